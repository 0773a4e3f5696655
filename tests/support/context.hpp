// SPDX-License-Identifier: BSD-3-Clause
// A context for plugins under test: logs into memory, keeps artefacts, never cancels.
#pragma once

#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "tolman/context.hpp"

namespace tolman::test {

class TestContext : Logger, FindingCollector, ArtefactWriter, Cancellation, Clock {
 public:
  /// `parameters` as the host would give them: checked; absent ones keep the declared default.
  explicit TestContext(ParameterValues values = {}, std::uint64_t seed = 1)
      : parameters_(std::move(values)), seed_(seed) {}

  operator Context() {  // NOLINT: a test context is a context
    return {parameters_, *this, *this, *this, *this, *this, rig, seed_, "test"};
  }

  std::vector<std::string> log;
  std::vector<Finding> findings;
  std::map<std::string, std::string> artefacts;
  CameraRig rig;
  std::int64_t now_ns = 0;
  std::atomic<bool> cancelled = false;  // as in a run: other threads ask for it

 private:
  void write(LogLevel, std::string_view message) override { log.emplace_back(message); }
  Status write(std::string_view name, std::span<const std::byte> bytes) override {
    artefacts[std::string(name)] =
        std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return Status::ok();
  }
  void add(Finding finding) override { findings.push_back(std::move(finding)); }
  bool requested() const override { return cancelled; }
  std::int64_t steadyNs() const override { return now_ns; }

  ParameterValues parameters_;
  std::uint64_t seed_;
};

}  // namespace tolman::test
