// SPDX-License-Identifier: BSD-3-Clause
// Speed and memory: reported, never judged.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "conformance/check.hpp"
#include "conformance/lab.hpp"
#include "conformance/process_state.hpp"

namespace tolman::conformance {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

void checkCost(Lab& lab) {
  const Stimulus stimulus = lab.stimulus();
  resetPeakResident();
  const double before_mib = residentMib();
  auto begin = std::chrono::steady_clock::now();
  const auto actor = lab.living(stimulus.rig);
  lab.figure("configure", millisecondsSince(begin), "ms");
  std::vector<double> frames_ms;
  for (const Moment& moment : stimulus.moments) {
    begin = std::chrono::steady_clock::now();
    const Status status = actor->work(moment);
    if (status.code() == StatusCode::EndOfStream) break;
    lab.demand(status);
    frames_ms.push_back(millisecondsSince(begin));
  }
  lab.demand(actor->finish(stimulus));
  if (frames_ms.empty()) lab.skip("there are no frames");
  std::sort(frames_ms.begin(), frames_ms.end());
  lab.figure("frame, median", frames_ms[frames_ms.size() / 2], "ms");
  lab.figure("frame, slowest", frames_ms.back(), "ms");
  lab.figure("peak memory", std::max(0.0, peakResidentMib() - before_mib), "MiB");
}

constexpr std::array kChecks = {
    Check{"cost", 1, kAllRoles, "time and memory, for information", "", &checkCost},
};

}  // namespace

std::span<const Check> costChecks() { return kChecks; }

std::vector<Check> allChecks() {
  std::vector<Check> all;
  for (const auto& group : {declarationChecks(), lifeChecks(), inputChecks(), parameterChecks(),
                            repeatChecks(), stateChecks(), processChecks(), costChecks()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace tolman::conformance
