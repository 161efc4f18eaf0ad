#include "identify/posterior/posterior_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/hash.hpp"
#include "base/text/toml.hpp"
#include "base/units.hpp"
#include "machine/numbers_hash.hpp"

namespace plumbline::identify {
namespace {

constexpr std::string_view kMarker = "posterior 1";
constexpr std::string_view kOther =
    "learn the model anew (identify, calibrate or diagnose), or take [posterior] out of it: "
    "then [uncertainty] says what is known";

constexpr std::uintmax_t kLargestModel = 10'000'000;  // bytes: more is a program or a table, and no model

// What a number may be, with room for what is badly known: what lies beyond was not written here, and its squares would
// leave what is expected of the tip without a meaning.
constexpr double kLargestNoise = 1e6;      // um, N m
constexpr double kLargestWidening = 1e12;  // of a covariance
constexpr double kLargestMean = 1e3;       // of what the catalogue lets a number be
constexpr double kLargestError = 1e6;      // likewise
constexpr double kOddCorrelation = 1e-6;   // beyond one: of rounding
constexpr double kOddMatrix = 1e-6;        // below zero: a smallest eigenvalue of correlations that were rounded
constexpr double kSmallestSigma = 1e-15;   // of what the catalogue lets a number be

// --- written ---

std::string list_text(const std::vector<double>& numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
  return text + "]";
}

std::vector<double> units_of(const Unknowns& unknowns) {
  std::vector<double> units;
  for (const Unknown& unknown : unknowns) units.push_back(unknown.unit.si);
  return units;
}

std::vector<double> in_units(const Eigen::VectorXd& values, const std::vector<double>& units) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < units.size(); ++i) numbers.push_back(values[static_cast<Eigen::Index>(i)] / units[i]);
  return numbers;
}

std::string unknown_text(const Unknown& unknown) {
  std::string text =
      fmt::format("\n[[unknown]] # {}\neffect = \"{}\"\nkey = \"{}\"\n", unknown.label, unknown.effect, unknown.key);
  if (unknown.index >= 0) text += fmt::format("index = {}\n", unknown.index);
  if (unknown.row > 0) text += fmt::format("row = {}\n", unknown.row);
  text += fmt::format("unit = \"{}\"\nvalue = {}\n", unknown.unit.name, unknown.start / unknown.unit.si);
  if (!unknown.free()) text += fmt::format("prior_sigma = {}\n", unknown.sigma / unknown.unit.si);
  return text;
}

std::string state_text(const PosteriorState& state, const std::vector<double>& units) {
  const Eigen::VectorXd errors = state.covariance.diagonal().cwiseMax(0).cwiseSqrt();
  std::string text =
      fmt::format("\n[[state]]\nname = \"{}\"\nweight = {}\nmean = {}\nstandard_errors = {}\n", state.name,
                  state.weight, list_text(in_units(state.mean, units)), list_text(in_units(errors, units)));
  text += "correlations = [\n";
  for (Eigen::Index i = 1; i < errors.size(); ++i) {
    std::vector<double> row;
    for (Eigen::Index k = 0; k < i; ++k) {
      const double both = errors[i] * errors[k];
      row.push_back(both > 0 ? state.covariance(i, k) / both : 0);
    }
    text += list_text(row) + ",\n";
  }
  text += fmt::format("]\nwidening = {}\nmoved = [\n", state.widening);
  for (Eigen::Index k = 0; k < state.moved.cols(); ++k) text += list_text(in_units(state.moved.col(k), units)) + ",\n";
  return text + "]\n";
}

// --- read ---

[[noreturn]] void refuse_file(const TomlDocument& document, TextSpan span, std::string message) {
  refuse("posterior-wrong", std::move(message),
         "do not edit a posterior: learn the model anew, as its file is written then", document.place(span));
}

const TomlValue& entry(const TomlDocument& document, const TomlValue& table, std::string_view key,
                       TomlValue::Kind kind) {
  const TomlEntry* const found = table.find(key);
  if (found == nullptr) refuse_file(document, table.span, fmt::format("{} is missing", key));
  if (found->value.kind != kind) {
    refuse_file(document, found->value.span,
                fmt::format("{} is {}, not {}", key, name_of(found->value.kind), name_of(kind)));
  }
  return found->value;
}

double number(const TomlDocument& document, const TomlValue& value) {
  if (value.kind != TomlValue::Kind::number || !std::isfinite(value.number))
    refuse_file(document, value.span, "this is no number");
  return value.number;
}

double number(const TomlDocument& document, const TomlValue& table, std::string_view key) {
  return number(document, entry(document, table, key, TomlValue::Kind::number));
}

struct Bounds {
  double lower = 0, upper = 0;
};

double number_within(const TomlDocument& document, const TomlValue& value, const Bounds& bounds) {
  const double x = number(document, value);
  if (!(x >= bounds.lower && x <= bounds.upper)) {
    refuse_file(document, value.span,
                fmt::format("{:.6g} cannot be here: {:.6g} to {:.6g} can", x, bounds.lower, bounds.upper));
  }
  return x;
}

double number_within(const TomlDocument& document, const TomlValue& table, std::string_view key, const Bounds& bounds) {
  return number_within(document, entry(document, table, key, TomlValue::Kind::number), bounds);
}

void check_within(const TomlDocument& document, const TomlValue& list, const std::vector<Bounds>& bounds) {
  for (std::size_t i = 0; i < list.items.size(); ++i) number_within(document, list.items[i], bounds[i]);
}

Eigen::VectorXd numbers(const TomlDocument& document, const TomlValue& list, std::size_t count) {
  if (list.kind != TomlValue::Kind::array || list.items.size() != count) {
    refuse_file(document, list.span, fmt::format("{} numbers belong here", count));
  }
  Eigen::VectorXd all(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) all[static_cast<Eigen::Index>(i)] = number(document, list.items[i]);
  return all;
}

// Null: the physics has no such number.
const physics::ParameterSpec* spec_of(const Unknown& unknown) {
  const std::size_t effect = physics::effect_index(unknown.effect);
  if (effect >= physics::kEffects) return nullptr;
  for (const physics::ParameterSpec& spec : physics::effect_infos()[effect].parameters) {
    if (spec.key == unknown.key) return &spec;
  }
  return nullptr;
}

// How far the catalogue lets a number go, in its unit.
double reach_of(const physics::ParameterSpec& spec) {
  return std::max({std::abs(spec.lower), std::abs(spec.upper), 1.0});
}

// So many times as far for each.
std::vector<double> reach_of(const Unknowns& unknowns, double times) {
  std::vector<double> reach;
  for (const Unknown& unknown : unknowns) reach.push_back(times * reach_of(*spec_of(unknown)));
  return reach;
}

// Between minus a reach and the reach; or from zero on.
std::vector<Bounds> bounds_of(const std::vector<double>& reach, bool from_zero) {
  std::vector<Bounds> bounds;
  for (const double each : reach) bounds.push_back({from_zero ? 0 : -each, each});
  return bounds;
}

// Of an unknown that the physics has; its start is the model's number.
void read_unknown(const TomlDocument& document, const TomlValue& row, Unknowns& unknowns) {
  Unknown like;
  like.effect = entry(document, row, "effect", TomlValue::Kind::text).text;
  like.key = entry(document, row, "key", TomlValue::Kind::text).text;
  if (row.find("index") != nullptr) like.index = static_cast<int>(number(document, row, "index"));
  if (row.find("row") != nullptr) like.row = static_cast<int>(number(document, row, "row"));
  const std::size_t effect = physics::effect_index(like.effect);
  const physics::ParameterSpec* const spec = spec_of(like);
  if (spec == nullptr || like.index < -1 || like.index >= spec->size())
    refuse_file(document, row.span, fmt::format("no effect {} has such a number {}", like.effect, like.key));
  const std::size_t rows = unknowns.forces().instances_of(effect).size();
  if (like.row < 0 || (like.row > 0 && static_cast<std::size_t>(like.row) >= rows))
    refuse_file(document, row.span, fmt::format("the model has no row {} of the effect {}", like.row, like.effect));
  if (row.find("prior_sigma") != nullptr) {
    const double reach = reach_of(*spec);
    like.sigma =
        number_within(document, row, "prior_sigma", {kSmallestSigma * reach, kLargestError * reach}) * spec->unit.si;
  }
  for (const Unknown& other : unknowns) {
    if (other.effect == like.effect && other.key == like.key && other.index == like.index && other.row == like.row)
      refuse_file(document, row.span, fmt::format("{} of {} stands here twice", like.key, like.effect));
  }
  add_like(unknowns, like);
}

// Row by row, below the diagonal. Numbers that no errors have together give variances below zero.
Eigen::MatrixXd read_correlations(const TomlDocument& document, const TomlValue& rows, std::size_t size) {
  if (rows.items.size() + 1 != std::max<std::size_t>(size, 1))
    refuse_file(document, rows.span, fmt::format("{} rows belong here", size - 1));
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd all = Eigen::MatrixXd::Identity(n, n);
  for (std::size_t i = 1; i < size; ++i) {
    const TomlValue& row = rows.items[i - 1];
    const Eigen::VectorXd of_row = numbers(document, row, i);
    check_within(document, row, std::vector<Bounds>(i, {-1 - kOddCorrelation, 1 + kOddCorrelation}));
    const auto r = static_cast<Eigen::Index>(i);
    all.row(r).head(r) = of_row.transpose();
    all.col(r).head(r) = of_row;
  }
  if (size < 2) return all;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(all, Eigen::EigenvaluesOnly);
  if (!(parts.eigenvalues()[0] > -kOddMatrix))
    refuse_file(document, rows.span, "no errors have these correlations together");
  return all;
}

PosteriorState read_state(const TomlDocument& document, const TomlValue& row, const Unknowns& unknowns) {
  using Kind = TomlValue::Kind;
  const std::size_t size = unknowns.size();
  const std::vector<double> si = units_of(unknowns);
  const Eigen::Map<const Eigen::VectorXd> units(si.data(), static_cast<Eigen::Index>(size));
  PosteriorState state;
  state.name = entry(document, row, "name", Kind::text).text;
  state.weight = number_within(document, row, "weight", {0, 1});
  const TomlValue& mean = entry(document, row, "mean", Kind::array);
  state.mean = numbers(document, mean, size).cwiseProduct(units);
  check_within(document, mean, bounds_of(reach_of(unknowns, kLargestMean), false));
  const std::vector<double> reach = reach_of(unknowns, kLargestError);
  const TomlValue& standard_errors = entry(document, row, "standard_errors", Kind::array);
  const Eigen::VectorXd errors = numbers(document, standard_errors, size).cwiseProduct(units);
  check_within(document, standard_errors, bounds_of(reach, true));
  state.covariance = errors.asDiagonal() *
                     read_correlations(document, entry(document, row, "correlations", Kind::array), size) *
                     errors.asDiagonal();
  state.widening = number_within(document, row, "widening", {1, kLargestWidening});
  const TomlValue& moved = entry(document, row, "moved", Kind::array);
  state.moved.resize(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(moved.items.size()));
  for (std::size_t k = 0; k < moved.items.size(); ++k) {
    state.moved.col(static_cast<Eigen::Index>(k)) = numbers(document, moved.items[k], size).cwiseProduct(units);
    check_within(document, moved.items[k], bounds_of(reach, false));
  }
  return state;
}

void check_states(const TomlDocument& document, const Posterior& posterior) {
  const double weights = std::accumulate(posterior.states.begin(), posterior.states.end(), 0.0,
                                         [](double sum, const PosteriorState& s) { return sum + s.weight; });
  const bool positive = std::all_of(posterior.states.begin(), posterior.states.end(),
                                    [](const PosteriorState& s) { return s.weight > 0; });
  if (!positive || std::abs(weights - 1) > 1e-6)
    refuse_file(document, {0, 1}, "the weights of its states do not sum to one");
}

// Of the name in a model.
std::string beside(const std::string& model_path, const std::string& name) {
  return (path_of(model_path).parent_path() / path_of(name)).generic_string();
}

[[noreturn]] void refuse_unnamed(const machine::MachineModel& machine, TextSpan span) {
  refuse("posterior-wrong", "[posterior] of the model names no file", std::string(kOther),
         machine.document.place(span));
}

}  // namespace

std::string posterior_text(const Posterior& posterior, std::uint64_t numbers) {
  std::string text = fmt::format(
      "plumbline = \"{}\"\nmodel = \"{}\" # hash of the numbers that it belongs to\nprovenance = \"{}\"\n"
      "set_up = \"ball x and y and the length of the bar free on each circle\"\n"
      "noise_radial_um = {}\nnoise_torque_Nm = {}\nunexplained_um = {}\n",
      kMarker, to_hex(numbers), posterior.made_by, posterior.noise.radial / kUm, posterior.noise.torque,
      posterior.unexplained / kUm);
  for (const Unknown& unknown : posterior.unknowns) text += unknown_text(unknown);
  const std::vector<double> units = units_of(posterior.unknowns);
  for (const PosteriorState& state : posterior.states) text += state_text(state, units);
  return text;
}

Posterior parse_posterior(std::string text, std::string file, const machine::MachineModel& machine) {
  using Kind = TomlValue::Kind;
  const TomlDocument document = parse_toml(std::move(text), std::move(file));
  const TomlEntry* const marker = document.root.find("plumbline");
  if (marker == nullptr || marker->value.text != kMarker)
    refuse_file(document, {0, 1}, "this is no posterior that this version reads");
  const TomlValue& model = entry(document, document.root, "model", Kind::text);
  if (model.text != to_hex(machine::numbers_hash(machine))) {
    refuse("posterior-other-model", "this posterior belongs to a model with other numbers", std::string(kOther),
           document.place(model.span));
  }
  Unknowns unknowns{physics::ForceModel(machine)};
  for (const TomlValue& row : entry(document, document.root, "unknown", Kind::array).items)
    read_unknown(document, row, unknowns);
  Posterior posterior(std::move(unknowns));
  posterior.made_by = entry(document, document.root, "provenance", Kind::text).text;
  posterior.noise = {number_within(document, document.root, "noise_radial_um", {0, kLargestNoise}) * kUm,
                     number_within(document, document.root, "noise_torque_Nm", {0, kLargestNoise})};
  posterior.unexplained = number_within(document, document.root, "unexplained_um", {0, kLargestNoise}) * kUm;
  for (const TomlValue& row : entry(document, document.root, "state", Kind::array).items)
    posterior.states.push_back(read_state(document, row, posterior.unknowns));
  check_states(document, posterior);
  return posterior;
}

std::string posterior_named_in(const std::string& model_path) try {
  std::error_code none;
  if (model_path.empty() || !std::filesystem::is_regular_file(path_of(model_path), none)) return {};
  if (std::filesystem::file_size(path_of(model_path), none) > kLargestModel) return {};
  const TomlDocument document = parse_toml(read_text(model_path), model_path);
  const TomlEntry* const posterior = document.root.find("posterior");
  const TomlEntry* const file = posterior == nullptr ? nullptr : posterior->value.find("file");
  if (file == nullptr || file->value.text.empty()) return {};
  return beside(model_path, file->value.text);
} catch (const Refusal&) {
  return {};  // whoever reads the model says why
}

Posterior known_of(const machine::MachineModel& machine) {
  const machine::ModelValue& named = machine.value("posterior", "file");
  if (!named.given()) {
    if (const TomlEntry* const table = machine.document.root.find("posterior"))
      refuse_unnamed(machine, table->key_span);
    return prior_of(machine);
  }
  if (named.text.empty()) refuse_unnamed(machine, named.span);
  const std::string path = beside(machine.document.file, named.text);
  std::error_code unreadable;
  const std::filesystem::file_status status = std::filesystem::status(path_of(path), unreadable);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    refuse("posterior-wrong", fmt::format("{} is a folder, a pipe or a device, and no posterior", path),
           std::string(kOther), machine.document.place(named.span));
  }
  if (!std::filesystem::exists(status)) {
    refuse("file-missing", fmt::format("the model names {} as its posterior, and there is no such file", path),
           "put it beside the model: what learns a model writes both, and both go together; or take [posterior] out of "
           "the model, whose errors are then those of [uncertainty]",
           machine.document.place(named.span));
  }
  std::string text = read_text(path);
  if (to_hex(fnv1a(text)) != machine.value("posterior", "hash").text) {
    refuse("posterior-other-file", fmt::format("{} is not the posterior that the model names", path),
           std::string(kOther), machine.document.place(named.span));
  }
  return parse_posterior(std::move(text), path, machine);
}

}  // namespace plumbline::identify
