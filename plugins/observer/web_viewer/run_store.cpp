// SPDX-License-Identifier: BSD-3-Clause
#include "run_store.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace tolman::web_viewer {

namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

[[noreturn]] void failToCreate(const std::string& folder, const std::error_code& error) {
  const bool descriptors =
      error == std::errc::too_many_files_open || error == std::errc::too_many_files_open_in_system;
  throw std::system_error(
      error, folder + ": cannot hold temporary files; " +
                 (descriptors ? "allow more open files (`ulimit -n`)"
                              : "set TMPDIR to a folder that exists and can be written"));
}

}  // namespace

TemporaryFile::TemporaryFile() {
  std::error_code error;
  // Also of a folder that is none, the path is named.
  const char* given = std::getenv("TMPDIR");
  std::string folder = std::filesystem::temp_directory_path(error).string();
  if (error && given != nullptr) folder = given;
  if (error) failToCreate(folder, error);
  descriptor_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor_ >= 0) return;
  std::string name = folder + "/tolman-viewer-XXXXXX";  // no O_TMPFILE on this file system
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) failToCreate(folder, {errno, std::generic_category()});
  ::unlink(name.c_str());
}

TemporaryFile::~TemporaryFile() { ::close(descriptor_); }

void TemporaryFile::write(std::uint64_t offset, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail("the temporary file cannot be written");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

void TemporaryFile::read(std::uint64_t offset, std::span<char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail("the temporary file cannot be read");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

bool TemporaryFile::release(std::uint64_t offset, std::uint64_t size) {
  return ::fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                     static_cast<off_t>(offset), static_cast<off_t>(size)) == 0;
}

namespace {

// Bytes; only whole blocks of the file system can be freed.
constexpr std::uint64_t kBlock = 4096;

std::uint64_t blocks(std::uint64_t size) { return (size + kBlock - 1) / kBlock * kBlock; }

}  // namespace

bool Spool::store(std::int64_t number, const std::string& message) {
  const std::uint64_t needed = blocks(message.size());
  if (needed > capacity_ || full_) return false;
  if (const auto old = extents_.find(number); old != extents_.end()) drop(old);
  while (used_ + needed > capacity_ && !full_) thin();
  if (full_) return false;
  file_.write(end_, message);
  extents_[number] = {end_, message.size()};
  end_ += needed;
  used_ += needed;
  return true;
}

Spool::Extents::iterator Spool::drop(Extents::iterator extent) {
  const std::uint64_t size = blocks(extent->second.size);
  full_ = !file_.release(extent->second.offset, size) || full_;
  used_ -= size;
  return extents_.erase(extent);
}

/// Drops the second, fourth, ... message; if there is only one message, drops it.
void Spool::thin() {
  auto extent = extents_.begin();
  if (extents_.size() > 1) ++extent;
  while (extent != extents_.end()) {
    extent = drop(extent);
    if (extent != extents_.end()) ++extent;
  }
}

std::optional<std::string> Spool::at(std::int64_t number) const {
  const auto found = extents_.find(number);
  if (found == extents_.end()) return std::nullopt;
  std::string message(found->second.size, '\0');
  file_.read(found->second.offset, message);
  return message;
}

std::optional<std::int64_t> Spool::atOrBefore(std::int64_t number) const {
  auto after = extents_.upper_bound(number);
  if (after == extents_.begin()) return std::nullopt;
  return std::prev(after)->first;
}

namespace {

constexpr JpegOptions kThumbnail = {320, 70};

}  // namespace

RunStore::RunStore(const JpegOptions& jpeg_options, std::uint64_t spool_bytes)
    : jpeg_options_(jpeg_options),
      frames_(spool_bytes - spool_bytes / 8),
      template_images_(spool_bytes / 8) {
  hello_.columns = rowColumns();
}

void RunStore::add(const PendingData& pending) {
  rows_.append(pending.rows);
  events_.append(pending.events);
  messages_.append(pending.messages);
  pose_ = pending.pose;
  if (pending.has_graph) {
    graph_ = std::make_shared<const std::string>(pending.graph.encode());
    flat_graph_ = pending.graph;
  }
  if (pending.has_frame) {
    const auto frame =
        std::make_shared<const EncodedFrame>(encodeFrame(pending.newest, jpeg_options_));
    (void)frames_.store(frame->header.frame, storedMessage(*frame, pending.events));
    newest_ = frame;
  }
  for (const TemplateImage& made : pending.template_images) {
    // Not stored when the spool is full: /api/template then answers 404.
    (void)template_images_.store(made.template_id, jpeg(made.image, kThumbnail));
  }
}

HelloHeader RunStore::hello() const {
  HelloHeader hello = hello_;
  hello.rows = static_cast<std::int64_t>(rows_.size());
  return hello;
}

void RunStore::end(std::string_view state) {
  end_state_ = state;
  hello_.live = false;
}

std::string RunStore::endMessage() const {
  const EndHeader header{end_state_, static_cast<std::int64_t>(rows_.size())};
  return encodeContainer(headerJson(header), {});
}

}  // namespace tolman::web_viewer
