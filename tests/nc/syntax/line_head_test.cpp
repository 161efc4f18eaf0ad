#include "nc/syntax/line_head.hpp"

#include <catch2/catch.hpp>

using namespace plumbline::nc;

namespace {

LineHead head_in(std::string_view dialect_name, std::string_view line) { return head_of(line, dialect(dialect_name)); }

}  // namespace

TEST_CASE("a line of macro B begins with the number or the name of a program, an N, or END") {
  CHECK(head_in("fanuc", "O0012 (PART)").program == "12");
  CHECK(head_in("fanuc", " : 0012").program == "12");
  CHECK(head_in("fanuc", "<Part - 1>(NOTE)").program == "<PART-1>");
  CHECK(head_in("fanuc", "<PART-1").program.empty());
  CHECK(head_in("fanuc", "N 0100 G1 X5.").number == "N100");
  CHECK(head_in("fanuc", "/2 N20 X1.").number == "N20");
  const LineHead end = head_in("fanuc", "N10 E N D 2");
  CHECK(end.number == "N10");
  CHECK(end.word == FlowWord::end_while);
  CHECK(end.loop == 2);
  CHECK(head_in("fanuc", "ENDIF").word == FlowWord::none);
  const LineHead move = head_in("fanuc", "G1 X5. (O7)");
  CHECK(move.program.empty());
  CHECK(move.number.empty());
  CHECK_FALSE(move.empty);
}

TEST_CASE("blanks, a comment and % are an empty line") {
  for (const char* const name : {"fanuc", "siemens", "okuma"}) {
    INFO(name);
    for (const char* const line : {"", " \t", "(N10)", "; N10", "%", "$"}) {
      INFO(line);
      CHECK(head_in(name, line).empty);
    }
    CHECK_FALSE(head_in(name, "X1").empty);
  }
}

TEST_CASE("a line of a high-level language has a number, then a label, then its statement") {
  const LineHead both = head_in("siemens", "N0100 loop_1: WHILE R1<5");
  CHECK(both.number == "N100");
  CHECK(both.label == "LOOP_1");
  CHECK(both.word == FlowWord::begin_while);
  CHECK(head_in("siemens", ":0100 G0").number == "N100");
  CHECK(head_in("siemens", "MARK:G0").label == "MARK");
  CHECK(head_in("siemens", "NEXT: G0").label == "NEXT");
  CHECK(head_in("siemens", "NEXT: G0").number.empty());
  CHECK(head_in("okuma", "NEXT G0").number == "NEXT");
  CHECK(head_in("okuma", "NEXT G0").label.empty());
}

TEST_CASE("an IF that jumps in its line opens nothing, whatever its comment says") {
  CHECK(head_in("siemens", "IF R1==2").word == FlowWord::begin_if);
  CHECK(head_in("siemens", "IF R1==2 GOTOF MARK").word == FlowWord::go_to);
  CHECK(head_in("siemens", "IF R1==2 ; GOTOF MARK").word == FlowWord::begin_if);
  CHECK(head_in("siemens", "ENDIF").word == FlowWord::end_if);
}

TEST_CASE("programs begin with the letter of the control, or with the head of an archive") {
  CHECK(head_in("okuma", "O0100 (PART)").program == "O0100");
  CHECK(head_in("okuma", "ODRILL").program == "ODRILL");
  CHECK(head_in("siemens", "%_N_SHAFT_2_MPF").program == "SHAFT_2");
  CHECK_FALSE(head_in("siemens", "%_N_SHAFT_2_MPF").empty);
  CHECK(head_in("okuma", "%_N_SHAFT_2_MPF").program.empty());
}

TEST_CASE("a line of comments is empty, one with words behind them is not") {
  for (const char* const line : {"", "  ", "(A)", "(A) (B)", " (A", "; X1", "(A) ; X1", "%"}) {
    INFO(line);
    CHECK(head_in("okuma", line).empty);
  }
  for (const char* const line : {"(A) X1", "(A)(B)G0", "(A) O100", "X1 (A)"}) {
    INFO(line);
    CHECK_FALSE(head_in("okuma", line).empty);
  }
  CHECK(zeros_of_label("n 007") == 2);
  CHECK(zeros_of_label(":10") == 0);
  CHECK(zeros_of_label("lap_07") == 0);
}

TEST_CASE("labels and names are compared in upper case, without blanks and leading zeros") {
  CHECK(canonical_label("n 007") == "N7");
  CHECK(canonical_label(":10") == "N10");
  CHECK(canonical_label("N000") == "N0");
  CHECK(canonical_label("N007a") == "N007A");
  CHECK(canonical_label("lap_07") == "LAP_07");
  CHECK(canonical_label("").empty());
  CHECK(canonical_program("0100") == "100");
  CHECK(canonical_program("o 0007") == "O7");
  CHECK(canonical_program("O07A") == "O07A");
  CHECK(canonical_program("%_N_L010_SPF") == "L010");
}

TEST_CASE("M2 and M30 end a program, in whatever way they are written") {
  for (const char* const line : {"M30", "N5 m02", "X1.M30", "G0 X1. M2 (END)", "/M30", "NEND M2"})
    CHECK(holds_program_end(line));
  for (const char* const line : {"M3 S30", "(M30)", "M300", "M20", "M2.5", "LM2=5", "M98 P30", ""})
    CHECK_FALSE(holds_program_end(line));
}
