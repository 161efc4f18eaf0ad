// Texts that programs of Windows write, and that are no UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// Refuses text in UTF-16 (file-not-text).
void refuse_utf16(std::string_view text, const std::string& file);

}  // namespace plumbline
