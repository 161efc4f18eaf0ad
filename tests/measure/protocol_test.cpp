#include "measure/protocol.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

TomlDocument document(const std::string& text) { return parse_toml("plumbline = \"dataset 1\"\n" + text, "d.toml"); }

}  // namespace

TEST_CASE("what is said of a measurement as a whole") {
  const measure::Protocol protocol = measure::read_protocol(
      document("[protocol]\nserial = \"7\"\ninstrument = \"bar 3\"\noperator = \"me\"\ndate = 2026-11-24\n"));
  CHECK(protocol.rows() ==
        std::vector<std::pair<std::string, std::string>>{
            {"serial number", "7"}, {"instrument", "bar 3"}, {"measured by", "me"}, {"date", "2026-11-24"}});
  CHECK(measure::read_protocol(document("")).rows().empty());
}

TEST_CASE("what instruments state of their noise") {
  const measure::Instrument instrument =
      measure::read_instrument(document("[instrument]\nbar_sigma_um = 0.4\ntorque_sigma_Nm = 0.06\n"));
  CHECK(*instrument.bar_sigma / kUm == Approx(0.4));
  CHECK(*instrument.torque_sigma == Approx(0.06));
  CHECK_FALSE(measure::read_instrument(document("")).bar_sigma);
}

TEST_CASE("flaws of both tables are refused at their places") {
  const auto refused = [](const std::string& text) {
    return refusal_of([&] {
      const TomlDocument of = document(text);
      measure::read_protocol(of);
      measure::read_instrument(of);
    });
  };
  CHECK(refused("[protocol]\nserail = \"7\"\n").code == "dataset-unknown-key");
  CHECK(refused("[protocol]\nserail = \"7\"\n").place.line == 3);
  CHECK(refused("[protocol]\nserial = 7\n").code == "dataset-wrong-type");
  CHECK(refused("protocol = 7\n").code == "dataset-wrong-type");
  CHECK(refused("[instrument]\nbar_sigma_um = -1\n").code == "dataset-out-of-range");
  CHECK(refused("[instrument]\nbar_sigma_um = \"1\"\n").code == "dataset-wrong-type");
  CHECK(refused("[instrument]\nsigma = 1\n").code == "dataset-unknown-key");
}
