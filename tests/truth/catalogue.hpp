// The stand-in's own list of effects: what each is called in files, how large it may be, and how one is drawn.
#pragma once

#include <string>
#include <vector>

#include "truth/statics.hpp"

namespace truth {

/// One key of an effect, as model files write it.
struct Key {
  std::string name;
  double unit = 1;               // SI = file x unit
  double upper = 0;              // in the file's unit; what can be negative goes down to its opposite
  std::vector<double*> numbers;  // in the flaws that were asked for
  bool points = false;           // six arrays of three
};

struct Effect {
  std::string name;
  std::vector<Key> keys;
};

/// The 24 effects of the first shelf; those of the second; those that no catalogue has.
const std::vector<std::string>& first_shelf();
const std::vector<std::string>& second_shelf();
const std::vector<std::string>& outside_effects();

/// The keys of an effect, pointing into `flaws`. Throws std::runtime_error if there is none of that name.
Effect effect_in(Flaws& flaws, const std::string& name);

/// The shape of an effect, drawn: numbers as large as they may become, per-strut ones on all struts or on one.
/// What stays fixed as it is scaled (a phase, a speed) comes out as it will be.
Flaws drawn_flaws(const std::string& name, Random& random);

/// That effect at a share of its size.
Flaws scaled(const Flaws& flaws, const std::string& name, double share);

/// The directions in which an effect of the catalogue can go from none, as flaws that are small.
std::vector<Flaws> directions(const std::string& name);

}  // namespace truth
