#include "machine/model_file.hpp"

#include <catch2/catch.hpp>

#include "machine/bad_files.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

TEST_CASE("a model is read in SI, with the places of its values") {
  const MachineModel model = pm600_like();
  CHECK(model.name == "pm600-like");
  CHECK(to_text(model.rotation) == "ZYX");
  CHECK(model.gravity.z() == -9.80665);
  CHECK((model.geometry.base_joints_W.col(1) - Vector3<double>(0.99780725, -0.06618683, 0.04144)).norm() < 1e-15);
  CHECK(model.geometry.platform_joints_P(2, 5) == Approx(0.15253));
  CHECK(model.limits.tilt == Approx(25 * kDeg));
  CHECK(model.limits.travel[2].lower == Approx(-1.25));
  CHECK(model.limits.length_max[5] == Approx(1.9));
  CHECK(std::isinf(model.limits.condition_max));
  CHECK(model.control.digits_deg == 5);
  CHECK(model.value("strut", "compliance_per_length_um_N_m").values[0] == Approx(1.287e-8));
  const ModelValue& friction = model.value("strut", "coulomb_friction_N");
  CHECK(friction.values == std::vector<double>{110, 130, 160, 130, 160, 160});
  const auto cut = [&](TextSpan span) { return model.document.text.substr(span.offset, span.length); };
  CHECK(cut(friction.span) == "[110, 130, 160, 130, 160, 160]");
  CHECK(cut(friction.spans[2]) == "160");
  CHECK(cut(model.value("platform", "mass_kg").span) == "100");
  CHECK(model.value("strut", "screw_mass_kg").values.size() == 6);
  CHECK_FALSE(model.value("joint", "coulomb_friction_Nm").given());
  CHECK(model.uncertainty("joint_position_um").value() == Approx(8e-6));
  CHECK_FALSE(model.uncertainty("platform_mass_kg").has_value());
  CHECK(model.effects.empty());
  CHECK_THROWS(model.value("strut", "no_such_key"));
}

TEST_CASE("effect rows are kept as they stand, with their places") {
  const std::string text = pm600_like().document.text +
                           "\n[[effect]]\nname = \"backlash\"\nwidth_um = [4, 0, 0, 0, 0, 0]\n"
                           "[[effect]]\nname = \"x\"\nq = [[1, 2], [3, 4], [5, 6]]\nk = 7\n";
  const MachineModel model = parse_model(text, "m.toml");
  REQUIRE(model.effects.size() == 2);
  CHECK(model.effects[0].name == "backlash");
  CHECK(model.effects[0].values[0].values == std::vector<double>{4, 0, 0, 0, 0, 0});
  CHECK(model.effects[0].values[0].shape == std::vector<std::size_t>{6});
  CHECK(model.effects[1].values[0].shape == std::vector<std::size_t>{3, 2});
  CHECK(model.effects[1].values[0].values == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(model.effects[1].values[1].shape.empty());
  CHECK(model.effects[1].values[1].place.column == 5);
  CHECK(model.hash != pm600_like().hash);
}

TEST_CASE("models that make no sense are refused where they stand") {
  check_bad_files(source_path("tests/machine/bad"), 40, [](const std::string& path) { read_model(path); });
}
