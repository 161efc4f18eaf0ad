#include "compensate/recorded/decimated.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <vector>

#include <catch2/catch.hpp>

using namespace plumbline;

namespace {

using Row = compensate::Decimated<std::size_t, 2>;

std::vector<std::size_t> kept_of(Row& row, const std::vector<Row::Figures>& figures) {
  for (std::size_t i = 0; i < figures.size(); ++i) row.add(figures[i], [&] { return i; });
  return row.take();
}

}  // namespace

TEST_CASE("a short row is kept whole") {
  Row row(8);
  const std::vector<std::size_t> kept = kept_of(row, {{1, 1}, {1, 1}, {1, 1}, {0, 2}});
  CHECK(kept == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(row.count() == 0);  // taken
}

TEST_CASE("a row may be kept whole up to a length") {
  for (const std::size_t count : {16U, 17U, 64U}) {
    Row row(2, 13);
    const std::vector<std::size_t> kept = kept_of(row, std::vector<Row::Figures>(count));
    CHECK((kept.size() == count) == (count == 16));
    CHECK(kept.front() == 0);
    CHECK(std::is_sorted(kept.begin(), kept.end()));
  }
}

TEST_CASE("points in a row are kept like points one by one") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Row::Figures> figures(3000);
  for (Row::Figures& of : figures) of = {normal(random), std::round(normal(random))};
  figures[5][0] = figures[1000][1] = std::numeric_limits<double>::quiet_NaN();
  Row one_by_one(8);
  const std::vector<std::size_t> wanted = kept_of(one_by_one, figures);
  for (const std::size_t length : {2U, 7U, 256U, 3000U}) {
    Row row(8);
    for (std::size_t begin = 0; begin < figures.size(); begin += length) {
      const auto part = std::span(figures).subspan(begin, std::min(length, figures.size() - begin));
      row.add(part, [&](std::size_t i) { return begin + i; });
    }
    CHECK(row.count() == figures.size());
    CHECK(row.take() == wanted);
  }
}

TEST_CASE("of a long row each stretch keeps its first point and all its extremes") {
  constexpr std::size_t kCount = 5000;
  constexpr std::size_t kStretches = 8;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Row::Figures> figures(kCount);
    double walk = 0;
    for (Row::Figures& of : figures) of = {walk += normal(random), normal(random)};
    Row row(kStretches);
    const std::vector<std::size_t> kept = kept_of(row, figures);
    const std::set<std::size_t> has(kept.begin(), kept.end());
    REQUIRE(std::is_sorted(kept.begin(), kept.end()));
    REQUIRE(has.size() == kept.size());
    CHECK(kept.size() <= 2 * kStretches * 5);

    // 5,000 points in at most 16 stretches of a power of two each: 512.
    for (std::size_t begin = 0; begin < kCount; begin += 512) {
      INFO("seed " << seed << ", from " << begin);
      CHECK(has.count(begin) == 1);
      const auto first = figures.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto end = figures.begin() + static_cast<std::ptrdiff_t>(std::min(begin + 512, kCount));
      for (const std::size_t f : {0U, 1U}) {
        const auto [least, largest] =
            std::minmax_element(first, end, [f](const auto& a, const auto& b) { return a[f] < b[f]; });
        CHECK(has.count(static_cast<std::size_t>(least - figures.begin())) == 1);
        CHECK(has.count(static_cast<std::size_t>(largest - figures.begin())) == 1);
      }
    }
  }
}

TEST_CASE("what is no number is no extreme") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Row::Figures> figures(1000, {none, 0});
  figures[777] = {3, 0};
  Row row(2);
  const std::vector<std::size_t> kept = kept_of(row, figures);
  CHECK(std::count(kept.begin(), kept.end(), 777) == 1);
  CHECK(kept.size() <= 2 * 4 * 2);
}

TEST_CASE("points are made where they are kept alone") {
  Row row(4);
  std::size_t made = 0;
  for (std::size_t i = 0; i < 100000; ++i) {
    row.add({std::sin(static_cast<double>(i)), 0}, [&] {
      ++made;
      return i;
    });
  }
  CHECK(made < 1000);
}

TEST_CASE("with a play of a sixteenth few points are made of a row that rises, its end missed by a sixteenth at most") {
  constexpr double kPlay = 1.0 / 16;
  Row row(1, 1, kPlay);
  std::vector<std::size_t> made;
  constexpr std::size_t kCount = 4096;
  for (std::size_t i = 0; i < kCount; ++i) {
    // Up, and far out for one point.
    const double figure = i == 3001 ? 9000 : static_cast<double>(i);
    row.add({figure, -figure}, [&] {
      made.push_back(i);
      return i;
    });
  }
  CHECK(made.size() < kCount / 8);
  const std::vector<std::size_t> kept = row.take();
  CHECK(std::count(kept.begin(), kept.end(), 3001) == 1);
  Row rising(1, 1, kPlay);
  for (std::size_t i = 0; i < kCount; ++i) rising.add({static_cast<double>(i), 0}, [&] { return i; });
  const std::vector<std::size_t> of_rising = rising.take();
  CHECK(of_rising.back() >= kCount - 1 - static_cast<std::size_t>(kPlay * kCount));
  Row exact(1);
  for (std::size_t i = 0; i < kCount; ++i) exact.add({static_cast<double>(i), 0}, [&] { return i; });
  CHECK(exact.take().back() == kCount - 1);
}
