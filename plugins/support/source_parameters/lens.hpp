// SPDX-License-Identifier: BSD-3-Clause
// The distortion of a lens by the name of its model and its coefficients, as calibration files,
// messages and drivers give them.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::source_parameters {

/// Sets model and distortion of `camera`. Coefficients that are all 0 are a lens without distortion
/// in every model but a fisheye's, and zeros beyond those that a model has are none: drivers fill
/// up to 8 or 14. The message of a failure completes the sentence "FILE ...".
inline Status setLens(std::string_view name, std::span<const double> coefficients,
                      RawCamera& camera) {
  const auto isOneOf = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool is_fisheye =
      isOneOf({"equidistant", "equi", "fisheye", "kannala_brandt", "kannala_brandt4"});
  const bool is_radial =
      isOneOf({"radtan", "radial-tangential", "plumb_bob", "rational_polynomial"});
  std::size_t count = coefficients.size();
  while (count > 0 && coefficients[count - 1] == 0) --count;
  camera.distortion.setZero();
  camera.model = LensModel::Pinhole;
  if (is_fisheye ? coefficients.empty() : count == 0) return Status::ok();
  if (!is_fisheye && !is_radial) {
    return Status::unsupported("has the distortion model '" + std::string(name.substr(0, 40)) +
                               "', which is not known; calibrate with radtan (plumb_bob), "
                               "rational_polynomial or equidistant");
  }
  const std::size_t given = coefficients.size();
  const bool fits = is_fisheye ? given >= 4 && count <= 4
                               : (given == 4 || given == 5 || given >= 8) && count <= 8;
  if (!fits) {
    return Status::unsupported("has " + std::to_string(given) + " coefficients of the model '" +
                               std::string(name) + "'; known are " +
                               (is_fisheye ? "4" : "4, 5 or 8"));
  }
  camera.model = is_fisheye ? LensModel::Equidistant : LensModel::RadialTangential;
  std::copy_n(coefficients.begin(), count, camera.distortion.data());
  return Status::ok();
}

}  // namespace tolman::source_parameters
