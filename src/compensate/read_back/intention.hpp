// Notes what each block of a program is meant to do in the output, as the program is compensated.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/files/files.hpp"
#include "base/text/number_text.hpp"
#include "compensate/read_back/intended.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/emit_pieces.hpp"

namespace plumbline::compensate {

/// Between begin() and end() of a block each of its moves is said once, in order. Where the control stands away from
/// the original is followed here from corrections alone.
class Intention {
 public:
  /// All must outlive it. Unless it `notes` it does nothing: nobody reads the output back.
  Intention(const InputFile& source, const nc::Dialect& dialect, const nc::EmitSettings& emit, bool unrolled,
            bool notes = true);

  void begin(const nc::Step& original);
  /// The moves of `step` go through as they stand; `counts`: their time is part of the summary.
  void keep(const nc::Step& step, bool counts, std::optional<double> seconds = std::nullopt);
  /// One move goes through `points`, whose words only `writable` axes may get.
  void divide(const nc::Step& step, std::span<const nc::CorrectedPoint> points, AxisSet writable,
              std::optional<double> seconds);
  /// A hole of a cycle that stays one, shifted.
  void shift(const nc::Step& hole, const AxisWords& by);
  /// Of the block since begin(). Refuses to go on (InternalError) if a move of the original was not said.
  void end(std::uint64_t output_end);

  IntendedBatch& batch() { return batch_; }
  /// A batch was handed over: the next begins empty.
  void start_batch() {
    batch_.clear();
    has_state_ = false;
  }

 private:
  struct KeptWord {                   // of what is written with so many decimals
    double digit = 0, increment = 0;  // in the program's unit: see IntendedMove
    double tolerance = 0;             // mm or deg
    int decimals = 0;                 // that the control keeps
  };
  static constexpr std::size_t kind(bool rotary, bool inches, bool incremental) {
    return (rotary ? 4U : 0U) + (inches ? 2U : 0U) + (incremental ? 1U : 0U);
  }
  KeptWord kept_word(bool rotary, bool inches, bool incremental, int written) const;
  void note_kept(const nc::Step& step, IntendedMove& move);
  void note_arcs(const nc::Step& step, std::span<const nc::CorrectedPoint> points, IntendedMove& move);
  IntendedMove& add(const nc::Motion& motion, IntendedMove::Form form);
  AxisWords work_shift(const nc::Frame& frame) const;
  void move_away(const nc::Step& step, const nc::Motion& motion, bool last);
  void check_all_said() const;
  void note_state(const nc::Step& step);

  const InputFile& source_;
  const nc::Dialect& dialect_;
  const nc::EmitSettings& emit_;
  const bool unrolled_;
  const bool notes_;
  std::array<std::array<KeptWord, kMostDecimals + 1>, 8> kept_words_{};  // by kind(), and by the decimals of the word
  IntendedBatch batch_;
  const nc::Step* original_ = nullptr;
  double level_away_ = 0;     // of the height that cycles go back to,
  double level_written_ = 0;  // and the tolerance of its block, maybe in another unit
  bool goes_on_ = false;      // the cycle before
  AxisWords away_;            // the control's position minus the original's, in W
  AxisWords written_;         // the tolerance of what was written since the axis was named, maybe in another unit
  IntendedState state_;
  bool has_state_ = false;
};

}  // namespace plumbline::compensate
