// What is given as a program and is none: refused before a dialect is looked for in it.
#pragma once

#include "base/files/files.hpp"

namespace plumbline::jobs {

/// Refuses a file without a single word (file-empty), and one that is packed, in UTF-16 or no text at all
/// (file-not-text).
void refuse_unless_program_text(const InputFile& program);

}  // namespace plumbline::jobs
