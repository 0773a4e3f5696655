// SPDX-License-Identifier: BSD-3-Clause
#include "frame_encoder.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tolman/image_cv.hpp"

namespace tolman::web_viewer {
namespace {

// Points of an older frame lie elsewhere by now.
constexpr std::int64_t kRecentFrames = 10;
// A message that no browser wants to take ten times a second.
constexpr Eigen::Index kMostPoints = 20'000;
constexpr std::size_t kMostCells = 1U << 20U;  // numbers in all arrays
constexpr std::size_t kMostText = 1000;        // bytes of what an event says

void addMotion(const Motion& motion, nlohmann::json& header) {
  header["state"] = enumName(motion.state);
  header["v"] = motion.v;
  header["omega"] = motion.omega;
  header["tracked"] = motion.tracked;
  header["is_keyframe"] = motion.is_keyframe;
}

void addPlace(const PlaceObservation& place, nlohmann::json& header) {
  header["recognition"] = enumName(place.recognition);
  header["template_id"] = place.template_id;
  header["score"] = place.score;
}

void addDecision(const Decision& decision, nlohmann::json& header) {
  header["action"] = enumName(decision.action);
  header["experience"] = decision.experience;
  header["heading"] = decision.heading;
  header["confidence"] = decision.confidence;
}

nlohmann::json timesJson(const StageTimes& times_ns) {
  nlohmann::json times = nlohmann::json::object();
  for (std::size_t role = 0; role < times_ns.size(); ++role) {
    if (times_ns[role] > 0) times[std::string(kRoleNames[role])] = 1e-6 * double(times_ns[role]);
  }
  return times;
}

nlohmann::json headerOf(const Sighting& s) {
  nlohmann::json header = {{"type", "frame"},
                           {"frame", s.frame},
                           {"stamp_s", static_cast<double>(s.stamp_ns) * 1e-9},
                           {"points_frame", s.has_motion ? s.motion.points_frame : -1},
                           {"times_ms", timesJson(s.times_ns)}};
  if (s.has_motion) addMotion(s.motion, header);
  if (s.has_place) addPlace(s.place, header);
  if (s.has_decision) addDecision(s.decision, header);
  if (s.has_map) {
    header["map"] = {{"version", s.map.version},
                     {"experiences", s.map.experiences},
                     {"links", s.map.links},
                     {"loops", s.map.loops}};
  }
  return header;
}

void addPoints(const Sighting& s, std::vector<PackedArray>& arrays) {
  const Motion& motion = s.motion;
  const bool recent = motion.points_frame >= 0 && s.frame - motion.points_frame <= kRecentFrames;
  if (!s.has_motion || !recent || motion.points.cols() == 0) return;
  const auto count = static_cast<std::size_t>(std::min(motion.points.cols(), kMostPoints));
  // Column-major 4 x n is row-major n x 4.
  arrays.push_back(pack<float>("points", {count, 4}, {motion.points.data(), 4 * count}));
}

void addCells(const std::vector<NamedArray>& cells, std::vector<PackedArray>& arrays) {
  std::size_t total = 0;
  for (const NamedArray& array : cells) {
    total += array.values.size();
    if (total > kMostCells) return;
    arrays.push_back(
        pack<float>("cells." + array.name, {array.shape.begin(), array.shape.end()}, array.values));
  }
}

/// At most `width` wide, by a whole factor: means over whole pixels cost a tenth of the others.
/// What is left over at the right and at the bottom, less than one pixel of the result, is cut off.
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

std::string jpeg(const Image& image, const Picture& picture) {
  if (image.empty()) return {};
  const cv::Mat pixels = shrunk(asMat(image), picture.width);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", pixels, bytes, {cv::IMWRITE_JPEG_QUALITY, picture.quality});
  return {bytes.begin(), bytes.end()};
}

EncodedFrame encodeFrame(const Sighting& sighting, const Picture& picture) {
  EncodedFrame encoded{sighting.frame, headerOf(sighting), {}};
  if (const std::string image = jpeg(sighting.left, picture); !image.empty()) {
    encoded.arrays.push_back(
        {"image", Element::U8, {image.size()}, std::make_shared<const std::string>(image)});
  }
  addPoints(sighting, encoded.arrays);
  addCells(sighting.cells, encoded.arrays);
  return encoded;
}

nlohmann::json eventsJson(const std::vector<RunEvent>& events) {
  nlohmann::json list = nlohmann::json::array();
  for (const RunEvent& event : events) {
    list.push_back({{"frame", event.frame},
                    {"level", enumName(event.level)},
                    {"source", event.source},
                    {"message", event.message.substr(0, kMostText)}});
  }
  return list;
}

std::string storedMessage(const EncodedFrame& frame, const std::vector<RunEvent>& events) {
  nlohmann::json header = frame.header;
  header["stored"] = true;
  header["events"] = eventsJson(events);
  return encodeContainer(std::move(header), frame.arrays);
}

}  // namespace tolman::web_viewer
