// SPDX-License-Identifier: BSD-3-Clause
// Maps the fields of a record to columns of a table: one Codec per type, which describes the
// columns, binds a value to them and reads it back.
//
// Isometry3d: seven REAL columns _x _y _z _qx _qy _qz _qw (w >= 0). Matrices: one BLOB, row-major,
// little-endian; the column count of a dynamic one follows from the size. Enumerations: TEXT.
// Images are not stored. Lists of arrays go to table `array`, lists of records to their own table.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "config/limits.hpp"
#include "config/text.hpp"
#include "record/sqlite.hpp"
#include "tolman/fields.hpp"

namespace tolman::record {

static_assert(std::endian::native == std::endian::little, "blobs are little-endian");

struct Column {
  std::string name;
  std::string type;  ///< INTEGER, REAL, TEXT or BLOB
  std::string unit;
  std::string doc;
};
using Columns = std::vector<Column>;

/// Column names have '_' where member names have '.'.
inline std::string columnName(std::string_view field) {
  std::string name(field);
  for (char& c : name) c = c == '.' ? '_' : c;
  return name;
}

inline Column columnOf(const Field& field, std::string type) {
  return {columnName(field.name), std::move(type), std::string(field.unit), std::string(field.doc)};
}

template <class T>
struct Codec;

template <class Stored>
inline constexpr Stored kMaxNumber = config::kMaxNumber;
template <>
inline constexpr std::int64_t kMaxNumber<std::int64_t> = config::kMaxInteger;

/// Throws BadRow if |number| is above `most`, and for NaN.
template <class Stored>
void checkNumber(Stored number, Stored most) {
  if (number >= -most && number <= most) return;
  throw BadRow("a number is larger than any run has");
}

template <class T>
inline constexpr bool kIsMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T>;

template <class T>
requires std::is_arithmetic_v<T>
struct Codec<T> {
  using Stored = std::conditional_t<std::is_integral_v<T>, std::int64_t, double>;
  static void describe(const Field& f, Columns& out) {
    out.push_back(columnOf(f, std::is_integral_v<T> ? "INTEGER" : "REAL"));
  }
  static void bind(Statement& row, T value) { row.bindNext(static_cast<Stored>(value)); }
  static void read(Statement& row, T& value) {
    const Stored stored = row.next();
    checkNumber(stored, std::is_integral_v<T> && sizeof(T) < sizeof(Stored)
                            ? static_cast<Stored>(std::numeric_limits<T>::max())
                            : kMaxNumber<Stored>);
    value = static_cast<T>(stored);
  }
};

template <>
struct Codec<std::string> {
  static void describe(const Field& f, Columns& out) { out.push_back(columnOf(f, "TEXT")); }
  static void bind(Statement& row, const std::string& value) { row.bindNext(value); }
  static void read(Statement& row, std::string& value) { value = row.next().getString(); }
};

template <NamedEnum T>
struct Codec<T> {
  static void describe(const Field& f, Columns& out) { Codec<std::string>::describe(f, out); }
  static void bind(Statement& row, T value) { row.bindNext(std::string(enumName(value))); }
  static void read(Statement& row, T& value) {
    const std::string name = row.next().getString();
    const std::optional<T> known = config::valueNamed<T>(name);
    if (!known)
      throw BadRow("'" + name.substr(0, 24) + "' is none of the values that this column has");
    value = *known;
  }
};

template <>
struct Codec<Eigen::Isometry3d> {
  static void describe(const Field& f, Columns& out) {
    for (const char* part : {"_x", "_y", "_z", "_qx", "_qy", "_qz", "_qw"}) {
      const std::string name = std::string(f.name) + part;
      out.push_back(columnOf({name, part[1] == 'q' ? "" : f.unit, f.doc}, "REAL"));
    }
  }
  static void bind(Statement& row, const Eigen::Isometry3d& T) {
    Eigen::Quaterniond q(T.linear());
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    for (int i = 0; i < 3; ++i) row.bindNext(T.translation()[i]);
    for (int i = 0; i < 4; ++i) row.bindNext(q.coeffs()[i]);
  }
  static void read(Statement& row, Eigen::Isometry3d& T) {
    Eigen::Quaterniond q;
    for (int i = 0; i < 3; ++i) {
      T.translation()[i] = row.next().getDouble();
      checkNumber(T.translation()[i], config::kFarthest);
    }
    for (int i = 0; i < 4; ++i) q.coeffs()[i] = row.next().getDouble();
    constexpr double kError = 1e-3;  // much larger than the effect of config::kRotationError
    if (!(std::abs(q.norm() - 1) < kError)) throw BadRow("a quaternion is not of unit length");
    T.linear() = q.normalized().toRotationMatrix();
  }
};

template <class T>
requires kIsMatrix<T>
struct Codec<T> {
  using Scalar = typename T::Scalar;
  static_assert(T::RowsAtCompileTime != Eigen::Dynamic, "only the column count may be dynamic");

  static void describe(const Field& f, Columns& out) {
    const int columns = T::ColsAtCompileTime;
    const std::string shape = std::to_string(T::RowsAtCompileTime) + "x" +
                              (columns == Eigen::Dynamic ? "n" : std::to_string(columns));
    const std::string type = sizeof(Scalar) == 8 ? " float64" : " float32";
    const std::string doc = std::string(f.doc) + "; " + shape + type + ", row-major";
    out.push_back(columnOf({f.name, f.unit, doc}, "BLOB"));
  }
  static void bind(Statement& row, const T& matrix) {
    const Eigen::VectorX<Scalar> values = matrix.template reshaped<Eigen::RowMajor>();
    const void* data = values.size() == 0 ? "" : static_cast<const void*>(values.data());
    row.bindNext(data, static_cast<int>(sizeof(Scalar)) * static_cast<int>(values.size()));
  }
  static void read(Statement& row, T& matrix) {
    const std::string bytes = row.next().getString();
    const std::size_t line = sizeof(Scalar) * static_cast<std::size_t>(T::RowsAtCompileTime);
    const auto columns = static_cast<Eigen::Index>(bytes.size() / line);
    constexpr int kColumns = T::ColsAtCompileTime;
    if (bytes.size() % line != 0 || (kColumns != Eigen::Dynamic && columns != kColumns)) {
      throw BadRow("a matrix has " + std::to_string(bytes.size()) + " bytes, which do not fit");
    }
    matrix.resize(T::RowsAtCompileTime, columns);
    const auto* values = reinterpret_cast<const Scalar*>(bytes.data());
    matrix.template reshaped<Eigen::RowMajor>() =
        Eigen::Map<const Eigen::VectorX<Scalar>>(values, matrix.size());
    // Arrays of plugins may contain any values. Other matrices were finite when recorded.
    if (kColumns != Eigen::Dynamic && !matrix.allFinite()) {
      throw BadRow("a matrix has numbers that are not finite");
    }
  }
};

/// Fields that have no column in the table of their record.
template <class T>
concept StoredElsewhere = std::same_as<T, Image> ||
    (requires { typename T::value_type; } && !kIsMatrix<T> && !std::same_as<T, std::string>);

template <StoredElsewhere T>
struct Codec<T> {
  static void describe(const Field&, Columns&) {}
  static void bind(Statement&, const T&) {}
  static void read(Statement&, T&) {}
};

/// A nested record: the columns' names begin with the member's name.
template <Record T>
struct Codec<T> {
  static void describe(const Field& f, Columns& out) {
    T record;
    const std::string prefix = f.name.empty() ? "" : std::string(f.name) + "_";
    visitFields(record, [&](const Field& inner, const auto& value) {
      const std::string name = prefix + std::string(inner.name);
      Codec<std::remove_cvref_t<decltype(value)>>::describe({name, inner.unit, inner.doc}, out);
    });
  }
  static void bind(Statement& row, const T& record) {
    visitFields(record, [&](const Field&, const auto& value) {
      Codec<std::remove_cvref_t<decltype(value)>>::bind(row, value);
    });
  }
  static void read(Statement& row, T& record) {
    visitFields(record, [&](const Field&, auto& value) {
      Codec<std::remove_cvref_t<decltype(value)>>::read(row, value);
    });
  }
};

template <Record R>
Columns columnsOf() {
  Columns columns;
  Codec<R>::describe({}, columns);
  return columns;
}

}  // namespace tolman::record
