// SPDX-License-Identifier: BSD-3-Clause
// The experience map as a g2o file, for other back ends and viewers, and its connected parts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::record {

/// The connected components of an experience graph. A map has several when no loop joins a session
/// with the earlier ones, or when tracking restarted at an unknown pose. The relative pose of two
/// components is unknown.
struct GraphParts {
  std::vector<std::int64_t> of_experience;  ///< component of each experience; the first one is 0
  std::int64_t count = 0;
};

/// The components that all links form that the map has not rejected.
GraphParts partsOf(const MapGraph& graph);

/// The information matrix of an EDGE_SE3:QUAT: g2o's error is (translation, vector part of the
/// quaternion), and that vector is half the rotation vector. Variances below 1e-10 (10 um, 10 urad)
/// are raised to it, so that a covariance of zero has an inverse. Scaled by the link's weight.
Matrix6d g2oInformation(const Link& link);

/// The map as VERTEX_SE3:QUAT, FIX 0, and EDGE_SE3:QUAT with the 21 values of the upper triangle.
/// Links that the map has rejected are left out.
std::string g2oText(const MapGraph& graph);

}  // namespace tolman::record
