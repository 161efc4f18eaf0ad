// The battery: what every effect of the list has to satisfy, run on each without naming it.
#include <catch2/catch.hpp>
#include <ceres/jet.h>

#include "machine/machines.hpp"
#include "physics/effects/list.hpp"
#include "physics/moments.hpp"
#include "physics/strut_stretch.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

using Numbers = Eigen::VectorXd;
using Jet = ceres::Jet<double, 1>;

// --- the sums that hooks add to, as plain numbers ---

Numbers numbers(const Conditions<double>& c) {
  Numbers n(25);
  n << c.gravity, c.platform_mass, c.centre_of_mass_P, c.screw_mass, c.joint_mass, c.motor_mass;
  return n;
}
Numbers numbers(const Wrench<double>& w) { return (Numbers(6) << w.force, w.moment).finished(); }
template <int Rows, int Columns>
Numbers numbers(const Eigen::Matrix<double, Rows, Columns>& m) {
  return m.reshaped();
}

void fill(Conditions<double>& c, double x) {
  for (auto* v : {&c.screw_mass, &c.joint_mass, &c.motor_mass}) v->setConstant(x);
  for (auto* v : {&c.gravity, &c.centre_of_mass_P}) v->setConstant(x);
  c.platform_mass = x;
}
void fill(Wrench<double>& w, double x) {
  w.force.setConstant(x);
  w.moment.setConstant(x);
}
template <int Rows, int Columns>
void fill(Eigen::Matrix<double, Rows, Columns>& m, double x) {
  m.setConstant(x);
}

// Calls check(name of the hook, a function that adds to a sum, an empty sum) for each hook of the effect.
// NOLINTBEGIN(bugprone-macro-parentheses): the name of a member takes none
#define HOOK(name, Sum)                                                                           \
  if constexpr (requires { &Effect::template name<T>; }) {                                        \
    check(                                                                                        \
        #name, [&](Sum& sum) { Effect::name(Values<T>(p.data()), at, sum); }, Sum{empty<Sum>()}); \
  }
// NOLINTEND(bugprone-macro-parentheses)
template <class Sum>
Sum empty() {
  Sum sum;
  fill(sum, 0);
  return sum;
}
template <class Effect, class Check>
void for_each_hook(const std::vector<double>& p, const Situation<double>& at, Check check) {
  using T = double;
  PLUMBLINE_HOOKS(HOOK)
}
#undef HOOK

// A moment with loads of ordinary size, for calling hooks one by one.
struct Stage {
  ForceModel model{pm600_like()};
  Motion<double> motion;
  Environment environment = model.environment();
  machine::StrutGeometry<double> struts;
  StrutRates<double> rates;
  Situation<double> at;

  template <class Effect>
  Stage(Random& random, const std::vector<double>& p, Effect*)
      : motion(moment_within(pm600_like().limits, random)),
        struts(machine::strut_geometry(model.machine.geometry, motion.pose)),
        rates(strut_rates(struts, motion, environment)),
        at{model.machine, environment, motion, rates, motion.pose, struts, {}} {
    environment.tool_mass = environment.payload_mass = p.empty() ? 0 : 3;
    at.conditions.gravity = model.machine.gravity;
    if constexpr (requires { &Effect::template conditions<double>; }) {
      Effect::conditions(Values<double>(p.data()), at, at.conditions);
    }
    for (auto* tension : {&at.nut_tension, &at.drive_tension}) {
      *tension = machine::PerStrut<double>::NullaryExpr([&] { return uniform(random, -300, 900); });
    }
    at.torque = at.drive_tension * 0.003;
  }
};

std::vector<double> initial_values(const EffectInfo& info) {
  std::vector<double> values;
  for (const ParameterSpec& spec : info.parameters) {
    values.insert(values.end(), static_cast<std::size_t>(spec.size()), spec.initial * spec.unit.si);
  }
  return values;
}

// Ordinary values: near the model's for a base effect, else up to a fifth of the bounds.
std::vector<double> ordinary_values(const EffectInfo& info, Random& random) {
  static const machine::MachineModel model = pm600_like();
  std::vector<double> values;
  for (const ParameterSpec& spec : info.parameters) {
    for (int i = 0; i < spec.size(); ++i) {
      double value = uniform(random, 0.2 * spec.lower, 0.2 * spec.upper) * spec.unit.si;
      if (spec.setting) value = std::round(uniform(random, 0.51, 2.49)) * spec.unit.si;
      if (info.base) {
        const double stated = model.value(spec.table, spec.key).values[static_cast<std::size_t>(i)];
        value =
            stated != 0 ? stated * uniform(random, 0.8, 1.2) : uniform(random, 0, 0.005 * spec.upper) * spec.unit.si;
      }
      values.push_back(value);
    }
  }
  return values;
}

// Which numbers are parameters, and not settings.
std::vector<bool> fitted_numbers(const EffectInfo& info) {
  std::vector<bool> fitted;
  for (const ParameterSpec& spec : info.parameters) {
    fitted.insert(fitted.end(), static_cast<std::size_t>(spec.size()), !spec.setting);
  }
  return fitted;
}

// A model in which that effect acts with these values.
ForceModel model_with(std::size_t effect, const std::vector<double>& values) {
  ForceModel model(pm600_like());
  const EffectInfo& info = effect_infos()[effect];
  const int first = info.base ? model.instances_of(effect).front() : model.add(info.name);
  std::copy(values.begin(), values.end(), model.parameters.begin() + first);
  return model;
}

template <class T>
Eigen::Matrix<T, 30, 1> outcome(const StrutStretch<T>& s) {
  Eigen::Matrix<T, 30, 1> all;
  all << s.tension, s.drive_tension, s.stretch, s.tip, s.torque;
  return all;
}

// Tensions in N, stretch in um, torques in N m: what a difference of one means is then alike.
const Eigen::Matrix<double, 30, 1> kScale = [] {
  Eigen::Matrix<double, 30, 1> scale;
  scale << Eigen::Matrix<double, 12, 1>::Ones(), Eigen::Matrix<double, 12, 1>::Constant(1e6),
      Eigen::Matrix<double, 6, 1>::Constant(100);
  return scale;
}();

// Derivatives of the outcome by one parameter: automatic, by finite differences, and how far the two may differ.
struct Slopes {
  Eigen::Matrix<double, 30, 1> automatic, finite, margin;
};

Slopes slopes_by(ForceModel model, std::size_t parameter, const Environment& environment,
                 const Motion<double>& motion) {
  std::vector<Jet> jets = parameters_as<Jet>(model);
  jets[parameter].v[0] = 1;
  const auto by_jet = outcome(strut_stretch(model, jets.data(), environment, cast<Jet>(motion)));

  const double here = model.parameters[parameter];
  const double h = 1e-5 * std::max(std::abs(here), 1e-6);
  model.parameters[parameter] = here + h;
  const auto later = outcome(strut_stretch(model, environment, motion));
  model.parameters[parameter] = here - h;
  const auto before = outcome(strut_stretch(model, environment, motion));

  Slopes slopes;
  for (int k = 0; k < by_jet.size(); ++k) slopes.automatic[k] = by_jet[k].v[0];
  slopes.finite = (later - before) / (2 * h);
  // what rounding of the two values leaves, and the curvature over the step
  const Eigen::Array<double, 30, 1> rounding =
      1e-13 * (1 + (later.array() * kScale.array()).abs()) / (h * kScale.array());
  slopes.margin = rounding + 1e-6 * slopes.finite.array().abs();
  return slopes;
}

}  // namespace

TEST_CASE("every effect adds to what is there, and assigns nothing") {
  Random random(20);
  for_each_effect([&]<class Effect>(std::size_t i) {
    const std::vector<double> p = ordinary_values(effect_infos()[i], random);
    const Stage stage(random, p, static_cast<Effect*>(nullptr));
    for_each_hook<Effect>(p, stage.at, [&](const char* hook, auto add, auto sum) {
      INFO(Effect::name << " " << hook);
      add(sum);
      const Numbers alone = numbers(sum);
      fill(sum, 0.75);
      add(sum);
      const Numbers onto = numbers(sum);
      CHECK((onto - alone).isApproxToConstant(0.75, 1e-12 * (1 + alone.cwiseAbs().maxCoeff())));
    });
  });
}

TEST_CASE("every effect has a hook that its parameters work through, and adds nothing at their initial values") {
  Random random(21);
  for_each_effect([&]<class Effect>(std::size_t i) {
    INFO(Effect::name);
    const EffectInfo& info = effect_infos()[i];
    double most = 0;
    for (int n = 0; n < 5; ++n) {
      const std::vector<double> none = initial_values(info);
      const Stage idle(random, none, static_cast<Effect*>(nullptr));
      for_each_hook<Effect>(none, idle.at, [&](const char*, auto add, auto sum) {
        add(sum);
        CHECK(numbers(sum).isZero(0));
      });
      const std::vector<double> p = ordinary_values(info, random);
      Stage stage(random, p, static_cast<Effect*>(nullptr));
      if (p.empty()) stage.environment.tool_mass = 3;
      for_each_hook<Effect>(p, stage.at, [&](const char*, auto add, auto sum) {
        add(sum);
        most = std::max(most, numbers(sum).cwiseAbs().maxCoeff());
      });
    }
    CHECK(most > 0);
  });
}

TEST_CASE("numbers that move their own strut alone do nothing else, whatever the loads") {
  Random random(23);
  int some = 0;
  for_each_effect([&]<class Effect>(std::size_t i) {
    if constexpr (moves_own_strut_alone<Effect>) {
      ++some;
      const EffectInfo& info = effect_infos()[i];
      const std::vector<double> none = initial_values(info);
      Stage stage(random, none, static_cast<Effect*>(nullptr));
      for (int n = 0; n < info.size(); ++n) {
        INFO(Effect::name << ", number " << n);
        std::vector<double> p = none;
        p[static_cast<std::size_t>(n)] = 1e-4;
        std::vector<Numbers> found;
        for (int twice = 0; twice < 2; ++twice) {
          for_each_hook<Effect>(p, stage.at, [&](const std::string& hook, auto add, auto sum) {
            REQUIRE(hook == "length");
            add(sum);
            found.push_back(numbers(sum));
          });
          stage.at.drive_tension *= 2;
          stage.at.nut_tension *= 2;
          stage.at.torque *= 2;
        }
        REQUIRE(found.size() == 2);
        CHECK(found[0] == found[1]);
        CHECK(found[0][info.strut_of(n)] != 0);
        found[0][info.strut_of(n)] = 0;
        CHECK(found[0].isZero(0));
      }
    }
  });
  CHECK(some > 0);
}

TEST_CASE("a fresh instance of any effect of the catalogue leaves the machine as it is") {
  Random random(22);
  const machine::MachineModel machine = pm600_like();
  const ForceModel bare(machine);
  for (const std::string_view name : catalogue_names()) {
    INFO(name);
    ForceModel model(machine);
    model.add(name);
    const Motion<double> motion = moment_within(machine.limits, random);
    CHECK(outcome(strut_stretch(model, model.environment(), motion)) ==
          outcome(strut_stretch(bare, bare.environment(), motion)));
  }
}

TEST_CASE("every parameter of every effect matters, its automatic derivative equal to the finite difference") {
  Random random(23);
  for (std::size_t effect = 0; effect < kEffects; ++effect) {
    const EffectInfo& info = effect_infos()[effect];
    ForceModel model = model_with(effect, ordinary_values(info, random));
    const Environment environment = model.environment();
    const int first = model.instances_of(effect).front();
    const std::vector<bool> fitted = fitted_numbers(info);
    for (int i = 0; i < info.size(); ++i) {
      if (!fitted[static_cast<std::size_t>(i)]) continue;
      INFO(info.name << ", parameter " << i);
      double steepest = 0;
      for (int n = 0; n < 3; ++n) {
        const Motion<double> motion = moment_within(pm600_like().limits, random);
        const Slopes slopes = slopes_by(model, static_cast<std::size_t>(first + i), environment, motion);
        CHECK(((slopes.automatic - slopes.finite).cwiseAbs() - slopes.margin).maxCoeff() <= 0);
        steepest = std::max(steepest, slopes.automatic.cwiseAbs().maxCoeff());
      }
      CHECK(steepest > 0);
    }
  }
}

TEST_CASE("every effect gives a pack of poses what it gives each of them") {
  Random random(24);
  for (std::size_t effect = 0; effect < kEffects; ++effect) {
    INFO(effect_infos()[effect].name);
    const ForceModel model = model_with(effect, ordinary_values(effect_infos()[effect], random));
    std::vector<Motion<double>> lanes;
    for (int lane = 0; lane < Pack::size(); ++lane) lanes.push_back(moment_within(pm600_like().limits, random));
    const auto packed =
        outcome(strut_stretch(model, model.parameters.data(), model.environment(), packed_motion(lanes)));
    for (int lane = 0; lane < Pack::size(); ++lane) {
      const Motion<double>& motion = lanes[static_cast<std::size_t>(lane)];
      const auto alone = outcome(strut_stretch(model, model.environment(), motion));
      for (int k = 0; k < alone.size(); ++k) {
        CHECK(std::abs(packed[k][lane] - alone[k]) * kScale[k] <= 1e-9 * (1 + std::abs(alone[k] * kScale[k])));
      }
    }
  }
}

TEST_CASE("names and keys of the list are told apart") {
  std::vector<std::string_view> names;
  for (const EffectInfo& info : effect_infos()) {
    names.push_back(info.name);
    for (const ParameterSpec& spec : info.parameters) {
      INFO(info.name << "." << spec.key);
      CHECK(spec.lower < spec.upper);
      CHECK(info.base == !spec.table.empty());
      CHECK(info.offset_of(spec.key) >= 0);
    }
    CHECK(effect_index(info.name) == names.size() - 1);
  }
  std::sort(names.begin(), names.end());
  CHECK(std::unique(names.begin(), names.end()) == names.end());
  CHECK(effect_index("no-such-effect") == kEffects);
}
