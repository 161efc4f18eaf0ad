#include "diagnose/description.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

#include "base/parallel.hpp"
#include "diagnose/states.hpp"
#include "physics/effects/generic.hpp"

namespace plumbline::diagnose {
namespace {

using identify::kRadial;
using identify::RunEquations;
using machine::kStruts;
using physics::Generic;
using Channel = Term::Channel;

constexpr double kVectorParts = 3;

// The factors of the effect `generic`, in its units.
std::array<double, Generic::kStrutFactors> strut_factors(const physics::MachineConstants& machine, const State& s,
                                                         int j) {
  const double tension = s.nut_tension[j] * 1e-3;
  const Vector3<double> u = s.struts.direction.col(j);
  return {(s.struts.length[j] - machine.middle_length[j]) * 10,
          s.speed[j] * 100,
          s.sign[j],
          tension,
          std::abs(tension),
          u.x(),
          u.y(),
          u.z()};
}

std::array<double, Generic::kSharedFactors> shared_factors(const State& s) {
  const Vector3<double>& x = s.pose.p_WT;
  const Vector3<double> z = s.pose.R_WP.col(2);
  return {x[0] * 10, x[1] * 10, (x[2] - Generic::kMiddleHeight) * 10, z[0], z[1], s.time / 3600};
}

template <std::size_t N>
double product(const std::array<double, N>& factors, const std::array<int, N>& powers) {
  double value = 1;
  for (std::size_t k = 0; k < N; ++k) {
    for (int n = 0; n < powers[k]; ++n) value *= factors[k];
  }
  return value;
}

bool is_per_strut(Channel channel) {
  return channel == Channel::length || channel == Channel::drive || channel == Channel::torque;
}

// All products of up to two factors, and some of three, of which factors 0 to 7 are a strut's and 8 to 13 shared.
std::vector<Term> products(Channel channel, bool per_strut) {
  std::vector<std::vector<int>> lists{{}};
  const int first = per_strut ? 0 : Generic::kStrutFactors;
  const int last = Generic::kStrutFactors + Generic::kSharedFactors;
  for (int a = first; a < last; ++a) {
    lists.push_back({a});
    for (int b = a; b < last; ++b) lists.push_back({a, b});
  }
  if (per_strut) {
    for (const int a : {0, 1, 3}) lists.push_back({a, a, a});
    for (const int a : {0, 3, 5, 6, 7}) lists.push_back({2, a, a});
    for (const int a : {0, 5, 6, 7}) lists.push_back({3, a, a});
    lists.push_back({3, 3, 4});
  }
  std::vector<Term> terms;
  for (const std::vector<int>& list : lists) {
    Term term;
    term.channel = channel;
    for (const int f : list) {
      if (f < Generic::kStrutFactors) {
        ++term.strut_powers[static_cast<std::size_t>(f)];
      } else {
        ++term.shared_powers[static_cast<std::size_t>(f - Generic::kStrutFactors)];
      }
    }
    if (term.strut_powers[2] > 1) continue;  // the square of a sign
    terms.push_back(term);
  }
  return terms;
}

// A run made ready: what its samples are, and how its readings move with the channels.
struct RunAtHand {
  std::vector<State> states;
  const RunEquations* raw = nullptr;
  Eigen::MatrixXd drive;  // slopes by each strut's drive tension, rows as the residuals
  Eigen::MatrixXd force;  // by a force at the tip, x y z
  Eigen::MatrixXd tip;    // by the tip's displacement
};

class Describer {
 public:
  Describer(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem, const Taken& taken,
            const identify::NoiseModel& noise, const DescriptionOptions& options)
      : bench_(bench), forces_(forces), problem_(problem), taken_(taken), noise_(noise), options_(options) {
    runs_.resize(bench.runs.size());
    for_each_index(runs_.size(), [&](std::size_t i) { prepare(i); });
    Eigen::MatrixXd own = problem.gram(taken.columns, taken.columns);
    own.diagonal() += taken.precision;
    nuisances_.compute(own);
    Eigen::VectorXd pull = problem.gram(taken.columns, problem.residual());
    pull -= taken.precision.cwiseProduct(taken.departure);
    by_nuisances_ = nuisances_.solve(pull);
  }

  Description run() {
    Description found;
    std::vector<Term> best = best_products(found.tried);
    const std::vector<Term> waves = best_waves(found.tried);
    best.insert(best.end(), waves.begin(), waves.end());
    pick(best, found);
    return found;
  }

 private:
  void prepare(std::size_t i) {
    RunAtHand& run = runs_[i];
    run.raw = &problem_.raw[i];
    run.states = states_of(bench_.machine.rotation, forces_, bench_.runs[i]);
    const Eigen::Index n = run.raw->samples;
    const Eigen::Index rows = run.raw->residual.size();
    run.drive = run.raw->slopes;
    run.force.setZero(rows, 3);
    run.tip.setZero(rows, 3);
    const int K1 = forces_.find("axial-elasticity", "compliance_per_length_um_N_m");
    const int K2 = forces_.find("axial-elasticity", "compliance_um_N");
    const Vector3<double> ball = measure::ideal_ball(bench_.runs[i]);
    for (Eigen::Index s = 0; s < n; ++s) {
      const State& state = run.states[static_cast<std::size_t>(s)];
      for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
        const Eigen::Index row = static_cast<Eigen::Index>(c) * n + s;
        const int channel = run.raw->channels[c];
        for (int j = 0; j < kStruts; ++j) {
          const auto jj = static_cast<std::size_t>(j);
          const double compliance = forces_.parameters[static_cast<std::size_t>(K1) + jj] * state.struts.length[j] +
                                    forces_.parameters[static_cast<std::size_t>(K2) + jj];
          run.drive(row, j) *= compliance;
          if (channel == 1 + j) run.drive(row, j) += forces_.machine.lead[j] / (2 * std::numbers::pi);
        }
        if (channel == kRadial) run.tip.row(row) = (state.pose.p_WT - ball).normalized().transpose();
      }
      // a force at the tip: J^T t = (F, 0)
      const machine::Lu6<double> lu(machine::jacobian(state.struts));
      for (int a = 0; a < 3; ++a) {
        machine::Vector6<double> load = machine::Vector6<double>::Zero();
        load[a] = 1;
        const machine::PerStrut<double> tension = lu.solve_transposed(load);
        for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
          const Eigen::Index row = static_cast<Eigen::Index>(c) * n + s;
          run.force(row, a) = run.drive.row(row).dot(tension);
        }
      }
    }
  }

  static Eigen::Index size_of(const Term& term) { return term.part >= 0 || !is_per_strut(term.channel) ? 1 : kStruts; }

  // The readings' change by one strut's (axis's) coefficient of a term, times cos or -sin of its wave.
  Eigen::VectorXd column(const RunAtHand& run, const Term& term, int part, bool sine) const {
    const Eigen::Index n = run.raw->samples;
    const Eigen::Index rows = run.raw->residual.size();
    Eigen::VectorXd f(n);
    for (Eigen::Index s = 0; s < n; ++s) {
      const State& state = run.states[static_cast<std::size_t>(s)];
      f[s] = product(shared_factors(state), term.shared_powers);
      if (!is_per_strut(term.channel)) continue;
      f[s] *= product(strut_factors(forces_.machine, state, part), term.strut_powers);
      if (term.pitch > 0) {
        const double turn = 2 * std::numbers::pi * state.struts.length[part] / term.pitch;
        f[s] *= sine ? -std::sin(turn) : std::cos(turn);
      }
    }
    const auto channels = static_cast<Eigen::Index>(run.raw->channels.size());
    const Eigen::VectorXd all = f.replicate(channels, 1);
    switch (term.channel) {
      case Channel::length:
        return run.raw->slopes.col(part).cwiseProduct(all);
      case Channel::drive:
        return run.drive.col(part).cwiseProduct(all);
      case Channel::force:
        return run.force.col(part).cwiseProduct(all);
      case Channel::tip:
        return run.tip.col(part).cwiseProduct(all);
      case Channel::torque:
        break;
    }
    Eigen::VectorXd torque = Eigen::VectorXd::Zero(rows);
    for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
      if (run.raw->channels[c] == 1 + part) torque.segment(static_cast<Eigen::Index>(c) * n, n) = f;
    }
    return torque;
  }

  Eigen::MatrixXd columns_of(const RunAtHand& run, const std::vector<Term>& terms, bool sine = false) const {
    Eigen::MatrixXd columns(run.raw->residual.size(), static_cast<Eigen::Index>(terms.size()));
    for (std::size_t t = 0; t < terms.size(); ++t) {
      const auto c = static_cast<Eigen::Index>(t);
      if (terms[t].part >= 0) {
        columns.col(c) = column(run, terms[t], terms[t].part, sine);
      } else {
        columns.col(c).setZero();
        for (int j = 0; j < kStruts; ++j) columns.col(c) += column(run, terms[t], j, sine);
      }
    }
    return columns;
  }

  // Gram matrix of terms with the nuisances and the residual, these taken out.
  struct Projected {
    Eigen::MatrixXd gram;
    Eigen::VectorXd with_residual;
  };
  Projected projected(const std::vector<Term>& terms, const std::vector<bool>& sines, bool full) const {
    const auto count = static_cast<Eigen::Index>(terms.size());
    struct Sums {
      Eigen::MatrixXd cross, own;
      Eigen::VectorXd residual;
    };
    std::vector<Sums> sums(runs_.size());
    for_each_index(runs_.size(), [&](std::size_t i) {
      Eigen::MatrixXd columns(runs_[i].raw->residual.size(), count);
      for (std::size_t t = 0; t < terms.size(); ++t) {
        columns.col(static_cast<Eigen::Index>(t)) = columns_of(runs_[i], {terms[t]}, sines[t]);
      }
      columns = without_setup(*runs_[i].raw, std::move(columns), noise_);
      const Eigen::MatrixXd& rows = problem_.blocks[i].rows;
      sums[i].cross = rows(Eigen::all, taken_.columns).transpose() * columns;
      sums[i].residual = columns.transpose() * rows.col(problem_.residual());
      sums[i].own = full ? Eigen::MatrixXd(columns.transpose() * columns)
                         : Eigen::MatrixXd(columns.colwise().squaredNorm().asDiagonal());
    });
    Eigen::MatrixXd cross = sums[0].cross;
    Projected all{sums[0].own, sums[0].residual};
    for (std::size_t i = 1; i < sums.size(); ++i) {
      cross += sums[i].cross;
      all.gram += sums[i].own;
      all.with_residual += sums[i].residual;
    }
    const Eigen::MatrixXd solved = nuisances_.solve(cross);
    if (full) {
      all.gram -= cross.transpose() * solved;
    } else {
      for (Eigen::Index t = 0; t < count; ++t) all.gram(t, t) -= cross.col(t).dot(solved.col(t));
    }
    all.with_residual -= cross.transpose() * by_nuisances_;
    return all;
  }

  static std::vector<Term> with_parts(const std::vector<Term>& terms, int parts, bool shared) {
    std::vector<Term> all;
    for (Term term : terms) {
      for (int part = shared ? -1 : 0; part < parts; ++part) {
        term.part = part;
        all.push_back(term);
      }
    }
    return all;
  }

  std::vector<Term> best_products(double& tried) const {
    std::vector<Term> all;
    for (const Channel channel : {Channel::length, Channel::drive, Channel::torque}) {
      const std::vector<Term> more = with_parts(products(channel, true), kStruts, true);
      all.insert(all.end(), more.begin(), more.end());
    }
    for (const Channel channel : {Channel::force, Channel::tip}) {
      const std::vector<Term> more = with_parts(products(channel, false), static_cast<int>(kVectorParts), false);
      all.insert(all.end(), more.begin(), more.end());
    }
    tried += static_cast<double>(all.size());
    constexpr std::size_t kChunk = 256;
    for (std::size_t first = 0; first < all.size(); first += kChunk) {
      const std::size_t last = std::min(first + kChunk, all.size());
      const std::vector<Term> chunk(all.begin() + static_cast<std::ptrdiff_t>(first),
                                    all.begin() + static_cast<std::ptrdiff_t>(last));
      const Projected p = projected(chunk, std::vector<bool>(chunk.size(), false), false);
      for (std::size_t t = 0; t < chunk.size(); ++t) {
        const auto c = static_cast<Eigen::Index>(t);
        all[first + t].gain = p.gram(c, c) > 1e-12 ? p.with_residual[c] * p.with_residual[c] / p.gram(c, c) : 0;
      }
    }
    return foremost(std::move(all), options_.most_looked_at);
  }

  static std::vector<Term> foremost(std::vector<Term> terms, int count) {
    const auto kept = std::min(terms.size(), static_cast<std::size_t>(count));
    std::stable_sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.gain > b.gain; });
    terms.resize(kept);
    return terms;
  }

  // Waves in the length of a strut, by how they go with the residual alone: nuisances take little of them.
  std::vector<Term> best_waves(double& tried) const {
    std::vector<Term> peaks;
    for (const Channel channel : {Channel::length, Channel::torque}) {
      for (int j = -1; j < kStruts; ++j) {
        const std::vector<Term> more = waves_of(channel, j, tried);
        peaks.insert(peaks.end(), more.begin(), more.end());
      }
    }
    return foremost(std::move(peaks), options_.waves_looked_at);
  }

  struct Pull {
    double length, pull, weight;  // of a sample: L, the residual's slope by it, its square
  };

  // How the whitened residual moves with the length (the torque reading) of a strut at each sample.
  std::vector<Pull> pulls_of(Channel channel, int strut) const {
    std::vector<Pull> pulls;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const RunAtHand& run = runs_[i];
      const Eigen::Index n = run.raw->samples;
      Eigen::VectorXd pull = Eigen::VectorXd::Zero(n);
      Eigen::VectorXd weight = Eigen::VectorXd::Zero(n);
      for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
        const identify::ChannelNoise& of = noise_.channels[static_cast<std::size_t>(run.raw->channels[c])];
        if (channel == Channel::torque && run.raw->channels[c] != 1 + strut) continue;
        Eigen::MatrixXd W = Eigen::MatrixXd::Identity(n, n);
        identify::whiten(of, W);
        const auto first = static_cast<Eigen::Index>(c) * n;
        const Eigen::VectorXd back = W.transpose() * problem_.blocks[i].rows.col(problem_.residual()).segment(first, n);
        const Eigen::VectorXd slope = channel == Channel::torque
                                          ? Eigen::VectorXd(Eigen::VectorXd::Ones(n))
                                          : Eigen::VectorXd(run.raw->slopes.col(strut).segment(first, n));
        pull += slope.cwiseProduct(back);
        weight += slope.cwiseAbs2() * (W.squaredNorm() / static_cast<double>(n));
      }
      for (Eigen::Index s = 0; s < n; ++s) {
        pulls.push_back({run.states[static_cast<std::size_t>(s)].struts.length[strut], pull[s], weight[s]});
      }
    }
    return pulls;
  }

  std::vector<Term> waves_of(Channel channel, int strut, double& tried) const {
    std::vector<Pull> pulls;
    for (int j = strut < 0 ? 0 : strut; j <= (strut < 0 ? kStruts - 1 : strut); ++j) {
      const std::vector<Pull> more = pulls_of(channel, j);
      pulls.insert(pulls.end(), more.begin(), more.end());
    }
    double weight = 0;
    std::vector<double> c;
    std::vector<double> s;
    std::vector<double> dc;
    std::vector<double> ds;
    const double first = 10;  // cycles per metre: longer waves are products
    for (const Pull& p : pulls) {
      weight += 0.5 * p.weight;
      c.push_back(std::cos(2 * std::numbers::pi * first * p.length));
      s.push_back(std::sin(2 * std::numbers::pi * first * p.length));
      dc.push_back(std::cos(2 * std::numbers::pi * options_.wave_step * p.length));
      ds.push_back(std::sin(2 * std::numbers::pi * options_.wave_step * p.length));
    }
    std::vector<Term> all;
    for (double f = first; f < 1 / options_.finest_pitch; f += options_.wave_step) {
      double cosine = 0;
      double sine = 0;
      for (std::size_t i = 0; i < pulls.size(); ++i) {
        cosine += pulls[i].pull * c[i];
        sine += pulls[i].pull * s[i];
        const double next = c[i] * dc[i] - s[i] * ds[i];
        s[i] = s[i] * dc[i] + c[i] * ds[i];
        c[i] = next;
      }
      Term term;
      term.channel = channel;
      term.part = strut;
      term.pitch = 1 / f;
      term.gain = weight > 0 ? (cosine * cosine + sine * sine) / weight : 0;
      all.push_back(term);
    }
    tried += static_cast<double>(all.size());
    return foremost(std::move(all), 4);
  }

  // Forward selection among the foremost, exactly.
  void pick(const std::vector<Term>& best, Description& found) const {
    std::vector<Term> terms;
    std::vector<bool> sines;
    std::vector<std::vector<Eigen::Index>> groups;
    for (const Term& term : best) {
      groups.emplace_back();
      for (int part = 0; part < (term.pitch > 0 ? 2 : 1); ++part) {
        groups.back().push_back(static_cast<Eigen::Index>(terms.size()));
        terms.push_back(term);
        sines.push_back(part == 1);
      }
    }
    const Projected p = projected(terms, sines, true);
    std::vector<Eigen::Index> in;
    std::vector<std::size_t> chosen;
    double before = 0;
    for (int round = 0; round < options_.most_terms; ++round) {
      double most = 0;
      std::size_t which = groups.size();
      for (std::size_t g = 0; g < groups.size(); ++g) {
        if (std::find(chosen.begin(), chosen.end(), g) != chosen.end()) continue;
        std::vector<Eigen::Index> trial = in;
        trial.insert(trial.end(), groups[g].begin(), groups[g].end());
        const double gain = gain_of(p, trial) - before;
        if (gain > most) {
          most = gain;
          which = g;
        }
      }
      if (which == groups.size()) break;
      // one or two numbers more, and the best of so many
      const auto size = static_cast<double>(groups[which].size());
      const double odds =
          0.5 * (most - size - size * std::log(std::max(most / size, 1.0))) - std::log(std::max(found.tried, 1.0));
      if (round == 0) found.log_odds = odds;
      if (odds < options_.least_log_odds) break;
      chosen.push_back(which);
      in.insert(in.end(), groups[which].begin(), groups[which].end());
      before += most;
      found.terms.push_back(best[which]);
      found.terms.back().gain = most;
    }
    found.gain = before;
    if (in.empty()) return;
    const Eigen::VectorXd sizes = solve(p, in);
    Eigen::Index at = 0;
    for (Term& term : found.terms) {
      term.cosine = sizes[at++];
      if (term.pitch > 0) term.sine = sizes[at++];
    }
  }

  static Eigen::VectorXd solve(const Projected& p, const std::vector<Eigen::Index>& in) {
    Eigen::MatrixXd A = p.gram(in, in);
    const Eigen::VectorXd length = A.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    A = length.asDiagonal() * A * length.asDiagonal();
    A.diagonal().array() += 1e-6;
    return length.cwiseProduct(A.ldlt().solve(length.cwiseProduct(p.with_residual(in))));
  }
  static double gain_of(const Projected& p, const std::vector<Eigen::Index>& in) {
    const Eigen::VectorXd x = solve(p, in);
    return 2 * x.dot(p.with_residual(in)) - x.dot(p.gram(in, in) * x);
  }

  const Workbench& bench_;
  const physics::ForceModel& forces_;
  const LinearProblem& problem_;
  const Taken& taken_;
  const identify::NoiseModel& noise_;
  const DescriptionOptions& options_;
  std::vector<RunAtHand> runs_;
  Eigen::LDLT<Eigen::MatrixXd> nuisances_;
  Eigen::VectorXd by_nuisances_;
};

}  // namespace

Description describe(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem,
                     const Taken& taken, const identify::NoiseModel& noise, const DescriptionOptions& options) {
  return Describer(bench, forces, problem, taken, noise, options).run();
}

std::vector<double> generic_parameters(const Term& term) {
  std::vector<double> p(static_cast<std::size_t>(physics::effect_infos()[physics::effect_index("generic")].size()), 0);
  constexpr std::array kFirst{Generic::kLength, Generic::kDrive, Generic::kTorque, Generic::kForce, Generic::kTip};
  const auto first = static_cast<std::size_t>(kFirst.at(static_cast<std::size_t>(term.channel)));
  const double size = term.pitch > 0 ? std::hypot(term.cosine, term.sine) : term.cosine;
  if (term.part >= 0) {
    p[first + static_cast<std::size_t>(term.part)] = size;
  } else {
    for (std::size_t j = 0; j < kStruts; ++j) p[first + j] = size;
  }
  for (std::size_t k = 0; k < term.strut_powers.size(); ++k) p[Generic::kStrutPowers + k] = term.strut_powers[k];
  for (std::size_t k = 0; k < term.shared_powers.size(); ++k) p[Generic::kSharedPowers + k] = term.shared_powers[k];
  if (term.pitch > 0) {
    p[Generic::kPitch] = term.pitch;
    p[Generic::kPhase] = std::atan2(term.sine, term.cosine);
  }
  return p;
}

}  // namespace plumbline::diagnose
