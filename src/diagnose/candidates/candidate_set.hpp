// The set of effects that may be missing, as columns of a linear problem: what each adds to the readings for small
// sizes.
#pragma once

#include <string>
#include <vector>

#include "identify/unknowns/unknowns.hpp"

namespace plumbline::diagnose {

class CandidateKind;

/// One number that may be missing from the model. Its column of the linear problem is the change of all readings with
/// it.
struct Column {
  std::string effect;
  std::string key;
  int index = -1;    // among the key's numbers; -1: the only one
  int strut = -1;    // 0 to 5; -1: of all struts
  int unknown = -1;  // its place among the unknowns; -1: made from other columns
  double scale = 1;  // SI per unit of the linear problem
  double lower = 0;  // bounds, in units of the linear problem
  double upper = 0;
};

/// Columns that belong together: a strut, a joint; an effect without parts has one group.
using ColumnGroup = std::vector<int>;

/// One way in which an effect may act; an effect that bends has several, one for each shape that is tried.
struct ActingMode {
  std::vector<ColumnGroup> column_groups;  // each may act or not
  bool all_or_none = false;                // groups act together
  bool sums_to_zero = false;               // the numbers of all columns
  double shape = 0;                        // what bends, SI; see physics::Bend
};

/// An effect that may be missing.
struct Candidate {
  std::string name;
  bool rare = false;  // less common than others
  std::vector<ActingMode> modes;
  const CandidateKind* kind = nullptr;  // how its columns and its numbers belong together
};

struct CandidateSetOptions {
  std::vector<std::string> without;  // effects to be left out
};

struct CandidateSet {
  identify::Unknowns unknowns;  // nuisances first, then all numbers of all candidates that are not among them
  std::size_t nuisances = 0;    // how many of the unknowns are
  std::vector<Column> columns;  // of the linear problem: first one for each unknown, then those made from others
  std::vector<Candidate> all;

  const Candidate& candidate(std::string_view name) const;
};

/// Refuses with diagnose-unknown-effect what `without` names and the catalogue does not.
CandidateSet make_candidate_set(const machine::MachineModel& machine, const physics::ForceModel& forces,
                                const CandidateSetOptions& options = {});

/// No candidates: the nuisances, and what else linearise() takes slopes by.
CandidateSet make_nuisance_set(const machine::MachineModel& machine, const physics::ForceModel& forces);

}  // namespace plumbline::diagnose
