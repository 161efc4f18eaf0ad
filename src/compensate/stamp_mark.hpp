// The mark of a compensated program.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/files/files.hpp"

namespace plumbline::compensate {

/// Whether the mark stands anywhere in the file, in whatever case and with whatever blanks.
bool is_compensated(const InputFile& file);

/// The share of a block's time that a compensated program's stamp says its blocks may differ by; none where the head of
/// the file does not say it.
std::optional<double> stamped_time_tolerance(const InputFile& file);

/// A compensated program holds the corrections already; a second helping would double them. Refuses with
/// compensate-stamped a file that is one.
class StampSearch {
 public:
  /// `program` must outlive it.
  explicit StampSearch(const InputFile& program) : program_(program) {}

  void look_at_program() const;
  /// A file of subprograms: it is compensated with the program, and looked at once.
  void look_at(std::string_view file);

 private:
  const InputFile& program_;
  std::set<std::string, std::less<>> seen_;
};

}  // namespace plumbline::compensate
