// The page that a diagnosis is read on: one self-contained HTML file, pictures first.
#pragma once

#include <string>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// HTML with inline SVG, nothing from elsewhere, no script: verdict, gap map (run by channel), residuals in polar plots
/// before and after, evidence, the numbers found, runs left out, the next test. `title` names machine and dataset.
std::string diagnosis_page(const diagnose::Diagnosis& diagnosis, const std::string& title);

}  // namespace plumbline::report
