// SPDX-License-Identifier: BSD-3-Clause
#include "host/call_handlers.hpp"

#include <array>
#include <sstream>

#include "host/instance.hpp"

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
  if (object.raw_rig != nullptr) {
    handlers[Call::RawRig] = handler(*object.raw_rig, &RawRigSource::rawRig);
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
    Status status = host::saveTo(stream, *state);
    bytes = std::move(stream).str();
    return status;
  }));
  handlers[Call::Restore] = handler(std::function([state = object.state](const std::string& bytes) {
    std::istringstream stream(bytes);
    return state->load(stream);
  }));
}

void addCalls(Handlers& handlers, Source& source) {
  handlers[Call::Info] = handler(source, &Source::info);
  handlers[Call::Next] = handler(source, &Source::next);
}

void addCalls(Handlers& handlers, Odometry& odometry) {
  handlers[Call::Track] = handler(odometry, &Odometry::track);
  handlers[Call::FinishOdometry] = handler(odometry, &Odometry::finish);
}

void addCalls(Handlers& handlers, Place& place) {
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

void addCalls(Handlers& handlers, Cells& cells) {
  handlers[Call::Step] = handler(cells, &Cells::step);
  handlers[Call::FinishCells] = handler(cells, &Cells::finish);
}

void addCalls(Handlers& handlers, Map& map) {
  handlers[Call::Update] = handler(map, &Map::update);
  handlers[Call::PoseOf] =
      handler(std::function([&](const std::int64_t& frame, Eigen::Isometry3d& T_world_camera) {
        T_world_camera.setIdentity();
        return map.poseOf(frame, T_world_camera);
      }));
  handlers[Call::Graph] = handler(map, &Map::graph);
  handlers[Call::FinishMap] = handler(map, &Map::finish);
}

void addCalls(Handlers& handlers, Observer& observer) {
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
void addRole(Handlers& handlers, Plugin& plugin) {
  addCalls(handlers, static_cast<RoleType&>(plugin));
}

}  // namespace

Handlers handlersOf(Role role, const PluginObject& object) {
  constexpr std::array kAdd = {&addRole<Source>, &addRole<Odometry>, &addRole<Place>,
                               &addRole<Cells>,  &addRole<Map>,      &addRole<Observer>};
  Handlers handlers;
  handlers[Call::Reset] = handler(*object.plugin, &Plugin::reset);
  addExtras(handlers, object);
  kAdd.at(static_cast<std::size_t>(role))(handlers, *object.plugin);
  return handlers;
}

}  // namespace tolman::isolation
