#include "compensate/written_steps.hpp"

#include <fmt/format.h>

#include "compensate/limits.hpp"
#include "compensate/read_back/block_effects.hpp"

namespace plumbline::compensate {
namespace {

void refuse_what_stops(const nc::Step& step) {
  if (!step.flow || step.stop == nc::StopByVariable::none) return;
  refuse("compensate-flow",
         fmt::format("the program stops here with {}, on a condition that the output does not hold",
                     step.stop == nc::StopByVariable::alarm ? "an alarm" : "a message"),
         "look at the condition: with the offsets and variables given here it holds", place_of(step));
}

void refuse_handed_variables(const nc::Step& step) {
  if (!step.passes_variables) return;
  refuse("compensate-flow", "this block hands variables to the control, and the program, written out, sets none",
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

void refuse_handed_on(const nc::Step& step) {
  if (step.handed == nullptr) return;
  refuse("compensate-flow",
         fmt::format(
             "{}, set in line {}, {}, and the program, written out, sets none", step.handed->name, step.handed->line,
             step.handed->carried ? "counts from run to run" : "is not read here, but may be by other programs"),
         "remove it, or set it in a program that calls this one", place_of(step));
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
  refuse_handed_on(step);
  if (step.flow || step.saves_modes) return of_steering(step);
  refuse_handed_variables(step);
  const nc::Step* const plain = expander_.plain(step, false);
  if (plain == nullptr || plain->nurbs != nc::NurbsBlock::point) return only(plain);
  return {moves_.of(*plain), std::nullopt};  // its curve is written out at its end
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
