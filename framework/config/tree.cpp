// SPDX-License-Identifier: BSD-3-Clause
// The tree is built from yaml-cpp's events, not from YAML::Node: events include duplicate keys, the
// position of keys, and whether a scalar was quoted.
#include "config/tree.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "base/text_file.hpp"
#include "config/text.hpp"

namespace tolman::config {
namespace {

using Values = std::map<std::string, std::string>;

void addLeaves(const Node& node, const std::string& path, Values& values) {
  if (node.isScalar()) values[path] = node.text;
  for (const Node& child : node.children) addLeaves(child, joinPath(path, child.key), values);
}

bool isVariableName(std::string_view name) {
  const auto inner = [](char c) { return isLetter(c) || isDigit(c) || c == '_'; };
  return !name.empty() && !isDigit(name.front()) && std::ranges::all_of(name, inner);
}

/// The value for the text between the braces. Adds the name of the variable to `used`, and whether
/// the default is taken.
Result<std::string> lookUp(const std::string& inside, const Environment& environment,
                           std::string& used) {
  const std::size_t split = inside.find(":-");
  const bool has_default = split != std::string::npos;
  const std::string name = inside.substr(0, split);
  if (!isVariableName(name)) {
    return Status::invalidParameter("'${" + inside +
                                    "}' is not a variable; write ${NAME} or "
                                    "${NAME:-default}, and $${ for the characters themselves");
  }
  if (inside.find("${") != std::string::npos) {
    return Status::invalidParameter("${" + name + ":-...} cannot contain another ${...}");
  }
  used += (used.empty() ? "" : ", ") + name;
  const std::optional<std::string> value = environment(name);
  if (value && !(value->empty() && has_default)) return *value;
  if (!has_default) {
    return Status::invalidParameter("the environment variable " + name +
                                    " is not set; set it or write ${" + name + ":-default}");
  }
  used += value ? " (empty)" : " (not set)";
  return inside.substr(split + 2);
}

Origin at(const YAML::Mark& mark, const Origin& source) {
  Origin origin = source;
  if (source.kind != Origin::Kind::File || mark.is_null()) return origin;
  origin.line = mark.line + 1;
  origin.column = mark.column + 1;
  return origin;
}

/// Ends the reading of a document.
struct Refused {
  Origin where;
  std::string message;
};

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const Origin& source, const Environment& environment, const std::string& path,
              Problems& problems)
      : source_(source), environment_(environment), path_(path), problems_(problems) {
    root_.origin = source;
  }

  Node takeRoot() { return std::move(root_); }
  /// Where the latest key or value began.
  const Origin& last() const { return last_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    last_ = at(mark, source_);
    if (++documents_ > 1) refuse("a second document starts here; one per file");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    add(make(Node::Kind::Null, mark, ""));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    last_ = at(mark, source_);
    refuse("aliases are not supported; write the value again, or use 'extends'");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                const std::string& value) override {
    Node node = make(Node::Kind::Scalar, mark, tag);
    node.text = value;
    node.quoted = tag == "!";
    if (!wantsKey()) expand(node);
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {
    open(make(Node::Kind::Sequence, mark, tag));
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {
    open(make(Node::Kind::Map, mark, tag));
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or map that is not complete yet, with the key of the next value.
  struct Open {
    Node node;
    std::string path;
    std::optional<Node> key{};
  };

  [[noreturn]] void refuse(const std::string& message) const { throw Refused{last_, message}; }

  Node make(Node::Kind kind, const YAML::Mark& mark, const std::string& tag) {
    last_ = at(mark, source_);
    if (!tag.empty() && tag != "?" && tag != "!") {
      refuse("the tag '" + tag + "' is not supported; remove it");
    }
    return {kind, "", {}, last_};
  }

  void open(Node node) {
    std::string path = pathOfNext();
    open_.push_back({std::move(node), std::move(path)});
  }
  void close() {
    Node done = std::move(open_.back().node);
    open_.pop_back();
    add(std::move(done));
  }

  bool wantsKey() const { return !open_.empty() && open_.back().node.isMap() && !open_.back().key; }

  /// Adds a complete value to its parent.
  void add(Node node) {
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (Open& parent = open_.back(); parent.node.isSequence()) {
      node.key = std::to_string(parent.node.children.size());
      node.key_origin = node.origin;
      parent.node.children.push_back(std::move(node));
    } else if (!parent.key) {
      takeKey(parent, std::move(node));
    } else {
      takeValue(parent, std::move(node));
    }
  }

  static void takeKey(Open& map, Node key) {
    if (!key.isScalar() || key.text.empty()) {
      throw Refused{key.origin, "a key must be a scalar, not " + describe(key)};
    }
    if (key.text == "<<") {
      throw Refused{key.origin, "merge keys '<<' are not supported; use 'extends'"};
    }
    map.key = std::move(key);
  }

  void takeValue(Open& map, Node value) {
    const std::string path = pathOfNext();
    const Node key = *std::exchange(map.key, std::nullopt);
    if (const Node* first = map.node.find(key.text)) {
      problems_.push_back({key.origin, path, "given twice; first at " + text(first->key_origin)});
      return;
    }
    if (value.kind == Node::Kind::Null) value.origin = key.origin;  // yaml-cpp marks what follows
    value.key = key.text;
    value.key_origin = key.origin;
    map.node.children.push_back(std::move(value));
  }

  /// Replaces variables in a scalar.
  void expand(Node& node) {
    if (!environment_ || node.text.find("${") == std::string::npos) return;
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
    return joinPath(parent.path,
                    parent.key ? parent.key->text : std::to_string(parent.node.children.size()));
  }

  const Origin& source_;
  const Environment& environment_;
  const std::string& path_;
  Problems& problems_;
  Node root_;
  Origin last_;
  std::vector<Open> open_;
  int documents_ = 0;
};

/// yaml-cpp's message with the likely cause in this line.
std::string explained(std::string message, const std::string& line) {
  if (message == YAML::ErrorMsg::EOF_IN_SCALAR) return "a quote after this is never closed";
  if (message.starts_with(YAML::ErrorMsg::INVALID_UNICODE)) {
    return "this escape is no character; write one beyond \\uFFFF as \"\\U0001F600\", not as two "
           "escapes";
  }
  if (message == YAML::ErrorMsg::END_OF_MAP_FLOW) message = "a '{' has no '}'";
  if (message == YAML::ErrorMsg::END_OF_SEQ_FLOW) message = "a '[' has no ']'";
  const std::string indent = line.substr(0, line.find_first_not_of(" \t"));
  if (indent.find('\t') != std::string::npos) return message + "; indent with spaces, not tabs";
  const bool has_variable = line.find("${") != std::string::npos;
  return has_variable ? message + "; put quotes around a value with ${...}" : message;
}

std::string lineOf(const std::string& text, int number) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= number && std::getline(lines, line); ++i) {
  }
  return line;
}

}  // namespace

std::string text(const Origin& origin) {
  if (origin.kind == Origin::Kind::Default) return "default";
  if (origin.line == 0) return origin.file;
  return origin.file + ':' + std::to_string(origin.line) + ':' + std::to_string(origin.column);
}

std::string format(const Problem& problem) {
  constexpr std::size_t kMax = 2000;  // longer ones quote a file; lists of keys are shorter
  constexpr std::size_t kEnd = 200;
  std::string line = text(problem.where) + ": ";
  if (!problem.key_path.empty()) line += problem.key_path + ": ";
  const std::string& all = problem.message;
  if (all.size() <= kMax) return line + all;
  return line + all.substr(0, kEnd) + " ... " + all.substr(all.size() - kEnd);
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

const Node* Node::find(std::string_view name) const {
  const auto found = std::ranges::find(children, name, &Node::key);
  return found == children.end() ? nullptr : &*found;
}

Node* Node::find(std::string_view name) {
  const auto found = std::ranges::find(children, name, &Node::key);
  return found == children.end() ? nullptr : &*found;
}

void Node::erase(std::string_view name) {
  std::erase_if(children, [&](const Node& child) { return child.key == name; });
}

std::string describe(const Node& node) {
  if (node.isScalar()) return "'" + node.text + "'";
  return node.isMap() ? "a map" : node.isSequence() ? "a list" : "nothing";
}

std::string joinPath(std::string_view path, std::string_view key) {
  std::string joined(path);
  if (!path.empty() && !key.empty()) joined += '.';
  return joined.append(key);
}

bool namesOtherPlugin(const Node& stage, const Node& plugin) {
  const Node* current = stage.find("plugin");
  return current != nullptr && (current->kind != plugin.kind || current->text != plugin.text);
}

void merge(Node& base, const Node& over) {
  const Node* plugin = over.find("plugin");
  const bool other_plugin = plugin != nullptr && namesOtherPlugin(base, *plugin);
  if (!base.isMap() || !over.isMap() || other_plugin) {
    base = over;
    return;
  }
  base.origin = over.origin;
  base.key_origin = over.key_origin;
  for (const Node& child : over.children) {
    if (Node* below = base.find(child.key)) {
      merge(*below, child);
    } else {
      base.children.push_back(child);
    }
  }
}

std::vector<Difference> differencesOf(const std::vector<const Node*>& trees) {
  std::vector<Values> all;
  Values keys;
  for (const Node* tree : trees) {
    addLeaves(*tree, "", all.emplace_back());
    keys.insert(all.back().begin(), all.back().end());
  }
  std::vector<Difference> differences;
  for (const auto& [key, first] : keys) {
    Difference difference{key, {}};
    for (const Values& values : all) {
      const auto own = values.find(key);
      difference.values.push_back(own == values.end() ? "-" : own->second);
    }
    const auto& values = difference.values;
    const bool is_same = std::ranges::count(values, values.front()) == std::ranges::ssize(values);
    if (!is_same) differences.push_back(std::move(difference));
  }
  return differences;
}

Environment processEnvironment() {
  return [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
  };
}

Result<std::string> expandVariables(const std::string& text, const Environment& environment,
                                    std::string& used) {
  std::string expanded;
  std::size_t done = 0;
  for (std::size_t start = text.find("${"); start != std::string::npos;
       start = text.find("${", done)) {
    expanded.append(text, done, start - done);
    if (start > done && text[start - 1] == '$') {  // escaped; one '$' is already there
      expanded += '{';
      done = start + 2;
      continue;
    }
    const std::size_t end = text.find('}', start);
    if (end == std::string::npos) return Status::invalidParameter("'${' without '}'");
    const auto value = lookUp(text.substr(start + 2, end - start - 2), environment, used);
    if (!value.isOk()) return value.status();
    expanded += value.value();
    done = end + 1;
  }
  return expanded + text.substr(done);
}

std::optional<Node> readYaml(const std::string& text, const Origin& source, Problems& problems,
                             const Environment& environment, const std::string& path) {
  if (const std::string problem = text_encoding::encodingProblem(text); !problem.empty()) {
    problems.push_back({source, "", problem});
    return std::nullopt;
  }
  TreeBuilder builder(source, environment, path, problems);
  const auto fail = [&](const Origin& where, const std::string& message) {
    problems.push_back({where, "", "cannot read this YAML: " + message});
    return std::nullopt;
  };
  try {
    // Without a comment after the last line, yaml-cpp does not report an unclosed quote in it.
    std::istringstream stream(text + "\n#");
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    return builder.takeRoot();
  } catch (const Refused& refused) {
    return fail(refused.where, refused.message);
  } catch (const YAML::Exception& e) {
    const bool in_quote = e.msg == YAML::ErrorMsg::EOF_IN_SCALAR;
    const Origin where = in_quote ? builder.last() : at(e.mark, source);
    return fail(where, explained(e.msg, e.mark.is_null() ? "" : lineOf(text, e.mark.line)));
  } catch (const std::exception& e) {
    return fail(source, e.what());
  }
}

}  // namespace tolman::config
