#include "report/measured/functions_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "support/diagnosis.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using diagnose::LearntFunction;
using Channel = diagnose::Term::Channel;

namespace {

physics::MachineConstants constants() {
  physics::MachineConstants machine =
      physics::ForceModel(machine::read_model(testing::source_file("models/pm600-like.toml"))).machine;
  machine.middle_length.setConstant(1.3);
  return machine;
}

LearntFunction of_length() {
  LearntFunction function;
  function.shape.channel = Channel::length;
  function.shape.coordinates = {7};
  function.part = 2;
  function.least = {{-2.5}, -2.14e-6, 0.3e-6};
  function.most = {{1}, 6e-6, 0.42e-6};
  return function;
}

}  // namespace

TEST_CASE("a function that is a power says which, and whose law that is") {
  LearntFunction function = of_length();
  function.shape.coordinates = {10};
  function.part = -1;
  function.least = {{-0.5}, -5e-6, 0.1e-6};
  function.most = {{2}, 12.7e-6, 0.1e-6};
  function.law = diagnose::PowerLaw{8e-6, 0.1e-6, 0.66, 0.62, 0.7};
  CHECK(report::function_text(function, constants()) ==
        "length of each strut, as a function of its tension: -5 +- 0.1 um at -0.5 kN to +12.7 +- 0.1 um at 2 kN; it is "
        "a power: +8 +- 0.1 um x sign(t) |t / kN|^0.66 (exponent 0.62 to 0.70 with 95 %), the exponent of Hertz's "
        "contacts, which give way at their balls or rollers");
  function.law = diagnose::PowerLaw{-8e-6, 0.1e-6, 1.4, 1.3, 1.5};
  CHECK(report::function_text(function, constants())
            .ends_with("it is a power: -8 +- 0.1 um x sign(t) |t / kN|^1.40 (exponent 1.30 to 1.50 with 95 %)"));
  function.shape.coordinates = {7};
  function.law = diagnose::PowerLaw{8e-6, 0.1e-6, 2.01, 1.9, 2.1};
  CHECK(report::function_text(function, constants()).find("um x (L / L_mid)^2.01 (") != std::string::npos);
  function.shape.channel = Channel::drive;
  function.shape.coordinates = {8};
  function.law = diagnose::PowerLaw{20, 1, 0.5, 0.4, 0.6};
  CHECK(report::function_text(function, constants())
            .ends_with("+20 +- 1 N x sign(v) |v / (10 mm/s)|^0.50 (exponent 0.40 to 0.60 with 95 %)"));
}

TEST_CASE("a function is told by where it is smallest and largest, with its uncertainty") {
  CHECK(report::function_text(of_length(), constants()) ==
        "length of strut 3, as a function of its length: -2.14 +- 0.3 um at 1.05 m to +6 +- 0.42 um at 1.4 m");
  LearntFunction beside = of_length();
  beside.mean_aside = true;
  CHECK(report::function_text(beside, constants()).ends_with("um at 1.4 m, beside its mean"));
  LearntFunction all = of_length();
  all.shape.channel = Channel::drive;
  all.shape.strut_powers[2] = 1;
  all.part = -1;
  all.least = {{0}, -20, 3};
  all.most = {{1}, 40, 5};
  CHECK(report::function_text(all, constants()) ==
        "drive tension of each strut, as a function of its length: -20 +- 3 N at 1.3 m to +40 +- 5 N at 1.4 m, x s");
}

TEST_CASE("a function of the place names its axis and its coordinates") {
  LearntFunction function;
  function.shape.channel = Channel::force;
  function.shape.coordinates = {1, 2, 3};
  function.part = 1;
  function.least = {{-1, 0, 0.5}, -30, 4};
  function.most = {{1, 0.2, 0}, 12, 2};
  CHECK(report::function_text(function, constants()) ==
        "force at the tip, along y, as a function of x, y, z: -30 +- 4 N at x = -100 mm, y = 0 mm, z = -950 mm to "
        "+12 +- 2 N at x = 100 mm, y = 20 mm, z = -1000 mm");
}

TEST_CASE("what is a formula is told as that formula") {
  LearntFunction function;
  function.shape.strut_powers[3] = 2;
  diagnose::Term term;
  term.part = 4;
  term.strut_powers[3] = 2;
  term.cosine = 3e-6;
  function.formula = {term};
  CHECK(report::function_text(function, constants()) == "length_j: [0, 0, 0, 0, 3, 0] um x (t / kN)^2");
}

TEST_CASE("what is corrected all the same stands in text and JSON") {
  diagnose::Diagnosis diagnosis = testing::small_diagnosis();
  CHECK(report::function_lines(diagnosis).empty());
  CHECK(report::diagnosis_text(diagnosis).find("corrected all the same") == std::string::npos);
  diagnosis.functions = {of_length()};
  diagnosis.functions[0].log_odds = 40;
  diagnosis.functions[0].left_out = 30;
  CHECK(report::diagnosis_text(diagnosis).find("\nlength of strut 3, as a function of its length: ") !=
        std::string::npos);
  const auto json = nlohmann::json::parse(report::diagnosis_json(diagnosis));
  REQUIRE(json["functions"].size() == 1);
  CHECK(json["functions"][0]["says"] == report::function_lines(diagnosis)[0]);
  CHECK(json["functions"][0]["log_odds"] == 40);
  CHECK(json["functions"][0]["left_out_nats"] == 30);
}
