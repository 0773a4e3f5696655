// SPDX-License-Identifier: BSD-3-Clause
#include "file_tree.hpp"

#include <algorithm>
#include <opencv2/core.hpp>

#include "base/number_text.hpp"
#include "base/text_file.hpp"

#pragma GCC visibility push(default)  // of its exceptions, which the library throws
#include <yaml-cpp/yaml.h>
#pragma GCC visibility pop

namespace tolman::camera_files {
namespace {

using text_encoding::inQuotes;

constexpr int kDeepest = 16;  // levels; an alias in YAML may contain itself

Node treeOf(const YAML::Node& yaml, int depth) {
  Node node;
  node.line = yaml.Mark().line + 1;
  if (depth > kDeepest) throw FileError(node.line, "is nested too deeply; it is no calibration");
  if (yaml.IsScalar()) node.text = yaml.Scalar();
  if (yaml.IsSequence()) node.kind = Node::Kind::List;
  if (yaml.IsMap()) node.kind = Node::Kind::Map;
  for (const auto& entry : yaml) {
    const bool in_map = node.kind == Node::Kind::Map;
    node.children.push_back(treeOf(in_map ? entry.second : entry, depth + 1));
    if (!in_map) continue;
    node.children.back().key = entry.first.Scalar();
    node.children.back().line = entry.first.Mark().line + 1;
  }
  return node;
}

Node treeOf(const cv::FileNode& xml) {
  Node node;
  if (xml.isString()) node.text = xml.string();
  if (xml.isInt() || xml.isReal()) node.text = text_encoding::rounded(xml.real(), 17);
  if (!xml.isSeq() && !xml.isMap()) return node;
  node.kind = xml.isMap() ? Node::Kind::Map : Node::Kind::List;
  for (const cv::FileNode& child : xml) {
    node.children.push_back(treeOf(child));
    if (xml.isMap()) node.children.back().key = child.name();
  }
  return node;
}

void appendNumbers(const Node& node, std::vector<double>& numbers) {
  for (const Node& child : node.children) appendNumbers(child, numbers);
  if (node.kind != Node::Kind::Value || node.text.empty()) return;
  const std::optional<double> number = text_encoding::parseNumber(node.text);
  if (!number) {
    throw FileError(node.line, inQuotes(node.text) + " " +
                                   std::string(text_encoding::numberProblem(node.text)) +
                                   "; correct it");
  }
  numbers.push_back(*number);
}

}  // namespace

const Node* Node::find(std::initializer_list<std::string_view> names) const {
  const Node* found = nullptr;
  for (const Node& child : children) {
    if (std::find(names.begin(), names.end(), child.key) == names.end()) continue;
    if (found != nullptr) {
      const std::string what = child.key == found->key
                                   ? " is given twice, first in line "
                                   : " means the same as " + inQuotes(found->key) + " in line ";
      throw FileError(child.line, inQuotes(child.key) + what + std::to_string(found->line) +
                                      "; remove one of the two");
    }
    found = &child;
  }
  return found;
}

const Node& Node::need(std::initializer_list<std::string_view> names) const {
  const Node* found = find(names);
  if (found != nullptr) return *found;
  throw FileError(line, "has no " + inQuotes(*names.begin()) + "; add it");
}

std::vector<double> Node::numbers() const {
  const Node* data = find({"data"});
  std::vector<double> numbers;
  appendNumbers(data == nullptr ? *this : *data, numbers);
  return numbers;
}

std::vector<double> Node::numbers(std::size_t count) const {
  std::vector<double> all = numbers();
  if (all.size() == count) return all;
  throw FileError(line, inQuotes(key) + " has " + std::to_string(all.size()) +
                            " numbers instead of " + std::to_string(count));
}

Node parseYaml(const std::string& text) {
  try {
    Node node = treeOf(YAML::Load(text), 0);
    node.line = 0;
    return node;
  } catch (const YAML::Exception& error) {
    throw FileError(error.mark.line + 1, "is no YAML (" + error.msg + "); correct it");
  }
}

Node parseXml(const std::string& text) {
  try {
    constexpr int kMode =
        cv::FileStorage::READ | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_XML;
    return treeOf(cv::FileStorage(text, kMode).root());
  } catch (const cv::Exception& error) {
    throw FileError(0, "is no XML that OpenCV can read (" + error.err + "); correct it");
  }
}

}  // namespace tolman::camera_files
