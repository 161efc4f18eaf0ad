// What a dataset says of the measurement as a whole: who, when, with what, and how sure the instrument is of itself.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text/toml.hpp"

namespace plumbline::measure {

/// What stands on a report, as it was written; empty: not said.
struct Protocol {
  std::string serial;      // of the machine
  std::string instrument;  // maker, type and number of the bar, where it was calibrated
  std::string operator_;   // who measured
  std::string date;
  std::string place;
  std::string remarks;

  /// Names for people and what was said, of those that were.
  std::vector<std::pair<std::string, std::string>> rows() const;
};

/// What the instruments state of a single reading, 1 sigma, SI.
struct Instrument {
  std::optional<double> bar_sigma, torque_sigma;
};

/// Of the table [protocol]; nothing is required. Refuses with dataset-unknown-key and dataset-wrong-type.
Protocol read_protocol(const TomlDocument& document);
/// Of the table [instrument]. Refuses with dataset-out-of-range, too.
Instrument read_instrument(const TomlDocument& document);

}  // namespace plumbline::measure
