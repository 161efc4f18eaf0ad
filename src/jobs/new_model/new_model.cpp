#include "jobs/new_model/new_model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "jobs/new_model/assumptions.hpp"
#include "jobs/new_model/linuxcnc_machine.hpp"
#include "machine/condition.hpp"
#include "machine/forward.hpp"
#include "machine/limits.hpp"
#include "machine/model_file.hpp"
#include "machine/model_keys.hpp"
#include "physics/error.hpp"

namespace plumbline::jobs {
namespace {

constexpr int kJointDecimals = 5;  // mm, of joints on a circle
constexpr std::size_t kHeadingWidth = 110;

constexpr double kLargestMachine = 50000;  // mm, as machine/model_keys.hpp has it

constexpr double kMostAngle = 360;  // deg

bool is_length(double mm) { return std::abs(mm) <= kLargestMachine; }

std::vector<double> on_circle(const JointRing& ring) {
  std::vector<double> joints;
  for (const double angle : ring.angles_deg) {
    for (const double coordinate :
         {*ring.radius_mm * std::cos(angle * kDeg), *ring.radius_mm * std::sin(angle * kDeg), ring.height_mm})
      joints.push_back(from_ticks(to_ticks(coordinate, kJointDecimals), kJointDecimals));
  }
  return joints;
}

void put_ring(ModelDraft& draft, const JointRing& ring, const std::string& name, bool needed) {
  const bool circle = ring.radius_mm || !ring.angles_deg.empty();
  if (circle && !ring.joints_mm.empty()) {
    refuse("draft-joints", fmt::format("the joints of the {} are stated twice", name),
           fmt::format("give either --{0}-joints or --{0}-radius and --{0}-angles", name));
  }
  if (circle && !(ring.radius_mm && ring.angles_deg.size() == machine::kStruts)) {
    refuse("draft-joints", fmt::format("joints on a circle of the {} need a radius and six angles", name),
           fmt::format("give --{0}-radius MM and --{0}-angles DEG,... with six angles", name));
  }
  if (!ring.joints_mm.empty() && ring.joints_mm.size() != 3 * machine::kStruts) {
    refuse("draft-joints", fmt::format("six joints of the {} have 18 coordinates, not {}", name, ring.joints_mm.size()),
           fmt::format("give x,y,z of each, strut by strut, with --{}-joints", name));
  }
  const bool turns = std::all_of(ring.angles_deg.begin(), ring.angles_deg.end(),
                                 [](double angle) { return std::abs(angle) <= kMostAngle; });
  if (!turns) {
    refuse("draft-joints", fmt::format("the angles of the {}'s joints are no angles of a circle", name),
           "give them in deg, from -360 to 360");
  }
  if (!is_length(ring.radius_mm.value_or(0)) || !is_length(ring.height_mm)) {
    refuse("draft-joints", fmt::format("the circle of the {}'s joints is larger than any machine", name),
           "give its radius and height in mm");
  }
  if (circle || !ring.joints_mm.empty()) {
    draft.put({name,
               "joints_mm",
               circle ? on_circle(ring) : ring.joints_mm,
               "",
               circle ? fmt::format("radius {} mm", to_decimal(*ring.radius_mm)) : "",
               false,
               {}});
  } else if (needed) {
    refuse("draft-missing", fmt::format("nothing says where the joints of the {} are", name),
           fmt::format("give --{0}-radius and --{0}-angles, or --{0}-joints, or a control's files with --ini", name));
  }
}

// Before anything is computed from them: what follows takes them to be those of a machine.
void check_ranges(const ModelDraft& draft) {
  for (const DraftValue& value : draft.values()) {
    const machine::KeySpec& spec = machine::key_spec(value.table, value.key);
    for (const double number : value.values) {
      if (number >= spec.lower && number <= spec.upper) continue;
      const std::string name = value.table.empty() ? value.key : fmt::format("[{}] {}", value.table, value.key);
      refuse("draft-number",
             fmt::format("{} is {}{}, and not within {} to {}", name, draft_number(number),
                         spec.unit.name.empty() ? "" : fmt::format(" {}", spec.unit.name), draft_number(spec.lower),
                         draft_number(spec.upper)),
             fmt::format("check the number and its unit: {}", spec.meaning), value.place);
    }
  }
  for (const double mm : draft.home_mm) {
    if (!is_length(mm))
      refuse("draft-number", fmt::format("home lies at {} mm, further than any machine goes", draft_number(mm)),
             "check HOME of [TRAJ] and the unit, or --home");
  }
}

ModelDraft draft_of(const NewModelJob& job, std::vector<std::string>& notes) {
  ModelDraft draft;
  draft.put({"", "plumbline", {}, "machine 1", "", false, {}});
  if (!job.name.empty()) draft.put({"", "name", {}, job.name, "", false, {}});
  for (const DraftValue& value : job.stated) draft.put(value);
  draft.home_mm = job.home_mm;
  if (!draft.home_mm.empty()) draft.home_note = "as stated";
  if (job.control) take_linuxcnc(read_linuxcnc_control(*job.control), draft, notes);
  put_ring(draft, job.base, "base", !job.control);
  put_ring(draft, job.platform, "platform", !job.control);
  if (!draft.has("", "name")) draft.put({"", "name", {}, "hexapod", "", false, {}});
  check_ranges(draft);
  assume_the_rest(draft);
  return draft;
}

std::vector<DraftValue> assumed_of(const ModelDraft& draft) {
  std::vector<DraftValue> assumed;
  for (const machine::KeySpec& spec : machine::kKeys) {
    const DraftValue* const value = draft.find(spec.table, spec.key);
    if (value != nullptr && value->assumed) assumed.push_back(*value);
  }
  return assumed;
}

std::string provenance_of(const NewModelJob& job, const std::vector<DraftValue>& assumed,
                          const std::vector<std::string>& notes) {
  std::string text = job.provenance;
  if (text.empty()) text = notes.empty() ? "as stated to plumbline new-model" : notes.front();
  std::string keys;
  for (const DraftValue& value : assumed) {
    if (value.table != "uncertainty") keys += (keys.empty() ? "" : ", ") + value.key;
  }
  return keys.empty() ? text : text + "; assumed: " + keys;
}

// A text as lines of at most that width, cut at blanks.
std::vector<std::string> wrapped(std::string_view text) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > kHeadingWidth) lines.emplace_back();
    if (!lines.back().empty() && !word.empty()) lines.back() += ' ';
    lines.back() += word;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<std::string> heading_of(const NewModelJob& job, const ModelDraft& draft, bool assumes) {
  std::vector<std::string> lines{fmt::format("{}: written by plumbline new-model", draft.find("", "name")->text)};
  if (!job.provenance.empty()) {
    const std::vector<std::string> said = wrapped(job.provenance);
    lines.insert(lines.end(), said.begin(), said.end());
  }
  lines.push_back(fmt::format("Home, where the tip stands at rest, not turned: {}, {}, {} mm ({})",
                              to_decimal(draft.home_mm[0]), to_decimal(draft.home_mm[1]), to_decimal(draft.home_mm[2]),
                              draft.home_note));
  if (assumes)
    lines.emplace_back(
        "Lines with \"assumed\" are rules of thumb that nobody stated: put the machine's own numbers there");
  return lines;
}

// What the reader of models refuses, at the place where the value was stated: the text is not written anywhere yet.
machine::MachineModel read_draft(const DraftText& text, const std::string& file) {
  try {
    return machine::parse_model(text.text, file);
  } catch (const Refusal& refusal) {
    Diagnostic diagnostic = refusal.diagnostic();
    const std::size_t line = diagnostic.place.line;
    const DraftValue* const value = line >= 1 && line <= text.lines.size() ? text.lines[line - 1] : nullptr;
    if (value != nullptr && !value->place.file.empty()) {
      diagnostic.place = value->place;
    } else if (value != nullptr) {
      const std::string table = value->table.empty() ? "" : fmt::format("[{}] ", value->table);
      diagnostic.message =
          fmt::format("{}{}{}: {}", table, value->key, value->assumed ? ", which is assumed" : "", diagnostic.message);
      diagnostic.place = {};
    }
    throw Refusal(std::move(diagnostic));
  }
}

void check_home(NewModel& made) {
  const machine::MachineModel& model = made.model;
  const Pose<double> home = machine::home_pose(model);
  const auto refuse_home = [&](std::string_view why) {
    const Vector3<double> mm = home.p_WT / kMm;
    refuse("draft-home",
           fmt::format("in the middle of the travel, at {}, {}, {} mm, {}", to_decimal(mm.x()), to_decimal(mm.y()),
                       to_decimal(mm.z()), why),
           "check home, the travel, the lengths of the struts and the joints; --travel-x, --travel-y, --travel-z and "
           "--strut-min, --strut-max take precedence over what a control's files say");
  };
  const std::vector<machine::Violation> broken = machine::check_compensated(model.limits, model.geometry, home);
  if (!broken.empty()) refuse_home(machine::to_text(broken.front()));
  made.home_condition = machine::condition_number(machine::strut_geometry(model.geometry, home),
                                                  machine::platform_radius(model.geometry));
  const physics::ForceModel forces(model);
  physics::Environment at_rest = forces.environment();
  at_rest.friction = false;
  physics::Motion<double> motion;
  motion.pose = home;
  const physics::TipError<double> error = physics::tip_error(forces, at_rest, motion);
  if (!error.converged())
    refuse_home(fmt::format("the machine gives way: {}", physics::to_text(error.stopped_because)));
  made.home_error = error.displacement.head<3>().norm();
}

CornerCheck check_corners(const machine::MachineModel& model, double home_condition) {
  CornerCheck check;
  check.largest_condition = home_condition;
  const int side = machine::side_of(model.geometry, machine::home_pose(model));
  for (unsigned corner = 0; corner < 8; ++corner) {
    Pose<double> pose;
    for (unsigned a = 0; a < 3; ++a) {
      const machine::Range& range = model.limits.travel[a];
      pose.p_WT[a] = ((corner >> a) & 1U) != 0 ? range.upper : range.lower;
    }
    const std::vector<machine::Violation> broken = machine::check_compensated(model.limits, model.geometry, pose);
    if (!broken.empty()) {
      if (check.first_limit.empty()) check.first_limit = machine::to_text(broken.front());
      continue;
    }
    ++check.reached;
    if (machine::side_of(model.geometry, pose) != side) ++check.other_side;
    check.largest_condition =
        std::max(check.largest_condition, machine::condition_number(machine::strut_geometry(model.geometry, pose),
                                                                    machine::platform_radius(model.geometry)));
  }
  return check;
}

}  // namespace

NewModel make_new_model(const NewModelJob& job) {
  NewModel made;
  ModelDraft draft = draft_of(job, made.notes);
  made.assumed = assumed_of(draft);
  draft.put({"", "provenance", {}, provenance_of(job, made.assumed, made.notes), "", false, {}});
  const DraftText text = draft_text(draft, heading_of(job, draft, !made.assumed.empty()));
  made.text = text.text;
  made.model = read_draft(text, job.file);
  check_home(made);
  made.corners = check_corners(made.model, made.home_condition);
  return made;
}

}  // namespace plumbline::jobs
