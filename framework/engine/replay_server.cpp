// SPDX-License-Identifier: BSD-3-Clause
#include "engine/replay_server.hpp"

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "record/run_directory.hpp"

namespace tolman::engine {
namespace {

using namespace std::chrono_literals;

constexpr auto kPollPeriod = 500ms;  // as often as the recorder commits

template <class Answer>
auto readable(Answer answer) {
  return require(std::move(answer), FailureKind::Dataset);
}

void requireObserved(const Status& status) { require(status, FailureKind::Stage, "viewer"); }

/// The recorded description of the run's source.
SourceInfo sourceInfo(const record::RunReader& reader, const nlohmann::ordered_json& file) {
  SourceInfo info;
  const auto rigs = reader.records<CameraRig>();
  if (rigs.isOk() && !rigs.value().empty()) info.rig = rigs.value().front();
  const auto take = [&](const char* key, auto& value) {
    try {
      file.at("source").at(key).get_to(value);
    } catch (const nlohmann::json::exception&) {  // a foreign file
    }
  };
  take("description", info.description);
  take("frames", info.frames);
  take("has_truth", info.has_truth);
  return info;
}

}  // namespace

RecordedImages::RecordedImages(const std::filesystem::path& directory,
                               std::vector<std::string> plugin_paths, const Clock& clock,
                               const Cancellation& cancellation) {
  const std::filesystem::path config = directory / "config.resolved.yaml";
  try {
    assembly_ = std::make_unique<Assembly>(
        checkSystem({config.string(), {}, std::move(plugin_paths)}, Scope::Source), log_, clock,
        cancellation);
  } catch (const Failure& failed) {
    end(failed.what());
  }
}

void RecordedImages::restore(Frame& recorded) {
  while (assembly_ && next_.frame < recorded.frame) {
    const Status status = assembly_->source().next(next_);
    if (status.code() == StatusCode::EndOfStream) return end("the source has fewer frames now");
    if (!status.isOk()) return end(status.message());
  }
  if (!assembly_) return;
  if (next_.frame != recorded.frame || next_.stamp_ns != recorded.stamp_ns) {
    return end("the data are not those of the run: frame " + std::to_string(recorded.frame) +
               " has another time");
  }
  recorded.left = next_.left;
  recorded.right = next_.right;
}

std::map<std::int64_t, Image> RecordedImages::views(const record::RunReader& reader,
                                                    const std::set<std::int64_t>& frames) {
  std::map<std::int64_t, Image> views;
  record::RowsOf<Frame> rows(reader.database(), "WHERE \"frame\" = ?");
  for (const std::int64_t frame : frames) {
    rows.each(
        [&](Frame recorded) {
          restore(recorded);
          if (!recorded.left.empty()) views[frame] = recorded.left;
        },
        frame);
  }
  return views;
}

void RecordedImages::end(const std::string& problem) {
  problem_ = problem.substr(0, problem.find('\n'));
  assembly_.reset();
}

/// Defaults of the plugin, with every frame kept and serving until cancelled. Parameters that the
/// plugin does not declare are left out.
ParameterValues ReplayServer::parametersOf(const Schema& schema, bool running) const {
  ParameterValues values;
  for (const ParameterInfo& info : schema) values[info.name] = info.default_value;
  const auto set = [&](const char* name, const ParameterValue& value) {
    if (const auto known = values.find(name); known != values.end()) known->second = value;
  };
  set("rate", 0.0);
  set("stay", true);
  set("recorded", !running);
  if (options_.port >= 0) set("port", std::int64_t{options_.port});
  if (!options_.bind.empty()) set("bind", options_.bind);
  return values;
}

void ReplayServer::openObserver(bool running) {
  const host::Catalogue catalogue = openCatalogue(options_.plugin_paths);
  const host::LoadedPlugin plugin =
      loadFrom(catalogue, findPageObserver(catalogue), Role::Observer);
  auto instance = opening([&] { return host::Instance::create(plugin, "viewer"); });
  values_ = parametersOf(plugin.schema, running);
  const Context context{values_, logger_, findings_, artefacts_, cancellation_,
                        clock_,  {},      0,         "viewer"};
  const Status status = instance->configure(context);
  const bool choice = status.code() == StatusCode::InvalidParameter;
  require(status, choice ? FailureKind::Configuration : FailureKind::Plugin, "viewer");
  observer_ = std::make_unique<host::ObserverStage>(std::move(instance));
}

void ReplayServer::beginRun(const record::RunReader& reader, bool running) {
  const record::RunTotals totals = readable(reader.totals());
  const auto meta = readable(reader.meta());
  const auto name = meta.find("name");
  RunInfo info;
  info.name = name == meta.end() ? "run" : name->second;
  if (record::RunDirectory::wasKilled(options_.run)) {
    info.name += " (killed)";
    listener_.note("the run was killed; what it had recorded is shown");
  }
  info.directory = std::filesystem::absolute(options_.run).lexically_normal().string();
  info.source = sourceInfo(reader, record::RunDirectory::readRunFile(options_.run));
  info.arrays = readable(reader.arrayInfos());
  if (!running) info.source.frames = totals.frames;
  listener_.loading(totals.frames);
  requireObserved(observer_->begin(info));
  listener_.serving(require(observer_->instance().url(), FailureKind::Stage));
}

void ReplayServer::show(record::RecordedFrame& recorded, const MapGraph* graph) {
  if (images_) images_->restore(recorded.frame);
  if (images_ && !images_->problem().empty() && !image_problem_reported_) {
    image_problem_reported_ = true;
    listener_.note("without images: " + images_->problem());
  }
  Snapshot snapshot = recorded.snapshot();
  snapshot.graph = graph;
  requireObserved(observer_->observe(snapshot));
  listener_.frame();
}

/// Passes on all frames that are new in the record. The first of them carries the graph, because
/// the record has only its newest version.
void ReplayServer::showNewFrames(const record::RunReader& reader, bool running) {
  graph_ = readable(reader.graph());
  const auto replay = readable(record::Replay::open(reader, position_, running));
  record::RecordedFrame recorded;
  const MapGraph* new_graph = &graph_;
  while (!cancellation_.requested() && readable(replay->next(recorded))) {
    show(recorded, std::exchange(new_graph, nullptr));
  }
  position_ = replay->position();
}

void ReplayServer::follow() {
  for (bool first = true, running = true; running && !cancellation_.requested(); first = false) {
    if (!first) std::this_thread::sleep_for(kPollPeriod);
    running = record::RunDirectory::isBeingWritten(options_.run);  // before the reader looks
    const auto reader = readable(record::RunReader::open(options_.run));
    if (first) {
      openObserver(running);
      beginRun(*reader, running);
      if (options_.images) {
        images_ = std::make_unique<RecordedImages>(options_.run, options_.plugin_paths, clock_,
                                                   cancellation_);
      }
    }
    showNewFrames(*reader, running);
    if (first) listener_.loaded();
  }
}

void ReplayServer::serve() {
  follow();
  images_.reset();
  requireObserved(observer_->finish(graph_));  // serves until cancelled
}

}  // namespace tolman::engine
