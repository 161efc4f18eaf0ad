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

  void cut(const SentMove& move);
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

    /// `all`: its pieces, and those of the moves after it.
    SentMove move(std::span<const SentPiece> all) const {
      return {&path, seconds, begin, all.first(pieces), as_it_stands};
    }
  };
  struct Batch {  // reused
    std::span<const Event> all() const { return std::span(events).first(count); }

    std::vector<Event> events;
    std::size_t count = 0;  // of these
    std::vector<SentPiece> pieces;
  };
  Event& add(Event::Kind kind);
  void hand_over();
  void take(Batch& batch);
  void foresee(std::span<const Event> events, std::span<const SentPiece> pieces);

  Corrector corrector_;
  BetweenPoints between_;
  std::vector<SentMove> moves_;  // that are foreseen
  Batch batch_;
  Relay<Batch> relay_;  // the last: it ends before what it works on
};

}  // namespace plumbline::compensate
