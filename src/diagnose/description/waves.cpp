#include "diagnose/description/waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/angle.hpp"
#include "base/parallel.hpp"
#include "identify/equations/whitening.hpp"

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
std::vector<Back> backs_of(const ReadyRun& run, const identify::SlopeRows& left, const identify::NoiseModel& noise) {
  const Eigen::Index n = run.raw->samples;
  std::vector<Back> backs;
  for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
    const identify::ChannelNoise& channel = noise.channels[static_cast<std::size_t>(run.raw->channels[c])];
    identify::SlopeRows residual = left.middleRows(static_cast<Eigen::Index>(c) * n, n);
    identify::whiten_back(channel, residual);
    backs.push_back({residual, identify::whitened_unit(channel, n)});
  }
  return backs;
}

// Samples of all runs: L, the residual's slope by it, its square.
struct Pulls {
  std::vector<double> length, pull, weight;
};

// How the whitened residual moves with the length (the torque reading) of a strut at each sample.
void add_pulls(const ReadyRun& run, const std::vector<Back>& backs, Channel channel, int strut, Pulls& pulls) {
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
  pulls.pull.insert(pulls.pull.end(), pull.begin(), pull.end());
  pulls.weight.insert(pulls.weight.end(), weight.begin(), weight.end());
  for (const SampleState& state : run.states) pulls.length.push_back(state.struts.length[strut]);
}

// What a wave of each frequency has in common with the pulls, its cosine and its sine. Sine and cosine of each sample
// step from pitch to pitch by the addition theorem, some samples at a time: these stay in the processor's cache.
struct Common {
  Eigen::ArrayXd cosine, sine;
};
Common common_with(const Pulls& pulls, const std::vector<double>& frequencies, double step) {
  constexpr Eigen::Index kTogether = 512;
  const auto samples = static_cast<Eigen::Index>(pulls.length.size());
  const auto count = static_cast<Eigen::Index>(frequencies.size());
  Common common{Eigen::ArrayXd::Zero(count), Eigen::ArrayXd::Zero(count)};
  const Eigen::Map<const Eigen::ArrayXd> length(pulls.length.data(), samples);
  const Eigen::Map<const Eigen::ArrayXd> pull(pulls.pull.data(), samples);
  for (Eigen::Index first = 0; first < samples; first += kTogether) {
    const Eigen::Index some = std::min(kTogether, samples - first);
    const Eigen::ArrayXd turn = kTurn * length.segment(first, some);
    const auto of = pull.segment(first, some);
    Eigen::ArrayXd c = (frequencies.front() * turn).cos();
    Eigen::ArrayXd s = (frequencies.front() * turn).sin();
    const Eigen::ArrayXd dc = (step * turn).cos();
    const Eigen::ArrayXd ds = (step * turn).sin();
    Eigen::ArrayXd next(some);
    for (Eigen::Index f = 0; f < count; ++f) {
      common.cosine[f] += (of * c).sum();
      common.sine[f] += (of * s).sum();
      next = c * dc - s * ds;
      s = s * dc + c * ds;
      c.swap(next);
    }
  }
  return common;
}

// The strongest of all waves of a channel, of one strut or (-1) of all alike.
std::vector<Term> waves_of(const Pulls& pulls, Channel channel, int strut, const std::vector<double>& frequencies,
                           const DescriptionOptions& options) {
  const Common common = common_with(pulls, frequencies, options.wave_step);
  const double weight = 0.5 * std::accumulate(pulls.weight.begin(), pulls.weight.end(), 0.0);
  std::vector<Term> all;
  for (std::size_t f = 0; f < frequencies.size(); ++f) {
    const double cosine = common.cosine[static_cast<Eigen::Index>(f)];
    const double sine = common.sine[static_cast<Eigen::Index>(f)];
    Term term;
    term.channel = channel;
    term.part = strut;
    term.pitch = 1 / frequencies[f];
    term.gain = weight > 0 ? (cosine * cosine + sine * sine) / weight : 0;
    all.push_back(term);
  }
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
  for_each_index(runs.size(),
                 [&](std::size_t i) { backs[i] = backs_of(runs[i], problem.blocks[i].rows.rightCols<1>(), noise); });
  std::vector<double> frequencies;
  for (double f = options.fewest_cycles; f < 1 / options.finest_pitch; f += options.wave_step) frequencies.push_back(f);
  constexpr std::array kChannels{Channel::length, Channel::torque};
  constexpr std::size_t kTimes = kStruts + 1;  // each strut, and all alike
  std::vector<std::vector<Term>> each(kChannels.size() * kTimes);
  for_each_index(each.size(), [&](std::size_t k) {
    const Channel channel = kChannels.at(k / kTimes);
    const auto strut = static_cast<int>(k % kTimes);
    const bool alike = strut == kStruts;
    Pulls pulls;
    for (int j = alike ? 0 : strut; j < (alike ? kStruts : strut + 1); ++j) {
      for (std::size_t i = 0; i < runs.size(); ++i) add_pulls(runs[i], backs[i], channel, j, pulls);
    }
    each[k] = waves_of(pulls, channel, alike ? -1 : strut, frequencies, options);
  });
  tried += static_cast<double>(each.size() * frequencies.size());
  std::vector<Term> peaks;
  for (const std::vector<Term>& more : each) peaks.insert(peaks.end(), more.begin(), more.end());
  return foremost(std::move(peaks), options.waves_looked_at);
}

std::vector<double> best_pitches(const std::vector<ReadyRun>& runs, const std::vector<identify::SlopeRows>& left,
                                 const identify::NoiseModel& noise, Channel channel, const DescriptionOptions& options,
                                 int count, double& tried) {
  std::vector<Pulls> pulls(kStruts);
  for_each_index(pulls.size(), [&](std::size_t j) {
    for (std::size_t i = 0; i < runs.size(); ++i)
      add_pulls(runs[i], backs_of(runs[i], left[i], noise), channel, static_cast<int>(j), pulls[j]);
  });
  // the sum over struts of what the misfit drops by
  const auto gains = [&](const std::vector<double>& frequencies, double step) {
    std::vector<Eigen::ArrayXd> each(kStruts);
    for_each_index(pulls.size(), [&](std::size_t j) {
      const Common common = common_with(pulls[j], frequencies, step);
      const double weight = 0.5 * std::accumulate(pulls[j].weight.begin(), pulls[j].weight.end(), 0.0);
      each[j] = (common.cosine.square() + common.sine.square()) / std::max(weight, 1e-300);
    });
    for (std::size_t j = 1; j < each.size(); ++j) each[0] += each[j];
    return each[0];
  };
  const double step = options.wave_step / 2;
  std::vector<double> frequencies;
  for (double f = options.fewest_cycles; f < 1 / options.finest_pitch; f += step) frequencies.push_back(f);
  tried += static_cast<double>(frequencies.size());
  const Eigen::ArrayXd coarse = gains(frequencies, step);
  std::vector<Eigen::Index> peaks;
  for (Eigen::Index f = 1; f + 1 < coarse.size(); ++f) {
    if (coarse[f] > coarse[f - 1] && coarse[f] >= coarse[f + 1]) peaks.push_back(f);
  }
  std::stable_sort(peaks.begin(), peaks.end(), [&](Eigen::Index a, Eigen::Index b) { return coarse[a] > coarse[b]; });
  peaks.resize(std::min(peaks.size(), static_cast<std::size_t>(count)));
  constexpr int kFiner = 10;
  std::vector<double> pitches;
  for (const Eigen::Index peak : peaks) {
    std::vector<double> near;
    for (int k = -kFiner; k <= kFiner; ++k)
      near.push_back(frequencies[static_cast<std::size_t>(peak)] + step * k / kFiner);
    Eigen::Index best = 0;
    gains(near, step / kFiner).maxCoeff(&best);
    pitches.push_back(1 / near[static_cast<std::size_t>(best)]);
  }
  return pitches;
}

}  // namespace plumbline::diagnose
