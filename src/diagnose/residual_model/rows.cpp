#include "diagnose/residual_model/rows.hpp"

#include <algorithm>
#include <cmath>

#include "physics/effects/generic.hpp"
#include "physics/effects/residual.hpp"

namespace plumbline::diagnose {
namespace {

using physics::Generic;
using physics::Residual;

// The rows of one component. Numbers begin at `first_` of the flat parameters.
class Rows {
 public:
  Rows(const Component& component, physics::ForceModel& forces) : of_(component), forces_(forces) {}

  std::vector<RowNumber> add() {
    if (of_.shape.is_smooth()) {
      for (std::size_t k = 0; k < of_.parts.size(); ++k) smooth(k);
    } else if (of_.shape.is_wave()) {
      for (std::size_t k = 0; k < of_.parts.size(); ++k) wave(k);
    } else {
      product();
    }
    return std::move(numbers_);
  }

 private:
  void begin(std::string_view effect) {
    effect_ = effect;
    first_ = forces_.add(effect);
    row_ = static_cast<int>(forces_.instances_of(physics::effect_index(effect)).size()) - 1;
  }
  double& parameter(int offset) { return forces_.parameters[static_cast<std::size_t>(first_ + offset)]; }

  template <std::size_t N>
  void set(int offset, const std::array<int, N>& powers) {
    for (std::size_t k = 0; k < N; ++k) parameter(offset + static_cast<int>(k)) = powers[k];
  }

  // The number that stands at an offset of the row that was begun.
  void number(int offset, const Eigen::RowVectorXd& by_weights) {
    int before = 0;
    for (const physics::ParameterSpec& spec : physics::effect_infos()[physics::effect_index(effect_)].parameters) {
      if (offset < before + spec.size()) {
        numbers_.push_back({effect_, spec.key, spec.size() == 1 ? -1 : offset - before, row_, by_weights});
        return;
      }
      before += spec.size();
    }
  }
  Eigen::RowVectorXd unit(Eigen::Index weight) const { return Eigen::RowVectorXd::Unit(of_.weights.size(), weight); }

  void smooth(std::size_t k) {
    begin(Residual::name);
    constexpr std::array kFirst{Residual::kLength, Residual::kDrive, Residual::kTorque,
                                Residual::kForce,  Residual::kTip,   Residual::kCentre};
    const int weights = kFirst.at(static_cast<std::size_t>(of_.shape.channel));
    const int count = of_.shape.functions();
    const int part = of_.parts[k];
    for (int f = 0; f < count; ++f) {
      const auto weight = static_cast<Eigen::Index>(k) * count + f;
      parameter(weights + f) = of_.weights[weight];
      number(weights + f, unit(weight));
    }
    parameter(Residual::kPart) = part + 1;
    set(Residual::kStrutPowers, of_.shape.strut_powers);
    set(Residual::kSharedPowers, of_.shape.shared_powers);
    for (std::size_t d = 0; d < of_.shape.coordinates.size(); ++d) {
      const int at = static_cast<int>(d);
      parameter(Residual::kCoordinate + at) = of_.shape.coordinates[d];
      parameter(Residual::kMiddle + at) = of_.region.middle[d];
      parameter(Residual::kHalfWidth + at) = of_.region.half_width[d];
      double lower = of_.region.middle[d] - of_.region.half_width[d];
      double upper = of_.region.middle[d] + of_.region.half_width[d];
      if (part >= 0) {
        lower = of_.region.lower[static_cast<std::size_t>(part)][d];
        upper = of_.region.upper[static_cast<std::size_t>(part)][d];
      }
      parameter(Residual::kLower + at) = lower;
      parameter(Residual::kUpper + at) = upper;
    }
  }

  int generic_first() const {
    constexpr std::array kFirst{Generic::kLength, Generic::kDrive, Generic::kTorque, Generic::kForce, Generic::kTip};
    return kFirst.at(static_cast<std::size_t>(of_.shape.channel));
  }
  std::vector<int> parts_of(int part) const {
    if (part >= 0) return {part};
    std::vector<int> all;
    for (int j = 0; j < of_.shape.parts(); ++j) all.push_back(j);
    return all;
  }
  void begin_generic() {
    begin(Generic::name);
    set(Generic::kStrutPowers, of_.shape.strut_powers);
    set(Generic::kSharedPowers, of_.shape.shared_powers);
  }

  void product() {
    begin_generic();
    for (std::size_t k = 0; k < of_.parts.size(); ++k) {
      const auto weight = static_cast<Eigen::Index>(k);
      for (const int part : parts_of(of_.parts[k])) {
        parameter(generic_first() + part) = of_.weights[weight];
        number(generic_first() + part, unit(weight));
      }
    }
  }

  // c cos(a) - s sin(a) = hypot(c, s) cos(a + atan2(s, c))
  void wave(std::size_t k) {
    begin_generic();
    const auto at = static_cast<Eigen::Index>(2 * k);
    const double c = of_.weights[at];
    const double s = of_.weights[at + 1];
    const double size = std::max(std::hypot(c, s), 1e-12);
    parameter(Generic::kPitch) = of_.shape.pitch;
    parameter(Generic::kPhase) = std::atan2(s, c);
    for (const int part : parts_of(of_.parts[k])) {
      parameter(generic_first() + part) = size;
      number(generic_first() + part, (c * unit(at) + s * unit(at + 1)) / size);
    }
    number(Generic::kPhase, (c * unit(at + 1) - s * unit(at)) / (size * size));
  }

  const Component& of_;
  physics::ForceModel& forces_;
  std::string_view effect_;
  int first_ = 0;
  int row_ = 0;
  std::vector<RowNumber> numbers_;
};

}  // namespace

std::vector<RowNumber> add_rows(const Component& component, physics::ForceModel& forces) {
  return Rows(component, forces).add();
}

}  // namespace plumbline::diagnose
