// SPDX-License-Identifier: BSD-3-Clause
// Runs with viewer and clients have the same results as without. The hidden cases measure the cost
// of the viewer.
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <thread>

#include "browser.hpp"
#include "end_to_end/process.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"

namespace tolman::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Waits for the port of a run's viewer; 0 when there is none.
int portOf(const fs::path& run) {
  const fs::path file = run / "artefacts/web_viewer/viewer.json";
  for (int i = 0; i < 3000 && !fs::exists(file); ++i) std::this_thread::sleep_for(10ms);
  return fs::exists(file) ? readJson(file).at("port").get<int>() : 0;
}

/// Three clients that read, and one that does not.
class TestClients {
 public:
  explicit TestClients(int port) : stalled_(port, 600, 4096) {
    for (int i = 0; i < 3; ++i) {
      // Opened here, because this asserts, which only one thread may do at a time (Catch2).
      auto socket = std::make_shared<LiveSocket>(port, 600);
      readers_.emplace_back([this, socket] {
        while (auto message = socket->next()) {
          if (message->opcode == 8) {
            socket->sendFrame(0x88, message->bytes.substr(0, 2));
            break;
          }
          ++messages_;
        }
      });
    }
  }
  ~TestClients() {
    for (std::thread& reader : readers_) reader.join();
  }
  int messages() const { return messages_; }

 private:
  LiveSocket stalled_;
  std::vector<std::thread> readers_;
  std::atomic<int> messages_ = 0;
};

std::vector<std::string> words(const char* text) {
  std::istringstream stream(text != nullptr ? text : "");
  return {std::istream_iterator<std::string>(stream), {}};
}

/// `tolman run` with configuration and options from $TOLMAN_BENCH_RUN.
std::vector<std::string> benchCommand(const fs::path& out, bool watched) {
  std::vector<std::string> command = {tolmanProgram().string(), "run", "-q", "--out", out.string()};
  for (const std::string& word : words(std::getenv("TOLMAN_BENCH_RUN"))) command.push_back(word);
  if (watched) command.emplace_back("--view");
  return command;
}

struct Cost {
  double wall_s = 0;
  double cpu_s = 0;
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Wall time and CPU of a whole run.
Cost measured(bool watched) {
  const TemporaryFolder folder;
  const auto begin = std::chrono::steady_clock::now();
  rusage before{};
  ::getrusage(RUSAGE_CHILDREN, &before);
  Process process(benchCommand(folder.path() / "run", watched), folder.path());
  std::unique_ptr<TestClients> clients;
  if (watched) clients = std::make_unique<TestClients>(portOf(folder.path() / "run"));
  const Finished finished = process.wait();
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  rusage after{};
  ::getrusage(RUSAGE_CHILDREN, &after);
  return {wall.count(), seconds(after.ru_utime) + seconds(after.ru_stime) -
                            seconds(before.ru_utime) - seconds(before.ru_stime)};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void report(const char* what, const std::vector<double>& without, const std::vector<double>& with) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < with.size(); ++i) ratios.push_back(with[i] / without[i]);
  std::cout << what << ": median " << median(without) << " s without, " << median(with)
            << " s with; ratio of medians " << median(with) / median(without) << ", of least "
            << *std::min_element(with.begin(), with.end()) /
                   *std::min_element(without.begin(), without.end())
            << ", median of pairs " << median(ratios) << "\n";
}

double residentMib(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  }
  return 0;
}

}  // namespace

TEST_CASE("a watched run gives byte-identical results") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 400);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const fs::path alone = folder.path() / "alone";
  const fs::path watched = folder.path() / "watched";
  REQUIRE(tolman::test::tolman(tinyRun(config, alone)).exit_code == 0);
  std::vector<std::string> command = tinyRun(config, watched);
  command.insert(command.begin(), tolmanProgram().string());
  command.emplace_back("--view");
  Process process(command, folder.path());
  int messages = 0;
  {
    const int port = portOf(watched);
    REQUIRE(port > 0);
    TestClients clients(port);
    for (int wait = 0; wait < 500 && messages == 0; ++wait) {
      std::this_thread::sleep_for(10ms);
      messages = clients.messages();
    }
  }
  const Finished finished = process.wait();
  INFO(finished.err);
  CHECK(finished.exit_code == 0);
  CHECK(messages > 0);
  CHECK(readText(watched / "results.sha256") == readText(alone / "results.sha256"));
  CHECK(contains(readText(watched / "config.resolved.yaml"), "plugin: web_viewer"));
  CHECK(contains(readText(watched / "log.txt"), "watch at http://127.0.0.1:"));
}

TEST_CASE("cost of the viewer", "[.][cost]") {
  const char* const passes = std::getenv("TOLMAN_BENCH_PASSES");
  std::vector<double> wall[2];
  std::vector<double> cpu[2];
  for (int pass = 0; pass < (passes != nullptr ? std::stoi(passes) : 3); ++pass) {
    for (const int watched : {0, 1}) {
      const Cost cost = measured(watched == 1);
      wall[watched].push_back(cost.wall_s);
      cpu[watched].push_back(cost.cpu_s);
      std::cout << (watched == 1 ? "with   " : "without") << " wall " << cost.wall_s << " s, CPU "
                << cost.cpu_s << " s" << std::endl;
    }
  }
  report("wall", wall[0], wall[1]);
  report("CPU ", cpu[0], cpu[1]);
}

TEST_CASE("memory of a run with viewer", "[.][memory]") {
  const TemporaryFolder folder;
  Process process(benchCommand(folder.path() / "run", true), folder.path());
  const int port = portOf(folder.path() / "run");
  REQUIRE(port > 0);
  const TestClients clients(port);
  LiveSocket socket(port, 600);
  double next = 0;
  while (const auto frame = socket.next("frame")) {
    const double shown = frame->header.at("frame");
    if (shown < next) continue;
    std::cout << "frame " << shown << ": " << residentMib(process.id()) << " MiB" << std::endl;
    next = (std::floor(shown / 250) + 1) * 250;
  }
  CHECK(process.wait().exit_code == 0);
}

}  // namespace tolman::test
