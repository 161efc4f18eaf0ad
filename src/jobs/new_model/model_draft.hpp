// A model that is being made: what was stated of a machine, and what is assumed because nothing was.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "machine/geometry.hpp"

namespace plumbline::jobs {

/// The value of a key of machine/model_keys.hpp, in the unit of the file.
struct DraftValue {
  std::string table;
  std::string key;
  std::vector<double> values;  // flattened; one for all six struts, or six; empty of a text
  std::string text;
  std::string note;      // where it comes from; if it is assumed, by what rule; may be empty
  bool assumed = false;  // nobody stated it
  Place place;           // where it was stated; no file: on the command line
};

class ModelDraft {
 public:
  /// Takes the place of what was stated of that key before.
  void put(DraftValue value);
  const DraftValue* find(std::string_view table, std::string_view key) const;
  bool has(std::string_view table, std::string_view key) const { return find(table, key) != nullptr; }
  /// The first number of a key that is there: asking for another one is a bug.
  double number(std::string_view table, std::string_view key) const;
  /// The greatest (least) number of a key that is there.
  double largest(std::string_view table, std::string_view key) const;
  double least(std::string_view table, std::string_view key) const;
  const std::vector<DraftValue>& values() const { return values_; }

  /// Joints and gauge point, m; they must be there.
  machine::Geometry geometry() const;

  std::vector<double> home_mm;  // where the tip stands at home, x y z in W; empty: not known
  std::string home_note;
  bool home_assumed = false;

 private:
  std::vector<DraftValue> values_;
};

/// A number as a model file holds it; large ones with an exponent.
std::string draft_number(double value);

/// The text of a model file, and what stands on which line of it.
struct DraftText {
  std::string text;
  std::vector<const DraftValue*> lines;  // line n + 1 states *lines[n]; nothing: a comment, a header, an empty line
};

/// The draft as a model file: tables in the order of machine/model_keys.hpp, a comment on each line that says where its
/// value comes from. `heading` are lines of the comment at its head, without their "# ". The draft is kept by
/// reference.
DraftText draft_text(const ModelDraft& draft, const std::vector<std::string>& heading);

}  // namespace plumbline::jobs
