// Tokens of RS274/NGC and its relatives, compiled by re2c into src/nc. block.ebnf says how they make a block.
// Blanks mean nothing outside comments [RS274/NGC 3.3.1], so each rule lets them stand between its characters.
#include <charconv>

#include "base/text/characters.hpp"
#include "nc/language/block.hpp"
#include "nc/syntax/reading/lexer.hpp"

namespace plumbline::nc {
namespace {

constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                   1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kLargestExact = std::uint64_t{1} << 53U;
constexpr int kMostDigits = 18;

void keep(Token& token, TokenKind kind, const char* begin, const char* end) {
  token.kind = kind;
  token.begin = begin;
  token.end = end;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// Long numbers, blanks taken out.
double read_long_number(const char* begin, const char* end) {
  char digits[512];
  char* to = digits;
  for (; begin != end && to != digits + sizeof digits; ++begin) {
    if (!is_blank(*begin) && *begin != '+') *to++ = *begin;
  }
  double value = 0;
  std::from_chars(digits, to, value, std::chars_format::fixed);
  return value;
}

// Digits and their power of ten are both exact in a double up to 2^53 and 10^22, so that one division rounds the number
// as std::from_chars does.
void read_number(Token& token, const char* begin, const char* end) {
  const char* c = begin;
  while (is_blank(*c)) ++c;
  const bool negative = *c == '-';
  if (negative || *c == '+') ++c;
  std::uint64_t digits = 0;
  int count = 0;
  const auto take_digits = [&] {
    for (; c != end; ++c) {
      const unsigned digit = static_cast<unsigned char>(*c) - unsigned{'0'};
      if (digit <= 9) {
        digits = digits * 10 + digit;
        ++count;
      } else if (!is_blank(*c)) {
        return;
      }
    }
  };
  take_digits();
  const int before_point = count;
  token.point = c != end;
  if (token.point) {
    ++c;
    take_digits();
  }
  const int decimals = count - before_point;
  token.decimals = static_cast<std::uint8_t>(decimals);
  if (count > kMostDigits || digits > kLargestExact) {
    token.value = read_long_number(begin, end);
    return;
  }
  const double size = static_cast<double>(digits) / kPowersOfTen[decimals];
  token.value = negative ? -size : size;
}

void keep_word(Token& token, const char* begin, const char* end) {
  keep(token, TokenKind::word, begin, end);
  token.letter = upper(*begin);
  read_number(token, begin + 1, end);
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

// A word without blanks in it, as nearly all are; false, and nothing is kept, where the automaton must look.
bool keep_plain_word(Token& token, const char* begin) {
  if (!is_letter(*begin)) return false;
  const char* c = begin + 1;
  const bool negative = *c == '-';
  if (negative || *c == '+') ++c;
  std::uint64_t digits = 0;
  const auto take_digits = [&] {
    const char* const first = c;
    for (unsigned digit = 0; (digit = static_cast<unsigned char>(*c) - unsigned{'0'}) <= 9; ++c) {
      digits = digits * 10 + digit;
    }
    return c - first;
  };
  const auto before_point = take_digits();
  const bool point = *c == '.';
  if (point) ++c;
  const auto decimals = point ? take_digits() : 0;
  const auto count = before_point + decimals;
  if (count == 0 || count > kMostDigits || digits > kLargestExact) return false;
  const char* next = c;
  while (is_blank(*next)) ++next;
  if (*next == '.' || (*next >= '0' && *next <= '9')) return false;
  keep(token, TokenKind::word, begin, c);
  token.letter = upper(*begin);
  token.point = point;
  token.decimals = static_cast<std::uint8_t>(decimals);
  const double size = static_cast<double>(digits) / kPowersOfTen[decimals];
  token.value = negative ? -size : size;
  return true;
}

void keep_letter(Token& token, const char* begin, const char* end) {
  keep(token, TokenKind::letter, begin, end);
  token.letter = upper(*begin);
}

void keep_operation(Token& token, TokenKind kind, Operation operation, const char* begin, const char* end) {
  keep(token, kind, begin, end);
  token.operation = static_cast<std::uint8_t>(operation);
}

}  // namespace

/*!re2c
  re2c:define:YYCTYPE = "unsigned char";
  re2c:define:YYCURSOR = at;
  re2c:define:YYMARKER = marker;
  re2c:yyfill:enable = 0;

  blank    = [ \t\r];
  w        = blank*;
  digit    = [0-9];
  letter   = [A-Za-z@^$];  // @ and ^ are polar words, $ chooses a spindle
  unsigned = digit (w digit)* (w "." (w digit)*)? | "." (w digit)+;
  number   = [+-]? w unsigned;
*/

void lex_item(const char* cursor, Token& token) {
  while (*cursor == ' ') ++cursor;
  if (keep_plain_word(token, cursor)) return;
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* marker = nullptr;
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
again:
  begin = at;
  /*!re2c
    blank+                { goto again; }
    letter w number       { return keep_word(token, text(begin), text(at)); }
    letter                { return keep_letter(token, text(begin), text(at)); }
    "(" [^()\n\x00]* ")"  { return keep(token, TokenKind::comment, text(begin), text(at)); }
    "(" [^()\n\x00]* "("  { return keep(token, TokenKind::nested_comment, text(at) - 1, text(at)); }
    "("                   { return keep(token, TokenKind::open_comment, text(begin), text(at)); }
    ";" [^\n\x00]*        { return keep(token, TokenKind::comment, text(begin), text(at)); }
    "#"                   { return keep(token, TokenKind::hash, text(begin), text(at)); }
    "/"                   { return keep(token, TokenKind::slash, text(begin), text(at)); }
    "%"                   { return keep(token, TokenKind::percent, text(begin), text(at)); }
    "="                   { return keep(token, TokenKind::equals, text(begin), text(at)); }
    [\n\x00]              { return keep(token, TokenKind::end, text(begin), text(begin)); }
    *                     { return keep(token, TokenKind::bad, text(begin), text(at)); }
  */
}

void lex_value(const char* cursor, Token& token) {
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* marker = nullptr;
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
  const auto function = [&](Operation which) {
    keep_operation(token, TokenKind::function, which, text(begin), text(at));
  };
again:
  begin = at;
  /*!re2c
    blank+       { goto again; }
    number       { keep(token, TokenKind::number, text(begin), text(at));
                   return read_number(token, text(begin), text(at)); }
    [+-]         { keep(token, TokenKind::sign, text(begin), text(at));
                   token.letter = *text(begin);
                   return; }
    "["          { return keep(token, TokenKind::open, text(begin), text(at)); }
    "#"          { return keep(token, TokenKind::hash, text(begin), text(at)); }
    "<" [^<>\n\x00]* ">"  { return keep(token, TokenKind::name, text(begin), text(at)); }
    'a' w 'b' w 's'          { return function(Operation::absolute); }
    'a' w 'c' w 'o' w 's'    { return function(Operation::arc_cosine); }
    'a' w 's' w 'i' w 'n'    { return function(Operation::arc_sine); }
    'a' w 't' w 'a' w 'n'    { return function(Operation::arc_tangent); }
    'c' w 'o' w 's'          { return function(Operation::cosine); }
    'e' w 'x' w 'p'          { return function(Operation::exponential); }
    'f' w 'i' w 'x'          { return function(Operation::round_down); }
    'f' w 'u' w 'p'          { return function(Operation::round_up); }
    'l' w 'n'                { return function(Operation::logarithm); }
    'r' w 'o' w 'u' w 'n' w 'd'  { return function(Operation::round); }
    's' w 'i' w 'n'          { return function(Operation::sine); }
    's' w 'q' w 'r' w 't'    { return function(Operation::square_root); }
    't' w 'a' w 'n'          { return function(Operation::tangent); }
    'e' w 'x' w 'i' w 's' w 't' w 's'  { return keep(token, TokenKind::exists, text(begin), text(at)); }
    [\n\x00]     { return keep(token, TokenKind::end, text(begin), text(begin)); }
    *            { return keep(token, TokenKind::bad, text(begin), text(at)); }
  */
}

void lex_operation(const char* cursor, Token& token) {
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* marker = nullptr;
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
  const auto operation = [&](Operation which) {
    keep_operation(token, TokenKind::operation, which, text(begin), text(at));
  };
again:
  begin = at;
  /*!re2c
    blank+         { goto again; }
    "]"            { return keep(token, TokenKind::close, text(begin), text(at)); }
    "*" w "*"      { return operation(Operation::power); }
    "*"            { return operation(Operation::times); }
    "/"            { return operation(Operation::divide); }
    'm' w 'o' w 'd'  { return operation(Operation::modulo); }
    "+"            { return operation(Operation::plus); }
    "-"            { return operation(Operation::minus); }
    'e' w 'q'      { return operation(Operation::equal); }
    'n' w 'e'      { return operation(Operation::not_equal); }
    'g' w 't'      { return operation(Operation::greater); }
    'g' w 'e'      { return operation(Operation::greater_equal); }
    'l' w 't'      { return operation(Operation::less); }
    'l' w 'e'      { return operation(Operation::less_equal); }
    'a' w 'n' w 'd'  { return operation(Operation::logical_and); }
    'o' w 'r'      { return operation(Operation::logical_or); }
    'x' w 'o' w 'r'  { return operation(Operation::exclusive_or); }
    [\n\x00]       { return keep(token, TokenKind::end, text(begin), text(begin)); }
    *              { return keep(token, TokenKind::bad, text(begin), text(at)); }
  */
}

void lex_flow(const char* cursor, Token& token) {
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* marker = nullptr;
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
  const auto flow = [&](FlowWord word) {
    keep(token, TokenKind::flow, text(begin), text(at));
    token.operation = static_cast<std::uint8_t>(word);
  };
again:
  begin = at;
  /*!re2c
    blank+  { goto again; }
    's' w 'u' w 'b'                                      { return flow(FlowWord::sub); }
    'e' w 'n' w 'd' w 's' w 'u' w 'b'                    { return flow(FlowWord::end_sub); }
    'c' w 'a' w 'l' w 'l'                                { return flow(FlowWord::call); }
    'r' w 'e' w 't' w 'u' w 'r' w 'n'                    { return flow(FlowWord::give_back); }
    'd' w 'o'                                            { return flow(FlowWord::begin_do); }
    'w' w 'h' w 'i' w 'l' w 'e'                          { return flow(FlowWord::begin_while); }
    'e' w 'n' w 'd' w 'w' w 'h' w 'i' w 'l' w 'e'        { return flow(FlowWord::end_while); }
    'r' w 'e' w 'p' w 'e' w 'a' w 't'                    { return flow(FlowWord::repeat); }
    'e' w 'n' w 'd' w 'r' w 'e' w 'p' w 'e' w 'a' w 't'  { return flow(FlowWord::end_repeat); }
    'b' w 'r' w 'e' w 'a' w 'k'                          { return flow(FlowWord::leave); }
    'c' w 'o' w 'n' w 't' w 'i' w 'n' w 'u' w 'e'        { return flow(FlowWord::go_on); }
    'i' w 'f'                                            { return flow(FlowWord::begin_if); }
    'e' w 'l' w 's' w 'e' w 'i' w 'f'                    { return flow(FlowWord::else_if); }
    'e' w 'l' w 's' w 'e'                                { return flow(FlowWord::otherwise); }
    'e' w 'n' w 'd' w 'i' w 'f'                          { return flow(FlowWord::end_if); }
    "["     { return keep(token, TokenKind::open, text(begin), text(at)); }
    *       { return keep(token, TokenKind::end, text(begin), text(begin)); }
  */
}

void lex_statement(const char* cursor, Token& token) {
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* marker = nullptr;
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
  const auto flow = [&](FlowWord word) {
    keep(token, TokenKind::flow, text(begin), text(at));
    token.operation = static_cast<std::uint8_t>(word);
  };
again:
  begin = at;
  /*!re2c
    blank+  { goto again; }
    'i' w 'f'                          { return flow(FlowWord::begin_if); }
    't' w 'h' w 'e' w 'n'              { return flow(FlowWord::if_then); }
    'w' w 'h' w 'i' w 'l' w 'e'        { return flow(FlowWord::begin_while); }
    'd' w 'o'                          { return flow(FlowWord::begin_do); }
    'e' w 'n' w 'd'                    { return flow(FlowWord::end_while); }
    'g' w 'o' w 't' w 'o'              { return flow(FlowWord::go_to); }
    *       { return keep(token, TokenKind::end, text(begin), text(begin)); }
  */
}

void lex_named_item(const char* cursor, Token& token) {
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* marker = nullptr;
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
again:
  begin = at;
  /*!re2c
    plain      = [A-Za-z];
    solid      = digit+ ("." digit*)? | "." digit+;  // a blank ends a number [6FC5398-2EP40-0BA0 p. 52]
    identifier = [A-Za-z_] [A-Za-z_] [A-Za-z0-9_]*;
    string     = "\"" [^"\n\x00]* "\"" | "'" [^'\n\x00]* "'";

    blank+                { goto again; }
    plain w [+-]? w solid { return keep_word(token, text(begin), text(at)); }
    identifier            { return keep(token, TokenKind::identifier, text(begin), text(at)); }
    plain                 { return keep_letter(token, text(begin), text(at)); }
    string                { return keep(token, TokenKind::string, text(begin), text(at)); }
    ";" [^\n\x00]*        { return keep(token, TokenKind::comment, text(begin), text(at)); }
    "("                   { return keep(token, TokenKind::parenthesis, text(begin), text(at)); }
    ")"                   { return keep(token, TokenKind::closing_parenthesis, text(begin), text(at)); }
    "["                   { return keep(token, TokenKind::open, text(begin), text(at)); }
    "]"                   { return keep(token, TokenKind::close, text(begin), text(at)); }
    "="                   { return keep(token, TokenKind::equals, text(begin), text(at)); }
    ","                   { return keep(token, TokenKind::comma, text(begin), text(at)); }
    ":"                   { return keep(token, TokenKind::colon, text(begin), text(at)); }
    "/"                   { return keep(token, TokenKind::slash, text(begin), text(at)); }
    "%"                   { return keep(token, TokenKind::percent, text(begin), text(at)); }
    [\n\x00]              { return keep(token, TokenKind::end, text(begin), text(begin)); }
    *                     { return keep(token, TokenKind::bad, text(begin), text(at)); }
  */
}

void lex_named_value(const char* cursor, Token& token) {
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* marker = nullptr;
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
again:
  begin = at;
  /*!re2c
    blank+       { goto again; }
    solid        { keep(token, TokenKind::number, text(begin), text(at));
                   return read_number(token, text(begin), text(at)); }
    [+-]         { keep(token, TokenKind::sign, text(begin), text(at));
                   token.letter = *text(begin);
                   return; }
    "["          { return keep(token, TokenKind::open, text(begin), text(at)); }
    "("          { return keep(token, TokenKind::parenthesis, text(begin), text(at)); }
    [A-Za-z_] [A-Za-z0-9_]*  { return keep(token, TokenKind::identifier, text(begin), text(at)); }
    string       { return keep(token, TokenKind::string, text(begin), text(at)); }
    [\n\x00]     { return keep(token, TokenKind::end, text(begin), text(begin)); }
    *            { return keep(token, TokenKind::bad, text(begin), text(at)); }
  */
}

void lex_named_operation(const char* cursor, Token& token) {
  const auto* at = reinterpret_cast<const unsigned char*>(cursor);
  const unsigned char* begin = nullptr;
  const auto text = [](const unsigned char* c) { return reinterpret_cast<const char*>(c); };
  const auto operation = [&](Operation which) {
    keep_operation(token, TokenKind::operation, which, text(begin), text(at));
  };
again:
  begin = at;
  /*!re2c
    blank+      { goto again; }
    "]"         { return keep(token, TokenKind::close, text(begin), text(at)); }
    ")"         { return keep(token, TokenKind::closing_parenthesis, text(begin), text(at)); }
    ","         { return keep(token, TokenKind::comma, text(begin), text(at)); }
    "*"         { return operation(Operation::times); }
    "/"         { return operation(Operation::divide); }
    "+"         { return operation(Operation::plus); }
    "-"         { return operation(Operation::minus); }
    "=="        { return operation(Operation::equal); }
    "<>"        { return operation(Operation::not_equal); }
    ">"         { return operation(Operation::greater); }
    ">="        { return operation(Operation::greater_equal); }
    "<"         { return operation(Operation::less); }
    "<="        { return operation(Operation::less_equal); }
    [A-Za-z_] [A-Za-z0-9_]*  { return keep(token, TokenKind::identifier, text(begin), text(at)); }
    *           { return keep(token, TokenKind::end, text(begin), text(begin)); }
  */
}

}  // namespace plumbline::nc
