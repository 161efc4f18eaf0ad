#include "nc/rewrite/emit_refusals.hpp"

#include <cmath>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {
namespace {

[[noreturn]] void refuse_shared_words(const Block& block, std::string_view user, const Word& taker) {
  refuse_at(block, taker.span, "emit-shared-words",
            fmt::format("{} and {} both take the axis words of this block", user, block.at(taker.span)),
            "put the two into blocks of their own");
}

}  // namespace

void refuse_if_shifted(const Step& step, const OutputState& control) {
  for (const Axis axis : kAllAxes) {
    if (std::abs(control.shift[axis]) <= 1e-9) continue;
    refuse_block(
        *step.block, "emit-stores-position",
        fmt::format("this block stores where the control stands, which is {:.4f} {} off in {} after the correction",
                    control.shift[axis], is_rotary(axis) ? "deg" : "mm", letter(axis)),
        "store the position before the program runs, or move there in machine coordinates (G53) first");
  }
}

void refuse_if_turned(const Step& step, const OutputState& control) {
  if (step.motions.empty() || step.named.empty() || step.after->incremental) return;
  const AxisWords shift = control.work_shift(*step.frame);
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    const bool endless = step.named.contains(axis) && step.after->rule_of(axis) != RotaryRule::linear;
    if (!endless || std::abs(shift[axis]) <= 1e-9) continue;
    refuse_block(*step.block, "emit-rotary-word",
                 fmt::format("{} stands {:.6g} deg off after the correction, and this block, which is not corrected, "
                             "counts its word from there",
                             letter(axis), shift[axis]),
                 "move it by increments (G91), or leave it out of the block");
  }
}

void refuse_if_shared(const Step& step, const BlockCodes& codes) {
  if (codes.axis_taker == nullptr || step.named.empty()) return;
  refuse_shared_words(*step.block, "the motion of this block", *codes.axis_taker);
}

void refuse_shared_offset(const Step& step, const BlockCodes& codes) {
  if (codes.other_taker == nullptr) return;
  refuse_shared_words(*step.block, step.block->at(codes.other_taker->span), *codes.axis_taker);
}

void refuse_point_without_code(const Step& step, const BlockCodes& codes, MotionMode in_output) {
  const bool point = step.motions.empty() && !step.named.empty() && codes.motion == nullptr &&
                     codes.axis_taker == nullptr && step.role == BlockRole::plain;
  if (!point || step.after->motion != MotionMode::special || in_output == MotionMode::special) return;
  refuse_block(*step.block, codes::kNotInterpreted,
               "this point of a NURBS goes on in the mode of a move before it, which was written anew as G1",
               "write G5.2 into this block, or end the NURBS with G5.3 before the move");
}

void refuse_beside_unit(const Step& step, const Dialect& dialect) {
  if (step.before->inches == step.after->inches) return;
  if (dialect.behaviour.unknown_beside_unit.find('X') == std::string::npos) return;
  refuse_block(*step.block, "emit-shared-words",
               "this block changes the unit and moves, and the move must be corrected",
               "put the change of units into a block of its own");
}

void refuse_doubtful_increments(const Step& step, std::span<const Piece> pieces) {
  if (!step.after->incremental) return;
  for (const Word& word : step.block->words) {
    const bool says_way =
        word.mode == WordMode::shortest || word.mode == WordMode::positive || word.mode == WordMode::negative;
    if (!says_way) continue;
    refuse_at(*step.block, word.span, "emit-rotary-word",
              fmt::format("{} says which way round it turns, and the correction is written as increments (G91), which "
                          "say nothing of that",
                          step.block->at(word.span)),
              "write G90 before this block");
  }
  AxisSet positioned;
  for (const Piece& piece : pieces) {
    positioned = positioned | piece.positioned;
    const AxisSet doubtful = (piece.moved & step.shifted) - positioned;
    if (doubtful.empty()) continue;
    refuse_block(*step.block, codes::kNotInterpreted,
                 fmt::format("the correction of this block is an increment of {}, and whether that brings along the "
                             "offset that changed before it depends on the settings of the control",
                             axis_list(doubtful)),
                 "move these axes once by absolute words (G90) after the change");
  }
}

void refuse_builders_codes(const Step& step, const Dialect& dialect) {
  if (!dialect.behaviour.m_beside_cut_unknown) return;
  for (const Word& word : step.block->words) {
    if (!is_code(word)) continue;
    const CodeRow* const row = dialect.row_of(word);
    const bool known = word.letter != 'M' || (row != nullptr && row->action != Action::refused);
    if (known && (row == nullptr || !row->order_unknown)) continue;
    const std::string_view code = step.block->at(word.span);
    refuse_at(
        *step.block, word.span, "emit-m-code",
        word.letter == 'M'
            ? fmt::format("whether {} acts before the move of its block or after it is the machine builder's "
                          "choice, and the corrected move has several blocks",
                          code)
            : fmt::format("{} acts while the block moves, and the next one waits for both: the corrected move has "
                          "several blocks",
                          code),
        "put it into a block of its own, before or after the move");
  }
}

// G64 P0.05 M68 E0 Q2: Q0 would be the output's as well.
void refuse_shared_path(const Step& step, const BlockCodes& codes, const Dialect& dialect) {
  const Block& block = *step.block;
  const auto refuse = [&](std::string_view other) {
    refuse_block(
        block, "emit-shared-words",
        fmt::format("{} takes P or Q as well as G64, which gets Q0 so that each corrected point counts", other),
        "put G64 into a block of its own before");
  };
  for (const Word& word : block.words) {
    const CodeRow* const row = is_code(word) && &word != codes.path_control ? dialect.row_of(word) : nullptr;
    if (row == nullptr) continue;
    for (const char letter : {'P', 'Q'}) {
      if (find_word(block, letter) != nullptr && row->words.find(letter) != std::string::npos)
        refuse(block.at(word.span));
    }
  }
  const bool arc = !step.motions.empty() && step.motions.front().kind == MotionKind::arc;
  if (arc && find_word(block, 'P') != nullptr) refuse("the arc");
}

}  // namespace plumbline::nc
