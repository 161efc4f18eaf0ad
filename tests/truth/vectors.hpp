// Small types that everything of the stand-in shares.
#pragma once

#include <array>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace truth {

inline constexpr double kMm = 1e-3;
inline constexpr double kDeg = M_PI / 180;

using Vec = Eigen::Vector3d;
using Rotation = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Six = std::array<double, 6>;

/// Where the platform stands: tool tip in the base frame, and its turning from there.
struct Stand {
  Vec x = Vec::Zero();
  Rotation R = Rotation::Identity();
};

}  // namespace truth
