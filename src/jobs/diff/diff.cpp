#include "jobs/diff/diff.hpp"

#include <optional>

#include "compensate/stamp_mark.hpp"
#include "jobs/diff/align.hpp"
#include "jobs/program/open_program.hpp"
#include "jobs/program/program_text.hpp"
#include "nc/rewrite/output/emit_settings.hpp"

namespace plumbline::jobs {

bool DiffSummary::equal_within(double tolerance_mm, double tolerance_deg) const {
  bool equal = out_of_line_a == 0 && out_of_line_b == 0;
  for (const Axis axis : kAllAxes) {
    equal = equal && shift[index(axis)].largest <= (is_rotary(axis) ? tolerance_deg : tolerance_mm);
  }
  return equal;
}

DiffSummary diff_files(const Source& a, const Source& b, const settings::Options& options, const Progress& progress,
                       compensate::DrawnPath* picture) {
  const OpenedProgram first = open_program(options, a);  // what both leave open cancels
  const InputFile file_b(b);
  refuse_unless_program_text(file_b);
  MoveQueue moves_a(first.file, first.dialect, first.settings);
  MoveQueue moves_b(file_b, first.dialect, first.settings);
  std::optional<compensate::PathRecord> record;
  if (picture != nullptr) {
    record.emplace();
    moves_a.keep_texts();
    moves_b.keep_texts();
  }
  const double time_tolerance = compensate::stamped_time_tolerance(file_b).value_or(nc::EmitSettings{}.time_tolerance);
  Aligner aligner(moves_a, moves_b, time_tolerance, record ? &*record : nullptr);
  for (std::uint64_t i = 1; aligner.next(); ++i) {
    if (progress && i % kProgressEvery == 0) progress(moves_b.bytes_read(), file_b.size());
  }
  DiffSummary summary = aligner.take();
  summary.moves_a = moves_a.moves();
  summary.moves_b = moves_b.moves();
  summary.seconds_a += moves_a.dwell_seconds();
  summary.seconds_b += moves_b.dwell_seconds();
  if (record) *picture = compensate::drawn_path(*record);
  return summary;
}

}  // namespace plumbline::jobs
