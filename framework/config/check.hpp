// SPDX-License-Identifier: BSD-3-Clause
// One checker for all that is configured: a map of nodes against a schema.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/paths.hpp"
#include "tolman/parameters.hpp"

namespace tolman::config {

/// Whose parameters are checked.
struct Subject {
  std::string path;   ///< of the map: "odometry", "observers.0", "" for the root
  std::string owner;  ///< for messages: "plugin kitti"; empty for the host's own keys
  std::vector<std::string> also_known;  ///< keys that belong to somebody else
};

/// Complete values, defaults included. Unknown keys, wrong types, values out of range and missing
/// required ones become problems, all of them; such a parameter keeps its default.
ParameterValues check(const Node& map, const Schema& schema, const Subject& subject,
                      const Places& places, Problems& problems);

}  // namespace tolman::config
