// SPDX-License-Identifier: BSD-3-Clause
#include "record/views.hpp"

#include <fmt/format.h>

namespace tolman::record {
namespace {

/// SQL for columns x, y (m) and heading (rad) of the pose `pose`, as in toPlanar().
std::string planar(const std::string& pose) {
  return fmt::format(
      R"("{0}_z" AS x, -"{0}_x" AS y, atan2(-2 * ("{0}_qx" * "{0}_qz" + "{0}_qw" * "{0}_qy"), )"
      R"(1 - 2 * ("{0}_qx" * "{0}_qx" + "{0}_qy" * "{0}_qy")) AS heading)",
      pose);
}

}  // namespace

std::vector<SqlView> views() {
  return {
      {"path",
       "`frame`, `stamp_ns`, `x` (forward, m), `y` (left, m), `heading` (rad) of the finished map",
       "SELECT frame, stamp_ns, " + planar("T_world_camera") +
           " FROM final_pose JOIN frame USING (frame)"},
      {"true_path", "the same of the true poses",
       "SELECT frame, stamp_ns, " + planar("T_world_camera_truth") + " FROM frame WHERE has_truth"},
      {"map_link",
       "`id`, `from_experience`, `to_experience`, `kind`, `frame`, `x`, `y`, `heading`, "
       "`duration`, "
       "`weight`, `rejected`",
       R"(SELECT id, "from" AS from_experience, "to" AS to_experience, kind, frame, )" +
           planar("T_from_to") + ", duration, weight, rejected FROM link"},
      {"array_data", "`frame`, `source`, `name`, `shape`, `data` (`values` of `array`)",
       R"(SELECT frame, source, name, shape, "values" AS data FROM "array")"},
  };
}

std::string createSql(const SqlView& view) {
  return "CREATE VIEW " + view.name + " AS " + view.select;
}

}  // namespace tolman::record
