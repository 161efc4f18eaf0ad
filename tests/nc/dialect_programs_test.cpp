// Programs of each dialect mean what was worked out by hand from the rules of its control: NAME.trace beside a program
// states its motions. A word that a line leaves out is as in the line before (at first 0).
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/recognise.hpp"
#include "nc/language/tool_table.hpp"
#include "nc/programs.hpp"
#include "support/skip.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;
namespace fs = std::filesystem;

namespace {

struct ExpectedMotion {
  std::string text;
  std::string kind;
  AxisWords to, machine;
  double feed = 0;
  double dwell_s = 0;
  std::array<double, 3> centre{};
  int turns = 0;
};

struct Trace {
  std::vector<ExpectedMotion> motions;
  ProgramSettings settings = empty_tables();
  std::string dialect;
};

double number_of(const std::string& text) { return parse_number(text).value(); }

void read_setting(Trace& trace, std::istringstream& words, const Dialect& dialect) {
  std::string name;
  std::string value;
  words >> name >> value;
  if (name == "calculator-type") trace.settings.calculator_type = value == "on";
  if (name == "input-increment") trace.settings.input_increment = number_of(value);
  if (name == "free-rotation") {
    trace.settings.free_rotation = value == "c-zero" ? FreeRotation::c_zero : FreeRotation::c_stays;
  }
  if (name == "block-delete") trace.settings.block_delete = value == "on";
  if (name != "work-offset") return;
  const std::size_t equals = value.find('=');
  const int system = dialect.system_of_name(value.substr(0, equals));
  REQUIRE(system > 0);
  WorkOffset offset;
  std::istringstream numbers(value.substr(equals + 1));
  std::string part;
  for (const Axis axis : kAllAxes) {
    if (std::getline(numbers, part, ',')) offset.origin[axis] = number_of(part);
  }
  trace.settings.work_offsets[static_cast<std::size_t>(system - 1)] = offset;
}

// rapid X1 Y2 | Z3 F4   feed ... F100   cw|ccw X1 Y2 I3 J4 K5 (centre) N2 (turns begun)   dwell 1.5
// After | stands the display of the machine, from there on the words are its.
Trace read_trace(const fs::path& path, const Dialect& dialect) {
  std::ifstream in(path);
  REQUIRE(in);
  Trace trace;
  ExpectedMotion now;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word.empty()) continue;
    if (word == "#") {
      read_setting(trace, words, dialect);
      continue;
    }
    now.text = line;
    now.kind = word;
    now.turns = word == "cw" ? -1 : 1;
    bool machine = false;
    while (words >> word) {
      if (word == "|") {
        machine = true;
        continue;
      }
      if (now.kind == "dwell") {
        now.dwell_s = number_of(word);
        continue;
      }
      const double value = number_of(word.substr(1));
      const std::optional<Axis> axis = axis_of(word.front());
      if (axis) (machine ? now.machine : now.to)[*axis] = value;
      if (word.front() == 'F') now.feed = value;
      if (word.front() >= 'I' && word.front() <= 'K') now.centre[static_cast<std::size_t>(word.front() - 'I')] = value;
      if (word.front() == 'N') now.turns = now.kind == "cw" ? -static_cast<int>(value) : static_cast<int>(value);
    }
    if (!machine) now.machine[Axis::X] = NAN;  // not stated
    trace.motions.push_back(now);
    if (!machine) now.machine[Axis::X] = 0;
  }
  return trace;
}

std::string kind_of(const Motion& motion) {
  switch (motion.kind) {
    case MotionKind::rapid:
      return "rapid";
    case MotionKind::feed:
      return "feed";
    case MotionKind::arc:
      return motion.arc.turns < 0 ? "cw" : "ccw";
    case MotionKind::dwell:
      return "dwell";
    case MotionKind::probe:
      break;
  }
  return "probe";
}

bool near(double a, double b) { return std::abs(a - b) < 1e-6; }

bool same(const Motion& ours, const ExpectedMotion& expected) {
  if (kind_of(ours) != expected.kind) return false;
  if (expected.kind == "dwell") return near(ours.dwell_s, expected.dwell_s);
  for (const Axis axis : kAllAxes) {
    if (!near(ours.to[axis], expected.to[axis])) return false;
    if (!std::isnan(expected.machine[Axis::X]) && !near(ours.machine[axis], expected.machine[axis])) return false;
  }
  if (expected.kind != "rapid" && !near(ours.feed, expected.feed)) return false;
  if (ours.kind != MotionKind::arc) return true;
  const PlaneAxes plane = axes_of(ours.arc.plane);
  for (const Axis axis : {plane.first, plane.second}) {
    if (!near(ours.arc.centre_mm[index(axis)], expected.centre[index(axis)])) return false;
  }
  return ours.arc.turns == expected.turns;
}

std::string text_of(const Motion& motion) {
  std::string text = kind_of(motion);
  for (const Axis axis : kAllAxes) text += fmt::format(" {}{:.6g}", letter(axis), motion.to[axis]);
  text += " |";
  for (const Axis axis : kAllAxes) text += fmt::format(" {}{:.6g}", letter(axis), motion.machine[axis]);
  text += fmt::format(" F{:.6g} dwell {:.6g}", motion.feed, motion.dwell_s);
  if (motion.kind == MotionKind::arc) {
    text += fmt::format(" centre {:.6g} {:.6g} {:.6g} turns {}", motion.arc.centre_mm[0], motion.arc.centre_mm[1],
                        motion.arc.centre_mm[2], motion.arc.turns);
  }
  return text + fmt::format(" (line {})", motion.line);
}

void compare(const fs::path& program, const Dialect& known) {
  INFO(program);
  Trace trace = read_trace(fs::path(program).replace_extension(".trace"), known);
  trace.settings.tools = read_tool_table((program.parent_path() / "tools.toml").string());
  const InputFile file(program.string());
  Program blocks(file, known, trace.settings);
  std::vector<Motion> motions;
  while (const Step* step = blocks.next()) motions.insert(motions.end(), step->motions.begin(), step->motions.end());
  for (std::size_t i = 0; i < std::min(motions.size(), trace.motions.size()); ++i) {
    INFO("by hand: " << trace.motions[i].text << "\nours:    " << text_of(motions[i]));
    CHECK(same(motions[i], trace.motions[i]));
  }
  CHECK(motions.size() == trace.motions.size());
}

void compare_all(const std::string& name) {
  const Dialect& known = dialect(name);
  int programs = 0;
  for (const auto& entry : fs::directory_iterator(folder(name))) {
    const fs::path ending = entry.path().extension();
    if (ending == ".trace" || ending == ".toml") continue;
    if (!fs::exists(fs::path(entry.path()).replace_extension(".trace"))) continue;  // a subprogram
    compare(entry.path(), known);
    const Recognised recognised = recognise(InputFile(entry.path().string()));
    INFO(entry.path() << ": " << recognised.evidence);
    CHECK(recognised.dialect == &known);
    ++programs;
  }
  CHECK(programs >= 10);
}

}  // namespace

TEST_CASE("an Okuma control whose unit is not 1 mm is refused: it may count numbers with a point in it, too") {
  struct Case {
    const char* program;
    std::size_t column;  // 0: interpreted
  };
  for (const Case& c :
       {Case{"G15 H1\nG1 X1000 F100\n", 4}, Case{"G15 H1\nG0 X20. Y5\n", 4}, Case{"G15 H1\nVC1=5\nG0 A=VC1\n", 4},
        Case{"G15 H1\nG4 F2.\n", 4}, Case{"G15 H1\nVC1=5\nS100 M3\n", 0}}) {
    INFO(c.program);
    const ProgramFile text(c.program);
    const InputFile file(text.path());
    ProgramSettings settings = empty_tables();
    settings.input_increment = 0.001;
    std::size_t column = 0;
    try {
      Program program(file, dialect("okuma"), settings);
      while (program.next() != nullptr) continue;
    } catch (const Refusal& refusal) {
      CHECK(refusal.diagnostic().code == "nc-value-unknown");
      column = refusal.diagnostic().place.column;
    }
    CHECK(column == c.column);
  }
}

// docs/corpus.md says why.
TEST_CASE("programs of others for Fanuc and Okuma are interpreted, or refused for the right reason") {
  if (corpus().empty()) return testing::skip_without_corpus();
  struct Case {
    const char* file;
    bool calculator_type;
    std::size_t motions;
    const char* code;
    std::size_t line;
  };
  for (const Case& c :
       {Case{"fanuc/TEST_G91.NC", false, 0, "nc-not-interpreted", 30}, Case{"fanuc/VINT_360arc.NC", false, 36, "", 0},
        Case{"fanuc/G83.NC", false, 414, "", 0}, Case{"fanuc/G83.NC", true, 414, "", 0},
        Case{"fanuc/G17_18_19_G91.NC", false, 0, "nc-arc-radius", 11}, Case{"fanuc/G17_18_19_G91.NC", true, 15, "", 0},
        Case{"fanuc/G81_G91.NC", false, 0, "nc-not-interpreted", 17},
        Case{"fanuc/HAAS_sample.NCF", false, 0, "nc-value-missing", 9},
        Case{"fanuc/mazak_sample.EIA", false, 0, "nc-unknown-code", 2},
        Case{"okuma/G116-NEW.LIB", false, 0, "nc-not-interpreted", 7},
        Case{"okuma/HOME-MULTUS.LIB", false, 0, "nc-not-interpreted", 2},
        Case{"okuma/OPHAN.SSB", false, 0, "nc-not-interpreted", 3},
        Case{"okuma/OPULL.SSB", false, 0, "nc-not-interpreted", 10},
        Case{"okuma/OROTA.SSB", false, 0, "nc-not-interpreted", 32}}) {
    INFO(c.file);
    const fs::path path = corpus() / c.file;
    if (!fs::exists(path)) continue;
    ProgramSettings settings = empty_tables();
    settings.calculator_type = c.calculator_type;
    const InputFile file(path.string());
    std::size_t motions = 0;
    try {
      Program program(file, dialect(fs::path(c.file).parent_path().string()), settings);
      while (const Step* step = program.next()) motions += step->motions.size();
      CHECK(std::string(c.code).empty());
      CHECK(motions == c.motions);
    } catch (const Refusal& refusal) {
      CHECK(refusal.diagnostic().code == c.code);
      CHECK(refusal.diagnostic().place.line == c.line);
    }
  }
}

TEST_CASE("programs for Fanuc mean what its rules say") { compare_all("fanuc"); }
TEST_CASE("programs for Okuma mean what its rules say") { compare_all("okuma"); }
TEST_CASE("programs for Siemens mean what its rules say") { compare_all("siemens"); }
