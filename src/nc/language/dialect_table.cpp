#include "nc/language/dialect_table.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/number_text.hpp"
#include "base/text/toml.hpp"
#include "nc/language/block_words.hpp"
#include "nc/language/dialect_keys.hpp"
#include "nc/language/dialect_names.hpp"

namespace plumbline::nc {
namespace {

std::uint32_t mask(std::string_view letters) {
  std::uint32_t bits = 0;
  for (const char c : letters) bits |= letter_bit(c);
  return bits;
}

// One table being read; every complaint names it.
class TableReader {
 public:
  explicit TableReader(const TomlDocument& document) : document_(document), root_(document.root) {}

  Dialect read() const {
    Dialect dialect;
    dialect.name = text(root_, "name");
    dialect.comment_open = text(root_, "comment_open");
    dialect.comment_close = text(root_, "comment_close");
    dialect.feed_rule = feed_rule_named(text(root_, "feed_rule"));
    dialect.feed_rate_min = number(root_, "feed_rate_min", 0);
    dialect.line_length = static_cast<std::size_t>(number(root_, "line_length", 0));
    const std::vector<TomlValue>& user_m_codes = list("user_m_codes");
    if (user_m_codes.size() != 2) complain("'user_m_codes' needs the first and the last");
    dialect.first_user_m_code = static_cast<int>(user_m_codes[0].number);
    dialect.last_user_m_code = static_cast<int>(user_m_codes[1].number);
    dialect.feed_row = turn("F", Action::feed_word);
    dialect.feed_before_units = has_turn("units") && dialect.feed_row.step < turn("units", Action::no_motion).step;
    dialect.speed_row = turn("S", Action::speed_word);
    dialect.speed_row.words = "$";
    dialect.speed_row.word_mask = mask(dialect.speed_row.words);
    dialect.tool_row = turn("T", Action::tool_word);
    dialect.user_row = turn("user", Action::user_code);
    dialect.user_row.words = "PQ";
    dialect.user_row.word_mask = mask(dialect.user_row.words);
    dialect.user_row.loses_position = true;
    dialect.has_edges = has_turn("D");
    if (dialect.has_edges) dialect.edge_row = turn("D", Action::tool_edge);
    rows("g", dialect.g_codes, dialect.g_index);
    rows("m", dialect.m_codes, dialect.m_index);
    dialect.work_systems = static_cast<int>(number(root_, "work_systems", dialect.work_systems));
    if (root_.find("guard") != nullptr) dialect.guard = guard_named(text(root_, "guard"));
    if (const TomlEntry* entry = root_.find("syntax")) read_syntax(entry->value, dialect.syntax);
    if (const TomlEntry* entry = root_.find("habits")) read_habits(entry->value, dialect.behaviour);
    texts("subprogram_files", dialect.syntax.subprogram_files);
    if (root_.find("names") != nullptr) named_rows(dialect);
    texts("marks", dialect.marks);
    texts("weak_marks", dialect.weak_marks);
    texts("file_endings", dialect.file_endings);
    texts("weak_file_endings", dialect.weak_file_endings);
    if (root_.find("at_start") != nullptr) {
      for (const TomlValue& code : list("at_start")) dialect.at_start.push_back(start_row(dialect, code.text));
    }
    return dialect;
  }

 private:
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
    const TomlValue* const found = value(root_, key, TomlValue::Kind::array);
    if (found == nullptr) complain(fmt::format("no list '{}'", key));
    return found->items;
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

  void read_syntax(const TomlValue& from, Syntax& syntax) const {
    check_keys(from, {"statements", "labels", "system_variables"}, kSyntaxFlags, kSyntaxLetters, kSyntaxNumbers,
               kSyntaxIntegers, kSyntaxTexts);
    syntax.statements = statements_named(text(from, "statements"));
    if (from.find("labels") != nullptr) syntax.labels = labels_named(text(from, "labels"));
    syntax.system_variables = system_variables_named(text(from, "system_variables"));
    read_keys(from, syntax, kSyntaxFlags);
    read_keys(from, syntax, kSyntaxLetters);
    read_keys(from, syntax, kSyntaxNumbers);
    read_keys(from, syntax, kSyntaxIntegers);
    read_keys(from, syntax, kSyntaxTexts);
    read_names(syntax);
    syntax.branches = std::any_of(syntax.meanings.begin(), syntax.meanings.end(), [](const auto& entry) {
      return entry.second.kind == NameMeaning::Kind::keyword &&
             entry.second.which == static_cast<int>(FlowWord::end_if);
    });
  }

  void read_names(Syntax& syntax) const {
    using Kind = NameMeaning::Kind;
    const auto each = [&](std::string_view key, Kind kind, const auto& which) {
      if (root_.find(key) == nullptr) return;
      for (const TomlValue& row : list(key)) {
        const int arguments = static_cast<int>(number(row, "arguments", 1));
        syntax.meanings[text(row, "name")] = {kind, static_cast<int>(which(row)), arguments, number(row, "value", 0),
                                              flag(row, "tool_vector")};
      }
    };
    each("addresses", Kind::address, [&](const TomlValue& row) { return text(row, "letter").at(0); });
    each("keywords", Kind::keyword, [&](const TomlValue& row) { return keyword_named(text(row, "does")); });
    each("functions", Kind::function, [&](const TomlValue& row) { return operation_named(text(row, "does")); });
    each("operations", Kind::operation, [&](const TomlValue& row) { return operation_named(text(row, "does")); });
    each("variables", Kind::variable, [&](const TomlValue& row) {
      syntax.variables.push_back({text(row, "name"), static_cast<int>(number(row, "first", 0)),
                                  static_cast<int>(number(row, "last", 0)), static_cast<int>(number(row, "at", 0))});
      return syntax.variables.size() - 1;
    });
  }

  void read_habits(const TomlValue& from, ControlBehaviour& behaviour) const {
    check_keys(from, {"beside_dwell", "increment_unknown_after"}, kHabitFlags, kHabitNumbers, kHabitIntegers,
               kHabitTexts);
    read_keys(from, behaviour, kHabitFlags);
    read_keys(from, behaviour, kHabitNumbers);
    read_keys(from, behaviour, kHabitIntegers);
    read_keys(from, behaviour, kHabitTexts);
    if (from.find("beside_dwell") != nullptr) behaviour.beside_dwell = beside_named(text(from, "beside_dwell"));
    read_increments_after(from, behaviour);
  }

  void read_increments_after(const TomlValue& from, ControlBehaviour& behaviour) const {
    const TomlValue* const list = value(from, "increment_unknown_after", TomlValue::Kind::array);
    if (list == nullptr) return;
    for (const TomlValue& change : list->items) {
      bool* const flag = change.text == "offset"   ? &behaviour.increment_unknown_after_offset
                         : change.text == "length" ? &behaviour.increment_unknown_after_length
                         : change.text == "turn"   ? &behaviour.increment_unknown_after_turn
                                                   : nullptr;
      if (flag == nullptr) complain(fmt::format("'increment_unknown_after' knows no '{}'", change.text));
      *flag = true;
    }
  }

  ControlBehaviour::Beside beside_named(const std::string& name) const {
    if (name == "no_axes") return ControlBehaviour::Beside::no_axes;
    if (name == "nothing") return ControlBehaviour::Beside::nothing;
    complain(fmt::format("'beside_dwell' knows no '{}'", name));
  }

  void named_rows(Dialect& dialect) const {
    for (const TomlValue& from : list("names")) {
      CodeRow named_code = row(from, false);
      named_code.name = text(from, "code");
      const int place = static_cast<int>(dialect.named_codes.size());
      dialect.syntax.meanings[named_code.name] = {NameMeaning::Kind::code, place, 0, 0};
      dialect.named_codes.push_back(std::move(named_code));
    }
  }

  CodeRow start_row(const Dialect& dialect, const std::string& code) const {
    const int times_ten = static_cast<int>(std::lround(parse_number(code.substr(1)).value_or(-1) * 10));
    const CodeRow* const found = dialect.g_code(times_ten);
    if (found == nullptr) complain(fmt::format("'at_start' names {}, which is no code", code));
    return *found;
  }

  std::uint8_t step(std::string_view name) const {
    const std::vector<TomlValue>& steps = list("execution");
    const auto at =
        std::find_if(steps.begin(), steps.end(), [&](const TomlValue& entry) { return entry.text == name; });
    if (at == steps.end()) complain(fmt::format("'{}' has no turn in 'execution'", name));
    return static_cast<std::uint8_t>(at - steps.begin());
  }

  bool has_turn(std::string_view name) const {
    const std::vector<TomlValue>& steps = list("execution");
    return std::any_of(steps.begin(), steps.end(), [&](const TomlValue& entry) { return entry.text == name; });
  }

  CodeRow turn(std::string_view name, Action action) const {
    CodeRow row;
    row.action = action;
    row.step = step(name);
    return row;
  }

  CodeRow row(const TomlValue& from, bool has_number = true) const {
    CodeRow row;
    const std::string code = text(from, "code");
    if (has_number) row.code = static_cast<int>(std::lround(parse_number(code).value_or(-1) * 10));
    if (row.code < 0) complain(fmt::format("'{}' is no code", code));
    row.group = static_cast<int>(number(from, "group", -1));
    row.meaning = text(from, "does");
    row.action = action_named(row.meaning);
    if (from.find("words") != nullptr) row.words = text(from, "words");
    row.word_mask = mask(row.words);
    row.step = step(text(from, "step"));
    const std::uint8_t motion = step("motion");
    row.order = row.step < motion    ? Order::before_motion
                : row.step == motion ? Order::with_motion
                                     : Order::after_motion;
    row.value = static_cast<int>(number(from, "value", 0));
    row.takes_axes = flag(from, "axes");
    row.loses_position = flag(from, "loses_position");
    row.harmless = flag(from, "harmless");
    row.has_arguments = flag(from, "arguments");
    row.alone = flag(from, "alone");
    row.needs_axes = flag(from, "needs_axes");
    row.absolute_alone = flag(from, "absolute_alone");
    row.unturned = flag(from, "unturned");
    if (from.find("not_beside") != nullptr) row.not_beside = text(from, "not_beside").front();
    if (from.find("feed_rule") != nullptr) row.feed_rule = feed_rule_named(text(from, "feed_rule"));
    if (const TomlValue* const only = value(from, "only", TomlValue::Kind::array)) {
      for (const TomlValue& word : only->items) {
        row.only_letter = word.text.at(0);
        row.only.push_back(parse_number(word.text.substr(1)).value());
      }
    }
    row.order_unknown = flag(from, "order_unknown");
    row.tool_vectors = flag(from, "tool_vectors");
    if (from.find("written_as") != nullptr) row.written_as = text(from, "written_as");
    row.has_values = flag(from, "values");
    if (from.find("stays_with") != nullptr) row.stays_mask = mask(text(from, "stays_with"));
    if (from.find("levels") != nullptr) row.levels = text(from, "levels");
    if (row.action == Action::refused || !row.only.empty() || from.find("why") != nullptr) row.why = text(from, "why");
    return row;
  }

  void texts(std::string_view key, std::vector<std::string>& into) const {
    if (root_.find(key) == nullptr) return;
    for (const TomlValue& item : list(key)) into.push_back(item.text);
  }

  void rows(std::string_view key, std::vector<CodeRow>& into, std::vector<std::int16_t>& places) const {
    for (const TomlValue& from : list(key)) {
      into.push_back(row(from));
      if (from.find("last") == nullptr) continue;
      const int last = static_cast<int>(std::lround(parse_number(text(from, "last")).value_or(-1) * 10));
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
      if (place >= 0) complain(fmt::format("two rows of '{}' for {}", key, into[i].code / 10.0));
      place = static_cast<std::int16_t>(i);
    }
  }

  const TomlDocument& document_;
  const TomlValue& root_;
};

}  // namespace

Dialect read_dialect(std::string_view name, std::string_view text) {
  const TomlDocument document = parse_toml(std::string(text), std::string(name));
  return TableReader(document).read();
}

}  // namespace plumbline::nc
