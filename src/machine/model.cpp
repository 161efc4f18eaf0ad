#include "machine/model.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace plumbline::machine {

const ModelValue& MachineModel::value(std::string_view table, std::string_view key) const {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const ModelValue& v) { return v.table == table && v.key == key; });
  PLUMBLINE_CHECK(found != values.end());
  return *found;
}

std::optional<double> MachineModel::uncertainty(std::string_view key) const {
  const ModelValue& sigma = value("uncertainty", key);
  return sigma.given() ? std::optional(sigma.values.front()) : std::nullopt;
}

Pose<double> home_pose(const MachineModel& model) {
  Pose<double> home;
  for (int a = 0; a < 3; ++a) {
    const Range& range = model.limits.travel[static_cast<std::size_t>(a)];
    home.p_WT[a] = 0.5 * (range.lower + range.upper);
  }
  return home;
}

}  // namespace plumbline::machine
