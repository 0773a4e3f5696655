// SPDX-License-Identifier: BSD-3-Clause
#include "g2o_edges.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <sstream>
#include <string>

#include "base/text_file.hpp"

namespace tolman::motion_log {
namespace {

// Bound of metres and radians: farther than any vehicle drives; the poses of all frames are finite.
constexpr double kFarthest = 1e9;
constexpr double kMaxTurn = 2 * std::numbers::pi + 1e-3;  // rad, of one edge

Status badLine(const std::filesystem::path& file, int line, const std::string& what) {
  return Status::invalidInput(file.string() + ":" + std::to_string(line) + ": " + what);
}

/// What is wrong in a line.
struct LineError {
  std::string what;
};

/// A pose or motion. Spatial ones become planar when all of the file is known.
struct Motion {
  PlanarPose planar;                   ///< x forward, y left
  std::optional<Eigen::Isometry3d> T;  ///< of a spatial one

  PlanarPose flat(bool in_camera_axes) const {
    if (!T) return planar;
    if (in_camera_axes) return toPlanar(*T);
    const Eigen::Matrix3d R = T->linear();
    return {T->translation().x(), T->translation().y(), std::atan2(R(1, 0), R(0, 0))};
  }
};

/// Tags of poses and of edges between them, with what follows the ids.
struct Kind {
  std::string_view tag;
  std::size_t ids;
  bool spatial;
};
constexpr std::array kKinds = {Kind{"EDGE_SE2", 2, false}, Kind{"EDGE_SE3:QUAT", 2, true},
                               Kind{"VERTEX_SE2", 1, false}, Kind{"VERTEX_SE3:QUAT", 1, true}};

[[noreturn]] void refuseFields(const Kind& kind) {
  throw LineError{
      std::string("needs ") + (kind.ids == 2 ? "two ids" : "an id") + " from 0 and " +
      (kind.spatial ? "seven numbers (x y z qx qy qz qw)" : "three numbers (dx dy dtheta)") +
      " of at most 1e9; correct it"};
}

double numberIn(const std::string& word, const std::string& otherwise) {
  if (const std::optional<double> number = text_encoding::parseNumber(word)) return *number;
  const std::string_view why = text_encoding::numberProblem(word);
  if (why.find("small") == std::string_view::npos) throw LineError{otherwise};
  throw LineError{"'" + word.substr(0, 24) + "' " + std::string(why) + "; correct it"};
}

std::int64_t idIn(const std::string& word, const Kind& kind) {
  std::int64_t id = -1;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, id);
  if (error != std::errc() || rest != end || id < 0) refuseFields(kind);
  return id;
}

double nearNumberIn(const std::string& word, const Kind& kind) {
  double number = kFarthest * 2;
  try {
    number = numberIn(word, "");
  } catch (const LineError& error) {
    if (!error.what.empty()) throw;
  }
  if (std::abs(number) > kFarthest) refuseFields(kind);
  return number;
}

/// Checks the information values of an edge, the upper triangle row by row. They are not used, but
/// the check detects lines that were cut within a number.
void checkInformation(std::span<const std::string> words, bool spatial) {
  const int size = spatial ? 6 : 3;
  const auto needed = static_cast<std::size_t>(size * (size + 1) / 2);
  if (words.size() != needed) {
    throw LineError{"has " + std::to_string(words.size()) + " information values instead of " +
                    (spatial ? "21 after x y z qx qy qz qw" : "six after dx dy dtheta") +
                    "; the file may be cut off"};
  }
  Eigen::MatrixXd matrix(size, size);
  std::size_t next = 0;
  for (int row = 0; row < size; ++row) {
    for (int column = row; column < size; ++column) {
      matrix(row, column) = matrix(column, row) =
          numberIn(words[next++], "has an information value that is no number; correct it");
    }
  }
  if (matrix.llt().info() == Eigen::Success) return;
  throw LineError{
      "has information values that are no positive definite matrix; write 1 0 0 1 0 1 where it "
      "is not known"};
}

Motion motionIn(std::span<const std::string> words, const Kind& kind) {
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < words.size(); ++i) v[i] = nearNumberIn(words[i], kind);
  Motion motion;
  if (!kind.spatial) {
    motion.planar = {v[0], v[1], v[2]};
    if (kind.ids == 2 && std::abs(v[2]) > kMaxTurn) {
      throw LineError{"turns by more than a full turn; dtheta is in radians, not degrees"};
    }
    return motion;
  }
  constexpr double kUnit = 0.01;  // digits that files print
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (std::abs(q.norm() - 1) > kUnit) {
    throw LineError{"has no unit quaternion (qx qy qz qw); correct it"};
  }
  motion.T = Eigen::Translation3d(v[0], v[1], v[2]) * q.normalized();
  return motion;
}

/// Reads a file line by line.
class GraphReader {
 public:
  void read(const text_encoding::TextLine& line) {
    std::istringstream fields(line.text);
    std::string tag;
    fields >> tag;
    const auto* const kind = std::ranges::find(kKinds, tag, &Kind::tag);
    if (kind == kKinds.end()) return passOver(tag);
    std::vector<std::string> words;
    for (std::string word; fields >> word;) words.push_back(word);
    const std::size_t numbers = kind->spatial ? 7 : 3;
    if (words.size() < kind->ids + numbers) refuseFields(*kind);
    const std::span<const std::string> all(words);
    const Motion motion = motionIn(all.subspan(kind->ids, numbers), *kind);
    const std::int64_t first = idIn(words[0], *kind);
    if (kind->ids == 1) {
      vertices_[first] = motion;
      return;
    }
    edges_.push_back({first, idIn(words[1], *kind), {}, line.number});
    motions_.push_back(motion);
    checkInformation(all.subspan(kind->ids + numbers), kind->spatial);
  }

  GraphFile finish(const std::string& file) {
    const Eigen::Vector3d path = wayBySpatialAxes();
    const bool camera = path.z() > path.x();
    GraphFile graph;
    for (std::size_t i = 0; i < edges_.size(); ++i) edges_[i].motion = motions_[i].flat(camera);
    graph.edges = std::move(edges_);
    for (const auto& [id, pose] : vertices_) graph.vertices[id] = pose.flat(camera);
    if (!path.isZero()) graph.findings.push_back(flattened(file, camera, path));
    for (const auto& [tag, count] : unused_) {
      graph.findings.push_back({Finding::Severity::Warning, file,
                                "has " + std::to_string(count) + " " + tag +
                                    ", which are not used: only edges between poses are"});
    }
    return graph;
  }

 private:
  void passOver(const std::string& tag) {
    if (tag.starts_with("EDGE_")) {
      ++unused_[tag];
    } else if (!tag.starts_with("VERTEX_") && !tag.starts_with("PARAMS_") && tag != "FIX") {
      throw LineError{"is no line of a g2o file (EDGE_SE2, EDGE_SE3:QUAT, VERTEX_..., FIX)"};
    }
  }

  /// m along each axis of the vehicle, of edges or else of vertices.
  Eigen::Vector3d wayBySpatialAxes() const {
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    for (const Motion& motion : motions_) {
      if (motion.T) way += motion.T->translation().cwiseAbs();
    }
    const Motion* before = nullptr;
    for (const auto& [id, pose] : vertices_) {
      if (!motions_.empty() || !pose.T) break;
      if (before != nullptr) way += (before->T->inverse() * *pose.T).translation().cwiseAbs();
      before = &pose;
    }
    return way;
  }

  static Finding flattened(const std::string& file, bool camera, const Eigen::Vector3d& path) {
    constexpr double kFlat = 0.1;  // of the way; steeper than roads
    const double upwards = camera ? path.y() : path.z();
    const double along = path.sum() - upwards;
    return {upwards > kFlat * along ? Finding::Severity::Warning : Finding::Severity::Note, file,
            std::string("is spatial; it is used as planar motion in ") +
                (camera ? "camera axes (z forward, x right)" : "the axes x forward, y left") +
                ", without the " + text_encoding::fixed(upwards, 1) + " m up and down beside the " +
                text_encoding::fixed(along, 1) + " m along x and y"};
  }

  std::vector<Edge> edges_;
  std::vector<Motion> motions_;  ///< of the edges
  std::map<std::int64_t, Motion> vertices_;
  std::map<std::string, int> unused_;  ///< edges by their tags
};

}  // namespace

Result<GraphFile> readGraph(const std::filesystem::path& file) {
  const Result<std::string> text = text_encoding::readText(file);
  if (!text.isOk()) return text.status();
  GraphReader reader;
  for (const text_encoding::TextLine& line : text_encoding::contentLines(text.value())) {
    try {
      reader.read(line);
    } catch (const LineError& error) {
      return badLine(file, line.number, error.what);
    }
  }
  return reader.finish(file.string());
}

namespace {

PlanarPose inverse(const PlanarPose& motion) { return between(motion, {}); }

/// The drive of a graph that was read; throws what is wrong.
Drive driveOf(GraphFile graph, const std::string& file) {
  Drive drive;
  drive.findings = std::move(graph.findings);
  for (const auto& [id, pose] : graph.vertices) drive.ids.push_back(id);
  for (const Edge& edge : graph.edges) drive.ids.insert(drive.ids.end(), {edge.from, edge.to});
  std::ranges::sort(drive.ids);
  drive.ids.erase(std::ranges::unique(drive.ids).begin(), drive.ids.end());
  const auto frameOf = [&](std::int64_t id) {
    return std::ranges::lower_bound(drive.ids, id) - drive.ids.begin();
  };
  int repeated = 0;
  std::vector<const Edge*> steps(drive.ids.size());  // to each frame from the one before
  for (const Edge& edge : graph.edges) {
    const auto from = frameOf(edge.from);
    const auto to = frameOf(edge.to);
    const Edge*& step = steps[static_cast<std::size_t>(std::max(from, to))];
    if (std::abs(from - to) != 1) {
      drive.others.push_back(edge);
    } else if (step == nullptr) {
      step = &edge;
    } else {
      ++repeated;
    }
  }
  drive.poses.emplace_back();
  int guessed = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const std::int64_t before = drive.ids[i - 1];
    const std::int64_t here = drive.ids[i];
    PlanarPose motion;
    if (steps[i] != nullptr) {
      motion = steps[i]->from == before ? steps[i]->motion : inverse(steps[i]->motion);
    } else if (graph.vertices.contains(before) && graph.vertices.contains(here)) {
      motion = between(graph.vertices[before], graph.vertices[here]);
      ++guessed;
    } else {
      throw LineError{"no edge leads from " + std::to_string(before) + " to " +
                      std::to_string(here) + ", and there are no vertices of the two; add one"};
    }
    drive.poses.push_back(compose(drive.poses.back(), motion));
  }
  const auto warn = [&](int count, const std::string& what) {
    if (count == 0 || graph.edges.empty()) return;
    drive.findings.push_back(
        {Finding::Severity::Warning, file, "has " + std::to_string(count) + what});
  };
  warn(guessed, " steps without an edge; their motion is that of the vertices");
  warn(repeated, " more edges between successive poses; the first of each two is used");
  return drive;
}

}  // namespace

Result<Drive> readDrive(const std::filesystem::path& file) {
  Result<GraphFile> graph = readGraph(file);
  if (!graph.isOk()) return graph.status();
  if (graph.value().edges.empty() && graph.value().vertices.size() < 2) {
    return Status::invalidInput(file.string() + " has no edges");
  }
  try {
    return driveOf(std::move(graph).value(), file.string());
  } catch (const LineError& error) {
    return Status::invalidInput(file.string() + ": " + error.what);
  }
}

std::vector<std::string> unitDoubts(const std::vector<PlanarPose>& poses, double rate) {
  // The default limits of `checks`. In degrees every turn of more than 0.17 rad/s exceeds the
  // first, in mm every way of more than 0.1 m/s the second. The same turn does not last: in drives
  // in degrees 5 to 30 % of the steps are of curves.
  constexpr double kFastestTurn = 10;  // rad/s
  constexpr double kShareOfTurns = 0.01;
  constexpr double kTopSpeed = 100;  // m/s
  constexpr double kShareOfWays = 0.5;
  const std::size_t steps = poses.empty() ? 0 : poses.size() - 1;
  std::size_t turns = 0;
  std::size_t ways = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const PlanarPose step = between(poses[i - 1], poses[i]);
    if (std::abs(step.theta) * rate > kFastestTurn) ++turns;
    if (std::hypot(step.x, step.y) * rate > kTopSpeed) ++ways;
  }
  const auto exceed = [&](std::size_t many, double share) {
    return static_cast<double>(many) > share * static_cast<double>(steps);
  };
  const auto ofSteps = [&](std::size_t many) {
    return std::to_string(many) + " of " + std::to_string(steps) + " steps";
  };
  std::vector<std::string> texts;
  if (exceed(turns, kShareOfTurns)) {
    texts.push_back(ofSteps(turns) +
                    " turn faster than 10 rad/s; are its angles in degrees? They must be in "
                    "radians; or is `rate` too high?");
  }
  if (exceed(ways, kShareOfWays)) {
    texts.push_back(
        ofSteps(ways) +
        " are faster than 100 m/s; are its lengths in mm or cm? They must be in metres; "
        "or is `rate` too high?");
  }
  return texts;
}

}  // namespace tolman::motion_log
