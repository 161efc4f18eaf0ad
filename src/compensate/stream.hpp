// A program through the model: read block by block, corrected, written.
#pragma once

#include "base/files/files.hpp"
#include "base/progress.hpp"
#include "compensate/program_survey.hpp"
#include "compensate/read_back/read_back.hpp"
#include "compensate/recorded/path_record.hpp"
#include "compensate/recorded/path_samples.hpp"
#include "compensate/settings.hpp"
#include "compensate/summary.hpp"
#include "machine/model.hpp"
#include "nc/rewrite/emit.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::compensate {

/// A program whose blocks are executed in the order of its text keeps its form: blocks are replaced where they must
/// change. One that loops, branches or calls comes out as it is if nothing must change, else unrolled.
class Stream {
 public:
  /// All references must outlive it.
  Stream(const InputFile& source, const ProgramSurvey& survey, nc::ProgramSettings program,
         const machine::MachineModel& model, const Settings& settings, nc::EmitSettings emit, OutputFile& out);

  /// Notes what the output replaces; to be called before run(). `log` must outlive the stream.
  void record(nc::UndoLog& log) { undo_ = &log; }

  /// Records the path for a picture; to be called before run(). `record` must outlive the stream.
  void record(PathRecord& record) { record_ = &record; }

  /// Takes samples of the cuts; to be called before run(). `samples` must outlive the stream.
  void sample(PathSamples& samples) { samples_ = &samples; }

  /// What the output is meant to do is shown to `observer`, from the begin again where the output is written anew.
  void show(ReadBack::Observer observer) { observer_ = std::move(observer); }

  /// Compensates the whole program into `out`, which is left for the caller to commit. Refuses with nc-..., limit-...,
  /// emit-... or compensate-... and the place.
  Summary run(const Progress& progress = {});

 private:
  const InputFile& source_;
  const ProgramSurvey& survey_;
  nc::ProgramSettings program_;
  const machine::MachineModel& model_;
  const Settings& settings_;
  nc::EmitSettings emit_;
  OutputFile& out_;
  nc::UndoLog* undo_ = nullptr;
  PathRecord* record_ = nullptr;
  PathSamples* samples_ = nullptr;
  ReadBack::Observer observer_;
};

}  // namespace plumbline::compensate
