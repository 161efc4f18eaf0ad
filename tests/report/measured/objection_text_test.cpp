#include "report/measured/objection_text.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using diagnose::ReadingKind;
using identify::Objection;

namespace {

physics::ForceModel forces() {
  return physics::ForceModel(machine::read_model(testing::source_file("models/pm600-like.toml")));
}

// Two tilts of the base, known to 0.15 mrad.
identify::Stage small_stage() {
  identify::Unknowns unknowns(forces());
  for (const int axis : {0, 1}) unknowns.set_prior(unknowns.add("level", "tilt_mrad", axis), 0.15e-3);
  return {"joint", identify::Fit(std::move(unknowns)), {}, {}, {}, false, {}, {}};
}

identify::Unknown width() {
  identify::Unknown unknown;
  unknown.label = "backlash width_um strut 1";
  unknown.unit = machine::units::um;
  unknown.sigma = 2e-6;
  unknown.upper = 200e-6;
  return unknown;
}

}  // namespace

TEST_CASE("priors that are refuted are named with how far, five of them at most") {
  identify::Stage stage = small_stage();
  CHECK(report::objection_text(stage).empty());
  stage.objection = Objection::strained;
  stage.plausible.strained = {{0, 8}, {1, -7}};
  const std::string x = stage.fit.unknowns[0].label + " is 1.2 mrad off, 8.0 times what [uncertainty] says of it";
  CHECK(report::objection_text(stage) ==
        x + "; " + stage.fit.unknowns[1].label + " is -1.05 mrad off, 7.0 times what [uncertainty] says of it");
  stage.plausible.strained.assign(7, {0, 8});
  const std::string seven = report::objection_text(stage);
  CHECK(seven.starts_with(x + "; " + x));
  CHECK(seven.ends_with("; and 2 more"));
}

TEST_CASE("priors that are refuted together, and circles predicted worse, are said with their numbers") {
  identify::Stage stage = small_stage();
  stage.plausible.chi2 = 90;
  stage.plausible.degrees = 40;
  stage.plausible.radial = {3e-6, 7.25e-6, 0, 120};
  stage.plausible.torque = {0.05, 0.125, 0, 120};
  stage.objection = Objection::all_strained;
  CHECK(report::objection_text(stage).find("chi-square is 90 where 40 is expected") != std::string::npos);
  stage.objection = Objection::radial_worse;
  CHECK(report::objection_text(stage) ==
        "a fit to the other circles leaves 7.25 um of the bar's readings on those that it did not see, and the model "
        "as given 3");
  stage.objection = Objection::torque_worse;
  CHECK(report::objection_text(stage).find("leaves 0.125 N m of the torques") != std::string::npos);
}

TEST_CASE("an identified model is objected to for its stage first, then for a gap that stays open") {
  const machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  jobs::IdentifiedModel model{machine, {{}, forces(), {}, {}}, {}, {}, {}, forces(), {}, {}};
  CHECK_FALSE(model.objected());
  CHECK(report::objection_text(model).empty());
  model.open_gap = diagnose::OpenGap{{ReadingKind::radial, 10e-6, 6e-6}};
  CHECK(model.objected());
  CHECK(report::objection_text(model) == "the gap of the bar's readings stays open, 6 um of 10, and is no noise");
  model.found.stages.push_back(small_stage());
  model.found.stages[0].objection = Objection::strained;
  model.found.stages[0].plausible.strained = {{0, 8}};
  CHECK(report::objection_text(model).find("8.0 times what [uncertainty] says of it") != std::string::npos);
}

TEST_CASE("a model that its own errors call less sure than the one as given is objected to") {
  const machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  jobs::IdentifiedModel model{machine, {{}, forces(), {}, {}}, {}, {}, {}, forces(), {}, {}};
  model.less_sure = identify::LessSure{20e-6, 28.3e-3};
  CHECK(model.objected());
  const std::string off = "by its own errors the tip would be 2.83e+04 um off where the model as given states 20 um";
  CHECK(report::objection_text(model).starts_with(off));
  CHECK(report::objection_text(diagnose::Objection{*model.less_sure}).starts_with(off));
}

TEST_CASE("what is wrong with the data is said before what the fit says against itself") {
  const machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  jobs::IdentifiedModel model{machine, {{}, forces(), {}, {}}, {}, {}, {}, forces(), {}, {}};
  CHECK(report::not_converged_text(model) == "the fit did not converge");
  model.runs.resize(2);
  model.runs[0].id = "a";
  model.runs[1].id = "b";
  model.inspection.faults.push_back({inspect::FaultKind::direction, {1}});
  const std::string direction =
      "something is wrong with the data: run b: its angles go ccw, and the dataset says otherwise";
  CHECK(report::objection_text(model) == direction);
  CHECK(report::not_converged_text(model) == direction + "; and the fit did not converge");
  model.open_gap = diagnose::OpenGap{{ReadingKind::radial, 10e-6, 6e-6}};
  CHECK(report::objection_text(model).starts_with(direction + "; and of the fit: the gap of the bar's readings"));
  model.found.stages.push_back(small_stage());
  model.found.stages[0].objection = Objection::all_strained;
  CHECK(report::objection_text(model).starts_with(direction + "; and of the fit: all that [uncertainty] lists"));
  model.inspection.faults[0].blocks = false;  // accepted
  CHECK(report::objection_text(model).starts_with("all that [uncertainty] lists"));
}

TEST_CASE("what speaks against a diagnosis is said with its numbers and what to check") {
  using diagnose::ChannelFlaw;
  CHECK(report::objection_text(ChannelFlaw{ChannelFlaw::Kind::sign, {0, 3}, {-1, -1}}) ==
        "2 of 6 torques (torque1_Nm, torque4_Nm) have the sign opposite to the model's in all runs: no effect does "
        "that; check the "
        "sign of each channel (positive where the strut is pulled)");
  CHECK(report::objection_text(ChannelFlaw{ChannelFlaw::Kind::unit, {2}, {6.25}})
            .starts_with("1 of 6 torques (torque3_Nm) is 6.25 times the model's: no effect does that; check the unit"));
  CHECK(report::objection_text(std::vector<diagnose::StrainedUnknown>{{width(), 8}, {width(), -7}}) ==
        "backlash width_um strut 1 is 16 um off, 8 times what [uncertainty] says of it\n"
        "backlash width_um strut 1 is -14 um off, 7 times what [uncertainty] says of it");
  CHECK(report::objection_text(diagnose::StrainedTogether{6.7}).find("by 7 of its standard") != std::string::npos);
  CHECK(report::objection_text(diagnose::MovedFar{0.042}).starts_with("it would move the tip by 42 mm"));
  CHECK(report::objection_text(diagnose::GivenIsNearer{ReadingKind::radial}) ==
        "the model as given is nearer to the bar's readings held out");
  CHECK(report::objection_text(diagnose::OpenGap{{ReadingKind::torque, 0.25, 0.125}}) ==
        "the gap of the torques stays open, 0.125 N m of 0.25, and is no noise: check unit and sign of each torque");
}

TEST_CASE("a doubt names the effects that it is about") {
  const std::vector<std::string> both{"backlash", "level"};
  const auto text = [&](auto why) { return report::doubt_text({both, why}); };
  CHECK(
      text(diagnose::AtBound{"backlash", width()}) ==
      "backlash would stand at its bound of 200 um, as far as it can be at all: check units and signs of the channels, "
      "and what the dataset says of its runs");
  CHECK(text(diagnose::AtBound{"torque-scale", width()}).ends_with("check unit and sign of each torque"));
  CHECK(text(diagnose::FurtherOff{{ReadingKind::radial, 2e-6, 3e-6}}) ==
        "with backlash and level the bar's readings of the runs held out would be further off, 3 um for 2");
  CHECK(text(diagnose::OpenGap{{ReadingKind::radial, 10e-6, 6e-6}}) ==
        "with backlash and level the gap of the bar's readings stays open, 6 um of 10, and is no noise");
  CHECK(text(diagnose::OneMore{}) == "backlash and level are not enough: one more effect would pass the threshold");
  CHECK(report::doubt_text({{"level"}, diagnose::OneMore{}}) ==
        "level is not enough: one more effect would pass the threshold");
  CHECK_THAT(report::doubt_text({{"contact-compliance"}, diagnose::Suspected{"contact-compliance"}}),
             Catch::StartsWith("contact-compliance explains the readings, and is a suspect only: "));
  CHECK_THAT(text(diagnose::Suspected{"level"}),
             Catch::StartsWith("backlash and level explain the readings, of which level is a suspect only: "));
  CHECK(text(diagnose::LargeRemainder{12.4}) == "backlash and level would leave too much: 12 times the noise in all");
  CHECK(text(diagnose::NotPredicted{ReadingKind::radial, 2.04}) ==
        "backlash and level would explain the runs fitted, but the readings of the bar of the runs held out are 2.0 "
        "times as far off");
  CHECK(text(diagnose::BarGain{1.5, 40}) ==
        "backlash and level would explain the readings, but a bar that reads 1.5 times what it should in all runs "
        "explains more: check its scale, and whether radii are diameters");
}

TEST_CASE("what the catalogue does not explain is a line for each part") {
  diagnose::Recurs recurs;
  recurs.radial = diagnose::Recurring{6, 0.75, diagnose::Difference::direction};
  recurs.torque = diagnose::Recurring{8, -0.5, diagnose::Difference::feed};
  CHECK(report::remainder_text({10, recurs}) ==
        "what is left of the readings of the bar is no noise: in runs at one pose that differ by direction alone it is "
        "alike, with a correlation of 0.75\n"
        "what is left of the torques is no noise: in runs at one pose that differ by feed alone it is opposite, with a "
        "correlation of -0.50");
  CHECK(report::remainder_text({8, std::vector<diagnose::StrainedUnknown>{{width(), 8}}}) ==
        "backlash width_um strut 1 is 16 um off, 8 times what [uncertainty] says of it");
  diagnose::Term term;
  term.part = 1;
  term.cosine = 3.2e-6;
  CHECK(report::remainder_text({8, std::vector<diagnose::Term>{term}}) == "length_j: [0, 3.2, 0, 0, 0, 0] um");
}
