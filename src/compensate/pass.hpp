// One reading of a program through the model: block by block, corrected, written in one form.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.hpp"
#include "base/progress.hpp"
#include "compensate/between_points.hpp"
#include "compensate/corrector.hpp"
#include "compensate/intention.hpp"
#include "compensate/program_pose.hpp"
#include "compensate/read_back.hpp"
#include "compensate/settings.hpp"
#include "compensate/summary.hpp"
#include "machine/model.hpp"
#include "nc/rewrite/emit.hpp"
#include "nc/rewrite/step_expander.hpp"
#include "nc/rewrite/written_moves.hpp"
#include "nc/sequence/program.hpp"
#include "path/curve.hpp"
#include "path/subdivide.hpp"

namespace plumbline::compensate {

class Pass {
 public:
  /// All references must outlive it.
  Pass(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
       const machine::MachineModel& model, const Settings& settings, const nc::EmitSettings& emit, OutputFile& out,
       nc::Form form);

  /// Notes what the output replaces; to be called before run(). `log` must outlive the stream.
  void record(nc::UndoLog& log) { emitter_.record(log); }

  /// Shows what the output is meant to do; to be called before run().
  void show(const ReadBack::Observer& observer) {
    if (read_back_) read_back_->show(observer);
  }

  /// Reads the program to its end, and writes it. False, and what was written is of no use: it is to be written in text
  /// order, but jumps, and something in it must change. Refuses as Stream does.
  bool run(const Progress& progress);
  Summary summary();

 private:
  void refuse_system_of_block(const nc::Step& step) const;
  void refuse_stamped(std::string_view file);
  void note_whether_it_ends(const nc::Step& step);
  void warn_of_no_end();
  void warn_of_silent_effects();
  void note_intended();
  void take(const nc::Step& step);
  void process(const nc::Step& step);
  void process_cycle(const nc::Step& step);
  bool cycle_stays(const nc::Step& step, std::span<const nc::Step* const> moves);
  void steer(const nc::Step& step);
  void process_synchronised(const nc::Step& step);
  void process_hole(const nc::Step& step);
  void hole_points(const nc::Step& step);
  void find_points(const nc::Step& step);
  nc::EmittedMove write_move(const nc::Step& step, std::optional<double> duration);
  void copy(const nc::Step& step, bool counts, std::optional<double> seconds = std::nullopt);
  void note_cycle(const nc::Step& step);
  void note_dwell(const nc::Motion& dwell);
  void take_tool(const nc::Step& step);
  void warn_of_massless_tool(const nc::Step& step, int tool);
  bool is_corrected(const nc::Step& step);
  bool has_position(const nc::Step& step, AxisSet known, bool needed);
  AxisSet writable() const;
  bool writes_vector(const nc::Step& step) const;
  void pass(const nc::Step& step);
  void correct_rapid(const nc::Step& step);
  void correct_feed(const nc::Step& step);
  void refuse_unless_in_place(const nc::Step& step, bool goes_on) const;
  void rapid_point(const nc::Step& step);
  void check_way_to_hole(const nc::Step& step, const AxisWords& shift) const;
  void check_level_of_hole(const nc::Step& step, const AxisWords& shift) const;
  OriginalPath path_of(const nc::Step& step, const path::Curve& curve) const;
  void follow_cut(const nc::Step& step, const path::Curve& curve, const AxisWords& begin, bool changed,
                  std::optional<double> seconds);
  path::Subdivision feed_points(const nc::Step& step, const path::Curve& curve, std::optional<double> seconds);
  Target target_of(const nc::Step& step, const path::CurvePoint& point, std::optional<double> seconds) const;
  nc::CorrectedPoint corrected_point(const nc::Step& step, const Target& target, const AxisWords& words);
  void note_widened(const nc::Step& step, const path::Curve& curve, std::optional<double> seconds);
  void note_short_pieces(const nc::Step& step, double seconds);
  void warn_of_short_pieces();
  void note_point(const nc::Step& step, const nc::CorrectedPoint& point);
  void note_move(const nc::Step& step, const nc::EmittedMove& move, std::optional<double> seconds);
  void note_end(const nc::Step& step, const Target& target);
  void note_offset_sensitivity(const Target& target, const AxisWords& commanded);

  const InputFile& source_;
  const nc::Dialect& dialect_;
  const machine::MachineModel& model_;
  const Settings& settings_;
  OutputFile& out_;
  nc::Program program_;
  nc::Form form_;
  double stands_at_ = 0;      // height of the tool before a hole of a cycle, in the original
  bool must_unroll_ = false;  // something changes that cannot be put in the place of its block
  nc::StepExpander plain_;
  nc::WrittenMoves written_;
  nc::Emitter emitter_;
  Corrector corrector_;
  Intention intention_;
  std::optional<ReadBack> read_back_;
  std::uint64_t unchanged_blocks_ = 0;  // before the first that changed
  SpindleTool spindle_;
  ProgramPose pose_;
  Summary summary_;
  AxisWords touch_off_error_;
  std::vector<nc::CorrectedPoint> points_;
  std::vector<machine::PerStrut<double>> signs_;  // of the struts' speeds at these
  BetweenPoints between_;
  std::vector<SentPiece> sent_;
  bool ended_ = false;                        // the last thing that was executed ends a program
  std::size_t last_line_ = 0;                 // that holds a word
  std::set<std::string, std::less<>> files_;  // of subprograms, looked through
  std::map<int, Place> massless_tools_;       // and where each came into the spindle
  std::optional<Target> sample_;              // where the error per kg of a tool is worked out
  double sum_of_squares_ = 0;
  std::uint64_t corrected_moves_ = 0;
};

}  // namespace plumbline::compensate
