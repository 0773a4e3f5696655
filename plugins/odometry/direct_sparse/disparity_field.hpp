// SPDX-License-Identifier: BSD-3-Clause
// A smooth function over an image, in px: by how much the right image of a point lies below, or to
// the right of, where the calibration says. Zero for a perfectly calibrated pair.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace tolman::direct_sparse {

/// Products of Legendre polynomials P_i(x) P_j(y) with i + j <= 3, where x and y run from -1 to 1
/// over the image. Coefficients are in px.
struct SmoothField {
  static constexpr int kDegree = 3;
  static constexpr int kTerms = 10;
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  /// i + j of each term; terms are ordered by i, then j.
  static constexpr std::array<int, kTerms> kDegrees = {0, 1, 2, 3, 1, 2, 3, 2, 3, 3};

  /// Values of the terms at pixel (u, v) of an image of this size.
  static Terms termsAt(double u, double v, int width, int height);

  /// px
  double at(double u, double v, int width, int height) const {
    return coefficients.dot(termsAt(u, v, width, height));
  }
  /// Root mean square over an image, px.
  double rms() const;
  double rmsWithoutOffset() const;

  Terms coefficients = Terms::Zero();
};

// Whether a rig has a field of disparity errors beyond an offset. Estimating one where there is
// none costs accuracy, because its noise acts on the scale.

class FieldDecision {
 public:
  void reset() { *this = FieldDecision(); }
  /// `rms`: px, root mean square over the image of the field at a keyframe, without its offset, as
  /// it is (`is_on`) or would be if it were on. Returns whether it shall be on from the next
  /// keyframe on.
  ///
  /// A standard deviation of the window is no help: it is ten times too small. In exact towns the
  /// estimates had up to 0.08 px, on KITTI 06 and raw 0001 from the third keyframe on 0.19 px or
  /// more. 0.1 px is also the limit for rows.
  bool decide(bool is_on, double rms) {
    constexpr double kOn = 0.1;    // px
    constexpr double kOff = 0.05;  // px; chosen, not tuned
    constexpr int kKeyframes = 3;  // in a row; chosen, not tuned
    contradictions_ = (is_on ? rms < kOff : rms > kOn) ? contradictions_ + 1 : 0;
    if (contradictions_ < kKeyframes) return is_on;
    contradictions_ = 0;
    return !is_on;
  }

 private:
  int contradictions_ = 0;
};

// Errors of all disparities of a rig, as the window estimates them: an offset, and a smooth
// function over the right image. A wrong one makes depths wrong, and so the scale of the motion.

/// How static residuals of weight w lie in the image and in disparity d: sums of w, w d, w B and
/// w d B, B being the terms of the field.
template <class Scalar>
struct ScaleMoments {
  using Terms = Eigen::Matrix<Scalar, SmoothField::kTerms, 1>;
  Scalar weight = 0;
  Scalar disparity = 0;
  Terms terms = Terms::Zero();
  Terms products = Terms::Zero();

  void add(Scalar w, Scalar d, const Terms& B) {
    weight += w;
    disparity += w * d;
    terms += w * B;
    products += w * d * B;
  }
  template <class Other>
  void add(const ScaleMoments<Other>& other) {
    weight += static_cast<Scalar>(other.weight);
    disparity += static_cast<Scalar>(other.disparity);
    terms += other.terms.template cast<Scalar>();
    products += other.products.template cast<Scalar>();
  }
  /// Unit vector h: a field c, without its offset, is uncorrelated with disparity if h' c = 0. Then
  /// it does not act like a common factor of the disparities. Zero if nothing was added.
  Terms factorDirection() const {
    Terms h = products - terms * (disparity / std::max(weight, static_cast<Scalar>(1e-9)));
    h[0] = 0;
    return h.stableNormalized();
  }
};

/// A point of disparity d has column u - d + field in the right image. The offset, coefficient 0,
/// has two possible causes. If a camera has turned since the calibration, columns are displaced as
/// by a yaw, yaw (f + x^2 / f), at all disparities. What a calibration by least squares leaves is a
/// constant, which focal length and baseline compensate, so that disparities at the distance of the
/// calibration are right; it leaves other terms of the field, too, and they show how much of the
/// offset it can be. docs/report/odometry.md has the derivation.
class DisparityField {
 public:
  using Terms = SmoothField::Terms;

  /// Image size in px; focal length in px, and times baseline in px m; distance of the calibration
  /// in m, 0: an offset is always that of a turn. Off.
  void configure(int width, int height, double focal, double focal_baseline, double distance);
  /// Forgets the estimate.
  void clear();
  /// While it is off there is only the offset, as that of a turn, and the other coefficients are
  /// zero. Switching off sets them to zero.
  void setOn(bool on);
  bool isOn() const { return on_; }

  double offset() const { return first_ + change_[0]; }  ///< px
  /// Terms of the field at a column and row of the right image, for a point of this disparity. They
  /// are its derivatives by the coefficients, but for the change of the share of each cause: it
  /// follows the estimate, and is not estimated itself.
  Terms termsAt(double u, double v, double disparity) const;
  /// The field where these are its terms, px.
  double sum(const Terms& terms) const { return terms.dot(change_) + terms[0] * first_; }
  double at(double u, double v, double disparity) const { return sum(termsAt(u, v, disparity)); }
  const Terms& changes() const { return change_; }
  void move(const Terms& step);
  /// The value of the offset, px, from which the estimate starts and which its prior expects.
  void startFrom(double offset);

  /// The part of the offset of this field (at disparity 0) that calibration is expected to have
  /// left, 0 to 1.
  double calibrationShare(const SmoothField& field) const;
  /// Coefficients at disparity 0.
  SmoothField atInfinity() const;

 private:
  void updateShares();

  int width_ = 1;
  int height_ = 1;
  double focal_ = 1;
  double by_disparity_ = 0;   ///< 1/px, of an offset that calibration left
  double across_by_yaw_ = 0;  ///< coefficient of P_2(x) of a yaw whose mean over the image is 1
  bool on_ = false;
  double compensated_ = 0;  ///< 1/px, of the whole offset
  double across_ = 0;       ///< coefficient of P_2(x) of the whole offset
  double first_ = 0;        ///< px
  Terms change_ = Terms::Zero();
};

}  // namespace tolman::direct_sparse
