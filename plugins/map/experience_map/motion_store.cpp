// SPDX-License-Identifier: BSD-3-Clause
#include "motion_store.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace tolman::experience_map {
namespace {

constexpr std::size_t kBlock = 256;        // slots that are moved to the file at once
constexpr std::size_t kInMemory = 1024;    // slots; more than the window of any odometry; 0.4 MB
constexpr std::size_t kNumbers = 16 + 36;  // pose and covariance
constexpr std::size_t kBytes = kNumbers * sizeof(double);

std::int64_t offsetOf(std::size_t slot) { return static_cast<std::int64_t>(slot * kBytes); }

std::vector<double> numbersOf(std::span<const UncertainPose> motions) {
  std::vector<double> numbers(motions.size() * kNumbers);
  double* out = numbers.data();
  for (const UncertainPose& motion : motions) {
    out = std::copy_n(motion.T.data(), 16, out);
    out = std::copy_n(motion.covariance.data(), 36, out);
  }
  return numbers;
}

}  // namespace

void MotionStore::append(const UncertainPose& motion) {
  recent_.push_back(motion);
  if (recent_.size() >= kInMemory + kBlock && recent_.size() % kBlock == 0) fileOldest();
}

void MotionStore::fileOldest() {
  const std::vector<double> numbers = numbersOf(std::span(recent_).first(kBlock));
  if (!file_.write(offsetOf(filed_), std::as_bytes(std::span(numbers))).isOk()) return;
  recent_.erase(recent_.begin(), recent_.begin() + kBlock);
  filed_ += kBlock;
}

void MotionStore::replace(std::size_t slot, const UncertainPose& motion) {
  if (slot >= filed_) {
    recent_[slot - filed_] = motion;
    return;
  }
  const std::vector<double> numbers = numbersOf(std::span(&motion, 1));
  const Status status = file_.write(offsetOf(slot), std::as_bytes(std::span(numbers)));
  if (!status.isOk()) throw std::runtime_error("motions cannot be stored: " + status.message());
  block_.clear();
}

UncertainPose MotionStore::operator[](std::size_t slot) const {
  if (slot >= filed_) return recent_[slot - filed_];
  const std::size_t first = slot - slot % kBlock;
  if (block_.empty() || block_first_ != first) loadBlock(first);
  return block_[slot - first];
}

void MotionStore::loadBlock(std::size_t first) const {
  std::vector<double> numbers(kBlock * kNumbers);
  const Status status = file_.read(offsetOf(first), std::as_writable_bytes(std::span(numbers)));
  if (!status.isOk()) throw std::runtime_error("motions cannot be read: " + status.message());
  block_.resize(kBlock);
  block_first_ = first;
  const double* in = numbers.data();
  for (UncertainPose& motion : block_) {
    std::copy_n(in, 16, motion.T.data());
    std::copy_n(in + 16, 36, motion.covariance.data());
    in += kNumbers;
  }
}

}  // namespace tolman::experience_map
