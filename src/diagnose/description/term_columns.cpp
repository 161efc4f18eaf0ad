#include "diagnose/description/term_columns.hpp"

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "physics/effects/generic.hpp"

namespace plumbline::diagnose {
namespace {

using identify::kRadial;
using machine::kStruts;
using physics::Generic;
using Channel = Term::Channel;

ReadyRun ready_run(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem,
                   std::size_t i) {
  ReadyRun run;
  run.raw = &problem.raw[i];
  run.states = sample_states(bench.machine.rotation, forces, bench.runs[i]);
  const Eigen::Index n = run.raw->samples;
  const Eigen::Index rows = run.raw->residual.size();
  run.drive = run.raw->slopes;
  run.force.setZero(rows, 3);
  run.centre.setZero(rows, 3);
  const int centre = forces.find(physics::PlatformGravity::name, "centre_of_mass_mm");
  const Vector3<double> centre_P = Eigen::Map<const Vector3<double>>(forces.parameters.data() + centre);
  run.tip.setZero(rows, 3);
  const Vector3<double> ball = measure::ideal_ball(bench.runs[i]);
  for (Eigen::Index s = 0; s < n; ++s) {
    const SampleState& state = run.states[static_cast<std::size_t>(s)];
    for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
      const Eigen::Index row = static_cast<Eigen::Index>(c) * n + s;
      const int channel = run.raw->channels[c];
      for (int j = 0; j < kStruts; ++j) {
        run.drive(row, j) *= physics::drive_compliance(forces, j, state.struts.length[j]);
        if (channel == 1 + j) run.drive(row, j) += forces.machine.lead_per_radian(j);
      }
      if (channel == kRadial) run.tip.row(row) = (state.pose.p_WT - ball).normalized().transpose();
    }
    // a force at the tip, or at the centre of mass: J^T t = (F, arm x F)
    const Vector3<double> arm = state.pose.R_WP * (centre_P - forces.machine.geometry.tool_tip_P);
    const machine::Lu6<double> lu(machine::jacobian(state.struts));
    for (int a = 0; a < 3; ++a) {
      machine::Vector6<double> load = machine::Vector6<double>::Zero();
      load[a] = 1;
      const machine::PerStrut<double> tension = lu.solve_transposed(load);
      load.tail<3>() = arm.cross(Vector3<double>(load.head<3>()));
      const machine::PerStrut<double> from_centre = lu.solve_transposed(load);
      for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
        const Eigen::Index row = static_cast<Eigen::Index>(c) * n + s;
        run.force(row, a) = run.drive.row(row).dot(tension);
        run.centre(row, a) = run.drive.row(row).dot(from_centre);
      }
    }
  }
  return run;
}

// The readings' change by one strut's (axis's) coefficient of a term, times cos or -sin of its wave.
Eigen::VectorXd change_by_part(const ReadyRun& run, const physics::MachineConstants& machine, const Term& term,
                               int part, bool sine) {
  const Eigen::Index n = run.raw->samples;
  const Eigen::Index rows = run.raw->residual.size();
  Eigen::VectorXd f(n);
  for (Eigen::Index s = 0; s < n; ++s) {
    const SampleState& state = run.states[static_cast<std::size_t>(s)];
    f[s] = product(shared_factors(state), term.shared_powers);
    if (!is_per_strut(term.channel)) continue;
    f[s] *= product(strut_factors(machine, state, part), term.strut_powers);
    if (term.pitch > 0) {
      const double turn = 2 * std::numbers::pi * state.struts.length[part] / term.pitch;
      f[s] *= sine ? -std::sin(turn) : std::cos(turn);
    }
  }
  const auto channels = static_cast<Eigen::Index>(run.raw->channels.size());
  const Eigen::VectorXd all = f.replicate(channels, 1);
  switch (term.channel) {
    case Channel::length:
      return run.raw->slopes.col(part).cwiseProduct(all);
    case Channel::drive:
      return run.drive.col(part).cwiseProduct(all);
    case Channel::force:
      return run.force.col(part).cwiseProduct(all);
    case Channel::centre:
      return run.centre.col(part).cwiseProduct(all);
    case Channel::tip:
      return run.tip.col(part).cwiseProduct(all);
    case Channel::torque:
      break;
  }
  Eigen::VectorXd torque = Eigen::VectorXd::Zero(rows);
  for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
    if (run.raw->channels[c] == 1 + part) torque.segment(static_cast<Eigen::Index>(c) * n, n) = f;
  }
  return torque;
}

}  // namespace

bool is_per_strut(Channel channel) {
  return channel == Channel::length || channel == Channel::drive || channel == Channel::torque;
}

std::array<double, physics::kStrutFactors> strut_factors(const physics::MachineConstants& machine, const SampleState& s,
                                                         int j) {
  const double tension = s.nut_tension[j] * 1e-3;
  const Vector3<double> u = s.struts.direction.col(j);
  return {(s.struts.length[j] - machine.middle_length[j]) * 10,
          s.speed[j] * 100,
          s.sign[j],
          tension,
          std::abs(tension),
          u.x(),
          u.y(),
          u.z()};
}

std::array<double, physics::kSharedFactors> shared_factors(const SampleState& s) {
  const Vector3<double>& x = s.pose.p_WT;
  const Vector3<double> z = s.pose.R_WP.col(2);
  return {x[0] * 10, x[1] * 10, (x[2] - physics::kMiddleHeight) * 10, z[0], z[1], s.time / 3600};
}

Eigen::MatrixXd slopes_of(const ReadyRun& run, Channel channel) {
  switch (channel) {
    case Channel::length:
      return run.raw->slopes;
    case Channel::drive:
      return run.drive;
    case Channel::force:
      return run.force;
    case Channel::centre:
      return run.centre;
    case Channel::tip:
      return run.tip;
    case Channel::torque:
      break;
  }
  Eigen::MatrixXd torque = Eigen::MatrixXd::Zero(run.raw->residual.size(), kStruts);
  for (int j = 0; j < kStruts; ++j) {
    if (const auto first = run.raw->first_row(1 + j)) torque.col(j).segment(*first, run.raw->samples).setOnes();
  }
  return torque;
}

std::vector<ReadyRun> ready_runs(const Workbench& bench, const physics::ForceModel& forces,
                                 const LinearProblem& problem) {
  std::vector<ReadyRun> runs(bench.runs.size());
  for_each_index(runs.size(), [&](std::size_t i) { runs[i] = ready_run(bench, forces, problem, i); });
  return runs;
}

Eigen::VectorXd change_by(const ReadyRun& run, const physics::MachineConstants& machine, const Term& term, bool sine) {
  if (term.part >= 0) return change_by_part(run, machine, term, term.part, sine);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(run.raw->residual.size());
  for (int j = 0; j < kStruts; ++j) all += change_by_part(run, machine, term, j, sine);
  return all;
}

}  // namespace plumbline::diagnose
