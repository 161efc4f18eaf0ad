#include "nc/language/recognise.hpp"

#include <algorithm>
#include <bitset>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kLook = std::size_t{1} << 16U;

bool begins_name(char c) { return is_letter(c) || c == '_'; }

// A mark at one place of a line: a blank stands for any blanks or none, * for a number, ~ for the end of a word, $ for
// the end of the line, ! before a letter for anything but that letter.
bool matches_at(std::string_view mark, std::string_view line, std::size_t at) {
  for (std::size_t i = 0; i < mark.size(); ++i) {
    const char wanted = mark[i];
    if (wanted == '!') {
      if (at < line.size() && line[at] == mark[++i]) return false;
    } else if (wanted == ' ') {
      while (at < line.size() && is_blank(line[at])) ++at;
    } else if (wanted == '*') {
      if (at >= line.size() || !is_digit(line[at])) return false;
      while (at < line.size() && is_digit(line[at])) ++at;
    } else if (wanted == '~') {
      const bool number = at > 0 && is_digit(line[at - 1]);
      if (at < line.size() && (is_digit(line[at]) || line[at] == '.')) return false;
      if (!number && at < line.size() && begins_name(line[at])) return false;
    } else if (wanted == '$') {
      while (at < line.size() && is_blank(line[at])) ++at;
      if (at < line.size()) return false;
    } else if (at >= line.size() || line[at++] != wanted) {
      return false;
    }
  }
  return true;
}

// A line as marks are looked for in it.
struct PlainLine {
  std::string text;
  std::bitset<256> holds;  // characters
  bool first;              // that says anything

  PlainLine(std::string plain, bool first_of_all) : text(std::move(plain)), first(first_of_all) {
    for (const char c : text) holds.set(static_cast<unsigned char>(c));
  }
};

// Anywhere in the line, but not inside a name. No mark begins with what stands for something else.
bool holds(std::string_view mark, const PlainLine& line) {
  if (mark.starts_with('^')) return line.first && matches_at(mark.substr(1), line.text, 0);
  const char begin = mark.front();
  if (!line.holds.test(static_cast<unsigned char>(begin))) return false;
  const std::string& text = line.text;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const bool inside = begins_name(begin) && at > 0 && (begins_name(text[at - 1]) || text[at - 1] == '$');
    if (!inside && matches_at(mark, text, at)) return true;
  }
  return false;
}

// What a < after this begins is a name of the program's own: #<x>, o<x>.
bool names_after(std::string_view out) {
  if (out.ends_with('#')) return true;
  return out.ends_with('O') && (out.size() < 2 || !begins_name(out[out.size() - 2]));
}

// Upper case, without what may say anything: comments in ( ) and after ;, names in < >, texts in " ". A bracket
// after a name is no comment.
std::string plain(std::string_view line) {
  std::string out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ';' && !line.substr(i).starts_with(";$PATH")) break;
    const bool after_name = !out.empty() && begins_name(out.back());
    if (line[i] == '(' && !after_name) {
      i = std::min(line.find(')', i), line.size());
      continue;
    }
    const char end = line[i] == '"' ? '"' : line[i] == '<' && names_after(out) ? '>' : '\0';
    out += upper(line[i]);
    if (end != '\0') i = std::min(line.find(end, i + 1), line.size());
  }
  while (!out.empty() && is_blank(out.back())) out.pop_back();
  out.erase(0, std::min(out.find_first_not_of(" \t\r"), out.size()));
  return out;
}

struct Evidence {
  std::string_view dialect;
  std::string text;
  std::size_t line;
  std::string whole;  // that line as it stands
};

class Look {
 public:
  explicit Look(const InputFile& file) : file_(file) {}

  Recognised decide() {
    name();
    text();
    if (found_.empty()) found_ = by_name_;
    if (found_.empty()) found_ = weak_;
    if (found_.empty()) return {&dialect(dialect_names().front()), {}, 0};
    if (found_.size() == 1) return {&dialect(found_.front().dialect), found_.front().text, found_.front().line};
    std::string list;
    for (const Evidence& e : found_) {
      list += fmt::format("{}{} speaks for {}", list.empty() ? "" : ", ", e.text, e.dialect);
    }
    Place place;
    place.file = file_.name();
    place.line = found_.back().line;
    place.column = 1;
    place.length = std::max<std::size_t>(found_.back().text.size(), 1);
    place.text = found_.back().whole;
    refuse(codes::kDialectAmbiguous, fmt::format("which control this program is for is not clear: {}", list),
           "name it: --dialect " + dialect_list(), std::move(place));
  }

 private:
  static void note(std::vector<Evidence>& evidence, std::string_view dialect, std::string text, std::size_t line,
                   std::string_view whole) {
    for (const Evidence& e : evidence) {
      if (e.dialect == dialect) return;
    }
    evidence.push_back({dialect, std::move(text), line, std::string(whole)});
  }

  void name() {
    std::string upper_name;
    for (const char c : file_.name()) upper_name += upper(c);
    for (const std::string_view dialect_name : dialect_names()) {
      const DialectMarks& known = marks_of_dialect(dialect_name);
      for (const std::string& ending : known.file_endings) {
        if (upper_name.ends_with(ending))
          note(found_, dialect_name, fmt::format("the file's ending {}", ending), 0, {});
      }
      for (const std::string& ending : known.weak_file_endings) {
        if (upper_name.ends_with(ending))
          note(by_name_, dialect_name, fmt::format("the file's ending {}", ending), 0, {});
      }
    }
  }

  void text() {
    std::string begin(kLook, '\0');
    begin.resize(file_.read(0, begin.data(), begin.size()));
    const std::string_view all = begin;
    bool first = true;
    std::size_t number = 1;
    for (std::size_t at = 0; at < all.size(); ++number) {
      const std::size_t end = std::min(all.find('\n', at), all.size());
      const std::string_view whole = all.substr(at, end - at);
      at = end + 1;
      const PlainLine line(plain(whole), first);
      if (line.text.empty() || line.text == "%") continue;
      for (const std::string_view name : dialect_names()) marks(name, line, whole, number);
      first = false;
    }
  }

  void marks(std::string_view name, const PlainLine& line, std::string_view whole, std::size_t number) {
    const DialectMarks& known = marks_of_dialect(name);
    const auto held = [&](const std::string& mark) { return holds(mark, line); };
    const auto shown = [&] { return fmt::format("line {} ({})", number, line.text.substr(0, 40)); };
    if (std::any_of(known.marks.begin(), known.marks.end(), held)) note(found_, name, shown(), number, whole);
    if (std::any_of(known.weak_marks.begin(), known.weak_marks.end(), held)) note(weak_, name, shown(), number, whole);
  }

  const InputFile& file_;
  std::vector<Evidence> found_, by_name_, weak_;
};

}  // namespace

Recognised recognise(const InputFile& file) { return Look(file).decide(); }

}  // namespace plumbline::nc
