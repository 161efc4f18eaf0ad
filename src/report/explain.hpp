// What the codes of diagnostics mean: the pages of docs/diagnostics, compiled into the program.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumbline::report {

/// One section of docs/diagnostics/*.md.
struct CodePage {
  std::string_view code;
  std::string_view text;  // markdown: what it means, an example, the way out
};

/// All pages, by code.
std::span<const CodePage> code_pages();

/// Null: there is no such code.
const CodePage* find_code_page(std::string_view code);

/// The page of a code for the terminal; brackets around the code are passed over. Refuses with explain-unknown-code.
std::string explain_text(std::string_view code);

/// Every code and the first sentence of its page, a line each.
std::string explain_list();

}  // namespace plumbline::report
