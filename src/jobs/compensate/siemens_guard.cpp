// $P_ACTFRAME: all frames in force, chained [Programming Guide Advanced, 04.00, p. 6-218]; TR its shift, RT its turn
// [6FC5398-2EP40-0BA0, p. 636]. $AA_IW: where an axis stands in the work system [6FC5397-0BP10-2BA0, p. 128]. The axes
// are named X Y Z A B C (setting).
#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "jobs/compensate/guards.hpp"

namespace plumbline::jobs {
namespace {

class SiemensGuard {
 public:
  void choose(const std::string& system) { lines_.push_back(system); }

  void check_system(const std::string& name, const AxisWords& origin) {
    choose(name);
    for (const Axis axis : kAllAxes) {
      stop_if(differs(fmt::format("$P_ACTFRAME[{},TR]", letter(axis)), origin[axis]),
              fmt::format("{} {}{}", name, letter(axis), number(origin[axis])));
    }
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      stop_if(differs(fmt::format("$P_ACTFRAME[{},RT]", letter(axis)), 0), name + " without a turn");
    }
  }

  void check_position(Axis axis, double wanted) {
    stop_if(differs(fmt::format("$AA_IW[{}]", letter(axis)), wanted),
            fmt::format("{} at {} deg", letter(axis), number(wanted)));
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  // M0 shows the message and waits; whoever starts again gets no further.
  void stop_if(const std::string& condition, const std::string& made_for) {
    lines_.push_back("IF " + condition);
    lines_.push_back(fmt::format("MSG(\"plumbline guard: this program was made for {}\")", made_for));
    lines_.emplace_back("M0");
    lines_.emplace_back("M30");
    lines_.emplace_back("ENDIF");
  }

  static std::string differs(const std::string& expression, double wanted) {
    return fmt::format("ABS({}-({}))>{}", expression, number(wanted), kGuardTolerance);
  }

  static std::string number(double value) { return to_decimal(value, 4); }

  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> siemens_guard(const nc::ProgramSettings& program, AxisSet assumed,
                                       const nc::Dialect& dialect) {
  SiemensGuard guard;
  for (std::size_t i = 0; i < program.work_offsets.size(); ++i) {
    if (!program.work_offsets[i]) continue;
    guard.check_system(dialect.name_of_system(static_cast<int>(i) + 1), program.work_offsets[i]->origin);
  }
  for (const Axis axis : kAllAxes) {
    if (assumed.contains(axis)) guard.check_position(axis, program.start[index(axis)].value_or(0));
  }
  guard.choose(dialect.name_of_system(dialect.work_systems));
  return guard.take();
}

}  // namespace plumbline::jobs
