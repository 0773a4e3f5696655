// SPDX-License-Identifier: BSD-3-Clause
// extends: which layer takes precedence, and that every value keeps its place of origin.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "config/toy_system.hpp"
#include "support/data.hpp"

namespace tolman {
namespace {

std::string valueAt(const config::Node& tree, std::initializer_list<const char*> path) {
  const config::Node* node = &tree;
  for (const char* key : path) node = node != nullptr ? node->find(key) : nullptr;
  if (node == nullptr) return "absent";
  return node->text + " @ " + test::withoutFolder(config::text(node->origin));
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("Later layers override earlier ones key by key; lists are replaced") {
  const auto loaded =
      config::load(test::fixtures() + "layers/top.yaml", {}, test::environmentOf({}));
  REQUIRE(loaded.problems.empty());
  const config::Node& tree = loaded.tree;
  CHECK(valueAt(tree, {"name"}) == "top @ layers/top.yaml:2:7");
  CHECK(valueAt(tree, {"seed"}) == "2 @ layers/night.yaml:1:7");
  CHECK(valueAt(tree, {"source", "path"}) == "../there @ layers/top.yaml:4:9");
  CHECK(valueAt(tree, {"source", "first"}) == "1 @ layers/base.yaml:3:49");
  CHECK(valueAt(tree, {"odometry", "scale"}) == "3 @ layers/night.yaml:3:10");
  CHECK(valueAt(tree, {"odometry", "active_points"}) == "1000 @ layers/base.yaml:4:49");
  REQUIRE(tree.find("observers")->children.size() == 2);
  CHECK(valueAt(tree, {"observers", "1", "name"}) == "b @ layers/night.yaml:4:75");
  CHECK(tree.find("extends") == nullptr);
}

TEST_CASE("A relative path refers to the folder of its file") {
  const test::CheckedSystem top = test::checkSystem("layers/top.yaml");
  CHECK(std::get<std::string>(top.of("source").at("path")) == test::fixtures() + "there");
  const test::CheckedSystem base = test::checkSystem("layers/base.yaml");
  CHECK(std::get<std::string>(base.of("source").at("path")) == test::fixtures() + "layers/here");
}

TEST_CASE("A layer with another plugin removes the parameters of the old one") {
  const test::CheckedSystem swapped = test::checkSystem("layers/swapped.yaml");
  const config::Node& odometry = *swapped.loaded.tree.find("odometry");
  CHECK(valueAt(odometry, {"plugin"}) == "toy_place @ layers/swapped.yaml:2:20");
  CHECK(odometry.children.size() == 1);
  CHECK(swapped.complaints().find("unknown parameter") == std::string::npos);
}

TEST_CASE("A file may be extended twice on different paths, but not by itself") {
  const test::TemporaryFolder folder;
  write(folder.path() / "root.yaml", "seed: 1\n");
  write(folder.path() / "left.yaml", "extends: root.yaml\nthreads: 2\n");
  write(folder.path() / "right.yaml", "extends: root.yaml\nseed: 3\n");
  write(folder.path() / "diamond.yaml", "extends: [left.yaml, right.yaml]\n");
  const auto load = [&](const std::string& name) {
    return config::load(folder.path() / name, {}, test::environmentOf({}));
  };
  const auto diamond = load("diamond.yaml");
  CHECK(diamond.problems.empty());
  CHECK(diamond.tree.find("seed")->text == "3");
  CHECK(diamond.tree.find("threads")->text == "2");

  write(folder.path() / "itself.yaml", "extends: ./itself.yaml\n");
  REQUIRE(load("itself.yaml").problems.size() == 1);
  CHECK(load("itself.yaml").problems[0].message.starts_with("circular: "));
}

TEST_CASE("extends takes a shipped configuration by its name where there is no such file") {
  const test::TemporaryFolder folder;
  const std::filesystem::path shipped = folder.path() / "shipped";
  std::filesystem::create_directories(shipped);
  std::filesystem::create_directories(folder.path() / "mine/demo");  // a folder is no configuration
  write(shipped / "demo.yaml", "seed: 1\nthreads: 1\n");
  write(folder.path() / "mine/a.yaml", "extends: demo\nthreads: 2\n");
  const auto load = [&](const std::string& name, const config::FindShipped& find) {
    return config::load(folder.path() / "mine" / name, {}, test::environmentOf({}), find);
  };
  const auto find = [&](const std::string& name) {
    const std::filesystem::path file = shipped / (name + ".yaml");
    return std::filesystem::exists(file) ? file : std::filesystem::path();
  };
  const auto found = load("a.yaml", find);
  CHECK(found.problems.empty());
  CHECK(found.tree.find("seed")->text == "1");
  CHECK(found.tree.find("threads")->text == "2");
  CHECK(found.tree.find("seed")->origin.file == (shipped / "demo.yaml").string());
  CHECK(load("a.yaml", {}).problems.size() == 1);

  write(folder.path() / "mine/b.yaml", "extends: absent\n");
  REQUIRE(load("b.yaml", find).problems.size() == 1);
  write(folder.path() / "mine/absent", "seed: 4\n");  // a file is preferred
  CHECK(load("b.yaml", find).tree.find("seed")->text == "4");
}

TEST_CASE("extends accepts variables and ~, and refuses values that are not file names") {
  const test::TemporaryFolder folder;
  write(folder.path() / "base.yaml", "seed: 5\n");
  write(folder.path() / "a.yaml", "extends: ~/base.yaml\n");
  write(folder.path() / "b.yaml", "extends: ${WHERE}/base.yaml\n");
  write(folder.path() / "c.yaml", "extends: {file: base.yaml}\n");
  write(folder.path() / "d.yaml", "extends: [[base.yaml], ]\n");
  const auto load = [&](const std::string& name) {
    const std::string here = folder.path().string();
    return config::load(folder.path() / name, {},
                        test::environmentOf({{"HOME", here}, {"WHERE", here}}));
  };
  CHECK(load("a.yaml").tree.find("seed")->text == "5");
  CHECK(load("b.yaml").tree.find("seed")->text == "5");
  REQUIRE(load("c.yaml").problems.size() == 1);
  CHECK(load("c.yaml").problems[0].message == "expects a file or a list of files, not a map");
  REQUIRE(load("d.yaml").problems.size() == 1);
  CHECK(load("d.yaml").problems[0].message == "expects a file, not a list");
}

TEST_CASE("A file of more than 1 MiB is refused without reading it") {
  const test::TemporaryFolder folder;
  write(folder.path() / "large.yaml", "seed: 1\n" + std::string((1U << 20U) + 1, '#'));
  const auto loaded = config::load(folder.path() / "large.yaml", {}, test::environmentOf({}));
  REQUIRE(loaded.problems.size() == 1);
  CHECK(loaded.problems[0].message == "larger than 1 MiB; not a configuration?");
}

}  // namespace tolman
