// Readings that stand in the records twice: of two runs, or of two motors.
#pragma once

#include <vector>

#include "inspect/fault.hpp"
#include "measure/dataset.hpp"

namespace plumbline::inspect {

/// Finds runs that are given twice: with the same readings at the same angles, be one of them cut short, thinned or
/// rounded.
class AlikeRuns {
 public:
  /// `runs` is kept by reference.
  explicit AlikeRuns(const std::vector<measure::Run>& runs);

  /// Whether more than `share` of the readings of `a` and `b` are alike, sample by sample or at the same angles.
  bool alike(std::size_t a, std::size_t b, double share) const;

 private:
  struct Turn {
    std::vector<double> angle;        // within a turn, ascending, rad
    std::vector<std::size_t> sample;  // of each
    std::vector<double> resolution;   // of each channel; nil: too coarse to be told from that of another run
  };

  bool alike_by_angle(std::size_t few, std::size_t many, double share) const;

  const std::vector<measure::Run>& runs_;
  std::vector<Turn> turns_;
};

/// Motors that have the readings of another one, or these with the other sign, in more than `share` of their samples:
/// one fault for two motors.
std::vector<Fault> motors_alike(const std::vector<measure::Run>& runs, double share);

}  // namespace plumbline::inspect
