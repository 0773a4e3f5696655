// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "text_tree.hpp"

namespace tolman::camera_files {
namespace {

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  /// The root element; fails without one.
  Node whole() {
    skipProlog();
    if (at_ == text_.size()) fail("has no element; this is no calibration");
    Node node = element(0);
    node.line = 0;
    return node;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw FileError(line_, what); }
  bool startsWith(std::string_view part) const { return text_.substr(at_).starts_with(part); }

  void advanceTo(std::size_t end) {
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = end;
  }
  void advancePast(std::string_view part) {
    const std::size_t found = text_.find(part, at_);
    if (found == std::string_view::npos) fail("ends before " + inQuotes(part) + "; restore it");
    advanceTo(found + part.size());
  }
  void skipProlog() {
    while (true) {
      advanceTo(std::min(text_.find('<', at_), text_.size()));
      if (startsWith("<!--")) {
        advancePast("-->");
      } else if (startsWith("<?") || startsWith("<!")) {
        advancePast(">");
      } else {
        return;
      }
    }
  }

  Node element(int depth) {
    if (depth > kDeepest) fail("is nested too deeply; this is no calibration");
    Node node{Node::Kind::Value, line_, {}, {}, {}};
    const std::size_t begin = at_ + 1;
    advancePast(">");
    const std::string_view tag = text_.substr(begin, at_ - 1 - begin);
    node.key = tag.substr(0, tag.find_first_of(" \t\r\n/"));
    if (tag.ends_with('/')) return node;
    const std::size_t content = at_;
    while (true) {
      const std::size_t text_begin = at_;
      skipProlog();
      if (at_ == text_.size()) fail("<" + node.key + "> is not closed; restore the file");
      if (startsWith("</")) {
        if (node.children.empty()) node.text = text_.substr(content, at_ - content);
        close(node.key);
        node.checkKeys();
        return node;
      }
      if (node.children.empty()) checkBlank(text_.substr(text_begin, at_ - text_begin));
      node.children.push_back(element(depth + 1));
      // cv::FileStorage names the elements of a sequence "_".
      node.kind = node.children.back().key == "_" ? Node::Kind::List : Node::Kind::Map;
    }
  }

  void checkBlank(std::string_view between) const {
    if (between.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    if (between.find("-->") != std::string_view::npos) return;
    fail("has text beside elements; this is no calibration");
  }

  void close(const std::string& key) {
    const std::size_t begin = at_ + 2;
    advancePast(">");
    if (text_.substr(begin, at_ - 1 - begin) != key) fail("<" + key + "> is not closed here");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

Node parseXml(std::string_view text) { return XmlReader(text).whole(); }

}  // namespace tolman::camera_files
