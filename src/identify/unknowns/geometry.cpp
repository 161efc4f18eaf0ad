#include "identify/unknowns/geometry.hpp"

#include <cmath>
#include <utility>

namespace plumbline::identify {
namespace {

using machine::kStruts;
using machine::StrutVectors;
using physics::JointPosition;
using physics::StrutOffset;

// Adds what is not listed already, and gives it a prior.
void complete(Unknowns& unknowns, std::string_view effect, const char* key, int count, double sigma) {
  for (int i = 0; i < count; ++i) {
    if (unknowns.find(effect, key, i) < 0) unknowns.set_prior(unknowns.add(effect, key, i), sigma);
  }
}

// How each joint of a ring moves with the motion, as a direction of the unknowns.
WholeMotion of_ring(WholeMotion motion, const char* key, const StrutVectors<double>& moves, const Unknowns& unknowns) {
  motion.direction = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
  for (int i = 0; i < 3 * kStruts; ++i) {
    const int place = unknowns.find(JointPosition::name, key, i);
    if (place >= 0) motion.direction[place] = moves(i % 3, i / 3);
  }
  return motion;
}

void add_ring(std::vector<WholeMotion>& motions, WholeMotion::Ring ring, const char* key,
              const StrutVectors<double>& joints, const Vector3<double>& centre, const Unknowns& unknowns) {
  using Kind = WholeMotion::Kind;
  const StrutVectors<double> arms = joints.colwise() - centre;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3<double> e = Vector3<double>::Unit(axis);
    StrutVectors<double> shift;
    StrutVectors<double> turn;
    for (int j = 0; j < kStruts; ++j) {
      shift.col(j) = e;
      turn.col(j) = e.cross(arms.col(j));
    }
    motions.push_back(of_ring({Kind::shift, ring, axis, {}}, key, shift, unknowns));
    motions.push_back(of_ring({Kind::turn, ring, axis, {}}, key, turn, unknowns));
  }
  StrutVectors<double> wider = arms;
  wider.row(2).setZero();
  motions.push_back(of_ring({Kind::wider_ring, ring, 0, {}}, key, wider, unknowns));
}

}  // namespace

bool is_geometry(const Unknown& unknown) {
  return physics::effect_infos()[physics::effect_index(unknown.effect)].geometry;
}

Unknowns geometry_unknowns(const machine::MachineModel& machine, const physics::ForceModel& forces,
                           const GeometryOptions& options) {
  const auto sigma = [&](const char* key, double otherwise) {
    const double listed = machine.uncertainty(key).value_or(0);
    return listed > 0 ? listed : otherwise;
  };
  Unknowns unknowns = options.alone ? Unknowns(forces) : nuisances(machine, forces);
  const double joint = sigma("joint_position_um", options.joint_sigma);
  complete(unknowns, StrutOffset::name, "length_um", kStruts, sigma("strut_offset_um", options.offset_sigma));
  complete(unknowns, JointPosition::name, "base_um", 3 * kStruts, joint);
  complete(unknowns, JointPosition::name, "platform_um", 3 * kStruts, joint);
  return unknowns;
}

std::vector<WholeMotion> whole_motions(const machine::Geometry& geometry, const Unknowns& unknowns) {
  std::vector<WholeMotion> motions;
  if (!unknowns.of_effect(JointPosition::name).empty()) {
    add_ring(motions, WholeMotion::Ring::base, "base_um", geometry.base_joints_W,
             geometry.base_joints_W.rowwise().mean(), unknowns);
    add_ring(motions, WholeMotion::Ring::platform, "platform_um", geometry.platform_joints_P, geometry.tool_tip_P,
             unknowns);
  }
  const std::vector<std::size_t> offsets = unknowns.of_effect(StrutOffset::name);
  if (!offsets.empty()) {
    WholeMotion longer{
        WholeMotion::Kind::longer_struts, {}, 0, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()))};
    for (const std::size_t i : offsets) longer.direction[static_cast<Eigen::Index>(i)] = 1;
    motions.push_back(std::move(longer));
  }
  return motions;
}

double left_of_prior(const WholeMotion& motion, const Unknowns& unknowns, const Eigen::MatrixXd& covariance) {
  // the motion's share by least squares in units of the priors: weights direction / sigma^2
  std::vector<Eigen::Index> moved;
  for (Eigen::Index i = 0; i < motion.direction.size(); ++i) {
    if (motion.direction[i] == 0) continue;
    if (unknowns[static_cast<std::size_t>(i)].free()) return 0;  // nothing was known of it
    moved.push_back(i);
  }
  Eigen::VectorXd weights = motion.direction(moved);
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const double sigma = unknowns[static_cast<std::size_t>(moved[k])].sigma;
    weights[static_cast<Eigen::Index>(k)] /= sigma * sigma;
  }
  const double before = weights.dot(motion.direction(moved));
  return before > 0 ? std::sqrt(weights.dot(covariance(moved, moved) * weights) / before) : 0;
}

}  // namespace plumbline::identify
