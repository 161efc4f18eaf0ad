// The circular test that would separate what is named from what is not ruled out, in one sentence.
#pragma once

#include <string>
#include <string_view>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// "next test, to separate it from cyclic (by 7 sigma): centre ...", or that there is none.
std::string next_test_text(const diagnose::Separation& separation);

/// What a nat is, in one sentence.
inline constexpr std::string_view kNats =
    "nats are natural logarithms of odds: with 7 nats an effect is a thousand times as likely as without";

}  // namespace plumbline::report
