// One block on its way through the interpreter: what it says, what it works on, what it has done so far.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nc/control/parameters/expression.hpp"
#include "nc/control/state/control.hpp"
#include "nc/control/step.hpp"
#include "nc/language/block_words.hpp"

namespace plumbline::nc {

/// A code of the block and its row; F, S and T have one as well.
struct Chosen {
  const CodeRow* row = nullptr;
  const Word* word = nullptr;
};

/// Of a word that a message speaks of.
std::string_view article_of(char letter);
/// ", and X#1 has no value here", where such a word counts as not written; else "".
std::string vacancy_in(const Block& block);

/// No upper limit for Execution::whole.
inline constexpr int kNoLimit = 1000000000;
/// The way out of a code that is not interpreted, where its row names none.
inline constexpr std::string_view kWriteItOut =
    "write it out in G0, G1, G2 and G3, with the control's simulator or the CAM system";

struct Execution {
  const Dialect& dialect;
  const ProgramSettings& settings;
  Control& control;
  const Block* block = nullptr;

  BlockWords words = {};
  AxisSet axes = {};                     // named in the block
  std::vector<Chosen> chosen = {};       // in order of execution
  const CodeRow* motion = nullptr;       // the motion that this block makes
  const Word* motion_word = nullptr;     // null: the mode in force
  const Word* machine_word = nullptr;    // G53
  bool uses_position_axes = false;       // the axis words are those of a code of group 0
  const Word* vector = nullptr;          // the first word of the direction of the tool: A3=, or I J K under G43.5
  bool has_word_modes = false;           // some axis word says itself how it counts: X=IC(5)
  int work_system_before = 0;            // G16: to be brought back after the block; 0: none
  bool block_in_machine_system = false;  // G16 H0

  Step step = {};
  ProgramCall call = {};
  std::vector<std::pair<int, Value>> arguments = {};  // of G65: number of the variable and its value
  std::vector<Motion> motions = {};
  std::vector<Hole> holes = {};  // of a cycle

  bool in_machine_system() const { return block_in_machine_system || control.in_machine_system; }
  [[noreturn]] void refuse(const Word& word, std::string_view code, std::string message, std::string help) const;
  /// Refuses with the first word of the block under the caret.
  [[noreturn]] void refuse(std::string_view code, std::string message, std::string help) const;
  /// Of the block; one that is the whole block where it has none, as where a subprogram ends.
  Word first_word() const;
  /// A word's value in mm (X Y Z I J K R) or as it stands.
  double length(const Word& word) const { return word.value * control.length_unit(); }
  double value(Axis axis) const {
    const Word& word = *words.find(axis);
    return is_rotary(axis) ? word.value : length(word);
  }
  /// Refuses a point in a word of whole numbers, at which a Fanuc stops.
  void refuse_point(const Word& word) const;
  /// A whole number that a word holds, from `least` to `most`.
  int whole(const Word& word, int least, int most) const;
  /// The code of the block's motion, or its first word where the mode in force goes on.
  const Word& motion_code() const;
  /// The word as it is written.
  std::string_view text_of(const Word& word) const { return block->at(word.span); }
  /// The row of the block's code that does this; null if it has none.
  const CodeRow* chosen_row(Action action) const;
  /// The same with its word.
  const Chosen* chosen_code(Action action) const;
  /// The word of that letter; refuses when it is missing.
  const Word& need(char letter, std::string_view code_text) const;
};

// How the block is read.
/// Whether the axis words of the block are increments: its own G90 or G91 counts, before its turn has come as well.
bool counts_increments(const Execution& run);
/// Finds the rows of all codes, their order, the motion; refuses what does not go together: resolve_codes.cpp
void resolve_codes(Execution& run);
/// @ or ^ of a block that has one of them.
const Word& polar_word(const Execution& run);
/// The word of an axis that the block names, or the one that stands for two: @ or ^.
const Word& first_axis_word(const Execution& run);
/// Finds its words and the rows of its codes, as they stand in the block; refuses words that stand for nothing, and two
/// codes of a group: gather_codes.cpp
void gather_codes(Execution& run);
/// The motion in force after G80: the G0 from before the cycle, where the dialect has it so; null: none.
const CodeRow* row_after_cycle(const Execution& run);
/// Refuses what stands beside a code that stands alone in its block: alone.cpp
void check_alone(const Execution& run);
/// Refuses what no source covers for a code beside the others of its block, or in the modes in force: contexts.cpp
void check_contexts(const Execution& run);
/// Refuses words that two codes of the block could take, and codes of which one would do nothing: shared_words.cpp
void check_shared_words(const Execution& run);
/// The same, of words whose meaning depends on the offsets that the block may have changed: before its motion.
void check_offsets_of_motion(const Execution& run);
void check_cycle(const Execution& run);
/// Refuses C-0 of an axis whose words have a sign for the way round, unless the control is known to keep that of 0.
void check_sign_of_zero(const Execution& run, const Word& word, Axis axis);
void check_milliseconds(const Execution& run, const Word& word, bool waits);
void check_cycle_beside_motion(const Execution& run);
void check_beside_dwell(const Execution& run);
/// Of an axis word that counts from where its axis stands.
void check_increment(const Execution& run, const Word& word, Axis axis);
/// Refuses one that is finer than what the control keeps: increments.cpp
void check_digits_of_increment(const Execution& run, const Word& word, Axis axis);
void check_words_before_call(const Execution& run);
/// Refuses M1=8: only of the spindle's codes it is known which one that is.
void check_extended(const Execution& run, const CodeRow& row, const Word& word);
/// Gives words without a decimal point the value that they have where the control counts its increments.
void count_increments(const Execution& run, Block& block);
/// What ROUND in the value of a word of this block rounds to.
Rounding rounding_of(const Execution& run, const Block& block, const Word& word);

/// Whether the block states a motion: G0 G80 G91 G28 Z0 states G0, whichever stands first.
bool sets_motion(const Execution& run);
/// Does what the code says, in its turn: actions.cpp
void act(Execution& run, const Chosen& chosen);

// What codes do, one file a family.
void set_motion_mode(Execution& run, const CodeRow& row);      // motion_modes.cpp
void state_motion_mode(Execution& run, const Chosen& chosen);  // by a code that moves nothing itself
/// G80.
void end_motion(Execution& run);
/// The move that the motion of the block makes.
void make_motion(Execution& run);
bool move_as_it_stands(Execution& run);  // machine_ways.cpp; false: an ordinary move
void set_tool_tip(Execution& run, const Chosen& chosen);
void set_return_level(Execution& run, const Word& code);  // cycle_levels.cpp
double cycle_return_level(const Execution& run, double r);
void check_cycle_spindle(const Execution& run, int code);  // cycle_checks.cpp
void check_cycle_start(const Execution& run, std::array<double, 2> hole, double r, double level);
void set_feed(Execution& run, const Word& word);  // feed_words.cpp
void set_feed_mode(Execution& run, FeedMode mode);
void choose_work_system(Execution& run, int system);         // offsets.cpp
void set_table(Execution& run);                              // G10
void set_position(Execution& run);                           // G92
void clear_position(Execution& run, Action action);          // G92.1 G92.2 G92.3
void go_home(Execution& run, int which);                     // homes.cpp: G28 G30
void store_home(Execution& run, int which);                  // G28.1 G30.1
void home_or_unit(Execution& run, const Chosen& chosen);     // G20 of the OSP
void set_tool_length(Execution& run, const Chosen& chosen);  // tools.cpp: G43 G43.1 G43.2 G49
/// The length of the tool in the spindle (G43 without H), or none (G49), at a block that names neither.
void restore_tool_length(Execution& run, bool in_force);
/// Refuses a move along Z, or one that turns, while it is not known whether a tool's length counts.
void check_length_known(const Execution& run);
[[noreturn]] void refuse_length_doubt(const Execution& run, const Word& word);
/// After a move of Z to a place of the machine, where that ends the length in force.
void end_length_at_home(Execution& run);
/// Refuses at `word` when the length unit has changed under the tool length in force.
void check_tool_unit(const Execution& run, const Word& word);
/// The offset of a tool that a code names; refuses one that no table has: tool_table.cpp
AxisWords needed_offset(const Execution& run, const Word& named, int number);
void set_tool_row(Execution& run);                                   // G10 L1
void set_tool_row_here(Execution& run, bool in_probe_table_system);  // G10 L10 L11
void select_tool(Execution& run, const Word& word);                  // T
void change_tool(Execution& run, const Chosen& chosen);              // M6 M61
void forget_next_tool(Execution& run, const Word& code);             // M63 of an OSP
void dwell(Execution& run, const Word& code);                        // machine_codes.cpp: G4
void call_program(Execution& run, const Chosen& chosen);             // M98 M99
void machine_code(Execution& run, const Chosen& chosen);             // M0 M1 M60, outputs, inputs, spindle, user codes
void move_straight(Execution& run);                                  // straight.cpp
void move_arc(Execution& run);                                       // arcs.cpp

void move_spline(Execution& run);                                    // splines.cpp: G5 G5.1
void add_nurbs_point(Execution& run);                                // G5.2
void move_nurbs(Execution& run);                                     // G5.3
void move_synchronised(Execution& run);                              // synchronised.cpp: G33 G33.1
void move_probe(Execution& run);                                     // probe.cpp: G38.2 to G38.5
void set_work_table(Execution& run);                                 // frames.cpp: G10 L2 and L20 of Fanuc
void choose_work_system(Execution& run, const Chosen& chosen);       // G54.1 P, G15 H, G16 H
void change_programmed_frame(Execution& run, const Chosen& chosen);  // G52, G68, G69, TRANS, ROT...
void begin_tilted_plane(Execution& run, const Word& code, const AxisWords& origin, const Turn& plane);
void define_tilted_plane(Execution& run, const Chosen& chosen);  // tilted_plane.cpp: G68.2
void turn_tool(Execution& run, const Chosen& chosen);            // G53.1
void turn_tool_on_plane(Execution& run, const Word& code);
void end_tilted_plane(Execution& run);  // G69
/// What C does where a direction leaves it open; the second refuses where no option says.
FreeRotation free_rotation(const Execution& run);
FreeRotation free_rotation(const Execution& run, const Word& word, std::string_view code);
/// What helps where C stays and its place is not known.
inline constexpr std::string_view kWhereCStands =
    "write a move of C before it, say where the machine stands at the begin (--start C=0) or that a stop or a change "
    "of tools before it leaves the axes where they stand (--keeps-position M1, M6), or say that C goes to zero: "
    "--free-rotation c-zero";
/// Refuses a move that a tilted plane does not allow.
void check_on_plane(const Execution& run);
void check_no_rotary_words(const Execution& run);
/// Refuses the code of `word` while a plane is tilted.
void check_no_plane(const Execution& run, const Word& word);
/// Whether words of the block give the direction of the tool; refuses them where no straight move takes them.
void find_tool_vector(Execution& run);  // tool_vector.cpp
void check_tool_vector(Execution& run);
/// A, B and C of a straight move along the direction.
void end_along_vector(const Execution& run, Motion& motion);
/// Refuses a move whose way or time depends on how the control turns the tool from one direction to the next.
void check_way_of_vector(const Execution& run, const Motion& motion);
void set_feed_group(Execution& run, const Chosen& chosen);         // FGROUP
void choose_transformation(Execution& run, const Chosen& chosen);  // TRAORI, TRAFOOF
void set_tolerances(Execution& run, const Chosen& chosen);         // CYCLE832
void choose_edge(Execution& run, const Word& word);                // tools.cpp: D
void call_macro(Execution& run);                                   // macro_call.cpp: G65

void set_modal_call(Execution& run);                               // cycle_calls.cpp: MCALL
void call_cycle(Execution& run, const CodeRow& row);               // CYCLE81(10,0,2,-15)
void drill_after_move(Execution& run);                             // where MCALL is in force
void check_no_modal_call(const Execution& run, const Word& word);  // there, of a move that may call it or not
void swivel(Execution& run, const Chosen& chosen);                 // swivel.cpp: CYCLE800
void move_in_cycle(Execution& run);                                // cycles.cpp: G73 G74 G81..G89

// What the moves share: moves.cpp
/// Of two points of a plane.
double distance(const std::array<double, 2>& a, const std::array<double, 2>& b);
/// Ends of a move in the active work system from the axis words, absolute or incremental.
AxisWords end_of_move(const Execution& run);
/// X and Y that @ and ^ mean for a move that begins at x, y.
std::array<double, 2> polar_end(const Execution& run, double x, double y);
/// The axes that words of the block send to a position, whatever the modes around them say.
AxisSet absolute_words(const Execution& run);
/// A rotary axis that LinuxCNC keeps within one turn (WRAPPED_ROTARY): its words have a sign for the way round.
bool is_wrapped(const Execution& run, Axis axis);
/// Refuses words of an offset that are a turn or more on such an axis.
void check_wrapped_words(const Execution& run);
/// Refuses a word that is a turn or more, of an axis whose words have a sign for the way round.
void check_within_turn(const Execution& run, const Word& word);
/// Refuses a word of a wrapped axis that stands there but for what rounding leaves.
void check_stands_there(const Execution& run, const Word& word, Axis axis, double from);
/// Which axes are known there.
AxisSet known_after_move(const Execution& run);
/// Refuses where one of these axes stands, which an offset will depend on, is not known.
void need_position(const Execution& run, AxisSet axes);
/// Those that a rapid sends to the end of their travel (Z9999): machine_ways.cpp
AxisSet axes_to_limits(const Execution& run);
/// Whether the tool is tilted there, or may be: its length counts along it then. The step notes that it is: tools.cpp
bool tilts_tool(Execution& run, AxisSet known, const AxisWords& at);
/// Every offset of the active work system must have been given.
void need_offsets(const Execution& run);
/// The feed of a move in the unit that Motion states; refuses when there is none.
double feed_of_move(const Execution& run, bool linear);
/// Refuses a block that makes more moves than a program may execute (--max-blocks), or than one block may.
void check_motions(const Execution& run, double count);
/// Adds the move and puts the control at its end.
void add_motion(Execution& run, const Motion& planned);
/// From here on the axes may stand anywhere.
void lose_position(Execution& run, AxisSet axes);
void lose_unless_kept(Execution& run, const Chosen& chosen);  // as its row and --keeps-position say

}  // namespace plumbline::nc
