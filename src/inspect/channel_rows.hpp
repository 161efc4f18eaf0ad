// Rows of the runs that are suspected, channel by channel, and what other readings in their place make of the misfit.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "inspect/hypothesis.hpp"

namespace plumbline::inspect {

/// All rows of the suspects below each other, and where each channel of each of them lies.
class Channels {
 public:
  explicit Channels(const Suspects& suspects) : suspects_(suspects) {
    const Eigen::Index columns = suspects.rows.front()->slopes.cols();
    Eigen::Index rows = 0;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns, columns);
    for (const RunRows* run : suspects.rows) {
      rows += run->rows();
      gram += run->gram;
    }
    slopes_.resize(rows, columns);
    left_.resize(rows);
    Eigen::Index at = 0;
    for (const RunRows* run : suspects.rows) {
      slopes_.middleRows(at, run->rows()) = run->slopes;
      left_.segment(at, run->rows()) = run->left;
      at += run->rows();
    }
    prediction_.emplace(suspects.known, slopes_, gram);
    off_ = prediction_->off(left_);
    chi2_ = prediction_->square(off_);
    measured_ = whitened([](std::size_t, const RunRows& of) { return of.measured; });
  }

  const Suspects& suspects() const { return suspects_; }
  double chi2() const { return chi2_; }
  const Eigen::VectorXd& measured() const { return measured_; }
  Eigen::Index rows() const { return left_.size(); }
  /// Of some channels alone.
  Eigen::Index rows_of(const std::vector<int>& channels) const {
    Eigen::Index sum = 0;
    for (const RunRows* run : suspects_.rows) {
      for (const int channel : channels) sum += run->raw.first_row(channel) ? run->raw.samples : 0;
    }
    return sum;
  }

  /// Rows of something that each run has in place of its readings.
  Eigen::VectorXd whitened(const std::function<Eigen::VectorXd(std::size_t, const RunRows&)>& readings) const {
    Eigen::VectorXd all(left_.size());
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < suspects_.rows.size(); ++i) {
      const RunRows& rows = *suspects_.rows[i];
      all.segment(at, rows.rows()) = suspects_.bench.white(rows, readings(i, rows)).col(0);
      at += rows.rows();
    }
    return all;
  }

  /// The misfit if these were the readings.
  double chi2_of(const Eigen::VectorXd& readings) const {
    const Eigen::VectorXd off = off_ + readings - measured_;
    return prediction_->square(off);
  }
  /// The same for each of many columns of readings.
  Eigen::VectorXd chi2_of_each(const Eigen::MatrixXd& readings) const {
    return prediction_->squares(readings.colwise() + (off_ - measured_));
  }
  /// The part of it that some channels have.
  double chi2_of(const Eigen::VectorXd& readings, const std::vector<int>& about) const {
    const Eigen::VectorXd off = only(off_ + readings - measured_, about);
    return prediction_->square(off);
  }
  /// What is predicted of some channels, nil elsewhere.
  Eigen::VectorXd predicted(const std::vector<int>& channels) const { return only(measured_ - off_, channels); }
  Eigen::VectorXd only(Eigen::VectorXd rows, const std::vector<int>& channels) const {
    Eigen::Index at = 0;
    for (const RunRows* run : suspects_.rows) {
      for (const int channel : run->raw.channels) {
        if (std::find(channels.begin(), channels.end(), channel) == channels.end()) {
          rows.segment(at, run->raw.samples).setZero();
        }
        at += run->raw.samples;
      }
    }
    return rows;
  }
  bool has(int channel) const {
    return std::any_of(suspects_.rows.begin(), suspects_.rows.end(),
                       [&](const RunRows* run) { return run->raw.first_row(channel).has_value(); });
  }

  /// The factor by which readings of some channels are what is predicted.
  double factor(const std::vector<int>& channels) const {
    Eigen::MatrixXd both(rows(), 2);
    both << only(measured_, channels), predicted(channels);
    const Eigen::MatrixXd products = prediction_->products(both, both);
    return products(0, 1) / products(1, 1);
  }
  /// The products of such columns with each other and with what is off.
  void products(const Eigen::MatrixXd& columns, Eigen::MatrixXd& squares, Eigen::VectorXd& with_off) const {
    squares = prediction_->products(columns, columns);
    with_off = prediction_->products(columns, off_).col(0);
  }
  /// Columns that may each be added to the readings: how much the best size of each takes of the misfit, and that size.
  struct Added {
    double gain = 0, size = 0;
  };
  std::vector<Added> added(const Eigen::MatrixXd& columns) const {
    const Eigen::MatrixXd with = prediction_->products(columns, off_);
    const Eigen::VectorXd squares = prediction_->squares(columns);
    std::vector<Added> all;
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
      const double square = squares[k];
      all.push_back({square > 0 ? with(k, 0) * with(k, 0) / square : 0, square > 0 ? with(k, 0) / square : 0});
    }
    return all;
  }

 private:
  const Suspects& suspects_;
  identify::SlopeRows slopes_;
  Eigen::VectorXd left_, off_, measured_;
  std::optional<Prediction> prediction_;
  double chi2_ = 0;
};

/// The segment of a channel in the readings of a run; empty: not measured.
template <class Readings>
auto segment(Readings& readings, const RunRows& rows, int channel) {
  return readings.segment(*rows.raw.first_row(channel), rows.raw.samples);
}

/// The readings with those of some channels multiplied.
inline Eigen::VectorXd scaled(const RunRows& rows, const std::vector<int>& channels, double by) {
  Eigen::VectorXd readings = rows.measured;
  for (const int channel : channels) {
    if (rows.raw.first_row(channel)) segment(readings, rows, channel) *= by;
  }
  return readings;
}

}  // namespace plumbline::inspect
