#include "nc/syntax/named/named_words.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/axes.hpp"
#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/tool_table.hpp"
#include "nc/syntax/named/named_values.hpp"

namespace plumbline::nc {
namespace {

constexpr std::pair<std::string_view, WordMode> kModes[] = {{"AC", WordMode::absolute},
                                                            {"IC", WordMode::incremental},
                                                            {"DC", WordMode::shortest},
                                                            {"ACP", WordMode::positive},
                                                            {"ACN", WordMode::negative}};

// mode = ( "AC" | "IC" | "DC" | "ACP" | "ACN" ) , "("; modal: none stands here, and nothing is read.
WordMode word_mode(BlockReading& in) {
  if (!in.syntax->word_modes) return WordMode::modal;
  const Token next = in.cursor.peek(lex_named_value);
  if (next.kind != TokenKind::identifier) return WordMode::modal;
  const std::string name = upper({next.begin, next.end});
  const auto* const found =
      std::find_if(std::begin(kModes), std::end(kModes), [&](const auto& entry) { return entry.first == name; });
  if (found == std::end(kModes)) return WordMode::modal;
  in.cursor.accept(next);
  in.cursor.take(lex_named_value);
  if (in.cursor.is(TokenKind::parenthesis)) return found->second;
  in.cursor.refuse(in.cursor.span(), codes::kFunction, fmt::format("{} needs a value in brackets", name),
                   "write it as in X=IC(5)");
}

// token() is a text: R6='HFF' and T='H02' are numbers in other digits.
void refuse_other_digits(const BlockReading& in) {
  if (in.syntax->word_modes && *in.cursor.token().begin == '\'') in.cursor.refuse_token("a value");
}

// T="12" is a number, T="MILL10" a name of the tool table.
void tool_by_name(BlockReading& in, Span span) {
  in.cursor.take(lex_named_item);
  refuse_other_digits(in);
  const Token& text = in.cursor.token();
  const std::string_view name(text.begin + 1, static_cast<std::size_t>(text.end - text.begin) - 2);
  span.end = in.cursor.span().end;
  in.out.see('T', span);
  Word word{.letter = 'T', .span = span};
  if (is_tool_number(name)) {
    word.value = parse_number(name).value_or(0);
  } else {
    word.use = WordUse::tool_name;
  }
  in.out.add(word);
}

// A plain number, as in X=10, needs no code.
void make_literal(BlockReading& in, Word& word) {
  const std::vector<Instruction>& code = in.out.block().code;
  if (code.size() != word.expression + 2 || code[word.expression].operation != Operation::number) return;
  const std::string_view text = in.out.at(code[word.expression].span);
  if (text.find_first_of("Ee") != std::string_view::npos) return;  // 8.2EX-3 is written as its value
  word.value = code[word.expression].number;
  const std::size_t point = text.find('.');
  word.point = point != std::string_view::npos;
  if (word.point) word.decimals = static_cast<std::uint8_t>(text.size() - point - 1);
  in.out.take_back_code(word.expression);
  word.expression = kLiteral;
}

// What belongs to a code and is not looked into: [..], (..) and = with its value.
void pass_arguments(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  for (const char open : {'[', '('}) {
    if (!item_follows(in, open == '[' ? TokenKind::open : TokenKind::parenthesis)) continue;
    cursor.take(lex_named_item);
    const Span begin = cursor.span();
    bool in_text = false;
    for (int depth = 1; depth > 0; cursor.pass_byte()) {
      if (cursor.at_end()) {
        cursor.refuse(begin, codes::kBracketOpen, fmt::format("the bracket {} is not closed", open),
                      "add the one that closes it");
      }
      const char c = cursor.next_byte();
      if (c == '"') in_text = !in_text;
      if (in_text) continue;
      if (c == open) ++depth;
      if (c == (open == '[' ? ']' : ')')) --depth;
    }
  }
  if (!item_follows(in, TokenKind::equals)) return;
  cursor.take(lex_named_item);
  const bool by_mode = word_mode(in) != WordMode::modal;  // SPOS=DC(90)
  read_named_value(in);
  if (by_mode) expect_after_value(in, TokenKind::closing_parenthesis, ")");
}

// argument = [ value | text ]
Argument value_argument(BlockReading& in) {
  Argument argument;
  const std::uint32_t begin = in.cursor.here();
  const Token next = in.cursor.peek(lex_named_operation);
  if (next.kind != TokenKind::comma && next.kind != TokenKind::closing_parenthesis) {
    if (item_follows(in, TokenKind::string)) {
      in.cursor.take(lex_named_item);
    } else {
      argument.expression = read_named_value(in);
      const Instruction* const code = &in.out.block().code[argument.expression];
      const bool negative = code[1].operation == Operation::negate;
      argument.plain = code->operation == Operation::number && code[negative ? 2 : 1].operation == Operation::end;
    }
  }
  argument.span = {begin, in.cursor.here()};
  return argument;
}

// arguments = "(" , argument , { "," , argument } , ")"
void value_arguments(BlockReading& in, Span name) {
  if (!item_follows(in, TokenKind::parenthesis)) return;
  in.cursor.take(lex_named_item);
  if (!in.out.block().arguments.empty()) {
    in.cursor.refuse(name, codes::kFlowControl, "two codes with values in brackets stand in one block",
                     "put them into blocks of their own");
  }
  do {
    in.out.add_argument(value_argument(in));
    in.cursor.take(lex_named_operation);
  } while (in.cursor.is(TokenKind::comma));
  if (!in.cursor.is(TokenKind::closing_parenthesis)) {
    in.cursor.refuse(name, codes::kBracketOpen, "the bracket ( is not closed", "add the missing )");
  }
}

// CALLOSUB PX=5: no blank is needed on some controls, and what is set then is none of the name.
void refuse_glued_keyword(const BlockReading& in, Span name) {
  if (!in.dialect->syntax.settings_alone) return;
  const std::string text = upper(in.out.at(name));
  for (const std::string_view keyword : {"CALL", "GOTO", "MODIN"}) {
    if (!text.starts_with(keyword)) continue;
    in.cursor.refuse(name, codes::kAssignment, fmt::format("{} begins with {}", in.out.at(name), keyword),
                     "put a blank behind it, or choose another name for the variable");
  }
}

// COPY Q3 X10: a name of such a control that is not set is a word of its own.
void refuse_unknown_word(const BlockReading& in, Span name) {
  if (!in.dialect->syntax.settings_alone || item_follows(in, TokenKind::equals)) return;
  const std::string_view text = in.out.at(name);
  in.cursor.refuse(name, codes::kUnknownCode, fmt::format("{} is no word of this control that is known here", text),
                   "look for a slip; if it moves nothing and no move depends on it, leave it out");
}

// T1="MILL10": the tool of a spindle or a holder by its number.
void refuse_tool_of_holder(const BlockReading& in, Span name) {
  const std::string_view text = in.out.at(name);
  const bool of_holder = in.syntax->declared && upper(text.front()) == 'T' && text.size() > 1 &&
                         std::all_of(text.begin() + 1, text.end(), is_digit);
  if (!of_holder) return;
  const Token& tool = in.cursor.token();
  in.cursor.refuse(name, codes::kNotInterpreted,
                   fmt::format("{}= speaks to a spindle or a tool holder of its own, which is not interpreted", text),
                   fmt::format("write T={}: there is one spindle", std::string_view(tool.begin, tool.end)));
}

// Z=VPSLZ, and nothing worked out of it; false: another value stands here, and nothing is read.
bool end_of_travel(BlockReading& in, char letter, Span span) {
  const std::optional<Axis> axis = axis_of(letter);
  if (in.syntax->travel_ends.empty() || !axis || is_rotary(*axis)) return false;
  const Token next = in.cursor.peek(lex_named_value);
  if (next.kind != TokenKind::identifier || upper({next.begin, next.end}) != in.syntax->travel_ends + letter)
    return false;
  const Span name = in.cursor.span_of(next);
  in.cursor.accept(next);
  in.cursor.look(lex_named_operation);
  if (operator_at(in)) refuse_reserved(in, name);
  span.end = name.end;
  in.out.see(letter, span);
  in.out.add({.letter = letter, .span = span, .use = WordUse::travel_end});
  return true;
}

}  // namespace

void read_assigned_word(BlockReading& in, char letter, Span span, WordUse use) {
  if (letter == 'T' && item_follows(in, TokenKind::string)) return tool_by_name(in, span);
  if (end_of_travel(in, letter, span)) return;
  in.out.see(letter, span);
  Word word{.letter = letter, .expression = in.out.next_code(), .mode = word_mode(in), .use = use};
  read_named_value(in);
  if (word.mode == WordMode::modal) {
    make_literal(in, word);
  } else {
    expect_after_value(in, TokenKind::closing_parenthesis, ")");
  }
  word.span = {span.begin, in.cursor.here()};
  in.out.add(word);
}

void read_address(BlockReading& in, const NameMeaning& meaning, Span span) {
  expect_equals(in, span);
  const char letter = static_cast<char>(meaning.which);
  const WordUse use = meaning.tool_vector ? WordUse::tool_vector
                      : axis_of(letter)   ? WordUse::machine_axis
                                          : WordUse::of_letter;
  read_assigned_word(in, letter, span, use);
}

// Up to four characters [G 3.6]: two longer ones may be one variable to the control.
void refuse_long_name(const BlockReading& in, Span name) {
  constexpr std::uint32_t kMost = 4;
  if (in.syntax->statements != Statements::user_task || name.end - name.begin <= kMost) return;
  in.cursor.refuse(
      name, codes::kNotInterpreted,
      fmt::format("{} has more than four characters, and what the control makes of a longer name was found "
                  "in no source",
                  in.out.at(name)),
      "give the variable a name of up to four characters");
}

void read_assigned_variable(BlockReading& in, Span name, const NameMeaning* meaning) {
  Setting setting;
  setting.span = name;
  const std::string_view text = in.out.at(name);
  if (meaning != nullptr && meaning->kind == NameMeaning::Kind::function) {
    if (!item_follows(in, TokenKind::equals) && meaning->arguments > 0) {
      in.cursor.refuse(name, codes::kFunction, fmt::format("{} is a function, and stands here outside a value", text),
                       in.syntax->open == '[' ? fmt::format("write its values in brackets behind it, as in X={}[VC1{}]",
                                                            text, meaning->arguments > 1 ? ",2" : "")
                                              : fmt::format("write it as part of a value, as in X={}(R1)", text));
    }
    in.cursor.refuse(name, codes::kAssignment, fmt::format("{} is no variable", text), "choose another name");
  }
  if (is_numbered_variable(in, text)) {
    setting.target = in.out.next_code();
    add_numbered_variable(in, name);
    in.out.end_code();
  } else {
    if (is_reserved(in, text)) refuse_reserved(in, name);
    refuse_glued_keyword(in, name);
    if (item_follows(in, TokenKind::open)) {
      in.cursor.refuse(name, codes::kNotInterpreted, fmt::format("{} is a field, which is not interpreted", text),
                       "write a variable for each of its elements");
    }
    setting.name = in.out.add_name(name);
  }
  setting.span.end = in.cursor.here();
  if (setting.target == kLiteral) refuse_unknown_word(in, name);
  expect_equals(in, setting.span);
  if (setting.target == kLiteral) refuse_long_name(in, name);
  if (item_follows(in, TokenKind::string)) {
    in.cursor.take(lex_named_item);
    refuse_other_digits(in);
    refuse_tool_of_holder(in, name);
    in.cursor.refuse(setting.span, codes::kNotInterpreted, "texts are not interpreted",
                     "a program that shows messages this way needs them written as comments");
  }
  setting.value = read_named_value(in);
  setting.whole = {setting.span.begin, in.cursor.here()};
  in.out.add_setting(setting);
}

VariableType variable_type(const BlockReading& in, std::string_view what) {
  const std::string type = upper({in.cursor.token().begin, in.cursor.token().end});
  if (type == "REAL") return VariableType::real;
  if (type == "INT") return VariableType::whole;
  if (type == "BOOL") return VariableType::truth;
  in.cursor.refuse(in.cursor.span(), codes::kNotInterpreted,
                   fmt::format("{} of type {} are not interpreted", what, type), "REAL, INT and BOOL are");
}

void check_name_is_free(const BlockReading& in, Span name) {
  if (in.syntax->statements != Statements::high_level || in.dialect->meaning(in.out.at(name)) == nullptr) return;
  in.cursor.refuse(
      name, codes::kAssignment,
      fmt::format("{} is a word of the control, and none of them may be the name of a variable", in.out.at(name)),
      fmt::format("call the variable otherwise, as in DEF REAL U_{}", upper(in.out.at(name))));
}

void read_named_code(BlockReading& in, Span span, int row) {
  const CodeRow& code = in.dialect->named_codes[static_cast<std::size_t>(row)];
  const bool refused = code.action == Action::refused;
  if (refused) in.cursor.go_to(in.out.block().text.size());  // whatever else stands there
  if (code.has_values) value_arguments(in, span);
  if (code.has_arguments) pass_arguments(in);
  if (!refused) span.end = in.cursor.here();
  in.out.add({kNamedCode, static_cast<double>(row), kLiteral, span, 0, false, false, false, WordMode::modal});
}

}  // namespace plumbline::nc
