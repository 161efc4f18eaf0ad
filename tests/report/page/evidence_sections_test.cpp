#include "report/page/evidence_sections.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "support/diagnosis.hpp"
#include "support/page_sections.hpp"

namespace plumbline::report {
namespace {

TEST_CASE("odds are told in plain words") {
  CHECK(odds_words(std::log(1.5)) == "1.5 times as likely");
  CHECK(odds_words(std::log(1234.0)) == "about 1,200 times as likely");
  CHECK(odds_words(std::log(999999.0)) == "about 1,000,000 times as likely");
  CHECK(odds_words(50) == "more than a million times as likely");
  CHECK(odds_words(-std::log(20.0)) == "about 20 times less likely");
  CHECK(odds_words(-1000) == "more than a million times less likely");
}

TEST_CASE("evidence is shown in powers of ten, those not ruled out marked") {
  const std::vector<Json> sections = evidence_sections(testing::small_diagnosis());
  REQUIRE(sections.size() == 2);
  const Json& bars = sections[0];
  CHECK(bars["unit"] == "powers of ten");
  const double tens = testing::row_of(bars, "backlash")["bars"][0]["value"];
  CHECK(tens == Approx(50 / std::log(10)));
  CHECK(testing::row_of(bars, "cyclic")["bars"][0]["style"] == 2);
  CHECK(testing::row_of(bars, "cable")["bars"][0]["style"] == 1);
  CHECK(bars["references"][0]["value"].get<double>() == Approx(9.5 / std::log(10)));
  const Json row = testing::row_of(sections[1], "backlash");
  CHECK(row[3].get<double>() == Approx(31.5 / std::log(10)));
  CHECK(row[4].get<double>() == Approx(33.5 / std::log(10)));
  CHECK(row[2] == "more than a million");
  CHECK(testing::row_of(sections[1], "cable")[2] == "1 / 2.7");
  CHECK(testing::row_of(sections[1], "cyclic")[3] == "not computed");
  for (const Json& section : sections) CHECK_FALSE(testing::says(section, "odds"));
}

TEST_CASE("without evidence there is nothing to show") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.evidence.clear();
  CHECK(evidence_sections(d).empty());
}

}  // namespace
}  // namespace plumbline::report
