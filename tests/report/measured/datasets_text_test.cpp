#include "report/measured/datasets_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace plumbline;

namespace {

const std::vector<jobs::MeasuredFile> kTwo{{"a/dataset.toml", 0x12, 26},
                                           {"b/dataset.toml", 0xffull << 56, 2, {}, {{"01", "01@2"}, {"02", "02@2"}}}};

}  // namespace

TEST_CASE("datasets that were joined are named with their hashes, and runs with another name") {
  const nlohmann::ordered_json json = report::datasets_json(kTwo);
  CHECK(json[0].dump() == R"({"file":"a/dataset.toml","hash":"0000000000000012","runs":26,"renamed":[]})");
  CHECK(json[1]["hash"] == "ff00000000000000");
  CHECK(json[1]["renamed"][1].dump() == R"({"id":"02","as":"02@2"})");
  CHECK(report::renamed_text(kTwo) ==
        "note: ids of b/dataset.toml that an earlier dataset has: 01 is 01@2, 02 is 02@2\n");
  CHECK(report::renamed_text({kTwo[0]}).empty());
}
