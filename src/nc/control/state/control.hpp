// What a control remembers from block to block.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nc/control/parameters/parameters.hpp"
#include "nc/control/state/frame.hpp"
#include "nc/control/state/handed_variables.hpp"
#include "nc/control/state/modal.hpp"
#include "nc/control/state/motion.hpp"
#include "nc/control/state/program_settings.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// A row of the table of work offsets.
struct WorkSystem {
  AxisWords origin;
  double rotation_deg = 0;
  AxisSet known;  // axes whose origin somebody gave
};

/// A position that G28.1 or G30.1 stored, in machine coordinates.
struct Home {
  AxisWords machine;
  AxisSet known;
};

/// What a cycle inherits from the blocks before it, in mm and s.
struct Cycle {
  bool begun = false;        // false: another motion came between
  bool incremental = false;  // how its R and depth were given
  double unit_mm = 1;        // in which
  double start = 0;          // along the normal of the plane, where the first of these cycles began
  double shift = 0;          // there, of the work system and the tool against the machine, when it was stated
  double r = 0;
  double bottom = 0;
  double dwell_s = 0;           // P
  bool dwell_pointed = false;   // that it was written with a point
  double peck = 0;              // Q
  double peck_to_r = 0;         // J of an OSP's G73
  double feed_out = 0;          // FA of an OSP
  bool stays = false;           // some word of it is in no source that says all: the hole stays a cycle
  std::array<double, 3> ijk{};  // G87
};

/// Where cycles of an OSP go back to under M53, mm along the normal of the plane in which it was stated.
struct ReturnLevel {
  Axis normal = Axis::Z;
  double level = 0;
  double shift = 0;  // of the work system and the tool against the machine, there and then
};

/// How many inches a move gave for its end, and the mm that they are: the quotient may be another number.
struct InchPlace {
  double mm = 0;
  double inches = 0;
};

/// A control point of G5.2, mm, with its weight.
struct NurbsPoint {
  double x = 0, y = 0, weight = 1;
};

struct CallArgument {
  std::string text;  // as written
  std::optional<double> value;
};

/// A cycle that is called with values in brackets.
struct CycleCall {
  const CodeRow* row = nullptr;  // null: none
  std::vector<CallArgument> arguments;
  bool by_variables = false;  // some value is no plain number
};

/// The offset of G92, which the control keeps from program to program.
struct KeptShift {
  AxisWords suspended;          // what G92.3 brings back
  bool known = false;           // that
  std::optional<bool> applied;  // whether G92, G52 or G92.3 put it in force
};

/// A row of the control's tool table, as far as it is known.
struct ToolRow {
  AxisWords offset;
  std::optional<double> diameter_mm;
  std::array<std::optional<double>, 3> details{};  // front and back angle, orientation
};

struct Control {
  Control(const Dialect& dialect, const ProgramSettings& settings);

  const ControlBehaviour& behaviour;
  Modal modal;
  const CodeRow* motion_row = nullptr;        // of the motion mode in force
  bool motion_stated = false;                 // by a code of the program
  const CodeRow* row_before_cycle = nullptr;  // of the one before the cycle that is in force
  Frame frame;
  AxisWords position;                    // in the active work system
  std::array<InchPlace, 3> inch_places;  // of X, Y and Z, at the end of their last move in inches
  AxisSet shifted;                       // by a change that increments may bring along, since their last absolute word
  AxisSet turned;                        // a turn left them where they stood: known anew once both are named
  AxisSet lost;                          // where tables count as empty: in known, though a stop may have moved them
  AxisSet known;                         // of position; where the origin is not known, of the machine's position
  std::array<WorkSystem, kWorkSystems> systems;
  Cycle cycle;
  CycleCall modal_call;                             // after each move
  CycleCall call;                                   // of the block
  std::optional<std::array<double, 2>> spline_end;  // P and Q of the G5 before, mm
  std::vector<NurbsPoint> nurbs;                    // begun by G5.2
  int nurbs_order = 3;
  KeptShift g92;
  AxisWords local;                         // G52, TRANS: added to the origin of the work system
  bool local_added = false;                // by ATRANS
  AxisWords local_before_turn;             // G68 changes it, G69 brings it back
  double turn_deg = 0;                     // G68, ROT: about Z
  AxisWords plane_origin;                  // of a tilted plane, from that of the work system
  bool centre_point = false;               // the tool's tip stays where it is while A, B and C turn (G43.4, G43.5)
  bool tool_vectors = false;               // I, J and K are the direction of the tool (G43.5)
  bool tool_on_plane = false;              // the tool stands along its Z (G53.1)
  FeedRule feed_rule = FeedRule::unknown;  // the dialect's, or as FGROUP says
  std::array<Home, 2> homes;               // G28, G30
  std::map<int, ToolRow> tools;            // tool table rows that the program wrote (G10 L1, L10, L11)
  int selected_tool = -1;                  // T; -1: none yet
  int edge = 1;                            // D
  bool edge_of_selected = false;           // D took the length of T while no tool was known in the spindle,
  bool moved_on_selected = false;          // and moves were made with it
  double spindle_speed = 0;
  bool rigid_tap_due = false;  // M29 of a Fanuc, before its G84
  bool spindle_told = false;   // by M3 to M5: before, the program may be a part of another
  bool speed_limited = false;  // LIMS
  double feed_kept = 0;        // number of the F that G93 found in force, until a move has its own; then no number
  const CodeRow* feed_taken = nullptr;  // a cycle with feeds of its own, since the last F
  double feed_linear = 0;               // the F in force as mm/min (mm/rev under G95)
  Parameters parameters;
  HandedVariables handed;          // of those that outlast the program
  HandedVariables of_main;         // of all that M99 of the main program leaves to its next pass
  bool tool_in_inches = false;     // the unit in force when the tool's offset was taken
  bool ended = false;              // M2, M30
  bool position_read = false;      // by an expression: what is written must hold its value
  bool in_machine_system = false;  // G15 H0
  /// The code of which no motion code came after.
  enum class MotionEnd : std::uint8_t { none, off, nurbs_end, circle } motion_end = MotionEnd::none;  // G80, G5.3, CIP
  /// Where the length in force comes from; unknown: G170 after G169 H, as no source says whether that ends the length.
  enum class Length : std::uint8_t { by_code, by_tip, unknown } length = Length::by_code;
  /// Why it is not known whether a tool's length counts: after D0 a tool was changed, and D0 or D1 is in force as the
  /// control is set; G28, G30 or G53 ended the length of G43, and a parameter brings it back; or a macro of the user,
  /// which may choose one, changed the tool.
  enum class LengthDoubt : std::uint8_t { none, edge, home, macro } length_doubt = LengthDoubt::none;
  enum class Return : std::uint8_t { unknown, level, r } cycle_return = Return::unknown;  // M53, M54
  std::optional<ReturnLevel> return_level;                                                // G71

  WorkSystem no_system;  // before a control that needs to be told was told
  WorkSystem& active() {
    return modal.work_system == 0 ? no_system : systems[static_cast<std::size_t>(modal.work_system - 1)];
  }
  const WorkSystem& active() const { return const_cast<Control*>(this)->active(); }
  /// mm or mm/min per unit of the program.
  double length_unit() const;
  /// G20, G21: the feed stays what it is in mm/min.
  void change_unit(bool inches);
  /// The position of an axis in the program's unit, in inches the number that the program gave.
  double position_in_unit(Axis axis) const;
  /// Offsets change, the machine does not move: the position gets its new words.
  void change_frame(const Frame& next);
  AxisSet shifted_by(const Frame& next, const AxisWords& moved) const;
  /// Of position, as it is where tables do not count as empty.
  AxisSet surely_known() const { return known - lost; }
  /// M3, M4, M5, SPOS: kClockwise and so on.
  void turn_spindle(int code) {
    modal.switches.spindle = code;
    spindle_told = true;
  }
  /// No speed, or M5: the spindle turns no way that the program told.
  bool spindle_stands() const {
    return spindle_speed <= 0 || (spindle_told && modal.switches.spindle == kSpindleStands);
  }
  /// The active work system of the table takes force.
  void use_active_system();
  /// The program changed the row in force (G10 L2).
  void use_changed_row();
};

}  // namespace plumbline::nc
