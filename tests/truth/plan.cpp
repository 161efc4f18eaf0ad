#include "truth/plan.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

namespace truth {
namespace {

constexpr double kPause = 120;    // s between two runs
constexpr double kWarmUp = 3600;  // s until a warm repeat

Circle circle(const Vec& centre_mm, const Vec& abc_deg, int turn, double feed_mm_min, double payload = 0) {
  return {kMm * centre_mm, 144 * kMm, 150 * kMm, kDeg * abc_deg, turn, feed_mm_min * kMm / 60, payload, 0};
}

// Times on the dataset's clock, as somebody needs who sets a ballbar up between the runs.
void set_starts(Plan& plan, std::size_t warm_from) {
  double now = 0;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (i == warm_from) now += kWarmUp;
    plan[i].circle.start = std::round(10 * now) / 10;
    now += plan[i].circle.seconds() + kPause;
  }
}

}  // namespace

Plan eight_poses(int samples) {
  const std::vector<std::pair<Vec, Vec>> poses{{{0, 100, -1008}, {0, 0, 0}},     {{0, 100, -1008}, {-22, 0, 0}},
                                               {{0, 100, -1008}, {18, 0, 0}},    {{-70, -70, -1008}, {-15, -15, 0}},
                                               {{70, -70, -1008}, {15, -12, 0}}, {{0, 0, -1080}, {0, 20, 0}},
                                               {{0, 0, -1080}, {0, -20, 0}},     {{60, 0, -950}, {10, 10, 0}}};
  Plan plan;
  const auto add = [&](std::size_t pose, const std::string& kind, int turn, double feed, double payload) {
    const std::string id = fmt::format("{:02}-p{}{}-{}", plan.size() + 1, pose + 1, kind, turn > 0 ? "ccw" : "cw");
    plan.push_back({id, circle(poses[pose].first, poses[pose].second, turn, feed, payload), samples});
  };
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    for (const int turn : {1, -1}) add(pose, "", turn, 1000, 0);
  }
  for (const std::size_t pose : {0, 1, 3}) {
    for (const int turn : {1, -1}) add(pose, "-fast", turn, 6000, 0);
  }
  for (const std::size_t pose : {0, 3}) add(pose, "-20kg", 1, 1000, 20);
  const std::size_t warm = plan.size();
  for (const std::size_t pose : {0, 3}) add(pose, "-warm", 1, 1000, 0);
  set_starts(plan, warm);
  return plan;
}

Plan paper(int samples) {
  Plan plan{{"a", circle({0, 100, -1008}, {0, 0, 0}, 1, 1000), samples},
            {"b", circle({0, 100, -1008}, {-23, 0, 0}, 1, 1000), samples}};
  set_starts(plan, plan.size());
  return plan;
}

Plan figures(int samples) {
  Plan plan;
  for (const int tilt : {-25, -23, -20, -10, 0, 10, 20}) {
    plan.push_back(
        {fmt::format("a{:+03}", tilt), circle({0, 100, -1008}, {static_cast<double>(tilt), 0, 0}, 1, 1000), samples});
  }
  plan.push_back({"a-17-b-17", circle({-70, -70, -1008}, {-17, -17, 0}, 1, 1000), samples});
  set_starts(plan, plan.size());
  return plan;
}

Plan holdout(int samples) {
  Plan plan{{"h1", circle({0, 100, -1008}, {-18, 0, 0}, 1, 1000), samples},
            {"h2", circle({-50, 60, -1040}, {12, -12, 0}, -1, 2000), samples},
            {"h3", circle({50, -50, -960}, {-10, 14, 0}, 1, 4000), samples},
            {"h4", circle({0, 0, -1020}, {0, 0, 0}, -1, 3000), samples},
            {"h5", circle({-80, 0, -1008}, {-12, 16, 0}, 1, 1500), samples},
            {"h6", circle({40, 80, -1060}, {16, 8, 0}, -1, 5000), samples}};
  for (std::size_t i = 0; i < plan.size(); ++i) plan[i].circle.start = 600.0 * static_cast<double>(i);
  return plan;
}

Plan plan_of(const std::string& name, int samples) {
  if (name == "eight-pose") return eight_poses(samples);
  if (name == "paper") return paper(samples);
  if (name == "figures") return figures(samples);
  throw std::runtime_error("no plan is called " + name + ": eight-pose, paper, figures");
}

Plan circles_of(const std::vector<std::string>& texts, int samples) {
  Plan plan;
  for (const std::string& text : texts) {
    Vec centre;
    Vec abc;
    char turn[4] = {};
    double feed = 0;
    double payload = 0;
    const int read = std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%3[cw],%lf,%lf", &centre.x(), &centre.y(),
                                 &centre.z(), &abc.x(), &abc.y(), &abc.z(), turn, &feed, &payload);
    const std::string direction = turn;
    if (read != 9 || feed <= 0 || (direction != "ccw" && direction != "cw")) {
      throw std::runtime_error("no circle: " + text + "; X,Y,Z,A,B,C,ccw,FEED,PAYLOAD");
    }
    const std::string id = fmt::format("{:02}-{}", plan.size() + 1, direction);
    plan.push_back({id, circle(centre, abc, direction == "ccw" ? 1 : -1, feed, payload), samples});
  }
  set_starts(plan, plan.size());
  return plan;
}

Samples measured_on(const Truth& truth, const PlannedRun& run, const Program& program, FrictionLaw law,
                    const Vec& ball_off, double bar_off) {
  const Circle& circle = run.circle;
  const double piece = 1e-4 * circle.radius / circle.feed;
  Follower follower(truth.machine, program.path, piece, law);
  if (program.before > 0) follower.at(-program.before, circle.start, circle.payload);  // friction remembers the way in
  Samples samples(static_cast<std::size_t>(run.samples));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Sample& s = samples[i];
    const double part = static_cast<double>(i) / run.samples;
    s.seconds = part * program.seconds;
    s.angle = circle.turn > 0 || i == 0 ? 2 * M_PI * part : 2 * M_PI * (1 - part);
    s.moment = follower.at(s.seconds, circle.start, circle.payload);
    s.standing = settled(truth, s.moment);
    s.reading = reading_at(truth, s.standing.at, s.moment, circle.ball() + ball_off, circle.bar + bar_off);
  }
  return samples;
}

Samples measured(const Truth& truth, const PlannedRun& run, FrictionLaw law, const Vec& ball_off, double bar_off) {
  return measured_on(truth, run, {path_of(run.circle), run.circle.seconds()}, law, ball_off, bar_off);
}

}  // namespace truth
