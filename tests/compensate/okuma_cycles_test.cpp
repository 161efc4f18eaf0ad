// Cycles of an OSP that stay cycles, shifted as a whole.
#include <initializer_list>
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kBeforeHoles = "O1\nG15 H1\nG90 G94 G0 X0 Y0 Z50. A0 B0 C0\nS500 M3\n";

Diagnostic refused_hole(const std::string& rest, const Job& job) {
  try {
    run(kBeforeHoles + rest, job);
  } catch (const Refusal& refusal) {
    return refusal.diagnostic();
  }
  return {};
}

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a peck of an OSP that is finer than what the control keeps is refused where the hole stays a cycle") {
  const Job job = job_of_control("okuma");
  for (const std::string hole :
       {"G73 X10. Y0 Z-10. R3. I=10/3 J=20/3 F100 M53\nX20.\n", "G83 X10. Y0 Z-10. R3. I=1/3 J1. F100 M53\nX20.\n",
        "G83 X10. Y0 Z-10. R3. I3.3333 J6.6666 F100 M53\n", "G83 X10. Y0 Z-10. R3. Q4.3333 P100 F100 M53\n"}) {
    INFO(hole);
    const Diagnostic refused = refused_hole("G71 Z50.\n" + hole + "G0 Z60.\nM2\n", job);
    CHECK(refused.code == "nc-not-interpreted");
    CHECK(refused.place.line == 6);
    CHECK(tells(refused.message, "finer"));
  }
  for (const std::string hole :
       {"G83 NCYL X10. Y0 Z-10. R3. I3.3333 J9.9999 F100 M53\nX20.\n",
        "G84 NCYL X10. Y0 Z-10. R3.1234 F100 M53\nX20.\n", "NCYL G73 Z-10. R3. Q3.0001 P200 F100 M53\nX20.\n"}) {
    const Diagnostic refused = refused_hole("G71 Z50.\n" + hole + "G0 Z60.\nM2\n", job);
    INFO(hole << refused.message);
    CHECK(refused.place.line == 6);
    CHECK(tells(refused.message, "finer"));
  }
  for (const std::string hole :
       {"G83 X10. Y0 Z-10. R3. Q4.3333 F100 M53\nX20. P500\n", "G83 X10. Y0 Z-10. R3. Q=10/3 F100 M53\nX20. P500\n",
        "G73 NCYL X10. Y0 Z-10. R3. Q3.3333 F100 M53\nX20. P1\n"}) {
    const Diagnostic refused = refused_hole("G71 Z50.\n" + hole + "G0 Z60.\nM2\n", job);
    INFO(hole << refused.message);
    CHECK(refused.code == "nc-not-interpreted");
    CHECK(refused.place.line == 7);
    CHECK(tells(refused.message, "finer"));
  }
  for (const std::string hole :
       {"G73 X10. Y0 Z-10. R3. I=10/4 J=15/2 F100 M53\nX20.\n", "G83 X10. Y0 Z-10. R3. I3.333 J6.666 F100 M53\n",
        "G83 X10. Y0 Z-10. R3. Q4.333 P100 F100 M53\nX20.\n",
        "G83 X10. Y0 Z-10. R3. Q=13/3 F100 M53\nX20.\n"}) {  // it is written out
    INFO(hole);
    CHECK(refused_hole("G71 Z50.\n" + hole + "G0 Z60.\nM2\n", job).message.empty());
  }
}

TEST_CASE("a tap of an OSP that begins above the hole is refused with where the tool stands") {
  const Job job = job_of_control("okuma");
  for (const std::string hole : {"G84 X0 Y0 Z-5. R3. F400 M54\nX10.\n", "G82 X0 Y0 Z-5. R3. P500 F400 M54\n",
                                 "G73 X0 Y0 Z-5. R3. I1. J2. F400 M54\n"}) {
    INFO(hole);
    const Diagnostic refused = refused_hole("G71 Z50.\n" + hole + "G0 Z60.\nM2\n", job);
    INFO(refused.message << refused.help);
    CHECK(refused.code == "compensate-cycle");
    CHECK(tells(refused.message, "the tool stands at Z50 and not on R, Z3"));
    CHECK(tells(refused.help, "Z3 with G0"));
    CHECK(refused_hole("G71 Z50.\nG0 Z3.\n" + hole + "G0 Z60.\nM2\n", job).message.empty());
  }
  CHECK(refused_hole("G71 Z50.\nG81 X0 Y0 Z-5. R3. F400 M54\nX10.\nG0 Z60.\nM2\n", job).message.empty());
}

TEST_CASE("a cycle of an OSP that states all its words goes on from none that is written out") {
  const Job job = job_of_control("okuma");
  for (const std::string next : {"G82 X-20. Y0 Z-6. R3. P500 F100\nX-30.\n", "G84 X-20. Y0 Z-6. R3. F100\nX-30.\n",
                                 "G73 X-20. Y0 Z-6. R3. I1. J2. F100\n"}) {
    INFO(next);
    const std::string text =
        kBeforeHoles + "G71 Z40.\nG0 Z40.\nM53\nG81 X0 Y0 Z-8. R3. F120\nX10.\n" + next + "G80\nG0 Z60.\nM2\n";
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(tells(result.text, "\n" + next.substr(0, 3) + " X-"));
    CHECK_FALSE(tells(result.text, "G81"));
  }
}

TEST_CASE("a hole of an OSP that stays a cycle states its words anew behind a block of the cycle that is written out") {
  const Job job = job_of_control("okuma");
  const auto written = [&](const std::string& holes) {
    const std::string text = kBeforeHoles + "G71 Z40.\nG0 Z40.\nM53\n" + holes + "G80\nG0 Z60.\nM2\n";
    INFO(text);
    const Result result = run(text, job);
    CHECK(result.summary.read_back);
    return result.text;
  };
  const auto states = [&](const std::string& holes, std::initializer_list<const char*> parts) {
    const std::string text = written(holes);
    INFO(text);
    std::size_t at = 0;
    for (const char* const part : parts) {
      at = text.find(part, at);
      CHECK(at != std::string::npos);
    }
    CHECK_FALSE(tells(text, "NCYL"));
  };
  states("G84 NCYL X0 Y0 Z-8. R5. F400\nX10.\nX20. Y5.\n", {"\nF400\n", "\nG84 X", " R5.", "\nX", " Y", " R5."});
  states("G284 NCYL X0 Y0 Z-8. R5. F400\nY10. A0\n", {"\nG284 Y", " A", " X"});
  states("NCYL G74 X0 Y0 Z-8. R5. F400\nM8\nX10.\nNCYL X15.\nX20.\n", {"\nG74 X", "\nG0 X", "\nG74 X"});
  states("G83 NCYL X0 Y0 Z-20. R5. I3. J9. F100\nX10.\n", {"\nG83 X", " I3. J9."});
  states("G73 NCYL X0 Y0 Z-20. R5. Q4. P300 F100\nX10.\n", {"\nG73 X", " P300 Q4."});
  states("G85 NCYL X0 Y0 Z-20. R5. F100 FA=250\nX10.\n", {"\nG85 X", " FA=250."});
  states("G73 NCYL X0 Y0 Z-20. R5. Q4. P0.4 F100\nX10.\n", {"\nG73 X", " P0.4 Q4."});
  states("G73 NCYL X0 Y0 Z-20. R5. Q4. P1. F100\nX10.\n", {"\nG73 X", " P1. Q4."});
  states("G82 NCYL X0 Y0 Z-8. R5. F100 P200\nX10. P400\n", {"\nG82 X", " P400"});
  states("G81 X0 Y0 Z-8. R3. F120\nX10. P500\nX20.\n", {"\nG81 X", " P500", "\nX"});
  states("G74 X0 Y0 Z-8. R5. F400\nX10.\nG85 NCYL Z-9. R4. P100 F90 FA=80\nX20.\n",
         {"\nX", "\nG0 Z40.", "\nG85 X", " P100 FA=80."});
  states("G86 X0 Y0 Z-8. R5. P20 F100\nX5.\nNCYL G84 Z-9. R5. P0 F90\nX10.\n", {"\nG86 X", "\nG0 Z40.", "\nG84 X"});
  states("G84 X0 Y0 Z-8. R5. P20 F400\nNCYL Z-9. P0\nX10.\n", {"\nG0 Z40.", "\nG84 X"});
  states("NCYL G84 Z-8. R5. F400\nCALL OA\nM2\nOA\nX10. Y0\nX20.\nRTS\n", {"\nF400\n", "\nG84 X", "\nX"});
}

TEST_CASE("what varies along a hole by less than 0.1 um is told in digits that say something") {
  Job job = job_of_control("okuma");
  job.settings.cycle_tolerance_mm = 0;
  const Diagnostic refused = refused_hole("G71 Z50.\nG84 X10. Y0 Z-5. R3. F400 M53\nG0 Z60.\nM2\n", job);
  CHECK(refused.code == "compensate-cycle");
  CHECK_FALSE(tells(refused.message, "0.0000"));
}
