// Cycles of an OSP that stay cycles, shifted as a whole.
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
  const Diagnostic refused =
      refused_hole("G71 Z40.\nG0 Z40.\nM53\nG81 X0 Y0 Z-8. R3. F120\nX10. P500\nG80\nG0 Z60.\nM2\n", job);
  CHECK(refused.code == "compensate-cycle");
  CHECK(tells(refused.help, "the code of the cycle"));
}

TEST_CASE("what varies along a hole by less than 0.1 um is told in digits that say something") {
  Job job = job_of_control("okuma");
  job.settings.cycle_tolerance_mm = 0;
  const Diagnostic refused = refused_hole("G71 Z50.\nG84 X10. Y0 Z-5. R3. F400 M53\nG0 Z60.\nM2\n", job);
  CHECK(refused.code == "compensate-cycle");
  CHECK_FALSE(tells(refused.message, "0.0000"));
}
