// OSP: a tool's length lies along the tool. Where it changes while the tool is tilted, the tip goes elsewhere.
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

Job tilting_osp() {
  Job job = job_of_control("okuma");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  nc::Tool tool;
  tool.number = 2;
  tool.length_mm = 20;
  tool.mass_kg = 0;
  nc::Tool other = tool;
  other.number = 1;
  other.length_mm = 10;
  job.program.tools = nc::ToolTable({other, tool});
  return job;
}

const std::string kOspHead = "G15 H1 G90 G94 G17\nG56 H1 G0 X0 Y0 Z50 A0 B0 C0\nM3 S1000\n";

std::string code_of_tilt(const std::string& lines) { return code_of(kOspHead + lines + "M2\n", tilting_osp()); }

}  // namespace

TEST_CASE("okuma: after a change of length under a tilt X and Y are not known") {
  for (const std::string change : {"G0 A8\nG56 H2 Z40\n", "G0 A8\nG53 Z40\n", "G0 B-6\nG56 H0 Z40\n",
                                   "G0 A8\nG169 H2\nG0 Z40\n", "G0 A3 B3\nG56 H2 Z40\n"}) {
    INFO(change);
    CHECK(code_of_tilt(change + "G1 X5 F100\n") == "compensate-position-unknown");
    CHECK(code_of_tilt(change + "G0 X0 Y0 Z50\nG1 X5 F100\n").empty());
  }
}

TEST_CASE("okuma: a length that changes while the tool is upright, or that stays, leaves the axes known") {
  CHECK(code_of_tilt("G56 H2 Z40\nG1 X5 F100\n").empty());
  CHECK(code_of_tilt("G0 A8\nG0 A0\nG53 Z40\nG1 X5 F100\n").empty());
  CHECK(code_of_tilt("G0 A8\nG56 H1 Z40\nG1 X5 F100\n").empty());
}

TEST_CASE("okuma: what a program never turns stands at zero, and its lengths change upright") {
  CHECK(code_of("G15 H1 G90 G94 G17\nG0 X0 Y0\nG56 H1 Z50\nM3 S1000\nG1 Z40 F100\nM2\n", tilting_osp()).empty());
  Job turned = tilting_osp();
  turned.program.work_offsets[0]->origin[Axis::A] = 5;
  CHECK(code_of("G15 H1 G90 G94 G17\nG0 X0 Y0 Z60 A0 B0 C0\nG56 H1 Z50\nG1 Z40 F100\nM2\n", turned) ==
        "compensate-position-unknown");
}

TEST_CASE("okuma: F has three decimals, or the block is refused") {
  const std::string head = "G15 H1 G90 G94 G17\nG0 X0 Y0 Z50 A0 B0 C0\n";
  Job job = tilting_osp();
  for (const std::string lines : {"G1 X20 A3 F100\nX-20 Y5 B2 F333\n", "G2 X10 Y0 I5 J0 F77.7\nG1 Z40 F1200.5\n"}) {
    const std::string text = run(head + lines + "M2\n", job).text;
    for (std::size_t at = text.find('F'); at != std::string::npos; at = text.find('F', at + 1)) {
      const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
      const std::size_t point = std::min(text.find('.', at), end);
      INFO(text.substr(at, end - at));
      CHECK(end - point <= 4);
    }
  }
  job.settings.step.angle_deg = 20;
  CHECK(code_of(head + "G1 A4 B3 F77\nM2\n", job) == "emit-feed-range");
}

TEST_CASE("fanuc: after G49 under a tilt X, Y and Z are named again before anything cuts") {
  const std::string head = "O1\nG21 G90 G17 G54\nG0 X0. Y0. Z200. A0. B0. C0. S500 M3\nG43 H1 Z50.\nG1 Z49. F100.\n";
  CHECK(code_of(head + "G0 A8.\nG49\nG0 Z60.\nG1 X5.\nM30\n", fanuc_job()) == "compensate-position-unknown");
  CHECK(code_of(head + "G0 A8.\nG49\nG0 X0. Y0. Z60.\nG1 X5.\nM30\n", fanuc_job()).empty());
  CHECK(code_of(head + "G49\nG0 Z60.\nG1 X5.\nM30\n", fanuc_job()).empty());
  CHECK(code_of(head + "G0 A8.\nG0 A0.\nG49\nG0 Z60.\nG1 X5.\nM30\n", fanuc_job()).empty());
}

TEST_CASE("a cycle follows the feed mode of its own block") {
  const std::string holes = "X7.\nX9.\nG80\nG94\nM30\n";
  const std::string head = "O1\nG21 G90 G17 G54\nG0 X0. Y0. Z60. A0. B0. C0. S500 M3\n";
  for (const std::string cycle : {"G95 G84 X5. Y5. Z40. R45. F1.\n", "M29 S500\nG95 G84 X5. Y5. Z40. R45. F1.\n"}) {
    const std::string text = run(head + cycle + holes, fanuc_job()).text;
    INFO(text);
    CHECK(text.find("G95", text.find("G95") + 1) == std::string::npos);
  }
}

TEST_CASE("okuma: where / is taken away behind its name, a line keeps the blank") {
  Job job = tilting_osp();
  job.program.block_delete = false;
  for (const auto& [line, written] : {std::pair{"N10 /X5 F100", "\nN10 "}, {"NAT1 /G1 X5 F100", "\nNAT1 "}}) {
    const std::string text = run(std::string(kOspHead) + "G1 Z49 F100\n" + line + "\nM2\n", job).text;
    INFO(text);
    CHECK(text.find(written) != std::string::npos);
    CHECK(text.find('/') == std::string::npos);
  }
}

TEST_CASE("okuma: a feed a turn has finer decimals than one a minute") {
  const std::string head = "G15 H1 G90 G94 G17\nG0 X0 Y0 Z50 A0 B0 C0\nM3 S1000\n";
  for (const std::string cuts : {"G95\nG1 X1 F.1\nX1.5\nX2 Y3\nX2.2\nX10 Y5\nG94\n", "G95\nG1 Z20 F.5\nG94\n"}) {
    INFO(cuts);
    CHECK(code_of(head + cuts + "M2\n", tilting_osp()).empty());
  }
}
