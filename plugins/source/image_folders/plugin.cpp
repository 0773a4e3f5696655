// SPDX-License-Identifier: BSD-3-Clause
// Registration of the two sources that read image files.
#include "tolman/plugin.hpp"

#include "images_source.hpp"
#include "kitti_source.hpp"

TOLMAN_PLUGIN(kitti, tolman::image_folders::KittiSource, "0.1.0",
              "A sequence in the layout of the KITTI odometry benchmark, stereo or one camera.");
TOLMAN_PLUGIN(images, tolman::image_folders::ImagesSource, "0.1.0",
              "One or two folders of numbered PNG or JPEG images, with or without calibration.");
