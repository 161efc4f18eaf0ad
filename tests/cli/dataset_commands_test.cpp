// The commands that work on measurements.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "jobs/dataset_files.hpp"

using namespace plumbline::testing;
using nlohmann::json;

namespace {

// The table of a tracker in the frame W: what `error` says of each pose, added to it.
std::string seen_by_tracker(const std::string& errors) {
  std::istringstream lines(errors);
  std::string line;
  std::getline(lines, line);
  const auto dx =
      static_cast<std::size_t>(std::count(line.begin(), line.begin() + static_cast<int>(line.find("dx_um")), ','));
  std::string table = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,measured_x_mm,measured_y_mm,measured_z_mm\n";
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(*plumbline::parse_number(cell));
    for (std::size_t i = 0; i < 6; ++i) table += fmt::format("{},", row[i]);
    for (std::size_t i = 0; i < 3; ++i)
      table += fmt::format("{:.7f}{}", row[i] + 1e-3 * row[dx + i], i < 2 ? "," : "\n");
  }
  return table;
}

}  // namespace

TEST_CASE("simulate, compare and circularity work on a dataset") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  const Outcome simulated = run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel);
  CHECK(simulated.code == 0);
  CHECK(simulated.out.empty());
  CHECK(contains(simulated.err, "2 runs, 240 samples"));

  const Outcome compared = run(scratch, "compare -d sim/dataset.toml --json c.json --max-radial-um 0.01 " + kModel);
  CHECK(compared.code == 0);
  CHECK(contains(compared.out, "radial rms um"));
  CHECK(json::parse(scratch.text("c.json")).at("radial_rms_um").get<double>() < 0.001);
  const Outcome apart = run(scratch, "compare -d plan/dataset.toml --json - --max-radial-um 5 " + kModel);
  CHECK(apart.code == 3);
  CHECK(json::parse(apart.out).at("runs").size() == 2);

  const Outcome figures = run(scratch, "circularity -d sim/dataset.toml --json f.json");
  CHECK(figures.code == 0);
  CHECK(contains(figures.out, "G(b)"));
  CHECK(json::parse(scratch.text("f.json")).at("runs")[0].at("circularity_um").get<double>() > 200);
}

TEST_CASE("identify writes a model that fits, and says what it learnt") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  std::string other = plumbline::read_text(source_file("models/pm600-like.toml"));
  const std::string friction = "coulomb_friction_N = [110";
  other.replace(other.find(friction), friction.size(), "coulomb_friction_N = [121");
  scratch.file("other.toml", other);
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim -m other.toml").code == 0);

  const Outcome found = run(scratch, "identify -d sim/dataset.toml -o new.toml --json new.json " + kModel);
  CHECK(found.code == 0);
  CHECK(contains(found.out, "friction strut 1"));
  CHECK(contains(found.out, "circles at one height"));
  CHECK(contains(scratch.text("new.toml"), "# Identified by plumbline"));
  const json result = json::parse(scratch.text("new.json"));
  CHECK(result.at("converged") == true);
  CHECK(result.at("gap").at("after").at("radial_rms_um").get<double>() < 0.01);
  CHECK(run(scratch, "compare -d sim/dataset.toml -m new.toml --max-radial-um 0.01").code == 0);

  CHECK(run(scratch, "identify -d sim/dataset.toml " + kModel).code == 2);
  CHECK(run(scratch, "identify -d sim/dataset.toml -o x.toml --stages both " + kModel).code == 2);
  const Outcome unknown = run(scratch, "identify -d sim/dataset.toml -o x.toml --free backlash.witdh_um " + kModel);
  CHECK(unknown.code == 1);
  CHECK(contains(unknown.err, "did you mean backlash.width_um?"));
  CHECK(run(scratch, "identify -d sim/dataset.toml -o sim/dataset.toml " + kModel).code == 1);
}

TEST_CASE("identify refuses numbers that cannot be, and writes them when it is forced") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  for (const auto& [is, would_be] : {std::pair{"centre_of_mass_mm = [0, 0, ", "centre_of_mass_mm = [40, 0, "},
                                     std::pair{"coulomb_friction_N = [110", "coulomb_friction_N = [210"},
                                     std::pair{"compliance_um_N = 0.00782", "compliance_um_N = 0.03"}}) {
    std::string other = plumbline::read_text(source_file("models/pm600-like.toml"));
    other.replace(other.find(is), std::string(is).size(), would_be);
    scratch.file("other.toml", other);
    std::filesystem::remove_all(scratch.path("sim"));
    REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim -m other.toml").code == 0);
    const Outcome refused = run(scratch, "identify -d sim/dataset.toml -o no.toml --json no.json " + kModel);
    INFO(refused.err);
    CHECK(refused.code == 1);
    CHECK(contains(refused.err, "[identify-not-plausible]"));
    CHECK(contains(refused.err, "plumbline diagnose"));
    CHECK_FALSE(std::filesystem::exists(scratch.path("no.toml")));
    CHECK(json::parse(scratch.text("no.json")).at("stages")[0].at("objection").is_string());
    const Outcome forced = run(scratch, "identify --force -d sim/dataset.toml -o forced.toml " + kModel);
    CHECK(forced.code == 0);
    CHECK(contains(forced.err, "warning"));
    CHECK(contains(scratch.text("forced.toml"), "# Identified by plumbline"));
  }
}

TEST_CASE("calibrate finds joints from a tracker's poses, and can write them for the controller") {
  const Scratch scratch;
  std::string poses = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n";
  for (int i = 0; i < 40; ++i) {
    poses += fmt::format("{},{},{},{},{},{}\n", i % 5 * 70 - 140, i % 4 * 80 - 120, -900 - i % 7 * 40, i % 3 * 14 - 14,
                         i % 6 * 5 - 12, i % 2 * 8);
  }
  // the machine as it is, its base joint 2 moved by 0.05 mm: what `error` says of it is what the tracker sees
  scratch.file("poses.csv", poses);
  scratch.file("true.toml", plumbline::read_text(source_file("models/pm600-like.toml")) +
                                "\n[[effect]]\nname = \"joint-position\"\nbase_um = [[0, 0, 0], [50, 0, 0], [0, 0, 0], "
                                "[0, 0, 0], [0, 0, 0], [0, 0, 0]]\nplatform_um = [[0, 0, 0], [0, 0, 0], [0, 0, 0], "
                                "[0, 0, 0], [0, 0, 0], [0, 0, 0]]\n");
  REQUIRE(run(scratch, "error poses.csv -m true.toml -o errors.csv").code == 0);
  scratch.file("tracker.csv", seen_by_tracker(scratch.text("errors.csv")));

  const Outcome found = run(
      scratch, "calibrate --poses tracker.csv --frame-known -o new.toml --json new.json --report new.html " + kModel);
  INFO(found.err);
  CHECK(found.code == 0);
  CHECK(contains(found.out, "base joint 2"));
  CHECK(contains(found.out, "directions of the geometry"));
  CHECK(contains(scratch.text("new.toml"), "# Calibrated by plumbline"));
  CHECK(contains(scratch.text("new.html"), "Poses of the tracker: what is left"));
  const json result = json::parse(scratch.text("new.json"));
  CHECK(result.at("gap").at("before").at("tracker_rms_um").get<double>() > 5);
  CHECK(result.at("gap").at("after").at("tracker_rms_um").get<double>() < 0.5);

  REQUIRE(run(scratch, "calibrate --poses tracker.csv --frame-known --controller -o control.toml " + kModel).code == 0);
  CHECK_FALSE(contains(scratch.text("control.toml"), "joint-position\"\nbase_um"));
  CHECK_FALSE(contains(scratch.text("control.toml"), "[997.80725, "));

  CHECK(run(scratch, "calibrate -o new.toml " + kModel).code == 2);
  CHECK(run(scratch, "calibrate --poses tracker.csv -o tracker.csv " + kModel).code == 1);
  CHECK(contains(run(scratch, "calibrate --poses poses.csv -o x.toml " + kModel).err, "csv-header"));
}

TEST_CASE("plan proposes circles that simulate and calibrate read, the same ones for a seed") {
  const Scratch scratch;
  const std::string few = " --candidates 40 --samples 60 -n 3 ";
  const Outcome planned = run(scratch, "plan -o plan --json plan.json --seed 7" + few + kModel);
  INFO(planned.err);
  CHECK(planned.code == 0);
  CHECK(contains(planned.out, "joint-position base_um"));
  CHECK(contains(planned.out, "note: "));
  const json plan = json::parse(scratch.text("plan.json"));
  CHECK(plan.at("runs").size() == 3);
  for (const json& unknown : plan.at("unknowns")) {
    CHECK(unknown.at("after").get<double>() <= unknown.at("before").get<double>());
  }
  CHECK(run(scratch, "plan --json - --seed 7" + few + kModel).out == scratch.text("plan.json"));
  CHECK(run(scratch, "plan --json - --seed 8" + few + kModel).out != scratch.text("plan.json"));

  for (const char* const learns :
       {"inspect -d plan/dataset.toml", "identify -d plan/dataset.toml -o no.toml",
        "calibrate -d plan/dataset.toml -o no.toml", "diagnose -d plan/dataset.toml -o no"}) {
    CAPTURE(learns);
    const Outcome not_measured = run(scratch, learns + (" " + kModel));
    CHECK(not_measured.code == 1);
    CHECK(contains(not_measured.err, "these readings are the plan's own: nothing was measured"));
  }
  CHECK(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  CHECK(scratch.text("sim/01-" + plan.at("runs")[0].at("direction").get<std::string>() + ".csv").size() > 1000);
  CHECK(run(scratch, "calibrate -d sim/dataset.toml -o new.toml " + kModel).code == 0);
  // a plan for what is there already: nothing is as good as something else
  CHECK(run(scratch, "plan -d plan/dataset.toml --for elasticity,friction" + few + kModel).code == 0);

  const Outcome apart = run(scratch, "plan --separate backlash,screw-coulomb" + few + kModel);
  CHECK(apart.code == 0);
  CHECK(contains(apart.out, "sigma for a hundredth of its range"));
  CHECK(run(scratch, "plan --separate backlash" + few + kModel).code == 2);
  CHECK(contains(run(scratch, "plan --separate backlash,frictoin" + few + kModel).err, "plan-unknown-effect"));
  CHECK(contains(run(scratch, "plan -o plan" + few + kModel).err, "plan-folder-taken"));
  CHECK(contains(run(scratch, "plan --radius 900" + few + kModel).err, "plan-no-candidates"));
}

TEST_CASE("what the commands on measurements are not told is wrong usage, what is wrong with a dataset fails") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  CHECK(run(scratch, "simulate -d plan/dataset.toml " + kModel).code == 2);
  CHECK(run(scratch, "simulate -d plan/dataset.toml -o sim").code == 2);
  CHECK(run(scratch, "simulate -d plan/dataset.toml -o sim --no-friction " + kModel).code == 2);
  CHECK(run(scratch, "simulate x.ngc -d plan/dataset.toml -o sim " + kModel).code == 2);
  CHECK(run(scratch, "compare " + kModel).code == 2);
  CHECK(run(scratch, "compare -d plan/dataset.toml --max-radial-um -1 " + kModel).code == 2);
  scratch.file("plan/b.csv", "angle_deg,radial_mm\n");
  const Outcome wrong = run(scratch, "circularity -d plan/dataset.toml");
  CHECK(wrong.code == 1);
  CHECK(contains(wrong.err, "b.csv:1:11:"));
  CHECK(contains(wrong.err, "did you mean `radial_um`"));
}

TEST_CASE("a table of readings is never overwritten") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string before = scratch.text("plan/a.csv");
  CHECK(run(scratch, "compare -d plan/dataset.toml --json plan/a.csv " + kModel).code == 1);
  CHECK(run(scratch, "circularity -d plan/dataset.toml --json plan/a.csv").code == 1);
  for (const std::string command :
       {"identify -d plan/dataset.toml -o plan/a.csv ", "calibrate -d plan/dataset.toml -o plan/a.csv ",
        "identify -d plan/dataset.toml -o found.toml --json plan/a.csv ",
        "plan -d plan/dataset.toml --json plan/a.csv "}) {
    INFO(command);
    const Outcome outcome = run(scratch, command + kModel);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, contains(command, "--json") ? "[file-exists]" : "[file-overwrites-input]"));
  }
  CHECK(scratch.text("plan/a.csv") == before);
}

TEST_CASE("a bound on readings of the bar that nobody made is refused") {
  const Scratch scratch;
  scratch.file("dataset.toml", run_text("a", "ccw", "plumbline = \"dataset 1\"\n"));
  std::string table = "angle_deg,torque1_Nm,torque2_Nm,torque3_Nm,torque4_Nm,torque5_Nm,torque6_Nm\n";
  for (int angle = 0; angle < 360; angle += 10) table += std::to_string(angle) + ",1,1,1,1,1,1\n";
  scratch.file("a.csv", table);
  CHECK(run(scratch, "compare -d dataset.toml " + kModel).code == 0);
  const Outcome outcome = run(scratch, "compare -d dataset.toml --max-radial-um 5 " + kModel);
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "[compare-no-bar]"));
}

TEST_CASE("a diagnosis that fails leaves no folder, and one that works fills it") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  const std::string diagnose = "diagnose -d sim/dataset.toml " + kModel + " ";
  CHECK(run(scratch, diagnose + "-o a/b --without back-lash").code == 1);
  CHECK_FALSE(scratch.has("a"));
  scratch.file("file", "");
  const Outcome in_file = run(scratch, diagnose + "-o file/b");
  CHECK(in_file.code == 1);
  CHECK(contains(in_file.err, "file/b: error: cannot be made a folder"));

  const Outcome done = run(scratch, diagnose + "-o a/b --json");
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK(done.out == scratch.text("a/b/diagnosis.json"));
  CHECK(json::parse(done.out).at("plumbline") == "diagnosis 1");
  CHECK(scratch.text("a/b/report.html").starts_with("<!doctype html>"));
  CHECK(run(scratch, "compare -d sim/dataset.toml -m a/b/model.toml --max-radial-um 0.1").code == 0);
}

namespace {

// The data of a page, as it stands in it.
json page_data(const std::string& page) {
  const std::string open = R"(<script type="application/json" id="data">)";
  const std::size_t begin = page.find(open) + open.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

std::vector<std::string> section_types(const std::string& page) {
  std::vector<std::string> types;
  const json data = page_data(page);
  for (const json& section : data.at("sections")) types.push_back(section.at("type"));
  return types;
}

bool has_type(const std::string& page, const std::string& type) {
  const std::vector<std::string> types = section_types(page);
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

TEST_CASE("commands on measurements write pages, with their other outputs or not at all") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);

  REQUIRE(run(scratch, "compare -d sim/dataset.toml --report c.html --beside " + source_file("models/pm600-like.toml") +
                           " " + kModel)
              .code == 0);
  for (const char* const type : {"facts", "polar", "bars", "heat", "curves", "table"}) {
    INFO(type);
    CHECK(has_type(scratch.text("c.html"), type));
  }
  REQUIRE(run(scratch, "circularity -d sim/dataset.toml --report f.html " + kModel).code == 0);
  CHECK(page_data(scratch.text("f.html")).at("sections")[0].at("groups")[0].at("curves").size() == 3);
  REQUIRE(run(scratch, "circularity -d sim/dataset.toml --report f.html").code == 0);
  CHECK(page_data(scratch.text("f.html")).at("sections")[0].at("groups")[0].at("curves").size() == 1);

  REQUIRE(run(scratch, "identify -d sim/dataset.toml -o new.toml --report i.html " + kModel).code == 0);
  CHECK(contains(scratch.text("i.html"), "What was found: joint fit"));
  CHECK(has_type(scratch.text("i.html"), "polar"));

  const Outcome over = run(scratch, "compare -d sim/dataset.toml --report sim/a.csv " + kModel);
  CHECK(over.code == 1);
  CHECK(contains(over.err, "file-exists"));
  const Outcome twice = run(scratch, "compare -d sim/dataset.toml --json x --report x " + kModel);
  CHECK(contains(twice.err, "file-written-twice"));
  CHECK_FALSE(scratch.has("x"));
  CHECK(run(scratch, "compare -d sim/dataset.toml --json y.json --report none/y.html " + kModel).code == 1);
  CHECK_FALSE(scratch.has("y.json"));
  CHECK(run(scratch, "circularity -d sim/dataset.toml " + kModel).code == 2);
}

TEST_CASE("a diagnosis that leaves several effects writes the programs of the tests that tell them apart") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  scratch.file("true.toml", plumbline::read_text(source_file("models/pm600-like.toml")) +
                                "\n[[effect]]\nname = \"strut-offset\"\nlength_um = [300, 0, 0, 0, 0, 0]\n");
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim -m true.toml").code == 0);
  for (const std::string table : {"sim/a.csv", "sim/b.csv"}) {
    std::string text = scratch.text(table);
    for (int column = 1; column <= 7; ++column) {
      double place = 78.233 * column + (table == "sim/a.csv" ? 0 : 31.7);
      text = changed(text, column, [&](double number) {
        place += 12.9898;
        const double noise = std::sin(place) * 43758.5453;
        return number + (column == 1 ? 1.0 : 0.1) * (2 * (noise - std::floor(noise)) - 1);
      });
    }
    scratch.file(table, text);
  }
  REQUIRE(run(scratch, "diagnose -d sim/dataset.toml -o found " + kModel).code == 0);
  CHECK(scratch.has("found/report.html"));
  REQUIRE(run(scratch, "diagnose -d sim/dataset.toml -o elsewhere --report page.html " + kModel).code == 0);
  CHECK(scratch.text("page.html") == scratch.text("found/report.html"));
  CHECK_FALSE(scratch.has("elsewhere/report.html"));
  CHECK(run(scratch, "diagnose -d sim/dataset.toml -o third --report - " + kModel).code == 2);
  CHECK(contains(run(scratch, "diagnose -d sim/dataset.toml -o third --report sim/dataset.toml " + kModel).err,
                 "[file-overwrites-input]"));
  const json tests = json::parse(scratch.text("found/diagnosis.json")).at("next_tests");
  REQUIRE_FALSE(tests.empty());
  std::size_t programs = 0;
  for (const json& test : tests) {
    if (test.at("test").is_null()) continue;
    ++programs;
    const std::string name = "next-test-" + test.at("from").get<std::string>() + ".ngc";
    INFO(name);
    REQUIRE(scratch.has("found/" + name));
    CHECK(run(scratch, "check found/" + name + " --work-offset G54=0,0,0,0,0,0 " + kModel).code == 0);
    const json page = page_data(scratch.text("found/report.html"));
    CHECK(std::any_of(page.at("sections").begin(), page.at("sections").end(), [&](const json& section) {
      return section.at("type") == "circles" &&
             section.at("tests")[programs - 1].at("program") == scratch.text("found/" + name);
    }));
  }
  CHECK(programs > 0);
}

TEST_CASE("two models are compared with the same measurements") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  std::string other = plumbline::read_text(source_file("models/pm600-like.toml"));
  const std::string friction = "coulomb_friction_N = [110";
  other.replace(other.find(friction), friction.size(), "coulomb_friction_N = [160");
  scratch.file("other.toml", other);
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim -m other.toml").code == 0);
  const Outcome both = run(scratch, "compare -d sim/dataset.toml --beside other.toml --json both.json " + kModel);
  CHECK(both.code == 0);
  CHECK(contains(both.out, "\nother.toml\n"));
  const json written = json::parse(scratch.text("both.json"));
  CHECK(written.at("torque_rms_Nm").get<double>() > 0.01);
  CHECK(written.at("beside").at("model") == "other.toml");
  CHECK(written.at("beside").at("torque_rms_Nm").get<double>() < 1e-4);
  CHECK(written.at("beside").at("runs").size() == 2);
}

TEST_CASE("a plan writes the programs of its circles, which the machine can make, and a page") {
  const Scratch scratch;
  const std::string plan = "plan -n 2 --candidates 12 --samples 24 --programs p --report plan.html --dialect ";
  REQUIRE(run(scratch, plan + "siemens " + kModel).code == 0);
  std::size_t programs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path("p"))) {
    ++programs;
    const std::string name = entry.path().filename().string();
    INFO(name);
    CHECK(entry.path().extension() == ".mpf");
    CHECK(run(scratch, "check p/" + name + " --work-offset G54=0,0,0,0,0,0 " + kModel).code == 0);
  }
  CHECK(programs == 2);
  const json tests = page_data(scratch.text("plan.html")).at("sections")[1];
  CHECK(tests.at("type") == "circles");
  CHECK(contains(tests.at("tests")[0].at("program").get<std::string>(), "G54"));
  CHECK(run(scratch, plan + "klartext " + kModel).code == 2);
}
