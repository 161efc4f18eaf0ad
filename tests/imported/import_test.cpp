// Twelve layouts of one circle, three of them with a fault: read right, or refused at line and column.
#include "imported/import.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "imported/layouts.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using imported::Imported;

namespace {

constexpr double kAngles = 1e-6;  // deg

Imported made(const Scratch& scratch, const std::string& map, const std::vector<std::string>& files) {
  std::vector<std::string> paths;
  for (const std::string& file : files) paths.push_back(scratch.path(file));
  return imported::import_files(imported::parse_map(map, "map.toml"), paths);
}

// Whether a run holds one turn with what is measured at its angles. `torques`: whether there are any.
void check_turn(const measure::Run& run, std::size_t samples, bool torques, double tolerance = 1e-4) {
  REQUIRE(run.samples() == samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double deg = run.angle[i] / kDeg;
    INFO(run.id << " sample " << i << " at " << deg);
    CHECK(deg > -kAngles);
    CHECK(deg < 360);
    if (run.has_radial()) CHECK(run.radial[i] / kUm == Approx(radial_um(deg)).margin(tolerance));
    CHECK(run.has_torque() == torques);
    for (int j = 0; torques && j < 6; ++j) {
      CHECK(run.torque[static_cast<std::size_t>(j)][i] == Approx(torque_of(j + 1, deg)).margin(tolerance));
    }
  }
}

const std::string kAngleAndBar =
    "[columns]\nangle = {name = \"a\", unit = \"deg\"}\nradial = {name = \"r\", unit = \"um\"}\n";

}  // namespace

TEST_CASE("layout 1: names with commas between, one turn") {
  const Scratch scratch;
  scratch.file("c.csv", "a,r\n" + lines(way(0, 357), [](const Moment& m) {
                          return fmt::format("{:.3f},{:.5f}", m.deg, radial_um(m.deg));
                        }));
  const Imported found = made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"});
  check_turn(found.dataset.runs.at(0), 120, false);
  CHECK(found.taken.at(0).first_line == 2);
  CHECK(found.taken.at(0).last_line == 121);
}

TEST_CASE("layout 2: semicolons, decimal commas, comments, a line of units, Latin-1, mm, the whole length of the bar") {
  const Scratch scratch;
  scratch.file("c.txt",
               "# Pr\xfc"
               "fstand\nWinkel;L\xe4nge\n\xb0;mm\n" +
                   lines(way(0, 357), [](const Moment& m) {
                     return comma(fmt::format("{:.3f};{:.8f}", m.deg, 150 + radial_um(m.deg) / 1000));
                   }));
  const std::string map = kMapHead +
                          "[table]\ndelimiter = \";\"\ndecimal = \",\"\ncomment = \"#\"\nunit_lines = 1\n[columns]\n"
                          "angle = {name = \"Winkel\", unit = \"deg\"}\n"
                          "radial = {name = \"L\u00e4nge\", unit = \"mm\", minus = 150}\n" +
                          map_run("one", "c.txt");
  const Imported found = made(scratch, map, {"c.txt"});
  CHECK(found.tables.at(0).encoding == "latin-1");
  check_turn(found.dataset.runs.at(0), 120, false);
}

TEST_CASE("layout 3: UTF-16 with its mark, tabs, radians, inches, inward positive") {
  const Scratch scratch;
  const std::string text = "phi\tdev\r\n" + lines(way(0, 357), [](const Moment& m) {
                             return fmt::format("{:.9f}\t{:.9f}\r", m.deg * kPi / 180, -radial_um(m.deg) / 25400);
                           });
  std::string wide = "\xff\xfe";
  for (const char c : text) wide += {c, '\0'};
  scratch.file("c.txt", wide);
  const std::string map = kMapHead +
                          "[table]\ndelimiter = \"tab\"\n[columns]\nangle = {name = \"phi\", unit = \"rad\"}\n"
                          "radial = {name = \"dev\", unit = \"inch\", sign = -1}\n" +
                          map_run("one", "c.txt");
  check_turn(made(scratch, map, {"c.txt"}).dataset.runs.at(0), 120, false);
}

TEST_CASE("layout 4: a run-in of 180 deg and a run-out, angles that go on") {
  const Scratch scratch;
  scratch.file("c.csv", "a,r\n" + lines(way(-180, 540), [](const Moment& m) {
                          return fmt::format("{:.3f},{:.5f}", m.deg, radial_um(m.deg));
                        }));
  const Imported found = made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"});
  check_turn(found.dataset.runs.at(0), 120, false);
  CHECK(found.dataset.runs.at(0).angle.front() / kDeg == Approx(0).margin(kAngles));
  CHECK(found.taken.at(0).before / kDeg == Approx(180));
  CHECK(found.taken.at(0).sweep / kDeg == Approx(720));
}

TEST_CASE("layout 5: time alone, in ms, the feed and a run-in tell the angle") {
  const Scratch scratch;
  scratch.file("c.csv", "t,r\n" + lines(way(-180, 540), [](const Moment& m) {
                          return fmt::format("{:.5f},{:.5f}", 1000 * m.seconds, radial_um(m.deg));
                        }));
  const std::string columns =
      "[columns]\ntime = {name = \"t\", unit = \"ms\"}\nradial = {name = \"r\", unit = \"um\"}\n";
  const Imported found = made(scratch, kMapHead + columns + map_run("one", "c.csv"), {"c.csv"});
  check_turn(found.dataset.runs.at(0), 120, false, 1e-3);
  CHECK(found.taken.at(0).angle_from == "time and feed");
  // the record begins elsewhere, and the run-in is shorter than the run-out
  const Imported from =
      made(scratch, kMapHead + columns + map_run("one", "c.csv", "ccw", "start_angle_deg = -180\nrun_in_deg = 90"),
           {"c.csv"});
  CHECK(from.dataset.runs.at(0).angle.front() / kDeg == Approx(270).margin(1e-3));
  check_turn(from.dataset.runs.at(0), 120, false, 1e-3);
}

TEST_CASE("layout 6: places of the tip, standing still before and after, both directions in one file") {
  const Scratch scratch;
  const auto line = [](const Moment& m) {
    const double phi = m.deg * kPi / 180;
    std::string text = fmt::format("{:.5f} {:.6f} {:.6f} {:.5f}", m.seconds, 144 * std::cos(phi),
                                   100 + 144 * std::sin(phi), radial_um(m.deg));
    for (int j = 1; j <= 6; ++j) text += fmt::format(" {:.6f}", torque_of(j, m.deg));
    return text;
  };
  const auto still = [&](double deg, double from) {
    std::vector<Moment> moments;
    for (int i = 0; i < 30; ++i) moments.push_back({from + 0.4 * i, deg});
    return moments;
  };
  scratch.file("c.dat", lines(still(-180, 0), line) + lines(way(-180, 540, 3, 20), line) +
                            lines(still(540, 200), line) + lines(way(540, -180, 3, 230), line) +
                            lines(still(-180, 400), line));
  std::string map = kMapHead +
                    "[table]\ndelimiter = \"blanks\"\nheader = false\n[columns]\n"
                    "time = {column = 1, unit = \"s\"}\nx = {column = 2, unit = \"mm\"}\n"
                    "y = {column = 3, unit = \"mm\"}\nradial = {column = 4, unit = \"um\"}\n";
  for (int j = 1; j <= 6; ++j) map += fmt::format("torque{} = {{column = {}, unit = \"Nm\"}}\n", j, 4 + j);
  map += map_run("there", "c.dat") + map_run("back", "c.dat", "cw");
  const Imported found = made(scratch, map, {"c.dat"});
  REQUIRE(found.dataset.runs.size() == 2);
  check_turn(found.dataset.runs[0], 120, true, 1e-3);
  check_turn(found.dataset.runs[1], 120, true, 1e-3);
  CHECK(found.taken[1].circle == 2);
  CHECK(found.taken[1].circles == 2);
}

TEST_CASE(
    "one angle that leaves its neighbours is refused at its line, where most of the circle would be thrown away") {
  for (const char* const bad : {"99999", "45", "-170.5"}) {
    const Scratch scratch;
    std::string text = "a,r\n";
    for (const Moment& m : way(0, 357))
      text += m.deg == 150 ? std::string(bad) + ",1\n" : fmt::format("{:.3f},{:.5f}\n", m.deg, radial_um(m.deg));
    scratch.file("c.csv", text);
    const Diagnostic d =
        refusal_of([&] { made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"}); });
    CHECK(d.code == "import-number");
    CHECK(d.place.line == 52);
  }
}

TEST_CASE("a time in another unit than the map says is refused by the feed") {
  for (const auto& [unit, factor] : {std::pair{"s", 1000.0}, std::pair{"ms", 1.0}, std::pair{"min", 1.0}}) {
    const Scratch scratch;
    scratch.file("c.csv", "t,a,r\n" + lines(way(0, 357), [f = factor](const Moment& m) {
                            return fmt::format("{:.6f},{:.3f},{:.5f}", m.seconds * f, m.deg, radial_um(m.deg));
                          }));
    const std::string map = kMapHead + "[columns]\ntime = {name = \"t\", unit = \"" + unit +
                            "\"}\nangle = {name = \"a\", unit = \"deg\"}\nradial = {name = \"r\", unit = \"um\"}\n" +
                            map_run("one", "c.csv");
    const Diagnostic d = refusal_of([&] { made(scratch, map, {"c.csv"}); });
    CHECK(d.code == "import-value");
    CHECK(d.help.find("unit of the column time") != std::string::npos);
  }
}

TEST_CASE("layout 7: motors in another order, as currents and per cent of rated, one turned around") {
  const Scratch scratch;
  scratch.file("c.csv", "a,m6,m5,m4,m3,m2,m1\n" + lines(way(0, 357), [](const Moment& m) {
                          return fmt::format("{:.3f},{:.7f},{:.7f},{:.7f},{:.7f},{:.7f},{:.7f}", m.deg,
                                             torque_of(6, m.deg) / 0.5, torque_of(5, m.deg) / 0.12,
                                             -torque_of(4, m.deg), torque_of(3, m.deg) * 1000, torque_of(2, m.deg),
                                             torque_of(1, m.deg));
                        }));
  const std::string map = kMapHead + R"([columns]
angle = {name = "a", unit = "deg"}
torque1 = {name = "m1", unit = "Nm"}
torque2 = {name = "m2", unit = "Nm"}
torque3 = {name = "m3", unit = "Nmm"}
torque4 = {name = "m4", unit = "Nm", sign = -1}
torque5 = {name = "m5", unit = "percent", rated_Nm = 12}
torque6 = {name = "m6", unit = "A", Nm_per_A = 0.5}
)" + map_run("one", "c.csv");
  check_turn(made(scratch, map, {"c.csv"}).dataset.runs.at(0), 120, true);
}

TEST_CASE("layout 8: motors in a file of their own, on a clock of their own, at another rate") {
  const Scratch scratch;
  const double ahead = 7.25;  // s, by which their clock shows more
  scratch.file("bar.csv", "t,a,r\n" + lines(way(0, 357), [](const Moment& m) {
                            return fmt::format("{:.6f},{:.3f},{:.5f}", m.seconds, m.deg, radial_um(m.deg));
                          }));
  scratch.file("drives.csv", "clock,1,2,3,4,5,6\n" + lines(way(-30, 390, 0.5), [&](const Moment& m) {
                               const double deg_per_s = 1000 / 60.0 / 144 * 180 / kPi;
                               std::string text = fmt::format("{:.6f}", ahead + m.deg / deg_per_s);
                               for (int j = 1; j <= 6; ++j) text += fmt::format(",{:.7f}", torque_of(j, m.deg));
                               return text;
                             }));
  std::string map = kMapHead +
                    "[columns]\ntime = {name = \"t\", unit = \"s\"}\nangle = {name = \"a\", unit = \"deg\"}\n"
                    "radial = {name = \"r\", unit = \"um\"}\n[clock]\nmotors_later_s = 7.25\n"
                    "[motors.columns]\ntime = {name = \"clock\", unit = \"s\"}\n";
  for (int j = 1; j <= 6; ++j) map += fmt::format("torque{0} = {{name = \"{0}\", unit = \"Nm\"}}\n", j);
  map += map_run("one", "bar.csv", "ccw", "motors_file = \"drives.csv\"");
  check_turn(made(scratch, map, {"bar.csv", "drives.csv"}).dataset.runs.at(0), 120, true, 1e-3);
}

TEST_CASE("layout 9: what LinuxCNC's halsampler prints, averaged to 120 samples a turn") {
  const Scratch scratch;
  // sampler cfg=ffffffff, halsampler -t: number, X, Y, six torques; the word stands first where it counts on
  std::size_t number = 4711;
  scratch.file("c.samples", "overrun\n" + lines(way(-90, 450, 0.1), [&](const Moment& m) {
                              const double phi = m.deg * kPi / 180;
                              std::string text =
                                  fmt::format("{} {:f} {:f}", number++, 144 * std::cos(phi), 100 + 144 * std::sin(phi));
                              for (int j = 1; j <= 6; ++j) text += fmt::format(" {:f}", torque_of(j, m.deg));
                              return text + " ";
                            }));
  std::string map(imported::example_map("linuxcnc-halsampler"));
  map.replace(map.find("samples = 360"), 13, "samples = 120");
  map.replace(map.find("circle.samples\"\ncentre"), 14, "c.samples");
  const std::string period = fmt::format("period_s = {:.9f}", way(0, 0.1, 0.1)[1].seconds);
  map.replace(map.find("period_s = 0.001"), 16, period);
  check_turn(made(scratch, map, {"c.samples"}).dataset.runs.at(0), 120, true, 1e-3);
}

TEST_CASE("layout 10, with a fault: a decimal comma where the map says a point") {
  const Scratch scratch;
  scratch.file("c.txt", "a;r\n0;1.5\n3;1,4\n6;1.3\n");
  const Diagnostic d = refusal_of([&] {
    made(scratch, kMapHead + "[table]\ndelimiter = \";\"\n" + kAngleAndBar + map_run("one", "c.txt"), {"c.txt"});
  });
  CHECK(d.code == "import-number");
  CHECK(d.place.line == 3);
  CHECK(d.place.column == 3);
  CHECK(d.help.find("decimal") != std::string::npos);
}

TEST_CASE("layout 11, with a fault: the sampler lost samples within the record") {
  const Scratch scratch;
  std::string text = "overrun\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{} 1 2 3 4 5 6 7 8\n{}", i, i == 9 ? "overrun\n" : "");
  scratch.file("circle.samples", text);
  const Diagnostic d =
      refusal_of([&] { made(scratch, std::string(imported::example_map("linuxcnc-halsampler")), {"circle.samples"}); });
  CHECK(d.code == "import-lost-samples");
  CHECK(d.place.line == 12);
}

TEST_CASE("layout 12, with a fault: the last line is cut off") {
  const Scratch scratch;
  std::string text = "a,r\n" + lines(way(0, 351), [](const Moment& m) { return fmt::format("{},{:.3f}", m.deg, 1.0); });
  scratch.file("c.csv", text + "354");
  const Diagnostic d = refusal_of([&] { made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"}); });
  CHECK(d.code == "import-columns");
  CHECK(d.place.line == 120);
  CHECK(d.place.column == 1);
}

TEST_CASE("a table whose lines end with carriage returns alone is refused") {
  const Scratch scratch;
  for (const char* const text : {"a,r\r0,1.5\r3,1.4\r", "a,r\n0,1.5\r3,1.4\n", "a,r # bar\r0,1.5\n"}) {
    INFO(text);
    scratch.file("c.csv", text);
    const Diagnostic d =
        refusal_of([&] { made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"}); });
    CHECK(d.code == "import-line-end");
    CHECK(d.help.find("line ends") != std::string::npos);
  }
}

TEST_CASE("rows without a reading are left out and counted") {
  const Scratch scratch;
  scratch.file("c.csv", "a,r\n" + lines(way(0, 357), [](const Moment& m) {
                          return fmt::format("{:.3f},{}", m.deg,
                                             m.deg == 30 ? "" : fmt::format("{:.5f}", radial_um(m.deg)));
                        }));
  const Imported found = made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"});
  check_turn(found.dataset.runs.at(0), 119, false);
  CHECK(found.taken.at(0).missing == 1);
}

TEST_CASE("what the map says and the file does not hold is refused") {
  const Scratch scratch;
  scratch.file("c.csv", "a,r\n" + lines(way(0, 357), [](const Moment& m) { return fmt::format("{},1.0", m.deg); }));
  const auto code = [&](const std::string& columns, const std::string& runs) {
    return refusal_of([&] { made(scratch, kMapHead + columns + runs, {"c.csv"}); }).code;
  };
  CHECK(code(kAngleAndBar, map_run("one", "other.csv")) == "import-file");
  CHECK(code(kAngleAndBar, map_run("one", "c.csv", "cw")) == "import-direction");
  CHECK(code(kAngleAndBar, map_run("one", "c.csv") + map_run("two", "c.csv")) == "import-no-circle");
  CHECK(code("[columns]\nradial = {name = \"r\", unit = \"um\"}\n", map_run("one", "c.csv")) == "import-angle");
  CHECK(code("[columns]\nradial = {name = \"b\", unit = \"um\"}\n", map_run("one", "c.csv")) == "import-no-column");
  CHECK(code(kAngleAndBar + "[clock]\nmotors_later_s = 1\n", map_run("one", "c.csv")).empty());  // no motors
}

TEST_CASE("a run-in that leaves no turn is refused, and one that does is taken") {
  const Scratch scratch;
  scratch.file("c.csv", "t,r\n" + lines(way(0, 717), [](const Moment& m) {
                          return fmt::format("{:.6f},{:.5f}", m.seconds, radial_um(m.deg));
                        }));
  const std::string columns =
      "[columns]\ntime = {name = \"t\", unit = \"s\"}\nradial = {name = \"r\", unit = \"um\"}\n";
  const auto with = [&](const std::string& deg) {
    return [&, deg] {
      made(scratch, kMapHead + columns + map_run("one", "c.csv", "ccw", "run_in_deg = " + deg), {"c.csv"});
    };
  };
  for (const std::string deg : {"0", "90", "357", "360"}) {
    CAPTURE(deg);
    CHECK(refusal_of(with(deg)).code.empty());
  }
  for (const std::string deg : {"370", "400", "720"}) {
    CAPTURE(deg);
    const Diagnostic refused = refusal_of(with(deg));
    CHECK(refused.code == "import-value");
    CHECK(refused.message.find("run-in of " + deg + " deg") != std::string::npos);
  }
}

TEST_CASE("a circle that is not where the table says that the tip was is refused") {
  const Scratch scratch;
  const auto with = [&](double x, double y, double radius) {
    scratch.file("c.csv", "x,y,r\n" + lines(way(0, 357), [&](const Moment& m) {
                            const double angle = m.deg * kDeg;
                            return fmt::format("{:.4f},{:.4f},1.0", x + radius * std::cos(angle),
                                               y + radius * std::sin(angle));
                          }));
    const std::string columns =
        "[columns]\nx = {name = \"x\", unit = \"mm\"}\ny = {name = \"y\", unit = \"mm\"}\nradial = {name = \"r\", "
        "unit = \"um\"}\n";
    return refusal_of([&] { made(scratch, kMapHead + columns + map_run("one", "c.csv"), {"c.csv"}); });
  };
  CHECK(with(0, 100, 144).code.empty());
  CHECK(with(0.4, 99.7, 144.5).code.empty());
  CHECK(with(0, 105, 144).code == "import-value");
  CHECK(with(-4, 97, 144).code == "import-value");
  CHECK(with(0, 100, 140).message.find("radius 140.00 mm about [0.00, 100.00]") != std::string::npos);
}

TEST_CASE("times that go back are refused where they do, of the bar and of motors with a clock of their own") {
  const Scratch scratch;
  const auto table = [](double direction, double odd) {
    return "t,a,r\n" + lines(way(0, 357), [&](const Moment& m) {
             const double t = direction * (m.seconds + (m.deg == 30 ? odd : 0));
             return fmt::format("{:.6f},{},1.0", t, m.deg);
           });
  };
  const std::string map = kMapHead + "[columns]\ntime = {name = \"t\", unit = \"s\"}\n" +
                          kAngleAndBar.substr(kAngleAndBar.find('\n') + 1) + map_run("one", "c.csv");
  for (const auto& [direction, odd, line] :
       {std::tuple{1.0, 0.0, 0}, {-1.0, 0.0, 3}, {1.0, -5.0, 12}, {1.0, 5.0, 13}}) {
    CAPTURE(direction, odd);
    scratch.file("c.csv", table(direction, odd));
    const Diagnostic refused = refusal_of([&] { made(scratch, map, {"c.csv"}); });
    CHECK(refused.code == (line == 0 ? "" : "import-value"));
    CHECK(refused.place.line == static_cast<std::size_t>(line));
  }
}

TEST_CASE("a table that the delimiter does not divide is refused with the one that would, CR alone with line ends") {
  const Scratch scratch;
  const auto help = [&](const std::string& text) {
    scratch.file("c.csv", text);
    const Diagnostic refused =
        refusal_of([&] { made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"}); });
    CHECK_FALSE(refused.code.empty());
    return refused.help;
  };
  CHECK(help("a\tr\n0\t1\n3\t1\n").find("delimiter = \"tab\"") != std::string::npos);
  CHECK(help("a;r\n0;1\n3;1\n").find("delimiter = \";\"") != std::string::npos);
  CHECK(help("a,r\r0,1\r3,1\r").find("line ends") != std::string::npos);
  CHECK(help("a,b\n0,1\n3,1\n").find("delimiter") == std::string::npos);
}

TEST_CASE("an imported dataset is written and read again") {
  const Scratch scratch;
  scratch.file("c.csv", "a,r\n" + lines(way(-180, 540), [](const Moment& m) {
                          return fmt::format("{:.3f},{:.5f}", m.deg, radial_um(m.deg));
                        }));
  const Imported found = made(scratch, kMapHead + kAngleAndBar + map_run("one", "c.csv"), {"c.csv"});
  measure::write_dataset(found.dataset, scratch.path("made"));
  const measure::Dataset again = measure::read_dataset(scratch.path("made/dataset.toml"));
  CHECK(again.machine == "m");
  check_turn(again.runs.at(0), 120, false, 1e-3);
}
