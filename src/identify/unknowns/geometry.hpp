// The geometry of a machine as unknowns: where its joints are and how long its struts, and what of that moves nothing
// that is measured.
#pragma once

#include <string>
#include <vector>

#include "identify/unknowns/unknowns.hpp"

namespace plumbline::identify {

struct GeometryOptions {
  double joint_sigma = 1e-3;   // m, of a joint's coordinate where [uncertainty] does not list joint_position_um
  double offset_sigma = 1e-3;  // m, of a strut's length where it does not list strut_offset_um
  bool alone = false;          // everything else counts as exact
};

/// Whether it is a coordinate of a joint or an offset of a strut.
bool is_geometry(const Unknown& unknown);

/// The 36 coordinates of the joints and 6 offsets of the struts, with the priors of [uncertainty] or those of the
/// options, beside all else that [uncertainty] lists.
Unknowns geometry_unknowns(const machine::MachineModel& machine, const physics::ForceModel& forces,
                           const GeometryOptions& options = {});

/// A motion of the geometry as a whole.
struct WholeMotion {
  std::string name;           // "a shift of the base joints along X"
  Eigen::VectorXd direction;  // of the unknowns, SI: what each does in it
};

/// Shifts and turns of either ring of joints, its width, and all struts longer together.
std::vector<WholeMotion> whole_motions(const machine::Geometry& geometry, const Unknowns& unknowns);

/// How much of what is not known of a motion beforehand is left after the data: standard error over the prior's sigma
/// of the motion's share in the unknowns.
double left_of_prior(const WholeMotion& motion, const Unknowns& unknowns, const Eigen::MatrixXd& covariance);

/// In words: how many directions of the geometry the data tell, and which motions as a whole they do not show (more
/// than `little` of the prior left). Empty if the geometry is not among the unknowns.
std::vector<std::string> geometry_statements(const machine::Geometry& geometry, const Unknowns& unknowns,
                                             const Eigen::MatrixXd& covariance, double little = 0.9);

}  // namespace plumbline::identify
