// The file of a posterior, which lies beside the model that it belongs to and is named in it.
#pragma once

#include <string>

#include "identify/posterior/posterior.hpp"

namespace plumbline::identify {

/// "plumbline posterior 1" (docs/formats.md). `numbers`: machine::numbers_hash of the model as it was written.
std::string posterior_text(const Posterior& posterior, std::uint64_t numbers);

/// Of a machine whose numbers it says it belongs to. Refuses with posterior-wrong what is no such file, with
/// posterior-other-model one that belongs to other numbers.
Posterior parse_posterior(std::string text, std::string file, const machine::MachineModel& machine);

/// The file that a model names as its posterior, be it there or not. Empty: it names none, or is no file that can be
/// read as a model.
std::string posterior_named_in(const std::string& model_path);

/// What is known of a model: the posterior that it names, or else its [uncertainty]. The file is looked for beside the
/// model. Refuses as parse_posterior and the reader of files do, and with posterior-other-file where it is not the one
/// that the model names.
Posterior known_of(const machine::MachineModel& machine);

}  // namespace plumbline::identify
