#include "diagnose/description/products.hpp"

#include <algorithm>

#include <Eigen/QR>

#include "base/check.hpp"
#include "base/parallel.hpp"
#include "diagnose/description/waves.hpp"
#include "identify/equations/whitening.hpp"
#include "physics/effects/generic.hpp"

namespace plumbline::diagnose {
namespace {

using identify::SlopeRows;
using machine::kStruts;
using Channel = Term::Channel;

constexpr int kVectorParts = 3;
constexpr double kNoColumn = 1e-12;  // squared length, in units of the noise: a term that the runs do not show

// Factors of a product: 0 to 7 are a strut's, 8 to 13 shared.
using Product = std::vector<int>;

// All products of up to two factors, and some of three.
std::vector<Product> products(bool per_strut) {
  std::vector<Product> all{{}};
  const int first = per_strut ? 0 : physics::kStrutFactors;
  const int last = physics::kStrutFactors + physics::kSharedFactors;
  for (int a = first; a < last; ++a) {
    all.push_back({a});
    for (int b = a; b < last; ++b) all.push_back({a, b});
  }
  if (per_strut) {
    for (const int a : {0, 1, 3}) all.push_back({a, a, a});
    for (const int a : {0, 3, 5, 6, 7}) all.push_back({2, a, a});
    for (const int a : {0, 5, 6, 7}) all.push_back({3, a, a});
    all.push_back({3, 3, 4});
  }
  // the square of a sign
  all.erase(
      std::remove_if(all.begin(), all.end(), [](const Product& p) { return std::count(p.begin(), p.end(), 2) > 1; }),
      all.end());
  return all;
}

// Products of one channel, each on every part; last, where there are such terms, on all struts alike.
struct Family {
  Channel channel = Channel::length;
  std::vector<Product> products;
  int parts = kStruts;
  bool all_alike = true;

  explicit Family(Channel of) : channel(of) {
    const bool per_strut = is_per_strut(of);
    products = diagnose::products(per_strut);
    if (per_strut) return;
    parts = kVectorParts;
    all_alike = false;
  }
  Eigen::Index size() const { return static_cast<Eigen::Index>(products.size()); }
  int columns() const { return parts + (all_alike ? 1 : 0); }

  Term term(std::size_t product, int column) const {
    Term term;
    term.channel = channel;
    term.part = column < parts ? column : -1;
    for (const int f : products[product]) {
      if (f < physics::kStrutFactors) {
        ++term.strut_powers[static_cast<std::size_t>(f)];
      } else {
        ++term.shared_powers[static_cast<std::size_t>(f - physics::kStrutFactors)];
      }
    }
    return term;
  }
};

// The products of a part at each sample: a row each.
SlopeRows values_of(const Family& family, const ReadyRun& run, const physics::MachineConstants& machine, int part) {
  SlopeRows values(run.raw->samples, family.size());
  std::array<double, physics::kStrutFactors + physics::kSharedFactors> factors{};
  for (Eigen::Index s = 0; s < values.rows(); ++s) {
    const SampleState& state = run.states[static_cast<std::size_t>(s)];
    if (family.all_alike) {
      const auto own = strut_factors(machine, state, part);
      std::copy(own.begin(), own.end(), factors.begin());
    }
    const auto shared = shared_factors(state);
    std::copy(shared.begin(), shared.end(), factors.begin() + physics::kStrutFactors);
    for (Eigen::Index p = 0; p < values.cols(); ++p) {
      double value = 1;
      for (const int f : family.products[static_cast<std::size_t>(p)]) value *= factors[static_cast<std::size_t>(f)];
      values(s, p) = value;
    }
  }
  return values;
}

const std::vector<Family>& families() {
  static const std::vector<Family> all{Family(Channel::length), Family(Channel::drive), Family(Channel::torque),
                                       Family(Channel::force), Family(Channel::tip)};
  return all;
}

class RunSums {
 public:
  RunSums(const Family& family, const ReadyRun& run, const physics::MachineConstants& machine,
          const identify::NoiseModel& noise)
      : family_(family), run_(run), noise_(noise), slopes_(slopes_of(run, family.channel)) {
    values_.reserve(static_cast<std::size_t>(family.parts));
    for (int part = 0; part < family.parts; ++part) {
      values_.push_back(part == 0 || family.all_alike ? values_of(family, run, machine, part) : values_.front());
    }
  }

  // The squared lengths of all terms.
  Eigen::VectorXd squares() const {
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(family_.size() * family_.columns());
    for (std::size_t c = 0; c < run_.raw->channels.size(); ++c) add_squares(c, squares);
    return squares;
  }

  // `others`: rows of other columns, whitened, the set-up out, and whitened back.
  Eigen::MatrixXd cross_with(const SlopeRows& others) const {
    const Eigen::Index n = run_.raw->samples;
    Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(others.cols(), family_.size() * family_.columns());
    for (int part = 0; part < family_.parts; ++part) {
      SlopeRows by_value = SlopeRows::Zero(n, others.cols());
      for (std::size_t c = 0; c < run_.raw->channels.size(); ++c) {
        const Eigen::Index first = static_cast<Eigen::Index>(c) * n;
        by_value += slopes_.col(part).segment(first, n).asDiagonal() * others.middleRows(first, n);
      }
      auto own = cross.middleCols(part * family_.size(), family_.size());
      own.noalias() = by_value.transpose() * values_[static_cast<std::size_t>(part)];
      if (family_.all_alike) cross.rightCols(family_.size()) += own;
    }
    return cross;
  }

 private:
  // Of one channel of readings.
  void add_squares(std::size_t c, Eigen::VectorXd& squares) const {
    const Eigen::Index n = run_.raw->samples;
    const Eigen::Index size = family_.size();
    std::vector<int> acting;
    for (int part = 0; part < family_.parts; ++part) {
      if (!slopes_.col(part).segment(static_cast<Eigen::Index>(c) * n, n).isZero(0)) acting.push_back(part);
    }
    const auto count = static_cast<Eigen::Index>(acting.size());
    const bool sum = family_.all_alike && count > 1;
    SlopeRows columns(n, size * (count + (sum ? 1 : 0)));
    for (Eigen::Index s = 0; s < n; ++s) {
      for (Eigen::Index k = 0; k < count; ++k) {
        const int part = acting[static_cast<std::size_t>(k)];
        const double slope = slopes_(static_cast<Eigen::Index>(c) * n + s, part);
        columns.row(s).segment(k * size, size) = slope * values_[static_cast<std::size_t>(part)].row(s);
      }
      if (!sum) continue;
      auto together = columns.row(s).tail(size);
      together = columns.row(s).head(size);
      for (Eigen::Index k = 1; k < count; ++k) together += columns.row(s).segment(k * size, size);
    }
    take_setup_out(*run_.raw, c, noise_, columns);
    const Eigen::VectorXd own = columns.colwise().squaredNorm().transpose();
    for (Eigen::Index k = 0; k < count; ++k) {
      squares.segment(acting[static_cast<std::size_t>(k)] * size, size) += own.segment(k * size, size);
    }
    if (family_.all_alike && count > 0) squares.tail(size) += own.tail(size);
  }

  const Family& family_;
  const ReadyRun& run_;
  const identify::NoiseModel& noise_;
  Eigen::MatrixXd slopes_;         // of the readings by what a part of the channel is changed by
  std::vector<SlopeRows> values_;  // of the products, part by part
};

SlopeRows whitened_back(const ReadyRun& run, const identify::NoiseModel& noise, SlopeRows rows) {
  const Eigen::Index n = run.raw->samples;
  for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
    identify::whiten_back(noise.channels[static_cast<std::size_t>(run.raw->channels[c])],
                          rows.middleRows(static_cast<Eigen::Index>(c) * n, n));
  }
  return rows;
}

}  // namespace

Nuisances::Nuisances(const LinearProblem& problem, const Marginalised& marginalised) : columns(marginalised.columns) {
  Eigen::MatrixXd own = problem.gram(columns, columns);
  own.diagonal() += marginalised.precision;
  gram.compute(own);
  Eigen::VectorXd pull = problem.gram(columns, problem.residual());
  pull -= marginalised.precision.cwiseProduct(marginalised.departure);
  sizes = gram.solve(pull);
}

// What the terms have in common with these columns goes before the last of what they have by now, the residual. Family
// by family: those of all runs together would take most of the memory.
void ProductSums::add(const LinearProblem& problem, const std::vector<int>& columns) {
  const bool first = sums_.empty();
  for (std::size_t k = 0; k < families().size(); ++k) {
    std::vector<Sums> each(runs_.size());
    for_each_index(runs_.size(), [&](std::size_t i) {
      const RunSums sums(families()[k], runs_[i], machine_, noise_);
      each[i].cross = sums.cross_with(whitened_back(runs_[i], noise_, problem.rows_of(i, columns)));
      if (first) each[i].squares = sums.squares();
    });
    for (std::size_t i = 1; i < each.size(); ++i) {
      each[0].cross += each[i].cross;
      if (first) each[0].squares += each[i].squares;
    }
    if (first) {
      sums_.push_back(std::move(each[0]));
      continue;
    }
    const Eigen::MatrixXd before = std::move(sums_[k].cross);
    sums_[k].cross.resize(before.rows() + each[0].cross.rows(), before.cols());
    sums_[k].cross << before.topRows(before.rows() - 1), each[0].cross, before.bottomRows<1>();
  }
}

std::vector<Term> ProductSums::best(const LinearProblem& problem, const Nuisances& nuisances,
                                    const DescriptionOptions& options, double& tried) {
  const std::ptrdiff_t known = sums_.empty() ? 0 : sums_.front().cross.rows() - 1;
  std::vector<int> more(nuisances.columns.begin() + known, nuisances.columns.end());
  if (sums_.empty()) more.push_back(static_cast<int>(problem.residual()));
  if (!more.empty()) add(problem, more);
  std::vector<Term> all;
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const Family& family = families()[k];
    const Eigen::MatrixXd cross = sums_[k].cross.topRows(nuisances.sizes.size());
    // what the nuisances leave of the terms, and of what these have in common with the residual
    const Eigen::VectorXd lengths =
        sums_[k].squares - cross.cwiseProduct(nuisances.gram.solve(cross)).colwise().sum().transpose();
    const Eigen::VectorXd pulls = sums_[k].cross.bottomRows<1>().transpose() - cross.transpose() * nuisances.sizes;
    for (Eigen::Index t = 0; t < lengths.size(); ++t) {
      Term term = family.term(static_cast<std::size_t>(t % family.size()), static_cast<int>(t / family.size()));
      term.gain = lengths[t] > kNoColumn ? pulls[t] * pulls[t] / lengths[t] : 0;
      all.push_back(term);
    }
  }
  tried += static_cast<double>(all.size());
  return foremost(std::move(all), options.most_looked_at);
}

Eigen::MatrixXd ProductSums::cross_of(const Term& term) const {
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const Family& family = families()[k];
    if (family.channel != term.channel) continue;
    for (std::size_t p = 0; p < family.products.size(); ++p) {
      const Term own = family.term(p, 0);
      if (own.strut_powers != term.strut_powers || own.shared_powers != term.shared_powers) continue;
      return sums_[k].cross(Eigen::all, Eigen::seqN(static_cast<Eigen::Index>(p), family.parts, family.size()));
    }
  }
  PLUMBLINE_CHECK(false);
  return {};
}

std::vector<Term> best_products(const std::vector<ReadyRun>& runs, const physics::MachineConstants& machine,
                                const LinearProblem& problem, const Nuisances& nuisances,
                                const identify::NoiseModel& noise, const DescriptionOptions& options, double& tried) {
  return ProductSums(runs, machine, noise).best(problem, nuisances, options, tried);
}

}  // namespace plumbline::diagnose
