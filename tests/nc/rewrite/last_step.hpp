// The step that a program ends with, held as long as the object: what the parts of the emitter are given.
#pragma once

#include <algorithm>
#include <string_view>

#include "nc/programs.hpp"

namespace plumbline::nc::tests {

struct LastStep {
  /// Every line of the text is one block; lines from `lines` on are not executed.
  explicit LastStep(std::string_view text, std::string_view dialect_name = "linuxcnc",
                    const ProgramSettings& settings = at_zero(), long lines = 0)
      : text_file(text), file(text_file.path()), program(file, dialect(dialect_name), settings) {
    for (long left = lines > 0 ? lines : std::count(text.begin(), text.end(), '\n'); left > 0; --left) {
      step = program.next();
    }
  }
  const Step& operator*() const { return *step; }
  const Step* operator->() const { return step; }

  ProgramFile text_file;
  InputFile file;
  Program program;
  const Step* step = nullptr;
};

}  // namespace plumbline::nc::tests
