// A block that is written with values in place of expressions has another text than the file: what is refused of it is
// shown in the file's.
#pragma once

#include "base/diagnostic.hpp"
#include "nc/language/block.hpp"

namespace plumbline::compensate {

/// The refusal again, where its place is of a line written in place of `of_file`: the place is then that of the same
/// word in `of_file`, or the whole line where no word is the same one.
[[noreturn]] void refuse_in_file(const Refusal& refusal, const nc::Block& written, const nc::Block& of_file);

}  // namespace plumbline::compensate
