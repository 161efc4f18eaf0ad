// How these stand in the whole page is in diagnosis_page_test.cpp.
#include "report/page/where_svg.hpp"

#include <catch2/catch.hpp>

#include "report/page/svg.hpp"
#include "support/diagnosis.hpp"

using namespace plumbline;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("the map of the circle has a square for each wave and each twelfth") {
  const std::string map = report::circle_map(testing::small_diagnosis());
  std::size_t squares = 0;
  for (std::size_t at = map.find("<title>"); at != std::string::npos; at = map.find("<title>", at + 1)) ++squares;
  CHECK(squares == 10 + 12);
  CHECK(holds(map, "<title>bar, order 2: 10.00 times the noise</title>"));
  CHECK(holds(map, "<title>bar, order 3: 0.00 times the noise</title>"));
  CHECK(holds(map, "<title>bar, 90 to 120 deg: 10.00 times the noise</title>"));
  CHECK(map.ends_with("</svg>"));
}

TEST_CASE("pairs and groups are in times of the noise, torques of all motors together") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.noise.channels[2] = {0.35, 0, 120, 0};  // with 0.05 of the first: sqrt((0.0025 + 0.1225) / 2) = 0.25
  const auto cell = [](double times, const char* text) {
    return "<td style=\"background:" + report::heat(times) + "\">" + text + "</td>";
  };
  d.gap_map.contrasts[0].differs = {2e-6, 0.5};
  CHECK(holds(report::contrast_table(d), "<tr><td>direction</td><td>2</td>" + cell(1, "1.00") + cell(0.2, "0.20") +
                                             cell(4, "4.00") + cell(2, "2.00") + "<td>0.00</td><td>0.00</td></tr>"));
  d.gap_map.groups = {{diagnose::Grouping::feed, 1000, 1000, 3, {1e-6, 0.25}},
                      {diagnose::Grouping::start, 0.5, 2.25, 1, {0, 0}},
                      {diagnose::Grouping::payload, 12.5, 12.5, 2, {0, 0}}};
  const std::string groups = report::group_table(d);
  CHECK(holds(groups, "<tr><td>feed F1000</td><td>3</td>" + cell(2, "2.00") + cell(1, "1.00") + "</tr>"));
  CHECK(holds(groups, "<td>begun 0.5 to 2.2 h</td><td>1</td>"));
  CHECK(holds(groups, "<td>payload 12.5 kg</td>"));
}

TEST_CASE("what was not measured is a dash in the tables") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.noise.channels[identify::kRadial] = {};
  CHECK(holds(report::group_table(d), "<td>tilt 0 to 5 deg</td><td>2</td><td>-</td><td style="));
  d.noise.channels[1] = {};
  CHECK(holds(report::group_table(d), "<td>2</td><td>-</td><td>-</td></tr>"));
}

TEST_CASE("bars of circularity reach as far as the largest, and there are none of nothing") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  const std::string bars = report::circularity_bars(d);  // 20, 9 and 4 um: 500, 225 and 100 px
  CHECK(holds(bars, "width=\"500.0\""));
  CHECK(holds(bars, "width=\"225.0\""));
  CHECK(holds(bars, "width=\"100.0\""));
  CHECK(holds(bars, ">first</text>"));
  d.runs[0].circularity.reset();
  CHECK(report::circularity_bars(d).empty());
}
