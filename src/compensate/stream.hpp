// A program through the model: read block by block, corrected, written.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "base/files.hpp"
#include "base/progress.hpp"
#include "compensate/corrector.hpp"
#include "compensate/settings.hpp"
#include "compensate/summary.hpp"
#include "machine/model.hpp"
#include "nc/emit.hpp"
#include "nc/program.hpp"
#include "path/curve.hpp"

namespace plumbline::compensate {

class Stream {
 public:
  /// All references must outlive it.
  Stream(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
         const machine::MachineModel& model, const Settings& settings, nc::EmitSettings emit, OutputFile& out);

  /// Notes what the output replaces; to be called before run(). `log` must outlive the stream.
  void record(nc::UndoLog& log) { emitter_.record(log); }

  /// Compensates the whole program into `out`, which is left for the caller to commit. Refuses with nc-..., limit-...,
  /// emit-... or compensate-... and the place.
  Summary run(const Progress& progress = {});

 private:
  void refuse_stamped(const nc::Block& block) const;
  void refuse_flow(const nc::Step& step) const;
  void set_touch_off();
  void take_tool(const nc::Step& step);
  void warn_of_massless_tool(const nc::Step& step, int tool);
  bool is_corrected(const nc::Step& step);
  AxisSet assumed_axes(const nc::Step& step, AxisSet unknown);
  AxisSet writable() const;
  void pass(const nc::Step& step);
  void correct_rapid(const nc::Step& step);
  void correct_feed(const nc::Step& step);
  Target target_of(const nc::Step& step, const AxisWords& words, const AxisWords& slope,
                   std::optional<double> seconds) const;
  nc::CorrectedPoint corrected_point(const nc::Step& step, const Target& target, const AxisWords& words);
  void check_chord(const nc::Step& step, const AxisWords& from, const AxisWords& to) const;
  void note_widened(const nc::Step& step, const path::Curve& curve, std::optional<double> seconds);
  void note_point(const nc::Step& step, const nc::CorrectedPoint& point);
  void note_move(const nc::Step& step, const nc::EmittedMove& move, std::optional<double> seconds);
  void note_end(const nc::Step& step, const Target& target);
  void note_offset_sensitivity(const Target& target, const AxisWords& commanded);
  void finish_summary();

  const InputFile& source_;
  const nc::Dialect& dialect_;
  const nc::ProgramSettings& program_settings_;
  const machine::MachineModel& model_;
  const Settings& settings_;
  nc::Program program_;
  nc::Emitter emitter_;
  Corrector corrector_;
  Summary summary_;
  AxisWords touch_off_error_;
  std::optional<AxisSet> assumed_;  // rotary axes that no word names; looked for when first asked
  std::vector<nc::CorrectedPoint> points_;
  AxisWords tool_offset_;
  int tool_in_spindle_ = -1;
  std::map<int, Place> massless_tools_;  // and where each came into the spindle
  std::optional<Target> sample_;         // where the error per kg of a tool is worked out
  double sum_of_squares_ = 0;
  std::uint64_t corrected_moves_ = 0;
};

}  // namespace plumbline::compensate
