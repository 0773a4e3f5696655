// SPDX-License-Identifier: BSD-3-Clause
// What a recorded run means: trajectories, graph, counters.
#include <algorithm>
#include <set>
#include <unordered_map>

#include "record/run_reader.hpp"

namespace tolman::record {
namespace {

/// Ids must be dense from 0, as the records promise.
template <Record R>
std::vector<R> denseRows(const Database& database) {
  std::vector<R> rows;
  forEachRow<R>(database, "", [&](const R& row) {
    if (row.id != static_cast<std::int64_t>(rows.size())) {
      throw BadRow(std::string(R::kRecord) + " " + std::to_string(rows.size()) + " is missing");
    }
    rows.push_back(row);
  });
  return rows;
}

using Revisions = std::unordered_map<std::int64_t, Eigen::Isometry3d>;

Revisions lastRevisions(const Database& database) {
  Revisions revisions;
  forEachRow<MotionRevision>(database, "", [&](const MotionRevision& revision) {
    revisions[revision.frame] = revision.T_previous_current;
  });
  return revisions;
}

/// The one number that a query gives.
std::int64_t integerOf(const Database& database, const std::string& query) {
  Statement row(database, query);
  row.step();
  return row.integer();
}

std::int64_t count(const Database& database, const std::string& table_and_condition) {
  return integerOf(database, "SELECT count(*) FROM " + table_and_condition);
}

}  // namespace

const Result<std::vector<StampedPose>>& RunReader::odometry() const {
  return once(odometry_, [&] {
    std::vector<StampedPose> poses;
    std::set<std::int64_t> beginnings;
    forEachRow<Session>(database_, "",
                        [&](const Session& row) { beginnings.insert(row.first_frame); });
    const Revisions revisions = lastRevisions(database_);
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
    forEachRow<Motion>(database_, "", [&](const Motion& motion) {
      const auto revised = revisions.find(motion.frame);
      const Eigen::Isometry3d& T_previous_current =
          revised != revisions.end() ? revised->second : motion.T_previous_current;
      if (beginnings.contains(motion.frame)) {
        T_world_camera.setIdentity();
      } else if (!poses.empty()) {
        T_world_camera = normalised(T_world_camera * T_previous_current);
      }
      poses.push_back({motion.frame, motion.stamp_ns, T_world_camera});
    });
    return poses;
  });
}

const Result<std::vector<StampedPose>>& RunReader::map() const {
  return once(map_, [&] {
    std::vector<StampedPose> poses;
    const auto experiences = denseRows<Experience>(database_);
    const auto known = static_cast<std::int64_t>(experiences.size());
    std::unordered_map<std::int64_t, Eigen::Isometry3d> settled;
    forEachRow<FinalPose>(database_, "",
                          [&](const FinalPose& row) { settled[row.frame] = row.T_world_camera; });
    forEachRow<MapUpdate>(database_, "", [&](const MapUpdate& update) {
      Eigen::Isometry3d T_world_camera = update.T_world_camera;
      if (const auto last_word = settled.find(update.frame); last_word != settled.end()) {
        T_world_camera = last_word->second;
      } else if (update.experience >= 0 && update.experience < known) {
        const auto& experience = experiences[static_cast<std::size_t>(update.experience)];
        T_world_camera = experience.T_world_experience * update.T_experience_camera;
      }
      poses.push_back({update.frame, update.stamp_ns, T_world_camera});
    });
    return poses;
  });
}

Result<std::vector<Session>> RunReader::sessions() const { return records<Session>(); }

Result<std::int64_t> RunReader::nextFrame() const {
  return answered(name_, [&] {
    return integerOf(database_, "SELECT coalesce(max(\"frame\"), -1) + 1 FROM \"frame\"");
  });
}

Result<std::vector<StampedPose>> RunReader::truth() const {
  return answered(name_, [&] {
    std::vector<StampedPose> poses;
    forEachRow<Frame>(database_, "WHERE \"has_truth\" <> 0", [&](const Frame& frame) {
      poses.push_back({frame.frame, frame.stamp_ns, frame.T_world_camera_truth});
    });
    return poses;
  });
}

const Result<MapGraph>& RunReader::graph() const {
  return once(graph_, [&] {
    MapGraph graph;
    graph.experiences = denseRows<Experience>(database_);
    graph.links = denseRows<Link>(database_);
    const auto count = static_cast<std::int64_t>(graph.experiences.size());
    for (const Link& link : graph.links) {
      if (std::min(link.from, link.to) < 0 || std::max(link.from, link.to) >= count) {
        throw BadRow("link " + std::to_string(link.id) + " ends at no experience");
      }
    }
    graph.version =
        integerOf(database_, "SELECT coalesce(max(\"version\"), 0) FROM \"map_update\"");
    return graph;
  });
}

Result<bool> RunReader::scaleKnown() const {
  return answered(name_, [&] {
    Statement last(database_, "SELECT \"scale_known\" FROM \"motion\" ORDER BY rowid DESC LIMIT 1");
    return !last.step() || last.integer() != 0;
  });
}

Result<Counters> RunReader::counters() const {
  return answered(name_, [&] {
    Counters counters;
    counters.frames = count(database_, "\"frame\"");
    counters.lost = count(database_, "\"motion\" WHERE \"state\" = 'lost'");
    counters.templates = count(database_, "\"place\" WHERE \"recognition\" = 'novel'");
    counters.experiences = count(database_, "\"experience\"");
    counters.links = count(database_, "\"link\"");
    counters.loops = count(database_, "\"link\" WHERE \"kind\" = 'loop'");
    Statement stamps(database_,
                     "SELECT coalesce(min(\"stamp_ns\"), 0), coalesce(max(\"stamp_ns\"), 0)"
                     " FROM \"frame\"");
    stamps.step();
    counters.first_stamp_ns = stamps.integer();
    counters.last_stamp_ns = stamps.integer();
    return counters;
  });
}

}  // namespace tolman::record
