#include "diagnose/readings/noise_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include <unsupported/Eigen/FFT>

#include "base/parallel.hpp"
#include "base/units.hpp"

namespace plumbline::diagnose {
namespace {

using identify::kRadial;
using identify::RunEquations;

struct Band {
  double frequency = 0;  // cycles per sample, the mean
  double power = 0;      // of white noise: its variance
  double weight = 0;     // ordinates
};

struct Ordinate {
  double frequency, power;
};

// The periodogram at the frequencies k / n, k = 1 ... below n / 2: of white noise its variance on average.
std::vector<Ordinate> periodogram(const Eigen::VectorXd& e, int first) {
  const auto n = static_cast<double>(e.size());
  Eigen::FFT<double> fft;
  const std::vector<double> values(e.begin(), e.end());
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, values);
  std::vector<Ordinate> ordinates;
  for (auto k = static_cast<std::size_t>(first); 2 * k < values.size(); ++k) {
    ordinates.push_back({static_cast<double>(k) / n, std::norm(spectrum[k]) / n});
  }
  return ordinates;
}

// The mean of exponentially distributed powers whose largest may not belong to them: of the smallest share q of such
// the mean is 1 + (1 - q) log(1 - q) / q of that of all.
double trimmed_mean(std::vector<double> powers, double trimmed) {
  std::sort(powers.begin(), powers.end());
  const auto kept = static_cast<std::size_t>(std::ceil((1 - trimmed) * static_cast<double>(powers.size())));
  double sum = 0;
  for (std::size_t i = 0; i < kept; ++i) sum += powers[i];
  const double q = static_cast<double>(kept) / static_cast<double>(powers.size());
  const double share = q < 1 ? 1 + (1 - q) * std::log(1 - q) / q : 1;
  return sum / static_cast<double>(kept) / share;
}

// Bands narrow where frequencies are low: there the colour shows.
std::vector<Band> bands_of(const std::vector<Ordinate>& all, const SpectrumOptions& options) {
  std::map<int, std::vector<Ordinate>> grouped;
  for (const Ordinate& o : all) {
    const int band = static_cast<int>(options.bands * std::sqrt(2 * o.frequency));
    grouped[band].push_back(o);
  }
  std::vector<Band> bands;
  for (const auto& [number, ordinates] : grouped) {
    Band band;
    std::vector<double> powers;
    for (const Ordinate& o : ordinates) {
      band.frequency += o.frequency / static_cast<double>(ordinates.size());
      powers.push_back(o.power);
    }
    band.power = trimmed_mean(powers, options.trimmed);
    band.weight = static_cast<double>(powers.size());
    bands.push_back(band);
  }
  return bands;
}

// The spectrum of unit variance: (1 - w) (1 - m^2) / (1 + m^2 - 2 m cos 2 pi f) + w
double shape(double memory, double white, double frequency) {
  const double remembered =
      (1 - memory * memory) / (1 + memory * memory - 2 * memory * std::cos(2 * std::numbers::pi * frequency));
  return (1 - white) * remembered + white;
}

double variance_of(const std::vector<Band>& bands, double memory, double white) {
  double sum = 0;
  double weight = 0;
  for (const Band& band : bands) {
    sum += band.weight * band.power / shape(memory, white, band.frequency);
    weight += band.weight;
  }
  return weight > 0 ? sum / weight : 0;
}

// Whittle: sum of log S + I / S, its variance the best
double deviance(const std::vector<std::vector<Band>>& channels, double memory, double white) {
  double sum = 0;
  for (const std::vector<Band>& bands : channels) {
    const double variance = std::max(variance_of(bands, memory, white), 1e-300);
    for (const Band& band : bands) {
      const double S = variance * shape(memory, white, band.frequency);
      sum += band.weight * (std::log(S) + band.power / S);
    }
  }
  return sum;
}

std::vector<Ordinate> ordinates_of(const std::vector<RunEquations>& runs, int channel) {
  std::vector<std::vector<Ordinate>> each(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) {
    const std::optional<Eigen::Index> first = runs[i].first_row(channel);
    if (!first) return;
    const Eigen::VectorXd e = runs[i].residual.segment(*first, runs[i].samples);
    each[i] = periodogram(e, channel == kRadial ? 2 : 1);  // the ball takes the first
  });
  std::vector<Ordinate> all;
  for (const std::vector<Ordinate>& more : each) all.insert(all.end(), more.begin(), more.end());
  return all;
}

void estimate(const std::vector<RunEquations>& runs, const std::vector<int>& channels, const SpectrumOptions& options,
              identify::NoiseModel& noise) {
  std::vector<std::vector<Band>> bands;
  std::vector<int> measured;
  for (const int channel : channels) {
    const std::vector<Ordinate> all = ordinates_of(runs, channel);
    if (all.empty()) continue;
    bands.push_back(bands_of(all, options));
    measured.push_back(channel);
    for (const Band& band : bands.back())
      noise.channels[static_cast<std::size_t>(channel)].samples += static_cast<Eigen::Index>(2 * band.weight);
  }
  double best = 1e300;
  double memory = 0;
  double white = 0;
  for (double m = 0; m < options.most_colour; m += options.colour_step) {
    for (double w = 0; w < options.most_colour; w += options.colour_step) {
      if (m == 0 && w > 0) continue;
      const double d = deviance(bands, m, w);
      if (d < best) {
        best = d;
        memory = m;
        white = w;
      }
    }
  }
  for (std::size_t i = 0; i < measured.size(); ++i) {
    identify::ChannelNoise& channel = noise.channels[static_cast<std::size_t>(measured[i])];
    const double least = measured[i] == kRadial ? options.least_sigma_um * kUm : options.least_sigma_Nm;
    channel.memory = memory;
    channel.white = white;
    channel.sigma = std::max(std::sqrt(variance_of(bands[i], memory, white)), least);
  }
}

}  // namespace

double noise_power(const identify::ChannelNoise& noise, double frequency) {
  return noise.sigma * noise.sigma * shape(noise.memory, noise.white, frequency);
}

identify::NoiseModel noise_of(const std::vector<RunEquations>& runs, const SpectrumOptions& options) {
  identify::NoiseModel noise;
  estimate(runs, {kRadial}, options, noise);
  estimate(runs, {1, 2, 3, 4, 5, 6}, options, noise);
  return noise;
}

}  // namespace plumbline::diagnose
