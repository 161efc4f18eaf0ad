// Where a model puts the tip, over the poses that were measured: how far it is from where another model has it, and how
// it moves with each unknown.
#pragma once

#include <vector>

#include "identify/unknowns/unknowns.hpp"
#include "measure/dataset.hpp"

namespace plumbline::identify {

/// Three rows (x, y, z in W, m) for each place, all divided by the root of how many places there are: the norm of a
/// column is an rms.
struct TipField {
  Eigen::VectorXd moved;   // from where the tip stands with the model as given to where it stands at `values`
  Eigen::MatrixXd slopes;  // of the tip at `values`, a column for each unknown, per SI unit
  std::vector<Eigen::Index> at_pose;  // how many of the places, in their order, lie about each pose

  Eigen::Index places() const { return moved.size() / 3; }
};

/// Which places.
struct TipFieldOptions {
  std::size_t most_circles = 16;  // of the poses measured, evenly among them where there are more
  std::size_t angles = 12;        // of each circle
  std::size_t tilts = 4;          // at each circle: its own and those of others, as parts are tilted anywhere
  double middle = 0.5;            // how far from the middle of what was measured, as a share: parts are set up there
};

/// Places in the middle of what `runs` measured, where parts are set up: on their circles, each with its own tilt and
/// with those of others, all of it nearer to the middle. As `compensate` has it: at the feed of the
/// run, no inertia and no following error, at time zero. Places that the machine cannot reach are left out.
TipField tip_field(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                   const physics::ForceModel& given, const Unknowns& unknowns, const Eigen::VectorXd& values,
                   const TipFieldOptions& options = {});

/// The same without the mean over all places: what is left once the zero was touched off on the machine.
TipField touched_off(TipField field);

/// The places about each pose, as a field of its own: a part that is set up there.
std::vector<TipField> parts_of(const TipField& field);

}  // namespace plumbline::identify
