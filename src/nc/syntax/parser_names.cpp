// The productions of languages in which words, values and codes may be names: X=LENGTH, TRAORI, R1=5.
#include <algorithm>

#include <fmt/format.h>

#include "base/axes.hpp"
#include "base/characters.hpp"
#include "base/number_text.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/language/tool_table.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {
// block = [ percent ] , [ "/" , [ digit ] ] , [ label ] , ( program name | items )
void Parser::named_block() {
  if (syntax_->goes_on != '\0' && block_->text.starts_with(syntax_->goes_on)) return header();
  const std::size_t next = syntax_->goes_on == '\0' ? std::string_view::npos : block_->text.find('\n');
  const std::size_t first = block_->text.find_first_not_of(" \t\r");
  if (next != std::string_view::npos && (first == next || block_->text[first] == '(')) {
    refuse_goes_on(static_cast<std::uint32_t>(next + 1));
  }
  if (syntax_->draws && draws()) return;
  take(lex_named_item);
  if (token_.kind == TokenKind::percent) {
    if (syntax_->statements != Statements::high_level || *at_ != '_') return percent();
    block_->flow = Flow{};  // %_N_NAME_MPF
    const auto end = static_cast<std::uint32_t>(block_->text.size());
    return program_name({span_of(token_).begin, end});
  }
  if (token_.kind == TokenKind::slash) {
    block_->block_delete = true;
    block_->slash = span_of(token_);
    skip_level();
    take(lex_named_item);
  }
  if (block_label()) named_items();
}

// $NAME.MIN%
void Parser::header() {
  const std::size_t last = block_->text.find_last_not_of(" \t\r");
  if (block_->text[last] == '%') {
    block_->kind = LineKind::percent;
    return;
  }
  refuse_goes_on(0);
}

void Parser::refuse_goes_on(std::uint32_t at) const {
  refuse_at(*block_, {at, at + 1}, codes::kBadCharacter,
            fmt::format("{} goes on with the block of the line before, and there is none", syntax_->goes_on),
            fmt::format("take the {} away, or end the head of the program with %", syntax_->goes_on));
}

// DEF WORK ... END: the shape that the control draws.
bool Parser::draws() {
  std::string words;
  for (const char c : block_->text.substr(0, block_->text.find('('))) {
    if (!is_blank(c)) words += upper(c);
  }
  const bool within = drawing_;
  drawing_ = within ? words != "END" : words == "DEFWORK";
  if (!within && !drawing_) return false;
  block_->kind = LineKind::ignored;
  return true;
}

// False: the line is the name of a program.
bool Parser::block_label() {
  const bool user_task = syntax_->statements == Statements::user_task;
  const auto first = [&] { return upper(*token_.begin); };
  if (token_.kind == TokenKind::word && token_.letter == 'N') {
    block_->number = span_of(token_);
    if (token_.begin[1] == '-' || token_.begin[1] == '+') {
      refuse_at(*block_, block_->number, codes::kLineNumber, "N without a line number", "write digits behind the N");
    }
    take(lex_named_item);
  } else if (user_task && token_.kind == TokenKind::identifier && first() == 'N' && !is_code_of_motion()) {
    block_->number = span_of(token_);
    take(lex_named_item);
  } else if (token_.kind == TokenKind::colon && is_digit(*at_)) {
    block_->number = span_of(token_);
    while (is_digit(*at_)) ++at_;
    block_->number.end = here();
    take(lex_named_item);
  }
  const bool is_name = token_.kind == TokenKind::identifier || token_.kind == TokenKind::word;
  if (user_task && is_name && first() == 'O') {
    block_->flow = Flow{};
    program_name(span_of(token_));
    end_of_statement();
    return false;
  }
  if (syntax_->statements == Statements::high_level && token_.kind == TokenKind::identifier &&
      next_is(TokenKind::colon)) {
    block_->names.push_back(span_of(token_));
    take(lex_named_item);
    take(lex_named_item);
  }
  return true;
}

// NCYL is a code, whatever else begins with N a label.
bool Parser::is_code_of_motion() const {
  const NameMeaning* const meaning = dialect_->meaning(block_->at(span_of(token_)));
  return meaning != nullptr && meaning->kind == NameMeaning::Kind::code &&
         dialect_->named_codes[static_cast<std::size_t>(meaning->which)].action == Action::no_hole;
}

void Parser::program_name(Span span) {
  block_->flow.word = FlowWord::program;
  block_->flow.span = block_->flow.name = span;
}

bool Parser::next_is(TokenKind kind) {
  Token next;
  look(lex_named_item, next);
  return next.kind == kind;
}

void Parser::expect(TokenKind kind, std::string_view what) {
  take(lex_named_operation);
  if (token_.kind == kind) return;
  refuse_at(*block_, span_of(token_), codes::kBracketOpen, fmt::format("{} is missing here", what), "add it");
}

// items = { word | setting | code | comment } | statement
void Parser::named_items() {
  while (true) {
    switch (token_.kind) {
      case TokenKind::word:
        named_word();
        break;
      case TokenKind::letter:
        named_letter();
        break;
      case TokenKind::identifier:
        identifier();
        break;
      case TokenKind::comment:
        comment(span_of(token_));
        break;
      case TokenKind::parenthesis:
        if (syntax_->open == '(') refuse_token("a word");
        pass_comment();
        break;
      case TokenKind::end:
        if (token_.begin < block_->text.data() + block_->text.size()) refuse_token("a word");
        return;
      default:
        refuse_token("a word");
    }
    if (block_->flow.word != FlowWord::none) return;
    take(lex_named_item);
  }
}

void Parser::pass_comment() {
  const Span open = span_of(token_);
  const std::size_t close = block_->text.find_first_of(")\n", open.begin);
  if (close == std::string_view::npos || block_->text[close] == '\n') {
    refuse_at(*block_, open, codes::kCommentOpen, "the comment ( is not closed", "add the missing )");
  }
  block_->comments.push_back({{open.begin, static_cast<std::uint32_t>(close + 1)}});
  at_ = block_->text.data() + close + 1;
}

// word = letter , number | letter , [ number ] , "=" , value
void Parser::named_word() {
  const Span span = span_of(token_);
  if (next_is(TokenKind::equals)) {
    const NameMeaning* const meaning = dialect_->meaning(block_->at(span));
    if (meaning != nullptr && meaning->kind == NameMeaning::Kind::code) return code_by_name(span, meaning->which);
    if (meaning != nullptr && meaning->kind == NameMeaning::Kind::address) return address(*meaning, span);
    return assigned_variable(span, meaning);
  }
  if (syntax_->statements == Statements::high_level && token_.letter == 'L') return call_by_name(span);
  const std::string_view letter(&token_.letter, 1);
  const NameMeaning* const variables = dialect_->meaning(letter);
  if (variables != nullptr && variables->kind == NameMeaning::Kind::variable) {
    refuse_at(*block_, span, codes::kAssignment, "a variable stands here without a word or a value",
              fmt::format("set it as in {}1=3, or write the word that its value is for", letter));
  }
  literal_word();
}

void Parser::named_letter() {
  const Span span = span_of(token_);
  const char letter = token_.letter;
  const std::string_view name(&letter, 1);
  const NameMeaning* const meaning = dialect_->meaning(name);
  if (meaning != nullptr && meaning->kind == NameMeaning::Kind::variable) return assigned_variable(span, meaning);
  if (next_is(TokenKind::equals)) {
    take(lex_named_item);
    return assigned_word(letter, span);
  }
  look(lex_named_item, token_);
  refuse_token("a value");
}

void Parser::identifier() {
  const Span span = span_of(token_);
  const std::string_view name = block_->at(span);
  const NameMeaning* const meaning = dialect_->meaning(name);
  using Kind = NameMeaning::Kind;
  if (meaning != nullptr && meaning->kind == Kind::code) return code_by_name(span, meaning->which);
  if (meaning != nullptr && meaning->kind == Kind::keyword) return statement(static_cast<FlowWord>(meaning->which));
  if (meaning != nullptr && meaning->kind == Kind::address) return address(*meaning, span);
  const bool assigns = next_is(TokenKind::equals) || next_is(TokenKind::open);
  if (!assigns && syntax_->statements == Statements::high_level) return call_by_name(span);
  assigned_variable(span, meaning);
}

// CR=5; X1=0, whose axis is the machine's.
void Parser::address(const NameMeaning& meaning, Span span) {
  expect_equals(span);
  const char letter = static_cast<char>(meaning.which);
  assigned_word(letter, span, axis_of(letter).has_value());
  block_->words.back().tool_vector = meaning.tool_vector;
}

void Parser::expect_equals(Span name) {
  take(lex_named_item);
  if (token_.kind == TokenKind::equals) return;
  refuse_at(*block_, name, codes::kAssignment, fmt::format("{} stands here without a value", block_->at(name)),
            "write = and its value behind it");
}

// Codes that are names, and what may stand behind them in brackets.
void Parser::code_by_name(Span span, int row) {
  const bool refused = dialect_->named_codes[static_cast<std::size_t>(row)].action == Action::refused;
  if (refused) at_ = block_->text.data() + block_->text.size();  // whatever else stands there
  if (dialect_->named_codes[static_cast<std::size_t>(row)].has_values) value_arguments(span);
  if (dialect_->named_codes[static_cast<std::size_t>(row)].has_arguments) pass_arguments();
  if (!refused) span.end = here();
  block_->words.push_back(
      {kNamedCode, static_cast<double>(row), kLiteral, span, 0, false, false, false, WordMode::modal});
}

void Parser::pass_arguments() {
  for (const char open : {'[', '('}) {
    if (!next_is(open == '[' ? TokenKind::open : TokenKind::parenthesis)) continue;
    take(lex_named_item);
    const Span begin = span_of(token_);
    bool in_text = false;
    int depth = 1;
    for (; depth > 0; ++at_) {
      if (at_ >= block_->text.data() + block_->text.size()) {
        refuse_at(*block_, begin, codes::kBracketOpen, fmt::format("the bracket {} is not closed", open),
                  "add the one that closes it");
      }
      if (*at_ == '"') in_text = !in_text;
      if (in_text) continue;
      if (*at_ == open) ++depth;
      if (*at_ == (open == '[' ? ']' : ')')) --depth;
    }
  }
  if (!next_is(TokenKind::equals)) return;
  take(lex_named_item);
  named_value_code();
}

bool Parser::word_mode(WordMode& mode) {
  if (syntax_->statements != Statements::high_level) return false;
  Token next;
  look(lex_named_value, next);
  if (next.kind != TokenKind::identifier) return false;
  const std::string name = upper({next.begin, next.end});
  constexpr std::pair<std::string_view, WordMode> kModes[] = {{"AC", WordMode::absolute},
                                                              {"IC", WordMode::incremental},
                                                              {"DC", WordMode::shortest},
                                                              {"ACP", WordMode::positive},
                                                              {"ACN", WordMode::negative}};
  const auto* const found =
      std::find_if(std::begin(kModes), std::end(kModes), [&](const auto& entry) { return entry.first == name; });
  if (found == std::end(kModes)) return false;
  mode = found->second;
  at_ = next.end;
  take(lex_named_value);
  if (token_.kind == TokenKind::parenthesis) return true;
  refuse_at(*block_, span_of(token_), codes::kFunction, fmt::format("{} needs a value in brackets", name),
            "write it as in X=IC(5)");
}

// Behind "=".
void Parser::assigned_word(char letter, Span span, bool machine_axis) {
  if (letter == 'T' && next_is(TokenKind::string)) return tool_by_name(span);
  see(letter, span);
  Word word;
  word.letter = letter;
  word.machine_axis = machine_axis;
  word.expression = static_cast<std::uint32_t>(block_->code.size());
  if (word_mode(word.mode)) {
    named_value();
    expect(TokenKind::closing_parenthesis, ")");
    push(Operation::end, {});
  } else {
    named_value_code();
    const std::vector<Instruction>& code = block_->code;
    if (code.size() == word.expression + 2 && code[word.expression].operation == Operation::number) {
      const std::string_view text = block_->at(code[word.expression].span);  // a plain number, as in X=10
      word.value = code[word.expression].number;
      const std::size_t point = text.find('.');
      word.point = point != std::string_view::npos;
      if (word.point) word.decimals = static_cast<std::uint8_t>(text.size() - point - 1);
      block_->code.resize(word.expression);
      word.expression = kLiteral;
    }
  }
  word.span = {span.begin, here()};
  block_->words.push_back(word);
}

// T="12" is a number, T="MILL10" a name of the tool table.
void Parser::tool_by_name(Span span) {
  take(lex_named_item);
  const std::string_view name(token_.begin + 1, static_cast<std::size_t>(token_.end - token_.begin) - 2);
  span.end = span_of(token_).end;
  see('T', span);
  Word word{.letter = 'T', .span = span};
  word.named = !is_tool_number(name);
  if (!word.named) word.value = parse_number(name).value_or(0);
  block_->words.push_back(word);
}

void Parser::refuse_reserved(Span span) const {
  refuse_at(*block_, span, codes::kNotInterpreted,
            fmt::format("{} is a variable of the control itself, which is not interpreted", block_->at(span)),
            "it reads or sets what only this machine has: tables, counters, screens; write the values themselves");
}

// setting = variable , [ "[" , value , "]" ] , "=" , value
void Parser::assigned_variable(Span name, const NameMeaning* meaning) {
  Setting setting;
  setting.span = name;
  const std::string_view text = block_->at(name);
  if (meaning != nullptr && meaning->kind == NameMeaning::Kind::function) {
    refuse_at(*block_, name, codes::kAssignment, fmt::format("{} is no variable", text), "choose another name");
  }
  if (!syntax_->reserved.empty() && !is_numbered(text) && upper(text.front()) == syntax_->reserved.front()) {
    refuse_reserved(name);
  }
  const auto begin = static_cast<std::uint32_t>(block_->code.size());
  if (variable_place(text, name)) {
    setting.target = begin;
    push(Operation::end, {});
  } else {
    if (next_is(TokenKind::open)) {
      refuse_at(*block_, name, codes::kNotInterpreted, fmt::format("{} is a field, which is not interpreted", text),
                "write a variable for each of its elements");
    }
    setting.name = static_cast<std::uint32_t>(block_->names.size());
    block_->names.push_back(name);
  }
  setting.span.end = here();
  expect_equals(setting.span);
  if (next_is(TokenKind::string)) {
    refuse_at(*block_, setting.span, codes::kNotInterpreted, "texts are not interpreted",
              "a program that shows messages this way needs them written as comments");
  }
  setting.value = named_value_code();
  setting.whole = {setting.span.begin, here()};
  block_->settings.push_back(setting);
}

// Of those variables that have numbers: R1, R[2], VC3, VC[4].
bool Parser::is_numbered(std::string_view name) const {
  std::size_t digits = name.size();
  while (digits > 0 && is_digit(name[digits - 1])) --digits;
  const NameMeaning* const meaning = dialect_->meaning(name.substr(0, digits));
  return meaning != nullptr && meaning->kind == NameMeaning::Kind::variable;
}

// Pushes the number of the parameter that a numbered variable is kept as; false: it is none.
bool Parser::variable_place(std::string_view name, Span span) {
  std::size_t digits = name.size();
  while (digits > 0 && is_digit(name[digits - 1])) --digits;
  if (!is_numbered(name)) return false;
  const NameMeaning* const meaning = dialect_->meaning(name.substr(0, digits));
  const NumberedVariables& family = syntax_->variables[static_cast<std::size_t>(meaning->which)];
  if (digits == name.size()) {
    take(lex_named_item);
    if (token_.kind != TokenKind::open) {
      refuse_at(*block_, span, codes::kAssignment, fmt::format("{} stands here without a number", name),
                fmt::format("write it as in {}{}", family.name, family.first));
    }
    named_value_until(TokenKind::close);
    push(Operation::number, span, family.at - family.first);
    push(Operation::plus, span);
    return true;
  }
  double number = 0;
  for (const char c : name.substr(digits)) number = std::min(number * 10 + (c - '0'), 1e6);
  if (number < family.first || number > family.last) {
    refuse_at(*block_, span, codes::kParameterNumber, fmt::format("there is no variable {}", name),
              fmt::format("they have the numbers {} to {}", family.first, family.last));
  }
  push(Operation::number, span, number - family.first + family.at);
  return true;
}

}  // namespace plumbline::nc
