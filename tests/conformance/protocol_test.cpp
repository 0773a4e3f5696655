// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/protocol.hpp"

#include <catch2/catch.hpp>

using namespace tolman::conformance;

TEST_CASE("a task arrives as it was sent") {
  const Task sent{
      "reset", 5, {"a b/c.so", "mine", {"x=[1, 2]", "y=\"q\""}, UINT64_MAX, 2, "/tmp/s", 1.5}};
  const Task task = decodeTask(encode(sent));
  CHECK(task.check == "reset");
  CHECK(task.report_descriptor == 5);
  CHECK(task.lab.file == "a b/c.so");
  CHECK(task.lab.id == "mine");
  CHECK(task.lab.set == sent.lab.set);
  CHECK(task.lab.seed == UINT64_MAX);
  CHECK(task.lab.level == 2);
  CHECK(task.lab.scratch == "/tmp/s");
  CHECK(task.lab.patience == 1.5);
  CHECK_THROWS(decodeTask("reset"));
}

TEST_CASE("a message is one line, whatever it says") {
  const std::string line = encode(Finding{Severity::Error, "two\nlines \xff", "do \"this\""});
  CHECK(line.find('\n') == std::string::npos);
  const auto message = decodeMessage(line);
  REQUIRE(message);
  const auto& finding = std::get<Finding>(*message);
  CHECK(finding.severity == Severity::Error);
  CHECK(finding.message.starts_with("two\nlines "));
  CHECK(finding.remedy == "do \"this\"");
}

TEST_CASE("every kind of message arrives") {
  CHECK(std::get<Step>(*decodeMessage(encode(Step{"frame 3"}))).what == "frame 3");
  CHECK(std::get<Topic>(*decodeMessage(encode(Topic{"draw 7"}))).what == "draw 7");
  const auto figure = std::get<Figure>(*decodeMessage(encode(Figure{"peak", 1.25, "MiB"})));
  CHECK(figure.name == "peak");
  CHECK(figure.value == 1.25);
  CHECK(figure.unit == "MiB");
  CHECK(std::holds_alternative<Done>(*decodeMessage(encode(Done{}))));
}

TEST_CASE("what a plugin writes into the report is no message") {
  for (const char* noise : {"", "hello", "{}", "[1]", "{\"finding\":\"x\"}", "{\"step\":7}"}) {
    CHECK_FALSE(decodeMessage(noise));
  }
}
