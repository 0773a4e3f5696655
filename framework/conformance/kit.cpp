// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/kit.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>

#include <boost/algorithm/string/replace.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "base/named_value.hpp"
#include "config/json_text.hpp"
#include "conformance/check.hpp"
#include "host/child_process.hpp"

namespace tolman::conformance {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckTask, check, folder, file, id, program_file, set, level,
                                   seed, timeout, memory_mib)

namespace {

using Json = nlohmann::ordered_json;

/// The file in the folder of a check with its messages, a line each.
constexpr const char* kMessages = "messages";

Json jsonOf(const Finding& finding) {
  return {{"severity", enumName(finding.severity)},
          {"message", finding.message},
          {"remedy", finding.remedy}};
}

Json jsonOf(const CheckResult& result);

template <class T>
Json listOf(const std::vector<T>& items) {
  Json list = Json::array();
  for (const T& item : items) list.push_back(jsonOf(item));
  return list;
}

Json jsonOf(const CheckResult& result) {
  return {{"check", result.check},     {"level", result.level},
          {"demand", result.demand},   {"result", enumName(result.severity())},
          {"seconds", result.seconds}, {"findings", listOf(result.findings)}};
}

std::string indented(const std::string& text) {
  return "         " + boost::replace_all_copy(text, "\n", "\n         ") + "\n";
}

/// "; last line of its output: ...", or nothing.
std::string lastLine(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last.empty() ? "" : "; last line of its output: " + last;
}

/// One check in its own process, which may crash, hang or exit.
class CheckProcess {
 public:
  CheckProcess(const Check& check, const KitOptions& options)
      : result_{std::string(check.id), check.level, std::string(check.demand)} {
    const host::ScratchFolder scratch("tolman-validate");
    if (scratch.path().empty()) throw std::runtime_error(host::kNoScratchFolder);
    const CheckTask task{options, result_.check, scratch.path()};
    std::vector<std::string> command = options.program;
    command.push_back(config::jsonText(nlohmann::json(task)));
    const FileDescriptor output(
        ::open((scratch.path() / kOutputFile).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    host::ChildProcess child(command, {}, output.number());
    const host::ProcessEnd end =
        child.end(std::chrono::milliseconds(static_cast<std::int64_t>(1e3 * options.timeout)));
    result_.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    timed_out_ = end.signal == SIGKILL && result_.seconds >= options.timeout;
    readMessages(scratch.path() / kMessages);
    addEnd(end, options.timeout, lastLine(scratch.path() / kOutputFile));
  }

  bool timedOut() const { return timed_out_; }
  CheckResult take() { return std::move(result_); }

 private:
  void readMessages(const std::filesystem::path& file) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
      const Json message = Json::parse(line, nullptr, false);
      if (message.contains("call")) call_ = message["call"];
      if (message.contains("input")) input_ = message["input"];
      if (message.contains("severity")) {
        const auto severity = valueNamed<Finding::Severity>(message["severity"].get<std::string>());
        result_.findings.push_back({*severity, {}, message["message"], message["remedy"]});
      }
      result_.skipped = result_.skipped || message.contains("skipped");
      completed_ = completed_ || message.contains("completed");
    }
  }

  void addEnd(const host::ProcessEnd& end, double timeout, const std::string& output) {
    const std::string when = completed_
                                 ? "when the process ended"
                                 : "in '" + call_ + "'" + (input_.empty() ? "" : " of ") + input_;
    const std::string how = end.text() + " " + when + output;
    if (timed_out_) {
      error(fmt::format("did not return within {:.0f} s, {}", timeout, when),
            "look for endless loops and for locks; --timeout gives more time");
    } else if (end.signal != 0) {
      error(how, "run it under a debugger: --check " + result_.check + " repeats this check alone");
    } else if (!completed_) {
      error(how, "never call exit(): return a Status");
    } else if (end.exit_code != 0) {
      error(how, "look at destructors of static objects");
    }
  }

  void error(const std::string& message, const std::string& remedy) {
    result_.findings.push_back({Finding::Severity::Error, {}, message, remedy});
  }

  CheckResult result_;
  std::string call_ = "start";
  std::string input_;
  bool completed_ = false;
  bool timed_out_ = false;
};

bool isWanted(const Check& check, const KitOptions& options, Role role) {
  if (!options.only.empty()) return std::ranges::count(options.only, check.id) > 0;
  return check.level <= options.level && (check.roles & bit(role)) != 0;
}

}  // namespace

std::string text(const CheckResult& result) {
  std::string lines =
      fmt::format("{:<9}{:<20}{}\n", enumName(result.severity()), result.check, result.demand);
  for (const Finding& finding : result.findings) {
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

Json json(const ConformanceReport& report) {
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
          {"checks", listOf(report.checks)}};
}

ConformanceReport validate(const KitOptions& options, Role role, const OnCheckResult& on_result) {
  constexpr int kMaxTimeouts = 3;
  ConformanceReport report{options.file,  options.id,   std::string(enumName(role)),
                           options.level, options.seed, {}};
  int timeouts = 0;
  for (const Check& check : allChecks()) {
    if (!isWanted(check, options, role)) continue;
    CheckProcess process(check, options);
    report.checks.push_back(process.take());
    const CheckResult& result = report.checks.back();
    on_result(result);
    timeouts += process.timedOut() ? 1 : 0;
    const bool basic = check.id == "manifest" || check.id == "load" || check.id == "settings";
    if ((basic && result.severity() == CheckSeverity::Error) || timeouts == kMaxTimeouts) break;
  }
  return report;
}

void runCheck(const std::string& text) {
  const CheckTask task = nlohmann::json::parse(text);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // end with the kit
  host::limitResources(task.memory_mib);
  const std::vector<Check> checks = allChecks();
  const auto check = std::ranges::find(checks, task.check, &Check::id);
  if (check == checks.end()) throw std::runtime_error("no check '" + task.check + "'");
  std::filesystem::create_directory(task.folder / kPluginFolder);
  std::ofstream messages(task.folder / kMessages);
  const auto send = [&](const Json& message) {
    messages << config::jsonText(message) + "\n" << std::flush;  // the plugin may crash afterwards
  };
  CheckContext context(task, check->remedy, send);
  try {
    if (check->same_images && context.manifest().hasExtra("live")) {
      context.skip("live images do not come twice");
    }
    check->run(context);
  } catch (const Finding& last) {
    context.add(last);
  } catch (const host::Refusal& refusal) {
    context.error("[" + refusal.id + "] " + refusal.message, refusal.remedy);
  } catch (const std::exception& error) {
    context.error(std::string("the check failed with an exception: ") + error.what());
  }
  send({{"completed", true}});
}

std::vector<Check> allChecks() {
  std::vector<Check> all;
  for (const auto& group : {declarationChecks(), lifeChecks(), inputChecks()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

std::vector<std::string> checkIds() {
  std::vector<std::string> ids;
  for (const Check& check : allChecks()) ids.emplace_back(check.id);
  return ids;
}

}  // namespace tolman::conformance
