// A model file with new values: the old text, byte for byte, but for the numbers that changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/model.hpp"
#include "physics/force_model.hpp"

namespace plumbline::identify {

/// Joints as the controller is to believe them, m.
struct BelievedJoints {
  machine::StrutVectors<double> base_W, platform_P;
};

/// The posterior beside a model.
struct PosteriorName {
  std::string file;  // seen from the model
  std::string hash;  // of its text
};

struct ModelChanges {
  const physics::ForceModel& forces;     // made from that model, its parameters changed, effects added
  std::vector<double> resolution;        // of each parameter, SI: how far it may be rounded; empty: nine digits of each
  std::string provenance;                // is appended to the model's provenance
  std::vector<std::string> notes;        // lines of a comment at the end of the file
  std::optional<BelievedJoints> joints;  // in place of the file's
  std::optional<PosteriorName> posterior = std::nullopt;  // nothing: what the file says of another one is made empty
};

/// The text of `machine` with the parameters of `changes`: numbers that differ are spliced into their places, keys that
/// the file left out are added to their tables, effects that it does not name are added as [[effect]] rows at its end
/// (unless they change nothing). Comments, order and all else stay, but that a number which
/// a comment calls assumed is called fitted. What a reader of models would take for a slip of
/// units (a friction of 0.05 N) becomes zero.
std::string model_text(const machine::MachineModel& machine, const ModelChanges& changes);

}  // namespace plumbline::identify
