// SPDX-License-Identifier: BSD-3-Clause
#include "app/view.hpp"

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "record/run_directory.hpp"

namespace tolman::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kPollPeriod = 500ms;  // as often as the recorder commits

Failure dataFailure(const Status& status) { return {ExitCode::Dataset, status.message()}; }

/// What the run's source has said of itself.
SourceInfo sourceInfo(const record::RunReader& reader, const nlohmann::ordered_json& file) {
  SourceInfo info;
  const auto rigs = reader.records<CameraRig>();
  if (rigs.isOk() && !rigs.value().empty()) info.rig = rigs.value().front();
  const auto source = file.find("source");
  if (source == file.end() || !source->is_object()) return info;
  const auto take = [&](const char* key, auto& value) {
    const auto found = source->find(key);
    if (found == source->end()) return;
    try {
      found->get_to(value);
    } catch (const nlohmann::json::exception&) {  // a foreign file
    }
  };
  take("description", info.description);
  take("frames", info.frames);
  take("has_truth", info.has_truth);
  return info;
}

}  // namespace

Status ViewerAddress::write(std::string_view name, std::span<const std::byte> bytes) {
  if (name == "viewer.json") {
    tell_(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  }
  return Status::ok();
}

View::View(const ViewOptions& options, const Clock& clock, const Cancellation& cancellation,
           const ViewListener& listener)
    : options_(options),
      clock_(clock),
      cancellation_(cancellation),
      listener_(listener),
      log_(false),
      logger_(log_, "viewer"),
      address_(listener.address) {}

/// All that the plugin declares, with every frame kept, and serving until cancelled.
ParameterValues View::parametersOf(const Schema& schema) const {
  ParameterValues values;
  for (const ParameterInfo& info : schema) values[info.name] = info.default_value;
  const auto set = [&](const char* name, const ParameterValue& value) {
    if (const auto known = values.find(name); known != values.end()) known->second = value;
  };
  set("rate", 0.0);
  set("stay", true);
  if (options_.port >= 0) set("port", std::int64_t{options_.port});
  if (!options_.bind.empty()) set("bind", options_.bind);
  return values;
}

std::optional<Failure> View::openObserver() {
  auto loaded = loadFrom(openCatalogue(options_.plugin_paths), kViewer, Role::Observer);
  if (auto* refusal = std::get_if<plugins::Refusal>(&loaded)) {
    return Failure{ExitCode::Plugin, refusal->text()};
  }
  const auto& plugin = std::get<plugins::LoadedPlugin>(loaded);
  auto created = plugins::Instance::create(plugin, "viewer");
  if (auto* refusal = std::get_if<plugins::Refusal>(&created)) {
    return Failure{ExitCode::Plugin, refusal->text()};
  }
  auto instance = std::move(std::get<std::unique_ptr<plugins::Instance>>(created));
  values_ = parametersOf(plugin.schema);
  const Context context{values_, logger_, address_, cancellation_, clock_,
                        {},      0,       "viewer", false,         false};
  const Status status = instance->configure(context);
  if (!status.isOk()) {
    const bool choice = status.code() == StatusCode::InvalidParameter;
    return Failure{choice ? ExitCode::Configuration : ExitCode::Plugin, status.message()};
  }
  observer_ = std::make_unique<plugins::ObserverStage>(std::move(instance));
  return std::nullopt;
}

std::optional<Failure> View::beginRun(const record::RunReader& reader, bool running) {
  const auto counters = reader.counters();
  if (!counters.isOk()) return dataFailure(counters.status());
  const auto meta = reader.meta();
  if (!meta.isOk()) return dataFailure(meta.status());
  RunInfo info;
  const auto name = meta.value().find("name");
  info.name = name == meta.value().end() ? "run" : name->second;
  if (record::RunDirectory::wasKilled(options_.run)) {
    info.name += " (killed)";
    listener_.note("the run was killed; what it had recorded is shown");
  }
  info.directory = std::filesystem::absolute(options_.run).lexically_normal().string();
  info.source = sourceInfo(reader, record::RunDirectory::readRunFile(options_.run));
  if (!running) info.source.frames = counters.value().frames;
  listener_.loading(counters.value().frames);
  const Status status = observer_->begin(info);
  if (!status.isOk()) return Failure{ExitCode::PluginFailed, status.message()};
  return std::nullopt;
}

Status View::show(record::RecordedFrame& recorded, const MapGraph* graph) {
  if (images_) images_->restore(recorded.frame);
  if (images_ && !images_->problem().empty() && !image_problem_told_) {
    image_problem_told_ = true;
    listener_.note("without images: " + images_->problem());
  }
  Snapshot snapshot = recorded.snapshot();
  snapshot.graph = graph;
  const Status status = observer_->observe(snapshot);
  listener_.frame();
  return status;
}

/// All frames that are new in the record. The graph is known as it is now only: the first of them
/// brings it.
std::optional<Failure> View::showNews(const record::RunReader& reader, bool running) {
  const auto& graph = reader.graph();
  if (!graph.isOk()) return dataFailure(graph.status());
  auto replay = record::Replay::open(reader, position_, running);
  if (!replay.isOk()) return dataFailure(replay.status());
  record::RecordedFrame recorded;
  graph_ = graph.value();
  const MapGraph* news = &graph_;
  while (!cancellation_.requested()) {
    const auto more = replay.value()->next(recorded);
    if (!more.isOk()) return dataFailure(more.status());
    if (!more.value()) break;
    const Status status = show(recorded, std::exchange(news, nullptr));
    if (!status.isOk()) return Failure{ExitCode::PluginFailed, status.message()};
  }
  position_ = replay.value()->position();
  return std::nullopt;
}

std::optional<Failure> View::follow() {
  for (bool first = true, running = true; running && !cancellation_.requested(); first = false) {
    if (!first) std::this_thread::sleep_for(kPollPeriod);
    running = record::RunDirectory::isBeingWritten(options_.run);  // before the reader looks
    const auto reader = record::RunReader::open(options_.run);
    if (!reader.isOk()) return dataFailure(reader.status());
    if (first) {
      if (auto failure = openObserver()) return failure;
      if (auto failure = beginRun(*reader.value(), running)) return failure;
      if (options_.images) {
        images_ = std::make_unique<RecordedImages>(options_.run, options_.plugin_paths, clock_,
                                                   cancellation_);
      }
    }
    if (auto failure = showNews(*reader.value(), running)) return failure;
    if (first) listener_.loaded();
  }
  return std::nullopt;
}

std::optional<Failure> View::serve() {
  if (auto failure = follow()) return failure;
  images_.reset();
  const Status status = observer_->finish(graph_);  // serves until cancelled
  if (!status.isOk()) return Failure{ExitCode::PluginFailed, status.message()};
  return std::nullopt;
}

}  // namespace tolman::app
