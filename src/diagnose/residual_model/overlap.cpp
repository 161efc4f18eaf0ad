#include "diagnose/residual_model/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnose/evidence/linear_problem.hpp"

namespace plumbline::diagnose {
namespace {

using identify::SlopeRows;

constexpr double kTellsLittle = 0.002;  // as against the channel that tells most, in units of the noise

// Whether a channel (row) tells anything of a part (column).
Eigen::MatrixX<bool> telling(const ReadyRun& run, const Eigen::MatrixXd& slopes, const identify::NoiseModel& noise) {
  const Eigen::Index n = run.raw->samples;
  Eigen::MatrixXd size(run.raw->channels.size(), slopes.cols());
  for (Eigen::Index c = 0; c < size.rows(); ++c) {
    const int channel = run.raw->channels[static_cast<std::size_t>(c)];
    size.row(c) =
        slopes.middleRows(c * n, n).colwise().norm() / noise.channels[static_cast<std::size_t>(channel)].sigma;
  }
  return (size.array() > kTellsLittle * size.colwise().maxCoeff().replicate(size.rows(), 1).array()).matrix();
}

}  // namespace

bool only_alike(const Shape& shape) { return is_per_strut(shape.channel) && shape.coordinates.size() > 1; }

SlopeRows in_groups(const SlopeRows& rows, Eigen::Index samples, int points) {
  const Eigen::Index together = std::max<Eigen::Index>(1, samples / points);
  const Eigen::Index groups = (samples + together - 1) / together;
  const Eigen::Index channels = rows.rows() / samples;
  SlopeRows sums(channels * groups, rows.cols());
  for (Eigen::Index c = 0; c < channels; ++c) {
    for (Eigen::Index g = 0; g < groups; ++g) {
      const Eigen::Index size = std::min(together, samples - g * together);
      sums.row(c * groups + g) =
          rows.middleRows(c * samples + g * together, size).colwise().sum() / std::sqrt(static_cast<double>(size));
    }
  }
  return sums;
}

Overlap overlap_in_groups(const Shape& shape, const Region& region, const ReadyRun& run,
                          const physics::MachineConstants& machine, const identify::NoiseModel& noise,
                          const SlopeRows& others, int points) {
  const Eigen::Index n = run.raw->samples;
  const Eigen::Index count = shape.functions();
  const bool alike = only_alike(shape);
  const Eigen::MatrixXd slopes = slopes_of(run, shape.channel);
  const Eigen::MatrixX<bool> tells = telling(run, slopes, noise);
  const std::vector<SlopeRows> values = values_of(shape, region, run, machine);
  const Eigen::Index all = alike ? count : count * shape.parts();
  Overlap overlap{Eigen::MatrixXd::Zero(all, all), Eigen::MatrixXd::Zero(others.cols(), all)};
  const Eigen::Index groups = others.rows() / tells.rows();
  for (Eigen::Index c = 0; c < tells.rows(); ++c) {
    std::vector<Eigen::Index> places;  // of the columns that are not zero
    SlopeRows columns = SlopeRows::Zero(n, alike ? count : count * tells.row(c).count());
    Eigen::Index first = 0;
    for (int part = 0; part < shape.parts(); ++part) {
      if (!tells(c, part)) continue;
      columns.middleCols(first, count) +=
          slopes.col(part).segment(c * n, n).asDiagonal() * values[static_cast<std::size_t>(part)];
      if (alike) continue;
      for (Eigen::Index k = 0; k < count; ++k) places.push_back(part * count + k);
      first += count;
    }
    if (alike && tells.row(c).any()) {
      for (Eigen::Index k = 0; k < count; ++k) places.push_back(k);
    }
    if (places.empty()) continue;
    take_setup_out(*run.raw, static_cast<std::size_t>(c), noise, columns);
    const SlopeRows few = in_groups(columns, n, points);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(few.cols(), few.cols());
    gram.selfadjointView<Eigen::Lower>().rankUpdate(few.transpose());
    overlap.gram(places, places) += Eigen::MatrixXd(gram.selfadjointView<Eigen::Lower>());
    overlap.cross(Eigen::all, places) += others.middleRows(c * groups, groups).transpose() * few;
  }
  return overlap;
}

}  // namespace plumbline::diagnose
