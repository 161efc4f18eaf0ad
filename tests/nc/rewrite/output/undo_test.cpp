// Also the undo records of output_text.cpp, whose text emit_test.cpp tests.
#include "nc/rewrite/output/undo.hpp"

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

TEST_CASE("parts of several programs stand after each other, and each finds its own") {
  const Folder folder;
  write_case(folder);
  const std::string first = read_text(folder / "undo");
  write_text(folder / "original2", "G0 X9\nM2\n");
  write_text(folder / "output2", "G0 X9.5\nM2\n");
  {
    OutputFile file(folder / "undo2");
    nc::UndoLog log(file);
    log.replaced(0, 8, "G0 X9\n");
    log.finish(InputFile(folder / "original2"), 11, fnv1a("G0 X9.5\nM2\n"));
    file.commit();
  }
  const std::string second = read_text(folder / "undo2");
  for (const std::string& both : {first + second, second + first}) {
    write_text(folder / "undo", both);
    CHECK(restored(folder) == read_text(folder / "original"));
    OutputFile part(folder / "part");
    CHECK(nc::copy_undo(InputFile(folder / "output2"), InputFile(folder / "undo"), part));
    part.commit();
    CHECK(read_text(folder / "part") == second);
  }
  OutputFile none(folder / "none");
  CHECK_FALSE(nc::copy_undo(InputFile(folder / "original"), InputFile(folder / "undo"), none));
  CHECK(none.size() == 0);
  write_text(folder / "undo", first + "something else\n");
  fs::remove(folder / "back");
  CHECK(code_of(folder) == "undo-format");
}

TEST_CASE("spans that overlap, lie beyond the output or write another size are refused before anything is written") {
  const Folder folder;
  write_case(folder);
  const std::string size = std::to_string(fs::file_size(folder / "output"));
  for (const std::string& spans :
       {"replaced 10 5 0\n\nreplaced 12 5 0\n\nend 10 " + size, "replaced 10 18446744073709551610 0\n\nend 40 " + size,
        "replaced 0 999 0\n\nend 0 " + size, "replaced 0 8 0\n\nend 20000000000 " + size}) {
    INFO(spans);
    write_text(folder / "undo", "plumbline undo 1\n" + spans + " 0000000000000000 0000000000000000\n");
    CHECK(code_of(folder) == "undo-format");
  }
}
