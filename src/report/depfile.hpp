// Which files an output depends on, in the words of make, as ninja reads them too.
#pragma once

#include <string>
#include <vector>

namespace plumbline::report {

/// The rule of `target`, and an empty one of each file, so that make does not stop where one is gone. Names with line
/// ends, which neither make nor ninja can be told, are left out.
std::string depfile_text(const std::string& target, const std::vector<std::string>& files);

}  // namespace plumbline::report
