// SPDX-License-Identifier: BSD-3-Clause
// A file of nested names, lists and values, with the lines that they stand on. Made from the parts
// of YAML and XML that calibration files consist of; nesting is limited.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tolman::camera_files {

/// What is wrong in a file, at a line (0: in no particular one), with the remedy.
struct FileError : std::runtime_error {
  FileError(int at, const std::string& what) : std::runtime_error(what), line(at) {}
  int line;
};

struct Node {
  enum class Kind : unsigned char { Value, List, Map };
  Kind kind = Kind::Value;
  int line = 0;
  std::string key;   ///< its name in a map
  std::string text;  ///< of a value
  std::vector<Node> children;

  /// The first child of one of these names; null where there is none.
  const Node* find(std::initializer_list<std::string_view> names) const;
  /// All numbers below, in their order; a value may hold several, between blanks or commas. Throws
  /// FileError where there is something else.
  std::vector<double> numbers() const;
  /// Throws FileError unless it is one number.
  double number() const;
};

inline constexpr int kDeepest = 16;  // levels

/// YAML: maps and lists as blocks or in brackets, plain and quoted values, comments, tags and
/// directives (ignored). Throws FileError.
Node parseYaml(std::string_view text);

/// The XML of cv::FileStorage: elements without mixed content, attributes ignored. Throws
/// FileError.
Node parseXml(std::string_view text);

/// Short and printable, in quotes, for a message.
std::string inQuotes(std::string_view text);

}  // namespace tolman::camera_files
