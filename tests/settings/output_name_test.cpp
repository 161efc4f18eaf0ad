#include "settings/output_name.hpp"

#include <catch2/catch.hpp>

#include "settings/options.hpp"

using plumbline::settings::check_output_pattern;
using plumbline::settings::OptionError;
using plumbline::settings::output_name;

TEST_CASE("an output takes folder, name and ending from its program") {
  const std::string pattern(plumbline::settings::kOutputPattern);
  CHECK(output_name(pattern, "part.ngc", "") == "part_straight.ngc");
  CHECK(output_name(pattern, "jobs/a/part.v2.MPF", "") == "jobs/a/part.v2_straight.MPF");
  CHECK(output_name(pattern, "/jobs/O1000", "") == "/jobs/O1000_straight");
  CHECK(output_name("/out/{name}{ext}", "jobs/part.ngc", "") == "/out/part.ngc");
  CHECK(output_name("{folder}/../{machine}/{name}.ngc", "jobs/part.nc", "hex-3") == "hex-3/part.ngc");
}

TEST_CASE("a pattern that holds a machine needs one") {
  CHECK_THROWS_AS(output_name("{name}_{machine}", "part.ngc", ""), OptionError);
}

TEST_CASE("a pattern without the name, or with other names, is none") {
  CHECK_NOTHROW(check_output_pattern("{folder}/{name}{ext}"));
  for (const char* const pattern : {"", "out.ngc", "{folder}/out{ext}", "{nam}", "{nam", "{name}{", "{name}{}",
                                    "{folder}/{name", "{name}}{ext}", "}{name}"}) {
    INFO(pattern);
    CHECK_THROWS_AS(check_output_pattern(pattern), OptionError);
  }
}
