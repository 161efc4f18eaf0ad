// Comments that LinuxCNC's interpreter acts on: they begin with one of these words and a comma.
#pragma once

#include <array>
#include <string_view>

namespace plumbline::nc {

struct ActiveComment {
  std::string_view word;
  bool shows_parameters = false;  // those that are named in its text, by #
};

inline constexpr std::array<ActiveComment, 8> kActiveComments{
    {{"msg"}, {"debug", true}, {"print", true}, {"log", true}, {"probeopen"}, {"probeclose"}, {"py"}, {"abort"}}};

}  // namespace plumbline::nc
