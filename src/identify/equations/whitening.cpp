#include "identify/equations/whitening.hpp"

#include <cmath>
#include <limits>

namespace plumbline::identify {
namespace {

// The Kalman filter of noise whose gains do not depend on the data: x = memory x + gain e, e = y - x of variance F,
// F = P + white,  P' = memory^2 P white / F + (1 - memory^2) (1 - white); weight = 1 / (sigma sqrt F)
struct Filter {
  Eigen::VectorXd gain, weight;
  double log_weights = 0;  // the sum of the weights' logarithms

  Filter(const ChannelNoise& noise, Eigen::Index samples) : gain(samples), weight(samples) {
    const double remembered = 1 - noise.white;
    double P = remembered;
    for (Eigen::Index i = 0; i < samples; ++i) {
      const double F = P + noise.white;
      gain[i] = noise.memory * P / F;
      weight[i] = 1 / (noise.sigma * std::sqrt(F));
      log_weights += std::log(weight[i]);
      const double next =
          noise.memory * noise.memory * P * noise.white / F + (1 - noise.memory * noise.memory) * remembered;
      if (std::abs(next - P) <= std::numeric_limits<double>::epsilon() * P) {  // no longer changes: nor does the rest
        gain.tail(samples - i).setConstant(gain[i]);
        weight.tail(samples - i).setConstant(weight[i]);
        log_weights += static_cast<double>(samples - i - 1) * std::log(weight[i]);
        return;
      }
      P = next;
    }
  }
};

template <class Rows>
void whiten_rows(const ChannelNoise& noise, Rows& rows) {
  const Filter filter(noise, rows.rows());
  Eigen::RowVectorXd remembered = Eigen::RowVectorXd::Zero(rows.cols());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    rows.row(i) -= remembered;
    remembered = noise.memory * remembered + filter.gain[i] * rows.row(i);
    rows.row(i) *= filter.weight[i];
  }
}

}  // namespace

void whiten(const ChannelNoise& noise, Eigen::Ref<SlopeRows> rows) { whiten_rows(noise, rows); }
void whiten(const ChannelNoise& noise, Eigen::Ref<Eigen::MatrixXd> rows) { whiten_rows(noise, rows); }

// Reverse order: what a row was taken off from gives back what it kept.
void whiten_back(const ChannelNoise& noise, Eigen::Ref<SlopeRows> rows) {
  const Filter filter(noise, rows.rows());
  Eigen::RowVectorXd remembered = Eigen::RowVectorXd::Zero(rows.cols());
  for (Eigen::Index i = rows.rows(); i-- > 0;) {
    rows.row(i) = filter.weight[i] * rows.row(i) + filter.gain[i] * remembered;
    remembered = noise.memory * remembered - rows.row(i);
  }
}

// One at sample i leaves weight_i there and, as gain_i is remembered, -weight_k gain_i prod (memory - gain_l) at k > i,
// l going from i + 1 to k - 1.
double whitened_unit(const ChannelNoise& noise, Eigen::Index samples) {
  const Filter filter(noise, samples);
  double sum = 0;
  double handed_on = 0;  // sum over k > i of [weight_k prod (memory - gain_l)]^2
  for (Eigen::Index i = samples; i-- > 0;) {
    const double own = filter.weight[i] * filter.weight[i];
    sum += own + filter.gain[i] * filter.gain[i] * handed_on;
    const double kept = noise.memory - filter.gain[i];
    handed_on = own + kept * kept * handed_on;
  }
  return sum / static_cast<double>(samples);
}

double log_weights(const ChannelNoise& noise, Eigen::Index samples) { return Filter(noise, samples).log_weights; }

void whiten(const NoiseModel& noise, RunEquations& equations) {
  const Eigen::Index n = equations.samples;
  for (std::size_t c = 0; c < equations.channels.size(); ++c) {
    const ChannelNoise& channel = noise.channels[static_cast<std::size_t>(equations.channels[c])];
    const Eigen::Index first = static_cast<Eigen::Index>(c) * n;
    auto residual = equations.residual.segment(first, n);
    whiten_rows(channel, residual);
    if (equations.slopes.size() > 0) {
      auto slopes = equations.slopes.middleRows(first, n);
      whiten_rows(channel, slopes);
    }
    if (first >= equations.setup_slopes.rows()) continue;
    auto setup = equations.setup_slopes.middleRows(first, n);
    whiten_rows(channel, setup);
  }
}

}  // namespace plumbline::identify
