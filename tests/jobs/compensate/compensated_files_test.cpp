#include "jobs/compensate/compensated_files.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

constexpr const char* kOriginal = "G0 X1\nG1 X2 F100\nM2\n";

// As a compensation writes it: X2 becomes `x`.
void write_corrected(const testing::Scratch& scratch, const std::string& x,
                     const std::vector<std::string>& reports = {}) {
  const InputFile original(scratch.file("p.ngc", kOriginal));
  jobs::CompensatedFiles files(scratch / "out.ngc", jobs::undo_name(scratch / "out.ngc"), reports);
  files.program().write("G0 X1\nG1 ");
  files.undo_log()->replaced(9, x.size(), "X2");
  files.program().write(x + " F100\nM2\n");
  for (OutputFile& report : files.reports()) report.write("{}\n");
  files.commit(original);
}

std::string restored(const testing::Scratch& scratch, const std::string& program) {
  const auto [rewritten, undo] = jobs::open_pair(program, scratch / "out.ngc.undo");
  OutputFile out(scratch / "restored.ngc");
  nc::restore(rewritten, undo, out);
  out.commit();
  return scratch.text("restored.ngc");
}

}  // namespace

TEST_CASE("program, undo file and summary appear, and the undo file gives the original back") {
  const testing::Scratch scratch;
  write_corrected(scratch, "X2.0123", {scratch / "sum.json"});
  CHECK(jobs::undo_name("out.ngc") == "out.ngc.undo");
  CHECK(scratch.text("out.ngc") == "G0 X1\nG1 X2.0123 F100\nM2\n");
  CHECK(scratch.text("sum.json") == "{}\n");
  CHECK(restored(scratch, scratch / "out.ngc") == kOriginal);
}

TEST_CASE("without --undo and --json the program appears alone, and only at the end") {
  const testing::Scratch scratch;
  const InputFile original(scratch.file("p.ngc", kOriginal));
  {
    jobs::CompensatedFiles files(scratch / "out.ngc", std::nullopt, {});
    CHECK(files.undo_log() == nullptr);
    files.program().write("G0 X1\n");
    CHECK_FALSE(scratch.has("out.ngc"));
  }
  CHECK_FALSE(scratch.has("out.ngc"));
  jobs::CompensatedFiles files(scratch / "out.ngc", std::nullopt, {});
  files.program().write("G0 X1\n");
  files.commit(original);
  CHECK(scratch.text("out.ngc") == "G0 X1\n");
  CHECK_FALSE(scratch.has("out.ngc.undo"));
}

TEST_CASE("a pair that is replaced leaves an undo file of the new program alone") {
  const testing::Scratch scratch;
  write_corrected(scratch, "X2.01");
  const std::string first = scratch.text("out.ngc");
  write_corrected(scratch, "X2.02");
  CHECK(restored(scratch, scratch / "out.ngc") == kOriginal);
  scratch.file("first.ngc", first);
  CHECK(testing::refusal_of([&] { restored(scratch, scratch / "first.ngc"); }).code == "undo-mismatch");
}

TEST_CASE("an undo file that fits nothing is no hindrance") {
  const testing::Scratch scratch;
  scratch.file("out.ngc", "G0 X99\n");
  scratch.file("out.ngc.undo", "of somebody else\n");
  write_corrected(scratch, "X2.5");
  CHECK(restored(scratch, scratch / "out.ngc") == kOriginal);
}

TEST_CASE("nothing appears where the program was written to meanwhile, or a file cannot be had") {
  const testing::Scratch scratch;
  const InputFile original(scratch.file("p.ngc", kOriginal));
  {
    jobs::CompensatedFiles files(scratch / "out.ngc", jobs::undo_name(scratch / "out.ngc"), {scratch / "sum.json"});
    files.program().write("G0 X1\n");
    files.reports().front().write("{}\n");
    scratch.file("p.ngc", "G0 X5\n");
    CHECK(testing::refusal_of([&] { files.commit(original); }).code == "file-changed");
  }
  for (const char* const name : {"out.ngc", "out.ngc.undo", "sum.json"}) CHECK_FALSE(scratch.has(name));
  CHECK(testing::refusal_of([&] {
          jobs::CompensatedFiles(scratch / "out.ngc", std::nullopt, {scratch / "none/sum.json"});
        }).code == "file-unwritable");
  CHECK(testing::refusal_of([&] { jobs::open_pair(scratch / "p.ngc", scratch / "none.undo"); }).code == "file-missing");
}
