// Files after whole fits are in tests/jobs/identify_test.cpp.
#include "report/measured/model_file.hpp"

#include <catch2/catch.hpp>

#include "support/diagnosis.hpp"

using namespace plumbline;

TEST_CASE("after a diagnosis the notes have the headline and what could not be told apart") {
  jobs::DiagnoseResult result{
      machine::read_model(testing::source_file("models/pm600-like.toml")), testing::small_diagnosis(), {}};
  result.diagnosis.errors.assign(result.diagnosis.forces.parameters.size(), 0);
  std::string text = report::model_file(result);
  CHECK(text.find("; with what diagnose found\"") != std::string::npos);
  CHECK(text.find("# diagnosis: named: one of backlash, cyclic\n") != std::string::npos);
  CHECK(text.find("# backlash, which these data do not tell from cyclic\n") != std::string::npos);
  result.diagnosis.withheld = diagnose::GivenIsNearer{diagnose::ReadingKind::torque};
  result.diagnosis.verdict = diagnose::Verdict::unknown;
  text = report::model_file(result);
  CHECK(text.find("; as it was given to diagnose\"") != std::string::npos);
  CHECK(text.find("# the numbers are those given: the model as given is nearer to the torques held out\n") !=
        std::string::npos);
  CHECK(text.find("# the effects named generic describe what was seen; they are no cause\n") != std::string::npos);
}
