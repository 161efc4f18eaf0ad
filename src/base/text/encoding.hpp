// Files that are no text in UTF-8: texts that programs of Windows write, archives.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plumbline {

/// What a file is instead, to be said behind "is", and the way out.
struct NotText {
  std::string_view is, help;
};

/// Of a file that begins like this: what it is if it is packed or in UTF-16.
std::optional<NotText> not_text(std::string_view begin);

/// Refuses what is no text by not_text (file-not-text).
void refuse_not_text(std::string_view text, const std::string& file);

}  // namespace plumbline
