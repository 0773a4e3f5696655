// SPDX-License-Identifier: BSD-3-Clause
#include "host/values.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "config/text.hpp"
#include "tolman/geometry.hpp"

namespace tolman::host {

namespace {

Status checkImage(const Image& image, const CameraRig& rig, const char* side) {
  const int width = image.width();
  const int height = image.height();
  if (image.empty()) {
    if (width == 0 && height == 0) return Status::ok();
    return Status::failed(
        fmt::format("the {} image has {}x{} px and no data", side, width, height));
  }
  if (width != rig.width || height != rig.height) {
    return Status::invalidInput(fmt::format("an image of {}x{} px; the rig has {}x{}", width,
                                            height, rig.width, rig.height));
  }
  if (image.format() != PixelFormat::Gray8 && image.format() != PixelFormat::Bgr8) {
    return Status::failed(fmt::format("the {} image has an unknown pixel format", side));
  }
  const std::ptrdiff_t row = std::ptrdiff_t{width} * bytesPerPixel(image.format());
  if (image.stride() >= row) return Status::ok();
  return Status::failed(fmt::format("the {} image has rows of {} bytes and a stride of {}", side,
                                    row, image.stride()));
}

}  // namespace

Status checkImages(const Frame& frame, const CameraRig& rig) {
  Status status = checkImage(frame.left, rig, "left");
  if (status.isOk()) status = checkImage(frame.right, rig, "right");
  if (!status.isOk() || !rig.isStereo()) return status;
  if (frame.left.empty() != frame.right.empty()) {
    return Status::failed(
        fmt::format("only the {} image of a pair; give both, or none and a 'defect' that says why",
                    frame.left.empty() ? "right" : "left"));
  }
  if (frame.left.empty() || frame.left.format() == frame.right.format()) return status;
  return Status::failed("the images of a pair have different pixel formats");
}

Status checkRig(const CameraRig& rig) {
  if (rig.width < 0 || rig.height < 0 || (rig.width == 0) != (rig.height == 0)) {
    return Status::invalidInput(
        fmt::format("the cameras have images of {}x{} px; give their width and height, or 0 and 0 "
                    "where there are no images",
                    rig.width, rig.height));
  }
  if (rig.baseline < 0) {
    return Status::invalidInput(
        fmt::format("the baseline of the cameras is {:.5g} m; it is the distance of the right "
                    "camera to the right of the left one: exchange the two cameras if they are "
                    "the wrong way round, or give 0 for a single one",
                    rig.baseline));
  }
  if (!rig.calibrated || (rig.pinhole.fx > 0 && rig.pinhole.fy > 0)) return Status::ok();
  return Status::invalidInput(fmt::format(
      "the focal lengths of the cameras are {:.5g} and {:.5g} px; they must be above 0: "
      "correct the calibration, or set `calibrated` to false where they are not known",
      rig.pinhole.fx, rig.pinhole.fy));
}

namespace {

Status checkName(std::string_view name) {
  const bool fits = !name.empty() && name.size() <= kLongestName;
  if (fits && config::isPrintable(name)) return Status::ok();
  return Status::failed(
      fmt::format("the array name '{}' is not of 1 to {} bytes of UTF-8 without control characters",
                  config::printable(name.substr(0, kLongestName)), kLongestName));
}

Status checkArray(const NamedArray& array) {
  if (Status status = checkName(array.name); !status.isOk()) return status;
  if (!shapeFits(array.shape, array.values.size())) {
    return Status::failed("array '" + array.name + "' has a size that differs from its shape");
  }
  if (std::ranges::all_of(array.values, [](float value) { return std::isfinite(value); })) {
    return Status::ok();
  }
  return Status::failed("array '" + array.name +
                        "' has NaN, infinity or a number beyond 3.4e38, the largest of 32 bits");
}

/// Whether two shapes differ at most in the length of the first axis.
bool differInLength(std::span<const int> a, std::span<const int> b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::ranges::equal(a.subspan(1), b.subspan(1));
}

Status changedShape(const NamedArray& array) {
  return Status::failed("array '" + array.name + "' changed its shape");
}

/// Checks the number of arrays, each array, and that names are unique.
template <class Named, class CheckOne>
Status checkEach(std::span<const Named> all, const CheckOne& check_one) {
  if (all.size() > kMaxArrays) {
    return Status::failed(fmt::format("{} arrays; at most {} are allowed", all.size(), kMaxArrays));
  }
  std::set<std::string_view> names;
  for (const Named& one : all) {
    if (Status status = check_one(one); !status.isOk()) return status;
    if (!names.insert(one.name).second) {
      return Status::failed("array '" + one.name + "' is given twice");
    }
  }
  return Status::ok();
}

}  // namespace

Status checkArrays(const std::vector<NamedArray>& arrays) {
  return checkEach(std::span(arrays), checkArray);
}

Status checkDescriptions(std::span<const ArrayInfo> arrays) {
  return checkEach(arrays, [](const ArrayInfo& info) {
    const Status status = checkName(info.name);
    return status.isOk() ? checkValues(info) : status;
  });
}

Status ArrayShapes::checkShapes(const std::vector<NamedArray>& arrays) {
  if (Status status = checkArrays(arrays); !status.isOk()) return status;
  for (const NamedArray& array : arrays) {
    const auto& [known, is_new] = known_.emplace(array.name, array.shape);
    if (!is_new && !differInLength(known->second, array.shape)) return changedShape(array);
  }
  return Status::ok();
}

Status ArrayShapes::check(const std::vector<NamedArray>& arrays) {
  if (Status status = checkArrays(arrays); !status.isOk()) return status;
  const bool is_first = known_.empty();
  std::size_t same = 0;
  for (const NamedArray& array : arrays) {
    const auto& [known, is_new] = known_.emplace(array.name, array.shape);
    if (is_new && !is_first) {
      return Status::failed("array '" + array.name +
                            "' was not there before; the names stay the same over a run");
    }
    if (known->second != array.shape) return changedShape(array);
    ++same;
  }
  if (same == known_.size()) return Status::ok();
  const auto missing = std::ranges::find_if(known_, [&](const auto& known) {
    return std::ranges::find(arrays, known.first, &NamedArray::name) == arrays.end();
  });
  return Status::failed("array '" + missing->first +
                        "' is missing; the names stay the same over a run");
}

namespace {

template <class... T>
Status failed(fmt::format_string<const T&...> text, const T&... values) {
  return Status::failed(fmt::format(text, values...));
}

/// Checks the covariance of a relative pose. Zero is refused: the map would treat the pose as
/// exact.
Status checkMeasured(const Matrix6d& covariance, const char* field) {
  if (covariance.trace() != 0) return checkCovariance(covariance, field);
  return failed("'{}' is zero, which claims an exact pose; set it", field);
}

/// A difference of two headings. Larger values are in degrees, or are sums that were not wrapped.
Status checkRelativeYaw(double relative_yaw) {
  if (std::abs(relative_yaw) <= 2 * std::numbers::pi) return Status::ok();
  return failed("relative_yaw {:g} is not in [-2 pi, 2 pi]; it is in rad, not degrees",
                relative_yaw);
}

Status checkHeading(double heading) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (heading >= 0 && heading < kTurn) return Status::ok();
  if (heading >= kTurn && heading < kTurn + 1e-6) {  // as the remainder of a small negative angle
    return failed("heading is 2 pi, which is not in [0, 2 pi); answer 0");
  }
  return failed("heading {:f} is not in [0, 2 pi)", heading);
}

Status checkEarlier(const EarlierLoop& loop, std::int64_t frame, std::int64_t experiences) {
  if (loop.frame < 0 || loop.frame >= frame) {
    return failed("answered a loop of frame {}, which is not an earlier frame", loop.frame);
  }
  if (loop.experience < 0 || loop.experience >= experiences) {
    return failed("answered a loop of frame {} to experience {}, which does not exist", loop.frame,
                  loop.experience);
  }
  return checkMeasured(loop.covariance, "earlier.covariance");
}

Status checkExperience(const Decision& decision, std::int64_t experiences, std::int64_t last) {
  const std::int64_t id = decision.experience;
  if (decision.template_id < -1) {
    return failed("decided by template {}; -1 for none", decision.template_id);
  }
  const bool stays = decision.action == Action::Stay;
  if (decision.action == Action::CreateExperience) {
    if (id == experiences) return Status::ok();
    return failed("created experience {}; ids are 0, 1, 2, ... without gaps, the next one is {}",
                  id, experiences);
  }
  if (id < (stays ? -1 : 0) || id >= experiences) {
    return failed("decided for experience {}, which does not exist", id);
  }
  if (!stays || last < -1 || id == last) return Status::ok();
  return failed("stays at experience {}, but was at {}", id, last);
}

bool isPast(std::int64_t frame, const KnownMap& known) {
  return frame >= 0 && frame <= known.newest_frame;
}

Status checkExperience(const Experience& experience, std::int64_t id, const KnownMap& known) {
  if (experience.id != id)
    return failed(
        "experience {} of the graph has the id {}; ids are 0, 1, 2, ... without gaps, in this "
        "order",
        id, experience.id);
  if (!isPast(experience.frame, known)) {
    return failed("experience {} was made at frame {}, which is not a past frame", id,
                  experience.frame);
  }
  if (experience.template_id < -1) {
    return failed("experience {} has template {}; -1 for none", id, experience.template_id);
  }
  if (experience.template_id >= known.templates) {
    return failed("experience {} has template {}, which no decision named", id,
                  experience.template_id);
  }
  return checkValues(experience);
}

Status checkLink(const Link& link, std::int64_t experiences, const KnownMap& known) {
  const auto exists = [&](std::int64_t id) { return id >= 0 && id < experiences; };
  if (!exists(link.from) || !exists(link.to)) {
    return failed("link {} has an unknown experience", link.id);
  }
  if (!isPast(link.frame, known)) {
    return failed("link {} was made at frame {}, which is not a past frame", link.id, link.frame);
  }
  if (Status status = checkValues(link); !status.isOk()) return status;
  constexpr double kLongest = 1e9;  // s; three decades, chosen
  if (link.duration < 0 || link.duration > kLongest) {
    return failed("link {} has a duration of {:g} s", link.id, link.duration);
  }
  if (link.weight < 0 || link.weight > 1) {
    return failed("link {} has a weight of {}, which is not in [0, 1]", link.id, link.weight);
  }
  return checkCovariance(link.covariance, "covariance");
}

Status checkCounts(const MapGraph& graph, const KnownMap& known) {
  const auto loops = std::ranges::count(graph.links, LinkKind::Loop, &Link::kind);
  const auto differs = [](std::int64_t count, std::int64_t told) {
    return told >= 0 && count != told;
  };
  if (differs(std::ssize(graph.experiences), known.experiences)) {
    return failed("the graph has {} experiences, the last update {}", graph.experiences.size(),
                  known.experiences);
  }
  if (differs(std::ssize(graph.links), known.links)) {
    return failed("the graph has {} links, the last update {}", graph.links.size(), known.links);
  }
  if (!differs(loops, known.loops)) return Status::ok();
  return failed("the graph has {} loop links, the last update {}", loops, known.loops);
}

Status checkRejected(const MapGraph& graph) {
  const auto links = static_cast<std::int64_t>(graph.links.size());
  std::int64_t last = -1;
  for (const std::int64_t id : graph.rejected) {
    if (id <= last) return failed("the ids of rejected links are not ascending from 0");
    last = id;
    const bool is_loop =
        id < links && graph.links[static_cast<std::size_t>(id)].kind == LinkKind::Loop;
    if (!is_loop) return failed("rejected link {} is no loop link of the graph", id);
  }
  return Status::ok();
}

}  // namespace

Status checkCovariance(const Matrix6d& covariance, const char* field) {
  const double size = covariance.cwiseAbs().maxCoeff();
  if (size == 0) return Status::ok();
  constexpr double kMax = 1e36;  // its root still fits into a float
  if (size > kMax) return failed("'{}' is larger than {:g} m^2", field, kMax);
  // Rounding errors as shares of the largest element: of the inverse of an ill-conditioned
  // information matrix, and of a product with a singular one.
  constexpr double kAsymmetry = 1e-6;
  constexpr double kNegative = 1e-12;
  const Matrix6d scaled = covariance / size;
  if ((scaled - scaled.transpose()).cwiseAbs().maxCoeff() > kAsymmetry) {
    return failed("'{}' is not symmetric", field);
  }
  if (scaled.diagonal().minCoeff() < -kNegative) {
    return failed("'{}' has a negative variance", field);
  }
  Matrix6d lifted = scaled;
  lifted.diagonal() += 1e-6 * scaled.diagonal() + Vector6d::Constant(1e-9);
  if (lifted.llt().info() == Eigen::Success) return Status::ok();
  return failed("'{}' is not positive semidefinite", field);
}

Status checkRevisions(const std::vector<MotionRevision>& revisions, std::int64_t oldest,
                      std::int64_t newest) {
  for (const MotionRevision& revision : revisions) {
    if (revision.frame < oldest || revision.frame > newest) {
      return failed("revised frame {}, which is not a past frame", revision.frame);
    }
    Status status = checkCovariance(revision.covariance, "revisions.covariance");
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

Status checkMotion(const Motion& motion, bool is_first) {
  const bool moved = !motion.T_previous_current.isApprox(Eigen::Isometry3d::Identity(), 1e-12);
  if (is_first && (motion.state != TrackingState::Initialising || moved)) {
    return Status::failed("frame 0 has no motion: answer Initialising and the identity");
  }
  if (motion.state == TrackingState::Initialising && moved) {
    return Status::failed("an Initialising motion is the identity");
  }
  if (motion.tracked < 0)
    return failed("'tracked' is {}, a number of measurements", motion.tracked);
  if (motion.points.cols() > 0 && (motion.points_frame < 0 || motion.points_frame > motion.frame)) {
    return failed("points of frame {}, which is not a past frame", motion.points_frame);
  }
  return checkCovariance(motion.covariance, "covariance");
}

Status checkTemplateId(const PlaceObservation& observation, std::int64_t templates) {
  const std::int64_t id = observation.template_id;
  switch (observation.recognition) {
    case Recognition::None:
      if (id == -1) break;
      return failed("answered None with template {}; None has template_id -1", id);
    case Recognition::Novel:
      if (id == templates || (templates < 0 && id >= 0)) break;
      return failed("made template {}; ids are 0, 1, 2, ... without gaps, the next one is {}", id,
                    std::max<std::int64_t>(templates, 0));
    case Recognition::Familiar:
      if (id >= 0 && (templates < 0 || id < templates)) break;
      return failed("recognised template {}, which was never made", id);
  }
  return Status::ok();
}

Status checkPlace(const PlaceObservation& observation) {
  if (observation.recognition == Recognition::Familiar) {
    const Status status = checkRelativeYaw(observation.relative_yaw);
    if (!status.isOk()) return status;
  }
  if (observation.has_relative_pose) return checkMeasured(observation.covariance, "covariance");
  return Status::ok();
}

Status checkDecision(const Decision& decision, std::int64_t experiences, std::int64_t last,
                     std::int64_t templates) {
  Status status = checkExperience(decision, experiences, last);
  if (status.isOk() && decision.template_id >= templates) {
    status =
        failed("decided by template {}, which place recognition never gave", decision.template_id);
  }
  for (const EarlierLoop& loop : decision.earlier) {
    if (status.isOk()) status = checkEarlier(loop, decision.frame, experiences);
  }
  if (!status.isOk()) return status;
  if (status = checkHeading(decision.heading); !status.isOk()) return status;
  if (decision.confidence < 0 || decision.confidence > 1) {
    return failed("confidence {:f} is not in [0, 1]", decision.confidence);
  }
  if (decision.action != Action::CloseLoop) return Status::ok();
  if (status = checkRelativeYaw(decision.relative_yaw); !status.isOk()) return status;
  return decision.has_relative_pose ? checkMeasured(decision.covariance, "covariance") : status;
}

Status checkLocalised(const Decision& decision, std::int64_t experiences) {
  const std::int64_t id = decision.experience;
  if (decision.action == Action::CreateExperience) {
    return Status::failed("created an experience, although the map must stay as it is");
  }
  if (id < -1 || id >= experiences || decision.has_relative_pose != (id >= 0)) {
    return failed("is at experience {} of {} {} relative pose: give both, or -1 and none", id,
                  experiences, decision.has_relative_pose ? "with" : "without");
  }
  if (Status status = checkHeading(decision.heading); !status.isOk()) return status;
  return id < 0 ? Status::ok() : checkMeasured(decision.covariance, "covariance");
}

Status checkUpdate(const MapUpdate& update, std::int64_t last_version) {
  if (update.version < last_version) return Status::failed("the version of the map decreased");
  if (update.experience < -1 || update.experience >= update.experiences) {
    return failed("the frame is attached to experience {}, which does not exist",
                  update.experience);
  }
  if (update.links < 0 || update.loops < 0) return failed("a number of links is negative");
  if (update.loops <= update.links) return Status::ok();
  return failed("{} loops of {} links", update.loops, update.links);
}

Status checkGraph(const MapGraph& graph, const KnownMap& known) {
  const auto count = static_cast<std::int64_t>(graph.experiences.size());
  if (graph.version < known.version) return failed("the version of the map decreased");
  if (Status status = checkCounts(graph, known); !status.isOk()) return status;
  for (std::int64_t i = 0; i < count; ++i) {
    const Experience& experience = graph.experiences[static_cast<std::size_t>(i)];
    if (Status status = checkExperience(experience, i, known); !status.isOk()) return status;
  }
  if (!graph.residuals.empty() && graph.residuals.size() != graph.links.size()) {
    return failed("{} residuals of {} links", graph.residuals.size(), graph.links.size());
  }
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    if (graph.links[i].id != static_cast<std::int64_t>(i)) {
      return failed(
          "link {} of the graph has the id {}; ids are 0, 1, 2, ... without gaps, in this order", i,
          graph.links[i].id);
    }
    if (Status status = checkLink(graph.links[i], count, known); !status.isOk()) return status;
  }
  return checkRejected(graph);
}

Status checkPlaced(const MapUpdate& update, const MapGraph& graph) {
  if (update.experience < 0 || update.experience >= std::ssize(graph.experiences)) {
    return Status::ok();
  }
  const Experience& experience = graph.experiences[static_cast<std::size_t>(update.experience)];
  return checkSamePose(update.T_world_camera,
                       experience.T_world_experience * update.T_experience_camera,
                       fmt::format("experience {} of graph() and T_experience_camera of the update",
                                   update.experience));
}

Status checkSamePose(const Eigen::Isometry3d& T_world_camera, const Eigen::Isometry3d& other,
                     const std::string& what) {
  // Tolerances for poses that are stored in single precision.
  constexpr double kApart = 1e-3;       // m
  constexpr double kApartShare = 1e-5;  // of the distance from the origin
  constexpr double kTurned = 1e-3;      // rad
  const double size = T_world_camera.translation().norm();
  const double apart = (T_world_camera.translation() - other.translation()).norm();
  const double turned = logSo3(T_world_camera.linear().transpose() * other.linear()).norm();
  if (apart <= kApart + kApartShare * size && turned <= kTurned) return Status::ok();
  return failed("is {:.4g} m and {:.3g} rad from the pose by {}", apart, turned, what);
}

}  // namespace tolman::host
