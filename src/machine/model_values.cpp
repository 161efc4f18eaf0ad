#include "machine/model_values.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/nearest_name.hpp"

namespace plumbline::machine {
namespace {

std::string full_name(std::string_view table, std::string_view key) {
  return table.empty() ? std::string(key) : fmt::format("[{}] {}", table, key);
}
std::string full_name(const KeySpec& spec) { return full_name(spec.table, spec.key); }

std::string with_unit(double value, const Unit& unit) {
  return unit.name.empty() ? fmt::format("{:.12g}", value) : fmt::format("{:.12g} {}", value, unit.name);
}

std::string_view shape_text(Shape shape) {
  switch (shape) {
    case Shape::text:
      return "a text in quotes";
    case Shape::number:
      return "a number";
    case Shape::whole:
      return "a whole number";
    case Shape::six:
      return "a number for all six struts, or an array of six";
    case Shape::vector:
      return "three numbers, as [0, 0, 0]";
    case Shape::range:
      return "two numbers, the lower first, as [-300, 300]";
    case Shape::six_vectors:
      break;
  }
  return "six points of three numbers each, as [[x, y, z], ...]";
}

TextSpan start_of_file() { return {0, 1}; }

// --- which tables and keys there may be ---

std::vector<std::string_view> known_tables() {
  std::vector<std::string_view> tables;
  for (const KeySpec& spec : kKeys) {
    if (!spec.table.empty() && (tables.empty() || tables.back() != spec.table)) tables.push_back(spec.table);
  }
  return tables;
}

std::vector<std::string_view> known_keys(std::string_view table) {
  std::vector<std::string_view> keys;
  for (const KeySpec& spec : kKeys) {
    if (spec.table == table) keys.push_back(spec.key);
  }
  return keys;
}

bool holds(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The table that a key belongs to although it stands elsewhere; empty if none.
std::string home_of(std::string_view key) {
  for (const KeySpec& spec : kKeys) {
    if (spec.key == key && !spec.table.empty()) return std::string(spec.table);
  }
  return "";
}

void refuse_unknown_key(const TomlDocument& document, const TomlEntry& entry, std::string_view table) {
  const std::string home = home_of(entry.key);
  refuse("model-unknown-key", fmt::format("{} is no key of a machine model", full_name(table, entry.key)),
         home.empty() || home == table ? suggestion(entry.key, known_keys(table))
                                       : fmt::format("it belongs into the table [{}]", home),
         document.place(entry.key_span));
}

void check_names(const TomlDocument& document) {
  const std::vector<std::string_view> tables = known_tables();
  for (const TomlEntry& entry : document.root.entries) {
    if (entry.key == "effect") continue;
    if (!holds(tables, entry.key)) {
      if (holds(known_keys(""), entry.key)) continue;
      if (entry.value.kind != TomlValue::Kind::table) refuse_unknown_key(document, entry, "");
      refuse("model-unknown-table", fmt::format("[{}] is no table of a machine model", entry.key),
             suggestion(entry.key, tables), document.place(entry.key_span));
    }
    if (entry.value.kind != TomlValue::Kind::table) {
      refuse("model-wrong-type", fmt::format("{} is {}, not a table", entry.key, name_of(entry.value.kind)),
             fmt::format("write it as a table: [{}] on a line of its own, its keys below", entry.key),
             document.place(entry.value.span));
    }
    const std::vector<std::string_view> keys = known_keys(entry.key);
    for (const TomlEntry& inner : entry.value.entries) {
      if (!holds(keys, inner.key)) refuse_unknown_key(document, inner, entry.key);
    }
  }
}

void check_marker(const TomlDocument& document) {
  constexpr std::string_view kMarker = "machine 1";
  const TomlEntry* marker = document.root.find("plumbline");
  if (marker == nullptr) {
    refuse("model-marker", "this file does not say that it is a machine model",
           "write plumbline = \"machine 1\" as its first line; a dataset or a diagnosis is not a machine",
           document.place(start_of_file()));
  }
  if (marker->value.kind != TomlValue::Kind::text || marker->value.text != kMarker) {
    const bool later = marker->value.text.starts_with("machine ");
    refuse("model-marker", "this file is not a machine model that this version reads",
           later ? "only \"machine 1\" is known: use the plumbline that wrote the file"
                 : "a machine model says plumbline = \"machine 1\"",
           document.place(marker->value.span));
  }
}

// --- one value ---

class Reader {
 public:
  Reader(const TomlDocument& document, const KeySpec& spec) : document_(document), spec_(spec) {
    read_.table = spec.table;
    read_.key = spec.key;
  }

  ModelValue run() && {
    const TomlEntry* entry = find();
    if (entry == nullptr) return std::move(*this).left_out();
    read_.span = entry->value.span;
    if (spec_.shape == Shape::text) {
      require_kind(entry->value, TomlValue::Kind::text);
      read_.text = entry->value.text;
      return std::move(read_);
    }
    read_shape(entry->value);
    for (double& value : read_.values) value *= spec_.unit.si;
    return std::move(read_);
  }

 private:
  const TomlEntry* find() const {
    if (spec_.table.empty()) return document_.root.find(spec_.key);
    const TomlEntry* table = document_.root.find(spec_.table);
    if (table != nullptr) return table->value.find(spec_.key);
    if (std::isnan(spec_.fallback)) {
      refuse("model-missing-table", fmt::format("the table [{}] is missing", spec_.table),
             fmt::format("add [{}] with at least {} ({})", spec_.table, spec_.key, spec_.meaning),
             document_.place(start_of_file()));
    }
    return nullptr;
  }

  ModelValue left_out() && {
    if (std::isnan(spec_.fallback)) {
      const TomlEntry* table = document_.root.find(spec_.table);
      refuse("model-missing-key", fmt::format("{} is missing", full_name(spec_)),
             fmt::format("add it: {}, {}{}", spec_.meaning, shape_text(spec_.shape),
                         spec_.unit.name.empty() ? "" : fmt::format(", in {}", spec_.unit.name)),
             document_.place(table == nullptr ? start_of_file() : table->key_span));
    }
    read_.values.assign(count_of(spec_.shape), spec_.fallback * spec_.unit.si);
    read_.spans.assign(count_of(spec_.shape), TextSpan{});
    return std::move(read_);
  }

  void read_shape(const TomlValue& value) {
    switch (spec_.shape) {
      case Shape::number:
      case Shape::whole:
        read_number(value);
        break;
      case Shape::six:
        if (value.kind == TomlValue::Kind::array) {
          read_numbers(value, kStruts);
        } else {
          read_number(value);
          read_.values.assign(kStruts, read_.values.front());
          read_.spans.assign(kStruts, value.span);
        }
        break;
      case Shape::six_vectors:
        require_size(value, kStruts);
        for (const TomlValue& point : value.items) read_numbers(point, 3);
        break;
      default:
        read_numbers(value, count_of(spec_.shape));
        break;
    }
  }

  void read_numbers(const TomlValue& value, std::size_t count) {
    require_size(value, count);
    for (const TomlValue& item : value.items) read_number(item);
  }

  void read_number(const TomlValue& value) {
    require_kind(value, TomlValue::Kind::number);
    if (!std::isfinite(value.number)) {
      refuse("model-not-finite", fmt::format("{} is not a finite number", full_name(spec_)),
             fmt::format("write the number: {}", spec_.meaning), document_.place(value.span));
    }
    check_range(value);
    if (spec_.shape == Shape::whole && value.number != std::floor(value.number)) {
      refuse("model-not-whole", fmt::format("{} is {:.12g}", full_name(spec_), value.number),
             fmt::format("{}: a whole number", spec_.meaning), document_.place(value.span));
    }
    read_.values.push_back(value.number);
    read_.spans.push_back(value.span);
  }

  void check_range(const TomlValue& value) const {
    const double x = value.number;
    const bool below = x < spec_.lower;
    const bool slip = x != 0 && std::abs(x) < spec_.least_nonzero;
    if (!below && !slip && x <= spec_.upper) return;
    const std::string bound =
        below  ? fmt::format("below {}", with_unit(spec_.lower, spec_.unit))
        : slip ? fmt::format("below any that makes sense ({})", with_unit(spec_.least_nonzero, spec_.unit))
               : fmt::format("above {}", with_unit(spec_.upper, spec_.unit));
    refuse("model-out-of-range", fmt::format("{} is {}, {}", full_name(spec_), with_unit(x, spec_.unit), bound),
           fmt::format("{}: {} to {}{}", spec_.meaning, with_unit(spec_.lower, spec_.unit),
                       with_unit(spec_.upper, spec_.unit),
                       slip_hint(spec_.unit, x, spec_.lower, spec_.upper, spec_.least_nonzero)),
           document_.place(value.span));
  }

  void require_kind(const TomlValue& value, TomlValue::Kind kind) const {
    if (value.kind == kind) return;
    refuse("model-wrong-type",
           fmt::format("{} holds {} where {} belongs", full_name(spec_), name_of(value.kind), name_of(kind)),
           fmt::format("{}: {}", spec_.meaning, shape_text(spec_.shape)), document_.place(value.span));
  }

  void require_size(const TomlValue& value, std::size_t count) const {
    require_kind(value, TomlValue::Kind::array);
    if (value.items.size() == count) return;
    refuse("model-wrong-size",
           fmt::format("{} holds {} values where {} belong", full_name(spec_), value.items.size(), count),
           fmt::format("{}: {}", spec_.meaning, shape_text(spec_.shape)), document_.place(value.span));
  }

  const TomlDocument& document_;
  const KeySpec& spec_;
  ModelValue read_;
};

}  // namespace

std::string slip_hint(const Unit& unit, double value, double lower, double upper, double least_nonzero) {
  for (const Slip& slip : unit.slips) {
    const double meant = value * slip.factor;
    if (slip.factor != 0 && meant >= lower && meant <= upper && std::abs(meant) >= least_nonzero) {
      return fmt::format("; if it was meant in {}, write {:.12g}", slip.name, meant);
    }
  }
  return "";
}

std::vector<ModelValue> read_values(const TomlDocument& document) {
  check_marker(document);
  check_names(document);
  std::vector<ModelValue> values;
  values.reserve(kKeys.size());
  for (const KeySpec& spec : kKeys) values.push_back(Reader(document, spec).run());
  return values;
}

}  // namespace plumbline::machine
