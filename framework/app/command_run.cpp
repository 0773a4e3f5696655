// SPDX-License-Identifier: BSD-3-Clause
// tolman run: a whole run, recorded.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <optional>

#include "app/provenance.hpp"
#include "app/report_files.hpp"
#include "app/results.hpp"
#include "app/run_listener.hpp"
#include "app/saved_session.hpp"
#include "app/summary.hpp"
#include "app/system_options.hpp"
#include "app/view.hpp"
#include "record/atomic_file.hpp"
#include "record/run_directory.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

/// One run from its parts; each step may end it.
class Run {
 public:
  /// `replace`: also where `out` holds a run.
  Run(Invocation& invocation, std::string out, bool replace)
      : invocation_(invocation), out_(std::move(out)), replace_(replace), log_(invocation.quiet) {}

  ExitCode execute(const SystemOptions& options) {
    auto checked = checkSystem(options);
    if (auto* failure = std::get_if<Failure>(&checked)) return tell(*failure);
    const Audience audience{isatty(STDERR_FILENO) == 1 && !invocation_.quiet, invocation_.quiet};
    auto assembled = Assembly::create(std::move(std::get<CheckedSystem>(checked)), log_, clock_,
                                      interrupts_, audience);
    if (auto* failure = std::get_if<Failure>(&assembled)) return tell(*failure);
    assembly_ = std::move(std::get<std::unique_ptr<Assembly>>(assembled));
    Status status = assembly_->source().info(info_);
    if (!status.isOk()) return tell({ExitCode::Dataset, status.message()});
    if (const auto failure = goOn()) return tell(*failure);
    status = openRecord();
    if (!status.isOk()) return tell({ExitCode::Record, status.message()});
    return drive();
  }

 private:
  const config::SystemConfig& config() const { return assembly_->system().config; }

  /// Takes up the map of an earlier run, if one is named.
  std::optional<Failure> goOn() {
    const std::string& directory = config().general.go_on_from;
    if (directory.empty()) return std::nullopt;
    std::error_code ignored;
    if (!out_.empty() && std::filesystem::equivalent(out_, directory, ignored)) {
      return Failure{ExitCode::Session, directory +
                                            ": cannot go on in its own directory; give "
                                            "another one with --out"};
    }
    auto opened = record::RunReader::open(directory);
    if (!opened.isOk()) return Failure{ExitCode::Session, opened.status().message()};
    earlier_ = std::move(opened).value();
    const auto frames = earlier_->nextFrame();
    if (!frames.isOk()) return Failure{ExitCode::Session, frames.status().message()};
    const auto loaded = loadSession(*assembly_, directory);
    if (const auto* failure = std::get_if<Failure>(&loaded)) return *failure;
    const auto& before = std::get<Progress>(loaded);
    if (frames.value() != before.frames) {
      return Failure{ExitCode::Session,
                     directory + ": run.sqlite has " + std::to_string(frames.value()) +
                         " frames, the saved map " + std::to_string(before.frames) +
                         "; they are not of one run"};
    }
    first_frame_ = before.frames;
    assembly_->source().startAt(first_frame_);
    assembly_->odometry().startAt(first_frame_);
    assembly_->place().expect(before.templates);
    assembly_->cells().expect(before.experiences);
    return std::nullopt;
  }

  /// The sessions before, and this one.
  Status recordSessions() {
    record::Session session{0, first_frame_, config().general.name, info_.description};
    if (earlier_) {
      const auto sessions = earlier_->sessions();
      if (!sessions.isOk()) return sessions.status();
      session.id = static_cast<std::int64_t>(sessions.value().size());
      if (Status status = recorder_->inherit(*earlier_); !status.isOk()) return status;
      earlier_.reset();
    }
    return recorder_->session(session);
  }

  /// The run directory comes last, so that a failing start leaves an earlier run alone.
  Status openRecord() {
    record::RunDirectoryOptions options;
    options.name = config().general.name;
    options.utc_seconds = utcSeconds();
    if (!out_.empty()) options.out = out_;
    options.replace = replace_;
    auto directory = record::RunDirectory::create(options);
    if (!directory.isOk()) return directory.status();
    directory_ = std::make_unique<record::RunDirectory>(std::move(directory).value());
    log_.openFile(directory_->path() / "log.txt");
    assembly_->openArtefacts(directory_->path());
    provenance_ =
        provenance(assembly_->system(), info_, invocation_.command_line, config().general.threads);
    if (!config().general.go_on_from.empty()) {
      provenance_["continued"] = {{"directory", config().general.go_on_from},
                                  {"first_frame", first_frame_}};
    }
    Status status =
        record::writeAtomically(directory_->path() / "config.resolved.yaml",
                                config::resolvedYaml(config(), assembly_->system().values));
    if (status.isOk()) {
      status = directory_->writeRunFile(provenance_, record::RunState::Running);
    }
    if (!status.isOk()) return status;
    auto recorder = record::Recorder::open(directory_->path());
    if (!recorder.isOk()) return recorder.status();
    recorder_ = std::move(recorder).value();
    status = recordSessions();
    if (!status.isOk()) return status;
    return recorder_->meta("name", config().general.name);
  }

  ExitCode drive() {
    const auto start = std::chrono::steady_clock::now();
    RunListener listener(*recorder_, assembly_->observers(), log_, config().record.arrays_every);
    const pipeline::Policies policies{assembly_->policy(Role::Odometry),
                                      assembly_->policy(Role::Place),
                                      assembly_->policy(Role::Cells), assembly_->policy(Role::Map)};
    pipeline::Chain chain({assembly_->source(), assembly_->odometry(), assembly_->place(),
                           assembly_->cells(), assembly_->map()},
                          policies, listener);
    const Status begun =
        listener.begin({config().general.name, directory_->path().string(), info_});
    if (!begun.isOk()) chain.fail(begun);
    const pipeline::Outcome outcome =
        pipeline::run(chain, config().pipeline, config().general.threads, interrupts_);
    keepSession(outcome, listener);
    for (const Status& status : assembly_->teardown()) {
      listener.onEvent({-1, LogLevel::Warning, "teardown", status.message()});
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return conclude(outcome, listener.recordStatus(), wall.count());
  }

  /// What a failed stage still knows is not to be built on.
  void keepSession(const pipeline::Outcome& outcome, RunListener& listener) {
    const pipeline::Counters& n = outcome.counters;
    if (!outcome.status.isOk() || n.frames == 0 || !listener.recordStatus().isOk()) return;
    const Status saved =
        saveSession(*assembly_, directory_->path(), {listener.nextFrame(), n.experiences, -1});
    if (!saved.isOk()) listener.onEvent({-1, LogLevel::Warning, "session", saved.message()});
  }

  ExitCode codeOf(const pipeline::Outcome& outcome, const Status& record_status) const {
    if (!record_status.isOk()) return ExitCode::Record;
    if (!outcome.status.isOk()) {
      const bool data = outcome.status.message().starts_with(
          assembly_->system().config.stages.front().instance + " (");
      return data ? ExitCode::Dataset : ExitCode::PluginFailed;
    }
    if (outcome.interrupted) return ExitCode::Interrupted;
    return outcome.counters.lost_at_end ? ExitCode::TrackingLost : ExitCode::Ok;
  }

  ExitCode conclude(const pipeline::Outcome& outcome, const Status& record_status, double wall) {
    const Status closed = recorder_->close();
    const ExitCode code = codeOf(outcome, record_status.isOk() ? closed : record_status);
    addOutcome(provenance_, outcome, code);
    const auto state = code == ExitCode::Ok || code == ExitCode::TrackingLost
                           ? record::RunState::Finished
                       : code == ExitCode::Interrupted ? record::RunState::Interrupted
                                                       : record::RunState::Failed;
    Result<Results> results = Status::failed("no frame was processed");
    if (outcome.counters.frames > 0) {
      results = writeResults(directory_->path(), config().evaluation);
      if (!results.isOk()) std::cerr << results.status().message() << "\n";
    }
    const Status written = directory_->writeRunFile(provenance_, state);
    if (!written.isOk()) std::cerr << written.message() << "\n";
    if (results.isOk()) {
      const Status reported = writeReport(*results.value().reader, results.value().data);
      if (!reported.isOk()) std::cerr << reported.message() << "\n";
    }
    show(outcome, results.isOk() ? &results.value().data.metrics : nullptr, wall);
    if (!outcome.status.isOk()) return tell({code, outcome.status.message()});
    return code;
  }

  /// `metrics` is null where there are none.
  void show(const pipeline::Outcome& outcome, const evaluation::Metrics* metrics,
            double wall) const {
    if (invocation_.json) {
      nlohmann::ordered_json json = provenance_;
      json["directory"] = directory_->path().string();
      if (metrics != nullptr) json["metrics"] = evaluation::toJson(*metrics);
      std::cout << json.dump(2) << "\n";
    } else if (!invocation_.quiet) {
      std::cout << fmt::format("{:<10}{}\n", "run", directory_->path().string())
                << healthText(outcome, wall);
      if (metrics == nullptr) return;
      std::cout << figuresText(*metrics)
                << fmt::format("{:<10}{}\n", "report",
                               (directory_->path() / "report.html").string());
    }
  }

  Invocation& invocation_;
  std::string out_;
  bool replace_;
  Interrupts interrupts_;  // before anything that starts threads
  RunLog log_;
  SteadyClock clock_;
  std::unique_ptr<Assembly> assembly_;
  SourceInfo info_;
  std::unique_ptr<record::RunReader> earlier_;  ///< until it is inherited
  std::int64_t first_frame_ = 0;
  std::unique_ptr<record::RunDirectory> directory_;
  nlohmann::ordered_json provenance_;
  std::unique_ptr<record::Recorder> recorder_;
};

}  // namespace

void addRunCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("run", "Run a configuration and record everything");
  auto options = std::make_shared<SystemOptionsReader>(*command);
  options->addContinue(*command);
  auto out = std::make_shared<std::string>();
  command->add_option("--out", *out, "Run directory (default: runs/NAME-TIME)");
  auto replace = std::make_shared<bool>(false);
  command->add_flag("--force", *replace, "Replace the run that the --out directory holds");
  auto view = std::make_shared<bool>(false);
  command->add_flag("--view", *view, "Show the run in the browser (adds observer web_viewer)");
  command->callback([options, out, replace, view, &invocation] {
    Run run(invocation, *out, *replace);
    SystemOptions system = options->read(invocation);
    if (*view) system.observers.emplace_back(kViewer);
    invocation.exit_code = static_cast<int>(run.execute(system));
  });
}

}  // namespace tolman::app
