// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/run_check.hpp"

#include <unistd.h>

#include <algorithm>

#include "conformance/check.hpp"
#include "conformance/protocol.hpp"

namespace tolman::conformance {
namespace {

/// Unbuffered: what was said before a crash has been said.
void send(int descriptor, const Message& message) {
  const std::string line = encode(message) + "\n";
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t bytes = ::write(descriptor, line.data() + sent, line.size() - sent);
    if (bytes <= 0) return;  // nobody listens any more
    sent += static_cast<std::size_t>(bytes);
  }
}

void make(const Check& check, Lab& lab) {
  try {
    check.run(lab);
  } catch (const Stop&) {  // it has said why
  } catch (const std::exception& error) {
    lab.error(std::string("the check could not be made: ") + error.what());
  }
}

}  // namespace

void runCheck(const std::string& text) {
  const Task task = decodeTask(text);
  const int report = task.report_descriptor;
  const std::vector<Check> checks = allChecks();
  const auto check = std::find_if(checks.begin(), checks.end(),
                                  [&](const Check& c) { return c.id == task.check; });
  if (check == checks.end()) throw std::runtime_error("no check '" + task.check + "'");
  Lab lab(
      task.lab, [report](const std::string& step) { send(report, Step{step}); },
      [report](const std::string& topic) { send(report, Topic{topic}); },
      [report, check](Finding finding) {
        const bool fault = finding.severity >= Severity::Warning;
        if (fault && finding.remedy.empty()) finding.remedy = check->remedy;
        send(report, finding);
      },
      [report](const Figure& figure) { send(report, figure); });
  make(*check, lab);
  send(report, Done{});
}

}  // namespace tolman::conformance
