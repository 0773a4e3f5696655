// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "text_tree.hpp"

namespace tolman::camera_files {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// Scans a text and tells which characters are outside of quotes.
class Quotes {
 public:
  bool outside(char c) {
    if (quote_ == 0 && (c == '"' || c == '\'')) {
      quote_ = c;
      return false;
    }
    if (c == quote_) {
      quote_ = 0;
      return false;
    }
    return quote_ == 0;
  }

 private:
  char quote_ = 0;
};

std::string_view withoutComment(std::string_view line) {
  Quotes quotes;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool after_blank = i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t';
    if (quotes.outside(line[i]) && line[i] == '#' && after_blank) return line.substr(0, i);
  }
  return line;
}

std::string unquoted(std::string_view text) {
  text = trimmed(text);
  const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
                      text.back() == text.front();
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

/// Number of opening minus closing brackets.
int openBrackets(std::string_view text) {
  Quotes quotes;
  int open = 0;
  for (const char c : text) {
    if (!quotes.outside(c)) continue;
    open += c == '[' || c == '{' ? 1 : 0;
    open -= c == ']' || c == '}' ? 1 : 0;
  }
  return open;
}

/// The colon that ends a key; npos where there is none.
std::size_t keyEnd(std::string_view text) {
  Quotes quotes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!quotes.outside(text[i])) continue;
    if (text[i] == '[' || text[i] == '{') return std::string_view::npos;
    if (text[i] == ':' && (i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\t')) {
      return i;
    }
  }
  return std::string_view::npos;
}

struct Line {
  int number = 0;
  std::size_t indent = 0;
  std::string text;  ///< without indent and comment
};

/// Reads "[1, {a: 2}]".
class FlowReader {
 public:
  FlowReader(std::string_view text, int line) : text_(text), line_(line) {}

  Node whole() {
    Node node = value(0);
    skipBlanks();
    if (at_ != text_.size()) fail("something follows the closing bracket; remove it");
    return node;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw FileError(line_, what); }

  void skipBlanks() {
    for (; at_ < text_.size() && kBlanks.find(text_[at_]) != std::string_view::npos; ++at_) {
      if (text_[at_] == '\n') ++line_;
    }
  }

  Node value(int depth) {
    if (depth > kDeepest) fail("brackets are nested too deeply; this is no calibration");
    skipBlanks();
    Node node{Node::Kind::Value, line_, {}, {}, {}};
    if (at_ < text_.size() && (text_[at_] == '[' || text_[at_] == '{')) {
      node.kind = text_[at_] == '[' ? Node::Kind::List : Node::Kind::Map;
      ++at_;
      items(node, depth);
    } else {
      node.text = plain();
    }
    return node;
  }

  void items(Node& node, int depth) {
    const bool is_map = node.kind == Node::Kind::Map;
    const char close = is_map ? '}' : ']';
    while (true) {
      skipBlanks();
      if (at_ == text_.size()) fail("a bracket is not closed");
      if (text_[at_] == close) break;
      const int line = line_;
      std::string key;
      if (is_map) key = takeKey();
      Node child = value(depth + 1);
      if (is_map) child.line = line;
      child.key = std::move(key);
      node.children.push_back(std::move(child));
      skipBlanks();
      if (at_ < text_.size() && text_[at_] == ',') {
        ++at_;
      } else if (at_ == text_.size() || text_[at_] != close) {
        fail("a comma or a closing bracket is missing");
      }
    }
    ++at_;
    node.checkKeys();
  }

  std::string takeKey() {
    const std::size_t colon = text_.find(':', at_);
    if (colon == std::string_view::npos) fail("a colon is missing after a name");
    const std::string_view key = text_.substr(at_, colon - at_);
    line_ += static_cast<int>(std::count(key.begin(), key.end(), '\n'));
    at_ = colon + 1;
    return unquoted(key);
  }

  std::string plain() {
    Quotes quotes;
    const std::size_t begin = at_;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (quotes.outside(c) && (c == ',' || c == ']' || c == '}')) break;
      if (c == '\n') ++line_;
    }
    return unquoted(text_.substr(begin, at_ - begin));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_;
};

class BlockReader {
 public:
  explicit BlockReader(std::string_view text) { split(text); }

  Node whole() {
    if (lines_.empty()) throw FileError(0, "is empty; restore it");
    Node node = block(lines_.front().indent, 0);
    if (at_ < lines_.size()) fail("is not indented like the lines above; correct the file");
    node.line = 0;
    return node;
  }

 private:
  void split(std::string_view text) {
    int number = 0;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size() - 1);
      const std::string_view line = withoutComment(text.substr(0, end + 1));
      text.remove_prefix(end + 1);
      ++number;
      const std::string_view content = trimmed(line);
      const bool is_mark = content.starts_with('%') || content == "---" || content == "...";
      if (content.empty() || is_mark) continue;
      lines_.push_back({number, line.find_first_not_of(" \t"), std::string(content)});
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(at_ < lines_.size() ? lines_[at_].number : 0, what);
  }
  bool isAt(std::size_t indent) const {
    return at_ < lines_.size() && lines_[at_].indent == indent;
  }
  bool isItem() const { return lines_[at_].text == "-" || lines_[at_].text.starts_with("- "); }

  Node block(std::size_t indent, int depth) {
    if (depth > kDeepest) fail("is nested too deeply; this is no calibration");
    Node node{isItem() ? Node::Kind::List : Node::Kind::Map, lines_[at_].number, {}, {}, {}};
    while (isAt(indent) && isItem() == (node.kind == Node::Kind::List)) {
      node.children.push_back(node.kind == Node::Kind::List ? listItem(indent, depth)
                                                            : mapItem(indent, depth));
    }
    node.checkKeys();
    return node;
  }

  Node listItem(std::size_t indent, int depth) {
    Line& line = lines_[at_];
    const std::string rest(trimmed(std::string_view(line.text).substr(1)));
    if (keyEnd(rest) != std::string_view::npos) {  // "- a: 1" opens a map
      line.text = rest;
      line.indent = indent + 2;
      return block(line.indent, depth + 1);
    }
    return valueAfter(rest, indent, depth);
  }

  Node mapItem(std::size_t indent, int depth) {
    const std::string text = lines_[at_].text;
    const int line = lines_[at_].number;
    const std::size_t end = keyEnd(text);
    if (end == std::string_view::npos) {
      fail(inQuotes(text) + " is not of the form 'name: value'; correct it");
    }
    Node node =
        valueAfter(std::string(trimmed(std::string_view(text).substr(end + 1))), indent, depth);
    node.key = unquoted(std::string_view(text).substr(0, end));
    node.line = line;
    return node;
  }

  /// The value whose first line has `rest` after its key or dash.
  Node valueAfter(std::string rest, std::size_t indent, int depth) {
    const int line = lines_[at_++].number;
    if (rest.starts_with('!')) {
      rest = trimmed(std::string_view(rest).substr(std::min(rest.find(' '), rest.size())));
    }
    if (rest.empty()) return nested(line, indent, depth);
    if (rest.front() == '[' || rest.front() == '{') {
      for (int last = line; openBrackets(rest) > 0 && at_ < lines_.size(); ++at_) {
        rest.append(static_cast<std::size_t>(lines_[at_].number - last), '\n');
        rest += lines_[at_].text;
        last = lines_[at_].number;
      }
      return FlowReader(rest, line).whole();
    }
    while (at_ < lines_.size() && lines_[at_].indent > indent) rest += " " + lines_[at_++].text;
    return {Node::Kind::Value, line, {}, unquoted(rest), {}};
  }

  Node nested(int line, std::size_t indent, int depth) {
    const bool deeper = at_ < lines_.size() && lines_[at_].indent > indent;
    const bool list_below = isAt(indent) && isItem();
    if (deeper || list_below) return block(lines_[at_].indent, depth + 1);
    return {Node::Kind::Value, line, {}, {}, {}};
  }

  std::vector<Line> lines_;
  std::size_t at_ = 0;
};

}  // namespace

Node parseYaml(std::string_view text) { return BlockReader(text).whole(); }

}  // namespace tolman::camera_files
