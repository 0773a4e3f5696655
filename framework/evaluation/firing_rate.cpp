// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/firing_rate.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace tolman::evaluation {

namespace {

double wrapped(double angle) {
  const double rest = std::fmod(angle, kRadiansOfTurn);
  return rest < 0 ? rest + kRadiansOfTurn : rest;
}

/// Gives the bins of the connected field around bin (r, c), which are -1, the number of the field.
void numberField(Eigen::MatrixXi& field, Eigen::Index r, Eigen::Index c, int number) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> open{{r, c}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (i < 0 || j < 0 || i >= field.rows() || j >= field.cols() || field(i, j) >= 0) continue;
    field(i, j) = number;
    for (Eigen::Index di = -1; di <= 1; ++di) {
      for (Eigen::Index dj = -1; dj <= 1; ++dj) open.emplace_back(i + di, j + dj);
    }
  }
}

/// Rates of a circle of bins; bins without visits are interpolated between their neighbours.
std::vector<double> interpolated(const std::vector<double>& rate,
                                 const std::vector<double>& visits) {
  const std::size_t size = rate.size();
  const auto nearest = [&](std::size_t from, std::size_t step) {
    std::size_t away = 0;
    while (!(visits[(from + away * step) % size] > 0)) ++away;
    return away;
  };
  std::vector<double> whole = rate;
  for (std::size_t i = 0; i < size; ++i) {
    if (visits[i] > 0) continue;
    const std::size_t after = nearest(i, 1);
    const std::size_t before = nearest(i, size - 1);
    const double share = static_cast<double>(before) / static_cast<double>(before + after);
    whole[i] =
        (1 - share) * rate[(i + before * (size - 1)) % size] + share * rate[(i + after) % size];
  }
  return whole;
}

/// Number of bins from the peak to where the curve falls to half of it; `step` is the direction.
double binsToHalf(const std::vector<double>& rate, std::size_t peak, std::size_t step) {
  const double half = 0.5 * rate[peak];
  double last = rate[peak];
  for (std::size_t away = 1; away <= rate.size() / 2; ++away) {
    const double here = rate[(peak + away * step) % rate.size()];
    if (here < half) return static_cast<double>(away) - (half - here) / (last - here);
    last = here;
  }
  return static_cast<double>(rate.size()) / 2;
}

std::optional<double> halfWidth(const TuningCurve& curve, const std::vector<double>& visits) {
  const auto visited = std::ranges::count_if(visits, [](double count) { return count > 0; });
  const std::size_t size = visits.size();
  if (2 * static_cast<std::size_t>(visited) < size) return std::nullopt;
  const std::vector<double> rate = interpolated(curve.rate, visits);
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(rate) - rate.begin());
  if (!(rate[peak] > 0)) return std::nullopt;
  const double bins = 0.5 * (binsToHalf(rate, peak, 1) + binsToHalf(rate, peak, size - 1));
  return bins * kRadiansOfTurn / static_cast<double>(size);
}

}  // namespace

RateMap rateMap(const std::vector<Sample>& samples, int bins_on_the_long_side) {
  RateMap map;
  Eigen::AlignedBox2d box;
  for (const Sample& sample : samples) box.extend(sample.position);
  if (box.isEmpty() || !box.sizes().allFinite()) return map;
  map.corner = box.min();
  map.bin = std::max(box.sizes().maxCoeff() / bins_on_the_long_side, 1e-6);
  const auto bins = [&](double length) { return static_cast<Eigen::Index>(length / map.bin) + 1; };
  map.rate = Eigen::MatrixXd::Zero(bins(box.sizes().x()), bins(box.sizes().y()));
  map.visits = map.rate;
  for (const Sample& sample : samples) {
    const Eigen::Vector2d place = (sample.position - map.corner) / map.bin;
    const auto right = static_cast<Eigen::Index>(place.x());
    const auto forward = static_cast<Eigen::Index>(place.y());
    map.rate(right, forward) += sample.rate * sample.seconds;
    map.visits(right, forward) += sample.seconds;
  }
  map.rate = map.rate.binaryExpr(map.visits, [](double sum, double count) {
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
  });
  return map;
}

RateMap smoothed(const RateMap& map, double sigma) {
  const auto reach = static_cast<Eigen::Index>(std::ceil(3 * sigma));
  const auto along = [&](const Eigen::MatrixXd& values) {  // sums over the columns' neighbours
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(values.rows(), values.cols());
    for (Eigen::Index d = -reach; d <= reach; ++d) {
      const Eigen::Index count = values.cols() - std::abs(d);
      if (count <= 0) continue;
      const double weight = std::exp(-0.5 * static_cast<double>(d * d) / (sigma * sigma));
      sum.middleCols(std::max<Eigen::Index>(-d, 0), count) +=
          weight * values.middleCols(std::max<Eigen::Index>(d, 0), count);
    }
    return sum;
  };
  const auto spread = [&](const Eigen::MatrixXd& values) -> Eigen::MatrixXd {
    return along(along(values).transpose()).transpose();
  };
  const Eigen::ArrayXXd activity = (map.visits.array() > 0).select(map.rate.array(), 0);
  RateMap result = map;
  const Eigen::ArrayXXd time = spread(map.visits).array();
  result.rate = (map.visits.array() > 0)
                    .select(spread(activity * map.visits.array()).array() / time, map.rate.array());
  return result;
}

double highestRate(const RateMap& map) {
  double highest = 0;
  for (const double rate : map.rate.reshaped())
    highest = std::isnan(rate) ? highest : std::max(highest, rate);
  return highest;
}

TuningCurve tuningCurve(const std::vector<Sample>& samples, int bins) {
  TuningCurve curve;
  const auto size = static_cast<std::size_t>(bins);
  curve.rate.assign(size, 0);
  std::vector<double> visits(size, 0);
  for (const Sample& sample : samples) {
    const auto bin = std::min(
        static_cast<std::size_t>(wrapped(sample.heading) / kRadiansOfTurn * bins), size - 1);
    curve.rate[bin] += sample.rate * sample.seconds;
    visits[bin] += sample.seconds;
  }
  std::complex<double> sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (visits[i] > 0) curve.rate[i] /= visits[i];
    const double centre = (static_cast<double>(i) + 0.5) / bins * kRadiansOfTurn;
    sum += std::polar(1.0, centre) * curve.rate[i];
    total += curve.rate[i];
  }
  if (total > 0) curve.mean_vector_length = std::abs(sum) / total;
  curve.preferred = wrapped(std::arg(sum));
  curve.half_width = halfWidth(curve, visits);
  return curve;
}

double spatialInformation(const RateMap& map) {
  const double visits = map.visits.sum();
  if (!(visits > 0)) return 0;
  double mean = 0;
  for (Eigen::Index i = 0; i < map.rate.size(); ++i) {
    if (map.visits(i) > 0) mean += map.visits(i) / visits * map.rate(i);
  }
  if (!(mean > 0)) return 0;
  double bits = 0;
  for (Eigen::Index i = 0; i < map.rate.size(); ++i) {
    const double ratio = map.visits(i) > 0 ? map.rate(i) / mean : 0;
    if (ratio > 0) bits += map.visits(i) / visits * ratio * std::log2(ratio);
  }
  return bits;
}

FieldBins fieldBins(const RateMap& map, double share) {
  const double highest = highestRate(map);
  FieldBins found;
  found.field = map.rate.unaryExpr(
      [&](double rate) { return highest > 0 && rate > share * highest ? -1 : 0; });
  for (Eigen::Index i = 0; i < found.field.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.field.cols(); ++j) {
      if (found.field(i, j) < 0) numberField(found.field, i, j, ++found.count);
    }
  }
  return found;
}

std::vector<Eigen::Vector2d> fields(const RateMap& map, double share) {
  const FieldBins found = fieldBins(map, share);
  std::vector<Eigen::Vector3d> sums(static_cast<std::size_t>(found.count), Eigen::Vector3d::Zero());
  for (Eigen::Index i = 0; i < found.field.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.field.cols(); ++j) {
      if (found.field(i, j) == 0) continue;
      sums[static_cast<std::size_t>(found.field(i, j) - 1)] +=
          map.rate(i, j) * Eigen::Vector3d(static_cast<double>(i), static_cast<double>(j), 1);
    }
  }
  std::vector<Eigen::Vector2d> centres;
  for (const Eigen::Vector3d& sum : sums) {
    const Eigen::Vector2d place = sum.head<2>() / sum.z() + Eigen::Vector2d::Constant(0.5);
    centres.emplace_back(map.corner + map.bin * place);
  }
  return centres;
}

namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

void Correlation::add(double x, double y, double weight) {
  n += weight;
  a += weight * x;
  b += weight * y;
  aa += weight * x * x;
  bb += weight * y * y;
  ab += weight * x * y;
}

double Correlation::value() const {
  const double spread = (n * aa - a * a) * (n * bb - b * b);
  return spread > 1e-12 * n * aa * n * bb ? (n * ab - a * b) / std::sqrt(spread) : kNan;
}

namespace {

/// Fewest bins that a correlation is computed from (Sargolini et al. 2006).
constexpr double kMinOverlap = 20;
/// The central peak ends at the first minimum, or where correlation falls below this (Langston et
/// al. 2010).
constexpr double kCentralPeak = 0.2;
/// Outer radius of the ring of the nearest peaks, relative to their distance.
constexpr double kNearest = 1.25;
constexpr int kMinReach = 4;          // bins
constexpr double kLongest = 2.0 / 3;  // largest displacement, share of the map's shorter side
constexpr int kAngles = 120;          // samples of a full turn
constexpr std::array<int, 4> kRotations = {10, 15, 20, 30};  // 30, 45, 60, 90 degrees

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
  if (std::isnan(r(i, j))) return false;
  for (Eigen::Index a = std::max<Eigen::Index>(i - 1, 0); a <= std::min(i + 1, r.rows() - 1); ++a) {
    for (Eigen::Index b = std::max<Eigen::Index>(j - 1, 0); b <= std::min(j + 1, r.cols() - 1);
         ++b) {
      if (r(a, b) > r(i, j)) return false;
    }
  }
  return true;
}

/// A peak of the autocorrelogram, in bins from its centre.
struct Peak {
  Eigen::Vector2d at;
  double height;
  double distance() const { return at.norm(); }
};

/// The nearest peaks around the centre. `ring` is the distance at which the radial mean has its
/// maximum. It is larger than theirs, because on a square lattice the diagonal neighbours
/// contribute to the radial mean as well.
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
    const double angle = wrapped(std::atan2(top.y(), top.x()) + 1e-9);  // 0, not a full turn
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
class RotatedRing {
 public:
  RotatedRing(const Eigen::MatrixXd& r, int reach) : r_(r), reach_(reach) {}

  void grow(int radius) {
    std::array<double, kAngles> values;
    for (int k = 0; k < kAngles; ++k) {
      const double angle = k * 2 * std::numbers::pi / kAngles;
      values.at(static_cast<std::size_t>(k)) =
          interpolated(r_, reach_ + radius * std::cos(angle), reach_ + radius * std::sin(angle));
    }
    for (std::size_t rotation = 0; rotation < kRotations.size(); ++rotation) {
      for (int k = 0; k < kAngles; ++k) {
        const double x = values.at(static_cast<std::size_t>(k));
        const double y =
            values.at(static_cast<std::size_t>((k + kRotations.at(rotation)) % kAngles));
        if (!std::isnan(x) && !std::isnan(y)) sums_.at(rotation).add(x, y, radius);
      }
    }
  }
  double hexagonal() const {
    const double most = after(0) > after(3) ? after(0) : after(3);
    return std::isnan(after(0)) ? kNan : after(2) - most;
  }
  double square() const { return after(3) - after(1); }

 private:
  double after(std::size_t rotation) const { return sums_.at(rotation).value(); }
  const Eigen::MatrixXd& r_;
  int reach_;
  std::array<Correlation, kRotations.size()> sums_;
};

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
  RotatedRing ring(r, reach);
  for (int radius = centre + 1; radius <= reach; ++radius) {
    ring.grow(radius);
    const double hexagonal = ring.hexagonal();
    if (radius > centre + 1) scores.langston = std::fmax(scores.langston, hexagonal);
    if (radius != outer) continue;
    scores.sargolini = hexagonal;
    scores.square = ring.square();
  }
  const bool known =
      !std::isnan(scores.langston) && !std::isnan(scores.sargolini) && !std::isnan(scores.square);
  return known ? std::optional(scores) : std::nullopt;
}

}  // namespace tolman::evaluation
