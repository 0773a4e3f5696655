// SPDX-License-Identifier: BSD-3-Clause
// One process that runs one stage, seen from the host.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "isolation/calls.hpp"
#include "isolation/channel.hpp"
#include "isolation/child_process.hpp"
#include "isolation/codec.hpp"
#include "isolation/shared_buffer.hpp"
#include "tolman/context.hpp"

namespace tolman::isolation {

/// How the processes of stages are started, and what they may take.
struct Launch {
  std::vector<std::string> command;  ///< of the program that calls serve(); numbers are appended
  double deadline_s = 60;            ///< of one call; 0 for none
  std::uint64_t memory_mib = 4096;   ///< of its data; 0 for no limit
  std::int64_t threads = 0;          ///< 0 for all
};

class Worker {
 public:
  using Write = std::function<void(Encoder&)>;
  using Read = std::function<void(Decoder&)>;

  /// Starts the process. Throws std::exception.
  explicit Worker(Launch launch);
  /// From now on lines of the log go there, and cancellation is passed on. Null: nowhere.
  void serve(Logger* log, const Cancellation* cancellation);

  /// One call. The status is the plugin's, or says what became of the process; `read` gets the
  /// answers when it is Ok.
  Status ask(Call call, const Write& write, const Read& read);
  /// From now on what a call carried is kept until the next.
  void keepRequests() { keep_requests_ = true; }
  const std::string& lastRequest() const { return kept_request_; }
  /// Ends the process.
  void abandon();
  /// The process has ended or was ended.
  bool gone() const { return gone_; }

 private:
  Wait listen(Note& note, std::chrono::steady_clock::time_point begin);
  Status died();
  Status ended(const std::string& why);
  Status take(const Note& reply, const Read& read);

  Launch launch_;
  SharedBuffer request_;
  SharedBuffer response_;
  SharedBuffer control_memory_;
  ControlBlock* control_;
  Socket socket_;
  std::unique_ptr<ChildProcess> process_;
  Logger* log_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  std::size_t request_size_ = 0;
  std::uint32_t serial_ = 0;  ///< of the last call
  bool keep_requests_ = false;
  std::string kept_request_;
  bool gone_ = false;
};

}  // namespace tolman::isolation
