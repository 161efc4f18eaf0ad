#include "nc/undo.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

using Folder = testing::Scratch;

// "G0 X1\nG1 X2\nG1 X3\nM2\n" rewritten with a stamp and two blocks replaced.
void write_case(const Folder& folder) {
  write_text(folder / "original", "G0 X1\nG1 X2\nG1 X3\nM2\n");
  const std::string output = "(stamp)\nG0 X1\nG1 X2.1\nX2.2\nG1 X3.3\nM2\n";
  write_text(folder / "output", output);
  OutputFile file(folder / "undo");
  nc::UndoLog log(file);
  log.replaced(0, 8, "");
  log.replaced(14, 13, "G1 X2\n");
  log.replaced(27, 8, "G1 X3\n");  // touches the one before
  log.finish(InputFile(folder / "original"), output.size(), fnv1a(output));
  file.commit();
}

std::string restored(const Folder& folder) {
  const InputFile rewritten(folder / "output");
  const InputFile undo(folder / "undo");
  OutputFile out(folder / "back");
  nc::restore(rewritten, undo, out);
  out.commit();
  return read_text(folder / "back");
}

std::string code_of(const Folder& folder) {
  try {
    restored(folder);
  } catch (const Refusal& refusal) {
    CHECK_FALSE(fs::exists(folder / "back"));
    return refusal.diagnostic().code;
  }
  return "";
}

}  // namespace

TEST_CASE("the original comes back byte for byte") {
  const Folder folder;
  write_case(folder);
  CHECK(restored(folder) == read_text(folder / "original"));
}

TEST_CASE("a program that was changed since is not restored") {
  const Folder folder;
  write_case(folder);
  write_text(folder / "output", "(stamp)\nG0 X7\nG1 X2.1\nX2.2\nG1 X3.3\nM2\n");
  CHECK(code_of(folder) == "undo-mismatch");
  write_text(folder / "output", "(stamp)\n");
  CHECK(code_of(folder) == "undo-mismatch");
}

TEST_CASE("an undo file that is none, or cut short, is refused") {
  const Folder folder;
  write_case(folder);
  const std::string whole = read_text(folder / "undo");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    INFO(length);
    write_text(folder / "undo", whole.substr(0, length));
    CHECK(code_of(folder).starts_with("undo-"));
  }
  write_text(folder / "undo", "plumbline undo 1\nreplaced 99999999999 3 2\nab\n");
  CHECK(code_of(folder) == "undo-format");
}
