#include <cmath>
#include <sstream>

#include <catch2/catch.hpp>
#include <plumbline/plumbline.hpp>

#include "support/scratch.hpp"

namespace api = plumbline::api;
namespace testing = plumbline::testing;
using api::Input;
using api::Output;

namespace {

constexpr const char* kPart = "G0 X0 Y0 Z0 A0 B0 C0\nG1 X20 A5 F500\nM2\n";

api::Model model() { return api::Model(Input::file(testing::source_file("models/pm600-like.toml"))); }

api::Options options() { return api::Options().set("work-offset", "G54=0,0,-1008,0,0,0"); }

template <class Call>
api::Error error_of(const Call& call) {
  try {
    call();
  } catch (const api::Error& error) {
    return error;
  }
  FAIL("nothing was thrown");
  throw;
}

}  // namespace

TEST_CASE("a text in memory becomes what a file becomes") {
  const testing::Scratch scratch;
  std::string text;
  std::ostringstream stream;
  const api::Result done = api::compensate(Input::text(kPart), model(), options(), Output::text(text));
  api::compensate(Input::file(scratch.file("p.ngc", kPart)), model(), options(), Output::file(scratch.path("o.ngc")));
  api::compensate(Input::text(kPart), model(), options(), Output::stream(stream));
  CHECK(text.starts_with("(plumbline " + api::version()));
  CHECK(scratch.text("o.ngc") == text);
  CHECK(stream.str() == text);
  CHECK(done.number("moves") == 2);
  CHECK(done.json().starts_with("{\n  \"plumbline\": \"compensation 1\""));
  CHECK_FALSE(done.words().empty());
}

TEST_CASE("models and tool tables may be texts, too") {
  const testing::Scratch scratch;
  const std::string table = "plumbline = \"tools 1\"\n\n[[tool]]\nnumber = 3\nlength_mm = 85\n";
  const std::string part = "T3 M6\nG43\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X20 A5 F500\nM2\n";
  const api::Model held(Input::text(model().text(), "held.toml"));
  CHECK(held.name() == model().name());
  CHECK(held.hash() == model().hash());
  std::string by_text, by_file;
  const api::Options all = options().set("start", "0,0,100,0,0,0").set("keeps-position", "M6");
  api::compensate(Input::text(part), held, api::Options(all).set("tools", Input::text(table)), Output::text(by_text));
  api::compensate(Input::text(part), model(), api::Options(all).set("tools", scratch.file("t.toml", table)),
                  Output::text(by_file));
  CHECK(by_text.find("tool 3: length 85 mm") != std::string::npos);
  CHECK(by_text == by_file);
}

TEST_CASE("what was replaced is kept, and gives the original back") {
  std::string text, undo, original;
  api::compensate(Input::text(kPart), model(), options(), Output::text(text), Output::text(undo));
  api::restore(Input::text(text), Input::text(undo), Output::text(original));
  CHECK(original == kPart);
  CHECK(text != original);
  const api::Error error =
      error_of([&] { api::compensate(Input::text(kPart), model(), options().set("undo"), Output::text(text)); });
  CHECK(error.kind() == api::Error::Kind::wrong_usage);
  const testing::Scratch scratch;
  api::compensate(Input::text(kPart), model(), options().set("undo"), Output::file(scratch.path("o.ngc")));
  CHECK(scratch.text("o.ngc.undo") == undo);
}

TEST_CASE("trace, check, diff and simulate take texts") {
  std::string trace, text, csv;
  api::trace(Input::text(kPart), {}, Output::text(trace));
  CHECK(trace.starts_with("{\"line\": 1, \"motion\": \"rapid\""));
  const api::Result kept = api::check(Input::text(kPart), model(), options());
  CHECK_FALSE(kept.found());
  CHECK(kept.number("violations") == 0);
  const api::Result broken = api::check(Input::text("G0 X0 Y0 Z0 A0 B0 C0\nG1 X5000 F500\nM2\n"), model(), options());
  CHECK(broken.found());
  api::compensate(Input::text(kPart), model(), options(), Output::text(text));
  CHECK(api::diff(Input::text(kPart), Input::text(text), options()).found());
  CHECK_FALSE(
      api::diff(Input::text(kPart), Input::text(text), options().set("tolerance-mm", "1").set("tolerance-deg", "1"))
          .found());
  const api::Result played = api::simulate(Input::text(text), model(), options(), Output::text(csv));
  const api::Table points = api::simulate(Input::text(text), model(), options());
  CHECK(played.number("points") == static_cast<double>(points.rows()));
  CHECK(csv.starts_with("line,motion,time_s,x_mm"));
  REQUIRE(points.columns.at(9) == "dx_um");
  CHECK(points.at(0, 1) == 0);                  // a rapid
  CHECK(points.at(points.rows() - 1, 1) == 1);  // a cut
  CHECK(points.at(points.rows() - 1, 0) > 2);   // its line: the stamp stands before it
}

TEST_CASE("the error at poses is a table of numbers, and CSV") {
  std::string csv;
  const api::Table table = api::error({{0, 0, -1008, 0, 0, 0}}, model());
  const api::Result result =
      api::error(Input::text("x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,0\n"), model(), Output::text(csv));
  REQUIRE(table.rows() == 1);
  REQUIRE(table.columns.at(26) == "dz_um");
  const double distance = std::hypot(table.at(0, 24), table.at(0, 25), table.at(0, 26));
  CHECK(distance == Approx(15.379).epsilon(1e-3));
  CHECK(result.number("largest_um") == Approx(distance));
  CHECK(csv.starts_with("x_mm,y_mm,z_mm"));
  CHECK(table.warnings.empty());
  const api::Table far = api::error({{0, 0, -1008, 0, 0, 0}, {0, 0, -1300, 0, 0, 0}}, model());
  REQUIRE(far.warnings.size() == 1);
  CHECK(far.warnings[0].code == "error-beyond-travel");
  const api::Error beyond = error_of([] { api::error({{0, 0, 0, 0, 0, 0}, {0, 0, 99999, 0, 0, 0}}, model()); });
  CHECK(beyond.diagnostic().code == "error-unreachable");
}

TEST_CASE("a tolerance chooses the points, and steps beside it are thrown back") {
  std::string text;
  const api::Options bound = options().set("tolerance", "1um").set("no-friction");
  const api::Result done = api::compensate(Input::text(kPart), model(), bound, Output::text(text));
  CHECK(done.number("worst_residual_um/value") <= 1);
  CHECK(done.number("points") < 20);  // of 0.1 deg: 50
  const api::Error error = error_of([&] {
    api::compensate(Input::text(kPart), model(), api::Options(bound).set("step-length", "1"), Output::text(text));
  });
  CHECK(error.kind() == api::Error::Kind::wrong_usage);
}

TEST_CASE("what is wrong is thrown, with its place, and nothing is written") {
  const testing::Scratch scratch;
  std::string text = "as it was";
  const Input bad = Input::text("G0 X0 Y0 Z0 A0 B0 C0\nG1 A60 F100\n", "bad.ngc");
  const api::Error error = error_of([&] { api::compensate(bad, model(), options(), Output::text(text)); });
  CHECK(error.kind() == api::Error::Kind::refused);
  CHECK(error.diagnostic().code == "limit-tilt");
  CHECK(error.diagnostic().place.file == "bad.ngc");
  CHECK(error.diagnostic().place.line == 2);
  CHECK(std::string(error.what()).starts_with("bad.ngc:2:"));
  CHECK(error.json().starts_with("{\"code\":\"limit-tilt\",\"severity\":\"error\""));
  CHECK(text == "as it was");
  CHECK_THROWS_AS(api::compensate(bad, model(), options(), Output::file(scratch.path("out.ngc"))), api::Error);
  CHECK_FALSE(scratch.has("out.ngc"));
  CHECK(api::explain("limit-tilt").find("limit-tilt") != std::string::npos);
  CHECK(error_of([] { api::explain("no-such-code"); }).diagnostic().code == "explain-unknown-code");
}

TEST_CASE("a call that cannot be meant is wrong usage") {
  std::string text;
  const auto usage_of = [&](const api::Options& how, const api::Model& machine) {
    const api::Error error = error_of([&] { api::compensate(Input::text(kPart), machine, how, Output::text(text)); });
    CHECK(error.kind() == api::Error::Kind::wrong_usage);
    CHECK(error.diagnostic().code == "usage-wrong");
    return error.diagnostic();
  };
  CHECK(usage_of(options().set("work-offset", "G54=1"), model()).message.starts_with("work-offset G54=1: expected"));
  CHECK(usage_of(options().set("tolerence", "1um"), model()).help.find("tolerance") != std::string::npos);
  CHECK(usage_of(options(), api::Model()).message == "a model of the machine is needed");
  CHECK_THROWS_AS(api::check(Input::text(kPart), model(), options().set("undo")), api::Error);
}

TEST_CASE("an output never goes over an input") {
  const testing::Scratch scratch;
  const std::string part = scratch.file("p.ngc", kPart);
  const api::Error error =
      error_of([&] { api::compensate(Input::file(part), model(), options(), Output::file(part)); });
  CHECK(error.diagnostic().code == "file-overwrites-input");
  CHECK(scratch.text("p.ngc") == kPart);
}

TEST_CASE("a settings file is read where it is named, and what is said besides counts more") {
  const testing::Scratch scratch;
  const std::string settings = scratch.file(
      "plumbline.toml", "plumbline = \"settings 1\"\nstep_length = 5\n[work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n");
  std::string by_settings, by_options;
  api::compensate(Input::text(kPart), model(), api::Options().set("settings", settings).set("step-length", "1"),
                  Output::text(by_settings));
  api::compensate(Input::text(kPart), model(), options().set("step-length", "1"), Output::text(by_options));
  const auto moves = [](const std::string& text) { return text.substr(text.find("G0 X")); };
  CHECK(moves(by_settings) == moves(by_options));
}

TEST_CASE("a settings file describes machines by name, model and all") {
  const testing::Scratch scratch;
  const std::string settings =
      scratch.file("shop.toml", "plumbline = \"settings 1\"\n[machines.hex-3]\nmodel = \"" +
                                    testing::source_file("models/pm600-like.toml") +
                                    "\"\n[machines.hex-3.work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n");
  const api::Options shop = api::Options().set("settings", settings);
  std::string text;
  const api::Result done =
      api::compensate(Input::text(kPart), api::Model(), api::Options(shop).set("machine", "hex-3"), Output::text(text));
  CHECK(done.number("moves") == 2);
  CHECK(text.find("machine hex-3") != std::string::npos);
  const auto without = error_of([&] { api::compensate(Input::text(kPart), api::Model(), shop, Output::text(text)); });
  CHECK(without.diagnostic().message == "a model of the machine is needed");
  const auto other =
      error_of([&] { api::check(Input::text(kPart), api::Model(), api::Options(shop).set("machine", "hex-4")); });
  CHECK(other.diagnostic().code == "settings-no-machine");
}

TEST_CASE("what progress throws ends the work") {
  std::string program = "G0 X0 Y0 Z0 A0 B0 C0\nF500\n";
  for (int i = 0; i < 9000; ++i) program += i % 2 == 0 ? "G1 X1\n" : "G1 X0\n";
  std::string text = "as it was";
  int calls = 0;
  const api::Progress stop = [&](std::uint64_t, std::uint64_t) {
    ++calls;
    throw 7;
  };
  CHECK_THROWS_AS(
      api::compensate(Input::text(program), model(), options(), Output::text(text), Output::nothing(), stop), int);
  CHECK(calls == 1);
  CHECK(text == "as it was");
}
