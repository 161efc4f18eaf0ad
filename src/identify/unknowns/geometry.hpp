// The geometry of a machine as unknowns: where its joints are and how long its struts, and what of that moves nothing
// that is measured.
#pragma once

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
  enum class Kind { shift, turn, wider_ring, longer_struts };
  enum class Ring { base, platform };

  Kind kind = Kind::shift;
  Ring ring = Ring::base;     // of joints; of no meaning for struts
  int axis = 0;               // of W, along which the joints are shifted or about which they are turned: 0 is X
  Eigen::VectorXd direction;  // of the unknowns, SI: what each does in it
};

/// Shifts and turns of either ring of joints, its width, and all struts longer together.
std::vector<WholeMotion> whole_motions(const machine::Geometry& geometry, const Unknowns& unknowns);

/// How much of what is not known of a motion beforehand is left after the data: standard error over the prior's sigma
/// of the motion's share in the unknowns.
double left_of_prior(const WholeMotion& motion, const Unknowns& unknowns, const Eigen::MatrixXd& covariance);

}  // namespace plumbline::identify
