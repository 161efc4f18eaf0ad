// A code beside others of its block, or in a mode, where no source says what a control makes of it: refused.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSameValue = 1e-9;

// G5.1 Q2 X0 Y0 Z0: the axes that the function works on.
void check_named_axes(const Execution& run, const Chosen& code) {
  for (const Axis axis : kAllAxes) {
    if (!code.row->takes_axes || !run.axes.contains(axis) || run.words.find(axis)->value == 0) continue;
    run.refuse(*run.words.find(axis), codes::kNotInterpreted,
               fmt::format("{} names the axes that it works on, by 0", run.block->at(code.word->span)),
               "write 0 after the axis, or put the move into a block of its own");
  }
}

void check_values(const Execution& run) {
  for (const Chosen& code : run.chosen) {
    const CodeRow& row = *code.row;
    if (row.only.empty()) continue;  // G5 P10001 is another function than G5 P10000
    const Word& word = run.need(row.only_letter, run.block->at(code.word->span));
    const bool known = std::any_of(row.only.begin(), row.only.end(), [&](double value) {
      return word.value > value - kSameValue && word.value < value + kSameValue;
    });
    if (known) check_named_axes(run, code);
    if (known) continue;
    run.refuse(word, codes::kNotInterpreted, fmt::format("{} {}", run.block->at(code.word->span), row.reason()),
               std::string(row.way_out().empty() ? kWriteItOut : row.way_out()));
  }
}

void check_moves_beside(const Execution& run) {
  for (const Chosen& code : run.chosen) {
    const bool moves = run.motion != nullptr || (!run.axes.empty() && !code.row->takes_axes);
    if (!code.row->alone || !moves) continue;
    run.refuse(*code.word, codes::kNotInterpreted,
               fmt::format("{} beside {} is not interpreted: the control takes it in a block of its own",
                           run.block->at(code.word->span), run.motion != nullptr ? "a move" : "words of axes"),
               "put the other words into the block after it");
  }
}

// G30 P1, G20 HP=4: to a place that the machine keeps, by no words of axes.
void check_beside_home(const Execution& run) {
  if (run.motion == nullptr && run.axes.empty()) return;
  for (const Chosen& code : run.chosen) {
    const bool by_number = code.row->action == Action::lose_position && !code.row->takes_axes;
    if (!by_number && (code.row->action != Action::home_or_unit || !run.words.has('2'))) continue;
    run.refuse(*code.word, codes::kNotInterpreted,
               fmt::format("{} goes to a position of the machine's own: what words of axes and a move beside it do was "
                           "found in no source",
                           run.text_of(*code.word)),
               "put the move into a block of its own");
  }
}

void check_m_codes(const Execution& run) {
  const int most = run.dialect.behaviour.most_m_codes;
  int count = 0;
  for (const Word& word : run.block->words) {
    if (word.letter != 'M' || ++count <= most || most == 0) continue;
    run.refuse(word, codes::kSameGroup, fmt::format("more than {} M codes in one block", most),
               "put them into blocks of their own");
  }
}

// In which unit the words of such a block count stands in no source.
void check_words_beside_unit(const Execution& run) {
  const std::string& unknown = run.dialect.behaviour.unknown_beside_unit;
  if (unknown.empty()) return;
  const Chosen* code = run.chosen_code(Action::inches);
  if (code == nullptr) code = run.chosen_code(Action::millimetres);
  if (code == nullptr || (code->row->action == Action::inches) == run.control.modal.inches) return;
  for (const Word& word : run.block->words) {
    if (unknown.find(word.letter) == std::string::npos) continue;
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} beside {}, which changes the unit: in which of the two it counts is not known",
                           run.block->at(word.span), run.block->at(code->word->span)),
               "put the change of units into a block of its own before");
  }
}

bool belongs_to_dwell(const Execution& run, const CodeRow& dwell, const Word& word) {
  return run.dialect.row_of(word) == &dwell || (!is_code(word) && (letter_bit(word.letter) & dwell.word_mask) != 0);
}

// Whatever it does, no axis is known after it; whether a tool's length goes on counting is another matter.
bool goes_home_unknown(const Execution& run, const CodeRow& row) {
  return row.action == Action::go_home && run.dialect.behaviour.bare_home_loses_position &&
         run.control.frame.tool == AxisWords{};
}

// G28 alone: all axes, or none.
void check_axes_needed(const Execution& run) {
  if (!run.axes.empty()) return;
  for (const Chosen& code : run.chosen) {
    if (!code.row->needs_axes || goes_home_unknown(run, *code.row)) continue;
    run.refuse(
        *code.word, codes::kAxesMissing,
        fmt::format("{} names no axis, and what it does then depends on the control", run.block->at(code.word->span)),
        "add the words of the axes that are meant, as in G28 Z0");
  }
}

// G91 G52 X5: to X5, or 5 further.
void check_absolute(const Execution& run) {
  if (!counts_increments(run)) return;
  for (const Chosen& code : run.chosen) {
    if (!code.row->absolute_alone) continue;
    run.refuse(
        *code.word, codes::kNotInterpreted,
        fmt::format("whether {} counts increments under G91 differs between controls", run.block->at(code.word->span)),
        "write G90 before it");
  }
}

// TRANS X=IC(5): whether it adds there stands in no source.
void check_word_modes(const Execution& run) {
  if (!run.has_word_modes || !run.uses_position_axes) return;
  for (const Axis axis : kAllAxes) {
    const Word* const word = run.words.find(axis);
    if (word == nullptr || word->mode == WordMode::modal || word->mode == WordMode::absolute) continue;
    run.refuse(*word, codes::kNotInterpreted,
               fmt::format("{} is no word of a move here, and what it counts from was found in no source",
                           run.block->at(word->span)),
               "write the value itself");
  }
}

// G28, G54, G92 and their like while G68 is in force: the manual forbids them.
void check_turned(const Execution& run) {
  const bool turns = run.control.turn_deg != 0 || run.chosen_row(Action::turn_on) != nullptr;
  if (!turns || run.chosen_row(Action::turn_off) != nullptr) return;
  for (const Chosen& code : run.chosen) {
    if (!code.row->unturned) continue;
    run.refuse(*code.word, codes::kNotInterpreted,
               fmt::format("{} stands where the coordinates are turned, and moves otherwise than it says there",
                           run.block->at(code.word->span)),
               "end the turn before it, with G69");
  }
}

// G54 P48 is G54.1 P48 as well, whoever else of the block takes the P.
void check_not_beside(const Execution& run) {
  for (const Chosen& code : run.chosen) {
    if (code.row->not_beside == 0) continue;
    const Word* const word = run.words.find(code.row->not_beside);
    if (word == nullptr) continue;
    run.refuse(*word, codes::kNotInterpreted,
               fmt::format("{} beside {} chooses another work system, and may belong to another code of the block",
                           run.block->at(word->span), run.block->at(code.word->span)),
               "put the work system into a block of its own; write further ones as G54.1 P1");
  }
}

// X alone: whether Y stays where it stands or goes to its old word in the turned system is a setting of the control.
void check_alone_after_turn(const Execution& run) {
  const AxisSet named = run.axes & kTurningAxes;
  if (!run.dialect.behaviour.turned_axis_alone_unknown || named.empty()) return;
  const AxisSet other = kTurningAxes - named;
  if (other.empty() || (run.control.shifted & other).empty() || !run.control.known.contains(other)) return;
  if (run.control.modal.incremental || run.machine_word != nullptr) return;
  const Axis axis = named.contains(Axis::X) ? Axis::X : Axis::Y;
  run.refuse(*run.words.find(axis), codes::kNotInterpreted,
             fmt::format("{} alone after a turn of the coordinates: where the other axis goes depends on the settings "
                         "of the control",
                         letter(axis)),
             "name both X and Y in the first move after G68 and G69");
}

// R and the depth of a cycle count from where the axis stands.
void check_cycle_increments(const Execution& run) {
  if (run.motion->action != Action::cycle || !counts_increments(run)) return;
  const Axis normal = axes_of(run.control.modal.plane).third;
  const bool with_length =
      run.dialect.behaviour.increment_unknown_after_length && run.chosen_code(Action::tool_length) != nullptr;
  if (with_length) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "whether the increments of this cycle bring the tool length of its block along is not known",
               "put the tool length into a block of its own before, with G90 and a position");
  }
  if (const Word* const word = run.words.find('R')) check_increment(run, *word, normal);
  for (const Axis axis : kAllAxes) {
    if (const Word* const word = run.words.find(axis)) check_increment(run, *word, axis);
  }
}

// X5. M98 P8 in a cycle: P is the program, or the time to wait as well [Haas 96-8000, p. 191].
void check_words_of_call(const Execution& run, const CodeRow& call) {
  for (const char letter : call.words) {
    const Word* const word = run.words.find(letter);
    if (word == nullptr || (run.motion->word_mask & letter_bit(letter)) == 0) continue;
    run.refuse(*word, codes::kNotInterpreted,
               fmt::format("{} belongs to the call of a program, and may be taken for a word of the drilling cycle",
                           run.text_of(*word)),
               "put the call into a block of its own, without axis words");
  }
}

// G84 S400 F400.: the manual has it drill nothing, as long as no R stands there either [B-64484EN, canned cycles].
[[noreturn]] void refuse_cycle_without_place(const Execution& run) {
  run.refuse(run.motion_code(), codes::kAxesMissing,
             fmt::format("{} without X, Y or Z: whether it drills where the tool stands, and which of its words the "
                         "next hole takes, differs between controls",
                         run.text_of(run.motion_code())),
             "write it into the block of the next hole, beside X and Y");
}

// Which axis drills there, and when a tool's length counts in.
void check_beside_cycle(const Execution& run) {
  const bool drills = run.motion != nullptr && run.motion->action == Action::cycle;
  if (!drills || !run.dialect.behaviour.fanuc_cycles) return;
  const Chosen* other = run.chosen_code(Action::plane_zx);
  if (other == nullptr) other = run.chosen_code(Action::plane_yz);
  const bool in_xy = run.control.modal.plane == Plane::xy || run.chosen_code(Action::plane_xy) != nullptr;
  if (other != nullptr || !in_xy) {
    run.refuse(other != nullptr ? *other->word : run.motion_code(), codes::kNotInterpreted,
               run.dialect.behaviour.return_levels
                   ? "along which axis the cycles drill in G18 and G19 was found in no source"
                   : "which axis drills in G18 and G19 is said by a parameter of the control (5101 FXY)",
               "write G17 before it, and drill along Z");
  }
  const Chosen* const off = run.dialect.behaviour.return_levels ? run.chosen_code(Action::motion_off) : nullptr;
  if (off != nullptr) {
    run.refuse(
        *off->word, codes::kSameGroup,
        fmt::format("{} beside a drilling cycle: whether it ends that, or the one before, was found in no source",
                    run.text_of(*off->word)),
        "put them into blocks of their own");
  }
  if ((run.axes & AxisSet::linear()).empty() && !run.dialect.behaviour.return_levels) refuse_cycle_without_place(run);
  for (const Chosen& code : run.chosen) {
    if (code.row->action == Action::call_program || code.row->action == Action::end_program) {
      check_words_of_call(run, *code.row);
    }
    if (code.row->action != Action::tool_length && code.row->action != Action::tool_length_off) continue;
    run.refuse(
        *code.word, codes::kNotInterpreted,
        fmt::format("{} beside a drilling cycle acts on the way to R, and which level the tool goes back to then "
                    "is not known",
                    run.block->at(code.word->span)),
        "put it into a block of its own, with Z");
  }
}

// MCALL CYCLE81(...): in some blocks without a move the control is said to call it, too. F and S beside G4 are its time
// [N 4.3].
void check_modal_call(const Execution& run) {
  if (run.control.modal_call.row == nullptr || !run.axes.empty()) return;
  if (run.chosen_row(Action::modal_call) != nullptr || run.chosen_row(Action::dwell) != nullptr) return;
  for (const Word& word : run.block->words) {
    const CodeRow* const row = is_code(word) ? run.dialect.row_of(word) : nullptr;
    const bool moves = row != nullptr && (row->action == Action::rapid || row->action == Action::feed);
    if (!moves && word.letter != 'F' && word.letter != 'S') continue;
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} is in force after each move: whether it is called after a block with {} and no move was "
                           "found in no source",
                           run.control.modal_call.row->name, run.block->at(word.span)),
               "write it before MCALL, or beside a move");
  }
}

}  // namespace

bool counts_increments(const Execution& run) {
  if (run.chosen_code(Action::incremental) != nullptr) return true;
  return run.control.modal.incremental && run.chosen_code(Action::absolute) == nullptr;
}

void check_contexts(const Execution& run) {
  check_values(run);
  check_moves_beside(run);
  check_beside_home(run);
  check_m_codes(run);
  check_words_beside_unit(run);
  check_axes_needed(run);
  check_absolute(run);
  check_word_modes(run);
  check_turned(run);
  check_not_beside(run);
  check_shared_words(run);
  check_beside_cycle(run);
  check_modal_call(run);
  check_length_known(run);
}

// A turn or a work offset of the block itself counts already.
void check_offsets_of_motion(const Execution& run) {
  check_alone_after_turn(run);
  check_cycle_increments(run);
}

// The first that may be, of those behind the code if there is one.
const Word* time_of_dwell(const Execution& run, const CodeRow& dwell) {
  std::array<const Word*, 2> times{};  // before the code, and behind it
  bool coded = false;
  for (const Word& word : run.block->words) {
    if (!belongs_to_dwell(run, dwell, word)) continue;
    coded = coded || is_code(word);
    const Word*& time = times[coded ? 1 : 0];
    if (!is_code(word) && time == nullptr) time = &word;
  }
  return times[1] != nullptr ? times[1] : times[0];
}

// What the control does with other words beside G4 is in no source.
void check_beside_dwell(const Execution& run) {
  using Beside = ControlBehaviour::Beside;
  const Beside allowed = run.dialect.behaviour.beside_dwell;
  const CodeRow* const dwell = allowed <= Beside::no_arcs ? nullptr : run.chosen_row(Action::dwell);
  if (dwell == nullptr) return;
  const Word* const time = time_of_dwell(run, *dwell);
  for (const Word& word : run.block->words) {
    const bool second = !is_code(word) && &word != time && belongs_to_dwell(run, *dwell, word);
    if (belongs_to_dwell(run, *dwell, word) && !second) continue;
    if (allowed == Beside::no_axes && !axis_of(word.letter) && !second) continue;
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} stands beside a dwell, and what the control does with it then was found in no source",
                           run.block->at(word.span)),
               time != nullptr || dwell->words.find('F') == std::string::npos
                   ? "put the dwell and the other words into blocks of their own"
                   : "write the time of a dwell as F, in seconds; other words into blocks of their own");
  }
}

// Whether the first increment brings along what TRANS, G55, a turn or a tool's length changed is not known.
void check_increment(const Execution& run, const Word& word, Axis axis) {
  const Control& control = run.control;
  check_digits_of_increment(run, word, axis);
  if (!control.shifted.contains(axis) || !(control.known | control.turned).contains(axis)) return;
  if (word.value == 0 && run.chosen_row(Action::go_home) != nullptr) return;  // it ends at home, whatever counts
  const std::string absolute =
      run.dialect.syntax.word_modes ? fmt::format("G90 or {}=AC(..)", letter(axis)) : std::string("G90");
  run.refuse(
      word, codes::kNotInterpreted,
      fmt::format("whether this increment brings along the offset that changed before it depends on the settings "
                  "of the control, and {} had no absolute word since",
                  letter(axis)),
      fmt::format("move {} once by an absolute word after the change, with {}", letter(axis), absolute));
}

// Of G1 and G81 in one block the control makes what its series does: one group or two [B-62764EN 13.1].
void check_cycle_beside_motion(const Execution& run) {
  const Chosen* const cycle = run.chosen_code(Action::cycle);
  if (cycle == nullptr) return;
  const Chosen* const off = run.chosen_code(Action::motion_off);
  if (off != nullptr && off->word > cycle->word) {
    run.refuse(*off->word, codes::kSameGroup,
               fmt::format("{} after a canned cycle, in its block", run.block->at(off->word->span)),
               "put them into blocks of their own");
  }
  for (const Chosen& code : run.chosen) {
    const bool moves = code.word->letter == 'G' && code.row->group == kMotionGroup &&
                       code.row->action != Action::cycle && code.row->action != Action::motion_off;
    if (!moves) continue;
    run.refuse(*code.word, codes::kSameGroup, fmt::format("{} beside a canned cycle", run.block->at(code.word->span)),
               "put them into blocks of their own");
  }
}

// Some controls take P1.5 and P2. for seconds, others stop at them.
void check_milliseconds(const Execution& run, const Word& word, bool waits) {
  if (run.dialect.behaviour.dwell_p_s == 1) return;
  if (!(waits && word.point) && word.value == std::floor(word.value)) return;
  run.refuse(word, codes::kNotWhole,
             fmt::format("P counts whole milliseconds without a point, and {} is none", run.block->at(word.span)),
             run.chosen_row(Action::dwell) != nullptr ? "write milliseconds without a point, or X and seconds"
                                                      : "write milliseconds without a point");
}

void check_words_before_call(const Execution& run) {
  for (const Word& word : run.block->words) {
    const CodeRow* const row = word.letter == 'G' ? run.dialect.row_of(word) : nullptr;
    if (row != nullptr && row->action == Action::call_macro) return;
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} before the call of a macro is no argument of it", run.block->at(word.span)),
               "put it into a block of its own before, or, as an argument, after the call");
  }
}

}  // namespace plumbline::nc
