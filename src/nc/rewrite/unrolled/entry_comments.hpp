// Comments of an unrolled program that say which loop or subprogram is entered.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/output/output_text.hpp"

namespace plumbline::nc {

/// A file of subprograms that stands in the output now.
struct InlinedFile {
  std::string name;
  std::uint64_t hash = 0;
};

/// They wait until a block is written: what is entered and left without one is not told.
class EntryComments {
 public:
  explicit EntryComments(const Dialect& dialect) : dialect_(dialect) {}

  void note(const FlowEntry& entry);
  void write(OutputText& out);
  const std::vector<InlinedFile>& inlined() const { return inlined_; }

 private:
  struct Pending {  // an entry whose first block was not met yet
    FlowEntry::Kind kind;
    std::string name;
    std::size_t line;
    std::string text;
  };
  std::string text_of(const FlowEntry& entry);

  const Dialect& dialect_;
  std::vector<Pending> entries_;
  std::vector<InlinedFile> inlined_;
};

}  // namespace plumbline::nc
