// SPDX-License-Identifier: BSD-3-Clause
// Terminals, pipes and limits that fail while Tolman runs.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// `tolman` with these arguments as the end of a shell script, such as "ulimit -f 10; exec".
std::vector<std::string> script(const std::string& before, const std::vector<std::string>& words,
                                const std::string& after = "") {
  std::string line = before + " '" + tolmanProgram().string() + "'";
  for (const std::string& word : words) line += " '" + word + "'";
  return {"bash", "-c", line + after};
}

struct Tiny {
  TemporaryFolder folder;
  fs::path out = folder.path() / "run";

  explicit Tiny(int frames = 12) { writeTinyKitti(folder.path() / "sequence", frames); }
  std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    auto words = tinyRun(writeTinyConfig(folder.path(), folder.path() / "sequence"), out);
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

}  // namespace

TEST_CASE("output that cannot be written is exit code 8 of every command") {
  const Tiny tiny;
  const std::string config = writeTinyConfig(tiny.folder.path(), tiny.folder.path() / "sequence");
  const std::string truth = tiny.folder.path() / "sequence/poses.txt";
  const std::vector<std::string> path = {"--plugin-path", inBuild("tests/fixtures/plugins/steady")};
  const auto code = [&](std::vector<std::string> words) {
    words.insert(words.end(), path.begin(), path.end());
    const Finished finished = run(script("exec", words, " >/dev/full"));
    CAPTURE(words, finished.err);
    CHECK(contains(finished.err, "the output cannot be written"));
    return finished.exit_code;
  };
  CHECK(code({"run", config, "--out", tiny.out.string(), "--json"}) == 8);
  CHECK(code({"eval", truth, truth, "--json"}) == 8);
  CHECK(code({"eval", truth, truth}) == 8);
  CHECK(code({"check", config, "--explain"}) == 8);
  CHECK(code({"plugins", "describe", "steady", "--json-schema"}) == 8);
  CHECK(code({"plugins", "list", "--json"}) == 8);
  CHECK(code({"--help"}) == 8);
}

TEST_CASE("a closed output is told as one that cannot be written") {
  const Tiny tiny;
  const std::string truth = tiny.folder.path() / "sequence/poses.txt";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"eval", truth, truth}, {"plugins", "list"}, {"--version"}}) {
    CAPTURE(words);
    CHECK(run(script("exec", words, " >&-")).exit_code == 8);
  }
  CHECK(run(script("exec", tiny.arguments({"--quiet"}), " >&- 2>&- <&-")).exit_code == 0);
  CHECK(readJson(tiny.out / "run.json")["status"] == "finished");
}

TEST_CASE("control sequences in configurations and names of folders do not reach the terminal") {
  const TemporaryFolder folder;
  const fs::path config = folder.path() / "\x1b]0;title\a.yaml";
  std::ofstream(config) << "\"\\e]0;title\\a\\e[31mkey\": 1\nseed: \"\\e[31m\"\n";
  const Finished finished = run({tolmanProgram().string(), "check", config.string()});
  CHECK(finished.exit_code == 3);
  CHECK(contains(finished.err, "?]0;title??[31mkey"));
  CHECK_FALSE(contains(finished.err, "\x1b"));
  CHECK_FALSE(contains(finished.err, "\a"));
}

TEST_CASE("a closed pipe does not end a run; its exit code is 8") {
  const Tiny tiny;
  // A pipe without a reader: 3 opened both ends, 4 writes, 3 closes.
  const std::string pipe = "mkfifo '" + (tiny.folder.path() / "pipe").string() + "'; exec 3<>'" +
                           (tiny.folder.path() / "pipe").string() + "' 4>'" +
                           (tiny.folder.path() / "pipe").string() + "' 3<&-; exec";
  const Finished finished = run(script(pipe, tiny.arguments(), " >&4 2>&4"));
  CHECK(finished.exit_code == 8);
  CHECK(readJson(tiny.out / "run.json")["status"] == "finished");
  CHECK(fs::exists(tiny.out / "report.html"));
}

TEST_CASE("a closed terminal interrupts a run, even when it says so twice") {
  const Tiny tiny(80);  // 8 s in realtime
  auto command = tiny.arguments({"--set", "pipeline.mode=realtime"});
  const auto waitForRecord = [&] {
    for (int i = 0; i < 6000 && !fs::exists(tiny.out / "run.sqlite"); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  };
  SECTION("interrupted") {
    Process process(script("exec", command), tiny.folder.path());
    waitForRecord();
    process.signal(SIGHUP);
    process.signal(SIGHUP);
    CHECK(process.wait().exit_code == 130);
    CHECK(readJson(tiny.out / "run.json")["status"] == "interrupted");
    CHECK(fs::exists(tiny.out / "state/session.json"));
  }
  SECTION("ignored, as by nohup") {
    Process process(script("trap '' HUP; exec", command), tiny.folder.path());
    waitForRecord();
    process.signal(SIGHUP);
    CHECK(process.wait().exit_code == 0);
    CHECK(readJson(tiny.out / "run.json")["status"] == "finished");
  }
}
