// SPDX-License-Identifier: BSD-3-Clause
// Resolution of paths in a configuration.
#include <catch2/catch.hpp>

#include "config/values.hpp"

namespace tolman {

TEST_CASE("Paths become absolute and normal, relative to their origin") {
  const config::BaseFolders folders{"/start", "/home/ada"};
  const config::Origin file = config::Origin::ofFile("configs/deep/a.yaml");
  const config::Origin far = config::Origin::ofFile("/etc/tolman/a.yaml");
  const config::Origin line{config::Origin::Kind::CommandLine, "--set x=y", 0, 0, {}};
  const auto resolve = [&](const char* path, const config::Origin& origin) {
    return config::resolvePath(path, origin, folders).value();
  };
  CHECK(resolve("data", file) == "/start/configs/deep/data");
  CHECK(resolve("../../data/./06/", file) == "/start/data/06");
  CHECK(resolve("data", far) == "/etc/tolman/data");
  CHECK(resolve("data", line) == "/start/data");
  CHECK(resolve("/abs/../x", file) == "/x");
  CHECK(resolve("~", line) == "/home/ada");
  CHECK(resolve("~/kitti/06", file) == "/home/ada/kitti/06");
  CHECK(resolve("a~/b", line) == "/start/a~/b");
  CHECK(resolve("/", line) == "/");
  CHECK(resolve("", file).empty());
}

TEST_CASE("Unknown home folders are refused") {
  const auto unset = config::resolvePath("~/x", {}, {"/start", ""});
  CHECK(unset.status().message() == "'~' needs HOME, which is not set");
  const auto other = config::resolvePath("~bob/x", {}, {"/start", "/home/ada"});
  CHECK(other.status().message() ==
        "'~bob/x': only '~/' is supported, not the home of another user");
}

}  // namespace tolman
