// SPDX-License-Identifier: BSD-3-Clause
// Source `motion_log`: recorded planar motion (m, rad) and loop candidates from g2o files, without
// images. Planar axes: x forward, y left, theta counter-clockwise.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "g2o_edges.hpp"
#include "tolman/extras.hpp"
#include "tolman/frame_selection.hpp"
#include "tolman/roles.hpp"

namespace tolman::motion_log {

/// The frame whose pose is the origin of the true poses.
enum class TruthOrigin : std::uint8_t {
  First,  ///< the first selected frame, as for all sources
  Data,   ///< the first frame of the data: the same for several sessions on the same data
};
inline constexpr std::array<std::string_view, 2> kTruthOriginNames = {"first", "data"};
constexpr std::span<const std::string_view> enumNames(TruthOrigin) { return kTruthOriginNames; }

struct LogParameters : FrameSelection {
  std::string path;
  std::string odometry = "odometry.g2o";
  std::string truth = "ground_truth.g2o";
  std::string candidates = "loop_candidates.g2o";
  double rate = 10;
  TruthOrigin truth_origin = TruthOrigin::First;

  static constexpr auto declaration() {
    using P = LogParameters;
    return std::tuple_cat(
        parameters(
            parameter("path", &P::path)
                .path()
                .required()
                .doc("Folder of one sequence with the files below, or one g2o file with motion and "
                     "loops."),
            parameter("odometry", &P::odometry)
                .doc("Motion from frame to frame (EDGE_SE2, EDGE_SE3:QUAT); other edges are "
                     "candidates."),
            parameter("truth", &P::truth)
                .doc("True motion or poses; empty: none. Without a file of the default name there "
                     "is no truth."),
            parameter("candidates", &P::candidates)
                .doc("More loop candidates, edges between two frames; empty for none."),
            parameter("rate", &P::rate).range(0.001, 1e6).unit("Hz").doc("Frames per second."),
            parameter("truth_origin", &P::truth_origin)
                .doc(
                    "Origin of the true poses: the first selected frame, or the first frame of the "
                    "data, so that several sessions share one world frame.")),
        selectionParameters<P>());
  }
};

/// Frames without images. The recorded values are in Frame::sensors, for the replay plugins:
///   motion.planar    {3}     x, y (m) and theta (rad) since the previous frame
///   place.candidate  {n, 4}  source index of a similar frame, and its x, y, theta in this frame
///   place.looked     {1}     1 if a candidate begins or ends here (the detector ran), otherwise 0
///   motion.drive     {1}     hash of the odometry, to distinguish the frames of two drives
class MotionLog final : public Source, public ArrayDescriptions {
 public:
  using Parameters = LogParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status next(Frame& frame) override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  Status loadTruth(const std::filesystem::path& file);
  Status load(FindingCollector& findings);
  Status addCandidates(const std::filesystem::path& file, const std::vector<Edge>& edges,
                       const std::vector<std::int64_t>& ids, FindingCollector& findings);
  void attachCandidates(std::int64_t here, Frame& frame) const;

  Parameters parameters_;
  Status ready_ = Status::failed("configure() was not called");
  std::vector<PlanarPose> poses_;  ///< by odometry
  std::vector<PlanarPose> truth_;  ///< empty without true poses
  std::multimap<std::int64_t, Edge> candidates_;
  std::set<std::int64_t> looked_;  ///< ends of candidates
  float drive_ = 0;                ///< motion.drive
  FrameSequence sequence_;
  std::int64_t next_ = 0;
};

}  // namespace tolman::motion_log
