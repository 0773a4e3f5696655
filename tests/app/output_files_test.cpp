// SPDX-License-Identifier: BSD-3-Clause
// No command replaces a file that exists without --force.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

const std::string kPrecious = "years of work\n";

/// A recorded run, and files of the user beside it.
struct Desk {
  TemporaryFolder folder;
  fs::path run = folder.path() / "run";
  fs::path config;

  explicit Desk(bool has_run = true) {
    if (!has_run) return;
    writeTinyKitti(folder.path() / "sequence", 6);
    config = writeTinyConfig(folder.path(), folder.path() / "sequence");
    REQUIRE(tolman::test::tolman(tinyRun(config, run)).exit_code == 0);
  }
  /// A sweep over the same configuration.
  fs::path study() const {
    const fs::path file = folder.path() / "study.yaml";
    std::ofstream(file) << "base: tiny.yaml\nseeds: 2\n";
    return file;
  }
  fs::path precious(const std::string& name) const {
    const fs::path file = folder.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << kPrecious;
    return file;
  }
};

/// The command refuses to replace `file`, and with --force does replace it.
void isKept(const fs::path& file, const std::string& option, std::vector<std::string> words) {
  INFO(file);
  const Finished refused = tolman::test::tolman(words);
  CHECK(refused.exit_code == 8);
  CHECK(refused.err ==
        file.string() + ": exists; choose another " + option + ", or replace it with --force\n");
  CHECK(readText(file) == kPrecious);
  words.emplace_back("--force");
  CHECK(tolman::test::tolman(words).exit_code == 0);
  CHECK(readText(file) != kPrecious);
}

}  // namespace

TEST_CASE("files in the folder of an export are replaced only by force") {
  const Desk desk;
  const std::string run = desk.run.string();
  const std::string out = (desk.folder.path() / "mine").string();
  isKept(desk.precious("mine/trajectory.tum"), "--out", {"export", run, "--out", out});
  CHECK(tolman::test::tolman({"export", run}).exit_code ==
        0);  // in its own directory they are Tolman's
  CHECK(tolman::test::tolman({"export", run, "--out", run}).exit_code == 0);
}

TEST_CASE("a report and figures are replaced only by force") {
  const Desk desk;
  const std::string run = desk.run.string();
  const std::string out = (desk.folder.path() / "mine").string();
  isKept(desk.precious("mine/report.html"), "--out", {"report", run, "--out", out});
  CHECK(tolman::test::tolman({"report", run}).exit_code == 0);
}

TEST_CASE("tables and figures of a comparison are replaced only by force") {
  const Desk desk;
  const std::string run = desk.run.string();
  const fs::path table = desk.precious("table.md");
  isKept(table, "--out", {"compare", run, "--out", table.string()});
  const fs::path figure = desk.precious("figure.svg");
  isKept(figure, "--figure", {"compare", run, "--figure", figure.string()});
  // Nothing is lost by these: an empty file, a device, the standard output.
  const fs::path empty = desk.folder.path() / "empty.md";
  std::ofstream(empty).flush();
  CHECK(tolman::test::tolman({"compare", run, "--out", empty.string()}).exit_code == 0);
  CHECK(tolman::test::tolman({"compare", run, "--out", "/dev/null"}).exit_code == 0);
  CHECK(tolman::test::tolman({"compare", run, "--out", "/dev/stdout"}).exit_code == 0);
  // A link would be replaced, so it counts as a file, also if it leads nowhere.
  fs::create_symlink("nowhere", desk.folder.path() / "link.md");
  CHECK(tolman::test::tolman({"compare", run, "--out", (desk.folder.path() / "link.md").string()})
            .exit_code == 8);
}

TEST_CASE("an output that exists is refused before the work begins") {
  const Desk desk(false);
  const fs::path table = desk.precious("table.md");
  const std::string none = (desk.folder.path() / "no-run").string();
  const Finished refused = tolman::test::tolman({"compare", none, "--out", table.string()});
  CHECK(refused.exit_code == 8);
  CHECK(contains(refused.err, "table.md: exists"));
}
