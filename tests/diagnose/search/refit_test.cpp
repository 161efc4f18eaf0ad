#include "diagnose/search/refit.hpp"

#include <catch2/catch.hpp>

#include "diagnose/hidden.hpp"
#include "diagnose/usual_noise.hpp"

namespace plumbline::diagnose {
namespace {

Refit fit(const testing::Hidden& hidden, const std::vector<Pick>& picks) {
  return refit(hidden.bench(), picks, hidden.candidates.unknowns.start(), testing::usual_noise());
}

}  // namespace

TEST_CASE("the number of a picked effect is found, with its error, and the misfit drops") {
  const testing::Hidden hidden("backlash", "width_um", 2, 6e-6);
  const int width = hidden.candidates.unknowns.find("backlash", "width_um", 2);
  const Refit without = fit(hidden, {});
  const Refit with = fit(hidden, {hidden.pick("backlash", width)});
  CHECK(with.converged);
  CHECK(with.misfit < 0.5 * without.misfit);
  CHECK(std::abs(with.values[width] - 6e-6) < 0.5e-6);
  const double error = with.errors[static_cast<std::size_t>(width)];
  CHECK((error > 0 && error < 1e-6));
  CHECK(with.sizes.size() == 1);
}

TEST_CASE("a number stays within its bounds, whatever the readings ask for") {
  const testing::Hidden hidden("platform-mass", "mass_kg", -1, -20);
  const int mass = hidden.candidates.unknowns.find("payload", "mass_kg");
  const Refit bounded = fit(hidden, {hidden.pick("payload", mass)});
  CHECK(bounded.values[mass] == Approx(0).margin(1e-6));
  const int lighter = hidden.candidates.unknowns.find("platform-mass", "mass_kg");
  CHECK(fit(hidden, {hidden.pick("platform-mass", lighter)}).values[lighter] == Approx(-20).margin(1));
}

}  // namespace plumbline::diagnose
