// SPDX-License-Identifier: BSD-3-Clause
// How a record declares its fields.
//
// A record is a plain struct with a name, `static constexpr const char* kRecord`, and one function
//
//   template <class Self, class Visit>
//   static void fields(Self& self, Visit&& visit) {
//     TOLMAN_FIELD(stamp_ns, "ns", "data time of the exposure");
//   }
//
// From that list are derived the tables of run.sqlite, JSON, the NaN check at the plugin boundary,
// the messages to isolated stages and viewers, and the reference page. Members may be: bool,
// integers, float, double, enumerations with enumNames(), std::string, Eigen vectors and matrices
// of float or double, Eigen::Isometry3d, Image, other records, and std::vector of records.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tolman/image.hpp"

namespace tolman {

/// Name, unit (SI by default, "" for none) and one line about a record's field.
struct Field {
  std::string_view name;
  std::string_view unit;
  std::string_view doc;
};

/// Names one member inside fields(); the member's name is the field's name.
#define TOLMAN_FIELD(member, unit, doc) visit(::tolman::Field{#member, unit, doc}, self.member)

template <class T>
concept Record = requires {
  { T::kRecord } -> std::convertible_to<std::string_view>;
};

/// Calls visit(Field, member) for each field, in the order of declaration.
template <class R, class Visit>
requires Record<std::remove_const_t<R>>
void visitFields(R& record, Visit&& visit) { std::remove_const_t<R>::fields(record, visit); }

/// A named numeric array: neural activity for a viewer, or a sensor beside the images. What its
/// numbers mean is described once per run, by an ArrayInfo of the same name.
struct NamedArray {
  static constexpr const char* kRecord = "named_array";
  std::string name;           ///< e.g. "hd.activity"
  std::vector<int> shape;     ///< e.g. {36} or {rows, columns}; row-major
  std::vector<float> values;  ///< as many as the product of shape

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(name, "", "name of the array");
    TOLMAN_FIELD(shape, "", "size of each axis, row-major");
    TOLMAN_FIELD(values, "", "the numbers");
  }
};

/// An enumeration with names, listed in the order of its values from 0, by a function in the
/// namespace of the enumeration (for a nested one: a friend of the class):
///
///   enum class Colour : std::uint8_t { Red, Green };
///   inline constexpr std::array<std::string_view, 2> kColourNames = {"red", "green"};
///   constexpr std::span<const std::string_view> enumNames(Colour) { return kColourNames; }
template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E e) {
  { enumNames(e) } -> std::convertible_to<std::span<const std::string_view>>;
};

template <NamedEnum E>
constexpr std::string_view enumName(E value) {
  const std::span<const std::string_view> names = enumNames(value);
  const auto index = static_cast<std::size_t>(value);
  return index < names.size() ? names[index] : std::string_view("invalid");
}

/// The kind of data in a NamedArray, for viewers and figures.
enum class ArrayKind : std::uint8_t {
  Values,      ///< plain numbers
  Activity,    ///< firing rates of a population: one axis for each dimension of its units
  Bump,        ///< Gaussian bumps of a population; the last axis has the labelled components:
               ///< first the mean along each axis of the population, then any others
  DepthImage,  ///< depth of each pixel along the optical axis; axes: row, column
};
inline constexpr std::array<std::string_view, 4> kArrayKindNames = {"values", "activity", "bump",
                                                                    "depth_image"};
constexpr std::span<const std::string_view> enumNames(ArrayKind) { return kArrayKindNames; }

/// One axis of a NamedArray. Index i stands for the value first + i * step, modulo `period`.
struct ArrayAxis {
  static constexpr const char* kRecord = "array_axis";
  std::string name;                 ///< e.g. "heading", "x", "row", "component"
  std::string unit;                 ///< of first, step and period; "" for a plain index
  double first = 0;                 ///< value of index 0: the phase of unit 0
  double step = 1;                  ///< from one index to the next
  double period = 0;                ///< length of a periodic axis; 0 if it is not periodic
  std::vector<std::string> labels;  ///< one for each index, or no labels

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(name, "", "what varies along the axis");
    TOLMAN_FIELD(unit, "", "unit of first, step and period");
    TOLMAN_FIELD(first, "", "value of index 0");
    TOLMAN_FIELD(step, "", "difference between neighbouring indices");
    TOLMAN_FIELD(period, "", "length of a periodic axis; 0 if it does not wrap around");
    TOLMAN_FIELD(labels, "", "name of each index, or none");
  }
};

/// Description of the NamedArray of the same name, constant over a run. It is a separate struct
/// because NamedArray crosses the plugin boundary: its layout is fixed within a major version.
struct ArrayInfo {
  static constexpr const char* kRecord = "array_info";
  std::string name;
  ArrayKind kind = ArrayKind::Values;
  std::string unit;             ///< of the values
  std::string doc;              ///< one line
  std::string population;       ///< Bump: name of the Activity array whose axes the mean refers to
  std::vector<ArrayAxis> axes;  ///< one for each axis of the shape

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(name, "", "name of the array that is described");
    TOLMAN_FIELD(kind, "", "values, activity, bump or depth_image");
    TOLMAN_FIELD(unit, "", "unit of the values");
    TOLMAN_FIELD(doc, "", "what the numbers are");
    TOLMAN_FIELD(population, "", "of a bump: the activity array whose axes its mean refers to");
    TOLMAN_FIELD(axes, "", "one for each axis of the shape");
  }
};

/// A place that a recogniser found most alike, whether or not it answers with it: for explanations
/// alone, no stage depends on it.
struct Candidate {
  static constexpr const char* kRecord = "candidate";
  std::int64_t template_id = -1;
  double score = 0;            ///< as PlaceObservation::score
  double limit = 0;            ///< the largest score of a familiar place
  std::int64_t agreeing = -1;  ///< landmarks that agree on a pose; -1: none were compared
  std::int64_t compared = -1;  ///< landmarks that were found again
  std::int64_t needed = -1;    ///< fewest landmarks that must agree
  std::string reason;          ///< why it is not the answer; empty where the numbers say it

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(template_id, "", "the template");
    TOLMAN_FIELD(score, "", "its distance, in the plugin's measure");
    TOLMAN_FIELD(limit, "", "largest score of a familiar place");
    TOLMAN_FIELD(agreeing, "", "landmarks that agree on a pose, -1 if none were compared");
    TOLMAN_FIELD(compared, "", "landmarks that were found again");
    TOLMAN_FIELD(needed, "", "fewest landmarks that must agree");
    TOLMAN_FIELD(reason, "", "why it is not the answer; empty where the numbers say it");
  }
};

/// What a frame did to a hypothesis of the cells.
enum class Fate : std::uint8_t { Born, Grew, Accepted, Faded, Displaced };
inline constexpr std::array<std::string_view, 5> kFateNames = {"born", "grew", "accepted", "faded",
                                                               "displaced"};
constexpr std::span<const std::string_view> enumNames(Fate) { return kFateNames; }

/// A place at which the cells suppose the robot to be, at a frame that changed it. For explanations
/// alone, no stage depends on it.
struct PlaceHypothesis {
  static constexpr const char* kRecord = "hypothesis";
  std::int64_t id = -1;          ///< 0, 1, 2 ... in the order of creation
  Fate fate = Fate::Born;        ///< born, grew: by a view; faded: without views for too long;
                                 ///< displaced: by stronger ones
  std::int64_t experience = -1;  ///< where the robot would be; -1: as before
  double energy = 0;             ///< nats, after the change
  double change = 0;             ///< nats, what the view added
  double share = 0;              ///< of all hypotheses: its probability
  double limit = 0;              ///< share above which it is accepted
  std::int64_t views = 0;        ///< that supported it so far
  double unsupported = 0;        ///< m driven since the view before

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(id, "", "0, 1, 2 ... in the order of creation");
    TOLMAN_FIELD(fate, "", "born, grew, accepted, faded or displaced");
    TOLMAN_FIELD(experience, "", "where the robot would be, -1 for as before");
    TOLMAN_FIELD(energy, "nats", "energy after the change");
    TOLMAN_FIELD(change, "nats", "what the view of the frame added");
    TOLMAN_FIELD(share, "", "its probability among all hypotheses");
    TOLMAN_FIELD(limit, "", "share above which it is accepted");
    TOLMAN_FIELD(views, "", "number of views that supported it so far");
    TOLMAN_FIELD(unsupported, "m", "distance driven since the view before");
  }
};

namespace detail {

template <class T>
bool allFinite(const T& value);

template <class T>
bool allFinite(const std::vector<T>& values) {
  return std::ranges::all_of(values, [](const T& value) { return allFinite(value); });
}

template <class T>
bool allFinite(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(value);
  } else if constexpr (NamedEnum<T>) {
    return static_cast<std::size_t>(value) < enumNames(value).size();
  } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    return value.matrix().allFinite();
  } else if constexpr (Record<T>) {
    bool finite = true;
    visitFields(value, [&](const Field&, const auto& v) { finite = finite && allFinite(v); });
    return finite;
  } else if constexpr (std::is_base_of_v<Eigen::DenseBase<T>, T>) {
    return value.allFinite();
  } else {
    return true;  // integers, text, pixels
  }
}

}  // namespace detail

/// The name of the first field that holds NaN, infinity or an impossible enumeration value;
/// empty if there is none.
template <Record R>
std::string firstInvalidField(const R& record) {
  std::string bad;
  visitFields(record, [&](const Field& field, const auto& value) {
    if (bad.empty() && !detail::allFinite(value)) bad = field.name;
  });
  return bad;
}

}  // namespace tolman
