// SPDX-License-Identifier: BSD-3-Clause
// tolman run: a whole run, recorded; tolman check: the same configuration without running it;
// tolman rerun: the same run again, compared byte for byte.
#include <fmt/format.h>

#include <iostream>
#include <map>
#include <set>

#include "app/options.hpp"
#include "app/summary.hpp"
#include "engine/checked_system.hpp"
#include "engine/provenance.hpp"
#include "engine/run.hpp"
#include "record/digest.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct RunCommand {
  Output out;
  bool view = false;
};

engine::Outcome execute(engine::CheckedSystem checked, engine::RunOptions options,
                        const Invocation& invocation, const engine::Interrupts& interrupts) {
  options.command_line = invocation.command_line;
  options.exit_code = [](const engine::Outcome& o) { return static_cast<int>(exitCode(o)); };
  engine::RunLog log(invocation.quiet);
  const engine::SteadyClock clock;
  return engine::Run(log, clock, interrupts, std::move(options)).execute(std::move(checked));
}

ExitCode runSystem(const RunCommand& command, const SystemOptionsReader& reader,
                   const Invocation& invocation) {
  engine::SystemOptions system = reader.read(invocation);
  const engine::Interrupts interrupts;  // before anything that starts threads
  if (command.view) {
    const host::Catalogue catalogue = engine::openCatalogue(system.plugin_paths);
    system.observers.push_back(engine::findPageObserver(catalogue));
  }
  engine::RunOptions options;
  options.out = command.out.path;
  options.replace = command.out.replace;
  options.resume = reader.resumed();
  return printOutcome(execute(engine::checkSystem(system), options, invocation, interrupts),
                      invocation);
}

void check(const SystemOptionsReader& reader, bool explain, const Invocation& invocation) {
  engine::SystemOptions system = reader.read(invocation);
  system.apart = true;
  const auto checked = engine::checkSystem(system);
  const std::string& continued = checked.config.general.earlier();
  if (!continued.empty()) {  // otherwise it would be refused only when the run begins
    (void)engine::require(record::RunReader::open(continued), engine::FailureKind::Continuation);
  }
  if (explain) {
    std::cout << config::explain(checked.config, checked.values);
  } else if (invocation.json) {
    std::cout << R"({"sound": true, "stages": )" << checked.config.stages.size() << "}\n";
  } else if (!invocation.quiet) {
    std::cout << "sound: " << checked.config.stages.size() << " stages\n";
  }
}

struct RerunCommand {
  std::string run;
  Output out;
  bool verify = false;
};

/// The digests of results.sha256; there must be some.
std::map<std::string, std::string> expectedDigests(const fs::path& run) {
  auto digests = record::resultsDigests(run);
  if (!digests.empty()) return digests;
  fail(ExitCode::Dataset, (run / "results.sha256").string() + ": has no digests");
}

ExitCode compare(const fs::path& before, const fs::path& after, const Invocation& invocation) {
  const auto expected = expectedDigests(before);
  const auto found = record::resultsDigests(after);
  std::set<std::string> names;
  for (const auto* digests : {&expected, &found}) {
    for (const auto& [file, digest] : *digests) names.insert(file);
  }
  Json files = Json::object();
  bool same = true;
  for (const std::string& file : names) {
    const bool in_both = expected.contains(file) && found.contains(file);
    const bool is_same = in_both && expected.at(file) == found.at(file);
    files[file] = is_same ? "same" : in_both ? "differs" : "is in one of the runs only";
    same = same && is_same;
  }
  std::vector<std::string> changed;
  if (!same) {
    changed = engine::changedInputs(record::RunDirectory::readRunFile(before),
                                    record::RunDirectory::readRunFile(after));
  }
  if (invocation.json) {
    std::cout << jsonText(Json{{"same", same}, {"files", files}, {"changed", changed}});
  } else if (!invocation.quiet) {
    for (const auto& [file, text] : files.items()) {
      std::cout << fmt::format("{:<20}{}\n", file, text.get<std::string>());
    }
    for (const std::string& file : changed) {
      std::cout << fmt::format("{} has other contents\n", file);
    }
  }
  if (same) return ExitCode::Ok;
  return printFailure(ExitCode::Record,
                      after.string() + ": its results are not those of " + before.string() +
                          "; compare the two run.json for other data, programs or machines");
}

ExitCode rerun(const RerunCommand& command, const Invocation& invocation) {
  const engine::Interrupts interrupts;
  fs::path before = fs::absolute(command.run).lexically_normal();
  if (!before.has_filename()) before = before.parent_path();
  if (fs::exists(before / "point.json") && fs::exists(before / "run"))
    before /= "run";  // of a sweep
  const fs::path out = command.out.path.empty() ? before.string() + "-again" : command.out.path;
  std::error_code ignored;
  if (fs::equivalent(before, out, ignored)) {
    fail(ExitCode::Usage, out.string() + ": is the run itself; give another folder with --out");
  }
  const std::string config = configOfRun(before, ExitCode::Configuration);
  if (command.verify) (void)expectedDigests(before);
  engine::SystemOptions system{config, {}, invocation.plugin_paths};
  system.quiet = invocation.quiet;
  engine::RunOptions options;
  options.out = out;
  options.replace = command.out.replace;
  const engine::Outcome outcome =
      execute(engine::checkSystem(system), options, invocation, interrupts);
  const bool is_whole = !outcome.interrupted && !outcome.failure;
  return command.verify && is_whole ? compare(before, out, invocation)
                                    : printOutcome(outcome, invocation);
}

}  // namespace

void addRunCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand("run", "Run a configuration and record everything");
  auto reader = std::make_shared<SystemOptionsReader>(command);
  auto options = std::make_shared<RunCommand>();
  CLI::Option* out = options->out.add(command, "FOLDER", "Run directory (default: runs/NAME-TIME)",
                                      "Replace the run that the --out directory holds");
  reader->addContinue();
  command.get_option("--resume")->excludes(out)->excludes(command.get_option("--force"));
  command.add_flag("--view", options->view, "Show the run in the browser");
  command.callback([options, reader, &invocation] {
    invocation.exit_code = runSystem(*options, *reader, invocation);
  });
}

void addCheckCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand("check", "Check a configuration without running it");
  auto reader = std::make_shared<SystemOptionsReader>(command);
  auto explain = std::make_shared<bool>(false);
  command.add_flag("--explain", *explain, "Print every value with its origin");
  command.callback([reader, explain, &invocation] { check(*reader, *explain, invocation); });
}

void addRerunCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand("rerun", "Run the configuration of a run again");
  auto options = std::make_shared<RerunCommand>();
  addArgument(command, "run", options->run, "RUN", "Run directory");
  options->out.add(command, "FOLDER", "Directory of the new run (default: RUN-again)",
                   "Replace the run that the --out directory holds");
  command.add_flag("--verify", options->verify, "Compare the results byte for byte");
  command.callback([options, &invocation] { invocation.exit_code = rerun(*options, invocation); });
}

}  // namespace tolman::app
