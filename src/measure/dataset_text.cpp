#include "measure/dataset_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::measure {
namespace {

std::string three_text(const Vector3<double>& v, double unit) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v[0] / unit, v[1] / unit, v[2] / unit);
}

std::string row_text(const Run& run) {
  std::string text = fmt::format("\n[[run]]\nid = \"{}\"\nfile = \"{}\"\ncentre_mm = {}\nradius_mm = {:.6g}\n", run.id,
                                 run.file, three_text(run.centre_W, kMm), run.radius / kMm);
  if (run.bar) text += fmt::format("bar_mm = {:.6g}\n", *run.bar / kMm);
  text += fmt::format("tilt_deg = {}\ndirection = \"{}\"\nfeed_mm_min = {:.6g}\nstart_s = {:.6g}\n",
                      three_text(run.tilt, kDeg), to_text(run.direction), run.feed / kMmPerMin, run.start);
  if (run.payload_mass > 0) text += fmt::format("payload_kg = {:.6g}\n", run.payload_mass);
  if (!run.planned.empty()) text += fmt::format("planned = \"{}\"\n", run.planned);
  return text;
}

}  // namespace

std::string dataset_text(const Dataset& dataset) {
  std::string text = fmt::format("plumbline = \"dataset 1\"\nmachine = \"{}\"\n", dataset.machine);
  for (const Run& run : dataset.runs) text += row_text(run);
  return text;
}

std::string without_plan(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
    if (!line.starts_with("planned = ")) kept += line;
    text.remove_prefix(line.size());
  }
  return kept;
}

}  // namespace plumbline::measure
