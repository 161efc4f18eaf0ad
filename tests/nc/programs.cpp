#include "nc/programs.hpp"

#include <cstdlib>

#include <unistd.h>

#include "base/files/files.hpp"

namespace plumbline::nc::tests {
namespace fs = std::filesystem;

ProgramFile::ProgramFile(std::string_view text, std::string_view ending) {
  static int count = 0;
  path_ = (fs::temp_directory_path() /
           ("plumbline-" + std::to_string(getpid()) + "-" + std::to_string(count++) + std::string(ending)))
              .string();
  std::ofstream(path_, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
}

ProgramFile::~ProgramFile() { fs::remove(path_); }

ProgramSettings empty_tables() {
  ProgramSettings settings;
  settings.as_with_empty_tables = true;
  return settings;
}

ProgramSettings at_zero() {
  ProgramSettings settings;
  settings.work_offsets[0] = WorkOffset{};
  settings.start.fill(0.0);
  return settings;
}

std::vector<Motion> motions_of_file(const std::string& path, const ProgramSettings& settings,
                                    std::string_view control) {
  const InputFile file(path);
  Program program(file, dialect(control), settings);
  std::vector<Motion> motions;
  while (const Step* step = program.next()) motions.insert(motions.end(), step->motions.begin(), step->motions.end());
  return motions;
}

std::vector<Motion> motions_of(std::string_view text, const ProgramSettings& settings) {
  return motions_of_file(ProgramFile(text).path(), settings);
}

std::optional<Diagnostic> refusal_of_file(const std::string& path, const ProgramSettings& settings,
                                          std::string_view control) {
  try {
    motions_of_file(path, settings, control);
  } catch (const Refusal& refusal) {
    return refusal.diagnostic();
  }
  return std::nullopt;
}

std::optional<Diagnostic> refusal_of(std::string_view text, const ProgramSettings& settings, std::string_view control) {
  return refusal_of_file(ProgramFile(text).path(), settings, control);
}

std::string code_of(std::string_view text, const ProgramSettings& settings, std::string_view control) {
  const auto refusal = refusal_of(text, settings, control);
  return refusal ? refusal->code : "";
}

std::string text_of_blocks(const std::string& path, const ProgramSettings& settings) {
  const InputFile file(path);
  Program program(file, dialect("linuxcnc"), settings);
  std::string text;
  while (const Step* step = program.next()) {
    text += step->block->text;
    text += step->block->line_end;
  }
  return text;
}

fs::path corpus() {
  const char* const named = std::getenv("PLUMBLINE_NC_CORPUS");
  fs::path path = named != nullptr ? fs::path(named) : fs::path(PLUMBLINE_SOURCE_DIR) / "../shared/nc";
  return fs::is_directory(path) ? path : fs::path();
}

fs::path folder(std::string_view name) { return fs::path(PLUMBLINE_SOURCE_DIR) / "tests/nc" / name; }

}  // namespace plumbline::nc::tests
