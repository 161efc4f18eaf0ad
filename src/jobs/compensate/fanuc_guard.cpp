// #4006, #4008 and #4014: the codes of groups 6, 8 and 14 in force; #5021 and #5041: where the axes stand, of the
// machine and of the work; #5201, #5221... and #7001...: the external offset, G54 to G59, G54.1 P1 to P48. The axes are
// numbered X Y Z A B C (setting).
#include <algorithm>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/number_text.hpp"
#include "jobs/compensate/guards.hpp"

namespace plumbline::jobs {
namespace {

class FanucGuard {
 public:
  explicit FanucGuard(const nc::Dialect& dialect) : dialect_(dialect) {}

  void check_start() {
    stop_if("#4006 NE 21", "START IN G21");
    stop_if("#4014 NE 54", "START IN G54");
    stop_if("#4008 NE 49", "START IN G49");
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      stop_if(differs(fmt::format("{}-{}", variable(kMachinePosition, axis), variable(kWorkPosition, axis)),
                      sum_with_external(0, axis)),
              fmt::format("G92 SHIFTS {}", letter(axis)));
    }
  }

  void check_system(std::size_t system, const AxisWords& origin) {
    for (const Axis axis : kAllAxes) {
      stop_if(differs(sum_with_external(system, axis), number(origin[axis])),
              fmt::format("{} {}", dialect_.name_of_system(static_cast<int>(system) + 1), letter(axis)));
    }
  }

  void check_position(Axis axis, double wanted) {
    stop_if(differs(variable(kWorkPosition, axis), number(wanted)),
            fmt::format("START AT {}{}", letter(axis), to_decimal(wanted, 3)));
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  static constexpr int kMachinePosition = 5021, kWorkPosition = 5041;
  static constexpr int kExternal = 5201, kFirstSystem = 5221, kFirstOfFurther = 7001, kPerSystem = 20;
  static constexpr std::size_t kSystems = 6, kFurtherSystems = 48;
  static constexpr std::ptrdiff_t kMostDigits = 8;  // of a number

  // Alarms have the numbers 0 to 200 or 100 to 255, and 26 characters.
  void stop_if(const std::string& condition, const std::string& message) {
    lines_.push_back(fmt::format("IF [{}] THEN #3000=101(PLUMBLINE: {})", condition, message));
  }

  static std::string differs(const std::string& expression, const std::string& wanted) {
    return fmt::format("ABS[{}-[{}]] GT {}", expression, wanted, kGuardTolerance);
  }

  static std::string number(double value) {
    std::string text;
    for (int decimals = 4; decimals >= 0; --decimals) {
      text = to_decimal(value, decimals, 1);
      const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
      if (std::count_if(text.begin(), text.end(), is_digit) <= kMostDigits) break;
    }
    return text;
  }

  static std::string variable(int first, Axis axis) {
    return fmt::format("#{}", first + static_cast<int>(index(axis)));
  }

  std::string sum_with_external(std::size_t system, Axis axis) const {
    const bool further = system >= kSystems;
    if (system >= kSystems + kFurtherSystems) {
      refuse("guard-system",
             fmt::format("which variables hold the offset of {} was found in no source",
                         dialect_.name_of_system(static_cast<int>(system) + 1)),
             "use G54 to G59 or G54.1 P1 to P48, or leave --guard out");
    }
    const auto place = static_cast<int>(further ? system - kSystems : system);
    const int first = (further ? kFirstOfFurther : kFirstSystem) + kPerSystem * place;
    return variable(kExternal, axis) + "+" + variable(first, axis);
  }

  const nc::Dialect& dialect_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> fanuc_guard(const nc::ProgramSettings& program, AxisSet assumed, const nc::Dialect& dialect) {
  if (program.inches.value_or(false)) {
    refuse("guard-unit",
           "the guard compares offsets in mm and has the control begin in G21, and this program begins in inches",
           "write G20 into the program before its first move and leave --unit out, or leave --guard out");
  }
  FanucGuard guard(dialect);
  guard.check_start();
  for (std::size_t i = 0; i < program.work_offsets.size(); ++i) {
    if (program.work_offsets[i]) guard.check_system(i, program.work_offsets[i]->origin);
  }
  for (const Axis axis : kAllAxes) {
    if (assumed.contains(axis)) guard.check_position(axis, program.start[index(axis)].value_or(0));
  }
  return guard.take();
}

}  // namespace plumbline::jobs
