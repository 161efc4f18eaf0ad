#include "nc/control/state/handed_variables.hpp"

namespace plumbline::nc {

void HandedVariables::note_read(int number) {
  HandedVariable& variable = variables_[number];
  (variable.line == 0 ? variable.carried : variable.read) = true;
}

void HandedVariables::note_set(int number, std::string_view name, std::size_t line) {
  HandedVariable& variable = variables_[number];
  if (variable.line != 0) return;
  variable.name = name;
  variable.line = line;
}

const HandedVariable* HandedVariables::first() const {
  for (const auto& [number, variable] : variables_) {
    if (variable.line != 0 && (variable.carried || !variable.read)) return &variable;
  }
  return nullptr;
}

const HandedVariable* HandedVariables::first_carried() const {
  for (const auto& [number, variable] : variables_) {
    if (variable.line != 0 && variable.carried) return &variable;
  }
  return nullptr;
}

}  // namespace plumbline::nc
