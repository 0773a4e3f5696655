// SPDX-License-Identifier: BSD-3-Clause
// The revision that a program names is that of the sources at the time of the build.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// A repository with one file, and the header that the build writes of it.
struct BuiltSources {
  TemporaryFolder folder;
  fs::path header = folder.path() / "build_info.hpp";
  fs::path tree = folder.path() / "tree";

  std::string shell(const std::string& commands) const {
    const Finished finished = run({"sh", "-ec", "cd '" + tree.string() + "'\n" + commands});
    INFO(finished.err);
    REQUIRE(finished.exit_code == 0);
    return finished.out;
  }
  void commit(const std::string& text) const {
    shell("echo '" + text +
          "' > file && git add file && git -c user.name=n -c user.email=e commit -qm " + text);
  }
  void build() const {
    const Finished finished =
        run({TOLMAN_CMAKE, "-DSOURCE=" + tree.string(), "-DOUTPUT=" + header.string(),
             "-DINPUT=" + inSource("framework/engine/build_info.hpp.in"), "-P",
             inSource("framework/engine/write_build_info.cmake")});
    INFO(finished.err);
    REQUIRE(finished.exit_code == 0);
  }
  bool names(const std::string& revision) const {
    return contains(readText(header), "kRevision = \"" + revision + "\"");
  }
  std::string head() const {
    const std::string text = shell("git rev-parse --short=12 HEAD");
    return text.substr(0, text.find('\n'));
  }
};

}  // namespace

TEST_CASE("a build after a commit names that commit, and changed sources are told") {
  const BuiltSources sources;
  fs::create_directory(sources.tree);
  sources.shell("git init -q");
  sources.commit("first");
  sources.build();
  const std::string first = sources.head();
  CHECK(sources.names(first));

  const auto written = fs::last_write_time(sources.header);
  sources.build();
  CHECK(fs::last_write_time(sources.header) == written);  // nothing is compiled again

  sources.shell("echo changed > file");
  sources.build();
  CHECK(sources.names(first + "-dirty"));

  sources.commit("second");
  sources.build();
  CHECK(sources.head() != first);
  CHECK(sources.names(sources.head()));
}

TEST_CASE("sources that are in no repository have an unknown revision") {
  const BuiltSources sources;
  fs::create_directory(sources.tree);
  sources.build();
  CHECK(sources.names("unknown"));
}
