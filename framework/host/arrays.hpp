// SPDX-License-Identifier: BSD-3-Clause
// Whether named arrays and their descriptions can be recorded and shown.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "tolman/fields.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Checks number, names, shapes and values of the arrays of one frame.
Status checkArrays(const std::vector<NamedArray>& arrays);

/// Checks names, texts and numbers of descriptions.
Status checkDescriptions(std::span<const ArrayInfo> arrays);

/// Checks that names and shapes of the arrays of a plugin stay the same over a run. Call only one
/// of the two functions.
class ArrayShapes {
 public:
  /// checkArrays(), and requires the names and shapes of the first call.
  Status check(const std::vector<NamedArray>& arrays);
  /// checkArrays(), and requires that an array keeps its shape, except for the length of the first
  /// axis. Arrays may be missing, because a sensor need not measure at each frame.
  Status checkShapes(const std::vector<NamedArray>& arrays);

 private:
  std::map<std::string, std::vector<int>, std::less<>> known_;  // empty: not known yet
};

}  // namespace tolman::host
