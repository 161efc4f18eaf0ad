#include "jobs/test_program.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "jobs/compensate/guard_block.hpp"
#include "machine/limits.hpp"
#include "machine/orientation.hpp"
#include "nc/language/comment_line.hpp"

namespace plumbline::jobs {
namespace {

// How programs of a dialect begin and end.
struct Manner {
  std::string_view dialect, ending, head, modes, end;
};
constexpr std::array<Manner, 4> kManners{{
    {"linuxcnc", "ngc", "", "G21 G90 G91.1 G17 G40 G49 G54 G94 G64 P0.001", "M2\n"},
    {"fanuc", "nc", "%\nO0001\n", "G21 G90 G17 G40 G49 G80 G54 G94 G64", "M30\n%\n"},
    {"siemens", "mpf", "", "G710 G90 G17 G40 G54 D0 G94 G64", "M30\n"},
    {"okuma", "min", "", "G90 G17 G40 G15 H1 G94 G64", "M2\n"},
}};

const Manner& manner_of(const nc::Dialect& dialect) {
  const Manner* const found = std::find_if(kManners.begin(), kManners.end(),
                                           [&](const Manner& manner) { return manner.dialect == dialect.name; });
  PLUMBLINE_CHECK(found != kManners.end());
  return *found;
}

// Names of files and runs may hold what ends a comment, what a control acts on, or more than a line may have.
std::string harmless(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  std::string plain = text.substr(0, kLongest);
  for (char& c : plain) {
    const bool keeps = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    if (!keeps) c = '_';
  }
  return plain;
}

class TestProgramText {
 public:
  TestProgramText(const machine::MachineModel& machine, const measure::Run& run, const nc::Dialect& dialect)
      : machine_(machine), run_(run), dialect_(dialect) {}

  void comment(const std::string& text) { line(nc::comment_line(text, dialect_)); }
  void line(std::string_view text) {
    text_ += text;
    text_ += '\n';
  }
  void add(std::string_view text) { text_ += text; }

  // On the circle, `up` above it.
  std::string place(double turn_deg, double up) const {
    const Vector3<double> p = point(turn_deg, up) / kMm;
    return fmt::format("X{} Y{} Z{}", number(p.x()), number(p.y()), number(p.z()));
  }
  std::string pose(double turn_deg, double up) const { return place(turn_deg, up) + " " + tilt(); }
  std::string tilt() const {
    const Vector3<double> t = run_.tilt / kDeg;
    return fmt::format("A{} B{} C{}", number(t.x()), number(t.y()), number(t.z()));
  }
  // With a point: without one some controls count thousandths.
  static std::string number(double value) { return to_decimal(value, 4, 1); }
  // From one end of the diameter along X to the same (a whole turn) or to the other one. I and J as the words have
  // them: from the start of the arc to the centre.
  std::string arc(bool from_angle_zero, bool whole) const {
    const double towards_centre = from_angle_zero ? -1 : 1;
    const double end = from_angle_zero == whole ? 0 : 180;
    return fmt::format("{} {} I{} J0.0", run_.direction == measure::Direction::ccw ? "G3" : "G2", place(end, 0),
                       number(towards_centre * run_.radius / kMm));
  }

  // How high the tool may go above the start within the limits, at most as asked.
  double height(const TestProgramOptions& options) const {
    const Matrix3<double> R = machine::rotation<double>(machine_.rotation, run_.tilt);
    double reached = 0;
    while (reached + options.retreat_step <= options.retreat * (1 + 1e-9)) {
      const Pose<double> pose{point(180, reached + options.retreat_step + options.reserve), R};
      if (!machine::check_compensated(machine_.limits, machine_.geometry, pose).empty()) break;
      reached += options.retreat_step;
    }
    return reached;
  }

  std::string take() { return std::move(text_); }

 private:
  Vector3<double> point(double turn_deg, double up) const {
    return run_.centre_W + Vector3<double>(turn_deg == 0 ? run_.radius : -run_.radius, 0, up);
  }

  const machine::MachineModel& machine_;
  const measure::Run& run_;
  const nc::Dialect& dialect_;
  std::string text_;
};

void write_head(TestProgramText& text, const machine::MachineModel& machine, const measure::Run& run) {
  const Vector3<double> c = run.centre_W / kMm;
  const Vector3<double> t = run.tilt / kDeg;
  text.comment(fmt::format("circular test {}, for {}", harmless(run.id), harmless(machine.name)));
  text.comment(fmt::format("centre X{} Y{} Z{} mm, radius {} mm, {}", to_decimal(c.x(), 4), to_decimal(c.y(), 4),
                           to_decimal(c.z(), 4), to_decimal(run.radius / kMm, 4),
                           run.direction == measure::Direction::ccw ? "counterclockwise" : "clockwise"));
  text.comment(fmt::format("tilt A{} B{} C{} deg, F{} mm/min, {} kg at the tool tip", to_decimal(t.x(), 4),
                           to_decimal(t.y(), 4), to_decimal(t.z(), 4), to_decimal(run.feed / kMmPerMin, 4),
                           to_decimal(run.payload_mass, 4)));
  if (run.bar) {
    const double down = std::sqrt(std::max(0.0, *run.bar * *run.bar - run.radius * run.radius));
    text.comment(fmt::format("bar {} mm: the ball on the table stands at X{} Y{} Z{}", to_decimal(*run.bar / kMm, 4),
                             to_decimal(c.x(), 4), to_decimal(c.y(), 4), to_decimal(c.z() - down / kMm, 3)));
  } else {
    text.comment("the bar lies in the plane of the circle, the ball on the table in its centre");
  }
  text.comment("positions are those of the tool tip in the base frame: work offset zero, no tool length");
  text.comment("first move: straight to above the start; begin where nothing is in its way");
}

}  // namespace

std::string test_program(const machine::MachineModel& machine, const measure::Run& run, const nc::Dialect& dialect,
                         const TestProgramOptions& options) {
  const Manner& manner = manner_of(dialect);
  TestProgramText text(machine, run, dialect);
  text.add(manner.head);
  write_head(text, machine, run);
  if (dialect.guard != nc::GuardLanguage::none) {
    nc::ProgramSettings zero;
    zero.work_offsets[0] = nc::WorkOffset{};
    compensate::ProgramSurvey survey{dialect, AxisSet::rotary()};
    survey.beginning.states_unit = survey.beginning.states_distance = true;  // Manner::modes
    survey.beginning.states_feed_mode = true;
    for (const std::string& line : guard_block(zero, survey)) text.line(line);
  }
  text.line(manner.modes);
  const double height = text.height(options);
  const auto feed_word = [](double feed) { return "F" + TestProgramText::number(feed / kMmPerMin); };
  const std::string feed = feed_word(run.feed);
  text.line("G0 " + text.pose(180, height));
  text.line(fmt::format("G1 {} {}", text.pose(180, 0), feed_word(std::min(run.feed, options.approach_feed))));
  text.comment("put the bar in and start the record");
  text.comment("leave the axes where they are");
  text.line("M0");
  text.line("G0 " + text.pose(180, 0));  // after a stop the axes may stand elsewhere: the arc says where it begins
  text.comment("half a turn to run in");
  text.line(fmt::format("{} {}", text.arc(false, false), feed));
  text.comment("the turn that is measured, from angle 0");
  text.line(text.arc(true, true));
  text.comment("half a turn to run out");
  text.line(text.arc(true, false));
  text.comment("stop the record and take the bar out");
  text.line("M0");
  text.line("G0 " + text.pose(180, height));
  text.add(manner.end);
  return text.take();
}

std::string test_program_name(const std::string& id, const nc::Dialect& dialect) {
  return fmt::format("{}.{}", harmless(id), manner_of(dialect).ending);
}

}  // namespace plumbline::jobs
