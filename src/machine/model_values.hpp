// The values of a model file by the table of machine/model_keys.hpp: each one present, of its shape, finite and in
// range.
#pragma once

#include <vector>

#include "machine/model.hpp"
#include "machine/model_keys.hpp"

namespace plumbline::machine {

/// Every key of kKeys, in SI, in its order. Refuses with model-marker, model-unknown-table, model-unknown-key,
/// model-missing-table, model-missing-key, model-wrong-type, model-wrong-size, model-not-finite, model-out-of-range or
/// model-not-whole.
std::vector<ModelValue> read_values(const TomlDocument& document);

/// "; if it was meant in m, write 1200" where another unit would bring the value into the range, else empty.
std::string slip_hint(const Unit& unit, double value, double lower, double upper, double least_nonzero = 0);

}  // namespace plumbline::machine
