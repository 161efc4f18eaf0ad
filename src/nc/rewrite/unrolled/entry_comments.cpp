#include "nc/rewrite/unrolled/entry_comments.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/files/path_of.hpp"
#include "base/text/hash.hpp"
#include "nc/language/comment_line.hpp"

namespace plumbline::nc {
namespace {

std::string as_comment(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    const bool may_stand = c >= 0x20 && c < 0x7F && c != '(' && c != ')' && c != ';' && c != '%';
    plain += may_stand ? c : '_';
  }
  return plain;
}

std::string subprogram_name(std::string_view name, Statements statements) {
  if (statements == Statements::user_task) return as_comment(name);
  const bool number = name.find_first_not_of("0123456789") == std::string_view::npos;
  return number ? fmt::format("o{}", name) : fmt::format("o<{}>", as_comment(name));
}

}  // namespace

// An entry met again before any block was written takes the place of the one before, and of all that is inside it.
void EntryComments::note(const FlowEntry& entry) {
  const auto again = std::find_if(entries_.begin(), entries_.end(), [&](const Pending& p) {
    return p.kind == entry.kind && p.line == entry.line && p.name == entry.name;
  });
  entries_.erase(again, entries_.end());
  entries_.push_back({entry.kind, std::string(entry.name), entry.line, text_of(entry)});
}

std::string EntryComments::text_of(const FlowEntry& entry) {
  if (entry.kind == FlowEntry::Kind::pass) return fmt::format("pass {} of the loop in line {}", entry.pass, entry.line);
  std::string text =
      fmt::format("{} called in line {}", subprogram_name(entry.name, dialect_.syntax.statements), entry.line);
  if (entry.pass > 1) text += fmt::format(", pass {}", entry.pass);
  const bool known =
      std::any_of(inlined_.begin(), inlined_.end(), [&](const InlinedFile& file) { return file.name == entry.file; });
  if (entry.file.empty() || known) return text;
  const InputFile file{std::string(entry.file)};
  inlined_.push_back({file.name(), hash_of(file)});
  const std::string plain_name = path_of(file.name()).filename().generic_string();
  return fmt::format("{}, from {}, hash {}", text, as_comment(plain_name), to_hex(inlined_.back().hash));
}

void EntryComments::write(OutputText& out) {
  for (const Pending& entry : entries_) out.write_own_line(comment_line(entry.text, dialect_));
  entries_.clear();
}

}  // namespace plumbline::nc
