#include "nc/control/parameters/parameters.hpp"

#include <catch2/catch.hpp>

using namespace plumbline::nc;

TEST_CASE("numbered parameters are unset until somebody sets them") {
  Parameters parameters;
  CHECK_FALSE(parameters.has(31));
  parameters.set(31, {2.5, true});
  CHECK(parameters.has(31));
  CHECK(parameters.get(31).number == 2.5);
  parameters.set(kLastParameter, {1, false});
  CHECK_FALSE(parameters.get(kLastParameter).known);
}

TEST_CASE("names do not depend on case and blanks") {
  Parameters parameters;
  CHECK(parameters.find("depth") == nullptr);
  parameters.set("Depth Of Cut", {3, true});
  REQUIRE(parameters.find("depthofcut") != nullptr);
  parameters.set("DEPTHOFCUT", {4, true});
  CHECK(parameters.find("d e p t h o f c u t")->number == 4);
}

TEST_CASE("names that begin with _ are seen everywhere, but where the control keeps names apart") {
  for (const bool apart : {false, true}) {
    Parameters parameters;
    if (apart) parameters.keep_names_apart();
    parameters.set("_depth", {5, true});
    parameters.enter(LocalNumbers::callers);
    CHECK((parameters.find("_depth") == nullptr) == apart);
    parameters.set("_depth", {7, true});
    parameters.leave();
    CHECK(parameters.find("_depth")->number == (apart ? 5 : 7));
  }
}
