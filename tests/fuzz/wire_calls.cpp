// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the calls that the process of an isolated plugin receives. The first byte of an
// input chooses the role, the second the call, the rest are its arguments.
#include <array>

#include "host/child_process.hpp"
#include "host/plugin_process.hpp"
#include "input.hpp"

namespace {

using namespace tolman;

/// Answers what it was asked with.
class Quiet final : public Source,
                    public Odometry,
                    public Place,
                    public Cells,
                    public Map,
                    public Observer,
                    public StateKeeper {
 public:
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status info(SourceInfo&) override { return Status::ok(); }
  Status next(Frame&) override { return Status::endOfStream(); }
  Status track(const Frame& frame, Motion& motion) override {
    motion.frame = frame.frame;
    return Status::ok();
  }
  Status observe(const Frame&, const Motion* motion, PlaceObservation& view) override {
    if (motion != nullptr) view.frame = motion->frame;
    return Status::ok();
  }
  Status step(const Motion& motion, const PlaceObservation&, Decision& decision) override {
    decision.earlier.resize(std::min<std::size_t>(motion.revisions.size(), 8));
    return Status::ok();
  }
  Status update(const Motion&, const Decision&, MapUpdate&) override { return Status::ok(); }
  Status poseOf(std::int64_t frame, Eigen::Isometry3d&) const override {
    return frame < 0 ? Status::invalidParameter("no such frame") : Status::ok();
  }
  Status graph(MapGraph&) const override { return Status::ok(); }
  Status begin(const RunInfo& run) override {
    return run.arrays.empty() ? Status::failed("no arrays") : Status::ok();
  }
  Status observe(const Snapshot& snapshot) override {
    const bool rejects = snapshot.graph != nullptr && !snapshot.graph->rejected.empty();
    return rejects ? Status::failed("rejected") : Status::ok();
  }
  Status finish(std::vector<MotionRevision>&) override { return Status::ok(); }
  Status finish() override { return Status::ok(); }
  Status finish(const std::vector<MotionRevision>&) override { return Status::ok(); }
  Status finish(const MapGraph&) override { return Status::ok(); }
  Status save(std::ostream&) const override { return Status::ok(); }
  Status load(std::istream&) override { return Status::ok(); }
};

template <class RoleType>
host::Handlers handlersOf(Role role, Quiet& plugin) {
  PluginObject object{static_cast<RoleType*>(&plugin)};
  object.state = &plugin;
  return host::handlersOf(role, object);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Quiet plugin;
  static const std::array<host::Handlers, 6> kHandlers = {
      handlersOf<Source>(Role::Source, plugin), handlersOf<Odometry>(Role::Odometry, plugin),
      handlersOf<Place>(Role::Place, plugin),   handlersOf<Cells>(Role::Cells, plugin),
      handlersOf<Map>(Role::Map, plugin),       handlersOf<Observer>(Role::Observer, plugin)};
  fuzz::Input input({data, size});
  const std::size_t role = input.take<std::uint8_t>() % kHandlers.size();
  const auto call = static_cast<host::Call>(input.take<std::uint8_t>());
  const fuzz::Bytes bytes = input.rest();
  Decoder decoder(fuzz::asText(bytes));
  Encoder encoder;
  try {
    host::ContextMessage context;
    host::LoadMessage load;
    const auto found = kHandlers.at(role).find(call);
    if (found != kHandlers.at(role).end()) found->second(decoder, encoder);
    if (call == host::Call::Configure) decoder.get(context);
    if (call == host::Call::Load) decoder.get(load);
  } catch (const std::domain_error&) {  // ends the process
  }
  return 0;
}
