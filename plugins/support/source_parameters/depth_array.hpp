// SPDX-License-Identifier: BSD-3-Clause
// Depth images among the sensors of a source.
#pragma once

#include <string>
#include <utility>

#include "tolman/fields.hpp"

namespace tolman::source_parameters {

inline ArrayInfo depthArray(std::string name, std::string doc) {
  ArrayInfo info;
  info.name = std::move(name);
  info.kind = ArrayKind::DepthImage;
  info.unit = "m";
  info.doc = std::move(doc);
  info.axes.resize(2);
  info.axes[0].name = "row";
  info.axes[1].name = "column";
  return info;
}

}  // namespace tolman::source_parameters
