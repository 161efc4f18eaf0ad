// The page on which measurements are judged.
#pragma once

#include "jobs/measured/inspect.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// What is wrong first, a sentence each; then how far each run is from what the model and all others predict, channel
/// by channel; then the same as a table.
Page inspection_page(const jobs::InspectResult& result);

}  // namespace plumbline::report
