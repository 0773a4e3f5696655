// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_process.hpp"

#include <fcntl.h>
#include <oneapi/tbb/global_control.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>

#include "host/child_process.hpp"
#include "host/instance.hpp"
#include "host/library.hpp"

namespace tolman::host {

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
    Status status = saveTo(stream, *state);
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

namespace {

void send(const Socket& socket, ReplyKind kind, std::uint32_t detail, std::string bytes) {
  (void)socket.send({static_cast<std::uint32_t>(kind), detail, std::move(bytes)});
}

class RemoteLogger : public Logger {
 public:
  explicit RemoteLogger(const Socket& socket) : socket_(socket) {}
  void write(LogLevel level, std::string_view text) override {
    constexpr std::size_t kLongest = 10'000;
    send(socket_, ReplyKind::Log, static_cast<std::uint32_t>(level),
         std::string(text.substr(0, kLongest)));
  }

 private:
  const Socket& socket_;
};

class RemoteFindings : public FindingCollector {
 public:
  explicit RemoteFindings(const Socket& socket) : socket_(socket) {}
  void add(Finding finding) override {
    Encoder encoder;
    encoder.put(finding);
    send(socket_, ReplyKind::Finding, 0, encoder.take());
  }

 private:
  const Socket& socket_;
};

/// The calls from the host, read by a thread of their own, which sees also during a call that the
/// run was cancelled, and kills this process and its group as soon as the host ends.
class Requests : public Cancellation {
 public:
  explicit Requests(const Socket& socket) : socket_(socket) {
    // The id of the original group: the plugin may have moved this process to another one.
    std::thread([this, group = ::getpid()] {
      listen();
      ::kill(-group, SIGKILL);
      ::kill(group, SIGKILL);
    }).detach();
  }
  bool requested() const override { return cancelled_; }
  SocketMessage next() {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [&] { return request_.has_value(); });
    return *std::exchange(request_, std::nullopt);
  }

 private:
  void listen() {
    SocketMessage message;
    for (;;) {
      const ReceiveResult received = socket_.receive(message, std::chrono::milliseconds(-1));
      if (received == ReceiveResult::Closed) return;
      if (received == ReceiveResult::Timeout) continue;
      if (message.kind == static_cast<std::uint32_t>(Call::Cancel)) {
        cancelled_ = true;
        continue;
      }
      const std::lock_guard lock(mutex_);
      request_ = std::move(message);
      came_.notify_one();
    }
  }

  const Socket& socket_;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  std::condition_variable came_;
  std::optional<SocketMessage> request_;
};

class PluginProcess {
 public:
  PluginProcess(int descriptor, const ProcessServices& services)
      : socket_(FileDescriptor(descriptor)),
        requests_(socket_),
        services_(services),
        log_(socket_),
        findings_(socket_) {
    ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);  // not inherited by processes that the plugin starts
    addOwnCalls();
  }

  [[noreturn]] void run() {
    for (;;) {
      const SocketMessage request = requests_.next();
      Decoder in(request.bytes);
      Encoder out;
      const auto found = handlers_.find(static_cast<Call>(request.kind));
      if (found == handlers_.end()) {
        out.put(Status::failed("the plugin does not support this call"));
      } else {
        found->second(in, out);
      }
      send(socket_, ReplyKind::Reply, request.detail, out.take());
    }
  }

 private:
  void addOwnCalls() {
    handlers_[Call::Load] = handler(*this, &PluginProcess::load);
    handlers_[Call::Create] = handler(*this, &PluginProcess::create);
    handlers_[Call::Configure] = handler(*this, &PluginProcess::configure);
    handlers_[Call::OpenArtefacts] = handler(*this, &PluginProcess::openArtefacts);
    handlers_[Call::Destroy] = handler(*this, &PluginProcess::destroy);
  }

  Status load(const LoadMessage& message, Refusal& refusal, Role& role, std::string& version,
              std::string& summary, std::vector<std::string>& files, Schema& schema) {
    limitResources(message.memory_mib);
    if (message.threads > 0) {
      threads_.emplace(tbb::global_control::max_allowed_parallelism,
                       static_cast<std::size_t>(message.threads));
    }
    try {
      Manifest manifest = readManifest(message.file, message.id);
      manifest.program = message.program;
      plugin_ = loadPlugin(manifest, HostIdentity::ofThisBuild());
    } catch (const Refusal& reason) {
      refusal = reason;
      return Status::ok();
    }
    role = plugin_->manifest.role;
    version = plugin_->manifest.version;
    summary = plugin_->manifest.summary;
    files = plugin_->manifest.program_files;
    schema = plugin_->schema;
    return Status::ok();
  }

  Status create(Refusal& refusal, bool& arrays, bool& state) {
    object_ = plugin_->descriptor->create();
    try {
      requireObject(object_, plugin_->manifest);
    } catch (const Refusal& reason) {
      refusal = reason;
      return Status::ok();
    }
    arrays = object_.arrays != nullptr;
    state = object_.state != nullptr;
    handlers_.merge(handlersOf(plugin_->manifest.role, object_));
    return Status::ok();
  }

  Status configure(const ContextMessage& message) {
    context_ = message;
    return object_.plugin->configure({context_.parameters, log_, findings_, artefacts_, requests_,
                                      services_.clock, context_.rig, context_.seed,
                                      context_.instance, context_.localise});
  }

  Status openArtefacts(const std::string& directory) {
    artefacts_.folder = services_.artefacts(directory, context_.instance);
    return Status::ok();
  }

  Status destroy() {
    Plugin* plugin = std::exchange(object_, PluginObject{}).plugin;
    if (plugin != nullptr) plugin_->descriptor->destroy(plugin);
    return Status::ok();
  }

  Socket socket_;
  Requests requests_;
  const ProcessServices& services_;
  RemoteLogger log_;
  RemoteFindings findings_;
  StageArtefacts artefacts_;
  std::optional<tbb::global_control> threads_;
  ContextMessage context_;
  std::optional<LoadedPlugin> plugin_;
  PluginObject object_;
  Handlers handlers_;
};

}  // namespace

void runPluginProcess(int descriptor, const ProcessServices& services) {
  try {
    PluginProcess(descriptor, services).run();
  } catch (...) {  // the host detects that this process ended
    std::abort();
  }
}

}  // namespace tolman::host
