// Any bytes as a dataset.toml, "=====" and the table of its runs. A dataset that is taken has as many angles as times,
// every number finite, can be written and read again, and its figures can be worked out.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "fuzz/fuzz.hpp"
#include "measure/circularity.hpp"
#include "measure/dataset.hpp"

using namespace plumbline;

namespace {

void check_column(const measure::Run& run, const std::vector<double>& column, bool is_measured) {
  FUZZ_CHECK(column.size() == (is_measured ? run.samples() : 0));
  FUZZ_CHECK(std::all_of(column.begin(), column.end(), [](double x) { return std::isfinite(x); }));
}

void check_run(const measure::Run& run) {
  check_column(run, run.time, true);
  check_column(run, run.angle, true);
  check_column(run, run.radial, run.has_radial());
  for (const auto& torque : run.torque) check_column(run, torque, run.has_torque());
  FUZZ_CHECK(std::isfinite(run.radius) && run.radius > 0);
  if (!run.has_radial()) return;
  const measure::CircularityFigures figures = measure::circularity_figures(measure::profile_of(run));
  FUZZ_CHECK(std::isfinite(figures.minimum_zone) && figures.minimum_zone >= 0);
  FUZZ_CHECK(figures.minimum_zone <= figures.least_squares * (1 + 1e-6) + 1e-12);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Two input = fuzz::split(fuzz::text_of(data, size));
  fuzz::folder().file("run.csv", input.second);
  fuzz::is_taken([&] {
    const measure::Dataset dataset =
        measure::parse_dataset(std::string(input.first), fuzz::folder() / "dataset.toml", fuzz::folder().path());
    for (const measure::Run& run : dataset.runs) {
      if (run.samples() > 200) continue;
      check_run(run);
    }
    if (std::any_of(dataset.runs.begin(), dataset.runs.end(), [](const auto& run) { return run.file != "run.csv"; })) {
      return;  // the input names paths of its own: nothing is written there
    }
    const std::string again = fuzz::folder() / "again";
    std::filesystem::remove_all(again);
    measure::write_dataset(dataset, again);
    const measure::Dataset reread = measure::read_dataset(again + "/dataset.toml");
    FUZZ_CHECK(reread.runs.size() == dataset.runs.size());
    for (std::size_t i = 0; i < reread.runs.size(); ++i) {
      FUZZ_CHECK(reread.runs[i].samples() == dataset.runs[i].samples());
    }
  });
  return 0;
}
