// SPDX-License-Identifier: BSD-3-Clause
#include "text_tree.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "base/number_text.hpp"

namespace tolman::camera_files {
namespace {

constexpr std::string_view kSeparators = " \t\r\n,";

void appendNumbers(const Node& node, std::vector<double>& numbers) {
  for (const Node& child : node.children) appendNumbers(child, numbers);
  std::string_view rest = node.text;
  while (true) {
    const std::size_t begin = rest.find_first_not_of(kSeparators);
    if (begin == std::string_view::npos) return;
    rest.remove_prefix(begin);
    std::string_view field = rest.substr(0, rest.find_first_of(kSeparators));
    rest.remove_prefix(field.size());
    const std::optional<double> number = text_encoding::parseNumber(field);
    if (!number) {
      throw FileError(node.line, inQuotes(field) + " " +
                                     std::string(text_encoding::numberProblem(field)) +
                                     "; correct it");
    }
    numbers.push_back(*number);
  }
}

}  // namespace

const Node* Node::find(std::initializer_list<std::string_view> names) const {
  if (kind != Kind::Map) return nullptr;
  const auto named = [&](const Node& child) {
    return std::find(names.begin(), names.end(), child.key) != names.end();
  };
  const auto found = std::find_if(children.begin(), children.end(), named);
  if (found == children.end()) return nullptr;
  const auto second = std::find_if(found + 1, children.end(), named);
  if (second == children.end()) return &*found;
  throw FileError(second->line, inQuotes(second->key) + " means the same as " +
                                    inQuotes(found->key) + " in line " +
                                    std::to_string(found->line) + "; remove one of the two");
}

void Node::checkKeys() const {
  if (kind != Kind::Map) return;
  std::map<std::string_view, int> lines;
  for (const Node& child : children) {
    if (child.key.empty()) throw FileError(child.line, "a key is empty; name it");
    const auto [first, is_new] = lines.emplace(child.key, child.line);
    if (!is_new) throw givenTwice(child.line, child.key, first->second);
  }
}

std::vector<double> Node::numbers() const {
  std::vector<double> numbers;
  appendNumbers(*this, numbers);
  return numbers;
}

double Node::number() const {
  const std::vector<double> all = numbers();
  if (all.size() != 1) throw FileError(line, inQuotes(key) + " must be one number");
  return all.front();
}

FileError givenTwice(int line, std::string_view key, int first_line) {
  return {line, inQuotes(key) + " is given twice, first in line " + std::to_string(first_line) +
                    "; remove one of the two"};
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kMax = 24;  // characters of a message
  std::string quoted = "'";
  for (const char c : text.substr(0, kMax)) quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (text.size() > kMax ? "...'" : "'");
}

std::string shortNumber(double value) {
  char text[32];
  const int size = std::snprintf(text, sizeof text, "%.4g", value + 0.0);  // never -0
  return {text, static_cast<std::size_t>(std::clamp(size, 0, 31))};
}

}  // namespace tolman::camera_files
