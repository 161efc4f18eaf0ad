// The values of a dialect's table, as they are asked for by key.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/check.hpp"
#include "nc/language/packed_table.hpp"

namespace plumbline::nc {

/// One table being read; every complaint names it. A table is part of the program: what is wrong with it is an
/// InternalError.
class TableValues {
 public:
  TableValues(std::string_view name, PackedValue root) : name_(name), root_(root) {}

  const PackedValue& root() const { return root_; }
  bool has(std::string_view key) const { return has(root_, key); }
  static bool has(const PackedValue& table, std::string_view key) { return table.find(key).has_value(); }

  [[noreturn]] void complain(std::string_view what) const { throw InternalError(fmt::format("{}: {}", name_, what)); }

  std::optional<PackedValue> value(const PackedValue& table, std::string_view key, PackedValue::Kind kind) const {
    const std::optional<PackedValue> found = table.find(key);
    if (found && found->kind() != kind) complain(fmt::format("'{}' is not of kind '{}'", key, static_cast<char>(kind)));
    return found;
  }

  std::string text(const PackedValue& table, std::string_view key) const {
    const std::optional<PackedValue> found = value(table, key, PackedValue::Kind::text);
    if (!found) complain(fmt::format("no text '{}'", key));
    return std::string(found->text());
  }

  double number(const PackedValue& table, std::string_view key, double fallback) const {
    const std::optional<PackedValue> found = value(table, key, PackedValue::Kind::number);
    return found ? found->number() : fallback;
  }

  bool flag(const PackedValue& table, std::string_view key) const {
    const std::optional<PackedValue> found = value(table, key, PackedValue::Kind::boolean);
    return found && found->flag();
  }

  PackedValue::Items list(std::string_view key) const {
    const std::optional<PackedValue> found = value(root_, key, PackedValue::Kind::array);
    if (!found) complain(fmt::format("no list '{}'", key));
    return found->items();
  }

  void texts(std::string_view key, std::vector<std::string>& into) const {
    if (!has(key)) return;
    for (const PackedValue item : list(key)) into.emplace_back(item.text());
  }

  // Sets the members of those keys that the table has.
  template <class Table, class Keys>
  void read_keys(const PackedValue& from, Table& table, const Keys& keys) const {
    for (const auto& key : keys) {
      if (!has(from, key.name)) continue;
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
  void check_keys(const PackedValue& from, std::initializer_list<std::string_view> others, const Keys&... keys) const {
    from.each_entry([&](std::string_view its_key, const PackedValue&) {
      const auto is_this = [&](const auto& key) { return key.name == its_key; };
      const bool known = std::find(others.begin(), others.end(), its_key) != others.end() ||
                         (std::any_of(std::begin(keys), std::end(keys), is_this) || ...);
      if (!known) complain(fmt::format("'{}' is no key", its_key));
    });
  }

 private:
  std::string_view name_;
  PackedValue root_;
};

}  // namespace plumbline::nc
