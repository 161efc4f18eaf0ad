#include "identify/equations/noise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "base/median.hpp"
#include "base/parallel.hpp"
#include "identify/equations/fitted_directions.hpp"
#include "identify/equations/whitening.hpp"

namespace plumbline::identify {
namespace {

constexpr double kMedianToSigma = 1.4826;  // of a normal distribution: sigma over the median of |e|

// The residuals of one channel, run by run, and what each run's set-up can take of them.
struct ChannelResiduals {
  std::vector<Eigen::VectorXd> residuals;
  std::vector<Eigen::MatrixXd> setups;
  std::vector<Eigen::MatrixXd> slopes;  // readings per direction of the unknowns; none if not asked for
  Eigen::Index samples = 0;
};

ChannelResiduals residuals_of(const std::vector<RunEquations>& runs, int channel,
                              const Eigen::MatrixXd* directions = nullptr) {
  ChannelResiduals all;
  std::vector<const RunEquations*> with_slopes;
  for (const RunEquations& run : runs) {
    const std::optional<Eigen::Index> first = run.first_row(channel);
    if (!first) continue;
    all.residuals.emplace_back(run.residual.segment(*first, run.samples));
    all.setups.push_back(*first < run.setup_slopes.rows()
                             ? Eigen::MatrixXd(run.setup_slopes.middleRows(*first, run.samples))
                             : Eigen::MatrixXd(run.samples, 0));
    if (directions != nullptr) with_slopes.push_back(&run);
    all.samples += run.samples;
  }
  all.slopes.resize(with_slopes.size());
  for_each_index(with_slopes.size(), [&](std::size_t i) {
    const RunEquations& run = *with_slopes[i];
    all.slopes[i] = run.slopes.middleRows(*run.first_row(channel), run.samples) * *directions;
  });
  return all;
}

double robust_sigma(const ChannelResiduals& all) {
  std::vector<double> sizes;
  sizes.reserve(static_cast<std::size_t>(all.samples));
  for (const Eigen::VectorXd& run : all.residuals) {
    for (const double e : run) sizes.push_back(std::abs(e));
  }
  if (sizes.empty()) return 0;
  return kMedianToSigma * median(std::move(sizes));
}

double least_sigma(int channel, const NoiseOptions& options) {
  if (channel == kTrackerTilt) return options.least_sigma_rad;
  return channel == kRadial || channel == kTracker ? options.least_sigma_um * kUm : options.least_sigma_Nm;
}

// What the restricted likelihood makes of one colour: its best sigma, and -2 log of the likelihood there.
struct Trial {
  double variance = 0;
  double deviance = 1e300;
  double memory = 0;
  double white = 0;
};

// Residuals of a channel: of each run a matrix whose columns are its set-up, the directions that were fitted, the
// residuals.
struct Channel {
  std::vector<SlopeRows> runs;
  std::vector<Eigen::Index> setups;  // how many columns
  Eigen::VectorXd elsewhere;         // precision of each direction from other channels and priors
  Eigen::VectorXd balance;           // products of directions and residuals where the fit ended, in units of variance
  double variance = 0;               // sigma^2 that the fit weighed these readings with
  double fitted_degrees = 0;         // of freedom, that the fit took

  // Whitened products of directions and residuals of all runs, set-ups out; and what the set-ups cost.
  struct Products {
    Eigen::MatrixXd sum;
    double determinants = 0;
    double degrees = 0;
  };

  Products products(double memory, double white) const {
    const ChannelNoise unit{1, memory, 0, white};
    std::vector<Products> each(runs.size());
    for_each_index(runs.size(), [&](std::size_t r) {
      SlopeRows columns = runs[r];
      whiten(unit, columns);
      Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
      gram.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
      gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
      const Eigen::Index setup = setups[r];
      const Eigen::Index rest = gram.rows() - setup;
      each[r].sum = gram.bottomRightCorner(rest, rest);
      if (setup > 0) {
        const Eigen::LLT<Eigen::MatrixXd> llt(gram.topLeftCorner(setup, setup));
        const Eigen::MatrixXd taken_out = llt.matrixL().solve(gram.topRightCorner(setup, rest));
        each[r].sum -= taken_out.transpose() * taken_out;
        each[r].determinants = 2 * llt.matrixLLT().diagonal().array().log().sum();
      }
      each[r].determinants -= 2 * log_weights(unit, columns.rows());
      each[r].degrees = static_cast<double>(columns.rows() - setup);
    });
    Products all = each.front();
    for (std::size_t r = 1; r < each.size(); ++r) {
      all.sum += each[r].sum;
      all.determinants += each[r].determinants;
      all.degrees += each[r].degrees;
    }
    return all;
  }

  Trial at(double memory, double white) const {
    Products p = products(memory, white);
    const Eigen::Index n = elsewhere.size();
    double squares = p.sum(n, n);
    if (n > 0) {
      // the misfit of this channel where the unknowns, held by all else that is known of them, would then go
      Eigen::MatrixXd precision = p.sum.topLeftCorner(n, n);
      precision.diagonal() += variance * elsewhere;
      const Eigen::LLT<Eigen::MatrixXd> llt(precision);
      squares -= llt.matrixL().solve(p.sum.topRightCorner(n, 1) - balance).squaredNorm();
      p.determinants += 2 * llt.matrixLLT().diagonal().array().log().sum();
    }
    const double degrees = std::max(p.degrees - fitted_degrees, 1.0);
    squares = std::max(squares, 0.0);
    return {squares / degrees, degrees * std::log(std::max(squares / degrees, 1e-300)) + p.determinants, memory, white};
  }
};

// The deviance of one colour, summed over channels that share it, each with the sigma that suits it best.
Trial trial(const std::vector<Channel>& channels, double memory, double white) {
  Trial sum{0, 0, memory, white};
  for (const Channel& channel : channels) {
    if (!channel.runs.empty()) sum.deviance += channel.at(memory, white).deviance;
  }
  return sum;
}

// The memory of the smallest deviance without a white part: golden section, the deviance having one minimum.
Trial best_memory(const std::vector<Channel>& channels, double most, double tolerance) {
  constexpr double kGolden = 0.6180339887498949;
  double lower = -most;
  double upper = most;
  Trial a = trial(channels, upper - kGolden * (upper - lower), 0);
  Trial b = trial(channels, lower + kGolden * (upper - lower), 0);
  while (upper - lower > tolerance) {
    if (a.deviance < b.deviance) {
      upper = b.memory;
      b = a;
      a = trial(channels, upper - kGolden * (upper - lower), 0);
    } else {
      lower = a.memory;
      a = b;
      b = trial(channels, lower + kGolden * (upper - lower), 0);
    }
  }
  return a.deviance < b.deviance ? a : b;
}

// From one colour by steps each way that shrink where none helps; the white part is held where it has none to begin
// with.
Trial best_near(const std::vector<Channel>& channels, const NoiseOptions& options, Trial from,
                const ColourSearch::Steps& steps) {
  Trial best = trial(channels, from.memory, from.white);
  const bool beside_white = from.white > 0;
  const double most = beside_white ? options.most_memory_beside_white : options.most_memory;
  const auto consider = [&](double memory, double white) {
    if (std::abs(memory) > most || white < 0 || white > options.most_white) return false;
    const Trial one = trial(channels, memory, white);
    if (one.deviance >= best.deviance) return false;
    best = one;
    return true;
  };
  double step = steps.first;
  while (step > steps.least) {
    const Trial now = best;
    const double away = std::min(1.0, 4 * (1 - now.memory));  // near 1 the memory means more
    bool better = consider(now.memory + step * away, now.white) || consider(now.memory - step * away, now.white);
    if (beside_white)
      better = better || consider(now.memory, now.white + step) || consider(now.memory, now.white - step);
    if (!better) step /= 2;
  }
  return best;
}

// A channel without the directions that were fitted.
Channel residuals_alone(const Channel& channel) {
  Channel bare;
  bare.setups = channel.setups;
  for (std::size_t r = 0; r < channel.runs.size(); ++r) {
    const SlopeRows& run = channel.runs[r];
    bare.runs.emplace_back(run.rows(), channel.setups[r] + 1);
    bare.runs.back() << run.leftCols(channel.setups[r]), run.rightCols(1);
  }
  return bare;
}

// Memory alone, or memory beside a white part if that is so much likelier. The residuals say where to look, and the
// directions that were fitted, if any were, what is best there.
Trial best_colour(const std::vector<Channel>& channels, const NoiseOptions& options) {
  const ColourSearch& search = options.search;
  std::vector<Channel> bare;
  for (const Channel& channel : channels) bare.push_back(residuals_alone(channel));
  Trial simple = best_memory(bare, options.most_memory, search.memory_tolerance);
  Trial beside;
  for (const double memory : search.memories) {
    for (const double white : search.whites) {
      const Trial one = trial(bare, memory, white);
      if (one.deviance < beside.deviance) beside = one;
    }
  }
  beside = best_near(bare, options, beside, search.residuals);
  const auto fitted = [](const Channel& channel) { return channel.elsewhere.size() > 0; };
  if (std::any_of(channels.begin(), channels.end(), fitted)) {
    simple = best_near(channels, options, simple, search.fitted_memory);
    beside = best_near(channels, options, beside, search.fitted);
  }
  Eigen::Index readings = 0;
  for (const Channel& channel : channels) {
    for (const SlopeRows& run : channel.runs) readings += run.rows();
  }
  return beside.deviance < simple.deviance - std::log(static_cast<double>(readings)) ? beside : simple;
}

// Residuals of a channel with its set-ups, outliers cut back at `most`.
Channel clipped(const ChannelResiduals& all, double most) {
  Channel channel;
  for (std::size_t r = 0; r < all.residuals.size(); ++r) {
    channel.setups.push_back(all.setups[r].cols());
    const Eigen::MatrixXd slopes = all.slopes.empty() ? Eigen::MatrixXd(all.residuals[r].size(), 0) : all.slopes[r];
    channel.runs.emplace_back(all.residuals[r].size(), all.setups[r].cols() + slopes.cols() + 1);
    channel.runs.back() << all.setups[r], slopes, all.residuals[r].cwiseMax(-most).cwiseMin(most);
  }
  return channel;
}

// A channel beside the directions of the unknowns that its readings were fitted with.
Channel channel_of(const std::vector<RunEquations>& runs, int channel, double most, const NoiseOptions& options,
                   const FittedUnknowns* fitted) {
  if (fitted == nullptr) return clipped(residuals_of(runs, channel), most);
  const FittedDirections directions = fitted_directions(runs, channel, *fitted, options.least_share);
  Channel one = clipped(residuals_of(runs, channel, &directions.changes), most);
  if (one.runs.empty()) return one;
  const ChannelNoise& noise = fitted->noise.channels[static_cast<std::size_t>(channel)];
  one.fitted_degrees = directions.degrees;
  one.variance = noise.sigma * noise.sigma;
  one.elsewhere = (1 - directions.share.array()).cwiseMax(0.0);
  const Eigen::MatrixXd now = one.products(noise.memory, noise.white).sum;
  one.balance = now.topRightCorner(one.elsewhere.size(), 1);
  return one;
}

// Of a channel whose noise does not remember: the residuals' mean square, allowing for unknowns and set-ups.
void estimate_white(const std::vector<RunEquations>& runs, int channel, const NoiseOptions& options,
                    const FittedUnknowns* fitted, NoiseModel& noise) {
  ChannelNoise& found = noise.channels[static_cast<std::size_t>(channel)];
  if (found.samples == 0) return;
  const ChannelResiduals all = residuals_of(runs, channel);
  const double most = options.clip * found.sigma;
  const bool both = noise.channels[kTracker].samples > 0 && noise.channels[kTrackerTilt].samples > 0;
  double squares = 0;
  auto degrees = static_cast<double>(found.samples);
  if (fitted != nullptr) degrees -= fitted_directions(runs, channel, *fitted, options.least_share).degrees;
  for (std::size_t r = 0; r < all.residuals.size(); ++r) {
    squares += all.residuals[r].cwiseMax(-most).cwiseMin(most).squaredNorm();
    degrees -= static_cast<double>(all.setups[r].cols()) / (both ? 2 : 1);
  }
  found.sigma = std::max(std::sqrt(squares / std::max(degrees, 1.0)), least_sigma(channel, options));
}

}  // namespace

NoiseModel rough_noise(const std::vector<RunEquations>& runs, const NoiseOptions& options) {
  NoiseModel noise;
  for (int channel = 0; channel < kAllChannels; ++channel) {
    const ChannelResiduals all = residuals_of(runs, channel);
    noise.channels[static_cast<std::size_t>(channel)] = {std::max(robust_sigma(all), least_sigma(channel, options)), 0,
                                                         all.samples};
  }
  return noise;
}

NoiseModel estimate_noise(const std::vector<RunEquations>& runs, const NoiseOptions& options,
                          const FittedUnknowns* fitted) {
  NoiseModel noise = rough_noise(runs, options);
  // the drives are of one kind: their torques share a colour
  for (const std::vector<int>& group : {std::vector<int>{kRadial}, std::vector<int>{1, 2, 3, 4, 5, 6}}) {
    std::vector<Channel> channels;
    for (const int channel : group) {
      const ChannelNoise& rough = noise.channels[static_cast<std::size_t>(channel)];
      channels.push_back(channel_of(runs, channel, options.clip * rough.sigma, options, fitted));
    }
    const auto measured = [](const Channel& c) { return !c.runs.empty(); };
    if (std::none_of(channels.begin(), channels.end(), measured)) continue;
    const Trial best = best_colour(channels, options);
    for (std::size_t i = 0; i < group.size(); ++i) {
      ChannelNoise& found = noise.channels[static_cast<std::size_t>(group[i])];
      found.memory = best.memory;
      found.white = best.white;
      const double variance = measured(channels[i]) ? channels[i].at(best.memory, best.white).variance : 0;
      found.sigma = std::max(std::sqrt(variance), least_sigma(group[i], options));
    }
  }
  for (const int channel : {kTracker, kTrackerTilt}) estimate_white(runs, channel, options, fitted, noise);
  return noise;
}

double low_frequency_variance(const ChannelNoise& noise) {
  return noise.sigma * noise.sigma * ((1 - noise.white) * (1 + noise.memory) / (1 - noise.memory) + noise.white);
}

}  // namespace plumbline::identify
