#include "jobs/pose_table.hpp"

#include <algorithm>

#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/text/number_table.hpp"

namespace plumbline::jobs {

std::vector<PoseRow> read_poses(const Source& source) {
  static const std::vector<NumberColumn> columns{{"x_mm", "mm"},   {"y_mm", "mm"},   {"z_mm", "mm"},
                                                 {"a_deg", "deg"}, {"b_deg", "deg"}, {"c_deg", "deg"}};
  const NumberTable table =
      read_number_table(source.name(), read_text(source), columns, "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg");
  if (table.rows.empty()) {
    refuse("csv-no-rows", "the table has no rows", "write a pose a line below the names of the columns", table.header);
  }
  std::vector<PoseRow> rows;
  for (const NumberTable::Row& row : table.rows) {
    PoseRow pose{{}, row.place};
    std::copy(row.values.begin(), row.values.end(), pose.pose.values.begin());
    rows.push_back(std::move(pose));
  }
  return rows;
}

}  // namespace plumbline::jobs
