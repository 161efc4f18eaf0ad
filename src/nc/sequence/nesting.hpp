// What begins, divides and ends loops and branches, paired by the text of a program: where an end stands says which
// begin is its own, whatever jumps lead there.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "nc/syntax/line_head.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {

/// A loop or a branch. One with a fault has no end, or holds what does not belong there.
struct NestedPart {
  FlowWord word = FlowWord::none;  // that begins it
  int number = 0;                  // of DO
  LinePlace begin;
  LinePlace otherwise;  // of its ELSE; line 0: it has none
  LinePlace end;
  std::string fault;     // as a message calls it
  bool is_open = false;  // the fault: it has no end

  bool contains(std::size_t line) const { return line >= begin.line && line <= end.line; }
  /// True of what can be reached by a jump alone from a line to another: behind the begin, or behind ELSE from before
  /// it and the other way round.
  bool is_entered(std::size_t from, std::size_t to) const;
};

class Nesting {
 public:
  /// The lines of a file, in their order. `left_out`: those behind / are.
  void add(const LineHead& head, const LinePlace& place, bool left_out);
  /// The file ends.
  void close();

  /// What this line begins, divides or ends, paired or not; null: it is none such.
  const NestedPart* part_at(std::size_t line) const;
  /// The first that a jump leads into; null: there is none.
  const NestedPart* entered(std::size_t from, std::size_t to) const;
  /// The first that begins, is divided or ends in one of these lines, and is not in them as a whole; null: there is
  /// none.
  const NestedPart* cut_by(std::size_t first, std::size_t last) const;
  /// True if a line between these two begins, divides or ends what is of the same kind, and stands behind /.
  bool has_slash_between(const LinePlace& from, const LinePlace& to, FlowWord kind) const;

 private:
  struct LineBehindSlash {
    std::size_t line = 0;
    FlowWord kind = FlowWord::none;  // the word that begins such a part
  };

  void begin(const LineHead& head, const LinePlace& place);
  void divide(const LineHead& head, const LinePlace& place);
  void end(const LineHead& head, const LinePlace& place, FlowWord kind);
  void add_stray(const LinePlace& place, std::string fault);

  std::vector<NestedPart> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> lines_;  // with the number of their part
  std::vector<std::size_t> open_;                           // numbers of parts, one inside the other
  std::vector<LineBehindSlash> behind_slash_;
};

}  // namespace plumbline::nc
