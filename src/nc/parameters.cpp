#include "nc/parameters.hpp"

#include <algorithm>
#include <utility>

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
  plain(name);
  const Names& names = scope_of(plain_);
  const auto at = names.find(plain_);
  return at == names.end() ? nullptr : &at->second;
}

void Parameters::set(std::string_view name, Value value) {
  plain(name);
  Names& names = scope_of(plain_);
  const auto at = names.find(plain_);
  if (at != names.end()) {
    at->second = value;
  } else {
    names.emplace(plain_, value);
  }
}

void Parameters::enter(bool numbers) {
  Scope scope;
  if (numbers) {
    scope.callers.assign(numbered_.begin() + 1, numbered_.begin() + 1 + kLocalParameters);
    std::fill_n(numbered_.begin() + 1, kLocalParameters, Numbered{{}, true});
  }
  scopes_.push_back(std::move(scope));
}

void Parameters::enter_with_own(int count) {
  Scope scope;
  scope.callers.assign(numbered_.begin() + 1, numbered_.begin() + 1 + count);
  std::fill_n(numbered_.begin() + 1, count, Numbered{});
  scopes_.push_back(std::move(scope));
}

void Parameters::enter_sharing() {
  scopes_.emplace_back();
  scopes_.back().shared = true;
}

bool Parameters::was_local_elsewhere(std::string_view name) {
  plain(name);
  return left_.contains(plain_) ||
         std::any_of(scopes_.begin(), scopes_.end(), [&](const Scope& scope) { return scope.names.contains(plain_); });
}

void Parameters::leave() {
  for (const auto& [name, value] : scopes_.back().names) left_.insert(name);
  std::copy(scopes_.back().callers.begin(), scopes_.back().callers.end(), numbered_.begin() + 1);
  scopes_.pop_back();
}

}  // namespace plumbline::nc
