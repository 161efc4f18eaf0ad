#include "report/measured/circularity_text.hpp"

#include <numbers>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace plumbline;

namespace {

jobs::CircularityTable a_pair() {
  jobs::CircularityTable table;
  table.runs.push_back({"left", {12.345e-6, 11e-6, 6.5e-6, -5.5e-6, {}}, {{2, 3e-6, std::numbers::pi / 2}}});
  table.runs.push_back({"right", {8e-6, 7.25e-6, 1e-12, -1e-12, {}}, {}});
  table.pairs.push_back({"left", "right", {14e-6, 14.5e-6, -2e-6}});
  return table;
}

}  // namespace

TEST_CASE("figures of runs and pairs are written in um, and nil without a sign") {
  CHECK(report::circularity_text(a_pair()) ==
        "run                       circularity         G     F max     F min   um\n"
        "left                            12.35     11.00      6.50     -5.50\n"
        "right                            8.00      7.25      0.00      0.00\n"
        "\n"
        "both directions                            G(b)         D   um\n"
        "left, right                               14.00     -2.00\n");
}

TEST_CASE("without pairs there is one table") {
  jobs::CircularityTable table = a_pair();
  table.pairs.clear();
  const std::string text = report::circularity_text(table);
  CHECK(text.ends_with("right                            8.00      7.25      0.00      0.00\n"));
  CHECK(text.find("both directions") == std::string::npos);
  CHECK(nlohmann::json::parse(report::circularity_json(table))["pairs"] == nlohmann::json::array());
}

TEST_CASE("figures as JSON have their waves in um and deg") {
  const nlohmann::json json = nlohmann::json::parse(report::circularity_json(a_pair()));
  CHECK(json["plumbline"] == "circularity 1");
  const nlohmann::json& left = json["runs"][0];
  CHECK(left["circularity_um"].get<double>() == Approx(12.345));
  CHECK(left["G_um"].get<double>() == Approx(11));
  CHECK(left["F_max_um"].get<double>() == Approx(6.5));
  CHECK(left["F_min_um"].get<double>() == Approx(-5.5));
  CHECK(left["harmonics"][0]["order"] == 2);
  CHECK(left["harmonics"][0]["amplitude_um"].get<double>() == Approx(3));
  CHECK(left["harmonics"][0]["phase_deg"].get<double>() == Approx(90));
  const nlohmann::json& pair = json["pairs"][0];
  CHECK(pair["ccw"] == "left");
  CHECK(pair["cw"] == "right");
  CHECK(pair["G_b_um"].get<double>() == Approx(14));
  CHECK(pair["G_b_least_squares_um"].get<double>() == Approx(14.5));
  CHECK(pair["D_um"].get<double>() == Approx(-2));
}
