// Drilling cycles of a Fanuc control whose blocks name all axes.
#include <regex>

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
