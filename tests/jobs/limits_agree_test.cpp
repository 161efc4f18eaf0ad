// check and compensate find the same limits broken, up to the edge.
#include <array>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "jobs/check.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

// A limit of the model, moved until the program breaks it.
struct Edge {
  std::string_view key;   // a line of the model
  std::string_view line;  // as it is to be written
  double kept, broken;
};
constexpr std::array kEdges{Edge{"length_max_mm = 1900", "length_max_mm = {:.6f}", 1900, 800},
                            Edge{"length_min_mm = 700", "length_min_mm = {:.6f}", 700, 1800},
                            Edge{"tilt_deg = 25", "tilt_deg = {:.6f}", 25, 0},
                            Edge{"x_mm = [-300, 300]", "x_mm = [-300, {:.6f}]", 300, -290},
                            Edge{"z_mm = [-1250, -800]", "z_mm = [-1250, {:.6f}]", -800, -1200}};

class OnTheEdge {
 public:
  OnTheEdge(const std::string& dialect, const std::string& text) {
    options_.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
    options_.dialect = dialect;
    options_.program.tool_in_spindle = 1;
    options_.program.free_rotation = nc::FreeRotation::c_stays;
    options_.program.feed_rule = nc::FeedRule::xyz_first;
    options_.paths.tools =
        scratch_.file("tools.toml", "plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = 0\n");
    program_ = scratch_.file("p.nc", text);
  }

  bool check_breaks(const Edge& edge, double limit) {
    move(edge, limit);
    return jobs::check_file(program_, options_).violations > 0;
  }
  bool compensate_breaks(const Edge& edge, double limit) {
    move(edge, limit);
    const Diagnostic said =
        testing::refusal_of([&] { jobs::compensate_file(program_, scratch_.path("out.nc"), options_); });
    INFO(said.code << ": " << said.message);
    CHECK((said.code.empty() || said.code.starts_with("limit-") || said.code == "compensate-unreachable"));
    return !said.code.empty();
  }

 private:
  void move(const Edge& edge, double limit) {
    std::string text = model_;
    text.replace(text.find(edge.key), edge.key.size(), fmt::format(fmt::runtime(edge.line), limit));
    options_.paths.model = scratch_.file("model.toml", text);
  }

  const testing::Scratch scratch_;
  const std::string model_ = read_text(testing::source_file("models/pm600-like.toml"));
  settings::Options options_;
  std::string program_;
};

constexpr double kFine = 1e-4;  // mm and deg: far below what a correction of other axes moves

// The edge is sought by halves with one command; the other one must see it in the same place.
void check_same_edge(const std::string& dialect, const std::string& text) {
  INFO(dialect << "\n" << text);
  OnTheEdge program(dialect, text);
  for (const Edge& edge : kEdges) {
    INFO(edge.key);
    double kept = edge.kept;
    double broken = edge.broken;
    REQUIRE_FALSE(program.compensate_breaks(edge, kept));
    if (!program.compensate_breaks(edge, broken)) continue;
    while (std::abs(kept - broken) > kFine) {
      const double middle = (kept + broken) / 2;
      (program.compensate_breaks(edge, middle) ? broken : kept) = middle;
    }
    INFO("kept at " << kept << ", broken at " << broken);
    CHECK_FALSE(program.check_breaks(edge, kept + (kept - broken)));
    CHECK(program.check_breaks(edge, broken - (kept - broken)));
  }
}

}  // namespace

TEST_CASE("check finds a limit broken where compensate does: lines, rapids, turns") {
  check_same_edge("linuxcnc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 X50 Y20 A10 F1000\nB5 C-4\nM2\n");
  check_same_edge("linuxcnc", "G0 X-80 Y0 Z0 A12 B0 C0\nG0 X80 Y60 A-12 B4\nG1 Z-5 F500\nM2\n");
  check_same_edge("linuxcnc", "G0 X0 Y0 Z0 A8 B0 C0\nG93 G1 X5 A-8 F2\nA0 B9 F3\nG94\nM2\n");
}

TEST_CASE("check finds a limit broken where compensate does: arcs whose middle goes furthest, splines") {
  check_same_edge("linuxcnc", "G0 X0 Y0 Z0 A0 B0 C0\nG2 X0 Y40 I30 J20 F1000\nM2\n");
  check_same_edge("linuxcnc", "G0 X-60 Y0 Z0 A6 B0 C0\nG18 G3 X60 Z0 I60 K0 F1000\nG17 G3 I5 A-6\nM2\n");
  check_same_edge("linuxcnc", "G0 X0 Y0 Z0 A0 B0 C0\nF900\nG5 X0 Y50 I60 J0 P60 Q0\nM2\n");
}

TEST_CASE("check finds a limit broken where compensate does: cycles that are expanded and cycles that stay") {
  check_same_edge("linuxcnc", "G0 X0 Y0 Z20 A4 B0 C0\nF300\nG98 G83 X40 Y10 Z-20 R2 Q5\nX70\nG80\nM2\n");
  check_same_edge("linuxcnc", "G0 X0 Y0 Z20 A4 B0 C0\nM3 S500\nF300\nG98 G86 X40 Y10 Z-3 R2 P0.5\nX60\nG80\nM2\n");
  check_same_edge("fanuc",
                  "O1\nG54\nG0 X0. Y0. Z20. A0. B0. C0.\nM3 S500\nG99 G85 X40. Y10. Z-3. R2. F300.\nX60.\nG80\nM30\n");
}

TEST_CASE("check corrects on a tilted plane the axes that compensate corrects there") {
  const std::string fanuc = "O1\nG21 G17 G90 G54 G94\nG43 H1\nG0 X0. Y0. Z50. A0. B0. C0.\n";
  check_same_edge("fanuc", fanuc +
                               "G68.2 X10. Y5. Z0. I30. J15. K-20.\nG53.1\nG0 X0. Y0. Z20.\nG1 Z-2. F500.\n"
                               "X60.\nG69\nM30\n");
  check_same_edge("fanuc", fanuc +
                               "G68.2 X0. Y0. Z0. I90. J10. K-90.\nG53.1\nG0 X0. Y0. Z20.\nG1 Z-2. F500.\n"
                               "G3 X0. Y40. I30. J20.\nG69\nM30\n");
  check_same_edge("siemens",
                  "G54 G17 G90 G71 G94\nD1\nG0 X0 Y0 Z60 A0 B0 C0\n"
                  "CYCLE800(1,\"TABLE\",0,57,0,0,0,8,-10,0,0,0,0,-1)\nG0 X5 Y5 Z20\nG1 Z-1 F600\n"
                  "G2 X35 Y-5 CR=30\nG0 Z40\nCYCLE800()\nG0 X0 Y0 Z60 A0 B0 C0\nM30\n");
}
