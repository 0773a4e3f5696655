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

/// The file of the default name may be missing; one that was named, or a link to nothing, may not.
Status MotionLog::loadTruth(const fs::path& file) {
  if (parameters_.truth.empty()) return Status::ok();
  std::error_code ignored;
  const bool is_named = parameters_.truth != Parameters().truth;
  if (!is_named && !fs::exists(fs::symlink_status(file, ignored))) return Status::ok();
  Result<std::vector<PlanarPose>> read = readChain(file);
  if (!read.isOk()) return read.status();
  truth_ = std::move(read.value());
  if (truth_.size() == poses_.size()) return Status::ok();
  return Status::invalidInput(file.string() + " has " + std::to_string(truth_.size()) +
                              " poses, the odometry " + std::to_string(poses_.size()) +
                              "; give the truth of this sequence");
}

Status MotionLog::load(FindingCollector& findings) {
  const fs::path folder = parameters_.path;
  Result<std::vector<PlanarPose>> poses = readChain(folder / parameters_.odometry);
  if (!poses.isOk()) return poses.status();
  poses_ = std::move(poses.value());
  drive_ = digest(poses_);
  if (Status status = loadTruth(folder / parameters_.truth); !status.isOk()) return status;
  if (Status status = loadCandidates(); !status.isOk()) return status;
  const auto report = [&](const std::string& name, const std::vector<std::string>& doubts) {
    for (const std::string& doubt : doubts) {
      findings.add({Finding::Severity::Warning, (folder / name).string(), doubt});
    }
  };
  report(parameters_.odometry, unitDoubts(poses_, parameters_.rate));
  report(parameters_.truth, unitDoubts(truth_, parameters_.rate));
  std::vector<std::int64_t> stamps;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    stamps.push_back(std::llround(static_cast<double>(i) * 1e9 / parameters_.rate));
  }
  Result<FrameSequence> sequence = FrameSequence::make(parameters_, stamps);
  if (!sequence.isOk()) return sequence.status();
  sequence_ = sequence.value();
  return Status::ok();
}

Status MotionLog::loadCandidates() {
  if (parameters_.candidates.empty()) return Status::ok();
  const fs::path file = fs::path(parameters_.path) / parameters_.candidates;
  Result<std::vector<Edge>> edges = readEdges(file);
  if (!edges.isOk()) return edges.status();
  const auto count = static_cast<std::int64_t>(poses_.size());
  for (const Edge& edge : edges.value()) {
    const std::string place = file.string() + ":" + std::to_string(edge.line) + ": ";
    if (edge.from >= count) {
      return Status::invalidInput(place + "there is no frame " + std::to_string(edge.from) +
                                  "; the odometry has " + std::to_string(count) +
                                  ", and the candidates must be of the same drive");
    }
    if (edge.to >= edge.from) {
      return Status::invalidInput(place + "leads from frame " + std::to_string(edge.from) + " to " +
                                  std::to_string(edge.to) +
                                  "; a candidate leads from a frame to an earlier one");
    }
    const auto [first, last] = candidates_.equal_range(edge.from);
    const auto same = std::find_if(
        first, last, [&](const auto& earlier) { return earlier.second.to == edge.to; });
    if (same != last) {
      return Status::invalidInput(place + "repeats the candidate of line " +
                                  std::to_string(same->second.line) + "; remove one of the two");
    }
    candidates_.emplace(edge.from, edge);
    looked_.insert({edge.from, edge.to});
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
  addCandidates(here, frame);
  ++next_;
  return Status::ok();
}

void MotionLog::addCandidates(std::int64_t here, Frame& frame) const {
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
