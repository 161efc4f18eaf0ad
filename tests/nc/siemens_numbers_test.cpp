// What a SINUMERIK makes of numbers: fractions where whole numbers belong, halves below zero, names declared twice.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "nc/siemens_cases.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::string x_at_end(const std::vector<Motion>& motions) {
  return fmt::format("X{:g}", motions.empty() ? 0 : motions.back().to[Axis::X]);
}

void check_numbers(const std::string& expected, const std::vector<std::string>& programs) {
  check_siemens("G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0\n", x_at_end, expected, programs);
}

}  // namespace

TEST_CASE("MOD and DIV are of whole numbers") {
  check_numbers("nc-not-whole", {"R1=7.5\nR2=R1 MOD 2\n", "X=7 MOD 2.5\n", "X=7.5 DIV 2\n", "R1=0.5\nX=3 DIV R1\n",
                                 "DEF REAL DEPTH=-12.25\nX=DEPTH MOD 5\n", "R1=0.1\nX=(R1+R1+R1)*10 MOD 3\n"});
  check_numbers("X1",
                {"X=7 MOD 2\n", "R1=7.5\nX=TRUNC(R1) MOD 2\n", "DEF INT COUNT=9\nX=COUNT MOD 4\n", "X=7 DIV 4\n"});
  check_numbers("nc-not-interpreted", {"X=-7 MOD 2\n", "X=-7 DIV 4\n", "R1=-2\nX=7 MOD R1\n", "X=7 DIV (2-4)\n"});
}

TEST_CASE("halves below zero are rounded in a way that no source says") {
  check_numbers("nc-not-interpreted",
                {"X=ROUND(-2.5)\n", "R1=ROUND(-0.5)\n", "R2=7\nX=ROUND(-R2/2)\n", "DEF INT COUNT\nCOUNT=-2.5\n",
                 "DEF INT COUNT=-1.5\n", "DEF INT COUNT\nCOUNT=1-0.5*3\n", "X=ROUND(0.7-0.2)\n",
                 "DEF INT COUNT=2.3-0.8\n", "SUB(-3.5)\nM30\n%_N_SUB_SPF\nPROC SUB(INT TIMES)\nX=TIMES\nRET\n"});
  check_numbers("X3", {"X=ROUND(2.5)\n", "DEF INT COUNT=2.5\nX=COUNT\n", "DEF REAL WIDTH=-2.5\nX=WIDTH+5.5\n",
                       "X=5+ROUND(-2.4)\n", "DEF INT COUNT=-2.6\nX=6+COUNT\n"});
}

TEST_CASE("CASE chooses by whole numbers") {
  check_numbers(
      "nc-not-whole",
      {"R1=2.4\nCASE R1 OF 2 GOTOF AA\nAA: X1\n", "CASE 2 OF 2.4 GOTOF AA 2 GOTOF AA\nAA: X1\n",
       "R1=0.1\nCASE (R1+R1+R1)*10 OF 3 GOTOF AA DEFAULT GOTOF AA\nAA: X1\n", "CASE -0.5 OF 0 GOTOF AA\nAA: X1\n"});
  check_numbers("X3",
                {"R1=2.4\nCASE ROUND(R1) OF 2 GOTOF AA\nX9\nM30\nAA: X3\n", "CASE 1.0 OF 1 GOTOF AA\nX9\nM30\nAA: X3\n",
                 "CASE 4 OF 1 GOTOF AA DEFAULT GOTOF BB\nAA: X9\nM30\nBB: X3\n"});
}

TEST_CASE("ROUNDUP goes to the next whole number upwards") {
  check_numbers("X4", {"X=ROUNDUP(3.1)\n", "X=ROUNDUP(3.6)\n", "R1=7\nX=ROUNDUP(R1/2)\n", "X=ROUNDUP(4)\n"});
  check_numbers("X-3", {"X=ROUNDUP(-3.1)\n", "X=ROUNDUP(-3.6)\n", "X=-ROUNDUP(2.5)\n"});
}

// [V 1.6]
TEST_CASE("BOUND keeps a value between a minimum and a maximum") {
  check_numbers("X10", {"X=BOUND(10,40,3)\n", "R1=-5\nX=BOUND(10,40,R1)\n", "DEF REAL AA=10\nX=BOUND(AA,40,AA)\n",
                        "X=BOUND(-4,10,R2+12)\n", "X=2*BOUND(5,5,7)\n"});
  check_numbers("X25", {"X=BOUND(10,40,25)\n", "R1=20\nX=BOUND(R1,R1+5,99)\n", "X=MAXVAL(2,BOUND(1,25,26))\n"});
  check_numbers("nc-not-interpreted", {"X=BOUND(40,10,25)\n", "R1=3\nX=BOUND(R1,R1-1,5)\n", "X=BOUND(0,-1,0)\n"});
  check_numbers("nc-operator", {"X=BOUND(1,2)\n", "X=BOUND(1,2,3,4)\n"});
}

TEST_CASE("an angle of nothing is none") {
  check_numbers("nc-arithmetic", {"X=ATAN2(0,0)\n", "A=ATAN2(R1,R2)\n", "R3=ATAN2(R1*5,0)\n"});
  check_numbers("X90", {"X=ATAN2(1,0)\n", "R1=2\nX=ATAN2(R1,R2)\n"});
}

TEST_CASE("a name is declared once") {
  check_numbers("nc-assignment", {"DEF REAL WIDTH=3\nDEF REAL WIDTH\nX=WIDTH\n", "DEF REAL WIDTH, DEPTH, WIDTH\n",
                                  "DEF INT COUNT=1\nDEF REAL count=2\n",
                                  "SUB(3)\nM30\n%_N_SUB_SPF\nPROC SUB(REAL TIMES)\nDEF REAL TIMES\nX=TIMES\nRET\n"});
  check_numbers("X3", {"DEF REAL WIDTH=1\nSUB\nX=WIDTH+2\nM30\n%_N_SUB_SPF\nDEF REAL WIDTH=9\nX=WIDTH\nRET\n",
                       "SUB P3\nM30\n%_N_SUB_SPF\nDEF REAL WIDTH=3\nX=WIDTH\nRET\n"});
}

TEST_CASE("values behind addresses are of all but N, G and L") {
  check_numbers("nc-assignment", {"R1=2\nG=R1-1 X5\n", "G=1 X5\n", "N=5 X5\n", "L=R1\n", "G = 54\n"});
  check_numbers("X5", {"R1=5\nX=R1\n", "G1 X=5 F=R2+100 S=500\n", "D=R1 G0 X5\n"});
}

TEST_CASE("numbers that differ by less than 1e-12 of them compare as the same") {
  check_numbers("X3", {"R1=0\nWHILE R1<=0.3\nX=R1*10\nR1=R1+0.1\nENDWHILE\n", "R1=0.3\nIF R1>=0.1+0.2\nX3\nENDIF\n",
                       "R1=9000.1+0.2\nIF R1==9000.3\nX3\nENDIF\n", "IF 0.1+0.2<>0.3\nX9\nELSE\nX3\nENDIF\n",
                       "R1=0\nREPEAT\nR1=R1+0.1\nX=R1/0.8*3\nUNTIL R1>=0.8\n", "IF 0.1+0.3>0.3\nX3\nENDIF\n",
                       "IF 0.1+0.2<0.300001\nX3\nENDIF\n", "R1=5-5\nIF R1==0\nX3\nENDIF\n",
                       "IF 0.00000001==0\nX9\nELSE\nX3\nENDIF\n"});
  check_numbers("nc-not-interpreted", {"R1=61.01 R2=61.02 R3=0.01\nIF ABS(R2-R1)>R3 GOTOF AA\nX1\nAA: X2\n",
                                       "IF 0.1+0.2>0.3\nX1\nENDIF\n", "R1=0.1+0.2-0.3\nIF R1==0\nX1\nENDIF\n",
                                       "R1=0.1+0.2-0.3\nIF R1>0\nX1\nENDIF\n", "IF 1.000000000001==1\nX1\nENDIF\n"});
}

TEST_CASE("an INT has 32 bits, and a level of block skip one digit") {
  check_numbers("nc-out-of-range", {"DEF INT II=3000000000\n", "DEF INT II=2147483647\nII=II+1\n",
                                    "DEF INT II\nR1=-70000\nII=R1*R1*R1\n"});
  check_numbers("X3", {"DEF INT II=2147483647\nX3\n", "DEF REAL RR=3000000000\nX=RR/1000000000\n"});
  check_numbers("nc-not-interpreted", {"/10 G1 X3\n", "/12\n"});
}
