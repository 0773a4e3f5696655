// SPDX-License-Identifier: BSD-3-Clause
#include "place_verifier.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>

namespace tolman::view_sequences {

namespace {

using landmarks::kDescriptionBytes;
using landmarks::kPatchBytes;
using landmarks::Landmarks;

constexpr std::int64_t kBytesEach = 3 * sizeof(float) + kDescriptionBytes + kPatchBytes;

Status failure(const char* what, const Status& status) {
  return Status::failed(std::string("landmarks cannot be ") + what + ": " + status.message() +
                        " Set landmarks to 0 to do without");
}

std::vector<std::uint8_t> bytesOfLandmarks(const StoredLandmarks& landmarks) {
  const Landmarks& corners = landmarks.corners;
  std::vector<std::uint8_t> bytes(corners.points.size() * kBytesEach);
  std::uint8_t* out = bytes.data();
  const auto put = [&out](const void* from, std::size_t size) {
    std::memcpy(out, from, size);
    out += size;
  };
  for (std::size_t i = 0; i < corners.points.size(); ++i) {
    const cv::Point3f& p = corners.points[i];
    const float xyz[3] = {p.x, p.y, p.z};
    put(xyz, sizeof xyz);
    put(corners.descriptions.ptr<std::uint8_t>(static_cast<int>(i)), kDescriptionBytes);
    put(landmarks.patches[i].data(), kPatchBytes);
  }
  return bytes;
}

}  // namespace

Status LandmarkStore::add(std::int64_t view, const StoredLandmarks& landmarks) {
  return append(view, static_cast<std::int64_t>(landmarks.corners.points.size()),
                bytesOfLandmarks(landmarks));
}

Status LandmarkStore::append(std::int64_t view, std::int64_t count,
                             const std::vector<std::uint8_t>& bytes) {
  if (Status status = file_.write(end_, std::as_bytes(std::span(bytes))); !status.isOk()) {
    return failure("stored", status);
  }
  entries_.push_back({view, end_, count});
  end_ += static_cast<std::int64_t>(bytes.size());
  return Status::ok();
}

std::optional<std::int64_t> LandmarkStore::nearest(std::int64_t view, std::int64_t reach) const {
  const auto after = std::ranges::lower_bound(entries_, view, {}, &StoredView::view);
  std::optional<std::int64_t> best;
  if (after != entries_.begin()) best = std::prev(after)->view;
  if (after != entries_.end() && (!best || after->view - view < view - *best)) best = after->view;
  return best && std::abs(*best - view) <= reach ? best : std::nullopt;
}

Result<std::vector<std::uint8_t>> LandmarkStore::bytesOf(const StoredView& entry) const {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(entry.count * kBytesEach));
  const Status status = file_.read(entry.offset, std::as_writable_bytes(std::span(bytes)));
  if (!status.isOk()) return failure("read", status);
  return bytes;
}

Result<StoredLandmarks> LandmarkStore::read(std::int64_t view) const {
  const auto entry = std::ranges::lower_bound(entries_, view, {}, &StoredView::view);
  auto bytes = bytesOf(*entry);
  if (!bytes.isOk()) return bytes.status();
  StoredLandmarks landmarks;
  landmarks.corners.descriptions.create(static_cast<int>(entry->count), kDescriptionBytes, CV_8U);
  landmarks.patches.resize(static_cast<std::size_t>(entry->count));
  const std::uint8_t* in = bytes.value().data();
  const auto get = [&in](void* to, std::size_t size) {
    std::memcpy(to, in, size);
    in += size;
  };
  for (int i = 0; i < entry->count; ++i) {
    float xyz[3];
    get(xyz, sizeof xyz);
    landmarks.corners.points.emplace_back(xyz[0], xyz[1], xyz[2]);
    get(landmarks.corners.descriptions.ptr<std::uint8_t>(i), kDescriptionBytes);
    get(landmarks.patches[static_cast<std::size_t>(i)].data(), kPatchBytes);
  }
  return landmarks;
}

Status LandmarkStore::save(StateWriter& writer) const {
  writer.put(static_cast<std::uint64_t>(entries_.size()));
  for (const StoredView& entry : entries_) {
    const auto bytes = bytesOf(entry);
    if (!bytes.isOk()) return bytes.status();
    writer.put(entry.view);
    writer.put(entry.count);
    writer.putAll<std::uint8_t>(bytes.value());
  }
  return Status::ok();
}

Status LandmarkStore::load(StateReader& reader, std::int64_t views) {
  *this = LandmarkStore();
  const auto entries = reader.get<std::uint64_t>();
  for (std::uint64_t i = 0; i < entries && reader.remaining() > 0; ++i) {
    const auto view = reader.get<std::int64_t>();
    const auto count = reader.get<std::int64_t>();
    const bool follows = entries_.empty() ? view >= 0 : view > entries_.back().view;
    const auto most = static_cast<std::int64_t>(reader.remaining()) / kBytesEach;
    if (!follows || view >= views || count < 0 || count > most) break;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(count * kBytesEach));
    reader.getAll<std::uint8_t>(bytes);
    if (Status status = append(view, count, bytes); !status.isOk()) return status;
  }
  return entries_.size() == entries ? Status::ok()
                                    : Status::invalidInput("the landmarks are damaged");
}

namespace {

// Chosen, not tuned.
constexpr double kMinApart = 4;              // m of path: a chance match does not last so long
constexpr double kMaxApart = 12;             // m of path
constexpr double kLargestGap = 1.5;          // m, between the poses
constexpr double kLargestTurn = 0.12;        // rad
constexpr std::uint64_t kMaxMeasured = 200;  // a larger number is damage

void putPlanar(StateWriter& writer, const PlanarPose& pose) {
  for (const double value : {pose.x, pose.y, pose.theta}) writer.put(value);
}

bool getPlanar(StateReader& reader, PlanarPose& pose) {
  for (double* value : {&pose.x, &pose.y, &pose.theta}) *value = reader.get<double>();
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta);
}

}  // namespace

bool PoseAgreement::add(double path, const PlanarPose& stored, const PlanarPose& driven) {
  while (!measured_.empty() && measured_.front().path < path - kMaxApart) measured_.pop_front();
  const bool agrees = std::ranges::any_of(measured_, [&](const Measured& earlier) {
    if (path - earlier.path < kMinApart) return false;
    const PlanarPose expected = compose(earlier.stored, between(earlier.driven, driven));
    const PlanarPose gap = between(expected, stored);
    return std::hypot(gap.x, gap.y) < kLargestGap && std::abs(gap.theta) < kLargestTurn;
  });
  measured_.push_back({path, stored, driven});
  return agrees;
}

void PoseAgreement::save(StateWriter& writer) const {
  writer.put(static_cast<std::uint64_t>(measured_.size()));
  for (const Measured& one : measured_) {
    writer.put(one.path);
    putPlanar(writer, one.stored);
    putPlanar(writer, one.driven);
  }
}

bool PoseAgreement::load(StateReader& reader) {
  measured_.clear();
  const auto count = reader.get<std::uint64_t>();
  if (count > kMaxMeasured) return false;
  for (std::uint64_t i = 0; i < count; ++i) {
    Measured one;
    one.path = reader.get<double>();
    const bool sound = getPlanar(reader, one.stored) && getPlanar(reader, one.driven);
    if (!sound || !std::isfinite(one.path)) return false;
    measured_.push_back(one);
  }
  return true;
}

void PlaceVerifier::beginFrame(const Frame& frame) {
  frame_ = &frame;
  corners_.reset();
  edge_search_.reset();
  has_edges_ = false;
}

const landmarks::Corners& PlaceVerifier::corners() {
  if (!corners_) {
    corners_ = landmarks::findCorners(landmarks::grayOf(frame_->left), settings_.corners);
  }
  return *corners_;
}

const landmarks::EdgeMap& PlaceVerifier::edges() {
  if (!has_edges_) edges_.compute(landmarks::grayOf(frame_->left));
  has_edges_ = true;
  return edges_;
}

Status PlaceVerifier::store(std::int64_t view) {
  if (!canMeasure() || frame_->right.empty()) return Status::ok();
  if (store_.nearest(view, settings_.spacing - 1)) return Status::ok();
  StoredLandmarks found;
  found.corners = landmarks::findLandmarks(landmarks::grayOf(frame_->left),
                                           landmarks::grayOf(frame_->right), rig_, corners());
  const std::vector<cv::Point3f>& points = found.corners.points;
  if (static_cast<int>(points.size()) < settings_.least_agreeing) return Status::ok();
  for (const cv::Point3f& p : points) {
    found.patches.push_back(landmarks::patchAt(edges(), landmarks::pixelOf(p, rig_.pinhole)));
  }
  return store_.add(view, found);
}

std::optional<std::int64_t> PlaceVerifier::viewNear(std::int64_t view) const {
  return canMeasure() ? store_.nearest(view, settings_.spacing) : std::nullopt;
}

Result<std::optional<landmarks::MeasuredPose>> PlaceVerifier::locate(std::int64_t view) {
  // Errors of landmarks that are near to each other are alike, so a pose is less exact than its
  // equations say: by this factor on the town's 06 and 07.
  constexpr double kInflation = 1.5;
  const auto stored = store_.read(view);
  if (!stored.isOk()) return stored.status();
  auto pose =
      landmarks::poseOf(landmarks::findAgain(stored.value().corners, corners()), rig_.pinhole,
                        settings_.least_agreeing, corners().sigma, &agreement_);
  if (pose) pose->covariance *= kInflation * kInflation;
  return pose;
}

Result<std::optional<landmarks::MeasuredPose>> PlaceVerifier::locateByEdges(std::int64_t view) {
  // Chosen on the town's 06, by day and with its second pass by night: 50 of 52 poses of right
  // places are accepted there, and one wrong pose; with a share of a half nine wrong ones.
  constexpr int kTimesLeast = 2;
  constexpr double kShare = 0.65;
  constexpr double kInflation = 3.25;  // as above; chosen on 06 and 05 by night
  // Most candidates are wrong, which a quarter of their landmarks shows. Of 40 found ones a true
  // share of 0.65 is below 0.45 by chance once in 330 times (binomial).
  constexpr std::size_t kSample = 4;
  constexpr double kShareOfSample = 0.45;
  const auto stored = store_.read(view);
  if (!stored.isOk()) return stored.status();
  const int least = settings_.least_agreeing;
  if (!poseByEdges(stored.value(), kSample, least / 4, kShareOfSample)) {
    return std::optional<landmarks::MeasuredPose>();
  }
  auto pose = poseByEdges(stored.value(), 1, kTimesLeast * least, kShare);
  if (pose) pose->covariance *= kInflation * kInflation;
  return pose;
}

/// The pose on which at least `least` and this share of every step-th landmark agree.
std::optional<landmarks::MeasuredPose> PlaceVerifier::poseByEdges(const StoredLandmarks& stored,
                                                                  std::size_t step, int least,
                                                                  double share) {
  if (!edge_search_) edge_search_.emplace(edges());
  const auto matches =
      edge_search_->find(stored.corners.points, stored.patches, rig_.pinhole, step);
  const auto of_share = static_cast<int>(share * static_cast<double>(matches.size()));
  return landmarks::poseOf(matches, rig_.pinhole, std::max({least, of_share, 4}),
                           edge_search_->sigma());
}

}  // namespace tolman::view_sequences
