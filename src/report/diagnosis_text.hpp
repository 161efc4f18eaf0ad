// A diagnosis, for people and as JSON.
#pragma once

#include <string>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// For people: the verdict, what was found, what else is not ruled out and the next test.
std::string diagnosis_text(const diagnose::Diagnosis& diagnosis);
/// As docs/formats.md says.
std::string diagnosis_json(const diagnose::Diagnosis& diagnosis);

}  // namespace plumbline::report
