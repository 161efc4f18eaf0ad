#include "compensate/played/output_play.hpp"

namespace plumbline::compensate {
namespace {

constexpr std::size_t kEvents = 128;  // of a batch, or so many pieces:
constexpr std::size_t kPieces = 1024;

}  // namespace

OutputPlay::OutputPlay(const machine::MachineModel& model, const Settings& settings)
    : corrector_(model, settings), between_(corrector_), relay_([this](Batch& batch) { take(batch); }) {}

OutputPlay::Event& OutputPlay::add(Event::Kind kind) {
  if (batch_.count == kEvents || batch_.pieces.size() >= kPieces) hand_over();
  if (batch_.events.size() == batch_.count) batch_.events.emplace_back();
  Event& event = batch_.events[batch_.count++];
  event.kind = kind;
  return event;
}

void OutputPlay::hand_over() {
  relay_.hand_over(batch_);
  batch_.count = 0;
  batch_.pieces.clear();
}

void OutputPlay::cut(const SentMove& move) {
  Event& event = add(Event::Kind::cut);
  event.path = *move.path;
  event.seconds = move.seconds;
  event.begin = move.begin;
  event.pieces = move.pieces.size();
  event.as_it_stands = move.as_it_stands;
  batch_.pieces.insert(batch_.pieces.end(), move.pieces.begin(), move.pieces.end());
}

void OutputPlay::rapid(const machine::PerStrut<double>& sign) { add(Event::Kind::rapid).sign = sign; }

void OutputPlay::leave() { add(Event::Kind::leave); }

void OutputPlay::set_tool(const ToolInSpindle& tool) { add(Event::Kind::tool).tool = tool; }

const BetweenPoints& OutputPlay::finish() {
  leave();
  hand_over();
  relay_.finish();
  return between_;
}

// Up to the next change of the tool.
void OutputPlay::foresee(std::span<const Event> events, std::span<const SentPiece> pieces) {
  moves_.clear();
  for (const Event& event : events) {
    if (event.kind == Event::Kind::tool) break;
    if (event.kind != Event::Kind::cut) continue;
    moves_.push_back(event.move(pieces));
    pieces = pieces.subspan(event.pieces);
  }
  between_.foresee(moves_);
}

void OutputPlay::take(Batch& batch) {
  std::span<const SentPiece> pieces = batch.pieces;
  std::span<const Event> events = batch.all();
  foresee(events, pieces);
  while (!events.empty()) {
    const Event& event = events.front();
    events = events.subspan(1);
    switch (event.kind) {
      case Event::Kind::cut:
        between_.cut(event.move(pieces));
        pieces = pieces.subspan(event.pieces);
        break;
      case Event::Kind::rapid:
        between_.rapid(event.sign);
        break;
      case Event::Kind::leave:
        between_.leave();
        break;
      case Event::Kind::tool:
        between_.leave();
        corrector_.set_tool(event.tool);
        foresee(events, pieces);
        break;
    }
  }
}

}  // namespace plumbline::compensate
