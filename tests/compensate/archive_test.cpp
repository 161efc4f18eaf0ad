// Archives of a SINUMERIK, whose main program is written out.
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kMainOfArchive =
    "%_N_MAIN_MPF\n;$PATH=/_N_WKS_DIR/_N_TEST_WPD\nG54 G17 G71 G90 G94 G64\nG0 X0 Y0 Z5 A0 B0 C0\n";
const std::string kToolsOfArchive = "%_N_TEST_TOA\n;$PATH=/_N_WKS_DIR/_N_TEST_WPD\n$TC_DP3[1,1]=100\nM17\n";
const std::string kFramesOfArchive = "%_N_COMPLETE_UFR\n$P_UIFR[1]=CTRANS(X,1)\nM17";
const std::string kSubOfArchive = "%_N_SUB_SPF\nG1 X3 F200\nM17\n";
const std::string kUncalled = "%_N_OTHER_SPF\nG1 X=R9\nM17\n";

}  // namespace

TEST_CASE("what stands behind the main program of an archive that is written out stays as it is") {
  const Job job = job_of_control("siemens");
  for (const std::string body :
       {"R1=0\nWHILE R1<2\nR1=R1+1\nG1 X=R1*5 F200\nENDWHILE\nM30\n", "SUB\nM30\n", "SUB P2\nM17\n", "SUB\n",
        "GOTOF NEXT\nG1 X4 F200\nNEXT:\nG1 X5 F200\nM2\n", "GOTOF NEXT\nNEXT: G1 X5 F200\n"}) {
    INFO(body);
    for (const std::string& behind : {kSubOfArchive + kToolsOfArchive, kToolsOfArchive + kSubOfArchive + kUncalled,
                                      kUncalled + kSubOfArchive + kFramesOfArchive}) {
      INFO(behind);
      const std::string text = run(kMainOfArchive + body + behind, job).text;
      CHECK(text.ends_with('\n' + behind));
      CHECK(text.find("%_N_") == 0);
      CHECK(text.find("plumbline 0 compensated") != std::string::npos);
    }
  }
  CHECK(run(kMainOfArchive + "G1 X5 F200\nM30\n" + kUncalled + kToolsOfArchive, job)
            .text.ends_with("M30\n" + kUncalled + kToolsOfArchive));
  CHECK(run("G54 G17 G71 G90 G94 G64\nG0 X0 Y0 Z5 A0 B0 C0\nSUB\nM30\n" + kSubOfArchive, job)
            .text.ends_with("M30\n" + kSubOfArchive));
}

TEST_CASE("programs of an archive whose names have no _N_ are told apart as those that have it") {
  const Job job = job_of_control("siemens");
  const auto both = [&](const std::string& main, const std::string& first, const std::string& second) {
    const std::string begin = "\nG54 G17 G71 G90 G94 G64\nG0 X0 Y0 Z5 A0 B0 C0\n";
    return code_of(first + (main == first ? begin : "\n") + "G1 X3 F200\nM30\n" + second +
                       (main == second ? begin : "\n") + "G1 X6 F200\nM30\n",
                   job);
  };
  for (const std::string prefix : {"%_N_", "%"}) {
    INFO(prefix);
    CHECK(both(prefix + "MAIN_MPF", prefix + "MAIN_MPF", prefix + "TWO_MPF") != "");
    CHECK(both(prefix + "MAIN_MPF", prefix + "SUB_SPF", prefix + "MAIN_MPF") != "");
    CHECK(both(prefix + "MAIN_MPF", prefix + "MAIN_MPF", prefix + "SUB_SPF") == "");
  }
}

TEST_CASE("a second main program that the first one calls is not left as it is behind it") {
  const Job job = job_of_control("siemens");
  const std::string other = "%_N_TWO_MPF\nG1 X3 F200\nM17\n";
  std::size_t line = 0;
  CHECK(code_of(kMainOfArchive + "TWO\nM30\n" + other, job, &line) == "compensate-flow");
  CHECK(line == 7);
  CHECK(code_of(kMainOfArchive + "SUB\nTWO\nM30\n" + kSubOfArchive + other, job, &line) == "compensate-flow");
  CHECK(line == 11);
  CHECK(code_of(kMainOfArchive + "TWO\nM30\n" + other + kToolsOfArchive, job) == "compensate-flow");
}
