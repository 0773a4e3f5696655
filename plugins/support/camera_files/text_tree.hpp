// SPDX-License-Identifier: BSD-3-Clause
// A tree of maps, lists and values with their line numbers, read from the subset of YAML and XML
// that calibration files use. The depth of nesting is limited.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tolman::camera_files {

/// An error in a file, at a line (0: the whole file), with the remedy.
struct FileError : std::runtime_error {
  FileError(int at, const std::string& what) : std::runtime_error(what), line(at) {}
  int line;
};

struct Node {
  enum class Kind : unsigned char { Value, List, Map };
  Kind kind = Kind::Value;
  int line = 0;      ///< of its key in a map, else of itself; 0: the whole file
  std::string key;   ///< its key in a map
  std::string text;  ///< of a value
  std::vector<Node> children;

  /// The child with one of these names, which are synonyms; null if there is none. Throws FileError
  /// if there are two.
  const Node* find(std::initializer_list<std::string_view> names) const;
  /// All numbers of this node and its children, in order; a value may contain several, separated by
  /// blanks or commas. Throws FileError for any other text.
  std::vector<double> numbers() const;
  /// Throws FileError unless it is one number.
  double number() const;
  /// Throws FileError if a key of the map is empty or repeated.
  void checkKeys() const;
};

inline constexpr int kDeepest = 16;  // levels; bounds the recursion

/// YAML: maps and lists as blocks or in brackets, plain and quoted values, comments, tags and
/// directives (ignored). Throws FileError, also for a key that is given twice in one map.
Node parseYaml(std::string_view text);

/// The XML of cv::FileStorage: elements without mixed content, attributes ignored; elements of one
/// name only in its sequences, whose elements are named "_". Throws FileError.
Node parseXml(std::string_view text);

/// The error for a key at `line` that was already given at `first_line`.
FileError givenTwice(int line, std::string_view key, int first_line);

/// The text in quotes for a message, shortened and made printable.
std::string inQuotes(std::string_view text);

/// A number for a message, with four digits.
std::string shortNumber(double value);

}  // namespace tolman::camera_files
