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
