// SPDX-License-Identifier: BSD-3-Clause
// Catch2's main. A case whose data, or what is optional, are absent ends the program with 77, which
// CTest shows as skipped; such a case must have the tag [data] or [optional], so that it is a CTest
// test of its own.
#define CATCH_CONFIG_RUNNER
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <string>

#include "support/data.hpp"

namespace {

constexpr int kSkipped = 77;

class SkipReporter : public Catch::TestEventListenerBase {
 public:
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    TestEventListenerBase::testCaseStarting(info);
    tagged_ = std::ranges::any_of(
        info.lcaseTags, [](const std::string& tag) { return tag == "data" || tag == "optional"; });
    skips_before_ = tolman::test::skips().size();
  }
  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    TestEventListenerBase::testCaseEnded(stats);
    if (tolman::test::skips().size() == skips_before_ || tagged_) return;
    std::cerr << "without the tag [data] or [optional], though it was skipped: "
              << stats.testInfo.name << "\n";
    untagged = true;
  }

  static inline bool untagged = false;

 private:
  bool tagged_ = false;
  std::size_t skips_before_ = 0;
};
CATCH_REGISTER_LISTENER(SkipReporter)

}  // namespace

int main(int argc, char** argv) {
  const int failed = Catch::Session().run(argc, argv);
  if (failed != 0) return std::min(failed, 1);
  if (SkipReporter::untagged) return 1;
  return tolman::test::skips().empty() ? 0 : kSkipped;
}
