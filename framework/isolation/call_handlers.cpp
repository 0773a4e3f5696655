// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/call_handlers.hpp"

#include <sstream>

namespace tolman::isolation {
namespace {

void addExtras(Handlers& handlers, const PluginObject& object) {
  if (object.arrays != nullptr) {
    handlers[Call::Arrays] =
        handler(std::function([extra = object.arrays](std::vector<NamedArray>& arrays) {
          extra->arrays(arrays);
          return Status::ok();
        }));
  }
  if (object.descriptions != nullptr) {
    handlers[Call::Describe] = handler(*object.descriptions, &ArrayDescriptions::describe);
  }
  if (object.page != nullptr) {
    handlers[Call::Url] = handler(std::function([page = object.page](std::string& url) {
      url = page->url();
      return Status::ok();
    }));
  }
  if (object.state == nullptr) return;
  handlers[Call::Save] = handler(std::function([state = object.state](std::string& bytes) {
    std::ostringstream stream;
    Status status = state->save(stream);
    bytes = std::move(stream).str();
    return status;
  }));
  handlers[Call::Restore] = handler(std::function([state = object.state](const std::string& bytes) {
    std::istringstream stream(bytes);
    return state->load(stream);
  }));
}

void addSource(Handlers& handlers, Source& source) {
  handlers[Call::Info] = handler(source, &Source::info);
  handlers[Call::Next] = handler(source, &Source::next);
  handlers[Call::Inspect] = handler(source, &Source::inspect);
}

void addOdometry(Handlers& handlers, Odometry& odometry) {
  handlers[Call::Track] = handler(odometry, &Odometry::track);
  handlers[Call::FinishOdometry] = handler(odometry, &Odometry::finish);
}

void addPlace(Handlers& handlers, Place& place) {
  handlers[Call::Input] = handler(std::function([&](PlaceInput& input) {
    input = place.input();
    return Status::ok();
  }));
  handlers[Call::Observe] = handler(std::function(
      [&](const Frame& frame, const std::optional<Motion>& motion, PlaceObservation& observation) {
        return place.observe(frame, motion ? &*motion : nullptr, observation);
      }));
  handlers[Call::FinishPlace] = handler(place, &Place::finish);
}

void addCells(Handlers& handlers, Cells& cells) {
  handlers[Call::Step] = handler(cells, &Cells::step);
  handlers[Call::FinishCells] = handler(cells, &Cells::finish);
}

void addMap(Handlers& handlers, Map& map) {
  handlers[Call::Update] = handler(map, &Map::update);
  handlers[Call::PoseOf] =
      handler(std::function([&](const std::int64_t& frame, Eigen::Isometry3d& T_world_camera) {
        T_world_camera.setIdentity();
        return map.poseOf(frame, T_world_camera);
      }));
  handlers[Call::Graph] = handler(map, &Map::graph);
  handlers[Call::FinishMap] = handler(map, &Map::finish);
}

void addObserver(Handlers& handlers, Observer& observer) {
  handlers[Call::Begin] = handler(observer, &Observer::begin);
  handlers[Call::Watch] = handler(
      std::function([&](const Frame& frame, const Motion& motion, const PlaceObservation& place,
                        const Decision& decision, const MapUpdate& map,
                        const std::vector<NamedArray>& cells, const std::optional<MapGraph>& graph,
                        const StageTimes& times, const std::vector<RunEvent>& events) {
        return observer.observe({&frame, &motion, &place, &decision, &map, &cells,
                                 graph ? &*graph : nullptr, times, &events});
      }));
  handlers[Call::FinishObserver] = handler(observer, &Observer::finish);
}

template <class RoleType>
RoleType& as(const PluginObject& object) {
  return static_cast<RoleType&>(*object.plugin);
}

}  // namespace

Handlers handlersOf(Role role, const PluginObject& object) {
  Handlers handlers;
  handlers[Call::Reset] = handler(*object.plugin, &Plugin::reset);
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
