#include "report/measured/thinning_text.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("long records that were made short are told, others are not") {
  CHECK(report::thinning_text({26, 0, 0, 700}).empty());
  CHECK(report::thinning_text({26, 3, 360, 50000}) ==
        "3 of 26 runs have up to 50000 samples: each channel was low-passed and brought to 360 points of a turn, and "
        "the noise stated is that of these points\n");
  CHECK(report::thinning_text({1, 1, 360, 50000}).starts_with("1 of 1 run has up to 50000 samples: "));
}
