#include "nc/control/families/called_tap.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSamePitch = 1e-6;  // mm
constexpr double kSameFeed = 1e-6;   // of it

// _PITA says in which unit PIT is, whatever the program's: a post writes 1 where its lengths are mm, 3 where they are
// inches [P]; 0 or nothing is the program's.
double pitch_unit_mm(const Execution& run, const CalledValues& given, const Places& places) {
  const double unit = given.number(places.axis + 1);
  if (unit == 0) return run.control.length_unit();
  if (unit == 1) return 1;
  if (unit == 3) return kMmPerInch;
  given.refuse("its pitch is counted otherwise than in mm or inches (_PITA), which is not interpreted",
               "give the pitch in mm, with _PITA as 1");
}

// ENC: the spindle has none that counts, and G63 taps at F [X p. 2-86]; which of both counts where a pitch stands
// there, too, depends on ENC and the software.
double feed_without_encoder(const Execution& run, const CalledValues& given, double by_pitch) {
  const Control& control = run.control;
  const double feed = feed_of_move(run, true);
  const double by_turn = control.modal.feed_mode == FeedMode::per_revolution ? control.spindle_speed : 1;
  if (by_pitch == 0 || std::abs(feed * by_turn - by_pitch) <= kSameFeed * by_pitch) return feed;
  given.refuse(
      "F is another feed than its pitch times S, and with ENC other than 0 no source says which of both counts",
      fmt::format("write F{:.6g}, or leave out PIT and MPIT", by_pitch / by_turn / control.length_unit()));
}

}  // namespace

// Without a pitch F counts. CYCLE84 has a speed of its own on the way down, SST, and on the way up, SST1.
double tapping_feed(const Execution& run, const CalledValues& given, const Places& places, bool up) {
  const bool rigid = places.code == kCalledTap;
  const int pitch = rigid ? 8 : 10;
  if (rigid && given.number(10) == 0) {
    given.refuse("no source says at which speed it taps without SST", "give it: SST, its eleventh value");
  }
  const double down_speed = rigid ? given.number(10) : run.control.spindle_speed;
  const double speed = up && rigid && given.number(11) != 0 ? given.number(11) : down_speed;
  const double thread_mm = pitch_of_thread(given.number(pitch - 1));
  const double written = std::abs(given.number(pitch));
  const double pitch_mm = written != 0 ? written * pitch_unit_mm(run, given, places) : thread_mm;
  if (thread_mm != 0 && std::abs(pitch_mm - thread_mm) > kSamePitch) {
    given.refuse("its two pitches (MPIT and PIT) contradict each other", "leave out one of them");
  }
  if (!rigid && given.number(8) != 0) return feed_without_encoder(run, given, pitch_mm * speed);
  if (pitch_mm > 0 && speed > 0) return pitch_mm * speed;
  given.refuse(
      "how fast it taps is not known",
      rigid ? "give its pitch (PIT, or MPIT for M3 to M48) and its speed (SST)"
            : "give its pitch (PIT, or MPIT for M3 to M48) and S before it; or ENC as 1 and F, where F is to count");
}

}  // namespace plumbline::nc
