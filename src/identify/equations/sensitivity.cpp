#include "identify/equations/sensitivity.hpp"

#include <algorithm>
#include <optional>

#include "base/check.hpp"

namespace plumbline::identify {
namespace {

using machine::kStruts;
using machine::Matrix6;
using machine::PerStrut;
using machine::StrutVectors;
using machine::Vector6;
using physics::Conditions;
using physics::Situation;
using physics::Wrench;

// What follows from where the machine stands: strut lengths beyond those commanded, displacement of the tip that no
// strut makes, torques. Derivatives of each, one column per seed.
struct Flow {
  Matrix6<double> stretch, tip, torque;
};

// The conditions as 25 numbers, in this order: what is often unknown comes first, and together.
constexpr int kConditions = 25;
Eigen::Matrix<Jet, kConditions, 1> flat(const Conditions<Jet>& c) {
  Eigen::Matrix<Jet, kConditions, 1> all;
  all << c.gravity, c.centre_of_mass_P, c.screw_mass, c.motor_mass, c.joint_mass, c.platform_mass;
  return all;
}
Jet& condition(Conditions<Jet>& c, int i) {
  if (i < 3) return c.gravity[i];
  if (i < 6) return c.centre_of_mass_P[i - 3];
  if (i < 12) return c.screw_mass[i - 6];
  if (i < 18) return c.motor_mass[i - 12];
  return i < 24 ? c.joint_mass[i - 18] : c.platform_mass;
}

template <class Matrix>
auto jets_of(const Matrix& values) {
  return values.template cast<Jet>().eval();
}

void seed(PerStrut<Jet>& values) {
  for (int j = 0; j < kStruts; ++j) values[j].v = PerStrut<double>::Unit(j);
}

// by += outcome * slopes, most unknowns being those of one strut: the other rows are zero.
template <class Outcome>
void add_product(Outcome& by, const Outcome& outcome, const Matrix6<double>& slopes) {
  for (int j = 0; j < kStruts; ++j) {
    if (!slopes.row(j).isZero(0)) by.noalias() += outcome.col(j) * slopes.row(j);
  }
}

}  // namespace

// One point, and how the outcome moves with each sum that effects add to.
struct Sensitivity::Point {
  using Outcome6 = Eigen::Matrix<double, kOutcomes, 6>;

  Point(const physics::ForceModel& model, const Jet* values, const physics::Environment& environment,
        const physics::Motion<double>& commanded, const physics::TipError<double>& error);

  const physics::ForceModel& forces;
  const Jet* parameters;
  physics::Motion<Jet> motion;
  physics::StrutRates<Jet> rates;
  Pose<Jet> pose;
  const machine::Lu6<double>& lu;
  Situation<Jet> at;

  Outcome6 by_stretch, by_tip, by_torque;
  Outcome6 by_drive, by_nut, by_wrench;

  // One for each hook of physics/hooks.hpp: adds to `by` what a sum's slopes do to the outcome.
  void follow_conditions(const Conditions<Jet>& sum, Outcome6& by) {
    by += by_conditions(slopes_of<kConditions>(flat(sum)));
  }
  void follow_wrench(const Wrench<Jet>& sum, Outcome6& by) const {
    by += by_wrench.leftCols<3>() * slopes_of<3>(sum.force) + by_wrench.rightCols<3>() * slopes_of<3>(sum.moment);
  }
  void follow_transverse_force(const StrutVectors<Jet>& sum, Outcome6& by) const {
    Wrench<Jet> wrench;
    wrench.add_at_joints(sum, at.struts);
    follow_wrench(wrench, by);
  }
  void follow_nut_tension(const PerStrut<Jet>& sum, Outcome6& by) const { add_product(by, by_nut, slopes_of<6>(sum)); }
  void follow_drive_tension(const PerStrut<Jet>& sum, Outcome6& by) const {
    add_product(by, by_drive, slopes_of<6>(sum));
  }
  void follow_length(const PerStrut<Jet>& sum, Outcome6& by) const { add_product(by, by_stretch, slopes_of<6>(sum)); }
  void follow_tip(const Vector6<Jet>& sum, Outcome6& by) const { add_product(by, by_tip, slopes_of<6>(sum)); }
  void follow_reading(const PerStrut<Jet>& sum, Outcome6& by) const { add_product(by, by_torque, slopes_of<6>(sum)); }

 private:
  // What changes of the conditions do, given as 25 rows. What is asked for once is kept.
  Outcome6 by_conditions(const Eigen::Matrix<double, kConditions, kSeeds>& changes);
  Flow by_pose(const Pose<double>& standing) const;
  Flow after_drive(Situation<Jet>& now) const;
  Flow after_nut(Situation<Jet>& now) const;
  Flow after_conditions(Situation<Jet>& now) const;
  Outcome6 outcome(const Flow& flow) const {
    return by_stretch * flow.stretch + by_tip * flow.tip + by_torque * flow.torque;
  }

  static constexpr int kParts = (kConditions + kSeeds - 1) / kSeeds;
  std::array<std::optional<Outcome6>, kParts> by_conditions_;
};

namespace {

physics::Motion<Jet> without_slopes(const physics::Motion<double>& m) {
  return {{jets_of(m.pose.p_WT), jets_of(m.pose.R_WP)},
          {jets_of(m.twist.v_WT), jets_of(m.twist.w_WP)},
          {jets_of(m.acceleration.v_WT), jets_of(m.acceleration.w_WP)},
          Jet(m.time)};
}

physics::StrutRates<Jet> without_slopes(const physics::StrutRates<double>& r) {
  return {jets_of(r.speed), jets_of(r.acceleration), jets_of(r.sign), jets_of(r.transverse)};
}

// Where the struts leave the platform, before displacements that no strut makes.
Pose<double> on_struts(const physics::TipError<double>& error) {
  const Vector6<double> tip = error.loads.tip;
  return {error.pose.p_WT - tip.head<3>(), machine::exponential<double>(-tip.tail<3>()) * error.pose.R_WP};
}

}  // namespace

Sensitivity::Point::Point(const physics::ForceModel& model, const Jet* values, const physics::Environment& environment,
                          const physics::Motion<double>& commanded, const physics::TipError<double>& error)
    : forces(model),
      parameters(values),
      motion(without_slopes(commanded)),
      rates(without_slopes(physics::strut_rates(machine::strut_geometry(model.machine.geometry, commanded.pose),
                                                commanded, environment))),
      lu(error.loads.jacobian),
      at{model.machine,
         environment,
         motion,
         rates,
         pose,
         {jets_of(error.loads.struts.arm), jets_of(error.loads.struts.direction), jets_of(error.loads.struts.length)},
         {}} {
  const Pose<double> standing = on_struts(error);
  pose = {jets_of(standing.p_WT), jets_of(standing.R_WP)};
  at.conditions.gravity = jets_of(model.machine.gravity);
  ask_conditions(forces, parameters, at, at.conditions);
  at.nut_tension = jets_of(error.loads.nut_tension);
  at.drive_tension = jets_of(error.loads.drive_tension);
  at.torque = model.machine.torque(at.drive_tension);

  // L_cmd + dL(X, p) - L(X) = 0 holds for where the machine stands, X, hence (J - dL_X) dX = dL_p  [implicit function
  // theorem]; the tip is at X displaced by what no strut makes
  const Flow pose_flow = by_pose(standing);
  const Matrix6<double> J = machine::jacobian(error.loads.struts);
  const Matrix6<double> by_length = (J - pose_flow.stretch).partialPivLu().inverse();
  const Matrix6<double> displaced = (Matrix6<double>::Identity() + pose_flow.tip) * by_length;
  by_stretch.middleRows<3>(kTipRow) = displaced.topRows<3>();
  by_stretch.middleRows<6>(kTorqueRow) = pose_flow.torque * by_length;
  by_stretch.middleRows<3>(kTurnRow) = displaced.bottomRows<3>();
  by_tip.setZero();
  by_tip.block<3, 3>(kTipRow, 0).setIdentity();
  by_tip.block<3, 3>(kTurnRow, 3).setIdentity();
  by_torque.setZero();
  by_torque.middleRows<6>(kTorqueRow).setIdentity();

  Situation<Jet> driven = at;
  seed(driven.drive_tension);
  by_drive = outcome(after_drive(driven));
  Situation<Jet> pulled = at;
  seed(pulled.nut_tension);
  by_nut = outcome(after_nut(pulled));
  // J^T t = w
  by_wrench = by_nut * J.transpose().partialPivLu().inverse();
}

Sensitivity::Point::Outcome6 Sensitivity::Point::by_conditions(
    const Eigen::Matrix<double, kConditions, kSeeds>& changes) {
  Outcome6 sum = Outcome6::Zero();
  for (int part = 0; part < kParts; ++part) {
    const int first = part * kSeeds;
    const int count = std::min(kSeeds, kConditions - first);
    if (changes.middleRows(first, count).isZero(0)) continue;
    std::optional<Outcome6>& known = by_conditions_[static_cast<std::size_t>(part)];
    if (!known) {
      Situation<Jet> weighed = at;
      for (int k = 0; k < count; ++k) condition(weighed.conditions, first + k).v[k] = 1;
      known = outcome(after_conditions(weighed));
    }
    sum += known->leftCols(count) * changes.middleRows(first, count);
  }
  return sum;
}

// The whole calculation, its derivatives by a displacement of the platform.
Flow Sensitivity::Point::by_pose(const Pose<double>& standing) const {
  Vector6<Jet> displacement = Vector6<Jet>::Zero();
  seed(displacement);
  const Pose<Jet> near = machine::displaced<Jet>({jets_of(standing.p_WT), jets_of(standing.R_WP)}, displacement);
  const physics::StrutStretch<Jet> loads = strut_stretch_at(forces, parameters, at.environment, motion, rates, near,
                                                            machine::strut_geometry(forces.machine.geometry, near));
  return {slopes_of<6>(loads.stretch), slopes_of<6>(loads.tip), slopes_of<6>(loads.torque)};
}

// From the drive's tension on.
Flow Sensitivity::Point::after_drive(Situation<Jet>& now) const {
  const PerStrut<Jet> stretch = stretch_from_drive_tension(forces, parameters, now);
  const Vector6<Jet> tip = tip_from_drive_tension(forces, parameters, now);
  const PerStrut<Jet> reading = reading_from_drive_tension(forces, parameters, now);
  return {slopes_of<6>(stretch), slopes_of<6>(tip), slopes_of<6>(reading)};
}

// From the nut's tension on.
Flow Sensitivity::Point::after_nut(Situation<Jet>& now) const {
  drive_from_nut_tension(forces, parameters, now);
  return after_drive(now);
}

// From gravity and masses on; the machine stands still, so that its Jacobian has no derivative.
Flow Sensitivity::Point::after_conditions(Situation<Jet>& now) const {
  StrutVectors<Jet> transverse = StrutVectors<Jet>::Zero();
  const Wrench<Jet> wrench = wrench_from_conditions(forces, parameters, now, transverse);
  Matrix6<double> load;
  load << slopes_of<3>(wrench.force), slopes_of<3>(wrench.moment);
  PerStrut<Jet> tension = PerStrut<Jet>::Zero();
  for (int k = 0; k < kSeeds; ++k) {
    const Vector6<double> slopes = lu.solve_transposed(load.col(k));
    for (int j = 0; j < kStruts; ++j) tension[j].v[k] = slopes[j];
  }
  nut_from_joint_tension(forces, parameters, now, tension);
  for (int j = 0; j < kStruts; ++j) now.nut_tension[j].a = at.nut_tension[j].a;
  return after_nut(now);
}

Sensitivity::Sensitivity(const physics::ForceModel& forces, const Unknowns& unknowns)
    : forces_(forces),
      unknowns_(static_cast<Eigen::Index>(unknowns.size())),
      parameters_(physics::parameters_as<Jet>(forces)) {
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    for (const Unknown::Term& term : unknowns[u].terms) {
      const auto holds = [&](const physics::Instance& i) {
        return term.parameter >= i.first && term.parameter < i.first + physics::effect_infos()[i.effect].size();
      };
      const auto instance = std::find_if(forces.instances().begin(), forces.instances().end(), holds);
      PLUMBLINE_CHECK(instance != forces.instances().end());
      const Seed seed{term.parameter - instance->first, 0, term.weight};
      if (physics::effect_infos()[instance->effect].own_strut_alone) {
        add_strut_seed(instance->effect, instance->first, static_cast<int>(u), seed);
      } else {
        add_seed(instance->effect, instance->first, static_cast<int>(u), seed);
      }
    }
  }
}

void Sensitivity::add_seed(std::size_t effect, int first, int unknown, Seed seed) {
  std::vector<Chunk>& chunks = chunks_[effect];
  const bool known = !chunks.empty() && chunks.back().first == first && chunks.back().used > 0 &&
                     chunks.back().unknowns[static_cast<std::size_t>(chunks.back().used - 1)] == unknown;
  if (!known) {
    if (chunks.empty() || chunks.back().first != first || chunks.back().used == kSeeds) chunks.push_back({first});
    chunks.back().unknowns[static_cast<std::size_t>(chunks.back().used++)] = unknown;
  }
  seed.slot = chunks.back().used - 1;
  chunks.back().seeds.push_back(seed);
}

void Sensitivity::add_strut_seed(std::size_t effect, int first, int unknown, Seed seed) {
  const auto strut = static_cast<std::size_t>(physics::effect_infos()[effect].strut_of(seed.offset));
  std::vector<StrutChunk>& chunks = strut_chunks_[effect];
  const auto open = [&](const auto& of) { return of[strut] == unknown || of[strut] < 0; };
  const auto fits = [&](const StrutChunk& c) {
    return c.first == first && std::any_of(c.unknowns.begin(), c.unknowns.end(), open);
  };
  if (chunks.empty() || !fits(chunks.back())) {
    chunks.push_back({first, {}, {}});
    for (auto& of : chunks.back().unknowns) of.fill(-1);
  }
  auto& unknowns = chunks.back().unknowns;
  auto* const slot = std::find_if(unknowns.begin(), unknowns.end(), open);
  (*slot)[strut] = unknown;
  seed.slot = static_cast<int>(slot - unknowns.begin());
  chunks.back().seeds.push_back(seed);
}

namespace {

template <class Sum>
Sum empty() {
  if constexpr (requires { Sum::Zero(); }) {
    return Sum::Zero();
  } else {
    return Sum{};
  }
}

}  // namespace

// An instance's parameters, with the derivatives that seeds give them.
template <class Effect>
auto Sensitivity::seeded(int first, const std::vector<Seed>& seeds) const {
  constexpr auto kSize = [] {
    std::size_t size = 0;
    for (const auto& spec : Effect::parameters) size += static_cast<std::size_t>(spec.size());
    return size;
  }();
  std::array<Jet, kSize> values;
  std::copy_n(parameters_.begin() + first, kSize, values.begin());
  for (const Seed& seed : seeds) values[static_cast<std::size_t>(seed.offset)].v[seed.slot] = seed.weight;
  return values;
}

template <class Effect>
void Sensitivity::add_strut_slopes(const StrutChunk& chunk, Point& point, Eigen::Ref<Slopes> slopes) const {
  const auto values = seeded<Effect>(chunk.first, chunk.seeds);
  PerStrut<Jet> length = PerStrut<Jet>::Zero();
  Effect::length(physics::Values<Jet>(values.data()), point.at, length);
  for (int k = 0; k < kSeeds; ++k) {
    for (int j = 0; j < kStruts; ++j) {
      const int unknown = chunk.unknowns[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)];
      if (unknown >= 0) slopes.col(unknown) += point.by_stretch.col(j) * length[j].v[k];
    }
  }
}

template <class Effect>
void Sensitivity::add_slopes(const Chunk& chunk, Point& point, Eigen::Ref<Slopes> slopes) const {
  const auto values = seeded<Effect>(chunk.first, chunk.seeds);
  const physics::Values<Jet> p(values.data());

  Point::Outcome6 by = Point::Outcome6::Zero();
  using T = Jet;
// NOLINTBEGIN(bugprone-macro-parentheses): the name of a member takes none
// Calls a hook with an empty sum, if the effect has it, and follows what it added to the outcome.
#define PLUMBLINE_FOLLOW(hook, Sum)                          \
  if constexpr (requires { &Effect::template hook<Jet>; }) { \
    auto sum = empty<Sum>();                                 \
    Effect::hook(p, point.at, sum);                          \
    point.follow_##hook(sum, by);                            \
  }
  // NOLINTEND(bugprone-macro-parentheses)
  PLUMBLINE_HOOKS(PLUMBLINE_FOLLOW)
#undef PLUMBLINE_FOLLOW
  for (int k = 0; k < chunk.used; ++k) slopes.col(chunk.unknowns[static_cast<std::size_t>(k)]) += by.col(k);
}

void Sensitivity::at(const physics::Environment& environment, const physics::Motion<double>& motion,
                     const physics::TipError<double>& error, Eigen::Ref<Slopes> slopes) const {
  Point point(forces_, parameters_.data(), environment, motion, error);
  slopes.setZero();
  physics::for_each_effect([&]<class Effect>(std::size_t i) {
    if constexpr (physics::moves_own_strut_alone<Effect>) {
      for (const StrutChunk& chunk : strut_chunks_[i]) add_strut_slopes<Effect>(chunk, point, slopes);
    } else if constexpr (!Effect::parameters.empty()) {
      for (const Chunk& chunk : chunks_[i]) add_slopes<Effect>(chunk, point, slopes);
    }
  });
}

}  // namespace plumbline::identify
