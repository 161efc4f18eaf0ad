// Pages of programs.
#pragma once

#include <string>

#include "jobs/check.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/diff/diff.hpp"
#include "jobs/simulate.hpp"
#include "report/page/page.hpp"
#include "settings/options.hpp"

namespace plumbline::report {

/// A program as it stands, played on the model.
Page simulation_page(const jobs::SimulationSummary& summary, const jobs::ProgramPicture& picture,
                     const std::string& program);

/// The limits that a program breaks or keeps.
Page check_page(const jobs::CheckSummary& summary, const jobs::ProgramPicture& picture, const std::string& program);

/// By how much the second program moves the tool away from where the first does.
Page diff_page(const jobs::DiffSummary& summary, const compensate::DrawnPath& path, const std::string& a,
               const std::string& b);

/// What a compensation did; `program` is the name of the original.
Page compensation_page(const jobs::Compensation& compensation, const std::string& program,
                       const settings::Options& options);

}  // namespace plumbline::report
