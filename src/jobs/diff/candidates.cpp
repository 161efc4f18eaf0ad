#include "jobs/diff/candidates.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::jobs {
namespace {

// All in mm and deg together, as distance() counts.
constexpr double kSlack = 0.1;         // what the shift may change along a move: friction turns at corners
constexpr double kLengthShare = 0.1;   // of a move's length, likewise
constexpr double kShiftShare = 0.5;    // of the shift itself: near the end of the workspace it grows fast
constexpr double kMostOfShift = 5;     // likewise, of a move that its pieces take the time of,
constexpr double kMostOfLength = 0.4;  // and of its length: beside a singularity a move may be shifted by millimetres
constexpr double kFirstShift = 10;     // before anything was matched, and of rapids
constexpr double kRapidShare = 0.01;   // of a rapid's length
constexpr double kChangeShare = 1e-3;  // of a rapid's length, that the correction may change by on its way
constexpr double kOfTolerance = 1.5;   // times the tolerance of its time may the pieces of a move differ from it,
constexpr double kRounded = 1e-4;      // and so much of its length: what its ends are rounded by
constexpr double kStandstill = 1e-9;   // mm and deg
constexpr double kVanishes = 0.002;    // a move shorter than that may have no counterpart: its end rounds to its start

// What a candidate costs. Time tells where a move ends better than places do, unless the feed is another one.
constexpr double kShiftUnit = 0.03;  // of a change of shift, and of what it makes the way longer,
constexpr double kUnitShare = 0.3;   // and as much of what shifts are thereabouts: one may pass through nil
constexpr double kMostForWay = 1;
constexpr double kMostForTime = 8;
constexpr double kMuchForPlace = 20;   // where the time says that it is the end, the place says little more than this,
constexpr double kBeyondShare = 0.05;  // since one far end must not outweigh all ends before it
constexpr double kVanishing = 0.5;     // of a move without a counterpart, and as much again for each:
constexpr double kVanishingUnit = 0.0005;
constexpr double kUneven = 0.3;           // of a rapid more or less
constexpr std::size_t kMostRapids = 3;    // that a rapid may have become: there, over the hole, down to R
constexpr double kNoCode = 2;             // the next move of A states G1, that of B does not
constexpr double kNewCode = 0.5;          // the other way round
constexpr double kMarginOfCosts = 10;     // more than the best: never the right one
constexpr std::size_t kMostInTime = 256;  // that are looked into
constexpr std::size_t kMostOthers = 4;

double size(const AxisWords& shift) { return distance(shift, {}); }

// Of a rapid that a change of the shift alone may have made, on a way of this length.
double tiny(const Standing& standing, double way = 0) {
  return kSlack + (standing.has_shift ? kShiftShare * size(standing.shift) : 0) + kChangeShare * way;
}

double shift_unit(const Standing& standing) { return kShiftUnit + kUnitShare * standing.usual; }

double place_cost(double off, const Standing& standing, bool in_time) {
  const double cost = off / shift_unit(standing);
  return in_time && cost > kMuchForPlace ? kMuchForPlace + kBeyondShare * (cost - kMuchForPlace) : cost;
}

double time_cost(double gone, double seconds, double share) {
  return std::min(std::abs(gone / seconds - 1) / share, kMostForTime);
}

void sort_out(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::size_t in_time = 0;
  std::size_t others = 0;
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    if (candidate.cost > candidates.front().cost + kMarginOfCosts) break;
    const std::size_t before = candidate.in_time ? in_time++ : others++;
    if (before < (candidate.in_time ? kMostInTime : kMostOthers)) kept.push_back(candidate);
  }
  candidates = std::move(kept);
}

}  // namespace

bool numbers_differ(const DiffMove& a, const DiffMove& b) {
  return !a.number.empty() && !b.number.empty() && a.number != b.number;
}

double Candidates::slack(const DiffMove& move, const Standing& standing) {
  const double of_shift = standing.has_shift ? kShiftShare * size(standing.shift) : kFirstShift;
  return kSlack + kLengthShare * move.length + of_shift;
}

std::vector<Candidate> Candidates::of(std::size_t i, std::size_t j, const Standing& standing) {
  const DiffMove* const move = a_.peek(i);
  if (move == nullptr) return {};
  std::vector<Candidate> candidates = move->cuts() ? of_cut(*move, i, j, standing) : of_rapid(*move, j, standing);
  for (Candidate& candidate : candidates) candidate.cost += cost_of_codes(i + 1, j + candidate.count);
  sort_out(candidates);
  return candidates;
}

// Where a block begins, it says G1 in both programs or in none, while further pieces of a block do not.
double Candidates::cost_of_codes(std::size_t i, std::size_t j) {
  const DiffMove* const a = a_.peek(i);
  const DiffMove* const b = b_.peek(j);
  if (a == nullptr || b == nullptr || !a->cuts() || !b->cuts() || !a->states_code || !b->states_code) return 0;
  if (*a->states_code == *b->states_code) return 0;
  return *a->states_code ? kNoCode : kNewCode;
}

bool Candidates::corresponds(const DiffMove& move, std::size_t ahead) {
  const DiffMove* const other = b_.peek(ahead);
  return other != nullptr && other->kind == move.kind && other->in_machine_coordinates == move.in_machine_coordinates &&
         !numbers_differ(move, *other);
}

// One to one, except that either side may have tiny moves more: a cycle that begins where the tool already stands has
// no way there, and some micrometres of way where the one side was moved, over the hole and down to its level R.
std::vector<Candidate> Candidates::of_rapid(const DiffMove& move, std::size_t j, const Standing& standing) {
  const AxisWords wanted = move.end + standing.shift;
  std::vector<Candidate> candidates;
  const auto consider = [&](std::size_t moves, const AxisWords& end) {
    const double off = distance(end, wanted);
    const double uneven = kUneven * static_cast<double>(moves > 0 ? moves - 1 : 1);
    if (off <= kFirstShift + kRapidShare * move.length)
      candidates.push_back({moves, off / shift_unit(standing) + uneven});
  };
  std::size_t far = 0;
  for (std::size_t moves = 1; moves <= kMostRapids && corresponds(move, j + moves - 1); ++moves) {
    const DiffMove& last = *b_.peek(j + moves - 1);
    if (last.length > tiny(standing, move.length) && ++far > 1) break;
    consider(moves, last.end);
  }
  if (move.length <= tiny(standing) && standing.has_shift) consider(0, standing.b);
  return candidates;
}

// The piece that would be the `count`th of a move; null where the move must have ended.
const DiffMove* Candidates::piece(const DiffMove& move, std::size_t j, std::size_t count) {
  const DiffMove* const next = b_.peek(j + count - 1);
  if (next == nullptr || !next->cuts()) return nullptr;
  if (count > 1 && next->begins_numbered) return nullptr;  // N stays on the first piece, or before it
  return count == 1 && numbers_differ(move, *next) ? nullptr : next;
}

// What rounding makes of the length of a short move, it makes of its time.
double Candidates::time_share(const DiffMove& move) const {
  return kOfTolerance * time_tolerance_ + kRounded / std::max(move.length, kRounded);
}

// Numbered moves end where the next number stands.
std::optional<std::size_t> Candidates::count_by_number(const DiffMove& move, std::size_t i, std::size_t j,
                                                       const Standing& standing) {
  const DiffMove* const next = a_.peek(i + 1);
  // Not where A goes on: to a block without a number, or to the next point of the spline that this block ends.
  const bool goes_on = next != nullptr && next->cuts() && (next->number.empty() || !next->begins_numbered);
  if (move.number.empty() || goes_on) return std::nullopt;
  const DiffMove* const first = b_.peek(j);
  if (first == nullptr || first->number != move.number) return std::nullopt;
  std::size_t count = 0;
  while (piece(move, j, count + 1) != nullptr) ++count;
  if (next != nullptr && next->cuts()) {  // a label that is met again is written the first time alone
    const DiffMove* const stop = b_.peek(j + count);
    const bool is_next = stop != nullptr && stop->begins_numbered;
    if (!is_next || (!stop->number.empty() && stop->number != next->number)) return std::nullopt;
  }
  const bool ends_there =
      count > 0 && distance(b_.peek(j + count - 1)->end, move.end + standing.shift) <= slack(move, standing);
  return ends_there ? std::optional(count) : std::nullopt;
}

// A hole of a cycle that begins where the one before it ended has no way there in A, but a tiny one in B, which the
// correction of another hole moves elsewhere.
std::size_t Candidates::tiny_rapids(std::size_t j, const Standing& standing) {
  std::size_t count = 0;
  for (const DiffMove* next = b_.peek(j); next != nullptr && !next->cuts() && next->length <= tiny(standing);
       next = b_.peek(j + count)) {
    if (next->in_machine_coordinates || ++count == kMostRapids) break;
  }
  return count;
}

// As it is, or after tiny rapids that A does not have.
std::vector<Candidate> Candidates::of_cut(const DiffMove& move, std::size_t i, std::size_t j,
                                          const Standing& standing) {
  const std::size_t before = tiny_rapids(j, standing);
  std::vector<Candidate> candidates = pieces_of_cut(move, i, j + before, standing);
  for (Candidate& candidate : candidates) {
    if (candidate.count > 0) candidate.count += before;
  }
  return candidates;
}

// Pieces take the time of the move together, or are as long as it, and end where it does.
std::vector<Candidate> Candidates::pieces_of_cut(const DiffMove& move, std::size_t i, std::size_t j,
                                                 const Standing& standing) {
  if (const auto count = count_by_number(move, i, j, standing)) return {{*count, 0}};
  const AxisWords wanted = move.end + standing.shift;
  const double allowed = slack(move, standing);
  const double seconds = move.effort.value_or(0);
  const double share = time_share(move);
  std::vector<Candidate> candidates;
  if (standing.has_shift && move.length <= kVanishes) {
    const double off = distance(standing.b, wanted);
    candidates.push_back({0, kVanishing + move.length / kVanishingUnit + off / shift_unit(standing)});
  }
  double way = 0;
  double gone = 0;
  bool has_time = seconds > 0;
  bool has_code = false;  // of the further pieces: some state one, some do not
  bool has_none = false;
  for (std::size_t k = 1;; ++k) {
    const DiffMove* const next = piece(move, j, k);
    if (next == nullptr) break;
    way += next->length;
    has_time = has_time && next->effort.has_value();
    gone += next->effort.value_or(0);
    if (k > 1) (next->states_code.value_or(false) ? has_code : has_none) = true;
    const bool in_time = has_time && std::abs(gone / seconds - 1) <= share;
    const bool on_way = std::abs(way - move.length) <= allowed;
    const bool goes_on = way <= move.length + allowed || (has_time && gone < (1 + share) * seconds);
    if (!goes_on) break;
    if (!in_time && !on_way) continue;
    const double off = distance(next->end, wanted);
    const double more = kMostOfLength * move.length + (standing.has_shift ? kMostOfShift * size(standing.shift) : 0);
    if (off > allowed + (in_time ? more : 0)) continue;
    const bool both_vanish = way <= kStandstill && move.length <= kVanishes;
    const double for_time = has_time && !both_vanish ? time_cost(gone, seconds, share) : 0;
    const double for_way = std::min(std::abs(way - move.length) / shift_unit(standing), kMostForWay);
    candidates.push_back(
        {k, place_cost(off, standing, in_time) + for_way + for_time + (has_code && has_none ? kNoCode : 0), in_time});
  }
  return candidates;
}

}  // namespace plumbline::jobs
