#include "truth/program.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>

namespace truth {
namespace {

using Json = nlohmann::ordered_json;

// One motion: where it begins and ends, mm and deg, and about which centre if it is an arc.
struct Move {
  double begins = 0, lasts = 0;  // s
  Vec6 from, to;
  Vec centre{0, 0, 0};
  double sweep = 0;  // rad; zero: straight
};

Vec6 axes(const Json& values) {
  Vec6 words;
  for (int a = 0; a < 6; ++a) words[a] = values.at(static_cast<std::size_t>(a)).get<double>();
  return words;
}

double arc_sweep(const Vec6& from, const Vec6& to, const Vec& centre, int turns) {
  const Vec a = from.head<3>() - centre;
  const Vec b = to.head<3>() - centre;
  const double way = turns > 0 ? 1 : -1;
  double sweep = way * (std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()));
  while (sweep <= 1e-9) sweep += 2 * M_PI;
  return way * (sweep + 2 * M_PI * (std::abs(turns) - 1));
}

double length_mm(const Move& move) {
  const double rise = (move.to - move.from)[2];
  if (move.sweep == 0) return (move.to - move.from).head<3>().norm();
  return std::hypot((move.from.head<2>() - move.centre.head<2>()).norm() * move.sweep, rise);
}

Vec6 at_share(const Move& move, double share) {
  Vec6 words = move.from + share * (move.to - move.from);
  if (move.sweep != 0) {
    const Eigen::Vector2d arm = move.from.head<2>() - move.centre.head<2>();
    words.head<2>() = move.centre.head<2>() + Eigen::Rotation2Dd(share * move.sweep) * arm;
  }
  return words;
}

}  // namespace

Program read_program(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  const auto moves = std::make_shared<std::vector<Move>>();
  Vec6 now = Vec6::Zero();
  double seconds = 0;
  for (std::string line; std::getline(in, line);) {
    const Json motion = Json::parse(line);
    const std::string kind = motion.at("motion");
    const Vec6 to = axes(motion.at("machine"));
    if (kind == "feed" || kind == "arc") {
      Move move{seconds, 0, now, to};
      if (kind == "arc") {
        const Json& c = motion.at("centre");
        move.centre = Vec(c.at(0), c.at(1), c.at(2));
        move.sweep = arc_sweep(now, to, move.centre, motion.at("turns"));
      }
      const double feed = motion.at("feed");
      move.lasts = 60 / feed * (motion.at("feed_mode") == "G93" ? 1 : length_mm(move));
      if (move.lasts > 0) moves->push_back(move);
      seconds += move.lasts;
    } else if (kind != "rapid") {
      throw std::runtime_error("the stand-in does not run a " + kind);
    }
    now = to;
  }
  if (moves->empty()) throw std::runtime_error(path + " cuts nothing");
  std::vector<double> ends;
  for (const Move& move : *moves) ends.push_back(move.begins + move.lasts);
  // before its start and after its end the path goes on as it began and ended
  return {[moves](double t) {
            const auto next = std::upper_bound(moves->begin(), moves->end(), t,
                                               [](double time, const Move& m) { return time < m.begins; });
            const Move& move = next == moves->begin() ? *next : *(next - 1);
            const Vec6 words = at_share(move, (t - move.begins) / move.lasts);
            return Stand{1e-3 * words.head<3>(), turned(M_PI / 180 * words.tail<3>())};
          },
          seconds, 0, std::move(ends)};
}

Program last_turn(const Program& program, const Vec& centre) {
  constexpr int kPieces = 7200;
  constexpr double kTurn = 2 * M_PI - 1e-6;
  const double piece = program.seconds / kPieces;
  const auto arm_at = [&](double t) -> Eigen::Vector2d { return (program.path(t).x - centre).head<2>(); };
  double turned = 0;
  Eigen::Vector2d later = arm_at(program.seconds);
  for (int left = kPieces - 1; left >= 0; --left) {
    const Eigen::Vector2d arm = arm_at(left * piece);
    const double turn = std::abs(std::atan2(arm.x() * later.y() - arm.y() * later.x(), arm.dot(later)));
    if (turned + turn >= kTurn) {
      const double begins = piece * (left + 1 - std::min(1.0, (2 * M_PI - turned) / turn));
      return {[path = program.path, begins](double t) { return path(begins + t); }, program.seconds - begins, begins};
    }
    turned += turn;
    later = arm;
  }
  return program;
}

}  // namespace truth
