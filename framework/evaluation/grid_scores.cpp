// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "evaluation/firing_rate.hpp"
#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Fewest bins that a correlation is computed from (Sargolini et al. 2006).
constexpr double kMinOverlap = 20;
/// The central peak ends at the first minimum, or below this (Langston et al. 2010).
constexpr double kCentralPeak = 0.2;
/// Outer radius of the ring of the nearest peaks, relative to their distance.
constexpr double kNearest = 1.25;
constexpr int kMinReach = 4;          // bins
constexpr double kLongest = 2.0 / 3;  // largest displacement, share of the map's shorter side
constexpr std::size_t kAngles = 120;  // samples of a full turn
constexpr std::array<std::size_t, 4> kRotations = {10, 15, 20, 30};  // 30, 45, 60, 90 degrees

struct VisitedBin {
  int i, j;
  double rate;
};

std::vector<VisitedBin> visitedBins(const RateMap& map) {
  std::vector<VisitedBin> bins;
  for (Eigen::Index i = 0; i < map.rate.rows(); ++i) {
    for (Eigen::Index j = 0; j < map.rate.cols(); ++j) {
      if (map.visits(i, j) > 0) {
        bins.push_back({static_cast<int>(i), static_cast<int>(j), map.rate(i, j)});
      }
    }
  }
  return bins;
}

/// Mean of the autocorrelogram by distance in bins; NaN where all values are NaN.
std::vector<double> radialMean(const Eigen::MatrixXd& r, int reach) {
  std::vector<double> sum(static_cast<std::size_t>(reach) + 1, 0);
  std::vector<double> count(sum.size(), 0);
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      const auto distance = static_cast<std::size_t>(std::lround(std::hypot(i, j)));
      const double value = r(i + reach, j + reach);
      if (distance >= sum.size() || std::isnan(value)) continue;
      sum[distance] += value;
      count[distance] += 1;
    }
  }
  for (std::size_t d = 0; d < sum.size(); ++d) sum[d] = count[d] > 0 ? sum[d] / count[d] : kNan;
  return sum;
}

int centralPeak(const std::vector<double>& mean) {
  int d = 1;
  while (d + 1 < static_cast<int>(mean.size())) {
    const auto at = static_cast<std::size_t>(d);
    if (mean[at] < kCentralPeak || mean[at + 1] > mean[at]) break;
    ++d;
  }
  return d;
}

/// Distance of the nearest peaks: the first maximum beyond the central peak that is at least half
/// as high as the highest. Peaks farther out may have the higher mean.
int nearestPeaks(const std::vector<double>& mean, int centre) {
  const auto first = static_cast<std::size_t>(centre) + 1;
  const auto at = [&](std::size_t d) { return d < mean.size() && mean[d] > -1 ? mean[d] : -1; };
  std::size_t best = first;
  for (std::size_t d = first; d < mean.size(); ++d) {
    if (at(d) > at(best)) best = d;
  }
  for (std::size_t d = first; d < best; ++d) {
    const bool peak = at(d) >= at(d - 1) && at(d) >= at(d + 1);
    if (peak && at(d) >= 0.5 * at(best)) return static_cast<int>(d);
  }
  return static_cast<int>(best);
}

/// Whether no neighbour is higher. Neighbours that are NaN are ignored.
bool isPeak(const Eigen::MatrixXd& r, Eigen::Index i, Eigen::Index j) {
  const Eigen::Index top = std::max<Eigen::Index>(i - 1, 0);
  const Eigen::Index left = std::max<Eigen::Index>(j - 1, 0);
  const auto around =
      r.block(top, left, std::min(i + 2, r.rows()) - top, std::min(j + 2, r.cols()) - left);
  return !std::isnan(r(i, j)) && !(around.array() > r(i, j)).any();
}

/// A peak of the autocorrelogram, in bins from its centre.
struct Peak {
  Eigen::Vector2d at;
  double height;
  double distance() const { return at.norm(); }
};

/// The nearest peaks around the centre. `ring`, where the radial mean is highest, is farther away:
/// on a square lattice the diagonal neighbours contribute to it as well.
std::vector<Peak> peaksOf(const Eigen::MatrixXd& r, int reach, int ring) {
  constexpr double kInner = 0.6;     // of the ring
  constexpr double kTogether = 1.2;  // of the smallest distance
  std::vector<Peak> peaks;
  double highest = 0;
  for (Eigen::Index i = 0; i < r.rows(); ++i) {
    for (Eigen::Index j = 0; j < r.cols(); ++j) {
      const Peak peak{{static_cast<double>(i - reach), static_cast<double>(j - reach)}, r(i, j)};
      if (peak.distance() < kInner * ring || peak.distance() > kNearest * ring || !isPeak(r, i, j))
        continue;
      peaks.push_back(peak);
      highest = std::max(highest, peak.height);
    }
  }
  if (highest <= 0) return {};
  std::erase_if(peaks, [&](const Peak& peak) { return peak.height < 0.5 * highest; });
  const double nearest = std::ranges::min_element(peaks, {}, &Peak::distance)->distance();
  std::erase_if(peaks, [&](const Peak& peak) { return peak.distance() > kTogether * nearest; });
  return peaks;
}

/// Mean distance of the peaks, in bins; `ring` without any.
double peakDistance(const std::vector<Peak>& peaks, int ring) {
  double sum = 0;
  for (const Peak& peak : peaks) sum += peak.distance();
  return peaks.empty() ? ring : sum / static_cast<double>(peaks.size());
}

/// The top of the parabola through a peak and its neighbours, along each axis.
Eigen::Vector2d refined(const Eigen::MatrixXd& r, int reach, const Peak& peak) {
  const auto i = static_cast<Eigen::Index>(std::lround(peak.at.x())) + reach;
  const auto j = static_cast<Eigen::Index>(std::lround(peak.at.y())) + reach;
  if (i < 1 || j < 1 || i + 1 >= r.rows() || j + 1 >= r.cols()) return peak.at;
  const auto top = [&](double before, double after) {
    const double bend = before - 2 * peak.height + after;
    return bend < 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0;  // NaN: 0
  };
  return peak.at + Eigen::Vector2d(top(r(i - 1, j), r(i + 1, j)), top(r(i, j - 1), r(i, j + 1)));
}

/// Sets orientation and ellipticity by the tops of the peaks, of which each has its opposite.
void setShape(const std::vector<Eigen::Vector2d>& tops, GridScores& scores) {
  scores.orientation = scores.ellipticity = kNan;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector2d& top : tops) {
    const double angle =
        wrapPeriod(std::atan2(top.y(), top.x()) + 1e-9, kRadiansOfTurn);  // 0, not a full turn
    scores.orientation = std::fmin(scores.orientation, std::max(angle - 1e-9, 0.0));
    const Eigen::Vector3d row(top.x() * top.x(), 2 * top.x() * top.y(), top.y() * top.y());
    normal += row * row.transpose();
    sum += row;
  }
  if (tops.size() < 6) return;
  const Eigen::Vector3d c = normal.ldlt().solve(sum);  // x^T C x = 1
  const double mean = (c.x() + c.z()) / 2;
  const double spread = std::hypot((c.x() - c.z()) / 2, c.y());
  if (mean > spread) scores.ellipticity = std::sqrt((mean + spread) / (mean - spread));
}

double interpolated(const Eigen::MatrixXd& r, double x, double y) {
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto at = [&](double row, double column) {
    const auto last = static_cast<double>(r.rows() - 1);
    return r(static_cast<Eigen::Index>(std::clamp(row, 0.0, last)),
             static_cast<Eigen::Index>(std::clamp(column, 0.0, last)));
  };
  const double u = x - i;
  const double v = y - j;
  return (1 - u) * ((1 - v) * at(i, j) + v * at(i, j + 1)) +
         u * ((1 - v) * at(i + 1, j) + v * at(i + 1, j + 1));
}

/// Correlations of a growing ring with itself after the rotations.
using RingSums = std::array<Correlation, kRotations.size()>;

void grow(RingSums& sums, const Eigen::MatrixXd& r, int reach, int radius) {
  std::array<double, kAngles> values;
  for (std::size_t k = 0; k < kAngles; ++k) {
    const double angle = static_cast<double>(k) * 2 * std::numbers::pi / kAngles;
    values.at(k) =
        interpolated(r, reach + radius * std::cos(angle), reach + radius * std::sin(angle));
  }
  for (std::size_t rotation = 0; rotation < sums.size(); ++rotation) {
    for (std::size_t k = 0; k < kAngles; ++k) {
      const double x = values.at(k), y = values.at((k + kRotations.at(rotation)) % kAngles);
      if (!std::isnan(x) && !std::isnan(y)) sums.at(rotation).add(x, y, radius);
    }
  }
}

}  // namespace

/// Sums over pairs of visited bins, because a path visits only few bins.
Eigen::MatrixXd autocorrelogram(const RateMap& map, int reach) {
  const int side = 2 * reach + 1;
  const std::vector<VisitedBin> bins = visitedBins(map);
  std::vector<Correlation> sums(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (std::size_t a = 0; a < bins.size(); ++a) {
    for (std::size_t b = a; b < bins.size() && bins[b].i - bins[a].i <= reach; ++b) {
      const int di = bins[b].i - bins[a].i;
      const int dj = bins[b].j - bins[a].j;
      if (std::abs(dj) > reach) continue;
      sums[static_cast<std::size_t>((di + reach) * side + dj + reach)].add(bins[a].rate,
                                                                           bins[b].rate);
    }
  }
  Eigen::MatrixXd r = Eigen::MatrixXd::Constant(side, side, kNan);
  for (int di = 0; di <= reach; ++di) {
    for (int dj = di == 0 ? 0 : -reach; dj <= reach; ++dj) {
      const Correlation& sum = sums[static_cast<std::size_t>((di + reach) * side + dj + reach)];
      if (sum.n < kMinOverlap) continue;
      r(reach + di, reach + dj) = r(reach - di, reach - dj) = sum.value();
    }
  }
  return r;
}

std::optional<GridScores> gridScores(const RateMap& map) {
  const auto shorter = static_cast<double>(std::min(map.rate.rows(), map.rate.cols()));
  const int reach = static_cast<int>(kLongest * shorter);
  if (reach < kMinReach) return std::nullopt;
  const Eigen::MatrixXd r = autocorrelogram(map, reach);
  if (std::isnan(r(reach, reach))) return std::nullopt;
  const std::vector<double> mean = radialMean(r, reach);
  const int centre = centralPeak(mean);
  const int nearest = nearestPeaks(mean, centre);
  const int outer = std::min(reach, static_cast<int>(std::lround(kNearest * nearest)));
  const std::vector<Peak> peaks = peaksOf(r, reach, nearest);
  std::vector<Eigen::Vector2d> tops;
  for (const Peak& peak : peaks) tops.push_back(refined(r, reach, peak));
  GridScores scores{0, kNan, 0, peakDistance(peaks, nearest) * map.bin};
  setShape(tops, scores);
  RingSums sums;
  const auto after = [&](std::size_t rotation) { return sums.at(rotation).value(); };
  for (int radius = centre + 1; radius <= reach; ++radius) {
    grow(sums, r, reach, radius);
    const double most = after(0) > after(3) ? after(0) : after(3);
    const double hexagonal = std::isnan(after(0)) ? kNan : after(2) - most;
    if (radius > centre + 1) scores.langston = std::fmax(scores.langston, hexagonal);
    if (radius != outer) continue;
    scores.sargolini = hexagonal;
    scores.square = after(3) - after(1);
  }
  const bool known =
      !std::isnan(scores.langston) && !std::isnan(scores.sargolini) && !std::isnan(scores.square);
  return known ? std::optional(scores) : std::nullopt;
}

}  // namespace tolman::evaluation
