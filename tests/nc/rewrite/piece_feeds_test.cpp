// Turns that wait (held_turns) are held by whole programs: tests/compensate/held_turns_test.cpp.
#include "nc/rewrite/piece_feeds.hpp"

#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/rewrite/last_step.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

// A move cut into pieces: where each ends, and its share of the time.
struct Feeds {
  struct Cut {
    AxisWords end;
    double share;
  };
  Feeds(std::string_view text, const std::vector<Cut>& cuts, std::string_view dialect_name = "linuxcnc",
        const ProgramSettings& settings = at_zero())
      : step(text, dialect_name, settings) {
    for (const Cut& cut : cuts) {
      ends.push_back(cut.end);
      pieces.emplace_back().share = cut.share;
    }
    feeds.emplace(dialect(dialect_name), emit, *step, pieces, ends);
  }
  double choose(double seconds) { return feeds->choose(step->motions.front().from, seconds, control); }
  std::string refusal(double seconds) {
    return testing::refusal_of([&] { choose(seconds); }).code;
  }
  std::string refusal_to_keep(bool has_time) {
    return testing::refusal_of([&] { feeds->keep(has_time, control); }).code;
  }

  LastStep step;
  EmitSettings emit;
  std::vector<AxisWords> ends;
  std::vector<Piece> pieces;
  OutputState control;
  std::optional<PieceFeeds> feeds;
};

AxisWords at_x(double x) { return {{x, 0, 0, 0, 0, 0}}; }
AxisWords at_a(double z, double a) { return {{0, 0, z, a, 0, 0}}; }

ProgramSettings feed_rule(FeedRule rule) {
  ProgramSettings settings = at_zero();
  settings.feed_rule = rule;
  return settings;
}

}  // namespace

TEST_CASE("F stays where it keeps the time of the block, and is written where the block says one or none is in force") {
  Feeds stated("G1 X10 F60\n", {{at_x(10), 1}});
  CHECK(stated.choose(10) == Approx(10));
  CHECK(stated.pieces[0].feed == 60);
  CHECK(stated.pieces[0].length == Approx(10));
  Feeds modal("F60\nG1 X10\n", {{at_x(10), 1}});
  modal.control.set_feed(60);
  CHECK(modal.choose(10) == Approx(10));
  CHECK_FALSE(modal.pieces[0].feed);
  Feeds lost("F60\nG1 X10\n", {{at_x(10), 1}});
  lost.choose(10);
  CHECK(lost.pieces[0].feed == 60);
  CHECK(lost.control.feed == 60);
}

TEST_CASE("another time needs another F: one for all pieces that are alike, else each its own") {
  Feeds alike("G1 X10 F60\n", {{at_x(4), 0.4}, {at_x(10), 0.6}});
  CHECK(alike.choose(5) == Approx(5));  // 10 mm in 5 s
  CHECK(alike.pieces[0].feed == Approx(120));
  CHECK_FALSE(alike.pieces[1].feed);
  Feeds unlike("G1 X10 F60\n", {{at_x(1), 0.5}, {at_x(10), 0.5}});
  CHECK(unlike.choose(20) == Approx(20));  // 1 mm and 9 mm in 10 s each
  CHECK(unlike.pieces[0].feed == Approx(6));
  CHECK(unlike.pieces[1].feed == Approx(54));
  CHECK(unlike.control.feed == Approx(54));
}

TEST_CASE("F has six digits that count") {
  Feeds feeds("G1 X10 F60\n", {{at_x(10), 1}});
  feeds.choose(7);
  CHECK(feeds.pieces[0].feed == 85.7143);  // 600 / 7 = 85.714285...
}

TEST_CASE("a turn alone counts in degrees, which do not follow a change of units") {
  Feeds feeds("G20 F360\nG1 A90\n", {{at_a(0, 90), 1}});
  feeds.control.feed = 14;  // as inches
  feeds.control.feed_rotary = 360;
  CHECK(feeds.choose(15) == Approx(15));
  CHECK(feeds.pieces[0].in_degrees);
  CHECK(feeds.pieces[0].length == Approx(90));
  CHECK_FALSE(feeds.pieces[0].feed);
}

TEST_CASE("inverse time: each piece one over its share of the time") {
  Feeds one("G93 G1 X10 F2\n", {{at_x(10), 1}});
  one.control.feed_mode = FeedMode::inverse_time;
  CHECK(one.choose(30) == Approx(30));
  CHECK_FALSE(one.pieces[0].feed);  // the block has its own
  CHECK_FALSE(one.pieces[0].restates_mode);
  Feeds two("G93 G1 X10 F2\n", {{at_x(2.5), 0.25}, {at_x(10), 0.75}});
  two.control.feed_mode = FeedMode::inverse_time;
  CHECK(two.choose(30) == Approx(30).epsilon(1e-5));
  CHECK(two.pieces[0].feed == 8);        // 7.5 s
  CHECK(two.pieces[1].feed == 2.66667);  // 22.5 s
  CHECK(two.control.feed == 0);          // no F stays in force
}

TEST_CASE("what is slower than the control's least rate leaves inverse time for that block") {
  Feeds feeds("G93 G1 A5 F2\n", {{at_a(0.01, 5), 1}});  // 0.01 mm in 30 s
  feeds.control.feed_mode = FeedMode::inverse_time;
  CHECK(feeds.choose(30) == Approx(30));
  CHECK(feeds.pieces[0].leaves_inverse_time);
  CHECK(feeds.pieces[0].restates_mode);
  CHECK(feeds.pieces[0].feed == Approx(0.02));
  CHECK(feeds.control.feed_mode == FeedMode::per_minute);
}

TEST_CASE("a control that counts inverse time in steps gets whole ones, or the block is refused") {
  Feeds feeds("G93 G1 X10. F2.\n", {{at_x(5), 0.5}, {at_x(10), 0.5}}, "fanuc", empty_tables());
  feeds.control.feed_mode = FeedMode::inverse_time;
  CHECK(feeds.choose(30.00003) == Approx(30));
  CHECK(feeds.pieces[0].feed == 4);
  CHECK(feeds.refusal(60 / 9000.0) == "emit-feed-range");  // 18000 a minute, and 9999.999 is the most
}

TEST_CASE("an F that no control takes is refused") {
  Feeds feeds("G1 X10 F60\n", {{at_x(10), 1}});
  CHECK(feeds.refusal(1e-11) == "emit-feed-range");
  CHECK(feeds.refusal(1e10) == "emit-feed-range");
  CHECK(feeds.refusal(10).empty());
}

TEST_CASE("where it is not known which speed F is, a move that turns as well is refused") {
  const AxisWords both{{10, 0, 0, 90, 0, 0}};
  Feeds unknown("G1 X10 A90 F60\n", {{both, 1}}, "linuxcnc", feed_rule(FeedRule::unknown));
  CHECK(unknown.refusal(10) == "emit-feed-rule");
  CHECK(unknown.refusal_to_keep(false) == "emit-feed-rule");
  CHECK(unknown.refusal_to_keep(true).empty());  // its own time is known to be none
  Feeds known("G1 X10 A90 F60\n", {{both, 1}}, "linuxcnc", feed_rule(FeedRule::xyz_first));
  CHECK(known.refusal(10).empty());
  CHECK(known.refusal_to_keep(false).empty());
  Feeds tip("G1 A90 F60\n", {{at_a(0.01, 90), 1}}, "linuxcnc", feed_rule(FeedRule::tool_tip));
  CHECK(tip.refusal_to_keep(true) == "emit-feed-rule");
}

TEST_CASE("a move without a time keeps its F, in the unit of the block") {
  Feeds feeds("G20\nG1 X1 F10\n", {{at_x(25.4), 1}});
  feeds.feeds->keep(true, feeds.control);
  CHECK(feeds.control.feed == 10);
  Feeds before("G20 G1 X1 F10\n", {{at_x(25.4), 1}});  // LinuxCNC reads F before the units of its block
  before.feeds->keep(true, before.control);
  CHECK(before.control.feed == Approx(10 / 25.4));
  Feeds none("G20\nG21 G0 X1\n", {{at_x(1), 1}});
  none.control.set_feed(10);
  none.feeds->keep(true, none.control);
  CHECK(none.control.feed == Approx(254));
  CHECK(none.control.feed_rotary == 10);
}

TEST_CASE("an F whose digits do not say it is refused where the time must be kept better than that") {
  for (const double needed : {0.00110215, 0.00030005, 0.01000005}) {  // between two numbers of eight digits
    CAPTURE(needed);
    Feeds feeds("G1 X10. F60.\n", {{at_x(10), 1}}, "fanuc", empty_tables());
    const double seconds = 10 / needed * 60;
    feeds.emit.time_tolerance = 1e-3;
    CHECK(feeds.refusal(seconds) == (needed < 4e-4 ? "emit-feed-range" : ""));
    feeds.emit.time_tolerance = 1e-8;
    CHECK(feeds.refusal(seconds) == (needed < 4e-3 ? "emit-feed-range" : ""));
  }
}
