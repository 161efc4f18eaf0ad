// The values of a dialect's table, as they are asked for by key.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/toml.hpp"

namespace plumbline::nc {

/// One table being read; every complaint names it. A table is part of the program: what is wrong with it is an
/// InternalError.
class TableValues {
 public:
  explicit TableValues(const TomlDocument& document) : document_(document) {}

  const TomlValue& root() const { return document_.root; }
  bool has(std::string_view key) const { return root().find(key) != nullptr; }

  [[noreturn]] void complain(std::string_view what) const {
    throw InternalError(fmt::format("{}: {}", document_.file, what));
  }

  const TomlValue* value(const TomlValue& table, std::string_view key, TomlValue::Kind kind) const {
    const TomlEntry* const entry = table.find(key);
    if (entry == nullptr) return nullptr;
    if (entry->value.kind != kind) complain(fmt::format("'{}' is no {}", key, name_of(kind)));
    return &entry->value;
  }

  std::string text(const TomlValue& table, std::string_view key) const {
    const TomlValue* const found = value(table, key, TomlValue::Kind::text);
    if (found == nullptr) complain(fmt::format("no text '{}'", key));
    return found->text;
  }

  double number(const TomlValue& table, std::string_view key, double fallback) const {
    const TomlValue* const found = value(table, key, TomlValue::Kind::number);
    return found == nullptr ? fallback : found->number;
  }

  bool flag(const TomlValue& table, std::string_view key) const {
    const TomlValue* const found = value(table, key, TomlValue::Kind::boolean);
    return found != nullptr && found->flag;
  }

  const std::vector<TomlValue>& list(std::string_view key) const {
    const TomlValue* const found = value(root(), key, TomlValue::Kind::array);
    if (found == nullptr) complain(fmt::format("no list '{}'", key));
    return found->items;
  }

  void texts(std::string_view key, std::vector<std::string>& into) const {
    if (root().find(key) == nullptr) return;
    for (const TomlValue& item : list(key)) into.push_back(item.text);
  }

  // Sets the members of those keys that the table has.
  template <class Table, class Keys>
  void read_keys(const TomlValue& from, Table& table, const Keys& keys) const {
    for (const auto& key : keys) {
      if (from.find(key.name) == nullptr) continue;
      auto& member = table.*key.member;
      using Member = std::remove_reference_t<decltype(member)>;
      if constexpr (std::is_same_v<Member, bool>) {
        member = flag(from, key.name);
      } else if constexpr (std::is_same_v<Member, char>) {
        member = text(from, key.name).at(0);
      } else if constexpr (std::is_same_v<Member, std::string>) {
        member = text(from, key.name);
      } else {
        member = static_cast<Member>(number(from, key.name, 0));
      }
    }
  }

  // A slip in a key would be a habit that the control does not have.
  template <class... Keys>
  void check_keys(const TomlValue& from, std::initializer_list<std::string_view> others, const Keys&... keys) const {
    for (const TomlEntry& entry : from.entries) {
      const auto is_this = [&](const auto& key) { return key.name == entry.key; };
      const bool known = std::find(others.begin(), others.end(), entry.key) != others.end() ||
                         (std::any_of(std::begin(keys), std::end(keys), is_this) || ...);
      if (!known) complain(fmt::format("'{}' is no key", entry.key));
    }
  }

 private:
  const TomlDocument& document_;
};

}  // namespace plumbline::nc
