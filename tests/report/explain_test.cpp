// Every code that the sources can emit has a page in docs/diagnostics, and every page a code.
#include "report/explain.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "nc/language/codes.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

bool is_code(std::string_view text) {
  const bool plain = std::all_of(text.begin(), text.end(),
                                 [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
  return plain && text.find('-') != std::string_view::npos && text.front() != '-' && text.back() != '-';
}

std::string family(std::string_view code) { return std::string(code.substr(0, code.find('-'))); }

std::set<std::string> families() {
  std::set<std::string> families;
  for (const report::CodePage& page : report::code_pages()) families.insert(family(page.code));
  return families;
}

struct Literal {
  std::string text;
  bool refuses = false;  // the first one behind a call of refuse...()
};

// The texts in quotes of a source file, comments and all.
std::vector<Literal> literals_of(const std::string& source) {
  std::vector<Literal> literals;
  bool refuses = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source.compare(i, 6, "refuse") == 0) refuses = true;
    if (source[i] == ';') refuses = false;
    if (source[i] != '"' || (i > 0 && source[i - 1] == '\'')) continue;
    std::string text;
    for (++i; i < source.size() && source[i] != '"' && source[i] != '\n'; ++i) {
      if (source[i] == '\\') ++i;
      text += source[i];
    }
    literals.push_back({text, refuses});
    refuses = false;
  }
  return literals;
}

// Codes that the sources hold, and the file of each: what a refuse...() names, and whatever else looks like a code of a
// family that there is (option and effect names are of none).
std::map<std::string, std::string> codes_in_sources() {
  const std::set<std::string> known = families();
  std::map<std::string, std::string> codes;
  for (const auto& entry : fs::recursive_directory_iterator(testing::source_file("src"))) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".cpp" && extension != ".hpp") continue;
    for (const Literal& literal : literals_of(read_text(entry.path().string()))) {
      if (!is_code(literal.text)) continue;
      if (literal.refuses || known.contains(family(literal.text))) codes.emplace(literal.text, entry.path().string());
    }
  }
  return codes;
}

}  // namespace

TEST_CASE("every code has a page") {
  const auto codes = codes_in_sources();
  CHECK(codes.size() > 140);
  CHECK(codes.contains("nc-unknown-code"));
  CHECK(codes.contains("file-missing"));
  for (const auto& [code, file] : codes) {
    INFO(file << " names the code " << code << ": say what it means in docs/diagnostics/" << family(code)
              << ".md, in a section \"## " << code << "\": what is wrong and why, an indented example, the way out");
    CHECK(report::find_code_page(code) != nullptr);
  }
  for (const std::string_view code : nc::codes::kAll) CHECK(report::find_code_page(code) != nullptr);
}

TEST_CASE("every page has a code, an example and a way out, and stands once") {
  const auto codes = codes_in_sources();
  std::set<std::string_view> seen;
  for (const report::CodePage& page : report::code_pages()) {
    INFO("docs/diagnostics, section " << page.code);
    CHECK(codes.contains(std::string(page.code)));
    CHECK(seen.insert(page.code).second);
    const std::size_t example = page.text.find("\n\n    ");
    CHECK(example != std::string_view::npos);
    if (example == std::string_view::npos) continue;
    CHECK(page.text.find("\n\n", example + 2) != std::string_view::npos);
  }
}

TEST_CASE("a page is found by its code, with brackets or without") {
  const std::string text = report::explain_text("nc-word-twice");
  CHECK(text.starts_with("nc-word-twice\n\nA letter stands twice"));
  CHECK(text.find("    G0 X1 X2\n") != std::string::npos);
  CHECK(text.find("##") == std::string::npos);
  CHECK(report::explain_text("[nc-word-twice]") == text);
  CHECK(report::explain_text("nc-tool-unknown").find("(see docs/using.md)") != std::string::npos);
}

TEST_CASE("an unknown code is told the nearest one") {
  const Diagnostic near = testing::refusal_of([] { report::explain_text("nc-word-twise"); });
  CHECK(near.code == "explain-unknown-code");
  CHECK(near.help == "did you mean nc-word-twice?");
  CHECK(testing::refusal_of([] { report::explain_text("xyz"); }).help == "plumbline explain lists all of them");
}

TEST_CASE("the list holds every code and a sentence") {
  const std::string list = report::explain_list();
  CHECK(std::count(list.begin(), list.end(), '\n') == static_cast<std::ptrdiff_t>(report::code_pages().size()));
  CHECK(list.find("A letter stands twice in one block, and only one of the two can count\n") != std::string::npos);
}
