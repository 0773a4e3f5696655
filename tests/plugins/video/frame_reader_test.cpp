// SPDX-License-Identifier: BSD-3-Clause
// Any order gives the same pictures, within the memory limit.
#include "frame_reader.hpp"

#include <catch2/catch.hpp>

namespace tolman::video {
namespace {

/// Twenty pictures of one pixel that is their number.
class Counting final : public Capture {
 public:
  explicit Counting(int& converted) : converted_(converted) {}
  PictureSize size() const override { return {1, 1}; }
  std::string description() const override { return "numbers"; }
  Status next(bool wanted, Picture& picture) override {
    if (number_ == 20) return Status::endOfStream();
    picture = {};
    picture.stamp_ns = number_ * 10;
    picture.timed = true;
    if (wanted) {
      ++converted_;
      picture.image =
          Image::create(1, 1, PixelFormat::Gray8, [this](std::uint8_t* data) { *data = number_; });
    }
    ++number_;
    return Status::ok();
  }
  std::string defectOfEnd() const override { return "cut"; }

 private:
  int& converted_;
  std::uint8_t number_ = 0;
};

struct Opened {
  int times = 0;
  int converted = 0;
  OpenCapture open = [this]() -> Result<std::unique_ptr<Capture>> {
    ++times;
    return std::unique_ptr<Capture>(std::make_unique<Counting>(converted));
  };
};

}  // namespace

TEST_CASE("forward decodes once, backward in blocks") {
  Opened opened;
  FrameReader reader(opened.open, 4 * 3);  // four pictures
  Picture picture;
  for (const int index : {0, 3, 4, 19}) {
    REQUIRE(reader.read(index, picture).isOk());
    CHECK(picture.image.data()[0] == index);
    CHECK(picture.stamp_ns == index * 10);
  }
  CHECK(opened.times == 1);
  CHECK(opened.converted == 4);
  for (int index = 18; index >= 0; --index) {
    REQUIRE(reader.read(index, picture).isOk());
    CHECK(picture.image.data()[0] == index);
  }
  CHECK(opened.times == 1 + 5);  // 18 ... 15, 14 ... 11, 10 ... 7, 6 ... 3, 2 ... 0
  CHECK(opened.converted == 4 + 19);
}

TEST_CASE("times without pixels, and what is wrong with the end") {
  Opened opened;
  FrameReader reader(opened.open);
  std::vector<Picture> pictures;
  std::string end;
  REQUIRE(reader.readTimes(pictures, end).isOk());
  CHECK(pictures.size() == 20);
  CHECK(pictures[7].stamp_ns == 70);
  CHECK(opened.converted == 0);
  CHECK(end == "cut");
  Picture picture;
  CHECK(reader.read(20, picture).message().find("shorter") != std::string::npos);
}

}  // namespace tolman::video
