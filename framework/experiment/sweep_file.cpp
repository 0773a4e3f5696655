// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/sweep_file.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "config/loader.hpp"
#include "config/text.hpp"
#include "config/values.hpp"
#include "tolman/context.hpp"

namespace tolman::experiment {

namespace {

constexpr unsigned kBits = 32;

/// A primitive polynomial and the first direction numbers of one dimension (Joe and Kuo 2008).
struct Direction {
  unsigned degree;
  unsigned polynomial;
  std::array<unsigned, 5> first;
};
constexpr std::array<Direction, kSobolDimensions - 1> kDirections = {{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
}};

std::array<std::uint32_t, kBits> directionNumbers(std::size_t dimension) {
  std::array<std::uint32_t, kBits> v{};
  if (dimension == 0) {
    for (unsigned i = 0; i < kBits; ++i) v.at(i) = 1U << (kBits - 1 - i);
    return v;
  }
  const Direction& d = kDirections.at(dimension - 1);
  for (unsigned i = 0; i < kBits; ++i) {
    if (i < d.degree) {
      v.at(i) = d.first.at(i) << (kBits - 1 - i);
      continue;
    }
    v.at(i) = v.at(i - d.degree) ^ (v.at(i - d.degree) >> d.degree);
    for (unsigned k = 1; k < d.degree; ++k) {
      if (((d.polynomial >> (d.degree - 1 - k)) & 1U) != 0) v.at(i) ^= v.at(i - k);
    }
  }
  return v;
}

}  // namespace

std::vector<std::vector<double>> sobolPoints(std::size_t count, std::size_t dimensions) {
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    const auto v = directionNumbers(d);
    std::uint32_t x = 0;
    for (std::size_t i = 0; i < count; ++i) {
      points[i][d] = static_cast<double>(x) * 0x1.0p-32;
      x ^= v.at(static_cast<std::size_t>(std::countr_one(i)));
    }
  }
  return points;
}

std::vector<std::vector<double>> randomPoints(std::size_t count, std::size_t dimensions,
                                              std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (auto& point : points) {
    for (double& coordinate : point) coordinate = random.uniform();
  }
  return points;
}

namespace {

using config::Node;
using NodePointer = std::shared_ptr<const Node>;

constexpr std::size_t kMaxSamples = 100'000;
/// Columns beside the factors in the table of csvOf() (run_table.hpp).
constexpr std::array kTableColumns = {"name", "alignment", "truth_sha256", "results_sha256"};

/// The label of a value: a scalar, the plugin of a stage, the values of a map, or a list in
/// brackets.
std::string labelOf(const Node& value) {
  if (value.isScalar()) return value.text;
  if (const Node* plugin = value.find("plugin"); plugin != nullptr && value.children.size() == 1) {
    return plugin->text;
  }
  std::string text;
  for (const Node& child : value.children) {
    text += (text.empty() ? "" : " ") + (value.isMap() ? child.key + "=" : "") + labelOf(child);
  }
  return value.isMap() ? text : "[" + text + "]";
}

class Reader {
 public:
  Reader(SweepFile& sweep, config::Problems& problems) : sweep_(sweep), problems_(problems) {}

  void read(const Node& tree) {
    knownKeys(tree, "",
              {"name", "base", "set", "reuse", "grid", "list", "random", "sobol", "include",
               "sequences", "seeds", "exclude"});
    if (const Node* name = scalar(tree, "name")) sweep_.name = name->text;
    sweep_.base = pointerTo(scalar(tree, "base"));
    if (!sweep_.base) problem(tree, "base", "is missing: the configuration that is varied");
    if (const Node* set = map(tree, "set")) sweep_.settings = settings(*set, {});
    if (const Node* reuse = scalar(tree, "reuse")) {
      const Result<bool> value = config::readBool(reuse->text);
      if (value.isOk()) sweep_.reuse = value.value();
      if (!value.isOk()) problem(*reuse, "reuse", value.status().message());
    }
    if (const Node* grid = map(tree, "grid")) readGrid(*grid);
    if (const Node* list = map(tree, "list")) readLists(*list);
    for (const char* kind : {"random", "sobol"}) {
      if (const Node* samples = map(tree, kind)) readSamples(*samples, kind);
    }
    if (const Node* include = tree.find("include")) readInclude(*include);
    if (const Node* sequences = map(tree, "sequences")) readSequences(*sequences);
    if (const Node* seeds = tree.find("seeds")) readSeeds(*seeds);
    if (const Node* exclude = tree.find("exclude")) readExclude(*exclude);
  }

 private:
  void problem(const Node& where, const std::string& path, const std::string& message) {
    problems_.push_back({where.origin, path, message});
  }
  static NodePointer pointerTo(const Node* node) {
    return node == nullptr ? nullptr : std::make_shared<const Node>(*node);
  }

  void knownKeys(const Node& map, const std::string& path, const std::vector<std::string>& known) {
    for (const Node& child : map.children) {
      if (std::ranges::find(known, child.key) != known.end()) continue;
      problems_.push_back({child.key_origin, config::joinPath(path, child.key),
                           "unknown key" + config::didYouMean(child.key, known) +
                               "; keys: " + config::listed(known)});
    }
  }

  const Node* scalar(const Node& parent, const std::string& key) {
    const Node* node = parent.find(key);
    if (node == nullptr || node->isScalar()) return node;
    problem(*node, key, "expects a value, not " + config::describe(*node));
    return nullptr;
  }
  const Node* map(const Node& parent, const std::string& key) {
    const Node* node = parent.find(key);
    if (node == nullptr || node->isMap()) return node;
    problem(*node, key, "expects a map, not " + config::describe(*node));
    return nullptr;
  }

  std::vector<Setting> settings(const Node& map, const std::vector<std::string>& others) {
    std::vector<Setting> all;
    for (const Node& child : map.children) {
      if (std::ranges::find(others, child.key) != others.end()) continue;
      if (child.key == "name") problem(child, child.key, "points have names of their own");
      all.push_back({child.key, pointerTo(&child)});
    }
    return all;
  }

  void add(Axis& axis, Choice choice, const Node& origin) {
    for (const Choice& other : axis) {
      if (other.factors.front().label != choice.factors.front().label) continue;
      problem(origin, choice.factors.front().name,
              "has the value '" + choice.factors.front().label + "' twice");
      return;
    }
    axis.push_back(std::move(choice));
  }
  void add(Axis axis, const Node& origin, const std::string& name) {
    if (axis.empty()) problem(origin, name, "has no values");
    sweep_.axes.push_back(std::move(axis));
  }

  /// key: [values], or key: {label: value}.
  void readGrid(const Node& grid) {
    for (const Node& key : grid.children) {
      Axis axis;
      if (key.isScalar()) problem(key, key.key, "expects a list of values, not one");
      for (const Node& value : key.children) {
        const std::string label = key.isMap() ? value.key : labelOf(value);
        add(axis, {{{key.key, label}}, {{key.key, pointerTo(&value)}}, nullptr}, value);
      }
      add(std::move(axis), key, key.key);
    }
  }

  /// name: {label: {key: value}}
  void readLists(const Node& lists) {
    for (const Node& list : lists.children) {
      Axis axis;
      if (std::ranges::find(kTableColumns, list.key) != kTableColumns.end()) {
        problem(list, list.key, "is a column of the table of `sweep collect`; rename the factor");
      }
      if (!list.isMap()) problem(list, list.key, "expects a map from labels to settings");
      for (const Node& item : list.children) {
        if (!item.isMap()) problem(item, item.key, "expects a map of settings");
        add(axis, {{{list.key, item.key}}, settings(item, {"first_session"}), firstSession(item)},
            item);
      }
      add(std::move(axis), list, list.key);
    }
  }

  struct Range {
    std::string key;
    double low = 0;
    double high = 1;
    bool log = false;
    bool integer = false;
    config::Origin origin;

    std::string at(double share) const {
      const double value = log ? std::exp(std::log(low) + share * (std::log(high) - std::log(low)))
                               : low + share * (high - low);
      if (!integer) return fmt::format("{:.8g}", value);
      return fmt::format("{}", std::llround(std::floor(low + share * (high - low + 1))));
    }
  };

  double number(const Node& parent, const std::string& key, double fallback) {
    const Node* node = scalar(parent, key);
    if (node == nullptr) return fallback;
    const Result<double> value = config::readReal(node->text);
    if (!value.isOk()) problem(*node, key, value.status().message());
    return value.isOk() ? value.value() : fallback;
  }

  std::size_t whole(const Node& parent, const std::string& key, std::int64_t fallback) {
    const Node* node = scalar(parent, key);
    if (node == nullptr) return static_cast<std::size_t>(fallback);
    const Result<std::int64_t> value = config::readInteger(node->text);
    const bool is_usable = value.isOk() && value.value() >= 0;
    if (!is_usable) problem(*node, key, "expects a whole number from 0");
    return static_cast<std::size_t>(is_usable ? value.value() : fallback);
  }

  bool flag(const Node& parent, const std::string& key) {
    const Node* node = scalar(parent, key);
    if (node == nullptr) return false;
    const Result<bool> value = config::readBool(node->text);
    if (!value.isOk()) problem(*node, key, value.status().message());
    return value.isOk() && value.value();
  }

  Range range(const Node& node) {
    knownKeys(node, node.key, {"min", "max", "log", "integer"});
    Range range{node.key, 0, 1, false, false, node.origin};
    if (!node.isMap() || node.find("min") == nullptr || node.find("max") == nullptr) {
      problem(node, node.key, "expects a range such as {min: 50, max: 300}");
      return range;
    }
    range.low = number(node, "min", 0);
    range.high = number(node, "max", 1);
    range.log = flag(node, "log");
    range.integer = flag(node, "integer");
    if (range.integer &&
        (std::trunc(range.low) != range.low || std::trunc(range.high) != range.high)) {
      problem(node, node.key, "expects whole numbers for min and max with integer");
    }
    if (range.low > range.high || (range.log && (range.low <= 0 || range.integer))) {
      problem(node, node.key, "is no range; max must be above min, and min above 0 with log");
      range = Range{node.key, 0, 1, false, false, node.origin};
    }
    return range;
  }

  /// {count: N, seed: S, keys: {key: {min: A, max: B, log: true, integer: true}}}
  void readSamples(const Node& samples, const std::string& kind) {
    // The points of the Sobol sequence are always the same.
    if (kind == "sobol") knownKeys(samples, kind, {"count", "keys"});
    if (kind != "sobol") knownKeys(samples, kind, {"count", "seed", "keys"});
    const std::size_t count = whole(samples, "count", 0);
    const Node* keys = map(samples, "keys");
    if (count < 1 || count > kMaxSamples || keys == nullptr) {
      problem(samples, kind, "expects a count from 1 to 100000 and a map of keys");
      return;
    }
    std::vector<Range> ranges;
    for (const Node& key : keys->children) ranges.push_back(range(key));
    if (kind == "sobol" && ranges.size() > kSobolDimensions) {
      problem(*keys, kind, fmt::format("has more than {} keys", kSobolDimensions));
      return;
    }
    const auto shares = kind == "sobol"
                            ? sobolPoints(count, ranges.size())
                            : randomPoints(count, ranges.size(), whole(samples, "seed", 1));
    Axis axis;
    for (const auto& point : shares) {
      Choice& choice = axis.emplace_back();
      for (std::size_t d = 0; d < ranges.size(); ++d) {
        Node value{Node::Kind::Scalar, ranges[d].key, ranges[d].origin, ranges[d].origin};
        value.text = ranges[d].at(point[d]);
        choice.factors.push_back({ranges[d].key, value.text});
        choice.settings.push_back({ranges[d].key, std::make_shared<const Node>(std::move(value))});
      }
    }
    sweep_.axes.push_back(std::move(axis));
  }

  void readInclude(const Node& include) {
    if (!include.isSequence()) problem(include, "include", "expects a list of maps of settings");
    for (const Node& item : include.children) {
      if (!item.isMap()) problem(item, "include", "expects a map of settings");
      Choice choice{{}, settings(item, {}), nullptr};
      for (const Setting& s : choice.settings) choice.factors.push_back({s.key, labelOf(*s.value)});
      if (!choice.factors.empty()) sweep_.include.push_back(std::move(choice));
    }
  }

  /// label: PATH for source.path, or label: {key: value}; front_end: FILE or {base: , key: value}.
  void readSequences(const Node& sequences) {
    Axis axis;
    for (const Node& item : sequences.children) {
      Choice choice{{{"sequence", item.key}}, {}, nullptr};
      if (item.isMap()) {
        choice.settings = settings(item, {"front_end"});
        if (const Node* front = item.find("front_end"))
          choice.front_end = frontEnd(*front, item.key);
      } else if (item.isScalar()) {
        choice.settings.push_back({"source.path", pointerTo(&item)});
      } else {
        problem(item, item.key, "expects a path, or a map of settings");
      }
      add(axis, std::move(choice), item);
    }
    if (axis.empty()) problem(sequences, "sequences", "has no values");
    sweep_.repeats.push_back(std::move(axis));
  }

  std::shared_ptr<const FrontEnd> frontEnd(const Node& node, const std::string& label) {
    auto front = std::make_shared<FrontEnd>();
    front->label = label;
    const Node* base = node.isMap() ? scalar(node, "base") : &node;
    if (base == nullptr || !base->isScalar()) {
      problem(node, "front_end", "expects a configuration, or a map with 'base' and settings");
      return nullptr;
    }
    front->base = pointerTo(base);
    if (node.isMap()) front->settings = settings(node, {"base"});
    return front;
  }

  /// first_session: {key: value}; none where the item has no such key.
  std::shared_ptr<const FrontEnd> firstSession(const Node& item) {
    const Node* first = map(item, "first_session");
    if (first == nullptr) return nullptr;
    return std::make_shared<const FrontEnd>(
        FrontEnd{item.key, true, sweep_.base, settings(*first, {})});
  }

  /// A number N for 1 to N, or a list.
  void readSeeds(const Node& seeds) {
    Axis axis;
    const auto seed = [&](const std::string& text, const Node& origin) {
      Node value{Node::Kind::Scalar, "seed", origin.origin, origin.origin};
      value.text = text;
      add(axis, {{{"seed", text}}, {{"seed", std::make_shared<const Node>(value)}}, nullptr},
          origin);
    };
    const Result<std::int64_t> count = config::readInteger(seeds.text);
    if (seeds.isSequence()) {
      for (const Node& item : seeds.children) seed(item.text, item);
    } else if (seeds.isScalar() && count.isOk() && count.value() > 0 && count.value() <= 10'000) {
      for (std::int64_t i = 1; i <= count.value(); ++i) seed(std::to_string(i), seeds);
    }
    if (axis.empty()) problem(seeds, "seeds", "expects how many, or a list such as [1, 2, 3]");
    sweep_.repeats.push_back(std::move(axis));
  }

  void readExclude(const Node& exclude) {
    if (!exclude.isSequence()) problem(exclude, "exclude", "expects a list of maps");
    for (const Node& item : exclude.children) {
      if (!item.isMap()) problem(item, "exclude", "expects a map from factors to values");
      Exclusion out{{}, item.origin};
      for (const Node& condition : item.children) {
        auto& added = out.conditions.emplace_back();
        added.factor = condition.key;
        if (condition.isSequence()) {
          for (const Node& value : condition.children) added.labels.push_back(labelOf(value));
        } else {
          added.labels.push_back(labelOf(condition));
        }
      }
      if (!out.conditions.empty()) sweep_.exclude.push_back(std::move(out));
    }
  }

  SweepFile& sweep_;
  config::Problems& problems_;
};

}  // namespace

SweepFile readSweep(const std::filesystem::path& file, const config::Environment& environment,
                    config::Problems& problems) {
  SweepFile sweep;
  sweep.file = file.string();
  sweep.name = file.stem().string();
  const config::Origin origin = config::Origin::ofFile(file.string());
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) {
    problems.push_back({origin, "", config::absence(file, "no such file")});
    return sweep;
  }
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  std::optional<Node> tree = config::readYaml(text, origin, problems, environment);
  if (!tree) return sweep;
  if (!tree->isMap()) {
    problems.push_back({origin, "", "a sweep is a map of keys, not " + config::describe(*tree)});
    return sweep;
  }
  Reader(sweep, problems).read(*tree);
  return sweep;
}

}  // namespace tolman::experiment
