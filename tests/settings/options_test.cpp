#include "settings/options.hpp"

#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/language/dialect.hpp"
#include "settings/program_settings.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using settings::OptionError;
using settings::Options;

namespace {

Options with(std::string_view name, std::string_view text) {
  Options options;
  settings::set_option(options, *settings::find_option(name), text);
  return options;
}

}  // namespace

TEST_CASE("a work offset is a system and exactly six numbers") {
  const Options options = with("work-offset", "G59.1=1,2.5,-3e1, 4 ,5,-6");
  REQUIRE(options.program.work_offsets[6]);
  CHECK(options.program.work_offsets[6]->origin == AxisWords{{1, 2.5, -30, 4, 5, -6}});
  CHECK(with("work-offset", "g54=0,0,0,0,0,0").program.work_offsets[0]);
  for (const char* const wrong :
       {"", "G54", "G54=", "G54=1,2,3,4,5", "G54=1,2,3,4,5,6,7", "G53=0,0,0,0,0,0", "G54=0,0,0,0,0,nan",
        "G54=0,0,0,0,0,x", "G54=0,,0,0,0,0", "G60=0,0,0,0,0,0", "=0,0,0,0,0,0", "G54=1;2;3;4;5;6"}) {
    INFO(wrong);
    CHECK_THROWS_AS(with("work-offset", wrong), OptionError);
  }
  for (const char* const wrong : {"G15H0=0,0,0,0,0,0", "G15 H201=0,0,0,0,0,0", "h999=0,0,0,0,0,0"}) {
    CHECK_THROWS_WITH(with("work-offset", wrong), Catch::Contains("an Okuma OSP has G15H1 to G15H200"));
  }
}

TEST_CASE("a start is six numbers or those of some axes") {
  CHECK(with("start", "1,2,3,4,5,6").program.start[5] == 6);
  const Options some = with("start", "A=0,b-1.5,C0");
  CHECK_FALSE(some.program.start[0]);
  CHECK(some.program.start[3] == 0);
  CHECK(some.program.start[4] == -1.5);
  CHECK(some.program.start[5] == 0);
  for (const char* const wrong : {"1,2,3", "Q=1", "A=", "A", "A=1,,", "A=x"}) {
    INFO(wrong);
    CHECK_THROWS_AS(with("start", wrong), OptionError);
  }
}

TEST_CASE("M codes, switches and numbers are checked") {
  CHECK(with("pass", "M428, m429").program.passed_m_codes == std::set{428, 429});
  CHECK_THROWS_AS(with("pass", "428"), OptionError);
  CHECK_THROWS_AS(with("pass", "M1.5"), OptionError);
  CHECK(with("block-delete", "on").program.block_delete == true);
  CHECK_THROWS_AS(with("block-delete", "yes"), OptionError);
  CHECK(with("unit", "inch").program.inches == true);
  CHECK(with("unit", "mm").program.inches == false);
  CHECK_THROWS_WITH(with("unit", "cm"), "expected mm or inch");
  CHECK(with("tolerance", "0.5um").compensation.bound.tolerance_mm == Approx(0.0005));
  CHECK(with("tolerance", "0.002 mm").compensation.bound.tolerance_mm == Approx(0.002));
  for (const char* const text : {"0.5", "0um", "-1um", "20mm", "0.5 um/m", "um", "0,5um"}) {
    INFO(text);
    CHECK_THROWS_AS(with("tolerance", text), OptionError);
  }
  CHECK(with("yields", "time").compensation.bound.yields == compensate::BoundSettings::Yields::time);
  CHECK_THROWS_AS(with("yields", "both"), OptionError);
  CHECK(with("step-angle", "0.5").compensation.step.angle_deg == 0.5);
  CHECK_THROWS_AS(with("step-angle", "0"), OptionError);
  CHECK_THROWS_AS(with("step-length", "1,5"), OptionError);
  CHECK_THROWS_AS(with("tool-in-spindle", "1.5"), OptionError);
  CHECK_THROWS_AS(with("tool-in-spindle", "-1"), OptionError);
  CHECK_FALSE(with("no-friction", "on").compensation.friction);
  CHECK(with("friction-turn", "0.002").compensation.sign_width_of_feed == 0.002);
  CHECK_THROWS_AS(with("friction-turn", "1.5"), OptionError);
  CHECK(with("first-order", "on").compensation.method == compensate::Method::first_order);
  CHECK(with("touch-off", "0,0,-1008,0,0,0").compensation.touch_off->values[2] == -1008);
}

TEST_CASE("repeated options add up, and none says another thing for the same") {
  Options options;
  const auto set = [&](std::string_view name, std::string_view text) {
    settings::set_option(options, *settings::find_option(name), text);
  };
  set("pass", "M100");
  set("pass", "M101");
  set("work-offset", "G54=1,0,0,0,0,0");
  set("work-offset", "G55=2,0,0,0,0,0");
  set("work-offset", "g54=1,0,0,0,0,0.0");  // the same once more
  for (const auto& [name, text] :
       std::vector<std::pair<const char*, const char*>>{{"work-offset", "G54=3,0,0,0,0,0"},
                                                        {"work-offset", "g 55=2,0,0,0,0,1e-3"},
                                                        {"start", "A=0,A=1"},
                                                        {"start", "x1,X2"},
                                                        {"rotary", "C=sign,C=shortest"}}) {
    INFO(text);
    Options copy = options;
    CHECK_THROWS_WITH(settings::set_option(copy, *settings::find_option(name), text), Catch::Contains("given twice"));
  }
  set("rotary", "C=shortest");
  set("rotary", "sign");
  set("rotary", "c=shortest");
  CHECK_THROWS_AS(set("rotary", "C=sign"), OptionError);
  CHECK_THROWS_AS(set("rotary", "one-turn"), OptionError);
  using nc::RotaryRule;
  CHECK(options.program.rotary == nc::RotaryRules{RotaryRule::sign, RotaryRule::sign, RotaryRule::shortest});
  CHECK(options.program.passed_m_codes == std::set{100, 101});
  CHECK(options.program.work_offsets[0]->origin[Axis::X] == 1);
  CHECK(options.program.work_offsets[1]->origin[Axis::X] == 2);
}

TEST_CASE("every option says what it is") {
  for (const settings::OptionRow& row : settings::option_rows()) {
    INFO(row.name);
    CHECK(settings::find_option(row.name) == &row);
    CHECK_FALSE(row.help.empty());
  }
  CHECK(settings::find_option("nonsense") == nullptr);
}

TEST_CASE("work offsets of a variables file count as given, and options say no other ones") {
  const testing::Scratch scratch;
  Options options = with("work-offset", "G56=1,7,0,0,0,0");
  options.paths.variables = scratch.file("v.var",
                                         "5221 1\n5222 2\n5223 3\n5224 0\n5225 0\n5226 0\n5230 10\n"
                                         "5241 1\n5242 2\n5243 3\n5244 4\n5245 5\n5246 6\n5250 30\n5261 1\n");
  const nc::ProgramSettings settings = settings::program_settings(options);
  CHECK(settings.work_offsets[0]->origin[Axis::X] == 1);
  CHECK(settings.work_offsets[0]->rotation_deg == 10);
  CHECK(settings.work_offsets[1]->origin == AxisWords{{1, 2, 3, 4, 5, 6}});
  CHECK(settings.work_offsets[1]->rotation_deg == 30);
  CHECK(settings.work_offsets[2]->origin == AxisWords{{1, 7, 0, 0, 0, 0}});
  CHECK_FALSE(settings.work_offsets[3]);
  for (const char* const other : {"G54=1,2,3,0,0,0", "G55=1,2,3,4,5,6.1", "G56=1.001,7,0,0,0,0", "G54=7,2,3,0,0,0"}) {
    INFO(other);
    Options both = with("work-offset", other);
    both.paths.variables = options.paths.variables;
    CHECK(testing::refusal_of([&] { settings::program_settings(both); }).code == "variables-offset");
  }
}

TEST_CASE("a rule of rotary words holds for all axes or for those that are named") {
  using nc::RotaryRule;
  CHECK(with("rotary", "sign").program.rotary == nc::RotaryRules{RotaryRule::sign, RotaryRule::sign, RotaryRule::sign});
  CHECK(with("rotary", "b=one-turn, C = shortest").program.rotary ==
        nc::RotaryRules{RotaryRule::linear, RotaryRule::one_turn, RotaryRule::shortest});
  for (const char* const wrong : {"", "wrapped", "X=sign", "=sign", "A=", "A=sign;B=sign"}) {
    INFO(wrong);
    CHECK_THROWS_AS(with("rotary", wrong), OptionError);
  }
}

TEST_CASE("help names the dialects that there are") {
  const std::string help = settings::help_of(*settings::find_option("dialect"));
  for (const std::string_view name : nc::dialect_names()) CHECK(help.find(name) != std::string::npos);
  for (const settings::OptionRow& row : settings::option_rows()) {
    INFO(row.name);
    CHECK(settings::help_of(row).find("{dialect") == std::string::npos);
  }
}
