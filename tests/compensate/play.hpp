// Whole programs, for tests: text in, text out, the output read again and played on the model.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "base/units.hpp"
#include "compensate/corrector.hpp"
#include "compensate/stream.hpp"
#include "machine/model_file.hpp"
#include "nc/sequence/program.hpp"
#include "path/duration.hpp"
#include "path/subdivide.hpp"
#include "support/scratch.hpp"

namespace plumbline {

inline machine::MachineModel pm600() { return machine::read_model(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml"); }

inline nc::ProgramSettings in_workspace() {
  nc::ProgramSettings settings;
  settings.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  return settings;
}

struct Job {
  machine::MachineModel model = pm600();
  nc::ProgramSettings program = in_workspace();
  compensate::Settings settings;
  std::string dialect = "linuxcnc";
  nc::EmitSettings emit = {.stamp = {"plumbline 0 compensated this program"}};
};

inline Job without_friction() {
  Job job;
  job.settings.friction = false;
  return job;
}

/// How many warnings of this code the summary has.
inline std::ptrdiff_t warnings_of(const compensate::Summary& summary, std::string_view code) {
  return std::count_if(summary.warnings.begin(), summary.warnings.end(),
                       [&](const Diagnostic& warning) { return warning.code == code; });
}

/// A program for this control, under any work system, without friction.
inline Job job_of_control(const std::string& dialect) {
  Job job;
  job.dialect = dialect;
  job.settings.friction = false;
  for (auto& offset : job.program.work_offsets) offset = job.program.work_offsets[0];
  return job;
}

/// Tool 1 alone, 100 mm long.
inline nc::ToolTable one_tool(double mass_kg) {
  nc::Tool tool;
  tool.number = 1;
  tool.length_mm = 100;
  tool.mass_kg = mass_kg;
  return nc::ToolTable({tool});
}

/// For a Fanuc, without friction, tool 1 in the spindle: 100 mm long.
inline Job fanuc_job() {
  Job job;
  job.dialect = "fanuc";
  job.settings.friction = false;
  job.program.tool_in_spindle = 1;
  job.program.tools = one_tool(1);
  return job;
}

inline compensate::ProgramSurvey surveyed(const InputFile& source, const Job& job) {
  const nc::Dialect& dialect = nc::dialect(job.dialect);
  return {dialect, nc::named_axes(source, dialect)};
}

using Folder = testing::Scratch;

inline bool has_text(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Result {
  std::string text;
  compensate::Summary summary;
};

inline std::string original_of(const std::string& output) {
  OutputFile back(output + ".back");
  nc::restore(InputFile(output), InputFile(output + ".undo"), back);
  back.commit();
  return read_text(output + ".back");
}

/// `beside`: a folder whose programs stand beside this one.
inline Result run(const std::string& text, const Job& job, const std::filesystem::path& beside = {}) {
  const Folder folder;
  if (!beside.empty()) {
    for (const auto& entry : std::filesystem::directory_iterator(beside)) {
      if (entry.is_regular_file())
        std::filesystem::create_symlink(entry.path(), folder / entry.path().filename().string());
    }
  }
  write_text(folder / "program.in", text);
  const InputFile source(folder / "program.in");
  OutputFile out(folder / "program.out");
  const compensate::ProgramSurvey survey = surveyed(source, job);
  compensate::Stream stream(source, survey, job.program, job.model, job.settings, job.emit, out);
  OutputFile undo(folder / "program.out.undo");
  nc::UndoLog log(undo);
  stream.record(log);
  out.keep_hash();
  Result result;
  result.summary = stream.run();
  log.finish(source, out.size(), out.hash());
  undo.commit();
  out.commit();
  result.text = read_text(folder / "program.out");
  CHECK(original_of(folder / "program.out") == text);
  return result;
}

inline std::string code_of(const std::string& text, const Job& job, std::size_t* line = nullptr) {
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

/// Reads a program again; `take` is handed each step.
template <class Take>
void for_each_step(const std::string& text, const nc::ProgramSettings& settings, const std::string& dialect,
                   const Take& take) {
  const Folder folder;
  write_text(folder / "again.ngc", text);
  const InputFile source(folder / "again.ngc");
  nc::Program program(source, nc::dialect(dialect), settings);
  while (const nc::Step* step = program.next()) take(*step);
}

inline std::vector<Move> moves_of(const std::string& text, const nc::ProgramSettings& settings,
                                  const std::string& dialect = "linuxcnc") {
  std::vector<Move> moves;
  for_each_step(text, settings, dialect, [&](const nc::Step& step) {
    for (const nc::Motion& m : step.motions) {
      // A cycle goes through all its stations, also where it stands there already.
      const bool stands = step.role == nc::BlockRole::cycle && m.from == m.to;
      if (m.kind != nc::MotionKind::dwell && !stands)
        moves.push_back({m, *step.frame, step.frame->to_pose(m.from), step.frame->to_pose(m.to)});
    }
  });
  return moves;
}

/// Seconds of each wait.
inline std::vector<double> dwells_of(const std::string& text, const Job& job) {
  std::vector<double> dwells;
  for_each_step(text, job.program, job.dialect, [&](const nc::Step& step) {
    for (const nc::Motion& m : step.motions) {
      if (m.kind == nc::MotionKind::dwell) dwells.push_back(m.dwell_s);
    }
  });
  return dwells;
}

inline double tip_distance(const AxisWords& a, const AxisWords& b) {
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
inline Played play(const std::string& original, const std::string& output, const Job& job,
                   const compensate::ToolInSpindle& tool = {}) {
  Played played;
  compensate::Settings still = job.settings;
  still.friction = false;
  compensate::Corrector machine(job.model, still);
  machine.set_tool(tool);
  const auto stands = [&](const AxisWords& commanded) {
    return commanded + machine.error({commanded, {}, {}, std::nullopt}).value();
  };
  const std::vector<Move> before = moves_of(original, job.program, job.dialect);
  const std::vector<Move> after = moves_of(output, job.program, job.dialect);
  const nc::Dialect& dialect = nc::dialect(job.dialect);
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
    if (seconds && *seconds > 1e-9) played.time_change = std::max(played.time_change, std::abs(spent / *seconds - 1));
    ++played.blocks;
  }
  CHECK(next == after.size());
  return played;
}

}  // namespace plumbline
