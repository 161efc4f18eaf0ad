#include "truth/drawn_case.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "truth/program.hpp"

namespace truth {
namespace {

constexpr double kBallOff = 8e-6;     // m, on each axis
constexpr double kBarOff = 2e-6;      // m
constexpr double kRadialStep = 1e-7;  // m, as the files are written
constexpr double kTorqueStep = 0.01;  // N m
constexpr int kSamplesOfStrength = 120;
constexpr double kMostOfBound = 0.95;

std::string one_of(const std::vector<std::string>& names, Random& random) {
  return names[std::uniform_int_distribution<std::size_t>(0, names.size() - 1)(random)];
}

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

// The names that an option asks for.
std::vector<std::string> names_of(const std::string& effect, Random& random) {
  if (effect == "none") return {};
  if (effect == "any") return {one_of(first_shelf(), random)};
  if (effect == "outside") return {one_of(outside_effects(), random)};
  if (starts_with(effect, "outside:")) return {effect.substr(8)};
  if (starts_with(effect, "two:")) {
    const std::size_t comma = effect.find(',');
    if (comma == std::string::npos) throw std::runtime_error("two:A,B names two effects");
    return {effect.substr(4, comma - 4), effect.substr(comma + 1)};
  }
  if (effect != "two") return {effect};
  std::vector<std::string> names{one_of(first_shelf(), random)};
  while (names.size() < 2) {
    const std::string other = one_of(first_shelf(), random);
    if (other != names.front()) names.push_back(other);
  }
  return names;
}

// How far the numbers of an effect may grow before one comes near its bound.
double largest_share(Flaws flaws, const std::string& name) {
  double largest = 0;
  for (const Key& key : effect_in(flaws, name).keys) {
    if (key.name == "phase_deg" || key.name == "speed_mm_s") continue;
    for (const double* x : key.numbers) largest = std::max(largest, std::abs(*x) / (key.upper * key.unit));
  }
  return kMostOfBound / largest;
}

// The effect at the size that gives the wanted strength, or at its largest if that does not reach it.
Hidden sized(const Strength& strength, const Machine& machine, const std::string& name, double snr, Random& random) {
  Hidden hidden;
  hidden.name = name;
  const auto& outside = outside_effects();
  hidden.outside = std::find(outside.begin(), outside.end(), name) != outside.end();
  const Flaws full = drawn_flaws(name, random);
  const double most = largest_share(full, name);
  double share = std::min(most, 0.1);
  for (int step = 0; step < 8; ++step) {
    hidden.flaws = scaled(full, name, share);
    hidden.snr = strength.snr(strength.trace(machine, hidden.flaws));
    if (hidden.snr <= 0) throw std::runtime_error("the plan does not see " + name);
    if (std::abs(hidden.snr / snr - 1) < 0.005 || (share == most && hidden.snr < snr)) break;
    share = std::min(most, share * snr / hidden.snr);
  }
  return hidden;
}

void look_around(const Strength& strength, const Machine& machine, Hidden& hidden) {
  const Column trace = strength.trace(machine, hidden.flaws);
  double own = hidden.snr;
  for (const auto& shelf : {first_shelf(), second_shelf()}) {
    for (const std::string& name : shelf) {
      const double left = strength.beyond(trace, {name});
      if (name == hidden.name) {
        own = left;
      } else {
        hidden.nearest.emplace_back(name, left);
      }
    }
  }
  std::sort(hidden.nearest.begin(), hidden.nearest.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  hidden.beyond_others = hidden.nearest.front().second;
  hidden.beyond_all = std::min(own, hidden.beyond_others);
  hidden.beyond_two = hidden.beyond_others;
  for (const auto& [one, alone] : hidden.nearest) {
    for (const auto& [other, more] : hidden.nearest) {
      if (one < other) hidden.beyond_two = std::min(hidden.beyond_two, strength.beyond(trace, {one, other}));
    }
  }
  hidden.nearest.resize(4);
}

// All effects together: numbers of different effects lie in different places.
Flaws together(const std::vector<Hidden>& hidden) {
  Flaws all;
  for (const Hidden& one : hidden) {
    Flaws flaws = one.flaws;
    const Effect from = effect_in(flaws, one.name);
    Effect into = effect_in(all, one.name);
    for (std::size_t k = 0; k < from.keys.size(); ++k) {
      for (std::size_t i = 0; i < from.keys[k].numbers.size(); ++i) *into.keys[k].numbers[i] = *from.keys[k].numbers[i];
    }
  }
  return all;
}

MeasuredRun measured_with_noise(const DrawnCase& drawn, const PlannedRun& planned, Random& random) {
  std::normal_distribution<double> normal;
  const Vec off = kBallOff * Vec(normal(random), normal(random), normal(random));
  const double bar = kBarOff * normal(random);
  const CaseOptions& o = drawn.options;
  MeasuredRun run{planned, {}};
  if (o.programs.empty()) {
    run.samples = measured(drawn.truth, planned, o.law, off, bar);
  } else {
    const Program whole = read_program(o.programs + "/" + planned.id + ".jsonl");
    const Program program = last_turn(whole, planned.circle.ball());
    run.samples = measured_on(drawn.truth, planned, program, o.law, off, bar);
  }
  const auto some = [&](double sigma) { return noise(run.samples.size(), sigma, o.colour, o.memory, random); };
  const std::vector<double> radial = some(o.radial_noise);
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    run.samples[i].reading.radial = rounded(run.samples[i].reading.radial + radial[i], kRadialStep);
  }
  for (std::size_t j = 0; j < 6; ++j) {
    const std::vector<double> torque = some(o.torque_noise);
    for (std::size_t i = 0; i < run.samples.size(); ++i) {
      run.samples[i].reading.torque[j] = rounded(run.samples[i].reading.torque[j] + torque[i], kTorqueStep);
    }
  }
  return run;
}

}  // namespace

namespace {

// The machine and what is hidden in it, not measured yet.
DrawnCase hide(const CaseOptions& options, Random& random) {
  DrawnCase drawn;
  drawn.options = options;
  drawn.model = read_model(options.machine);
  drawn.truth.machine = truth::drawn(drawn.model, random);
  const std::vector<std::string> names = names_of(options.effect, random);
  if (!names.empty()) {
    const Strength strength(drawn.model, plan_of(options.plan, kSamplesOfStrength));
    for (const std::string& name : names) {
      drawn.hidden.push_back(sized(strength, drawn.truth.machine, name, options.snr, random));
      if (options.look_alikes) look_around(strength, drawn.truth.machine, drawn.hidden.back());
    }
    drawn.truth.flaws = together(drawn.hidden);
  }
  return drawn;
}

}  // namespace

Truth draw_truth(const CaseOptions& options) {
  Random random(options.seed);
  return hide(options, random).truth;
}

DrawnCase draw_case(const CaseOptions& options) {
  Random random(options.seed);
  DrawnCase drawn = hide(options, random);
  for (const PlannedRun& run : plan_of(options.plan, options.samples)) {
    drawn.data.push_back(measured_with_noise(drawn, run, random));
  }
  if (!options.programs.empty()) return drawn;
  for (const PlannedRun& run : holdout(options.samples)) {
    drawn.holdout.push_back(measured_with_noise(drawn, run, random));
  }
  for (const PlannedRun& run : circles_of(options.more, options.samples)) {
    drawn.more.push_back(measured_with_noise(drawn, run, random));
  }
  return drawn;
}

}  // namespace truth
