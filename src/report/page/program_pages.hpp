// Pages of programs.
#pragma once

#include <string>

#include "jobs/compensate/compensate_file.hpp"
#include "report/page/page.hpp"
#include "settings/options.hpp"

namespace plumbline::report {

/// What a compensation did; `program` is the name of the original.
Page compensation_page(const jobs::Compensation& compensation, const std::string& program,
                       const settings::Options& options);

}  // namespace plumbline::report
