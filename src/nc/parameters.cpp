#include "nc/parameters.hpp"

namespace plumbline::nc {

std::string_view Parameters::plain(std::string_view name) {
  plain_.clear();
  for (const char c : name) {
    if (c == ' ' || c == '\t' || c == '\r') continue;
    plain_ += c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  }
  return plain_;
}

const Value* Parameters::find(std::string_view name) {
  const auto at = named_.find(plain(name));
  return at == named_.end() ? nullptr : &at->second;
}

void Parameters::set(std::string_view name, Value value) {
  const auto at = named_.find(plain(name));
  if (at != named_.end()) {
    at->second = value;
  } else {
    named_.emplace(plain_, value);
  }
}

}  // namespace plumbline::nc
