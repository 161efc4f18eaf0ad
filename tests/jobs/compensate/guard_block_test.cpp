#include "jobs/compensate/guard_block.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>

#include <catch2/catch.hpp>

#include "nc/language/guard_lines.hpp"
#include "nc/sequence/program.hpp"
#include "support/scratch.hpp"
#include "support/skip.hpp"

using namespace plumbline;

namespace {

const AxisSet kAllButB = AxisSet::all() - AxisSet{Axis::B};  // that the program names

// The state of a control, and what LinuxCNC's interpreter makes of a guard in it.
struct Control {
  std::string set_up = "G21\nG10 L2 P1 X0 Y0 Z-1008 A0 B0 C0\nG10 L2 P2 X1.5 Y2 Z-7 C5 R30\n";  // a program
  std::string tools = "T1 P1 Z3.3464567\n";                                                     // lengths in inch
};

std::vector<std::string> guard() {
  nc::ProgramSettings program;
  program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  program.work_offsets[1] = nc::WorkOffset{{{1.5, 2, -7, 0, 0, 5}}, 30};
  const std::vector<nc::Tool> tools{{1, 85, {}, {}, {}}};
  compensate::ProgramSurvey survey{nc::dialect("linuxcnc"), kAllButB, tools};
  survey.beginning.states_unit = true;
  return jobs::guard_block(program, survey);
}

// True if the program after the guard is reached.
bool goes_on(const Control& control, const std::string& units = "") {
  const testing::Scratch scratch;
  std::string text = control.set_up + units;
  for (const std::string& line : guard()) text += line + "\n";
  scratch.file("p.ngc", text + "G0 X77\nM2\n");
  scratch.file("tools.tbl", control.tools);
  scratch.file("v.var", "");
  const std::string command = "cd " + scratch.path("") + " && HOME=" + scratch.path("") +
                              " rs274 -g -n 2 -t tools.tbl -v v.var p.ngc canon >log 2>&1";
  const int status = std::system(command.c_str());
  INFO(scratch.text("log"));
  CHECK(status == 0);
  const std::string canon = scratch.text("canon");
  const bool reached = canon.find("STRAIGHT_TRAVERSE(77.0000") != std::string::npos;
  CHECK(reached == (canon.find("plumbline guard") == std::string::npos));
  return reached;
}

std::vector<std::string> fanuc_guard_lines() {
  nc::ProgramSettings program;
  program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  program.work_offsets[1] = nc::WorkOffset{{{1, 0, 2, 0, 0, -5}}, 0};  // G55
  return jobs::guard_block(program, {nc::dialect("fanuc"), kAllButB});
}

// Codes in force, machine and work positions, offsets: external, G54, G55.
const std::map<int, double> kFanucAsMeant{{4006, 21}, {4008, 49}, {4014, 54},    {5021, 10}, {5022, 20}, {5023, -1000},
                                          {5041, 10}, {5042, 20}, {5043, 8},     {5044, 0},  {5045, 0},  {5046, 0},
                                          {5201, 0},  {5202, 0},  {5203, 0},     {5204, 0},  {5205, 0},  {5206, 0},
                                          {5221, 0},  {5222, 0},  {5223, -1008}, {5224, 0},  {5225, 0},  {5226, 0},
                                          {5241, 1},  {5242, 0},  {5243, 2},     {5244, 0},  {5245, 0},  {5246, -5}};

// True if what stands after the guard is reached; its lines are read as any macro is.
bool goes_on_at_fanuc(const std::map<int, double>& variables) {
  const testing::Scratch scratch;
  std::string text = "O0001\n";
  for (const std::string& line : fanuc_guard_lines()) {
    if (line.front() != '(') text += line + "\n";
  }
  const InputFile file(scratch.file("p.nc", text + "G0 X77.\nM30\n"));
  nc::ProgramSettings settings;
  settings.as_with_empty_tables = true;
  settings.variables = variables;
  nc::Program program(file, nc::dialect("fanuc"), settings);
  bool reached = false;
  bool alarms = false;
  while (const nc::Step* step = program.next()) {
    reached = reached || !step->motions.empty();
    alarms = alarms || step->stop == nc::StopByVariable::alarm;
  }
  CHECK(reached != alarms);
  return reached;
}

}  // namespace

TEST_CASE("a guard goes on where the control is set as the program was made for, in mm and in inch") {
  if (!testing::has_rs274_or_skips()) return;
  CHECK(goes_on({}));
  CHECK(goes_on({}, "G20\n"));
  CHECK(goes_on({}, "G0 X3 Y4 Z5 A6 C7\n"));
}

TEST_CASE("a guard stops the control at each difference") {
  if (!testing::has_rs274_or_skips()) return;
  for (const char* const change :
       {"G10 L2 P1 Z-1008.002\n", "G10 L2 P1 A0.002\n", "G10 L2 P2 X1.502\n", "G10 L2 P2 Y1.998\n",
        "G10 L2 P2 R30.01\n", "G10 L2 P2 C5.002\n", "G55\n", "G92 X0.1\n", "G43 H1\n", "G0 B0.01\n"}) {
    INFO(change);
    Control control;
    control.set_up += change;
    CHECK_FALSE(goes_on(control));
    CHECK_FALSE(goes_on(control, "G20\n"));
  }
  Control control;
  control.tools = "T1 P1 Z3.3466\n";
  CHECK_FALSE(goes_on(control));
}

TEST_CASE("the lines of a guard fit the control") {
  for (const std::string& line : guard()) {
    INFO(line);
    CHECK(line.size() <= nc::dialect("linuxcnc").line_length);
  }
}

TEST_CASE("Fanuc: the guard goes on where the control is set as the program was made for") {
  CHECK(goes_on_at_fanuc(kFanucAsMeant));
  std::map<int, double> further = kFanucAsMeant;
  further[5203] = 0.4;  // the external offset and G54 add up
  further[5223] = -1008.4;
  further[5243] = 1.6;
  CHECK(goes_on_at_fanuc(further));
}

TEST_CASE("Fanuc: the guard stops the control at each difference") {
  for (const std::pair<int, double>& change : {std::pair{4006, 20.0},
                                               {4014, 55.0},
                                               {4008, 43.0},
                                               {5041, 0.5},
                                               {5023, 7.0},
                                               {5203, 0.002},
                                               {5221, 0.002},
                                               {5223, -1007.99},
                                               {5224, 0.002},
                                               {5226, -0.01},
                                               {5241, 2.0},
                                               {5243, 2.002},
                                               {5246, 5.0},
                                               {5045, 0.01}}) {
    INFO("#" << change.first << " is " << change.second);
    std::map<int, double> control = kFanucAsMeant;
    control[change.first] = change.second;
    CHECK_FALSE(goes_on_at_fanuc(control));
  }
}

TEST_CASE("Fanuc: what the guard writes the control can read") {
  for (const std::string& line : fanuc_guard_lines()) {
    INFO(line);
    if (line.front() == '(') continue;
    const std::size_t message = line.find('(');
    CHECK(line.size() - message - 2 <= 26);
    CHECK(nc::is_part_of_guard(line, nc::dialect("fanuc")));
    CHECK_FALSE(std::regex_search(line.substr(0, message), std::regex("[0-9]{5,}[.][0-9]{4}|[0-9]{9}")));
  }
  nc::ProgramSettings further;
  further.work_offsets[6 + 47] = nc::WorkOffset{{{1, 0, 2, 0, 0, -5}}, 0};  // G54.1 P48
  CHECK(jobs::guard_block(further, {nc::dialect("fanuc"), AxisSet::all()}).at(12) ==
        "IF [ABS[#5206+#7946-[-5.0]] GT 0.001] THEN #3000=101(PLUMBLINE: G54.1 P48 C)");
  nc::ProgramSettings far;
  far.work_offsets[0] = nc::WorkOffset{{{-123456.7891, 0, 0, 0, 0, 0}}, 0};
  CHECK(jobs::guard_block(far, {nc::dialect("fanuc"), AxisSet::all()}).at(7).find("#5201+#5221-[-123456.79]") !=
        std::string::npos);
}

TEST_CASE("Siemens: the guard compares all frames of a system and its turn, and ends with G500") {
  nc::ProgramSettings program;
  program.work_offsets[0] = nc::WorkOffset{{{0, 1.5, -1008, 0, 0, 0}}, 0};
  program.work_offsets[4] = nc::WorkOffset{};  // G505
  program.start[index(Axis::B)] = 2;
  const std::vector<std::string> lines = jobs::guard_block(program, {nc::dialect("siemens"), kAllButB});
  CHECK(lines.front() == "; guard: the control must be set as this program was made for");
  CHECK(lines.back() == "; guard: passed");
  CHECK(lines.at(1) == "G54");
  CHECK(lines.at(2) == "IF ABS($P_ACTFRAME[X,TR]-(0))>0.001");
  CHECK(lines.at(3) == "MSG(\"plumbline guard: this program was made for G54 X0\")");
  CHECK(lines.at(4) == "M0");
  CHECK(lines.at(5) == "M30");
  CHECK(lines.at(6) == "ENDIF");
  CHECK(lines.at(7) == "IF ABS($P_ACTFRAME[Y,TR]-(1.5))>0.001");
  const auto holds = [&](const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  };
  CHECK(holds("IF ABS($P_ACTFRAME[Z,TR]-(-1008))>0.001"));
  CHECK(holds("IF ABS($P_ACTFRAME[C,TR]-(0))>0.001"));
  CHECK(holds("IF ABS($P_ACTFRAME[Z,RT]-(0))>0.001"));
  CHECK(holds("G505"));
  CHECK(holds("IF ABS($AA_IW[B]-(2))>0.001"));
  CHECK(lines.at(lines.size() - 2) == "G500");
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) CHECK(nc::is_part_of_guard(lines[i], nc::dialect("siemens")));
}

TEST_CASE("Siemens: a guard does not stand before definitions") {
  const testing::Scratch scratch;
  const auto code = [&](const std::string& text, const char* dialect) {
    const InputFile file(scratch.file("p.mpf", text));
    return testing::refusal_of([&] { jobs::refuse_guard_before_definitions(file, nc::dialect(dialect)); }).code;
  };
  CHECK(code("; part\nDEF REAL DEPTH=-15\nG54 G0 X0\nM30\n", "siemens").empty());  // it stands behind them
  CHECK(code("PROC PART\nDEF INT ZAEHL\nG54 G0 X0\nM30\n", "siemens").empty());
  CHECK(code("R1=5\nDEF REAL DEPTH=-15\nG54 G0 X0\nM30\n", "siemens") == "guard-definitions");
  CHECK(code("; part\nG54\nPROC PART\nM30\n", "siemens") == "guard-definitions");
  CHECK(code("N5 G90\nN10 DEF INT COUNT\nG54 G0 X0\nM30\n", "siemens") == "guard-definitions");
  const InputFile plain(scratch.file("p.mpf", "; DEF REAL A\nR1=5\nG54 G0 X0 ; PROC\nMSG(\"DEF\")\nM30\n"));
  CHECK_NOTHROW(jobs::refuse_guard_before_definitions(plain, nc::dialect("siemens")));
  const std::string main = "; made by hand\n%_N_PART_MPF\n;$PATH=/_N_WKS_DIR\n";
  for (const char* const behind :
       {"G54 G0 X0\nM30\n%_N_SUB_SPF\nPROC SUB(REAL A)\nRET\n", "R1=5\nM30\n%_N_SUB_SPF\nDEF INT COUNT\nRET\n",
        "M30\n%_N_SUB_SPF\nX1\nM17\n%_N_SUB2_SPF\nPROC SUB2 DISPLOF\nRET\n"}) {
    const InputFile archive(scratch.file("p.mpf", main + behind));
    CHECK_NOTHROW(jobs::refuse_guard_before_definitions(archive, nc::dialect("siemens")));
  }
  CHECK(code(main + "DEF REAL A\nM30\n%_N_SUB_SPF\nX1\nM17\n", "siemens").empty());
  CHECK(code(main + "R1=1\nDEF REAL A\nM30\n%_N_SUB_SPF\nX1\nM17\n", "siemens") == "guard-definitions");
}

TEST_CASE("lines that move or set anything are no part of a guard") {
  for (const char* const line : {"G1 X5", "G55 X1", "IF [1 EQ 1] THEN #5221=0", "M3", "G91", "MSG(\"other\")",
                                 "IF [1 EQ 1] THEN #3000=101(PLUMBLINE: A)G1 X5", "TRANS X5", "M0 X5", "G5 X0"}) {
    for (const std::string_view name : nc::dialect_names()) {
      INFO(name << ": " << line);
      CHECK_FALSE(nc::is_part_of_guard(line, nc::dialect(name)));
    }
  }
}

TEST_CASE("a guard is refused where it cannot be said") {
  CHECK(testing::refusal_of([&] {
          jobs::guard_block({}, {nc::dialect("okuma"), AxisSet::all()});
        }).code == "guard-dialect");
  nc::ProgramSettings beyond;
  beyond.work_offsets[6 + 48] = nc::WorkOffset{};  // G54.1 P49
  CHECK(testing::refusal_of([&] {
          jobs::guard_block(beyond, {nc::dialect("fanuc"), AxisSet::all()});
        }).code == "guard-system");
  nc::ProgramSettings in_inches;
  in_inches.inches = true;
  CHECK(testing::refusal_of([&] {
          jobs::guard_block(in_inches, {nc::dialect("fanuc"), AxisSet::all()});
        }).code == "guard-unit");
  nc::ProgramSettings with_g92;
  with_g92.variables = {{5210, 1}, {5211, 3}};
  CHECK(testing::refusal_of([&] {
          jobs::guard_block(with_g92, {nc::dialect("linuxcnc"), AxisSet::all()});
        }).code == "guard-g92");
}
