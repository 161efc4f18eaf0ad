// Holds what a program does against what it was meant to do.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "base/files/files.hpp"
#include "compensate/read_back/effect_check.hpp"
#include "compensate/read_back/figures.hpp"
#include "compensate/read_back/intended.hpp"
#include "compensate/read_back/intention.hpp"
#include "compensate/read_back/move_check.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/emit_pieces.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::compensate {

class OutputCheck {
 public:
  /// All must outlive it. `output` need hold no more than what the batches that were taken speak of.
  OutputCheck(const InputFile& source, const InputFile& output, const nc::Dialect& dialect,
              const nc::ProgramSettings& program, const nc::EmitSettings& emit, bool unrolled);

  /// Reads as far as the batch speaks. Refuses with compensate-read-back and both lines.
  void take(const IntendedBatch& batch);
  /// Reads to the end, after the last batch: nothing may be left but what no control executes.
  void finish();

  const ReadBackFigures& figures() const { return figures_; }

 private:
  void take_unchanged(std::uint64_t blocks);
  void take_block(const IntendedBatch& batch, const IntendedBlock& block);
  const nc::Step* next();
  bool is_stamp();
  void take_step();
  void check_turn(const BlockEffect& effect);
  void finish_block();
  [[noreturn]] void differ(std::string what) const;
  std::string line_at(const std::string& file, std::uint64_t offset) const;

  const InputFile& source_;
  const nc::Dialect& dialect_;
  const nc::ProgramSettings& settings_;
  const nc::EmitSettings& emit_;
  bool tilted_length_ = false;  // of the block in hand, which program_ looks at
  nc::Program program_;

  // The block of the original in hand
  const IntendedBatch* batch_ = nullptr;
  const IntendedBlock* block_ = nullptr;
  std::size_t steps_ = 0;  // blocks of the output for it
  std::size_t numbers_ = 0;
  const bool drops_labels_;                    // that stood in the output before, as a program does that is written out
  std::set<std::string, std::less<>> labels_;  // those that stood there

  // Where the output was read to
  const nc::Step* step_ = nullptr;
  std::uint64_t read_to_ = 0;
  std::size_t stamp_ = 0, guard_ = 0;  // lines of them that were read
  std::size_t output_line_ = 0;
  std::string output_text_;  // where it could not be read
  std::vector<BlockEffect> read_effects_;
  ReadBackFigures figures_;
  EffectCheck effects_;
  MoveCheck moves_;
};

}  // namespace plumbline::compensate
