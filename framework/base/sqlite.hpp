// SPDX-License-Identifier: BSD-3-Clause
// Connections and statements of SQLite, on top of SQLiteCpp; values are bound and read from left to
// right. guarded() converts exceptions to a Status with a remedy.
//
// Maps the fields of a record to columns of a table: one Codec per type, which describes the
// columns, binds a value to them and reads it back.
//
// Isometry3d: seven REAL columns _x _y _z _qx _qy _qz _qw (w >= 0). Matrices: one BLOB, row-major,
// little-endian; the column count of a dynamic one follows from the size. Enumerations: TEXT.
// Images are not stored. Lists of arrays go to table `array`, lists of records to their own table.
// A quaternion does not give back all bits of a rotation: see ExactPoses in record_rows.hpp.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <bit>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "base/named_value.hpp"
#include "tolman/fields.hpp"
#include "tolman/status.hpp"

namespace tolman::record {

using SQLite::Database;

enum class Access : std::uint8_t { Create, Write, ReadOnly };
/// One connection. Not thread-safe.
Database openDatabase(const std::filesystem::path& file, Access access);

/// A prepared statement.
class Statement : public SQLite::Statement {
 public:
  using SQLite::Statement::Statement;

  /// Binds the next parameter. No argument binds NULL, a std::string a text, pointer and size a
  /// BLOB.
  template <class... Value>
  void bindNext(const Value&... value) {
    bind(++parameter_, value...);
  }
  /// Moves to the next row; false after the last one. Then, and after an exception, the statement
  /// can be bound again.
  bool step();
  /// Executes a statement that has no rows.
  void run() { (void)step(); }
  /// The next column of the row.
  SQLite::Column next() { return getColumn(column_++); }

 private:
  void restart();
  int parameter_ = 0;
  int column_ = 0;
};

/// The message of SQLite with a remedy; InvalidInput if the database is damaged, otherwise Failed.
Status explained(const std::string& where, const SQLite::Exception& error);

/// Calls `work` and converts exceptions to a Status whose message begins with `where`. A value that
/// violates the schema throws std::domain_error.
template <class Work>
Status guarded(const std::string& where, Work&& work) {
  try {
    work();
    return Status::ok();
  } catch (const std::domain_error& error) {
    return Status::invalidInput(where + ": " + error.what());
  } catch (const SQLite::Exception& error) {
    return explained(where, error);
  } catch (const std::bad_alloc&) {
    return Status::failed(where + ": out of memory");
  } catch (const std::exception& error) {
    return Status::failed(where + ": " + error.what());
  }
}

/// The result of `work`, or its exception as a Status.
template <class Work>
Result<std::invoke_result_t<Work>> answered(const std::string& where, Work&& work) {
  std::optional<std::invoke_result_t<Work>> answer;
  const Status status = guarded(where, [&] { answer = work(); });
  if (!status.isOk()) return status;
  return *std::move(answer);
}

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
    const std::optional<T> known = valueNamed<T>(name);
    if (!known)
      throw std::domain_error("'" + name + "' is none of the values that this column has");
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
    for (int i = 0; i < 3; ++i) T.translation()[i] = row.next().getDouble();
    for (int i = 0; i < 4; ++i) q.coeffs()[i] = row.next().getDouble();
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
      throw std::domain_error("a matrix has " + std::to_string(bytes.size()) +
                              " bytes, which do not fit");
    }
    matrix.resize(T::RowsAtCompileTime, columns);
    const auto* values = reinterpret_cast<const Scalar*>(bytes.data());
    matrix.template reshaped<Eigen::RowMajor>() =
        Eigen::Map<const Eigen::VectorX<Scalar>>(values, matrix.size());
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

/// `"a", "b"`: quoted, because link.from and link.to are words of SQL.
std::string columnList(const Columns& columns);

}  // namespace tolman::record
