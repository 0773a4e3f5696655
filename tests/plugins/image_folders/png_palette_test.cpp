// SPDX-License-Identifier: BSD-3-Clause
// Images with a palette whose pixels name colours that it does not have. The files are written
// here, because no encoder makes them.
#include "png_palette.hpp"

#include <zlib.h>

#include <array>
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "png_decoder.hpp"

namespace tolman::image_folders {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Grid = std::vector<std::vector<unsigned>>;  ///< indices by row and column

void addNumber(Bytes& bytes, std::size_t value) {
  for (unsigned shift = 32; shift > 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (shift - 8)));
  }
}

void addChunk(Bytes& png, const std::string& name, const Bytes& data) {
  addNumber(png, data.size());
  const std::size_t begin = png.size();
  png.insert(png.end(), name.begin(), name.end());
  png.insert(png.end(), data.begin(), data.end());
  addNumber(png, crc32(0, png.data() + begin, static_cast<uInt>(png.size() - begin)));
}

/// Every `step`-th pixel of every `row_step`-th row, packed, each row with the filter "none".
void addPass(Bytes& rows, const Grid& grid, unsigned depth, std::array<std::size_t, 4> pass) {
  const auto [column, row, step, row_step] = pass;
  if (column >= grid[0].size()) return;
  for (std::size_t r = row; r < grid.size(); r += row_step) {
    rows.push_back(0);
    unsigned used = 8;
    for (std::size_t c = column; c < grid[0].size(); c += step) {
      if (used == 8) {
        rows.push_back(0);
        used = 0;
      }
      used += depth;
      rows.back() = static_cast<std::uint8_t>(rows.back() | (grid[r][c] << (8 - used)));
    }
  }
}

Bytes palettePng(const Grid& grid, unsigned depth, std::size_t colours, bool interlaced) {
  Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  addNumber(header, grid[0].size());
  addNumber(header, grid.size());
  header.insert(header.end(), {static_cast<std::uint8_t>(depth), 3, 0, 0, interlaced});
  addChunk(png, "IHDR", header);
  addChunk(png, "PLTE", Bytes(3 * colours, 200));
  Bytes rows;
  if (interlaced) {
    for (const auto& pass : {std::array<std::size_t, 4>{0, 0, 8, 8},
                             {4, 0, 8, 8},
                             {0, 4, 4, 8},
                             {2, 0, 4, 4},
                             {0, 2, 2, 4},
                             {1, 0, 2, 2},
                             {0, 1, 1, 2}}) {
      addPass(rows, grid, depth, pass);
    }
  } else {
    addPass(rows, grid, depth, {0, 0, 1, 1});
  }
  uLongf size = compressBound(rows.size());
  Bytes packed(size);
  REQUIRE(compress(packed.data(), &size, rows.data(), rows.size()) == Z_OK);
  packed.resize(size);
  addChunk(png, "IDAT", packed);
  addChunk(png, "IEND", {});
  return png;
}

}  // namespace

TEST_CASE("a pixel of a colour that the palette does not have makes the image damaged") {
  for (const unsigned depth : {1U, 2U, 4U, 8U}) {
    for (const bool interlaced : {false, true}) {
      const std::size_t colours = (std::size_t{1} << depth) - 1;
      Grid grid(11, std::vector<unsigned>(13, 0));
      Bytes sound = palettePng(grid, depth, colours, interlaced);
      CHECK_FALSE(exceedsPalette(sound));
      CHECK(cv::imdecode(sound, cv::IMREAD_GRAYSCALE).at<std::uint8_t>(10, 12) == 200);
      CHECK(decodePng(sound, false).isOk());
      for (const auto& [r, c] : {std::pair{0U, 0U}, {10U, 12U}, {5U, 3U}, {2U, 7U}}) {
        INFO(depth << " " << interlaced << " " << r << " " << c);
        Grid wrong = grid;
        wrong[r][c] = static_cast<unsigned>(colours);
        Bytes png = palettePng(wrong, depth, colours, interlaced);
        CHECK(exceedsPalette(png));
        CHECK(decodePng(png, false).status().code() == StatusCode::InvalidInput);
        CHECK(decodePng(png, true).status().message() ==
              "has pixels of colours that are not in its palette, so its data are damaged");
        Bytes whole = palettePng(wrong, depth, colours + 1, interlaced);
        CHECK_FALSE(exceedsPalette(whole));
        CHECK(decodePng(whole, true).isOk());
      }
    }
  }
}

TEST_CASE("images that are cut or have no palette do not exceed one") {
  const Bytes png = palettePng(Grid(4, std::vector<unsigned>(4, 3)), 2, 3, false);
  for (std::size_t size = 0; size < png.size(); ++size) {
    const bool has_data = size >= png.size() - 12;  // all but IEND
    CHECK(exceedsPalette(std::span(png).first(size)) == has_data);
  }
  Bytes grey;
  cv::imencode(".png", cv::Mat(5, 5, CV_8UC1, cv::Scalar(9)), grey);
  CHECK_FALSE(exceedsPalette(grey));
}

}  // namespace tolman::image_folders
