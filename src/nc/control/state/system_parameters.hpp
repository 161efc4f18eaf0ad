// Parameters that show the control's own state: positions, offsets, the tool, modes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "nc/control/parameters/expression.hpp"
#include "nc/control/state/control.hpp"

namespace plumbline::nc {

inline constexpr int kProbeSuccess = 5070;  // 1: the probe touched; in rs274 it never does

/// What to do where the position of an axis must be known: another thing behind a probe, whose end no option says.
std::string way_to_position(const Control& control);

/// A variable that another program declared: the one that called, or one that has ended. `span`: where it stands here.
[[noreturn]] void refuse_of_other_program(const Block& block, Span span, std::string_view name);

class SystemParameters : public ParameterReader {
 public:
  SystemParameters(Control& control, const ProgramSettings& settings, const Dialect& dialect)
      : control_(control), at_start_(control), settings_(settings), dialect_(dialect) {}
  Value read(const Block& block, int number, Span span) override;
  Value read(const Block& block, std::string_view name, Span span) override;
  Value exists(const Block& block, std::string_view name, Span span) override;
  ParameterLimits limits() const override;
  /// True for parameters that a program may read but not set.
  bool is_read_only(int number) const;
  bool is_read_only(std::string_view name);
  /// True for parameters that are made for what comes after the program, or that the control itself obeys.
  bool is_kept(int number) const;
  /// It outlasts the program, which may as well need it for itself alone.
  bool is_lasting(int number) const;
  /// M99 of the main program leaves its value to the next pass.
  bool goes_to_next_pass(int number) const;
  /// What the program read of the control's state as it found it, and what is otherwise by now; empty: nothing is.
  std::string changed_since_read() const;

 private:
  /// Lengths in mm, so that a change of units changes none.
  std::optional<double> shown(const Control& control, int number) const;
  std::optional<double> shown(const Control& control, std::string_view plain) const;
  void note_read(int number);
  void note_read(std::string_view plain);
  Value position(const Block& block, Axis axis, Span span) const;
  Value machine_position(const Block& block, Axis axis, Span span) const;
  std::optional<double> table_value(const Control& control, int number) const;
  Value read_macro_variable(const Block& block, int number, Span span) const;
  Value unset(const Block& block, Span span) const;
  [[noreturn]] void refuse_undeclared(const Block& block, Span span, std::string_view name) const;
  [[noreturn]] static void refuse_left_over(const Block& block, Span span);
  bool is_made(const Block& block, std::string_view plain, Span span);
  Control& control_;
  const Control at_start_;
  std::map<int, double> found_;  // of the state that was read: what it was, at the start and then
  std::map<std::string, double, std::less<>> found_named_;
  const ProgramSettings& settings_;
  const Dialect& dialect_;
};

}  // namespace plumbline::nc
