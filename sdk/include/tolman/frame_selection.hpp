// SPDX-License-Identifier: BSD-3-Clause
// Which frames of a data set a run uses, and in which order: the parameters that all sources share.
//
//   struct Parameters : tolman::FrameSelection {
//     std::string path;
//     static constexpr auto declaration() {
//       return std::tuple_cat(
//           tolman::parameters(tolman::parameter("path", &Parameters::path).path().required()),
//           tolman::selectionParameters<Parameters>());
//     }
//   };
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tolman/parameters.hpp"
#include "tolman/status.hpp"

namespace tolman {

enum class FrameOrder : std::uint8_t {
  Forward,
  Backward,  ///< from last to first
  Pingpong,  ///< forward, backward, forward, ...; the frame at each turn occurs once
};
inline constexpr std::array<std::string_view, 3> kFrameOrderNames = {"forward", "backward",
                                                                     "pingpong"};
constexpr std::span<const std::string_view> enumNames(FrameOrder) { return kFrameOrderNames; }

/// Base of a source's Parameters.
struct FrameSelection {
  std::int64_t first = 0;  ///< index in the data set
  std::int64_t last = -1;  ///< inclusive; -1 for the end
  std::int64_t step = 1;
  FrameOrder order = FrameOrder::Forward;
  std::int64_t passes = 2;  ///< pingpong only: 4 is forward, backward, forward, backward
};

/// Declares these parameters for a Parameters struct that derives from FrameSelection.
template <std::derived_from<FrameSelection> P>
constexpr auto selectionParameters() {
  return parameters(
      parameter<P, std::int64_t>("first", &P::first)
          .range(0, 1e9)
          .doc("First frame of the data set to use, from 0."),
      parameter<P, std::int64_t>("last", &P::last)
          .range(-1, 1e9)
          .doc("Last frame of the data set to use, inclusive; -1 for the end."),
      parameter<P, std::int64_t>("step", &P::step).range(1, 1e9).doc("Use every step-th frame."),
      parameter<P, FrameOrder>("order", &P::order)
          .doc("forward, backward, or pingpong: forward and backward alternately."),
      parameter<P, std::int64_t>("passes", &P::passes)
          .range(1, 10000)
          .doc("Number of passes of pingpong; forward and backward count as two."));
}

/// The frames of a run: frame k is frame sourceIndex(k) of the data set, at stampNs(k).
///
/// Forward keeps the stamps of the data. Backward and pingpong begin with the earliest selected
/// stamp and add the absolute differences between the frames' stamps, so stamps always increase.
class FrameSequence {
 public:
  FrameSequence() = default;

  /// `stamps_ns`: one per frame of the data set. The selected ones must increase strictly.
  static Result<FrameSequence> make(const FrameSelection& selection,
                                    std::span<const std::int64_t> stamps_ns) {
    const auto count = static_cast<std::int64_t>(stamps_ns.size());
    if (Status status = checkBounds(selection, count); !status.isOk()) return status;
    FrameSequence sequence;
    sequence.selection_ = selection;
    const std::int64_t last = selection.last < 0 ? count - 1 : selection.last;
    for (std::int64_t i = selection.first; i <= last; i += selection.step) {
      sequence.stamps_ns_.push_back(stamps_ns[static_cast<std::size_t>(i)]);
    }
    if (Status status = sequence.checkStamps(); !status.isOk()) return status;
    return sequence;
  }

  /// How many frames the run has; 0 for a default-constructed sequence.
  std::int64_t size() const {
    if (selection_.order != FrameOrder::Pingpong || selected() < 2) return selected();
    return (selected() - 1) * selection_.passes + 1;
  }
  /// Index in the data set of frame k, 0 <= k < size().
  std::int64_t sourceIndex(std::int64_t k) const {
    return selection_.first + position(k) * selection_.step;
  }
  /// Data time of frame k, 0 <= k < size().
  std::int64_t stampNs(std::int64_t k) const {
    const std::int64_t start = stamps_ns_.front();
    const std::int64_t since_start = stamps_ns_[static_cast<std::size_t>(position(k))] - start;
    const std::int64_t span = stamps_ns_.back() - start;
    const bool back = isBackward(pass(k));
    return start + pass(k) * span + (back ? span - since_start : since_start);
  }

 private:
  static Status checkBounds(const FrameSelection& s, std::int64_t count) {
    const std::string have = "but the data end at frame " + std::to_string(count - 1);
    if (count == 0) return Status::invalidInput("the data have no frames; check the path");
    if (s.step < 1 || s.passes < 1 || s.first < 0 || s.last < -1) {
      return Status::invalidParameter("first, last, step or passes is out of its range");
    }
    if (s.first >= count) {
      return Status::invalidParameter("first is " + std::to_string(s.first) + ", " + have +
                                      "; choose a smaller one");
    }
    if (s.last >= count) {
      return Status::invalidParameter("last is " + std::to_string(s.last) + ", " + have +
                                      "; choose a smaller one, or -1 for the end");
    }
    if (s.last >= 0 && s.last < s.first) {
      return Status::invalidParameter("last is " + std::to_string(s.last) +
                                      ", before first = " + std::to_string(s.first) +
                                      "; for the reverse order use order: backward");
    }
    return Status::ok();
  }

  /// Requires stamps that increase strictly, and sums in stampNs() that fit into 64 bits.
  Status checkStamps() const {
    constexpr std::int64_t kMaxNs = std::int64_t{1} << 62;  // 146 years
    for (std::size_t i = 0; i < stamps_ns_.size(); ++i) {
      const std::string frame =
          std::to_string(selection_.first + static_cast<std::int64_t>(i) * selection_.step);
      if (stamps_ns_[i] < 0 || stamps_ns_[i] > kMaxNs) {
        return Status::invalidInput("the stamp of frame " + frame +
                                    " is not within 0 and 146 years; check its unit");
      }
      if (i > 0 && stamps_ns_[i] <= stamps_ns_[i - 1]) {
        return Status::invalidInput("the stamp of frame " + frame +
                                    " is not after that of the frame before; sort the data");
      }
    }
    if (stamps_ns_.back() - stamps_ns_.front() > kMaxNs / selection_.passes) {
      return Status::invalidParameter("passes = " + std::to_string(selection_.passes) +
                                      " take longer than 146 years; choose fewer");
    }
    return Status::ok();
  }

  std::int64_t selected() const { return static_cast<std::int64_t>(stamps_ns_.size()); }
  /// Number of the pass that frame k belongs to; the frame at a turn belongs to the next pass.
  std::int64_t pass(std::int64_t k) const {
    return selection_.order == FrameOrder::Pingpong && selected() > 1 ? k / (selected() - 1) : 0;
  }
  bool isBackward(std::int64_t pass) const {
    return selection_.order == FrameOrder::Backward || pass % 2 == 1;
  }
  /// Index of frame k among the selected frames in forward order.
  std::int64_t position(std::int64_t k) const {
    const std::int64_t done = k - pass(k) * (selected() - 1);
    return isBackward(pass(k)) ? selected() - 1 - done : done;
  }

  FrameSelection selection_;
  std::vector<std::int64_t> stamps_ns_;  ///< of the selected frames, forward
};

}  // namespace tolman
