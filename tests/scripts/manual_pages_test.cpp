// SPDX-License-Identifier: BSD-3-Clause
// The tree of commands and the manual pages: every command and option has a text and is in its
// page.
#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <set>

#include "end_to_end/process.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

Json helpTree() {
  const Finished tree = tolman::test::tolman({"help-tree"});
  REQUIRE(tree.exit_code == 0);
  return Json::parse(tree.out);
}

void forEach(const Json& command, const std::function<void(const Json&)>& visit) {
  visit(command);
  for (const Json& child : command["commands"]) forEach(child, visit);
}

fs::path pageOf(const Json& command) {
  std::string name = command["words"];
  for (char& c : name) c = c == ' ' ? '-' : c;
  return inBuild("help/man/man1/" + name + ".1");
}

/// The page without the escapes of roff.
std::string plainPage(const fs::path& file) {
  std::string text;
  const std::string page = readText(file);
  for (std::size_t i = 0; i < page.size(); ++i) {
    if (page[i] != '\\') {
      text += page[i];
    } else if (page.compare(i, 2, "\\-") == 0) {
      text += page[++i];
    } else if (page.compare(i, 2, "\\f") == 0) {
      i += 2;
    } else if (page.compare(i, 4, "\\(ti") == 0) {
      text += '~';
      i += 3;
    }
  }
  return text;
}

const Json& named(const Json& list, const std::string& name) {
  for (const Json& one : list) {
    if (one["name"] == name) return one;
  }
  FAIL(name << " is not there");
  return list;
}

}  // namespace

TEST_CASE("every command and option has a text, and every value of a known kind its choices") {
  std::set<std::string> kinds;
  forEach(helpTree()["command"], [&](const Json& command) {
    INFO(command["words"]);
    CHECK_FALSE(command["text"].get<std::string>().empty());
    for (const char* part : {"options", "positionals"}) {
      for (const Json& option : command[part]) {
        INFO(option);
        CHECK_FALSE(option["text"].get<std::string>().empty());
        if (!option.contains("kind")) continue;
        kinds.insert(option["kind"].get<std::string>());
        CHECK((option["kind"] == "choice") == option.contains("choices"));
        CHECK(option["value"] != "TEXT");  // says nothing
      }
    }
  });
  CHECK(kinds == std::set<std::string>{"", "choice", "command", "configuration", "directory",
                                       "file", "plugin", "plugin observer", "plugin source",
                                       "setting"});
}

TEST_CASE("the tree is that of the help, without what is hidden there") {
  const Json tree = helpTree()["command"];
  const std::string help = tolman::test::tolman({"--help"}).out;
  for (const Json& command : tree["commands"]) {
    CHECK(contains(help, command["text"].get<std::string>()));
    CHECK(command["name"] != "run-stage");
    CHECK(command["name"] != "help-tree");
  }
  const Json align = [&] {
    for (const Json& option : named(tree["commands"], "eval")["options"]) {
      if (option["names"][0] == "--align") return option;
    }
    return Json();
  }();
  CHECK(align["choices"] == Json{"none", "se2", "se3", "sim3"});
  const Json fresh = named(named(tree["commands"], "plugins")["commands"], "new");
  CHECK(fresh["words"] == "tolman plugins new");
  CHECK(named(fresh["positionals"], "role")["choices"].size() == 6);
  CHECK(fresh["examples"][0]["command"] == "tolman plugins new place my_places");
}

TEST_CASE("each command has a page with all its options") {
  std::size_t pages = 0;
  forEach(helpTree()["command"], [&](const Json& command) {
    const std::string page = plainPage(pageOf(command));
    INFO(pageOf(command));
    CHECK(contains(page, command["words"].get<std::string>()));
    for (const Json& option : command["options"]) {
      for (const Json& name : option["names"]) CHECK(contains(page, name.get<std::string>()));
      CHECK(contains(page, option["text"].get<std::string>()));
    }
    for (const Json& part : command["positionals"]) {
      CHECK(contains(page, part["text"].get<std::string>()));
    }
    for (const Json& example : command["examples"]) {
      CHECK(contains(page, example["command"].get<std::string>()));
    }
    CHECK(contains(page, "--plugin-path"));  // an option of all commands
    CHECK(contains(page, "EXIT STATUS"));
    ++pages;
  });
  const auto files = fs::directory_iterator(inBuild("help/man/man1"));
  CHECK(static_cast<std::size_t>(std::distance(begin(files), end(files))) == pages);
}

TEST_CASE("man shows the pages and finds nothing wrong with them") {
  if (run({"man", "--version"}).exit_code != 0) {
    std::cout << "SKIPPED: man is not installed\n";
    return;
  }
  for (const auto& file : fs::directory_iterator(inBuild("help/man/man1"))) {
    const Finished shown = run({"env", "LC_ALL=C.UTF-8", "MANWIDTH=80", "man", "--warnings", "-E",
                                "UTF-8", "-l", file.path().string()});
    INFO(file.path());
    CHECK(shown.exit_code == 0);
    CHECK(shown.err.empty());
    CHECK(contains(shown.out, "SYNOPSIS"));
  }
}
