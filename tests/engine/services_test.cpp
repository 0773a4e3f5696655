// SPDX-License-Identifier: BSD-3-Clause
// The services of a run: the log keeps every line, artefacts are kept until their folder exists.
#include "engine/services.hpp"

#include <catch2/catch.hpp>
#include <regex>
#include <thread>
#include <vector>

#include "end_to_end/process.hpp"
#include "host/instance.hpp"
#include "record/atomic_file.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::engine;
using test::TemporaryFolder;

namespace {

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::istringstream text(test::readText(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace

TEST_CASE("lines written before there is a file come first in it, each with time and level") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "log.txt";
  RunLog log(true);
  log.write(LogLevel::Info, "tolman", "early");
  log.write(LogLevel::Debug, "cells", "detail");
  REQUIRE(log.openFile(file).isOk());
  log.write(LogLevel::Warning, "map", "late", false);
  const std::vector<std::string> lines = linesOf(file);
  REQUIRE(lines.size() == 3);
  const std::string time = R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3} )";
  CHECK(std::regex_match(lines[0], std::regex(time + "info tolman: early")));
  CHECK(std::regex_match(lines[1], std::regex(time + "debug cells: detail")));
  CHECK(std::regex_match(lines[2], std::regex(time + "warning map: late")));
}

TEST_CASE("warnings from before there is a file can be asked for") {
  RunLog log(true);
  log.write(LogLevel::Info, "source", "watch at");
  log.write(LogLevel::Warning, "source", "dark");
  CHECK(log.keptWarnings() == std::vector<std::string>{"source: dark"});
}

TEST_CASE("messages are text, whatever a format string would make of them") {
  const TemporaryFolder folder;
  RunLog log(true);
  REQUIRE(log.openFile(folder.path() / "log.txt").isOk());
  StageLogger stage(log, "odometry");
  for (const char* text : {"{}", "{0:d} %s %n", "100 %", "{{", ""}) {
    stage.write(LogLevel::Info, text);
    const std::vector<std::string> lines = linesOf(folder.path() / "log.txt");
    CAPTURE(text);
    CHECK(lines.back().ends_with(std::string("info odometry: ") + text));
  }
}

TEST_CASE("threads write whole lines, and none is lost") {
  const TemporaryFolder folder;
  {
    RunLog log(true);
    std::vector<std::thread> writers;
    for (int w = 0; w < 4; ++w) {
      writers.emplace_back([&log, w] {
        StageLogger stage(log, "stage" + std::to_string(w));
        for (int i = 0; i < 300; ++i) stage.write(LogLevel::Info, "line " + std::to_string(i));
      });
    }
    REQUIRE(log.openFile(folder.path() / "log.txt").isOk());  // amid the first lines
    for (std::thread& writer : writers) writer.join();
  }
  std::array<int, 4> next{};
  for (const std::string& line : linesOf(folder.path() / "log.txt")) {
    std::smatch match;
    REQUIRE(std::regex_search(line, match, std::regex("info stage(\\d): line (\\d+)$")));
    REQUIRE(std::stoi(match[2]) == next[static_cast<std::size_t>(std::stoi(match[1]))]++);
  }
  for (const int count : next) CHECK(count == 300);
}

TEST_CASE("a log that cannot be opened or written says so in its status") {
  const TemporaryFolder folder;
  RunLog log(true);
  CHECK_FALSE(log.openFile(folder.path()).isOk());  // a folder
  CHECK_FALSE(log.status().isOk());
  RunLog full(true);
  full.write(LogLevel::Info, "tolman", "line");
  const Status opened = full.openFile("/dev/full");
  full.write(LogLevel::Info, "tolman", "line");
  CHECK_FALSE(full.status().isOk());
  CHECK(test::contains(full.status().message(), "look for a full disk"));
  CHECK((opened.isOk() || opened.message() == full.status().message()));
}

TEST_CASE("artefacts are refused before there is a run directory, and never leave it") {
  const TemporaryFolder folder;
  host::StageArtefacts artefacts;
  CHECK(artefacts.write("a.txt", bytesOf("text")).message() ==
        "there is no run directory yet; write artefacts after configure()");
  artefacts.folder = std::make_unique<record::ArtefactFolder>(folder.path(), "cells");
  CHECK(artefacts.write("plots/a.txt", bytesOf("text")).isOk());
  CHECK(test::readText(folder.path() / "artefacts/cells/plots/a.txt") == "text");
  for (const char* name : {"", "/etc/a", "../a", "a/../../b", "a/", ".", "a//../b"}) {
    CAPTURE(name);
    CHECK_FALSE(artefacts.write(name, bytesOf("text")).isOk());
  }
}

TEST_CASE("the clock never goes back") {
  SteadyClock clock;
  std::int64_t before = clock.steadyNs();
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t now = clock.steadyNs();
    REQUIRE(now >= before);
    before = now;
  }
}
