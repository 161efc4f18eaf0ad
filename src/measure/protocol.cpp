#include "measure/protocol.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text/nearest_name.hpp"
#include "base/units.hpp"

namespace plumbline::measure {
namespace {

using Kind = TomlValue::Kind;

// The entries of a table at the top of a dataset, whose keys are known.
const std::vector<TomlEntry>& entries_of(const TomlDocument& document, std::string_view table,
                                         const std::vector<std::string_view>& keys) {
  static const std::vector<TomlEntry> kNone;
  const TomlEntry* const found = document.root.find(table);
  if (found == nullptr) return kNone;
  if (found->value.kind != Kind::table) {
    refuse("dataset-wrong-type", fmt::format("{} holds {} where a table belongs", table, name_of(found->value.kind)),
           fmt::format("write [{}] on a line of its own, its keys below", table), document.place(found->value.span));
  }
  for (const TomlEntry& entry : found->value.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    refuse("dataset-unknown-key", fmt::format("{} is no key of [{}]", entry.key, table), suggestion(entry.key, keys),
           document.place(entry.key_span));
  }
  return found->value.entries;
}

[[noreturn]] void refuse_kind(const TomlDocument& document, const TomlEntry& entry, Kind kind) {
  refuse("dataset-wrong-type",
         fmt::format("{} holds {} where {} belongs", entry.key, name_of(entry.value.kind), name_of(kind)),
         kind == Kind::text ? "write it in quotes" : "write a number, without quotes",
         document.place(entry.value.span));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> Protocol::rows() const {
  std::vector<std::pair<std::string, std::string>> rows{{"serial number", serial},  {"instrument", instrument},
                                                        {"measured by", operator_}, {"date", date},
                                                        {"place", place},           {"remarks", remarks}};
  rows.erase(std::remove_if(rows.begin(), rows.end(), [](const auto& row) { return row.second.empty(); }), rows.end());
  return rows;
}

Protocol read_protocol(const TomlDocument& document) {
  Protocol protocol;
  const std::vector<std::pair<std::string_view, std::string*>> keys{
      {"serial", &protocol.serial}, {"instrument", &protocol.instrument}, {"operator", &protocol.operator_},
      {"date", &protocol.date},     {"place", &protocol.place},           {"remarks", &protocol.remarks}};
  std::vector<std::string_view> names;
  for (const auto& [name, text] : keys) names.push_back(name);
  for (const TomlEntry& entry : entries_of(document, "protocol", names)) {
    std::string& text =
        *std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.first == entry.key; })->second;
    if (entry.value.kind == Kind::date) {  // TOML has dates of its own
      text = document.text.substr(entry.value.span.offset, entry.value.span.length);
    } else if (entry.value.kind == Kind::text) {
      text = entry.value.text;
    } else {
      refuse_kind(document, entry, Kind::text);
    }
  }
  return protocol;
}

Instrument read_instrument(const TomlDocument& document) {
  Instrument instrument;
  for (const TomlEntry& entry : entries_of(document, "instrument", {"bar_sigma_um", "torque_sigma_Nm"})) {
    if (entry.value.kind != Kind::number) refuse_kind(document, entry, Kind::number);
    const bool bar = entry.key == "bar_sigma_um";
    constexpr double kMost = 1000;
    if (!(entry.value.number > 0 && entry.value.number <= kMost)) {
      refuse("dataset-out-of-range", fmt::format("{} is {:.12g}", entry.key, entry.value.number),
             fmt::format("1 sigma of a single reading: more than 0, at most {:.12g}", kMost),
             document.place(entry.value.span));
    }
    (bar ? instrument.bar_sigma : instrument.torque_sigma) = entry.value.number * (bar ? kUm : 1);
  }
  return instrument;
}

}  // namespace plumbline::measure
