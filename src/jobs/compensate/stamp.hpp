// The comments that mark a compensated program: what made it, and what it holds for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compensate/program_survey.hpp"
#include "machine/model.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// Texts of comments for nc::EmitSettings::stamp. The first is "plumbline VERSION compensated this program", by which a
/// compensated program is known; then model, method, settings, offsets and tools. Plain ASCII without ( ) ; or %, none
/// longer than the dialect's line with the comment signs around it.
std::vector<std::string> stamp(const settings::Options& options, const nc::ProgramSettings& program,
                               const machine::MachineModel& model, const compensate::ProgramSurvey& survey);

/// A text that can stand in a comment of any control: what cannot is replaced.
std::string comment_text(std::string_view text);

}  // namespace plumbline::jobs
