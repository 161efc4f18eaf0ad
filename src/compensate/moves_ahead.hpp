// Corrects the points of short moves in packs, on the thread that reads the program.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "compensate/corrector.hpp"
#include "compensate/move_corrector.hpp"
#include "compensate/move_reader.hpp"
#include "nc/sequence/program_ahead.hpp"

namespace plumbline::compensate {

/// Guesses what will be asked for: who comes to a move takes its points where they are those that were corrected, with
/// the tool that is in the spindle. One pose alone takes nearly as long as eight together.
class MovesAhead : public nc::StepsAhead {
 public:
  /// All but `reader` must outlive it. `program`: the name of its own file; moves of all others are told with theirs.
  MovesAhead(const machine::MachineModel& model, const Settings& settings, const nc::Dialect& dialect,
             const nc::ToolTable& tools, const ReaderSettings& reader, std::string_view program = {});

  void look(const nc::KeptSteps& steps, std::size_t place) override;

  // For the thread that takes the steps
  /// Each step when it is taken; `handed_over` and `place` as of nc::ProgramAhead.
  void come_to(const nc::Step& step, std::uint64_t handed_over, std::size_t place);
  /// False where nothing is read ahead.
  bool looks() const { return handed_over_ > 0; }
  /// Points of the steps that were handed over together with the one that is come to.
  const PointsAhead& points() const { return points_[place_]; }
  /// The move of the step that is come to, where it was made with these axes at zero; else null.
  const MoveAhead* move_of(const nc::Step& step, AxisSet at_zero);

 private:
  void add(const nc::Step& step, PointsAhead& points) const;

  const nc::Dialect& dialect_;
  const ReaderSettings reader_;
  std::string_view program_;
  Corrector corrector_;
  SpindleTool spindle_;
  std::uint64_t looks_ = 0;
  std::uint64_t tools_ = 0;  // that came into the spindle
  std::array<PointsAhead, kPlaces> points_;
  std::atomic<AxisSet> at_zero_{};
  // Of the thread that takes the steps
  std::uint64_t handed_over_ = 0;
  std::size_t place_ = 0;
  std::size_t met_ = 0;              // moves that were come to since then
  const MoveAhead* here_ = nullptr;  // of the step that is come to
};

}  // namespace plumbline::compensate
