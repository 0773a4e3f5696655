// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "conformance/child.hpp"

using namespace tolman::conformance;

TEST_CASE("a task is decoded to what was encoded") {
  const CheckTask sent{"reset",    5, "a b/c.so", "mine", {"x=[1, 2]", "y=\"q\""},
                       UINT64_MAX, 2, "/tmp/s",   1.5,    64};
  const CheckTask task = decodeTask(encode(sent));
  CHECK(task.check == "reset");
  CHECK(task.report_descriptor == 5);
  CHECK(task.file == "a b/c.so");
  CHECK(task.id == "mine");
  CHECK(task.set == sent.set);
  CHECK(task.seed == UINT64_MAX);
  CHECK(task.level == 2);
  CHECK(task.scratch == "/tmp/s");
  CHECK(task.timeout_s == 1.5);
  CHECK(task.memory_mib == 64);
  CHECK_THROWS(decodeTask("reset"));
}

TEST_CASE("a message is one line, whatever its text") {
  const std::string line =
      encode(CheckFinding{CheckSeverity::Error, "two\nlines \xff", "do \"this\""});
  CHECK(line.find('\n') == std::string::npos);
  const auto message = decodeMessage(line);
  REQUIRE(message);
  const auto& finding = std::get<CheckFinding>(*message);
  CHECK(finding.severity == CheckSeverity::Error);
  CHECK(finding.message.starts_with("two\nlines "));
  CHECK(finding.remedy == "do \"this\"");
}

TEST_CASE("every kind of message is decoded to what was encoded") {
  const auto sent = [](const CheckMessage& message) { return *decodeMessage(encode(message)); };
  CHECK(std::get<CallStarted>(sent(CallStarted{"frame 3"})).call == "frame 3");
  CHECK(std::get<CurrentInput>(sent(CurrentInput{"draw 7"})).description == "draw 7");
  const auto measured = std::get<Measurement>(sent(Measurement{"peak", 1.25, "MiB"}));
  CHECK(measured.name == "peak");
  CHECK(measured.value == 1.25);
  CHECK(measured.unit == "MiB");
  CHECK(std::holds_alternative<CheckCompleted>(sent(CheckCompleted{})));
}

TEST_CASE("text that a plugin writes to the report is not a message") {
  for (const char* noise :
       {"", "hello", "{}", "[1]", "[0, 7]", "[2, {\"severity\":\"x\"}]", "[9, null]",
        "[1e300, null]", "[-1, null]", "[2, {\"severity\":4,\"message\":\"\",\"remedy\":\"\"}]"}) {
    CHECK_FALSE(decodeMessage(noise));
  }
}
