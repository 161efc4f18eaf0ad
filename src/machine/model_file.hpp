// Reading a machine model file.
#pragma once

#include <string>

#include "base/files/source.hpp"
#include "machine/model.hpp"

namespace plumbline::machine {

/// The machine that a text states; `file` names it in messages. Whatever is wrong with it is refused with file, line,
/// column and the way out: toml-syntax, or one of the codes that read_values, read_effect_rows and check_model list, or
/// model-rotation. What the [[effect]] rows mean is for the physics to judge.
MachineModel parse_model(std::string text, std::string file);

/// The same of a file. Refuses as read_text does, too.
MachineModel read_model(const Source& source);

}  // namespace plumbline::machine
