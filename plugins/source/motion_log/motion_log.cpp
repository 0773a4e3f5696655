// SPDX-License-Identifier: BSD-3-Clause
#include "motion_log.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

namespace tolman::motion_log {
namespace fs = std::filesystem;

namespace {

/// Sensor values are floats.
template <class T>
float f(T value) {
  return static_cast<float>(value);
}

/// FNV-1a hash of the poses; its upper 24 bits, which a float holds exactly.
float digest(const std::vector<PlanarPose>& poses) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const PlanarPose& pose : poses) {
    for (const double number : {pose.x, pose.y, pose.theta}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3ULL;
    }
  }
  return f(hash >> 40U);
}

}  // namespace

Status MotionLog::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  return ready_ = load(context.findings);
}

Status MotionLog::loadTruth(const fs::path& file) {
  Result<Drive> read = readDrive(file);
  if (!read.isOk()) return read.status();
  truth_ = std::move(read.value().poses);
  if (truth_.size() == poses_.size()) return Status::ok();
  return Status::invalidInput(file.string() + " has " + std::to_string(truth_.size()) +
                              " poses, the odometry " + std::to_string(poses_.size()) +
                              "; give the truth of this sequence");
}

Status MotionLog::load(FindingCollector& findings) {
  std::error_code ignored;
  const fs::path path = parameters_.path;
  const bool is_folder = !fs::is_regular_file(path, ignored);
  const fs::path folder = is_folder ? path : path.parent_path();
  const fs::path file = is_folder ? folder / parameters_.odometry : path;
  Result<Drive> drive = readDrive(file);
  if (!drive.isOk()) return drive.status();
  poses_ = std::move(drive.value().poses);
  drive_ = digest(poses_);
  for (const Finding& finding : drive.value().findings) findings.add(finding);
  const auto reportUnits = [&](const fs::path& of, const std::vector<PlanarPose>& poses) {
    for (const std::string& doubt : unitDoubts(poses, parameters_.rate)) {
      findings.add({Finding::Severity::Warning, of.string(), doubt});
    }
  };
  reportUnits(file, poses_);
  // The file of a default name may be missing beside a graph; one that was named, or a link to
  // nothing, may not.
  const auto isThere = [&](const std::string& name, const std::string& usual, bool optional) {
    if (name.empty() || (name == usual && !is_folder)) return false;
    return name != usual || !optional || fs::exists(fs::symlink_status(folder / name, ignored));
  };
  Status status = addCandidates(file, drive.value().others, drive.value().ids, findings);
  if (isThere(parameters_.truth, Parameters().truth, true)) {
    if (status.isOk()) status = loadTruth(folder / parameters_.truth);
    reportUnits(folder / parameters_.truth, truth_);
  }
  if (isThere(parameters_.candidates, Parameters().candidates, !candidates_.empty())) {
    const Result<GraphFile> graph = readGraph(folder / parameters_.candidates);
    if (status.isOk()) status = graph.status();
    if (status.isOk()) {
      status = addCandidates(folder / parameters_.candidates, graph.value().edges,
                             drive.value().ids, findings);
    }
  }
  if (!status.isOk()) return status;
  std::vector<std::int64_t> stamps;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    stamps.push_back(std::llround(static_cast<double>(i) * 1e9 / parameters_.rate));
  }
  Result<FrameSequence> sequence = FrameSequence::make(parameters_, stamps);
  if (!sequence.isOk()) return sequence.status();
  sequence_ = sequence.value();
  return Status::ok();
}

/// Each from the later to the earlier of its two frames.
Status MotionLog::addCandidates(const fs::path& file, const std::vector<Edge>& edges,
                                const std::vector<std::int64_t>& ids, FindingCollector& findings) {
  int repeated = 0;
  for (Edge edge : edges) {
    const std::string place = file.string() + ":" + std::to_string(edge.line) + ": ";
    for (std::int64_t* id : {&edge.from, &edge.to}) {
      const auto found = std::ranges::lower_bound(ids, *id);
      if (found == ids.end() || *found != *id) {
        return Status::invalidInput(place + "there is no frame " + std::to_string(*id) +
                                    "; the odometry has " + std::to_string(ids.size()) +
                                    ", and the candidates must be of the same drive");
      }
      *id = found - ids.begin();
    }
    if (edge.to == edge.from) return Status::invalidInput(place + "leads from a frame to itself");
    if (edge.to > edge.from) {
      std::swap(edge.from, edge.to);
      edge.motion = between(edge.motion, {});
    }
    const auto [first, last] = candidates_.equal_range(edge.from);
    const auto same = std::find_if(
        first, last, [&](const auto& earlier) { return earlier.second.to == edge.to; });
    repeated += same != last ? 1 : 0;
    if (same != last) continue;
    candidates_.emplace(edge.from, edge);
    looked_.insert({edge.from, edge.to});
  }
  if (repeated > 0) {
    findings.add(
        {Finding::Severity::Warning, file.string(),
         "repeats " + std::to_string(repeated) + " candidates; the first of each is used"});
  }
  return Status::ok();
}

Status MotionLog::reset() {
  next_ = 0;
  return ready_;
}

Status MotionLog::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  info.frames = sequence_.size();
  info.has_truth = !truth_.empty();
  info.description = "motion log, " + std::to_string(info.frames) + " frames, " +
                     std::to_string(candidates_.size()) + " loop candidates";
  return Status::ok();
}

Status MotionLog::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  if (next_ >= sequence_.size()) return Status::endOfStream();
  const std::int64_t here = sequence_.sourceIndex(next_);
  frame.frame = next_;
  frame.stamp_ns = sequence_.stampNs(next_);
  frame.source_index = here;
  const auto at = [](const std::vector<PlanarPose>& poses, std::int64_t i) {
    return poses[static_cast<std::size_t>(i)];
  };
  if (!truth_.empty()) {
    frame.has_truth = true;
    const bool own_world = parameters_.truth_origin == TruthOrigin::First;
    const PlanarPose start = at(truth_, own_world ? sequence_.sourceIndex(0) : 0);
    frame.T_world_camera_truth = fromPlanar(between(start, at(truth_, here)));
  }
  const std::int64_t before = sequence_.sourceIndex(std::max<std::int64_t>(next_ - 1, 0));
  const PlanarPose step = between(at(poses_, before), at(poses_, here));
  frame.sensors.push_back({"motion.planar", {3}, {f(step.x), f(step.y), f(step.theta)}});
  attachCandidates(here, frame);
  ++next_;
  return Status::ok();
}

void MotionLog::attachCandidates(std::int64_t here, Frame& frame) const {
  NamedArray alike = {"place.candidate", {0, 4}, {}};
  const auto [first, last] = candidates_.equal_range(here);
  for (auto edge = first; edge != last; ++edge, ++alike.shape[0]) {
    const PlanarPose& m = edge->second.motion;
    alike.values.insert(alike.values.end(), {f(edge->second.to), f(m.x), f(m.y), f(m.theta)});
  }
  frame.sensors.push_back(std::move(alike));
  frame.sensors.push_back({"place.looked", {1}, {looked_.contains(here) ? 1.0F : 0.0F}});
  frame.sensors.push_back({"motion.drive", {1}, {drive_}});
}

Status MotionLog::describe(std::vector<ArrayInfo>& arrays) const {
  const auto add = [&arrays](const char* name, const char* doc, std::vector<ArrayAxis> axes) {
    ArrayInfo& info = arrays.emplace_back();
    info.name = name;
    info.doc = doc;
    info.axes = std::move(axes);
  };
  ArrayAxis value;
  value.name = "value";
  ArrayAxis candidate;
  candidate.name = "candidate";
  ArrayAxis component;
  component.name = "component";
  component.labels = {"x (m)", "y (m)", "theta (rad)"};
  add("motion.planar", "planar motion since the frame before", {component});
  component.labels.insert(component.labels.begin(), "source index");
  add("place.candidate", "similar earlier frames and their pose", {candidate, component});
  add("place.looked", "1 where the loop detector ran, else 0", {value});
  add("motion.drive", "hash of the odometry", {value});
  return Status::ok();
}

}  // namespace tolman::motion_log
