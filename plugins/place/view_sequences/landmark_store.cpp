// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_store.hpp"

#include <algorithm>
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

}  // namespace tolman::view_sequences
