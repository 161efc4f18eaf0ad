#include "measure/fine_waves.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include <unsupported/Eigen/FFT>

#include "base/median.hpp"

namespace plumbline::measure {
namespace {

constexpr double kHeld = 1.0 / 3;  // of the points: orders below stay as they are (EvenGrid)
constexpr double kGone = 2.0 / 3;  // orders above are gone

// What pairs of runs have in common at the orders of a band.
struct Band {
  double lowest = 0;
  double highest = 0;
  double common = 0;     // sum of Re(a conj b) over pairs and orders
  double differs = 0;    // sum of |a - b|^2 / 2: the power of noise, where a wave is alike in both,
  double opposites = 0;  // and of |a + b|^2 / 2, where it is opposite
  double terms = 0;

  double middle() const { return std::sqrt(lowest * highest); }
  /// Of so many terms |s|^2 of a wave beside noise of power n, each has by chance a variance of n |s|^2 + n^2 / 2.
  double deviation() const {
    const double noise = std::min(differs, opposites) / terms;
    return std::sqrt(terms * noise * (std::abs(common) / terms + noise / 2));
  }
};

using Spectrum = std::vector<std::complex<double>>;

// Amplitudes: a wave a cos(k phi + p) has |a| / 2 at order k.
std::vector<Spectrum> spectra_of(const Eigen::MatrixXd& readings) {
  Eigen::FFT<double> fft;
  std::vector<Spectrum> spectra;
  for (Eigen::Index r = 0; r < readings.rows(); ++r) {
    const Eigen::VectorXd row = readings.row(r).transpose();
    std::vector<double> values(row.begin(), row.end());
    Spectrum spectrum;
    fft.fwd(spectrum, values);
    for (auto& value : spectrum) value /= static_cast<double>(readings.cols());
    spectra.push_back(std::move(spectrum));
  }
  return spectra;
}

std::vector<Band> bands_of(const std::vector<Spectrum>& spectra, const std::vector<int>& circles, std::size_t orders,
                           const FineWaveOptions& options) {
  std::vector<Band> bands;
  for (double from = options.first_order; from < static_cast<double>(orders);) {
    const double to = std::max(std::floor(from * options.wider), from + options.narrowest);
    Band band{from, std::min(to, static_cast<double>(orders)) - 1};
    for (std::size_t i = 0; i < spectra.size(); ++i) {
      for (std::size_t k = i + 1; k < spectra.size(); ++k) {
        if (circles[i] != circles[k]) continue;
        for (auto order = static_cast<std::size_t>(band.lowest); order <= static_cast<std::size_t>(band.highest);
             ++order) {
          band.common += (spectra[i][order] * std::conj(spectra[k][order])).real();
          band.differs += std::norm(spectra[i][order] - spectra[k][order]) / 2;
          band.opposites += std::norm(spectra[i][order] + spectra[k][order]) / 2;
          ++band.terms;
        }
      }
    }
    bands.push_back(band);
    from = to;
  }
  return bands;
}

// What steps have at order 1, falling with the square of the order: the median over the bands of low orders.
double steps_of(const std::vector<Band>& bands, const FineWaveOptions& options) {
  std::vector<double> sizes;
  for (const Band& band : bands) {
    if (band.lowest >= options.steps_below || band.terms == 0) continue;
    sizes.push_back(std::abs(band.common) / band.terms * band.middle() * band.middle());
  }
  if (sizes.empty()) return 0;
  return median(std::move(sizes));
}

}  // namespace

std::vector<OrderRange> fine_waves(const Eigen::MatrixXd& readings, const std::vector<int>& circles, double least_rms,
                                   const FineWaveOptions& options) {
  const auto orders = static_cast<std::size_t>(readings.cols() / 2);
  const std::vector<Band> bands = bands_of(spectra_of(readings), circles, orders, options);
  const double steps = steps_of(bands, options);
  std::vector<OrderRange> found;
  for (const Band& band : bands) {
    if (band.terms == 0) continue;
    const double common = std::abs(band.common) / band.terms;
    const double width = band.highest - band.lowest + 1;
    const bool wave = common > options.over_steps * steps / (band.middle() * band.middle()) &&
                      std::abs(band.common) > options.sigmas * band.deviation() &&
                      2 * common * width > least_rms * least_rms;
    if (wave) found.push_back({band.lowest, band.highest});
  }
  return found;
}

std::size_t points_for(const std::vector<OrderRange>& waves, const std::vector<std::size_t>& points) {
  const auto all = [&](auto&& holds) { return std::all_of(waves.begin(), waves.end(), holds); };
  for (const std::size_t p : points) {
    if (all([&](const OrderRange& w) { return w.highest <= kHeld * static_cast<double>(p); })) return p;
  }
  const auto least = std::find_if(points.rbegin(), points.rend(), [&](std::size_t p) {
    const auto count = static_cast<double>(p);
    return all([&](const OrderRange& w) { return w.highest <= kHeld * count || w.lowest >= kGone * count; });
  });
  return least != points.rend() ? *least : points.front();
}

}  // namespace plumbline::measure
