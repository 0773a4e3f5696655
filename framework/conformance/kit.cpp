// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/kit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <chrono>
#include <system_error>

#include "conformance/child.hpp"
#include "host/plugin_process.hpp"
#include "host/scratch_folder.hpp"

namespace tolman::conformance {

namespace {

std::string indented(const std::string& text) {
  return "         " + boost::replace_all_copy(text, "\n", "\n         ") + "\n";
}

}  // namespace

std::string text(const CheckResult& result) {
  std::string lines =
      fmt::format("{:<9}{:<20}{}", enumName(result.severity()), result.check, result.demand);
  for (const Measurement& measured : result.measurements) {
    lines += fmt::format("\n{:29}{}: {:.4g} {}", "", measured.name, measured.value, measured.unit);
  }
  lines += "\n";
  for (const CheckFinding& finding : result.findings) {
    lines += indented(finding.message);
    if (!finding.remedy.empty()) lines += indented("remedy: " + finding.remedy);
  }
  return lines;
}

std::string summary(const ConformanceReport& report) {
  const bool whole = report.checks.size() > 1;  // --check selected a single one
  const std::string verdict = !report.conforms() ? "does not conform at level"
                              : whole            ? "conforms at level"
                                                 : "one check run, of level";
  return fmt::format("{}: {} {}: {} ok, {} warnings, {} errors, {} skipped; seed {}\n", report.id,
                     verdict, report.level, report.count(CheckSeverity::Ok),
                     report.count(CheckSeverity::Warning), report.count(CheckSeverity::Error),
                     report.count(CheckSeverity::Skip), report.seed);
}

nlohmann::ordered_json json(const ConformanceReport& report) {
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const CheckResult& result : report.checks) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const CheckFinding& finding : result.findings) {
      findings.push_back({{"severity", enumName(finding.severity)},
                          {"message", finding.message},
                          {"remedy", finding.remedy}});
    }
    nlohmann::ordered_json measurements = nlohmann::ordered_json::array();
    for (const Measurement& measured : result.measurements) {
      measurements.push_back(
          {{"name", measured.name}, {"value", measured.value}, {"unit", measured.unit}});
    }
    checks.push_back({{"check", result.check},
                      {"level", result.level},
                      {"demand", result.demand},
                      {"result", enumName(result.severity())},
                      {"seconds", result.seconds},
                      {"findings", findings},
                      {"measurements", measurements}});
  }
  return {{"id", report.id},
          {"role", report.role},
          {"file", report.file},
          {"level", report.level},
          {"seed", report.seed},
          {"conforms", report.conforms()},
          {"ok", report.count(CheckSeverity::Ok)},
          {"warnings", report.count(CheckSeverity::Warning)},
          {"errors", report.count(CheckSeverity::Error)},
          {"skipped", report.count(CheckSeverity::Skip)},
          {"checks", checks}};
}

namespace {

std::string lastLine(const std::string& output) {
  std::string text = output;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::string line = text.substr(text.rfind('\n') + 1);
  return line.empty() ? "" : "; last line of its output: " + line;
}

/// No finding about the plugin.
std::system_error noThreads() {
  return {std::make_error_code(std::errc::resource_unavailable_try_again), "a check"};
}

/// Runs one check in its own process.
class CheckProcess {
 public:
  CheckProcess(const Check& check, const KitOptions& options) : options_(options) {
    result_.check = check.id;
    result_.level = check.level;
    result_.demand = check.demand;
  }

  CheckResult run() {
    const host::ScratchFolder scratch("tolman-validate");
    if (scratch.path().empty()) throw std::runtime_error(host::kNoScratchFolder);
    const auto begin = std::chrono::steady_clock::now();
    const auto command = [&](int descriptor) {
      std::vector<std::string> words = options_.program;
      words.push_back(
          encode(CheckTask{result_.check, descriptor, options_.file, options_.id, options_.set,
                           options_.seed, options_.level, scratch.path(), options_.timeout,
                           options_.memory_mib, options_.program_file}));
      return words;
    };
    reportEnd(runChild(command, options_.timeout,
                       [this](const std::string& line) { readMessage(line); }));
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
  }
  bool timedOut() const { return timed_out_; }

 private:
  void readMessage(const std::string& line) {
    std::optional<CheckMessage> message = decodeMessage(line);
    if (!message) return;
    if (auto* started = std::get_if<CallStarted>(&*message)) call_ = std::move(started->call);
    if (auto* input = std::get_if<CurrentInput>(&*message)) input_ = std::move(input->description);
    if (auto* finding = std::get_if<CheckFinding>(&*message)) result_.findings.push_back(*finding);
    if (auto* measured = std::get_if<Measurement>(&*message)) {
      result_.measurements.push_back(*measured);
    }
    completed_ = completed_ || std::holds_alternative<CheckCompleted>(*message);
  }

  std::string lastCall() const {
    if (completed_) return "when the process ended";
    return "in '" + call_ + "'" + (input_.empty() ? "" : " of " + input_);
  }

  void reportEnd(const ChildEnd& end) {
    if (end.process.exit_code == host::kNoThreadsExit) throw noThreads();
    timed_out_ = end.timed_out;
    const std::string how = end.process.text() + " " + lastCall() + lastLine(end.output);
    if (end.timed_out) {
      error("did not return within " + std::to_string(static_cast<int>(options_.timeout)) + " s, " +
                lastCall(),
            "look for endless loops and for locks; --timeout gives more time");
    } else if (end.process.signal != 0) {
      error(how, "run it under a debugger: --check " + result_.check + " repeats this check alone");
    } else if (!completed_) {
      error(how, "never call exit(): return a Status");
    } else if (end.process.exit_code != 0) {
      error(how, "look at destructors of static objects");
    }
  }

  void error(const std::string& message, const std::string& remedy) {
    result_.findings.push_back({CheckSeverity::Error, message, remedy});
  }

  const KitOptions& options_;
  CheckResult result_;
  std::string call_ = "start";
  std::string input_;
  bool completed_ = false;
  bool timed_out_ = false;
};

bool isWanted(const Check& check, const KitOptions& options, Role role) {
  if (!options.only.empty()) {
    return std::find(options.only.begin(), options.only.end(), check.id) != options.only.end();
  }
  return check.level <= options.level && (check.roles & bit(role)) != 0;
}

}  // namespace

ConformanceReport validate(const KitOptions& options, Role role, const OnCheckResult& on_result) {
  constexpr int kMaxTimeouts = 3;
  ConformanceReport report{options.file,  options.id,   std::string(enumName(role)),
                           options.level, options.seed, {}};
  int timeouts = 0;
  for (const Check& check : allChecks()) {
    if (!isWanted(check, options, role)) continue;
    CheckProcess process(check, options);
    report.checks.push_back(process.run());
    const CheckResult& result = report.checks.back();
    on_result(result);
    timeouts += process.timedOut() ? 1 : 0;
    const bool basic = check.id == "manifest" || check.id == "load" || check.id == "settings";
    if ((basic && result.severity() == CheckSeverity::Error) || timeouts == kMaxTimeouts) break;
  }
  return report;
}

}  // namespace tolman::conformance
