// An output with what it was meant to be, and faults put into it.
#pragma once

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"
#include "compensate/read_back/output_check.hpp"

namespace plumbline {

struct Meant {
  std::string source, output;
  std::vector<compensate::IntendedBatch> batches;
  bool unrolled = false;
};

inline Meant compensated(const std::string& text, const Job& job) {
  const Folder folder;
  write_text(folder / "program.in", text);
  const InputFile source(folder / "program.in");
  OutputFile out(folder / "program.out");
  const compensate::ProgramSurvey survey = surveyed(source, job);
  compensate::Stream stream(source, survey, job.program, job.model, job.settings, job.emit, out);
  Meant meant;
  stream.show([&](const compensate::IntendedBatch& batch) { meant.batches.push_back(batch); });
  meant.unrolled = stream.run().unrolled;
  out.commit();
  meant.source = text;
  meant.output = read_text(folder / "program.out");
  return meant;
}

// What reading `output` says, which was made from the one that was meant by exchanging bytes at `at`.
inline std::string found(Meant meant, const Job& job, std::size_t at, std::size_t size, const std::string& by) {
  meant.output.replace(at, size, by);
  for (compensate::IntendedBatch& batch : meant.batches) {
    for (compensate::IntendedBlock& block : batch.blocks) {
      if (block.output_end > at) block.output_end += by.size() - size;
    }
  }
  const Folder folder;
  write_text(folder / "source", meant.source);
  write_text(folder / "output", meant.output);
  const InputFile source(folder / "source");
  const InputFile output(folder / "output");
  compensate::OutputCheck check(source, output, nc::dialect(job.dialect), job.program, job.emit, meant.unrolled);
  try {
    for (const compensate::IntendedBatch& batch : meant.batches) check.take(batch);
    check.finish();
  } catch (const Refusal& refusal) {
    CHECK(refusal.diagnostic().code == "compensate-read-back");
    CHECK(refusal.diagnostic().place.line > 0);
    return refusal.what();
  }
  return {};
}

// The same with the first `what` after `behind` exchanged.
inline std::string found(const Meant& meant, const Job& job, const std::string& behind, const std::string& what,
                         const std::string& by) {
  const std::size_t begin = meant.output.find(behind);
  REQUIRE(begin != std::string::npos);
  const std::size_t at = meant.output.find(what, begin + behind.size());
  INFO(behind << " ... " << what << " in\n" << meant.output);
  REQUIRE(at != std::string::npos);
  return found(meant, job, at, what.size(), by);
}

}  // namespace plumbline
