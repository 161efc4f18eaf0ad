// What cannot be corrected without changing something else.
#pragma once

#include <span>

#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/output/emit_codes.hpp"
#include "nc/rewrite/output/emit_state.hpp"
#include "nc/rewrite/piece_feeds.hpp"

namespace plumbline::nc {

/// Of a block that stores where the control stands, which the correction moved: emit-stores-position.
void refuse_if_shifted(const Step& step, const OutputState& control);

/// Off by a little, an axis whose words count from where it stands may turn all the way round: emit-rotary-word.
void refuse_if_turned(const Step& step, const OutputState& control);

/// G43.1 Z-8 G0 X1 moves to Z-8 and makes that the length of the tool: a correction of the one would change the other:
/// emit-shared-words.
void refuse_if_shared(const Step& step, const BlockCodes& codes);

/// The same of G10 L20 X0 G43.1, where the one must change its words and the other not.
void refuse_shared_offset(const Step& step, const BlockCodes& codes);

/// A point of a NURBS in the mode of a code that came out as G1: nc-not-interpreted.
void refuse_point_without_code(const Step& step, const BlockCodes& codes, MotionMode in_output);

/// The words that a correction adds would stand beside a change of units, where it is not known in which they count:
/// emit-shared-words.
void refuse_beside_unit(const Step& step, const Dialect& dialect);

/// An increment of an axis whose offset changed before, which the correction adds under G91: nc-not-interpreted.
void refuse_doubtful_increments(const Step& step, std::span<const Piece> pieces);

/// With several pieces in its place the block's M code acts beside the first, or after the last; its builder decides:
/// emit-m-code.
void refuse_builders_codes(const Step& step, const Dialect& dialect);

/// Refuses a block that sets G64 P and has another code, or an arc, that takes its P or Q too.
void refuse_shared_path(const Step& step, const BlockCodes& codes, const Dialect& dialect);

}  // namespace plumbline::nc
