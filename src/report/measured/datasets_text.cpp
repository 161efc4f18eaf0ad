#include "report/measured/datasets_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text/hash.hpp"

namespace plumbline::report {

std::string renamed_text(const std::vector<jobs::MeasuredFile>& measured) {
  std::string text;
  for (const jobs::MeasuredFile& file : measured) {
    if (file.renamed.empty()) continue;
    std::vector<std::string> pairs;
    for (const auto& [id, name] : file.renamed) pairs.push_back(fmt::format("{} is {}", id, name));
    text += fmt::format("note: ids of {} that an earlier dataset has: {}\n", file.path, fmt::join(pairs, ", "));
  }
  return text;
}

nlohmann::ordered_json datasets_json(const std::vector<jobs::MeasuredFile>& measured) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const jobs::MeasuredFile& file : measured) {
    json.push_back({{"file", file.path}, {"hash", to_hex(file.hash)}, {"runs", file.count}});
    json.back()["renamed"] = nlohmann::ordered_json::array();
    for (const auto& [id, name] : file.renamed) json.back()["renamed"].push_back({{"id", id}, {"as", name}});
  }
  return json;
}

}  // namespace plumbline::report
