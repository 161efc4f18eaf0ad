#include "truth/catalogue.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

namespace truth {
namespace {

constexpr double kMilli = 1e-3;
constexpr double kMicro = 1e-6;

template <class Numbers>
std::vector<double*> each(Numbers& numbers) {
  std::vector<double*> all;
  all.reserve(static_cast<std::size_t>(numbers.size()));
  for (double& x : numbers) all.push_back(&x);
  return all;
}
std::vector<double*> each(double& x) { return {&x}; }
std::vector<double*> each(std::array<Vec, 6>& points) {
  std::vector<double*> all;
  for (Vec& point : points) {
    for (double& x : point) all.push_back(&x);
  }
  return all;
}

using Keys = std::function<std::vector<Key>(Flaws&)>;

Keys one(const char* key, double unit, double upper, auto member) {
  return [=](Flaws& f) { return std::vector<Key>{{key, unit, upper, each(f.*member), false}}; };
}

const std::map<std::string, Keys>& table() {
  static const std::map<std::string, Keys> effects{
      {"payload", one("mass_kg", 1, 60, &Flaws::payload)},
      {"platform-mass", one("mass_kg", 1, 60, &Flaws::platform_mass)},
      {"centre-of-mass", one("offset_mm", kMilli, 60, &Flaws::centre_of_mass)},
      {"level", one("tilt_mrad", kMilli, 10, &Flaws::level)},
      {"strut-mass", one("mass_kg", 1, 10, &Flaws::screw_mass)},
      {"screw-coulomb", one("force_N", 1, 300, &Flaws::coulomb)},
      {"screw-viscous", one("damping_N_s_m", 1, 8000, &Flaws::viscous)},
      {"screw-stribeck",
       [](Flaws& f) {
         return std::vector<Key>{{"force_N", 1, 300, each(f.stribeck_force), false},
                                 {"speed_mm_s", kMilli, 10, each(f.stribeck_speed), false}};
       }},
      {"load-friction", one("mu", 1, 0.2, &Flaws::load_friction)},
      {"joint-coulomb", one("moment_Nm", 1, 40, &Flaws::joint_moment)},
      {"joint-viscous", one("damping_Nms_rad", 1, 1500, &Flaws::joint_damping)},
      {"backlash", one("width_um", kMicro, 40, &Flaws::backlash)},
      {"strut-offset", one("length_um", kMicro, 500, &Flaws::offset)},
      {"thermal-drift", one("rate_K_h", 1 / 3600.0, 8, &Flaws::drift)},
      {"cyclic",
       [](Flaws& f) {
         return std::vector<Key>{{"amplitude_um", kMicro, 50, each(f.cyclic), false},
                                 {"phase_deg", kDeg, 180, each(f.cyclic_phase), false}};
       }},
      {"servo-lag", one("lag_ms", kMilli, 60, &Flaws::lag)},
      {"servo-mismatch", one("lag_ms", kMilli, 5, &Flaws::lags)},
      {"torque-scale", one("percent", 0.01, 30, &Flaws::torque_scale)},
      {"base-joint-compliance",
       [](Flaws& f) {
         return std::vector<Key>{{"radial_um_N", kMicro, 0.05, each(f.base_compliance[0]), false},
                                 {"vertical_um_N", kMicro, 0.05, each(f.base_compliance[1]), false}};
       }},
      {"platform-joint-compliance",
       [](Flaws& f) {
         return std::vector<Key>{{"radial_um_N", kMicro, 0.05, each(f.platform_compliance[0]), false},
                                 {"axial_um_N", kMicro, 0.05, each(f.platform_compliance[1]), false}};
       }},
      {"strut-compliance", one("compliance_um_N", kMicro, 0.05, &Flaws::compliance)},
      {"joint-clearance", one("width_um", kMicro, 60, &Flaws::clearance)},
      {"cable",
       [](Flaws& f) {
         return std::vector<Key>{{"force_N", 1, 300, each(f.cable), false},
                                 {"stiffness_N_m", 1, 3000, each(f.cable_stiffness), false}};
       }},
      {"inertia", one("mass_kg", 1, 1000, &Flaws::inertia)},
      {"counterbalance", one("force_N", 1, 600, &Flaws::counterbalance)},
      {"lead-error", one("error_um_m", kMicro, 500, &Flaws::lead_error)},
      {"ring-thermal", one("rise_K", 1, 40, &Flaws::ring_rise)},
      {"joint-position",
       [](Flaws& f) {
         return std::vector<Key>{{"base_um", kMicro, 500, each(f.base_moved), true},
                                 {"platform_um", kMicro, 500, each(f.platform_moved), true}};
       }},
      {"gimbal-offset", one("offset_um", kMicro, 2000, &Flaws::gimbal)},
      {"screw-roll", one("share", 1, 1, &Flaws::roll_share)},
      {"spindle-growth",
       [](Flaws& f) {
         return std::vector<Key>{{"length_um", kMicro, 200, each(f.growth), false},
                                 {"rate_um_h", kMicro / 3600, 200, each(f.growth_rate), false}};
       }},
      {"frame-compliance",
       [](Flaws& f) {
         return std::vector<Key>{{"shift_um_N", kMicro, 0.2, each(f.frame_shift), false},
                                 {"tilt_urad_Nm", kMicro, 5, each(f.frame_tilt), false}};
       }},
      {"hertz-contact", one("um_at_kN", kMicro, 60, &Flaws::hertz)},
      {"contact-compliance", one("um_at_kN", kMicro, 60, &Flaws::hertz)},  // as plumbline's catalogue calls it
      {"gear-beat", one("amplitude_um", kMicro, 50, &Flaws::gear_beat)},
      {"cogging", one("torque_Nm", 1, 2, &Flaws::cogging)},
      {"preload-slope", one("force_N_m", 1, 500, &Flaws::preload_slope)},
      {"hardening", one("um_at_kN2", kMicro, 60, &Flaws::hardening)},
      {"hose", one("force_N_m2", 1, 8000, &Flaws::hose)},
      {"table-sag", one("sag_um", kMicro, 60, &Flaws::table_sag)},
      {"side-friction", one("force_N", 1, 300, &Flaws::side_friction)},
      {"softening", one("um_at_kN", kMicro, 60, &Flaws::softening)},
      {"magnet", one("force_N", 1, 600, &Flaws::magnet)},
      {"two-gears", one("amplitude_um", kMicro, 30, &Flaws::two_gears)},
  };
  return effects;
}

// What keeps its value while the effect is scaled.
bool fixed(const std::string& key) { return key == "phase_deg" || key == "speed_mm_s"; }

// Effects whose numbers may be negative.
bool signed_effect(const std::string& name) {
  static const std::vector<std::string> names{"platform-mass",  "centre-of-mass",
                                              "level",          "strut-mass",
                                              "strut-offset",   "thermal-drift",
                                              "cyclic",         "servo-mismatch",
                                              "torque-scale",   "cable",
                                              "counterbalance", "lead-error",
                                              "ring-thermal",   "joint-position",
                                              "gimbal-offset",  "screw-roll",
                                              "spindle-growth", "hertz-contact",
                                              "preload-slope",  "hardening",
                                              "table-sag",      "contact-compliance"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

void draw_key(const std::string& name, Key& key, Random& random) {
  const std::size_t count = key.numbers.size();
  if (key.name == "phase_deg") {
    for (double* x : key.numbers) *x = key.unit * uniform(random, -180, 180);
    return;
  }
  if (key.name == "speed_mm_s") {
    *key.numbers.front() = key.unit * uniform(random, 1.5, 6);
    return;
  }
  const bool lonely = count == 6 && name != "servo-mismatch" && uniform(random, 0, 1) < 0.5;
  const auto chosen = static_cast<std::size_t>(uniform(random, 0, static_cast<double>(count) - 1e-9));
  const bool both_signs = signed_effect(name) && key.name != "stiffness_N_m";
  for (std::size_t i = 0; i < count; ++i) {
    const double size = uniform(random, 0.1, 1);
    const double way = both_signs && uniform(random, 0, 1) < 0.5 ? -1 : 1;
    *key.numbers[i] = lonely && i != chosen ? 0 : way * size * key.upper * key.unit;
  }
  if (name == "servo-mismatch") {  // its lags sum to zero
    double mean = 0;
    for (const double* x : key.numbers) mean += *x / static_cast<double>(count);
    for (double* x : key.numbers) *x -= mean;
  }
}

}  // namespace

const std::vector<std::string>& first_shelf() {
  static const std::vector<std::string> names{"payload",
                                              "platform-mass",
                                              "centre-of-mass",
                                              "level",
                                              "strut-mass",
                                              "screw-coulomb",
                                              "screw-viscous",
                                              "screw-stribeck",
                                              "load-friction",
                                              "joint-coulomb",
                                              "joint-viscous",
                                              "backlash",
                                              "strut-offset",
                                              "thermal-drift",
                                              "cyclic",
                                              "servo-lag",
                                              "servo-mismatch",
                                              "torque-scale",
                                              "base-joint-compliance",
                                              "platform-joint-compliance",
                                              "strut-compliance",
                                              "joint-clearance",
                                              "cable",
                                              "inertia"};
  return names;
}

const std::vector<std::string>& second_shelf() {
  static const std::vector<std::string> names{"counterbalance", "lead-error", "ring-thermal",   "joint-position",
                                              "gimbal-offset",  "screw-roll", "spindle-growth", "frame-compliance"};
  return names;
}

const std::vector<std::string>& outside_effects() {
  static const std::vector<std::string> names{"hertz-contact", "gear-beat", "cogging",   "preload-slope",
                                              "hardening",     "hose",      "table-sag", "side-friction",
                                              "softening",     "magnet",    "two-gears"};
  return names;
}

Effect effect_in(Flaws& flaws, const std::string& name) {
  const auto found = table().find(name);
  if (found == table().end()) throw std::runtime_error("no effect is called " + name);
  return {name, found->second(flaws)};
}

Flaws drawn_flaws(const std::string& name, Random& random) {
  Flaws flaws;
  for (Key& key : effect_in(flaws, name).keys) draw_key(name, key, random);
  return flaws;
}

Flaws scaled(const Flaws& flaws, const std::string& name, double share) {
  Flaws result = flaws;
  for (Key& key : effect_in(result, name).keys) {
    if (fixed(key.name)) continue;
    for (double* x : key.numbers) *x *= share;
  }
  return result;
}

std::vector<Flaws> directions(const std::string& name) {
  constexpr double kSmall = 0.02;  // of the largest
  std::vector<Flaws> all;
  Flaws none;
  const std::vector<Key> keys = effect_in(none, name).keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (fixed(keys[k].name)) continue;
    for (std::size_t i = 0; i < keys[k].numbers.size(); ++i) {
      const auto add = [&](const auto& change) {
        all.emplace_back();
        Effect effect = effect_in(all.back(), name);
        *effect.keys[k].numbers[i] = kSmall * keys[k].upper * keys[k].unit;
        change(effect);
      };
      if (name == "cyclic") {
        for (const double phase : {0.0, M_PI / 2}) add([&](Effect& e) { *e.keys[1].numbers[i] = phase; });
      } else if (name == "screw-stribeck") {
        for (const double speed : {1.5e-3, 3e-3, 6e-3}) add([&](Effect& e) { *e.keys[1].numbers[0] = speed; });
      } else {
        add([](Effect&) {});
      }
    }
  }
  return all;
}

}  // namespace truth
