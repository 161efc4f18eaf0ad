// The [[effect]] rows of a model file, as they stand: names, keys and numbers in the file's units.
#pragma once

#include <vector>

#include "machine/model.hpp"

namespace plumbline::machine {

/// All rows in the order of the file. Refuses with model-effect-row, model-missing-key, model-wrong-type,
/// model-wrong-size or model-not-finite.
std::vector<EffectRow> read_effect_rows(const TomlDocument& document);

}  // namespace plumbline::machine
