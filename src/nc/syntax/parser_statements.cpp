// The productions of lines that steer a program in languages with names: IF, GOTO, CALL, FOR and their like.

#include <fmt/format.h>

#include "base/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {

void Parser::statement(FlowWord word) {
  Flow& flow = block_->flow;
  flow = Flow{};
  flow.word = word;
  flow.span = span_of(token_);
  if (!block_->words.empty()) {
    refuse_at(*block_, flow.span, codes::kFlowControl,
              fmt::format("{} stands behind other words", block_->at(flow.span)), "put it into a block of its own");
  }
  switch (word) {
    case FlowWord::begin_if:
      return named_jump(true);
    case FlowWord::go_to:
      return named_jump(false);
    case FlowWord::begin_while:
    case FlowWord::until:
      flow.values.push_back(named_value_code());
      break;
    case FlowWord::begin_for:
      for_statement();
      break;
    case FlowWord::choose:
      case_statement();
      break;
    case FlowWord::begin_repeat:
    case FlowWord::repeat_line:
      repeat_statement(word == FlowWord::repeat_line);
      break;
    case FlowWord::external_call:
      external_call();
      break;
    case FlowWord::define:
      return define_statement();
    case FlowWord::sub:
      return subprogram_head();
    case FlowWord::call:
      return call_statement();
    default:
      break;
  }
  end_of_statement();
}

namespace {

// GOTOF, GOTOB; a label behind the condition itself may stand anywhere
Direction direction_of(std::string_view keyword) {
  if (keyword.empty()) return Direction::both;
  const char last = upper(keyword.back());
  return last == 'F' ? Direction::forward : last == 'B' ? Direction::backward : Direction::both;
}

}  // namespace

// jump = [ "IF" , value ] , ( "GOTO" , label | label | ) ; without either it begins a branch
void Parser::named_jump(bool conditional) {
  Flow& flow = block_->flow;
  Span keyword = conditional ? Span{} : flow.span;
  if (conditional) {
    flow.values.push_back(named_value_code());
    Token next;
    look(lex_named_item, next);
    const bool is_name = next.kind == TokenKind::identifier;
    const std::string_view name(next.begin, static_cast<std::size_t>(next.end - next.begin));
    const NameMeaning* const meaning = is_name ? dialect_->meaning(name) : nullptr;
    const bool jumps = meaning != nullptr && meaning->kind == NameMeaning::Kind::keyword &&
                       static_cast<FlowWord>(meaning->which) == FlowWord::go_to;
    if (jumps) {
      keyword = span_of(next);
      at_ = next.end;
    } else if (syntax_->statements == Statements::high_level) {
      return end_of_statement();
    }
  }
  flow.word = FlowWord::go_to;
  flow.direction = direction_of(block_->at(keyword));
  jump_label();
  end_of_statement();
}

void Parser::jump_label() {
  take(lex_named_item);
  const bool user_task = syntax_->statements == Statements::user_task;
  const bool is_number = token_.kind == TokenKind::word && token_.letter == 'N';
  const bool is_name = token_.kind == TokenKind::identifier && (!user_task || (*token_.begin & ~0x20) == 'N');
  if (!is_number && !is_name) {
    refuse_at(
        *block_, block_->flow.span, codes::kFlowControl, "the label to go on at is missing behind this",
        user_task ? "write it as in IF [VC1 GT 5] N100, or GOTO NEND" : "write it as in GOTOF ENDE, or GOTOB N100");
  }
  block_->flow.name = span_of(token_);
}

// call = "CALL" , program name , [ "Q" , number ] , { variable , "=" , value }
void Parser::call_statement() {
  Flow& flow = block_->flow;
  take(lex_named_item);
  const bool named = token_.kind == TokenKind::identifier || token_.kind == TokenKind::word;
  if (!named || (*token_.begin & ~0x20) != 'O') {
    refuse_at(*block_, flow.span, codes::kFlowControl, "the name of a program is missing behind this",
              "write it as in CALL O1000 Q3 PX=10");
  }
  flow.name = span_of(token_);
  take(lex_named_item);
  for (; token_.kind != TokenKind::end; take(lex_named_item)) {
    if (token_.kind == TokenKind::parenthesis) {
      pass_comment();
    } else if (token_.kind == TokenKind::word && token_.letter == 'Q') {
      flow.count = static_cast<std::uint32_t>(block_->code.size());
      push(Operation::number, span_of(token_), token_.value);
      push(Operation::end, {});
    } else if (token_.kind == TokenKind::letter && token_.letter == 'Q' && next_is(TokenKind::equals)) {
      take(lex_named_item);
      flow.count = named_value_code();
    } else if (token_.kind == TokenKind::identifier) {
      assigned_variable(span_of(token_), nullptr);
    } else {
      refuse_token("an argument");
    }
  }
}

// call = name , [ "(" , [ value , { "," , value } ] , ")" ] , [ "P" , number ]
void Parser::call_by_name(Span name) {
  Flow& flow = block_->flow;
  const CodeRow* const before = block_->words.empty() ? nullptr : dialect_->row_of(block_->words.back());
  if (before != nullptr && before->action == Action::modal_call) {
    refuse_at(*block_, name, codes::kNotInterpreted,
              fmt::format("{} of a program of one's own is not interpreted", before->name),
              "call the program by its name in each of the blocks behind the moves");
  }
  if (!block_->words.empty() || !block_->settings.empty()) {
    refuse_at(*block_, name, codes::kUnknownCode, fmt::format("{} is no word of this control", block_->at(name)),
              "look for a slip; the name of a subprogram stands alone in its block");
  }
  flow = Flow{};
  flow.word = FlowWord::call;
  flow.span = flow.name = name;
  if (next_is(TokenKind::parenthesis)) {
    take(lex_named_item);
    if (next_is(TokenKind::closing_parenthesis)) {
      take(lex_named_item);
    } else {
      do {
        flow.values.push_back(named_value_code());
        take(lex_named_operation);
      } while (token_.kind == TokenKind::comma);
      if (token_.kind != TokenKind::closing_parenthesis) {
        refuse_at(*block_, name, codes::kBracketOpen, "the bracket ( is not closed", "add the missing )");
      }
    }
  }
  Token next;
  look(lex_named_item, next);
  if (next.kind == TokenKind::word && next.letter == 'P') {
    at_ = next.end;
    flow.count = static_cast<std::uint32_t>(block_->code.size());
    push(Operation::number, span_of(next), next.value);
    push(Operation::end, {});
  }
  end_of_statement();
}

// for = "FOR" , variable , "=" , value , "TO" , value
void Parser::for_statement() {
  take(lex_named_item);
  const bool is_variable =
      token_.kind == TokenKind::identifier || token_.kind == TokenKind::word || token_.kind == TokenKind::letter;
  if (!is_variable) refuse_token("a variable");
  const Span name = span_of(token_);
  assigned_variable(name, dialect_->meaning(block_->at(name)));
  take(lex_named_item);
  const std::string word = upper({token_.begin, token_.end});
  if (word != "TO") {
    refuse_at(*block_, block_->flow.span, codes::kFlowControl, "TO is missing in this loop",
              "write it as in FOR R1=1 TO 10");
  }
  block_->flow.values.push_back(named_value_code());
}

namespace {

VariableType type_named(const std::string& name) {
  return name == "INT" ? VariableType::whole : name == "BOOL" ? VariableType::truth : VariableType::real;
}

}  // namespace

// definition = "DEF" , type , variable , [ "=" , value ] , { "," , variable , [ "=" , value ] }
void Parser::define_statement() {
  take(lex_named_item);
  const std::string type = upper({token_.begin, token_.end});
  if (type != "REAL" && type != "INT" && type != "BOOL") {
    refuse_at(*block_, span_of(token_), codes::kNotInterpreted,
              fmt::format("variables of type {} are not interpreted", type), "REAL, INT and BOOL are");
  }
  const VariableType kept = type_named(type);
  do {
    take(lex_named_item);
    if (token_.kind != TokenKind::identifier) refuse_token("a name");
    const Span name = span_of(token_);
    if (next_is(TokenKind::equals)) {
      assigned_variable(name, nullptr);
    } else {
      if (next_is(TokenKind::open)) {
        refuse_at(*block_, name, codes::kNotInterpreted, "fields are not interpreted",
                  "write a variable for each of its elements");
      }
      Setting setting;
      setting.span = setting.whole = name;
      setting.name = static_cast<std::uint32_t>(block_->names.size());
      block_->names.push_back(name);
      setting.value = static_cast<std::uint32_t>(block_->code.size());
      push(Operation::number, name, 0);
      push(Operation::end, {});
      block_->settings.push_back(setting);
    }
    block_->settings.back().type = kept;
    take(lex_named_operation);
  } while (token_.kind == TokenKind::comma);
  at_ = token_.begin;
  end_of_statement();
}

// head = "PROC" , name , [ "(" , [ type , name , { "," , type , name } ] , ")" ] , { attribute }
void Parser::subprogram_head() {
  Flow& flow = block_->flow;
  take(lex_named_item);
  if (token_.kind != TokenKind::identifier && token_.kind != TokenKind::word) refuse_token("a name");
  flow.name = span_of(token_);
  if (next_is(TokenKind::parenthesis)) {
    take(lex_named_item);
    take(lex_named_item);
    while (token_.kind == TokenKind::identifier) {
      const std::string type = upper({token_.begin, token_.end});
      if (type != "REAL" && type != "INT" && type != "BOOL") {
        refuse_at(*block_, span_of(token_), codes::kNotInterpreted,
                  fmt::format("parameters of type {} are not interpreted", type), "REAL, INT and BOOL are");
      }
      take(lex_named_item);
      if (token_.kind != TokenKind::identifier) refuse_token("a name");
      Setting setting;
      setting.type = type_named(type);
      setting.span = setting.whole = span_of(token_);
      setting.name = static_cast<std::uint32_t>(block_->names.size());
      block_->names.push_back(setting.span);
      setting.value = static_cast<std::uint32_t>(block_->code.size());
      push(Operation::number, setting.span, 0);
      push(Operation::end, {});
      block_->settings.push_back(setting);
      take(lex_named_item);
      if (token_.kind == TokenKind::comma) take(lex_named_item);
    }
    if (token_.kind != TokenKind::closing_parenthesis) refuse_token(")");
  }
  while (next_is(TokenKind::identifier)) {
    take(lex_named_item);
    if (upper({token_.begin, token_.end}) != "SAVE") continue;  // DISPLOF, SBLOF: for the operator
    refuse_at(*block_, span_of(token_), codes::kNotInterpreted,
              "SAVE brings the modes of the caller back at the end of the subprogram, which is not interpreted",
              "leave it out, and write the codes that the caller needs behind the call");
  }
  end_of_statement();
}

}  // namespace plumbline::nc
