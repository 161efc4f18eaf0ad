#include "settings/contradiction.hpp"

#include <initializer_list>
#include <utility>

#include <catch2/catch.hpp>

using namespace plumbline;
using settings::Options;

namespace {

Options tolerance() {
  Options options;
  settings::set_option(options, *settings::find_option("tolerance"), "0.5um");
  return options;
}

}  // namespace

TEST_CASE("a tolerance takes the place of the steps") {
  Options options = tolerance();
  CHECK_FALSE(settings::contradiction(options));
  settings::set_option(options, *settings::find_option("yields"), "time");
  CHECK_FALSE(settings::contradiction(options));
  for (const auto& [name, text] : std::initializer_list<std::pair<const char*, const char*>>{
           {"step-angle", "0.1"}, {"step-length", "1"}, {"friction-turn", "0.5"}, {"first-order", "on"}}) {
    INFO(name);
    const settings::OptionRow& row = *settings::find_option(name);
    CHECK(settings::excludes(row, *settings::find_option("tolerance")));
    CHECK(settings::excludes(*settings::find_option("yields"), row));
    Options both = options;
    settings::set_option(both, row, text);
    CHECK(settings::contradiction(both));
    Options alone;
    settings::set_option(alone, row, text);
    CHECK_FALSE(settings::contradiction(alone));
  }
  CHECK_FALSE(settings::excludes(*settings::find_option("yields"), *settings::find_option("tolerance")));
}
