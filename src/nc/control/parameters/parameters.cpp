#include "nc/control/parameters/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::nc {
namespace {

bool differs(const Value& a, const Value& b) {
  return a.number != b.number || a.known != b.known || a.vacant != b.vacant;
}

}  // namespace

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

// From REAL to INT what is 0.5 or more is rounded up, the rest down; any value but 0 is TRUE [6FC5398-2BP40-0BA0 p.
// 54].
Value Parameters::converted(Value value) {
  const Scope& scope = owner();
  const auto type = scope.types.find(plain_);
  if (type == scope.types.end() || !value.known || value.vacant) return value;
  value.number = type->second == VariableType::whole ? std::round(value.number) : value.number != 0 ? 1 : 0;
  return value;
}

void Parameters::declare(std::string_view name, VariableType type) {
  plain(name);
  if (type != VariableType::real) owner().types[plain_] = type;
}

bool Parameters::declare_once(std::string_view name, std::uint64_t place) {
  plain(name);
  const auto [at, made] = owner().declared.emplace(plain_, place);
  return made || at->second == place;
}

bool Parameters::is_whole(std::string_view name) {
  const auto& types = owner().types;
  if (types.empty()) return false;
  plain(name);
  const auto type = types.find(plain_);
  return type != types.end() && type->second == VariableType::whole;
}

bool Parameters::numbers_are_of_main() const {
  return std::all_of(scopes_.begin() + 1, scopes_.end(), [](const Scope& scope) { return scope.shared; });
}

void Parameters::set(int number, Value value) {
  Numbered& now = numbered(number);
  if (!now.set || differs(now.value, value)) ++changes_;
  now = {value, true};
}

void Parameters::set(std::string_view name, Value value) {
  plain(name);
  value = converted(value);
  owner().left_over.erase(plain_);
  if (watches_) last_set_[plain_] = {value};
  Names& names = scope_of(plain_);
  const auto at = names.find(plain_);
  if (at == names.end() || differs(at->second, value)) ++changes_;
  if (at != names.end()) {
    at->second = value;
  } else {
    names.emplace(plain_, value);
  }
}

void Parameters::enter(LocalNumbers numbers) {
  Scope scope;
  if (numbers == LocalNumbers::own) {
    scope.callers.assign(locals(), locals() + kLocalParameters);
    std::fill_n(locals(), kLocalParameters, Numbered{{}, true});
  }
  scopes_.push_back(std::move(scope));
}

void Parameters::enter_with_own(int count) {
  Scope scope;
  scope.callers.assign(locals(), locals() + count);
  std::fill_n(locals(), count, Numbered{});
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

void Parameters::remember_begin() {
  Scope& scope = scopes_.back();
  if (scope.shared) return;
  scope.first.assign(locals(), locals() + static_cast<std::ptrdiff_t>(scope.callers.size()));
  scope.first_names = scope.names;
}

void Parameters::begin_again() {
  Scope& scope = scopes_.back();
  if (scope.shared) return;
  auto now = locals();
  for (const Numbered& first : scope.first) {
    now->left_over = now->set != first.set || differs(now->value, first.value);
    ++now;
  }
  for (const auto& [name, value] : scope.names) {
    const auto first = scope.first_names.find(name);
    if (first == scope.first_names.end() || differs(value, first->second)) scope.left_over.insert(name);
  }
}

bool Parameters::is_left_over(std::string_view name) {
  const auto& left_over = owner().left_over;
  if (left_over.empty()) return false;
  plain(name);
  return left_over.contains(plain_);
}

void Parameters::forget_own_names() {
  for (const auto& [name, value] : scopes_.back().names) left_.insert(name);
  scopes_.back().names.clear();
}

bool Parameters::depends_on_scope(std::string_view name) {
  if (!watches_) return false;
  plain(name);
  const auto last = last_set_.find(plain_);
  if (last == last_set_.end()) return false;
  const Names& own = scope_of(plain_);
  const auto here = own.find(plain_);
  return here == own.end() ? !last->second.ended : differs(here->second, last->second.value);
}

void Parameters::note_argument(std::string_view name) {
  if (!watches_) return;
  plain(name);
  last_set_[plain_].argument_of = depth();
}

void Parameters::leave() {
  for (auto& [name, last] : last_set_) last.ended = last.ended || (last.argument_of > 0 && last.argument_of >= depth());
  forget_own_names();
  std::copy(scopes_.back().callers.begin(), scopes_.back().callers.end(), locals());
  scopes_.pop_back();
}

}  // namespace plumbline::nc
