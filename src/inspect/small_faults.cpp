#include "inspect/small_faults.hpp"

#include <algorithm>
#include <vector>

namespace plumbline::inspect {
namespace {

// A run is a little off, by a number that may be a little off, or in the way of another run: the model may lack what
// makes it so.
bool may_be_effect(const Fault& fault, const InspectOptions& options) {
  const bool little = is_by_degrees(fault.kind) || fault.kind == FaultKind::exchanged;
  return little && !fault.all && fault.before < options.clearly * fault.after;
}

}  // namespace

void doubt_small_faults(Inspection& found, const InspectOptions& options) {
  std::vector<bool> said(found.runs.size(), false);
  for (const Fault& fault : found.faults) {
    if (fault.all) continue;
    for (const std::size_t run : fault.runs) said[run] = true;
  }
  double most_off = 0;
  for (std::size_t run = 0; run < found.runs.size(); ++run) {
    if (!said[run]) most_off = std::max(most_off, found.runs[run].all);
  }
  for (Fault& fault : found.faults) {
    if (!may_be_effect(fault, options)) continue;
    const bool alike =
        is_setting(fault.kind) && std::any_of(found.faults.begin(), found.faults.end(), [&](const Fault& other) {
          return &other != &fault && other.kind == fault.kind && may_be_effect(other, options);
        });
    fault.may_be_effect = alike || most_off > options.as_far_off * fault.before;
    if (fault.may_be_effect) fault.blocks = false;
  }
  std::erase_if(found.faults, [&](const Fault& fault) {
    return is_setting(fault.kind) && !fault.all && !fault.may_be_effect && fault.nats < options.setting_nats;
  });
}

}  // namespace plumbline::inspect
