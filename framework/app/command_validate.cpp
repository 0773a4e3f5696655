// SPDX-License-Identifier: BSD-3-Clause
// tolman plugins validate: the conformance kit at the command line.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/exit_code.hpp"
#include "app/program.hpp"
#include "conformance/kit.hpp"
#include "conformance/report_text.hpp"
#include "conformance/run_check.hpp"
#include "plugins/manifest.hpp"

namespace tolman::app {
namespace {

using conformance::KitOptions;
using conformance::Report;
using conformance::Severity;

/// The plugins of the file that are asked for: all, or the one of --id.
plugins::OrRefusal<std::vector<plugins::Manifest>> wanted(const KitOptions& options) {
  auto read = plugins::readManifests(options.file);
  auto* manifests = std::get_if<std::vector<plugins::Manifest>>(&read);
  if (manifests == nullptr || options.id.empty()) return read;
  std::string known;
  for (const plugins::Manifest& manifest : *manifests) {
    if (manifest.id == options.id) return std::vector{manifest};
    known += (known.empty() ? "" : ", ") + manifest.id;
  }
  return plugins::Refusal{"plugin/not-found", options.file + " has no plugin '" + options.id + "'",
                          "it has: " + known};
}

/// A file without a readable manifest has a report as well.
Report refused(const KitOptions& options, const plugins::Refusal& refusal) {
  conformance::CheckResult manifest;
  manifest.check = "manifest";
  manifest.demand = "a manifest that can be read without opening the library";
  manifest.findings = {
      {Severity::Error, "[" + refusal.id + "] " + refusal.message, refusal.remedy}};
  return {options.file, options.id, "", options.level, options.seed, {manifest}};
}

int exitCode(const Report& report) {
  if (report.conforms()) return 0;
  const conformance::CheckResult& last = report.checks.back();
  const bool settings = last.check == "settings" && last.severity() == Severity::Error;
  return static_cast<int>(settings ? ExitCode::Configuration : ExitCode::Plugin);
}

void validate(KitOptions options, Invocation& invocation) {
  const auto tell = [&](const conformance::CheckResult& result) {
    const bool fault = result.severity() >= Severity::Warning;
    if (!invocation.json && (fault || !invocation.quiet)) {
      std::cout << conformance::text(result) << std::flush;
    }
  };
  std::vector<Report> reports;
  const auto found = wanted(options);
  if (const auto* refusal = std::get_if<plugins::Refusal>(&found)) {
    reports.push_back(refused(options, *refusal));
    tell(reports.back().checks.back());
  } else {
    for (const auto& manifest : std::get<std::vector<plugins::Manifest>>(found)) {
      options.id = manifest.id;
      reports.push_back(conformance::validate(options, manifest.role, tell));
      if (!invocation.json) std::cout << conformance::summary(reports.back()) << std::flush;
    }
  }
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Report& report : reports) {
    all.push_back(conformance::json(report));
    if (invocation.exit_code == 0) invocation.exit_code = exitCode(report);
  }
  if (invocation.json) std::cout << all.dump(2) << "\n";
}

std::vector<std::string> checkIds() {
  std::vector<std::string> ids;
  for (const conformance::Check& check : conformance::allChecks()) ids.emplace_back(check.id);
  return ids;
}

}  // namespace

void addValidateCommand(CLI::App& plugins, Invocation& invocation) {
  CLI::App* command = plugins.add_subcommand("validate", "Does a plugin keep the contract?");
  auto options = std::make_shared<KitOptions>();
  command->add_option("file", options->file, "Library, *.so")->required();
  command->add_option("--id", options->id, "One plugin of the library; else all");
  command->add_option("--level", options->level, "1 must, 2 results, 3 everything")
      ->check(CLI::Range(1, 3))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of pictures and drawn parameters")
      ->capture_default_str();
  command->add_option("--set", options->set, "A parameter, key=value (repeatable)")
      ->allow_extra_args(false);
  command->add_option("--check", options->only, "Only this check (repeatable)")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(checkIds()));
  command->add_option("--timeout", options->timeout, "Seconds for each check")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--memory", options->memory_mib, "MiB for each check; 0 for no limit")
      ->capture_default_str();
  command->callback([options, &invocation] {
    options->program = {std::filesystem::read_symlink("/proc/self/exe").string(), "plugins",
                        "run-check"};
    validate(*options, invocation);
  });

  CLI::App* inside = plugins.add_subcommand("run-check", "The inside of one check")->group("");
  auto task = std::make_shared<std::string>();
  inside->add_option("task", *task)->required();
  inside->callback([task] { conformance::runCheck(*task); });
}

}  // namespace tolman::app
