#include "identify/observability.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "identify/unknowns/geometry.hpp"

namespace plumbline::identify {
namespace {

// What the data alone say of a pair, the other unknowns within their priors: the pair's own priors taken back.
Eigen::Matrix2d pair_information(const Fit& fit, std::size_t a, std::size_t b) {
  Eigen::Matrix2d covariance;
  const std::array<std::size_t, 2> pair{a, b};
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      covariance(i, k) = fit.covariance(static_cast<Eigen::Index>(pair[static_cast<std::size_t>(i)]),
                                        static_cast<Eigen::Index>(pair[static_cast<std::size_t>(k)]));
    }
  }
  // the two may differ by many orders of magnitude
  const Eigen::Vector2d scale = covariance.diagonal().cwiseSqrt();
  const Eigen::Matrix2d correlation = (covariance.array() / (scale * scale.transpose()).array()).matrix();
  Eigen::Matrix2d information = correlation.inverse().array() / (scale * scale.transpose()).array();
  for (int i = 0; i < 2; ++i) {
    const double sigma = fit.unknowns[pair[static_cast<std::size_t>(i)]].sigma;
    information(i, i) -= 1 / (sigma * sigma);
  }
  return information;
}

std::vector<Confusion> confusions_of(const Fit& fit, const Observability& known, double apart) {
  const auto unknown_to_data = [&](std::size_t i) {
    return std::find(known.nothing.begin(), known.nothing.end(), i) != known.nothing.end();
  };
  std::vector<Confusion> found;
  for (std::size_t a = 0; a < fit.unknowns.size(); ++a) {
    for (std::size_t b = a + 1; b < fit.unknowns.size(); ++b) {
      if (is_geometry(fit.unknowns[a]) || is_geometry(fit.unknowns[b]) || unknown_to_data(a) || unknown_to_data(b))
        continue;
      const Eigen::Matrix2d M = pair_information(fit, a, b);
      if (M(0, 0) <= 0 || M(1, 1) <= 0) continue;
      const double correlation = -M(0, 1) / std::sqrt(M(0, 0) * M(1, 1));
      if (!(std::abs(correlation) >= apart)) continue;
      // w a + b moves as the data see it: along its gradient, w = M01 / M11; its variance with the priors
      Confusion c{a, b, correlation, M(0, 1) / M(1, 1)};
      const auto i = static_cast<Eigen::Index>(a);
      const auto k = static_cast<Eigen::Index>(b);
      c.value = c.weight * fit.values[i] + fit.values[k];
      c.standard_error = std::sqrt(c.weight * c.weight * fit.covariance(i, i) + 2 * c.weight * fit.covariance(i, k) +
                                   fit.covariance(k, k));
      found.push_back(c);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Confusion& a, const Confusion& b) { return std::abs(a.correlation) > std::abs(b.correlation); });
  return found;
}

std::string circles_text(const std::vector<measure::Run>& runs, double one_height) {
  if (runs.empty()) return "these poses";
  const auto [lowest, highest] = std::minmax_element(
      runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.centre_W.z() < b.centre_W.z(); });
  return highest->centre_W.z() - lowest->centre_W.z() <= one_height ? "circles at one height" : "these circles";
}

std::string confusion_text(const Confusion& c, const Unknowns& unknowns, const std::string& circles) {
  const Unknown& a = unknowns[c.first];
  const Unknown& b = unknowns[c.second];
  // K1 and K2 are lengths apart; others in the units of the file
  const bool compliances = a.label == "K1" && b.label == "K2";
  const double weight = compliances ? c.weight : c.weight * a.unit.si / b.unit.si;
  return fmt::format(
      "{} and {} cannot be told apart from {} (correlation {:.3f}): what they tell is {:.4g}{} x {} + {} "
      "= {:.6g} +- {:.2g} {}",
      a.label, b.label, circles, c.correlation, weight, compliances ? " m" : "", a.label, b.label, c.value / b.unit.si,
      c.standard_error / b.unit.si, b.unit.name);
}

// Numbers of the geometry by how many there are: "strut-offset (6 of 6), joint-position (30 of 36), level tilt_mrad x".
std::string names_of(const std::vector<std::size_t>& which, const Unknowns& unknowns) {
  std::map<std::string, std::size_t> geometry;
  std::vector<std::string> names;
  for (const std::size_t i : which) {
    if (is_geometry(unknowns[i])) {
      ++geometry[unknowns[i].effect];
    } else {
      names.push_back(unknowns[i].label);
    }
  }
  for (const auto& [effect, count] : geometry) {
    names.push_back(fmt::format("{} ({} of {})", effect, count, unknowns.of_effect(effect).size()));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

Observability observability(const Fit& fit, const std::vector<measure::Run>& runs,
                            const ObservabilityOptions& options) {
  Observability found;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(fit.information, Eigen::EigenvaluesOnly);
  found.singular_values = eigen.eigenvalues().cwiseMax(0).cwiseSqrt().reverse();
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& unknown = fit.unknowns[i];
    if (unknown.free()) {
      if (!std::isfinite(fit.standard_error(i))) found.nothing.push_back(i);
    } else if (fit.standard_error(i) > options.little * unknown.sigma) {
      found.little.push_back(i);
    }
  }
  found.confusions = confusions_of(fit, found, options.apart);

  if (!found.nothing.empty()) {
    found.statements.push_back("nothing in these data tells " + names_of(found.nothing, fit.unknowns));
  }
  const std::string circles = circles_text(runs, options.one_height);
  for (const Confusion& c : found.confusions) found.statements.push_back(confusion_text(c, fit.unknowns, circles));
  if (!found.little.empty()) {
    found.statements.push_back("these data tell little beyond [uncertainty] of " +
                               names_of(found.little, fit.unknowns));
  }
  return found;
}

}  // namespace plumbline::identify
