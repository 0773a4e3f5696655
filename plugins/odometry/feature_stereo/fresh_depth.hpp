// SPDX-License-Identifier: BSD-3-Clause
// Depth images that are no measurement of their frame: a sensor that repeats its last image, or
// gives one value everywhere.
#pragma once

#include <string>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::feature_stereo {

class FreshDepth {
 public:
  enum class Kind { Fresh, Repeated, Constant };
  /// Of the depth image of the next frame; null: Fresh. Unmeasured values do not count, and an
  /// image without any other is Fresh.
  Kind judge(const NamedArray* depth);

 private:
  std::vector<float> last_;  ///< values of the last image that was not Constant
};

}  // namespace tolman::feature_stereo
