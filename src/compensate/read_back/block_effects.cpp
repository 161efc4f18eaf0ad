#include "compensate/read_back/block_effects.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/same_value.hpp"
#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "nc/sequence/program_ends.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kAlike = 2e-9;        // of values as they stand in the text: nine decimals
constexpr double kOffsetAlike = 1e-6;  // mm and deg: what G92 is off by where the control keeps nine decimals of inches

// What the moves of the block, its time or the state after it show.
bool shows_otherwise(nc::Action action) {
  switch (action) {
    case nc::Action::rapid:
    case nc::Action::feed:
    case nc::Action::arc_cw:
    case nc::Action::arc_ccw:
    case nc::Action::arc_through_point:
    case nc::Action::motion_off:
    case nc::Action::dwell:
    case nc::Action::plane_xy:
    case nc::Action::plane_zx:
    case nc::Action::plane_yz:
    case nc::Action::inches:
    case nc::Action::millimetres:
    case nc::Action::absolute:
    case nc::Action::incremental:
    case nc::Action::arc_centre_absolute:
    case nc::Action::arc_centre_incremental:
    case nc::Action::inverse_time:
    case nc::Action::per_minute:
    case nc::Action::per_revolution:
    case nc::Action::exact_path:
    case nc::Action::exact_stop:
    case nc::Action::exact_stop_once:
    case nc::Action::continuous:
    case nc::Action::work_system:
    case nc::Action::work_system_by_word:
    case nc::Action::machine_coordinates:
    case nc::Action::go_home:
    case nc::Action::home_or_unit:
    case nc::Action::cycle:
    case nc::Action::called_cycle:
    case nc::Action::modal_call:
    case nc::Action::retract_to_start:
    case nc::Action::retract_to_r:
    case nc::Action::no_hole:
    case nc::Action::return_level:
    case nc::Action::call_program:
    case nc::Action::call_macro:
    case nc::Action::save_modes:
    case nc::Action::forget_modes:
    case nc::Action::restore_modes:
    case nc::Action::save_modes_of_call:
    case nc::Action::cubic_spline:
    case nc::Action::quadratic_spline:
    case nc::Action::nurbs_point:
    case nc::Action::nurbs_end:
    case nc::Action::feed_word:
      return true;
    default:
      return false;
  }
}

// A mode that may be said again where it comes back.
bool is_mode(nc::Action action) {
  return action == nc::Action::spindle || action == nc::Action::coolant || action == nc::Action::override_switch ||
         action == nc::Action::tool_length || action == nc::Action::tool_length_by_words ||
         action == nc::Action::tool_length_off || action == nc::Action::speed_word ||
         action == nc::Action::surface_speed || action == nc::Action::suspend_position ||
         action == nc::Action::restore_position;
}

bool is_axis(char letter) { return axis_of(letter).has_value(); }

bool has_action(const nc::Block& block, const nc::Dialect& dialect, nc::Action action) {
  return std::any_of(block.words.begin(), block.words.end(), [&](const nc::Word& word) {
    const nc::CodeRow* const row = nc::is_code(word) ? dialect.row_of(word) : nullptr;
    return row != nullptr && row->action == action;
  });
}

// P and L beside a call are the call's.
void append_words(const nc::Block& block, const nc::Dialect& dialect, const nc::CodeRow& row, BlockEffect& effect) {
  const bool calls = has_action(block, dialect, nc::Action::call_program);
  for (const nc::Word& word : block.words) {
    if (calls && (word.letter == 'P' || word.letter == 'L')) continue;
    if (nc::is_code(word) || is_axis(word.letter) || row.words.find(word.letter) == std::string::npos) continue;
    effect.words.emplace_back(word.letter, word.unknown ? 0 : word.value);
  }
}

// ADIS=R1/10 of a program that is written out is ADIS=2/10 there.
std::string with_passed_values(const nc::Step& step, const nc::Word& word) {
  std::string text(step.block->at(word.span));
  if (step.passed == nullptr) return text;
  // the last first: then the places of the others stay
  for (std::size_t i = step.passed->size(); i-- > 0;) {
    const nc::PassedValue& value = (*step.passed)[i];
    if (value.span.begin < word.span.begin || value.span.end > word.span.end) continue;
    text.replace(value.span.begin - word.span.begin, value.span.end - value.span.begin, value.text);
  }
  return text;
}

void append_code(const nc::Word& word, const nc::CodeRow* row, const nc::Step& step, const nc::Dialect& dialect,
                 std::vector<BlockEffect>& effects) {
  const nc::Block& block = *step.block;
  if (row == nullptr || row->action == nc::Action::refused) row = &dialect.user_row;  // --pass
  if (shows_otherwise(row->action)) return;
  const bool ends = row->action == nc::Action::end_program || row->action == nc::Action::end;
  if (ends && step.flow) return;  // of a subprogram
  BlockEffect effect;
  if (word.letter == nc::kNamedCode) {
    effect.text = row->has_arguments ? with_passed_values(step, word) : row->name;
  } else {
    effect.text =
        fmt::format("{}{}", word.letter, row->written_as.empty() ? to_decimal(word.value, 1) : row->written_as);
  }
  effect.is_mode = is_mode(row->action);
  effect.turn = row->step;
  effect.behind_motion = row->order == nc::Order::after_motion;
  append_words(block, dialect, *row, effect);
  effects.push_back(std::move(effect));
}

void append_value(const nc::Word& word, const nc::CodeRow& row, std::vector<BlockEffect>& effects) {
  BlockEffect effect;
  effect.words.emplace_back(word.letter, word.unknown ? 0 : word.value);
  effect.is_mode = is_mode(row.action);
  effect.turn = row.step;
  effect.behind_motion = row.order == nc::Order::after_motion;
  effects.push_back(std::move(effect));
}

bool alike(double a, double b) { return std::abs(a - b) <= kAlike * std::max(1.0, std::abs(a)); }

bool alike(const AxisWords& a, const AxisWords& b) {
  return std::all_of(kAllAxes.begin(), kAllAxes.end(),
                     [&](Axis axis) { return std::abs(a[axis] - b[axis]) <= kOffsetAlike; });
}

}  // namespace

void append_effects(const nc::Step& step, const nc::Dialect& dialect, std::vector<BlockEffect>& effects) {
  const nc::Block& block = *step.block;
  for (const nc::Comment& comment : block.comments) {
    effects.push_back({.text = std::string(block.at(comment.span)), .is_comment = true});
  }
  const auto first = static_cast<std::ptrdiff_t>(effects.size());
  if (block.kind == nc::LineKind::percent) effects.push_back({.text = "%"});
  if (nc::returns_from_file(step)) effects.push_back({.text = upper(block.at(block.flow.span))});
  const std::size_t before_words = effects.size();
  const bool speed_is_time = nc::dwells_alone(step) && dialect.behaviour.dwell_takes_words;  // G4 S3: for three turns
  for (const nc::Word& word : block.words) {
    switch (word.letter) {
      case 'G':
      case 'M':
      case nc::kNamedCode: {
        const nc::CodeRow* const row = dialect.row_of(word);
        if (row != nullptr && row->action == nc::Action::call_macro) {  // all words of its block are the macro's
          effects.resize(before_words);
          return;
        }
        append_code(word, row, step, dialect, effects);
        break;
      }
      case 'S':
        if (!speed_is_time) append_value(word, dialect.speed_row, effects);
        break;
      case 'T':
        append_value(word, dialect.tool_row, effects);
        break;
      case 'D':
        if (dialect.has_edges) append_value(word, dialect.edge_row, effects);
        break;
      default:
        break;
    }
  }
  std::stable_sort(effects.begin() + first, effects.end(),
                   [](const BlockEffect& a, const BlockEffect& b) { return a.turn < b.turn; });
}

bool are_alike(const BlockEffect& a, const BlockEffect& b) {
  if (a.text != b.text || a.is_comment != b.is_comment || a.words.size() != b.words.size()) return false;
  for (std::size_t i = 0; i < a.words.size(); ++i) {
    if (a.words[i].first != b.words[i].first || !alike(a.words[i].second, b.words[i].second)) return false;
  }
  return true;
}

std::string text_of(const BlockEffect& effect) {
  std::string text = effect.text;
  for (const auto& [letter, value] : effect.words) {
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", letter, to_decimal(value));
  }
  return text;
}

std::string difference(const IntendedState& meant, const nc::Modal& modal, const nc::Frame& frame) {
  const nc::Modal& a = meant.modal;
  const nc::Modal& b = modal;
  if (a.inches != b.inches) return "the unit of length";
  if (a.plane != b.plane) return "the plane";
  if (a.incremental != b.incremental) return "G90 or G91";
  if (a.arc_centre_absolute != b.arc_centre_absolute) return "how arc centres count";
  if (a.retract_to_r != b.retract_to_r) return "where cycles retract to";
  if (a.path_control != b.path_control) return "the exact stop";
  if (a.work_system != b.work_system) return "the work system";
  if (a.tool_in_spindle != b.tool_in_spindle) return "the tool in the spindle";
  if (a.tool_of_offset != b.tool_of_offset) return "the tool whose length is in force";
  if (a.rotary != b.rotary) return "how rotary words count";
  if (a.switches.spindle != b.switches.spindle) return "the spindle";
  if (!alike(a.switches.speed, b.switches.speed)) return "the speed of the spindle";
  if (a.switches.surface_speed != b.switches.surface_speed) return "whether S is the speed of the surface";
  if (a.switches.mist != b.switches.mist || a.switches.flood != b.switches.flood) return "the coolant";
  const bool keeps_points = b.switches.naive_tolerance == 0;  // Q0 is written where G64 P has another one
  if (!alike(a.switches.path_tolerance, b.switches.path_tolerance) ||
      (!keeps_points && !alike(a.switches.naive_tolerance, b.switches.naive_tolerance)))
    return "the tolerance of the path";
  if (a.switches.feed_override != b.switches.feed_override || a.switches.speed_override != b.switches.speed_override ||
      a.switches.adaptive_feed != b.switches.adaptive_feed || a.switches.feed_stop != b.switches.feed_stop)
    return "an override switch";
  if (same_value(meant.frame, frame)) return {};
  if (!alike(meant.frame.origin, frame.origin) || !alike(meant.frame.rotation_deg, frame.rotation_deg))
    return "the work offset";
  if (meant.frame.tilted != frame.tilted || meant.frame.plane != frame.plane) return "the tilted plane";
  if (!alike(meant.frame.g92, frame.g92)) return "the G92 offset";
  if (!alike(meant.frame.tool, frame.tool)) return "the tool length";
  return {};
}

}  // namespace plumbline::compensate
