// The page that a diagnosis is read on.
#pragma once

#include <string>
#include <vector>

#include "jobs/diagnose.hpp"
#include "jobs/run_profiles.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// Verdict first, in one sentence with um at the tip; what was found with its numbers; what else is not ruled out and
/// the test that would tell, drawn, with its NC program (`programs`: of each of the diagnosis' next tests that has a
/// test, in order); the gap before and after; where it is; the evidence; the runs. `profiles`: of the runs, beside the
/// model as given and the model with what was found.
Page diagnosis_page(const jobs::DiagnoseResult& result, const jobs::RunsAndModels& profiles,
                    const std::vector<std::string>& programs);

}  // namespace plumbline::report
