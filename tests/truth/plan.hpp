// Plans of circular tests, and what a machine reads on them.
#pragma once

#include <string>
#include <vector>

#include "truth/motion.hpp"
#include "truth/program.hpp"

namespace truth {

struct PlannedRun {
  std::string id;
  Circle circle;
  int samples = 120;  // over the turn
};
using Plan = std::vector<PlannedRun>;

/// Eight poses both ways, three of them fast, two with 20 kg, two again when warm: 26 runs.
Plan eight_poses(int samples);
/// Conditions A and B of Table 2 of Ibaraki et al.: two tilts, counter-clockwise, F1000.
Plan paper(int samples);
/// Other poses, feeds and directions, to look at what was found.
Plan holdout(int samples);
/// The circles of Fig. 8 and 9: seven tilts at one place, and a place with two.
Plan figures(int samples);
/// By name: eight-pose, paper, figures. Throws std::runtime_error for another.
Plan plan_of(const std::string& name, int samples);

/// Circles of the plans' radius and bar, one after the other: X,Y,Z,A,B,C,ccw,FEED,PAYLOAD in mm, deg, mm/min, kg each.
/// Throws std::runtime_error for another text.
Plan circles_of(const std::vector<std::string>& texts, int samples);

/// Moments of a run, where the machine stands at each, and what it reads there.
struct Sample {
  double seconds = 0;  // from the start of the run
  double angle = 0;    // commanded, rad from 0 to 2 pi
  Moment moment;
  Standing standing;
  Reading reading;
};
using Samples = std::vector<Sample>;

/// On a program in place of the circle itself.
Samples measured_on(const Truth& truth, const PlannedRun& run, const Program& program, FrictionLaw law,
                    const Vec& ball_off, double bar_off);
Samples measured(const Truth& truth, const PlannedRun& run, FrictionLaw law, const Vec& ball_off, double bar_off);

}  // namespace truth
