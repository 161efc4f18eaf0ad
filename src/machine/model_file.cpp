#include "machine/model_file.hpp"

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/text/hash.hpp"
#include "machine/effect_rows.hpp"
#include "machine/model_checks.hpp"
#include "machine/model_values.hpp"

namespace plumbline::machine {
namespace {

using Flat = Eigen::Map<const Eigen::VectorXd>;

Flat flat(const ModelValue& value) { return {value.values.data(), static_cast<Eigen::Index>(value.values.size())}; }

StrutVectors<double> six_vectors(const ModelValue& value) {
  return Eigen::Map<const StrutVectors<double>>(value.values.data());  // column-major: strut by strut, as the file
}

RotationOrder read_rotation(const MachineModel& model) {
  const ModelValue& rotation = model.value("", "rotation");
  const std::optional<RotationOrder> order = rotation_order(rotation.text);
  if (!order) {
    refuse("model-rotation", fmt::format("\"{}\" is no order of rotations", rotation.text),
           "use one of XYZ, XZY, YXZ, YZX, ZXY, ZYX; \"ZYX\" is R = Rz(C) Ry(B) Rx(A)",
           model.document.place(rotation.span));
  }
  return *order;
}

Geometry read_geometry(const MachineModel& model) {
  return {six_vectors(model.value("base", "joints_mm")), six_vectors(model.value("platform", "joints_mm")),
          flat(model.value("platform", "tool_tip_mm"))};
}

Limits read_limits(const MachineModel& model) {
  const auto range = [&](const char* key) {
    const std::vector<double>& values = model.value("limits", key).values;
    return Range{values[0], values[1]};
  };
  Limits limits;
  limits.tilt = model.value("limits", "tilt_deg").values[0];
  limits.tilt_allowance = model.value("limits", "tilt_allowance_deg").values[0];
  limits.travel = {range("x_mm"), range("y_mm"), range("z_mm")};
  limits.length_min = flat(model.value("strut", "length_min_mm"));
  limits.length_max = flat(model.value("strut", "length_max_mm"));
  const ModelValue& condition = model.value("limits", "condition_max");
  if (condition.given()) limits.condition_max = condition.values[0];
  return limits;
}

ControlSettings read_control(const MachineModel& model) {
  const auto number = [&](const char* key) { return model.value("control", key).values[0]; };
  const auto digits = [&](const char* key) { return static_cast<int>(number(key)); };
  ControlSettings control;
  control.block_time = number("block_time_ms");
  control.increment_mm = number("increment_mm");
  control.increment_deg = number("increment_deg");
  control.digits_mm = digits("digits_mm");
  control.digits_deg = digits("digits_deg");
  control.digits_inch = digits("digits_inch");
  return control;
}

}  // namespace

MachineModel parse_model(std::string text, std::string file) {
  MachineModel model;
  model.hash = fnv1a(text);
  model.document = parse_toml(std::move(text), std::move(file));
  model.values = read_values(model.document);
  model.effects = read_effect_rows(model.document);
  model.name = model.value("", "name").text;
  model.provenance = model.value("", "provenance").text;
  model.rotation = read_rotation(model);
  model.gravity = flat(model.value("", "gravity_m_s2"));
  model.geometry = read_geometry(model);
  model.limits = read_limits(model);
  model.control = read_control(model);
  model.reference_tool_mass = model.value("platform", "reference_tool_kg").values[0];
  check_model(model);
  return model;
}

MachineModel read_model(const Source& source) { return parse_model(read_text(source), source.name()); }

}  // namespace plumbline::machine
