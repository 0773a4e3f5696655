// SPDX-License-Identifier: BSD-3-Clause
// The site opened from the disk: its search must be a script that the pages load.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// As the theme builds one: a page, one in a folder, the index and the worker.
struct Site {
  TemporaryFolder folder;

  Site() {
    write("index.html", page(""));
    write("below/page.html", page("../"));
    write("assets/javascripts/bundle.1.min.js", "");
    write("assets/javascripts/workers/search.1.min.js",
          "work();\n//# sourceMappingURL=search.1.min.js.map\n");
    write("search/search_index.json",
          R"({"config": {"lang": ["en"]}, "docs": [{"text": "Loop"}]})");
  }
  static std::string page(const std::string& up) {
    return "<div data-md-component=\"search\"></div><script src=\"" + up +
           "assets/javascripts/bundle.1.min.js\"></script>";
  }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder.path() / name).parent_path());
    std::ofstream(folder.path() / name) << text;
  }
  std::string read(const std::string& name) const { return readText(folder.path() / name); }
  Finished script(const std::string& name) const {
    return run({inSource("scripts/" + name), folder.path().string()});
  }
};

}  // namespace

TEST_CASE("a search box that needs a server is a fault") {
  const Site site;
  const Finished before = site.script("check-site");
  CHECK(before.exit_code == 1);
  CHECK(before.err ==
        "check-site: below/page.html: its search box does not work without a server\n"
        "check-site: index.html: its search box does not work without a server\n");
  REQUIRE(site.script("site-search").exit_code == 0);
  const Finished after = site.script("check-site");
  INFO(after.err);
  CHECK(after.exit_code == 0);
}

TEST_CASE("index and worker become one script, loaded before the theme's") {
  const Site site;
  const Finished made = site.script("site-search");
  INFO(made.err);
  REQUIRE(made.exit_code == 0);
  CHECK(contains(site.read("below/page.html"),
                 "<script src=\"../search/offline.js\"></script>"
                 "<script src=\"../assets/javascripts/bundle."));
  const std::string script = site.read("search/offline.js");
  CHECK(contains(script, R"("docs": [{"text": "Loop"}])"));
  CHECK(contains(script, R"(new Blob(["work();\n"])"));
}

TEST_CASE("what would need more files is refused") {
  const Site site;
  site.write("search/search_index.json", R"({"config": {"lang": ["en", "de"]}, "docs": []})");
  CHECK(contains(site.script("site-search").err, "other languages than English"));
  fs::remove_all(site.folder.path() / "assets/javascripts/workers");
  CHECK(contains(site.script("site-search").err, "0 workers"));
}
