// What stops the spindle, in programs for Fanuc and Siemens: a feed per revolution is none after it.
#include <string>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::string code_at(const char* control, const std::string& program) {
  return nc::tests::code_of(program, empty_tables(), control);
}

}  // namespace

TEST_CASE("a feed per revolution needs a spindle that no change of the tool has stopped") {
  const std::string code = "nc-feed-missing";
  for (const char* const control : {"fanuc", "siemens"}) {
    INFO(control);
    const std::string head = "G54 G90 G0 X0. Y0. Z0.\nS100 M3\n";
    CHECK(code_at(control, head + "T1 M6\nG0 X1.\nG95 G1 X5. F0.1\nM30\n") == code);
    CHECK(code_at(control, head + "M19\nG95 G1 X5. F0.1\nM30\n") == code);
    CHECK(code_at(control, head + "G95 G1 X5. F0.1\nM19\nX6.\nM30\n") == code);
    CHECK(code_at(control, head + "M3 S500 T1 M6\nG0 X1.\nG95 G1 X5. F0.1\nM30\n") != "");
    CHECK(code_at(control, head + "M19 M3 S500\nG95 G1 X5. F0.1\nM30\n") != "");
    CHECK(code_at(control, head + "T1 M6\nM3\nG0 X1.\nG95 G1 X5. F0.1\nM30\n").empty());
    CHECK(code_at(control, head + "M19\nM4\nG95 G1 X5. F0.1\nM30\n").empty());
  }
}

TEST_CASE("after rigid taps the spindle turns no way that the program told") {
  const std::string tap = "G54 G90 G0 X0. Y0. Z20. A0. B0. C0.\nS500 M3\nM29 S300\nG84 X1. Y0. Z-5. R5. F300.\n";
  CHECK(code_at("fanuc", tap + "G80\nG95 G1 X6. F0.1\nM30\n") == "nc-feed-missing");
  CHECK(code_at("fanuc", tap + "G0 X8.\nG95 G1 X6. F0.1\nM30\n") == "nc-feed-missing");
  CHECK(code_at("fanuc", tap + "G80\nG95\nG81 X6. Z-5. R5. F0.1\nM30\n") == "nc-feed-missing");
  CHECK(code_at("fanuc", tap + "G80\nM3 S500\nG95 G1 X6. F0.1\nM30\n").empty());
  CHECK(code_at("fanuc", tap + "G80\nG94 G1 X6. F100.\nM30\n").empty());
}

TEST_CASE("a rigid tap turns the spindle itself, a hole that is drilled does not") {
  const std::string head = "G54 G90 G0 X0. Y0. Z20. A0. B0. C0.\nS500 M3\nM5\nG95\n";
  CHECK(code_at("fanuc", head + "M29 S500\nG84 X1. Y0. Z-5. R5. F1.\nX2.\nG80\nM30\n").empty());
  CHECK(code_at("fanuc", head + "G74 X1. Y0. Z-5. R5. F1.\nG80\nM30\n").empty());
  CHECK(code_at("fanuc", head + "G81 X1. Y0. Z-5. R5. F1.\nG80\nM30\n") == "nc-feed-missing");
  CHECK(code_at("fanuc", "G54 G90 G0 X0. Y0. Z20. A0. B0. C0.\nG95\nG84 X1. Y0. Z-5. R5. F1.\nM30\n") ==
        "nc-feed-missing");
  CHECK(code_at("okuma", "G15 H1 G0 X0 Y0 Z5 A0 B0 C0\nM5 S500\nG95\nG284 X1 Y0 Z-5 R5 F1 M54\nM2\n").empty());
}
