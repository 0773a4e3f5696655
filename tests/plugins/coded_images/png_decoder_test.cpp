// SPDX-License-Identifier: BSD-3-Clause
// PNG data of every filter, undamaged and damaged. The undamaged ones are compared with
// cv::imdecode. The files are written here, so that the test chooses the filter of each row.
#include "png_decoder.hpp"

#include <zlib.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "png_filters.hpp"
#include "tolman/context.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::coded_images {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t value) {
  for (unsigned shift = 32; shift > 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (shift - 8)));
  }
}

void appendChunk(Bytes& png, const std::string& name, const Bytes& data) {
  append(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = png.size();
  png.insert(png.end(), name.begin(), name.end());
  png.insert(png.end(), data.begin(), data.end());
  append(png, static_cast<std::uint32_t>(
                  crc32(0, png.data() + begin, static_cast<uInt>(png.size() - begin))));
}

/// The prediction of a filter as the standard's text says it.
int predicted(int filter, int a, int b, int c) {
  switch (filter) {
    case 1:
      return a;
    case 2:
      return b;
    case 3:
      return (a + b) / 2;
    case 4: {
      const int p = a + b - c;
      const int pa = std::abs(p - a);
      const int pb = std::abs(p - b);
      const int pc = std::abs(p - c);
      if (pa <= pb && pa <= pc) return a;
      return pb <= pc ? b : c;
    }
    default:
      return 0;
  }
}

/// A row of pixels after filtering, with the filter's number before it.
Bytes filtered(int filter, const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes,
               std::size_t pixel) {
  Bytes result = {static_cast<std::uint8_t>(filter)};
  for (std::size_t i = 0; i < bytes; ++i) {
    const int a = i < pixel ? 0 : row[i - pixel];
    const int b = above == nullptr ? 0 : above[i];
    const int c = i < pixel || above == nullptr ? 0 : above[i - pixel];
    result.push_back(static_cast<std::uint8_t>(row[i] - predicted(filter, a, b, c)));
  }
  return result;
}

struct Header {
  std::uint32_t width;
  std::uint32_t height;
  std::uint8_t depth = 8;
  std::uint8_t colour_type = 0;
  std::uint8_t interlace = 0;
};

/// A file with `rows` as they are; the packed data lie in chunks of 100 bytes.
Bytes file(const Header& header, const Bytes& rows) {
  Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes data;
  append(data, header.width);
  append(data, header.height);
  data.insert(data.end(), {header.depth, header.colour_type, 0, 0, header.interlace});
  appendChunk(png, "IHDR", data);
  uLongf size = compressBound(rows.size());
  Bytes packed(size);
  REQUIRE(compress(packed.data(), &size, rows.data(), rows.size()) == Z_OK);
  packed.resize(size);
  for (std::size_t at = 0; at < packed.size(); at += 100) {
    const std::size_t end = std::min(at + 100, packed.size());
    appendChunk(png, "IDAT",
                {packed.begin() + static_cast<long>(at), packed.begin() + static_cast<long>(end)});
  }
  appendChunk(png, "IEND", {});
  return png;
}

/// Smooth structure and some noise, RGB or grey.
cv::Mat picture(int type, int width = 61, int height = 40) {
  cv::Mat pixels(height, width, type);
  cv::RNG(7).fill(pixels, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(pixels, pixels, {5, 5}, 1);
  return pixels;
}

/// The picture as a file; `filterOf` chooses the filter of each row.
template <class FilterOf>
Bytes encoded(const cv::Mat& picture, const FilterOf& filterOf) {
  const auto pixel = static_cast<std::size_t>(picture.channels());
  const std::size_t bytes = pixel * static_cast<std::size_t>(picture.cols);
  Bytes rows;
  for (int y = 0; y < picture.rows; ++y) {
    const Bytes row =
        filtered(filterOf(y), picture.ptr(y), y == 0 ? nullptr : picture.ptr(y - 1), bytes, pixel);
    rows.insert(rows.end(), row.begin(), row.end());
  }
  const std::uint8_t colour_type = pixel == 1 ? 0 : 2;
  return file({static_cast<std::uint32_t>(picture.cols), static_cast<std::uint32_t>(picture.rows),
               8, colour_type},
              rows);
}

source_parameters::UsedBits bits;

bool isSame(const Image& image, const cv::Mat& expected) {
  return cv::norm(asMat(image), expected, cv::NORM_INF) == 0;
}

}  // namespace

TEST_CASE("every filter of PNG, alone and mixed, is undone as by OpenCV") {
  RandomStream random(5);
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const bool colour = type == CV_8UC3;
    const cv::Mat pixels = picture(type);
    for (int filter = 0; filter <= 5; ++filter) {  // 5: mixed
      CAPTURE(colour, filter);
      const Bytes png = encoded(
          pixels, [&](int) { return filter < 5 ? filter : static_cast<int>(random.below(5)); });
      const auto image = decodePlainPng(png, colour);
      REQUIRE(image);
      const cv::Mat expected = cv::imdecode(png, colour ? cv::IMREAD_COLOR : cv::IMREAD_GRAYSCALE);
      CHECK(isSame(*image, expected));
      CHECK(image->format() == (colour ? PixelFormat::Bgr8 : PixelFormat::Gray8));
    }
  }
}

TEST_CASE("images of one row, one column and one pixel") {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(9, 1), std::pair(1, 9)}) {
    for (int filter = 0; filter < 5; ++filter) {
      const cv::Mat pixels = picture(CV_8UC1, width, height);
      const auto image = decodePlainPng(encoded(pixels, [&](int) { return filter; }), false);
      REQUIRE(image);
      CHECK(isSame(*image, pixels));
    }
  }
}

TEST_CASE("sums along rows of any length") {
  for (int width = 1; width <= 40; ++width) {
    CAPTURE(width);
    cv::Mat pixels(3, width, CV_8UC1);
    cv::RNG(width).fill(pixels, cv::RNG::UNIFORM, 0, 256);
    const auto image = decodePlainPng(encoded(pixels, [](int) { return 1; }), false);
    REQUIRE(image);
    CHECK(isSame(*image, pixels));
  }
}

TEST_CASE("the nearest of three neighbours, for all distances and ties") {
  for (int a = 0; a < 256; a += 5) {
    for (int b = 0; b < 256; b += 3) {
      for (int c = 0; c < 256; c += 7) {
        // Row 0 by the filter Sub: c, b. Row 1: a, then what Paeth predicts from a, b and c.
        const std::array<std::uint8_t, 6> rows = {1, std::uint8_t(c),     std::uint8_t(b - c),
                                                  4, std::uint8_t(a - c), 0};
        std::array<std::uint8_t, 4> pixels{};
        REQUIRE(undoFilters(rows.data(), 2, 2, 1, pixels.data()));
        if (pixels[3] != predicted(4, a, b, c)) FAIL(a << " " << b << " " << c);
      }
    }
  }
}

TEST_CASE("other kinds of images are left to OpenCV, and come as it reads them") {
  const cv::Mat grey = picture(CV_8UC1);
  const cv::Mat rgb = picture(CV_8UC3);
  cv::Mat deep;
  grey.convertTo(deep, CV_16U, 257);
  cv::Mat with_alpha;
  cv::cvtColor(rgb, with_alpha, cv::COLOR_BGR2BGRA);
  for (const cv::Mat& pixels : {deep, with_alpha, rgb}) {
    Bytes png;
    cv::imencode(".png", pixels, png);
    CHECK_FALSE(decodePlainPng(png, false));
    const cv::Mat expected = cv::imdecode(png, cv::IMREAD_GRAYSCALE);
    const Result<Image> image = decodePng(png, false, bits);
    REQUIRE(image.isOk());
    CHECK(isSame(image.value(), expected));
  }
  Bytes png;
  cv::imencode(".png", grey, png);
  CHECK(decodePlainPng(png, false));
  CHECK_FALSE(decodePlainPng(png, true));  // colour of a grey image
  // Chunks that do not change pixels are left out, others are not.
  const auto with = [&](const std::string& name) {
    Bytes more(png.begin(), png.begin() + 33);
    appendChunk(more, name, {1, 2, 3});
    more.insert(more.end(), png.begin() + 33, png.end());
    return decodePlainPng(more, false);
  };
  CHECK(isSame(with("tEXt").value(), grey));
  CHECK_FALSE(with("tRNS"));
  const Bytes rows(41 * 62);
  CHECK_FALSE(decodePlainPng(file({61, 41, 8, 0, 1}, rows), false));  // interlaced
  CHECK_FALSE(decodePlainPng(file({61, 41, 4, 0}, rows), false));
  CHECK_FALSE(decodePlainPng(file({61, 41, 8, 3}, rows), false));  // a palette
}

TEST_CASE("no changed byte passes") {
  const cv::Mat pixels = picture(CV_8UC1, 20, 12);
  const Bytes png = encoded(pixels, [](int y) { return y % 5; });
  for (std::size_t at = 8; at < png.size(); ++at) {
    for (const int bit : {0, 3, 7}) {
      Bytes damaged = png;
      damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1U << unsigned(bit)));
      if (decodePlainPng(damaged, false)) FAIL("byte " << at << ", bit " << bit);
    }
  }
  for (std::size_t size = 0; size < png.size(); ++size) {
    if (decodePlainPng(Bytes(png.begin(), png.begin() + long(size)), false)) FAIL("size " << size);
  }
}

TEST_CASE("data that do not fit the header are refused") {
  const Bytes rows(12 * 21);
  CHECK(decodePlainPng(file({20, 12}, rows), false));
  CHECK_FALSE(decodePlainPng(file({20, 13}, rows), false));
  CHECK_FALSE(decodePlainPng(file({20, 11}, rows), false));
  CHECK_FALSE(decodePlainPng(file({9'000, 9'000}, rows), false));  // no deflate packs so much
  Bytes wrong_filter = rows;
  wrong_filter[21] = 5;
  Bytes png = file({20, 12}, wrong_filter);
  CHECK_FALSE(decodePlainPng(png, false));
  CHECK_FALSE(decodePng(png, false, bits).isOk());
}

TEST_CASE("depth images are those of one channel of 16 bits") {
  Bytes png;
  cv::imencode(".png", cv::Mat(4, 6, CV_16UC1, cv::Scalar(5000)), png);
  const auto depth = decodeDepth(png);
  REQUIRE(depth.isOk());
  CHECK(depth.value().width == 6);
  CHECK(depth.value().values == std::vector<std::uint16_t>(24, 5000));
  cv::imencode(".png", cv::Mat(4, 6, CV_8UC1), png);
  CHECK(decodeDepth(png).status().message().ends_with("it is no depth image"));
}

}  // namespace tolman::coded_images
