#include "report/page/map_page.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

namespace plumbline {
namespace {

using report::Json;

machine::MachineModel map_model(const std::string& without = "") {
  std::string text = read_text(testing::source_file("models/pm600-like.toml"));
  if (!without.empty()) text.resize(text.find(without));
  return machine::parse_model(text, "model.toml");
}

// Two planes, the second tilted so far that it is out of reach: 3 x 2 cells each.
jobs::MapOptions two_tilts() {
  jobs::MapOptions options;
  options.box = {machine::Range{-0.1, 0.1}, machine::Range{0, 0.1}, std::nullopt};
  options.step = 0.1;
  options.planes = {-1};
  options.tilts = {AxisWords{}, AxisWords{{0, 0, 0, 27, 0, 5}}};
  return options;
}

report::Page page_of(const machine::MachineModel& model, const jobs::MapOptions& options,
                     std::vector<jobs::MapCell>* cells = nullptr) {
  report::MapPage page(model, options);
  const jobs::MapSummary summary = jobs::map_workspace(model, options, [&](const jobs::MapCell& cell) {
    page.add(cell);
    if (cells != nullptr) cells->push_back(cell);
  });
  return page.page(summary);
}

const Json& section_of(const report::Page& page, const std::string& type, const std::string& title = "") {
  for (const Json& section : page.sections) {
    if (section["type"] == type && (title.empty() || section["title"] == title)) return section;
  }
  FAIL("there is no section " << type << " " << title);
  return page.sections.front();
}

// The numbers of a packed column, in whole quanta.
std::vector<double> unpacked(const Json& column) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int have = 0;
  for (const char c : column["data"].get<std::string>()) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(letters.find(c));
    have += 6;
    if (have < 8) continue;
    have -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> have));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
    const auto whole = static_cast<std::int32_t>(static_cast<std::uint32_t>(bytes[i]) | bytes[i + 1] << 8 |
                                                 bytes[i + 2] << 16 | static_cast<std::uint32_t>(bytes[i + 3]) << 24);
    numbers.push_back(whole * column["quantum"].get<double>());
  }
  return numbers;
}

TEST_CASE("a map's page has a plane for each Z and tilt, the largest Y at the top") {
  std::vector<jobs::MapCell> cells;
  const report::Page page = page_of(map_model(), two_tilts(), &cells);
  const Json& heat = section_of(page, "heat", "Over the workspace");
  CHECK(heat["columns"]["values"] == Json({-100, 0, 100}));
  CHECK(heat["rows"]["values"] == Json({100, 0}));
  REQUIRE(heat["figures"].size() == 6);
  CHECK(heat["figures"][2]["name"] == "error of the tip, nothing corrected");
  const Json& planes = heat["figures"][2]["planes"];
  REQUIRE(planes.size() == 2);
  CHECK(planes[0]["name"] == "Z -1000 mm A0 B0");
  CHECK(planes[1]["name"] == "Z -1000 mm A27 B0 C5");
  const std::vector<double> values = unpacked(planes[0]["values"]);
  REQUIRE(values.size() == 6);
  for (std::size_t column = 0; column < 3; ++column) {
    CHECK(values[column] == Approx(cells[3 + column].error.norm() / kUm).margin(1e-3));  // Y 100
    CHECK(values[3 + column] == Approx(cells[column].error.norm() / kUm).margin(1e-3));  // Y 0
  }
  for (const double value : unpacked(planes[1]["values"])) CHECK(value < -1e6);  // missing
  CHECK(heat["reasons"] == Json({"out of reach: tilt too large"}));
}

TEST_CASE("a map's page says how far the machine is to be trusted, where it is worst, and what is out of reach") {
  const report::Page page = page_of(map_model(), two_tilts());
  CHECK(page.lead.find("is to be trusted within ") != std::string::npos);
  CHECK(page.lead.find("on 95 % of the reachable box; within ") != std::string::npos);
  const Json& facts = section_of(page, "facts")["rows"];
  CHECK(facts[2]["value"] == 50.0);
  CHECK(facts[3]["note"].get<std::string>().starts_with("at X"));
  const Json& shares = section_of(page, "table", "How much of the reach is within what");
  REQUIRE(shares["rows"].size() == 6);
  CHECK(shares["rows"][5][0] == 100);
  CHECK(shares["rows"][5][1] == facts[3]["value"]);  // all of it: the largest
  CHECK(shares["rows"][5][4] == facts[6]["value"]);  // of the stiffness the least
  CHECK(shares["rows"][0][4] >= shares["rows"][5][4]);
  const Json& limits = section_of(page, "table", "What keeps the machine from the rest");
  CHECK(limits["rows"][0] == Json({"tilt too large", 6.0, 50.0}));
}

TEST_CASE("a map's page shows the worst of each plane, and colours by ratio where figures are spread wide") {
  jobs::MapOptions options = two_tilts();
  options.planes = {-1.2, -1};
  std::vector<jobs::MapCell> cells;
  const report::Page page = page_of(map_model(), options, &cells);
  REQUIRE(cells.size() == 24);
  const Json& heat = section_of(page, "heat", "Plane by plane");
  CHECK(heat["rows"]["labels"] == Json({"A0 B0", "A27 B0 C5"}));
  CHECK(heat["columns"]["values"] == Json({-1200, -1000}));
  const std::vector<double> error = unpacked(heat["figures"][2]["planes"][0]["values"]);
  const std::vector<double> stiffness = unpacked(heat["figures"][3]["planes"][0]["values"]);
  REQUIRE(error.size() == 4);
  double largest = 0;
  double least = 1e30;
  for (std::size_t i = 6; i < 12; ++i) {  // Z -1000, not tilted
    largest = std::max(largest, cells[i].error.norm());
    least = std::min(least, cells[i].stiffness);
  }
  CHECK(error[1] == Approx(largest / kUm).margin(1e-3));
  CHECK(stiffness[1] == Approx(least / 1e6).margin(1e-3));
  CHECK(error[2] < -1e6);  // out of reach
  CHECK_FALSE(heat["figures"][2]["log"].get<bool>());
  options = {};
  options.step = 0.1;
  options.planes = {-0.85};
  options.tilts = {AxisWords{}, AxisWords{{0, 0, 0, -20, 0, 0}}};
  const report::Page wide = page_of(map_model(), options);
  CHECK(section_of(wide, "heat", "Over the workspace")["figures"][2]["log"].get<bool>());
}

TEST_CASE("without [uncertainty] the page claims none") {
  const report::Page page = page_of(map_model("[uncertainty]"), two_tilts());
  CHECK(page.lead.find("no [uncertainty]") != std::string::npos);
  CHECK(section_of(page, "heat", "Over the workspace")["figures"].size() == 4);
}

TEST_CASE("nothing in reach, and more than a page can hold") {
  jobs::MapOptions options = two_tilts();
  options.tilts.erase(options.tilts.begin());
  const report::Page page = page_of(map_model(), options);
  CHECK(page.lead == "Nothing of this box is in reach of the machine.");
  options.step = 0.0002;
  CHECK(testing::refusal_of([&] { report::MapPage(map_model(), options); }).code == "map-page");
}

}  // namespace
}  // namespace plumbline
