// What must hold of every drawn program.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "drawn/drawn_program.hpp"
#include "support/scratch.hpp"

namespace plumbline::drawn {

/// What does not hold.
struct Finding {
  std::string kind;  // the same for what has, most likely, the same cause
  std::string text;
};

struct Tally {
  std::uint64_t drawn = 0;
  std::uint64_t changed = 0;
  std::uint64_t unrolled = 0;
  std::uint64_t checks = 0;                      // whole comparisons with diff and check
  std::uint64_t interpreted = 0;                 // programs held against rs274, outputs among them
  std::map<std::string, std::uint64_t> refused;  // by code
  std::map<std::string, std::string> example;    // of each, the first

  void add(const Tally& other);
};

class Held {
 public:
  /// In a folder in memory where there is one.
  Held();

  bool with_diff = true;

  const Scene& scene() const { return scene_; }
  /// Compensates the program and holds all that is known against each other. `output`: what came out; empty if the
  /// program is refused or nothing changed.
  std::optional<Finding> check(const DrawnProgram& program, Tally& tally, std::string* output = nullptr);

 private:
  std::optional<Finding> check_ends(const DrawnProgram& program) const;
  std::optional<Finding> check_refused(const DrawnProgram& program, const std::string& code) const;
  std::optional<Finding> check_output(const DrawnProgram& program, double shift_mm, double shift_deg,
                                      double time_change) const;
  std::optional<Finding> check_diff(const DrawnProgram& program, double shift_mm, double shift_deg,
                                    double time_change) const;
  std::optional<Finding> check_zero(const DrawnProgram& program) const;

  testing::Scratch scratch_;
  Scene scene_;
};

}  // namespace plumbline::drawn
