// SPDX-License-Identifier: BSD-3-Clause
// Origins and problems as text.
#include "config/problem.hpp"

#include <algorithm>
#include <tuple>

namespace tolman::config {

std::string text(const Origin& origin) {
  if (origin.kind == Origin::Kind::Default) return "default";
  if (origin.line == 0) return origin.file;
  return origin.file + ':' + std::to_string(origin.line) + ':' + std::to_string(origin.column);
}

namespace {

/// A long message, such as one that quotes a whole file, without its middle.
std::string shortened(const std::string& message) {
  constexpr std::size_t kMax = 2000;  // lists of keys are shorter
  constexpr std::size_t kEnd = 200;
  if (message.size() <= kMax) return message;
  return message.substr(0, kEnd) + " ... " + message.substr(message.size() - kEnd);
}

}  // namespace

std::string format(const Problem& problem) {
  std::string line = text(problem.where) + ": ";
  if (!problem.key_path.empty()) line += problem.key_path + ": ";
  return line + shortened(problem.message);
}

std::string format(Problems problems) {
  const auto position = [](const Problem& p) {
    return std::tie(p.where.kind, p.where.file, p.where.line, p.where.column);
  };
  std::ranges::stable_sort(problems, {}, position);
  std::string lines;
  for (const Problem& problem : problems) lines += format(problem) + '\n';
  return lines;
}

}  // namespace tolman::config
