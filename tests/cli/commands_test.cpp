// What each command gives. The files of src/cli have no tests of their own: they take options from argv, call a job and
// print its words, which shows in the whole program alone. Each is held by a test that runs it:
//   compensate_command, trace_command, error_command, check_command, simulate_command, diff_command, control_command
//                                                                          here
//   compare_command, circularity_command, identify_command, calibrate_command (both write with identified_output),
//   plan_command, diagnose_command                                         dataset_commands_test.cpp
//   new_model_command, map_command, number_list                            model_commands_test.cpp
//   explain_command, messages                                              diagnostics_test.cpp
//   restore_command                                                        outputs_test.cpp
//   command_files, shared_options (with the settings file)                 files_test.cpp
//   main (help, version, exit codes), suggest, values of shared_options    usage_test.cpp
//   progress_line    here, that it is silent where standard error is no terminal; what a terminal gets depends on how
//                    long the work takes, and is not tested
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;
using nlohmann::json;

TEST_CASE("control writes the configuration of a simulated machine, once") {
  const Scratch scratch;
  const Outcome written = run(scratch, "control linuxcnc -o sim" + kOffset + kModel);
  CHECK(written.code == 0);
  CHECK(written.out.empty());
  CHECK(contains(written.err, "linuxcnc sim/hexapod.ini"));
  CHECK(contains(scratch.text("sim/hexapod.var"), "5223 -1008\n"));
  CHECK(contains(scratch.text("sim/hexapod.ini"), "MAX_LINEAR_VELOCITY = 200\n"));
  const Outcome again = run(scratch, "control linuxcnc --speed 6000 -o sim " + kModel);
  CHECK(again.code == 1);
  CHECK(contains(again.err, "control-folder-taken"));
  CHECK(contains(scratch.text("sim/hexapod.ini"), "MAX_LINEAR_VELOCITY = 200\n"));
  CHECK(run(scratch, "control linuxcnc -o other").code == 2);
  const Outcome unknown = run(scratch, "control heidenhain -o other " + kModel);
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "linuxcnc"));
  CHECK_FALSE(scratch.has("other"));
}

TEST_CASE("compensate writes a program, a summary and JSON") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome outcome = run(scratch, "compensate p.ngc -o out.ngc --json sum.json " + kModel + kOffset);
  CHECK(outcome.code == 0);
  CHECK(outcome.out.empty());
  CHECK(contains(outcome.err, "largest correction"));
  CHECK_FALSE(contains(outcome.err, "\r"));
  CHECK(json::parse(scratch.text("sum.json")).at("plumbline") == "compensation 1");
  CHECK(contains(scratch.text("out.ngc"), "compensated this program)"));
  const Outcome twice = run(scratch, "compensate out.ngc -o twice.ngc " + kModel + kOffset);
  CHECK(twice.code == 1);
  CHECK(contains(twice.err, "compensated already"));
}

TEST_CASE("compensate says where what a program needs was not given") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome outcome = run(scratch, "compensate p.ngc -o out.ngc " + kModel);
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "p.ngc:3:"));
  CHECK(contains(outcome.err, "--work-offset"));
}

TEST_CASE("trace prints a line of JSON for each motion") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome outcome = run(scratch, "trace p.ngc");
  CHECK(outcome.code == 0);
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 4);
  const json last = json::parse(outcome.out.substr(outcome.out.rfind('\n', outcome.out.size() - 2) + 1));
  CHECK(last.at("motion") == "arc");
  CHECK(last.at("to") == json({30.5, 20.25, 0, 5, -2.5, 1}));
  CHECK(run(scratch, "trace - -o t.jsonl <p.ngc").code == 0);
  CHECK(scratch.text("t.jsonl") == outcome.out);
}

TEST_CASE("trace and diff take the order of rotations from a model") {
  const Scratch scratch;
  std::string model = scratch.text(source_file("models/pm600-like.toml"));
  REQUIRE(contains(model, "rotation = \"ZYX\""));
  model.replace(model.find("\"ZYX\""), 5, "\"XYZ\"");
  scratch.file("xyz.toml", model);
  // The tool along (1 1 1): A, then B as turned, is not B, then A.
  scratch.file("a.mpf", "G54 G0 X0 Y0 Z0 A0 B0 C0\nG1 X5 A3=1 B3=1 C3=1 F100\nM30\n");
  scratch.file("b.mpf", "G54 G0 X0 Y0 Z0 A0 B0 C0\nG1 X5 A-45 B35.264389683 F100\nM30\n");
  const auto last_to = [&](const std::string& options) {
    const Outcome outcome = run(scratch, "trace a.mpf " + options);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out.substr(outcome.out.rfind('\n', outcome.out.size() - 2) + 1)).at("to");
  };
  CHECK(std::abs(last_to("").at(3).get<double>() + 35.264389683) < 1e-6);
  CHECK(std::abs(last_to("").at(4).get<double>() - 45) < 1e-6);
  CHECK(last_to(kModel) == last_to(""));
  CHECK(std::abs(last_to("-m xyz.toml").at(3).get<double>() + 45) < 1e-6);
  CHECK(std::abs(last_to("-m xyz.toml").at(4).get<double>() - 35.264389683) < 1e-6);
  CHECK(run(scratch, "diff a.mpf b.mpf --expect-equal").code == 3);
  CHECK(run(scratch, "diff a.mpf b.mpf --expect-equal " + kModel).code == 3);
  CHECK(run(scratch, "diff a.mpf b.mpf --expect-equal --model xyz.toml").code == 0);
  scratch.file("plumbline.toml", "plumbline = \"settings 1\"\nmodel = \"xyz.toml\"\n");
  CHECK(run(scratch, "diff a.mpf b.mpf --expect-equal").code == 0);
}

TEST_CASE("error tabulates the machine at rest") {
  const Scratch scratch;
  scratch.file("poses.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,0\n");
  const Outcome outcome = run(scratch, "error " + kModel + " poses.csv");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,length1_mm,"));
  CHECK(contains(outcome.out, "\n0.000,0.000,-1008.000,0.000,0.000,0.000,1251.0212102"));
  CHECK(contains(outcome.out, ",-15.378975"));
  CHECK(run(scratch, "error " + kModel + " - -o e.csv <poses.csv").code == 0);
  CHECK(scratch.text("e.csv") == outcome.out);
  scratch.file("poses.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,oops\n");
  const Outcome wrong = run(scratch, "error " + kModel + " poses.csv");
  CHECK(wrong.code == 1);
  CHECK(wrong.out.empty());
  CHECK(contains(wrong.err, "poses.csv:2:15: error: row 2, column c_deg"));
}

TEST_CASE("standard input is called so in what is said about it, and one pose is no poses") {
  const Scratch scratch;
  scratch.file("wrong.toml", "plumbline = \"model 1\"\nnonsense = 1\n");
  scratch.file("poses.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,0\n");
  const Outcome model = run(scratch, "error poses.csv -m - <wrong.toml");
  CHECK(model.code == 1);
  CHECK(contains(model.err, "<stdin>:"));
  CHECK(contains(run(scratch, "error poses.csv -o e.csv " + kModel).err, "1 pose, the tip"));
  scratch.file("header.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n");
  const Outcome header = run(scratch, "error header.csv -o e.csv " + kModel);
  CHECK(header.code == 1);
  CHECK(contains(header.err, "csv-no-rows"));
}

TEST_CASE("check exits with 3 where a limit is broken") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome kept = run(scratch, "check p.ngc " + kModel + kOffset);
  CHECK(kept.code == 0);
  CHECK(contains(kept.out, "all kept"));
  const Outcome broken = run(scratch, "check p.ngc --json c.json --work-offset G54=290,0,-1008,0,0,0 " + kModel);
  CHECK(broken.code == 3);
  CHECK(contains(broken.out, "p.ngc:5: X would be "));
  CHECK(json::parse(scratch.text("c.json")).at("violations") > 0);
  const Outcome as_json = run(scratch, "check p.ngc --json - " + kModel + kOffset);
  CHECK(json::parse(as_json.out).at("violations") == 0);
}

TEST_CASE("simulate writes a row for each point") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome outcome = run(scratch, "simulate p.ngc " + kModel + kOffset);
  CHECK(outcome.code == 0);
  CHECK(outcome.out.starts_with("line,motion,time_s,x_mm,"));
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') > 40);
  CHECK(contains(outcome.err, "the tip up to"));
}

TEST_CASE("simulate says what is not in its table") {
  const Scratch scratch;
  scratch.file("p.ngc", "G0 X0\nG53 G0 Z0\n");
  const Outcome outcome = run(scratch, "simulate p.ngc" + kOffset + kModel);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "0 points in 0.00 s\n2 moves left out of the table"));
}

TEST_CASE("diff tells programs apart and says so to scripts") {
  const Scratch scratch;
  scratch.file("a.ngc", kPart);
  CHECK(run(scratch, "compensate a.ngc -o b.ngc " + kModel + kOffset).code == 0);
  CHECK(run(scratch, "diff a.ngc a.ngc --expect-equal").code == 0);
  const Outcome outcome = run(scratch, "diff a.ngc b.ngc --json d.json");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "shift of Z"));
  CHECK(contains(outcome.out, "0 moves of A, 0 of B"));
  CHECK(json::parse(scratch.text("d.json")).at("out_of_line_b") == 0);
  CHECK(run(scratch, "diff a.ngc b.ngc --expect-equal").code == 3);
  CHECK(run(scratch, "diff a.ngc b.ngc --expect-equal --tolerance-mm 1 --tolerance-deg 1").code == 0);
  CHECK(run(scratch, "diff - b.ngc --json - <a.ngc").out == scratch.text("d.json"));
}

TEST_CASE("tools, variables and the rest reach the work") {
  const Scratch scratch;
  scratch.file("p.ngc", "G0 X0 Y0 Z0 A0 B0 C0\nT1 M6\nG43 H1\nG1 X#100 F500\n/G1 X2\nM120\nM2\n");
  scratch.file("tools.toml", "plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = 80\nmass_kg = 1\n");
  scratch.file("v.txt", "#100 7.5\n");
  const std::string command = "compensate p.ngc -o out.ngc " + kModel + kOffset;
  CHECK(run(scratch, command).code == 1);
  const Outcome outcome =
      run(scratch, command + "--tools tools.toml --variables v.txt --block-delete on --pass M120 --keeps-position M6");
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(scratch.text("out.ngc"), "(tool 1: length 80 mm, mass 1 kg at 0 mm)"));
  CHECK(contains(scratch.text("out.ngc"), "block delete on"));
}
