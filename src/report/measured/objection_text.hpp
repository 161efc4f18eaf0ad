// Why what was learnt is not to be believed, a sentence each without its full stop.
#pragma once

#include <string>

#include "diagnose/objection.hpp"
#include "jobs/identify.hpp"

namespace plumbline::report {

/// "level tilt_mrad x is 1.2 mrad off, 8.0 times what [uncertainty] says of it"
std::string strain_text(const identify::Unknown& unknown, double sigmas, int decimals);

/// That all priors together are further off than they should be.
std::string all_strained_text(const identify::Plausibility& plausible);

/// Why a stage is not to be believed; empty: nothing speaks against it.
std::string objection_text(const identify::Stage& stage);
/// Why an identified model is not, what is wrong with the data first; empty: nothing speaks against it.
std::string objection_text(const jobs::IdentifiedModel& model);
/// What is wrong with the data and not accepted; empty: nothing is.
std::string spoiled_text(const jobs::IdentifiedModel& model);
/// That its fit did not converge, after what is wrong with the data.
std::string not_converged_text(const jobs::IdentifiedModel& model);
/// Why what a diagnosis learnt is not.
std::string objection_text(const diagnose::Objection& objection);
/// Why the effects found are not to be named.
std::string doubt_text(const diagnose::Doubt& doubt);
/// What the catalogue does not explain, a line for each part of it.
std::string remainder_text(const diagnose::Remainder& remainder);

}  // namespace plumbline::report
