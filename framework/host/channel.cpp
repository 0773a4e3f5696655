// SPDX-License-Identifier: BSD-3-Clause
#include "host/channel.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace tolman::host {

namespace {

constexpr std::size_t kStep = std::size_t{1} << 20U;  // bytes; each growth is a system call

[[noreturn]] void throwErrno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

std::size_t sizeOf(int descriptor) {
  struct stat state {};
  if (::fstat(descriptor, &state) != 0) throwErrno("the size of shared memory cannot be read");
  return static_cast<std::size_t>(state.st_size);
}

}  // namespace

SharedBuffer::SharedBuffer(const std::string& name)
    : descriptor_(::memfd_create(name.c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (descriptor_ < 0) throwErrno("no shared memory");
  if (::fcntl(descriptor_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_SEAL) != 0) {
    ::close(descriptor_);
    throwErrno("shared memory cannot be sealed");
  }
}

SharedBuffer::~SharedBuffer() {
  if (memory_ != nullptr) ::munmap(memory_, mapped_);
  ::close(descriptor_);
}

void SharedBuffer::map(std::size_t size) {
  void* memory = memory_ == nullptr
                     ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0)
                     : ::mremap(memory_, mapped_, size, MREMAP_MAYMOVE);
  if (memory == MAP_FAILED) throwErrno("shared memory cannot be mapped");
  memory_ = static_cast<std::byte*>(memory);
  mapped_ = size;
}

std::byte* SharedBuffer::reserve(std::size_t size) {
  if (size <= mapped_) return memory_;
  // Grow by half, because a long list is written in many pieces.
  const std::size_t wanted = std::max(size, mapped_ + mapped_ / 2);
  const std::size_t rounded = (wanted + kStep - 1) / kStep * kStep;
  if (sizeOf(descriptor_) < rounded && ::ftruncate(descriptor_, static_cast<off_t>(rounded)) != 0) {
    throwErrno("shared memory cannot grow");
  }
  map(rounded);
  return memory_;
}

const std::byte* SharedBuffer::view(std::size_t size) {
  if (size <= mapped_) return memory_;
  const std::size_t there = sizeOf(descriptor_);
  if (there < size) throw std::runtime_error("a message longer than the shared memory");
  map(std::min(there, (size + kStep - 1) / kStep * kStep));
  return memory_;
}

void Descriptor::close() {
  if (value_ >= 0) ::close(release());
}

std::array<Socket, 2> Socket::pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "no socket");
  }
  return {Socket(Descriptor(ends[0])), Socket(Descriptor(ends[1]))};
}

bool Socket::send(const SocketMessage& message) const {
  MessageHead head = message;
  // sendmsg() does not change the text, but its pointer is not const.
  std::array<iovec, 2> pieces{
      {{&head, sizeof head},
       {const_cast<char*>(message.text.data()), std::min(message.text.size(), kMaxText)}}};
  msghdr header{};
  header.msg_iov = pieces.data();
  header.msg_iovlen = pieces.size();
  ssize_t sent = 0;
  do {
    sent = ::sendmsg(descriptor_.get(), &header, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

ReceiveResult Socket::receive(SocketMessage& message, std::chrono::milliseconds timeout) const {
  pollfd watched{descriptor_.get(), POLLIN, 0};
  const int ready = ::poll(&watched, 1, static_cast<int>(timeout.count()));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return ReceiveResult::Timeout;
  MessageHead& head = message;
  message.text.resize(kMaxText);
  std::array<iovec, 2> pieces{{{&head, sizeof head}, {message.text.data(), message.text.size()}}};
  msghdr header{};
  header.msg_iov = pieces.data();
  header.msg_iovlen = pieces.size();
  const ssize_t bytes = ::recvmsg(descriptor_.get(), &header, 0);
  if (bytes < 0 && errno == EINTR) return ReceiveResult::Timeout;
  if (bytes < static_cast<ssize_t>(sizeof head))
    return ReceiveResult::Closed;  // closed, or not a valid message
  message.text.resize(static_cast<std::size_t>(bytes) - sizeof head);
  return ReceiveResult::Message;
}

}  // namespace tolman::host
