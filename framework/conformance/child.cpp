// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <stdexcept>

#include "host/channel.hpp"

namespace tolman::conformance {
namespace {

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    reader = isolation::Descriptor(ends[0]);
    writer = isolation::Descriptor(ends[1]);
  }
  isolation::Descriptor reader;
  isolation::Descriptor writer;
};

/// Appends what can be read without waiting; false at the end of the stream.
bool readAvailable(int descriptor, std::string& text) {
  std::array<char, 4096> piece{};
  for (;;) {
    const ssize_t bytes = ::read(descriptor, piece.data(), piece.size());
    if (bytes == 0) return false;
    if (bytes < 0) return true;
    text.append(piece.data(), static_cast<std::size_t>(bytes));
  }
}

/// Splits the report of a child into lines and keeps the last of its output.
class ChildReader {
 public:
  using OnLine = std::function<void(const std::string&)>;
  ChildReader(const Pipe& report, const Pipe& output, const OnLine& on_line)
      : report_(report), output_pipe_(output), on_line_(on_line) {}

  /// Waits at most 50 ms for bytes.
  void waitAndRead() {
    std::array<pollfd, 2> watched{
        {{report_.reader.get(), POLLIN, 0}, {output_pipe_.reader.get(), POLLIN, 0}}};
    ::poll(watched.data(), watched.size(), open_ ? 50 : 0);
    if (!open_) ::usleep(2000);
    read();
  }

  void read() {
    constexpr std::size_t kKept = 300;  // bytes
    open_ = readAvailable(report_.reader.get(), pending_);
    readAvailable(output_pipe_.reader.get(), output_);
    if (output_.size() > kKept) output_.erase(0, output_.size() - kKept);
    std::size_t newline = 0;
    while ((newline = pending_.find('\n')) != std::string::npos) {
      on_line_(pending_.substr(0, newline));
      pending_.erase(0, newline + 1);
    }
  }

  const std::string& output() const { return output_; }

 private:
  const Pipe& report_;
  const Pipe& output_pipe_;
  const OnLine& on_line_;
  std::string pending_;
  std::string output_;
  bool open_ = true;
};

}  // namespace

ChildEnd runChild(const std::function<std::vector<std::string>(int descriptor)>& command,
                  double timeout_s, const std::function<void(const std::string& line)>& on_line) {
  using Clock = std::chrono::steady_clock;
  Pipe report;
  Pipe output;
  isolation::ChildProcess child(command(report.writer.get()), {report.writer.get()},
                                output.writer.get());
  report.writer.close();
  output.writer.close();
  ChildReader reader(report, output, on_line);
  ChildEnd end;
  const auto begin = Clock::now();
  while (!child.hasEnded() && !end.timed_out) {
    end.timed_out = std::chrono::duration<double>(Clock::now() - begin).count() > timeout_s;
    if (!end.timed_out) reader.waitAndRead();
  }
  end.process = child.end(std::chrono::milliseconds(0));
  reader.read();
  end.output = reader.output();
  return end;
}

}  // namespace tolman::conformance
