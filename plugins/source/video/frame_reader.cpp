// SPDX-License-Identifier: BSD-3-Clause
#include "frame_reader.hpp"

#include <algorithm>
#include <string>

namespace tolman::video {

Status FrameReader::rewind() {
  capture_.reset();
  Result<std::unique_ptr<Capture>> opened = open_();
  if (!opened.isOk()) return opened.status();
  capture_ = std::move(opened).value();
  position_ = 0;
  block_.clear();
  return Status::ok();
}

Status FrameReader::readTimes(std::vector<Picture>& pictures, std::string& defect) {
  if (Status status = rewind(); !status.isOk()) return status;
  while (true) {
    Picture picture;
    const Status status = capture_->next(false, picture);
    if (status.code() == StatusCode::EndOfStream) {
      defect = capture_->defectOfEnd();
      return rewind();
    }
    if (!status.isOk()) return status;
    pictures.push_back(std::move(picture));
  }
}

std::int64_t FrameReader::blockSize() const {
  const PictureSize size = capture_->size();
  const auto bytes = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  constexpr std::size_t kBytesPerPixel = 3;
  return static_cast<std::int64_t>(
      std::max<std::size_t>(1, most_bytes_ / std::max<std::size_t>(1, bytes * kBytesPerPixel)));
}

Status FrameReader::read(std::int64_t index, Picture& picture) {
  const auto in_block = [&] {
    return index >= block_begin_ && index < block_begin_ + static_cast<std::int64_t>(block_.size());
  };
  if (!in_block()) {
    std::int64_t begin = index;
    if (capture_ == nullptr || index < position_) {
      if (Status status = rewind(); !status.isOk()) return status;
      begin = std::max<std::int64_t>(0, index - blockSize() + 1);
    }
    block_.clear();
    block_begin_ = begin;
    for (; position_ <= index; ++position_) {
      Picture next;
      const Status status = capture_->next(position_ >= begin, next);
      if (status.code() == StatusCode::EndOfStream) {
        return Status::failed("the video has become shorter; do not change it during a run");
      }
      if (!status.isOk()) return status;
      if (position_ >= begin) block_.push_back(std::move(next));
    }
  }
  picture = block_[static_cast<std::size_t>(index - block_begin_)];
  return Status::ok();
}

}  // namespace tolman::video
