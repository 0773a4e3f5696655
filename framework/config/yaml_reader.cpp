// SPDX-License-Identifier: BSD-3-Clause
// Builds the tree from yaml-cpp's events, not from YAML::Node: events include duplicate keys, the
// position of keys, and whether a scalar was quoted. Aliases are copied, up to a limit.
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "base/text_encoding.hpp"
#include "config/loader.hpp"

namespace tolman::config {
namespace {

constexpr std::size_t kMaxDepth = 32;
constexpr std::size_t kMaxNodes = 20000;
// Without a comment after the last line, yaml-cpp does not report an unclosed quote in it.
constexpr const char* kLastLine = "\n#";

[[noreturn]] void refuse(const YAML::Mark& mark, const std::string& message) {
  throw YAML::ParserException(mark, message);
}

Origin at(const YAML::Mark& mark, const Origin& source) {
  Origin origin = source;
  if (source.kind != Origin::Kind::File || mark.is_null()) return origin;
  origin.line = mark.line + 1;
  origin.column = mark.column + 1;
  return origin;
}

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const Origin& source, const Environment& environment, const std::string& path,
              Problems& problems)
      : source_(source), environment_(environment), path_(path), problems_(problems) {
    root_.origin = source;
  }

  Node takeRoot() { return std::move(root_); }
  /// Where the latest value began.
  const YAML::Mark& last() const { return last_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) refuse(mark, "a second document starts here; one per file");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    count(mark, 1);
    add(make(Node::Kind::Null, mark), mark, anchor, 1);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) refuse(mark, "this alias refers to a value that contains it");
    count(mark, found->second.size);
    add(found->second.node, mark, 0, found->second.size);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuseTag(tag, mark);
    count(mark, 1);
    Node node = make(Node::Kind::Scalar, mark);
    node.text = value;
    node.quoted = tag == "!";
    add(std::move(node), mark, anchor, 1);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(Node::Kind::Sequence, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(Node::Kind::Map, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or map that is not complete yet, with the key of the next value.
  struct Open {
    Node node;
    YAML::Mark mark;
    YAML::anchor_t anchor = 0;
    std::size_t count_before = 0;
    bool has_key = false;
    Node key;
  };
  struct Anchored {
    Node node;
    std::size_t size = 0;
  };

  Node make(Node::Kind kind, const YAML::Mark& mark) const {
    return {kind, "", {}, at(mark, source_)};
  }

  static void refuseTag(const std::string& tag, const YAML::Mark& mark) {
    if (!tag.empty() && tag != "?" && tag != "!")
      refuse(mark, "the tag '" + tag + "' is not supported; remove it");
  }

  void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    refuseTag(tag, mark);
    if (open_.size() >= kMaxDepth) refuse(mark, "nested too deeply");
    open_.push_back({make(kind, mark), mark, anchor, count_, false, {}});
    count(mark, 1);
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    add(std::move(done.node), done.mark, done.anchor, count_ - done.count_before);
  }

  void count(const YAML::Mark& mark, std::size_t nodes) {
    last_ = mark;
    count_ += nodes;
    if (count_ > kMaxNodes) refuse(mark, "more than 20000 values, copies of aliases included");
  }

  /// Adds a complete value of `size` nodes to its parent.
  void add(Node node, const YAML::Mark& mark, YAML::anchor_t anchor, std::size_t size) {
    const bool is_key = !open_.empty() && open_.back().node.isMap() && !open_.back().has_key;
    if (!is_key) expand(node);
    if (anchor != 0) anchors_[anchor] = {node, size};
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (Open& parent = open_.back(); parent.node.isSequence()) {
      node.key = std::to_string(parent.node.children.size());
      node.key_origin = node.origin;
      parent.node.children.push_back(std::move(node));
    } else if (!parent.has_key) {
      takeKey(parent, std::move(node), mark);
    } else {
      takeValue(parent, std::move(node));
    }
  }

  static void takeKey(Open& map, Node key, const YAML::Mark& mark) {
    if (!key.isScalar() || key.text.empty())
      refuse(mark, "a key must be a scalar, not " + describe(key));
    if (key.text == "<<") refuse(mark, "merge keys '<<' are not supported; use 'extends'");
    map.key = std::move(key);
    map.has_key = true;
  }

  void takeValue(Open& map, Node value) {
    map.has_key = false;
    if (const Node* first = map.node.find(map.key.text)) {
      problems_.push_back(
          {map.key.origin, path(map.key.text), "given twice; first at " + text(first->key_origin)});
      return;
    }
    if (value.kind == Node::Kind::Null)
      value.origin = map.key.origin;  // yaml-cpp marks what follows
    value.key = map.key.text;
    value.key_origin = map.key.origin;
    map.node.children.push_back(std::move(value));
  }

  /// Replaces variables in a scalar.
  void expand(Node& node) {
    if (!environment_ || !node.isScalar() || node.text.find("${") == std::string::npos) return;
    std::string used;
    const Result<std::string> expanded = expandVariables(node.text, environment_, used);
    if (!expanded.isOk()) {
      problems_.push_back({node.origin, pathOfNext(), expanded.status().message()});
      return;
    }
    node.text = expanded.value();
    if (used.empty()) return;  // only escapes
    node.origin.variables = used;
    node.quoted = false;
  }

  std::string pathOfNext() const {
    if (open_.empty()) return path_;
    const Open& parent = open_.back();
    return path(parent.node.isMap() ? parent.key.text
                                    : std::to_string(parent.node.children.size()));
  }

  std::string path(std::string_view last) const {
    std::string joined = path_;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Node& node = open_[i].node;
      joined =
          joinPath(joined, node.isMap() ? open_[i].key.text : std::to_string(node.children.size()));
    }
    return joinPath(joined, last);
  }

  const Origin& source_;
  const Environment& environment_;
  const std::string& path_;
  Problems& problems_;
  Node root_;
  YAML::Mark last_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Anchored> anchors_;
  std::size_t count_ = 0;
  int documents_ = 0;
};

std::string lineOf(const std::string& text, int number) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= number && std::getline(lines, line); ++i) {
  }
  return line;
}

/// yaml-cpp's message with the likely cause.
std::string explained(const YAML::Exception& e, const std::string& line) {
  std::string message = e.msg;
  if (message == YAML::ErrorMsg::EOF_IN_SCALAR) return "a quote after this is never closed";
  if (message.starts_with(YAML::ErrorMsg::INVALID_UNICODE)) {
    return "this escape is no character; write one beyond \\uFFFF as \"\\U0001F600\", not as two "
           "escapes";
  }
  if (message == YAML::ErrorMsg::END_OF_MAP_FLOW) message = "a '{' has no '}'";
  if (message == YAML::ErrorMsg::END_OF_SEQ_FLOW) message = "a '[' has no ']'";
  const std::size_t first = line.find_first_not_of(" \t");
  if (line.substr(0, first).find('\t') != std::string::npos) {
    return message + "; indent with spaces, not tabs";
  }
  const bool has_variable = line.find("${") != std::string::npos;
  return has_variable ? message + "; put quotes around a value with ${...}" : message;
}

bool isText(const std::string& text, const Origin& source, Problems& problems) {
  // A zero byte in other text is reported below, with its column.
  if (const std::string problem = text_encoding::encodingProblem(text);
      problem.starts_with("is UTF-")) {
    problems.push_back({source, "", problem});
    return false;
  }
  const auto bad = std::ranges::find_if(text, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
  });
  if (bad == text.end()) return true;
  const auto index = static_cast<std::size_t>(bad - text.begin());
  YAML::Mark mark;
  mark.line = static_cast<int>(std::count(text.begin(), bad, '\n'));
  mark.column = static_cast<int>(index - (text.rfind('\n', index) + 1));  // npos + 1 == 0
  problems.push_back({at(mark, source), "",
                      "a byte of value " + std::to_string(static_cast<unsigned char>(*bad)) +
                          " is not text; is this a YAML file?"});
  return false;
}

}  // namespace

std::optional<Node> readYaml(const std::string& text, const Origin& source, Problems& problems,
                             const Environment& environment, const std::string& path) {
  if (!isText(text, source, problems)) return std::nullopt;
  TreeBuilder builder(source, environment, path, problems);
  try {
    std::istringstream stream(text + kLastLine);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    return builder.takeRoot();
  } catch (const YAML::Exception& e) {
    const bool at_end = e.msg == YAML::ErrorMsg::EOF_IN_SCALAR;
    const YAML::Mark mark = at_end ? builder.last() : e.mark;
    const std::string line = mark.is_null() ? "" : lineOf(text, mark.line);
    problems.push_back({at(mark, source), "", "cannot read this YAML: " + explained(e, line)});
  } catch (const std::exception& e) {
    problems.push_back({source, "", std::string("cannot read this YAML: ") + e.what()});
  }
  return std::nullopt;
}

}  // namespace tolman::config
