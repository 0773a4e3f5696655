// SPDX-License-Identifier: BSD-3-Clause
// For every write, sync, rename or opening of a file: if it fails, the run reports it. If the run
// is killed there, its record is readable, and the run can be resumed or this is refused with a
// message.
#ifdef TOLMAN_COUNTED_WRITES
#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <sstream>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

Words joined(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Runs of twelve frames in which one change of a file goes wrong.
class Victim {
 public:
  explicit Victim(Words settings = {}) {
    writeTinyKitti(folder_.path() / "sequence", 12);
    words_ = tinyRun(writeTinyConfig(folder_.path(), folder_.path() / "sequence"), out());
    plugins_ = {words_.end() - 4, words_.end()};
    words_ = joined(words_, settings);
  }

  fs::path out() const { return fs::canonical(folder_.path()) / "run"; }

  /// The number of changes of a run without a fault.
  int changes() const {
    const Finished finished = faulty({});
    INFO(finished.err);
    REQUIRE(finished.exit_code == 0);
    std::istringstream lines(change());
    int count = 0;
    for (std::string line; std::getline(lines, line);) ++count;
    return count;
  }
  Finished faulty(const std::string& fault, int at) const {
    return faulty({"TOLMAN_FAULT=" + fault, "TOLMAN_FAULT_AT=" + std::to_string(at)});
  }
  /// What went wrong: "write /tmp/.../run.sqlite-wal"; empty: the run had fewer changes.
  std::string change() const { return readText(log()); }
  Finished exported() const {
    return tolman::test::tolman(
        {"export", out().string(), "--out", (folder_.path() / "exported").string(), "--force"});
  }
  Finished resumed() const {
    return tolman::test::tolman(joined({"run", "--resume", out().string()}, plugins_));
  }

 private:
  fs::path log() const { return folder_.path() / "changes"; }
  Finished faulty(const Words& fault) const {
    fs::remove_all(out());
    fs::remove(log());
    const Words environment = {"env", std::string("LD_PRELOAD=") + TOLMAN_COUNTED_WRITES,
                               "TOLMAN_FAULT_BELOW=" + out().string(),
                               "TOLMAN_FAULT_LOG=" + log().string()};
    return tolman::test::run(
        joined(joined(environment, fault), joined({tolmanProgram().string()}, words_)));
  }

  TemporaryFolder folder_;
  Words words_;
  Words plugins_;
};

bool isOneSentence(const std::string& text) {
  return text.size() > 20 && std::count(text.begin(), text.end(), '\n') == 1;
}

/// A record that cannot be read is refused, in a sentence that names it.
void checkRecord(const Victim& victim) {
  const Finished exported = victim.exported();
  CAPTURE(exported.exit_code, exported.err);
  if (exported.exit_code == 0) return;
  CHECK(exported.exit_code == 5);
  CHECK(isOneSentence(exported.err));
  CHECK(contains(exported.err, victim.out().string()));
}

bool hasTemporaryFiles(const fs::path& folder) {
  if (!fs::exists(folder)) return false;
  return std::ranges::any_of(fs::recursive_directory_iterator(folder), [](const auto& entry) {
    return contains(entry.path().filename().string(), ".partial");
  });
}

}  // namespace

TEST_CASE("whichever change of a file fails, the run ends with exit code 8 and names a file") {
  const auto [fault, step] = GENERATE(std::tuple{"once", 9}, std::tuple{"full", 17});
  const Victim victim;
  const int changes = victim.changes();
  CHECK(changes > 200);
  int failed = 0;
  for (int at = 1; at <= changes; at += step) {
    const Finished finished = victim.faulty(fault, at);
    const std::string change = victim.change();
    if (change.empty()) continue;  // threads: this run had fewer changes
    CAPTURE(fault, at, change, finished.exit_code, finished.err);
    checkRecord(victim);
    // The log is opened again when the first attempt fails.
    if (finished.exit_code == 0 && change.starts_with("open") && contains(change, "log.txt")) {
      continue;
    }
    ++failed;
    CHECK(finished.exit_code == 8);
    CHECK(contains(finished.err, victim.out().string()));
    CHECK_FALSE(hasTemporaryFiles(victim.out()));
    const auto json = nlohmann::json::parse(readText(victim.out() / "run.json"), nullptr, false);
    CHECK((!json.is_object() || json["status"] != "finished"));
  }
  CHECK(failed > 200 / step);
}

TEST_CASE(
    "whichever change of a file a run is killed at, its record and its resumption are sound") {
  const Victim victim({"--set", "record.state_every=0.001"});
  const int changes = victim.changes();
  const std::string digests = readText(victim.out() / "results.sha256");
  int resumed = 0;
  int refused = 0;
  for (int at = 1; at <= changes; at += 19) {
    const Finished killed = victim.faulty("kill", at);
    const std::string change = victim.change();
    if (change.empty()) continue;
    CAPTURE(at, change, killed.exit_code, killed.err);
    CHECK(killed.exit_code == 128 + SIGKILL);
    checkRecord(victim);
    const Finished again = victim.resumed();
    CAPTURE(again.exit_code, again.err);
    if (again.exit_code == 0) {
      ++resumed;
      CHECK(readText(victim.out() / "results.sha256") == digests);
      CHECK(readJson(victim.out() / "run.json")["status"] == "finished");
    } else {
      ++refused;
      CHECK(again.exit_code == 9);
      CHECK(isOneSentence(again.err));
    }
  }
  CAPTURE(resumed, refused);
  CHECK(resumed > 10);
}
#endif
