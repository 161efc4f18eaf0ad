#include "jobs/compensate/output_of.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "compensate/stamp_mark.hpp"
#include "settings/output_name.hpp"

namespace plumbline::jobs {

std::string output_of(const std::string& program, const settings::Options& options) {
  if (program == kStandardStream) return std::string(kStandardStream);
  std::string output = settings::output_name(program, options);
  std::error_code error;
  if (std::filesystem::equivalent(path_of(program), path_of(output), error)) {
    refuse("file-overwrites-input", fmt::format("--output-name gives the output the name of the program {}", program),
           "give a pattern with more than {name}{ext}, or name the output with -o", {output, 0});
  }
  if (std::filesystem::is_regular_file(path_of(output), error) && !compensate::is_compensated(InputFile(output))) {
    refuse("file-exists", fmt::format("{} stands there already, and is no compensated program", output),
           fmt::format("name the output with -o, which writes over it, or give another pattern with --output-name"),
           {output, 0});
  }
  return output;
}

}  // namespace plumbline::jobs
