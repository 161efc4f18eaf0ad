// Wrong usage is exit code 2, and the message says what is expected.
#include <vector>

#include <catch2/catch.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;

TEST_CASE("no number of an option may be nan or without end") {
  const Scratch scratch;
  for (const char* const words :
       {"control linuxcnc -m x -o y --speed nan", "control linuxcnc -m x -o y --acceleration inf",
        "plan -m x --bar-noise nan", "plan -m x --torque-noise inf", "plan -m x --feed 500,nan",
        "plan -m x --payload nan", "plan -m x --feed 0", "plan -m x --radius 100,0", "plan -m x --payload 2000",
        "plan -m x --bar-noise 1e-9", "plan -m x --torque-noise 1e6", "plan -m x --bar -1",
        "calibrate -m x -d y -o z --joint-sigma nan", "calibrate -m x -d y -o z --offset-sigma 0",
        "diff a b --tolerance-mm nan", "diff a b --tolerance-deg -1", "compare -m x -d y --max-radial-um nan",
        "batch a -o b --watch --poll nan"}) {
    INFO(words);
    const Outcome outcome = run(scratch, words);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "is no number "));
  }
}

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

TEST_CASE("what stands wrongly on the command line is named as its user would") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  for (const char* name : {"-there", "-model.ngc", "-outer.ngc"}) scratch.file(name, kPart);
  struct Case {
    const char* arguments;
    const char* expected;
  };
  for (const Case& c :
       {Case{"", "name a command: compensate, "},
        Case{"restore p.ngc", "-o FILE is required"},
        Case{"restore", "PROGRAM and -o FILE are required"},
        Case{"compensate", "PROGRAM is required"},
        Case{"compensate -lead.ngc -m m.toml", "name the file as ./-lead.ngc"},
        Case{"trace -there", "name the file as ./-there"},
        Case{"diff p.ngc -x.nc", "name the file as ./-x.nc"},
        Case{"compensate -model.ngc -o o.ngc", "-model.ngc is read as -m odel.ngc: if it is the file"},
        Case{"compensate -model.ngc -m m.toml -o o.ngc", "write ./-model.ngc"},
        Case{"trace -outer.ngc", "-outer.ngc is read as -o uter.ngc"},
        Case{"trace -zz", "no option -z"},
        Case{"compensate p.ngc -m m.toml -o", "-o needs its value: -o FILE"},
        Case{"compensate p.ngc -m -o out.ngc", "-m needs its value: -m "},
        Case{"compensate p.ngc -o o.ngc --undo o.undo", "o.undo is one too many: --undo is a switch"},
        Case{"compensate p.ngc -o o.ngc --guard yes", "yes is one too many: --guard is a switch"},
        Case{"diff p.ngc p.ngc p.ngc", "p.ngc is one too many: plumbline diff takes A, B"},
        Case{"compensate p.ngc -o o.ngc q.ngc r.ngc", "is one too many"},
        Case{"compensate p.ngc -m a.toml -m b.toml -o o.ngc", "-m stands twice"},
        Case{"trace p.ngc --work-offset G54 0 0 -1008", "is one too many: the value of --work-offset"},
        Case{"diff p.ngc p.ngc --step-length 3", "no option --step-length here: it belongs to compensate, "},
        Case{"compensate p.ngc -o o.ngc -m m.toml --tolerance 0.5um --step-angle 1", "say nothing beside it"},
        Case{"check p.ngc -m m.toml --step-length 1 --tolerance 0.5um", "say nothing beside it"},
        Case{"compensate p.ngc -o o.ngc -m m.toml --tolerance 0.5", "a length with its unit"},
        Case{"compensate p.ngc -o o.ngc -m m.toml --tolerance 1um --first-order", "--tolerance cannot be kept with it"},
        Case{"simulate p.ngc --tolerance 1um", "no option --tolerance here: it belongs to compensate, "},
        Case{"check p.ngc --undo", "no option --undo here: it belongs to compensate"},
        Case{"check p.ngc -x", "no option -x\n"},
        Case{"trace p.ngc --dialect fanuk", "did you mean fanuc?"}}) {
    INFO(c.arguments);
    const Outcome outcome = run(scratch, c.arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, c.expected));
  }
}

TEST_CASE("files of other tools are called what they are") {
  const Scratch scratch;
  scratch.file("model.nc", "plumbline = \"machine 1\"\n");
  scratch.file("part.nc", "solid part\nfacet normal 0 0 1\n");
  scratch.file("plain.nc", "0 BEGIN PGM 1 MM\n1 L X+0 FMAX\n");
  scratch.file("result.nc", "{\"plumbline\": \"diff 1\"}\n");
  for (const char* const name : {"model.nc", "part.nc", "plain.nc", "result.nc"}) {
    const Outcome outcome = run(scratch, std::string("trace ") + name);
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "[file-not-text]"));
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
