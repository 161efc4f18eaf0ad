// The narrowest ring that holds a profile.
#pragma once

#include <Eigen/Core>

namespace plumbline::measure {

struct Zone {
  double x = 0;  // of the rings' common centre
  double y = 0;
  double inner = 0;  // radial deviations of the two rings
  double outer = 0;
  double width() const { return outer - inner; }
};

/// The centre (x, y) for which outer - inner is least, with inner <= r_i - x cos phi_i - y sin phi_i <= outer for every
/// reading r_i at angle phi_i (rad): the minimum-zone reference circles of ISO 230-4, for deviations far below the
/// radius (limacon). Exact: the optimum of the linear program, by the dual simplex method. At least 3 different angles.
Zone minimum_zone(const Eigen::VectorXd& angle, const Eigen::VectorXd& reading);

}  // namespace plumbline::measure
