#include "nc/control/state/handed_variables.hpp"

#include <algorithm>

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

const HandedVariable* HandedVariables::first(bool (*is)(const HandedVariable&)) const {
  const auto found = std::find_if(variables_.begin(), variables_.end(), [&](const auto& numbered) {
    return numbered.second.line != 0 && is(numbered.second);
  });
  return found == variables_.end() ? nullptr : &found->second;
}

const HandedVariable* HandedVariables::first() const {
  return first([](const HandedVariable& variable) { return variable.carried || !variable.read; });
}

const HandedVariable* HandedVariables::first_carried() const {
  return first([](const HandedVariable& variable) { return variable.carried; });
}

}  // namespace plumbline::nc
