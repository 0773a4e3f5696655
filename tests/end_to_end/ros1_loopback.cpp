// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/ros1_loopback.hpp"

#include <arpa/inet.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>

namespace tolman::test {
namespace {

int freePort() {
  const int handle = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  (void)::bind(handle, reinterpret_cast<sockaddr*>(&address), size);
  (void)::getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(handle);
  return ntohs(address.sin_port);
}

}  // namespace

Ros1Loopback::Ros1Loopback(bool with_core) : port_(freePort()) {
  if (!with_core) return;
  core_ = start("core", {"roscore", "-p", std::to_string(port_)});
  CHECK(run(command({"/usr/bin/python3", kTool, "wait_master"})).exit_code == 0);
}

Ros1Loopback::~Ros1Loopback() {
  for (auto& process : others_) end(process);
  end(core_);
}

std::vector<std::string> Ros1Loopback::environment() const {
  return {"ROS_MASTER_URI=" + uri(), "ROS_HOSTNAME=127.0.0.1",
          "ROS_HOME=" + (folder() / "ros").string()};
}

std::vector<std::string> Ros1Loopback::command(const std::vector<std::string>& words) const {
  std::vector<std::string> all = environment();
  all.insert(all.begin(), "/usr/bin/env");
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

void Ros1Loopback::tool(std::vector<std::string> words) {
  const std::string name = "tool" + std::to_string(others_.size());
  words.insert(words.begin(), {"/usr/bin/python3", kTool});
  others_.push_back(start(name, words));
}

std::unique_ptr<Process> Ros1Loopback::start(const std::string& name,
                                             const std::vector<std::string>& words) {
  std::filesystem::create_directories(folder() / name);
  return std::make_unique<Process>(command(words), folder() / name);
}

void Ros1Loopback::end(std::unique_ptr<Process>& process) {
  if (process == nullptr) return;
  process->signal(SIGINT);  // roscore ends its own children then
  process->signal(SIGTERM);
  (void)process->wait();
  process.reset();
}

}  // namespace tolman::test
