// The page of an identification or a calibration.
#pragma once

#include "jobs/identify.hpp"
#include "jobs/run_profiles.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// What was found with its errors, what the data tell of it and what not, what is left of each run. `profiles`: of the
/// runs, beside the model as given and as found.
Page identification_page(const jobs::IdentifiedModel& model, const jobs::RunsAndModels& profiles);

/// The runs of an identification beside both models. Refuses as jobs::run_profiles does.
jobs::RunsAndModels profiles_of(const jobs::IdentifiedModel& model);

}  // namespace plumbline::report
