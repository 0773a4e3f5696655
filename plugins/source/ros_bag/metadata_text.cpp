// SPDX-License-Identifier: BSD-3-Clause
#include "metadata_text.hpp"

#include <charconv>
#include <sstream>
#include <string_view>

namespace tolman::ros_bag {
namespace {

constexpr std::string_view kRoot = "rosbag2_bagfile_information";
constexpr std::string_view kTopics = "topics_with_message_count";

std::string_view trimmed(std::string_view text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  const bool quoted = text.size() >= 2 && text.front() == text.back() &&
                      (text.front() == '"' || text.front() == '\'');
  return quoted ? text.substr(1, text.size() - 2) : text;
}

std::optional<std::int64_t> countOf(std::string_view digits) {
  std::int64_t count = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (error != std::errc() || end != digits.data() + digits.size() || count < 0) {
    return std::nullopt;
  }
  return count;
}

/// One line: "  - key: value", or an entry without a key.
struct Line {
  std::size_t indent = 0;
  bool is_entry = false;  ///< the first line of a list's entry
  std::string_view key;   ///< empty without one
  std::string_view value;
};

Line parseLine(std::string_view text) {
  Line line;
  line.indent = text.find_first_not_of(' ');
  if (line.indent == std::string_view::npos) return {};
  text.remove_prefix(line.indent);
  line.is_entry = text.starts_with("- ");
  text = trimmed(line.is_entry ? text.substr(2) : text);
  const std::size_t colon = text.find(": ");
  if (text.ends_with(':')) {
    line.key = text.substr(0, text.size() - 1);
  } else if (colon != std::string_view::npos) {
    line.key = text.substr(0, colon);
    line.value = trimmed(text.substr(colon + 2));
  } else {
    line.value = text;
  }
  return line;
}

/// Collects the lines of the sections below the root.
class Sections {
 public:
  void add(const Line& line) {
    if (line.key == kRoot || (line.key.empty() && line.value.empty())) return;
    const bool is_section = !line.is_entry && (!indent_ || line.indent <= *indent_);
    if (is_section) {
      endEntry();
      indent_ = line.indent;
      section_ = line.key;
      if (section_ == "message_count" && !metadata_.messages) {
        metadata_.messages = countOf(line.value);
      }
      return;
    }
    if (section_ == "relative_file_paths" && line.is_entry && line.key.empty()) {
      metadata_.files.emplace_back(line.value);
    }
    if (section_ != kTopics) return;
    // The entries of the list itself have the smallest indent; topics have lists of their own.
    if (line.is_entry && (!entry_indent_ || line.indent <= *entry_indent_)) {
      endEntry();
      entry_indent_ = line.indent;
    }
    if (line.key == "name") name_ = line.value;
    if (line.key == "type") entry_.type = line.value;
    if (line.key == "serialization_format") entry_.encoding = line.value;
    if (line.key == "message_count") messages_ = countOf(line.value);
  }
  BagMetadata end() {
    endEntry();
    return std::move(metadata_);
  }

 private:
  void endEntry() {
    if (!name_.empty() && messages_) {
      entry_.messages = *messages_;
      metadata_.topics[name_] = entry_;
    }
    entry_ = {};
    name_.clear();
    messages_.reset();
  }

  BagMetadata metadata_;
  std::optional<std::size_t> indent_;        ///< of the sections
  std::optional<std::size_t> entry_indent_;  ///< of the topics
  std::string section_;
  std::string name_;  ///< of the topic of entry_
  TopicCount entry_;
  std::optional<std::int64_t> messages_;
};

}  // namespace

BagMetadata parseMetadata(const std::string& text) {
  Sections sections;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) sections.add(parseLine(line));
  return sections.end();
}

}  // namespace tolman::ros_bag
