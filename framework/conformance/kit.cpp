// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/kit.hpp"

#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "conformance/child.hpp"
#include "conformance/protocol.hpp"
#include "isolation/child_process.hpp"
#include "plugins/scratch_folder.hpp"

namespace tolman::conformance {
namespace {

std::string lastLine(const std::string& output) {
  std::string text = output;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::string line = text.substr(text.rfind('\n') + 1);
  return line.empty() ? "" : "; its last words: " + line;
}

/// One check in its process.
class Experiment {
 public:
  Experiment(const Check& check, const KitOptions& options) : options_(options) {
    result_.check = check.id;
    result_.level = check.level;
    result_.demand = check.demand;
  }

  CheckResult run() {
    const plugins::ScratchFolder scratch("tolman-validate");
    if (scratch.path().empty()) throw std::runtime_error("no temporary folder");
    const auto begin = std::chrono::steady_clock::now();
    const auto command = [&](int descriptor) {
      std::vector<std::string> words = options_.program;
      words.push_back(encode(Task{result_.check,
                                  descriptor,
                                  {options_.file, options_.id, options_.set, options_.seed,
                                   options_.level, scratch.path(), options_.timeout}}));
      return words;
    };
    judge(runChild(command, {options_.timeout, options_.memory_mib},
                   [this](const std::string& line) { hear(line); }));
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
  }
  bool timedOut() const { return timed_out_; }

 private:
  void hear(const std::string& line) {
    std::optional<Message> message = decodeMessage(line);
    if (!message) return;
    if (auto* step = std::get_if<Step>(&*message)) step_ = std::move(step->what);
    if (auto* topic = std::get_if<Topic>(&*message)) topic_ = std::move(topic->what);
    if (auto* finding = std::get_if<Finding>(&*message)) result_.findings.push_back(*finding);
    if (auto* figure = std::get_if<Figure>(&*message)) result_.figures.push_back(*figure);
    done_ = done_ || std::holds_alternative<Done>(*message);
  }

  std::string place() const {
    if (done_) return "when the process ended";
    return "in '" + step_ + "'" + (topic_.empty() ? "" : " of " + topic_);
  }

  void judge(const ChildEnd& end) {
    const std::string where = place();
    timed_out_ = end.timed_out;
    if (end.timed_out) {
      error("did not return within " + std::to_string(static_cast<int>(options_.timeout)) + " s, " +
                where,
            "look for endless loops and for locks; --timeout gives more time");
    } else if (end.signal != 0) {
      error("died of " + isolation::signalName(end.signal) + " " + where + lastLine(end.output),
            "run it under a debugger: --check " + result_.check + " repeats this check alone");
    } else if (!done_) {
      error("ended the process itself (exit code " + std::to_string(end.exit_code) + ") " + where +
                lastLine(end.output),
            "never call exit(): return a Status");
    } else if (end.exit_code != 0) {
      error("the process ended with exit code " + std::to_string(end.exit_code) +
                lastLine(end.output),
            "look at destructors of static objects");
    }
  }

  void error(const std::string& message, const std::string& remedy) {
    result_.findings.push_back({Severity::Error, message, remedy});
  }

  const KitOptions& options_;
  CheckResult result_;
  std::string step_ = "start";
  std::string topic_;
  bool done_ = false;
  bool timed_out_ = false;
};

bool isWanted(const Check& check, const KitOptions& options, Role role) {
  if (!options.only.empty()) {
    return std::find(options.only.begin(), options.only.end(), check.id) != options.only.end();
  }
  return check.level <= options.level && (check.roles & bit(role)) != 0;
}

}  // namespace

Report validate(const KitOptions& options, Role role, const Progress& progress) {
  constexpr int kMostHangs = 3;
  Report report{options.file,  options.id,   std::string(enumName(role)),
                options.level, options.seed, {}};
  int hangs = 0;
  for (const Check& check : allChecks()) {
    if (!isWanted(check, options, role)) continue;
    Experiment experiment(check, options);
    report.checks.push_back(experiment.run());
    const CheckResult& result = report.checks.back();
    progress(result);
    hangs += experiment.timedOut() ? 1 : 0;
    const bool basic = check.id == "manifest" || check.id == "load" || check.id == "settings";
    if ((basic && result.severity() == Severity::Error) || hangs == kMostHangs) break;
  }
  return report;
}

}  // namespace tolman::conformance
