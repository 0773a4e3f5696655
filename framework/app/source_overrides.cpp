// SPDX-License-Identifier: BSD-3-Clause
#include "app/source_overrides.hpp"

#include <filesystem>

#include "config/check.hpp"
#include "config/overrides.hpp"

namespace tolman::app {
namespace {

constexpr const char* kImages = "images";
constexpr const char* kRectification = "rectification";

bool isBelow(const std::string& override, const std::string& key) {
  return override.starts_with(key + ".") || override.starts_with(key + "=");
}

template <class S>
S section(const config::Node& tree, const std::string& key, config::Problems& problems) {
  const config::Node none{config::Node::Kind::Map};
  const config::Node* given = tree.find(key);
  const config::BaseFolders folders{std::filesystem::current_path(), ""};
  return bindParameters<S>(config::check(given == nullptr ? none : *given, schemaOf<S>(),
                                         {key, "", {}}, folders, problems))
      .value();
}

}  // namespace

SourceOverrides splitOverrides(const std::vector<std::string>& overrides) {
  SourceOverrides split;
  for (const std::string& override : overrides) {
    const bool of_host = isBelow(override, kImages) || isBelow(override, kRectification);
    (of_host ? split.host : split.source).push_back(override);
  }
  return split;
}

ImageHandling imageHandling(const std::vector<std::string>& host_overrides,
                            config::Problems& problems) {
  config::Node tree{config::Node::Kind::Map};
  config::applyOverrides(tree, host_overrides, config::processEnvironment(), problems);
  return {section<config::RectificationSettings>(tree, kRectification, problems),
          section<config::ImageSettings>(tree, kImages, problems)};
}

}  // namespace tolman::app
