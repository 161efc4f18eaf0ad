// Writes a program again, block by block: as it stands, with its moves where the correction sends them, its holes
// shifted. What is written is noted as it was meant, and read back while it is written.
#pragma once

#include <optional>
#include <vector>

#include "base/files/files.hpp"
#include "compensate/move_corrector.hpp"
#include "compensate/played/between_points.hpp"
#include "compensate/read_back/intention.hpp"
#include "compensate/read_back/read_back.hpp"
#include "compensate/summary.hpp"
#include "compensate/written_steps.hpp"
#include "nc/rewrite/emit.hpp"

namespace plumbline::compensate {

/// What became of a move.
struct WrittenMove : nc::EmittedMove {
  AxisWords begin;                // where the control stood before it, in W
  std::vector<SentPiece> pieces;  // as the control keeps them, of a move that cuts
};

class Rewriter {
 public:
  /// All must outlive it, `steps` too. `read_back`: whether what is written is read again.
  Rewriter(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
           const nc::EmitSettings& emit, OutputFile& out, WrittenSteps& steps, bool read_back);

  /// Notes what the output replaces; to be called before the first block. `log` must outlive it.
  void record(nc::UndoLog& log) { emitter_.record(log); }
  /// Shows what the output is meant to do; to be called before the first block.
  void show(const ReadBack::Observer& observer) {
    if (read_back_) read_back_->show(observer);
  }
  /// From here on what is written does not matter, only whether changed().
  void only_look() { emitter_.only_look(); }

  /// Between these two each move of a block of the program is written once, in order.
  void begin(const nc::Step& original) { intention_.begin(original); }
  void end();
  /// A wait that comes before the move of the block which it stands in.
  void keep_wait(const nc::Step& wait) { intention_.keep(wait, true); }
  /// The block as it stands; `counts`: its time is part of the summary.
  void copy(const nc::Step& step, bool counts);
  /// Holds until the next call.
  const WrittenMove& write(const CorrectedMove& corrected);
  nc::EmittedMove write_hole(const nc::Step& hole, const AxisWords& shift);
  void steer(const nc::Step& step) { emitter_.steer(step); }
  /// A block that stands for none of the original, before that of `step`.
  void add_line(const nc::Step& step, const std::string& line) { emitter_.add_line(step, line); }
  /// What is written between these two stands for the block of a cycle.
  void begin_cycle(const nc::Step& step) { emitter_.begin_group(step); }
  void end_cycle(const nc::Step& step) { emitter_.end_group(step); }
  /// Unrolled, after the last block: the programs that stand from here on in the file, as they are.
  void carry_over(std::uint64_t begin) { emitter_.carry_over(begin); }
  /// After the last block.
  void finish();

  /// Bytes that were written so far.
  std::uint64_t written_bytes() const { return out_.size(); }
  bool changed() const { return emitter_.changed(); }
  /// By how much the control stands off the original, in the work system of the step.
  AxisWords standing(const nc::Step& step) const { return emitter_.control().work_shift(*step.frame); }
  /// How the words of the step's move may be written.
  WordsOfMove words_of(const nc::Step& step) const { return {emitter_.half_quanta(step), emitter_.arc_form(step)}; }
  /// True if a move may stay as it stands, or a block of the step.
  bool stays(const CorrectedMove& corrected);
  bool stands_true(const nc::Step& step, AxisSet writable) const { return emitter_.stands_true(step, writable); }
  /// True if none of the points is shifted as the words of the step are written.
  bool are_none(const nc::Step& step, const CorrectedMove& places) const;
  /// True if the cycle before this one, whose words it goes on with, was written out.
  bool goes_on_from_written_out(const nc::Step& cycle) const;

  /// What is to be said of the output.
  void describe(Summary& summary) const;

 private:
  bool writes_vector(const nc::Step& step) const;
  void note_pieces(const CorrectedMove& corrected);

  const nc::Dialect& dialect_;
  OutputFile& out_;
  WrittenSteps& steps_;
  nc::Emitter emitter_;
  Intention intention_;
  std::optional<ReadBack> read_back_;
  std::optional<ReadBackFigures> figures_;
  std::uint64_t unchanged_blocks_ = 0;  // before the first that changed
  WrittenMove written_;
  bool says_angles_ = false;  // A, B and C stand rounded where the program gives directions
};

}  // namespace plumbline::compensate
