// SPDX-License-Identifier: BSD-3-Clause
// The commands of docs/your-camera.md, on a raw recording.
#include <catch2/catch.hpp>
#include <fstream>

#include "author/markdown_script.hpp"
#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;

TEST_CASE("the page leads from a raw pair of EuRoC to a map and to a KITTI folder", "[data]") {
  const auto recording = dataOrSkip("euroc_v101");
  if (!recording) return;
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "page.sh")
      << "set -e\ncd " << folder.path() << "\nexport REC=" << *recording << "\n"
      << scriptOf(readText(inSource("docs/your-camera.md")));
  const std::string path = tolmanProgram().parent_path().string();
  const Finished page = run({"/usr/bin/env", "PATH=" + path + ":/usr/bin:/bin", "bash",
                             (folder.path() / "page.sh").string()});
  INFO(page.out << page.err);
  REQUIRE(page.exit_code == 0);
  CHECK(contains(page.out, "2 radial_tangential cameras of 752x480 px, rectified to"));
  CHECK(contains(page.out, "90 % of the rows are within"));
  const auto run_file = readJson(folder.path() / "mine_run/run.json");
  CHECK(run_file["source"]["raw_cameras"].size() == 2);
  CHECK(run_file["source"]["raw_cameras"][0]["pinhole.fx"] == 458.654);
  CHECK(run_file["source"]["width"] > 752);  // the corners of the distorted images reach far
  CHECK(run_file["counters"]["frames"] == 10);
  CHECK(run_file["counters"]["lost"] == 0);
  std::ifstream times(folder.path() / "mine_kitti/times.txt");
  std::string first;
  std::getline(times, first);
  CHECK(first == "1403715273.262142976");
}
