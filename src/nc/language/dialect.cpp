#include "nc/language/dialect.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/dialect_list.hpp"
#include "nc/language/dialect_table.hpp"

namespace plumbline::nc {
namespace {

constexpr double kLargestCode = 1e6;  // in tenths: more than any dialect has

const CodeRow* row_at(const std::vector<CodeRow>& rows, const std::vector<std::int16_t>& places, int code) {
  if (code < 0 || static_cast<std::size_t>(code) >= places.size()) return nullptr;
  const std::int16_t at = places[static_cast<std::size_t>(code)];
  return at < 0 ? nullptr : &rows[static_cast<std::size_t>(at)];
}

std::string text_of_code(const CodeRow& row) {
  return row.code % 10 == 0 ? fmt::format("G{}", row.code / 10) : fmt::format("G{}.{}", row.code / 10, row.code % 10);
}

}  // namespace

const CodeRow* Dialect::g_code(int times_ten) const { return row_at(g_codes, g_index, times_ten); }
const CodeRow* Dialect::m_code(int times_ten) const { return row_at(m_codes, m_index, times_ten); }

const CodeRow* Dialect::row_of_code(const Word& word) const {
  if (word.letter == kNamedCode) return &named_codes[static_cast<std::size_t>(word.value)];
  const double tenths = word.value * 10;
  const bool small = std::abs(tenths) < kLargestCode;
  const int code = static_cast<int>(small ? nearest_whole(tenths) : std::lround(tenths));
  return word.letter == 'G' ? g_code(code) : m_code(code);
}

std::string_view CodeRow::reason() const { return std::string_view(why).substr(0, why.find("; ")); }

std::string_view CodeRow::way_out() const {
  const std::size_t end = why.find("; ");
  return end == std::string::npos ? std::string_view() : std::string_view(why).substr(end + 2);
}

const NameMeaning* Dialect::meaning(std::string_view text) const {
  std::string found = upper(text);
  auto at = syntax.meanings.find(found);
  if (at == syntax.meanings.end() && !found.empty() && is_digit(found.back())) {  // CYCLE* stands for CYCLE495
    while (!found.empty() && is_digit(found.back())) found.pop_back();
    at = syntax.meanings.find(found + '*');
  }
  return at == syntax.meanings.end() ? nullptr : &at->second;
}

std::string Dialect::name_of_system(int system) const {
  for (const CodeRow& row : g_codes) {
    if (row.action == Action::work_system && row.value == system) return text_of_code(row);
  }
  for (const CodeRow& row : g_codes) {
    if (row.action != Action::work_system_by_word || system <= row.value) continue;
    return fmt::format("{} {}{}", text_of_code(row), row.words, system - row.value);
  }
  return fmt::format("work system {}", system);
}

int Dialect::system_of_name(std::string_view text) const {
  for (int system = 1; system <= work_systems; ++system) {
    std::string known = name_of_system(system);
    known.erase(std::remove(known.begin(), known.end(), ' '), known.end());
    if (known == text) return system;
  }
  // G154P2 is another name of G54.1P2.
  for (const CodeRow& row : g_codes) {
    const std::string code = text_of_code(row) + row.words;
    if (row.action != Action::work_system_by_word || !text.starts_with(code)) continue;
    const std::optional<double> number = parse_number(text.substr(code.size()));
    if (number && *number >= 1 && *number <= work_systems - row.value && *number == std::floor(*number)) {
      return row.value + static_cast<int>(*number);
    }
  }
  return 0;
}

std::span<const std::string_view> dialect_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const EmbeddedTable& table : embedded_tables()) all.push_back(table.name);
    return all;
  }();
  return names;
}

std::string dialect_list() {
  const std::span<const std::string_view> names = dialect_names();
  return fmt::format("{} or {}", fmt::join(names.first(names.size() - 1), ", "), names.back());
}

namespace {

// What is read of a table, each when it is asked for.
struct ReadTable {
  std::once_flag once, marks_once;
  Dialect dialect;
  DialectMarks marks;
};

std::pair<const EmbeddedTable&, ReadTable&> table_of(std::string_view name) {
  const std::span<const EmbeddedTable> tables = embedded_tables();
  static std::vector<ReadTable> read(tables.size());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (tables[i].name == name) return {tables[i], read[i]};
  }
  refuse(codes::kUnknownDialect, fmt::format("no dialect is named '{}'", name),
         fmt::format("there are: {}", fmt::join(dialect_names(), ", ")));
}

std::string file_of(const EmbeddedTable& table) { return fmt::format("grammar/{}.toml", table.name); }

}  // namespace

const Dialect& dialect(std::string_view name) {
  const auto [table, read] = table_of(name);
  std::call_once(read.once,
                 [&table = table, &read = read] { read.dialect = read_dialect(file_of(table), *table.packed); });
  return read.dialect;
}

const DialectMarks& marks_of_dialect(std::string_view name) {
  const auto [table, read] = table_of(name);
  std::call_once(read.marks_once,
                 [&table = table, &read = read] { read.marks = read_marks(file_of(table), *table.packed); });
  return read.marks;
}

double largest_inverse_feed(const ControlBehaviour& behaviour) {
  const double least = behaviour.inverse_time_increment;
  return least > 0 ? std::pow(10, behaviour.most_digits - 1) * least - least : 0;  // 9999.999 of 0.001
}

}  // namespace plumbline::nc
