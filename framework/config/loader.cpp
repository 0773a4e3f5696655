// SPDX-License-Identifier: BSD-3-Clause
// Reading files, following `extends`, and applying --set.
#include "config/loader.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

#include "config/text.hpp"

namespace tolman::config {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxBytes = 1U << 20U;

Result<std::string> readText(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return Status::invalidInput(absence(file, "no such file"));
  if (!fs::is_regular_file(file, error)) return Status::invalidInput("not a regular file");
  if (fs::file_size(file, error) > kMaxBytes) {
    return Status::invalidInput("larger than 1 MiB; not a configuration?");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) return Status::invalidInput(absence(file, "cannot be read; check the disk"));
  return text;
}

/// Follows `extends` from the first file. Paths are shown relative to the working directory where
/// the user gave them so.
class Loader {
 public:
  Loader(const Environment& environment, const FindShipped& find_shipped, Loaded& loaded)
      : environment_(environment), find_shipped_(find_shipped), loaded_(loaded) {}

  /// The merged tree of a file. `requested` is where it is named, for messages.
  Node merged(const fs::path& file, const Origin& requested) {
    const std::string circle = circleTo(file);
    if (!circle.empty()) return fail(requested, "extends", "circular: " + circle);
    chain_.push_back(file);
    Node tree = read(file, requested);
    Node base = bases(tree);
    tree.erase("extends");
    merge(base, tree);
    chain_.pop_back();
    return base;
  }

 private:
  /// Reports the problem and returns an empty map.
  Node fail(const Origin& where, const std::string& path, const std::string& message) {
    loaded_.complete = false;
    loaded_.problems.push_back({where, path, message});
    return {Node::Kind::Map, "", {}, where};
  }

  /// "a.yaml -> b.yaml -> a.yaml" when the file is already being read, or nothing.
  std::string circleTo(const fs::path& file) const {
    std::string shown;
    for (const fs::path& earlier : chain_) {
      std::error_code error;
      const bool starts = fs::equivalent(earlier, file, error);
      if (starts || !shown.empty()) shown += earlier.string() + " -> ";
    }
    return shown.empty() ? shown : shown + file.string();
  }

  /// The tree of one file, with variables expanded.
  Node read(const fs::path& file, const Origin& requested) {
    const Result<std::string> text = readText(file);
    if (!text.isOk()) {
      const std::string message = text.status().message();
      if (chain_.size() == 1) return fail(requested, "", message);
      return fail(requested, "extends", file.string() + ": " + message);
    }
    const Origin origin = Origin::ofFile(file.string());
    std::optional<Node> tree = readYaml(text.value(), origin, loaded_.problems, environment_);
    if (!tree) {  // readYaml() has reported the reason
      loaded_.complete = false;
      return {Node::Kind::Map, "", {}, origin};
    }
    if (tree->kind == Node::Kind::Null) return fail(origin, "", "the file is empty");
    if (tree->isMap()) return std::move(*tree);
    return fail(tree->origin, "", "a configuration is a map of keys, not " + describe(*tree));
  }

  /// The merged trees of the files in `extends`.
  Node bases(const Node& tree) {
    Node all{Node::Kind::Map, "", {}, tree.origin};
    const Node* extends = tree.find("extends");
    if (extends == nullptr) return all;
    if (extends->isScalar()) {
      merge(all, base(*extends));
    } else if (extends->isSequence()) {
      for (const Node& item : extends->children) merge(all, base(item));
    } else {
      fail(extends->origin, "extends",
           "expects a file or a list of files, not " + describe(*extends));
    }
    return all;
  }

  Node base(const Node& name) {
    if (!name.isScalar() || name.text.empty()) {
      return fail(name.origin, "extends", "expects a file, not " + describe(name));
    }
    fs::path file = fs::path(name.origin.file).parent_path() / name.text;
    if (name.text.starts_with('~')) {
      const Result<std::string> path = resolvePath(name.text, name.origin, loaded_.folders);
      if (!path.isOk()) return fail(name.origin, "extends", path.status().message());
      file = path.value();
    }
    std::error_code ignored;
    if (find_shipped_ && (!fs::exists(file, ignored) || fs::is_directory(file, ignored))) {
      if (const fs::path shipped = find_shipped_(name.text); !shipped.empty()) file = shipped;
    }
    return merged(file.lexically_normal(), name.origin);
  }

  const Environment& environment_;
  const FindShipped& find_shipped_;
  Loaded& loaded_;
  std::vector<fs::path> chain_;
};

/// The parts of "a.b.c".
Result<std::vector<std::string>> partsOf(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path + '.');
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  if (std::ranges::find(parts, "") != parts.end()) {
    return Status::invalidParameter("the key path has an empty part");
  }
  if (parts.front() != "extends") return parts;
  return Status::invalidParameter("'extends' is allowed in files only");
}

/// The child `part` of `parent`, created if it does not exist.
Result<Node*> step(Node& parent, const std::string& part, const Origin& origin) {
  if (parent.kind == Node::Kind::Null) {
    const bool is_index = part.size() <= 4 && std::ranges::all_of(part, isDigit);
    parent.kind = is_index ? Node::Kind::Sequence : Node::Kind::Map;
    parent.origin = origin;
  }
  if (parent.isScalar()) {
    return Status::invalidParameter("'" + part + "' cannot be set: its parent is the scalar " +
                                    describe(parent));
  }
  if (Node* child = parent.find(part)) return child;
  const std::string size = std::to_string(parent.children.size());
  if (parent.isSequence() && part != size) {
    return Status::invalidParameter("no item '" + part + "' in a list of " + size +
                                    "; indices start at 0");
  }
  parent.children.push_back({Node::Kind::Null, part, origin, origin});
  return &parent.children.back();
}

Status assign(Node& tree, const std::vector<std::string>& path, Node value, const Origin& origin) {
  Node* node = &tree;
  for (const std::string& part : path) {
    const bool is_plugin = part == "plugin" && &part == &path.back();
    if (is_plugin && namesOtherPlugin(*node, value)) node->children.clear();
    const Result<Node*> child = step(*node, part, origin);
    if (!child.isOk()) return child.status();
    node = child.value();
  }
  value.key = node->key;
  value.key_origin = origin;
  *node = std::move(value);
  return Status::ok();
}

Status applyOverride(Node& tree, const std::string& argument, const Origin& origin,
                     const Environment& environment, Problems& problems) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos) {
    return Status::invalidParameter("write --set key.path=value");
  }
  const std::string path = argument.substr(0, equals);
  const auto parts = partsOf(path);
  if (!parts.isOk()) return parts.status();
  std::optional<Node> value =
      readYaml(argument.substr(equals + 1), origin, problems, environment, path);
  if (!value) return Status::ok();  // readYaml() has reported the reason
  return assign(tree, parts.value(), std::move(*value), origin);
}

/// What `stage` has beside its plugin, if `now` has another plugin.
std::string leftOut(const Node& stage, const Node* now) {
  const Node* plugin = stage.find("plugin");
  const Node* other = now == nullptr ? nullptr : now->find("plugin");
  if (other == nullptr || !namesOtherPlugin(stage, *other)) return "";
  std::vector<std::string> keys;
  for (const Node& child : stage.children) {
    if (&child != plugin && now->find(child.key) == nullptr) keys.push_back(child.key);
  }
  if (keys.empty()) return "";
  return other->text + " replaces " + plugin->text +
         ", whose parameters are not used: " + listed(keys);
}

}  // namespace

void applyOverrides(Node& tree, const std::vector<std::string>& overrides,
                    const Environment& environment, Problems& problems) {
  std::vector<std::string> ordered = overrides;
  std::stable_partition(ordered.begin(), ordered.end(), [](const std::string& argument) {
    return argument.substr(0, argument.find('=')).ends_with(".plugin");
  });
  for (const std::string& argument : ordered) {
    const Origin origin{Origin::Kind::CommandLine, "--set " + argument, 0, 0, {}};
    const Status done = applyOverride(tree, argument, origin, environment, problems);
    if (!done.isOk()) problems.push_back({origin, "", done.message()});
  }
}

Status setValue(Node& tree, const std::string& path, const Node& value) {
  const auto parts = partsOf(path);
  if (!parts.isOk()) return parts.status();
  const Node* there = &tree;
  for (const std::string& part : parts.value()) there = there ? there->find(part) : nullptr;
  Node merged = value;
  if (value.isMap() && there != nullptr && there->isMap()) {
    merged = *there;
    merge(merged, value);
  }
  return assign(tree, parts.value(), std::move(merged), value.origin);
}

Loaded load(const fs::path& file, const std::vector<std::string>& overrides,
            const Environment& environment, const FindShipped& find_shipped) {
  Loaded loaded;
  std::error_code error;
  loaded.folders = {fs::current_path(error), environment("HOME").value_or("")};
  loaded.file = file.string();
  loaded.tree = {Node::Kind::Map};
  if (!file.empty()) {
    const Origin origin = Origin::ofFile(loaded.file);
    loaded.tree = Loader(environment, find_shipped, loaded).merged(file, origin);
  }
  const Node before = loaded.tree;
  applyOverrides(loaded.tree, overrides, environment, loaded.problems);
  for (const Node& stage : before.children) {
    const std::string note = leftOut(stage, loaded.tree.find(stage.key));
    if (!note.empty()) loaded.notes.push_back(stage.key + ": " + note);
  }
  return loaded;
}

}  // namespace tolman::config
