#include "identify/equations/whitening.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::identify;

TEST_CASE("whitening turns the covariance of the noise into the unit matrix") {
  const ChannelNoise noise{2.5, 0.7};
  constexpr int n = 6;
  Eigen::MatrixXd V(n, n);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) V(i, k) = noise.sigma * noise.sigma * std::pow(noise.memory, std::abs(i - k));
  }
  Eigen::MatrixXd W = Eigen::MatrixXd::Identity(n, n);
  whiten(noise, W);
  CHECK((W * V * W.transpose()).isApprox(Eigen::MatrixXd::Identity(n, n), 1e-12));
}

TEST_CASE("whitening with a white part turns the covariance into the unit matrix, too, whatever the storage") {
  const ChannelNoise noise{2.5, 0.7, 0, 0.3};
  constexpr int n = 7;
  Eigen::MatrixXd V(n, n);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      V(i, k) = 6.25 * (0.7 * std::pow(noise.memory, std::abs(i - k)) + (i == k ? 0.3 : 0));
    }
  }
  Eigen::MatrixXd W = Eigen::MatrixXd::Identity(n, n);
  whiten(noise, W);
  CHECK((W * V * W.transpose()).isApprox(Eigen::MatrixXd::Identity(n, n), 1e-12));
  SlopeRows rows = SlopeRows::Identity(n, n);
  whiten(noise, rows);
  CHECK(rows.isApprox(W, 1e-14));
}

TEST_CASE("whitening back is the transposed of whitening, and a unit's length that of its columns") {
  constexpr int n = 9;
  for (const ChannelNoise& noise : {ChannelNoise{2.5, 0.7}, ChannelNoise{0.3, 0.9, 0, 0.4}, ChannelNoise{1.5}}) {
    SlopeRows W = SlopeRows::Identity(n, n);
    whiten(noise, W);
    SlopeRows back = SlopeRows::Identity(n, n);
    whiten_back(noise, back);
    CHECK(back.isApprox(W.transpose(), 1e-14));
    CHECK(whitened_unit(noise, n) == Approx(W.squaredNorm() / n));
    CHECK(2 * log_weights(noise, n) == Approx(std::log((W.transpose() * W).determinant())));
  }
}
