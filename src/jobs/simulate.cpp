#include "jobs/simulate.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "compensate/limits.hpp"
#include "compensate/move_reader.hpp"
#include "jobs/csv_columns.hpp"
#include "jobs/open_program.hpp"
#include "machine/axis_words.hpp"
#include "machine/model_file.hpp"
#include "physics/error.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::string_view kSimulationColumns =
    "line,motion,time_s,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,dx_um,dy_um,dz_um,rx_urad,ry_urad,rz_urad,"
    "length1_mm,length2_mm,length3_mm,length4_mm,length5_mm,length6_mm,"
    "nut_tension1_N,nut_tension2_N,nut_tension3_N,nut_tension4_N,nut_tension5_N,nut_tension6_N,"
    "torque1_Nm,torque2_Nm,torque3_Nm,torque4_Nm,torque5_Nm,torque6_Nm\n";

std::string_view name_of(nc::MotionKind kind) {
  switch (kind) {
    case nc::MotionKind::rapid:
      return "rapid";
    case nc::MotionKind::arc:
      return "arc";
    default:
      return "feed";
  }
}

class Player {
 public:
  Player(const machine::MachineModel& model, const compensate::Settings& settings, OutputFile& out)
      : model_(model),
        settings_(settings),
        forces_(model),
        environment_(forces_.environment()),
        radius_(machine::platform_radius(model.geometry)),
        out_(out) {
    environment_.friction = settings.friction;
    environment_.dynamic = settings.dynamic;
    out_.write(kSimulationColumns);
  }

  void set_tool(const compensate::ToolInSpindle& tool) {
    forces_.machine.geometry = machine::with_tool(model_.geometry, tool.length);
    environment_.tool_mass = tool.mass - model_.reference_tool_mass;
    environment_.tool_centre_P = model_.geometry.tool_tip_P - Vector3<double>(0, 0, tool.along);
  }

  /// The ends of its pieces; a rapid stands still at each, since nobody knows how fast it is.
  void play(const compensate::Move& move, double begin_s) {
    for (int i = 1; i <= move.pieces; ++i) {
      const double fraction = move.fraction(i);
      Point point{&move, {}, begin_s + fraction * move.seconds.value_or(0)};
      point.target =
          move.is_rapid() ? move.path.at_rest(move.path.curve.at(fraction)) : move.path.target(fraction, move.seconds);
      play(point);
    }
  }

  SimulationSummary take() {
    if (summary_.points > 0) summary_.rms_um = std::sqrt(squares_ / static_cast<double>(summary_.points));
    return summary_;
  }

 private:
  struct Point {
    const compensate::Move* move;
    compensate::Target target;
    double time_s;
  };

  void play(const Point& point) {
    physics::Motion<double> motion = compensate::motion_at(model_.rotation, radius_, point.target, environment_);
    motion.time = settings_.time_s.value_or(0);
    const physics::TipError<double> error = physics::tip_error(forces_, environment_, motion);
    if (!error.converged()) {
      refuse("simulate-unreachable",
             fmt::format("the machine cannot stand here: {}", physics::to_text(error.stopped_because)),
             "check the work offset (--work-offset) and the pose", compensate::place_of(*point.move->step));
    }
    write_row(point, motion.pose, error);
    note(point, error.displacement.head<3>().norm() / kUm);
  }

  void write_row(const Point& point, const Pose<double>& pose, const physics::TipError<double>& error) {
    line_.clear();
    fmt::format_to(std::back_inserter(line_), "{},{},{:.6f}", point.move->path.line, name_of(point.move->motion->kind),
                   point.time_s);
    for (const Axis axis : kAllAxes) {
      line_ += ',';
      append_decimal(line_, point.target.pose[axis], 6);
    }
    append_columns(line_, error.displacement.head<3>(), kUm, 4);
    append_columns(line_, error.displacement.tail<3>(), kUrad, 4);
    append_columns(line_, machine::strut_lengths<double>(forces_.machine.geometry, pose), kMm, 7);
    append_columns(line_, error.loads.nut_tension, 1, 4);
    append_columns(line_, error.loads.torque, 1, 6);
    line_ += '\n';
    out_.write(line_);
  }

  void note(const Point& point, double um) {
    ++summary_.points;
    squares_ += um * um;
    summary_.seconds = point.time_s;
    if (um <= summary_.largest_um) return;
    summary_.largest_um = um;
    summary_.largest_line = point.move->path.line;
  }

  const machine::MachineModel& model_;
  const compensate::Settings& settings_;
  physics::ForceModel forces_;
  physics::Environment environment_;
  double radius_;
  OutputFile& out_;
  std::string line_;
  SimulationSummary summary_;
  double squares_ = 0;
};

}  // namespace

SimulationSummary simulate_program(const std::string& program, const settings::Options& options, OutputFile& out,
                                   const Progress& progress) {
  const machine::MachineModel model = machine::read_model(options.paths.model);
  const auto [source, dialect, settings] = open_program(options, program, model);

  compensate::MoveReader reader(
      source, dialect, settings,
      {nc::named_axes(source, dialect), options.compensation.step, model.reference_tool_mass, {}});
  Player player(model, options.compensation, out);
  while (const compensate::Move* const move = reader.next_move(progress)) {
    if (const auto tool = reader.new_tool()) player.set_tool(*tool);
    player.play(*move, reader.begin_s());
  }
  SimulationSummary summary = player.take();
  summary.passed_moves = reader.passed_moves();
  return summary;
}

}  // namespace plumbline::jobs
