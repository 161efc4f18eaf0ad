// Whole programs: text in, text out, the output read again and played on the model.
#include "compensate/stream.hpp"

#include <cmath>
#include <filesystem>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "base/units.hpp"
#include "compensate/random_program.hpp"
#include "machine/model_file.hpp"
#include "path/duration.hpp"
#include "path/subdivide.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

machine::MachineModel pm600() { return machine::read_model(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml"); }

nc::ProgramSettings in_workspace() {
  nc::ProgramSettings settings;
  settings.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  return settings;
}

struct Job {
  machine::MachineModel model = pm600();
  nc::ProgramSettings program = in_workspace();
  compensate::Settings settings;
  nc::EmitSettings emit = {.stamp = {"plumbline 0 compensated this program"}};
};

class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_ = fs::temp_directory_path() / "plumbline-stream-test";
};

struct Result {
  std::string text;
  compensate::Summary summary;
};

std::string original_of(const std::string& output) {
  OutputFile back(output + ".back");
  nc::restore(InputFile(output), InputFile(output + ".undo"), back);
  back.commit();
  return read_text(output + ".back");
}

Result run(const std::string& text, const Job& job) {
  const Folder folder;
  write_text(folder / "in.ngc", text);
  const InputFile source(folder / "in.ngc");
  OutputFile out(folder / "out.ngc");
  compensate::Stream stream(source, nc::dialect("linuxcnc"), job.program, job.model, job.settings, job.emit, out);
  OutputFile undo(folder / "out.ngc.undo");
  nc::UndoLog log(undo);
  stream.record(log);
  out.keep_hash();
  Result result;
  result.summary = stream.run();
  log.finish(source, out.size(), out.hash());
  undo.commit();
  out.commit();
  result.text = read_text(folder / "out.ngc");
  CHECK(original_of(folder / "out.ngc") == text);
  return result;
}

std::string code_of(const std::string& text, const Job& job, std::size_t* line = nullptr) {
  try {
    run(text, job);
  } catch (const Refusal& refusal) {
    if (line != nullptr) *line = refusal.diagnostic().place.line;
    return refusal.diagnostic().code;
  }
  return "";
}

struct Move {
  nc::Motion motion;
  nc::Frame frame;
  AxisWords from_W, to_W;
};

std::vector<Move> moves_of(const std::string& text, const nc::ProgramSettings& settings) {
  const Folder folder;
  write_text(folder / "again.ngc", text);
  const InputFile source(folder / "again.ngc");
  nc::Program program(source, nc::dialect("linuxcnc"), settings);
  std::vector<Move> moves;
  while (const nc::Step* step = program.next()) {
    for (const nc::Motion& m : step->motions) {
      if (m.kind != nc::MotionKind::dwell)
        moves.push_back({m, *step->frame, step->frame->to_pose(m.from), step->frame->to_pose(m.to)});
    }
  }
  return moves;
}

double tip_distance(const AxisWords& a, const AxisWords& b) {
  const AxisWords d = a - b;
  return std::hypot(d[Axis::X], d[Axis::Y], d[Axis::Z]);
}

struct Played {
  double at_points_um = 0;
  double between_points_um = 0;
  double time_change = 0;
  std::size_t blocks = 0;
};

// Plays the output on the model without friction and holds it against the original path; each block's time too.
Played play(const std::string& original, const std::string& output, const Job& job, double tool_length = 0) {
  Played played;
  compensate::Settings still = job.settings;
  still.friction = false;
  compensate::Corrector machine(job.model, still);
  machine.set_tool({.length = tool_length, .mass = 0, .along = 0});
  const auto stands = [&](const AxisWords& commanded) {
    return commanded + machine.error({commanded, {}, std::nullopt}).value();
  };
  const std::vector<Move> before = moves_of(original, job.program);
  const std::vector<Move> after = moves_of(output, job.program);
  const nc::Dialect& dialect = nc::dialect("linuxcnc");
  std::size_t next = 0;
  for (const Move& move : before) {
    const bool cuts = move.motion.kind != nc::MotionKind::rapid;
    const path::Curve curve(move.motion);
    const auto seconds = path::duration(move.motion, curve, dialect);
    const int pieces = cuts ? path::subdivide(curve, seconds, job.settings.step).pieces : 1;
    double spent = 0;
    for (int i = 1; i <= pieces; ++i, ++next) {
      REQUIRE(next < after.size());
      const Move& piece = after[next];
      const auto on_path = [&](double fraction) { return move.frame.to_pose(curve.at(fraction)); };
      played.at_points_um =
          std::max(played.at_points_um, tip_distance(stands(piece.to_W), on_path(1.0 * i / pieces)) * 1e3);
      spent += path::duration(piece.motion, path::Curve(piece.motion), dialect).value_or(0);
      if (!cuts) continue;
      AxisWords middle;
      for (const Axis axis : kAllAxes) middle[axis] = (piece.from_W[axis] + piece.to_W[axis]) / 2;
      played.between_points_um =
          std::max(played.between_points_um, tip_distance(stands(middle), on_path((i - 0.5) / pieces)) * 1e3);
    }
    if (seconds && *seconds > 0) played.time_change = std::max(played.time_change, std::abs(spent / *seconds - 1));
    ++played.blocks;
  }
  CHECK(next == after.size());
  return played;
}

const std::string kFiveMoves =
    "G21 G90 G94 G17\n"
    "G0 X0 Y0 Z20 A0 B0 C0\n"
    "G1 X20 Y10 Z0 A-12 B5 C3 F900\n"
    "G3 X-20 Y10 I-20 J15 A-5\n"
    "G1 A3 B-4\n"
    "G93 G1 X0 Y0 F12\n"
    "C-3 B2 F30\n"
    "G94 G1 X5 F500\n"
    "G91 G1 X1.5 Y-2\n"
    "A1.5\n"
    "G90 G0 Z30\n"
    "M2\n";

}  // namespace

TEST_CASE("a compensated program puts the deformed tip on the programmed path, in the programmed time") {
  Job job;
  job.settings.friction = false;
  const Result result = run(kFiveMoves, job);
  const Played played = play(kFiveMoves, result.text, job);
  CHECK(played.blocks == 10);
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.between_points_um <= 0.5);
  CHECK(played.time_change <= 1e-3);
  CHECK(result.summary.points > 400);
  CHECK(result.summary.correction_mm.value > 0.005);
  CHECK(result.summary.residual_mm.value < 1e-5);
  CHECK(result.summary.time_change.value <= 1e-3);
  CHECK(result.summary.seconds_after == Approx(result.summary.seconds_before).epsilon(1e-3));
}

TEST_CASE("programs drawn at random keep path and time in every mode") {
  Job job;
  job.settings.friction = false;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    const std::string text = RandomProgram(seed).text(40);
    INFO("seed " << seed << "\n" << text);
    const Played played = play(text, run(text, job).text, job);
    CHECK(played.at_points_um <= 0.15);
    CHECK(played.time_change <= 1e-3);
  }
}

TEST_CASE("inch programs come out as well") {
  Job job;
  job.settings.friction = false;
  const std::string text =
      "G20 G90 G94\nG0 X0 Y0 Z1 A0 B0 C0\nG1 X1 Y.5 Z0 A-5 F30\nG2 X2 Y.5 I.5 J0\nG1 B3\nG93 X1.5 C1 F20\nA2 F60\n";
  const Played played = play(text, run(text, job).text, job);
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.time_change <= 1e-3);
}

TEST_CASE("offsets with a rotation, G92 and a second system hold") {
  Job job;
  job.settings.friction = false;
  job.program.work_offsets[1] = nc::WorkOffset{{{10, 20, -1000, 0, 0, 5}}, 0};
  const std::string text =
      "G10 L2 P1 X0 Y0 Z-1008 A0 B0 C0 R30\nG0 X10 Y0 Z0 A-5 B0 C0\nG1 X20 F600\nG92 X0 Z5\nG1 X5 Y5\nG92.1\n"
      "G55 G1 X0 Y0\nG1 C2 X3\n";
  const Played played = play(text, run(text, job).text, job);
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.time_change <= 1e-3);
}

TEST_CASE("a model without errors gives back its input") {
  Job job;
  job.model.gravity.setZero();
  job.settings.friction = false;
  const Result result = run(kFiveMoves, job);
  CHECK(result.text == kFiveMoves);
  CHECK(result.summary.identical);
}

TEST_CASE("a program that never names A B C is corrected at the tip, and no rotary word appears") {
  Job job;
  job.settings.friction = false;
  const std::string text = "G21 G90 G94\nG0 X0 Y0 Z5\nG1 Z-1 F300\nX40\nG2 X60 Y20 I0 J20\n";
  const Result result = run(text, job);
  const std::string body = result.text.substr(result.text.find("G21"));
  CHECK(body.find_first_of("ABC") == std::string::npos);
  CHECK(result.summary.assumed_at_zero == AxisSet::rotary());
  CHECK(play(text, result.text, job).at_points_um <= 0.15);
}

TEST_CASE("cutting with an unknown position is refused, a rapid goes through as it stands") {
  std::size_t line = 0;
  CHECK(code_of("G21 G90 G94\nG1 X5 F100\n", {}, &line) == "compensate-position-unknown");
  CHECK(line == 2);
  CHECK(code_of("G0 X0 Y0\nG1 X5 F100\nZ5\n", {}) == "compensate-position-unknown");
  CHECK(code_of("G0 X0 Y0 Z0\nG1 X5 F100\nA5\n", {}, &line) == "compensate-position-unknown");  // A is named later
  CHECK(line == 2);
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nT1 M6\nG1 X5 F100\n", {}) == "compensate-position-unknown");
  Job kept;
  kept.program.keeps_position = {6};
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nT1 M6\nG1 X5 F100\n", kept).empty());
  const Result result = run("G0 Z9\nG0 X0 Y0 Z0 A0 B0 C0\n", {});
  CHECK(result.text.find(")\nG0 Z9\nG0 X") != std::string::npos);
  CHECK_FALSE(result.summary.identical);
}

TEST_CASE("limits are refused by block, axis or strut, and by how much") {
  std::size_t line = 0;
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nG1 A30 F500\n", {}, &line) == "limit-tilt");
  CHECK(line == 2);
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nG0 X400\n", {}) == "limit-travel");
  // Both ends are inside, the chord leaves the length of a strut.
  Job short_strut;
  short_strut.model.limits.length_min.setConstant(1.2);
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nG1 Z150 F500\n", short_strut) == "limit-strut");
  Job stiff;
  stiff.model.limits.condition_max = 2;
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\n", stiff) == "limit-condition");
}

TEST_CASE("a compensated program is refused") {
  const std::string once = run(kFiveMoves, {}).text;
  CHECK(code_of(once, {}) == "compensate-stamped");
}

TEST_CASE("offsets that nobody gave are refused") {
  CHECK(code_of("G55\nG0 X0 Y0 Z0 A0 B0 C0\n", {}) == "nc-work-offset-unknown");
}

TEST_CASE("at the touch-off pose nothing is left to correct") {
  Job job;
  job.settings.friction = false;
  job.settings.touch_off = AxisWords{{30, 40, -1008, -10, 5, 0}};
  const std::string text = "G0 X30 Y40 Z0 A-10 B5 C0\n";
  CHECK(run(text, job).text == text);
}

TEST_CASE("the summary says how far the zero is off and what a shift of the offset costs") {
  const compensate::Summary summary = run(kFiveMoves, {}).summary;
  REQUIRE(summary.zero_error.has_value());
  CHECK(summary.zero_error_line == 3);
  CHECK(tip_distance(*summary.zero_error, {}) > 0.005);
  CHECK(summary.offset_shift_for_1um_mm > 0.5);
  CHECK(summary.offset_shift_for_1um_mm < 500);
  CHECK(summary.blocks == 12);
}

TEST_CASE("a control that needs time for each block gets longer pieces") {
  Job job;
  job.settings.step.least_time_s = 0.5;
  const compensate::Summary summary = run(kFiveMoves, job).summary;
  CHECK(summary.widened_blocks > 0);
  CHECK(summary.points < 200);
}

TEST_CASE("a tool without a mass is warned of, with the error per kg") {
  Job job;
  nc::Tool tool;
  tool.number = 1;
  tool.length_mm = 80;
  job.program.tools = nc::ToolTable({tool});
  const std::string text = "T1 M6\nG43 H1\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X5 F100\n";
  const compensate::Summary summary = run(text, job).summary;
  REQUIRE(summary.warnings.size() == 1);
  CHECK(summary.warnings[0].code == "compensate-tool-mass");
  CHECK(summary.warnings[0].message.find("um") != std::string::npos);
  job.settings.friction = false;
  CHECK(play(text, run(text, job).text, job, 0.08).at_points_um <= 0.15);
}
