// SPDX-License-Identifier: BSD-3-Clause
#include "convert.hpp"

#include <algorithm>
#include <limits>
#include <memory>

namespace tolman::python {

py::handle classOf(const char* record) {
  // Leaked: Python objects must not be destroyed when the process ends.
  static const auto* const classes =
      new py::dict(py::module_::import("tolman.records").attr("BY_NAME"));
  return (*classes)[record].ptr();
}

std::string joined(const std::string& place, std::string_view part) {
  return place + "." + std::string(part);
}

std::string attributeOf(std::string_view field) {
  if (field == "from") return "from_";
  return std::string(field.substr(field.rfind('.') + 1));
}

void refuse(const std::string& place, const std::string& expected, py::handle value) {
  std::string given = py::str(py::type::of(value).attr("__name__"));
  if (py::hasattr(value, "shape"))
    given += " of shape " + std::string(py::str(value.attr("shape")));
  throw WrongAnswer(place + ": should be " + expected + ", not " + given);
}

void refuseHidden(py::handle value, const std::string& place) {
  const auto array = py::array::ensure(value);
  if (!array) {
    PyErr_Clear();
    return;
  }
  if (array.dtype().kind() == 'c') refuse(place, "an array of real numbers", value);
  const bool masked =
      py::hasattr(value, "mask") && static_cast<bool>(py::bool_(value.attr("mask").attr("any")()));
  if (masked) refuse(place, "an array without masked values", value);
}

py::object toPython(const Image& image) {
  if (image.empty()) return py::none();
  // The array owns a reference to the pixels.
  auto* const owner = new std::shared_ptr<const void>(image.owner());
  const py::capsule keeper(
      owner, [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
  const int channels = bytesPerPixel(image.format());
  std::vector<py::ssize_t> shape = {image.height(), image.width()};
  std::vector<py::ssize_t> strides = {image.stride(), channels};
  if (channels > 1) {
    shape.push_back(channels);
    strides.push_back(1);
  }
  py::array_t<std::uint8_t> view(shape, strides, image.data(), keeper);
  view.attr("flags").attr("writeable") = false;
  return view;
}

py::object toPython(const std::vector<NamedArray>& arrays) {
  py::dict named;
  for (const NamedArray& array : arrays) {
    const std::vector<py::ssize_t> shape(array.shape.begin(), array.shape.end());
    py::array_t<float> values(shape);
    const auto size = std::min(array.values.size(), static_cast<std::size_t>(values.size()));
    std::copy_n(array.values.data(), size, values.mutable_data());
    named[toPython(array.name)] = values;
  }
  return named;
}

Image imageFrom(py::handle value, const std::string& place) {
  if (value.is_none()) return {};
  using Pixels = py::array_t<std::uint8_t, py::array::c_style>;
  const bool bytes = py::isinstance<py::array_t<std::uint8_t>>(value);
  const Pixels pixels = bytes ? Pixels::ensure(value) : Pixels();
  const bool colour = bytes && pixels.ndim() == 3 && pixels.shape(2) == 3;
  constexpr py::ssize_t kMaxSide = 1 << 16;
  if (!bytes || (pixels.ndim() != 2 && !colour) || pixels.shape(0) > kMaxSide ||
      pixels.shape(1) > kMaxSide) {
    refuse(place, "None or an array of uint8 of shape (height, width) or (height, width, 3)",
           value);
  }
  if (pixels.size() == 0) return {};
  return Image::create(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)),
                       colour ? PixelFormat::Bgr8 : PixelFormat::Gray8, [&](std::uint8_t* copy) {
                         std::copy_n(pixels.data(), pixels.size(), copy);
                       });
}

std::vector<NamedArray> arraysFrom(py::handle value, const std::string& place) {
  if (!PyDict_Check(value.ptr())) refuse(place, "a dict from names to arrays", value);
  std::vector<NamedArray> arrays;
  for (const auto& [name, item] : py::reinterpret_borrow<py::dict>(value)) {
    NamedArray& array = arrays.emplace_back();
    array.name = textFrom(name, place);
    const std::string here = place + "['" + array.name + "']";
    refuseHidden(item, here);
    using Values = py::array_t<float, py::array::c_style | py::array::forcecast>;
    const Values values = Values::ensure(item);
    if (!values) {
      PyErr_Clear();
      refuse(here, "an array of numbers", item);
    }
    for (py::ssize_t i = 0; i < values.ndim(); ++i) {
      array.shape.push_back(static_cast<int>(values.shape(i)));
    }
    if (array.shape.empty()) array.shape = {1};  // a scalar
    array.values.assign(values.data(), values.data() + values.size());
  }
  return arrays;
}

double realFrom(py::handle value, const std::string& place) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse(place, "a number", value);
  }
  return number;
}

std::int64_t integerFrom(py::handle value, const std::string& place) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  const std::int64_t number = index ? PyLong_AsLongLong(index.ptr()) : -1;
  if (PyErr_Occurred() != nullptr) {
    const bool too_large = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
    PyErr_Clear();
    if (too_large) {
      throw WrongAnswer(place + ": should be an integer of 64 bits; this one needs more");
    }
    refuse(place, "an integer of 64 bits", value);
  }
  return number;
}

std::string textFrom(py::handle value, const std::string& place) {
  if (!PyUnicode_Check(value.ptr())) refuse(place, "a text", value);
  const auto bytes =
      py::reinterpret_steal<py::bytes>(PyUnicode_AsEncodedString(value.ptr(), "utf-8", "replace"));
  if (!bytes) throw py::error_already_set();
  return bytes;
}

std::size_t choiceFrom(py::handle value, std::span<const std::string_view> names,
                       const std::string& place) {
  std::string listed;
  for (const std::string_view name : names) {
    listed += (listed.empty() ? "'" : ", '") + std::string(name) + "'";
  }
  if (!PyUnicode_Check(value.ptr())) refuse(place, "one of " + listed, value);
  const std::string text = textFrom(value, place);
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) {
    throw WrongAnswer(place + ": should be one of " + listed + ", not '" + text + "'");
  }
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace tolman::python
