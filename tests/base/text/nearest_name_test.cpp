#include "base/text/nearest_name.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("the nearest name is offered, but nothing far away") {
  const std::vector<std::string_view> names{"screw_mass_kg", "motor_mass_kg", "lead_mm"};
  CHECK(nearest_name("screw_mas_kg", names) == "screw_mass_kg");
  CHECK(nearest_name("lead", names).empty());
  CHECK(nearest_name("laed_mm", names) == "lead_mm");
  CHECK(nearest_name("something_else", names).empty());
  CHECK(suggestion("laed_mm", names).find("`lead_mm`") != std::string::npos);
  CHECK(did_you_mean("laed_mm", names) == "did you mean lead_mm? ");
  CHECK(did_you_mean("q", names).empty());
  CHECK(suggestion("q", names).find("motor_mass_kg") != std::string::npos);
}
