#include "nc/sequence/called_program.hpp"

#include <optional>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/sequence/subprogram_file.hpp"

namespace plumbline::nc {
namespace {

[[noreturn]] void refuse_missing_program(const Block& block, const std::string& name, LabelIndex& labels,
                                         const Dialect& dialect) {
  if (const std::optional<LinePlace> behind = labels.behind_end(name)) {
    refuse_flow(block, codes::kFlowOpen,
                fmt::format("subprogram {} stands in line {}, behind the second %: the control stops reading there",
                            name, behind->line),
                "take out the % between the two programs, or put the subprogram into a file of its own");
  }
  if (const std::string other = labels.name_with_other_zeros(name); !other.empty()) {
    refuse_flow(block, codes::kFlowOpen,
                fmt::format("there is no subprogram {}, but {}: whether the control takes it for the same was found in "
                            "no source",
                            name, other),
                "call it by its name as it is written there");
  }
  refuse_flow(
      block, codes::kFlowOpen, fmt::format("subprogram {} is neither in this file nor beside it", name),
      fmt::format("put it into a file of its name beside the program, as {}", subprogram_file_name(name, dialect)));
}

// Libraries are known to a control before a program runs: which of two it takes does not depend on the order of calls.
void check_one_file(const Block& block, LabelIndex& labels, const std::string& name, const FilePlace& found) {
  const std::optional<LabelIndex::SameName> same = labels.find_same_name(name, found);
  if (!same) return;
  refuse_flow(block, "nc-subprogram-ambiguous",
              fmt::format("subprogram {} begins in {} and in {}, and which of them the control takes was found in no "
                          "source",
                          same->name, same->one, same->other),
              "move away the one that the control does not have, or give them names of their own");
}

}  // namespace

FilePlace program_called(const Block& block, const std::string& name, LabelIndex& labels, const Dialect& dialect) {
  if (const std::optional<FilePlace> found = labels.find_program(name)) {
    if (labels.is_twice(name)) {
      refuse_flow(block, codes::kFlowOpen, fmt::format("several programs of these files are named {}", name),
                  "leave the one that is meant, or give them names of their own");
    }
    if (dialect.syntax.statements == Statements::user_task) check_one_file(block, labels, name, *found);
    return *found;
  }
  refuse_missing_program(block, name, labels, dialect);
}

}  // namespace plumbline::nc
