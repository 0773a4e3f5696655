// SPDX-License-Identifier: BSD-3-Clause
// The binary codec: records and other values as the bytes of their fields in order, in the
// machine's byte order, for readers of the same build. The decoder checks all sizes and throws
// std::domain_error for bytes that no encoder wrote.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tolman/parameters.hpp"
#include "tolman/roles.hpp"

namespace tolman {

/// The members of a struct that is not a record: overload it in the namespace of the struct.
template <class T>
requires std::same_as<std::remove_const_t<T>, ParameterInfo>
auto parts(T& info) {
  return std::tie(info.name, info.type, info.default_value, info.required, info.min, info.max,
                  info.unit, info.doc, info.choices);
}

template <class T>
concept HasParts = requires(T& value) {
  parts(value);
};
template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class T>
concept Matrix = std::is_base_of_v<Eigen::PlainObjectBase<T>, T>;

class Encoder {
 public:
  /// What was written.
  std::string take() { return std::move(bytes_); }

  template <class... T>
  void putAll(const T&... values) {
    (put(values), ...);
  }

  /// Appends bytes that another encoder has written.
  void append(std::string_view bytes) { raw(bytes.data(), bytes.size()); }

  template <Scalar T>
  void put(T value) {
    raw(&value, sizeof value);
  }
  void put(const std::string& text) {
    put(text.size());
    raw(text.data(), text.size());
  }
  void put(const Status& status) { putAll(status.code(), status.message()); }
  void put(const Image& image);
  void put(const Eigen::Isometry3d& pose) { put(pose.matrix()); }

  template <Matrix M>
  void put(const M& matrix) {
    putAll(matrix.rows(), matrix.cols());
    raw(matrix.data(), sizeof(typename M::Scalar) * static_cast<std::size_t>(matrix.size()));
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(values.size());
    if constexpr (std::is_arithmetic_v<T>) {
      raw(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  template <Scalar T, std::size_t N>
  void put(const std::array<T, N>& values) {
    raw(values.data(), sizeof values);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  void put(const ParameterValue& value) {
    put(value.index());
    std::visit([&](const auto& held) { put(held); }, value);
  }
  void put(const ParameterValues& values) {
    put(values.size());
    for (const auto& [key, value] : values) putAll(key, value);
  }
  template <HasParts T>
  void put(const T& value) {
    std::apply([&](const auto&... part) { putAll(part...); }, parts(value));
  }
  template <Record R>
  void put(const R& record) {
    visitFields(record, [&](const Field&, const auto& value) { put(value); });
  }

 private:
  void raw(const void* bytes, std::size_t count) {
    if (count > 0) bytes_.append(static_cast<const char*>(bytes), count);
  }
  std::string bytes_;
};

class Decoder {
 public:
  /// The bytes must outlive it.
  explicit Decoder(std::string_view bytes) : bytes_(bytes) {}
  std::size_t remaining() const { return bytes_.size() - position_; }
  /// Ignores the remaining bytes.
  void skip() { position_ = bytes_.size(); }

  template <class... T>
  void getAll(T&... values) {
    (get(values), ...);
  }
  template <class T>
  T next() {
    T value{};
    get(value);
    return value;
  }

  template <Scalar T>
  void get(T& value) {
    std::memcpy(&value, take(sizeof value), sizeof value);
  }
  template <Scalar T, std::size_t N>
  void get(std::array<T, N>& values) {
    std::memcpy(values.data(), take(sizeof values), sizeof values);
  }
  void get(bool& value) { value = std::to_integer<int>(*take(1)) != 0; }
  void get(std::string& text) {
    const std::size_t count = this->count(1);
    text.assign(reinterpret_cast<const char*>(take(count)), count);
  }
  void get(Status& status) {
    const auto code = next<StatusCode>();
    if (code > StatusCode::Failed) throw std::domain_error("a status code that does not exist");
    status =
        code == StatusCode::Ok ? (skipText(), Status::ok()) : Status(code, next<std::string>());
  }
  void get(Image& image);
  void get(Eigen::Isometry3d& pose) { get(pose.matrix()); }

  template <Matrix M>
  void get(M& matrix) {
    const auto rows = next<Eigen::Index>();
    const auto columns = next<Eigen::Index>();
    constexpr std::size_t kScalar = sizeof(typename M::Scalar);
    const bool rows_fit = M::RowsAtCompileTime == Eigen::Dynamic || rows == M::RowsAtCompileTime;
    const bool columns_fit =
        M::ColsAtCompileTime == Eigen::Dynamic || columns == M::ColsAtCompileTime;
    const auto most = static_cast<Eigen::Index>(remaining() / kScalar);
    if (!rows_fit || !columns_fit || rows < 0 || columns < 0 ||
        (rows > 0 && columns > most / rows)) {
      throw std::domain_error("a matrix of impossible size");
    }
    matrix.resize(rows, columns);
    const std::size_t bytes = kScalar * static_cast<std::size_t>(matrix.size());
    if (bytes > 0) std::memcpy(matrix.data(), take(bytes), bytes);
  }
  template <class T>
  void get(std::vector<T>& values) {
    constexpr std::size_t kMin = std::is_arithmetic_v<T> ? sizeof(T) : 1;
    const std::size_t count = this->count(kMin);
    values.clear();
    if constexpr (std::is_arithmetic_v<T>) {
      values.resize(count);
      if (count > 0) std::memcpy(values.data(), take(count * sizeof(T)), count * sizeof(T));
    } else {
      for (std::size_t i = 0; i < count; ++i) get(values.emplace_back());
    }
  }
  template <class T>
  void get(std::optional<T>& value) {
    value.reset();
    if (next<bool>()) get(value.emplace());
  }
  template <class... T>
  void get(std::variant<T...>& value) {
    const auto index = next<std::size_t>();
    std::size_t i = 0;
    ((index == i++ ? void(value = next<T>()) : void()), ...);
    if (index >= sizeof...(T)) throw std::domain_error("a parameter of no known type");
  }
  void get(ParameterValues& values);
  template <HasParts T>
  void get(T& value) {
    std::apply([&](auto&... part) { getAll(part...); }, parts(value));
  }
  template <Record R>
  void get(R& record) {
    visitFields(record, [&](const Field&, auto& value) { get(value); });
  }

 private:
  const std::byte* take(std::size_t count) {
    if (count > remaining()) throw std::domain_error("the message ends too early");
    const char* start = bytes_.data() + position_;
    position_ += count;
    return reinterpret_cast<const std::byte*>(start);
  }
  /// Reads a number of elements of at least `least` bytes each; refuses a number that the rest of
  /// the message cannot contain.
  std::size_t count(std::size_t least) {
    const auto count = next<std::size_t>();
    if (count > remaining() / least) throw std::domain_error("a list longer than its message");
    return count;
  }
  void skipText() { take(count(1)); }

  std::string_view bytes_;
  std::size_t position_ = 0;
};

inline void Encoder::put(const Image& image) {
  putAll(image.width(), image.height(), image.format());
  const std::size_t row = static_cast<std::size_t>(image.width()) *
                          static_cast<std::size_t>(bytesPerPixel(image.format()));
  for (int r = 0; r < image.height(); ++r) raw(image.row(r), row);
}

inline void Decoder::get(Image& image) {
  constexpr int kMaxSide = 1 << 16;  // px
  const int width = next<int>();
  const int height = next<int>();
  const auto format = next<PixelFormat>();
  if (width < 0 || height < 0 || width > kMaxSide || height > kMaxSide ||
      format > PixelFormat::Bgr8) {
    throw std::domain_error("an image of impossible size");
  }
  image = Image();
  if (width == 0 || height == 0) return;
  const std::ptrdiff_t stride = std::ptrdiff_t{width} * bytesPerPixel(format);
  const auto size = static_cast<std::size_t>(stride * height);
  const std::byte* source = take(size);
  const std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[size]);
  std::memcpy(pixels.get(), source, size);
  image = Image(pixels.get(), width, height, stride, format, pixels);
}

inline void Decoder::get(ParameterValues& values) {
  const std::size_t count = this->count(1);
  values.clear();
  for (std::size_t i = 0; i < count; ++i) {
    std::string key = next<std::string>();
    get(values[std::move(key)]);
  }
}

/// A hash of the bytes of a value, to tell whether two are the same bit for bit: -0.0 and 0.0
/// differ. Not cryptographic. For bytes of files see record/digest.hpp.
template <class T>
std::size_t bitHash(const T& value) {
  Encoder encoder;
  encoder.put(value);
  return std::hash<std::string>()(encoder.take());
}

}  // namespace tolman
