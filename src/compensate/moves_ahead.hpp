// Corrects the points of short moves in packs, on the thread that reads the program.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
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
  /// All but `reader` must outlive it.
  MovesAhead(const machine::MachineModel& model, const Settings& settings, const nc::Dialect& dialect,
             const nc::ToolTable& tools, const ReaderSettings& reader);

  void look(const nc::KeptSteps& steps, std::size_t place) override;
  /// Axes that are taken to stand at zero from now on, as far as is known by now.
  void assume_at_zero(AxisSet axes) { at_zero_.store(axes, std::memory_order_relaxed); }
  /// Of the steps that were handed over so many times; to be asked while the last step taken is one of them.
  const PointsAhead& points(std::uint64_t handed_over) const { return points_[(handed_over - 1) % kPlaces]; }

 private:
  void add(const nc::Step& step, std::vector<Target>& targets) const;

  const nc::Dialect& dialect_;
  const ReaderSettings reader_;
  Corrector corrector_;
  SpindleTool spindle_;
  std::uint64_t looks_ = 0;
  std::uint64_t tools_ = 0;  // that came into the spindle
  std::array<PointsAhead, kPlaces> points_;
  std::atomic<AxisSet> at_zero_{};
};

}  // namespace plumbline::compensate
