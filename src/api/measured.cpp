// What is learnt from measurements, and models that are made.
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <plumbline/plumbline.hpp>

#include "api/given_options.hpp"
#include "api/guarded.hpp"
#include "api/inside.hpp"
#include "base/units.hpp"
#include "jobs/compare.hpp"
#include "jobs/diagnose.hpp"
#include "jobs/identify.hpp"
#include "jobs/measured/joined.hpp"
#include "report/measured/compare_text.hpp"
#include "report/measured/datasets_text.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/measured/identification_text.hpp"
#include "report/measured/model_file.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/thinning_text.hpp"

namespace plumbline::api {
namespace {

constexpr const char* kMendData =
    "mend what the dataset or the table says, or leave the run out; the option `accept` takes it as it is";

// Why the model that was identified is not given, or given with a warning where it is forced.
void object(Inside::Found& found, const jobs::IdentifiedModel& identified, bool force) {
  if (!identified.found.converged()) {
    found.no_model = Error(Error::Kind::refused,
                           {"identify-not-converged",
                            report::not_converged_text(identified) + ": there is no model",
                            identified.inspection.blocks()
                                ? kMendData
                                : "give fewer unknowns by `free`, or priors for them in [uncertainty]; check that the "
                                  "dataset belongs to this machine",
                            {}});
  } else if (identified.objected()) {
    const std::string objection = report::objection_text(identified);
    if (force) {
      found.warnings.push_back({"identify-not-plausible",
                                objection,
                                "do not cut with this model before compare says that it fits circles that were not "
                                "used here",
                                {},
                                Severity::warning});
      return;
    }
    found.no_model =
        Error(Error::Kind::refused,
              {"identify-not-plausible",
               objection + ": there is no model",
               identified.inspection.blocks()
                   ? kMendData
                   : "something else is missing in the model, or a channel has another unit or sign than it "
                     "says: diagnose the same data. If [uncertainty] is too narrow, widen it; the option "
                     "`force` gives the model all the same",
               {}});
  }
}

void add_warning(Inside::Found& found, const std::optional<plumbline::Diagnostic>& warning) {
  if (warning) found.warnings.push_back(public_diagnostic(*warning));
}

Result identified_result(const jobs::IdentifiedModel& identified, bool force) {
  Inside::Found found;
  found.json = report::identification_json(identified.found);
  found.words = report::identification_text(identified.found) + report::thinning_text(identified.thinning);
  add_warning(found, identified.other_model);
  object(found, identified, force);
  if (!found.no_model) found.model = report::model_file(identified);
  return Inside::result(std::move(found));
}

identify::Stages stages_of(const GivenOptions& given) {
  const std::string name = given.text("stages").value_or("joint");
  if (name != "joint" && name != "paper") wrong_usage(fmt::format("stages {}: expected joint or paper", name));
  return name == "paper" ? identify::Stages::paper : identify::Stages::joint;
}

std::uint64_t seed_of(const GivenOptions& given) {
  const double seed = given.number("seed").value_or(1);
  if (!(seed >= 0 && seed < 1e15 && seed == std::floor(seed))) wrong_usage("seed: expected a whole number from 0");
  return static_cast<std::uint64_t>(seed);
}

}  // namespace

inline namespace v1 {

Result identify(const Model& model, const std::string& dataset, const Options& options) {
  return guarded([&] {
    const GivenOptions given(options, {}, {"stages", "free", "force", "accept", "with"});
    identify::IdentifyOptions how;
    how.stages = stages_of(given);
    how.free = given.list("free");
    return identified_result(
        jobs::identify_model(Inside::machine_of(model).source, dataset, how, given.list("accept"), given.each("with")),
        given.is_on("force"));
  });
}

Result calibrate(const Model& model, const std::string& dataset, const Options& options) {
  return guarded([&] {
    const GivenOptions given(options, {},
                             {"poses", "frame-known", "geometry-alone", "free", "joint-sigma", "offset-sigma",
                              "controller", "force", "accept", "with"});
    jobs::CalibrateJob job;
    job.model = Inside::machine_of(model).source;
    job.dataset = dataset;
    job.with = given.each("with");
    job.poses = given.source("poses");
    if (job.dataset.empty() && job.poses.empty()) {
      wrong_usage("a dataset or the option `poses` is needed: circular tests, a tracker's poses, or both");
    }
    if (job.dataset.empty() && !job.with.empty())
      wrong_usage("`with` joins datasets with another one, and there is none");
    job.frame_known = given.is_on("frame-known");
    job.controller = given.is_on("controller");
    job.options.geometry.alone = given.is_on("geometry-alone");
    job.options.geometry.joint_sigma = given.positive("joint-sigma").value_or(1000) * kUm;
    job.options.geometry.offset_sigma = given.positive("offset-sigma").value_or(1000) * kUm;
    job.options.free = given.list("free");
    job.accepted = given.list("accept");
    return identified_result(jobs::calibrate_model(std::move(job)), given.is_on("force"));
  });
}

Result diagnose(const Model& model, const std::string& dataset, const Options& options) {
  return guarded([&] {
    const GivenOptions given(options, {}, {"without", "seed", "accept", "with"});
    jobs::DiagnoseJob job;
    job.model = Inside::machine_of(model).source;
    job.dataset = dataset;
    job.without = given.list("without");
    job.seed = seed_of(given);
    job.accepted = given.list("accept");
    job.with = given.each("with");
    const jobs::DiagnoseResult result = jobs::diagnose(job);
    Inside::Found found;
    found.json = report::diagnosis_json(result.diagnosis, result.measured);
    found.words = report::diagnosis_text(result.diagnosis) + report::thinning_text(result.thinning) +
                  report::renamed_text(result.measured);
    add_warning(found, result.other_model);
    found.model = report::model_file(result);
    if (!result.diagnosis.converged) {
      found.no_model = Error(Error::Kind::refused, {"diagnose-not-converged",
                                                    "the last fit did not converge: do not use the numbers found",
                                                    "look at what is odd in the readings; measure anew, or more runs",
                                                    {}});
    }
    return Inside::result(std::move(found));
  });
}

Result compare(const Model& model, const std::string& dataset, const Options& options) {
  return guarded([&] {
    const GivenOptions given(options, {}, {"max-radial-um", "with"});
    const std::optional<double> most = given.positive("max-radial-um");
    const jobs::Comparison comparison =
        jobs::compare(Inside::machine_of(model).source, jobs::read_joined(dataset, given.each("with")).dataset);
    if (most && !comparison.radial_rms_um) {
      refuse("compare-no-bar", "max-radial-um bounds readings of the bar, and no run has any",
             "leave it out, or measure radial_um", plumbline::Place{.file = dataset});
    }
    Inside::Found found;
    found.json = report::compare_json(comparison);
    found.words = report::compare_text(comparison);
    add_warning(found, comparison.other_model);
    found.found = most && *comparison.radial_rms_um > *most;
    return Inside::result(std::move(found));
  });
}

}  // namespace v1
}  // namespace plumbline::api
