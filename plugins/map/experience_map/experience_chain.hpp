// SPDX-License-Identifier: BSD-3-Clause
// The experiences, strung on the robot's path. An anchor is a node of the pose graph: the start,
// each new experience, and each visit of an old one. Odometry joins an anchor to the one before,
// a loop joins a visit to its experience. So each motion is used once, and an assumed offset of a
// visit cannot leak into the odometry after it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tolman/records.hpp>
#include <vector>

#include "motion_log.hpp"
#include "parameters.hpp"
#include "path_parts.hpp"
#include "planar_optimiser.hpp"
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

struct Anchor {
  std::size_t slot = 0;          ///< the frame that stands there, see MotionLog
  std::int64_t experience = -1;  ///< made or visited here; -1 for a start without experience
  std::int64_t template_id = -1;
  UncertainPose way;  ///< from the anchor before, by odometry
  double way_weight = 1;
  bool gap = false;  ///< begins a part of the path; the way to it is unknown
  bool visit = false;
  bool assumed = false;  ///< the offset was not measured
  UncertainPose offset;  ///< of a visit: T_experience_anchor as first said
  double offset_weight = 1;
  bool taken_back = false;  ///< a visit that the map does not believe
  PlanarPose correction;    ///< world = fromPlanar(correction) * dead reckoning, 3-D kept
};

/// Where a frame is seen from an experience; for good, however the experience moves.
struct Place {
  std::int64_t experience = -1;  ///< -1: seen from the world
  Eigen::Isometry3d T_experience_camera = Eigen::Isometry3d::Identity();
};

class ExperienceChain {
 public:
  explicit ExperienceChain(const Parameters& parameters = {}) : parameters_(parameters) {}

  /// The anchor on which frames hang now.
  std::int64_t current() const { return static_cast<std::int64_t>(anchors_.size()) - 1; }
  std::int64_t experiences() const { return static_cast<std::int64_t>(of_experience_.size()); }
  std::int64_t links() const { return links_; }
  std::int64_t loops() const { return loops_; }
  const Anchor& operator[](std::int64_t i) const { return anchors_[static_cast<std::size_t>(i)]; }

  /// The first frame of all; before everything else.
  void start() { anchors_.emplace_back(); }
  /// The log's last frame is somewhere unknown: a new part of the path begins. Until a loop joins
  /// it with an earlier part it is kept as if it began where that one ended.
  void startPart(const MotionLog& log);
  /// The log's last frame becomes the next experience.
  void addExperience(const MotionLog& log, std::int64_t template_id);
  /// The log's last frame visits an old experience, at a measured offset ...
  void addVisit(const MotionLog& log, std::int64_t experience, const UncertainPose& measured);
  /// ... or somewhere near it, only the heading being known.
  void addVisit(const MotionLog& log, std::int64_t experience, double relative_yaw);

  /// Takes up motions that changed from slot `first` on.
  void refresh(const MotionLog& log, std::size_t first);
  bool visited() const { return last_visit_ > 0; }
  /// There are loops which the poses do not yet obey.
  bool pending() const { return pending_; }
  /// Moves the anchors to the least energy. Leaves all alone when it fails.
  Status correct(const MotionLog& log, int iterations, double tolerance);
  /// The last word: weighs all loops afresh against each other, and takes the false ones back.
  Status judge(const MotionLog& log, int iterations, double tolerance);

  Eigen::Isometry3d T_world_camera(const MotionLog& log, std::size_t slot) const;
  Eigen::Isometry3d T_world_experience(const MotionLog& log, std::int64_t experience) const;
  /// Hangs a frame on the last experience that it is believed to have been at.
  Place place(const MotionLog& log, std::size_t slot) const;
  /// The chain as a graph of experiences alone: visits are folded into the links. No link leads
  /// over a gap but a loop, so the graph shows what is joined and what is not.
  void graph(const MotionLog& log, MapGraph& graph) const;

  /// All that decides the future besides the log, for saving. Of anchors `way` is not needed.
  struct State {
    std::vector<Anchor> anchors;
    std::int64_t links = 0;
    std::int64_t loops = 0;
    bool pending = false;
  };
  State state() const { return {anchors_, links_, loops_, pending_}; }
  /// A sound state, see saved_map.
  void restore(const MotionLog& log, State state);

 private:
  struct Sketch {
    std::vector<PlanarPose> reckoned;
    std::vector<PlanarPose> nodes;
    std::vector<PlanarLink> links;  ///< all ways, then all loops
  };
  Anchor& append(const MotionLog& log);
  PathParts parts() const;
  std::size_t homeOf(const Anchor& visit) const;
  void layOver(const MotionLog& log, const PathParts& before);
  Sketch sketch(const MotionLog& log) const;
  void rearrange(const PathParts& parts, const Sketch& start, OptimiserOptions options,
                 std::size_t attempts, Sketch& best, Outcome& outcome) const;
  void addVisit(const MotionLog& log, std::int64_t experience, const UncertainPose& offset,
                bool assumed);
  const Anchor& home(std::int64_t experience) const;
  PlanarLink wayLink(const MotionLog& log, std::size_t i, const PathParts& parts) const;
  PlanarLink loopLink(const MotionLog& log, std::size_t i) const;
  enum class Care : std::uint8_t { Brief, Thorough };
  Status optimiseAll(const MotionLog& log, OptimiserOptions options, Care care);
  bool counts(const Anchor& anchor) const { return !anchor.visit || !anchor.taken_back; }
  Link foldedLink(const MotionLog& log, std::size_t before, std::size_t i) const;
  void apply(const Sketch& sketch);

  Parameters parameters_;
  std::vector<Anchor> anchors_;
  std::vector<std::size_t> of_experience_;  ///< anchor where it was made
  std::vector<std::size_t> begins_ = {0};   ///< anchors at which parts of the path begin
  std::int64_t links_ = 0;
  std::int64_t loops_ = 0;
  std::size_t last_visit_ = 0;  ///< anchor; 0 for none
  bool pending_ = false;
};

}  // namespace tolman::experience_map
