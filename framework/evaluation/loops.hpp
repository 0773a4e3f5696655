// SPDX-License-Identifier: BSD-3-Clause
// Loops: which frames of a drive revisit a place by the true poses, how the links and views of a
// run compare with them, and precision and recall of claims that a place was seen before.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

enum class Heading : std::uint8_t { Same, Opposite };
inline constexpr std::array<std::string_view, 2> kHeadingNames = {"same", "opposite"};
constexpr std::span<const std::string_view> enumNames(Heading) { return kHeadingNames; }

/// What counts as the same place. Headings are those of the optical axes. Headings between the two
/// angles count as neither direction, because the views overlap too little.
struct RevisitRule {
  double distance_m = 5;            ///< largest distance of the two positions
  double path_m = 20;               ///< the path driven in between is longer than this
  double same_below_deg = 45;       ///< headings differ by less: same direction
  double opposite_above_deg = 135;  ///< headings differ by more: opposite direction
  double height_m = 0;  ///< places that are further apart in height (camera's y) differ; 0: off
};

/// The relation of the headings alone, whatever the positions; none for neither direction.
std::optional<Heading> headingBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                                      const RevisitRule& rule = {});

/// Whether two positions are the same place, whatever the headings.
bool isSamePlace(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const RevisitRule& rule);

/// Frame `frame` is at the place of frame `earlier`.
struct Revisit {
  std::int64_t frame = 0;
  std::int64_t earlier = 0;
  Heading heading = Heading::Same;
  double distance_m = 0;
};

/// For each frame and heading the nearest earlier frame that the rule allows (of equally near ones
/// the earliest), in the order of frames, same before opposite. Poses must be finite.
std::vector<Revisit> findRevisits(const Trajectory& truth, const RevisitRule& rule = {});

/// loops.txt: a comment line, then `frame earlier same|opposite distance_m`.
std::string loopsText(std::span<const Revisit> revisits, const RevisitRule& rule = {});

/// A loop link of the map against the truth. A link of a view with a measured pose is judged by the
/// error of that pose, height included: the place may be far ahead and the pose right. It is false
/// if the error is over a metre and over five of its standard deviations, or over 10 m. Others,
/// and where the truth has no orientations, are false if their ends are more than 10 m apart.
struct JudgedLoop {
  std::int64_t link = -1;
  std::int64_t frame = -1;        ///< at which the loop was seen
  std::int64_t earlier = -1;      ///< of the experience to which it returns
  bool rejected = false;          ///< by the map
  double residual = -1;           ///< of the map, standard deviations; -1: not known
  std::optional<double> apart_m;  ///< its ends
  std::optional<double> error_m;  ///< of the measured pose
  std::optional<double> error_sigmas;
  std::optional<bool> is_true;  ///< none where an end has no true pose
};

/// The frame at which each template was made.
std::map<std::int64_t, std::int64_t> framesOfTemplates(const std::vector<PlaceObservation>& places);

/// All loop links, in the order of their ids. Places that are more than `storey_height` metres
/// apart in height (y of the true poses) are different ones; 0: heights are ignored.
std::vector<JudgedLoop> judgeLoops(const MapGraph& graph,
                                   const std::vector<PlaceObservation>& places,
                                   const Trajectory& truth, double storey_height = 0);

/// Links and views are true or false if both ends have a true pose. Others are unknown: in a
/// continued run, for example, true poses of the earlier session are those of another world.
struct LoopFigures {
  std::int64_t true_links = 0;  ///< loop links of the final graph (JudgedLoop::is_true)
  std::int64_t false_links = 0;
  std::int64_t true_views = 0;  ///< familiar views, at most 10 m from where the view was learned
  std::int64_t false_views = 0;
  std::int64_t unknown_links = 0;  ///< loop links of the final graph
  std::int64_t unknown_views = 0;  ///< familiar views
  /// Number of true views with the end of a true loop link (rejected or not) at most 5.5 m of
  /// driven path away: one loop spacing and half a metre.
  std::int64_t true_views_closed = 0;
};

/// `loops` and `storey_height`: of judgeLoops().
LoopFigures loopFigures(const std::vector<JudgedLoop>& loops,
                        const std::vector<PlaceObservation>& places, const Trajectory& truth,
                        double storey_height = 0);

nlohmann::ordered_json toJson(const LoopFigures& figures);

/// `query` shows the place of the earlier image `place`.
struct PlaceClaim {
  std::int64_t query = -1;
  std::int64_t place = -1;
  double score = 0;  ///< a smaller score is more certain
  bool right = false;
  Eigen::Isometry3d T_place_query = Eigen::Isometry3d::Identity();  ///< as it is claimed
  double error_m = 0;  ///< claimed position to the true one, if that was judged
};

/// Precision and recall if only claims with at most this score are made.
struct PrecisionRecall {
  double score = 0;
  std::int64_t claims = 0;
  double precision = 1;  ///< share of the claims that are right
  double recall = 0;     ///< number of right claims over number of findable queries
};

/// One point for each score, ascending. `findable`: number of queries that have a true place.
std::vector<PrecisionRecall> precisionRecall(std::vector<PlaceClaim> claims, std::int64_t findable);

/// Largest recall at which the precision is at least `precision`; 0 where it never is.
double recallAt(const std::vector<PrecisionRecall>& curve, double precision);

}  // namespace tolman::evaluation
