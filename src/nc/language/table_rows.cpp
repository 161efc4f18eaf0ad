#include "nc/language/table_rows.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "nc/language/block_words.hpp"
#include "nc/language/dialect_names.hpp"

namespace plumbline::nc {

std::uint32_t letter_mask(std::string_view letters) {
  std::uint32_t bits = 0;
  for (const char c : letters) bits |= letter_bit(c);
  return bits;
}

bool TableRows::has_turn(std::string_view name) const { return step_of(name).has_value(); }

CodeRow TableRows::turn(std::string_view name, Action action) const {
  CodeRow row;
  row.action = action;
  row.step = step(name);
  return row;
}

void TableRows::rows(std::string_view key, std::vector<CodeRow>& into, std::vector<std::int16_t>& places) const {
  for (const PackedValue from : table_.list(key)) {
    into.push_back(row(from));
    if (!TableValues::has(from, "last")) continue;
    const int last = static_cast<int>(std::lround(parse_number(table_.text(from, "last")).value_or(-1) * 10));
    for (int code = into.back().code + 10; code <= last; code += 10) {  // a row for each whole number up to there
      CodeRow next = into.back();
      next.code = code;
      ++next.value;
      into.push_back(std::move(next));
    }
  }
  std::sort(into.begin(), into.end(), [](const CodeRow& a, const CodeRow& b) { return a.code < b.code; });
  places.assign(into.empty() ? 0 : static_cast<std::size_t>(into.back().code) + 1, -1);
  for (std::size_t i = 0; i < into.size(); ++i) {
    std::int16_t& place = places[static_cast<std::size_t>(into[i].code)];
    if (place >= 0) table_.complain(fmt::format("two rows of '{}' for {}", key, into[i].code / 10.0));
    place = static_cast<std::int16_t>(i);
  }
}

void TableRows::named_rows(Dialect& dialect) const {
  for (const PackedValue from : table_.list("names")) {
    CodeRow named_code = row(from, false);
    named_code.name = table_.text(from, "code");
    const int place = static_cast<int>(dialect.named_codes.size());
    dialect.syntax.meanings[named_code.name] = {NameMeaning::Kind::code, place, 0, 0};
    dialect.named_codes.push_back(std::move(named_code));
  }
}

void TableRows::reserved_rows(Dialect& dialect) const {
  for (const PackedValue from : table_.list("reserved")) {
    CodeRow word = turn("motion", Action::refused);
    word.group = -1;
    word.order = Order::with_motion;
    word.meaning = "refused";
    word.has_arguments = true;
    word.why = table_.text(from, "why");
    std::istringstream names(table_.text(from, "words"));
    while (names >> word.name) {
      const int place = static_cast<int>(dialect.named_codes.size());
      const NameMeaning meaning{NameMeaning::Kind::code, place, 0, 0};
      if (!dialect.syntax.meanings.emplace(word.name, meaning).second) {
        table_.complain(fmt::format("'reserved' holds {}, which has a meaning", word.name));
      }
      dialect.named_codes.push_back(word);
    }
  }
}

CodeRow TableRows::start_row(const Dialect& dialect, const std::string& code) const {
  const int times_ten = static_cast<int>(std::lround(parse_number(code.substr(1)).value_or(-1) * 10));
  const CodeRow* const found = dialect.g_code(times_ten);
  if (found == nullptr) table_.complain(fmt::format("'at_start' names {}, which is no code", code));
  return *found;
}

std::uint8_t TableRows::step(std::string_view name) const {
  const std::optional<std::uint8_t> step = step_of(name);
  if (!step) table_.complain(fmt::format("'{}' has no turn in 'execution'", name));
  return *step;
}

std::optional<std::uint8_t> TableRows::step_of(std::string_view name) const {
  std::uint8_t step = 0;
  for (const PackedValue entry : table_.list("execution")) {
    if (entry.text() == name) return step;
    ++step;
  }
  return std::nullopt;
}

CodeRow TableRows::row(const PackedValue& from, bool has_number) const {
  CodeRow row;
  const std::string code = table_.text(from, "code");
  if (has_number) row.code = static_cast<int>(std::lround(parse_number(code).value_or(-1) * 10));
  if (row.code < 0) table_.complain(fmt::format("'{}' is no code", code));
  row.group = static_cast<int>(table_.number(from, "group", -1));
  row.meaning = table_.text(from, "does");
  row.action = action_named(row.meaning);
  if (TableValues::has(from, "words")) row.words = table_.text(from, "words");
  row.word_mask = letter_mask(row.words);
  row.step = step(table_.text(from, "step"));
  const std::uint8_t motion = step("motion");
  row.order = row.step < motion ? Order::before_motion : row.step == motion ? Order::with_motion : Order::after_motion;
  row.value = static_cast<int>(table_.number(from, "value", 0));
  row.takes_axes = table_.flag(from, "axes");
  row.loses_position = table_.flag(from, "loses_position");
  row.harmless = table_.flag(from, "harmless");
  row.has_arguments = table_.flag(from, "arguments");
  row.alone = table_.flag(from, "alone");
  row.needs_axes = table_.flag(from, "needs_axes");
  row.absolute_alone = table_.flag(from, "absolute_alone");
  row.unturned = table_.flag(from, "unturned");
  if (TableValues::has(from, "not_beside")) row.not_beside = table_.text(from, "not_beside").front();
  if (TableValues::has(from, "beside_is")) {
    row.beside_is = static_cast<int>(std::lround(parse_number(table_.text(from, "beside_is")).value() * 10));
  }
  if (TableValues::has(from, "feed_rule")) row.feed_rule = feed_rule_named(table_.text(from, "feed_rule"));
  if (const auto only = table_.value(from, "only", PackedValue::Kind::array)) {
    for (const PackedValue word : only->items()) {
      row.only_letter = word.text().at(0);
      row.only.push_back(parse_number(word.text().substr(1)).value());
    }
  }
  row.order_unknown = table_.flag(from, "order_unknown");
  row.tool_vectors = table_.flag(from, "tool_vectors");
  if (TableValues::has(from, "written_as")) row.written_as = table_.text(from, "written_as");
  row.has_values = table_.flag(from, "values");
  if (TableValues::has(from, "stays_with")) row.stays_mask = letter_mask(table_.text(from, "stays_with"));
  if (TableValues::has(from, "levels")) row.levels = table_.text(from, "levels");
  if (row.action == Action::refused || !row.only.empty() || TableValues::has(from, "why"))
    row.why = table_.text(from, "why");
  return row;
}

}  // namespace plumbline::nc
