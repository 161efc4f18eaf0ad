// All runs of a dataset fitted together, some of them mended alike: which ones would make all of them agree.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Cholesky>

#include "inspect/looked.hpp"

namespace plumbline::inspect {

/// Of each run.
using Which = std::vector<bool>;

/// What a run adds to what is known of the machine, as it is stated or mended.
struct Information {
  Eigen::MatrixXd gram;  // empty: as stated
  Eigen::VectorXd pull;
  Eigen::VectorXd white_pull;  // L^-1 pull, L L^T the information of all runs as stated
  double square = 0;
};

/// One fault that runs may have: what each of them is when it is mended.
struct Alike {
  Fault fault;
  std::vector<Information> mended;
  double penalty = 0;          // nats, for the alternatives and for what is fitted
  std::vector<double> volume;  // nats by which smaller readings of a run are less likely, and larger ones more
  std::function<void(measure::Run&)> change;  // of labels; empty: none
  Which first;                                // a first guess of which runs; empty: none

  /// Whether runs have other slopes when they are mended.
  bool labelled() const;
};

/// The readings of channel `to` become `by` times those that stand in channel `from`.
struct Moved {
  int to = 0, from = 0;
  double by = 1;
};

/// `looked` and `bench` are kept by reference.
class Together {
 public:
  Together(const Looked& looked, const Bench& bench);

  std::size_t runs() const { return stated_.size(); }
  /// The misfit of all runs as they are stated, about what they say together, and of how many readings.
  double chi2() const { return chi2_; }
  Eigen::Index rows() const { return rows_; }
  const Looked& looked() const { return looked_; }
  const Bench& bench() const { return bench_; }

  /// Other readings in each run, where it has both channels.
  std::vector<Information> with_channels(const std::vector<Moved>& moved) const;
  /// By what the readings of some channels of each run are best multiplied, all runs fitted together.
  std::vector<double> best_scales(const std::vector<int>& channels) const;
  /// Other labels. A run that the machine cannot make then stays as it is.
  std::vector<Information> with_labels(const std::function<void(measure::Run&)>& change) const;

  /// The misfit with some runs mended.
  double chi2_of(const Alike& alike, const Which& which) const;
  /// The least of it where so many of some runs, the worst one after the other, are left out, each of their readings
  /// then being off by its noise.
  double least_without(const std::vector<std::size_t>& some, std::size_t most) const;
  /// Which runs, each by itself and the priors alone, are better mended.
  Which better_alone(const Alike& alike) const;

 private:
  // What the readings of each channel are as rows, in its own place and, of motors, in that of each other one: what any
  // others make of a run is a sum of these.
  struct Readings {
    Eigen::MatrixXd pulls;      // slopes^T of each
    Eigen::MatrixXd squares;    // products with each other
    Eigen::VectorXd with_left;  // and with what is left as stated
  };
  // How a run tells of the machine by itself, with the priors alone.
  struct Alone {
    Eigen::LLT<Eigen::MatrixXd> factored;
    double chi2 = 0;  // as it is stated
  };

  Information as_stated(const RunRows& rows) const;
  Readings readings_of_channels(const RunRows& rows) const;
  Eigen::LLT<Eigen::MatrixXd> factored_alone(const Eigen::MatrixXd& gram) const;
  double chi2_without(const Which& out) const;

  const Looked& looked_;
  const Bench& bench_;
  std::vector<Information> stated_;
  std::vector<Readings> readings_;
  std::vector<Alone> alone_;
  Eigen::MatrixXd information_;
  Eigen::LLT<Eigen::MatrixXd> factored_;
  double chi2_ = 0;
  Eigen::Index rows_ = 0;
};

/// Which runs are mended, and what chi-square then is.
struct Chosen {
  Which which;
  double chi2 = 0;
  double volume = 0;   // of runs whose readings become smaller; others gain nothing: noise may be less than is assumed
  double density = 0;  // of all
  double objective() const { return chi2 + 2 * volume; }
};

/// The choice of runs for one fault. Both are kept by reference.
class Choice {
 public:
  Choice(const Together& together, const Alike& alike) : together_(together), alike_(alike) {}

  Chosen at(Which which) const;
  /// The best from several first guesses, a run that is mended being worth so many nats.
  Chosen best(double nats) const;

 private:
  Chosen from(Which which, double nats) const;
  bool moved(Chosen& best, double nats, bool pairs) const;

  const Together& together_;
  const Alike& alike_;
};

}  // namespace plumbline::inspect
