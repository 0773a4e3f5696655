// SPDX-License-Identifier: BSD-3-Clause
#include "engine/assembly.hpp"

#include <algorithm>

#include "host/remote_plugin.hpp"
#include "record/atomic_file.hpp"

namespace tolman::engine {
namespace {

/// The seed of an instance depends on its name, so adding a plugin does not change the others'.
std::uint64_t seedOf(std::int64_t run_seed, const std::string& instance) {
  const auto start = static_cast<std::uint64_t>(run_seed) ^ 0xcbf29ce484222325ULL;
  return RandomStream(detail::fnv1a(start, instance)).bits();
}

/// The kind of a failure of configure(): Configuration for a bad value, Dataset for other failures
/// of a source.
FailureKind configureFailure(Role role, const Status& status) {
  const StatusCode code = status.code();
  if (code == StatusCode::InvalidParameter) return FailureKind::Configuration;
  if (role == Role::Source) return FailureKind::Dataset;
  return code == StatusCode::Unsupported ? FailureKind::Configuration : FailureKind::Plugin;
}

}  // namespace

std::unique_ptr<host::Instance> instantiate(const CheckedSystem& system, std::size_t i) {
  const std::string& name = system.config.stages[i].instance;
  const auto& remote = system.remotes[i];
  return opening(
      [&] {
        return remote ? host::instantiate(remote, name)
                      : host::Instance::create(system.plugins[i], name);
      },
      name);
}

Assembly::Assembly(CheckedSystem checked, RunLog& log, const Clock& clock,
                   const Cancellation& cancellation)
    : checked_(std::move(checked)),
      findings_(std::make_unique<Findings>(checked_.config.general.on_findings)) {
  for (std::size_t i = 0; i < checked_.config.stages.size(); ++i) {
    const config::StageConfig& stage = checked_.config.stages[i];
    auto instance = instantiate(checked_, i);
    const auto& services = services_.emplace_back(std::unique_ptr<Services>(
        new Services{stage.instance, {log, stage.instance}, {*findings_, stage.instance}, {}}));
    const Status status = findings_->judge(
        instance->configure({checked_.values.find(stage.instance)->second, services->log,
                             services->findings, services->artefacts, cancellation, clock,
                             info_.rig, seedOf(checked_.config.general.seed, stage.instance),
                             stage.instance}),
        -1);
    for (const Findings::Kind& kind : findings_->takeNewKinds()) {
      log.write(kind.level(), kind.first.stage, kind.text());
    }
    // What configure() answers then says nothing of the plugin or its data.
    if (cancellation.requested()) {
      throw Failure(FailureKind::Interrupted,
                    "interrupted while it was configured; nothing was run", stage.instance);
    }
    require(status, configureFailure(stage.role, status), stage.instance);
    instances_.push_back(instance.get());
    add(std::move(instance), stage);
    if (stage.role != Role::Source) continue;  // it is the first stage
    require(source().info(info_), FailureKind::Dataset, stage.instance);
  }
}

void Assembly::add(std::unique_ptr<host::Instance> instance, const config::StageConfig& stage) {
  switch (stage.role) {
    case Role::Source:
      source_ = std::make_unique<RectifiedSource>(
          std::move(instance), checked_.config.rectification, checked_.config.images);
      source_->judgeBy(*findings_);
      source_->setTruth(truePath(stage));
      break;
    case Role::Odometry:
      odometry_ = std::make_unique<host::OdometryStage>(std::move(instance));
      checked_odometry_ = std::make_unique<CheckedOdometry>(*odometry_, checked_.config.checks);
      break;
    case Role::Place:
      place_ = std::make_unique<host::PlaceStage>(std::move(instance));
      break;
    case Role::Cells:
      cells_ = std::make_unique<host::CellsStage>(std::move(instance));
      break;
    case Role::Map:
      map_ = std::make_unique<host::MapStage>(std::move(instance));
      break;
    case Role::Observer:
      observers_.push_back({host::ObserverStage(std::move(instance)), stage.on_failure});
      break;
  }
}

TruePath Assembly::truePath(const config::StageConfig& source) {
  config::EvaluationSettings settings = checked_.config.evaluation;
  // A replayed run has the truth of its camera already.
  if (source.plugin == "record" && settings.truth.empty()) settings = {};
  const auto& values = checked_.values.find(source.instance)->second;
  const auto found = values.find("path");
  const auto* folder = found == values.end() ? nullptr : std::get_if<std::string>(&found->second);
  Result<TruePath> path = TruePath::open(settings, folder == nullptr ? "" : *folder);
  const bool is_given = path.status().code() == StatusCode::InvalidParameter;  // the body
  if (path.isOk() || is_given || !settings.truth.empty()) {
    require(path.status(), is_given ? FailureKind::Configuration : FailureKind::Dataset);
    return std::move(path).value();
  }
  findings_->add("evaluation",
                 {Finding::Severity::Error, "truth", path.status().message(),
                  "correct the true poses, or remove the file", Finding::Kind::Damaged});
  return {};
}

void Assembly::openArtefacts(const std::filesystem::path& run_directory) {
  for (const auto& services : services_) {
    services->artefacts.folder =
        std::make_unique<record::ArtefactFolder>(run_directory, services->instance);
  }
  for (const auto& remote : checked_.remotes) {
    // If the process has ended, the next call reports the failure.
    if (remote) (void)host::openArtefacts(*remote, run_directory.string());
  }
}

std::vector<Status> Assembly::teardown() {
  std::vector<Status> failures;
  // clang 14 cannot compile views::reverse of this library.
  for (auto instance = instances_.rbegin(); instance != instances_.rend(); ++instance) {
    Status status = (*instance)->destroy();
    if (!status.isOk()) failures.push_back(std::move(status));
  }
  return failures;
}

Status Assembly::describeArrays(std::vector<ArrayInfo>& arrays) {
  const Status status = source_->instance().describe(arrays);
  return status.isOk() && cells_ ? cells_->instance().describe(arrays) : status;
}

Policies Assembly::policies() const {
  Policies policies{};
  for (const config::StageConfig& stage : checked_.config.stages) {
    policies.at(static_cast<std::size_t>(stage.role)) = stage.on_failure;
  }
  return policies;
}

}  // namespace tolman::engine
