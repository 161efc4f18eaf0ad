// Commanded motions, and the moments that the struts see of them: speeds and accelerations from short pieces of the
// path.
#pragma once

#include <functional>

#include "truth/statics.hpp"

namespace truth {

/// A circular test: one turn from angle zero at constant feed, the ball on the table below the circle's plane.
struct Circle {
  Vec centre{0, 0, 0};
  double radius = 0;
  double bar = 0;    // length, m; the radius for one that lies in the plane
  Vec abc{0, 0, 0};  // rad
  int turn = 1;      // +1 counter-clockwise
  double feed = 0;   // m/s
  double payload = 0;
  double start = 0;  // s on the dataset's clock

  double seconds() const { return 2 * M_PI * radius / feed; }
  Vec ball() const { return centre - Vec(0, 0, std::sqrt(bar * bar - radius * radius)); }
};

using Path = std::function<Stand(double seconds)>;

/// Rz(C) Ry(B) Rx(A), rad.
Rotation turned(const Vec& abc);
Stand commanded(const Circle& circle, double angle);
Path path_of(const Circle& circle);

/// How friction follows the speed of a strut.
enum class FrictionLaw {
  tanh,      // tanh(v / 0.02 mm/s)
  root,      // v / sqrt(v^2 + (0.02 mm/s)^2)
  dahl,      // turns over a few micrometres of travel, whatever the speed: it remembers where it came from
  stribeck,  // as dahl, and a seventh more at rest than above some mm/s
};

/// The moments of a motion in the order in which they are reached: some friction laws remember.
class Follower {
 public:
  /// `piece`: s, the path is differenced over so much before and after.
  Follower(const Machine& machine, Path path, double piece, FrictionLaw law);

  /// The moment at so many seconds from the start of the path; never before the one asked for last. `start` and
  /// `payload` are handed through.
  Moment at(double seconds, double start, double payload);

 private:
  void follow(double seconds);
  Vec6 told(double seconds) const;

  const Machine& machine_;
  Path path_;
  double piece_;
  FrictionLaw law_;
  bool started_ = false;
  double now_ = 0;
  Vec6 last_told_ = Vec6::Zero();
  Vec6 bristle_ = Vec6::Zero();
};

/// A reading of bar and motors.
struct Reading {
  double radial = 0;  // bar reading less the bar's length, m
  Six torque{};       // N m
};

/// What bar and motors read at a moment, ball and bar being as stated.
Reading reading_at(const Truth& truth, const Stand& at, const Moment& moment, const Vec& ball, double bar);

}  // namespace truth
