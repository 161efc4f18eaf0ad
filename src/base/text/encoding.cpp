#include "base/text/encoding.hpp"

#include "base/diagnostic.hpp"

namespace plumbline {

void refuse_utf16(std::string_view text, const std::string& file) {
  if (!text.starts_with("\xFF\xFE") && !text.starts_with("\xFE\xFF")) return;
  refuse("file-not-text", "this is text in UTF-16", "save it as UTF-8", {file, 0});
}

}  // namespace plumbline
