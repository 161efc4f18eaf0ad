// Where a machine stands, and what its struts carry there: free bodies, moments about the origin of the base frame.
#pragma once

#include "truth/machine.hpp"

namespace truth {

/// A machine and what is wrong with it.
struct Truth {
  Machine machine;
  Flaws flaws;
};

/// One moment of a commanded motion, as the struts see it.
struct Moment {
  Stand commanded;
  Vec6 told;                           // lengths that the control asks for, m
  Vec6 speed, acceleration;            // of these lengths
  Vec6 sign;                           // which way friction pulls, from -1 to 1
  Eigen::Matrix<double, 3, 6> across;  // speed of each platform joint across its strut, m/s
  Vec tip_acceleration;
  double time = 0;     // on the dataset's clock, s
  double payload = 0;  // a known mass at the tip, kg
};

struct Loads {
  Vec6 tension;  // at the nut, N
  Vec6 drive;    // at the screw's drive, N
  Vec6 longer;   // than told, m
  Vec6 torque;   // as read, N m
};

/// Lengths of the struts of a machine that stands there; `believed`: as its control takes them to be.
Vec6 true_lengths(const Truth& truth, const Stand& at);
Vec6 believed_lengths(const Machine& machine, const Stand& at);

Loads loads(const Truth& truth, const Stand& at, const Moment& moment);

/// From a stand by a short way: translation, and turning about the base frame's axes.
Stand moved(const Stand& from, const Vec6& by);

/// A place where the machine stands, and how the misfit of its lengths changes as it is moved from there.
struct Standing {
  Stand at;
  Mat6 slopes;
};

/// What misses at a stand: true lengths less told ones less what the loads there add.
Vec6 misfit(const Truth& truth, const Stand& at, const Moment& moment);

/// Where the true machine stands. Throws std::runtime_error if nowhere.
Standing settled(const Truth& truth, const Moment& moment);

/// Where the tip's ball is, once what no strut does is added.
Vec tip_ball(const Truth& truth, const Stand& at, const Moment& moment);

}  // namespace truth
