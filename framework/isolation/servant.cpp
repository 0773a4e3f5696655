// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/servant.hpp"

#include <fcntl.h>
#include <oneapi/tbb/global_control.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <optional>
#include <thread>

#include "isolation/channel.hpp"
#include "isolation/child_process.hpp"
#include "isolation/context_message.hpp"
#include "isolation/servant_calls.hpp"
#include "plugins/instance.hpp"
#include "plugins/library.hpp"

namespace tolman::isolation {
namespace {

class RemoteLogger : public Logger {
 public:
  explicit RemoteLogger(const Socket& socket) : socket_(socket) {}
  void write(LogLevel level, std::string_view message) override {
    Note note;
    note.kind = static_cast<std::uint32_t>(Word::Log);
    note.detail = static_cast<std::uint32_t>(level);
    note.text = message;
    (void)socket_.send(note);
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

/// Before there is a run directory writing fails, as in the host.
class LateArtefacts : public ArtefactWriter {
 public:
  std::unique_ptr<ArtefactWriter> folder;
  Status write(std::string_view name, std::span<const std::byte> bytes) override {
    if (folder) return folder->write(name, bytes);
    return Status::failed("there is no run directory yet; write artefacts after configure()");
  }
};

/// Ends this process, and what the plugin started, as soon as the host is no more: the plugin may
/// be in a call that never ends.
void followHost(int socket) {
  // The group as it was made: a plugin that changes its own must not take the host's with it.
  std::thread([socket, group = ::getpid()] {
    pollfd watched{socket, 0, 0};  // only that it was hung up
    while (::poll(&watched, 1, -1) <= 0) {
    }
    ::kill(-group, SIGKILL);
    ::kill(group, SIGKILL);
  }).detach();
}

plugins::OrRefusal<plugins::LoadedPlugin> find(const LoadMessage& message) {
  auto manifest = plugins::readManifest(message.file, message.id);
  if (auto* refusal = std::get_if<plugins::Refusal>(&manifest)) return *refusal;
  return plugins::loadPlugin(std::get<plugins::Manifest>(manifest),
                             plugins::HostIdentity::ofThisBuild());
}

class Servant {
 public:
  Servant(const std::vector<int>& descriptors, const ServantServices& services)
      : socket_(Descriptor(descriptors.at(0))),
        request_(descriptors.at(1)),
        response_(descriptors.at(2)),
        control_(descriptors.at(3)),
        services_(services),
        log_(socket_),
        cancellation_(*reinterpret_cast<const ControlBlock*>(control_.view(sizeof(ControlBlock)))) {
    for (const int descriptor : descriptors) {
      ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);  // what the plugin starts must not hold them
    }
    followHost(socket_.descriptor());
    addOwnCalls();
  }

  void run() {
    Note note;
    for (;;) {
      const Wait heard = socket_.receive(note, std::chrono::milliseconds(-1));
      if (heard == Wait::Gone) return;
      if (heard == Wait::Note) answer(note);
    }
  }

 private:
  void answer(const Note& question) {
    Decoder in(request_.view(question.size), question.size);
    Encoder out(response_);
    const auto found = handlers_.find(static_cast<Call>(question.kind));
    if (found == handlers_.end()) {
      out.put(Status::failed("this plugin has no such call"));
    } else {
      found->second(in, out);
    }
    Note reply;
    reply.kind = static_cast<std::uint32_t>(Word::Reply);
    reply.detail = question.detail;
    reply.size = out.size();
    (void)socket_.send(reply);
  }

  void addOwnCalls() {
    handlers_[Call::Load] = handler(Takes<LoadMessage>{}, Gives<RefusalMessage, Schema>{},
                                    [this](const auto& message, auto& no, Schema& schema) {
                                      return load(message, no, schema);
                                    });
    handlers_[Call::Create] =
        handler(Takes<>{}, Gives<RefusalMessage, bool, bool>{},
                [this](auto& no, bool& arrays, bool& state) { return create(no, arrays, state); });
    handlers_[Call::Configure] = handler(Takes<ContextMessage>{}, Gives<>{},
                                         [this](auto& message) { return configure(message); });
    handlers_[Call::OpenArtefacts] =
        handler(Takes<std::string>{}, Gives<>{}, [this](const std::string& directory) {
          artefacts_.folder = services_.artefacts(directory, context_.instance);
          return Status::ok();
        });
    handlers_[Call::Destroy] = handler(Takes<>{}, Gives<>{}, [this] {
      Plugin* doomed = std::exchange(object_, PluginObject{}).plugin;
      if (doomed != nullptr) plugin_->descriptor->destroy(doomed);
      return Status::ok();
    });
  }

  Status load(const LoadMessage& message, RefusalMessage& refusal, Schema& schema) {
    limitResources(message.memory_mib);
    if (message.threads > 0) {
      threads_.emplace(tbb::global_control::max_allowed_parallelism,
                       static_cast<std::size_t>(message.threads));
    }
    auto loaded = find(message);
    if (auto* no = std::get_if<plugins::Refusal>(&loaded)) {
      refusal = {no->id, no->message, no->remedy};
      return Status::ok();
    }
    plugin_ = std::move(std::get<plugins::LoadedPlugin>(loaded));
    schema = plugin_->schema;
    return Status::ok();
  }

  Status create(RefusalMessage& refusal, bool& arrays, bool& state) {
    object_ = plugin_->descriptor->create();
    if (object_.plugin == nullptr) {
      const plugins::Refusal none = plugins::nullInstance(plugin_->manifest);
      refusal = {none.id, none.message, none.remedy};
      return Status::ok();
    }
    arrays = object_.arrays != nullptr;
    state = object_.state != nullptr;
    handlers_.merge(handlersOf(plugin_->manifest.role, object_));
    return Status::ok();
  }

  Status configure(ContextMessage& message) {
    context_ = std::move(message);
    return object_.plugin->configure({context_.parameters, log_, artefacts_, cancellation_,
                                      services_.clock, context_.rig, context_.seed,
                                      context_.instance, context_.interactive, context_.quiet});
  }

  Socket socket_;
  SharedBuffer request_;
  SharedBuffer response_;
  SharedBuffer control_;
  const ServantServices& services_;
  RemoteLogger log_;
  LateArtefacts artefacts_;
  RemoteCancellation cancellation_;
  std::optional<tbb::global_control> threads_;
  ContextMessage context_;
  std::optional<plugins::LoadedPlugin> plugin_;
  PluginObject object_;
  Handlers handlers_;
};

}  // namespace

void serve(const std::vector<int>& descriptors, const ServantServices& services) {
  try {
    Servant(descriptors, services).run();
  } catch (...) {  // the host sees that this process ended
    ::_exit(70);
  }
  ::_exit(0);
}

}  // namespace tolman::isolation
