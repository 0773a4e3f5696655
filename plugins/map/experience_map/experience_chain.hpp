// SPDX-License-Identifier: BSD-3-Clause
// The pose graph behind the experience map, as a chain along the robot's path. Its nodes, called
// anchors, are the first frame, each frame that creates an experience, each frame that visits an
// earlier one, and the first frame after tracking restarted (`gap`: no odometry before it).
// Odometry links each anchor to the previous one, and a loop links each visit to the anchor that
// created its experience. Each motion is used in exactly one link, and the assumed offset of a
// visit does not change the odometry after it. Lengths are metres, angles radians.
//
//   start -o- created 0 -o- created 1 -o- visit of 0 -o- created 2        -o-: odometry
//                  \______________________/                               ___: loop
//
// graph() merges each visit with its experience, which gives the graph of experiences alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <tolman/records.hpp>
#include <vector>

#include "chain_arrangement.hpp"
#include "chain_problem.hpp"
#include "dead_reckoning.hpp"
#include "graph_optimiser.hpp"
#include "growing_list.hpp"
#include "parameters.hpp"
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

struct Anchor {
  std::size_t slot = 0;          ///< slot of its frame, see DeadReckoning
  std::int64_t experience = -1;  ///< created or visited here; -1 for neither
  std::int64_t template_id = -1;
  PathMotion odometry;  ///< odometry from the previous anchor
  double odometry_weight = 1;
  bool gap = false;  ///< first of a part of the path; the motion to it is unknown
  bool visit = false;
  bool assumed = false;  ///< the offset was not measured
  UncertainPose offset;  ///< of a visit: T_experience_anchor as given with the decision
  double offset_weight = 1;
  bool rejected = false;  ///< a visit whose loop the final correction has rejected
  double residual = -1;   ///< of a visit's loop after the final correction, standard deviations
  /// T_world_camera = correction * T_start_camera of dead reckoning. In the plane it has no height,
  /// pitch and roll.
  Eigen::Isometry3d correction = Eigen::Isometry3d::Identity();
};

/// Pose of a frame relative to an experience; remains valid when the experience moves.
struct ExperiencePose {
  std::int64_t experience = -1;  ///< -1: relative to the world
  Eigen::Isometry3d T_experience_camera = Eigen::Isometry3d::Identity();
};

class ExperienceChain {
 public:
  explicit ExperienceChain(const Parameters& parameters = {}) : parameters_(parameters) {}

  /// Index of the last anchor.
  std::int64_t current() const { return static_cast<std::int64_t>(anchors_.size()) - 1; }
  std::int64_t experiences() const { return static_cast<std::int64_t>(of_experience_.size()); }
  std::int64_t links() const { return links_; }
  std::int64_t loops() const { return loops_; }
  const Anchor& operator[](std::int64_t i) const { return anchors_[static_cast<std::size_t>(i)]; }

  /// Adds the anchor of the first frame; called before everything else.
  void start() { anchors_.emplace_back(); }
  /// The last frame has an unknown pose: a new part of the path begins there. Until a loop joins it
  /// with an earlier part, it starts at the end of the previous part.
  void startPart(const DeadReckoning& path);
  /// The last frame creates the next experience.
  void addExperience(const DeadReckoning& path, std::int64_t template_id);
  /// The last frame visits an earlier experience, at a measured offset.
  void addVisit(const DeadReckoning& path, std::int64_t experience, const UncertainPose& measured);
  /// The same at an unknown offset: only its heading (rad) is known.
  void addVisit(const DeadReckoning& path, std::int64_t experience, double relative_yaw);

  /// Adds a visit at an earlier slot, at a measured offset. The experience must have been created
  /// before this slot. Updates the anchors of the frames of `path`.
  void insertVisit(DeadReckoning& path, std::size_t slot, std::int64_t experience,
                   const UncertainPose& measured);

  /// Recomputes odometry links whose motions have changed from slot `first` on.
  void refresh(const DeadReckoning& path, std::size_t first);
  /// Whether the chain has a visit, i.e. a loop.
  bool visited() const { return last_visit_ > 0; }
  /// Whether loops or motions have changed since the last correction.
  bool pending() const { return pending_; }
  /// Moves the anchors to a minimum of the energy. On failure nothing changes.
  Status correct(const DeadReckoning& path, int iterations, double tolerance);
  /// The same from several starts (optimiseMultiStart); then rejects loops whose weight is below
  /// min_loop_weight.
  Status correctFinally(const DeadReckoning& path, int iterations, double tolerance);

  /// Slot of the frame that created the experience.
  std::size_t slotOf(std::int64_t experience) const { return origin(experience).slot; }
  Eigen::Isometry3d T_world_camera(const DeadReckoning& path, std::size_t slot) const;
  Eigen::Isometry3d T_world_experience(const DeadReckoning& path, std::int64_t experience) const;
  /// Pose of a frame relative to the experience of the last anchor up to it whose loop has at least
  /// min_loop_weight.
  ExperiencePose experiencePose(const DeadReckoning& path, std::size_t slot) const;
  /// The graph of experiences alone: each visit is merged with its experience. A rejected loop
  /// keeps its link, but the odometry link after it starts at the anchor before the visit. Only
  /// loop links cross gaps of the path.
  void graph(const DeadReckoning& path, MapGraph& graph) const;

  /// The state to save, besides that of DeadReckoning. Anchor::odometry is recomputed.
  const GrowingList<Anchor>& anchors() const { return anchors_; }
  /// What the loops taught about odometry.
  const PathCalibration& calibration() const { return calibration_; }
  const Assumptions& assumptions() const { return assumptions_; }
  /// Loops that the final correction has rejected.
  std::int64_t rejected() const { return rejected_; }
  std::size_t loopsWhenEstimated() const { return loops_when_estimated_; }
  /// After the final correction: distances of accepted loops from the map, in the standard
  /// deviations that were assumed for them.
  const std::vector<double>& residuals() const { return residuals_; }
  /// The saved state as it was read.
  struct State {
    GrowingList<Anchor> anchors;
    std::int64_t links = 0;
    std::int64_t loops = 0;
    bool pending = false;
    PathCalibration calibration;
    Assumptions assumptions;
    std::size_t loops_when_estimated = 0;
  };
  /// `state` must have passed the checks of saved_map.
  void restore(const DeadReckoning& path, State state);

 private:
  Anchor& append(const DeadReckoning& path);
  UncertainPose withModel(const UncertainPose& measured) const;
  PathParts parts() const;
  std::size_t originOf(const Anchor& visit) const;
  void alignPart(const DeadReckoning& path, const PathParts& before, std::size_t visit);
  /// Whether graph() has a link to anchor `i`. `previous`: the last anchor before it whose loop is
  /// not rejected.
  bool isLinked(std::size_t previous, std::size_t i) const;
  /// Adds the link to the last anchor to the counts of links and loops.
  void countLastLink();
  /// Counts all links again.
  void countLinks();
  void renumber(DeadReckoning& path, std::size_t i);
  /// Whether the map is corrected in space; otherwise in the plane (parameter `space`).
  bool isSpatial(const DeadReckoning& path) const;
  template <class G>
  PoseGraph<G> problem(const DeadReckoning& path, std::vector<typename G::Pose>& reckoned) const;
  template <class G>
  void rearrange(const PathParts& parts, const std::vector<typename G::Pose>& start,
                 OptimiserOptions options, std::size_t attempts, PoseGraph<G>& best,
                 OptimiserOutcome& outcome, BorderedSystem<G>& system) const;
  template <class G>
  Eigen::Isometry3d shiftOf(const DeadReckoning& path, std::size_t visit,
                            bool visit_is_later) const;
  void addVisit(const DeadReckoning& path, std::int64_t experience, const UncertainPose& offset,
                bool assumed);
  const Anchor& origin(std::int64_t experience) const;
  template <class G>
  PoseLink<G> odometryLink(const DeadReckoning& path, std::size_t i, const PathParts& parts) const;
  template <class G>
  PoseLink<G> loopLink(const DeadReckoning& path, std::size_t i) const;
  /// Refined: once more from where the map is, without the loops that are rejected.
  enum class Effort : std::uint8_t { Online, Final, Refined };
  Status optimiseAll(const DeadReckoning& path, OptimiserOptions options, Effort effort);
  template <class G>
  Status optimiseIn(const DeadReckoning& path, OptimiserOptions options, Effort effort);
  /// The slot at which the path around anchor `i` was nearest to the anchor's experience: a visit
  /// is decided metres before or after the path passes its experience.
  std::size_t slotOfPassing(const DeadReckoning& path, std::size_t i) const;
  /// Time that the path took from the experience of anchor `before` to anchor `i`.
  double seconds(const DeadReckoning& path, std::size_t before, std::size_t i) const;
  Link mergedLink(const DeadReckoning& path, std::size_t before, std::size_t i) const;
  template <class G>
  Status recalibrate(const OptimiserOptions& options, PoseGraph<G>& graph,
                     OptimiserOutcome& outcome, BorderedSystem<G>& system);
  /// A map under assumptions that were learned from one start.
  template <class G>
  struct Learned {
    PoseGraph<G> graph = {};
    Assumptions assumed = {};
    OptimiserOutcome outcome = {};
    double posterior = -std::numeric_limits<double>::infinity();  ///< log
  };
  template <class G>
  Status learnFrom(const OptimiserOptions& options, Learned<G>& learned, BorderedSystem<G>& system);
  template <class G>
  Status refine(const OptimiserOptions& options, const std::vector<typename G::Pose>& reckoned,
                PoseGraph<G>& graph);
  template <class G>
  void centreAssumedLoops(PoseGraph<G>& graph) const;
  template <class G>
  void noteCalibration(const PoseGraph<G>& graph, BorderedSystem<G>& system);
  template <class G>
  void noteResiduals(const PoseGraph<G>& graph);
  template <class G>
  void holdErrors(PoseGraph<G>& graph, bool always);
  template <class G>
  void apply(const std::vector<typename G::Pose>& reckoned, const PoseGraph<G>& graph);

  Parameters parameters_;
  GrowingList<Anchor> anchors_;
  std::vector<std::size_t> of_experience_;  ///< anchor that created each experience
  std::vector<std::size_t> begins_ = {0};   ///< anchors at which parts of the path begin
  std::int64_t links_ = 0;
  std::int64_t loops_ = 0;
  std::int64_t rejected_ = 0;
  std::size_t last_visit_ = 0;  ///< anchor; 0 for none
  bool measured_ = false;       ///< a visit has a measured offset
  bool pending_ = false;
  PathCalibration calibration_;
  Assumptions assumptions_;
  std::size_t loops_when_estimated_ = 0;  ///< at the last estimate of the steady errors
  std::vector<double> residuals_;         ///< of accepted loops, after the final correction
};

}  // namespace tolman::experience_map
