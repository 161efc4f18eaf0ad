#include "compensate/written_steps.hpp"

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "compensate/limits.hpp"
#include "compensate/read_back/block_effects.hpp"

namespace plumbline::compensate {
namespace {

constexpr int kDecimalsOfR = 8;  // that R parameters may be given with [Fundamentals, 05/2017, A5E40869423]

void refuse_what_stops(const nc::Step& step) {
  if (!step.flow || step.stop == nc::StopByVariable::none) return;
  refuse("compensate-flow",
         fmt::format("the program stops here with {}, on a condition that the output does not hold",
                     step.stop == nc::StopByVariable::alarm ? "an alarm" : "a message"),
         "look at the condition: with the offsets and variables given here it holds", place_of(step));
}

void refuse_handed_variables(const nc::Step& step) {
  if (!step.passes_variables) return;
  refuse("compensate-flow",
         "this block hands variables to the control whose values cannot be written in their place, and the program, "
         "written out, "
         "sets none",
         "write their values in their place", place_of(step));
}

void refuse_kept_variables(const nc::Step& step) {
  if (!step.sets_kept_variable) return;
  refuse("compensate-flow",
         "other programs may read the variable that is set here, or the control obeys it, and the program, written "
         "out, sets none",
         "use #100 to #199 where this program alone needs it, or set it in a program that calls this one",
         place_of(step));
}

void refuse_handed_on(const nc::Step& step, bool restates) {
  const nc::HandedVariable* const handed = step.handed == nullptr ? nullptr
                                           : restates             ? step.handed->first_carried()
                                                                  : step.handed->first();
  if (handed == nullptr) return;
  refuse("compensate-flow",
         fmt::format("{}, set in line {}, {}, and the program, written out, sets none", handed->name, handed->line,
                     handed->carried ? "counts from run to run" : "is not read here, but may be by other programs"),
         "remove it, or set it in a program that calls this one", place_of(step));
}

// "R5=2.5", "#100=2.5", "#<_height>=2.5"; of one that FOR counted its last pass, empty, since what FOR leaves in it was
// found in no source.
void append_restated(std::vector<std::string>& lines, const nc::Dialect& dialect, int number,
                     const nc::HandedVariable& variable, const nc::Step& step) {
  if (!variable.value.known && !variable.counted_to) {
    refuse("compensate-flow",
           fmt::format("{}, set in line {}, keeps for other programs what only the machine knows, and the program, "
                       "written out, sets none",
                       variable.name, variable.line),
           "remove it, or set it in a program that calls this one", place_of(step));
  }
  const std::vector<nc::NumberedVariables>& ranges = dialect.syntax.variables;
  const std::string name = number == 0 && ranges.empty() ? "#<" + variable.name + '>'
                           : ranges.empty()              ? fmt::format("#{}", number)
                                                         : fmt::format("{}{}", ranges.front().name, number);
  if (variable.counted_to) {
    lines.push_back(fmt::format("FOR {}={} TO {}", name, *variable.counted_to, *variable.counted_to));
    lines.emplace_back("ENDFOR");
    return;
  }
  const double value = variable.value.number;
  lines.push_back(name + '=' + (ranges.empty() ? exact_decimal(value) : to_decimal(value, kDecimalsOfR)));
}

}  // namespace

WrittenSteps::WrittenSteps(const nc::Dialect& dialect, const nc::EmitSettings& emit, nc::Form form)
    : dialect_(dialect),
      form_(form),
      expander_(dialect,
                nc::written_number(nc::kept_of_axis_word(dialect.behaviour, true, false, emit.increment_ratio, false),
                                   emit.digits_deg, emit.increment_deg)),
      moves_(dialect, emit.increment_ratio) {}

WrittenSteps::OfBlock WrittenSteps::only(const nc::Step* step) {
  only_ = step;
  return {{&only_, step != nullptr ? std::size_t{1} : 0}, std::nullopt};
}

// Unrolled, lines that steer are left out, and what depends on parameters is written out.
WrittenSteps::OfBlock WrittenSteps::of(const nc::Step& step) {
  if (form_ == nc::Form::in_text_order) return only(&step);
  refuse_what_stops(step);
  refuse_kept_variables(step);
  refuse_handed_on(step, dialect_.syntax.restates_lasting);
  if (step.flow || step.saves_modes) return of_steering(step);
  refuse_handed_variables(step);
  if (step.handed != nullptr && step.block->kind == nc::LineKind::ignored) return only(nullptr);  // the end of the file
  const nc::Step* const plain = expander_.plain(step, false);
  if (plain == nullptr || plain->nurbs != nc::NurbsBlock::point) return only(plain);
  return {moves_.of(*plain), std::nullopt};  // its curve is written out at its end
}

std::vector<std::string> WrittenSteps::restated_variables(const nc::Step& step) const {
  std::vector<std::string> lines;
  if (form_ == nc::Form::in_text_order || step.handed == nullptr || !dialect_.syntax.restates_lasting) return lines;
  for (const auto& [number, variable] : step.handed->set()) {
    append_restated(lines, dialect_, number, *variable, step);
  }
  return lines;
}

// What stands beside a call comes before it, and so do comments.
WrittenSteps::OfBlock WrittenSteps::of_steering(const nc::Step& step) {
  const bool acts = expander_.acts_beside_flow(step);
  OfBlock written = only(expander_.beside_flow(step, acts));
  written.steering = step;
  const bool enters = step.flow && step.flow->kind != nc::FlowEntry::Kind::none;
  const bool brings_back = dialect_.syntax.system_variables == nc::SystemVariables::rs274;  // M73, at the end
  if (acts && (enters || !brings_back)) written.steering->before = step.after;              // that is done
  return written;
}

}  // namespace plumbline::compensate
