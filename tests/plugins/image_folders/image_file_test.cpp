// SPDX-License-Identifier: BSD-3-Clause
// Image files with all kinds of damage. The undamaged ones are compared with cv::imread.
#include "image_file.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "data_folder.hpp"
#include "tolman/context.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::image_folders {
namespace {

constexpr ImageSize kSize = {64, 48};

std::string failure(const DataFolder& data, const std::string& name) {
  return data.anonymous(readImageFile(data.path(name), false, kSize).status().message());
}

bool isSame(const Image& image, const cv::Mat& expected) {
  return cv::norm(asMat(image), expected, cv::NORM_INF) == 0;
}

}  // namespace

TEST_CASE("sound images come as OpenCV reads them") {
  const DataFolder data;
  const cv::Mat colour = [] {
    cv::Mat pixels(48, 64, CV_8UC3);
    cv::RNG(3).fill(pixels, cv::RNG::UNIFORM, 0, 256);
    return pixels;
  }();
  for (const char* name : {"a.png", "a.jpg"}) {
    CAPTURE(name);
    const std::string file = data.path(name).string();
    cv::imwrite(file, colour);
    const Result<Image> grey = readImageFile(file, false, kSize);
    REQUIRE(grey.isOk());
    CHECK(grey.value().format() == PixelFormat::Gray8);
    CHECK(isSame(grey.value(), cv::imread(file, cv::IMREAD_GRAYSCALE)));
    const Result<Image> coloured = readImageFile(file, true, kSize);
    REQUIRE(coloured.isOk());
    CHECK(coloured.value().format() == PixelFormat::Bgr8);
    CHECK(isSame(coloured.value(), cv::imread(file, cv::IMREAD_COLOR)));
  }
  SECTION("16 bits become 8") {
    cv::imwrite(data.path("deep.png").string(), cv::Mat(48, 64, CV_16UC1, cv::Scalar(0x8000)));
    const Result<Image> image = readImageFile(data.path("deep.png"), false, kSize);
    REQUIRE(image.isOk());
    CHECK(image.value().row(0)[0] == 0x80);
  }
  SECTION("of 16 bits that use only 12 the upper 8 are taken") {
    cv::imwrite(data.path("deep.png").string(), cv::Mat(48, 64, CV_16UC1, cv::Scalar(0x0abc)));
    CHECK(readImageFile(data.path("deep.png"), false, kSize, 12).value().row(0)[0] == 0xab);
    CHECK(readImageFile(data.path("deep.png"), false, kSize, 10).value().row(0)[0] == 255);
    CHECK(readImageFile(data.path("deep.png"), false, kSize).value().row(0)[0] == 0x0a);
    CHECK(readDepthFile(data.path("deep.png"), kSize).value()[7] == 0x0abc);
    data.writeImage("flat.png", 64, 48);
    CHECK_THAT(readDepthFile(data.path("flat.png"), kSize).status().message(),
               Catch::Contains("is no depth image"));
  }
  SECTION("padding after the end of a JPEG is harmless") {
    data.write("a.jpg", data.read("a.jpg") + std::string(16, '\0'));
    CHECK(failure(data, "a.jpg").empty());
  }
}

TEST_CASE("damaged images name the file, the damage and the remedy") {
  const DataFolder data;
  const std::string remedy = "; copy or record it again, or leave it out by on_corrupt: skip";
  data.writeImage("a.png", 64, 48);
  data.writeImage("a.jpg", 64, 48);
  SECTION("missing or empty") {
    CHECK(failure(data, "no.png") == "DATA/no.png: is missing or no file" + remedy);
    CHECK(failure(data, "image_0") == "DATA/image_0: is missing or no file" + remedy);
    data.write("a.png", "");
    CHECK(failure(data, "a.png") == "DATA/a.png: is empty" + remedy);
  }
  SECTION("truncated PNG") {
    data.truncate("a.png", 0.6);
    CHECK(failure(data, "a.png") == "DATA/a.png: is a truncated PNG file" + remedy);
    data.truncate("a.png", 0.005);
    CHECK(failure(data, "a.png") == "DATA/a.png: is a PNG file with a damaged header" + remedy);
  }
  SECTION("truncated JPEG, which OpenCV takes for whole") {
    data.truncate("a.jpg", 0.6);
    CHECK_FALSE(cv::imread(data.path("a.jpg").string()).empty());
    CHECK(failure(data, "a.jpg") ==
          "DATA/a.jpg: is a truncated JPEG file: its end marker is missing" + remedy);
    data.truncate("a.jpg", 0.02);
    CHECK(failure(data, "a.jpg") == "DATA/a.jpg: is a JPEG file with a damaged header" + remedy);
  }
  SECTION("no image at all") {
    data.write("a.png", "<html>not found</html>");
    CHECK(failure(data, "a.png") == "DATA/a.png: is neither a PNG nor a JPEG file" + remedy);
  }
  SECTION("another size") {
    data.writeImage("a.png", 64, 47);
    CHECK(failure(data, "a.png") ==
          "DATA/a.png: has 64x47 pixels, but the first image has 64x48" + remedy);
  }
  SECTION("changed pixels, caught by the check sum") {
    std::string bytes = data.read("a.png");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
    data.write("a.png", bytes);
    CHECK(failure(data, "a.png") == "DATA/a.png: cannot be decoded, its data are damaged" + remedy);
  }
  SECTION("a header that claims ten thousand million pixels") {
    std::string bytes = data.read("a.png");
    for (const std::size_t at : {std::size_t{16}, std::size_t{20}}) {
      bytes.replace(at, 4, std::string("\x00\x01\x86\xa0", 4));
    }
    data.write("a.png", bytes);
    CHECK(failure(data, "a.png") ==
          "DATA/a.png: claims an impossible size of 100000x100000 pixels" + remedy);
  }
}

TEST_CASE("comments of a PNG file change no pixel, and none can claim memory") {
  const DataFolder data;
  data.writeImage("a.png", 64, 48);
  const cv::Mat pixels = cv::imread(data.path("a.png").string(), cv::IMREAD_GRAYSCALE);
  constexpr std::size_t kHeaderEnd = 33;
  const std::string sound = data.read("a.png");
  const auto with = [&](const std::string& chunk) {
    data.write("b.png", std::string(sound).insert(kHeaderEnd, chunk));
    return readImageFile(data.path("b.png"), false, kSize);
  };
  const Result<Image> commented = with(std::string("\0\0\0\5tEXta\0bcd....", 17));
  REQUIRE(commented.isOk());
  CHECK(isSame(commented.value(), pixels));
  // libpng would take 1 GiB before it finds that the file ends.
  CHECK_FALSE(with(std::string("\x40\0\0\0eXIf....", 12)).isOk());
}

TEST_CASE("a sound image that cannot be opened is told as that, not as damaged") {
  const DataFolder data;
  data.writeImage("a.jpg", 64, 48);
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &before) == 0);
  const rlimit none = {0, before.rlim_max};
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &none) == 0);
  const Status status = readImageFile(data.path("a.jpg"), false, kSize).status();
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &before) == 0);
  CHECK(status.code() == StatusCode::Failed);
  CHECK(data.anonymous(status.message()) ==
        "DATA/a.jpg: cannot be read (Too many open files); allow more open files (`ulimit -n`)");
  CHECK(readImageFile(data.path("a.jpg"), false, kSize).isOk());
}

TEST_CASE("no content crashes, and what is accepted has the right size") {
  const DataFolder data;
  RandomStream random(11);
  for (const std::string name : {"m.png", "m.jpg"}) {
    data.writeImage(name, 64, 48);
    const std::string sound = data.read(name);
    int accepted = 0;
    for (int i = 0; i < 300; ++i) {
      std::string bytes = sound;
      // Headers are where a reader is misled: half of the changes go to the first 100 bytes.
      const std::uint64_t where = i % 2 == 0 ? 100 : bytes.size();
      for (int change = 0; change <= i % 5; ++change) {
        bytes[random.below(where)] = static_cast<char>(random.below(256));
      }
      if (i % 7 == 0) bytes.resize(random.below(bytes.size()));
      data.write(name, bytes);
      const Result<Image> image = readImageFile(data.path(name), false, kSize);
      if (!image.isOk()) continue;
      ++accepted;
      REQUIRE(image.value().width() == kSize.width);
      REQUIRE(image.value().height() == kSize.height);
    }
    CHECK(accepted < 300);
  }
}

}  // namespace tolman::image_folders
