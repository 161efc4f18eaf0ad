// Also gather_codes.cpp, contexts.cpp and alone.cpp, which it calls: the codes of a block, and what stands beside
// others. fanuc_contexts_test.cpp, okuma_test.cpp, siemens_test.cpp and the files of tests/nc/bad have a program for
// each of their refusals.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/control/execution.hpp"
#include "nc/syntax/parsed.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

// A block whose codes are found, in the state of a control that has done nothing yet.
struct Resolved {
  explicit Resolved(const std::string& line, std::string_view name = "linuxcnc", ProgramSettings how = {})
      : parsed(line, name),
        settings(std::move(how)),
        control(dialect(name), settings),
        run{dialect(name), settings, control} {
    run.block = &parsed.block;
    resolve_codes(run);
  }
  std::vector<std::string> order() const {
    std::vector<std::string> texts;
    for (const Chosen& chosen : run.chosen) texts.push_back(parsed.at(chosen.word->span));
    return texts;
  }
  Parsed parsed;
  ProgramSettings settings;
  Control control;
  Execution run;
};

using CodeTexts = std::vector<std::string>;

Diagnostic refused(const std::string& line, std::string_view name = "linuxcnc", const ProgramSettings& how = {}) {
  return testing::refusal_of([&] { Resolved(line, name, how); });
}

}  // namespace

TEST_CASE("codes act in the order of the control, whatever their order in the block") {
  CHECK(Resolved("M2 G1 X1 G90 M8 M3 S100 G20 F5 G94").order() ==
        CodeTexts{"G94", "F5", "S100", "M3", "M8", "G20", "G90", "G1", "M2"});
  CHECK(Resolved("G0 X1 G55 G17").order() == CodeTexts{"G17", "G55", "G0"});
  CHECK(Resolved("X1 G1 F5 G21", "fanuc").order() ==
        CodeTexts{"G21", "F5", "G1"});  // F counts in the units of its block
}

TEST_CASE("the motion of a block is its own code") {
  const Resolved stated("G1 X1 F5");
  REQUIRE(stated.run.motion != nullptr);
  CHECK(stated.run.motion->action == Action::feed);
  CHECK(stated.parsed.at(stated.run.motion_word->span) == "G1");
  CHECK(stated.run.axes == AxisSet{Axis::X});
  CHECK(Resolved("M8").run.motion == nullptr);
  const Resolved offset("G92 X1");  // the axis words are those of G92
  CHECK(offset.run.motion == nullptr);
  CHECK(offset.run.uses_position_axes);
  CHECK(refused("X1").code == "nc-axes-unused");
  CHECK(refused("G1 G92 X1").code == "nc-axes-twice");
}

TEST_CASE("radius and angle stand for X and Y") {
  const Resolved polar("G0 @10 ^90");
  CHECK(polar.run.axes == AxisSet{Axis::X, Axis::Y});
  CHECK(polar.run.step.end_words == EndWords::polar);
  CHECK(refused("G0 @10 ^90 X1").code == "nc-axes-twice");
}

TEST_CASE("two codes of a group are refused, or the last one counts, as the control has it") {
  const Diagnostic twice = refused("G0 G1 X1 F5");
  CHECK(twice.code == "nc-same-group");
  CHECK(twice.place.line == 7);
  CHECK(twice.place.column == 4);
  CHECK(refused("M3 M4").code == "nc-same-group");
  CHECK(refused("G90 G20 M3 M8").code.empty());
  CHECK(Resolved("G0 G80 X1").run.motion->action == Action::rapid);  // G80 gives way
  CHECK(Resolved("G80 G0 X1").run.motion->action == Action::rapid);
  CHECK(Resolved("G0 G1 X1. F5.", "fanuc").order() == CodeTexts{"F5.", "G1"});
}

TEST_CASE("a fifth M code is refused where the control takes four") {
  CHECK(refused("M3 M8 M48 M0 S100").code.empty());
  const Diagnostic fifth = refused("M3 M8 M48 M0 M62 P1 S100");
  CHECK(fifth.code == "nc-same-group");
  CHECK(fifth.place.column == 14);
  CHECK(refused("G1 X1 F5 M5 M9 M49 M1 M63 P0").code == "nc-same-group");
  CHECK(refused("G0 G90 G21 G17 G40 G49 G54 M3 S5 M7").code.empty());
}

TEST_CASE("codes that the control has not are refused, those of its builder unless they are passed") {
  CHECK(refused("G6.5").code == "nc-unknown-code");
  CHECK(refused("G-1").code == "nc-unknown-code");
  CHECK(refused("M44").code == "nc-unknown-code");
  CHECK(refused("M100").code == "nc-user-code");
  CHECK(refused("M199").code == "nc-user-code");
  CHECK(refused("M428").code == "nc-user-code");  // a remap
  CHECK(refused("M1100").code == "nc-unknown-code");
  CHECK(refused("M3.5").code == "nc-not-whole");
  CHECK(refused("G41").code == "nc-not-interpreted");
  ProgramSettings passed;
  passed.passed_m_codes = {44, 100};
  CHECK(refused("M44", "linuxcnc", passed).code.empty());
  CHECK(refused("M100", "linuxcnc", passed).code.empty());
  ProgramSettings as_it_stands;
  as_it_stands.as_with_empty_tables = true;
  CHECK(refused("M199", "linuxcnc", as_it_stands).code.empty());
  CHECK(refused("M999", "linuxcnc", as_it_stands).code.empty());
  CHECK(refused("M1000", "linuxcnc", as_it_stands).code == "nc-unknown-code");
  CHECK(refused("M1100", "linuxcnc", as_it_stands).code == "nc-unknown-code");
}

TEST_CASE("a dwell stands beside moves, but not beside the code of an arc") {
  CHECK(refused("G4 P1 G1 X3 F5").code.empty());
  CHECK(refused("G4 P1 G80").code.empty());
  CHECK(refused("G2 X8 I4 F5").code.empty());
  CHECK(refused("G4 P1 G2 X8 I4 F5").code == "nc-same-group");
  CHECK(refused("G3 X8 R5 F5 G4 P1").place.column == 1);
}

TEST_CASE("a word that no code takes is refused where it stands") {
  const Diagnostic unused = refused("G0 X1 H2");
  CHECK(unused.code == "nc-word-unused");
  CHECK(unused.place.column == 7);
  CHECK(refused("G0 X1 P2").code == "nc-word-unused");
  CHECK(refused("F5 S100 T1").code.empty());
  CHECK(refused("G2 X1 I1").code.empty());
  CHECK(refused("G0 X1 I1").code == "nc-word-unused");
}

TEST_CASE("words beyond what can be written, and axes that are not those of the machine, are refused") {
  CHECK(refused("G0 X1000000000").code.empty());
  CHECK(refused("G0 X1000000001").code == "nc-out-of-range");
  CHECK(refused("G0 X-1000000001").code == "nc-out-of-range");
  CHECK(refused("G0 U1").code == "nc-not-interpreted");
}

TEST_CASE("G53 is a straight move, and of one control a rapid") {
  CHECK(Resolved("G53 G0 X1").run.machine_word != nullptr);
  CHECK(refused("G53 X1").code == "nc-axes-unused");
  CHECK(refused("G53 G2 X1 I1").code == "nc-machine-move");
  CHECK(refused("G53 G0 X1").code.empty());
  CHECK(Resolved("G53 X1.", "fanuc").run.motion->action == Action::rapid);
  CHECK(refused("G53 G1 X1.", "fanuc").code == "nc-machine-move");
}

TEST_CASE("the call of a cycle stands alone") {
  CHECK(refused("CYCLE81(10,0,2,-15)", "siemens").code.empty());
  CHECK(refused("G0 CYCLE81(10,0,2,-15)", "siemens").code == "nc-not-interpreted");
  CHECK(refused("M1=3 S100", "siemens").code.empty());
  CHECK(refused("M1=8", "siemens").code == "nc-not-interpreted");
}
