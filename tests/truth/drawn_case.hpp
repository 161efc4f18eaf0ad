// A blind case: a drawn machine with something hidden, measured on a plan, as files and with the answer.
#pragma once

#include <string>
#include <vector>

#include "truth/noise.hpp"
#include "truth/plan.hpp"
#include "truth/strength.hpp"

namespace truth {

struct CaseOptions {
  std::uint64_t seed = 1;
  std::string machine;          // file of the model
  std::string effect = "none";  // a name, none, any, outside, two, two:A,B, outside:NAME
  double snr = 0;               // wanted, of each effect
  std::string plan = "eight-pose";
  int samples = 120;  // of a run
  Colour colour = Colour::mixed;
  double memory = 0.7;
  double radial_noise = 0.5e-6, torque_noise = 0.05;  // m, N m
  FrictionLaw law = FrictionLaw::tanh;
  std::string programs;           // folder with a trace ID.jsonl for each run, to be run in place of the circles
  std::vector<std::string> more;  // circles to be measured after the plan: X,Y,Z,A,B,C,ccw,FEED,PAYLOAD in mm, deg, kg
  bool look_alikes = true;        // say what the rest of the catalogue makes of it: takes a second
};

/// One thing that was hidden.
struct Hidden {
  std::string name;
  bool outside = false;  // of every catalogue
  Flaws flaws;           // it alone
  double snr = 0;
  double beyond_all = 0;                                // what no effect of the catalogue imitates
  double beyond_others = 0;                             // what none but itself does
  double beyond_two = 0;                                // what no two others do together
  std::vector<std::pair<std::string, double>> nearest;  // other effects and what they leave, best first
};

struct MeasuredRun {
  PlannedRun planned;
  Samples samples;  // noisy and rounded
};

struct DrawnCase {
  CaseOptions options;
  Model model;
  Truth truth;
  std::vector<Hidden> hidden;
  std::vector<MeasuredRun> data, holdout, more;
};

/// Everything follows from the options. Throws std::runtime_error for what cannot be.
DrawnCase draw_case(const CaseOptions& options);

/// The machine of draw_case alone: what it is, and what is hidden in it.
Truth draw_truth(const CaseOptions& options);

/// Writes folder/base.toml, folder/data/, folder/holdout/, where there is more folder/more/, and folder/answer.json.
void write_case(const DrawnCase& drawn, const std::string& folder);

/// Writes folder/dataset.toml and its runs.
void write_dataset(const std::string& machine, const std::vector<MeasuredRun>& runs, const std::string& folder);

}  // namespace truth
