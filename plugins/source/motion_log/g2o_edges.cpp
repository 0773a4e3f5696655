// SPDX-License-Identifier: BSD-3-Clause
#include "g2o_edges.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include "text_encoding.hpp"

namespace tolman::motion_log {
namespace {

constexpr std::int64_t kMaxIds = 100'000'000;
// Bound of metres and radians: farther than any vehicle drives; the poses of all frames are finite.
constexpr double kFarthest = 1e9;
constexpr double kMaxTurn = 2 * std::numbers::pi + 1e-3;  // rad, of one edge

Status badLine(const std::filesystem::path& file, int line, const std::string& what) {
  std::string message = file.string();
  message.append(":").append(std::to_string(line)).append(": ").append(what);
  return Status::invalidInput(message);
}

std::optional<Edge> parseEdge(std::istringstream& fields, int line) {
  Edge edge;
  edge.line = line;
  fields >> edge.from >> edge.to >> edge.motion.x >> edge.motion.y >> edge.motion.theta;
  const auto isNear = [](double number) { return std::abs(number) <= kFarthest; };  // no NaN
  const bool sound = fields && isNear(edge.motion.x) && isNear(edge.motion.y) &&
                     isNear(edge.motion.theta) && edge.from >= 0 && edge.to >= 0 &&
                     edge.from < kMaxIds && edge.to < kMaxIds;
  return sound ? std::optional(edge) : std::nullopt;
}

/// The error in the information values in the rest of a line; empty if there is none. The values
/// are not used, but the check detects lines that were cut within a number.
std::string informationProblem(std::istringstream& fields) {
  std::vector<std::string> rest;
  for (std::string word; fields >> word;) rest.push_back(word);
  if (rest.size() != 6) {
    return "has " + std::to_string(rest.size()) +
           " information values instead of six after dx dy dtheta; the file may be cut off";
  }
  std::array<double, 6> v{};  // upper triangle, row by row
  for (std::size_t i = 0; i < v.size(); ++i) {
    std::istringstream word(rest[i]);
    if (!(word >> v[i]) || word.peek() != std::istringstream::traits_type::eof()) {
      return "has an information value that is no number; correct it";
    }
  }
  const auto& [xx, xy, xt, yy, yt, tt] = v;
  const double minor = xx * yy - xy * xy;
  const double determinant =
      xx * (yy * tt - yt * yt) - xy * (xy * tt - yt * xt) + xt * (xy * yt - yy * xt);
  if (xx > 0 && minor > 0 && determinant > 0) return "";
  return "has information values that are no positive definite matrix; write 1 0 0 1 0 1 where it "
         "is not known";
}

/// Reads a line, without the byte order mark that some editors write before UTF-8.
bool readLine(std::ifstream& stream, std::string& line, int& number) {
  if (!std::getline(stream, line)) return false;
  if (++number == 1) line = text_encoding::withoutMark(line);
  return true;
}

bool isPassedOver(const std::string& tag) {
  return tag.empty() || tag.front() == '#' || tag.starts_with("VERTEX") || tag == "FIX";
}

}  // namespace

Result<std::vector<Edge>> readEdges(const std::filesystem::path& file) {
  std::error_code ignored;  // a pipe would wait for its writer
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, ignored)) stream.open(file);
  if (!stream.is_open()) {
    return Status::invalidInput(file.string() + " is not a readable file; check the path");
  }
  if (const std::string problem = text_encoding::encodingProblemOf(file); !problem.empty()) {
    return Status::invalidInput(file.string() + ": " + problem);
  }
  std::vector<Edge> edges;
  int number = 0;
  for (std::string line; readLine(stream, line, number);) {
    std::istringstream fields(line);
    std::string tag;
    fields >> tag;
    if (isPassedOver(tag)) continue;
    if (tag != "EDGE_SE2") {
      return badLine(file, number, "is no EDGE_SE2; a motion log has planar edges only");
    }
    const std::optional<Edge> edge = parseEdge(fields, number);
    if (!edge) {
      return badLine(
          file, number,
          "needs two ids from 0 and three numbers (dx dy dtheta) of at most 1e9; correct it");
    }
    if (std::abs(edge->motion.theta) > kMaxTurn) {
      return badLine(file, number,
                     "turns by more than a full turn; dtheta is in radians, not degrees");
    }
    const std::string problem = informationProblem(fields);
    if (!problem.empty()) return badLine(file, number, problem);
    edges.push_back(*edge);
  }
  return edges;
}

Result<std::vector<PlanarPose>> readChain(const std::filesystem::path& file) {
  const Result<std::vector<Edge>> edges = readEdges(file);
  if (!edges.isOk()) return edges.status();
  std::vector<PlanarPose> poses = {{}};
  for (const Edge& edge : edges.value()) {
    const auto last = static_cast<std::int64_t>(poses.size()) - 1;
    if (edge.from != last || edge.to != last + 1) {
      return badLine(file, edge.line,
                     "should lead from " + std::to_string(last) + " to " +
                         std::to_string(last + 1) + "; sort the edges and fill the gaps");
    }
    poses.push_back(compose(poses.back(), edge.motion));
  }
  if (poses.size() < 2) return Status::invalidInput(file.string() + " has no edges");
  return poses;
}

}  // namespace tolman::motion_log
