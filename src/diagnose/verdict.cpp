#include "diagnose/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::diagnose {
namespace {

// Slopes of an effect's fitted numbers times these numbers: its signature, as coefficients of the problem's columns.
Eigen::VectorXd signature_of(const Workbench& bench, const Pick& pick, const Refit& fit, Eigen::Index columns) {
  Eigen::VectorXd signature = Eigen::VectorXd::Zero(columns);
  for (const int u : pick.unknowns) {
    const identify::Unknown& unknown = bench.candidates.unknowns[static_cast<std::size_t>(u)];
    if (unknown.shape) continue;
    signature[u] = (fit.values[u] - unknown.start) / unknown.scale;
  }
  return signature;
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::vector<std::string> alternatives_of(const Workbench& bench, const Model& model, std::size_t place,
                                         const VerdictOptions& options) {
  std::vector<Pick> others;
  for (std::size_t i = 0; i < model.found.size(); ++i) {
    if (i != place) others.push_back(model.found[i].pick);
  }
  const Eigen::MatrixXd reduced =
      reduced_gram(*model.problem, marginalised_by(bench.candidates, others, model.problem->values));
  const Pick& pick = model.found[place].pick;
  const Eigen::VectorXd signature = signature_of(bench, pick, model.fit, reduced.cols());
  const Eigen::VectorXd seen = reduced * signature;
  const double length2 = signature.dot(seen);
  std::vector<std::string> names;
  if (!(length2 > 0)) return names;
  for (const Candidate& candidate : bench.candidates.all) {
    if (&candidate == pick.candidate) continue;
    double most = 0;
    for (const ActingMode& mode : candidate.modes) {
      std::vector<int> all(mode.column_groups.size());
      std::iota(all.begin(), all.end(), 0);
      const ModeFit fit = fit_mode(reduced, bench.candidates, mode, all, seen);
      if (fit.seen) most = std::max(most, fit.gain);
    }
    const bool alike = most > options.same_signature * options.same_signature * length2;
    if (alike && 0.5 * (length2 - most) < options.told_apart_nats) names.push_back(candidate.name);
  }
  return names;
}

double resemblance(const Workbench& bench, const Model& model, std::size_t one, std::size_t other) {
  const Eigen::MatrixXd reduced =
      reduced_gram(*model.problem, marginalised_by(bench.candidates, {}, model.problem->values));
  const Eigen::VectorXd a = signature_of(bench, model.found[one].pick, model.fit, reduced.cols());
  const Eigen::VectorXd b = signature_of(bench, model.found[other].pick, model.fit, reduced.cols());
  const Eigen::VectorXd seen = reduced * b;
  const double lengths = std::sqrt(a.dot(reduced * a) * b.dot(seen));
  return lengths > 0 ? std::abs(a.dot(seen)) / lengths : 0;
}

std::vector<std::string> confidence_set_of(const Model& model, const std::vector<NamedEffect>& effects,
                                           const VerdictOptions& options) {
  std::vector<std::string> names;
  for (std::size_t place = 0; place < model.found.size(); ++place) {
    const Found& found = model.found[place];
    if (place > 0 && found.log_odds < options.as_strong * model.found.front().log_odds) continue;
    add_once(names, found.pick.candidate->name);
    for (const std::string& name : effects[place].alternatives) add_once(names, name);
    for (const Rival& rival : found.rivals) {
      if (rival.refitted && rival.log_odds > found.log_odds - options.within_nats) {
        add_once(names, rival.pick.candidate->name);
      }
    }
  }
  return names;
}

std::vector<NamedParameter> parameters_of(const Workbench& bench, const Pick& pick, const Refit& fit) {
  std::vector<NamedParameter> parameters;
  const physics::EffectInfo& info = physics::effect_infos()[physics::effect_index(pick.candidate->name)];
  for (const physics::ParameterSpec& spec : info.parameters) {
    NamedParameter parameter{std::string(spec.key), std::string(spec.unit.name)};
    parameter.each = static_cast<std::size_t>(spec.each);
    parameter.single = spec.size() == 1;
    for (int i = 0; i < spec.size(); ++i) {
      const int place = bench.candidates.unknowns.find(info.name, spec.key, parameter.single ? -1 : i);
      parameter.values.push_back(fit.values[place] / spec.unit.si);
      parameter.errors.push_back(fit.errors[static_cast<std::size_t>(place)] / spec.unit.si);
    }
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

}  // namespace plumbline::diagnose
