// The rows of codes of a dialect's table.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nc/language/dialect.hpp"
#include "nc/language/table_values.hpp"

namespace plumbline::nc {

/// A bit for each letter.
std::uint32_t letter_mask(std::string_view letters);

class TableRows {
 public:
  explicit TableRows(const TableValues& table) : table_(table) {}

  /// Whether the order of execution names it.
  bool has_turn(std::string_view name) const;
  /// A row for what has no code: F, S, T.
  CodeRow turn(std::string_view name, Action action) const;
  /// All rows of a key, by code, and where each code stands among them.
  void rows(std::string_view key, std::vector<CodeRow>& into, std::vector<std::int16_t>& places) const;
  /// Codes that are called by name.
  void named_rows(Dialect& dialect) const;
  /// Words of the control that are not interpreted: each a row that is refused.
  void reserved_rows(Dialect& dialect) const;
  /// The row of a code that is in force at the start, "G17".
  CodeRow start_row(const Dialect& dialect, const std::string& code) const;

 private:
  std::uint8_t step(std::string_view name) const;
  std::optional<std::uint8_t> step_of(std::string_view name) const;
  CodeRow row(const PackedValue& from, bool has_number = true) const;

  const TableValues& table_;
};

}  // namespace plumbline::nc
