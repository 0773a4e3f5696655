// SPDX-License-Identifier: BSD-3-Clause
// Findings of stages: printed once per kind, judged by `on_findings`, recorded one by one.
#include <catch2/catch.hpp>

#include "engine/services.hpp"

using namespace tolman;
using namespace tolman::engine;
using config::FindingPolicy;
using Severity = Finding::Severity;

namespace {

void addDamaged(Findings& findings, int count, int first = 0) {
  for (int i = first; i < first + count; ++i) {
    findings.add("source", {Severity::Error, std::to_string(i) + ".png",
                            "ends at byte " + std::to_string(10 * i), "copy it again",
                            Finding::Kind::Damaged});
  }
}

}  // namespace

TEST_CASE("an error stops the run by its text, the number of others and the key") {
  Findings findings(FindingPolicy::Stop);
  findings.add("source", {Severity::Warning, "times.txt", "has gaps"});
  CHECK(findings.judge(Status::ok(), -1).isOk());
  addDamaged(findings, 3);
  const Status status = findings.judge(Status::ok(), 7);
  CHECK(status.code() == StatusCode::InvalidInput);
  CHECK(status.message() ==
        "0.png: ends at byte 0; copy it again (and 2 more; `tolman dataset check` lists all); to "
        "go on without what is wrong, set on_findings: continue");
  const auto kinds = findings.takeNewKinds();  // the failure has reported the errors
  REQUIRE(kinds.size() == 1);
  CHECK(kinds[0].text() == "times.txt: has gaps");
  const auto all = findings.take();
  REQUIRE(all.size() == 4);
  CHECK(all[0].frame == -1);  // configure() found it
  CHECK(all[3].frame == 7);
  CHECK(all[3].stage == "source");
  CHECK(findings.take().empty());
}

TEST_CASE("a failed call keeps its own message, and its errors are not printed again") {
  const auto policy = GENERATE(FindingPolicy::Stop, FindingPolicy::Continue);
  Findings findings(policy);
  addDamaged(findings, 2);
  CHECK(findings.judge(Status::invalidInput("no image"), -1).message() == "no image");
  CHECK(findings.takeNewKinds().empty());
}

TEST_CASE("with continue each kind is a warning, and what comes later is counted at the end") {
  Findings findings(FindingPolicy::Continue);
  addDamaged(findings, 3);
  CHECK(findings.judge(Status::ok(), 1).isOk());
  const auto kinds = findings.takeNewKinds();
  REQUIRE(kinds.size() == 1);
  CHECK(kinds[0].level() == LogLevel::Warning);
  CHECK(kinds[0].text() == "0.png: ends at byte 0; copy it again (and 2 more)");
  CHECK(findings.takeNewKinds().empty());
  addDamaged(findings, 4, 3);
  findings.add("source", {Severity::Note, "", "12 frames"});
  CHECK(findings.takeNewKinds().at(0).level() == LogLevel::Info);
  const auto grown = findings.takeGrownKinds();
  REQUIRE(grown.size() == 1);
  CHECK(grown[0].text() == "4 more as this one: 0.png: ends at byte 0; copy it again");
  CHECK(findings.takeGrownKinds().empty());
}

TEST_CASE("kinds differ by stage, severity, kind and text, not by numbers and places") {
  Findings findings;
  findings.add("source", {Severity::Warning, "a", "has 3 gaps"});
  findings.add("source", {Severity::Warning, "b", "has 17 gaps"});
  findings.add("odometry", {Severity::Warning, "a", "has 3 gaps"});
  findings.add("source", {Severity::Note, "a", "has 3 gaps"});
  findings.add("source", {Severity::Warning, "a", "has 3 gaps", "", Finding::Kind::Damaged});
  findings.add("source", {Severity::Warning, "a", "has gaps"});
  CHECK(findings.takeNewKinds().size() == 5);
}
