// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "camera_rigs.hpp"

namespace tolman::ros_messages {
namespace {

std::string chosen(const std::vector<std::string>& cameras, const CameraNames& named = {},
                   bool mono = false) {
  const auto names = chooseCameraNames(cameras, named, mono);
  return names ? names->left + " " + names->right : std::string("choose ") + chooseBy(named);
}

}  // namespace

TEST_CASE("names of pairs") {
  CHECK(isPair("/stereo/left/image_raw", "/stereo/right/image_raw"));
  CHECK(isPair("/cam0/image", "/cam1/image"));
  CHECK(isPair("/infra1/image", "/infra2/image"));
  CHECK_FALSE(isPair("/right/image", "/left/image"));
  CHECK_FALSE(isPair("/cam1/image0", "/cam0/image1"));
  CHECK_FALSE(isPair("/cam0/image", "/cam2/image"));
  CHECK_FALSE(isPair("/a/image", "/b/image"));
  CHECK_FALSE(isPair("/left", "/left"));
}

TEST_CASE("the only camera, the only pair, and what is named") {
  CHECK(chosen({"/a"}) == "/a ");
  CHECK(chosen({"/cam0", "/cam1", "/rear"}) == "/cam0 /cam1");
  CHECK(chosen({"/cam0", "/cam1", "/rear"}, {}, true) == "/cam0 ");
  CHECK(chosen({"/cam0", "/cam1", "/rear"}, {"/rear", ""}) == "/rear ");
  CHECK(chosen({"/cam0", "/cam1", "/cam2"}, {"", "/cam2"}) == "/cam1 /cam2");
  CHECK(chosen({"/cam0", "/cam1"}, {"/cam1", "/cam0"}) == "/cam1 /cam0");
  CHECK(chosen({"/cam0", "/cam1"}, {"/cam1", ""}, true) == "/cam1 ");
}

TEST_CASE("where there is a choice, the parameter to set") {
  CHECK(chosen({"/front", "/rear"}) == "choose left");
  CHECK(chosen({"/cam0", "/cam1", "/cam2"}) == "choose left");
  CHECK(chosen({"/front", "/rear"}, {"", "/rear"}) == "choose left");
  CHECK(chosen({"/left/left", "/right/left", "/left/right"}, {"/left/left", ""}) == "choose right");
}

TEST_CASE("the CameraInfo beside images") {
  CHECK(infoBeside("/left/image_raw") == "/left/camera_info");
  CHECK(infoBeside("/left/image_raw/compressed") == "/left/camera_info");
}

}  // namespace tolman::ros_messages
