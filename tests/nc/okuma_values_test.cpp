// Variables of an OSP that have no value, and numbers finer than the control keeps.
#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"

using namespace plumbline::nc::tests;

TEST_CASE("OSP: what has no value is compared, and nothing else comes of it") {
  check_osp({{"G15 H1 G0 X0\nLA=EMPTY\nIF [LA EQ EMPTY] N10\nX1\nN10 X2\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nLB=LC\nIF [LB EQ EMPTY] N10\nX1\nN10 X2\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nLB=LC\nX=LB\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nVC1=EMPTY\nX=VC1+1\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nVC1=-LC\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nCALL OSUB PX=LC\nM2\nOSUB\nRTS\n", 2, 11, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nIF [LC] N10\nX1\nN10 X2\nM2\n", 2, 1, "nc-flow-control", "no condition"}});
  check_osp({{"G15 H1 G0 X0\nIF [LC EQ EMPTY] N10\nX1\nN10 X2\nM2\n", 0, 0},
             {"G15 H1 G0 X0\nLC=0\nIF [LC NE EMPTY] N10\nX1\nN10 X=LC\nM2\n", 0, 0},
             {"G15 H1 G0 X0\nCALL OSUB PX=1\nM2\nOSUB\nIF [PY EQ EMPTY] N1\nX=PY\nN1 X=PX\nRTS\n", 0, 0}});
}

TEST_CASE("OSP: an increment finer than the control keeps is refused") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G1 X0.1234 F100\nM2\n", 2, 8, "nc-not-interpreted", "0.001 mm"},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G0 A0.00005\nM2\n", 2, 8, "nc-not-interpreted", "0.001 deg"},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nVC1=1\nG91 G0 Y=VC1/3\nM2\n", 3, 8, "nc-not-interpreted", "3 decimals"},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G0 Z1000.0004\nM2\n", 2, 8}});
  check_osp({{"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G1 X0.123 Y10.0000 A2.5 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G1 X0.123 Y10.0000 F100\nG0 A2.505\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG90 G1 X0.12345 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nVC1=0.1\nG91 G0 Y=VC1+0.2\nX=VC1*3\nM2\n", 0, 0}});
}
