#include "nc/control/state/handed_variables.hpp"

#include <algorithm>

namespace plumbline::nc {

void HandedVariables::note_read(int number) {
  HandedVariable& variable = variables_[number];
  (variable.line == 0 ? variable.carried : variable.read) = true;
}

void HandedVariables::note(HandedVariable& variable, std::string_view name, std::size_t line, Value value) {
  variable.value = value;
  variable.counted_to.reset();
  if (variable.line != 0) return;
  variable.name = name;
  variable.line = line;
}

void HandedVariables::note_set(int number, std::string_view spelt, std::size_t line, Value value) {
  note(variables_[number], spelt, line, value);
}

void HandedVariables::note_set(std::string_view name, std::size_t line, Value value) {
  const auto known = named_.find(name);
  note(known != named_.end() ? known->second : named_[std::string(name)], name, line, value);
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

std::vector<std::pair<int, const HandedVariable*>> HandedVariables::set() const {
  std::vector<std::pair<int, const HandedVariable*>> all;
  for (const auto& [name, variable] : named_) all.emplace_back(0, &variable);
  for (const auto& [number, variable] : variables_) {
    if (variable.line != 0) all.emplace_back(number, &variable);
  }
  return all;
}

}  // namespace plumbline::nc
