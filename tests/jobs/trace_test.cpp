#include "jobs/trace.hpp"

#include <filesystem>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/files/files.hpp"
#include "report/program/trace_text.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

std::string trace_of(std::string_view program, const std::string& variables = {}) {
  const std::string path =
      (fs::temp_directory_path() / ("plumbline-trace-" + std::to_string(getpid()) + ".ngc")).string();
  write_text(path, program);
  settings::Options options;
  options.dialect = "linuxcnc";
  if (!variables.empty()) options.paths.variables = variables;
  std::string text;
  jobs::trace_file(path, options, [&](const nc::Motion& motion) { report::append_trace_line(text, motion); });
  fs::remove(path);
  return text;
}

}  // namespace

TEST_CASE("a trace has one object a line, with the keys that others rely on") {
  CHECK(trace_of("G20\nG0 X1 A5\n") ==
        "{\"line\": 2, \"motion\": \"rapid\", \"to\": [25.4, 0, 0, 5, 0, 0], \"machine\": [25.4, 0, 0, 5, 0, 0], "
        "\"feed\": 0, \"feed_mode\": \"G94\"}\n");
  CHECK(trace_of("G10 L2 P1 Z-7.5\nG43.1 Z2\nG93 G18 G3 X-10 I-5 F2.5 P2\n") ==
        "{\"line\": 3, \"motion\": \"arc\", \"to\": [-10, 0, 5.5, 0, 0, 0], \"machine\": [-10, 0, 0, 0, 0, 0], "
        "\"feed\": 2.5, \"feed_mode\": \"G93\", \"plane\": \"G18\", \"centre\": [-5, 0, 5.5], \"turns\": 2}\n");
  CHECK(trace_of("G4 P1\nG1 X0.123456789 F100\nM2\n") ==
        "{\"line\": 1, \"motion\": \"dwell\", \"to\": [0, 0, 0, 0, 0, 0], \"machine\": [0, 0, 0, 0, 0, 0], "
        "\"feed\": 0, \"feed_mode\": \"G94\", \"seconds\": 1}\n"
        "{\"line\": 2, \"motion\": \"feed\", \"to\": [0.123456789, 0, 0, 0, 0, 0], "
        "\"machine\": [0.123456789, 0, 0, 0, 0, 0], \"feed\": 100, \"feed_mode\": \"G94\"}\n");
}

TEST_CASE("a program reads the work offsets that a variables file holds, and is moved by them") {
  const testing::Scratch scratch;
  const auto last = [&](std::string_view program, std::string_view variables) {
    const std::string text = trace_of(program, scratch.file("v.var", variables));
    const std::size_t line = text.rfind('\n', text.size() - 2);
    const auto motion = nlohmann::json::parse(text.substr(line == std::string::npos ? 0 : line + 1));
    return std::pair(motion["to"][0].get<double>(), motion["machine"][0].get<double>());
  };
  CHECK(last("G1 X#5221 F100\n", "5221 5\n") == std::pair(5.0, 10.0));
  CHECK(last("G55 G1 X[#5241+1] F100\n", "5241 -2\n5242 3\n") == std::pair(-1.0, -3.0));
  CHECK(last("G1 X#5221 F100\n", "5221 5\n5222 1\n5223 1\n5224 0\n5225 0\n5226 0\n") == std::pair(5.0, 10.0));
  CHECK(last("G1 X[#5222+1] F100\n", "5221 5\n") == std::pair(1.0, 6.0));
}

TEST_CASE("every line of a long trace is JSON, numbers kept to a billionth") {
  std::string program = "G1 F100\n";
  for (int i = 0; i < 2000; ++i) program += fmt::format("X{:.7f} A{}\n", i * 0.1234567, -i);
  const std::string text = trace_of(program);
  std::size_t begin = 0;
  int lines = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    const auto object = nlohmann::json::parse(text.substr(begin, end - begin));
    CHECK(object.at("to").size() == 6);
    CHECK(object.at("machine").size() == 6);
    begin = end + 1;
    ++lines;
  }
  CHECK(lines == 2001);
}

TEST_CASE("numbers beyond a billionth's reach are still numbers") {
  for (const char* number : {"987654321.123", "-999999999.9999", "0.0000000001", "-0.0000000001"}) {
    INFO(number);
    const auto object = nlohmann::json::parse(trace_of(fmt::format("G0 X{}\n", number)));
    CHECK(object.at("to").at(0).get<double>() == Approx(std::stod(number)).epsilon(1e-12).margin(1e-9));
  }
}
