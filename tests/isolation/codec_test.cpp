// SPDX-License-Identifier: BSD-3-Clause
// All arguments are decoded to the encoded values; damaged bytes are refused.
#include "base/codec.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "host/child_process.hpp"

using namespace tolman;
using namespace tolman::host;

namespace {

/// Fills any field with random content.
class Filler {
 public:
  explicit Filler(std::uint64_t seed) : random_(seed) {}

  template <std::integral T>
  void fill(T& value) {
    value = static_cast<T>(random_.bits());
  }
  void fill(bool& value) { value = random_.below(2) == 1; }
  template <std::floating_point T>
  void fill(T& value) {
    value = static_cast<T>(random_.normal());
  }
  template <NamedEnum T>
  void fill(T& value) {
    value = static_cast<T>(random_.below(enumNames(T{}).size()));
  }
  void fill(Finding::Severity& value) { value = static_cast<Finding::Severity>(random_.below(3)); }
  void fill(std::string& text) {
    text.assign(random_.below(20), ' ');
    for (char& c : text) c = static_cast<char>(random_.below(256));
  }
  void fill(Eigen::Isometry3d& pose) {
    pose.matrix() = Eigen::Matrix4d::NullaryExpr([&] { return random_.normal(); });
  }
  template <Matrix M>
  void fill(M& matrix) {
    if constexpr (M::ColsAtCompileTime == Eigen::Dynamic) {
      matrix.resize(M::RowsAtCompileTime, static_cast<Eigen::Index>(random_.below(6)));
    }
    for (auto& value : matrix.reshaped()) fill(value);
  }
  void fill(Image& image) {
    const int width = static_cast<int>(random_.below(9));
    image = Image();
    if (width == 0) return;
    image = Image::create(width, 5, random_.below(2) == 0 ? PixelFormat::Gray8 : PixelFormat::Bgr8,
                          [](std::uint8_t* data) { data[3] = 77; });
  }
  template <class T>
  void fill(std::vector<T>& values) {
    values.resize(random_.below(5));
    for (T& value : values) fill(value);
  }
  template <HasParts T>
  void fill(T& value) {
    std::apply([&](auto&... part) { (fill(part), ...); }, parts(value));
  }
  template <Record R>
  void fill(R& record) {
    visitFields(record, [&](const Field&, auto& value) { fill(value); });
  }

 private:
  RandomStream random_;
};

template <class T>
std::string bytesOf(const T& value) {
  Encoder encoder;
  encoder.put(value);
  return encoder.take();
}

template <class T>
T fromBytes(const std::string& bytes) {
  Decoder decoder(bytes);
  T value = decoder.next<T>();
  CHECK(decoder.remaining() == 0);
  return value;
}

/// Encoding is one to one, so equal bytes are equal values.
template <class T>
void checkRoundTrip() {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    T value{};
    Filler(seed).fill(value);
    const std::string bytes = bytesOf(value);
    CHECK(bytesOf(fromBytes<T>(bytes)) == bytes);
  }
}

/// Cut anywhere it is refused; changed anywhere it is refused or is another value.
template <class T>
void checkDamage() {
  RandomStream random(3);
  T value{};
  Filler(11).fill(value);
  const std::string bytes = bytesOf(value);
  const auto read = [](const std::string& damaged) {
    Decoder decoder(damaged);
    return decoder.next<T>();
  };
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_THROWS_AS(read(bytes.substr(0, size)), std::domain_error);
  }
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = bytes;
    for (std::uint64_t n = 0; n <= random.below(8); ++n) {
      damaged[random.below(bytes.size())] = static_cast<char>(random.bits());
    }
    try {
      (void)read(damaged);
    } catch (const std::domain_error&) {
    }
  }
}

}  // namespace

TEMPLATE_TEST_CASE("records and other arguments are decoded to what was encoded", "", Frame, Motion,
                   MotionRevision, PlaceObservation, EarlierLoop, Decision, MapUpdate, MapGraph,
                   CameraRig, RawRig, SourceInfo, RunInfo, std::vector<Finding>,
                   std::vector<NamedArray>, std::vector<MotionRevision>, LoadMessage,
                   host::Refusal) {
  checkRoundTrip<TestType>();
}

TEMPLATE_TEST_CASE("damaged messages are refused", "", Frame, Motion, MapGraph, SourceInfo,
                   std::vector<NamedArray>) {
  checkDamage<TestType>();
}

TEST_CASE("pixels are packed, whatever the stride") {
  const std::array<std::uint8_t, 8> padded = {1, 2, 99, 99, 3, 4, 99, 99};
  const Image image(padded.data(), 2, 2, 4, PixelFormat::Gray8, nullptr);
  const Image back = fromBytes<Image>(bytesOf(image));
  REQUIRE(back.width() == 2);
  REQUIRE(back.height() == 2);
  CHECK(back.stride() == 2);
  CHECK(std::vector<int>(back.data(), back.data() + 4) == std::vector<int>{1, 2, 3, 4});
}

TEST_CASE("numbers keep every bit") {
  const std::vector<double> values = {-0.0, std::numeric_limits<double>::denorm_min(),
                                      std::numeric_limits<double>::infinity(), 1.0 / 3};
  const auto back = fromBytes<std::vector<double>>(bytesOf(values));
  CHECK(std::memcmp(back.data(), values.data(), values.size() * sizeof(double)) == 0);
}

TEST_CASE("parameters of every type survive") {
  const ParameterValues values = {{"a", true},
                                  {"b", std::int64_t{-7}},
                                  {"c", 0.1},
                                  {"d", std::string("text")},
                                  {"e", std::vector<double>{1, 2}}};
  CHECK(fromBytes<ParameterValues>(bytesOf(values)) == values);
}

TEST_CASE("a status survives with its code and message") {
  const Status back = fromBytes<Status>(bytesOf(Status::unsupported("one camera")));
  CHECK(back.code() == StatusCode::Unsupported);
  CHECK(back.message() == "one camera");
  CHECK(fromBytes<Status>(bytesOf(Status::ok())).isOk());
}

TEST_CASE("lists that claim to be longer than their message cost no memory") {
  std::string bytes(8, '\0');
  const std::uint64_t many = std::uint64_t{1} << 61U;
  std::memcpy(bytes.data(), &many, sizeof many);
  CHECK_THROWS_AS(fromBytes<std::string>(bytes), std::domain_error);
  CHECK_THROWS_AS(fromBytes<std::vector<double>>(bytes), std::domain_error);
  CHECK_THROWS_AS(fromBytes<std::vector<NamedArray>>(bytes), std::domain_error);
}
