// SPDX-License-Identifier: BSD-3-Clause
#include "frame_encoder.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tolman/image_cv.hpp"

namespace tolman::web_viewer {

namespace {

static_assert(std::endian::native == std::endian::little, "the wire is little-endian");

constexpr std::size_t kAlignment = 8;
constexpr std::array<std::string_view, 4> kElementNames = {"u8", "i32", "f32", "f64"};

std::size_t aligned(std::size_t size) { return (size + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

std::string jsonText(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string encodeContainer(nlohmann::json header, const std::vector<PackedArray>& arrays) {
  nlohmann::json list = nlohmann::json::array();
  std::size_t offset = 0;
  for (const PackedArray& array : arrays) {
    list.push_back({{"name", array.name},
                    {"dtype", kElementNames.at(static_cast<std::size_t>(array.element))},
                    {"shape", array.shape},
                    {"offset", offset}});
    offset = aligned(offset + array.bytes->size());
  }
  header["arrays"] = std::move(list);
  const std::string text = jsonText(header);
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string message(aligned(sizeof length + text.size()) + offset, '\0');
  std::memcpy(message.data(), &length, sizeof length);
  std::ranges::copy(text, message.begin() + sizeof length);
  char* next = message.data() + aligned(sizeof length + text.size());
  for (const PackedArray& array : arrays) {
    // NOLINTNEXTLINE(bugprone-not-null-terminated-result): bytes, not text
    std::memcpy(next, array.bytes->data(), array.bytes->size());
    next += aligned(array.bytes->size());
  }
  return message;
}

void FlatGraph::assign(const MapGraph& graph, std::int64_t at_frame) {
  header = {graph.version, at_frame};
  experience.clear();
  for (const Experience& e : graph.experiences) {
    const Eigen::Vector3d p = e.T_world_experience.translation();
    for (const double x : {p.x(), p.y(), p.z(), toPlanar(e.T_world_experience).theta}) {
      experience.push_back(static_cast<float>(x));
    }
  }
  link.clear();
  link_kind.clear();
  link_rejected.clear();
  link_metres.clear();
  link_seconds.clear();
  loop.clear();
  loop_residual.clear();
  const auto frameOf = [&](std::int64_t id) {
    return graph.experiences.at(static_cast<std::size_t>(id)).frame;
  };
  for (const Link& l : graph.links) {
    link.push_back(static_cast<std::int32_t>(l.from));
    link.push_back(static_cast<std::int32_t>(l.to));
    link_kind.push_back(static_cast<std::uint8_t>(l.kind));
    link_rejected.push_back(graph.isRejected(l) ? 1 : 0);
    link_metres.push_back(static_cast<float>(l.T_from_to.translation().norm()));
    link_seconds.push_back(static_cast<float>(l.duration));
    if (l.kind != LinkKind::Loop) continue;
    const std::size_t number = link_kind.size() - 1;
    for (const std::int64_t value : {l.id, l.frame, frameOf(l.from), frameOf(l.to)}) {
      loop.push_back(static_cast<std::int32_t>(value));
    }
    const bool measured = number < graph.residuals.size();
    loop_residual.push_back(measured ? static_cast<float>(graph.residuals[number]) : -1);
  }
}

std::string FlatGraph::encode() const {
  const std::size_t nodes = experience.size() / 4;
  const std::size_t links = link_kind.size();
  return encodeContainer(headerJson(header),
                         {pack<float>("experience", {nodes, 4}, experience),
                          pack<std::int32_t>("link", {links, 2}, link),
                          pack<std::uint8_t>("link_kind", {links}, link_kind),
                          pack<std::uint8_t>("link_rejected", {links}, link_rejected),
                          pack<std::int32_t>("loop", {loop_residual.size(), 4}, loop),
                          pack<float>("loop_residual", {loop_residual.size()}, loop_residual)});
}

namespace {

// Points of older frames are not sent: they no longer fit the present image.
constexpr std::int64_t kRecentFrames = 10;
// Limits of a message: about 5 MB, which the loopback interface carries ten times a second.
constexpr Eigen::Index kMaxPoints = 20'000;
constexpr std::size_t kMaxCells = 1U << 20U;  // values in all arrays
constexpr std::size_t kMaxText = 1000;        // bytes of an event's message

void addPoints(const FrameCopy& copy, std::vector<PackedArray>& arrays) {
  const bool recent = copy.points_frame >= 0 && copy.frame - copy.points_frame <= kRecentFrames;
  if (!recent || copy.points.cols() == 0) return;
  const auto count = static_cast<std::size_t>(std::min(copy.points.cols(), kMaxPoints));
  // Column-major 4 x n is row-major n x 4.
  arrays.push_back(pack<float>("points", {count, 4}, {copy.points.data(), 4 * count}));
}

void addCells(const std::vector<NamedArray>& cells, std::vector<PackedArray>& arrays) {
  std::size_t total = 0;
  for (const NamedArray& array : cells) {
    total += array.values.size();
    if (total > kMaxCells) return;
    arrays.push_back(
        pack<float>("cells." + array.name, {array.shape.begin(), array.shape.end()}, array.values));
  }
}

/// Reduces an image by an integer factor to at most `width` px: means over whole pixels take a
/// tenth of the time of other interpolations. The remainder at the right and the bottom, less than
/// a pixel of the result, is cut off.
cv::Mat shrunk(const cv::Mat& pixels, int width) {
  const int factor = std::min((pixels.cols + width - 1) / width, pixels.rows);
  if (factor <= 1) return pixels;
  const cv::Size size(pixels.cols / factor, pixels.rows / factor);
  cv::Mat small;
  cv::resize(pixels(cv::Rect(0, 0, factor * size.width, factor * size.height)), small, size, 0, 0,
             cv::INTER_AREA);
  return small;
}

}  // namespace

std::string jpeg(const Image& image, const JpegOptions& options) {
  if (image.empty()) return {};
  const cv::Mat pixels = shrunk(asMat(image), options.width);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", pixels, bytes, {cv::IMWRITE_JPEG_QUALITY, options.quality});
  return {bytes.begin(), bytes.end()};
}

EncodedFrame encodeFrame(const FrameCopy& copy, const JpegOptions& options) {
  EncodedFrame encoded;
  encoded.header.frame = copy.frame;
  encoded.header.points_frame = copy.points_frame;
  if (const std::string image = jpeg(copy.left, options); !image.empty()) {
    encoded.arrays.push_back(
        {"image", ElementType::U8, {image.size()}, std::make_shared<const std::string>(image)});
  }
  addPoints(copy, encoded.arrays);
  addCells(copy.cells, encoded.arrays);
  return encoded;
}

std::vector<RunEvent> shortened(std::vector<RunEvent> events) {
  for (RunEvent& event : events) event.message.resize(std::min(event.message.size(), kMaxText));
  return events;
}

std::string storedMessage(const EncodedFrame& frame, const std::vector<RunEvent>& events) {
  FrameHeader header = frame.header;
  header.events = shortened(events);
  return encodeContainer(headerJson(header), frame.arrays);
}

}  // namespace tolman::web_viewer
