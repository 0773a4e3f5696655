// SPDX-License-Identifier: BSD-3-Clause
// Checks configured values against the declaration of their parameters. The host's own keys and the
// parameters of plugins are checked by the same function.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/paths.hpp"
#include "tolman/parameters.hpp"

namespace tolman::config {

/// Which parameters are checked.
struct Subject {
  std::string path;   ///< of the map: "odometry", "observers.0", "" at the top
  std::string owner;  ///< for messages: "plugin kitti"; empty for the host's own keys
  std::vector<std::string> also_known;  ///< legal keys that are checked elsewhere
};

/// Values of all parameters, defaults included. Unknown keys, wrong types, values out of range and
/// missing required values are all reported; such a parameter keeps its default. An unknown key
/// that occurs in the doc of a parameter as "Formerly `key`." is reported as renamed.
ParameterValues check(const Node& map, const Schema& schema, const Subject& subject,
                      const BaseFolders& folders, Problems& problems);

}  // namespace tolman::config
