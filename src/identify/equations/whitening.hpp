// Equations turned so that the noise in them is independent and of variance one.
#pragma once

#include "identify/equations/noise.hpp"

namespace plumbline::identify {

/// Rows of one channel of one run, in order, turned so that the noise in them is independent and of variance one:
/// y_0 / sigma, (y_i - memory y_(i-1)) / (sigma sqrt(1 - memory^2)) without a white part; else the innovations of the
/// Kalman filter for a  [Durbin and Koopman 2012, 4.3].
void whiten(const ChannelNoise& noise, Eigen::Ref<SlopeRows> rows);
void whiten(const ChannelNoise& noise, Eigen::Ref<Eigen::MatrixXd> rows);

/// The transposed of it: with whiten(x) = W x, rows become W^T rows.
void whiten_back(const ChannelNoise& noise, Eigen::Ref<SlopeRows> rows);

/// The mean over a channel's samples of |W u|^2, u one at that sample alone.
double whitened_unit(const ChannelNoise& noise, Eigen::Index samples);

/// The sum of the logarithms of what whitening weighs the samples of a channel with: half the logarithm of det W^T W.
double log_weights(const ChannelNoise& noise, Eigen::Index samples);

/// All equations of a run whitened, channel by channel.
void whiten(const NoiseModel& noise, RunEquations& equations);

}  // namespace plumbline::identify
