#include "report/measured/diagnosis_text.hpp"

#include <catch2/catch.hpp>

#include "support/diagnosis.hpp"

using namespace plumbline;

namespace {

bool says(const diagnose::Diagnosis& diagnosis, const std::string& line) {
  std::string text = "\n";
  text += report::diagnosis_text(diagnosis);
  return text.find("\n" + line) != std::string::npos;
}

}  // namespace

TEST_CASE("a diagnosis is told from its verdict to what compensation gains") {
  CHECK(report::diagnosis_text(testing::small_diagnosis()) ==
        "named: one of backlash, cyclic\n"
        "  backlash (50 nats, threshold 9.5)\n"
        "    these data do not tell it from cyclic\n"
        "    width_um = 4.1 +- 0.1, 0\n"
        "(nats are natural logarithms of odds: with 7 nats an effect is a thousand times as likely as without)\n"
        "not ruled out: backlash, cyclic\n"
        "fitted     bar 3.10 -> 0.60 um (noise 0.50), torque 0.060 -> 0.050 N m (noise 0.050)\n"
        "held out   bar 3.00 -> 0.70 um (noise 0.50), torque 0.060 -> 0.050 N m (noise 0.050)\n"
        "circles    as measured 20.0 um, compensated with the model as given 9.0, with what was found 4.0 (means of "
        "1)\n");
}

TEST_CASE("where nothing is missing, what the runs could have shown is told") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.verdict = diagnose::Verdict::nothing_missing;
  d.effects.clear();
  d.confidence_set.clear();
  d.visible = {
      {"backlash", "width_um", "um", 3.21, true}, {"cable", "", "", 0, false}, {"cyclic", "share", "", 0.5, true}};
  CHECK(says(d, "nothing-missing, as far as these runs can show\n"));
  CHECK(says(d, "these runs tell nothing of, at any size: cable\n"));
  CHECK(says(d, "what they would have named with 95 %, from this size on: backlash 3.2 um, cyclic 0.5\n"));
  CHECK_FALSE(says(d, "not ruled out"));
  CHECK_FALSE(says(d, "(nats"));
  d.runs.resize(1);
  CHECK(says(d, "one run tells nothing of, at any size: cable\n"));
}

TEST_CASE("doubt, a remainder, the next test and a model that stays are told where there are any") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.verdict = diagnose::Verdict::unknown;
  d.doubt = diagnose::Doubt{{"backlash"}, diagnose::OneMore{}};
  d.remainder = diagnose::Remainder{12.4, diagnose::Recurs{diagnose::Recurring{6, 0.75, {}}, {}}};
  d.next = {{"cyclic", {}}};
  d.withheld = diagnose::StrainedTogether{7};
  CHECK(says(d, "unknown: there is a gap, and no effect of the catalogue is it\n"));
  CHECK(says(d, "backlash is not enough: one more effect would pass the threshold\n"));
  CHECK(says(d,
             "not explained by the catalogue (a description, not a cause; strength 12):\nwhat is left of the readings "
             "of the bar "));
  CHECK(says(d, "no circular test separates it from cyclic\n"));
  CHECK(says(d, "the model stays as it was given: all that [uncertainty] lists would be further off together "));
}

TEST_CASE("what was not measured has no numbers in the words of a diagnosis") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.fit.before.radial = d.fit.after.radial = std::nullopt;
  d.held_out = {};
  for (diagnose::RunGap& run : d.runs) run.circularity.reset();
  CHECK(says(d, "fitted     bar not measured, torque 0.060 -> 0.050 N m (noise 0.050)\n"));
  CHECK_FALSE(says(d, "held out"));
  CHECK_FALSE(says(d, "circles"));
}

TEST_CASE("the headline gives the whole set, and an effect beside it") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  CHECK(report::headline(d) == "named: one of backlash, cyclic");
  d.confidence_set = {"backlash"};
  CHECK(report::headline(d) == "named: backlash");
  d.effects.push_back({"level", {}, {}, 20});
  CHECK(report::headline(d) == "named: backlash; and level");
  d.confidence_set = {"backlash", "cyclic"};
  CHECK(report::headline(d) == "named: one of backlash, cyclic; and level");
  d.confidence_set = {"backlash", "level", "cyclic"};
  CHECK(report::headline(d) == "named: two of backlash, level, cyclic");
  CHECK(report::names_text(d) == "two of backlash, level, cyclic");
  d.verdict = diagnose::Verdict::unknown;
  CHECK(report::headline(d).starts_with("unknown: "));
}
