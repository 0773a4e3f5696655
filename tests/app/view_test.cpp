// SPDX-License-Identifier: BSD-3-Clause
// tolman view serves what the record contains, of finished, running and damaged runs.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "end_to_end/tiny_kitti.hpp"
#include "plugins/web_viewer/browser.hpp"
#include "record/run_reader.hpp"
#include "support/data.hpp"

namespace tolman::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// `tolman view` in the background, on a free port.
class Viewing {
 public:
  explicit Viewing(const fs::path& run, const std::vector<std::string>& more = {})
      : process_(command(run, more), folder_.path()) {
    for (int i = 0; i < 3000 && !contains(out(), "\n"); ++i) std::this_thread::sleep_for(10ms);
    const std::string text = out();
    INFO(text << readText(folder_.path() / "err"));
    REQUIRE(contains(text, "watch at http://127.0.0.1:"));
    port_ = std::stoi(text.substr(text.find("127.0.0.1:") + 10));
  }
  ~Viewing() {
    if (!ended_) end();
  }
  Viewing(const Viewing&) = delete;
  Viewing& operator=(const Viewing&) = delete;
  nlohmann::json run() const { return nlohmann::json::parse(get(port_, "/api/run").body); }
  void waitForEnd() const {
    for (int i = 0; i < 3000 && run()["live"] == true; ++i) std::this_thread::sleep_for(10ms);
    REQUIRE(run()["live"] == false);
  }
  Container container(const std::string& target) const {
    const HttpAnswer answer = get(port_, target);
    REQUIRE(answer.status == 200);
    return parseContainer(answer.body);
  }
  Finished end() {
    ended_ = true;
    process_.signal(SIGINT);
    return process_.wait();
  }
  std::string out() const { return readText(folder_.path() / "out"); }
  int port() const { return port_; }

 private:
  static std::vector<std::string> command(const fs::path& run,
                                          const std::vector<std::string>& more) {
    std::vector<std::string> words = {tolmanProgram().string(), "view", run.string(), "--port",
                                      "0"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  TemporaryFolder folder_;
  Process process_;
  int port_ = 0;
  bool ended_ = false;
};

struct Recorded {
  explicit Recorded(int frames) {
    writeTinyKitti(folder.path() / "sequence", frames);
    config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  }
  void make() const { REQUIRE(tolman::test::tolman(tinyRun(config, run)).exit_code == 0); }
  TemporaryFolder folder;
  fs::path config;
  fs::path run = folder.path() / "run";
};

/// One column of a history.
std::vector<double> column(const Container& history, const nlohmann::json& hello,
                           const std::string& name) {
  std::size_t index = 0;
  while (hello["columns"].at(index)["name"] != name) ++index;
  const auto rows = history.arrays.at("rows").as<double>();
  std::vector<double> values;
  for (std::size_t i = index; i < rows.size(); i += hello["columns"].size()) {
    values.push_back(rows[i]);
  }
  return values;
}

}  // namespace

TEST_CASE("a finished run is served as it was recorded, with its images") {
  const Recorded recorded(40);
  recorded.make();
  Viewing viewing(recorded.run);
  viewing.waitForEnd();
  const auto hello = viewing.run();
  CHECK(hello["recorded"] == true);  // the page does not call it live, even while it is read
  const auto& run = hello["run"];
  CHECK(run["source"]["frames"] == 40);
  CHECK(run["directory"] == fs::absolute(recorded.run).string());
  CHECK(run["source"]["rig"]["width"] == 160);
  CHECK(run["source"]["has_truth"] == true);
  const auto reader = record::RunReader::open(recorded.run).value();
  const Container history = viewing.container("/api/history");
  const auto motions = reader->records<Motion>().value();
  const auto updates = reader->records<MapUpdate>().value();
  const auto decisions = reader->records<Decision>().value();
  const auto tracked = column(history, hello, "motion.tracked");
  const auto map_z = column(history, hello, "map.z");
  const auto heading = column(history, hello, "decision.heading");
  REQUIRE(tracked.size() == 40);
  for (std::size_t i = 0; i < 40; ++i) {
    CHECK(tracked[i] == static_cast<double>(motions[i].tracked));
    CHECK(map_z[i] == updates[i].T_world_camera.translation().z());
    CHECK(heading[i] == decisions[i].heading);
  }
  const auto odometry = reader->odometry().value();
  CHECK(column(history, hello, "odometry.z")[39] ==
        Approx(odometry[39].T_world_camera.translation().z()));
  CHECK(column(history, hello, "duration.odometry")[5] > 0);
  const Container graph = viewing.container("/api/graph");
  CHECK(graph.arrays.at("experience").shape[0] == reader->graph().value().experiences.size());
  for (const int frame : {0, 17, 39}) {  // each frame is kept
    const Container shown = viewing.container("/api/frame/" + std::to_string(frame));
    CHECK(shown.header["frame"] == frame);
    CHECK(shown.has("image"));
    CHECK(shown.has("cells.hd.activity"));
  }
  CHECK(viewing.end().exit_code == 0);
}

TEST_CASE("a run that goes on is followed to its end") {
  const Recorded recorded(60);
  std::vector<std::string> command = tinyRun(recorded.config, recorded.run);
  command.insert(command.begin(), tolmanProgram().string());
  for (const char* word : {"--set", "pipeline.mode=realtime"}) command.emplace_back(word);
  const TemporaryFolder out;
  Process running(command, out.path());
  std::int64_t committed = 0;
  for (int i = 0; i < 3000 && committed == 0; ++i) {
    std::this_thread::sleep_for(10ms);
    const auto reader = record::RunReader::open(recorded.run);
    if (!reader.isOk()) continue;
    const auto totals = reader.value()->totals();
    if (totals.isOk()) committed = totals.value().frames;
  }
  Viewing viewing(recorded.run);
  CHECK(viewing.run()["live"] == true);
  CHECK(viewing.run()["recorded"] == false);
  LiveSocket socket(viewing.port(), 60);
  CHECK(socket.next("hello")->header["live"] == true);
  CHECK(socket.next("end"));
  CHECK(running.wait().exit_code == 0);
  const auto frames = record::RunReader::open(recorded.run).value()->records<Frame>().value();
  CHECK(viewing.container("/api/history").header["total"] == frames.size());
  CHECK(viewing.end().exit_code == 0);
}

TEST_CASE("a killed run is served as far as it came") {
  const Recorded recorded(60);
  std::vector<std::string> command = tinyRun(recorded.config, recorded.run);
  command.insert(command.begin(), tolmanProgram().string());
  for (const char* word : {"--set", "pipeline.mode=realtime"}) command.emplace_back(word);
  const TemporaryFolder out;
  Process running(command, out.path());
  for (int i = 0; i < 3000 && !fs::exists(recorded.run / "run.sqlite"); ++i) {
    std::this_thread::sleep_for(10ms);
  }
  std::this_thread::sleep_for(2s);
  running.signal(SIGKILL);
  CHECK(running.wait().exit_code == 128 + SIGKILL);
  Viewing viewing(recorded.run);
  viewing.waitForEnd();
  const auto frames = record::RunReader::open(recorded.run).value()->records<Frame>().value();
  CHECK(viewing.container("/api/history").header["total"] == frames.size());
  const Finished ended = viewing.end();
  CHECK(ended.exit_code == 0);
  CHECK(contains(ended.out + ended.err, "the run was killed; what it had recorded is shown"));
}

TEST_CASE("JSON for programs, and silence on demand") {
  const Recorded recorded(5);
  recorded.make();
  const TemporaryFolder folder;
  Process process(
      {tolmanProgram().string(), "view", recorded.run.string(), "--port", "0", "--json"},
      folder.path());
  const fs::path file = folder.path() / "out";
  for (int i = 0; i < 3000 && !contains(readText(file), "\n"); ++i) {
    std::this_thread::sleep_for(10ms);
  }
  const auto address = readJson(file);
  CHECK(get(address.at("port"), "/").status == 200);
  process.signal(SIGTERM);
  CHECK(process.wait().exit_code == 0);
}

TEST_CASE("what is no run is refused as by the other commands") {
  const TemporaryFolder folder;
  const std::string run = folder.path().string();
  const Finished view = tolman::test::tolman({"view", run});
  const Finished report = tolman::test::tolman({"report", run});
  CHECK(view.exit_code == 5);
  CHECK(view.exit_code == report.exit_code);
  CHECK(view.err == report.err);
  std::ofstream(folder.path() / "run.sqlite") << "this is no database, however long it may be";
  const Finished damaged = tolman::test::tolman({"view", run});
  CHECK(damaged.exit_code == 5);
  CHECK(contains(damaged.err, "run.sqlite"));
  CHECK(tolman::test::tolman({"view"}).exit_code == 2);
  CHECK(tolman::test::tolman({"view", run, "--port", "70000"}).exit_code == 2);
}

}  // namespace tolman::test
