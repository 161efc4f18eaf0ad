#include "machine/effect_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace plumbline::machine {
namespace {

// The lengths of nested arrays, from the outermost in, as the first item of each has them.
std::vector<std::size_t> shape_of(const TomlValue& value) {
  std::vector<std::size_t> shape;
  const TomlValue* at = &value;
  while (at->kind == TomlValue::Kind::array) {
    shape.push_back(at->items.size());
    if (at->items.empty()) break;
    at = &at->items.front();
  }
  return shape;
}

// Appends the numbers of a value that has the rest of the shape from `depth` on.
void collect(const TomlDocument& document, const TomlValue& value, std::size_t depth, EffectValue& into) {
  if (depth < into.shape.size()) {
    if (value.kind != TomlValue::Kind::array || value.items.size() != into.shape[depth]) {
      refuse("model-wrong-size", fmt::format("the values of {} are not nested alike", into.key),
             "give each inner array as many numbers as the others", document.place(value.span));
    }
    for (const TomlValue& item : value.items) collect(document, item, depth + 1, into);
    return;
  }
  if (value.kind != TomlValue::Kind::number) {
    refuse("model-wrong-type", fmt::format("{} holds {}", into.key, name_of(value.kind)),
           "an effect's keys hold numbers or arrays of numbers", document.place(value.span));
  }
  if (!std::isfinite(value.number)) {
    refuse("model-not-finite", fmt::format("{} is not a finite number", into.key), "write the number",
           document.place(value.span));
  }
  into.values.push_back(value.number);
}

EffectRow read_row(const TomlDocument& document, const TomlValue& row) {
  const TomlEntry* name = row.find("name");
  if (name == nullptr) {
    refuse("model-missing-key", "this [[effect]] has no name", "add name = \"...\", the effect's name in quotes",
           document.place(row.span));
  }
  if (name->value.kind != TomlValue::Kind::text) {
    refuse("model-wrong-type", fmt::format("the name of an effect is {}", name_of(name->value.kind)),
           "write the effect's name in quotes", document.place(name->value.span));
  }
  EffectRow read{name->value.text, {}, document.place(name->value.span)};
  for (const TomlEntry& entry : row.entries) {
    if (&entry == name) continue;
    EffectValue value{
        entry.key, {}, shape_of(entry.value), document.place(entry.value.span), document.place(entry.key_span)};
    collect(document, entry.value, 0, value);
    read.values.push_back(std::move(value));
  }
  return read;
}

}  // namespace

std::vector<EffectRow> read_effect_rows(const TomlDocument& document) {
  std::vector<EffectRow> rows;
  const TomlEntry* effects = document.root.find("effect");
  if (effects == nullptr) return rows;
  const auto is_table = [](const TomlValue& item) { return item.kind == TomlValue::Kind::table; };
  const std::vector<TomlValue>& items = effects->value.items;
  if (effects->value.kind != TomlValue::Kind::array || !std::all_of(items.begin(), items.end(), is_table)) {
    refuse("model-effect-row", "effects are rows of their own", "write [[effect]], in double brackets, for each",
           document.place(effects->key_span));
  }
  for (const TomlValue& row : items) rows.push_back(read_row(document, row));
  return rows;
}

}  // namespace plumbline::machine
