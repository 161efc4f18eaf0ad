// A machine as its model file states it, in SI.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/toml.hpp"
#include "machine/geometry.hpp"
#include "machine/orientation.hpp"

namespace plumbline::machine {

/// A value of the file: its numbers, flattened, and where they stand in the text.
struct ModelValue {
  std::string table;  // empty: before the first table
  std::string key;
  std::vector<double> values;   // SI; a number for all six struts is spread to six
  std::string text;             // of a text
  TextSpan span;                // of the value; of what the file leaves out: length 0
  std::vector<TextSpan> spans;  // of each number

  bool given() const { return span.length > 0; }
};

struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

struct Limits {
  double tilt = 0;                                         // rad, between Z of P and Z of W
  double tilt_allowance = 0;                               // rad more that a compensated pose may have
  std::array<Range, 3> travel;                             // x, y, z of the tool tip in W, m
  PerStrut<double> length_min = PerStrut<double>::Zero();  // m
  PerStrut<double> length_max = PerStrut<double>::Zero();
  double condition_max = std::numeric_limits<double>::infinity();
};

/// What the control does with the numbers of a program.
struct ControlSettings {
  double block_time = 0;    // s, the shortest that a block may take
  double increment_mm = 0;  // 0: as fine as its digits
  double increment_deg = 0;
  int digits_mm = 4;
  int digits_deg = 5;
  int digits_inch = 6;
};

/// One key of an [[effect]] row, in the units of the file; what it means is for the physics to say.
struct EffectValue {
  std::string key;
  std::vector<double> values;      // nested arrays flattened
  std::vector<std::size_t> shape;  // {}: a number, {6}: six, {6, 3}: six of three
  Place place;                     // of the value
  Place key_place;
};

struct EffectRow {
  std::string name;
  std::vector<EffectValue> values;
  Place place;  // of the name
};

struct MachineModel {
  std::string name;
  std::string provenance;
  RotationOrder rotation;
  Vector3<double> gravity = Vector3<double>::Zero();  // m/s^2 in W
  Geometry geometry;
  Limits limits;
  ControlSettings control;
  double reference_tool_mass = 0;  // kg, contained in platform.mass_kg
  std::vector<ModelValue> values;  // every key of machine/model_keys.hpp, given or not
  std::vector<EffectRow> effects;
  std::uint64_t hash = 0;  // fnv1a of the text
  TomlDocument document;   // the text that all this was read from, and its places

  /// The value of a key of machine/model_keys.hpp; asking for another one is a bug.
  const ModelValue& value(std::string_view table, std::string_view key) const;
  /// The 1 sigma that [uncertainty] states, SI; nothing if it is not listed: then the quantity is exact.
  std::optional<double> uncertainty(std::string_view key) const;
};

/// The pose in the middle of the travel, not turned: where the machine is surely on the right side of every
/// singularity.
Pose<double> home_pose(const MachineModel& model);

}  // namespace plumbline::machine
