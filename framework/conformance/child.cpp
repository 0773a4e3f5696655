// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/bounded_json.hpp"
#include "config/json_text.hpp"
#include "conformance/check.hpp"
#include "host/channel.hpp"
#include "host/child_process.hpp"

namespace tolman::conformance {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckTask, check, report_descriptor, file, id, set, seed, level,
                                   scratch, timeout_s, memory_mib, program)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CallStarted, call)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CurrentInput, description)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measurement, name, value, unit)
static void to_json(Json& json, const CheckFinding& finding) {
  json = {{"severity", finding.severity}, {"message", finding.message}, {"remedy", finding.remedy}};
}
static void from_json(const Json& json, CheckFinding& finding) {
  const auto severity = config::integerFrom<std::uint8_t>(json.at("severity"));
  if (severity >= kCheckSeverityNames.size()) throw std::runtime_error("no severity");
  finding.severity = static_cast<CheckSeverity>(severity);
  json.at("message").get_to(finding.message);
  json.at("remedy").get_to(finding.remedy);
}
static void to_json(Json& json, const CheckCompleted&) { json = nullptr; }
static void from_json(const Json&, CheckCompleted&) {}

namespace {

std::string dump(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// Decodes a message from [index of the alternative, its value].
template <class... M>
void read(const Json& json, std::variant<M...>& message) {
  const auto index = config::integerFrom<std::size_t>(json.at(0));
  std::size_t i = 0;
  ((index == i++ ? void(message = json.at(1).get<M>()) : void()), ...);
  if (index >= sizeof...(M)) throw std::runtime_error("no message");
}

}  // namespace

std::string encode(const CheckTask& task) { return dump(task); }

CheckTask decodeTask(const std::string& text) { return Json::parse(text).get<CheckTask>(); }

std::string encode(const CheckMessage& message) {
  return dump(std::visit([&](const auto& m) { return Json{message.index(), m}; }, message));
}

std::optional<CheckMessage> decodeMessage(const std::string& line) {
  try {
    CheckMessage message;
    read(bounded_json::parse<Json>(line), message);
    return message;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

namespace {

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    reader = host::Descriptor(ends[0]);
    writer = host::Descriptor(ends[1]);
  }
  host::Descriptor reader;
  host::Descriptor writer;
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
  host::ChildProcess child(command(report.writer.get()), {report.writer.get()},
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

namespace {

/// Unbuffered, so that no message is lost when the plugin crashes afterwards.
void send(int descriptor, const CheckMessage& message) {
  const std::string line = encode(message) + "\n";
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t bytes = ::write(descriptor, line.data() + sent, line.size() - sent);
    if (bytes <= 0) return;  // the kit has closed its end
    sent += static_cast<std::size_t>(bytes);
  }
}

}  // namespace

void runCheck(const std::string& text) {
  const CheckTask task = decodeTask(text);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // end with the kit
  host::limitResources(task.memory_mib);
  const std::vector<Check> checks = allChecks();
  const auto check = std::find_if(checks.begin(), checks.end(),
                                  [&](const Check& c) { return c.id == task.check; });
  if (check == checks.end()) throw std::runtime_error("no check '" + task.check + "'");
  const auto report = [descriptor = task.report_descriptor](const CheckMessage& message) {
    send(descriptor, message);
  };
  CheckContext context(task, check->remedy, report);
  try {
    if (check->same_images && context.manifest().hasExtra("live")) {
      context.skip("live images do not come twice");
    }
    check->run(context);
  } catch (const CheckEnded&) {  // the reason was sent
  } catch (const std::exception& error) {
    context.error(std::string("the check failed with an exception: ") + error.what());
  }
  report(CheckCompleted{});
}

}  // namespace tolman::conformance
