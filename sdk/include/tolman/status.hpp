// SPDX-License-Identifier: BSD-3-Clause
// Failure as a value: what every call across the plugin boundary returns.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace tolman {

enum class StatusCode : std::uint8_t {
  Ok,
  EndOfStream,       ///< a source has no further frame; not a failure
  InvalidInput,      ///< the data are wrong: missing file, corrupt image, NaN, bad calibration
  InvalidParameter,  ///< the configuration is wrong
  Unsupported,       ///< valid, but this plugin cannot do it (a stereo method given one camera)
  Cancelled,         ///< stopped because Cancellation asked for it
  Failed,            ///< anything else
};

/// Success, or one failure with a message for a person.
///
/// A good message is one sentence that names the thing (file and line where there is one), what is
/// wrong with it, and what to do: "times.txt:17: time goes back by 0.1 s; sort the file".
/// The host adds plugin, call and frame; do not repeat them.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(StatusCode code, std::string message) : code_(code), message_(std::move(message)) {}

  static Status ok() { return {}; }
  static Status endOfStream() { return {StatusCode::EndOfStream, "end of stream"}; }
  static Status invalidInput(std::string message) {
    return {StatusCode::InvalidInput, std::move(message)};
  }
  static Status invalidParameter(std::string message) {
    return {StatusCode::InvalidParameter, std::move(message)};
  }
  static Status unsupported(std::string message) {
    return {StatusCode::Unsupported, std::move(message)};
  }
  static Status failed(std::string message) { return {StatusCode::Failed, std::move(message)}; }

  bool isOk() const { return code_ == StatusCode::Ok; }
  StatusCode code() const { return code_; }
  const std::string& message() const { return message_; }

 private:
  StatusCode code_ = StatusCode::Ok;
  std::string message_;
};

/// A value, or the Status that says why there is none. Reading the absent one is a programming
/// error: it throws std::bad_variant_access, which the host reports as a failure of the call.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit
  Result(Status failure) : content_(std::in_place_index<1>, std::move(failure)) {}  // NOLINT

  bool isOk() const { return content_.index() == 0; }
  const T& value() const& { return std::get<0>(content_); }
  T& value() & { return std::get<0>(content_); }
  T&& value() && { return std::get<0>(std::move(content_)); }
  Status status() const { return isOk() ? Status::ok() : std::get<1>(content_); }

 private:
  std::variant<T, Status> content_;
};

}  // namespace tolman
