// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/sweep_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/text_file.hpp"
#include "config/loader.hpp"
#include "config/settings.hpp"
#include "config/text.hpp"
#include "config/values.hpp"
#include "tolman/context.hpp"
#include "tolman/parameters.hpp"

namespace tolman::experiment {

namespace {

using config::Node;
using NodePointer = std::shared_ptr<const Node>;

/// Columns beside the factors in the table of csvOf() (comparison.hpp).
constexpr std::array kTableColumns = {"name", "alignment", "truth_sha256", "results_sha256"};

/// A scalar, the plugin of a stage, the values of a map, or a list in brackets.
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

struct GeneralKeys {
  std::string name;
  std::string base;
  bool reuse = true;
  static constexpr auto declaration() {
    return parameters(
        parameter("name", &GeneralKeys::name),
        parameter("base", &GeneralKeys::base).required().doc("the configuration that is varied"),
        parameter("reuse", &GeneralKeys::reuse));
  }
};

struct SampleKeys {
  std::int64_t count = 1;
  std::int64_t seed = 1;
  static constexpr auto declaration() {
    return parameters(parameter("count", &SampleKeys::count)
                          .range(1, 100'000)
                          .required()
                          .doc("the number of points"),
                      parameter("seed", &SampleKeys::seed).range(0, config::kNoLimit));
  }
};

/// The range of one key of random samples.
struct RangeKeys {
  double min = 0;
  double max = 1;
  bool log = false;
  bool integer = false;
  static constexpr auto declaration() {
    return parameters(parameter("min", &RangeKeys::min).required().doc("the lowest value"),
                      parameter("max", &RangeKeys::max).required().doc("the highest value"),
                      parameter("log", &RangeKeys::log), parameter("integer", &RangeKeys::integer));
  }
  /// The value at this share of the range.
  std::string at(double share) const {
    if (integer) return fmt::format("{}", std::llround(std::floor(min + share * (max - min + 1))));
    const double value = log ? std::exp(std::log(min) + share * (std::log(max) - std::log(min)))
                             : min + share * (max - min);
    return fmt::format("{:.8g}", value);
  }
};

NodePointer pointerTo(const Node* node) {
  return node == nullptr ? nullptr : std::make_shared<const Node>(*node);
}

NodePointer scalarOf(const std::string& key, const std::string& text, const config::Origin& where) {
  Node node{Node::Kind::Scalar, key, where, where};
  node.text = text;
  return std::make_shared<const Node>(std::move(node));
}

class Reader {
 public:
  Reader(SweepFile& sweep, config::Problems& problems) : sweep_(sweep), problems_(problems) {}

  void read(const Node& tree) {
    const auto keys = read<GeneralKeys>(
        tree, "", {"set", "grid", "list", "random", "sequences", "seeds", "exclude"});
    if (!keys.name.empty()) sweep_.name = keys.name;
    sweep_.reuse = keys.reuse;
    sweep_.base = pointerTo(tree.find("base"));
    sweep_.settings = settings(map(tree, "set"), {});
    for (const Node& key : map(tree, "grid").children) readGrid(key);
    for (const Node& list : map(tree, "list").children) readList(list);
    if (const Node* samples = tree.find("random")) readSamples(*samples);
    if (const Node* sequences = tree.find("sequences")) readSequences(*sequences);
    if (const Node* seeds = tree.find("seeds")) readSeeds(*seeds);
    if (const Node* exclude = tree.find("exclude")) readExclude(*exclude);
  }

 private:
  void problem(const Node& where, const std::string& path, const std::string& message) {
    problems_.push_back({where.origin, path, message});
  }

  template <class Keys>
  Keys read(const Node& map, const std::string& path, const std::vector<std::string>& also_known) {
    return bindParameters<Keys>(
               config::check(map, schemaOf<Keys>(), {path, "", also_known}, {}, problems_))
        .value();
  }

  /// The map of this key; an empty one where there is none.
  const Node& map(const Node& parent, const std::string& key) {
    static const Node kNone;
    const Node* node = parent.find(key);
    if (node != nullptr && !node->isMap()) {
      problem(*node, key, "expects a map, not " + config::describe(*node));
    }
    return node != nullptr && node->isMap() ? *node : kNone;
  }

  /// The maps in a list.
  const std::vector<Node>& maps(const Node& list, const std::string& key) {
    static const std::vector<Node> kNone;
    const bool are_maps = list.isSequence() && std::ranges::all_of(list.children, &Node::isMap);
    if (!are_maps) problem(list, key, "expects a list of maps");
    return are_maps ? list.children : kNone;
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
  void add(std::vector<Axis>& axes, Axis axis, const Node& origin, const std::string& name) {
    if (axis.empty()) problem(origin, name, "has no values");
    axes.push_back(std::move(axis));
  }

  /// key: [values], or key: {label: value}.
  void readGrid(const Node& key) {
    Axis axis;
    if (key.isScalar()) problem(key, key.key, "expects a list of values, not one");
    for (const Node& value : key.children) {
      const std::string label = key.isMap() ? value.key : labelOf(value);
      add(axis, {{{key.key, label}}, {{key.key, pointerTo(&value)}}, nullptr}, value);
    }
    add(sweep_.axes, std::move(axis), key, key.key);
  }

  /// name: {label: {key: value}}
  void readList(const Node& list) {
    Axis axis;
    if (std::ranges::find(kTableColumns, list.key) != kTableColumns.end()) {
      problem(list, list.key, "is a column of the table of `sweep collect`; rename the factor");
    }
    if (!list.isMap()) problem(list, list.key, "expects a map from labels to settings");
    for (const Node& item : list.children) {
      if (!item.isMap()) problem(item, item.key, "expects a map of settings");
      Choice choice{{{list.key, item.key}}, settings(item, {"first_session"}), nullptr};
      if (item.find("first_session") != nullptr) {
        choice.front_end = std::make_shared<const FrontEnd>(
            FrontEnd{item.key, true, sweep_.base, settings(map(item, "first_session"), {})});
      }
      add(axis, std::move(choice), item);
    }
    add(sweep_.axes, std::move(axis), list, list.key);
  }

  /// {count: N, seed: S, keys: {key: {min: A, max: B, log: true, integer: true}}}
  void readSamples(const Node& samples) {
    const auto keys = read<SampleKeys>(samples, "random", {"keys"});
    const std::vector<Node>& ranged = map(samples, "keys").children;
    if (ranged.empty()) problem(samples, "random", "expects keys");
    std::vector<RangeKeys> ranges;
    for (const Node& key : ranged) ranges.push_back(range(key));
    RandomStream random(static_cast<std::uint64_t>(keys.seed));
    Axis axis(static_cast<std::size_t>(keys.count));
    for (Choice& choice : axis) {
      for (std::size_t d = 0; d < ranged.size(); ++d) {
        const std::string value = ranges[d].at(random.uniform());
        choice.factors.push_back({ranged[d].key, value});
        choice.settings.push_back(
            {ranged[d].key, scalarOf(ranged[d].key, value, ranged[d].origin)});
      }
    }
    if (!ranged.empty()) sweep_.axes.push_back(std::move(axis));
  }

  RangeKeys range(const Node& node) {
    if (!node.isMap()) {
      problem(node, node.key, "expects a range such as {min: 50, max: 300}");
      return {};
    }
    const auto range = read<RangeKeys>(node, node.key, {});
    const bool is_whole = std::trunc(range.min) == range.min && std::trunc(range.max) == range.max;
    if (range.integer && !is_whole) {
      problem(node, node.key, "expects whole numbers for min and max with integer");
    }
    if (range.min <= range.max && (!range.log || (range.min > 0 && !range.integer))) return range;
    problem(node, node.key, "is no range; max must be above min, and min above 0 with log");
    return {};
  }

  /// label: PATH for source.path, or label: {key: value}; front_end: FILE or {base: , key: value}.
  void readSequences(const Node& sequences) {
    Axis axis;
    if (!sequences.isMap()) problem(sequences, "sequences", "expects a map of labels");
    for (const Node& item : sequences.children) {
      Choice choice{{{"sequence", item.key}}, settings(item, {"front_end"}), nullptr};
      if (item.isScalar()) choice.settings.push_back({"source.path", pointerTo(&item)});
      if (item.isSequence()) problem(item, item.key, "expects a path, or a map of settings");
      if (const Node* front = item.find("front_end")) choice.front_end = frontEnd(*front, item.key);
      add(axis, std::move(choice), item);
    }
    add(sweep_.repeats, std::move(axis), sequences, "sequences");
  }

  std::shared_ptr<const FrontEnd> frontEnd(const Node& node, const std::string& label) {
    const Node* base = node.isMap() ? node.find("base") : &node;
    if (base != nullptr && base->isScalar()) {
      return std::make_shared<const FrontEnd>(
          FrontEnd{label, false, pointerTo(base), settings(node, {"base"})});
    }
    problem(node, "front_end", "expects a configuration, or a map with 'base' and settings");
    return nullptr;
  }

  /// A number N for 1 to N, or a list.
  void readSeeds(const Node& seeds) {
    Axis axis;
    const auto seed = [&](const std::string& text, const Node& origin) {
      add(axis, {{{"seed", text}}, {{"seed", scalarOf("seed", text, origin.origin)}}, nullptr},
          origin);
    };
    for (const Node& item : seeds.children) seed(item.text, item);
    const Result<std::int64_t> count = config::readInteger(seeds.text);
    const std::int64_t last = count.isOk() && count.value() <= 10'000 ? count.value() : 0;
    for (std::int64_t i = 1; i <= last; ++i) seed(std::to_string(i), seeds);
    if (axis.empty()) problem(seeds, "seeds", "expects how many, or a list such as [1, 2, 3]");
    sweep_.repeats.push_back(std::move(axis));
  }

  void readExclude(const Node& exclude) {
    for (const Node& item : maps(exclude, "exclude")) {
      Exclusion out{{}, item.origin};
      for (const Node& condition : item.children) {
        auto& labels =
            out.conditions.emplace_back(condition.key, std::vector<std::string>()).second;
        if (!condition.isSequence()) labels.push_back(labelOf(condition));
        for (const Node& value :
             condition.isSequence() ? condition.children : std::vector<Node>()) {
          labels.push_back(labelOf(value));
        }
      }
      if (!out.conditions.empty()) sweep_.exclude.push_back(std::move(out));
    }
  }

  SweepFile& sweep_;
  config::Problems& problems_;
};

constexpr std::size_t kMaxPoints = 100'000;

void join(SweepPoint& point, const Choice& choice) {
  for (const Factor& factor : choice.factors) point.factors.push_back(factor);
  for (const Setting& setting : choice.settings) point.settings.push_back(setting);
  if (choice.front_end) point.front_end = choice.front_end;
}

/// Combines each point with each choice; the axis varies fastest.
std::vector<SweepPoint> times(const std::vector<SweepPoint>& points, const Axis& axis) {
  std::vector<SweepPoint> product;
  for (const SweepPoint& point : points) {
    for (const Choice& choice : axis) {
      if (product.size() > kMaxPoints) return product;
      join(product.emplace_back(point), choice);
    }
  }
  return product;
}

/// The keys of single values that a setting sets.
void addKeys(const std::string& key, const config::Node& value,
             std::map<std::string, config::Origin>& keys) {
  if (!value.isMap() || value.children.empty()) keys.emplace(key, value.origin);
  if (!value.isMap()) return;
  for (const config::Node& child : value.children) addKeys(key + "." + child.key, child, keys);
}

/// The keys and factors that an axis sets.
std::map<std::string, config::Origin> keysOf(const Axis& axis) {
  std::map<std::string, config::Origin> keys;
  for (const Choice& choice : axis) {
    for (const Setting& setting : choice.settings) addKeys(setting.key, *setting.value, keys);
    for (const Factor& factor : choice.factors) {
      const auto& settings = choice.settings;
      keys.emplace("factor " + factor.name,
                   settings.empty() ? config::Origin() : settings.front().value->origin);
    }
  }
  return keys;
}

/// Refuses axes that set the same key: the later one would win, and the other's label be wrong.
void refuseOverlaps(const SweepFile& sweep, config::Problems& problems) {
  const auto refuse = [&](const Axis& a, const Axis& b) {
    const auto others = keysOf(a);
    for (const auto& [key, origin] : keysOf(b)) {
      const auto same = std::ranges::find_if(others, [&](const auto& other) {
        return key == other.first || key.starts_with(other.first + ".") ||
               other.first.starts_with(key + ".");
      });
      if (same == others.end()) continue;
      problems.push_back({origin, key,
                          "is set at " + config::text(same->second) +
                              " for the same runs; remove one of the two"});
      return;
    }
  };
  std::vector<const Axis*> product;
  for (const auto* axes : {&sweep.axes, &sweep.repeats}) {
    for (const Axis& axis : *axes) {
      for (const Axis* other : product) refuse(*other, axis);
      product.push_back(&axis);
    }
  }
}

void removeExcluded(std::vector<SweepPoint>& points, const SweepFile& sweep,
                    config::Problems& problems) {
  std::vector<std::string> names;
  for (const SweepPoint& point : points) {
    for (const Factor& factor : point.factors) {
      if (std::ranges::find(names, factor.name) == names.end()) names.push_back(factor.name);
    }
  }
  for (const Exclusion& exclusion : sweep.exclude) {
    const auto refuse = [&](const std::string& why) {
      problems.push_back({exclusion.origin, "exclude", why});
    };
    for (const auto& [factor, labels] : exclusion.conditions) {
      if (std::ranges::find(names, factor) != names.end()) continue;
      refuse("no factor '" + factor + "'" + config::didYouMean(factor, names) +
             "; factors: " + config::listed(names));
    }
    const std::size_t removed = std::erase_if(points, [&](const SweepPoint& point) {
      return std::ranges::all_of(exclusion.conditions, [&](const auto& condition) {
        return std::ranges::any_of(point.factors, [&](const Factor& factor) {
          return factor.name == condition.first &&
                 std::ranges::find(condition.second, factor.label) != condition.second.end();
        });
      });
    });
    if (removed == 0) refuse("leaves out no point; remove the entry, or correct its labels");
    if (points.empty()) return refuse("leaves out all points that were left");
  }
}

/// Names of factors, shortened to the last part if that is unique: "period" for "cells.period".
std::map<std::string, std::string> shortNames(const std::vector<SweepPoint>& points) {
  std::map<std::string, std::set<std::string>> by_end;
  for (const SweepPoint& point : points) {
    for (const Factor& factor : point.factors) {
      by_end[factor.name.substr(factor.name.rfind('.') + 1)].insert(factor.name);
    }
  }
  std::map<std::string, std::string> names;
  for (const auto& [end, full] : by_end) {
    for (const std::string& name : full) names[name] = full.size() == 1 ? end : name;
  }
  return names;
}

void nameAll(std::vector<SweepPoint>& points, const SweepFile& sweep) {
  const auto names = shortNames(points);
  std::map<std::string, int> taken;
  for (SweepPoint& point : points) {
    for (const Factor& factor : point.factors) {
      point.name += (point.name.empty() ? "" : ",") + names.at(factor.name) + "=" + factor.label;
    }
    if (point.name.empty()) point.name = sweep.name;
    const int before = taken[point.name]++;
    if (before > 0) point.name += "#" + std::to_string(before + 1);
  }
}

}  // namespace

SweepFile readSweep(const std::filesystem::path& file, const config::Environment& environment,
                    config::Problems& problems) {
  SweepFile sweep;
  sweep.file = file.string();
  sweep.name = file.stem().string();
  const config::Origin origin = config::Origin::ofFile(file.string());
  const Result<std::string> text = text_encoding::readText(file);
  if (!text.isOk()) {
    problems.push_back({origin, "", text.status().message().substr(file.string().size() + 2)});
    return sweep;
  }
  std::optional<Node> tree = config::readYaml(text.value(), origin, problems, environment);
  if (!tree) return sweep;
  if (!tree->isMap()) {
    problems.push_back({origin, "", "a sweep is a map of keys, not " + config::describe(*tree)});
    return sweep;
  }
  Reader(sweep, problems).read(*tree);
  return sweep;
}

std::vector<SweepPoint> pointsOf(const SweepFile& sweep, config::Problems& problems) {
  refuseOverlaps(sweep, problems);
  std::vector<SweepPoint> points(1);
  for (const Axis& axis : sweep.axes) points = times(points, axis);
  for (const Axis& axis : sweep.repeats) points = times(points, axis);
  if (points.size() > kMaxPoints) {
    problems.push_back({config::Origin::ofFile(sweep.file), "", "has more than 100000 points"});
    return {};
  }
  removeExcluded(points, sweep, problems);
  nameAll(points, sweep);
  return points;
}

}  // namespace tolman::experiment
