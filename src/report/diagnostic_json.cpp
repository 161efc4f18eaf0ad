#include "report/diagnostic_json.hpp"

#include <nlohmann/json.hpp>

namespace plumbline::report {
namespace {

std::string_view name_of(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

}  // namespace

std::string diagnostic_json(const Diagnostic& diagnostic) {
  using Json = nlohmann::ordered_json;
  const Place& place = diagnostic.place;
  const Json json{{"code", diagnostic.code},
                  {"severity", name_of(diagnostic.severity)},
                  {"message", diagnostic.message},
                  {"help", diagnostic.help},
                  {"file", place.file},
                  {"line", place.line},
                  {"column", place.column},
                  {"length", place.length},
                  {"text", place.text}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace plumbline::report
