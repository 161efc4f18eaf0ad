// Sections of runs with models beside them: what was measured, what each model says, what is left.
#pragma once

#include <string>
#include <vector>

#include "jobs/run_profiles.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// A column in a file's unit.
std::vector<double> in_unit(const Eigen::VectorXd& values, double unit);

/// Polar plots of the bar's readings: measured, simulated, and as the bar would read with the program compensated by
/// each model, with the figures of ISO 230-4. Null: no run has readings of the bar.
Json circles_section(const jobs::RunsAndModels& of, std::string title);

/// Rms of measured minus simulated, a bar for each model: of the bar's readings, and of all six motors. None of what
/// was not measured.
std::vector<Json> left_by_run_sections(const jobs::RunsAndModels& of);

/// Rms of measured minus simulated torques, run by motor. Null: none were measured.
Json torque_map_section(const jobs::RunsAndModels& of, std::string title);

/// Bar and motors along the turn: measured and simulated.
Json turn_section(const jobs::RunsAndModels& of, std::string title);
/// The same of measured minus simulated. Null: no model.
Json left_along_turn_section(const jobs::RunsAndModels& of, std::string title);

/// Adds a section unless it is null.
void add_section(Page& page, Json section);

}  // namespace plumbline::report
