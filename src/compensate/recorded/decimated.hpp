// A long row of points made short without losing its extremes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace plumbline::compensate {

/// Keeps of each of a few thousand stretches of a row of points the first, and those at which one of `kFigures` figures
/// is least or largest. A short row is kept whole. Memory does not grow with the row. A figure that is not a number is
/// no extreme.
template <class Point, std::size_t kFigures>
class Decimated {
 public:
  using Figures = std::array<double, kFigures>;

  /// Up to twice `stretches`; at least as many of a row that is longer than that. Of a row no longer than `whole`, or a
  /// little more, all points are kept. With a `play` the points kept come that near to the extremes of a stretch, as a
  /// share of its range: fewer points have to be made.
  explicit Decimated(std::size_t stretches, std::size_t whole = 1, double play = 0)
      : stretches_(std::max<std::size_t>(1, stretches)), whole_(std::bit_ceil(whole)), play_(play) {}

  /// `make` makes the point, where it is kept for now.
  template <class Make>
  void add(const Figures& figures, Make&& make) {
    add(std::span(&figures, 1), [&](std::size_t) { return make(); });
  }
  /// The same of points in a row, `make(i)` of the i-th of them: the more there are the fewer have to be made.
  template <class Make>
  void add(std::span<const Figures> row, Make&& make) {
    for (std::size_t begin = 0; begin < row.size();) {
      if (count_ > 0 && count_ % width_ == 0) begin_stretch();
      const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(width_ - count_ % width_, row.size() - begin));
      take(row.subspan(begin, part), [&](std::size_t i) { return make(begin + i); });
      begin += part;
    }
  }

  /// Of the whole row.
  std::uint64_t count() const { return count_; }
  void clear() { *this = Decimated(stretches_, whole_, play_); }
  /// The points that are kept, in their order.
  std::vector<Point> take() {
    thin(stretch_begin_);
    std::vector<Point> points;
    points.reserve(kept_.size());
    for (Kept& kept : kept_) points.push_back(std::move(kept.point));
    clear();
    return points;
  }

 private:
  static constexpr std::size_t kLoose = 4 * kFigures;  // of one stretch, before those that lost are thrown out

  struct Kept {
    std::uint64_t number = 0;
    Figures figures{};
    Point point;
  };
  struct Extremes {
    Figures least = filled(std::numeric_limits<double>::infinity());
    Figures largest = filled(-std::numeric_limits<double>::infinity());
    Figures beyond = filled(0);  // by so much more a new one has to be

    static Figures filled(double value) {
      Figures figures;
      figures.fill(value);
      return figures;
    }
    /// Marks those of a row that are new extremes of it all.
    void take(std::span<const Figures> row, double play, std::vector<char>& marks) {
      for (std::size_t f = 0; f < kFigures; ++f) {
        std::size_t low = row.size();
        std::size_t high = row.size();
        for (std::size_t i = 0; i < row.size(); ++i) {
          const double value = row[i][f];
          if (value < least[f] - beyond[f]) {
            least[f] = value;
            low = i;
          }
          if (value > largest[f] + beyond[f]) {
            largest[f] = value;
            high = i;
          }
        }
        if (low < row.size()) marks[low] = 1;
        if (high < row.size()) marks[high] = 1;
        if (low < row.size() || high < row.size()) beyond[f] = play * (largest[f] - least[f]);
      }
    }
  };

  // Points of one stretch.
  template <class Make>
  void take(std::span<const Figures> row, const Make& make) {
    marks_.assign(row.size(), 0);
    if (count_ % width_ == 0) marks_[0] = 1;
    extremes_.take(row, play_, marks_);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (marks_[i] != 0) kept_.push_back({count_ + i, row[i], make(i)});
    }
    count_ += row.size();
    if (kept_.size() - stretch_begin_ > kLoose) thin(stretch_begin_);
  }

  void begin_stretch() {
    thin(stretch_begin_);
    if (count_ >= whole_ && count_ / width_ >= 2 * stretches_) {
      while (count_ / width_ >= 2 * stretches_) width_ *= 2;  // two become one; it stays a part of count_
      thin(0);
    }
    stretch_begin_ = kept_.size();
    extremes_ = {};
  }

  // Throws out of each stretch from there on what is neither its first nor an extreme.
  void thin(std::size_t from) {
    std::size_t filled = from;
    for (std::size_t begin = from; begin < kept_.size();) {
      std::size_t next = begin;
      while (next < kept_.size() && kept_[next].number / width_ == kept_[begin].number / width_) ++next;
      filled = thin_stretch(begin, next - begin, filled);
      begin = next;
    }
    kept_.resize(filled);
  }

  // Moves what stays of one to where `filled` ends; returns where that ends then.
  std::size_t thin_stretch(std::size_t begin, std::size_t count, std::size_t filled) {
    std::vector<char> stays(count, 0);
    stays[0] = 1;
    for (std::size_t f = 0; f < kFigures; ++f) {
      std::size_t least = count;
      std::size_t largest = count;
      for (std::size_t i = 0; i < count; ++i) {
        const double value = kept_[begin + i].figures[f];
        if (std::isnan(value)) continue;
        if (least == count || value < kept_[begin + least].figures[f]) least = i;
        if (largest == count || value > kept_[begin + largest].figures[f]) largest = i;
      }
      if (least == count) continue;
      stays[least] = stays[largest] = 1;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (stays[i] == 0) continue;
      if (filled != begin + i) kept_[filled] = std::move(kept_[begin + i]);
      ++filled;
    }
    return filled;
  }

  std::size_t stretches_;
  std::size_t whole_;  // a power of two
  double play_;
  std::uint64_t width_ = 1;  // points of a stretch
  std::uint64_t count_ = 0;
  std::vector<Kept> kept_;
  std::size_t stretch_begin_ = 0;  // of the last one, in what is kept
  Extremes extremes_;              // of that
  std::vector<char> marks_;
};

}  // namespace plumbline::compensate
