// M99 of the main program begins it again, with what the control then has in force.
#pragma once

#include <bitset>
#include <initializer_list>
#include <string>

#include "nc/control/execution.hpp"
#include "nc/control/state/control.hpp"

namespace plumbline::nc {

/// What a program states before it depends on it. Of controls that M99 of the main program begins again.
class SecondPass {
 public:
  /// The codes of a block, before they act.
  void note_codes(const Execution& run);
  /// Its motions.
  void note_motions(const Execution& run);
  /// What is in force at the end and would be in force at the begin of a second pass, otherwise than in the first;
  /// empty: nothing is.
  std::string differs(const Control& control, const ProgramSettings& settings) const;

 private:
  using Actions = std::bitset<256>;
  void begin(const Control& control);
  void note_places(const Execution& run);
  std::string other_place(const Control& control) const;
  bool stated(std::initializer_list<Action> actions) const;
  bool stated_length() const;

  Actions before_moves_;  // of the codes that stood before the first motion, or beside it
  Actions before_z_;      // before the first of Z, A, B or C
  Actions before_holes_;
  bool began_ = false, moved_ = false, moved_z_ = false, drilled_ = false;
  AxisWords begin_;      // where the machine stood, in its own words,
  AxisSet begin_known_;  // as far as that was known
  PathControl path_ = PathControl::continuous;
  AxisSet placed_;              // axes that motions named without increments
  AxisSet leans_;               // axes from whose places motions went before that
  AxisSet shifted_;             // axes that G52 named before the first motion
  bool writes_tables_ = false;  // G10 of what was used before, or under G91
};

}  // namespace plumbline::nc
