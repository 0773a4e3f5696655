// SPDX-License-Identifier: BSD-3-Clause
// Registration of the source of videos and cameras.
#include "tolman/plugin.hpp"

#include "video_source.hpp"

TOLMAN_PLUGIN(video, tolman::video::VideoSource, "0.1.0",
              "A video file, a pipe that a program writes a video into, or a camera.");
