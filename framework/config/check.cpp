// SPDX-License-Identifier: BSD-3-Clause
// Checks types, ranges, choices and names.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "config/text.hpp"
#include "config/values.hpp"

namespace tolman::config {
namespace {

std::string expectation(const ParameterInfo& info) {
  constexpr std::array kTypes = {"true or false",
                                 "an integer",
                                 "a number",
                                 "a text",
                                 "a path",
                                 "one of ",
                                 "a list of numbers such as [1, 2.5]"};
  return kTypes.at(static_cast<std::size_t>(info.type)) + listed(info.choices);
}

std::string rangeText(const ParameterInfo& info) {
  const std::string unit = info.unit.empty() ? "" : " " + info.unit;
  if (std::isinf(info.max)) return "at least " + writeReal(info.min) + unit;
  if (std::isinf(info.min)) return "at most " + writeReal(info.max) + unit;
  return writeReal(info.min) + " ... " + writeReal(info.max) + unit;
}

/// Reads the value of one parameter. Each failure is reported as one problem.
class ValueReader {
 public:
  ValueReader(const ParameterInfo& info, std::string path, const BaseFolders& folders,
              Problems& problems)
      : info_(info), path_(std::move(path)), folders_(folders), problems_(problems) {}

  std::optional<ParameterValue> read(const Node& node) {
    if (info_.type == ParameterType::RealList) return readList(node);
    if (!node.isScalar())
      return refuse(node, "expects " + expectation(info_) + ", not " + describe(node));
    switch (info_.type) {
      case ParameterType::Bool:
        return readPlain(node, &readBool);
      case ParameterType::Integer:
        return inRange(node, readPlain(node, &readInteger));
      case ParameterType::Real:
        return inRange(node, readPlain(node, &readReal));
      case ParameterType::Path:
        return readPath(node);
      case ParameterType::Choice:
        return readChoice(node);
      default:
        return node.text;
    }
  }

 private:
  std::nullopt_t refuse(const Node& node, const std::string& message) {
    problems_.push_back({node.origin, path_, message});
    return std::nullopt;
  }

  template <class T>
  std::optional<ParameterValue> readPlain(const Node& node,
                                          Result<T> (*parse)(const std::string&)) {
    const Result<T> value = parse(node.text);
    if (!value.isOk()) return refuse(node, value.status().message());
    if (node.quoted) {
      return refuse(node, "expects " + expectation(info_) + ", not a text; remove the quotes");
    }
    return value.value();
  }

  std::optional<ParameterValue> inRange(const Node& node, std::optional<ParameterValue> value) {
    if (!value) return value;
    const auto* integer = std::get_if<std::int64_t>(&*value);
    const double number =
        integer != nullptr ? static_cast<double>(*integer) : std::get<double>(*value);
    if (number >= info_.min && number <= info_.max) return value;
    return refuse(node, node.text + " is out of range: " + rangeText(info_));
  }

  std::optional<ParameterValue> readPath(const Node& node) {
    const Result<std::string> path = resolvePath(node.text, node.origin, folders_);
    if (!path.isOk()) return refuse(node, path.status().message());
    const std::string denied = absence(path.value(), "");
    if (!denied.empty()) return refuse(node, path.value() + ": " + denied);
    return path.value();
  }

  std::optional<ParameterValue> readChoice(const Node& node) {
    if (std::ranges::find(info_.choices, node.text) != info_.choices.end()) return node.text;
    return refuse(node, "expects " + expectation(info_) + ", not '" + node.text + "'" +
                            didYouMean(node.text, info_.choices));
  }

  std::optional<ParameterValue> readList(const Node& node) {
    if (!node.isSequence()) {
      return refuse(node, "expects " + expectation(info_) + ", not " + describe(node));
    }
    std::vector<double> list;
    for (const Node& item : node.children) {
      ParameterInfo number = info_;
      number.type = ParameterType::Real;
      const auto value =
          ValueReader(number, joinPath(path_, item.key), folders_, problems_).read(item);
      if (value) list.push_back(std::get<double>(*value));
    }
    if (list.size() < node.children.size()) return std::nullopt;
    return list;
  }

  const ParameterInfo& info_;
  std::string path_;
  const BaseFolders& folders_;
  Problems& problems_;
};

std::vector<std::string> namesOf(const Schema& schema) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : schema) names.push_back(info.name);
  return names;
}

/// Whether the doc of a parameter says "Formerly `key`.".
bool wasCalled(const ParameterInfo& info, const std::string& key) {
  const std::size_t formerly = info.doc.find("Formerly ");
  return formerly != std::string::npos &&
         info.doc.find('`' + key + '`', formerly) != std::string::npos;
}

void refuseUnknown(const Node& map, const Schema& schema, const Subject& subject,
                   Problems& problems) {
  const std::vector<std::string> own = namesOf(schema);
  std::vector<std::string> known = own;
  known.insert(known.end(), subject.also_known.begin(), subject.also_known.end());
  const std::string list = subject.owner.empty() ? "keys: " + listed(known)
                           : own.empty()         ? subject.owner + " has no parameters"
                                         : "parameters of " + subject.owner + ": " + listed(own);
  const std::string unknown = subject.owner.empty() ? "unknown key" : "unknown parameter";
  const auto notKnown = [&](const std::string& key) {
    return unknown + didYouMean(key, known) + " (" + list + ")";
  };
  for (const Node& child : map.children) {
    if (std::ranges::find(known, child.key) != known.end()) continue;
    const auto renamed = std::ranges::find_if(
        schema, [&](const ParameterInfo& info) { return wasCalled(info, child.key); });
    problems.push_back(
        {child.key_origin, joinPath(subject.path, child.key),
         renamed != schema.end() ? "was renamed to '" + renamed->name + "'" : notKnown(child.key)});
  }
}

/// The default; paths are resolved.
ParameterValue defaultOf(const ParameterInfo& info, const BaseFolders& folders) {
  if (info.type != ParameterType::Path) return info.default_value;
  const auto path = resolvePath(std::get<std::string>(info.default_value), {}, folders);
  return path.isOk() ? path.value() : info.default_value;
}

}  // namespace

ParameterValues check(const Node& map, const Schema& schema, const Subject& subject,
                      const BaseFolders& folders, Problems& problems) {
  if (!map.isMap()) {
    problems.push_back({map.origin, subject.path, "expects a map of keys, not " + describe(map)});
  }
  if (map.isMap()) refuseUnknown(map, schema, subject, problems);
  ParameterValues values;
  for (const ParameterInfo& info : schema) {
    values[info.name] = defaultOf(info, folders);
    const std::string path = joinPath(subject.path, info.name);
    if (const Node* given = map.find(info.name)) {
      const auto value = ValueReader(info, path, folders, problems).read(*given);
      if (value) values[info.name] = *value;
    } else if (info.required && map.isMap()) {
      const std::string who = subject.owner.empty() ? "" : " for " + subject.owner;
      problems.push_back({map.origin, path, "is missing" + who + ": " + info.doc});
    }
  }
  return values;
}

}  // namespace tolman::config
