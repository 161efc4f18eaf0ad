#include "jobs/new_model/model_draft.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/number_text.hpp"
#include "base/text/printable.hpp"
#include "base/units.hpp"
#include "machine/model_keys.hpp"

namespace plumbline::jobs {
namespace {

machine::StrutVectors<double> six_vectors(const DraftValue& value) {
  PLUMBLINE_CHECK(value.values.size() == 18);
  return Eigen::Map<const machine::StrutVectors<double>>(value.values.data()) * kMm;
}

constexpr double kPlainBelow = 1e6;

std::string list_of(const double* first, std::size_t count) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + draft_number(first[i]);
  return text + "]";
}

// A text of TOML: what it cannot hold as it is comes as \uXXXX, or as printable() shows it.
std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::string text_of(const DraftValue& value, machine::Shape shape) {
  const std::vector<double>& numbers = value.values;
  if (shape == machine::Shape::text) return toml_text(value.text);
  if (numbers.size() == 1) return draft_number(numbers.front());
  if (shape != machine::Shape::six_vectors) return list_of(numbers.data(), numbers.size());
  std::string text = "[";
  for (std::size_t j = 0; j + 2 < numbers.size(); j += 3) text += (j == 0 ? "" : ", ") + list_of(&numbers[j], 3);
  return text + "]";
}

std::string comment_of(const DraftValue& value) {
  if (value.assumed) return "  # assumed: " + printable(value.note);
  return value.note.empty() ? "" : "  # " + printable(value.note);
}

}  // namespace

std::string draft_number(double value) {
  return std::abs(value) < kPlainBelow ? to_decimal(value) : fmt::format("{}", value);
}

void ModelDraft::put(DraftValue value) {
  const auto same = std::find_if(values_.begin(), values_.end(), [&](const DraftValue& other) {
    return other.table == value.table && other.key == value.key;
  });
  if (same == values_.end()) {
    values_.push_back(std::move(value));
  } else {
    *same = std::move(value);
  }
}

const DraftValue* ModelDraft::find(std::string_view table, std::string_view key) const {
  for (const DraftValue& value : values_) {
    if (value.table == table && value.key == key) return &value;
  }
  return nullptr;
}

double ModelDraft::number(std::string_view table, std::string_view key) const {
  const DraftValue* const value = find(table, key);
  PLUMBLINE_CHECK(value != nullptr && !value->values.empty());
  return value->values.front();
}

double ModelDraft::largest(std::string_view table, std::string_view key) const {
  const DraftValue* const value = find(table, key);
  PLUMBLINE_CHECK(value != nullptr && !value->values.empty());
  return *std::max_element(value->values.begin(), value->values.end());
}

double ModelDraft::least(std::string_view table, std::string_view key) const {
  const DraftValue* const value = find(table, key);
  PLUMBLINE_CHECK(value != nullptr && !value->values.empty());
  return *std::min_element(value->values.begin(), value->values.end());
}

machine::Geometry ModelDraft::geometry() const {
  const DraftValue* const base = find("base", "joints_mm");
  const DraftValue* const platform = find("platform", "joints_mm");
  const DraftValue* const tip = find("platform", "tool_tip_mm");
  PLUMBLINE_CHECK(base != nullptr && platform != nullptr && tip != nullptr && tip->values.size() == 3);
  return {six_vectors(*base), six_vectors(*platform),
          Vector3<double>(tip->values[0], tip->values[1], tip->values[2]) * kMm};
}

DraftText draft_text(const ModelDraft& draft, const std::vector<std::string>& heading) {
  DraftText result;
  const auto add = [&](const std::string& line, const DraftValue* value = nullptr) {
    result.text += line + "\n";
    result.lines.push_back(value);
  };
  for (const std::string& line : heading) add("# " + printable(line));
  std::string_view table;
  for (const machine::KeySpec& spec : machine::kKeys) {
    const DraftValue* const value = draft.find(spec.table, spec.key);
    if (value == nullptr) continue;
    if (spec.table != table) {
      add("");
      add(fmt::format("[{}]", spec.table));
      table = spec.table;
    }
    add(fmt::format("{} = {}{}", spec.key, text_of(*value, spec.shape), comment_of(*value)), value);
  }
  return result;
}

}  // namespace plumbline::jobs
