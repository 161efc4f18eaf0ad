#include "diagnose/bar_gain.hpp"

#include <catch2/catch.hpp>

#include "diagnose/hidden.hpp"
#include "diagnose/usual_noise.hpp"

namespace plumbline::diagnose {
namespace {

void read_by(testing::Hidden& hidden, double factor) {
  for (measure::Run& run : hidden.runs) {
    for (double& reading : run.radial) reading *= factor;
  }
}

// Numbers of all struts, and those numbers fitted as if nothing else were missing.
Model found(const testing::Hidden& hidden, const char* effect, const char* key, int count) {
  Pick pick{&hidden.candidates.candidate(effect), 0, {}, {}};
  for (int i = 0; i < count; ++i) {
    pick.column_groups.push_back(i);
    pick.unknowns.push_back(hidden.candidates.unknowns.find(effect, key, count > 1 ? i : -1));
  }
  Model model;
  model.noise = testing::usual_noise();
  model.fit = refit(hidden.bench(), {pick}, hidden.candidates.unknowns.start(), model.noise);
  Found one;
  one.pick = pick;
  model.found = {one};
  return model;
}

}  // namespace

TEST_CASE("readings of a bar times 1.5 are told from struts that give way more") {
  testing::Hidden hidden("backlash", "width_um", 2, 0);
  read_by(hidden, 1.5);
  const Model model = found(hidden, "strut-compliance", "compliance_um_N", 6);
  const std::optional<BarGain> bar = bar_gain(hidden.bench(), model);
  REQUIRE(bar);
  CHECK(bar->factor == Approx(1.5).margin(0.05));
  CHECK(bar->nats > 12);
  const std::optional<Doubt> doubt = doubt_of_bar(hidden.bench(), model);
  REQUIRE(doubt);
  CHECK(doubt->effects == std::vector<std::string>{"strut-compliance"});
}

TEST_CASE("beside an effect that is there, a factor of the bar is found as well") {
  testing::Hidden hidden("platform-mass", "mass_kg", -1, 8);
  read_by(hidden, 0.6);
  const std::optional<BarGain> bar = bar_gain(hidden.bench(), found(hidden, "platform-mass", "mass_kg", 1));
  REQUIRE(bar);
  CHECK(bar->factor == Approx(0.6).margin(0.05));
}

TEST_CASE("an effect that explains the readings is not doubted, nor is nothing, nor motors alone") {
  testing::Hidden hidden("platform-mass", "mass_kg", -1, 8);
  const Model model = found(hidden, "platform-mass", "mass_kg", 1);
  CHECK_FALSE(doubt_of_bar(hidden.bench(), model));
  CHECK_FALSE(doubt_of_bar(hidden.bench(), Model{}));
  read_by(hidden, 1.5);
  for (measure::Run& run : hidden.runs) run.radial.clear();
  CHECK_FALSE(doubt_of_bar(hidden.bench(), model));
}

TEST_CASE("a factor that an instrument may be off by is left alone") {
  testing::Hidden hidden("platform-mass", "mass_kg", -1, 8);
  read_by(hidden, 1.1);
  CHECK_FALSE(doubt_of_bar(hidden.bench(), found(hidden, "platform-mass", "mass_kg", 1)));
}

}  // namespace plumbline::diagnose
