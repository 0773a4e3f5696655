// SPDX-License-Identifier: BSD-3-Clause
#include "stages.hpp"

#include <memory>
#include <numbers>
#include <span>

#include "convert.hpp"

namespace tolman::python {

namespace {

py::object logOf(Logger& log) {
  const auto writer = [&log](LogLevel level) {
    return py::cpp_function([&log, level](py::handle text) {
      log.write(level, textFrom(py::str(text), "the text of a log line"));
    });
  };
  const py::object made = py::module_::import("types").attr("SimpleNamespace")();
  for (const LogLevel level :
       {LogLevel::Debug, LogLevel::Info, LogLevel::Warning, LogLevel::Error}) {
    py::setattr(made, std::string(enumName(level)).c_str(), writer(level));
  }
  return made;
}

py::object collectorOf(FindingCollector& findings) {
  return py::cpp_function([&findings](py::handle value) {
    Finding finding;
    fromPython(value, finding, "the finding");
    findings.add(std::move(finding));
  });
}

py::object writerOf(ArtefactWriter& artefacts) {
  return py::cpp_function([&artefacts](const std::string& name, const py::object& content) {
    // Text with lone surrogates has no UTF-8: encode() raises an error that names the first one.
    const bool is_text = PyUnicode_Check(content.ptr()) != 0;
    const std::string bytes{py::bytes(is_text ? content.attr("encode")("utf-8") : content)};
    const Status status = artefacts.write(name, std::as_bytes(std::span(bytes)));
    if (!status.isOk()) throw py::value_error(status.message());
  });
}

}  // namespace

py::object servicesOf(const Context& context) {
  py::dict services;
  services["log"] = logOf(context.log);
  services["add_finding"] = collectorOf(context.findings);
  services["write_artefact"] = writerOf(context.artefacts);
  services["rig"] = toPython(context.rig);
  services["seed"] = py::int_(context.seed);
  services["name"] = toPython(context.instance);
  return services;
}

py::object valuesOf(const ParameterValues& values) {
  py::dict dict;
  for (const auto& value : values) {  // a lambda of clang 14 cannot capture parts of it
    std::visit([&](const auto& held) { dict[toPython(value.first)] = toPython(held); },
               value.second);
  }
  return dict;
}

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
