#include "compensate/guard.hpp"

#include <fmt/format.h>

namespace plumbline::compensate {
namespace {

struct Kind {
  std::string_view code;
  std::string_view help;
};

Kind kind_of(const machine::Violation& violation) {
  if (violation.what == "tilt") {
    return {"limit-tilt", "re-post the program with less tilt, or correct [limits] tilt_deg of the model"};
  }
  if (violation.what == "condition") {
    return {"limit-condition", "stay away from this pose: the machine is near a singularity and hardly stiff there"};
  }
  if (violation.what.starts_with("strut")) {
    return {"limit-strut",
            "move the part (work offset) or the pose into the workspace; check length_min/max of the model"};
  }
  return {"limit-travel", "check the work offset (--work-offset), or move the part into the workspace"};
}

}  // namespace

Place place_of(const nc::Block& block, std::string_view file) {
  Place place;
  place.file = file;
  place.line = block.line;
  place.text = block.text;
  place.column = std::min(block.text.find_first_not_of(" \t"), block.text.size() - 1) + 1;
  place.length = block.text.size();
  return place;
}

Diagnostic diagnose(const machine::Violation& violation, const Place& place) {
  const Kind kind = kind_of(violation);
  return {std::string(kind.code), machine::to_text(violation), std::string(kind.help), place, Severity::error};
}

void refuse_violations(const std::vector<machine::Violation>& violations, const nc::Block& block,
                       std::string_view file) {
  if (!violations.empty()) throw Refusal(diagnose(violations.front(), place_of(block, file)));
}

}  // namespace plumbline::compensate
