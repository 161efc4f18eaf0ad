// Records what became of the moves of a program, on a thread of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/relay.hpp"
#include "compensate/move_corrector.hpp"
#include "compensate/recorded/path_record.hpp"
#include "compensate/rewriter.hpp"

namespace plumbline::compensate {

class OutputRecord {
 public:
  /// The record must outlive it; it is begun anew.
  explicit OutputRecord(PathRecord& record);

  /// A tool came into the spindle; `number` is -1 where it is not known.
  void set_tool(const ToolInSpindle& tool, int number);
  /// The machine goes where nobody follows it.
  void leave();
  /// What was written for a move begins at a byte of the output, and ends before another one.
  void move(const CorrectedMove& corrected, const WrittenMove& written, std::uint64_t after_begin,
            std::uint64_t after_end);
  /// A move of a block that is shifted as a whole, or left as it stands (no shift); the same bytes.
  void shifted(const Move& move, const AxisWords& shift, std::uint64_t after_begin, std::uint64_t after_end);
  /// Waits until all is recorded; to be called once, at the end.
  void finish();

 private:
  struct Event {
    enum class Kind : std::uint8_t { move, leave, tool };
    Kind kind = Kind::leave;
    MovePath path;
    WayKind way = WayKind::line;
    std::optional<double> seconds;
    AxisWords begin;
    bool begin_known = true;
    std::size_t pieces = 0;
    std::size_t text = 0, file = 0;  // characters
    std::uint64_t after_begin = 0, after_end = 0;
    ToolInSpindle tool;
    int number = -1;
  };
  struct Batch {  // reused
    std::vector<Event> events;
    std::size_t count = 0;  // of these
    std::vector<SentPiece> pieces;
    std::string text;
  };
  Event& add(Event::Kind kind);
  Event& add(const Move& move);
  void hand_over();
  void take(Batch& batch);
  void take_move(const Event& event, std::span<const SentPiece> pieces, const PathRecord::Texts& texts);
  void take_begin(const Event& event, const PathRecord::Texts& texts);
  RecordedPoint point(const Event& event, double fraction) const;

  PathRecord& record_;
  double time_s_ = 0;
  Batch batch_;
  Relay<Batch> relay_;  // the last: it ends before what it works on
};

}  // namespace plumbline::compensate
