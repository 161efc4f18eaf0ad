// Drilling cycles of an OSP: what they keep, and what no source says of them.
#include <string>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

TEST_CASE("OSP: a level of G71 holds no longer than the zero of its axis does") {
  check_osp({{"G15 H1\nT3 M6\nG56 H3 G0 X5 Y0 Z50\nG71 Z50\nM53\nG81 X5 Y0 Z-5 R2 F100\nG0 Z100\n"
              "T1 M6\nG0 X5 Y0\nG56 H1 Z50\nG81 X5 Y0 Z-5 R2 F100\nM2\n",
              11, 1, "nc-not-interpreted", "G71 Z"},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50\nM53\nG15 H2 G0 X0 Y0 Z50\nG82 X0 Y0 Z-5 R2 F100\nM2\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50\nM53\nG92 Z80\nG83 X0 Y0 Z-5 R2 Q1 F100\nM2\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\nG169 H1\nG0 Z50\nG85 X0 Y0 Z-5 R2 F100\nM2\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG18 M53\nG71 Y50\nG17\nG81 X0 Y0 Z-5 R2 F100\nM2\n", 5, 1, "nc-not-interpreted",
              "another plane"}});
  check_osp({{"G15 H1\nG56 H3 G0 X5 Y0 Z50\nG71 Z50 M53\nG81 X5 Y0 Z-5 R2 F100\nG0 Z100\nG56 H1 Z50\n"
              "G71 Z50\nG81 X5 Y0 Z-5 R2 F100\nM2\n",
              0, 0},
             {"G15 H1\nG56 H3 G0 X5 Y0 Z50\nG71 Z50 M53\nG56 H1 G0 Z60\nG56 H3 Z50\nG81 X5 Y0 Z-5 R2 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\nG92 X7\nG81 X0 Y0 Z-5 R2 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50 M54\nG15 H2 G0 X0 Y0 Z2\nG81 X0 Y0 Z-5 R2 F100\nM2\n", 0, 0}});
}

TEST_CASE("OSP: a block of a cycle names its hole") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\n";
  const auto check = [&](const std::string& rest, std::size_t line, std::size_t column) {
    const std::string program = begin + rest;
    check_osp({{program.c_str(), line, column}});
  };
  check("G81 X5 Y0 Z-5 R2 F100\nG81\nM2\n", 4, 1);
  check("G81 X5 Y0 Z-5 R2 F100\nZ-7\nM2\n", 4, 1);
  check("G81 X5 Y0 Z-5 R2 F100\nG82 R3 P100\nM2\n", 4, 1);
  check("G81 Z-5 R2 F100\nM2\n", 3, 1);
  check("G81 X5 Z-5 R2 F100\nM2\n", 0, 0);
  check("G81 X5 Y0 Z-5 R2 F100\nX7\nY3 Z-8\nG82 X1 Z-8 R2\nG0 Z60\nM2\n", 0, 0);
}

TEST_CASE("OSP: G83 pecks by Q, or by I with J for the depth after which the tool comes up") {
  const std::string begin = "G15 H1 G0 X5 Y0 Z50\nG71 Z50\n";
  for (const std::string block : {"G83 X5 Y0 Z-20 R2 I3 J9 F100 M53\n", "G83 X5 Y0 Z-20 R2 P500 I3 J9 F100 M53\n",
                                  "G83 X5 Y0 Z-20 R2 Q3 F100 M53\n", "G73 X5 Y0 Z-20 R2 I3 J9 F100 M53\n"}) {
    check_osp({{(begin + block + "X9\nM2\n").c_str(), 0, 0}});
  }
  check_osp({{(begin + "G83 X5 Y0 Z-20 R2 I3 F100 M53\nM2\n").c_str(), 3, 19},
             {(begin + "G83 X5 Y0 Z-20 R2 Q3 J9 F100 M53\nM2\n").c_str(), 3, 22},
             {(begin + "G73 X5 Y0 Z-20 R2 Q3 I3 J9 F100 M53\nM2\n").c_str(), 3, 22}});
}

TEST_CASE("OSP: a cycle waits where P says so") {
  for (const char* const code : {"G82", "G86", "G89"}) {
    for (const std::string wait : {"", " P500", " P0.5"}) {
      const bool waits = !wait.empty();
      const ProgramFile text(std::string("G15 H1 G0 X5 Y0 Z50\nG71 Z50\n") + code + " X5 Y0 Z-20 R2 F100 M53" + wait +
                             "\nM2\n");
      const InputFile file(text.path());
      Program blocks(file, dialect("okuma"), empty_tables());
      double seconds = 0;
      std::size_t dwells = 0;
      while (const Step* step = blocks.next()) {
        for (const Motion& motion : step->motions) {
          if (motion.kind != MotionKind::dwell) continue;
          ++dwells;
          seconds += motion.dwell_s;
        }
      }
      INFO(code);
      CHECK(dwells == (waits ? 1 : 0));
      CHECK(seconds == (waits ? 0.5 : 0));
    }
  }
}

TEST_CASE("OSP: a hole that stays a cycle has no finer words than the control keeps") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\nM3 S100\n";
  const auto check = [&](const std::string& rest, std::size_t line, std::size_t column) {
    check_osp({{(begin + rest).c_str(), line, column}});
  };
  check("G82 X5 Y0 Z-5.0004 R2 P1 F100\nM2\n", 4, 11);
  check("G84 X5 Y0 Z-5 R2.12345 F100\nM2\n", 4, 15);
  check("G82 X5 Y0 Z-5 R2 P1 F100\nX7.1234\nM2\n", 5, 1);
  check("G82 X5.123 Y0 Z-5.0000 R2 P1 F100\nX7.12\nM2\n", 0, 0);
  check("G81 X5.1234 Y0 Z-5.1234 R2 F100\nM2\n", 0, 0);
}

TEST_CASE("OSP: A, B and C beside a hole are read where they turn nothing") {
  const std::string begin = "G15 H1 G0 X5 Y0 Z50 A0 B0 C30\nG71 Z50 M53\n";
  const auto check = [&](const std::string& rest, std::size_t line, std::size_t column, const char* code = "") {
    const std::string program = begin + rest + "M2\n";
    check_osp({{program.c_str(), line, column, code}});
  };
  check("G81 X5 Y0 Z-5 R2 A0 B0 C30 F100\nX7 A0\n", 0, 0);
  check("G82 X5 Y0 Z-5 R2 P500 C30. F100\nX7 C30\n", 0, 0);
  check("G84 X5 Y0 A0 Z-5 R2 F100\nX7 Y3 B0\n", 0, 0);
  check("G81 X5 Y0 Z-5 R2 A0 C0 F100\n", 3, 21, "nc-axes-unused");
  check("G81 X5 Y0 Z-5 R2 F100\nX7 A0.001\n", 4, 4, "nc-axes-unused");
  check("G81 X5 Y0 Z-5 R2 F100\nA0\n", 4, 1, "nc-not-interpreted");
}

TEST_CASE("OSP: a hole that is a whole number of pecks deep has no peck more, whatever a sum of them comes to") {
  const auto pecks = [](const std::string& levels) {
    const ProgramFile text("G15 H1 G0 X5 Y0 Z50\nG71 Z50 M53\nG83 X5 Y0 F100 " + levels + "\nM2\n");
    const InputFile file(text.path());
    ProgramSettings settings;
    settings.work_offsets[0] = WorkOffset{};
    Program program(file, dialect("okuma"), settings);
    int feeds = 0;
    while (const Step* const step = program.next()) {
      for (const Motion& motion : step->motions) feeds += motion.kind == MotionKind::feed ? 1 : 0;
    }
    return feeds;
  };
  CHECK(pecks("Z-4.985 R3.015 I2 J4") == 4);
  CHECK(pecks("Z-4.985 R3.015 Q2") == 4);
  CHECK(pecks("Z-0.7 R0.2 Q0.1") == 9);
  CHECK(pecks("Z-0.701 R0.2 Q0.1") == 10);
  CHECK(pecks("Z-1.1 R2.2 Q1.1") == 3);
}

TEST_CASE("OSP: G80 does not stand in the block of a cycle") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z50\nG71 Z50\n";
  const auto check = [&](const std::string& rest, std::size_t line, std::size_t column) {
    const std::string program = begin + rest;
    check_osp({{program.c_str(), line, column, "nc-same-group", "G80"}});
  };
  check("G81 X5 Y5 Z0 R2 F100 M53 G80\nG0 Z20\nM2\n", 3, 26);
  check("G80 G83 X5 Y5 Z0 R2 Q1 F100 M53\nG0 Z20\nM2\n", 3, 1);
  check("G81 X5 Y5 Z0 R2 F100 M53\nG82 G80 X9\nM2\n", 4, 5);
  const std::string read = begin + "G81 X5 Y5 Z0 R2 F100 M53\nG80\nG0 Z60\nM2\n";
  check_osp({{read.c_str(), 0, 0}});
}

TEST_CASE("OSP: a cycle code that is written again states all its words") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\n";
  const auto check = [&](const std::string& rest, std::size_t line, const char* part = "") {
    const std::string program = begin + rest + "G0 Z60\nM2\n";
    check_osp({{program.c_str(), line, line == 0 ? std::size_t{0} : std::size_t{1}, "nc-not-interpreted", part}});
  };
  check("G82 X5 Y5 Z-5 R2 P500 F100\nG82 X7\n", 4, "Z, R, P");
  check("G82 X5 Y5 Z-5 R2 P500 F100\nG82 X7 Z-5 R2\n", 4, "without P");
  check("G83 X5 Y5 Z-20 R2 I3 J9 F100\nG83 X7 Z-20 R2 Q3\n", 4, "without J");
  check("G85 X5 Y5 Z-5 R2 F100 FA=300\nG85 X7 Z-5 R2\n", 4, "without FA");
  check("G81 X5 Y5 Z-5 R2 F100\nG83 X7 Z-5 R2\n", 4, "without Q");
  check("G81 X5 Y5 Z-5 R2 F100\nG81 X7 Z-8\n", 4, "without R");
  check("G82 X5 Y5 Z-5 R2 P500 F100\nX7\nX9\nG82 X7 Z-5 R2 P400\n", 0);
  check("G85 X5 Y5 Z-5 R2 F100 FA=300\nG81 X7 Z-5 R2\n", 0);
  check("G82 X5 Y5 Z-5 R2 P500 F100\nG80\nG81 X7 Y5 Z-5 R2\n", 0);
}

TEST_CASE("OSP: J of a peck is greater than 0") {
  const std::string begin = "G15 H1 G0 X5 Y0 Z50\nG71 Z50\n";
  check_osp({{(begin + "G83 X5 Y0 Z-20 R2 I3 J0 F100 M53\nM2\n").c_str(), 3, 22, "nc-out-of-range"},
             {(begin + "G83 X5 Y0 Z-20 R2 I3 J-9 F100 M53\nM2\n").c_str(), 3, 22},
             {(begin + "G73 X5 Y0 Z-20 R2 I3 J0 F100 M53\nM2\n").c_str(), 3, 22, "nc-out-of-range"},
             {(begin + "G73 X5 Y0 Z-20 R2 I3 J0.5 F100 M53\nM2\n").c_str(), 0, 0}});
}

TEST_CASE("OSP: whether G1, G2 or G3 ends a cycle is said, with axes or without") {
  const std::string cycle = "G15 H1 G90 G94 G0 X0 Y0 Z50 A0 B0 C0\nS500 M3\nG71 Z50\nG81 X0 Y0 Z-5 R3 F100 M53\n";
  for (const char* const line : {"G1 F200\nX20 Y5\n", "G1 X20 F200\n", "G2\nX20 Y0 I10 J0\n", "G3 F50\n"}) {
    const std::string program = cycle + line + "M2\n";
    check_osp({{program.c_str(), 5, 1}});
  }
  const std::string ended = cycle + "G80\nG0 Z60\nG1 F200\nX20 Y5\nM2\n";
  check_osp({{ended.c_str(), 0, 0}});
}

TEST_CASE("OSP: a place of a hole that stays a cycle, finer than the control keeps, is told how to be worked out") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z50\nM3 S500\nG71 Z50 M53\n";
  check_osp({{(begin + "G84 X=10*COS[50] Y=10*SIN[50] Z-5 R2 F100\nM2\n").c_str(), 4, 5, "nc-not-interpreted",
              "X=ROUND[VC1*1000]/1000"},
             {(begin + "G82 X0 Y=10/3 Z-5 R2 P100 F100\nM2\n").c_str(), 4, 8, "nc-not-interpreted", "ROUND"},
             {(begin + "VC1=10*COS[50]\nG84 X=ROUND[VC1*1000]/1000 Y0 Z-5 R2 F100\nM2\n").c_str(), 0, 0}});
}
