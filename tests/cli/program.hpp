// The built program, run as a user runs it.
#pragma once

#include <cstdlib>
#include <string>

#include <sys/wait.h>

#include "support/scratch.hpp"

namespace plumbline::testing {

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// The one that was built, or another that is to be tried: $PLUMBLINE_PROGRAM.
inline std::string program() {
  const char* const named = std::getenv("PLUMBLINE_PROGRAM");
  return named == nullptr ? PLUMBLINE_PROGRAM : named;
}

/// Runs `plumbline arguments` by the shell, in the scratch folder and without anybody's own settings; `before` stands
/// before the command, as in "LC_ALL=C".
inline Outcome run(const Scratch& scratch, const std::string& arguments, const std::string& before = "") {
  const std::string command = "cd '" + scratch.path("") +
                              "' && unset PLUMBLINE_SETTINGS && export XDG_CONFIG_HOME=none && { " + before + " '" +
                              program() + "' " + arguments + "; } >stdout.txt 2>stderr.txt";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, scratch.text("stdout.txt"), scratch.text("stderr.txt")};
}

inline const std::string kModel = "-m " + source_file("models/pm600-like.toml");
inline const std::string kOffset = " --work-offset G54=0,0,-1008,0,0,0 ";
inline constexpr const char* kPart =
    "(PART)\nG21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\nG1 Z0 F500\nG1 X20.5 Y10.25 A5 B-2.5 C1\nG2 X30.5 Y20.25 I5 J5\nM2\n";

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace plumbline::testing
