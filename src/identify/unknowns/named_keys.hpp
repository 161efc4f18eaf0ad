// Unknowns by the names that people write: keys of the model file and of effects.
#pragma once

#include <string>
#include <vector>

#include "identify/unknowns/unknowns.hpp"

namespace plumbline::identify {

/// All numbers of a key, "table.key" of the model file or "effect.key" of an effect; a mass or a compliance of all
/// struts as one. What is not among the unknowns yet is added, free. Returns their places in the list. Refuses with
/// identify-unknown-key.
std::vector<std::size_t> named_unknowns(Unknowns& unknowns, const std::string& name);

/// The names of the keys that a key of [uncertainty] says the sigma of.
std::vector<std::string> names_known_by(std::string_view uncertainty);

/// Nothing is known of these numbers beforehand.
void add_free(Unknowns& unknowns, const std::string& name);

}  // namespace plumbline::identify
