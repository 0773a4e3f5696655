// SPDX-License-Identifier: BSD-3-Clause
#include "stages.hpp"

#include <memory>
#include <numbers>

#include "stage.hpp"

namespace tolman::python {
namespace {

class PythonSource final : public PythonStage<Source> {
 public:
  Status info(SourceInfo& info) override {
    return work("info", [&] { answer(info, "info"); });
  }
  Status next(Frame& frame) override {
    bool ended = false;
    const Status status = work("next", [&] {
      const py::object given = ask("next");
      ended = given.is_none();
      if (!ended) fromPython(given, frame, "next()");
    });
    return ended ? Status::endOfStream() : status;
  }
};

class PythonOdometry final : public PythonStage<Odometry> {
 public:
  Status track(const Frame& frame, Motion& motion) override {
    return work("track", [&] {
      answer(motion, "track", frame);
      address(motion, frame);
    });
  }
  Status finish(std::vector<MotionRevision>& revisions) override {
    return work("finish", [&] { answer(revisions, "finish"); });
  }
};

class PythonPlace final : public PythonStage<Place> {
 public:
  PlaceInput input() const override {
    bool needs_motion = false;
    const Status status =
        work("needs_motion", [&] { needs_motion = py::bool_(object().attr("needs_motion")); });
    if (!status.isOk()) throw std::runtime_error(status.message());
    return needs_motion ? PlaceInput::FrameAndMotion : PlaceInput::Frame;
  }
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation) override {
    return work("observe", [&] {
      const py::object given = motion == nullptr ? py::none() : toPython(*motion);
      fromPython(object().attr("observe")(toPython(frame), given), observation, "observe()");
      address(observation, frame);
    });
  }
  Status finish() override {
    return work("finish", [&] { ask("finish"); });
  }
};

class PythonCells final : public PythonStage<Cells> {
 public:
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override {
    return work("step", [&] {
      answer(decision, "step", motion, observation);
      // In Python the remainder of -1e-17 by 2 pi is 2 pi.
      constexpr double kCircle = 2 * std::numbers::pi;
      if (decision.heading == kCircle) decision.heading = 0;
      address(decision, motion);
    });
  }
  Status finish() override {
    return work("finish", [&] { ask("finish"); });
  }
};

class PythonMap final : public PythonStage<Map> {
 public:
  Status update(const Motion& motion, const Decision& decision, MapUpdate& update) override {
    return work("update", [&] {
      answer(update, "update", motion, decision);
      address(update, motion);
    });
  }
  Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const override {
    return work("pose_of", [&] { answer(T_world_camera, "pose_of", frame); });
  }
  Status graph(MapGraph& graph) const override {
    return work("graph", [&] { answer(graph, "graph"); });
  }
  Status finish(const std::vector<MotionRevision>& revisions) override {
    return work("finish", [&] { ask("finish", revisions); });
  }
};

class PythonObserver final : public PythonStage<Observer> {
 public:
  Status begin(const RunInfo& run) override {
    return work("begin", [&] { ask("begin", run); });
  }
  Status observe(const Snapshot& s) override {
    return work("observe", [&] { object().attr("observe")(toPythonSnapshot(s)); });
  }
  Status finish(const MapGraph& graph) override {
    return work("finish", [&] { ask("finish", graph); });
  }

 private:
  static py::object toPythonSnapshot(const Snapshot& s) {
    py::dict times;
    for (std::size_t role = 0; role < kRoleNames.size(); ++role) {
      times[toPython(std::string(kRoleNames[role]))] = s.stage_times_ns[role];
    }
    return classOf("snapshot")(toPython(*s.frame), toPython(*s.motion), toPython(*s.place),
                               toPython(*s.decision), toPython(*s.map), toPython(*s.cells),
                               s.graph == nullptr ? py::none() : toPython(*s.graph), times,
                               s.events == nullptr ? py::list() : toPython(*s.events));
  }
};

template <class C>
PluginObject create() {
  auto made = std::make_unique<C>();
  PluginObject object{nullptr, nullptr, nullptr, made.get(), nullptr};
  if (!std::derived_from<C, Source>) object.state = made.get();  // sources save no state
  if (opened().has_arrays) object.arrays = made.get();
  object.plugin = made.release();
  return object;
}

template <class C>
constexpr PluginDescriptor kDescriptor = {TOLMAN_SDK_MAJOR,
                                          TOLMAN_SDK_MINOR,
                                          "python",
                                          ::tolman::detail::roleOf<C>(),
                                          0,
                                          nullptr,
                                          &create<C>,
                                          [](Plugin* plugin) { delete plugin; }};

}  // namespace

const PluginDescriptor* descriptorOf(const std::string& role) {
  static constexpr std::array kAll = {&kDescriptor<PythonSource>, &kDescriptor<PythonOdometry>,
                                      &kDescriptor<PythonPlace>,  &kDescriptor<PythonCells>,
                                      &kDescriptor<PythonMap>,    &kDescriptor<PythonObserver>};
  for (const PluginDescriptor* descriptor : kAll) {
    if (enumName(descriptor->role) == role) return descriptor;
  }
  throw std::out_of_range("'" + role + "' is not a role");
}

}  // namespace tolman::python
