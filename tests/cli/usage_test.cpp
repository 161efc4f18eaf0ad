// Wrong usage is exit code 2, and the message says what is expected.
#include <vector>

#include <catch2/catch.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;

TEST_CASE("help and version are results") {
  const Scratch scratch;
  const Outcome version = run(scratch, "--version");
  CHECK(version.code == 0);
  CHECK(version.out.starts_with("plumbline "));
  CHECK(run(scratch, "--help").code == 0);
  for (const char* const command : {"compensate", "error", "trace", "check", "simulate", "diff"}) {
    INFO(command);
    CHECK(contains(run(scratch, "--help").out, command));
    const Outcome help = run(scratch, std::string(command) + " --help");
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    CHECK(contains(help.out, "mm"));
    CHECK(contains(help.out, "deg"));
  }
}

TEST_CASE("what is missing or unknown is wrong usage") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  for (const std::string& arguments : std::vector<std::string>{
           "", "nonsense", "compensate", "compensate p.ngc", "compensate p.ngc -o out.ngc",
           "compensate p.ngc -o out.ngc -m", "check p.ngc", "simulate", "simulate p.ngc", "error p.csv", "diff p.ngc",
           "diff - -", "trace p.ngc --nonsense", "trace p.ngc extra", "diff p.ngc p.ngc --tolerance-mm -1",
           "diff p.ngc p.ngc --tolerance-mm x", "trace p.ngc -o ''", "diff p.ngc p.ngc --json ''", "trace ''"}) {
    INFO(arguments);
    const Outcome outcome = run(scratch, arguments);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("plumbline"));
    CHECK(contains(outcome.err, "--help"));
  }
}

TEST_CASE("values of options are checked before any file is read") {
  const Scratch scratch;
  struct Case {
    const char* option;
    const char* expected;
  };
  for (const Case& c :
       {Case{"--work-offset G54=1,2,3", "six numbers"}, Case{"--work-offset 1,2,3,4,5,6", "G54="},
        Case{"--start 1,2", "six numbers"}, Case{"--touch-off 1,2,3,4,5,x", "six numbers"}, Case{"--pass 428", "M428"},
        Case{"--dialect klingon", "linuxcnc, "}, Case{"--block-delete maybe", "on or off"},
        Case{"--step-angle 0", "deg"}, Case{"--step-length abc", "mm"}, Case{"--tool-in-spindle 1.5", "tool number"},
        Case{"--time-tolerance 2", "share"}}) {
    INFO(c.option);
    const Outcome outcome = run(scratch, "compensate missing.ngc -m missing.toml -o out.ngc " + std::string(c.option));
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, c.expected));
  }
}

TEST_CASE("negative numbers and spaces are values, not options") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  CHECK(run(scratch, "trace p.ngc --start -1,-2,-3,0,0,0 --work-offset ' G54 = -1, 2, 3, 0, 0, 0'").code == 0);
}

TEST_CASE("a misspelt command or option is answered with what was probably meant") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  struct Case {
    const char* arguments;
    const char* answer;
  };
  for (const Case& c : {Case{"check p.ngc --modle x", "no option --modle: did you mean --model?"},
                        Case{"check p.ngc --work-ofset=G54=0,0,0,0,0,0", "did you mean --work-offset?"},
                        Case{"compensate p.ngc --ouput o.ngc", "did you mean --output?"},
                        Case{"compensat p.ngc", "no command compensat: did you mean compensate?"},
                        Case{"simualte p.ngc", "did you mean simulate?"}, Case{"--hlep", "did you mean --help?"},
                        Case{"trace p.ngc --xyzzyxyzzy", "no option --xyzzyxyzzy"}}) {
    INFO(c.arguments);
    const Outcome outcome = run(scratch, c.arguments);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, c.answer));
  }
}
