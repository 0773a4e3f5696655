// SPDX-License-Identifier: BSD-3-Clause
// tolman plugins validate: the conformance kit at the command line.
#include <filesystem>
#include <iostream>

#include "app/options.hpp"
#include "conformance/child.hpp"
#include "conformance/kit.hpp"
#include "engine/checked_system.hpp"
#include "host/manifest.hpp"
#include "host/remote_plugin.hpp"
#include "host/scratch_folder.hpp"

namespace tolman::app {
namespace {

using conformance::CheckSeverity;
using conformance::ConformanceReport;
using conformance::KitOptions;

/// The program of the file, opened in a process of its own: only then is its role known.
host::OrRefusal<std::vector<host::Manifest>> programIn(const KitOptions& options,
                                                       const Invocation& invocation) {
  const auto found = engine::openCatalogue(invocation.plugin_paths).program(options.file);
  if (const auto* refusal = std::get_if<host::Refusal>(&found)) return *refusal;
  host::LaunchOptions launch{engine::SystemOptions{}.stage_program};
  launch.deadline_s = options.timeout;
  auto opened = host::RemotePlugin::start(std::get<host::Manifest>(found), launch);
  if (const auto* refusal = std::get_if<host::Refusal>(&opened)) return *refusal;
  return std::vector{std::get<std::shared_ptr<host::RemotePlugin>>(opened)->manifest()};
}

/// The plugins of the file that are asked for: all, or the one of --id.
host::OrRefusal<std::vector<host::Manifest>> wanted(const KitOptions& options,
                                                    const Invocation& invocation) {
  const std::string suffix = std::filesystem::path(options.file).extension();
  if (!suffix.empty() && suffix != ".so") return programIn(options, invocation);
  auto read = host::readManifests(options.file);
  auto* manifests = std::get_if<std::vector<host::Manifest>>(&read);
  if (manifests == nullptr || options.id.empty()) return read;
  std::string known;
  for (const host::Manifest& manifest : *manifests) {
    if (manifest.id == options.id) return std::vector{manifest};
    known += (known.empty() ? "" : ", ") + manifest.id;
  }
  return host::Refusal{"plugin/not-found", options.file + " has no plugin '" + options.id + "'",
                       "it has: " + known};
}

/// The report of a file without a readable manifest.
ConformanceReport refused(const KitOptions& options, const host::Refusal& refusal) {
  conformance::CheckResult manifest;
  manifest.check = "manifest";
  manifest.demand = "a manifest that can be read without opening the library";
  manifest.findings = {
      {CheckSeverity::Error, "[" + refusal.id + "] " + refusal.message, refusal.remedy}};
  return {options.file, options.id, "", options.level, options.seed, {manifest}};
}

ExitCode codeOf(const ConformanceReport& report) {
  if (report.conforms()) return ExitCode::Ok;
  const conformance::CheckResult& last = report.checks.back();
  const bool settings = last.check == "settings" && last.severity() == CheckSeverity::Error;
  return settings ? ExitCode::Configuration : ExitCode::Plugin;
}

void validate(KitOptions options, Invocation& invocation) {
  if (host::ScratchFolder("tolman-validate").path().empty()) {
    throw engine::Failed({engine::FailureKind::Record, host::kNoScratchFolder});
  }
  const auto print = [&](const conformance::CheckResult& result) {
    const bool fault = result.severity() >= CheckSeverity::Warning;
    if (!invocation.json && (fault || !invocation.quiet)) {
      std::cout << conformance::text(result) << std::flush;
    }
  };
  std::vector<ConformanceReport> reports;
  const auto found = wanted(options, invocation);
  if (const auto* refusal = std::get_if<host::Refusal>(&found)) {
    if (refusal->id == host::kNoProcess) engine::require(found);
    reports.push_back(refused(options, *refusal));
    print(reports.back().checks.back());
  } else {
    for (const auto& manifest : std::get<std::vector<host::Manifest>>(found)) {
      options.file = manifest.file;
      options.id = manifest.id;
      options.program_file = manifest.program;
      reports.push_back(conformance::validate(options, manifest.role, print));
      if (!invocation.json) std::cout << conformance::summary(reports.back()) << std::flush;
    }
  }
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ConformanceReport& report : reports) {
    all.push_back(conformance::json(report));
    if (invocation.exit_code == ExitCode::Ok) invocation.exit_code = codeOf(report);
  }
  if (invocation.json) std::cout << jsonText(all);
}

std::vector<std::string> checkIds() {
  std::vector<std::string> ids;
  for (const conformance::Check& check : conformance::allChecks()) ids.emplace_back(check.id);
  return ids;
}

}  // namespace

void addValidateCommand(CLI::App& plugins, Invocation& invocation) {
  CLI::App& command =
      *plugins.add_subcommand("validate", "Check whether a plugin keeps the contract");
  auto options = std::make_shared<KitOptions>();
  addArgument(command, "file", options->file, "FILE", "Library, *.so, or a program such as *.py");
  addOption(command, "--id", options->id, "ID", "One plugin of the library; else all");
  addOption(command, "--level", options->level, "1|2|3",
            "1 contract, 2 reproducible results, 3 all checks")
      ->check(CLI::Range(1, 3))
      ->capture_default_str();
  addOption(command, "--seed", options->seed, "N", "Seed of the images and random parameters")
      ->capture_default_str();
  addList(command, "--set", options->set, "NAME=VALUE", "A parameter, key=value (repeatable)");
  addList(command, "--check", options->only, "NAME", "Only this check (repeatable)")
      ->check(CLI::IsMember(checkIds()));
  addOption(command, "--timeout", options->timeout, "S", "Seconds for each check")
      ->check(positive)
      ->capture_default_str();
  addOption(command, "--memory", options->memory_mib, "MIB", "MiB for each check; 0 for no limit")
      ->capture_default_str();
  command.callback([options, &invocation] {
    options->program = {std::filesystem::read_symlink("/proc/self/exe").string(), "plugins",
                        "run-check"};
    validate(*options, invocation);
  });

  CLI::App& inside = *plugins.add_subcommand("run-check", "Run one check (internal)")->group("");
  auto task = std::make_shared<std::string>();
  addArgument(inside, "task", *task, "TASK", "");
  inside.callback([task] { conformance::runCheck(*task); });
}

}  // namespace tolman::app
