// A program run on a machine that is not as its model: how far the tip is from the path that was meant.
#pragma once

#include <vector>

#include "truth/program.hpp"

namespace truth {

struct Played {
  double rms = 0;         // m, across the path that was meant
  double most = 0;        // m
  double probed_rms = 0;  // the same with the zero probed on the machine: the best constant shift taken out
  double probed_most = 0;
  int samples = 0;
};

/// When the path that was meant is nearest to a place, about a time.
double nearest(const Program& meant, const Vec& place, double about);

/// Plays `run` on a machine and looks every `step` seconds where its tip is beside the path of `meant`. What a tip is
/// late or early along its path does not count: it cuts nothing wrong.
Played play(const Truth& truth, const Program& meant, const Program& run, FrictionLaw law, double step);

/// The tip beside the place that the path has then, m.
struct Off {
  double time = 0;  // s of the path
  Vec off;
};

struct Offs {
  Vec zero;  // where the path begins, the machine at rest
  std::vector<Off> along;
};

/// Plays `run` and looks where its tip is beside the path of `meant`, every `step` seconds, in all three directions. A
/// lag of the drives is left out: it is late along the path. `at_rest`: a program whose begin is where a machine that
/// stands still is sent; the friction of a move is none of it.
Offs offs(const Truth& truth, const Program& meant, const Program& run, const Program& at_rest, FrictionLaw law,
          double step);

}  // namespace truth
