// Text in the encodings that instruments write, as UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace plumbline::imported {

struct Decoded {
  std::string text;      // UTF-8, without a byte order mark
  std::string encoding;  // that it was taken for
};

/// `encoding` as maps name it; "auto": by the byte order mark; without one UTF-16 where every other byte is nil, UTF-8
/// where it is valid, else Latin-1. Refuses with import-encoding bytes that the encoding does not have, with their
/// line.
Decoded decoded(const std::string& file, std::string_view bytes, const std::string& encoding);

}  // namespace plumbline::imported
