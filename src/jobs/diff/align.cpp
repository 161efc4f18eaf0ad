#include "jobs/diff/align.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::jobs {
namespace {

// All in mm and deg together, as distance() counts.
constexpr std::size_t kLookAhead = 6;  // moves of A that decide between candidates
constexpr double kClear = 1;     // a candidate that costs no more, and others more than twice that more, is the one
constexpr double kNoWayOn = 30;  // a move without a candidate
constexpr std::array kWaysBack{1e-5, 0.02, 0.1};  // how near two ends must be to go on from there, the best first
constexpr std::size_t kWindow = 32;               // moves of each program in which a way back is sought
constexpr double kFades = 0.5;                    // what is usual, with each move
constexpr double kLateShare = 0.5;                // share of a change of shift that may come late or early
constexpr int kProjections = 2;                   // Newton steps onto a curve
constexpr double kProbe = 1e-4;                   // fraction of a curve
constexpr double kShortest = 1e-9;                // mm and deg, that a projection divides by
constexpr double kNoWay = 1e-9;                   // mm and deg: of a move whose end rounds to its start
constexpr double kTurnsLittle = 0.1;              // deg for a mm and deg, as a correction may
constexpr double kLeastSeconds = 1e-6;            // of a move whose change of time is a share

double dot(const AxisWords& a, const AxisWords& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kAxes; ++i) sum += a.values[i] * b.values[i];
  return sum;
}

AxisWords between(const AxisWords& from, const AxisWords& to, double fraction) {
  AxisWords words;
  for (const Axis axis : kAllAxes) words[axis] = from[axis] + fraction * (to[axis] - from[axis]);
  return words;
}

// What lies between a point and the nearest one of a move that was shifted evenly; the fraction is a first guess.
AxisWords shift_at(const DiffMove& move, const AxisWords& point, double fraction, const AxisWords& from,
                   const AxisWords& to) {
  for (int i = 0; i < kProjections; ++i) {
    const double probe = fraction > 0.5 ? -kProbe : kProbe;
    const AxisWords here = move.at(fraction);
    const AxisWords step = move.at(fraction + probe) - here;
    const double squared = dot(step, step);
    if (squared < kShortest * kShortest) break;
    const AxisWords off = point - here - between(from, to, fraction);
    fraction = std::clamp(fraction + probe * dot(off, step) / squared, 0.0, 1.0);
  }
  return point - move.at(fraction);
}

}  // namespace

bool Aligner::next() {
  const DiffMove* const move = a_.peek(0);
  if (move == nullptr) {
    const bool more = b_.peek(0) != nullptr;
    if (more) leave_out(0, 1);
    return more;
  }
  if (!align(*move)) find_way_back();
  return true;
}

double Aligner::usual_after(const AxisWords& shift) const {
  return std::max(distance(shift, {}), kFades * usual_shift_);
}

// Where both stand, once `i` moves of A and `j` of B were matched from here on.
Standing Aligner::standing(std::size_t i, std::size_t j) {
  Standing there{at_b_, shift_, has_shift_ || i > 0, usual_shift_};
  if (j > 0) there.b = b_.peek(j - 1)->end;
  if (i > 0) {
    there.shift = there.b - a_.peek(i - 1)->end;
    there.usual = usual_after(there.shift);
  }
  return there;
}

// What the next moves cost at least.
double Aligner::cost_ahead(std::size_t i, std::size_t j, std::size_t depth) {
  if (a_.peek(i) == nullptr) return b_.peek(j) == nullptr ? 0 : kNoWayOn;
  if (depth == 0) return 0;
  if (const auto known = ahead_.find({i, j}); known != ahead_.end()) return known->second;
  double least = kNoWayOn * static_cast<double>(depth);
  for (const Candidate& candidate : candidates_.of(i, j, standing(i, j))) {
    if (candidate.cost >= least) break;
    least = std::min(least, candidate.cost + cost_ahead(i + 1, j + candidate.count, depth - 1));
  }
  ahead_.emplace(std::pair(i, j), least);
  return least;
}

// Where several ends of B may be that of the move, the one from which the moves after it go on best.
bool Aligner::align(const DiffMove& move) {
  std::vector<Candidate> candidates = candidates_.of(0, 0, standing(0, 0));
  const bool is_clear = !candidates.empty() && candidates.front().cost <= kClear &&
                        (candidates.size() == 1 || candidates[1].cost > candidates[0].cost + 2 * kClear);
  if (!is_clear && candidates.size() > 1) {
    ahead_.clear();
    for (Candidate& candidate : candidates) candidate.cost += cost_ahead(1, candidate.count, kLookAhead);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  }
  for (const Candidate& candidate : candidates) {
    if (!lies_along(move, candidate.count)) continue;
    take_match(move, candidate.count);
    return true;
  }
  return false;
}

// Works out the shifts along the move; false where B leaves it.
bool Aligner::lies_along(const DiffMove& move, std::size_t count) {
  const AxisWords from = has_shift_ ? shift_ : AxisWords{};
  const AxisWords to = (count == 0 ? at_b_ : b_.peek(count - 1)->end) - move.end;
  const double allowed = Candidates::slack(move, standing(0, 0)) + kLateShare * distance(from, to);
  found_.clear();
  const auto take = [&](const AxisWords& point, double fraction) {
    found_.push_back(shift_at(move, point, fraction, from, to));
    return distance(found_.back(), between(from, to, fraction)) <= allowed;
  };
  if (count == 1 && move.cuts()) {
    const DiffMove& other = *b_.peek(0);
    const bool is_straight = move.kind != nc::MotionKind::arc && other.kind != nc::MotionKind::arc;
    for (const double fraction : {0.25, 0.5, 0.75}) {
      if (!is_straight && !take(other.at(fraction), fraction)) return false;
    }
  }
  double total = 0;
  for (std::size_t k = 0; k < count; ++k) total += b_.peek(k)->length;
  double gone = 0;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    gone += b_.peek(k)->length;
    if (!take(b_.peek(k)->end, total > 0 ? gone / total : 1)) return false;
  }
  found_.push_back(to);
  return true;
}

void Aligner::take_match(const DiffMove& move, std::size_t count) {
  const std::size_t line_b = count > 0 ? b_.peek(0)->line : 0;
  for (const AxisWords& shift : found_) note_shift(shift, move.line, line_b);
  note_time(move, count);
  if (record_ != nullptr) record(move, count);
  shift_ = found_.back();
  usual_shift_ = usual_after(shift_);
  has_shift_ = true;
  if (count > 0) at_b_ = b_.peek(count - 1)->end;
  ++summary_.matched;
  a_.drop(1);
  b_.drop(count);
}

// The nearest pair of moves further on that end in the same place; what lies before them and they themselves are out of
// line. Nothing within the window: one move of each.
void Aligner::find_way_back() {
  for (const double tolerance : kWaysBack) {
    if (find_way_back(tolerance)) return;
  }
  if (const DiffMove* const b = b_.peek(0)) at_b_ = b->end;
  leave_out(1, b_.peek(0) != nullptr ? 1 : 0);
}

bool Aligner::find_way_back(double tolerance) {
  for (std::size_t sum = 0; sum + 1 < 2 * kWindow; ++sum) {
    for (std::size_t i = sum < kWindow ? 0 : sum - kWindow + 1; i <= std::min(sum, kWindow - 1); ++i) {
      const DiffMove* const a = a_.peek(i);
      const DiffMove* const b = b_.peek(sum - i);
      if (a == nullptr || b == nullptr || a->cuts() != b->cuts() || numbers_differ(*a, *b)) continue;
      const double off = std::min(distance(b->end, a->end + shift_), distance(b->end, a->end));
      if (off > tolerance) continue;
      shift_ = b->end - a->end;
      usual_shift_ = usual_after(shift_);
      at_b_ = b->end;
      leave_out(i + 1, sum - i + 1);
      return true;
    }
  }
  return false;
}

// The ends of B's moves are the last of the shifts that were found.
void Aligner::record(const DiffMove& move, std::size_t count) {
  if (move.in_machine_coordinates) return record_->leave();
  for (std::size_t k = 0; k < count; ++k) {
    const DiffMove& piece = *b_.peek(k);
    compensate::RecordedPoint point;
    point.kind = compensate::way_kind(move.kind);
    point.line = move.line;
    point.commanded = piece.end;
    point.asked.pose = piece.end - found_[found_.size() - count + k];
    if (move.cuts() && piece.seconds) {
      recorded_s_ += *piece.seconds;
      point.piece_s = piece.seconds;
      if (*piece.seconds > 0) point.mm_s = piece.curve.linear_mm() / *piece.seconds;
    }
    point.time_s = recorded_s_;
    record_->add(std::move(point), {move.text, piece.text});
  }
}

void Aligner::leave_out(std::size_t count_a, std::size_t count_b) {
  if (record_ != nullptr) record_->leave();
  OutOfLine place;
  if (count_a > 0) {
    place.first_line_a = a_.peek(0)->line;
    place.last_line_a = a_.peek(count_a - 1)->line;
  }
  if (count_b > 0) {
    place.first_line_b = b_.peek(0)->line;
    place.last_line_b = b_.peek(count_b - 1)->line;
  }
  for (std::size_t i = 0; i < count_a; ++i) summary_.seconds_a += a_.peek(i)->seconds.value_or(0);
  for (std::size_t i = 0; i < count_b; ++i) summary_.seconds_b += b_.peek(i)->seconds.value_or(0);
  summary_.out_of_line_a += count_a;
  summary_.out_of_line_b += count_b;
  if (summary_.out_of_line.size() < DiffSummary::kMostListed) summary_.out_of_line.push_back(place);
  a_.drop(count_a);
  b_.drop(count_b);
}

void Aligner::note_shift(const AxisWords& shift, std::size_t line_a, std::size_t line_b) {
  ++summary_.points;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const double size = std::abs(shift.values[i]);
    squares_[i] += size * size;
    AxisShift& axis = summary_.shift[i];
    if (size <= axis.largest) continue;
    axis = {size, line_a, line_b, 0};
  }
}

void Aligner::note_time(const DiffMove& move, std::size_t count) {
  double after = 0;
  double way = 0;
  double turned = 0;  // deg, where nobody says whether F counts that
  bool is_known = move.seconds.has_value();
  for (std::size_t k = 0; k < count; ++k) {
    if (move.cuts() && !b_.peek(k)->cuts()) continue;  // a tiny way to where it begins
    const DiffMove& piece = *b_.peek(k);
    // What turns in B alone is the correction.
    const bool guessed = !piece.seconds && move.seconds;
    const std::optional<double> seconds = guessed ? piece.effort : piece.seconds;
    is_known = is_known && seconds.has_value();
    after += seconds.value_or(0);
    way += piece.length;
    if (guessed) turned += piece.length - piece.curve.linear_mm();
  }
  is_known = is_known && turned <= kTurnsLittle * way;
  if (!is_known) {
    if (move.cuts()) summary_.untimed.add(move.line);
    return;
  }
  const double before = *move.seconds;
  summary_.seconds_a += before;
  summary_.seconds_b += after;
  if (way > kNoWay && before > kLeastSeconds) summary_.time_change.take(std::abs(after / before - 1), {move.line});
}

DiffSummary Aligner::take() {
  for (std::size_t i = 0; i < kAxes && summary_.points > 0; ++i) {
    summary_.shift[i].rms = std::sqrt(squares_[i] / static_cast<double>(summary_.points));
  }
  return std::move(summary_);
}

}  // namespace plumbline::jobs
