// The table of many poses is in tests/jobs/error_table_test.cpp.
#include "report/program/error_text.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("a pose and its error are a row in the units of its columns") {
  const testing::Scratch scratch;
  OutputFile out(scratch.path("error.csv"));
  report::ErrorTable table(out);
  jobs::PoseError error;
  error.pose = {{60, -10.5, -1008, 10, -5, 0}};
  error.lengths.setConstant(1.25);
  error.nut_tension.setConstant(-100);
  error.stretch.setConstant(2e-6);
  error.error << 1e-6, -2e-6, 3e-6, 4e-6, 0, 0;
  table.add(error);
  out.commit();
  const std::string text = scratch.text("error.csv");
  const std::string row = text.substr(text.find('\n') + 1);
  CHECK(text.starts_with("x_mm,y_mm,"));
  CHECK(row.starts_with("60.000,-10.500,-1008.000,10.000,-5.000,0.000,1250.000000000,"));
  CHECK(row.ends_with(",2.00000000,1.00000000,-2.00000000,3.00000000,4.00000000,0.00000000,0.00000000\n"));
}

TEST_CASE("a table of errors is told by its poses and the largest error") {
  CHECK(report::error_text({1, 0, {}, 41.2034, {}}) == "1 pose, the tip up to 41.203 um off\n");
  CHECK(report::error_text({3, 2, {}, 41.2034, {}}) == "3 poses (2 beyond the limits), the tip up to 41.203 um off\n");
}
