// SPDX-License-Identifier: BSD-3-Clause
// Killed and interrupted runs are resumed from their last checkpoint, and give the same bytes as
// runs without interruption.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <thread>

#include "end_to_end/record_rows.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

Words joined(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// The frame of the last checkpoint; -1 while there is none.
int checkpointOf(const fs::path& run) {
  const fs::path file = run / "state/checkpoint.json";
  return fs::exists(file) ? readJson(file)["frame"].get<int>() : -1;
}

/// Starts `arguments` and sends `signal` once a checkpoint of `frame` or later is written.
Finished signalled(const Words& arguments, const fs::path& out, int signal, int frame) {
  const TemporaryFolder folder;
  Process process(joined({tolmanProgram().string()}, arguments), folder.path());
  for (int i = 0; i < 3000 && checkpointOf(out) < frame; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  process.signal(signal);
  return process.wait();
}

/// Plain files of the folder with their contents; those of SQLite come and go with its readers.
std::map<std::string, std::string> filesOf(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name.starts_with("run.sqlite")) continue;
    files[entry.path().string()] = readText(entry.path());
  }
  return files;
}

/// 60 frames at four times the speed of their stamps, none of them dropped.
struct TinyRun {
  TemporaryFolder folder;
  fs::path out = folder.path() / "run";
  Words plugins;
  Words words;

  TinyRun() {
    writeTinyKitti(folder.path() / "sequence", 60);
    words = tinyRun(writeTinyConfig(folder.path(), folder.path() / "sequence"), out);
    plugins = {words.end() - 4, words.end()};
    for (const char* setting : {"pipeline.mode=realtime", "pipeline.speed=4",
                                "pipeline.input_policy=block", "record.state_every=0.05"}) {
      words.insert(words.end(), {"--set", setting});
    }
  }
  /// The digests of a run to the end.
  std::string expected() const {
    Words whole = words;
    *std::ranges::find(whole, out.string()) = (folder.path() / "whole").string();
    const Finished finished = tolman::test::tolman(whole);
    INFO(finished.err);
    REQUIRE(finished.exit_code == 0);
    return readText(folder.path() / "whole/results.sha256");
  }
  Words resume() const { return joined({"run", "--resume", out.string()}, plugins); }
};

}  // namespace

TEST_CASE("a run that is killed twice and resumed twice ends with the same bytes") {
  const TinyRun run;
  CHECK(signalled(run.words, run.out, SIGKILL, 8).exit_code == 128 + SIGKILL);
  const int first = checkpointOf(run.out);
  REQUIRE(first >= 8);
  CHECK(signalled(run.resume(), run.out, SIGKILL, first + 8).exit_code == 128 + SIGKILL);
  const int second = checkpointOf(run.out);
  REQUIRE(second >= first + 8);
  const Finished resumed = tolman::test::tolman(run.resume());
  INFO(resumed.err);
  REQUIRE(resumed.exit_code == 0);
  CHECK(readText(run.out / "results.sha256") == run.expected());
  const auto json = readJson(run.out / "run.json");
  CHECK(json["status"] == "finished");
  REQUIRE(json["resumed"].size() == 2);
  CHECK(json["resumed"][1]["first_frame"] == second + 1);
  CHECK(json["counters"]["frames"] == 60);
  CHECK(checkpointOf(run.out) == -1);  // a finished run needs none
}

TEST_CASE(
    "observers of a resumed run get its recorded frames first, so that their files are whole") {
  for (const char* isolation : {"none", "process"}) {
    TinyRun run;
    run.words.insert(
        run.words.end(),
        {"--plugin-path", inBuild("tests/fixtures/plugins/snapshot_log"), "--set",
         "observers=[{plugin: snapshot_log, isolation: " + std::string(isolation) + "}]"});
    Words resume = run.resume();
    resume.insert(resume.end(), {"--plugin-path", inBuild("tests/fixtures/plugins/snapshot_log")});
    CHECK(signalled(run.words, run.out, SIGKILL, 20).exit_code == 128 + SIGKILL);
    const Finished resumed = tolman::test::tolman(resume);
    INFO(resumed.err);
    REQUIRE(resumed.exit_code == 0);
    const std::string text = readText(run.out / "artefacts/snapshot_log/snapshots.txt");
    std::size_t frames = 0;
    for (std::size_t at = 0; (at = text.find("timed\n", at)) != std::string::npos; ++at) ++frames;
    CHECK(frames == 60);
  }
}

TEST_CASE("a run that is still going is not continued") {
  const TinyRun run;
  const TemporaryFolder folder;
  Process going(joined({tolmanProgram().string()}, run.words), folder.path());
  for (int i = 0; i < 3000 && checkpointOf(run.out) < 5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  Words words = run.words;
  *std::ranges::find(words, run.out.string()) = (run.folder.path() / "second").string();
  const Finished refused = tolman::test::tolman(joined(words, {"--continue", run.out.string()}));
  CHECK(refused.exit_code == 9);
  CHECK(contains(refused.err, run.out.string() + ": this run is still going; wait for its end"));
  going.signal(SIGINT);
  CHECK(going.wait().exit_code == 130);
  CHECK(tolman::test::tolman(joined(words, {"--continue", run.out.string()})).exit_code == 0);
}

TEST_CASE("an interrupted run is resumed after its very last frame") {
  const TinyRun run;
  const Finished interrupted = signalled(run.words, run.out, SIGINT, 5);
  CHECK(interrupted.exit_code == 130);
  const int frames = readJson(run.out / "run.json")["counters"]["frames"];
  CHECK(checkpointOf(run.out) == frames - 1);
  const Finished resumed = tolman::test::tolman(run.resume());
  INFO(resumed.err);
  REQUIRE(resumed.exit_code == 0);
  CHECK(readText(run.out / "results.sha256") == run.expected());
}

TEST_CASE("a killed run's map can be continued in a new run, from its last checkpoint") {
  const TinyRun run;
  signalled(run.words, run.out, SIGKILL, 10);
  const int last = checkpointOf(run.out);
  const fs::path next = run.folder.path() / "next";
  Words words = joined(run.words, {"--continue", run.out.string()});
  *std::ranges::find(words, run.out.string()) = next.string();
  const Finished finished = tolman::test::tolman(words);
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto sessions = recordRows(next, "SELECT first_frame FROM session");
  REQUIRE(sessions.size() == 2);
  CHECK(sessions[1][0] == last + 1);
  CHECK(recordRows(next, "SELECT count(*) FROM frame")[0][0] == last + 1 + 60);
}

TEST_CASE("a run whose directory is moved writes nothing into the one that takes its place") {
  const TinyRun run;
  const fs::path moved = run.folder.path() / "moved";
  const bool replaced = GENERATE(true, false);
  Finished finished;
  {
    Process process(joined({tolmanProgram().string()}, run.words), run.folder.path());
    while (checkpointOf(run.out) < 5) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    fs::rename(run.out, moved);
    if (replaced) {
      fs::create_directory(run.out);
      std::ofstream(run.out / "run.json") << "{\"status\": \"of another run\"}";
    }
    finished = process.wait();
  }
  CAPTURE(replaced, finished.err);
  CHECK(finished.exit_code == 8);
  CHECK(contains(finished.err, "/run: this run directory was moved, removed or replaced"));
  if (replaced) {
    CHECK(filesOf(run.out).size() == 1);
    CHECK(readJson(run.out / "run.json")["status"] == "of another run");
  } else {
    CHECK_FALSE(fs::exists(run.out));
  }
  CHECK(readJson(moved / "run.json")["status"] == "failed");
  CHECK(tolman::test::tolman({"export", moved.string()}).exit_code == 0);
  CHECK(readText(moved / "trajectory.tum").size() > 100);
}

TEST_CASE("a run is not resumed with another build of a plugin, or of a library that it brings") {
  TinyRun run;
  const fs::path folder = run.folder.path() / "plugins";
  fs::copy(inBuild("tests/fixtures/plugins/brings_library"), folder);
  run.plugins = joined(run.plugins, {"--plugin-path", folder.string()});
  run.words = joined(run.words,
                     {"--plugin-path", folder.string(), "--set", "odometry.plugin=brings_library"});
  signalled(run.words, run.out, SIGKILL, 8);
  for (const char* name : {"tolman_odometry_brings_library.so", "libtolman_brought.so"}) {
    const fs::path file = folder / name;
    fs::copy(file, run.folder.path() / "first.so");
    fs::copy(file, run.folder.path() / "second.so");
    std::ofstream(run.folder.path() / "second.so", std::ios::app) << "built again";
    fs::rename(run.folder.path() / "second.so", file);
    const auto before = filesOf(run.out);
    const Finished refused = tolman::test::tolman(run.resume());
    CHECK(refused.exit_code == 9);
    CHECK(contains(refused.err, file.string() + ": has other contents than when the run began"));
    CHECK(filesOf(run.out) == before);
    fs::rename(run.folder.path() / "first.so", file);
  }
  auto json = readJson(run.out / "run.json");
  const auto kept = json["tolman"];
  const Finished digest = tolman::test::run({"sha256sum", tolmanProgram().string()});
  CHECK(digest.out.starts_with(kept["sha256"].get<std::string>() + " "));
  for (const char* key : {"revision", "sha256"}) {
    json["tolman"][key] = "0123456789ab";
    std::ofstream(run.out / "run.json") << json;
    const Finished refused = tolman::test::tolman(run.resume());
    CHECK(refused.exit_code == 9);
    CHECK(contains(refused.err, "the run was begun by another version of tolman"));
    json["tolman"] = kept;
  }
  std::ofstream(run.out / "run.json") << json;
  const Finished resumed = tolman::test::tolman(run.resume());
  INFO(resumed.err);
  CHECK(resumed.exit_code == 0);
}

TEST_CASE("what cannot be resumed is refused with exit code 9, and stays as it is") {
  const TinyRun run;
  signalled(run.words, run.out, SIGKILL, 8);
  const auto refusal = [&] {
    const auto before = filesOf(run.out);
    const Finished finished = tolman::test::tolman(run.resume());
    CHECK(finished.exit_code == 9);
    CHECK(std::count(finished.err.begin(), finished.err.end(), '\n') == 1);
    CHECK(filesOf(run.out) == before);
    return finished.err;
  };
  const fs::path config = run.out / "config.resolved.yaml";
  const fs::path checkpoint = run.out / "state/checkpoint.json";
  std::string text;
  SECTION("another odometry than that of the record") {
    text = readText(config);
    REQUIRE(contains(text, " speed: 10\n"));
    text.replace(text.find(" speed: 10\n"), 10, " speed: 11");
    std::ofstream(config) << text;
    CHECK(contains(refusal(), "config.resolved.yaml: is not what the run wrote"));
    auto json = readJson(run.out / "run.json");
    json.erase("config_sha256");  // as versions before wrote it
    std::ofstream(run.out / "run.json") << json;
    CHECK(contains(refusal(), "gives another motion at frame 1 than was recorded"));
  }
  SECTION("other true poses, and none") {
    const fs::path poses = run.folder.path() / "sequence/poses.txt";
    text = readText(poses);
    std::size_t line = 0;
    for (int i = 0; i < 2; ++i) line = text.find('\n', line) + 1;
    const std::size_t third = text.find('\n', line) + 1;  // frame 3 stands where frame 2 was
    std::ofstream(poses) << text.substr(0, third) << text.substr(line, third - line)
                         << text.substr(text.find('\n', third) + 1);
    CHECK(contains(refusal(), "sequence: has other contents than when the run began ("));
    auto json = readJson(run.out / "run.json");
    json.erase("data");  // what later data do to a run of which no digest is known
    std::ofstream(run.out / "run.json") << json;
    CHECK(contains(refusal(), "stamp or true pose of frame 3 is another than was recorded"));
    fs::remove(poses);
    CHECK(contains(refusal(), "stamp or true pose of frame 0 is another than was recorded"));
  }
  SECTION("fewer frames") {
    text = readText(config);
    REQUIRE(contains(text, " last: -1\n"));
    text.replace(text.find(" last: -1\n"), 9, " last: 4");
    std::ofstream(config) << text;
    auto json = readJson(run.out / "run.json");
    json.erase("config_sha256");
    std::ofstream(run.out / "run.json") << json;
    CHECK(contains(refusal(), "has fewer frames than were recorded"));
  }
  SECTION("a damaged checkpoint") {
    std::ofstream(checkpoint) << "{\"format\": 1, \"frame\": \"x\"}";
    CHECK(contains(refusal(), "checkpoint.json: is damaged"));
    fs::remove(checkpoint);
    CHECK(contains(refusal(), "has no checkpoint"));
  }
  SECTION("a run.json that is missing or damaged") {
    for (const char* damaged : {"", "[1]"}) {
      std::ofstream(run.out / "run.json") << damaged;
      CHECK(contains(refusal(), "run.json: is missing or damaged"));
    }
    fs::remove(run.out / "run.json");
    CHECK(contains(refusal(), "run.json: is missing or damaged"));
  }
  SECTION("a checkpoint that the record does not reach") {
    text = readText(checkpoint);
    const std::string frame = "\"frame\": " + std::to_string(checkpointOf(run.out));
    text.replace(text.find(frame), frame.size(), "\"frame\": 900");
    std::ofstream(checkpoint) << text;
    CHECK(contains(refusal(), "checkpoint-900-place.bin"));
  }
  SECTION("a run that has finished") {
    REQUIRE(tolman::test::tolman(run.resume()).exit_code == 0);
    CHECK(contains(refusal(), "this run has finished, there is nothing to resume"));
  }
}

TEST_CASE("--resume takes the configuration of the run and nothing beside it") {
  CHECK(tolman::test::tolman({"run", "--resume", "x", "--seed", "3"}).exit_code == 2);
  CHECK(tolman::test::tolman({"run", "a.yaml", "--resume", "x"}).exit_code == 2);
  CHECK(tolman::test::tolman({"run"}).exit_code == 2);
  const Finished missing = tolman::test::tolman({"run", "--resume", "/missing"});
  CHECK(missing.exit_code == 9);
  CHECK(contains(missing.err, "/missing: is no run directory, it holds no config.resolved.yaml"));
  const TemporaryFolder folder;
  const Finished no_run = tolman::test::tolman({"run", "--resume", folder.path().string()});
  CHECK(no_run.exit_code == 9);
  CHECK(contains(no_run.err, ": is no run directory, it holds no config.resolved.yaml"));
}

TEST_CASE("real images and real motion: resumed runs have the bytes of uninterrupted ones",
          "[data]") {
  const auto [config, sequence, frame] =
      GENERATE(std::tuple{"configs/kitti.yaml", "kitti_clips/06", 15},
               std::tuple{"configs/motion.yaml", "kitti_motion/05", 900});
  const auto data = dataOrSkip(sequence);
  if (!data) return;
  const TemporaryFolder folder;
  const auto words = [&](const fs::path& out) {
    return Words{"run",
                 inSource(config),
                 "-q",
                 "--out",
                 out.string(),
                 "--set",
                 "source.path=" + data->string(),
                 "--set",
                 "record.state_every=0.1"};
  };
  const fs::path whole = folder.path() / "whole";
  const fs::path out = folder.path() / "run";
  REQUIRE(tolman::test::tolman(words(whole)).exit_code == 0);
  signalled(words(out), out, SIGKILL, frame);
  if (readJson(out / "run.json")["status"] == "running") {  // else it was faster than the signal
    const Finished resumed = tolman::test::tolman({"run", "-q", "--resume", out.string()});
    INFO(resumed.err);
    REQUIRE(resumed.exit_code == 0);
  }
  CHECK(readText(out / "results.sha256") == readText(whole / "results.sha256"));
  for (const char* query :
       {"SELECT count(*) FROM array", "SELECT sum(length(\"values\")) FROM array",
        "SELECT count(*), sum(rowid * announced_at) FROM motion_revision"}) {
    CHECK(recordRows(out, query) == recordRows(whole, query));
  }
}

TEST_CASE("a run that this user may not write is not resumed, and told as read-only") {
  if (::geteuid() != 0) return;  // the owner could be root alone
  const TinyRun tiny;
  (void)signalled(tiny.words, tiny.out, SIGKILL, 10);
  const auto before = filesOf(tiny.out);
  fs::permissions(tiny.folder.path(), fs::perms(0755));
  Words words = {"setpriv", "--reuid=54324", "--regid=54324", "--clear-groups"};
  if (run(joined(words, {"test", "-x", tolmanProgram().string()})).exit_code != 0) return;
  words = joined(words, {tolmanProgram().string(), "run", "--resume", tiny.out.string()});
  const Finished finished = run(joined(words, tiny.plugins));
  CAPTURE(finished.err);
  CHECK(finished.exit_code == 9);
  CHECK(contains(finished.err, "run: is read-only for this user (Permission denied)"));
  CHECK(contains(finished.err, "make it writable, or resume a copy: cp -r"));
  CHECK(filesOf(tiny.out) == before);
  const std::string copy = (tiny.folder.path() / "copy").string();  // the remedy
  fs::copy(tiny.out, copy, fs::copy_options::recursive);
  const Finished resumed = tolman::test::tolman(joined({"run", "--resume", copy}, tiny.plugins));
  CAPTURE(resumed.err);
  CHECK(resumed.exit_code == 0);
}
