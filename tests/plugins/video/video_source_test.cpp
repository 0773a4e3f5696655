// SPDX-License-Identifier: BSD-3-Clause
// Selection of frames, stereo pairs in one picture, calibration, contradictions.
#include "video_source.hpp"

#include <catch2/catch.hpp>

#include "support/data.hpp"
#include "tolman/image_cv.hpp"
#include "video_encoder.hpp"
#include "video_maker.hpp"

namespace tolman::video {
namespace {

struct Clip {
  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "video.mkv";
  Clip() { writeFlatVideo(file, 12); }
};

}  // namespace

TEST_CASE("first, last and step, read forward") {
  const Clip clip;
  const Played all(clip.file);
  CHECK(all.frames.size() == 12);
  const Played some(
      clip.file,
      {{"first", std::int64_t{2}}, {"last", std::int64_t{9}}, {"step", std::int64_t{3}}});
  CHECK(some.message.empty());
  CHECK(some.numbers() == std::vector<int>{2, 5, 8});
  CHECK(some.frames[1].source_index == 5);
  CHECK(some.frames[1].frame == 1);
  CHECK(some.stamps() == std::vector<std::int64_t>{200'000'000, 500'000'000, 800'000'000});
}

TEST_CASE("a frame number beyond the end is refused at the end") {
  const Clip clip;
  const Played late(clip.file, {{"last", std::int64_t{12}}});
  CHECK(late.frames.size() == 12);
  CHECK(late.message ==
        "video.mkv has 12 pictures; choose first and last below that, or -1 for the end");
  CHECK(Played(clip.file, {{"first", std::int64_t{30}}}).frames.empty());
}

TEST_CASE("reset begins anew") {
  const Clip clip;
  Played played(clip.file);
  REQUIRE(played.source.reset().isOk());
  Frame frame;
  REQUIRE(played.source.next(frame).isOk());
  CHECK(frame.frame == 0);
  CHECK(numberOf(frame.left) == 0);
}

TEST_CASE("a rate replaces the times of the file") {
  const Clip clip;
  const Played played(clip.file, {{"rate", 30.0}, {"last", std::int64_t{3}}});
  CHECK(played.stamps() == std::vector<std::int64_t>{0, 33'333'333, 66'666'667, 100'000'000});
}

TEST_CASE("a stereo pair in one picture") {
  const test::TemporaryFolder folder;
  cv::Mat both(48, 128, CV_8UC1);
  both.colRange(0, 64).setTo(10 + 4 * 3);
  both.colRange(64, 128).setTo(10 + 4 * 20);
  writeVideo(folder.path() / "pair.mkv", "FFV1", 10, {both, both});
  const ParameterValues pair = {{"layout", std::string("side_by_side")},
                                {"pinhole", std::vector<double>{50, 50, 31.5, 20}},
                                {"baseline", 0.12}};
  const Played played(folder.path() / "pair.mkv", pair);
  CHECK(played.message.empty());
  const CameraRig& rig = played.info.rig;
  CHECK(rig.width == 64);
  CHECK(rig.height == 48);
  CHECK(rig.isStereo());
  CHECK(rig.pinhole.cx == 31.5);
  CHECK(rig.pinhole.cy == 20);
  REQUIRE(played.frames.size() == 2);
  CHECK(numberOf(played.frames[1].left) == 3);
  CHECK(numberOf(played.frames[1].right) == 20);
  ParameterValues uncalibrated = pair;
  uncalibrated["baseline"] = 0.0;
  CHECK(Played(folder.path() / "pair.mkv", uncalibrated).message ==
        "two cameras need a calibration; give pinhole and baseline");
}

TEST_CASE("contradictions are refused before the first frame") {
  const Clip clip;
  CHECK(Played(clip.file, {{"baseline", 0.1}}).message ==
        "baseline is given with layout: mono; set the layout");
  CHECK(Played(clip.file, {{"order", std::string("backward")}}).message ==
        "video.mkv: a video is read forward only; remove order, or make a folder of images of it");
  CHECK(Played(clip.file, {{"width", std::int64_t{640}}}).message ==
        "width and height are those of a camera; remove them");
  CHECK(
      Played(clip.file, {{"pinhole", std::vector<double>{100, 100, 64, 20}}}).message ==
      "the principal point of pinhole is outside of the image of 64x48 px; give the calibration of "
      "this "
      "camera");
  CHECK(Played("/dev/null").message.find("is no camera") != std::string::npos);
}

TEST_CASE("halves of a picture are views of its pixels") {
  const Image grey = Image::create(6, 4, PixelFormat::Gray8, [](std::uint8_t* data) {
    for (int i = 0; i < 24; ++i) data[i] = static_cast<std::uint8_t>(i);
  });
  const Image left = leftImage(grey, PictureLayout::SideBySide);
  const Image right = rightImage(grey, PictureLayout::SideBySide);
  CHECK(left.width() == 3);
  CHECK(left.data() == grey.data());
  CHECK(right.row(0)[0] == 3);
  CHECK(right.row(3)[2] == 23);
  const Image lower = rightImage(grey, PictureLayout::TopBottom);
  CHECK(lower.height() == 2);
  CHECK(lower.row(0)[0] == 12);
  CHECK(leftImage(grey, PictureLayout::Mono).data() == grey.data());
  CHECK(rightImage(grey, PictureLayout::Mono).empty());
  CHECK(rightImage({}, PictureLayout::SideBySide).empty());
  CHECK(cameraSize({7, 4}, PictureLayout::TopBottom).value() == PictureSize{7, 2});
  CHECK(cameraSize({7, 4}, PictureLayout::SideBySide).status().message() ==
        "pictures of 7x4 px are not two equal halves side by side; correct layout");
}

}  // namespace tolman::video
