// What a control's language is made of: a table, read from grammar/<name>.toml, compiled into the program.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "nc/language/block.hpp"
#include "nc/language/feed_rule.hpp"

namespace plumbline::nc {

/// When inside its block a word is executed.
enum class Order : std::uint8_t { before_motion, with_motion, after_motion };

/// What the interpreter does at a code; the names that the tables use, word for word.
enum class Action : std::uint8_t {
  refused,  // known, and not interpreted for the reason that its row states
  rapid,
  feed,
  arc_cw,
  arc_ccw,
  motion_off,
  dwell,
  plane_xy,
  plane_zx,
  plane_yz,
  inches,
  millimetres,
  absolute,
  incremental,
  arc_centre_absolute,
  arc_centre_incremental,
  inverse_time,
  per_minute,
  per_revolution,
  exact_path,
  exact_stop,
  continuous,
  compensation_off,
  work_system,
  set_table,
  set_position,
  clear_position,
  suspend_position,
  restore_position,
  machine_coordinates,
  go_home,
  store_home,
  tool_length,
  tool_length_by_words,
  tool_length_added,
  tool_length_off,
  change_tool,
  set_tool,
  stop,
  end,
  orient_spindle,
  set_output,
  read_input,
  set_analog_output,
  cycle,
  retract_to_start,
  retract_to_r,
  call_program,
  end_program,
  save_modes,
  forget_modes,
  restore_modes,
  save_modes_of_call,
  lose_position,         // the axes go where only the machine knows
  modal_call,            // MCALL
  called_cycle,          // CYCLE81(10,0,2,-15): the values stand in brackets
  swivel,                // CYCLE800(1,"T",0,57,...): a tilted plane, and the tool on it; CYCLE800() ends it
  home_or_unit,          // with a P word that; alone a statement of the unit: value 0 mm, 1 inches
  arc_through_point,     // CIP
  call_macro,            // G65
  set_work_table,        // G10 L2 and L20 of a control whose L20 names further work systems
  local_shift,           // G52
  turn_on,               // G68
  turn_off,              // G69
  tilted_plane,          // G68.2
  tool_on_plane,         // G53.1
  frame_new,             // TRANS, ROT: the programmable frame is this
  frame_added,           // ATRANS, AROT
  feed_group,            // FGROUP
  tolerance_cycle,       // CYCLE832, which older programs let choose a transformation
  transformation,        // TRAORI, TRAFOOF: what is always so, where no frame is in force
  exact_stop_once,       // G9: of this block alone
  work_system_by_word,   // G54.1 P3, G15 H3
  work_system_of_block,  // G16 H3: of this block alone
  tool_edge,             // D
  no_motion,             // changes nothing that motion depends on
  no_next_tool,          // the tool change to come puts a tool back and takes none
  tool_tip_on,           // with H a tool's length; axis words go to a point
  tool_tip_off,
  return_level,      // G71: where cycles go back to under M53
  no_hole,           // NCYL: to above the hole, and no further
  surface_speed,     // G96: S is the speed of the surface; value 1: on
  cubic_spline,      // G5
  quadratic_spline,  // G5.1
  nurbs_point,       // G5.2
  nurbs_end,         // G5.3
  synchronised,      // G33
  rigid_tap,         // G33.1
  probe,             // G38.2 to G38.5
  compensation_on,   // G41, G42: refused
  spindle,           // M3, M4, M5
  coolant,           // M7, M8, M9
  override_switch,   // M48 to M53
  position_spindle,  // SPOS, M19: it stands from then on
  main_spindle,      // SETMS: S, M3 to M5 and feeds per revolution are of this spindle
  speed_limit,       // LIMS: a spindle's speed is no greater, in some feed modes
  feed_word,
  speed_word,
  tool_word,  // F, S and T, which take their turn among the codes
  user_code,  // a code of the machine's builder
};

inline constexpr int kMotionGroup = 1;  // as the tables of all dialects number them
inline constexpr int kFeedModeGroup = 5;

/// A row of the table of G or M codes.
struct CodeRow {
  int code = 0;         // times ten: G5.1 is 51
  int group = 0;        // modal group: two of one group do not stand in one block
  std::string meaning;  // "feed", "plane_xy", ...: what the interpreter does at it
  std::string words;    // letters that belong to it
  Order order = Order::before_motion;
  Action action = Action::refused;  // the meaning, to switch on
  int value = 0;                    // which one of several: of the work systems, of the homes
  std::uint8_t step = 0;            // its turn inside a block
  std::uint32_t word_mask = 0;      // the words, A is bit 0
  std::uint32_t stays_mask = 0;     // of a cycle: with one of these words its holes stay cycles
  bool takes_axes = false;          // the axis words of the block are its own
  bool loses_position = false;      // the axes may stand elsewhere after it
  bool harmless = false;            // may stand after / without a choice
  std::string name;                 // of a code that is no letter and number
  std::string why;                  // refused, alone or with other values than those of `only`: why
  char only_letter = 0;             // 0: any value; else the word whose value must be one of these
  std::vector<double> only;
  bool alone = false;                      // no move stands beside it
  bool needs_axes = false;                 // without an axis word it is not known what it does
  bool absolute_alone = false;             // what it does under G91 is not known
  bool unturned = false;                   // not while the work system is turned by the program
  char not_beside = 0;                     // a letter that makes another code of it where it stands in the block:
  int beside_is = 0;                       // ten times that code; 0: refused
  FeedRule feed_rule = FeedRule::unknown;  // of a tool length: with it in force; unknown: the dialect's
  bool has_arguments = false;              // a name with ( ) after it, which the interpreter does not look into
  bool order_unknown = false;              // whether it acts before the move of its block or after it
  std::string levels;                      // which of these are heights of the work, digits that count from 0
  bool has_values = false;                 // a name with values in ( ) after it
  bool tool_vectors = false;               // of a tool length: I, J, K are the direction of the tool with it in force
  std::string written_as;                  // the code that is written instead, with A, B and C or on its own

  std::string_view reason() const;   // what stands before "; " in why
  std::string_view way_out() const;  // and after it; empty: nothing does
};

/// How a program says where it goes on: which grammar its lines have.
enum class Statements : std::uint8_t {
  o_words,     // RS274/NGC
  macro_b,     // IF [..] GOTO 10, WHILE [..] DO 1
  user_task,   // IF [..] NAME, GOTO NAME, CALL OSUB
  high_level,  // IF .. ELSE ENDIF, GOTOF NAME, SUB(1,2)
};

/// What a block that is jumped to begins with.
enum class Labels : std::uint8_t {
  numbers,         // N10
  sequence_names,  // N10, NLAP
  names,           // N10, NAME:
};

/// Which variables are the control's own.
enum class SystemVariables : std::uint8_t {
  rs274,    // #5161 and further, and names (#<_x>)
  macro_b,  // #3000 and further
  none,     // they have names of their own, or none is read
};

/// The language of the lines that a guard consists of.
enum class GuardLanguage : std::uint8_t { none, linuxcnc, macro_b, sinumerik };

/// What a name in a program means.
struct NameMeaning {
  enum class Kind : std::uint8_t { code, address, keyword, function, operation, variable, own };
  Kind kind = Kind::code;
  int which = 0;             // row of named_codes, letter, FlowWord, Operation, place in variables
  int arguments = 0;         // of a function
  double value = 0;          // of one without arguments, as PI
  bool tool_vector = false;  // of an address: part of the direction of the tool
};

/// Variables that have numbers, as R1 or VC[3]: they are kept as parameters `at`, `at` + 1...
struct NumberedVariables {
  std::string name;
  int first = 0, last = 0, at = 0;
};

inline constexpr int kNoVariable = -2;

/// How the control reads what is written. dialect_keys.hpp says what is called so in a table.
struct Syntax {
  Statements statements = Statements::o_words;
  bool names = false;               // words, values and codes may be names
  bool semicolon_ends = false;      // ; is the end of a block: nothing but comments in ( ) stands after it
  bool percent_text = false;        // after the first % there may be text
  bool percent_pairs = false;       // % ends a program only if it began with one
  bool archive_heads = false;       // %_N_NAME_MPF begins a program
  bool skip_switches = false;       // /2: a block skip of its own switch
  bool spindle_words = false;       // $ chooses one of several spindles
  bool polar_words = false;         // @ and ^ give an end in X and Y by radius and angle
  bool comma_corners = false;       // a comma begins a corner that the control works out (,C ,R ,A)
  bool word_modes = false;          // X=AC(5), A=DC(5)
  bool open_assignment = false;     // what is assigned needs no brackets
  bool settings_at_once = false;    // all values of a block are found before any is set
  bool exponents = false;           // 8.2EX-3
  bool one_sign = false;            // X--5 is a slip, not X5
  bool repeated_ijk = false;        // I, J and K may stand more than once (arguments of a macro)
  bool capitals = false;            // small letters of a file are dropped where it is read in
  bool rounds_to_zero = false;      // FIX and FUP
  bool bitwise = false;             // AND, OR, XOR work on the bits of whole numbers and bind like * and +
  bool full_turn = false;           // ATAN gives 0 to 360, ASIN of a negative number is refused
  bool exists_numbers = false;      // EXISTS[#5] asks for a number as well
  bool unsourced_values = false;    // ROUND(-2.5), -2.5 in an INT and ATAN2(0,0) are in no source: refused
  bool relations_last = false;      // == binds weaker than AND: both in one bracket are refused
  bool declared = false;            // a variable that has a name is declared before it is set (DEF)
  bool settings_alone = false;      // such a variable is set in a block without words, and has two letters or more
  bool empty_names = false;         // one that was never set has no value; else reading it is refused
  bool drops_vacant_words = false;  // a word whose value is a vacant variable is as if not written
  bool calls_by_name = false;       // a name that means nothing else is a subprogram
  bool zero_calls_unknown = false;  // whether a call that asks for none is executed is not known
  bool numbered_loops = false;      // DO 1 ends at END 1
  bool branches = false;            // IF without a jump begins a branch: there is a keyword that ends it
  bool case_of_files = false;       // the case of letters counts in names of subprograms' files
  char call_letter = '\0';          // L10 calls the subprogram of that name
  char program_letter = '\0';       // O and a name begin a program
  char open = '[';                  // of expressions of a language with names
  char goes_on = '\0';              // lines that begin with it belong to the block of the line before
  Labels labels = Labels::numbers;
  SystemVariables system_variables = SystemVariables::none;
  double equal_within = 1e-4;  // EQ and NE
  double relative_within = 0;  // of the larger of two numbers: what is no further apart is the same
  double doubtful_within = 0;  // numbers that differ by less, of them or of 1, may be the same to the control
  int local_variables = 30;    // #1... of a subprogram
  int last_variable = 5601;
  /// Variables that outlast the program, which may need them for itself alone; 0: none are told from others.
  int first_lasting = 0, last_lasting = 0;
  bool restates_lasting = false;       // where a program is written out, it sets them once, at its end
  int alarm_variable = kNoVariable;    // setting it stops the control
  int message_variable = kNoVariable;  // setting it shows a message and stops as M0 does
  bool draws = false;                  // DEF WORK ... END: the blank that the control draws
  bool truths_only = false;            // AND, OR: whether they join truths or bits is not known
  std::string reserved;                // names of the control's own variables begin with this
  std::string travel_ends;             // with the letter of an axis behind it: the end of its travel, such a variable
  std::unordered_map<std::string, NameMeaning> meanings;  // upper case; NAME*: with any digits
  std::uint32_t address_letters = 0;                      // that only stand for names, as P for TURN=: no words alone
  std::vector<NumberedVariables> variables;
  std::vector<std::string> subprogram_files;  // what a file of a subprogram is called: {} stands for its name
};

/// How the control executes what it has read, where controls differ.
struct ControlBehaviour {
  bool last_of_group = false;             // of two codes of a group the last one counts
  bool bare_motion_code_is_mode = false;  // G1 F500 alone moves nothing
  bool bare_home_loses_position = false;  // G28 without axes: all go home, or none
  bool rapid_before_codes = false;        // axis words before the first motion code and the first F
  bool group_0_takes_axes = false;        // G0 G91 G28 Z0: the words are G28's, and G0 is the mode from here on
  bool no_work_system_at_start = false;
  bool always_point = false;                                       // numbers are written with a decimal point
  double increment_mm = 0, increment_inch = 0, increment_deg = 0;  // what a number without a point counts; 0: units
  bool increment_of_rest_unknown = false;  // where another is set, of numbers with a point: refused
  double feed_per_revolution_increment = 0;
  bool keeps_increment = false;        // of a number no more than these are kept
  bool round_keeps_increment = false;  // ROUND in the value of a word rounds to these, too
  bool zero_has_sign = false;          // C-0 turns downwards where the sign of a word says the way round
  std::string whole_words;             // letters whose values are whole numbers, and written without a point
  double increment_word_mm = 0, increment_word_inch = 0, increment_word_deg = 0;  // kept of a word under G91; 0: all
  bool increment_word_always = false;        // under G90 as well, and a finer word under G91 is refused
  int most_digits = 0;                       // of a number; 0: any
  bool m_beside_cut_unknown = false;         // when codes of the builder act beside a move
  bool change_beside_move_unknown = false;   // whether M6 comes before the move of its block or after it
  double inverse_time_increment = 0;         // of F under G93; 0: units
  bool inverse_time_by_radius = false;       // F of an arc under G93 is feed over radius, not 1 over the time
  bool helix_feed_along_circle = false;      // F of an arc is the speed along its circle, whatever else moves with it
  bool feed_inch_increment_unknown = false;  // what F without a point counts under G20
  bool machine_move_is_rapid = false;        // G53 goes as G0 whatever is in force
  bool offset_numbers_last = false;  // D and H stay in force without a code that uses them: G43 needs an H of its own
  bool machine_move_tool_unknown = false;  // whether G53 counts to the tip while a length is in force
  bool home_ends_length = false;  // G28, G30 and G53 of Z end a tool's length; whether it comes back is not known
  bool unit_change_length_unknown = false;  // what a length in force is worth after G20, G21
  bool h0_is_no_tool = false;
  bool length_needs_number = false;         // without H the tool length is not that of the tool in the spindle
  bool tool_length_moves = false;           // whether G43 without Z moves depends on the control's parameters
  std::string unknown_beside_unit;          // words of which it is not known in which unit they count beside G20, G21
  bool unit_change_drops_feed = false;      // what F is worth after G20, G21 is not known
  bool tool_length_at_change = false;       // M6 puts the length of the tool in force
  bool fanuc_cycles = false;                // over the hole first, then to R; K repeats; taps and bores feed to R alone
  double peck_gap_mm = 0.254;               // a peck begins so far above the one before
  double chip_break_mm = 1;                 // the way back that breaks the chips, where a called cycle gives none
  bool passed_code_keeps_position = false;  // who passes it says so
  int most_m_codes = 0;                     // that a block may hold; 0: any
  bool call_with_moves = false;             // M98 may stand in a block that moves
  int least_calls = 0;                      // that an L asks for
  int call_repeat_digits = 0;               // M98 P00030010: digits of the program's number
  bool table_increments = false;            // G10 L2 under G91 adds
  bool end_returns = false;                 // M2, M30 in a subprogram end it alone
  bool turns_are_extra = false;             // the count of an arc's turns does not hold the begun one
  double dwell_p_s = 1;                     // what P of G4 counts
  enum class Beside : std::uint8_t { anything, no_arcs, no_axes, nothing };
  Beside beside_dwell = Beside::anything;         // what may stand in a block with G4
  bool inch_turn_unknown = false;                 // what a degree counts beside inches
  bool inch_turn_per_revolution_unknown = false;  // F of a move of A, B, C alone under G20 and G95
  bool dwell_unknown_per_revolution = false, dwell_unknown_inverse_time = false;  // what the word of G4 counts then
  int feed_decimals = 9;                                                          // of F, whatever its size
  bool h0_is_machine = false;                                                     // G15 H0, G16 H0: machine coordinates
  double travel_limit_mm = 0;             // a rapid to this or more goes to the end of the axis' travel; 0: none does
  bool return_levels = false;             // cycles go back to the level of G71 or to R, as M53 and M54 say
  bool cycle_off_stops_spindle = false;   // G80
  bool cycles_exact_path = false;         // their moves end exactly, under G64 as well
  bool rapid_after_cycles = false;        // G80 ends the cycle alone: the G0 from before it is in force again
  bool inverse_time_arc_unknown = false;  // what F of an arc says under G93
  bool radius_alone_stands = false;       // G2 R5 without an end: the tool stays
  bool set_position_unknown_elsewhere = false;                  // what G92 is under G91, and in another work system
  bool radius_positive = false;                                 // R of an arc: what less than 0 asks for is not known
  bool increment_unknown_after_offset = false;                  // TRANS, G55: whether G91 brings it along
  bool increment_unknown_after_length = false;                  // D1, G43 H1: likewise
  bool increment_unknown_after_turn = false;                    // ROT, G68: likewise
  bool turned_axis_alone_unknown = false;                       // G68, then X without Y
  bool dwell_takes_words = false;                               // F and S beside G4 are its time
  bool length_set_at_start = false, unit_set_at_start = false;  // a tool's length, G20 may be in force at the start
  bool starts_with_stops = false;     // where the program states nothing else each block may end standing
  bool feed_mode_drops_feed = false;  // G94 drops the F before it even where it is in force already
  bool change_stops_spindle = false;  // M6
  bool even_spirals = false;  // an arc whose radius is a little longer at its end than at its start gets there evenly
  bool arcs_turn = false;     // A, B and C may move beside an arc, evenly with its angle
  bool local_shift_adds = false;  // to what ATRANS added: G58 of a SINUMERIK
};

/// The largest F that the control takes under G93, per minute; 0: any.
double largest_inverse_feed(const ControlBehaviour& behaviour);

/// By what programs show which dialect they are in: recognise.hpp.
struct DialectMarks {
  std::vector<std::string> marks;              // what only programs for this control hold
  std::vector<std::string> weak_marks;         // what counts where nothing else does
  std::vector<std::string> file_endings;       // upper case
  std::vector<std::string> weak_file_endings;  // what counts where the text shows nothing but weak marks
};

struct Dialect {
  std::string name;
  Syntax syntax;
  ControlBehaviour behaviour;
  std::vector<CodeRow> named_codes;
  std::vector<CodeRow> at_start;  // codes that are in force before the program
  int work_systems = 9;
  std::vector<CodeRow> g_codes;  // by code
  std::vector<CodeRow> m_codes;
  FeedRule feed_rule = FeedRule::unknown;
  bool feed_before_units = false;  // F counts in the units that were in force before its block
  double feed_rate_min = 0;        // units/min under which length x F is lifted in inverse time mode
  std::size_t line_length = 255;   // characters, the line end not counted
  GuardLanguage guard = GuardLanguage::none;
  std::string comment_open = "(", comment_close = ")";
  int first_user_m_code = 0, last_user_m_code = -1;  // codes of the machine's builder
  CodeRow feed_row, speed_row, tool_row, user_row;   // the turns of F, S, T and of user M codes
  CodeRow edge_row;                                  // of D, where it chooses a tool's length
  bool has_edges = false, along_tool = false;        // a change of length moves X and Y where the tool is tilted
  std::vector<std::int16_t> g_index, m_index;        // code times ten -> place in g_codes, m_codes; -1: none

  const CodeRow* g_code(int times_ten) const;
  const CodeRow* m_code(int times_ten) const;
  /// The row of a word that is a code, named or not; null for other words and codes that the control does not know.
  const CodeRow* row_of(const Word& word) const { return is_code(word) ? row_of_code(word) : nullptr; }
  const CodeRow* row_of_code(const Word& word) const;
  /// What a name means, whatever its case; null if nothing.
  const NameMeaning* meaning(std::string_view text) const;
  /// "G54", "G54.1 P2" and so on, as programs and messages name a work system; 1 is the first.
  std::string name_of_system(int system) const;
  /// The work system of that name (upper case, blanks left out); 0: none.
  int system_of_name(std::string_view text) const;
};

/// The dialects that there are. The first is what a program is in that shows nothing else.
std::span<const std::string_view> dialect_names();

/// "linuxcnc, fanuc, okuma or siemens".
std::string dialect_list();

/// The dialect of that name. Refuses with nc-unknown-dialect and the list of those that there are.
const Dialect& dialect(std::string_view name);
/// Its marks, without the rest of its table.
const DialectMarks& marks_of_dialect(std::string_view name);

}  // namespace plumbline::nc
