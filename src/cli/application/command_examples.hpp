// Where the help lists a command, and an example of it.
#pragma once

#include <array>
#include <string_view>

namespace plumbline::cli {

struct CommandExample {
  std::string_view command;
  std::string_view group;
  std::string_view example;  // without "plumbline"
};

inline constexpr std::string_view kOfPrograms = "Programs";
inline constexpr std::string_view kOfMachines = "The machine and its model";
inline constexpr std::string_view kOfMeasurements = "Measurements";
inline constexpr std::string_view kOfPlumbline = "plumbline itself";

// A command that is not here stands among the programs, without an example; a test finds it.
inline constexpr std::array kCommandExamples{
    CommandExample{"compensate", kOfPrograms,
                   "compensate part.ngc -m machine.toml --work-offset G54=0,0,-1008,0,0,0 -o straight.ngc"},
    CommandExample{"restore", kOfPrograms, "restore straight.ngc -o part.ngc"},
    CommandExample{"trace", kOfPrograms, "trace part.ngc -o moves.jsonl"},
    CommandExample{"check", kOfPrograms, "check part.ngc -m machine.toml --work-offset G54=0,0,-1008,0,0,0"},
    CommandExample{"simulate", kOfPrograms,
                   "simulate part.ngc -m machine.toml --work-offset G54=0,0,-1008,0,0,0 -o path.csv"},
    CommandExample{"diff", kOfPrograms, "diff part.ngc straight.ngc --tolerance-mm 0.01"},
    CommandExample{"error", kOfMachines, "error poses.csv -m machine.toml"},
    CommandExample{"map", kOfMachines, "map -m machine.toml"},
    CommandExample{"new-model", kOfMachines, "new-model --ini machine.ini -o machine.toml"},
    CommandExample{"control", kOfMachines, "control linuxcnc -m machine.toml -o control"},
    CommandExample{"plan", kOfMeasurements, "plan -m machine.toml -o tests"},
    CommandExample{"import", kOfMeasurements, "import circles.txt --map map.toml -o tests"},
    CommandExample{"inspect", kOfMeasurements, "inspect -d tests/dataset.toml -m machine.toml"},
    CommandExample{"circularity", kOfMeasurements, "circularity -d tests/dataset.toml"},
    CommandExample{"compare", kOfMeasurements, "compare -d tests/dataset.toml -m machine.toml"},
    CommandExample{"identify", kOfMeasurements, "identify -d tests/dataset.toml -m machine.toml -o learnt.toml"},
    CommandExample{"calibrate", kOfMeasurements, "calibrate -d tests/dataset.toml -m machine.toml -o learnt.toml"},
    CommandExample{"diagnose", kOfMeasurements, "diagnose -d tests/dataset.toml -m machine.toml -o diagnosis"},
    CommandExample{"explain", kOfPlumbline, "explain nc-unknown-code"},
    CommandExample{"settings", kOfPlumbline, "settings part.ngc"},
    CommandExample{"batch", kOfPrograms, "batch export -m machine.toml --work-offset G54=0,0,-1008,0,0,0 -o straight"},
};

}  // namespace plumbline::cli
