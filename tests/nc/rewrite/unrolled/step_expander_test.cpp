// Also made_steps.cpp. entry_comments.cpp shows in programs that are compensated: tests/compensate/flow_test.cpp,
// "loops and subprograms are written out pass by pass".
#include "nc/rewrite/unrolled/step_expander.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "nc/rewrite/last_step.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

constexpr std::string_view kGone = "(no step)";

// The last block of the program as one without parameters holds it.
std::string plain_text(std::string_view text, std::string_view dialect_name = "linuxcnc", bool keeps_settings = false) {
  const LastStep step(text, dialect_name, empty_tables());
  StepExpander expander(dialect(dialect_name));
  const Step* const made = expander.plain(*step, keeps_settings);
  return std::string(made == nullptr ? kGone : made->block->text);
}

std::string text_beside_flow(const LastStep& step, bool acts, std::string_view dialect_name) {
  StepExpander expander(dialect(dialect_name));
  const Step* const made = expander.beside_flow(*step, acts);
  return std::string(made == nullptr ? kGone : made->block->text);
}

}  // namespace

TEST_CASE("a block without parameters is the step itself, not another like it") {
  StepExpander expander(dialect("linuxcnc"));
  for (const char* const text : {"G1 X5 F100 (note)\n", "N7\n", "(msg, hello)\n", "G81 X1 R2 Z-3 F100\n"}) {
    INFO(text);
    const LastStep step(text);
    CHECK(expander.plain(*step, false) == &*step);
  }
}

TEST_CASE("values stand where expressions stood, with as many decimals as they have") {
  CHECK(plain_text("#1=5\nN10 G1 X[#1+0.5] Y2.50 F[#1*20] (up)\n") == "N10 G1 X5.5 Y2.50 F100 (up)");
  CHECK(plain_text("#1=3\ng1x[#1/7]f100\n") == "g1x0.428571429f100");
  CHECK(plain_text("#1=54\nG#1\n") == "G54");
  CHECK(plain_text("#1=54.1\nG#1 P2\n", "fanuc") == "G54.1 P2");
  CHECK(plain_text("#1=5.\nG0 X#1 Y2.\n", "fanuc") == "G0 X5. Y2.");
  CHECK(plain_text("R1=5\nG0 X=R1 Y=IC(R1) Z2\n", "siemens") == "G0 X5 Y=IC(5) Z2");
}

TEST_CASE("values are as many decimals as the control needs, the words of the program keep theirs") {
  const LastStep step("#1=5\nG0 X[#1/3] Y2.50\n");
  StepExpander expander(dialect("linuxcnc"));
  const Step& made = *expander.plain(*step, false);
  CHECK(find_word(*made.block, 'X')->decimals == 0);
  CHECK(find_word(*made.block, 'X')->value == Approx(5.0 / 3));
  CHECK(find_word(*made.block, 'Y')->decimals == 2);
  CHECK(made.motions.size() == 1);
  CHECK(made.block->line == 2);
}

TEST_CASE("settings go with the parameters, unless they are kept") {
  CHECK(plain_text("#1=5\n") == kGone);
  CHECK(plain_text("#1=5\n", "linuxcnc", true) == "#1=5");
  CHECK(plain_text("#1=5 (depth)\n") == "(depth)");
  CHECK(plain_text("#1=5\nG0 X#1 #2=3 Y1\n") == "G0 X5 Y1");
  CHECK(plain_text("#1=5\nG0 X#1 #2=3 Y1\n", "linuxcnc", true) == "G0 X5 #2=3 Y1");
}

TEST_CASE("a word worth a vacant variable was no word") {
  CHECK(plain_text("G0 X#1 Y2. (left out)\n", "fanuc") == "G0 Y2. (left out)");
}

TEST_CASE("radius and angle become X and Y") {
  CHECK(plain_text("G0 X0 Y0\nG0 @10 ^90\n") == "G0 X0 Y10");
  CHECK(plain_text("G0 X10 Y0\nG0^180\n") == "G0X-10Y0");
  CHECK(plain_text("G20 G0 X0 Y0\nG0 @2 ^0\n") == "G0 X2 Y0");
}

TEST_CASE("the direction of the tool becomes A, B and C under the code that takes them") {
  const std::string head = "G21 G90 G54\nG0 X0. Y0. A0. B0. C90.\n";
  CHECK(plain_text(head + "G43.5 H1 Z50.\n", "fanuc") == "G43.4 H1 Z50.");
  const std::string turned = plain_text(head + "G43.5 H1 Z50.\nG0 X10. I1. J0. K2.\n", "fanuc");
  CHECK(turned.starts_with("G0 X10. A26.56505"));  // atan(1/2) about X, where C has turned the axes by 90 degrees
  CHECK(turned.find('I') == std::string::npos);
}

TEST_CASE("comments that show parameters are made comments that do not") {
  CHECK(plain_text("#1=5\n(debug, x is #1)\n") == "(was debug, x is #1)");
  CHECK(plain_text("#1=5\n( Print , #1)\n") == "(was  Print , #1)");
  CHECK(plain_text("(debug, nothing)\n") == "(debug, nothing)");
  CHECK(plain_text("(msg, #1)\n") == "(msg, #1)");
  CHECK(plain_text("#1=5\n(debug, x is #1)\n", "linuxcnc", true) == "(debug, x is #1)");
}

TEST_CASE("labels go where a program is written out, since nothing jumps there") {
  CHECK(plain_text("MARK: G0 X5\n", "siemens") == "G0 X5");
  CHECK(plain_text("N10 MARK: G0 X5\n", "siemens") == "N10 G0 X5");
  CHECK(plain_text("MARK:\n", "siemens") == kGone);
  CHECK(plain_text("MARK: G0 X5\n", "siemens", true) == "MARK: G0 X5");
}

TEST_CASE("a value that only the machine knows cannot be written") {
  const std::string text = "M66 P0 L0\n#1=#5399\nS#1 M3\n";
  const LastStep step(text);
  StepExpander expander(dialect("linuxcnc"));
  const Diagnostic refused = testing::refusal_of([&] { expander.plain(*step, false); });
  CHECK(refused.code == "emit-value-unknown");
  CHECK(refused.place.line == 3);
  CHECK(expander.plain(*step, true)->block->text == "S#1 M3");
}

TEST_CASE("of a line that steers, what acts stays without its call, or its comments alone") {
  const LastStep call("O1\n#1=5.\nG0 X#1 M98 P100 (go)\nM30\nO100\nM99\n", "fanuc", empty_tables(), 3);
  CHECK(call->flow);
  CHECK(text_beside_flow(call, true, "fanuc") == "G0 X5. (go)");
  CHECK(text_beside_flow(call, false, "fanuc") == "(go)");
  const LastStep silent("O1\nM98 P100\nM30\nO100\nM99\n", "fanuc", empty_tables(), 2);
  CHECK(text_beside_flow(silent, false, "fanuc") == kGone);
}

TEST_CASE("a control with O words acts on no comment beside one") {
  for (const char* const comment : {"(MSG,hello)", "(print, x)", "( Debug , x)", "(log,x)", "(LOGOPEN,x.txt)",
                                    "(logclose)", "(PROBEOPEN x.txt)", "(probeclose)"}) {
    INFO(comment);
    const std::string was = std::string("(was ") + (comment + 1);
    const LastStep branch("o1 if [1] " + std::string(comment) + "\n", "linuxcnc");
    CHECK(text_beside_flow(branch, false, "linuxcnc") == was);
    const LastStep call("M98 P5 " + std::string(comment) + "\nM2\nO5\nM99\n", "linuxcnc", empty_tables(), 1);
    CHECK(text_beside_flow(call, false, "linuxcnc") == was);
    const LastStep end("o1 sub\no1 endsub " + std::string(comment) + "\nM2\n", "linuxcnc", at_zero(), 2);
    CHECK(text_beside_flow(end, false, "linuxcnc") == was);
  }
  for (const char* const comment : {"(message)", "(logs, and more)", "(the msg,x)", "(a)"}) {
    INFO(comment);
    const LastStep step("o1 if [1] " + std::string(comment) + "\n", "linuxcnc");
    CHECK(text_beside_flow(step, false, "linuxcnc") == comment);
  }
}
