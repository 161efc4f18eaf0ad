#include "nc/dialect_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/number_text.hpp"
#include "base/toml.hpp"

namespace plumbline::nc {
namespace {

using ActionName = std::pair<std::string_view, Action>;
constexpr std::array kActions{
    ActionName{"none", Action::none},
    ActionName{"rapid", Action::rapid},
    ActionName{"feed", Action::feed},
    ActionName{"arc_cw", Action::arc_cw},
    ActionName{"arc_ccw", Action::arc_ccw},
    ActionName{"motion_off", Action::motion_off},
    ActionName{"dwell", Action::dwell},
    ActionName{"plane_xy", Action::plane_xy},
    ActionName{"plane_zx", Action::plane_zx},
    ActionName{"plane_yz", Action::plane_yz},
    ActionName{"inches", Action::inches},
    ActionName{"millimetres", Action::millimetres},
    ActionName{"absolute", Action::absolute},
    ActionName{"incremental", Action::incremental},
    ActionName{"arc_centre_absolute", Action::arc_centre_absolute},
    ActionName{"arc_centre_incremental", Action::arc_centre_incremental},
    ActionName{"inverse_time", Action::inverse_time},
    ActionName{"per_minute", Action::per_minute},
    ActionName{"per_revolution", Action::per_revolution},
    ActionName{"exact_path", Action::exact_path},
    ActionName{"exact_stop", Action::exact_stop},
    ActionName{"continuous", Action::continuous},
    ActionName{"compensation_off", Action::compensation_off},
    ActionName{"work_system", Action::work_system},
    ActionName{"set_table", Action::set_table},
    ActionName{"set_position", Action::set_position},
    ActionName{"clear_position", Action::clear_position},
    ActionName{"suspend_position", Action::suspend_position},
    ActionName{"restore_position", Action::restore_position},
    ActionName{"machine_coordinates", Action::machine_coordinates},
    ActionName{"go_home", Action::go_home},
    ActionName{"store_home", Action::store_home},
    ActionName{"tool_length", Action::tool_length},
    ActionName{"tool_length_by_words", Action::tool_length_by_words},
    ActionName{"tool_length_added", Action::tool_length_added},
    ActionName{"tool_length_off", Action::tool_length_off},
    ActionName{"change_tool", Action::change_tool},
    ActionName{"set_tool", Action::set_tool},
    ActionName{"stop", Action::stop},
    ActionName{"end", Action::end},
    ActionName{"orient_spindle", Action::orient_spindle},
    ActionName{"set_output", Action::set_output},
    ActionName{"read_input", Action::read_input},
    ActionName{"set_analog_output", Action::set_analog_output},
    ActionName{"cycle", Action::cycle},
    ActionName{"retract_to_start", Action::retract_to_start},
    ActionName{"retract_to_r", Action::retract_to_r},
    ActionName{"call_program", Action::call_program},
    ActionName{"end_program", Action::end_program},
    ActionName{"save_modes", Action::save_modes},
    ActionName{"forget_modes", Action::forget_modes},
    ActionName{"restore_modes", Action::restore_modes},
    ActionName{"save_modes_of_call", Action::save_modes_of_call},
    ActionName{"no_motion", Action::no_motion},
    ActionName{"cubic_spline", Action::cubic_spline},
    ActionName{"quadratic_spline", Action::quadratic_spline},
    ActionName{"nurbs_point", Action::nurbs_point},
    ActionName{"nurbs_end", Action::nurbs_end},
    ActionName{"synchronised", Action::synchronised},
    ActionName{"rigid_tap", Action::rigid_tap},
    ActionName{"probe", Action::probe},
    ActionName{"compensation_on", Action::compensation_on},
    ActionName{"spindle", Action::spindle},
    ActionName{"coolant", Action::coolant},
    ActionName{"override", Action::override_switch},
};

constexpr std::array kFeedRules{
    std::pair<std::string_view, FeedRule>{"xyz_first", FeedRule::xyz_first},
    std::pair<std::string_view, FeedRule>{"all_axes_as_mm", FeedRule::all_axes_as_mm},
    std::pair<std::string_view, FeedRule>{"path_group", FeedRule::path_group},
    std::pair<std::string_view, FeedRule>{"unknown", FeedRule::unknown},
};

std::uint32_t mask(std::string_view letters) {
  std::uint32_t bits = 0;
  for (const char c : letters) bits |= std::uint32_t{1} << static_cast<unsigned>(c - 'A');
  return bits;
}

template <class Names>
auto named(const Names& names, std::string_view name) {
  const auto at = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; });
  if (at == names.end()) throw InternalError(fmt::format("in a dialect table: nothing is called '{}'", name));
  return at->second;
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
    dialect.feed_rule = named(kFeedRules, text(root_, "feed_rule"));
    dialect.feed_rate_min = number(root_, "feed_rate_min", 0);
    dialect.line_length = static_cast<std::size_t>(number(root_, "line_length", 0));
    const std::vector<TomlValue>& user_m_codes = list("user_m_codes");
    if (user_m_codes.size() != 2) complain("'user_m_codes' needs the first and the last");
    dialect.first_user_m_code = static_cast<int>(user_m_codes[0].number);
    dialect.last_user_m_code = static_cast<int>(user_m_codes[1].number);
    dialect.feed_row = turn("F", Action::feed_word);
    dialect.speed_row = turn("S", Action::speed_word);
    dialect.tool_row = turn("T", Action::tool_word);
    dialect.user_row = turn("user", Action::user_code);
    dialect.user_row.words = "PQ";
    dialect.user_row.word_mask = mask(dialect.user_row.words);
    dialect.user_row.loses_position = true;
    rows("g", dialect.g_codes, dialect.g_index);
    rows("m", dialect.m_codes, dialect.m_index);
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

  std::uint8_t step(std::string_view name) const {
    const std::vector<TomlValue>& steps = list("execution");
    const auto at =
        std::find_if(steps.begin(), steps.end(), [&](const TomlValue& entry) { return entry.text == name; });
    if (at == steps.end()) complain(fmt::format("'{}' has no turn in 'execution'", name));
    return static_cast<std::uint8_t>(at - steps.begin());
  }

  CodeRow turn(std::string_view name, Action action) const {
    CodeRow row;
    row.action = action;
    row.step = step(name);
    return row;
  }

  CodeRow row(const TomlValue& from) const {
    CodeRow row;
    const std::string code = text(from, "code");
    row.code = static_cast<int>(std::lround(parse_number(code).value_or(-1) * 10));
    if (row.code < 0) complain(fmt::format("'{}' is no code", code));
    row.group = static_cast<int>(number(from, "group", -1));
    row.meaning = text(from, "does");
    row.action = named(kActions, row.meaning);
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
    return row;
  }

  void rows(std::string_view key, std::vector<CodeRow>& into, std::vector<std::int16_t>& places) const {
    for (const TomlValue& from : list(key)) into.push_back(row(from));
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
