#include "compensate/stream.hpp"

#include <utility>

#include "base/check.hpp"
#include "compensate/pass.hpp"

namespace plumbline::compensate {

Stream::Stream(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
               const machine::MachineModel& model, const Settings& settings, nc::EmitSettings emit, OutputFile& out)
    : source_(source),
      dialect_(dialect),
      program_(program),
      model_(model),
      settings_(settings),
      emit_(std::move(emit)),
      out_(out) {}

// Only the program knows whether it jumps, and only the model whether anything changes: the first reading finds out
// both while it writes what most programs need. Memory does not grow with the program either way.
Summary Stream::run(const Progress& progress) {
  const auto pass_in = [&](nc::Form form) {
    return Pass(source_, dialect_, program_, model_, settings_, emit_, out_, form);
  };
  {
    Pass pass = pass_in(nc::Form::in_text_order);
    if (undo_ != nullptr) pass.record(*undo_);
    if (observer_) pass.show(observer_);
    if (pass.run(progress)) return pass.summary();
  }
  out_.restart();
  if (undo_ != nullptr) undo_->replaced_all();
  Pass pass = pass_in(nc::Form::unrolled);
  if (observer_) pass.show(observer_);
  const bool done = pass.run(progress);
  PLUMBLINE_CHECK(done);
  return pass.summary();
}

}  // namespace plumbline::compensate
