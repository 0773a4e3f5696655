// SPDX-License-Identifier: BSD-3-Clause
// The roles of a plugin in another process.

#include <array>
#include <istream>
#include <iterator>
#include <ostream>
#include <stdexcept>

#include "host/remote_plugin.hpp"

namespace tolman::host {
namespace {

/// The calls that all roles have.
template <class RoleType>
class RemoteRole : public RoleType,
                   public ArraySource,
                   public ArrayDescriptions,
                   public PageServer,
                   public RawRigSource,
                   public StateKeeper {
 public:
  explicit RemoteRole(std::shared_ptr<RemotePlugin> remote) : remote_(std::move(remote)) {}

  Status configure(const Context& context) override { return remote_->configure(context); }
  Status reset() override { return ask(Call::Reset); }

  void arrays(std::vector<NamedArray>& arrays) const override {
    const Status status = ask(Call::Arrays, arrays);
    if (!status.isOk()) throw std::runtime_error(status.message());
  }
  Status describe(std::vector<ArrayInfo>& arrays) const override {
    std::vector<ArrayInfo> described;
    const Status status = ask(Call::Describe, described);
    arrays.insert(arrays.end(), described.begin(), described.end());
    return status;
  }
  std::string url() const override {
    std::string url;
    const Status status = ask(Call::Url, url);
    if (!status.isOk()) throw std::runtime_error(status.message());
    return url;
  }
  Status rawRig(RawRig& rig) override { return ask(Call::RawRig, rig); }
  Status save(std::ostream& stream) const override {
    std::string bytes;
    const Status status = ask(Call::Save, bytes);
    if (status.isOk()) stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return status;
  }
  Status load(std::istream& stream) override {
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    return ask(Call::Restore, bytes);
  }

  RemotePlugin& remote() { return *remote_; }

 protected:
  template <class... T>
  Status ask(Call call, T&... values) const {
    return remote_->call(call, values...);
  }
  std::shared_ptr<RemotePlugin> remote_;
};

class RemoteSource final : public RemoteRole<Source> {
 public:
  using RemoteRole::RemoteRole;
  Status info(SourceInfo& info) override { return ask(Call::Info, info); }
  Status next(Frame& frame) override { return ask(Call::Next, frame); }
};

class RemoteOdometry final : public RemoteRole<Odometry> {
 public:
  using RemoteRole::RemoteRole;
  /// A new process without the state of the last one begins anew: until it finds a motion, those
  /// frames fail and the engine predicts them, instead of recording that the camera stood.
  Status track(const Frame& frame, Motion& motion) override {
    const Status status = ask(Call::Track, frame, motion);
    if (!status.isOk()) return status;
    begins_ = (begins_ || remote_->takeStateLoss()) && motion.state == TrackingState::Initialising;
    return begins_ ? Status::failed("was restarted and has found no motion yet") : status;
  }
  Status finish(std::vector<MotionRevision>& revisions) override {
    return ask(Call::FinishOdometry, revisions);
  }

 private:
  bool begins_ = false;
};

class RemotePlace final : public RemoteRole<Place> {
 public:
  using RemoteRole::RemoteRole;
  PlaceInput input() const override {
    PlaceInput input = PlaceInput::Frame;
    const Status status = ask(Call::Input, input);
    if (!status.isOk()) throw std::runtime_error(status.message());
    return input;
  }
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation) override {
    const auto given = motion == nullptr ? std::nullopt : std::optional(*motion);
    return ask(Call::Observe, frame, given, observation);
  }
  Status finish() override { return ask(Call::FinishPlace); }
};

class RemoteCells final : public RemoteRole<Cells> {
 public:
  using RemoteRole::RemoteRole;
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override {
    return ask(Call::Step, motion, observation, decision);
  }
  Status finish() override { return ask(Call::FinishCells); }
};

class RemoteMap final : public RemoteRole<Map> {
 public:
  using RemoteRole::RemoteRole;
  Status update(const Motion& motion, const Decision& decision, MapUpdate& update) override {
    return ask(Call::Update, motion, decision, update);
  }
  Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const override {
    const std::int64_t asked = frame;
    return ask(Call::PoseOf, asked, T_world_camera);
  }
  Status graph(MapGraph& graph) const override { return ask(Call::Graph, graph); }
  Status finish(const std::vector<MotionRevision>& revisions) override {
    return ask(Call::FinishMap, revisions);
  }
};

class RemoteObserver final : public RemoteRole<Observer> {
 public:
  using RemoteRole::RemoteRole;
  Status begin(const RunInfo& run) override { return ask(Call::Begin, run); }
  Status observe(const Snapshot& s) override {
    const auto graph = s.graph == nullptr ? std::nullopt : std::optional(*s.graph);
    const std::vector<RunEvent> events = s.events != nullptr ? *s.events : std::vector<RunEvent>();
    return ask(Call::Watch, *s.frame, *s.motion, *s.place, *s.decision, *s.map, *s.cells, graph,
               s.stage_times_ns, events);
  }
  Status finish(const MapGraph& graph) override { return ask(Call::FinishObserver, graph); }
};

template <class Proxy>
std::unique_ptr<Instance> adopt(std::shared_ptr<RemotePlugin> remote, const std::string& name) {
  const Manifest& manifest = remote->manifest();
  auto proxy = std::make_unique<Proxy>(remote);
  PluginObject object{proxy.get()};
  if (remote->hasArrays()) object.arrays = proxy.get();
  if (remote->hasState()) object.state = proxy.get();
  if (manifest.hasExtra("descriptions")) object.descriptions = proxy.get();
  if (manifest.hasExtra("page")) object.page = proxy.get();
  if (manifest.hasExtra("raw_rig")) object.raw_rig = proxy.get();
  (void)proxy.release();  // owned by the instance
  return std::make_unique<Instance>(manifest, name, object, [](Plugin* plugin) {
    const std::unique_ptr<Proxy> owned(static_cast<Proxy*>(plugin));
    return owned->remote().destroy();
  });
}

}  // namespace

std::unique_ptr<Instance> instantiate(std::shared_ptr<RemotePlugin> remote,
                                      const std::string& name) {
  constexpr std::array kAdopt = {&adopt<RemoteSource>, &adopt<RemoteOdometry>,
                                 &adopt<RemotePlace>,  &adopt<RemoteCells>,
                                 &adopt<RemoteMap>,    &adopt<RemoteObserver>};
  remote->create();
  const auto role = static_cast<std::size_t>(remote->manifest().role);
  return kAdopt.at(role)(std::move(remote), name);
}

Status openArtefacts(RemotePlugin& remote, const std::string& run_directory) {
  return remote.call(Call::OpenArtefacts, run_directory);
}

}  // namespace tolman::host
