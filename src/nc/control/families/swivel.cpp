// CYCLE800: a tilted plane by angles about axes as turned so far, and the tool turned along its Z. The order of the
// values and the modes are those that Autodesk's post for the 840D writes [P].
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kRecord = 1, kStatus = 2, kMode = 3, kFirstShift = 4, kFirstAngle = 7, kSecondShift = 10,
                      kWay = 13;

struct SwivelMode {
  int mode;
  std::string_view axes;  // in the order of the angles
};
constexpr std::array kModes{SwivelMode{57, "XYZ"}, SwivelMode{39, "ZXY"}, SwivelMode{27, "ZYX"},
                            SwivelMode{45, "XZY"}, SwivelMode{30, "YZX"}, SwivelMode{54, "YXZ"}};

class Swivel {
 public:
  Swivel(Execution& run, const Chosen& chosen) : run_(run), name_(chosen.row->name), word_(*chosen.word) {}

  // No shift and no angle: the end of a plane, or the way back to where the tool stands upright.
  bool is_level() const {
    for (std::size_t i = kFirstShift; i < kWay; ++i) {
      if (value(i) != 0) return false;
    }
    return true;
  }

  bool goes_upright() const {
    const double way = value(kWay);
    return std::abs(way) == 1 && record() != "\"0\"" && value(kStatus) != 1;
  }

  // Of calls that end a plane as well.
  void check_context() const {
    const Control& control = run_.control;
    if (control.modal_call.row != nullptr) {
      refuse_word(fmt::format("while {} is called after each move: whether the moves of one make the other drill",
                              control.modal_call.row->name),
                  "write MCALL alone before it");
    }
    if (control.local != AxisWords{} || control.turn_deg != 0) {
      refuse_word("while TRANS or ROT is in force: whether it ends them", "write TRANS alone before it");
    }
  }

  // What no source covers.
  void check() const {
    if (record() == "\"0\"") {
      refuse(kRecord, "deselects the swivel data by the name \"0\", and tilts a plane as well",
             "name the swivel data, or leave the name empty");
    }
    if (run_.control.modal.plane != Plane::xy) {
      refuse_word("in G18 or G19: along which axis the tool is turned", "write G17 before it");
    }
    for (std::size_t i = kSecondShift; i < kSecondShift + 3; ++i) {
      if (value(i) != 0)
        refuse(i, "shifts the plane after it is turned, and how that counts was found in no source",
               "give the zero of the plane as the point that it turns about (X0, Y0, Z0), and leave X1, Y1, Z1 0");
    }
    // which of the two ways the axes of a head or a table turn there [Q]: of a plane there is one
    constexpr double kHundredThousand = 1e5;
    const bool chooses_way = value(kStatus) == kHundredThousand || value(kStatus) == 2 * kHundredThousand;
    if (value(kStatus) != 0 && !chooses_way) {
      refuse(kStatus,
             fmt::format("has the status {}: a plane on top of another one, or a tool that follows, is not "
                         "interpreted",
                         value(kStatus)),
             "write a new plane, status 0");
    }
  }

  /// The point that the plane turns about, its zero: in the work system, mm [R p. 481].
  AxisWords origin() const {
    AxisWords origin;
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
      origin[axis] = value(kFirstShift + index(axis)) * run_.control.length_unit();
    return origin;
  }

  Turn plane() const {
    for (const SwivelMode& mode : kModes) {
      if (value(kMode) != mode.mode) continue;
      return turned_in_turn(mode.axes, {value(kFirstAngle), value(kFirstAngle + 1), value(kFirstAngle + 2)});
    }
    refuse(kMode,
           fmt::format("has the mode {}, whose angles are no rotations about X, Y and Z one after the other",
                       value(kMode)),
           "write the angles axis by axis: mode 57, 39, 27, 45, 30 or 54");
  }

  /// Whether the axes turn; else the plane alone changes.
  bool turns() const {
    const double direction = value(kWay);
    if (direction != 0 && std::abs(direction) != 1)
      refuse(kWay, fmt::format("has the direction {}", direction), "write -1, 0 or 1");
    return direction != 0;
  }

 private:
  std::string_view record() const {
    const std::vector<Argument>& arguments = run_.block->arguments;
    if (arguments.size() <= kRecord) return {};
    const std::string_view text = run_.block->at(arguments[kRecord].span);
    const std::size_t begin = text.find_first_not_of(" \t");
    return begin == std::string_view::npos ? text : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
  }

  double value(std::size_t place) const {
    const std::vector<Argument>& arguments = run_.block->arguments;
    return place < arguments.size() && arguments[place].expression != kLiteral ? arguments[place].value : 0;
  }

  [[noreturn]] void refuse(std::size_t place, std::string_view what, std::string help) const {
    const std::vector<Argument>& arguments = run_.block->arguments;
    const Span span = place < arguments.size() ? arguments[place].span : word_.span;
    refuse_at(*run_.block, span, codes::kTiltedPlane, fmt::format("{} {}", name_, what), std::move(help));
  }

  [[noreturn]] void refuse_word(std::string_view what, std::string help) const {
    run_.refuse(word_, codes::kTiltedPlane, fmt::format("{} {} was found in no source", name_, what), std::move(help));
  }

  const Execution& run_;
  std::string_view name_;
  const Word& word_;
};

// Whether it is known where A, B and C stand when the tool is upright.
bool knows_upright(const Execution& run) {
  const Control& control = run.control;
  if (control.frame.rotation_deg != 0 || control.modal.plane != Plane::xy) return false;
  const FreeRotation free = free_rotation(run);
  if (free == FreeRotation::c_stays) return control.known.contains(Axis::C);
  return free == FreeRotation::c_zero && control.frame.origin[Axis::C] == 0;
}

// Posts turn the tool back by angles of zero and a direction; CYCLE800() alone ends the plane [P setWorkPlane].
void turn_upright(Execution& run, const Chosen& chosen) {
  begin_tilted_plane(run, *chosen.word, {}, kNoTurn);
  turn_tool_on_plane(run, *chosen.word);
  end_tilted_plane(run);
}

}  // namespace

// CYCLE800() and the like end the plane; where the axes go then, the machine's own data say.
void swivel(Execution& run, const Chosen& chosen) {
  const Swivel call(run, chosen);
  call.check_context();
  if (call.is_level()) {
    end_tilted_plane(run);
    run.step.role = BlockRole::machine_move;
    return call.goes_upright() && knows_upright(run) ? turn_upright(run, chosen) : lose_position(run, AxisSet::all());
  }
  call.check();
  const Turn plane = call.plane();
  const bool turns = call.turns();
  end_tilted_plane(run);
  begin_tilted_plane(run, *chosen.word, call.origin(), plane);
  if (turns) return turn_tool_on_plane(run, *chosen.word);
  run.step.role = BlockRole::machine_move;  // it may retract all the same
  lose_position(run, AxisSet::linear());
}

}  // namespace plumbline::nc
