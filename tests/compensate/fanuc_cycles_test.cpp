// Drilling cycles of a Fanuc control whose blocks name all axes.
#include <regex>
#include <tuple>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kDrillingStart = "O0001\nG21 G17 G90 G54 G94\n";

}  // namespace

TEST_CASE("rotary words in a drilling cycle that turn nothing are read") {
  const Job job = fanuc_job();
  const std::regex rotary_words(" [ABC]-?[0-9.]+");
  for (const std::string cycle : {"G81", "G83 Q3.", "G82 P100", "G84", "G85", "G99 G81", "G89 P50"}) {
    for (const std::string turn : {" A0. B0. C0.", " A2. B-1.5 C4.", " A2."}) {
      const std::string rest = turn == " A2." ? " B0. C0." : "";
      const auto text = [&](const std::string& beside) {
        return kDrillingStart + "G0 X0. Y0. Z50." + turn + rest + "\nS500 M3\n" + cycle + " X5. Y5. Z-8. R1. F200." +
               beside + "\nX25. Y-5." + beside + "\nG80\nG0 Z60.\nM30\n";
      };
      INFO(text(turn));
      const std::string out = run(text(turn), job).text;
      INFO(out);
      const auto without = [&](const std::string& output) { return std::regex_replace(output, rotary_words, ""); };
      if (cycle == "G84") {  // it stays one block a hole, and turns nothing
        CHECK(without(out) == without(run(text(""), job).text));
        const std::string start = out.substr(out.find("\nG0 X") + 1);
        const auto words = std::sregex_iterator(start.begin(), start.end(), rotary_words);
        const auto beside = start.substr(start.find("\nG84"), start.find("\nG80") - start.find("\nG84"));
        for (auto word = words; word->position() < static_cast<std::ptrdiff_t>(start.find('\n')); ++word) {
          const bool named = turn.find(word->str()[1]) != std::string::npos;
          CHECK((beside.find(word->str()) != std::string::npos) == named);
        }
      } else {
        CHECK(play(text(turn), out, job).at_points_um <= 2);
      }
    }
  }
}

TEST_CASE("rotary words in a drilling cycle that turn, or may turn, are refused") {
  const Job job = fanuc_job();
  const std::string start = kDrillingStart + "G0 X0. Y0. Z50. A0. B0. C0.\n";
  std::size_t line = 0;
  CHECK(code_of(start + "G81 X5. Y0 Z-5. R2. F100. A1.\nM30\n", job, &line) == "nc-axes-unused");
  CHECK(line == 4);
  CHECK(code_of(start + "G81 X5. Y0 Z-5. R2. F100.\nX10. A0.001\nM30\n", job, &line) == "nc-axes-unused");
  CHECK(line == 5);
  CHECK(code_of(start + "M0\nG0 X0. Y0. Z50.\nG81 X5. Y0 Z-5. R2. F100. A0.\nM30\n", job) == "nc-axes-unused");
  CHECK(code_of(start + "G81 X5. Y0 Z-5. R2. F100.\nA0. B0. C0.\nM30\n", job) == "nc-axes-missing");
  CHECK(code_of(start + "G81 X5. Y0 Z-5. R2. F100.\nG91 X10. R-48. Z-7. A0.\nM30\n", job).empty());
  CHECK(code_of(start + "G81 X5. Y0 Z-5. R2. F100.\nG91 X10. R-48. Z-7. A1.\nM30\n", job) == "nc-axes-unused");
}

TEST_CASE("the rapid to above the hole is written out where X and Y are not known before") {
  const Job job = fanuc_job();
  const std::string start = kDrillingStart + "G0 X5. Y5. Z20. A0. B0. C0.\n";
  const std::string level = "G0 Z20. A0. B0. C0.\n";
  // what loses them, the cycle, and what the rapid that goes there names
  for (const auto& [lost, cycle, axes] :
       {std::tuple{"M0\n" + level, "G81 X5. Y5. Z-2. R2. F100.\n", "X[^ ]* Y"},
        std::tuple{"G91 G28 Z0\nT2 M6\nG90\n" + level, "G99 G83 X5. Y5. Z-2. R2. Q1. F100.\n", "X[^ ]* Y"},
        std::tuple{"G28\n" + level, "G99 G73 X5. Y5. Z-2. R20. Q4. F100.\n", "X[^ ]* Y"},
        std::tuple{std::string("G91 G28 Y0\nG90\n"), "G82 X5. Y5. Z-2. R2. P100 F100.\n", "Y"},
        std::tuple{"G91 G28 X0 Y0 Z0\nG90\n" + level, "G85 X5. Y5. Z-2. R2. F100.\n", "X[^ ]* Y"}}) {
    const std::string text = start + lost + cycle + "X9.\nG80\nG0 Z30.\nM30\n";
    INFO(text);
    Job given = job;
    given.program.start = {0, 0, 50, 0, 0, 0};
    const std::string out = run(text, given).text;
    INFO(out);
    const std::regex above(std::string("\nG0 [^\n]*") + axes + "[^\n]*\n(G0 Z2[.]|G1 )");
    CHECK(std::regex_search(out, above));
  }
}

TEST_CASE("a hole at which X and Y stand names both in the first move after a turn of the coordinates") {
  const Job job = fanuc_job();
  const std::string start = kDrillingStart + "G0 X0. Y0. Z20. A0. B0. C0.\n";
  const std::string hole = "G81 X0. Y0. Z-2. R2. F100.\n";
  for (const std::string& body :
       {"G68 X0. Y0. R90.\n" + hole + "X10. Y0.\nG80\nG69\n", "G68 X0. Y0. R30.\nG0 X0. Y0.\n" + hole + "G80\nG69\n",
        "G68 X0. Y0. R90.\nG81 X5. Y0. Z-2. R2. F100.\nG80\nG69\n" + hole,
        std::string("G68 X0. Y0. R90.\nG83 X5. Y0. Z-2. R2. Q1. F100.\nG69\nX0. Y0.\n")}) {
    const std::string text = start + body + "G80\nG0 X0. Y0. Z30.\nM30\n";
    INFO(text);
    const std::string out = run(text, job).text;
    INFO(out);
    for (const std::string code : {"\nG68", "\nG69"}) {
      const std::string rest = out.substr(out.find(code) + 1);
      const std::size_t x = rest.find(" X", rest.find('\n'));
      if (x == std::string::npos) continue;
      const std::string line = rest.substr(rest.rfind('\n', x), rest.find('\n', x) - rest.rfind('\n', x));
      CHECK(line.find(" Y") != std::string::npos);
      CHECK(rest.find("Z2.") > x);
    }
  }
}
