#include "report/diagnostic_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace plumbline;

TEST_CASE("a diagnostic is one line of JSON with all of its parts") {
  const Diagnostic diagnostic{
      "nc-word-twice", "two X words", "leave one", {"part.ngc", 3, 7, 2, "G0 X1 X2"}, Severity::warning};
  const std::string text = report::diagnostic_json(diagnostic);
  CHECK(text.find('\n') == std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(text);
  CHECK(json == nlohmann::json{{"code", "nc-word-twice"},
                               {"severity", "warning"},
                               {"message", "two X words"},
                               {"help", "leave one"},
                               {"file", "part.ngc"},
                               {"line", 3},
                               {"column", 7},
                               {"length", 2},
                               {"text", "G0 X1 X2"}});
}

TEST_CASE("what is no UTF-8 in a program does not break the JSON") {
  const Diagnostic diagnostic{
      "nc-not-ascii", "byte 0xe4", "help", {"part.ngc", 1, 2, 1, "X\xE4\n\t\""}, Severity::note};
  const nlohmann::json json = nlohmann::json::parse(report::diagnostic_json(diagnostic));
  CHECK(json["text"] == "X\xEF\xBF\xBD\n\t\"");
  CHECK(json["severity"] == "note");
}
