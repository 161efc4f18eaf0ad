// Nothing depends on the locale: the same bytes under a German and a Turkish one.
#include <catch2/catch.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;

TEST_CASE("output is the same in every locale") {
  const Scratch scratch;
  scratch.file("p.ngc", "g21 g90 g94\ng0 x0 y0 z5.5 a0 b0 c0\ng1 z0.25 f500.5\ni0\n");
  scratch.file("part.ngc", kPart);
  scratch.file("poses.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0.5,0,-1008,1.5,0,0\n");
  for (const std::string& arguments :
       {"compensate part.ngc -o - --step-length 0.5" + kOffset + kModel, "compensate p.ngc -o -" + kOffset + kModel,
        std::string("trace part.ngc"), "error poses.csv " + kModel, "simulate part.ngc" + kOffset + kModel,
        "check part.ngc --json -" + kOffset + kModel,
        std::string("diff part.ngc part.ngc --json - --tolerance-mm 0.5 --expect-equal")}) {
    INFO(arguments);
    const Outcome plain = run(scratch, arguments, "LC_ALL=C");
    for (const char* const locale : {"de_DE.UTF-8", "tr_TR.UTF-8"}) {
      const Outcome other = run(scratch, arguments, std::string("LC_ALL=") + locale);
      INFO(locale);
      CHECK(other.code == plain.code);
      CHECK(other.out == plain.out);
      CHECK(other.err == plain.err);
    }
  }
}
