// What a page says, for tests of it.
#pragma once

#include <string>

#include "report/page/page.hpp"

namespace plumbline::testing {

/// The first section of that title; null: there is none.
inline report::Json section_of(const report::Page& page, const std::string& title) {
  for (const report::Json& section : page.sections) {
    if (section.at("title") == title) return section;
  }
  return nullptr;
}

/// Whether some text of the JSON holds `part`.
inline bool says(const report::Json& json, const std::string& part) {
  return json.dump(-1, ' ', false, report::Json::error_handler_t::replace).find(part) != std::string::npos;
}

/// The row of a table or of bars that begins with that name, or has it.
inline report::Json row_of(const report::Json& section, const std::string& name) {
  for (const report::Json& row : section.at("rows")) {
    if (row.is_array() ? row.at(0) == name : row.at("name") == name) return row;
  }
  return nullptr;
}

}  // namespace plumbline::testing
