#include "nc/syntax/named/named_calls.hpp"

#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/syntax/named/named_values.hpp"
#include "nc/syntax/named/named_words.hpp"

namespace plumbline::nc {
namespace {

void check_stands_alone(const BlockReading& in, Span name) {
  const Block& block = in.out.block();
  const CodeRow* const before = block.words.empty() ? nullptr : in.dialect->row_of(block.words.back());
  if (before != nullptr && before->action == Action::modal_call) {
    in.cursor.refuse(name, codes::kNotInterpreted,
                     fmt::format("{} of a program of one's own is not interpreted", before->name),
                     "call the program by its name in each of the blocks after the moves");
  }
  if (block.words.empty() && block.settings.empty()) return;
  if (block.settings.empty() && block.words.size() == 1 && block.words.front().letter == 'P') {
    in.cursor.refuse(name, codes::kFlowControl, "how often a program is called stands behind its name",
                     fmt::format("write it as in {} P2", block.at(name)));
  }
  in.cursor.refuse(name, codes::kUnknownCode, fmt::format("{} is no word of this control", block.at(name)),
                   "look for a slip; the name of a subprogram stands alone in its block");
}

// arguments = "(" , [ value ] , { "," , [ value ] } , ")"; what is left out is 0 [N p. 494]
void call_arguments(BlockReading& in, Span name) {
  if (!item_follows(in, TokenKind::parenthesis)) return;
  in.cursor.take(lex_named_item);
  if (item_follows(in, TokenKind::closing_parenthesis)) return in.cursor.take(lex_named_item);
  do {
    if (item_follows(in, TokenKind::string)) {
      in.cursor.refuse(
          name, codes::kNotInterpreted,
          fmt::format("{} is a program that is given a text, and texts are not interpreted", in.out.at(name)),
          "let the post write what it does in words of the control, as in T=\"MILL10\" and M6");
    }
    const Token next = in.cursor.peek(lex_named_operation);
    const bool left_out = next.kind == TokenKind::comma || next.kind == TokenKind::closing_parenthesis;
    in.out.flow().values.push_back(left_out ? in.out.add_number(0, name) : read_named_value(in));
    in.cursor.take(lex_named_operation);
  } while (in.cursor.is(TokenKind::comma));
  if (in.cursor.is(TokenKind::closing_parenthesis)) return;
  in.cursor.refuse(name, codes::kBracketOpen, "the bracket ( is not closed", "add the missing )");
}

[[noreturn]] void refuse_call(const BlockReading& in, std::string_view code, std::string message) {
  in.cursor.refuse(in.out.flow().span, code, std::move(message), "write it as in EXTCALL(\"POCKET\")");
}

// The name of the program in "path/NAME.SPF".
Span name_in_path(const BlockReading& in, Span text) {
  Span name{text.begin + 1, text.end - 1};
  const std::size_t folder = in.out.at(name).find_last_of("/\\:");
  if (folder != std::string_view::npos) name.begin += static_cast<std::uint32_t>(folder + 1);
  const std::string file = upper(in.out.at(name));
  if (file.ends_with(".SPF") || file.ends_with(".MPF") || file.ends_with("_SPF") || file.ends_with("_MPF"))
    name.end -= 4;
  constexpr std::string_view kDomain = "_N_";  // of names in the control's own folders
  if (file.starts_with(kDomain)) name.begin += static_cast<std::uint32_t>(kDomain.size());
  return name;
}

// parameters = "(" , [ type , name , { "," , type , name } ] , ")"
void parameters(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  cursor.take(lex_named_item);
  cursor.take(lex_named_item);
  while (cursor.is(TokenKind::identifier)) {
    const VariableType type = variable_type(in, "parameters");
    cursor.take(lex_named_item);
    if (!cursor.is(TokenKind::identifier)) cursor.refuse_token("a name, which begins with two letters");
    check_name_is_free(in, cursor.span());
    in.out.declare(cursor.span(), type);
    cursor.take(lex_named_item);
    if (cursor.is(TokenKind::equals)) {
      cursor.refuse(cursor.span(), codes::kNotInterpreted, "values that parameters have by default are not interpreted",
                    "leave it out here, and give the value in each call");
    }
    if (cursor.is(TokenKind::comma)) cursor.take(lex_named_item);
  }
  if (!cursor.is(TokenKind::closing_parenthesis)) cursor.refuse_token(")");
}

}  // namespace

void refuse_unread_keyword(const BlockReading& in, Span keyword) {
  const std::string name = upper(in.out.at(keyword));
  if (name == "CALL" || name == "PCALL" || name == "ISOCALL") {
    in.cursor.refuse(keyword, codes::kNotInterpreted,
                     fmt::format("{} calls a program in a way that is not interpreted", in.out.at(keyword)),
                     "call it by its name alone, with its values in brackets");
  }
  if (in.syntax->relations_last && name.starts_with("B_")) {
    in.cursor.refuse(keyword, codes::kNotInterpreted,
                     fmt::format("{} works bit by bit, which is not interpreted", name),
                     "write its result, or AND, OR, XOR and NOT of truths");
  }
  if (in.syntax->relations_last && (name == "DISPLOF" || name == "DISPLON" || name == "ACTBLOCNO")) {
    in.cursor.refuse(keyword, codes::kFlowControl, fmt::format("{} stands behind the PROC of its program", name),
                     "write it as in PROC NAME DISPLOF, or leave it out: it concerns the operator's screen alone");
  }
  if (name != "GOTOC" && name != "GOTOS") return;
  in.cursor.refuse(keyword, codes::kNotInterpreted,
                   name == "GOTOS" ? "GOTOS goes back to the begin of the program, which is not interpreted"
                                   : "where GOTOC goes on if its label is missing was found in no source",
                   name == "GOTOS" ? "end the program with M30" : "write GOTO, GOTOF or GOTOB");
}

void read_passes(BlockReading& in) {
  const Token next = in.cursor.peek(lex_named_item);
  if (next.letter != 'P' || (next.kind != TokenKind::word && next.kind != TokenKind::letter)) return;
  in.cursor.go_after(next);
  if (next.kind == TokenKind::word) {
    in.out.flow().count = in.out.add_number(next.value, in.cursor.span_of(next));
  } else {
    expect_equals(in, in.cursor.span_of(next));
    in.out.flow().count = read_named_value(in);
  }
}

namespace {

// called part = "CALL" , "BLOCK" , label , "TO" , label; false: it is none
bool called_part(BlockReading& in, Span call) {
  const Token block = in.cursor.peek(lex_named_item);
  if (upper(in.out.at(call)) != "CALL" || block.kind != TokenKind::identifier) return false;
  if (upper({block.begin, block.end}) != "BLOCK") return false;
  if (!in.out.block().words.empty() || !in.out.block().settings.empty()) {
    in.cursor.refuse(call, codes::kFlowControl, fmt::format("{} stands after other words", in.out.at(call)),
                     "put it into a block of its own");
  }
  Flow& flow = in.out.begin_flow(FlowWord::repeat_section, call);
  in.cursor.go_after(block);
  for (int i = 0; i < 2; ++i) {
    const bool is_name = i == 0 || read_keyword(in) == "TO";
    if (is_name) in.cursor.take(lex_named_item);
    if (!is_name || !in.cursor.is(TokenKind::identifier)) {
      in.cursor.refuse(call, codes::kFlowControl, "the names of the labels around the part that this calls are missing",
                       "write it as in CALL BLOCK BEGIN TO LAST");
    }
    flow.choices.push_back({.label = in.cursor.span(), .direction = Direction::both});
  }
  end_of_statement(in);
  return true;
}

}  // namespace

// call = name , [ arguments ] , passes | called part
void read_call_by_name(BlockReading& in, Span name) {
  if (called_part(in, name)) return;
  refuse_unread_keyword(in, name);
  check_stands_alone(in, name);
  Flow& flow = in.out.begin_flow(FlowWord::call, name);
  flow.name = name;
  call_arguments(in, name);
  read_passes(in);
  end_of_statement(in);
}

// call = "CALL" , program name , [ "Q" , number ] , { variable , "=" , value }
void read_call_statement(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  Flow& flow = in.out.flow();
  cursor.take(lex_named_item);
  const bool named = cursor.is(TokenKind::identifier) || cursor.is(TokenKind::word);
  if (!named || upper(*cursor.token().begin) != 'O') {
    cursor.refuse(flow.span, codes::kFlowControl, "the name of a program is missing after this",
                  "write it as in CALL O1000 Q3 PX=10");
  }
  flow.name = cursor.span();
  cursor.take(lex_named_item);
  for (; !cursor.is(TokenKind::end); cursor.take(lex_named_item)) {
    const bool counts = cursor.is_letter(TokenKind::word, 'Q') || cursor.is_letter(TokenKind::letter, 'Q');
    if (counts && flow.count != kLiteral) {
      cursor.refuse(cursor.span(), codes::kNotInterpreted,
                    "Q stands twice in this call, and no source says which of the two counts", "leave one of the two");
    }
    if (cursor.is(TokenKind::parenthesis)) {
      pass_comment(in);
    } else if (cursor.is_letter(TokenKind::word, 'Q')) {
      flow.count = in.out.add_number(cursor.token().value, cursor.span());
    } else if (cursor.is_letter(TokenKind::letter, 'Q') && item_follows(in, TokenKind::equals)) {
      cursor.take(lex_named_item);
      flow.count = read_named_value(in);
    } else if (cursor.is(TokenKind::identifier)) {
      read_assigned_variable(in, cursor.span(), nullptr);
    } else {
      cursor.refuse_token("an argument");
    }
  }
}

// external call = "EXTCALL" , [ "(" ] , '"' , [ path ] , name , [ ".SPF" ] , '"' , [ ")" ]
void read_external_call(BlockReading& in) {
  const bool bracket = item_follows(in, TokenKind::parenthesis);
  if (bracket) in.cursor.take(lex_named_item);
  in.cursor.take(lex_named_item);
  if (!in.cursor.is(TokenKind::string)) {
    refuse_call(in, codes::kNotInterpreted, "the name of the program that this calls is no text here");
  }
  const Span name = name_in_path(in, in.cursor.span());
  if (name.end <= name.begin) {
    refuse_call(in, codes::kFlowControl, "the name of the program that this calls is empty");
  }
  in.out.flow().word = FlowWord::call;
  in.out.flow().name = name;
  if (bracket) expect_after_value(in, TokenKind::closing_parenthesis, ")");
}

// head = "PROC" , name , [ parameters ] , { attribute }
void read_subprogram_head(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  cursor.take(lex_named_item);
  if (!cursor.is(TokenKind::identifier) && !cursor.is(TokenKind::word)) cursor.refuse_token("a name");
  in.out.flow().name = cursor.span();
  if (item_follows(in, TokenKind::parenthesis)) parameters(in);
  while (item_follows(in, TokenKind::identifier)) {
    if (read_keyword(in) != "SAVE") continue;  // DISPLOF, SBLOF: for the operator
    cursor.refuse(cursor.span(), codes::kNotInterpreted,
                  "SAVE brings the modes of the caller back at the end of the subprogram, which is not interpreted",
                  "leave it out, and write the codes that the caller needs after the call");
  }
}

}  // namespace plumbline::nc
