#include "nc/language/dialect_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "nc/language/block_words.hpp"
#include "nc/language/dialect_keys.hpp"
#include "nc/language/dialect_names.hpp"
#include "nc/language/table_rows.hpp"
#include "nc/language/table_values.hpp"

namespace plumbline::nc {
namespace {

class TableReader {
 public:
  explicit TableReader(const TableValues& table) : table_(table), rows_(table_) {}

  Dialect read() const {
    Dialect dialect;
    dialect.name = table_.text(table_.root(), "name");
    dialect.comment_open = table_.text(table_.root(), "comment_open");
    dialect.comment_close = table_.text(table_.root(), "comment_close");
    dialect.feed_rule = feed_rule_named(table_.text(table_.root(), "feed_rule"));
    dialect.feed_rate_min = table_.number(table_.root(), "feed_rate_min", 0);
    dialect.line_length = static_cast<std::size_t>(table_.number(table_.root(), "line_length", 0));
    std::vector<int> user_m_codes;
    for (const PackedValue code : table_.list("user_m_codes")) user_m_codes.push_back(static_cast<int>(code.number()));
    if (user_m_codes.size() != 2) table_.complain("'user_m_codes' needs the first and the last");
    dialect.first_user_m_code = user_m_codes[0];
    dialect.last_user_m_code = user_m_codes[1];
    dialect.feed_row = rows_.turn("F", Action::feed_word);
    dialect.feed_before_units =
        rows_.has_turn("units") && dialect.feed_row.step < rows_.turn("units", Action::no_motion).step;
    dialect.speed_row = rows_.turn("S", Action::speed_word);
    dialect.speed_row.words = "$";
    dialect.speed_row.word_mask = letter_mask(dialect.speed_row.words);
    dialect.tool_row = rows_.turn("T", Action::tool_word);
    dialect.user_row = rows_.turn("user", Action::user_code);
    dialect.user_row.words = "PQ";
    dialect.user_row.word_mask = letter_mask(dialect.user_row.words);
    dialect.user_row.loses_position = true;
    dialect.has_edges = rows_.has_turn("D");
    dialect.along_tool = dialect.has_edges || table_.flag(table_.root(), "along_tool");
    if (dialect.has_edges) dialect.edge_row = rows_.turn("D", Action::tool_edge);
    rows_.rows("g", dialect.g_codes, dialect.g_index);
    rows_.rows("m", dialect.m_codes, dialect.m_index);
    dialect.work_systems = static_cast<int>(table_.number(table_.root(), "work_systems", dialect.work_systems));
    if (table_.has("guard")) dialect.guard = guard_named(table_.text(table_.root(), "guard"));
    if (const auto syntax = table_.root().find("syntax")) read_syntax(*syntax, dialect.syntax);
    if (const auto habits = table_.root().find("habits")) read_habits(*habits, dialect.behaviour);
    table_.texts("subprogram_files", dialect.syntax.subprogram_files);
    if (table_.has("names")) rows_.named_rows(dialect);
    if (table_.has("reserved")) rows_.reserved_rows(dialect);
    if (table_.has("at_start")) {
      for (const PackedValue code : table_.list("at_start"))
        dialect.at_start.push_back(rows_.start_row(dialect, std::string(code.text())));
    }
    return dialect;
  }

 private:
  void read_syntax(const PackedValue& from, Syntax& syntax) const {
    table_.check_keys(from, {"statements", "labels", "system_variables"}, kSyntaxFlags, kSyntaxLetters, kSyntaxNumbers,
                      kSyntaxIntegers, kSyntaxTexts);
    syntax.statements = statements_named(table_.text(from, "statements"));
    if (TableValues::has(from, "labels")) syntax.labels = labels_named(table_.text(from, "labels"));
    syntax.system_variables = system_variables_named(table_.text(from, "system_variables"));
    table_.read_keys(from, syntax, kSyntaxFlags);
    table_.read_keys(from, syntax, kSyntaxLetters);
    table_.read_keys(from, syntax, kSyntaxNumbers);
    table_.read_keys(from, syntax, kSyntaxIntegers);
    table_.read_keys(from, syntax, kSyntaxTexts);
    read_names(syntax);
    syntax.branches = std::any_of(syntax.meanings.begin(), syntax.meanings.end(), [](const auto& entry) {
      return entry.second.kind == NameMeaning::Kind::keyword &&
             entry.second.which == static_cast<int>(FlowWord::end_if);
    });
  }

  void read_names(Syntax& syntax) const {
    using Kind = NameMeaning::Kind;
    const auto each = [&](std::string_view key, Kind kind, const auto& which) {
      if (!table_.has(key)) return;
      for (const PackedValue row : table_.list(key)) {
        const int arguments = static_cast<int>(table_.number(row, "arguments", 1));
        syntax.meanings[table_.text(row, "name")] = {kind, static_cast<int>(which(row)), arguments,
                                                     table_.number(row, "value", 0), table_.flag(row, "tool_vector")};
      }
    };
    each("addresses", Kind::address, [&](const PackedValue& row) {
      const char letter = table_.text(row, "letter").at(0);
      const bool of_name = table_.text(row, "name").at(0) != letter && !table_.flag(row, "tool_vector");
      if (of_name) syntax.address_letters |= letter_bit(letter);
      return letter;
    });
    each("keywords", Kind::keyword, [&](const PackedValue& row) { return keyword_named(table_.text(row, "does")); });
    each("functions", Kind::function,
         [&](const PackedValue& row) { return operation_named(table_.text(row, "does")); });
    each("operations", Kind::operation,
         [&](const PackedValue& row) { return operation_named(table_.text(row, "does")); });
    each("variables", Kind::variable, [&](const PackedValue& row) {
      syntax.variables.push_back({table_.text(row, "name"), static_cast<int>(table_.number(row, "first", 0)),
                                  static_cast<int>(table_.number(row, "last", 0)),
                                  static_cast<int>(table_.number(row, "at", 0))});
      return syntax.variables.size() - 1;
    });
  }

  void read_habits(const PackedValue& from, ControlBehaviour& behaviour) const {
    table_.check_keys(from, {"beside_dwell", "increment_unknown_after"}, kHabitFlags, kHabitNumbers, kHabitIntegers,
                      kHabitTexts);
    table_.read_keys(from, behaviour, kHabitFlags);
    table_.read_keys(from, behaviour, kHabitNumbers);
    table_.read_keys(from, behaviour, kHabitIntegers);
    table_.read_keys(from, behaviour, kHabitTexts);
    if (TableValues::has(from, "beside_dwell"))
      behaviour.beside_dwell = beside_named(table_.text(from, "beside_dwell"));
    read_increments_after(from, behaviour);
  }

  void read_increments_after(const PackedValue& from, ControlBehaviour& behaviour) const {
    const auto list = table_.value(from, "increment_unknown_after", PackedValue::Kind::array);
    if (!list) return;
    for (const PackedValue change : list->items()) {
      bool* const flag = change.text() == "offset"   ? &behaviour.increment_unknown_after_offset
                         : change.text() == "length" ? &behaviour.increment_unknown_after_length
                         : change.text() == "turn"   ? &behaviour.increment_unknown_after_turn
                                                     : nullptr;
      if (flag == nullptr) table_.complain(fmt::format("'increment_unknown_after' knows no '{}'", change.text()));
      *flag = true;
    }
  }

  ControlBehaviour::Beside beside_named(const std::string& name) const {
    if (name == "no_arcs") return ControlBehaviour::Beside::no_arcs;
    if (name == "no_axes") return ControlBehaviour::Beside::no_axes;
    if (name == "nothing") return ControlBehaviour::Beside::nothing;
    table_.complain(fmt::format("'beside_dwell' knows no '{}'", name));
  }

  TableValues table_;
  TableRows rows_;
};

}  // namespace

Dialect read_dialect(std::string_view name, std::string_view packed) {
  return TableReader(TableValues(name, PackedValue(packed))).read();
}

DialectMarks read_marks(std::string_view name, std::string_view packed) {
  const TableValues table(name, PackedValue(packed));
  DialectMarks marks;
  table.texts("marks", marks.marks);
  table.texts("weak_marks", marks.weak_marks);
  table.texts("file_endings", marks.file_endings);
  table.texts("weak_file_endings", marks.weak_file_endings);
  return marks;
}

}  // namespace plumbline::nc
