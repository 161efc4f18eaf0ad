// Loops and jumps that lead back: loops that no control takes, and ways that never end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "nc/control/interpreter.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/label_index.hpp"
#include "nc/sequence/program_files.hpp"

namespace plumbline::nc {

class WaysBack {
 public:
  /// All must outlive it.
  WaysBack(const ProgramFiles& files, LabelIndex& labels, const Dialect& dialect, Interpreter& interpreter)
      : files_(files), labels_(labels), dialect_(dialect), interpreter_(interpreter) {}

  /// DO 1 to DO 3, one inside the other; refuses with nc-flow-control others, and loops that cross.
  void check_loop(const Block& block);
  /// The line leads back. Refuses with nc-too-many-blocks if it did so before and no variable got another value since:
  /// it will for ever.
  void check_way_back(const Block& block);
  /// The same of a line that ends the main program and leads back, whatever was called in between.
  void check_main_again(const Block& block);
  /// What counts calls or repetitions goes on: a line may lead back once more in each of them.
  void forget() { changes_at_.clear(); }

 private:
  using FileLine = std::pair<std::size_t, std::size_t>;
  using ChangesAt = std::map<FileLine, std::uint64_t>;
  void check_against(const Block& block, ChangesAt& changes_at);

  const ProgramFiles& files_;
  LabelIndex& labels_;
  const Dialect& dialect_;
  Interpreter& interpreter_;
  std::set<FileLine> checked_;
  ChangesAt changes_at_, changes_of_main_at_;
};

}  // namespace plumbline::nc
