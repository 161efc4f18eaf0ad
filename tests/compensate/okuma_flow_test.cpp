// Programs of an OSP that are written out: their labels, the F of arcs, and F between holes.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

TEST_CASE("a label of an OSP stands once where a program is written out, and arcs of pieces below a grid keep one F") {
  const Job job = job_of_control("okuma");
  const std::string begin = "G15 H1\nG90 G0 X0 Y0 Z5 A0 B0 C0\n";
  const auto written = [&](const std::string& text) { return run(begin + text, job).text; };
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  const std::string loop = written("VC1=0\nNLP G1 X=VC1 F500\nVC1=VC1+1\nIF [VC1 LT 3] NLP\nN9 X9\nM2\n");
  INFO(loop);
  CHECK(count(loop, "NLP") == 1);
  CHECK(count(loop, "N9 ") == 1);
  CHECK(count(loop, "X2.") == 1);
  const std::string called =
      written("CALL OSUB\nG1 X2\nNEND Y3\nM2\nOSUB\nN10 G1 X5 F300\nGOTO NEND\nX7\nNEND X9\nRTS\n");
  INFO(called);
  CHECK(count(called, "NEND") == 1);
  CHECK(count(called, "N10") == 1);
  CHECK(count(written("N10 G1 X5 F300\nCALL OSUB Q3\nM2\nOSUB\nN10 G1 Y5\nN20 Y0\nRTS\n"), "N10") == 1);

  for (const std::string circle : {"G2 X1 I0.5 J0\n", "G2 I0.5 J0\n", "G3 X0.4 I0.2 J0\n"}) {
    Job fed = job;
    fed.program.feed_rule = nc::FeedRule::xyz_first;
    const std::string text = run(begin + "G1 Z4 F500\n" + circle + "M2\n", fed).text;
    INFO(text);
    CHECK(count(text, "F") <= 6);
  }
}

TEST_CASE("F alone between the holes of a cycle stays in its place") {
  const Job job = job_of_control("okuma");
  const std::string begin = "G15 H1\nG90 G0 X0 Y0 Z5 A0 B0 C0\nS100 M3\nG71 Z5\nM53\n";
  for (const std::string cycle : {"G83 X5 Y5 Z-5 R3 I2 J4 F100\n", "G82 X5 Y5 Z-5 R3 P500 F100\n",
                                  "G84 X5 Y5 Z-5 R3 F100\n", "G81 X5 Y5 Z-5 R3 F100\n", "G83 X5 Y5 Z-5 R3 Q3 F100\n"}) {
    const std::string text = run(begin + cycle + "F200\nX7 Y5\nG80\nM2\n", job).text;
    INFO(text);
    const std::size_t first = text.find("F100"), second = text.find("F200");
    CHECK(first < second);
    CHECK(text.find("X7", second) != std::string::npos);
    CHECK(text.find("X7") > second);
  }
}

TEST_CASE("the first pieces of a tiny arc go no faster than twice its feed, and all of it takes its time") {
  const auto largest_feed = [](const std::string& text) {  // but of turns alone, which counts degrees
    double largest = 0;
    for (std::size_t at = text.find('F'); at != std::string::npos; at = text.find('F', at + 1)) {
      const std::string line = text.substr(text.rfind('\n', at) + 1, at - text.rfind('\n', at) - 1);
      const bool is_word = at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
      const bool moves = line.find_first_of("XYZ") != std::string::npos && line.front() != '(';
      if (is_word && moves) largest = std::max(largest, std::stod(text.substr(at + 1)));
    }
    return largest;
  };
  for (const char* const control : {"okuma", "linuxcnc"}) {
    Job job = job_of_control(control);
    job.settings.friction = true;
    job.program.feed_rule = nc::FeedRule::xyz_first;
    const std::string system = job.dialect == "okuma" ? "G15 H1\n" : "G54 G21 G90 G94 G17\n";
    for (const char* const cut :
         {"G2 X5.2 R.1 F500\n", "G2 I.05 F500\n", "G2 I1. F500\n", "G2 I.05 F500\nG3 I.08\nG1 X9\n"}) {
      const Result result = run(system + "G0 X5 Y0 Z5 A0 B0 C0\nG1 Z4 F500\n" + cut + "M2\n", job);
      INFO(result.text);
      CHECK(largest_feed(result.text) <= 1000);
      CHECK(result.summary.time_change.value < 1.1e-3);
    }
  }
}

TEST_CASE("the number of a home position is written out without a point") {
  const Job job = job_of_control("okuma");
  const std::string begin = "G15 H1\nG90 G0 X0 Y0 Z5 A0 B0 C0\nG1 Z4 F500\n";
  for (const std::string home : {"LA=4\nG20 HP=LA\n", "VC1=2\nG21 HP=VC1+2\n", "LA=2\nG20 HP=2*LA\n"}) {
    const std::string text = run(begin + home + "CALL OSUB\nM2\nOSUB\nG0 X0 Y0 Z5\nRTS\n", job).text;
    INFO(text);
    CHECK(text.find("HP=4\n") != std::string::npos);
  }
}

TEST_CASE("OSP: a cut before the program says which tool length is in force is warned of") {
  const Job job = job_of_control("okuma");
  const auto warns = [&](const std::string& text) {
    return warnings_of(run(text, job).summary, "compensate-length-unstated");
  };
  const std::string start = "G15 H1\nG90 G94 G0 X0 Y0 Z50. A0 B0 C0\n";
  CHECK(warns(start + "G1 X5. F100\nX6.\nM2\n") == 1);
  CHECK(warns(start + "G1 X5. F100\nG53\nG0 Z50.\nG1 X6.\nM2\n") == 1);
  CHECK(warns("G53\n" + start + "G1 X5. F100\nM2\n") == 0);
  CHECK(warns(start + "G0 X5.\nM2\n") == 0);
}
