#include "report/page/sections.hpp"

#include <cctype>
#include <utility>

namespace plumbline::report {
namespace {

Json section(std::string_view type, std::string title) { return Json{{"type", type}, {"title", std::move(title)}}; }

}  // namespace

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

Json facts_section(std::string title, const std::vector<Fact>& facts) {
  Json made = section("facts", std::move(title));
  Json& rows = made["rows"] = Json::array();
  for (const Fact& fact : facts) {
    rows.push_back({{"name", fact.name},
                    {"value", fact.value},
                    {"unit", fact.unit},
                    {"digits", fact.digits},
                    {"note", fact.note}});
  }
  return made;
}

Json table_section(std::string title, const std::vector<TableColumn>& columns, std::vector<Json> rows,
                   std::string note) {
  Json made = section("table", std::move(title));
  Json& heads = made["columns"] = Json::array();
  for (const TableColumn& column : columns) {
    heads.push_back({{"name", column.name}, {"unit", column.unit}, {"digits", column.digits}});
  }
  made["rows"] = std::move(rows);
  made["note"] = std::move(note);
  return made;
}

Json text_section(std::string title, std::vector<std::string> paragraphs) {
  Json made = section("text", std::move(title));
  made["paragraphs"] = std::move(paragraphs);
  return made;
}

Json warnings_section(std::string title, std::vector<std::string> items) {
  Json made = section("warnings", std::move(title));
  made["items"] = std::move(items);
  return made;
}

Json screen_only(Json section) {
  if (section.is_object()) section["screen_only"] = true;
  return section;
}

Json listing_section(std::string title, std::string text, std::string words) {
  Json made = section("listing", std::move(title));
  made["text"] = std::move(text);
  made["words"] = std::move(words);
  return made;
}

}  // namespace plumbline::report
