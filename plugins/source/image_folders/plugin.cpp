// SPDX-License-Identifier: BSD-3-Clause
// Registration of the sources that read image files.
#include "tolman/plugin.hpp"

#include "euroc_source.hpp"
#include "images_source.hpp"
#include "kitti_raw_source.hpp"
#include "kitti_source.hpp"
#include "tum_source.hpp"

TOLMAN_PLUGIN(kitti, tolman::image_folders::KittiSource, "0.1.0",
              "A sequence in the layout of the KITTI odometry benchmark, stereo or one camera.");
TOLMAN_PLUGIN(images, tolman::image_folders::ImagesSource, "0.1.0",
              "One or two folders of numbered PNG or JPEG images, with or without calibration.");
TOLMAN_PLUGIN(
    euroc, tolman::image_folders::EurocSource, "0.1.0",
    "A sequence in the layout of EuRoC MAV or TUM-VI, unrectified, stereo or one camera.");
TOLMAN_PLUGIN(kitti_raw, tolman::image_folders::KittiRawSource, "0.1.0",
              "A drive of KITTI's raw data, before or after rectification.");
TOLMAN_PLUGIN(tum, tolman::image_folders::TumSource, "0.1.0",
              "A sequence in the layout of TUM RGB-D: colour images with depth.");
