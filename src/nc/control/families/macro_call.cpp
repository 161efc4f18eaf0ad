// G65: a call with arguments.
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

// The variable of each letter by argument specification I [B-63684EN 16, p. 278]; 0: the letter takes no argument.
int variable_of(char letter) {
  constexpr std::string_view kLetters = "ABCIJKDEFHMQRSTUVWXYZ";
  constexpr int kVariables[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  const std::size_t at = kLetters.find(letter);
  return at == std::string_view::npos ? 0 : kVariables[at];
}

constexpr int kSets = 10;  // of I J K by specification II: #4 #5 #6, #7 #8 #9...

}  // namespace

void call_macro(Execution& run) {
  run.arguments.clear();
  run.call.kind = ProgramCall::Kind::macro;
  run.call.number = -1;
  bool after_call = false;
  int set[3] = {0, 0, 0};
  for (const Word& word : run.block->words) {
    if (word.letter == 'G' && !after_call) {
      const CodeRow* const row = run.dialect.row_of(word);
      after_call = row != nullptr && row->action == Action::call_macro;
      continue;
    }
    if (!after_call) continue;
    if (word.letter == 'P') {
      run.call.number = run.whole(word, 0, kNoLimit);
    } else if (word.letter == 'L') {
      run.call.count = run.whole(word, run.dialect.behaviour.least_calls, kNoLimit);
    } else if (word.letter >= 'I' && word.letter <= 'K') {
      // The first, second... I, J or K: an I after a J or K belongs to the next set.
      const int which = word.letter - 'I';
      int number = set[which];
      for (int i = which + 1; i < 3; ++i) number = std::max(number, set[i]);
      for (int i = 0; i < which; ++i) {
        if (set[i] <= number + 1) continue;
        run.refuse(
            word, codes::kNotInterpreted,
            fmt::format("whether {} belongs to this set of I, J and K, or to the first without one, was found in "
                        "no source",
                        word.letter),
            "write I, J and K of each set one after the other");
      }
      if (number >= kSets) run.refuse(word, codes::kOutOfRange, "a macro takes ten sets of I, J and K", "leave it out");
      set[which] = number + 1;
      run.arguments.emplace_back(4 + 3 * number + which, Value{word.value, !word.unknown, word.vacant, word.rounded});
    } else {
      const int variable = variable_of(word.letter);
      if (variable == 0) {
        run.refuse(word, codes::kWordUnused, "a macro takes no argument of this letter", "choose another letter");
      }
      run.arguments.emplace_back(variable, Value{word.value, !word.unknown, word.vacant, word.rounded});
    }
  }
  if (run.call.number < 0) run.refuse(codes::kWordMissing, "G65 needs a P word", "add the number of the program");
}

}  // namespace plumbline::nc
