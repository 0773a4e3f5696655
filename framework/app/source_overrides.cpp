// SPDX-License-Identifier: BSD-3-Clause
#include "app/source_overrides.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>

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

void refuseTwoValues(const std::vector<std::string>& overrides) {
  std::map<std::string, std::string> values;
  for (const std::string& one : overrides) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos) continue;  // reported with its position when it is parsed
    const std::string key = one.substr(0, equals);
    const std::string value = one.substr(equals + 1);
    const auto [before, is_new] = values.emplace(key, value);
    if (is_new || before->second == value) continue;
    throw CLI::ValidationError("--set " + key, "is given twice, as '" + before->second +
                                                   "' and as '" + value + "'; give it once");
  }
}

SourceOverrides splitOverrides(const std::vector<std::string>& overrides) {
  refuseTwoValues(overrides);
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
