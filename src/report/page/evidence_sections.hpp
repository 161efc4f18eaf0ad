// Which effect it is, and how sure that is, in plain words.
#pragma once

#include <string>
#include <vector>

#include "diagnose/diagnose.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// How much more likely readings are, in plain words, from a natural logarithm of odds: "about 20 times as likely".
std::string odds_words(double nats);

/// The foremost effects as bars in powers of ten, and all that were compared as a table. Empty: none were.
std::vector<Json> evidence_sections(const diagnose::Diagnosis& diagnosis);

}  // namespace plumbline::report
