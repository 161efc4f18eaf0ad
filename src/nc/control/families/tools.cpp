// Tools: T, M6, M61, and their lengths: G43, G43.1, G43.2, G49.
#include <cmath>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/control/state/tool_rows.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

// T="MILL10"; where tables count as empty, a tool that no table holds.
constexpr int kOfNoTable = -2;
constexpr int kMacroOfUser = 1;  // value of the row of a code that changes tools: G111 of an OSP

int tool_by_name(const Execution& run, const Word& word) {
  const std::string_view text = run.block->at(word.span);
  const std::size_t begin = text.find_first_of("\"'") + 1;
  const std::string_view name = text.substr(begin, text.size() - begin - 1);
  if (const Tool* const tool = run.settings.tools.find(name)) return tool->number;
  if (run.settings.as_with_empty_tables) return kOfNoTable;
  run.refuse(word, codes::kToolUnknown, fmt::format("no tool of the table is named '{}'", name),
             fmt::format("add name = \"{}\", letter for letter, to its [[tool]] in the tool table (--tools)", name));
}

int tool_number(const Execution& run, const Word& word, std::string_view what) {
  run.refuse_point(word);
  const int number = whole_number(*run.block, word.span, word.value, what);
  if (number < 0) run.refuse(word, codes::kNegative, fmt::format("{} is negative", what), "write 0 or more");
  return number;
}

int tool_in_spindle(const Execution& run, const Word& word) {
  const int number = run.control.modal.tool_in_spindle;
  if (number >= 0) return number;
  if (run.settings.as_with_empty_tables) return 0;
  run.refuse(word, codes::kToolUnknown, "which tool is in the spindle is not known",
             "name it with H, or put T and M6 before it");
}

int tool_of_block(const Execution& run, const Chosen& chosen) {
  const Word* const word = run.words.find('H');
  const int named = word == nullptr ? 0 : tool_number(run, *word, "the number of a tool");
  if (named > 0 || (word != nullptr && run.dialect.behaviour.h0_is_no_tool))
    return named;  // H0 is the tool in the spindle [LinuxCNC, measured]
  if (word == nullptr && chosen.row->action == Action::tool_length_added) run.need('H', "G43.2");
  const ControlBehaviour& control = run.dialect.behaviour;
  if (word == nullptr && (control.offset_numbers_last || control.length_needs_number))
    run.need('H', run.block->at(chosen.word->span));
  return tool_in_spindle(run, *chosen.word);
}

const Word& word_of_length(const Execution& run, const Chosen& chosen) {
  const Word* const word = run.words.find('H');
  return word != nullptr ? *word : *chosen.word;
}

// A length that counts as zero because it was never given is not zero at the machine.
void mark_unknown_length(Execution& run, int number) {
  const bool given = run.settings.tools.find(number) != nullptr || run.control.tools.contains(number);
  if (number > 0 && !given && run.dialect.behaviour.increment_unknown_after_length) run.control.shifted.insert(Axis::Z);
}

// The length counts along the tool: where it is tilted, X and Y of the tip change with it, and not before the move that
// names them does the control say how.
void lose_tilted_tip(Execution& run) {
  const Control& control = run.control;
  const bool ends =
      run.dialect.syntax.statements == Statements::macro_b && run.chosen_row(Action::tool_length_off) != nullptr;
  if (!run.dialect.along_tool && !ends) return;
  const AxisSet tip = AxisSet::linear();
  if (tilts_tool(run, control.known, control.position) && !(control.known & tip).empty()) lose_position(run, tip);
}

// Only of axes whose words count within a turn G53, G28 and G30 take it away [interp_find.cc, find_ends].
void check_wrapped_offset(const Execution& run, const AxisWords& offset) {
  for (const Axis axis : kAllAxes) {
    if (offset[axis] == 0 || !is_wrapped(run, axis)) continue;
    run.refuse(run.first_word(), codes::kNotInterpreted,
               fmt::format("a tool's offset of {}, whose words have a sign for the way round (--rotary), is not "
                           "interpreted",
                           letter(axis)),
               "put it into the work offset, or leave it out of the tool");
  }
}

void take_offset(Execution& run, const AxisWords& offset) {
  check_wrapped_offset(run, offset);
  if (offset != run.control.frame.tool) lose_tilted_tip(run);
  Frame next = run.control.frame;
  next.tool = offset;
  run.control.change_frame(next);
  run.control.tool_in_inches = run.control.modal.inches;
}

// G43, G49, D: from the block's own turn on it is known again which length counts.
bool states_length(const Execution& run) {
  if (run.dialect.has_edges) return run.words.has('D');
  const bool by_tip = run.chosen_row(Action::tool_tip_on) != nullptr && run.words.has('H');
  return by_tip || run.chosen_row(Action::tool_length) != nullptr || run.chosen_row(Action::tool_length_off) != nullptr;
}

// The length of a tool's edge, without H.
void take_edge(Execution& run, const Word& word, int number) {
  const std::optional<AxisWords> offset =
      number < 0 ? (run.settings.as_with_empty_tables ? std::optional(AxisWords{}) : std::nullopt)
                 : offset_of_tool(run.control, run.settings, number);
  if (!offset) {
    run.refuse(word, codes::kToolUnknown,
               number < 0 ? std::string("which tool is in the spindle is not known")
                          : fmt::format("the length of tool {} is not known", number),
               number < 0
                   ? std::string("put T and M6 before it")
                   : fmt::format("add a [[tool]] with number = {} to a tool table and name it with --tools", number));
  }
  take_offset(run, *offset);
  if (run.settings.tools.find(number) != nullptr) run.control.modal.tool_of_offset = number;
}

}  // namespace

bool tilts_tool(Execution& run, AxisSet known, const AxisWords& at) {
  const AxisWords machine = run.control.frame.to_machine(at);
  const double least = run.settings.upright_deg;
  const AxisSet turned = AxisSet{Axis::A, Axis::B} & run.settings.named;
  const bool upright =
      known.contains(turned) && std::abs(machine[Axis::A]) < least && std::abs(machine[Axis::B]) < least;
  const bool* const of_original = run.settings.original_tilted;
  const bool tilted = of_original != nullptr ? *of_original : !upright;
  run.step.tilted_length = run.step.tilted_length || tilted;
  return run.step.tilted_length;
}

void refuse_length_doubt(const Execution& run, const Word& word) {
  if (run.control.length_doubt == Control::LengthDoubt::edge) {  // MD20270
    run.refuse(word, codes::kNotInterpreted,
               "a tool was changed while D0 was in force, and whether its length counts from then on depends on the "
               "settings of the control",
               "write D1 (or D0) after the change of the tool");
  }
  if (run.control.length_doubt == Control::LengthDoubt::macro) {
    run.refuse(
        word, codes::kNotInterpreted,
        "a macro of the user changed the tool before it, and whether that chose its length, too, no program says",
        "write G56 H (or G53) after it, before the first move of Z");
  }
  run.refuse(
      word, codes::kNotInterpreted,
      "the move to a place of the machine before it ended the tool length, or did so on some controls, and whether "
      "it comes back by itself depends on a parameter (5001 EVO)",
      "write G43 H (or G49) after G28, G30 and G53");
}

void check_length_known(const Execution& run) {
  const bool in_doubt = run.control.length_doubt != Control::LengthDoubt::none;
  if (!in_doubt || run.motion == nullptr || run.machine_word != nullptr || run.in_machine_system()) return;
  if (states_length(run)) return;
  if (run.motion->action == Action::cycle) refuse_length_doubt(run, run.motion_code());
  const bool may_turn = run.motion->action == Action::rapid && run.control.length == Control::Length::by_code &&
                        !run.control.centre_point;
  for (const Axis axis : kAllAxes) {
    if (axis == Axis::X || axis == Axis::Y || !run.axes.contains(axis)) continue;
    if (axes_to_limits(run).contains(axis)) continue;
    if (may_turn && is_rotary(axis)) continue;
    refuse_length_doubt(run, *run.words.find(axis));
  }
}

// G28 Z0 under G43: "vectors are canceled" [B-63844EN 14.1.2]; "G28 cancels tool length offsets" [Haas 96-8000],
// whichever axis it names.
void end_length_at_home(Execution& run) {
  Control& control = run.control;
  const bool along_tool = run.axes.contains(Axis::Z) || run.chosen_row(Action::go_home) != nullptr;
  if (!run.dialect.behaviour.home_ends_length || !along_tool || control.frame.tool == AxisWords{}) return;
  control.length_doubt = Control::LengthDoubt::home;
}

// LinuxCNC keeps a tool's offset as a number: after a change of units it takes 2 mm for 2 inches [measured].
void check_tool_unit(const Execution& run, const Word& word) {
  const Control& control = run.control;
  const AxisWords& tool = control.frame.tool;
  const bool linear = tool[Axis::X] != 0 || tool[Axis::Y] != 0 || tool[Axis::Z] != 0;
  if (!linear || control.tool_in_inches == control.modal.inches) return;
  run.refuse(word, codes::kNotInterpreted, "the control takes the tool length in force for one in the new unit",
             "write G49 before the change of units (G20, G21) and G43 after it");
}

void set_tool_length(Execution& run, const Chosen& chosen) {
  Control& control = run.control;
  check_tool_unit(run, *chosen.word);
  AxisWords offset = control.frame.tool;
  control.modal.tool_of_offset = -1;
  control.length_doubt = Control::LengthDoubt::none;
  const bool has_rule = chosen.row->feed_rule != FeedRule::unknown;
  if (has_rule) check_no_plane(run, *chosen.word);
  control.tool_vectors = chosen.row->tool_vectors;
  control.centre_point = has_rule;
  if (control.tool_vectors) run.step.end_words = EndWords::tool_vector;
  control.feed_rule = run.settings.feed_rule.value_or(has_rule ? chosen.row->feed_rule : run.dialect.feed_rule);
  switch (chosen.row->action) {
    case Action::tool_tip_on:
    case Action::tool_length: {
      const int number = tool_of_block(run, chosen);
      offset = needed_offset(run, word_of_length(run, chosen), number);
      if (chosen.row->value < 0) offset = AxisWords{} - offset;  // G44
      mark_unknown_length(run, number);
      if (run.settings.tools.find(number) != nullptr) control.modal.tool_of_offset = number;
      break;
    }
    case Action::tool_length_added:
      if (!run.axes.empty() && !run.words.has('H')) {
        run.refuse(first_axis_word(run), codes::kNotInterpreted,
                   "G43.2 with axis words in place of H stops LinuxCNC 2.9 of before June 2024, and adds them to the "
                   "length after it",
                   "write the whole length with G43.1");
      }
      if (!run.axes.empty()) {
        run.refuse(first_axis_word(run), codes::kAxesTwice, "G43.2 takes H or axis words, and its block holds both",
                   "put the move into a block of its own");
      }
      offset += needed_offset(run, word_of_length(run, chosen), tool_of_block(run, chosen));
      break;
    case Action::tool_length_by_words:
      for (const Axis axis : kAllAxes) {
        if (run.words.find(axis) != nullptr) offset[axis] = run.value(axis);  // @ and ^ name axes without their words
      }
      break;
    default:
      offset = AxisWords{};
      break;
  }
  take_offset(run, offset);
  const bool by_tip = chosen.row->action == Action::tool_tip_on && offset != AxisWords{};
  control.length = by_tip ? Control::Length::by_tip : Control::Length::by_code;
  const bool may_move =
      run.dialect.behaviour.tool_length_moves && !run.words.has('Z') && !run.settings.as_with_empty_tables;
  if (may_move) control.known.erase(Axis::Z);
}

void restore_tool_length(Execution& run, bool in_force) {
  const Word word = run.first_word();
  check_tool_unit(run, word);
  run.control.modal.tool_of_offset = -1;
  if (!in_force) return take_offset(run, AxisWords{});
  const int number = tool_in_spindle(run, word);
  take_offset(run, needed_offset(run, word, number));
  if (run.settings.tools.find(number) != nullptr) run.control.modal.tool_of_offset = number;
}

// D0: no length; D1: that of the tool in the spindle, or of the one that will be.
void choose_edge(Execution& run, const Word& word) {
  Control& control = run.control;
  const int edge = run.whole(word, 0, kNoLimit);
  control.length_doubt = Control::LengthDoubt::none;
  control.modal.tool_of_offset = -1;
  control.edge = edge;
  control.edge_of_selected = false;
  if (edge == 0) return take_offset(run, AxisWords{});
  if (edge > 1) {
    run.refuse(word, codes::kToolUnknown, "a tool of the table has one edge, and this chooses another",
               "give the edge's length as a tool of its own");
  }
  control.edge_of_selected = control.modal.tool_in_spindle < 0 && control.modal.tool_in_spindle != kOfNoTable;
  take_edge(run, word, control.edge_of_selected ? control.selected_tool : control.modal.tool_in_spindle);
}

void select_tool(Execution& run, const Word& word) {
  run.control.selected_tool =
      word.use == WordUse::tool_name ? tool_by_name(run, word) : tool_number(run, word, "the number of a tool");
}

void forget_next_tool(Execution& run, const Word& code) {
  if (const Word* const tool = run.words.find('T')) {
    run.refuse(*tool, codes::kNotInterpreted,
               fmt::format("whether {} or {} of one block says which tool comes next was found in no source",
                           run.text_of(*tool), run.text_of(code)),
               "put them into blocks of their own");
  }
  run.control.selected_tool = 0;
}

void change_tool(Execution& run, const Chosen& chosen) {
  Control& control = run.control;
  const bool after_motion = chosen.row->order == Order::after_motion && run.motion != nullptr;
  run.step.tool_change = after_motion ? ToolChange::after_motion : ToolChange::before_motion;
  if (chosen.row->action == Action::set_tool) {
    control.modal.tool_in_spindle = tool_number(run, run.need('Q', "M61"), "the number of a tool");
    return;
  }
  // With M6 in a program T only prepares [Siemens, MD22550 1]; without it T changes the tool.
  if (control.moved_on_selected) {
    run.refuse(
        *chosen.word, codes::kToolUnknown,
        "M6 changes tools here, so the T before it only prepared one; but D took its length for moves before this",
        "write M6 before D and the first move, or say which tool is in the spindle: --tool-in-spindle");
  }
  control.edge_of_selected = false;
  control.modal.tool_in_spindle = control.selected_tool;
  if (run.dialect.behaviour.change_stops_spindle) control.turn_spindle(kSpindleStands);
  if (run.dialect.behaviour.tool_length_at_change && control.edge != 0) {
    take_edge(run, *chosen.word, control.modal.tool_in_spindle);
  }
  if (run.dialect.behaviour.tool_length_at_change) {
    control.length_doubt = control.edge == 0 ? Control::LengthDoubt::edge : Control::LengthDoubt::none;
    if (control.edge == 0) lose_tilted_tip(run);
  }
  if (chosen.row->value == kMacroOfUser) control.length_doubt = Control::LengthDoubt::macro;
  lose_unless_kept(run, chosen);
}

}  // namespace plumbline::nc
