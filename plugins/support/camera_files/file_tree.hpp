// SPDX-License-Identifier: BSD-3-Clause
// A YAML or XML file as a tree of maps, lists and values with their line numbers.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tolman::camera_files {

/// An error at a line (0: the whole file), with the remedy.
struct FileError : std::runtime_error {
  FileError(int at, const std::string& what) : std::runtime_error(what), line(at) {}
  int line;
};

struct Node {
  enum class Kind : unsigned char { Value, List, Map };
  Kind kind = Kind::Value;
  int line = 0;      ///< of its key in a map, else of itself; 0: unknown, as in XML
  std::string key;   ///< its key in a map
  std::string text;  ///< of a value
  std::vector<Node> children;

  /// The child with one of these names, which are synonyms; null if there is none. Throws FileError
  /// if there are two.
  const Node* find(std::initializer_list<std::string_view> names) const;
  /// The same; throws FileError if there is none.
  const Node& need(std::initializer_list<std::string_view> names) const;
  /// All numbers of this node and its children, in order; of a matrix with rows, cols and data
  /// those of its data. Throws FileError for any other text.
  std::vector<double> numbers() const;
  /// Throws FileError unless it has `count` numbers.
  std::vector<double> numbers(std::size_t count) const;
};

/// By yaml-cpp. Throws FileError.
Node parseYaml(const std::string& text);

/// By cv::FileStorage, whose format of XML it must be. Throws FileError.
Node parseXml(const std::string& text);

}  // namespace tolman::camera_files
