// What a model leaves of the readings, learnt as a sum of functions: each enters where the evidence asks for it and
// poses that were left out confirm it.
#pragma once

#include "diagnose/description/products.hpp"
#include "diagnose/residual_model/overlap.hpp"

namespace plumbline::diagnose {

struct ResidualOptions {
  int most_components = 8;
  int most_rounds = 3;         // linear problems, each about what the one before found
  double least_log_odds = 8;   // nats, all that was tried counted
  double least_left_out = 3;   // nats, by which poses that were left out are more likely
  double as_near = 1.01;       // as the terms of a description are runs held out, squared: what was learnt knows how
                               // sure it is
  double may_be_worse = 1e-5;  // chance that a part comes out further off, see identify::HoldOptions: functions that
                               // imitate a cause are less sure than they state
  int most_refused = 4;        // of the best ones that poses left out do not confirm
  double most_over_all = 4;    // of what the readings have of all components, that they may have of one: more than that
                               // and they cancel each other, which ends where the region ends
  int pitches = 6;             // that are looked at
  int points = 180;            // of a run, by which smooth functions are ranked; by all of them what is added is learnt
  std::vector<double> length_scales{0.3, 0.6, 1.2, 2.4};  // in half widths of what was measured
};

/// Functions of one shape with one prior.
struct Component {
  Shape shape;
  Region region;
  std::vector<int> parts;   // whose functions these are; -1: one function for all struts
  double length_scale = 0;  // in half widths; none of what is not smooth
  double spread = 0;        // sigma of the functions beforehand, SI
  Eigen::VectorXd sigmas;   // of their numbers, part after part, SI
  Eigen::VectorXd weights;  // these numbers, SI
  double log_odds = 0;      // nats
  double left_out = 0;      // nats
};

/// Learns from the problem about a model in which `before` act already (their sizes are fitted anew), and adds what
/// more there is. In the end all that is left has its weights.
class Learner {
 public:
  Learner(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem,
          Marginalised nuisances, const identify::NoiseModel& noise, const DescriptionOptions& description,
          ResidualOptions options);

  /// A component whose weights the model has.
  void take(const Component& component);
  /// Adds components as long as there are some, then fits the spreads of all anew and leaves out those that do not pay
  /// any more, or that cancel what was there before. Whether any was added.
  bool learn();

  const std::vector<Component>& components() const { return components_; }
  /// Of the nuisances (in their sigmas) and all weights (in theirs), in this order.
  Eigen::MatrixXd covariance() const;

 private:
  struct Found {
    Component component;
    double score = -1e9;
  };
  /// What is known of the columns that were taken and the residual, before the columns of a shape are.
  struct Gathered {
    std::vector<identify::SlopeRows> rows;  // in groups
    Eigen::MatrixXd cross;                  // with the columns of the shape, where it is known
  };

  identify::SlopeRows whitened(const Shape& shape, const Region& region, std::size_t run) const;
  Overlap overlap_of(const Shape& shape, const Region& region, const Gathered& gathered) const;
  void look_at(const Shape& shape, double tried, const Gathered& gathered, std::vector<Found>& found) const;
  std::vector<Found> ranked(ProductSums& products) const;
  bool try_adding(const Component& component);
  void append(const Component& component);
  void fit_spreads();
  void drop(std::size_t place);
  void solve();
  bool cancel() const;
  Eigen::Index first_of(std::size_t place) const;

  physics::MachineConstants machine_;
  std::vector<ReadyRun> runs_;
  std::vector<int> poses_;
  identify::NoiseModel noise_;
  DescriptionOptions description_;
  ResidualOptions options_;
  LinearProblem problem_;  // nuisances, then the components' numbers in their sigmas; the residual last
  Marginalised taken_;
  std::vector<Component> components_;
};

/// The columns of some parts of a shape's functions among those of all; of all alike their sum.
Eigen::MatrixXd choice_of(const std::vector<int>& parts, int functions, int all_parts);

/// The spread tau that makes numbers with these columns most likely, beforehand normal with tau squared, and the
/// logarithm of how much more likely than none: max over tau of [b.(A + 1 / tau^2)^-1 b - log det(1 + tau^2 A)] / 2
/// [MacKay 1992]
struct Spread {
  double tau = 0;
  double log_bayes = -1e9;
};
Spread best_spread(const Eigen::MatrixXd& gram, const Eigen::VectorXd& pull);

}  // namespace plumbline::diagnose
