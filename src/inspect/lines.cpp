#include "inspect/lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Dense>

#include "base/angle.hpp"
#include "diagnose/readings/noise_spectrum.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using measure::Run;

// Between two samples, where none was left out.
double step_s(const Run& run) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < run.samples(); ++i) steps.push_back(run.time[i] - run.time[i - 1]);
  return median(std::move(steps));
}

double length_s(const Run& run) { return run.time.back() - run.time.front() + step_s(run); }

constexpr int kWaves = 8;  // of the circle, that are the machine's

// Waves of the circle up to that order, the mean first.
MatrixXd waves_of(const Run& run) {
  MatrixXd waves(static_cast<Index>(run.samples()), 2 * kWaves + 1);
  for (Index i = 0; i < waves.rows(); ++i) {
    const double angle = run.angle[static_cast<std::size_t>(i)];
    waves(i, 0) = 1;
    for (int k = 1; k <= kWaves; ++k) {
      waves(i, 2 * k - 1) = std::cos(k * angle);
      waves(i, 2 * k) = std::sin(k * angle);
    }
  }
  return waves;
}

// Sine and cosine in time; of the bar also as a shift of the floor shows along the circle.
MatrixXd columns_of(const Run& run, int channel, double frequency) {
  const auto n = static_cast<Index>(run.samples());
  MatrixXd columns(n, channel == identify::kRadial ? 6 : 2);
  for (Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double phase = kTurn * frequency * run.time[k];
    columns(i, 0) = std::cos(phase);
    columns(i, 1) = std::sin(phase);
    if (columns.cols() == 2) continue;
    const double x = std::cos(run.angle[k]);
    const double y = std::sin(run.angle[k]);
    columns.row(i).tail<4>() << x * columns(i, 0), x * columns(i, 1), y * columns(i, 0), y * columns(i, 1);
  }
  return columns;
}

// Runs sampled alike: their numbers among those of `left`.
std::vector<std::vector<std::size_t>> sampled_alike(const std::vector<Run>& runs) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return std::abs(step_s(runs[group[0]]) / step_s(runs[r]) - 1) < 0.01;
    });
    if (same == groups.end()) {
      groups.push_back({r});
    } else {
      same->push_back(r);
    }
  }
  return groups;
}

struct Residual {
  std::size_t run = 0;
  double step_s = 0;
  VectorXd e;
};

struct Fitted {
  double sigmas = 0;  // of chi-square over all runs
  double share = 0;   // of the runs that have it
  std::vector<VectorXd> sizes;
};

Fitted fit_line(const std::vector<Run>& runs, const std::vector<Residual>& residuals, int channel, double frequency,
                const identify::ChannelNoise& noise, const LineOptions& options) {
  Fitted fitted;
  double sum = 0;
  double degrees = 0;
  double with = 0;
  for (const Residual& residual : residuals) {
    const Run& run = runs[residual.run];
    const MatrixXd columns = columns_of(run, channel, frequency);
    const VectorXd size = columns.householderQr().solve(residual.e);
    const double gain = residual.e.squaredNorm() - (residual.e - columns * size).squaredNorm();
    const double power = diagnose::noise_power(noise, std::abs(frequency) * residual.step_s);
    const auto count = static_cast<double>(columns.cols());
    sum += gain / power;
    degrees += count;
    if (gain / power > options.least_gain * count) ++with;
    fitted.sizes.push_back(size);
  }
  fitted.sigmas = (sum - degrees) / std::sqrt(2 * degrees);
  fitted.share = with / static_cast<double>(residuals.size());
  return fitted;
}

// How large a line is, and which way it shakes.
void describe(Line& line, const std::vector<VectorXd>& sizes) {
  std::vector<double> alike;
  std::vector<double> along;
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const VectorXd& size : sizes) {
    alike.push_back(std::hypot(size[0], size[1]));
    if (size.size() == 2) continue;
    const Eigen::Matrix2d parts = (Eigen::Matrix2d() << size[2], size[3], size[4], size[5]).finished();
    squares += parts * parts.transpose();
    along.push_back(parts.norm());
  }
  line.amplitude = median(alike);
  if (along.empty() || median(along) < line.amplitude) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(squares);
  line.along = true;
  line.amplitude = median(along);
  line.direction = std::atan2(axes.eigenvectors()(1, 1), axes.eigenvectors()(0, 1));
}

std::vector<Line> lines_of_group(const std::vector<Run>& runs, std::vector<Residual> residuals, int channel,
                                 const identify::ChannelNoise& noise, const LineOptions& options) {
  std::vector<Line> lines;
  const Run& first = runs[residuals[0].run];
  const double length = length_s(first);
  const double highest = 0.5 / step_s(first) - 3 / length;  // nearer to half of the sampling sine and cosine are one
  while (lines.size() < options.most) {
    double best = options.least_order / length;
    double sigmas = -1;
    const double step = 1 / (options.steps_an_order * length);
    for (double f = best; f < highest; f += step) {
      const Fitted fitted = fit_line(runs, residuals, channel, f, noise, options);
      if (fitted.sigmas > sigmas) {
        sigmas = fitted.sigmas;
        best = f;
      }
    }
    for (double finer = step / 2; finer > step / 20; finer /= 2) {
      for (const double f : {best - finer, best + finer}) {
        if (f >= highest) continue;
        const Fitted fitted = fit_line(runs, residuals, channel, f, noise, options);
        if (fitted.sigmas <= sigmas) continue;
        sigmas = fitted.sigmas;
        best = f;
      }
    }
    const Fitted fitted = fit_line(runs, residuals, channel, best, noise, options);
    if (fitted.sigmas < options.sigmas || fitted.share < options.in_runs) break;
    Line line{channel, best, 1 / step_s(first)};
    describe(line, fitted.sizes);
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      line.runs.push_back(residuals[k].run);
      residuals[k].e -= columns_of(runs[residuals[k].run], channel, best) * fitted.sizes[k];
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

// What has as many periods a turn at another feed goes with the angle: the machine does it, however fine it is.
bool goes_with_angle(const std::vector<Run>& runs, const Line& line, const std::vector<std::vector<Residual>>& groups,
                     const identify::ChannelNoise& noise, const LineOptions& options) {
  constexpr double kSigmas = 5;
  const double length = length_s(runs[line.runs[0]]);
  for (const std::vector<Residual>& group : groups) {
    if (group.empty()) continue;
    const Run& first = runs[group[0].run];
    const bool other_feed = std::abs(length_s(first) / length - 1) > 0.1;
    const double frequency = line.frequency * length / length_s(first);
    if (!other_feed || frequency > 0.5 / step_s(first) - 3 / length_s(first)) continue;
    for (const double aside : {-0.3, 0.0, 0.3}) {  // of a period a turn
      const double f = frequency + aside / length_s(first);
      if (fit_line(runs, group, line.channel, f, noise, options).sigmas > kSigmas) return true;
    }
  }
  return false;
}

std::vector<double>& readings(Run& run, int channel) {
  return channel == identify::kRadial ? run.radial : run.torque.at(static_cast<std::size_t>(channel) - 1);
}

// Where sampling folds a frequency to.
double folded(double frequency, double sampling) {
  return std::abs(frequency - sampling * std::round(frequency / sampling));
}

}  // namespace

std::vector<Line> find_lines(const std::vector<Run>& runs, const std::vector<identify::RunEquations>& left,
                             const identify::NoiseModel& noise, const LineOptions& options) {
  std::vector<Line> lines;
  const std::vector<std::vector<std::size_t>> groups = sampled_alike(runs);
  for (int channel = 0; channel < identify::kChannels; ++channel) {
    const identify::ChannelNoise& of_channel = noise.channels[static_cast<std::size_t>(channel)];
    std::vector<std::vector<Residual>> residuals;  // of each group
    for (const std::vector<std::size_t>& group : groups) {
      std::vector<Residual>& of_group = residuals.emplace_back();
      for (const std::size_t r : group) {
        const auto row = left[r].first_row(channel);
        if (!row) continue;
        // what is left of long waves would leak into all frequencies
        const VectorXd e = left[r].residual.segment(*row, left[r].samples);
        const MatrixXd waves = waves_of(runs[r]);
        of_group.push_back({r, step_s(runs[r]), e - waves * waves.householderQr().solve(e)});
      }
    }
    for (const std::vector<Residual>& of_group : residuals) {
      if (of_group.size() < 2) continue;  // nothing in common with any other
      for (Line& line : lines_of_group(runs, of_group, channel, of_channel, options)) {
        if (!goes_with_angle(runs, line, residuals, of_channel, options)) lines.push_back(std::move(line));
      }
    }
  }
  return lines;
}

std::optional<double> common_frequency(const std::vector<Line>& lines, const std::vector<Run>& runs, double highest) {
  if (lines.empty()) return std::nullopt;
  // what the runs sampled fastest have, and all that is folded to it
  const Line& finest = *std::max_element(lines.begin(), lines.end(),
                                         [](const Line& a, const Line& b) { return a.sampling < b.sampling; });
  for (double whole = 0; whole * finest.sampling < highest; ++whole) {
    for (const double sign : {1.0, -1.0}) {
      const double f = whole * finest.sampling + sign * finest.frequency;
      if (f <= 0 || f > highest) continue;
      const bool all = std::all_of(lines.begin(), lines.end(), [&](const Line& line) {
        // a frequency is known to a part of its width, from the longer record better than from the shorter one
        const double width = 0.5 / length_s(runs[line.runs[0]]) + 0.25 / length_s(runs[finest.runs[0]]);
        return std::abs(folded(f, line.sampling) - line.frequency) < width;
      });
      if (all) return f;
    }
  }
  return std::nullopt;
}

std::vector<Run> without_lines(std::vector<Run> runs, const std::vector<Line>& lines) {
  for (const Line& line : lines) {
    for (const std::size_t r : line.runs) {
      Run& run = runs[r];
      std::vector<double>& values = readings(run, line.channel);
      const auto n = static_cast<Index>(values.size());
      const MatrixXd own = columns_of(run, line.channel, line.frequency);
      MatrixXd columns(n, own.cols() + 2 * kWaves + 1);
      columns << own, waves_of(run);
      Eigen::Map<VectorXd> e(values.data(), n);
      const VectorXd sizes = columns.householderQr().solve(e);
      e -= own * sizes.head(own.cols());
    }
  }
  return runs;
}

}  // namespace plumbline::inspect
