// A program in a file of its own, and the parts that it goes through one by one.
#pragma once

#include <string>
#include <utility>

#include "compensate/move_reader.hpp"
#include "compensate/play.hpp"

namespace plumbline {

struct Opened {
  explicit Opened(const std::string& text, Job given = {})
      : job(std::move(given)), source(folder.file("program.in", text)), dialect(nc::dialect(job.dialect)) {}

  compensate::ReaderSettings reader_settings() const {
    return {nc::named_axes(source, dialect), job.settings.step, job.model.reference_tool_mass, {}};
  }

  Folder folder;
  Job job;
  InputFile source;
  const nc::Dialect& dialect;
};

/// A reader of the program of `opened`, which must outlive it.
inline compensate::MoveReader reader_of(const Opened& opened) {
  return {opened.source, opened.dialect, opened.job.program, opened.reader_settings()};
}

inline Job standing_at_zero() {
  Job job;
  job.program.start.fill(0);
  return job;
}

}  // namespace plumbline
