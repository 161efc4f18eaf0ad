#include "diagnose/description/waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"

namespace plumbline::diagnose {
namespace {

using machine::kStruts;
using Channel = Term::Channel;

// W^T r of a channel of a run, r its whitened residual, and what W makes of a unit at a sample, squared, on average.
struct Back {
  Eigen::VectorXd residual;
  double weight = 0;
};

// A channel each.
std::vector<Back> backs_of(const ReadyRun& run, const Block& block, const identify::NoiseModel& noise) {
  const Eigen::Index n = run.raw->samples;
  std::vector<Back> backs;
  for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
    Eigen::MatrixXd W = Eigen::MatrixXd::Identity(n, n);
    identify::whiten(noise.channels[static_cast<std::size_t>(run.raw->channels[c])], W);
    const auto residual = block.rows.rightCols<1>().segment(static_cast<Eigen::Index>(c) * n, n);
    backs.push_back({W.transpose() * residual, W.squaredNorm() / static_cast<double>(n)});
  }
  return backs;
}

struct Pull {
  double length, pull, weight;  // of a sample: L, the residual's slope by it, its square
};

// How the whitened residual moves with the length (the torque reading) of a strut at each sample.
void add_pulls(const ReadyRun& run, const std::vector<Back>& backs, Channel channel, int strut,
               std::vector<Pull>& pulls) {
  const Eigen::Index n = run.raw->samples;
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(n);
  for (std::size_t c = 0; c < backs.size(); ++c) {
    if (channel == Channel::torque) {
      if (run.raw->channels[c] != 1 + strut) continue;
      pull += backs[c].residual;
      weight.array() += backs[c].weight;
    } else {
      const auto slope = run.raw->slopes.col(strut).segment(static_cast<Eigen::Index>(c) * n, n);
      pull += slope.cwiseProduct(backs[c].residual);
      weight += slope.cwiseAbs2() * backs[c].weight;
    }
  }
  for (Eigen::Index s = 0; s < n; ++s) {
    pulls.push_back({run.states[static_cast<std::size_t>(s)].struts.length[strut], pull[s], weight[s]});
  }
}

// The strongest of all waves of a channel, of one strut or (-1) of all alike. Sine and cosine of each sample step from
// pitch to pitch by the addition theorem.
std::vector<Term> waves_of(const std::vector<Pull>& pulls, Channel channel, int strut,
                           const DescriptionOptions& options, double& tried) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const std::size_t count = pulls.size();
  std::vector<double> c(count);
  std::vector<double> s(count);
  std::vector<double> dc(count);
  std::vector<double> ds(count);
  double weight = 0;
  for (std::size_t i = 0; i < count; ++i) {
    weight += 0.5 * pulls[i].weight;
    c[i] = std::cos(kTurn * options.fewest_cycles * pulls[i].length);
    s[i] = std::sin(kTurn * options.fewest_cycles * pulls[i].length);
    dc[i] = std::cos(kTurn * options.wave_step * pulls[i].length);
    ds[i] = std::sin(kTurn * options.wave_step * pulls[i].length);
  }
  std::vector<Term> all;
  for (double f = options.fewest_cycles; f < 1 / options.finest_pitch; f += options.wave_step) {
    double cosine = 0;
    double sine = 0;
    for (std::size_t i = 0; i < count; ++i) {
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
  return foremost(std::move(all), options.peaks);
}

}  // namespace

std::vector<Term> foremost(std::vector<Term> terms, int count) {
  const auto kept = std::min(terms.size(), static_cast<std::size_t>(count));
  std::stable_sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.gain > b.gain; });
  terms.resize(kept);
  return terms;
}

std::vector<Term> best_waves(const std::vector<ReadyRun>& runs, const LinearProblem& problem,
                             const identify::NoiseModel& noise, const DescriptionOptions& options, double& tried) {
  std::vector<std::vector<Back>> backs(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) { backs[i] = backs_of(runs[i], problem.blocks[i], noise); });
  std::vector<Term> peaks;
  for (const Channel channel : {Channel::length, Channel::torque}) {
    std::vector<Pull> of_all;
    for (int strut = 0; strut <= kStruts; ++strut) {
      const bool all_alike = strut == kStruts;
      std::vector<Pull> own;
      for (std::size_t i = 0; i < runs.size() && !all_alike; ++i) add_pulls(runs[i], backs[i], channel, strut, own);
      of_all.insert(of_all.end(), own.begin(), own.end());
      const std::vector<Term> more =
          all_alike ? waves_of(of_all, channel, -1, options, tried) : waves_of(own, channel, strut, options, tried);
      peaks.insert(peaks.end(), more.begin(), more.end());
    }
  }
  return foremost(std::move(peaks), options.waves_looked_at);
}

}  // namespace plumbline::diagnose
