#include "measure/minimum_zone.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "base/check.hpp"

namespace plumbline::measure {
namespace {

constexpr int kUnknowns = 4;  // x, y, outer, inner
constexpr int kMostSteps = 10000;
constexpr int kPlainSteps = 200;      // afterwards the first violated side enters, which cannot go in circles for ever
constexpr double kTolerance = 1e-14;  // of the largest reading

using Vector4 = Eigen::Matrix<double, kUnknowns, 1>;
using Matrix4 = Eigen::Matrix<double, kUnknowns, kUnknowns>;

// Side of the ring that a reading touches: x cos + y sin + outer >= r, or -(x cos + y sin) - inner >= -r.
struct Side {
  Eigen::Index reading = 0;
  bool is_outer = true;
};

class Program {
 public:
  Program(const Eigen::VectorXd& angle, const Eigen::VectorXd& reading)
      : cos_(angle.array().cos()), sin_(angle.array().sin()), reading_(reading) {
    scale_ = std::max(reading.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
    start();
  }

  Zone solve() {
    for (int step = 0; step < kMostSteps; ++step) {
      const Matrix4 rows = basis_rows();
      const Eigen::PartialPivLU<Matrix4> lu(rows);
      Vector4 sides;
      for (int k = 0; k < kUnknowns; ++k) sides[k] = value(basis_[static_cast<std::size_t>(k)]);
      solution_ = lu.solve(sides);
      const Side entering = most_violated(step >= kPlainSteps);
      if (entering.reading < 0) break;
      exchange(rows.transpose(), entering);
    }
    // of the readings themselves: what the tolerance left outside is inside
    const Eigen::ArrayXd left = reading_.array() - solution_[0] * cos_ - solution_[1] * sin_;
    return {solution_[0], solution_[1], left.minCoeff(), left.maxCoeff()};
  }

 private:
  Vector4 row(const Side& side) const {
    const double c = cos_[side.reading];
    const double s = sin_[side.reading];
    return side.is_outer ? Vector4(c, s, 1, 0) : Vector4(-c, -s, 0, -1);
  }
  double value(const Side& side) const { return side.is_outer ? reading_[side.reading] : -reading_[side.reading]; }

  // Both sides of one reading and the outer sides of two others: their multipliers are 1, 1, 0, 0.
  void start() {
    const auto other = [&](Eigen::Index a, Eigen::Index b) {
      Eigen::Index best = a;
      double most = 0;
      for (Eigen::Index i = 0; i < cos_.size(); ++i) {
        const double area =
            std::abs((cos_[b] - cos_[a]) * (sin_[i] - sin_[a]) - (cos_[i] - cos_[a]) * (sin_[b] - sin_[a]));
        const double far = a == b ? std::hypot(cos_[i] - cos_[a], sin_[i] - sin_[a]) : area;
        if (far > most) {
          most = far;
          best = i;
        }
      }
      PLUMBLINE_CHECK(most > 1e-9);
      return best;
    };
    const Eigen::Index second = other(0, 0);
    const Eigen::Index third = other(0, second);
    basis_ = {Side{0, true}, Side{0, false}, Side{second, true}, Side{third, true}};
  }

  Matrix4 basis_rows() const {
    Matrix4 rows;
    for (int k = 0; k < kUnknowns; ++k) rows.row(k) = row(basis_[static_cast<std::size_t>(k)]).transpose();
    return rows;
  }

  Side most_violated(bool first) const {
    Side worst{-1, true};
    double most = kTolerance * scale_ * 10;
    for (Eigen::Index i = 0; i < reading_.size(); ++i) {
      const double left = reading_[i] - solution_[0] * cos_[i] - solution_[1] * sin_[i];
      for (const bool is_outer : {true, false}) {
        const double beyond = is_outer ? left - solution_[2] : solution_[3] - left;
        if (beyond <= most) continue;
        most = beyond;
        worst = {i, is_outer};
        if (first) return worst;
      }
    }
    return worst;
  }

  // The entering side is a sum of those of the basis; the one whose multiplier falls to zero first leaves.
  void exchange(const Matrix4& columns, const Side& entering) {
    const Eigen::PartialPivLU<Matrix4> lu(columns);
    const Vector4 multipliers = lu.solve(Vector4(0, 0, 1, -1));
    const Vector4 parts = lu.solve(row(entering));
    std::size_t leaving = kUnknowns;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kUnknowns; ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      if (parts[at] <= 1e-12) continue;
      const double ratio = std::max(multipliers[at], 0.0) / parts[at];
      if (ratio < least) {
        least = ratio;
        leaving = k;
      }
    }
    PLUMBLINE_CHECK(leaving < kUnknowns);  // else no ring would hold the profile
    basis_[leaving] = entering;
  }

  Eigen::ArrayXd cos_, sin_;
  const Eigen::VectorXd& reading_;
  double scale_ = 1;
  std::array<Side, kUnknowns> basis_{};
  Vector4 solution_ = Vector4::Zero();
};

}  // namespace

Zone minimum_zone(const Eigen::VectorXd& angle, const Eigen::VectorXd& reading) {
  PLUMBLINE_CHECK(angle.size() == reading.size() && angle.size() >= 3);
  return Program(angle, reading).solve();
}

}  // namespace plumbline::measure
