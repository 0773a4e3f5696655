// SPDX-License-Identifier: BSD-3-Clause
#include "edge_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "edge_map.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::view_sequences {
namespace {

constexpr int kCell = 12;  // px of the reduced image; chosen, not tuned
constexpr int kWidth = kColumns * kCell;
constexpr int kHeight = kRows * kCell;
// Gradients below this over two pixels are treated as noise. Chosen, not tuned.
constexpr float kNoise = 0.01F;
// A view whose mean gradient over two pixels is smaller, in grey levels, is blank or dark. Chosen,
// not tuned.
constexpr double kBlank = 1;

cv::Mat reduced(const Image& image) {
  cv::Mat whole = asMat(image);
  // Halves first, which takes little time; the rest by a factor of two or more, so that it is the
  // same but for rounding.
  while (whole.cols >= 4 * kWidth && whole.rows >= 2 * kHeight) {
    cv::Mat half;
    cv::resize(whole, half, cv::Size(whole.cols / 2, whole.rows / 2), 0, 0, cv::INTER_AREA);
    whole = half;
  }
  cv::Mat small;
  cv::resize(whole, small, cv::Size(kWidth, kHeight), 0, 0, cv::INTER_AREA);
  if (image.format() != PixelFormat::Gray8) cv::cvtColor(small, small, cv::COLOR_BGR2GRAY);
  return small;
}

bool isBlank(const cv::Mat& gray) {
  double sum = 0;
  for (int y = 1; y < gray.rows - 1; ++y) {
    const std::uint8_t* above = gray.ptr<std::uint8_t>(y - 1);
    const std::uint8_t* row = gray.ptr<std::uint8_t>(y);
    const std::uint8_t* below = gray.ptr<std::uint8_t>(y + 1);
    for (int x = 1; x < gray.cols - 1; ++x) {
      const auto across = static_cast<float>(row[x + 1] - row[x - 1]);
      const auto down = static_cast<float>(below[x] - above[x]);
      sum += static_cast<double>(std::sqrt(across * across + down * down));
    }
  }
  return sum < kBlank * static_cast<double>(gray.total());
}

/// Logarithm of an image, so that edges in the dark count as those in the light: without it 0.81 of
/// the views of the town's 05 were ranked first on a second pass by night, with it 0.90. 8, 16 and
/// 32 for kDarkLevel are equally good there and on campus walks.
cv::Mat lightOf(const cv::Mat& gray) {
  constexpr float kMiddle = 100;  // grey level where its slope is that of level / 255
  cv::Mat light;
  gray.convertTo(light, CV_32F, 1, landmarks::kDarkLevel);
  cv::log(light, light);
  return light * ((kMiddle + landmarks::kDarkLevel) / 255);
}

/// The two cells nearest to a pixel along one axis, and the weight of the second.
struct Shares {
  int cell;  ///< the first; -1 before the first cell
  float second;
};

Shares sharesOf(int at) {
  const float place = (static_cast<float>(at) + 0.5F) / kCell - 0.5F;
  const float cell = std::floor(place);
  return {static_cast<int>(cell), place - cell};
}

class EdgeSums {
 public:
  /// Distributes an edge over the nearest cells and directions (linear interpolation).
  void add(Shares x, Shares y, float angle, float strength) {
    const float place = angle * kDirections - 0.5F;
    const float before = std::floor(place);
    const int first = (static_cast<int>(before) + kDirections) % kDirections;
    const int second = (first + 1) % kDirections;
    const float share = place - before;
    for (int i = 0; i < 4; ++i) {
      const int column = x.cell + i % 2;
      const int row = y.cell + i / 2;
      if (column < 0 || column >= kColumns || row < 0 || row >= kRows) continue;
      const float weight =
          (i % 2 == 0 ? 1 - x.second : x.second) * (i / 2 == 0 ? 1 - y.second : y.second);
      const auto cell = static_cast<std::size_t>(column * kRows + row);
      weights_[cell] += weight;
      sums_[cell * kDirections + static_cast<std::size_t>(first)] +=
          weight * strength * (1 - share);
      sums_[cell * kDirections + static_cast<std::size_t>(second)] += weight * strength * share;
    }
  }

  /// Mean strength for each cell and direction.
  EdgeValues means() const {
    EdgeValues means;
    for (std::size_t i = 0; i < means.size(); ++i) means[i] = sums_[i] / weights_[i / kDirections];
    return means;
  }

 private:
  EdgeValues sums_{};
  std::array<float, kColumns * kRows> weights_{};
};

EdgeValues edgesOf(const cv::Mat& image) {
  EdgeSums sums;
  for (int y = 1; y < kHeight - 1; ++y) {
    const float* above = image.ptr<float>(y - 1);
    const float* row = image.ptr<float>(y);
    const float* below = image.ptr<float>(y + 1);
    const Shares rows = sharesOf(y);
    for (int x = 1; x < kWidth - 1; ++x) {
      const float right = row[x + 1] - row[x - 1];
      const float down = below[x] - above[x];
      const float angle = std::atan2(down, right) / std::numbers::pi_v<float>;
      sums.add(sharesOf(x), rows, angle < 0 ? angle + 1 : angle,
               std::sqrt(right * right + down * down));
    }
  }
  return sums.means();
}

float energyOf(const EdgeValues& edges, int column, int row) {
  const float* cell = &edges[static_cast<std::size_t>((column * kRows + row) * kDirections)];
  float energy = 0;
  for (int k = 0; k < kDirections; ++k) energy += cell[k] * cell[k];
  return energy;
}

/// Root mean square of the edges of the 3 x 3 cells around.
float strengthAround(const EdgeValues& edges, int column, int row) {
  float energy = 0;
  int cells = 0;
  for (int c = std::max(0, column - 1); c <= std::min(kColumns - 1, column + 1); ++c) {
    for (int r = std::max(0, row - 1); r <= std::min(kRows - 1, row + 1); ++r) {
      energy += energyOf(edges, c, r);
      ++cells;
    }
  }
  return std::sqrt(energy / static_cast<float>(cells));
}

}  // namespace

bool edgeGrid(const Image& image, EdgeValues& values) {
  const cv::Mat gray = reduced(image);
  if (isBlank(gray)) return false;
  const EdgeValues edges = edgesOf(lightOf(gray));
  for (int c = 0; c < kColumns; ++c) {
    for (int r = 0; r < kRows; ++r) {
      const float around = strengthAround(edges, c, r) + kNoise;
      for (int k = 0; k < kDirections; ++k) {
        const auto i = static_cast<std::size_t>((c * kRows + r) * kDirections + k);
        values[i] = std::sqrt(edges[i] / around);  // the root amplifies weak edges near strong ones
      }
    }
  }
  return true;
}

PackedView packed(const EdgeValues& values) {
  const auto level = [&](int i) {
    const float value = values[static_cast<std::size_t>(i)] * kLevelsPerUnit;
    return static_cast<unsigned>(std::clamp(std::lround(value), 0L, 15L));
  };
  constexpr int kHalf = kColumnValues / 2;
  PackedView view;
  for (int c = 0; c < kColumns; ++c) {
    for (int i = 0; i < kHalf; ++i) {
      const int first = c * kColumnValues + i;
      view[static_cast<std::size_t>(c * kHalf + i)] =
          static_cast<std::uint8_t>(level(first) | level(first + kHalf) << 4U);
    }
  }
  return view;
}

void unpack(std::span<const std::uint8_t> view, std::span<std::int16_t, kValues> levels) {
  constexpr int kHalf = kColumnValues / 2;
  const std::uint8_t* byte = view.data();
  std::int16_t* level = levels.data();
  for (int c = 0; c < kColumns; ++c, byte += kHalf, level += kColumnValues) {
    for (int i = 0; i < kHalf; ++i) {
      level[i] = static_cast<std::int16_t>(byte[i] & 15U);
      level[kHalf + i] = static_cast<std::int16_t>(byte[i] >> 4U);
    }
  }
}

}  // namespace tolman::view_sequences
