#include "compensate/recorded/output_record.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::compensate {
namespace {

constexpr std::size_t kMostEvents = 128;  // of a batch, or so many pieces:
constexpr std::size_t kMostPieces = 1024;
constexpr double kDrawnDeg = 6;  // of a straight line in the picture of an arc

AxisWords between(const AxisWords& a, const AxisWords& b, double fraction) {
  AxisWords at;
  for (const Axis axis : kAllAxes) at[axis] = a[axis] + fraction * (b[axis] - a[axis]);
  return at;
}

int drawn_parts(const MovePath& path, double share) {
  return std::max(1, static_cast<int>(std::ceil(std::abs(path.curve.arc_deg()) * share / kDrawnDeg)));
}

}  // namespace

OutputRecord::OutputRecord(PathRecord& record) : record_(record), relay_([this](Batch& batch) { take(batch); }) {
  record_.restart();
}

OutputRecord::Event& OutputRecord::add(Event::Kind kind) {
  if (batch_.count == kMostEvents || batch_.pieces.size() >= kMostPieces) hand_over();
  if (batch_.events.size() == batch_.count) batch_.events.emplace_back();
  Event& event = batch_.events[batch_.count++];
  event.kind = kind;
  return event;
}

void OutputRecord::hand_over() {
  relay_.hand_over(batch_);
  batch_.count = 0;
  batch_.pieces.clear();
  batch_.text.clear();
}

void OutputRecord::set_tool(const ToolInSpindle& tool, int number) {
  Event& event = add(Event::Kind::tool);
  event.tool = tool;
  event.number = number;
}

void OutputRecord::leave() { add(Event::Kind::leave); }

OutputRecord::Event& OutputRecord::add(const Move& move) {
  Event& event = add(Event::Kind::move);
  event.path = move.path;
  event.way = way_kind(move.motion->kind);
  event.seconds = move.seconds;
  event.begin_known = move.begin_known;
  const std::string_view text = move.step->block->text.substr(0, kMostText);
  const std::string_view file = move.step->block->file;
  event.text = text.size();
  event.file = file.size();
  batch_.text += text;
  batch_.text += file;
  return event;
}

void OutputRecord::shifted(const Move& move, const AxisWords& shift, std::uint64_t after_begin,
                           std::uint64_t after_end) {
  Event& event = add(move);
  event.begin = move.path.in_base_frame(move.motion->from + shift);
  event.after_begin = after_begin;
  event.after_end = after_end;
  const AxisWords end = move.path.in_base_frame(move.motion->to + shift);
  batch_.pieces.push_back({end, end, 1, {}});
  event.pieces = 1;
}

void OutputRecord::move(const CorrectedMove& corrected, const WrittenMove& written, std::uint64_t after_begin,
                        std::uint64_t after_end) {
  const Move& move = corrected.move;
  Event& event = add(move);
  event.begin = move.path.in_base_frame(move.motion->from + corrected.standing);
  event.after_begin = written.changed ? after_begin : after_end;
  event.after_end = after_end;
  if (move.is_rapid()) {
    const AxisWords end = corrected.commanded(0);
    batch_.pieces.push_back({end, end, 1, corrected.signs.back()});
    event.pieces = 1;
  } else {
    batch_.pieces.insert(batch_.pieces.end(), written.pieces.begin(), written.pieces.end());
    event.pieces = written.pieces.size();
  }
}

void OutputRecord::finish() {
  hand_over();
  relay_.finish();
}

void OutputRecord::take(Batch& batch) {
  std::span<const SentPiece> pieces = batch.pieces;
  std::string_view text = batch.text;
  for (const Event& event : std::span(batch.events).first(batch.count)) {
    switch (event.kind) {
      case Event::Kind::move:
        take_move(event, pieces.first(event.pieces),
                  {text.substr(0, event.text), {}, text.substr(event.text, event.file)});
        pieces = pieces.subspan(event.pieces);
        text.remove_prefix(event.text + event.file);
        break;
      case Event::Kind::leave:
        record_.leave();
        break;
      case Event::Kind::tool:
        record_.set_tool(event.tool, event.number);
        break;
    }
  }
}

RecordedPoint OutputRecord::point(const Event& event, double fraction) const {
  RecordedPoint point = recorded_point(event.path, event.way, fraction, event.seconds, time_s_);
  point.after_begin = event.after_begin;
  point.after_end = event.after_end;
  return point;
}

// Where a move begins that nobody knows the way to.
void OutputRecord::take_begin(const Event& event, const PathRecord::Texts& texts) {
  if (!record_.has_left() || !event.begin_known) return;
  RecordedPoint begin = point(event, 0);
  begin.commanded = event.begin;
  begin.mm_s.reset();
  record_.add(std::move(begin), texts);
}

// An arc is drawn in parts; its correction goes evenly from one end of a piece to the other.
void OutputRecord::take_move(const Event& event, std::span<const SentPiece> pieces, const PathRecord::Texts& texts) {
  take_begin(event, texts);
  double from = 0;
  AxisWords begin = event.begin;
  for (const SentPiece& piece : pieces) {
    const double to = &piece == &pieces.back() ? 1 : from + piece.share;
    const int parts = event.way == WayKind::arc ? drawn_parts(event.path, to - from) : 1;
    const AxisWords before = begin - event.path.pose(from);
    const AxisWords after = piece.end - event.path.pose(to);
    for (int i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      RecordedPoint at = point(event, i == parts ? to : from + share * (to - from));
      at.commanded = i == parts ? piece.end : at.asked.pose + between(before, after, share);
      if (event.seconds) at.piece_s = *event.seconds * (to - from);
      record_.add(std::move(at), texts);
    }
    from = to;
    begin = piece.end;
  }
  time_s_ += event.seconds.value_or(0);
}

}  // namespace plumbline::compensate
