// SPDX-License-Identifier: BSD-3-Clause
// --set of the commands that take one source without a configuration: parameters of the source, and
// the host's keys for its images.
#pragma once

#include <string>
#include <vector>

#include "config/problem.hpp"
#include "config/settings.hpp"

namespace tolman::app {

struct SourceOverrides {
  std::vector<std::string> source;  ///< "first=3"
  std::vector<std::string> host;    ///< "images.scale=0.5", "rectification.mode=off"
};

/// Throws CLI::ValidationError for --set a=1 --set a=2: neither is certainly meant.
void refuseTwoValues(const std::vector<std::string>& overrides);

/// Refuses two values of one key.
SourceOverrides splitOverrides(const std::vector<std::string>& overrides);

/// How the host processes the images of the source.
struct ImageHandling {
  config::RectificationSettings rectification;
  config::ImageSettings images;
};

/// Checked as those of a configuration file are.
ImageHandling imageHandling(const std::vector<std::string>& host_overrides,
                            config::Problems& problems);

}  // namespace tolman::app
