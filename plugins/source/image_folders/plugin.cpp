// SPDX-License-Identifier: BSD-3-Clause
// Registration of the sources that read image files.
#include "tolman/plugin.hpp"

#include "layouts.hpp"

using namespace tolman::image_folders;

TOLMAN_PLUGIN(kitti, LayoutSource<KittiParameters>, "0.1.0",
              "A sequence in the layout of the KITTI odometry benchmark, stereo or one camera.");
TOLMAN_PLUGIN(images, LayoutSource<ImagesParameters>, "0.1.0",
              "One or two folders of numbered PNG or JPEG images, with or without calibration.");
TOLMAN_PLUGIN(
    euroc, LayoutSource<EurocParameters>, "0.1.0",
    "A sequence in the layout of EuRoC MAV or TUM-VI, unrectified, stereo or one camera.");
TOLMAN_PLUGIN(kitti_raw, LayoutSource<KittiRawParameters>, "0.1.0",
              "A drive of KITTI's raw data, before or after rectification.");
TOLMAN_PLUGIN(tum, LayoutSource<TumParameters>, "0.1.0",
              "A sequence in the layout of TUM RGB-D: colour images with depth.");
