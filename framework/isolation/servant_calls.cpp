// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/servant_calls.hpp"

#include <sstream>

namespace tolman::isolation {
namespace {

void addExtras(Handlers& handlers, const PluginObject& object) {
  if (object.arrays != nullptr) {
    handlers[Call::Arrays] =
        handler(Takes<>{}, Gives<std::vector<NamedArray>>{}, [arrays = object.arrays](auto& list) {
          arrays->arrays(list);
          return Status::ok();
        });
  }
  if (object.state == nullptr) return;
  handlers[Call::Save] =
      handler(Takes<>{}, Gives<std::string>{}, [state = object.state](std::string& bytes) {
        std::ostringstream stream;
        Status status = state->save(stream);
        bytes = std::move(stream).str();
        return status;
      });
  handlers[Call::Restore] =
      handler(Takes<std::string>{}, Gives<>{}, [state = object.state](std::string& bytes) {
        std::istringstream stream(bytes);
        return state->load(stream);
      });
}

void addSource(Handlers& handlers, Source& source) {
  handlers[Call::Info] =
      handler(Takes<>{}, Gives<SourceInfo>{}, [&](SourceInfo& info) { return source.info(info); });
  handlers[Call::Next] =
      handler(Takes<>{}, Gives<Frame>{}, [&](Frame& frame) { return source.next(frame); });
  handlers[Call::Inspect] = handler(Takes<>{}, Gives<std::vector<Finding>>{},
                                    [&](auto& findings) { return source.inspect(findings); });
}

void addOdometry(Handlers& handlers, Odometry& odometry) {
  handlers[Call::Track] =
      handler(Takes<Frame>{}, Gives<Motion>{},
              [&](const Frame& frame, Motion& motion) { return odometry.track(frame, motion); });
  handlers[Call::FinishOdometry] = handler(Takes<>{}, Gives<std::vector<MotionRevision>>{},
                                           [&](auto& owed) { return odometry.finish(owed); });
}

void addPlace(Handlers& handlers, Place& place) {
  handlers[Call::Input] = handler(Takes<>{}, Gives<PlaceInput>{}, [&](PlaceInput& input) {
    input = place.input();
    return Status::ok();
  });
  handlers[Call::Observe] =
      handler(Takes<Frame, std::optional<Motion>>{}, Gives<PlaceObservation>{},
              [&](const Frame& frame, const auto& motion, PlaceObservation& observation) {
                return place.observe(frame, motion ? &*motion : nullptr, observation);
              });
  handlers[Call::FinishPlace] = handler(Takes<>{}, Gives<>{}, [&] { return place.finish(); });
}

void addCells(Handlers& handlers, Cells& cells) {
  handlers[Call::Step] =
      handler(Takes<Motion, PlaceObservation>{}, Gives<Decision>{},
              [&](const Motion& motion, const PlaceObservation& seen, Decision& decision) {
                return cells.step(motion, seen, decision);
              });
  handlers[Call::FinishCells] = handler(Takes<>{}, Gives<>{}, [&] { return cells.finish(); });
}

void addMap(Handlers& handlers, Map& map) {
  handlers[Call::Update] =
      handler(Takes<Motion, Decision>{}, Gives<MapUpdate>{},
              [&](const Motion& motion, const Decision& decision, MapUpdate& update) {
                return map.update(motion, decision, update);
              });
  handlers[Call::PoseOf] = handler(Takes<std::int64_t>{}, Gives<Eigen::Isometry3d>{},
                                   [&](std::int64_t frame, Eigen::Isometry3d& T_world_camera) {
                                     T_world_camera.setIdentity();
                                     return map.poseOf(frame, T_world_camera);
                                   });
  handlers[Call::Graph] =
      handler(Takes<>{}, Gives<MapGraph>{}, [&](MapGraph& graph) { return map.graph(graph); });
  handlers[Call::FinishMap] = handler(Takes<std::vector<MotionRevision>>{}, Gives<>{},
                                      [&](const auto& owed) { return map.finish(owed); });
}

void addObserver(Handlers& handlers, Observer& observer) {
  handlers[Call::Begin] =
      handler(Takes<RunInfo>{}, Gives<>{}, [&](const RunInfo& run) { return observer.begin(run); });
  handlers[Call::Watch] =
      handler(Takes<Frame, Motion, PlaceObservation, Decision, MapUpdate, std::vector<NamedArray>,
                    std::optional<MapGraph>, StageTimes, std::vector<RunEvent>>{},
              Gives<>{},
              [&](const Frame& frame, const Motion& motion, const PlaceObservation& place,
                  const Decision& decision, const MapUpdate& map, const auto& cells,
                  const auto& graph, const StageTimes& times, const auto& events) {
                return observer.observe({&frame, &motion, &place, &decision, &map, &cells,
                                         graph ? &*graph : nullptr, times, &events});
              });
  handlers[Call::FinishObserver] = handler(
      Takes<MapGraph>{}, Gives<>{}, [&](const MapGraph& graph) { return observer.finish(graph); });
}

template <class RoleType>
RoleType& as(const PluginObject& object) {
  return static_cast<RoleType&>(*object.plugin);
}

}  // namespace

Handlers handlersOf(Role role, const PluginObject& object) {
  Handlers handlers;
  handlers[Call::Reset] =
      handler(Takes<>{}, Gives<>{}, [plugin = object.plugin] { return plugin->reset(); });
  addExtras(handlers, object);
  switch (role) {
    case Role::Source:
      addSource(handlers, as<Source>(object));
      break;
    case Role::Odometry:
      addOdometry(handlers, as<Odometry>(object));
      break;
    case Role::Place:
      addPlace(handlers, as<Place>(object));
      break;
    case Role::Cells:
      addCells(handlers, as<Cells>(object));
      break;
    case Role::Map:
      addMap(handlers, as<Map>(object));
      break;
    case Role::Observer:
      addObserver(handlers, as<Observer>(object));
      break;
  }
  return handlers;
}

}  // namespace tolman::isolation
