#include "report/page/inspection_page.hpp"

#include <cmath>

#include <fmt/format.h>

#include "identify/equations/run_model.hpp"
#include "report/measured/inspection_text.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/run_sections.hpp"
#include "report/page/sections.hpp"

namespace plumbline::report {
namespace {

Json fault_table(const jobs::InspectResult& result) {
  std::vector<Json> rows;
  for (const inspect::Fault& fault : result.inspection.faults) {
    std::vector<std::string> ids;
    for (const std::size_t r : fault.runs) ids.push_back(result.runs[r].id);
    Json row{fault.all ? std::string("all") : fmt::format("{}", fmt::join(ids, ", ")),
             std::string(inspect::to_text(fault.kind))};
    const bool fitted = fault.before > 0;
    row.push_back(fitted ? Json(fault.before) : Json("-"));
    row.push_back(fitted ? Json(fault.after) : Json("-"));
    row.push_back(fitted ? Json(fault.nats) : Json("-"));
    row.push_back(fault.blocks ? "to be mended or accepted" : "noted");
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return nullptr;
  return table_section(
      "Faults", {{"Run"}, {"kind"}, {"as stated", "", 1}, {"mended", "", 1}, {"evidence", "nats", 0}, {""}},
      std::move(rows), "How far the run is off, in units of the noise, as the dataset states it and mended.");
}

Json misfit_map(const jobs::InspectResult& result) {
  HeatMap map;
  map.rows = {"Run"};
  map.columns = {"Channel"};
  map.reasons = {"not measured, or not looked at"};
  HeatFigure figure{"off, times the noise", "", 2, {{""}}};
  for (int c = 0; c < identify::kChannels; ++c) map.columns.labels.emplace_back(identify::channel_name(c));
  for (std::size_t r = 0; r < result.runs.size(); ++r) {
    const inspect::RunMisfit& misfit = result.inspection.runs[r];
    map.rows.labels.push_back(result.runs[r].id);
    for (std::size_t c = 0; c < identify::kChannels; ++c) {
      const bool there = c < misfit.channels.size() && misfit.channels[c] > 0;
      figure.planes[0].values.push_back(there ? misfit.channels[c] : std::nan(""));
      figure.planes[0].reasons.push_back(there ? -1 : 0);
    }
  }
  map.figures.push_back(std::move(figure));
  map.words = "Each run as the model with its priors, the catalogue of effects and all other runs predict it.";
  return heat_section("How far each run is off", map);
}

}  // namespace

Page inspection_page(const jobs::InspectResult& result) {
  const bool blocks = result.inspection.blocks();
  Page page{"The data",
            blocks ? "Something is wrong with the data: nothing should be learnt from them before it is mended."
                   : "Nothing is wrong with the data, as far as they tell.",
            blocks ? Verdict::bad : Verdict::good};
  std::vector<std::string> items;
  for (const inspect::Fault& fault : result.inspection.faults)
    items.push_back(sentence(fault_text(fault, result.runs)));
  if (!items.empty()) page.sections.push_back(warnings_section("What was found", items));
  add_section(page, fault_table(result));
  if (result.with_model) page.sections.push_back(misfit_map(result));
  return page;
}

}  // namespace plumbline::report
