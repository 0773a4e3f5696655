// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_process.hpp"

#include <fcntl.h>
#include <oneapi/tbb/global_control.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>

#include "host/channel.hpp"
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

class RemoteLogger : public Logger {
 public:
  explicit RemoteLogger(const Socket& socket) : socket_(socket) {}
  void write(LogLevel level, std::string_view text) override {
    constexpr auto kLog = static_cast<std::uint32_t>(ReplyKind::Log);
    (void)socket_.send({{kLog, static_cast<std::uint32_t>(level)}, std::string(text)});
  }

 private:
  const Socket& socket_;
};

class RemoteFindings : public FindingCollector {
 public:
  explicit RemoteFindings(const Socket& socket) : socket_(socket) {}
  void add(Finding finding) override {
    (void)socket_.send({{static_cast<std::uint32_t>(ReplyKind::Finding)}, textOf(finding)});
  }

 private:
  const Socket& socket_;
};

class RemoteCancellation : public Cancellation {
 public:
  explicit RemoteCancellation(const ControlBlock& control) : control_(control) {}
  bool requested() const override { return control_.cancelled.load() != 0; }

 private:
  const ControlBlock& control_;
};

/// Kills this process and its group as soon as the host ends, even during a call that
/// does not return.
void endWithHost(int socket) {
  // The id of the original group: the plugin may have moved this process to another one.
  std::thread([socket, group = ::getpid()] {
    pollfd watched{socket, 0, 0};  // POLLHUP is always reported
    while (::poll(&watched, 1, -1) <= 0) {
    }
    ::kill(-group, SIGKILL);
    ::kill(group, SIGKILL);
  }).detach();
}

OrRefusal<LoadedPlugin> open(const LoadMessage& message) {
  auto manifest = readManifest(message.file, message.id);
  if (auto* refusal = std::get_if<Refusal>(&manifest)) return std::move(*refusal);
  std::get<Manifest>(manifest).program = message.program;
  return loadPlugin(std::get<Manifest>(manifest), HostIdentity::ofThisBuild());
}

class PluginProcess {
 public:
  PluginProcess(const std::vector<int>& descriptors, const ProcessServices& services)
      : socket_(Descriptor(descriptors.at(0))),
        request_(descriptors.at(1)),
        response_(descriptors.at(2)),
        control_(descriptors.at(3)),
        services_(services),
        log_(socket_),
        findings_(socket_),
        cancellation_(*reinterpret_cast<const ControlBlock*>(control_.view(sizeof(ControlBlock)))) {
    for (const int descriptor : descriptors) {
      ::fcntl(descriptor, F_SETFD,
              FD_CLOEXEC);  // not inherited by processes that the plugin starts
    }
    endWithHost(socket_.descriptor());
    addOwnCalls();
  }

  void run() {
    SocketMessage message;
    for (;;) {
      const ReceiveResult received = socket_.receive(message, std::chrono::milliseconds(-1));
      if (received == ReceiveResult::Closed) return;
      if (received == ReceiveResult::Message) execute(message);
    }
  }

 private:
  void execute(const SocketMessage& request) {
    Decoder in(request_.view(request.size), request.size);
    Encoder out(response_);
    const auto found = handlers_.find(static_cast<Call>(request.kind));
    if (found == handlers_.end()) {
      out.put(Status::failed("the plugin does not support this call"));
    } else {
      found->second(in, out);
    }
    constexpr auto kReply = static_cast<std::uint32_t>(ReplyKind::Reply);
    (void)socket_.send({{kReply, request.detail, out.size()}, {}});
  }

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
    auto loaded = open(message);
    if (auto* reason = std::get_if<Refusal>(&loaded)) {
      refusal = std::move(*reason);
      return Status::ok();
    }
    plugin_ = std::move(std::get<LoadedPlugin>(loaded));
    role = plugin_->manifest.role;
    version = plugin_->manifest.version;
    summary = plugin_->manifest.summary;
    files = plugin_->manifest.program_files;
    schema = plugin_->schema;
    return Status::ok();
  }

  Status create(Refusal& refusal, bool& arrays, bool& state) {
    object_ = plugin_->descriptor->create();
    if (object_.plugin == nullptr) {
      refusal = nullInstance(plugin_->manifest);
      return Status::ok();
    }
    arrays = object_.arrays != nullptr;
    state = object_.state != nullptr;
    handlers_.merge(handlersOf(plugin_->manifest.role, object_));
    return Status::ok();
  }

  Status configure(const ContextMessage& message) {
    context_ = message;
    return object_.plugin->configure({context_.parameters, log_, findings_, artefacts_,
                                      cancellation_, services_.clock, context_.rig, context_.seed,
                                      context_.instance});
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
  SharedBuffer request_;
  SharedBuffer response_;
  SharedBuffer control_;
  const ProcessServices& services_;
  RemoteLogger log_;
  RemoteFindings findings_;
  StageArtefacts artefacts_;
  RemoteCancellation cancellation_;
  std::optional<tbb::global_control> threads_;
  ContextMessage context_;
  std::optional<LoadedPlugin> plugin_;
  PluginObject object_;
  Handlers handlers_;
};

/// Ends the process after an exception, which cannot leave a static constructor of a library. Where
/// memory or threads are lacking, the exit code says so, instead of blaming the library.
[[noreturn]] void endByException() noexcept {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    ::_exit(kNoMemoryExit);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) ::_exit(kNoThreadsExit);
    if (error.code() == std::errc::not_enough_memory) ::_exit(kNoMemoryExit);
  } catch (...) {  // of the library
  }
  std::abort();
}

}  // namespace

void runPluginProcess(const std::vector<int>& descriptors, const ProcessServices& services) {
  std::set_terminate(endByException);
  try {
    PluginProcess(descriptors, services).run();
  } catch (...) {  // the host detects that this process ended
    endByException();
  }
  ::_exit(0);
}

}  // namespace tolman::host
