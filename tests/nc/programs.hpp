// Running programs in tests.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::nc::tests {

/// A program text in a file of its own, gone with the object.
class ProgramFile {
 public:
  explicit ProgramFile(std::string_view text, std::string_view ending = ".nc");
  ~ProgramFile();
  ProgramFile(const ProgramFile&) = delete;
  ProgramFile& operator=(const ProgramFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// As trace does it.
ProgramSettings empty_tables();
/// As compensate does it: every offset of G54 given as zero, axes at zero.
ProgramSettings at_zero();

std::vector<Motion> motions_of_file(const std::string& path, const ProgramSettings& settings,
                                    std::string_view control = "linuxcnc");
std::vector<Motion> motions_of(std::string_view text, const ProgramSettings& settings = empty_tables());
/// The diagnostic that the program is refused with, or nothing.
std::optional<Diagnostic> refusal_of_file(const std::string& path, const ProgramSettings& settings,
                                          std::string_view control = "linuxcnc");
std::optional<Diagnostic> refusal_of(std::string_view text, const ProgramSettings& settings = empty_tables(),
                                     std::string_view control = "linuxcnc");
/// Its code, or "".
std::string code_of(std::string_view text, const ProgramSettings& settings = empty_tables(),
                    std::string_view control = "linuxcnc");
/// The texts and line ends of all blocks.
std::string text_of_blocks(const std::string& path, const ProgramSettings& settings = empty_tables());

/// Programs of others: the folder that PLUMBLINE_NC_CORPUS names, else one beside the sources; "" if there is none.
/// none.
std::filesystem::path corpus();
/// tests/nc/programs and the like.
std::filesystem::path folder(std::string_view name);

}  // namespace plumbline::nc::tests
