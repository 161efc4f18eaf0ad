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

void OutputPlay::cut(const MovePath& path, std::optional<double> seconds, const AxisWords& begin,
                     std::span<const SentPiece> pieces, bool as_it_stands) {
  Event& event = add(Event::Kind::cut);
  event.path = path;
  event.seconds = seconds;
  event.begin = begin;
  event.pieces = pieces.size();
  event.as_it_stands = as_it_stands;
  batch_.pieces.insert(batch_.pieces.end(), pieces.begin(), pieces.end());
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

void OutputPlay::take(Batch& batch) {
  std::span<const SentPiece> pieces = batch.pieces;
  for (const Event& event : std::span(batch.events).first(batch.count)) {
    switch (event.kind) {
      case Event::Kind::cut:
        between_.cut(event.path, event.seconds, event.begin, pieces.first(event.pieces), event.as_it_stands);
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
        break;
    }
  }
}

}  // namespace plumbline::compensate
