#include "compensate/stream.hpp"

#include <utility>

#include "base/check.hpp"
#include "compensate/pipeline.hpp"

namespace plumbline::compensate {

Stream::Stream(const InputFile& source, const ProgramSurvey& survey, nc::ProgramSettings program,
               const machine::MachineModel& model, const Settings& settings, nc::EmitSettings emit, OutputFile& out)
    : source_(source),
      survey_(survey),
      program_(std::move(program)),
      model_(model),
      settings_(settings),
      emit_(std::move(emit)),
      out_(out) {
  program_.named = survey.named;
  emit_.keep_piece_times = settings.bound.is_asked();
}

// Only the program knows whether it jumps, and only the model whether anything changes: the first reading finds out
// both while it writes what most programs need. Memory does not grow with the program either way.
Summary Stream::run(const Progress& progress) {
  const auto pipeline = [&](nc::Form form) {
    return Pipeline(source_, survey_, program_, model_, settings_, emit_, out_, form);
  };
  {
    Pipeline in_text_order = pipeline(nc::Form::in_text_order);
    if (undo_ != nullptr) in_text_order.rewriter().record(*undo_);
    if (observer_) in_text_order.rewriter().show(observer_);
    if (record_ != nullptr) in_text_order.record(*record_);
    if (samples_ != nullptr) in_text_order.sample(*samples_);
    if (in_text_order.run(progress)) return in_text_order.summary();
  }
  out_.restart();
  if (undo_ != nullptr) undo_->replaced_all();
  Pipeline unrolled = pipeline(nc::Form::unrolled);
  if (observer_) unrolled.rewriter().show(observer_);
  if (record_ != nullptr) unrolled.record(*record_);
  if (samples_ != nullptr) unrolled.sample(*samples_);
  const bool done = unrolled.run(progress);
  PLUMBLINE_CHECK(done);
  return unrolled.summary();
}

}  // namespace plumbline::compensate
