#include "identify/noise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

namespace plumbline::identify {
namespace {

constexpr double kMedianToSigma = 1.4826;  // of a normal distribution: sigma over the median of |e|

// The residuals of one channel, run by run, and what each run's set-up can take of them.
struct ChannelResiduals {
  std::vector<Eigen::VectorXd> residuals;
  std::vector<Eigen::MatrixXd> setups;
  Eigen::Index samples = 0;
};

ChannelResiduals residuals_of(const std::vector<RunEquations>& runs, int channel) {
  ChannelResiduals all;
  for (const RunEquations& run : runs) {
    const auto place = std::find(run.channels.begin(), run.channels.end(), channel);
    if (place == run.channels.end()) continue;
    all.residuals.emplace_back(run.residual.segment((place - run.channels.begin()) * run.samples, run.samples));
    all.setups.push_back(channel == kRadial ? run.setup_slopes : Eigen::MatrixXd(run.samples, 0));
    all.samples += run.samples;
  }
  return all;
}

double robust_sigma(const ChannelResiduals& all) {
  std::vector<double> sizes;
  sizes.reserve(static_cast<std::size_t>(all.samples));
  for (const Eigen::VectorXd& run : all.residuals) {
    for (const double e : run) sizes.push_back(std::abs(e));
  }
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return kMedianToSigma * *middle;
}

double least_sigma(int channel, const NoiseOptions& options) {
  return channel == kRadial ? options.least_sigma_um * kUm : options.least_sigma_Nm;
}

// a^T V^-1 b of the noise with unit variance and memory m is [whole - m lagged + m^2 inner] / (1 - m^2), whole the sum
// over all samples, lagged over neighbours both ways, inner without the first and last sample.
struct Grams {
  Eigen::MatrixXd whole, lagged, inner;
  Eigen::Index samples;

  explicit Grams(const Eigen::MatrixXd& columns) : samples(columns.rows()) {
    const Eigen::Index n = samples;
    whole = columns.transpose() * columns;
    const Eigen::MatrixXd one_way = columns.topRows(n - 1).transpose() * columns.bottomRows(n - 1);
    lagged = one_way + one_way.transpose();
    inner = columns.middleRows(1, n - 2).transpose() * columns.middleRows(1, n - 2);
  }
  Eigen::MatrixXd at(double memory) const {
    return (whole - memory * lagged + memory * memory * inner) / (1 - memory * memory);
  }
};

// What the restricted likelihood makes of one memory: its best sigma, and -2 log of the likelihood there.
struct Trial {
  double variance = 0;
  double deviance = 0;
};

Trial trial(const std::vector<Grams>& runs, double memory, double taken) {
  double squares = 0;
  double determinants = 0;
  double degrees = -taken;
  for (const Grams& run : runs) {
    const Eigen::MatrixXd gram = run.at(memory);
    const Eigen::Index setup = gram.rows() - 1;
    double left = gram(setup, setup);
    if (setup > 0) {
      const Eigen::LLT<Eigen::MatrixXd> llt(gram.topLeftCorner(setup, setup));
      const Eigen::VectorXd half = llt.matrixL().solve(gram.topRightCorner(setup, 1));
      left -= half.squaredNorm();
      for (Eigen::Index i = 0; i < setup; ++i) determinants += 2 * std::log(llt.matrixLLT()(i, i));
    }
    squares += std::max(left, 0.0);
    determinants += static_cast<double>(run.samples - 1) * std::log(1 - memory * memory);
    degrees += static_cast<double>(run.samples - setup);
  }
  degrees = std::max(degrees, 1.0);
  return {squares / degrees, degrees * std::log(std::max(squares / degrees, 1e-300)) + determinants};
}

// The memory of the smallest deviance: golden section, the deviance having one minimum.
double best_memory(const std::vector<Grams>& runs, double taken, double most) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr double kTolerance = 1e-4;
  double lower = -most;
  double upper = most;
  while (upper - lower > kTolerance) {
    const double a = upper - kGolden * (upper - lower);
    const double b = lower + kGolden * (upper - lower);
    if (trial(runs, a, taken).deviance < trial(runs, b, taken).deviance) {
      upper = b;
    } else {
      lower = a;
    }
  }
  return 0.5 * (lower + upper);
}

}  // namespace

NoiseModel rough_noise(const std::vector<RunEquations>& runs, const NoiseOptions& options) {
  NoiseModel noise;
  for (int channel = 0; channel < kChannels; ++channel) {
    const ChannelResiduals all = residuals_of(runs, channel);
    noise.channels[static_cast<std::size_t>(channel)] = {std::max(robust_sigma(all), least_sigma(channel, options)), 0,
                                                         all.samples};
  }
  return noise;
}

NoiseModel estimate_noise(const std::vector<RunEquations>& runs, const NoiseOptions& options) {
  NoiseModel noise = rough_noise(runs, options);
  const Eigen::Index total =
      std::accumulate(noise.channels.begin(), noise.channels.end(), Eigen::Index{0},
                      [](Eigen::Index sum, const ChannelNoise& channel) { return sum + channel.samples; });
  for (int channel = 0; channel < kChannels; ++channel) {
    ChannelNoise& found = noise.channels[static_cast<std::size_t>(channel)];
    if (found.samples == 0) continue;
    const ChannelResiduals all = residuals_of(runs, channel);
    const double most = options.clip * found.sigma;
    std::vector<Grams> grams;
    for (std::size_t r = 0; r < all.residuals.size(); ++r) {
      Eigen::MatrixXd columns(all.residuals[r].size(), all.setups[r].cols() + 1);
      columns << all.setups[r], all.residuals[r].cwiseMax(-most).cwiseMin(most);
      grams.emplace_back(columns);
    }
    const double taken = options.degrees_taken * static_cast<double>(found.samples) / static_cast<double>(total);
    found.memory = best_memory(grams, taken, options.most_memory);
    found.sigma = std::max(std::sqrt(trial(grams, found.memory, taken).variance), least_sigma(channel, options));
  }
  return noise;
}

void whiten(const ChannelNoise& noise, Eigen::Ref<Eigen::MatrixXd> rows) {
  // the filter's gains do not depend on the data: x = memory (x + gain e), e = y - x, of variance F = P + white,
  // P' = memory^2 P (1 - gain) + (1 - memory^2) (1 - white)
  const double remembered = 1 - noise.white;
  Eigen::VectorXd gain(rows.rows());
  Eigen::VectorXd weight(rows.rows());
  double P = remembered;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const double F = P + noise.white;
    gain[i] = noise.memory * P / F;
    weight[i] = 1 / (noise.sigma * std::sqrt(F));
    P = noise.memory * noise.memory * P * noise.white / F + (1 - noise.memory * noise.memory) * remembered;
  }
  for (Eigen::Index c = 0; c < rows.cols(); ++c) {
    auto column = rows.col(c);
    double x = 0;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const double e = column[i] - x;
      x = noise.memory * x + gain[i] * e;
      column[i] = weight[i] * e;
    }
  }
}

void whiten(const NoiseModel& noise, RunEquations& equations) {
  const Eigen::Index n = equations.samples;
  for (std::size_t c = 0; c < equations.channels.size(); ++c) {
    const ChannelNoise& channel = noise.channels[static_cast<std::size_t>(equations.channels[c])];
    const Eigen::Index first = static_cast<Eigen::Index>(c) * n;
    whiten(channel, equations.residual.segment(first, n));
    if (equations.slopes.size() > 0) whiten(channel, equations.slopes.middleRows(first, n));
    if (equations.channels[c] == kRadial) whiten(channel, equations.setup_slopes);
  }
}

}  // namespace plumbline::identify
