// What a control made of a program: strut lengths that it asked for period by period, played on a machine.
#pragma once

#include <string>
#include <vector>

#include "truth/program.hpp"

namespace truth {

/// One servo period of the control.
struct Period {
  Vec6 told;       // lengths that the control asks for, m
  int motion = 0;  // LinuxCNC's motion.motion-type: 0 none, 1 rapid, 2 straight, 3 arc
};

struct Recording {
  std::vector<Period> samples;
  double period = 0.001;  // s
};

/// Reads what halsampler -t prints: a counter, six lengths in mm, the motion type. Throws std::runtime_error where a
/// period is missing.
Recording read_recording(const std::string& path);

/// Where the tip of the machine is off the path that was meant, in each period in which the control cuts.
struct OffPath {
  double time = 0;  // s from the first sample
  double off = 0;   // m, to the nearest point of the path
};

struct Followed {
  std::vector<OffPath> cutting;
  double seconds = 0;  // from the first motion to the last, rapids included
  double most = 0;     // m
  double rms = 0;      // m
};

/// Plays the lengths on `truth`, `meant` being the path in W.
Followed follow(const Truth& truth, const Program& meant, const Recording& recording, FrictionLaw law);

}  // namespace truth
