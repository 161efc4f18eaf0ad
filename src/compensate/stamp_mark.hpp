// The mark of a compensated program.
#pragma once

#include "base/files.hpp"

namespace plumbline::compensate {

/// A compensated program holds the corrections already; a second helping would double them. Refuses with
/// compensate-stamped a file in which the mark stands anywhere, in whatever case and with whatever blanks.
void refuse_stamped(const InputFile& file);

}  // namespace plumbline::compensate
