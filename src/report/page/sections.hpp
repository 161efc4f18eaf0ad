// The sections that pages are made of, as the JSON that their modules draw (src/report/page/README.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/page/page.hpp"

namespace plumbline::report {

/// With a capital and a full stop.
std::string sentence(std::string text);

/// A figure that is read first.
struct Fact {
  std::string name;
  Json value;  // a number, or text; a number that is not finite is shown as "none"
  std::string unit = {};
  int digits = 3;  // after the point
  std::string note = {};
};
Json facts_section(std::string title, const std::vector<Fact>& facts);

struct TableColumn {
  std::string name;
  std::string unit = {};
  int digits = 3;
};
/// `rows` of numbers and text, one of each column.
Json table_section(std::string title, const std::vector<TableColumn>& columns, std::vector<Json> rows,
                   std::string note = {});

Json text_section(std::string title, std::vector<std::string> paragraphs);
Json warnings_section(std::string title, std::vector<std::string> items);
/// The same section, left out where the page is printed; the sheet names it.
Json screen_only(Json section);

/// A program as a control reads it.
Json listing_section(std::string title, std::string text, std::string words = {});

}  // namespace plumbline::report
