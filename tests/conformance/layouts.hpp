// SPDX-License-Identifier: BSD-3-Clause
// The tiny sequence of tiny_kitti.hpp in the layouts of other data sets.
#pragma once

#include <filesystem>

namespace tolman::test {

/// EuRoC: FOLDER/mav0/cam0, cam1 with sensor.yaml and data.csv, unrectified.
void writeEuroc(const std::filesystem::path& sequence, const std::filesystem::path& folder);
/// TUM RGB-D: rgb.txt, depth.txt; everything is 2 m away.
void writeTum(const std::filesystem::path& sequence, const std::filesystem::path& folder);
/// A drive of KITTI's raw data in FOLDER/drive, unrectified.
void writeKittiRaw(const std::filesystem::path& sequence, const std::filesystem::path& folder);

}  // namespace tolman::test
