// Joints of a control, played on the stand-in.
#include "truth/sampled.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "support/scratch.hpp"

using plumbline::testing::Scratch;

namespace {

constexpr double kFeed = 0.025;  // m/s

truth::Machine pm() { return truth::read_model(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml").machine; }

constexpr double kSeconds = 0.02 / kFeed;

// A straight path of 20 mm that turns. Like every program it goes on before its start and after its end.
truth::Stand on_path(double seconds) {
  const double share = seconds / kSeconds;
  return {truth::Vec(0.02 * share, 0.01, -1.008), truth::turned({0.1 * share, -0.05, 0})};
}

truth::Program straight() { return {on_path, kSeconds}; }

// As halsampler -t prints it, counting from `first`, of a control that knows no acceleration: at rest, a rapid that
// goes nowhere, the path, at rest.
std::string recorded(const truth::Machine& of, int first, const truth::Vec& off = truth::Vec::Zero()) {
  std::string text;
  for (int k = 0; k < 1000; ++k) {
    const double t = (k - 100) * 1e-3;
    truth::Stand at = on_path(std::clamp(t, 0.0, kSeconds));
    at.x += off;
    const truth::Vec6 told = truth::believed_lengths(of, at);
    text += fmt::format("{}", first + k);
    for (int j = 0; j < 6; ++j) text += fmt::format(" {:.9f}", 1e3 * told[j]);
    text += fmt::format(" {} \n", k < 50 || k > 900 ? 0 : k < 100 ? 1 : 2);
  }
  return text;
}

truth::Truth rigid() {
  truth::Truth truth{pm(), {}};
  truth.machine.per_length = truth.machine.constant = truth.machine.friction = {};
  return truth;
}

}  // namespace

TEST_CASE("a rigid machine stays on the path that its control follows") {
  const Scratch scratch;
  const truth::Recording recording = truth::read_recording(scratch.file("a", recorded(pm(), 7)));
  const truth::Followed followed = truth::follow(rigid(), straight(), recording, truth::FrictionLaw::tanh);
  CHECK(followed.most < 1e-8);
  CHECK(followed.cutting.size() == 801);
  CHECK(followed.seconds == Approx(0.851));
}

TEST_CASE("how far the control is beside the path is what is found") {
  const Scratch scratch;
  const truth::Vec off(0, 3e-6, -4e-6);
  const truth::Recording recording = truth::read_recording(scratch.file("a", recorded(pm(), 0, off)));
  const truth::Followed followed = truth::follow(rigid(), straight(), recording, truth::FrictionLaw::tanh);
  CHECK(followed.most == Approx(5e-6).epsilon(1e-3));
  CHECK(followed.rms == Approx(5e-6).epsilon(1e-3));
}

TEST_CASE("a machine that bends is off by what the statics say") {
  const Scratch scratch;
  const truth::Recording recording = truth::read_recording(scratch.file("a", recorded(pm(), 0)));
  truth::Truth truth{pm(), {}};
  truth.machine.friction = {};
  const truth::Followed followed = truth::follow(truth, straight(), recording, truth::FrictionLaw::tanh);
  truth::Moment moment{on_path(0.4), truth::believed_lengths(truth.machine, on_path(0.4))};
  moment.speed = moment.acceleration = moment.sign = truth::Vec6::Zero();
  moment.across.setZero();
  moment.tip_acceleration.setZero();
  const truth::Vec error = truth::settled(truth, moment).at.x - on_path(0.4).x;
  const double beside = std::hypot(error.y(), error.z());  // the path runs along X
  const auto middle = followed.cutting[400];
  CHECK(middle.time == Approx(0.5));
  CHECK(middle.off == Approx(beside).epsilon(2e-3));
  CHECK(beside > 5e-6);
}

TEST_CASE("a recording that lacks a period is refused") {
  const Scratch scratch;
  std::string text = recorded(pm(), 0);
  const std::size_t gap = text.find("\n500 ") + 1;
  text.erase(gap, text.find('\n', gap) + 1 - gap);
  CHECK_THROWS_WITH(truth::read_recording(scratch.file("a", text)), Catch::Contains("lacks a sample: 501"));
  CHECK_THROWS_WITH(truth::read_recording(scratch.file("b", "overrun\n" + recorded(pm(), 0))),
                    Catch::Contains("lacks a sample: overrun"));
}
