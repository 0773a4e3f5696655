// SPDX-License-Identifier: BSD-3-Clause
#include "app/source_overrides.hpp"

#include <catch2/catch.hpp>

namespace tolman::app {
namespace {

using Texts = std::vector<std::string>;

std::string problemsOf(const Texts& host) {
  config::Problems problems;
  (void)imageHandling(host, problems);
  return config::format(problems);
}

}  // namespace

TEST_CASE("keys of the host are told from parameters of the source") {
  const SourceOverrides split =
      splitOverrides({"first=3", "images.scale=0.5", "rectification.mode=off", "images={scale: 1}",
                      "images_folder=a", "path=images.png"});
  CHECK(split.host == Texts{"images.scale=0.5", "rectification.mode=off", "images={scale: 1}"});
  CHECK(split.source == Texts{"first=3", "images_folder=a", "path=images.png"});
}

TEST_CASE("what the host does to images, by its keys") {
  config::Problems problems;
  const ImageHandling nothing = imageHandling({}, problems);
  CHECK(nothing.images.scale == 1);
  CHECK(nothing.images.crop.empty());
  CHECK(nothing.rectification.mode == config::RectificationMode::Auto);
  const ImageHandling set = imageHandling(
      {"images.scale=0.5", "images.crop=[8, 0, 96, 60]", "rectification.mode=off"}, problems);
  CHECK(problems.empty());
  CHECK(set.images.scale == 0.5);
  CHECK(set.images.crop == std::vector<double>{8, 0, 96, 60});
  CHECK(set.rectification.mode == config::RectificationMode::Off);
}

TEST_CASE("wrong keys and values of the host are told as in a configuration") {
  CHECK(problemsOf({"images.scale=2"}).find("images.scale") != std::string::npos);
  CHECK(problemsOf({"images.size=2"}).find("images.size") != std::string::npos);
  CHECK(problemsOf({"images=2"}).find("images") != std::string::npos);
  CHECK(problemsOf({"rectification.mode=on"}).find("auto, off") != std::string::npos);
}

}  // namespace tolman::app
