// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/run_check.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>

#include "conformance/check.hpp"
#include "conformance/check_context.hpp"
#include "host/child_process.hpp"

namespace tolman::conformance {
namespace {

/// Unbuffered, so that no message is lost when the plugin crashes afterwards.
void send(int descriptor, const CheckMessage& message) {
  const std::string line = encode(message) + "\n";
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t bytes = ::write(descriptor, line.data() + sent, line.size() - sent);
    if (bytes <= 0) return;  // the kit has closed its end
    sent += static_cast<std::size_t>(bytes);
  }
}

}  // namespace

void runCheck(const std::string& text) {
  const CheckTask task = decodeTask(text);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // end with the kit
  isolation::limitResources(task.memory_mib);
  const std::vector<Check> checks = allChecks();
  const auto check = std::find_if(checks.begin(), checks.end(),
                                  [&](const Check& c) { return c.id == task.check; });
  if (check == checks.end()) throw std::runtime_error("no check '" + task.check + "'");
  const auto report = [descriptor = task.report_descriptor](const CheckMessage& message) {
    send(descriptor, message);
  };
  CheckContext context(task, check->remedy, report);
  try {
    if (check->same_images && context.manifest().hasExtra("live")) {
      context.skip("live images do not come twice");
    }
    check->run(context);
  } catch (const CheckEnded&) {  // the reason was sent
  } catch (const std::exception& error) {
    context.error(std::string("the check failed with an exception: ") + error.what());
  }
  report(CheckCompleted{});
}

}  // namespace tolman::conformance
