// What a terminal shows beside the words: colours for verdicts, and how wide a line is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace plumbline::cli {

enum class Stream { out, err };

/// What a word tells at first sight.
enum class Verdict { good, doubtful, bad };

/// False where messages are JSON, too.
bool is_terminal(Stream stream);
/// Of the terminal of a stream, at least 1; 80 where it does not say.
std::size_t columns(Stream stream);

/// The text as it is, with the first place of `part` coloured where the stream is a terminal that shows colours: not
/// one that calls itself dumb, and not where NO_COLOR is set to anything (https://no-color.org).
std::string coloured(std::string text, std::string_view part, Verdict verdict, Stream stream);

}  // namespace plumbline::cli
