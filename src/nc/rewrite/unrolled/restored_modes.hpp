// Modes that come back at the end of a subprogram, said with codes.
#pragma once

#include <functional>
#include <string>

#include "nc/control/step.hpp"
#include "nc/rewrite/output/emit_codes.hpp"
#include "nc/rewrite/output/emit_state.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {

/// Takes a line without its end; an empty one is none.
using WriteLine = std::function<void(const std::string& line)>;

/// What M72 and the end of a subprogram with M73 bring back: the lines that take the control from the modes before
/// `step` to those after it. Units first, since F and G64 P count in them; F after its mode, which drops it.
/// `other_length`: the length of the tool comes back, too.
void write_restored_modes(const Step& step, bool other_length, const CodeWriter& codes, const Spelling& spelling,
                          OutputState& control, const WriteLine& write);

}  // namespace plumbline::nc
