// A diagnosis, for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include "diagnose/diagnose.hpp"
#include "jobs/measured/measured_file.hpp"

namespace plumbline::report {

/// The verdict in a few words: "named: one of backlash, cyclic".
std::string headline(const diagnose::Diagnosis& diagnosis);
/// What is missing, the whole confidence set where the data leave several: "one of backlash, cyclic".
std::string names_text(const diagnose::Diagnosis& diagnosis);

/// For people: the verdict, what was found, what else is not ruled out and the next test.
std::string diagnosis_text(const diagnose::Diagnosis& diagnosis);
/// As docs/formats.md says.
std::string diagnosis_json(const diagnose::Diagnosis& diagnosis, const std::vector<jobs::MeasuredFile>& measured = {});

}  // namespace plumbline::report
