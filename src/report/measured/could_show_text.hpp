// What runs can show of each effect, for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "diagnose/evidence/visible.hpp"

namespace plumbline::report {

/// What so many runs tell nothing of, and from which sizes on they name the others with 95 %: a line each. `planned`:
/// they are yet to be measured.
std::string could_show_text(const std::vector<diagnose::Visible>& visible, std::size_t runs, bool planned = false);

/// `[{"name", "shows", "key", "smallest"}]`
nlohmann::ordered_json could_show_json(const std::vector<diagnose::Visible>& visible);

}  // namespace plumbline::report
