// SPDX-License-Identifier: BSD-3-Clause
#include "g2o_edges.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include "base/number_text.hpp"
#include "base/text_file.hpp"

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

constexpr const char* kNeeded =
    "needs two ids from 0 and three numbers (dx dy dtheta) of at most 1e9; correct it";

/// What is wrong in a line.
struct LineError {
  std::string what;
};

double numberIn(const std::string& word, const char* otherwise) {
  if (const std::optional<double> number = text_encoding::parseNumber(word)) return *number;
  const std::string_view why = text_encoding::numberProblem(word);
  if (why.find("small") == std::string_view::npos) throw LineError{otherwise};
  throw LineError{"'" + word.substr(0, 24) + "' " + std::string(why) + "; correct it"};
}

std::int64_t idIn(const std::string& word) {
  std::istringstream digits(word);
  std::int64_t id = -1;
  const bool whole = digits >> id && digits.peek() == std::istringstream::traits_type::eof();
  if (!whole || id < 0 || id >= kMaxIds) throw LineError{kNeeded};
  return id;
}

double nearNumberIn(const std::string& word) {
  const double number = numberIn(word, kNeeded);
  if (std::abs(number) > kFarthest) throw LineError{kNeeded};
  return number;
}

/// Checks the information values after the five fields of an edge. They are not used, but the check
/// detects lines that were cut within a number.
void checkInformation(const std::vector<std::string>& words) {
  std::array<double, 6> v{};  // upper triangle, row by row
  if (words.size() != 5 + v.size()) {
    throw LineError{"has " + std::to_string(words.size() - 5) +
                    " information values instead of six after dx dy dtheta; the file may be cut "
                    "off"};
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    v[i] = numberIn(words[5 + i], "has an information value that is no number; correct it");
  }
  const auto& [xx, xy, xt, yy, yt, tt] = v;
  const double minor = xx * yy - xy * xy;
  const double determinant =
      xx * (yy * tt - yt * yt) - xy * (xy * tt - yt * xt) + xt * (xy * yt - yy * xt);
  if (xx > 0 && minor > 0 && determinant > 0) return;
  throw LineError{
      "has information values that are no positive definite matrix; write 1 0 0 1 0 1 where it "
      "is not known"};
}

/// An edge from the words after its tag. Throws LineError.
Edge parseEdge(std::istringstream& fields, int line) {
  std::vector<std::string> words;
  for (std::string word; fields >> word;) words.push_back(word);
  if (words.size() < 5) throw LineError{kNeeded};
  Edge edge;
  edge.line = line;
  edge.from = idIn(words[0]);
  edge.to = idIn(words[1]);
  edge.motion = {nearNumberIn(words[2]), nearNumberIn(words[3]), nearNumberIn(words[4])};
  if (std::abs(edge.motion.theta) > kMaxTurn) {
    throw LineError{"turns by more than a full turn; dtheta is in radians, not degrees"};
  }
  checkInformation(words);
  return edge;
}

bool isPassedOver(const std::string& tag) { return tag.starts_with("VERTEX") || tag == "FIX"; }

}  // namespace

Result<std::vector<Edge>> readEdges(const std::filesystem::path& file) {
  const Result<std::string> text = text_encoding::readText(file);
  if (!text.isOk()) return text.status();
  std::vector<Edge> edges;
  for (const text_encoding::TextLine& line : text_encoding::contentLines(text.value())) {
    std::istringstream fields(line.text);
    std::string tag;
    fields >> tag;
    if (isPassedOver(tag)) continue;
    if (tag != "EDGE_SE2") {
      return badLine(file, line.number, "is no EDGE_SE2; a motion log has planar edges only");
    }
    try {
      edges.push_back(parseEdge(fields, line.number));
    } catch (const LineError& error) {
      return badLine(file, line.number, error.what);
    }
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
