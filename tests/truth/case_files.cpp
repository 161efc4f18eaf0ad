#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "truth/drawn_case.hpp"

namespace truth {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::ofstream opened(const fs::path& path) {
  std::ofstream out(path);
  if (!out) throw std::runtime_error("cannot write " + path.string());
  return out;
}

// A number as somebody would type it: no more digits than it has.
std::string text(double value) { return fmt::format("{:.9g}", value); }

std::string text(const Vec& v, double unit) {
  return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", v.x() / unit, v.y() / unit, v.z() / unit);
}

void write_run(const MeasuredRun& run, const fs::path& path) {
  std::ofstream out = opened(path);
  out << "time_s,angle_deg,radial_um";
  for (int j = 1; j <= 6; ++j) out << ",torque" << j << "_Nm";
  out << '\n' << std::fixed;
  const int decimals = run.samples.size() < 10000 ? 3 : 6;  // of seconds and degrees: each sample has its own
  for (const Sample& s : run.samples) {
    out << std::setprecision(decimals) << s.seconds << ',' << s.angle * 180 / M_PI;
    out << std::setprecision(1) << ',' << s.reading.radial * 1e6 + 0.0 << std::setprecision(2);
    for (const double torque : s.reading.torque) out << ',' << torque + 0.0;
    out << '\n';
  }
}

Json numbers(const Key& key) {
  Json values = Json::array();
  for (const double* x : key.numbers) values.push_back(*x / key.unit);
  if (key.numbers.size() == 1) return values.front();
  if (!key.points) return values;
  Json points = Json::array();
  for (std::size_t i = 0; i < values.size(); i += 3) points.push_back({values[i], values[i + 1], values[i + 2]});
  return points;
}

Json numbers_of(Flaws flaws, const std::string& effect) {
  Json json = Json::object();
  for (const Key& key : effect_in(flaws, effect).keys) json[key.name] = numbers(key);
  return json;
}

// What a diagnosis finds of an effect that [uncertainty] leaves open as well: what was hidden and what was drawn with
// the machine are one departure from the model.
Flaws departure(Flaws flaws, const Machine& is, const Machine& believed) {
  flaws.platform_mass += is.mass - believed.mass;
  flaws.centre_of_mass += is.centre_of_mass - believed.centre_of_mass;
  flaws.screw_mass += is.screw_mass[0] - believed.screw_mass[0];
  const Vec turned = (is.gravity - believed.gravity) / believed.gravity.norm();
  flaws.level[0] += turned.y();
  flaws.level[1] -= turned.x();
  for (std::size_t j = 0; j < 6; ++j) {
    flaws.coulomb[j] += is.friction[j] - believed.friction[j];
    flaws.offset[j] += is.length_offset[j] - believed.length_offset[j];
    flaws.base_moved[j] += is.base[j] - believed.base[j];
    flaws.platform_moved[j] += is.platform[j] - believed.platform[j];
  }
  return flaws;
}

Json hidden_json(const Hidden& hidden, const Machine& is, const Machine& believed, bool look_alikes) {
  Json effect;
  effect["name"] = hidden.outside ? std::string("unknown:").append(hidden.name) : hidden.name;
  effect["snr"] = hidden.snr;
  if (look_alikes) {
    effect["outside"] = hidden.beyond_all;
    effect["beyond_others"] = hidden.beyond_others;
    effect["beyond_two"] = hidden.beyond_two;
    for (const auto& [name, left] : hidden.nearest) effect["nearest"].push_back({name, left});
  }
  effect["parameters"] = numbers_of(hidden.flaws, hidden.name);
  effect["departure"] = numbers_of(departure(hidden.flaws, is, believed), hidden.name);
  return effect;
}

// The drawn machine, in the units of a model file: what an identification should find.
Json machine_json(const Machine& m) {
  Json json;
  const auto six = [](const Six& values, double unit) {
    Json list = Json::array();
    for (const double x : values) list.push_back(x / unit);
    return list;
  };
  const auto points = [](const std::array<Vec, 6>& is, const std::array<Vec, 6>& believed) {
    Json list = Json::array();
    for (std::size_t j = 0; j < 6; ++j) {
      const Vec off = (is[j] - believed[j]) / 1e-6;
      list.push_back({off.x(), off.y(), off.z()});
    }
    return list;
  };
  json["compliance_per_length_um_N_m"] = six(m.per_length, 1e-6);
  json["compliance_um_N"] = six(m.constant, 1e-6);
  json["coulomb_friction_N"] = six(m.friction, 1);
  json["centre_of_mass_mm"] = {m.centre_of_mass.x() / 1e-3, m.centre_of_mass.y() / 1e-3, m.centre_of_mass.z() / 1e-3};
  json["platform_mass_kg"] = m.mass;
  json["screw_mass_kg"] = m.screw_mass[0];
  json["motor_mass_kg"] = m.motor_mass[0];
  json["gravity_m_s2"] = {m.gravity.x(), m.gravity.y(), m.gravity.z()};
  json["base_um"] = points(m.base, m.believed_base);
  json["platform_um"] = points(m.platform, m.believed_platform);
  json["strut_offset_um"] = six(m.length_offset, 1e-6);
  return json;
}

Json answer_of(const DrawnCase& drawn) {
  bool outside = false;
  Json effects = Json::array();
  for (const Hidden& hidden : drawn.hidden) {
    effects.push_back(hidden_json(hidden, drawn.truth.machine, drawn.model.machine, drawn.options.look_alikes));
    outside = outside || hidden.outside;
  }
  const std::string verdict = drawn.hidden.empty() ? "nothing-missing" : outside ? "unknown" : "named";
  return {{"machine", drawn.model.machine.name},
          {"plan", drawn.options.plan},
          {"seed", drawn.options.seed},
          {"verdict", verdict},
          {"effects", effects},
          {"machine_is", machine_json(drawn.truth.machine)}};
}

}  // namespace

void write_dataset(const std::string& machine, const std::vector<MeasuredRun>& runs, const std::string& folder) {
  fs::create_directories(folder);
  std::ofstream out = opened(fs::path(folder) / "dataset.toml");
  out << "plumbline = \"dataset 1\"\nmachine = \"" << machine << "\"\n";
  for (const MeasuredRun& run : runs) {
    const Circle& c = run.planned.circle;
    out << "\n[[run]]\nid = \"" << run.planned.id << "\"\nfile = \"" << run.planned.id << ".csv\"\n";
    out << "centre_mm = " << text(c.centre, 1e-3) << "\nradius_mm = " << text(c.radius / 1e-3) << '\n';
    if (c.bar != c.radius) out << "bar_mm = " << text(c.bar / 1e-3) << '\n';
    out << "tilt_deg = " << text(c.abc, M_PI / 180) << "\ndirection = \"" << (c.turn > 0 ? "ccw" : "cw") << "\"\n";
    out << "feed_mm_min = " << text(c.feed * 60 / 1e-3) << "\nstart_s = " << text(c.start)
        << "\npayload_kg = " << text(c.payload) << '\n';
    write_run(run, fs::path(folder) / (run.planned.id + ".csv"));
  }
}

void write_case(const DrawnCase& drawn, const std::string& folder) {
  const fs::path root(folder);
  fs::create_directories(root);
  opened(root / "base.toml") << drawn.model.text;
  write_dataset(drawn.model.machine.name, drawn.data, (root / "data").string());
  if (!drawn.holdout.empty()) write_dataset(drawn.model.machine.name, drawn.holdout, (root / "holdout").string());
  if (!drawn.more.empty()) write_dataset(drawn.model.machine.name, drawn.more, (root / "more").string());
  opened(root / "answer.json") << answer_of(drawn).dump(1) << '\n';
}

}  // namespace truth
