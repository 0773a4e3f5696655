// SPDX-License-Identifier: BSD-3-Clause
// Encodings of image messages, each against values worked out by hand.
#include "image_conversion.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "bag_case.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::ros_bag {
namespace {

const std::string kRaw(kImage);

Result<Image> convert(const test::RosImage& image, bool colour) {
  return convertImage(kRaw, asBytes(test::imageMessage(image)), colour);
}

/// 4x4 px, all of one pixel.
test::RosImage flat(const std::string& encoding, const std::string& pixel) {
  test::RosImage image{1, 4, 4, encoding, ""};
  for (int i = 0; i < 16; ++i) image.pixels += pixel;
  return image;
}

/// Blue, green, red.
std::array<int, 3> pixelOf(const Image& image, int x, int y) {
  const std::uint8_t* at = image.row(y) + 3 * x;
  return {at[0], at[1], at[2]};
}

}  // namespace

TEST_CASE("colours of every order of channels") {
  const double luminance = 0.299 * 200 + 0.587 * 100 + 0.114 * 50;
  for (const auto& [encoding, pixel] : {std::pair{"rgb8", "\xc8\x64\x32"},
                                        {"bgr8", "\x32\x64\xc8"},
                                        {"rgba8", "\xc8\x64\x32\xff"},
                                        {"bgra8", "\x32\x64\xc8\x01"}}) {
    INFO(encoding);
    const auto colour = convert(flat(encoding, pixel), true);
    REQUIRE(colour.isOk());
    CHECK(pixelOf(colour.value(), 2, 3) == std::array<int, 3>{50, 100, 200});
    const auto grey = convert(flat(encoding, pixel), false);
    REQUIRE(grey.isOk());
    CHECK(std::abs(grey.value().row(1)[1] - luminance) <= 1);
  }
}

TEST_CASE("a Bayer pattern of one colour is that colour") {
  // Only the red pixels are lit: where they stand is what tells the patterns apart.
  for (const auto& [encoding, red] :
       {std::pair{"bayer_rggb8", 0}, {"bayer_grbg8", 1}, {"bayer_gbrg8", 2}, {"bayer_bggr8", 3}}) {
    INFO(encoding);
    test::RosImage image{1, 8, 8, encoding, std::string(64, '\0')};
    for (int y = red / 2; y < 8; y += 2) {
      for (int x = red % 2; x < 8; x += 2)
        image.pixels[static_cast<std::size_t>(8 * y + x)] = '\x78';
    }
    const auto colour = convert(image, true);
    REQUIRE(colour.isOk());
    const auto [b, g, r] = pixelOf(colour.value(), 4, 4);
    CHECK(b == 0);
    CHECK(g == 0);
    CHECK(r == 0x78);
  }
}

TEST_CASE("of 16 bits as many are used as the camera has") {
  // Values 0x0234, 0x03fe, 0x0080, 0x0100, of a camera of 10 bits.
  const std::string ten("\x34\x02\xfe\x03\x80\x00\x00\x01", 8);
  const auto as = [&](int bits) {
    UsedBits used(bits);
    const auto image =
        convertImage(kRaw, asBytes(test::imageMessage({1, 2, 2, "mono16", ten})), false, used);
    REQUIRE(image.isOk());
    const Image& grey = image.value();
    return std::vector<int>{grey.row(0)[0], grey.row(0)[1], grey.row(1)[0], grey.row(1)[1]};
  };
  CHECK(as(16) == std::vector<int>{2, 3, 0, 1});
  CHECK(as(10) == std::vector<int>{0x234 >> 2, 0x3fe >> 2, 0x80 >> 2, 0x100 >> 2});
  CHECK(as(9) == std::vector<int>{255, 255, 0x80 >> 1, 0x100 >> 1});
}

TEST_CASE("depth in PNG as image_transport writes it") {
  std::vector<std::uint8_t> png;
  REQUIRE(cv::imencode(".png", cv::Mat(1, 2, CV_16UC1, cv::Scalar(1500)), png));
  const std::string coded(png.begin(), png.end());
  const auto depth = [](const std::string& format, const std::string& data) {
    const std::string message = test::compressedImageMessage(1, format, data);
    CHECK(isDepth(std::string(kCompressedImage), asBytes(message)));
    ImageSize size;
    const auto values = convertDepth(std::string(kCompressedImage), asBytes(message), size);
    REQUIRE(values.isOk());
    CHECK(size == ImageSize{2, 1});
    return values.value().at(0);
  };
  CHECK(depth("16UC1; png compressed", coded) == 1.5F);
  const auto header = [](float a, float b) {
    std::string bytes(12, '\0');
    std::memcpy(bytes.data() + 4, &a, 4);
    std::memcpy(bytes.data() + 8, &b, 4);
    return bytes;
  };
  CHECK(depth("16UC1; compressedDepth png", header(0, 0) + coded) == 1.5F);
  CHECK(depth("32FC1; compressedDepth png", header(3000, 500) + coded) == 3.0F);  // a / (value - b)
  CHECK_FALSE(isDepth(std::string(kCompressedImage), asBytes(test::compressedImageMessage(
                                                         1, "bgr8; png compressed bgr8", coded))));
}

TEST_CASE("16 bit, rows with bytes behind them, and YUV") {
  test::RosImage deep{1, 2, 2, "mono16", std::string("\x34\x12\xff\xfe\x00\x80\x00\x01", 8)};
  auto grey = convert(deep, false);
  REQUIRE(grey.isOk());
  CHECK(grey.value().row(0)[0] == 0x12);
  CHECK(grey.value().row(0)[1] == 0xfe);
  CHECK(grey.value().row(1)[0] == 0x80);
  deep.big_endian = true;
  CHECK(convert(deep, false).value().row(0)[0] == 0x34);
  grey = convert({1, 2, 2, "mono8", "abXcdX"}, false);
  REQUIRE(grey.isOk());
  CHECK(grey.value().row(1)[0] == 'c');
  grey = convert(flat("yuv422", "\x80\x50"), false);
  REQUIRE(grey.isOk());
  CHECK(grey.value().row(3)[3] == 0x50);
  grey = convert(flat("yuv422_yuy2", "\x50\x80"), false);
  REQUIRE(grey.isOk());
  CHECK(grey.value().row(3)[3] == 0x50);
}

TEST_CASE("encodings of cameras by V4L2, in any case of letters, and Bayer patterns of 16 bits") {
  for (const char* encoding : {"yuyv", "YUYV", "YUY2", "yuv422_yuy2"}) {
    CHECK(convert(flat(encoding, "\x50\x80"), false).value().row(3)[3] == 0x50);
  }
  for (const auto& [encoding, chroma] :
       {std::pair{"nv12", "\x80\xc8\x80\xc8"}, {"NV21", "\xc8\x80\xc8\x80"}}) {
    const test::RosImage image{1, 4, 4, encoding, std::string(16, '\x50') + chroma + chroma};
    CHECK(convert(image, false).value().row(3)[3] == 0x50);
    const auto [blue, green, red] = pixelOf(convert(image, true).value(), 3, 3);
    CHECK(green < blue);  // V is 200: more red, less green
    CHECK(red > 150);
    test::RosImage cut = image;
    cut.pixels.pop_back();
    CHECK_FALSE(convert(cut, false).isOk());
  }
  test::RosImage deep{1, 4, 4, "bayer_rggb16", ""};
  for (int i = 0; i < 16; ++i) deep.pixels += std::string("\x34\x12", 2);
  CHECK(convert(deep, false).value().row(2)[2] == 0x12);
}

TEST_CASE("a JPEG and a PNG image in a message, and cut ones") {
  cv::Mat picture(24, 32, CV_8UC1);
  for (int x = 0; x < 32; ++x) picture.col(x).setTo(8 * x);
  for (const char* type : {".png", ".jpg"}) {
    std::vector<std::uint8_t> coded;
    cv::imencode(type, picture, coded);
    const std::string bytes(coded.begin(), coded.end());
    const auto read = [&](const std::string& part) {
      const std::string message = test::compressedImageMessage(1, "mono8", part);
      return convertImage(std::string(kCompressedImage), asBytes(message), false);
    };
    const auto image = read(bytes);
    REQUIRE(image.isOk());
    CHECK(cv::norm(asMat(image.value()), picture, cv::NORM_INF) <= (type[1] == 'p' ? 0 : 12));
    CHECK_FALSE(read(bytes.substr(0, bytes.size() / 2)).isOk());
    CHECK_FALSE(read("").isOk());
  }
}

TEST_CASE("a JPEG image in a message whose second half is damaged, although it has its end") {
  cv::Mat picture(120, 160, CV_8UC1);
  cv::RNG(3).fill(picture, cv::RNG::UNIFORM, 0, 255);
  std::vector<std::uint8_t> coded;
  cv::imencode(".jpg", picture, coded);
  std::string bytes(coded.begin(), coded.end());
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), bytes.end() - 2, '\0');
  const std::string message = test::compressedImageMessage(1, "jpeg", bytes);
  for (const bool colour : {false, true}) {
    const Status status =
        convertImage(std::string(kCompressedImage), asBytes(message), colour).status();
    CHECK_THAT(status.message(),
               Catch::StartsWith("cannot be decoded, its data are damaged (libjpeg"));
  }
}

TEST_CASE("what cannot be converted says why") {
  CHECK(convert({1, 640, 480, "rgb8", std::string(480, 'x')}, false).status().message() ==
        "has rows of 1 bytes instead of 1920");
  CHECK(convert({1, 2, 2, "64FC9", "abcd"}, false).status().message() ==
        "has the encoding '64FC9', which cannot be converted");
  CHECK(convertImage(kRaw, asBytes("abc"), false).status().message() == "is no complete message");
  std::string message = test::imageMessage({1, 8, 4, "mono8", std::string(32, 'x')});
  message[28] = '\x7f';  // the height
  CHECK_FALSE(convertImage(kRaw, asBytes(message), false).isOk());
}

TEST_CASE("depth in metres, and 0 where it is not known") {
  ImageSize size;
  const auto whole = convertDepth(
      kRaw, asBytes(test::imageMessage({1, 2, 1, "16UC1", std::string("\xe8\x03\x00\x00", 4)})),
      size);
  REQUIRE(whole.isOk());
  CHECK(size == ImageSize{2, 1});
  CHECK(whole.value() == std::vector<float>{1.0F, 0.0F});
  const std::array<float, 4> metres = {2.5F, NAN, -1.0F, INFINITY};
  std::string pixels(16, '\0');
  std::memcpy(pixels.data(), metres.data(), 16);
  const auto real =
      convertDepth(kRaw, asBytes(test::imageMessage({1, 4, 1, "32FC1", pixels})), size);
  REQUIRE(real.isOk());
  CHECK(real.value() == std::vector<float>{2.5F, 0, 0, 0});
  CHECK_FALSE(
      convertDepth(kRaw, asBytes(test::imageMessage({1, 2, 1, "mono8", "ab"})), size).isOk());
}

}  // namespace tolman::ros_bag
