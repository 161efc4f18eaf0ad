// What a compensation did, noted block by block for the summary.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/files/files.hpp"
#include "compensate/hole_corrector.hpp"
#include "compensate/move_corrector.hpp"
#include "compensate/rewriter.hpp"
#include "compensate/settings.hpp"
#include "compensate/summary.hpp"
#include "machine/model.hpp"

namespace plumbline::compensate {

class Tally {
 public:
  /// All must outlive it.
  Tally(const InputFile& source, const nc::Dialect& dialect, const machine::MachineModel& model,
        const Settings& settings, const Corrector& corrector)
      : source_(source), dialect_(dialect), model_(model), settings_(settings), corrector_(corrector) {}

  /// A block of the program was read.
  void take_block(const nc::Step& step);
  /// Times that the rewriting keeps: of a wait, and of the moves of a cycle that stays one.
  void take_dwell(const nc::Motion& dwell) { take_kept_time(dwell.dwell_s); }
  void take_cycle(const nc::Step& step);
  void take_passed_move() { ++summary_.passed_moves; }
  void take_rapid(const CorrectedMove& corrected, const WrittenMove& written);
  void take_cut(const CorrectedMove& corrected, const WrittenMove& written);
  void take_hole(const CorrectedHole& hole, const nc::EmittedMove& written);
  /// To be called before the corrector gets another tool.
  void before_other_tool() { note_offset_sensitivity(); }
  /// A tool without a mass came into the spindle.
  void take_massless_tool(const nc::Step& step);

  /// All of it but what the output itself says.
  Summary summary();

 private:
  void take_kept_time(double seconds);
  void note_point(const nc::CorrectedPoint& point, const SourceLine& at);
  void note_written(const nc::EmittedMove& written, std::optional<double> seconds, const SourceLine& at);
  void note_end(const CorrectedMove& corrected);
  void note_offset_sensitivity();
  void note_widened(const CorrectedMove& corrected);
  void note_bound(const CorrectedMove& corrected);
  void note_short_pieces(const WrittenMove& written, double seconds, const SourceLine& at);
  void warn_of_no_end(Summary& summary) const;
  void warn_of_short_pieces(Summary& summary) const;
  void warn_of_silent_effects(Summary& summary) const;
  void warn_of_massless_tools(Summary& summary) const;

  const InputFile& source_;
  const nc::Dialect& dialect_;
  const machine::MachineModel& model_;
  const Settings& settings_;
  const Corrector& corrector_;
  Summary summary_;
  bool ended_ = false;                    // the last thing that was executed ends a program
  std::size_t last_line_ = 0;             // that holds a word
  std::optional<Place> length_unstated_;  // a cut before the program says which tool length is in force
  std::optional<Place> unit_unstated_;    // a cut before it says in which unit
  std::optional<Place> may_stop_;         // a block that became several, where the program states no path mode
  std::map<int, Place> massless_tools_;   // and where each came into the spindle
  std::optional<std::pair<double, Place>> negative_length_;  // the first that moves were made with
  std::vector<AxisWords> ends_;                              // corrections of ends of moves, of which is not yet known
  std::vector<Target> beside_;                               // how they change: in X, Y and Z of each
  Corrections corrections_;                                  // of targets beside those of the program
  std::optional<Target> sample_;                             // where the error per kg of a tool is worked out
  double sum_of_squares_ = 0;
  std::uint64_t cuts_ = 0;
};

}  // namespace plumbline::compensate
