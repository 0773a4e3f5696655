// SPDX-License-Identifier: BSD-3-Clause
// What is computed in integers for many pixels at once, against OpenCV or one pixel after the
// other.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "corner_detection.hpp"
#include "patch_alignment.hpp"
#include "stereo_matching.hpp"
#include "tolman/context.hpp"

namespace tolman::feature_stereo {
namespace {

cv::Mat randomImage(std::uint64_t seed, cv::Size size, double blur) {
  RandomStream random(seed);
  cv::Mat image(size, CV_8U);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      image.at<uchar>(y, x) = static_cast<uchar>(random.below(256));
    }
  }
  if (blur > 0) {
    cv::GaussianBlur(image, image, {0, 0}, blur);
    cv::normalize(image, image, 0, 255, cv::NORM_MINMAX);
  }
  return image;
}

/// A smooth texture, known between pixels too.
class Waves {
 public:
  explicit Waves(std::uint64_t seed) {
    RandomStream random(seed);
    for (cv::Vec3d& wave : waves_) {
      wave = {0.35 * random.normal(), 0.35 * random.normal(), random.uniform(0, 6.28)};
    }
  }

  cv::Mat image(double dx, double dy) const {
    cv::Mat image(100, 120, CV_8U);
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        double sum = 128;
        for (const cv::Vec3d& w : waves_) {
          sum += 8 * std::cos(w[0] * (x - dx) + w[1] * (y - dy) + w[2]);
        }
        image.at<uchar>(y, x) = cv::saturate_cast<uchar>(sum);
      }
    }
    return image;
  }

 private:
  std::array<cv::Vec3d, 60> waves_;
};

/// A pixel, mirrored at the outermost ones.
double pixelAt(const cv::Mat& image, int x, int y) {
  return image.at<uchar>(cv::borderInterpolate(y, image.rows, cv::BORDER_REFLECT_101),
                         cv::borderInterpolate(x, image.cols, cv::BORDER_REFLECT_101));
}

double bilinear(const cv::Mat& image, double x, double y) {
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const double u = x - left;
  const double v = y - top;
  return (1 - v) * ((1 - u) * pixelAt(image, left, top) + u * pixelAt(image, left + 1, top)) +
         v * ((1 - u) * pixelAt(image, left, top + 1) + u * pixelAt(image, left + 1, top + 1));
}

double distanceOf(const cv::Mat& left, const cv::Mat& right, cv::Point corner, int disparity) {
  int sums[2] = {0, 0};
  for (int y = -4; y <= 4; ++y) {
    for (int x = -4; x <= 4; ++x) {
      sums[0] += left.at<uchar>(corner.y + y, corner.x + x);
      sums[1] += right.at<uchar>(corner.y + y, corner.x - disparity + x);
    }
  }
  int cost = 0;
  for (int y = -4; y <= 4; ++y) {
    for (int x = -4; x <= 4; ++x) {
      cost += std::abs(left.at<uchar>(corner.y + y, corner.x + x) - sums[0] / 81 -
                       right.at<uchar>(corner.y + y, corner.x - disparity + x) + sums[1] / 81);
    }
  }
  return cost;
}

}  // namespace

TEST_CASE("grey levels between pixels are bilinear, inside and beyond the border") {
  const cv::Mat image = randomImage(1, {61, 47}, 0);
  const FlowPyramid pyramid(image, 15, 1);
  RandomStream random(2);
  std::vector<std::int16_t> gray(17 * 32);
  for (int k = 0; k < 200; ++k) {
    const auto x = static_cast<int>(random.below(63)) - 10;
    const auto y = static_cast<int>(random.below(49)) - 10;
    const auto right = static_cast<int>(random.below(129));
    const auto below = static_cast<int>(random.below(32768));
    const PaddedImage padded = pyramid.padded(0);
    interpolate(padded.at(x, y), padded.step, 17, 32, right, below, gray.data());
    for (int row = 0; row < 17; ++row) {
      for (int column = 0; column < 32; ++column) {
        const double exact = bilinear(image, x + column + right / 128.0, y + row + below / 32767.0);
        const double found = gray[static_cast<std::size_t>(32 * row + column)];
        CHECK(std::abs(found / kGrayOne - exact) < 0.1);
      }
    }
  }
}

TEST_CASE("patches are found where the image was moved to, without a bias") {
  RandomStream random(3);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Waves waves(seed);
    const double dx = random.uniform(-2, 2);
    const double dy = random.uniform(-2, 2);
    for (const int side : {7, 15, 31, 61}) {
      const FlowPyramid from(waves.image(0, 0), side, 1);
      const FlowPyramid to(waves.image(dx, dy), side, 1);
      Patch patch(side);
      cv::Point2f sum(0, 0);
      int found = 0;
      for (int k = 0; k < 40; ++k) {
        const cv::Point2f start(static_cast<float>(random.uniform(50, 70)),
                                static_cast<float>(random.uniform(45, 55)));
        cv::Point2f place = start;
        if (!patch.take(from.padded(0), start)) continue;
        if (!patch.align(to.padded(0), place, 0.01F)) continue;
        const cv::Point2f error = place - start - cv::Point2f(float(dx), float(dy));
        if (side < 15 && cv::norm(error) > 0.3) continue;  // too small for two pixels
        CAPTURE(seed, side, dx, dy);
        CHECK(cv::norm(error) < (side < 15 ? 0.2 : 0.06));
        sum += error;
        ++found;
      }
      REQUIRE(found > 25);
      CHECK(cv::norm(sum) / found < 0.02);
    }
  }
}

TEST_CASE("patches without texture and places outside are refused") {
  const FlowPyramid flat(cv::Mat(80, 80, CV_8U, cv::Scalar(90)), 15, 1);
  Patch patch(15);
  CHECK_FALSE(patch.take(flat.padded(0), {40, 40}));
  const FlowPyramid image(randomImage(4, {80, 80}, 2), 15, 1);
  CHECK_FALSE(patch.take(image.padded(0), {-2, 40}));
  CHECK_FALSE(patch.take(image.padded(0), {40, 82}));
  CHECK_FALSE(patch.take(image.padded(0), {std::nanf(""), 40}));
  REQUIRE(patch.take(image.padded(0), {40, 40}));
  for (cv::Point2f place :
       {cv::Point2f(1e9F, 40), cv::Point2f(40, -1e30F), cv::Point2f(40, INFINITY)}) {
    CHECK_FALSE(patch.align(image.padded(0), place, 0.01F));
  }
}

TEST_CASE("sixteen disparities at once cost the same as one after the other") {
  const cv::Mat left = randomImage(5, {150, 40}, 0);
  const cv::Mat right = randomImage(6, {150, 40}, 0);
  cv::Mat extreme(40, 150, CV_8U, cv::Scalar(0));
  extreme.colRange(60, 90) = 255;
  for (const cv::Mat& other : {right, extreme}) {
    const FlowPyramid a(left, 15, 1);
    const FlowPyramid b(other, 15, 1);
    for (const int most : {0, 5, 15, 16, 70}) {
      RowSearch search(a.padded(0), b.padded(0), most);
      for (const cv::Point corner : {cv::Point(4, 4), {30, 20}, {77, 11}, {145, 35}}) {
        const std::vector<int>& costs = search.costsAt(corner);
        REQUIRE(static_cast<int>(costs.size()) == std::min(most, corner.x - 4) + 1);
        for (std::size_t d = 0; d < costs.size(); ++d) {
          CHECK(costs[d] == distanceOf(left, other, corner, static_cast<int>(d)));
        }
      }
      CHECK(search.costsAt({3, 20}).empty());
      CHECK(search.costsAt({30, 36}).empty());
    }
  }
}

TEST_CASE("responses are the eigenvalues that OpenCV finds") {
  for (const double blur : {0.0, 1.5}) {
    const cv::Mat image = randomImage(7, {131, 60}, blur);
    cv::Mat expected;
    cv::cornerMinEigenVal(image, expected, 5);
    constexpr int kFirst = 9;
    CornerResponse response(image, kFirst);
    // OpenCV divides derivatives by 4 * 5 * 255.
    constexpr double kScale = 5100.0 * 5100.0;
    for (int y = kFirst; y < image.rows - CornerResponse::kReach; ++y) {
      const std::int32_t* row = response.next();
      for (int x = CornerResponse::kReach; x < image.cols - CornerResponse::kReach; ++x) {
        const double truth = kScale * static_cast<double>(expected.at<float>(y, x));
        CHECK(row[x] == Approx(truth).epsilon(1e-4).margin(20));
      }
    }
  }
}

TEST_CASE("the strongest pixel of each free cell is its corner") {
  const cv::Mat image = randomImage(8, {200, 120}, 1.5);
  const CornerSettings settings{60, 0.05, 12};
  const std::vector<cv::Point2f> occupied = {{30.5F, 20}, {100, 61}, {3, 119}, {1e6F, 2}};
  const auto corners = detectCorners(image, occupied, settings);
  cv::Mat response;
  cv::cornerMinEigenVal(image, response, 5);
  double strongest = 0;
  cv::minMaxLoc(response(cv::Rect(12, 12, 176, 96)), nullptr, &strongest);
  const int cell = static_cast<int>(std::sqrt(200.0 * 120 / 60));
  std::size_t next = 0;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 10; ++column) {
      const bool taken =
          (row == 1 && column == 1) || (row == 3 && column == 5) || (row == 5 && column == 0);
      const cv::Rect area =
          cv::Rect(column * cell, row * cell, cell, cell) & cv::Rect(12, 12, 176, 96);
      double best = 0;
      cv::Point place;
      cv::minMaxLoc(response(area), nullptr, &best, nullptr, &place);
      if (taken || best < settings.quality * strongest) continue;
      REQUIRE(next < corners.size());
      CHECK(corners[next] == cv::Point2f(area.tl() + place));
      ++next;
    }
  }
  CHECK(next == corners.size());
  CHECK(next > 40);
}

}  // namespace tolman::feature_stereo
