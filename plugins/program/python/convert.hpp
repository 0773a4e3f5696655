// SPDX-License-Identifier: BSD-3-Clause
// Records to Python objects (tolman/records.py) and back, field by field from their declarations.
// Images become NumPy views of the same pixels; poses, covariances and named arrays are copied,
// because their memory ends with the call. To be used with Python's lock held.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::python {

namespace py = pybind11;

/// An answer that is not a record of the wanted kind. Names the field and its expected type.
struct WrongAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The class of a record, by its name in fields.hpp.
py::handle classOf(const char* record);
/// The position of a value in an answer, for messages: "MapGraph.links[3].from".
std::string joined(const std::string& place, std::string_view part);
/// The Python attribute of a field: `from` is renamed because it is a keyword, and a prefix before
/// a dot is left out.
std::string attributeOf(std::string_view field);
[[noreturn]] void refuse(const std::string& place, const std::string& expected, py::handle value);

py::object toPython(const Image& image);
py::object toPython(const std::vector<NamedArray>& arrays);
Image imageFrom(py::handle value, const std::string& place);
std::vector<NamedArray> arraysFrom(py::handle value, const std::string& place);
double realFrom(py::handle value, const std::string& place);
std::int64_t integerFrom(py::handle value, const std::string& place);
std::string textFrom(py::handle value, const std::string& place);
std::size_t choiceFrom(py::handle value, std::span<const std::string_view> names,
                       const std::string& place);

template <class T>
py::object toPython(const std::vector<T>& values);

template <class T>
concept Matrix = std::is_base_of_v<Eigen::PlainObjectBase<T>, T>;

template <class T>
py::object toPython(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return py::bool_(value);
  } else if constexpr (NamedEnum<T>) {
    const std::string_view name = enumName(value);
    return py::str(name.data(), name.size());
  } else if constexpr (std::is_integral_v<T>) {
    return py::int_(value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return py::float_(value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(value.data(), static_cast<Py_ssize_t>(value.size()), "replace"));
  } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    return toPython(value.matrix());
  } else if constexpr (Matrix<T>) {
    using Scalar = typename T::Scalar;
    py::array_t<Scalar> array({value.rows(), value.cols()});
    Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        array.mutable_data(), value.rows(), value.cols()) = value;
    return array;
  } else {  // a record
    const py::handle type = classOf(T::kRecord);
    auto* const python_type = reinterpret_cast<PyTypeObject*>(type.ptr());
    const py::tuple nothing;
    auto object =
        py::reinterpret_steal<py::object>(python_type->tp_new(python_type, nothing.ptr(), nullptr));
    if (!object) throw py::error_already_set();
    visitFields(value, [&](const Field& field, const auto& member) {
      py::setattr(object, attributeOf(field.name).c_str(), toPython(member));
    });
    return object;
  }
}

template <class T>
py::object toPython(const std::vector<T>& values) {
  py::list list(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) list[i] = toPython(values[i]);
  return list;
}

template <class T>
void fromPython(py::handle value, T& member, const std::string& place);

/// Refuses values of which a conversion to numbers would drop something: imaginary parts, masks.
void refuseHidden(py::handle value, const std::string& place);

template <Matrix M>
void matrixFrom(py::handle value, M& matrix, const std::string& place) {
  refuseHidden(value, place);
  using Array = py::array_t<typename M::Scalar, py::array::c_style | py::array::forcecast>;
  const Array array = Array::ensure(value);
  if (!array) PyErr_Clear();
  const bool fits =
      array && array.ndim() == 2 &&
      (M::RowsAtCompileTime == Eigen::Dynamic || array.shape(0) == M::RowsAtCompileTime) &&
      (M::ColsAtCompileTime == Eigen::Dynamic || array.shape(1) == M::ColsAtCompileTime);
  if (!fits) {
    const auto size = [](int n) { return n == Eigen::Dynamic ? "N" : std::to_string(n); };
    refuse(place,
           "an array of shape (" + size(M::RowsAtCompileTime) + ", " + size(M::ColsAtCompileTime) +
               ")",
           value);
  }
  matrix = Eigen::Map<
      const Eigen::Matrix<typename M::Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      array.data(), array.shape(0), array.shape(1));
}

template <class T>
void listFrom(py::handle value, std::vector<T>& members, const std::string& place) {
  members.clear();
  if (value.is_none()) return;
  if (!PySequence_Check(value.ptr()) || PyUnicode_Check(value.ptr()))
    refuse(place, "a list", value);
  const auto sequence = py::reinterpret_borrow<py::sequence>(value);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    fromPython(py::object(sequence[i]), members.emplace_back(),
               place + "[" + std::to_string(i) + "]");
  }
}

template <class T>
void recordFrom(py::handle value, T& record, const std::string& place) {
  const py::handle type = classOf(T::kRecord);
  if (!py::isinstance(value, type)) {
    refuse(place, "a tolman." + std::string(py::str(type.attr("__name__"))), value);
  }
  visitFields(record, [&](const Field& field, auto& member) {
    const std::string name = attributeOf(field.name);
    fromPython(py::object(value.attr(name.c_str())), member, joined(place, name));
  });
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <class T>
void fromPython(py::handle value, T& member, const std::string& place) {
  if constexpr (std::is_same_v<T, bool>) {
    const int truth = PyObject_IsTrue(value.ptr());
    if (truth < 0) throw py::error_already_set();
    member = truth != 0;
  } else if constexpr (NamedEnum<T>) {
    member = static_cast<T>(choiceFrom(value, enumNames(member), place));
  } else if constexpr (std::is_integral_v<T>) {
    member = static_cast<T>(integerFrom(value, place));
  } else if constexpr (std::is_floating_point_v<T>) {
    member = static_cast<T>(realFrom(value, place));
  } else if constexpr (std::is_same_v<T, std::string>) {
    member = textFrom(value, place);
  } else if constexpr (std::is_same_v<T, Image>) {
    member = imageFrom(value, place);
  } else if constexpr (std::is_same_v<T, std::vector<NamedArray>>) {
    member = arraysFrom(value, place);
  } else if constexpr (IsVector<T>::value) {
    listFrom(value, member, place);
  } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    matrixFrom(value, member.matrix(), place);
  } else if constexpr (Matrix<T>) {
    matrixFrom(value, member, place);
  } else {
    recordFrom(value, member, place);
  }
}

}  // namespace tolman::python
