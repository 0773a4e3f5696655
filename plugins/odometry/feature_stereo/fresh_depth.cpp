// SPDX-License-Identifier: BSD-3-Clause
#include "fresh_depth.hpp"

#include <algorithm>

namespace tolman::feature_stereo {
namespace {

/// Whether there are measured values, and all are equal.
bool isConstant(const std::vector<float>& values) {
  const auto isMeasured = [](float value) { return value > 0; };
  const auto first = std::ranges::find_if(values, isMeasured);
  return first != values.end() && std::all_of(first, values.end(), [&](float value) {
           return !isMeasured(value) || value == *first;
         });
}

}  // namespace

FreshDepth::Kind FreshDepth::judge(const NamedArray* depth) {
  if (depth == nullptr) return Kind::Fresh;
  if (isConstant(depth->values)) return Kind::Constant;
  const bool is_measured = std::ranges::any_of(depth->values, [](float v) { return v > 0; });
  if (is_measured && depth->values == last_) return Kind::Repeated;
  last_ = depth->values;
  return Kind::Fresh;
}

}  // namespace tolman::feature_stereo
