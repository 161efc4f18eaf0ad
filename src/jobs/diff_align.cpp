#include "jobs/diff_align.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::jobs {
namespace {

// All in mm and deg together, as distance() counts.
constexpr double kSlack = 0.1;         // what the shift may change along a move: friction turns at corners
constexpr double kLengthShare = 0.1;   // of a move's length, likewise
constexpr double kFirstShift = 2;      // before anything was matched, and of rapids
constexpr double kRapidShare = 0.01;   // of a rapid's length
constexpr double kTimeShare = 0.0015;  // of a move's time, that its pieces may differ from it
constexpr double kVanishes = 0.002;    // a move shorter than that may have no counterpart: its end rounds to its start
constexpr std::array kWaysBack{1e-5, 0.02, 0.1};  // how near two ends must be to go on from there, the best first
constexpr std::size_t kWindow = 32;               // moves of each program in which a way back is sought
constexpr int kProjections = 2;                   // Newton steps onto a curve
constexpr double kProbe = 1e-4;                   // fraction of a curve
constexpr double kShortest = 1e-9;                // mm and deg, that a projection divides by
constexpr double kLeastSeconds = 1e-6;            // of a move whose change of time is a share

bool numbers_differ(const DiffMove& a, const DiffMove& b) {
  return !a.number.empty() && !b.number.empty() && a.number != b.number;
}

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
  if (!(move->cuts() ? align_cut(*move) : align_rapid(*move))) find_way_back();
  return true;
}

bool Aligner::corresponds(const DiffMove& move, std::size_t ahead) {
  const DiffMove* const other = b_.peek(ahead);
  return other != nullptr && other->kind == move.kind && other->in_machine_coordinates == move.in_machine_coordinates &&
         !numbers_differ(move, *other);
}

// One to one, except that either side may have a tiny move more: a cycle that begins where the tool already stands has
// no way there, and some micrometres of way where the one side was moved. The nearest end decides.
bool Aligner::align_rapid(const DiffMove& move) {
  const AxisWords wanted = move.end + shift_;
  double nearest = kFirstShift + kRapidShare * move.length;
  std::optional<std::size_t> count;
  const auto consider = [&](std::size_t moves, const AxisWords& end) {
    const double off = distance(end, wanted);
    if (off > nearest || (count && off == nearest)) return;
    nearest = off;
    count = moves;
  };
  const bool is_tiny = move.length <= kSlack;
  const bool goes_on = corresponds(move, 0);
  const bool other_is_tiny = goes_on && b_.peek(0)->length <= kSlack;
  if (goes_on) consider(1, b_.peek(0)->end);
  if (other_is_tiny && !is_tiny && corresponds(move, 1)) consider(2, b_.peek(1)->end);
  if (is_tiny && !other_is_tiny && has_shift_) consider(0, at_b_);
  if (!count) return false;
  found_.assign(1, (*count == 0 ? at_b_ : b_.peek(*count - 1)->end) - move.end);
  take_match(move, *count);
  return true;
}

bool Aligner::align_cut(const DiffMove& move) {
  std::optional<std::size_t> count = count_by_number(move);
  if (!count) count = count_by_time(move);
  if (!count) count = count_by_distance(move);
  if (!count || !lies_along(move, *count)) return false;
  take_match(move, *count);
  return true;
}

double Aligner::slack(const DiffMove& move) const {
  return kSlack + kLengthShare * move.length + (has_shift_ ? 0 : kFirstShift);
}

// The piece that would be the `count`th of a move; null where the move must have ended.
const DiffMove* Aligner::piece(const DiffMove& move, std::size_t count) {
  const DiffMove* const next = b_.peek(count - 1);
  if (next == nullptr || !next->cuts()) return nullptr;
  if (count > 1 && !next->number.empty()) return nullptr;  // N stays on the first piece
  return count == 1 && numbers_differ(move, *next) ? nullptr : next;
}

// Numbered moves end where the next number stands.
std::optional<std::size_t> Aligner::count_by_number(const DiffMove& move) {
  const DiffMove* const next = a_.peek(1);
  if (move.number.empty() || (next != nullptr && next->cuts() && next->number.empty())) return std::nullopt;
  const DiffMove* const first = b_.peek(0);
  if (first == nullptr || first->number != move.number) return std::nullopt;
  std::size_t count = 0;
  while (piece(move, count + 1) != nullptr) ++count;
  const bool ends_there = count > 0 && distance(b_.peek(count - 1)->end, move.end + shift_) <= slack(move);
  return ends_there ? std::optional(count) : std::nullopt;
}

// Pieces take the time of the move together. Of several that come near, the one that ends where it should.
std::optional<std::size_t> Aligner::count_by_time(const DiffMove& move) {
  const double seconds = move.seconds.value_or(0);
  if (seconds <= 0) return std::nullopt;
  std::optional<std::size_t> best;
  double nearest = slack(move);
  double gone = 0;
  for (std::size_t k = 1; gone < (1 + kTimeShare) * seconds; ++k) {
    const DiffMove* const next = piece(move, k);
    if (next == nullptr || !next->seconds) break;
    gone += *next->seconds;
    const double off = distance(next->end, move.end + shift_);
    if (std::abs(gone / seconds - 1) > kTimeShare || off > nearest) continue;
    nearest = off;
    best = k;
  }
  return best;
}

// Pieces are as long as the move together; the one that ends nearest to where the move should is its last.
std::optional<std::size_t> Aligner::count_by_distance(const DiffMove& move) {
  const AxisWords wanted = move.end + shift_;
  std::optional<std::size_t> best;
  double nearest = slack(move);
  double gone = 0;
  for (std::size_t k = 1; gone <= move.length + slack(move); ++k) {
    const DiffMove* const next = piece(move, k);
    if (next == nullptr) break;
    gone += next->length;
    const double off = distance(next->end, wanted);
    if (std::abs(gone - move.length) > slack(move) || off >= nearest) continue;
    nearest = off;
    best = k;
  }
  const bool may_vanish = has_shift_ && move.length <= kVanishes && distance(at_b_, wanted) < nearest;
  return may_vanish ? std::optional<std::size_t>(0) : best;
}

// Works out the shifts along the move; false where B leaves it.
bool Aligner::lies_along(const DiffMove& move, std::size_t count) {
  const AxisWords from = has_shift_ ? shift_ : AxisWords{};
  const AxisWords to = (count == 0 ? at_b_ : b_.peek(count - 1)->end) - move.end;
  const double allowed = slack(move);
  found_.clear();
  const auto take = [&](const AxisWords& point, double fraction) {
    found_.push_back(shift_at(move, point, fraction, from, to));
    return distance(found_.back(), between(from, to, fraction)) <= allowed;
  };
  if (count == 1) {
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
  shift_ = found_.back();
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
      at_b_ = b->end;
      leave_out(i + 1, sum - i + 1);
      return true;
    }
  }
  return false;
}

void Aligner::leave_out(std::size_t count_a, std::size_t count_b) {
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
  bool is_known = move.seconds.has_value();
  for (std::size_t k = 0; k < count; ++k) {
    is_known = is_known && b_.peek(k)->seconds.has_value();
    after += b_.peek(k)->seconds.value_or(0);
  }
  const double before = move.seconds.value_or(0);
  summary_.seconds_a += before;
  summary_.seconds_b += after;
  if (is_known && before > kLeastSeconds) summary_.time_change.take(std::abs(after / before - 1), move.line);
}

DiffSummary Aligner::take() {
  for (std::size_t i = 0; i < kAxes && summary_.points > 0; ++i) {
    summary_.shift[i].rms = std::sqrt(squares_[i] / static_cast<double>(summary_.points));
  }
  return std::move(summary_);
}

}  // namespace plumbline::jobs
