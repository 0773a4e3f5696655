// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pair_survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/brightness.hpp"
#include "engine/stereo_check.hpp"

namespace tolman::imaging {
namespace {

// The same limits as in the checks of a run (stereo_check.cpp, chosen on kitti_clips/06).
constexpr std::size_t kMinMatches = 20;
constexpr double kRowsApart = 1.2;       // px
constexpr double kShareExchanged = 0.6;  // of the matches
constexpr double kWidelyApart = 3;       // px; exceeded by 10 % of the matches

GrayHalf mirrorImage(GrayHalf image) {
  for (int r = 0; r < image.height; ++r) {
    const auto begin = image.pixels.begin() + std::ptrdiff_t{r} * image.width;
    std::reverse(begin, begin + image.width);
  }
  return image;
}

int countOf(double share, int all) { return static_cast<int>(std::lround(share * all)); }

}  // namespace

void PairSurvey::add(const Frame& frame) {
  if (frame.left.empty() || frame.right.empty()) return;
  ++pairs_;
  brightest_ = std::max(brightest_, brightest(frame.left));
  const GrayHalf left = grayHalf(frame.left);
  const GrayHalf right = grayHalf(frame.right);
  const StereoMeasure measure = measureStereo(left, right);
  rows_.insert(rows_.end(), measure.rows.begin(), measure.rows.end());
  exchanged_ += countOf(measure.share_exchanged, measure.matched);
  const StereoMeasure mirrored = measureStereo(left, mirrorImage(right));
  mirrored_ += mirrored.matched;
  mirrored_exchanged_ += countOf(mirrored.share_exchanged, mirrored.matched);
}

std::vector<Finding> PairSurvey::findings() const {
  using Severity = Finding::Severity;
  const auto matches = static_cast<int>(rows_.size());
  if (mirrored_ >= static_cast<int>(kMinMatches) && mirrored_ > 3 * matches) {
    // If the left image is the mirrored one, both are mirrored now, so the sides seem exchanged.
    const bool left = mirrored_exchanged_ > kShareExchanged * mirrored_;
    return {{Severity::Error, "pairs",
             fmt::format("the {} image is mirrored; mirror it back (left to right), and calibrate "
                         "the camera again",
                         left ? "left" : "right")}};
  }
  if (pairs_ == 0) return {};
  if (rows_.size() < kMinMatches && brightest_ < kNearlyBlack) {
    return {
        {Severity::Warning, "pairs",
         fmt::format("only {} corners matched in {} pairs, too few to judge them: the images "
                     "are nearly black, with hardly any grey level above {} of 255; if their files "
                     "have 16 bits of which the camera uses fewer, set bits, otherwise expose "
                     "them longer",
                     matches, pairs_, brightest_)}};
  }
  if (rows_.size() < kMinMatches) {
    return {{Severity::Warning, "pairs",
             fmt::format("only {} corners matched in {} pairs, too few to judge them; if they are "
                         "not dark or blurred: are left and right image exchanged, taken at other "
                         "times, or is the calibration of other cameras?",
                         matches, pairs_)}};
  }
  const double low = percentile(rows_, 0.5);
  std::vector<double> apart = rows_;
  for (double& row : apart) row = std::abs(row);
  const double most = percentile(apart, 0.9);
  std::vector<Finding> found = {
      {Severity::Note, "pairs",
       fmt::format("{} corners matched in {} pairs: the right image is {:.1f} px {} (median); 90 % "
                   "of the rows are within {:.1f} px",
                   matches, pairs_, std::abs(low), low < 0 ? "high" : "low", most)}};
  if (exchanged_ > kShareExchanged * matches) {
    found.push_back({Severity::Error, "pairs",
                     "left and right image are exchanged; exchange the two folders (or topics, or "
                     "cameras of the calibration)"});
  } else if (std::abs(low) > kRowsApart) {
    found.push_back({Severity::Warning, "pairs",
                     "the rows of left and right image are apart; give the calibration of the raw "
                     "images, so that they are rectified, or calibrate again"});
  } else if (most > kWidelyApart) {
    found.push_back({Severity::Warning, "pairs",
                     "the rows of left and right image differ from place to place; check that "
                     "both are exposed at one time, that the calibration is of these cameras, and "
                     "the model of the distortion"});
  }
  return found;
}

}  // namespace tolman::imaging
