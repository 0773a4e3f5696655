// SPDX-License-Identifier: BSD-3-Clause
#include "photometric.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/text_file.hpp"
#include "coded_image.hpp"
#include "data_error.hpp"
#include "image_file.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;
using source_parameters::valueOf;

PhotometricCalibration::PhotometricCalibration(const fs::path& response, int width, int height) {
  readResponse(response);
  std::error_code ignored;
  const fs::path vignette = response.parent_path() / "vignette.png";
  if (fs::exists(vignette, ignored)) readVignette(vignette, width, height);
}

void PhotometricCalibration::readResponse(const fs::path& file) {
  const std::string text = valueOf(text_encoding::readText(file));
  for (const text_encoding::TextLine& line : text_encoding::contentLines(text)) {
    for (const std::string_view field : text_encoding::splitFields(line.text)) {
      const auto number = text_encoding::parseNumber(field);
      if (!number) {
        throw DataError(file, line.number,
                        text_encoding::inQuotes(field) + " is no number; correct it");
      }
      light_.push_back(static_cast<float>(*number));
    }
  }
  if (light_.size() != 256) {
    throw DataError(file, "has " + std::to_string(light_.size()) +
                              " numbers instead of one for each of 256 grey levels; restore it");
  }
  const bool rises = std::ranges::adjacent_find(light_, std::greater_equal<>()) == light_.end();
  if (!rises) {
    throw DataError(file,
                    "has numbers that do not rise; give the inverse response, from grey "
                    "level to light");
  }
  const float dark = light_.front();
  const float span = light_.back() - dark;
  for (float& value : light_) value = 255 * (value - dark) / span;
}

void PhotometricCalibration::readVignette(const fs::path& file, int width, int height) {
  // Of 16 bits as published, but of 8 where a program has converted it.
  std::vector<float> attenuation;
  int columns = 0;
  int rows = 0;
  if (const Result<coded_images::DepthValues> deep = readDepthFile(file); deep.isOk()) {
    attenuation.assign(deep.value().values.begin(), deep.value().values.end());
    columns = deep.value().width;
    rows = deep.value().height;
  } else {
    source_parameters::UsedBits bits;
    const Image image = valueOf(coded_images::decodeImage(valueOf(readBytes(file)), false, bits));
    columns = image.width();
    rows = image.height();
    for (int y = 0; y < rows; ++y) {
      attenuation.insert(attenuation.end(), image.row(y), image.row(y) + columns);
    }
  }
  if (columns != width || rows != height) {
    throw DataError(file, "has " + std::to_string(columns) + "x" + std::to_string(rows) +
                              " pixels, but the images have " + std::to_string(width) + "x" +
                              std::to_string(height) + "; give the vignette of these images");
  }
  const float brightest = *std::ranges::max_element(attenuation);
  // Of the brightest; below it a pixel shows the rim of the lens. Chosen, not tuned.
  constexpr float kDarkest = 0.05F;
  for (float& value : attenuation) value = 1 / std::max(value / brightest, kDarkest);
  gain_ = std::move(attenuation);
}

Image PhotometricCalibration::apply(const Image& image) const {
  const int channels = bytesPerPixel(image.format());
  return Image::create(image.width(), image.height(), image.format(), [&](std::uint8_t* out) {
    std::size_t pixel = 0;
    for (int y = 0; y < image.height(); ++y) {
      const std::uint8_t* row = image.row(y);
      for (int x = 0; x < image.width(); ++x, ++pixel) {
        const float gain = gain_.empty() ? 1 : gain_[pixel];
        for (int c = 0; c < channels; ++c) {
          const float light = light_[*row++] * gain;
          *out++ = static_cast<std::uint8_t>(std::lround(std::min(light, 255.0F)));
        }
      }
    }
  });
}

}  // namespace tolman::image_folders
