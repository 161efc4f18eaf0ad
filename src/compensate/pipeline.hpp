// One reading of a program through the model. Each block goes one way:
//
//   MoveReader -Step-> WrittenSteps -Step-> MoveReader -Move-> MoveCorrector -CorrectedMove-> Rewriter -WrittenMove->
//   Tally
#pragma once

#include <optional>
#include <span>

#include "base/files/files.hpp"
#include "base/progress.hpp"
#include "compensate/corrector.hpp"
#include "compensate/hole_corrector.hpp"
#include "compensate/move_corrector.hpp"
#include "compensate/move_reader.hpp"
#include "compensate/moves_ahead.hpp"
#include "compensate/played/output_play.hpp"
#include "compensate/program_survey.hpp"
#include "compensate/recorded/output_record.hpp"
#include "compensate/recorded/path_samples.hpp"
#include "compensate/rewriter.hpp"
#include "compensate/settings.hpp"
#include "compensate/stamp_mark.hpp"
#include "compensate/summary.hpp"
#include "compensate/tally.hpp"
#include "compensate/written_steps.hpp"
#include "machine/model.hpp"
#include "nc/rewrite/emit.hpp"

namespace plumbline::compensate {

class Pipeline {
 public:
  /// All references must outlive it. Refuses with compensate-touch-off.
  Pipeline(const InputFile& source, const ProgramSurvey& survey, const nc::ProgramSettings& program,
           const machine::MachineModel& model, const Settings& settings, const nc::EmitSettings& emit, OutputFile& out,
           nc::Form form);

  /// Where the output is recorded and shown: before run().
  Rewriter& rewriter() { return rewriter_; }
  /// Records the path from its begin; before run().
  void record(PathRecord& record) { recorded_.emplace(record); }
  /// Takes samples of the cuts from their begin; before run().
  void sample(PathSamples& samples) {
    samples_ = &samples;
    samples.restart();
  }

  /// Reads the program to its end, and writes it. False, and what was written is of no use: it is to be written in text
  /// order, but jumps, and something in it must change. Refuses as Stream does.
  bool run(const Progress& progress);
  Summary summary();

 private:
  void follow_tool(const nc::Step& step);
  void take_block(const nc::Step& step);
  void take(const nc::Step& step);
  void copy_through(const nc::Step& step);
  bool is_corrected(const nc::Step& step);
  void take_move(const nc::Step& step);
  void take_synchronised(const nc::Step& step);
  void take_cycle(const nc::Step& step);
  bool cycle_stays(const nc::Step& step, std::span<const nc::Step* const> moves);
  void take_hole(const nc::Step& step);
  CorrectedHole corrected_hole(const nc::Step& step);
  const CorrectedMove& corrected(const Move& move, const MoveAhead* ahead = nullptr);

  const InputFile& source_;
  const nc::Dialect& dialect_;
  const Settings& settings_;
  Corrector corrector_;
  ReaderSettings reading_;
  MovesAhead ahead_;
  MoveReader reader_;
  MoveCorrector moves_;
  HoleCorrector holes_;
  WrittenSteps steps_;
  Rewriter rewriter_;
  OutputPlay play_;
  Tally tally_;
  std::optional<OutputRecord> recorded_;
  PathSamples* samples_ = nullptr;
  StampSearch stamps_;
  Move move_;                 // that was not read ahead
  std::uint64_t tools_ = 0;   // that came into the spindle
  bool must_unroll_ = false;  // something changes that cannot be put in the place of its block
};

}  // namespace plumbline::compensate
