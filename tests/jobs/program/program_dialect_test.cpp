#include "jobs/program/program_dialect.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

constexpr const char* kOfAnyControl = "G0 X1\nM2\n";

// The dialect of a program, or the code that it is refused with.
std::string chosen(const settings::Options& options, std::string_view program, const char* name = "p.nc") {
  const testing::Scratch scratch;
  const InputFile file(scratch.file(name, program));
  std::string dialect;
  const Diagnostic refused = testing::refusal_of([&] { dialect = jobs::dialect_of(options, file).name; });
  return refused.code.empty() ? dialect : refused.code;
}

settings::Options said(std::string dialect) {
  settings::Options options;
  options.dialect = std::move(dialect);
  return options;
}

}  // namespace

TEST_CASE("the dialect that was named counts, else the one that the text shows") {
  CHECK(chosen({}, kOfAnyControl) == "linuxcnc");
  CHECK(chosen({}, "CALL OPULL PL=5\n") == "okuma");
  CHECK(chosen(said("fanuc"), kOfAnyControl) == "fanuc");
  CHECK(chosen(said("siemens"), "CALL OPULL PL=5\n") == "siemens");
  CHECK(chosen(said("heidenhain"), kOfAnyControl) == "nc-unknown-dialect");
}

TEST_CASE("what is no program is refused before its dialect is asked for") {
  CHECK(chosen(said("heidenhain"), "") == "file-empty");
  CHECK(chosen({}, "PK\x03\x04 and so on") == "file-not-text");
}

TEST_CASE("a work offset of a system that the dialect does not have is refused") {
  settings::Options options = said("fanuc");
  options.offset_systems = {{"G54", 1, {}}};
  CHECK(chosen(options, kOfAnyControl) == "fanuc");
  options.offset_systems = {{"G54", 1, {}}, {"G505", 5, {}}};  // of Siemens
  CHECK(chosen(options, kOfAnyControl) == "settings-work-system");
  options.dialect = "siemens";
  CHECK(chosen(options, kOfAnyControl) == "siemens");
}

TEST_CASE("a work offset that is refused is found: the line of the settings file, and the program") {
  const testing::Scratch scratch;
  scratch.file("p.nc", kOfAnyControl);
  settings::Options options = said("linuxcnc");
  options.offset_systems = {{"G15H2", 2, {}}};
  const auto refused = [&] {
    return testing::refusal_of([&] { jobs::dialect_of(options, InputFile(scratch.path("p.nc"))); });
  };
  CHECK(refused().place.file == scratch.path("p.nc"));
  options.offset_systems[0].stated = {"plumbline.toml", 7};
  CHECK(refused().place.file == "plumbline.toml");
  CHECK(refused().place.line == 7);
  CHECK(refused().message.find(scratch.path("p.nc")) != std::string::npos);
}

TEST_CASE("an input increment is refused where numbers need no point") {
  settings::Options options = said("linuxcnc");
  options.program.input_increment = 0.001;
  CHECK(chosen(options, kOfAnyControl) == "settings-input-increment");
  options.dialect = "fanuc";
  CHECK(chosen(options, kOfAnyControl) == "fanuc");
}

TEST_CASE("a unit at the start is refused where none but mm is read of programs that state none") {
  for (const std::string control : {"linuxcnc", "fanuc", "okuma", "siemens"}) {
    INFO(control);
    settings::Options options = said(control);
    options.program.inches = true;
    CHECK(chosen(options, kOfAnyControl) == (control == "linuxcnc" || control == "fanuc" ? control : "settings-unit"));
  }
}

TEST_CASE("a calculator type is refused where numbers count mm and deg") {
  for (const bool on : {false, true}) {
    for (const std::string control : {"linuxcnc", "siemens", "okuma"}) {
      settings::Options options = said(control);
      options.program.calculator_type = on;
      CHECK(chosen(options, kOfAnyControl) == "settings-calculator-type");
    }
    settings::Options options = said("fanuc");
    options.program.calculator_type = on;
    CHECK(chosen(options, kOfAnyControl) == "fanuc");
  }
}
