// Comments that LinuxCNC's interpreter acts on: they begin with one of these words and a comma, or a word about a file
// alone.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "base/text/characters.hpp"

namespace plumbline::nc {

struct ActiveComment {
  std::string_view word;
  bool shows_parameters = false;  // those that are named in its text, by #
};

inline constexpr std::array<ActiveComment, 11> kActiveComments{{{"msg"},
                                                                {"debug", true},
                                                                {"print", true},
                                                                {"log", true},
                                                                {"logopen"},
                                                                {"logappend"},
                                                                {"logclose"},
                                                                {"probeopen"},
                                                                {"probeclose"},
                                                                {"py"},
                                                                {"abort"}}};

/// Whether a comment, with its bracket, is the active one of this word: `( Abort, text)` of "abort".
inline bool is_active_comment(std::string_view comment, std::string_view word) {
  if (!comment.starts_with('(')) return false;
  comment.remove_prefix(std::min(comment.find_first_not_of(" \t", 1), comment.size()));
  return comment.size() > word.size() && comment[word.size()] == ',' &&
         std::equal(word.begin(), word.end(), comment.begin(),
                    [](char small, char any) { return lower(any) == small; });
}

}  // namespace plumbline::nc
