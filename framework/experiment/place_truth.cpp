// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/must.hpp"
#include "base/text_file.hpp"
#include "config/values.hpp"
#include "experiment/bench.hpp"
#include "report/axes.hpp"

namespace tolman::experiment {
namespace {

using evaluation::Heading;
using evaluation::Trajectory;
using Images = std::set<std::int64_t>;
using Pairs = std::set<std::pair<std::int64_t, std::int64_t>>;

evaluation::RevisitRule ruleFor(double height_m) {
  evaluation::RevisitRule rule;
  rule.height_m = height_m;
  return rule;
}

/// The images that return to a place in this direction.
Images returning(const Trajectory& truth, const evaluation::RevisitRule& rule, Heading heading) {
  Images images;
  for (const evaluation::Revisit& revisit : evaluation::findRevisits(truth, rule)) {
    if (revisit.heading == heading) images.insert(revisit.frame);
  }
  return images;
}

}  // namespace

const evaluation::TrajectoryPose* poseOf(const Trajectory& truth, std::int64_t image) {
  const auto found = std::ranges::lower_bound(truth, image, {}, &evaluation::TrajectoryPose::frame);
  return found == truth.end() || found->frame != image ? nullptr : &*found;
}

PlaceTruth truthByNumber(std::int64_t images_of_first_pass, std::int64_t tolerance) {
  return {
      [=](std::int64_t query, std::int64_t place) { return std::abs(query - place) <= tolerance; },
      [=](std::int64_t query) { return query < images_of_first_pass + tolerance; }, -1};
}

Result<PlaceTruth> truthOfPairs(const std::filesystem::path& file, std::int64_t near) {
  return resultOf([&] {
    const auto pairs = std::make_shared<Pairs>();
    std::size_t number = 0;
    const auto refuse = [&](const std::string& why) {
      must(Status::invalidInput(file.string() + ":" + std::to_string(number) + ": " + why));
    };
    for (const std::vector<std::string>& line : csvRows(must(text_encoding::readText(file)))) {
      if (++number == 1 && line == std::vector<std::string>{"query", "match"}) continue;
      std::vector<std::int64_t> images;
      for (const std::string& field : line) {
        const auto image = config::readInteger(field);
        if (image.isOk() && image.value() >= 0) images.push_back(image.value());
      }
      if (line.size() != 2 || images.size() != 2) {
        refuse("a pair is two numbers of images, 'query,match'");
      }
      if (images[1] >= images[0]) refuse("the match must be an earlier image than the query");
      pairs->emplace(images[0], images[1]);
    }
    if (pairs->empty()) {
      must(Status::invalidInput(file.string() + ": lists no pairs; each line is 'query,match'"));
    }
    return PlaceTruth{[pairs](std::int64_t query, std::int64_t place) {
                        return pairs->contains({query, place});
                      },
                      [pairs, near](std::int64_t query) {
                        const auto earliest = pairs->lower_bound({query, INT64_MIN});
                        return earliest != pairs->end() && earliest->first == query &&
                               query - earliest->second > near;
                      },
                      pairs->rbegin()->first};
  });
}

PlaceTruth truthOfPoses(const Trajectory& truth, double height_m, std::int64_t near) {
  struct Drive {
    evaluation::RevisitRule rule;
    Trajectory truth;
    std::vector<double> path;
    Images findable;
  };
  const evaluation::RevisitRule rule = ruleFor(height_m);
  const auto drive = std::make_shared<const Drive>(
      Drive{rule, truth, evaluation::distances(truth), returning(truth, rule, Heading::Same)});
  const auto isSame = [drive](std::int64_t query, std::int64_t place) {
    const auto* const q = poseOf(drive->truth, query);
    const auto* const p = poseOf(drive->truth, place);
    if (q == nullptr || p == nullptr) return false;
    const auto pathOf = [&](const auto* pose) {
      return drive->path[static_cast<std::size_t>(pose - drive->truth.data())];
    };
    if (pathOf(q) - pathOf(p) <= drive->rule.path_m) return false;
    return evaluation::isSamePlace(q->T_world_camera, p->T_world_camera, drive->rule) &&
           evaluation::headingBetween(q->T_world_camera, p->T_world_camera, drive->rule) ==
               Heading::Same;
  };
  const auto isFindable = [drive, isSame, near](std::int64_t query) {
    if (!drive->findable.contains(query)) return false;
    for (std::int64_t place = 0; place < query - near; ++place) {
      if (isSame(query, place)) return true;
    }
    return false;
  };
  return {isSame, isFindable};
}

std::int64_t OppositePlaces::right() const {
  return std::ranges::count_if(claims, &evaluation::PlaceClaim::right);
}

double OppositePlaces::medianError() const {
  std::vector<double> errors;
  for (const evaluation::PlaceClaim& claim : claims) {
    if (claim.right) errors.push_back(claim.error_m);
  }
  std::ranges::sort(errors);
  return errors.empty() ? 0 : errors[errors.size() / 2];
}

OppositePlaces judgeOpposite(const Trajectory& truth, std::vector<evaluation::PlaceClaim> claims,
                             double height_m) {
  const evaluation::RevisitRule rule = ruleFor(height_m);
  OppositePlaces places{0, 0, std::move(claims)};
  for (evaluation::PlaceClaim& claim : places.claims) {
    const Eigen::Isometry3d& place = poseOf(truth, claim.place)->T_world_camera;
    const Eigen::Isometry3d& query = poseOf(truth, claim.query)->T_world_camera;
    const Eigen::Isometry3d claimed = place * claim.T_place_query;
    claim.error_m = (claimed.translation() - query.translation()).norm();
    claim.right = evaluation::headingBetween(place, query, rule) == Heading::Opposite &&
                  evaluation::isSamePlace(claimed, query, rule);
  }
  const std::vector<double> path = evaluation::distances(truth);
  const auto pathOf = [&](std::int64_t image) {
    return path[static_cast<std::size_t>(poseOf(truth, image) - truth.data())];
  };
  const Images same = returning(truth, rule, Heading::Same);
  for (const std::int64_t image : returning(truth, rule, Heading::Opposite)) {
    if (same.contains(image)) continue;
    ++places.findable;
    places.found += std::ranges::any_of(places.claims, [&](const evaluation::PlaceClaim& claim) {
      const double since = pathOf(image) - pathOf(claim.query);
      return claim.right && claim.query <= image && since <= rule.distance_m;
    });
  }
  return places;
}

Result<PlaceCurve> placeCurveOf(const std::filesystem::path& file) {
  using Json = nlohmann::json;
  const Result<std::string> text = text_encoding::readText(file);
  if (!text.isOk()) return text.status();
  const Status refusal =
      Status::invalidInput(file.string() + ": is not what `tolman bench places --json` prints");
  try {
    const Json measured = Json::parse(text.value(), nullptr, false);
    PlaceCurve curve{measured.at("name").get<std::string>(), {}};
    for (const Json& point : measured.at("rows").get_ref<const Json::array_t&>()) {
      const auto precision = point.at("precision").get<double>();
      const auto recall = point.at("recall").get<double>();
      if (std::min(precision, recall) < 0 || std::max(precision, recall) > 1) return refusal;
      curve.points.push_back({0, 0, precision, recall});
    }
    return curve;
  } catch (const Json::exception&) {
    return refusal;
  }
}

std::string placeCurvesFigure(const std::vector<PlaceCurve>& curves) {
  std::vector<report::Curve> lines;
  for (const PlaceCurve& curve : curves) {
    report::Curve line{curve.name, report::lineColour(lines.size()), {}, {}, 2};
    for (const auto& point : curve.points) {
      line.x.push_back(point.recall);
      line.y.push_back(point.precision);
    }
    lines.push_back(std::move(line));
  }
  return report::curveFigure({"Places recognised", "recall", "precision", {0, 1}, {0, 1.03}, {}},
                             std::move(lines), {560, 420});
}

}  // namespace tolman::experiment
