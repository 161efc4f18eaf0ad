// Plays what was written on the model, on a thread of its own.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/relay.hpp"
#include "compensate/corrector.hpp"
#include "compensate/move.hpp"
#include "compensate/played/between_points.hpp"

namespace plumbline::compensate {

/// BetweenPoints on another thread: what is told here is told there, in the same order.
class OutputPlay {
 public:
  /// Both must outlive it.
  OutputPlay(const machine::MachineModel& model, const Settings& settings);

  void cut(const MovePath& path, std::optional<double> seconds, const AxisWords& begin,
           std::span<const SentPiece> pieces, bool as_it_stands);
  void rapid(const machine::PerStrut<double>& sign);
  void leave();
  /// Leaves, and goes on with another tool.
  void set_tool(const ToolInSpindle& tool);
  /// Leaves, and waits until all is played; to be called once, at the end.
  const BetweenPoints& finish();

 private:
  struct Event {
    enum class Kind { cut, rapid, leave, tool };
    Kind kind = Kind::leave;
    MovePath path;
    std::optional<double> seconds;
    AxisWords begin;
    std::size_t pieces = 0;
    bool as_it_stands = false;
    machine::PerStrut<double> sign;
    ToolInSpindle tool;
  };
  struct Batch {  // reused
    std::vector<Event> events;
    std::size_t count = 0;  // of these
    std::vector<SentPiece> pieces;
  };
  Event& add(Event::Kind kind);
  void hand_over();
  void take(Batch& batch);

  Corrector corrector_;
  BetweenPoints between_;
  Batch batch_;
  Relay<Batch> relay_;  // the last: it ends before what it works on
};

}  // namespace plumbline::compensate
