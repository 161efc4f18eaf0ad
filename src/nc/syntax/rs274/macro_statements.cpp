#include "nc/syntax/rs274/macro_statements.hpp"

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/syntax/rs274/rs274_values.hpp"

namespace plumbline::nc {
namespace {

// Bytes that the name of a program takes from `begin` on: <PART-1>, where O1234 may stand, or :1234, as ISO tapes have
// it. 0: none.
std::size_t size_of_program_name(std::string_view text, std::size_t begin) {
  if (text[begin] == '<') {
    const std::size_t close = text.find('>', begin);
    return close == std::string_view::npos ? 0 : close + 1 - begin;
  }
  std::size_t end = begin + 1;
  while (end < text.size() && is_digit(text[end])) ++end;
  return text[begin] == ':' && end > begin + 1 ? end - begin : 0;
}

bool read_name_of_program(BlockReading& in) {
  const std::uint32_t begin = in.cursor.span().begin;
  const std::size_t size = size_of_program_name(in.out.block().text, begin);
  if (size == 0) return false;
  const auto end = begin + static_cast<std::uint32_t>(size);
  in.out.begin_flow(FlowWord::program, {begin, end});
  in.cursor.go_to(end);
  end_of_statement(in);
  return true;
}

struct Unread {
  std::string_view command, does, way_out;
};

constexpr std::string_view kSendsOut = "sends values out of the control, which is not interpreted";
constexpr std::string_view kSendElsewhere = "leave it out, or send the values from a program that does not move";
constexpr std::string_view kOfOthers = "is no statement of a macro that is read here";
constexpr Unread kUnread[] = {
    {"POPEN", kSendsOut, kSendElsewhere},
    {"PCLOS", kSendsOut, kSendElsewhere},
    {"DPRNT", kSendsOut, kSendElsewhere},
    {"BPRNT", kSendsOut, kSendElsewhere},
    {"SETVN", "names variables of the control, which is not interpreted",
     "leave it out, and write the variables as #500"},
    {"ELSE", kOfOthers, "write IF [..] GOTO, or IF [..] THEN with one assignment"},
    {"ENDIF", kOfOthers, "write IF [..] GOTO, or IF [..] THEN with one assignment"},
    {"CALL", kOfOthers, "call a subprogram with M98 P, a macro with G65 P"},
};

// What the program sends to somebody else, and statements of other controls.
void refuse_unread(const BlockReading& in) {
  const std::uint32_t begin = in.cursor.span().begin;
  const std::string_view rest = in.out.block().text.substr(begin);
  for (const Unread& unread : kUnread) {
    const std::size_t size = unread.command.size();
    if (upper(rest.substr(0, size)) != unread.command) continue;
    in.cursor.refuse({begin, begin + static_cast<std::uint32_t>(size)}, codes::kNotInterpreted,
                     fmt::format("{} {}", unread.command, unread.does), std::string(unread.way_out));
  }
}

// WH[#1 LT 5]DO1 and GO 10: which statements a control knows by two letters was found in no source.
void refuse_shortened(const BlockReading& in) {
  const std::uint32_t begin = in.cursor.span().begin;
  const std::string rest = upper(in.out.block().text.substr(begin, 5));
  for (const std::string_view statement : {"WHILE", "GOTO"}) {
    if (!rest.starts_with(statement.substr(0, 2)) || rest.starts_with(statement)) continue;
    in.cursor.refuse({begin, begin + 2}, codes::kNotInterpreted,
                     fmt::format("{} may be short for {}, which is read in full alone", rest.substr(0, 2), statement),
                     fmt::format("write {}", statement));
  }
}

bool keyword_follows(BlockReading& in, FlowWord wanted) {
  const Token keyword = in.cursor.peek(lex_statement);
  if (keyword.kind != TokenKind::flow || static_cast<FlowWord>(keyword.operation) != wanted) return false;
  in.cursor.accept(keyword);
  return true;
}

void condition(BlockReading& in) {
  in.cursor.take(lex_value);
  if (!in.cursor.is(TokenKind::open)) {
    in.cursor.refuse(in.out.flow().span, codes::kFlowControl, "a condition in brackets is missing after this",
                     "write it as in IF [#1 GT 5] GOTO 100");
  }
  in.out.flow().values.push_back(read_condition(in));
}

MacroLine statement(BlockReading& in, FlowWord word) {
  Flow& flow = in.out.flow();
  if (word == FlowWord::begin_if) {
    condition(in);
    if (keyword_follows(in, FlowWord::if_then)) {
      flow.word = FlowWord::if_then;
      if (keyword_follows(in, FlowWord::go_to)) {
        in.cursor.refuse(flow.span, codes::kFlowControl, "THEN stands before an assignment alone, and GOTO stands here",
                         "leave THEN out, as in IF [#1 GT 5] GOTO 100");
      }
      in.cursor.take(lex_item);
      return MacroLine::assignments;
    }
    if (!keyword_follows(in, FlowWord::go_to)) {
      in.cursor.refuse(flow.span, codes::kFlowControl, "GOTO or THEN is missing after this condition",
                       "write it as in IF [#1 GT 5] GOTO 100");
    }
    flow.word = FlowWord::go_to;
  } else if (word == FlowWord::begin_while) {
    condition(in);
    if (!keyword_follows(in, FlowWord::begin_do)) {
      in.cursor.refuse(flow.span, codes::kFlowControl, "DO is missing after this condition",
                       "write it as in WHILE [#1 LT 5] DO 1");
    }
  }
  flow.label = read_value(in);
  flow.span.end = in.cursor.here();
  end_of_statement(in);
  return MacroLine::whole;
}

}  // namespace

// statement = "IF" , expression , ( "GOTO" , value | "THEN" , { setting } ) | "WHILE" , expression , "DO" , value
//           | "DO" , value | "END" , value | "GOTO" , value
MacroLine read_macro_statement(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  if (!cursor.is(TokenKind::end) && read_name_of_program(in)) return MacroLine::whole;
  if (!cursor.is(TokenKind::letter) || cursor.token().letter == 'O') return MacroLine::words;
  refuse_unread(in);
  refuse_shortened(in);
  Token keyword;
  lex_statement(cursor.token().begin, keyword);
  if (keyword.kind != TokenKind::flow) return MacroLine::words;
  const auto word = static_cast<FlowWord>(keyword.operation);
  in.out.begin_flow(word, cursor.span_of(keyword));
  if (word == FlowWord::if_then) cursor.refuse_token("a word");
  cursor.go_after(keyword);
  return statement(in, word);
}

// A block is a macro statement or a block of words [cncforum.net, macro and NC statements].
void check_assignment_alone(const BlockReading& in, bool then) {
  const std::vector<Word>& words = in.out.block().words;
  const std::vector<Setting>& settings = in.out.block().settings;
  if (then && !words.empty()) {
    in.cursor.refuse(words.front().span, codes::kFlowControl, "THEN takes nothing but an assignment",
                     "write IF [..] GOTO, and the words into blocks of their own");
  }
  if (then && settings.empty()) {
    in.cursor.refuse(in.out.flow().span, codes::kFlowControl, "an assignment is missing after THEN",
                     "write it into this block, as in IF [#1 GT 5] THEN #2=1, or jump with IF [..] GOTO");
  }
  if (!settings.empty() && !words.empty()) {
    in.cursor.refuse(words.front().span, codes::kFlowControl,
                     "an assignment and words in one block: which the control does first was found in no source",
                     "put them into blocks of their own");
  }
  if (settings.size() < 2) return;
  in.cursor.refuse(settings[1].span, codes::kFlowControl,
                   "two assignments in one block: whether the control makes both was found in no source",
                   "put them into blocks of their own");
}

}  // namespace plumbline::nc
