// SPDX-License-Identifier: BSD-3-Clause
// Parameters: declared once, beside the struct that holds them.
//
//   struct Parameters {
//     int columns = 60;
//     double threshold = 0.085;
//     static constexpr auto declaration() {
//       return tolman::parameters(
//           tolman::parameter("columns", &Parameters::columns)
//               .range(1, 512).unit("cells").doc("Width of a template."),
//           tolman::parameter("threshold", &Parameters::threshold)
//               .range(0, 1).doc("Largest distance of a match."));
//     }
//   };
//
// The names `plugin`, `name`, `on_failure` and `isolation` are the host's. The member's initialiser
// is the default. Member types: bool, int, std::int64_t, double, std::string, std::vector<double>,
// and enumerations with enumNames(). From the declaration the host derives checks of configurations
// (errors with line and column), `tolman plugins describe`, and the reference pages.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "tolman/fields.hpp"
#include "tolman/status.hpp"

namespace tolman {

enum class ParameterType : std::uint8_t { Bool, Integer, Real, Text, Path, Choice, RealList };

/// Text, Path and Choice are std::string; every other type has an alternative of its own.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;
using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

/// One parameter as the host sees it.
struct ParameterInfo {
  std::string name;
  ParameterType type = ParameterType::Real;
  ParameterValue default_value;
  bool required = false;  ///< no default: the configuration must give it
  double min = -std::numeric_limits<double>::infinity();  ///< inclusive; for each item of a list
  double max = std::numeric_limits<double>::infinity();
  std::string unit;
  std::string doc;
  std::vector<std::string> choices;  ///< for Choice
};
using Schema = std::vector<ParameterInfo>;

/// One parameter as its author declares it; made by parameter().
template <class P, class T>
struct Parameter {
  std::string_view name;
  T P::*member;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::string_view unit_text = {};
  std::string_view doc_text = {};
  bool is_required = false;
  bool is_path = false;

  /// Smallest and largest legal value, inclusive.
  constexpr Parameter range(double smallest, double largest) const {
    Parameter copy = *this;
    copy.min = smallest;
    copy.max = largest;
    return copy;
  }
  constexpr Parameter unit(std::string_view text) const {
    Parameter copy = *this;
    copy.unit_text = text;
    return copy;
  }
  /// One sentence for a user.
  constexpr Parameter doc(std::string_view text) const {
    Parameter copy = *this;
    copy.doc_text = text;
    return copy;
  }
  constexpr Parameter required() const {
    Parameter copy = *this;
    copy.is_required = true;
    return copy;
  }
  /// A text that names a file or folder: the host expands `~` and makes it absolute, relative to
  /// the configuration file that says it, or to the working directory on the command line.
  constexpr Parameter path() const requires std::is_same_v<T, std::string> {
    Parameter copy = *this;
    copy.is_path = true;
    return copy;
  }

  static constexpr ParameterType plainType() {
    if constexpr (std::is_same_v<T, bool>) return ParameterType::Bool;
    if constexpr (std::is_integral_v<T>) return ParameterType::Integer;
    if constexpr (std::is_floating_point_v<T>) return ParameterType::Real;
    if constexpr (std::is_enum_v<T>) return ParameterType::Choice;
    if constexpr (std::is_same_v<T, std::string>) return ParameterType::Text;
    return ParameterType::RealList;
  }
  constexpr ParameterType type() const { return is_path ? ParameterType::Path : plainType(); }
};

template <class P, class T>
constexpr Parameter<P, T> parameter(std::string_view name, T P::*member) {
  static_assert(std::is_same_v<T, bool> || std::is_same_v<T, int> ||
                    std::is_same_v<T, std::int64_t> || std::is_same_v<T, double> || NamedEnum<T> ||
                    std::is_same_v<T, std::string> || std::is_same_v<T, std::vector<double>>,
                "a parameter is bool, int, int64, double, a named enum, string or list of double");
  Parameter<P, T> declared{name, member};
  if constexpr (std::is_same_v<T, int>) {  // what fits into the member
    declared.min = std::numeric_limits<int>::min();
    declared.max = std::numeric_limits<int>::max();
  }
  return declared;
}

template <class... Declared>
constexpr std::tuple<Declared...> parameters(Declared... declared) {
  return {declared...};
}

/// For plugins without parameters.
struct NoParameters {
  static constexpr auto declaration() { return parameters(); }
};

namespace detail {

// Not inlined: otherwise g++ 12 at -O3 warns falsely about the destructor of a std::string in the
// variant.
template <class T>
[[gnu::noinline]] ParameterValue toValue(const T& member) {
  if constexpr (std::is_enum_v<T>) {
    return std::string(enumName(member));
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    return static_cast<std::int64_t>(member);
  } else {
    return member;
  }
}

/// False when the value has the wrong type or is no name of the enumeration.
template <class T>
bool fromValue(const ParameterValue& value, T& member) {
  if constexpr (std::is_enum_v<T>) {
    const auto* text = std::get_if<std::string>(&value);
    const auto names = enumNames(T{});
    for (std::size_t i = 0; text != nullptr && i < names.size(); ++i) {
      if (names[i] != *text) continue;
      member = static_cast<T>(i);
      return true;
    }
    return false;
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    const auto* number = std::get_if<std::int64_t>(&value);
    if (number != nullptr) member = static_cast<T>(*number);
    return number != nullptr;
  } else {
    const auto* typed = std::get_if<T>(&value);
    if (typed != nullptr) member = *typed;
    return typed != nullptr;
  }
}

constexpr std::uint64_t fnv1a(std::uint64_t hash, std::string_view text) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return (hash ^ 0xff) * 0x100000001b3ULL;  // separates two texts
}

constexpr std::uint64_t fnv1a(std::uint64_t hash, double number) {
  auto bits = std::bit_cast<std::uint64_t>(number);
  for (int i = 0; i < 8; ++i, bits >>= 8U) hash = (hash ^ (bits & 0xffU)) * 0x100000001b3ULL;
  return hash;
}

}  // namespace detail

/// A hash of names, types, ranges, units and choices. Declarations with equal hashes accept the
/// same configurations. The hash is in the manifest, so the host can compare it without running
/// code of the plugin.
template <class P>
constexpr std::uint64_t schemaHash() {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  std::apply(
      [&](const auto&... p) {
        const auto add = [&hash]<class T>(const Parameter<P, T>& q) {
          hash = detail::fnv1a(hash, q.name);
          hash = detail::fnv1a(hash, static_cast<double>(q.type()) + (q.is_required ? 0.5 : 0));
          hash = detail::fnv1a(detail::fnv1a(hash, q.min), q.max);
          hash = detail::fnv1a(hash, q.unit_text);
          if constexpr (std::is_enum_v<T>) {
            for (const std::string_view choice : enumNames(T{})) hash = detail::fnv1a(hash, choice);
          }
        };
        (add(p), ...);
      },
      P::declaration());
  return hash;
}

/// The declaration as plain data, defaults included.
template <class P>
Schema schemaOf() {
  const P defaults{};
  Schema schema;
  const auto add = [&]<class T>(const Parameter<P, T>& p) {
    ParameterInfo info;
    info.name = std::string(p.name);
    info.type = p.type();
    info.default_value = detail::toValue(defaults.*p.member);
    info.required = p.is_required;
    info.min = p.min;
    info.max = p.max;
    info.unit = std::string(p.unit_text);
    info.doc = std::string(p.doc_text);
    if constexpr (std::is_enum_v<T>) {
      for (const std::string_view choice : enumNames(T{})) info.choices.emplace_back(choice);
    }
    schema.push_back(std::move(info));
  };
  std::apply([&](const auto&... p) { (add(p), ...); }, P::declaration());
  return schema;
}

/// Fills the struct from checked values; absent ones keep their default. The host has already
/// refused unknown names, wrong types and values out of range.
template <class P>
Result<P> bindParameters(const ParameterValues& values) {
  P bound{};
  std::string wrong;
  const auto bind = [&](const auto& p) {
    const auto found = values.find(p.name);
    if (found == values.end()) return;
    if (!detail::fromValue(found->second, bound.*p.member)) wrong = p.name;
  };
  std::apply([&](const auto&... p) { (bind(p), ...); }, P::declaration());
  if (!wrong.empty()) return Status::invalidParameter("parameter '" + wrong + "' has a wrong type");
  return bound;
}

}  // namespace tolman
