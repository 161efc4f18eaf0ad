#include "report/measured/thinning_text.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("long records that were averaged are told, others are not") {
  CHECK(report::thinning_text({26, 0, 1, 700}).empty());
  CHECK(report::thinning_text({26, 3, 138, 50000}) ==
        "3 of 26 runs have up to 50000 samples: means of up to 138 consecutive ones were used, and the noise stated is "
        "that of these means\n");
  CHECK(report::thinning_text({1, 1, 138, 50000}).starts_with("1 of 1 run has up to 50000 samples: "));
}
