// SPDX-License-Identifier: BSD-3-Clause
#include "file_access.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace tolman::video {
namespace {

Status cannotOpen(const std::string& path, int error) {
  const char* const remedy = path.starts_with("/dev/")
                                 ? "connect the camera (`ls /dev/video*` lists those that are "
                                   "there), close other programs "
                                   "that use it, and add the user to the group video"
                                 : "check path and permissions";
  return Status::invalidInput(path + ": cannot be opened (" +
                              std::generic_category().message(error) + "); " + remedy);
}

Status waitForData(const std::string& path, int pipe, const Cancellation& cancellation,
                   double patience_s) {
  constexpr int kStep = 50;  // ms, until an interruption takes effect
  pollfd waiting{pipe, POLLIN, 0};
  for (double waited_ms = 0; waited_ms < patience_s * 1000; waited_ms += kStep) {
    const int ready = ::poll(&waiting, 1, kStep);
    if (ready > 0 && (waiting.revents & POLLIN) != 0) return Status::ok();
    if (cancellation.requested()) return {StatusCode::Cancelled, "waiting was cancelled"};
    if (ready > 0) break;  // its writer has ended
  }
  return Status::invalidInput(path +
                              ": nothing was written into this pipe; start the program that "
                              "writes the video into it");
}

}  // namespace

OpenFile::~OpenFile() {
  if (number_ >= 0) ::close(number_);
}

Result<PathKind> findKind(const std::filesystem::path& path, OpenFile& pipe,
                          const Cancellation& cancellation, double patience_s) {
  const std::string name = path.string();
  OpenFile file(::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0) return cannotOpen(name, errno);
  struct stat about {};
  if (::fstat(file.get(), &about) != 0) return cannotOpen(name, errno);
  if (S_ISREG(about.st_mode) && about.st_size == 0) {
    return Status::invalidInput(name + ": is empty; copy or record it again");
  }
  if (S_ISREG(about.st_mode)) return PathKind::File;
  if (S_ISCHR(about.st_mode)) return PathKind::Device;
  if (!S_ISFIFO(about.st_mode)) {
    return Status::invalidInput(name +
                                ": is a folder, not a video; name the file, or read a "
                                "folder of images by the source images");
  }
  const Status status = waitForData(name, file.get(), cancellation, patience_s);
  if (!status.isOk()) return status;
  pipe = std::move(file);
  return PathKind::Pipe;
}

}  // namespace tolman::video
