// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/slurm_cluster.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

namespace tolman::test {
namespace {

namespace fs = std::filesystem;

constexpr int kWait = 600;  // tenths of a second

/// A port of the loopback that nobody uses now.
int freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  auto* any = reinterpret_cast<sockaddr*>(&address);
  const bool bound = ::bind(socket, any, size) == 0 && ::getsockname(socket, any, &size) == 0;
  ::close(socket);
  return bound ? ntohs(address.sin_port) : 0;
}

template <class Condition>
bool waitFor(Condition&& condition) {
  for (int i = 0; i < kWait; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

std::string programOf(const char* name) {
  for (const char* folder : {"/usr/sbin/", "/usr/bin/"}) {
    if (fs::exists(std::string(folder) + name)) return std::string(folder) + name;
  }
  return "";
}

}  // namespace

std::unique_ptr<SlurmCluster> SlurmCluster::start() {
  for (const char* name : {"slurmctld", "slurmd", "sbatch", "squeue", "scancel"}) {
    if (programOf(name).empty()) return nullptr;
  }
  return std::unique_ptr<SlurmCluster>(new SlurmCluster);
}

SlurmCluster::SlurmCluster() {
  // Root hands over to an ordinary user, where that one may execute what was built.
  drops_root_ =
      ::getuid() == 0 && test::run({"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups",
                                    tolmanProgram().string(), "--version"})
                                 .exit_code == 0;
  for (const char* name : {"spool", "state", "out-c", "out-d"}) {
    fs::create_directories(folder_.path() / name);
  }
  const fs::path file = folder_.path() / "slurm.conf";
  std::ofstream(file) << configuration();
  give(folder_.path());
  const char* old = std::getenv("SLURM_CONF");
  previous_ = old == nullptr ? "" : old;
  ::setenv("SLURM_CONF", file.c_str(), 1);
  controller_ =
      std::make_unique<Process>(asUser({programOf("slurmctld"), "-D"}), folder_.path() / "out-c");
  node_ = std::make_unique<Process>(asUser({programOf("slurmd"), "-D", "-N", "localhost"}),
                                    folder_.path() / "out-d");
}

SlurmCluster::~SlurmCluster() {
  (void)run({"scancel", "--state=RUNNING"});
  (void)run({"scancel", "--state=PENDING"});
  for (const auto& process : {std::ref(node_), std::ref(controller_)}) {
    process.get()->signal(SIGTERM);
    process.get()->wait();
  }
  if (previous_.empty()) {
    ::unsetenv("SLURM_CONF");
  } else {
    ::setenv("SLURM_CONF", previous_.c_str(), 1);
  }
}

std::string SlurmCluster::configuration() const {
  std::string user = run({"id", "-un"}).out;
  user.erase(std::min(user.find('\n'), user.size()));
  const std::string here = folder_.path().string();
  std::ostringstream text;
  text << "ClusterName=test\nSlurmctldHost=localhost(127.0.0.1)\nSlurmUser=" << user
       << "\nSlurmdUser=" << user
       << "\nAuthType=auth/none\nCredType=cred/none\nMpiDefault=none\n"
          "ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nReturnToService=2\n"
          "SlurmctldPort="
       << freePort() << "\nSlurmdPort=" << freePort() << "\nSlurmctldPidFile=" << here
       << "/c.pid\nSlurmdPidFile=" << here << "/d.pid\nSlurmdSpoolDir=" << here
       << "/spool\nStateSaveLocation=" << here << "/state\nSlurmctldLogFile=" << here
       << "/c.log\nSlurmdLogFile=" << here
       << "/d.log\nSchedulerType=sched/builtin\nSelectType=select/cons_tres\n"
          "SelectTypeParameters=CR_Core\nAccountingStorageType=accounting_storage/none\n"
          "JobAcctGatherType=jobacct_gather/none\nKillWait=2\n"
          "NodeName=localhost NodeAddr=127.0.0.1 CPUs="
       << std::max(1U, std::thread::hardware_concurrency())
       << " State=UNKNOWN\n"
          "PartitionName=all Nodes=localhost Default=YES MaxTime=INFINITE State=UP\n";
  return text.str();
}

std::vector<std::string> SlurmCluster::asUser(std::vector<std::string> command) const {
  if (!drops_root_) return command;
  const std::vector<std::string> user = {"setpriv", "--reuid=65534", "--regid=65534",
                                         "--clear-groups"};
  command.insert(command.begin(), user.begin(), user.end());
  return command;
}

Finished SlurmCluster::run(const std::vector<std::string>& command) const {
  return test::run(asUser(command));
}

void SlurmCluster::give(const fs::path& folder) const {
  if (drops_root_) (void)test::run({"chown", "-R", "65534:65534", folder.string()});
}

bool SlurmCluster::waitUntilIdle() const {
  return waitFor([&] { return contains(run({"sinfo", "-h", "-o", "%t"}).out, "idle"); });
}

bool SlurmCluster::waitUntilDone() const {
  return waitFor([&] {
    const Finished queue = run({"squeue", "-h"});
    return queue.exit_code == 0 && queue.out.empty();
  });
}

std::string SlurmCluster::logs() const {
  return readText(folder_.path() / "c.log") + readText(folder_.path() / "d.log");
}

}  // namespace tolman::test
