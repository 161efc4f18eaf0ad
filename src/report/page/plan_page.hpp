// The page of a plan of circular tests.
#pragma once

#include <string>
#include <vector>

#include "jobs/plan.hpp"
#include "jobs/run_profiles.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// The circles drawn in the machine with their NC programs (`programs`: of each run), what they would tell, what the
/// model predicts of them (`predicted`: of the runs, without models).
Page plan_page(const jobs::PlannedTests& plan, const machine::MachineModel& machine,
               const std::vector<std::string>& programs, const jobs::RunsAndModels& predicted);

}  // namespace plumbline::report
