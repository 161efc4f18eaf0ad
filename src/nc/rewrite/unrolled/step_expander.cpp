#include "nc/rewrite/unrolled/step_expander.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/active_comments.hpp"
#include "nc/language/refusal.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {
namespace {

constexpr double kWholeCode = 1e-9;    // how far G54 may be from a whole number
constexpr double kRoundedFeed = 1e-4;  // of it, by which a feed that is worked out may be rounded

constexpr std::size_t kLongestActive = 10;  // letters of an active comment's word

bool is_polar(const Word& word) { return word.letter == '@' || word.letter == '^'; }

bool turns_tool(const Step& step) { return step.end_words == EndWords::tool_vector; }

// The active comment that it is; null: none.
const ActiveComment* active_comment(std::string_view comment) {
  std::string text;
  for (const char c : comment.substr(1)) {
    if (c != ' ' && c != '\t') text += lower(c);
    if (text.size() > kLongestActive) break;
  }
  const auto* const found =
      std::find_if(kActiveComments.begin(), kActiveComments.end(), [&](const ActiveComment& active) {
        const bool of_file = active.word.starts_with("log") || active.word.starts_with("probe");
        if (!text.starts_with(active.word)) return false;
        return text.substr(active.word.size(), 1) == "," || (of_file && active.word != "log");
      });
  return found == kActiveComments.end() ? nullptr : found;
}

// Active comments that show parameters, which a program without parameters has not.
bool shows_parameters(std::string_view comment) {
  const ActiveComment* const active = active_comment(comment);
  return active != nullptr && active->shows_parameters && comment.find('#') != std::string_view::npos;
}

bool is_plain(const Step& step, bool keeps_settings) {
  const Block& block = *step.block;
  if (turns_tool(step)) return false;
  const bool heads = block.flow.word == FlowWord::sub;  // PROC, whose parameters those give that call the program
  if (!keeps_settings && !block.settings.empty() && !heads) return false;
  if (!block.left_out.empty() || (!keeps_settings && step.passed != nullptr)) return false;
  if (step.end_words == EndWords::polar && step.cycle == CycleForm::none && step.motions.size() == 1) return false;
  for (const Comment& comment : block.comments) {
    if (!keeps_settings && shows_parameters(block.at(comment.span))) return false;
  }
  const auto plain = [](const Argument& argument) { return argument.plain; };
  if (!keeps_settings && !std::all_of(block.arguments.begin(), block.arguments.end(), plain)) return false;
  return std::all_of(block.words.begin(), block.words.end(),
                     [](const Word& word) { return word.expression == kLiteral; });
}

}  // namespace

// NAME: of a program that is written out, where nothing jumps there and the same name would stand more than once. Where
// N names a label, too, it stays where it comes first.
Span StepExpander::label_of(const Block& block) {
  if (dialect_.syntax.labels == Labels::sequence_names) {
    const bool again = block.number.end > block.number.begin && !numbers_.emplace(block.at(block.number)).second;
    return again ? block.number : Span{};
  }
  if (dialect_.syntax.labels != Labels::names || block.kind != LineKind::block) return {};
  if (head_of(block.text, dialect_).label.empty()) return {};
  const std::size_t before = std::max(block.number.end, block.slash.end);
  const std::size_t begin = block.text.find_first_not_of(" \t", before);
  std::size_t end = block.text.find(':', begin) + 1;
  if (before == 0)
    end = std::min(block.text.find_first_not_of(" \t", end), block.text.size());  // else those before it go
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

const Step* StepExpander::plain(const Step& step, bool keeps_settings) {
  if (made_.holds(step)) return &step;  // as it was written out before, X=AC(5) and all
  made_.clear();
  const Block& block = *step.block;
  if (step.stop != StopByVariable::none) return &step;
  const Span label = keeps_settings ? Span{} : label_of(block);
  const bool has_label = label.end > label.begin;
  if (step.block_delete == BlockDelete::left_out || (is_plain(step, keeps_settings) && !has_label)) return &step;
  const bool vanishes = (!block.settings.empty() || has_label) && block.comments.empty();
  if (!keeps_settings && block.words.empty() && vanishes) return nullptr;
  spelling_ = spelling_of(block, spelling_);
  editor_.start(block, spelling_);
  if (has_label) editor_.replace(label, "");
  write_values(step, keeps_settings);
  if (!keeps_settings) {
    for (const Setting& setting : block.settings) editor_.replace(setting.whole, "");
    defuse_comments(block);
  }
  MadeStep& own = made_.next(step);
  editor_.apply(own.text);
  if (!is_blank(block.text.front())) own.text.erase(0, own.text.find_first_not_of(" \t"));
  own.step = step;
  if (!keeps_settings) own.step.passed = nullptr;
  if (turns_tool(step)) {
    own.step.end_words = EndWords::angles_of_vector;
  } else if (step.cycle == CycleForm::none) {
    own.step.end_words = EndWords::axes;
  }
  made_.parse(own, step);
  // As many decimals as the control needs are written where the block changes, not as many as the value has.
  auto word = own.block.words.begin();
  bool end_seen = false;
  for (const Word& before : block.words) {
    const bool code = !code_without_vectors(step, before).empty();
    const bool end = is_end_in_other_words(step, before);
    if (end && end_seen) continue;
    end_seen = end_seen || end;
    for (int i = !end ? 1 : turns_tool(step) ? 3 : 2; i > 0; --i, ++word) {
      PLUMBLINE_CHECK(word != own.block.words.end());
      if (!end && !code) word->value = before.value;  // where the text does not say it: increments, X=IC(5)
      if (before.expression != kLiteral || end) word->decimals = 0;
    }
  }
  return &own.step;
}

// A feed that is worked out has as many decimals as the control keeps of F; a small one is left with all, and read
// back.
int StepExpander::decimals_of_value(const Step& step, const Word& word) const {
  const int most = dialect_.behaviour.feed_decimals;
  for (const Word& code : step.block->words) {  // the F of G131 is no feed
    const CodeRow* const row = is_code(code) ? dialect_.row_of(code) : nullptr;
    if (row != nullptr && row->action == Action::no_motion && (row->word_mask & letter_bit('F')) != 0)
      return kMostDecimals;
  }
  const bool is_feed = word.letter == 'F' || word.letter == kFeedOutLetter;
  const double kept = std::round(word.value * std::pow(10, most)) / std::pow(10, most);
  return is_feed && std::abs(kept - word.value) < kRoundedFeed * std::abs(word.value) ? most : kMostDecimals;
}

// A word with its value in place of an expression, as the language spells it: X5, CR=5, X=IC(5).
std::string StepExpander::with_value(const Step& step, const Word& word) const {
  const std::string_view text = step.block->at(word.span);
  const Spelling spelling{spelling_.lower_case, false, spelling_.point, spelling_.most_digits};
  std::string value;
  const bool whole = dialect_.behaviour.whole_words.find(word.letter) != std::string::npos;
  const bool may_have_parts = word.letter == 'G' || word.letter == 'P';  // G54.1, and P where it counts seconds
  const bool has_parts = may_have_parts && std::abs(word.value - std::round(word.value)) > kWholeCode;
  if (whole && !has_parts) {
    append_word(value, word.letter, std::round(word.value), 0, {spelling_.lower_case, false, false, 0});
  } else {
    append_word(value, word.letter, word.value, decimals_of_value(step, word), spelling);
  }
  const std::size_t equals = text.find('=');
  if (word.letter == kNamedCode) return std::string(text);
  if (equals == std::string_view::npos) return value;
  if (word.mode != WordMode::modal) return std::string(text.substr(0, text.find('(') + 1)) + value.substr(1) + ')';
  const std::size_t name_end = text.find_last_not_of(" \t", equals - 1);
  return name_end == 0 ? value : std::string(text.substr(0, equals + 1)) + value.substr(1);
}

void StepExpander::write_values(const Step& step, bool keeps_settings, std::string_view without) {
  bool end_written = false;
  for (const Span& span : step.block->left_out) editor_.replace(span, "");
  if (step.passed != nullptr && !keeps_settings) {
    for (const PassedValue& value : *step.passed) editor_.replace(value.span, value.text);
  }
  for (const Argument& argument : step.block->arguments) {
    if (argument.plain || keeps_settings) continue;
    std::string text;
    append_decimal(text, argument.value, kMostDecimals);
    editor_.replace(argument.span, text);
  }
  for (const Word& word : step.block->words) {
    if (without.find(word.letter) != std::string_view::npos) continue;
    if (const std::string_view code = code_without_vectors(step, word); !code.empty()) {
      std::string text(1, spelling_.lower_case ? 'g' : 'G');
      editor_.replace(word.span, text += code);
    } else if (is_end_in_other_words(step, word)) {
      write_end(step, end_written, word.span);
    } else if (word.expression != kLiteral && !word.unknown) {
      editor_.replace(word.span, with_value(step, word));
    } else if (word.unknown && !keeps_settings) {
      refuse_at(*step.block, word.span, "emit-value-unknown",
                "this value is known only when the machine runs, and the program must be written without parameters",
                "write the value as a number, or the program without loops and subprograms");
    }
  }
}

// X and Y for @ and ^, A, B and C for the direction of the tool.
bool StepExpander::is_end_in_other_words(const Step& step, const Word& word) {
  const bool vector = turns_tool(step) && word.letter >= 'I' && word.letter <= 'K';
  return vector || (is_polar(word) && step.cycle == CycleForm::none);
}

// "43.4" of G43.5, which takes A, B and C; empty for other words.
std::string_view StepExpander::code_without_vectors(const Step& step, const Word& word) const {
  const CodeRow* const row = turns_tool(step) && is_code(word) ? dialect_.row_of(word) : nullptr;
  return row != nullptr ? std::string_view(row->written_as) : std::string_view{};
}

void StepExpander::write_end(const Step& step, bool& written, Span span) {
  std::string text;
  if (!written) {
    const Motion& motion = step.motions.front();
    const auto add = [&](Axis axis, double value, int decimals) {
      if (spelling_.spaced && !text.empty()) text += ' ';
      append_word(text, letter(axis), value, decimals,
                  {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    };
    if (turns_tool(step)) {
      for (const Axis axis : {Axis::A, Axis::B, Axis::C}) add(axis, angle_.kept(motion.to[axis]), angle_.digits);
    } else {
      for (const Axis axis : {Axis::X, Axis::Y}) {
        const double value = motion.to[axis] - (step.after->incremental ? motion.from[axis] : 0);
        add(axis, value / step.after->unit_of(axis), kMostDecimals);
      }
    }
  }
  editor_.replace(span, text);
  written = true;
}

void StepExpander::defuse_comments(const Block& block) {
  for (const Comment& comment : block.comments) {
    const std::string_view text = block.at(comment.span);
    if (!shows_parameters(text)) continue;
    if (!silenced_) silenced_ = place_in(block, comment.span);
    editor_.replace({comment.span.begin, comment.span.begin + 1}, std::string(text.substr(0, 1)) + "was ");
  }
}

// On a line that steers, a control with O words acts on no comment [LinuxCNC, measured].
bool StepExpander::is_defused_beside_flow(std::string_view comment) const {
  return dialect_.syntax.statements == Statements::o_words ? active_comment(comment) != nullptr
                                                           : shows_parameters(comment);
}

const Step* StepExpander::beside_flow(const Step& step, bool acts) {
  const Block& block = *step.block;
  if (!acts && block.comments.empty()) return nullptr;
  made_.clear();
  MadeStep& own = made_.next(step);
  if (acts) {
    write_without_call(step, own.text);
    if (!is_blank(block.text.front())) own.text.erase(0, own.text.find_first_not_of(" \t"));
  } else {
    for (const Comment& comment : block.comments) {
      const std::string_view text = block.at(comment.span);
      own.text += own.text.empty() ? "" : " ";
      own.text += text.substr(0, 1);
      own.text += is_defused_beside_flow(text) ? "was " : "";
      own.text += text.substr(1);
    }
  }
  own.step = step;
  own.step.passed = nullptr;
  own.step.flow.reset();
  own.step.saves_modes = false;
  if (acts) own.step.end_words = turns_tool(step) ? EndWords::angles_of_vector : EndWords::axes;
  if (!acts) own.step.motions = {};
  made_.parse(own, step);
  return &own.step;
}

bool StepExpander::acts_beside_flow(const Step& step) const {
  if (!step.flow) return false;
  if (!step.motions.empty()) return true;
  const std::vector<Word>& words = step.block->words;
  const auto calls_macro = [&](const Word& word) {
    const CodeRow* const row = is_code(word) ? dialect_.row_of(word) : nullptr;
    return row != nullptr && row->action == Action::call_macro;
  };
  if (std::any_of(words.begin(), words.end(), calls_macro)) return false;
  const std::string of_flow = words_of_flow(*step.block);
  return std::any_of(words.begin(), words.end(),
                     [&](const Word& word) { return !steers(word) && of_flow.find(word.letter) == std::string::npos; });
}

// M98, M99; M30 where it ends a subprogram.
bool StepExpander::steers(const Word& word) const {
  const CodeRow* const row = dialect_.row_of(word);
  return row != nullptr &&
         (row->action == Action::call_program || row->action == Action::end_program || row->action == Action::end);
}

// P and L of M98.
std::string StepExpander::words_of_flow(const Block& block) const {
  std::string letters;
  for (const Word& word : block.words) {
    if (steers(word)) letters += dialect_.row_of(word)->words;
  }
  return letters;
}

void StepExpander::write_without_call(const Step& step, std::string& text) {
  const Block& block = *step.block;
  const std::string of_flow = words_of_flow(block);
  spelling_ = spelling_of(block, spelling_);
  editor_.start(block, spelling_);
  write_values(step, false, of_flow);
  defuse_comments(block);
  for (const Word& word : block.words) {
    if (steers(word) || of_flow.find(word.letter) != std::string::npos) editor_.replace(word.span, "");
  }
  editor_.apply(text);
}

}  // namespace plumbline::nc
