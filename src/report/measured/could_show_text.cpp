#include "report/measured/could_show_text.hpp"

#include <string_view>

#include <fmt/format.h>

#include "report/measured/where_json.hpp"

namespace plumbline::report {

std::string could_show_text(const std::vector<diagnose::Visible>& visible, std::size_t runs, bool planned) {
  std::vector<std::string> never;
  std::vector<std::string> from;
  for (const diagnose::Visible& one : visible) {
    if (one.shows) {
      from.push_back(fmt::format("{} {:.2g}{}{}", one.name, one.smallest, one.unit.empty() ? "" : " ",
                                 one.unit));  // backlash 3 um
    } else {
      never.push_back(one.name);
    }
  }
  std::string text;
  const std::string_view these = runs == 1 ? "one run tells" : "these runs tell";
  if (!never.empty()) text += fmt::format("{} nothing of, at any size: {}\n", these, fmt::join(never, ", "));
  if (!from.empty()) {
    text += fmt::format("what {} with 95 %, from this size on: {}\n",
                        planned ? "a diagnosis of them would name" : "they would have named", fmt::join(from, ", "));
  }
  return text;
}

nlohmann::ordered_json could_show_json(const std::vector<diagnose::Visible>& visible) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const diagnose::Visible& one : visible) {
    nlohmann::ordered_json json{{"name", one.name}, {"shows", one.shows}, {"key", nullptr}, {"smallest", nullptr}};
    if (!one.key.empty()) json["key"] = one.key;
    if (one.shows) json["smallest"] = rounded(one.smallest);
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace plumbline::report
