// Steps as a program would hold them that has no parameters and no polar words: the same motion, written with values.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "nc/control/state/control.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/rewrite/output/emit_codes.hpp"
#include "nc/rewrite/output/emit_text.hpp"
#include "nc/rewrite/unrolled/made_steps.hpp"

namespace plumbline::nc {

class StepExpander {
 public:
  /// The dialect must outlive it. `angle`: how A, B and C are written.
  explicit StepExpander(const Dialect& dialect, WrittenNumber angle = {})
      : dialect_(dialect), made_(dialect), angle_(angle) {
    spelling_.point = dialect.behaviour.always_point;
    spelling_.most_digits = dialect.behaviour.most_digits;
  }

  /// The step with a block that holds values where the original has expressions, X and Y in place of @ and ^, and A, B
  /// and C in place of the direction of the tool.
  /// Values come with nine decimals, and count as written with none. Its parameter settings go too unless
  /// `keeps_settings`; null if nothing else was in it. Holds until the next call. Refuses a value that only the machine
  /// knows (emit-value-unknown).
  const Step* plain(const Step& step, bool keeps_settings);

  /// Whether a line that steers does something else as well: it moves, or has words of its own, among them those that
  /// go on counting (G90, G64). All words beside G65 are the macro's.
  bool acts_beside_flow(const Step& step) const;
  /// What else stands in a line that steers: where it `acts`, all but the call or the end of a program, else its
  /// comments; null if there are none. Holds until the next call.
  const Step* beside_flow(const Step& step, bool acts);

  /// The first comment that shows parameters on the control and shows nothing in what was made here; null: none.
  const Place* silenced() const { return silenced_ ? &*silenced_ : nullptr; }

 private:
  std::string with_value(const Step& step, const Word& word) const;
  int decimals_of_value(const Step& step, const Word& word) const;
  void write_values(const Step& step, bool keeps_settings, std::string_view without = {});
  bool steers(const Word& word) const;
  std::string words_of_flow(const Block& block) const;
  void write_without_call(const Step& step, std::string& text);
  static bool is_end_in_other_words(const Step& step, const Word& word);
  std::string_view code_without_vectors(const Step& step, const Word& word) const;
  void write_end(const Step& step, bool& written, Span span);
  void defuse_comments(const Block& block);
  bool is_defused_beside_flow(std::string_view comment) const;
  Span label_of(const Block& block);

  const Dialect& dialect_;
  MadeSteps made_;
  WrittenNumber angle_;
  std::set<std::string, std::less<>> numbers_;  // that stood in blocks, where they are labels
  std::optional<Place> silenced_;
  BlockEditor editor_;
  Spelling spelling_;
};

}  // namespace plumbline::nc
