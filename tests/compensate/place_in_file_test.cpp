#include "compensate/place_in_file.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

struct Case {
  std::string dialect;
  std::string before;  // lines
  std::string line;
  std::string after;
  std::string code;
};

Diagnostic refusal_of_case(const Case& one) {
  Job job = without_friction();
  job.dialect = one.dialect;
  return testing::refusal_of([&] { run(one.before + one.line + '\n' + one.after, job); });
}

}  // namespace

TEST_CASE("what is refused of a program that is written out is shown in the words of the file") {
  const std::string start = "G21 G90 G94 G17 G54\nG0 X0 Y0 Z5 A0 B0 C0\nG1 X1 F500\n";
  const std::string fanuc = "O0001\nG21 G90 G94 G17 G54\nG0 X0. Y0. Z5. A0. B0. C0.\nG1 X1. F500.\n";
  const std::string siemens = "G71 G90 G94 G17 G54\nG0 X0 Y0 Z5 A0 B0 C0\nG1 X1 F500\n";
  for (const Case& one :
       {Case{"linuxcnc", start + "o1 repeat [1]\nG1 X[1+2]\n", "S[1000*2-1500] G28.1", "o1 endrepeat\nM2\n",
             "emit-stores-position"},
        Case{"linuxcnc", start + "#1=3\no1 repeat [2]\nG1 Y3\n", "  F[#1*100] G30.1 (here)", "o1 endrepeat\nM2\n",
             "emit-stores-position"},
        Case{"linuxcnc", start + "o<a> sub\nG1 X#1\n", "N5 M3 S[#1*500] G28.1", "o<a> endsub\no<a> call [2]\nM2\n",
             "emit-stores-position"},
        Case{"fanuc", fanuc + "#1=1.\nWHILE [#1 LT 3.] DO1\n", "G1 X[#1*900.] Y#1", "#1=#1+1.\nEND1\nM30\n", ""},
        Case{"siemens", siemens + "R1=3\nREPEAT_BACK:\n", "G1 X=R1*900 Y=R1", "REPEAT REPEAT_BACK P=2\nM30\n", ""}}) {
    INFO(one.dialect << ": " << one.line);
    const Diagnostic refusal = refusal_of_case(one);
    INFO(refusal.code << ": " << refusal.message << "\n" << to_text(refusal));
    if (!one.code.empty()) CHECK(refusal.code == one.code);
    CHECK(refusal.place.text == one.line);
    CHECK(refusal.place.line == static_cast<std::size_t>(std::count(one.before.begin(), one.before.end(), '\n')) + 1);
    CHECK(refusal.place.column >= 1);
    CHECK(refusal.place.column - 1 + refusal.place.length <= one.line.size());
  }
}

TEST_CASE("the place of a word is that of the same word in the file") {
  nc::Block of_file;
  of_file.file = "p.ngc";
  of_file.line = 7;
  of_file.text = "N5 G1 G90 X[1+2] (a) Y#3";
  of_file.words = {{.letter = 'G', .span = {3, 5}},
                   {.letter = 'G', .span = {6, 9}},
                   {.letter = 'X', .span = {10, 16}},
                   {.letter = 'Y', .span = {21, 24}}};
  nc::Block written = of_file;
  written.text = "G1 G90 X3 (a) Y4";
  written.words = {{.letter = 'G', .span = {0, 2}},
                   {.letter = 'G', .span = {3, 6}},
                   {.letter = 'X', .span = {7, 9}},
                   {.letter = 'Y', .span = {14, 16}}};
  const auto again = [&](std::size_t column, std::size_t length, std::size_t line = 7) {
    const Place place{"p.ngc", line, column, length, std::string(written.text)};
    const Refusal refusal(Diagnostic{"a-code", "it is so", "do that", place});
    return testing::refusal_of([&] { compensate::refuse_in_file(refusal, written, of_file); });
  };
  const Diagnostic y = again(15, 2);
  CHECK(y.code == "a-code");
  CHECK(y.message == "it is so");
  CHECK(y.help == "do that");
  CHECK(y.place.text == of_file.text);
  CHECK(y.place.column == 22);
  CHECK(y.place.length == 3);
  CHECK(again(4, 3).place.column == 7);  // the second G
  CHECK(again(1, written.text.size()).place.column == 1);
  CHECK(again(1, written.text.size()).place.length == of_file.text.size());
  CHECK(again(15, 2, 8).place.text == written.text);  // of another line: nothing to do
}
