// SPDX-License-Identifier: BSD-3-Clause
// Time and memory: reported without a limit.
#include <algorithm>
#include <array>
#include <chrono>

#include "conformance/check.hpp"
#include "conformance/check_context.hpp"
#include "host/process_state.hpp"

namespace tolman::conformance {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

void checkCost(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  resetPeakResident();
  const double before_mib = residentMib();
  auto begin = std::chrono::steady_clock::now();
  const auto instance = context.configured(sequence.rig);
  context.measured("configure", millisecondsSince(begin), "ms");
  std::vector<double> frames_ms;
  for (const FrameInput& input : sequence.inputs) {
    begin = std::chrono::steady_clock::now();
    const Status status = instance->process(input);
    if (status.code() == StatusCode::EndOfStream) break;
    context.require(status);
    frames_ms.push_back(millisecondsSince(begin));
  }
  context.require(instance->finish(sequence));
  if (frames_ms.empty()) context.skip("there are no frames");
  std::sort(frames_ms.begin(), frames_ms.end());
  context.measured("frame, median", frames_ms[frames_ms.size() / 2], "ms");
  context.measured("frame, slowest", frames_ms.back(), "ms");
  context.measured("peak memory", std::max(0.0, peakResidentMib() - before_mib), "MiB");
}

constexpr std::array kCostChecks = {
    Check{"cost", 1, kAllRoles, "time and memory, for information", "", &checkCost},
};

}  // namespace

std::span<const Check> costChecks() { return kCostChecks; }

std::vector<Check> allChecks() {
  std::vector<Check> all;
  for (const auto& group : {declarationChecks(), lifeChecks(), inputChecks(), parameterChecks(),
                            repeatChecks(), stateChecks(), processChecks(), costChecks()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace tolman::conformance
