// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/process_state.hpp"

#include <dlfcn.h>
#include <immintrin.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <locale>
#include <thread>

namespace tolman::conformance {
namespace fs = std::filesystem;

namespace {

template <class T>
std::string pointerText(T* pointer) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%p", reinterpret_cast<void*>(pointer));
  return text.data();
}

void addSignals(ProcessState& state) {
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) != 0) continue;
    state["handler of signal " + std::to_string(number)] = pointerText(action.sa_handler);
  }
  sigset_t blocked;
  ::pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  std::string mask;
  for (int number = 1; number < NSIG; ++number) {
    if (sigismember(&blocked, number) == 1) mask += std::to_string(number) + " ";
  }
  state["blocked signals"] = mask;
}

void addNumbers(ProcessState& state) {
  constexpr unsigned kControl = 0xffc0;  // without the exception flags of calculations
  state["rounding mode"] = std::to_string(std::fegetround());
  state["floating point control (denormals, traps)"] = std::to_string(_mm_getcsr() & kControl);
}

double statusMib(const char* key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key)) return std::stod(line.substr(line.find(':') + 1)) / 1024;  // kB
  }
  return 0;
}

}  // namespace

ProcessState processState() {
  ProcessState state;
  state["locale of C"] = std::setlocale(LC_ALL, nullptr);
  state["locale of C++"] = std::locale().name();
  std::error_code error;
  state["working directory"] = fs::current_path(error).string();
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    state["environment variable " + text.substr(0, text.find('='))] = text;
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  state["umask"] = std::to_string(mask);
  addSignals(state);
  addNumbers(state);
  return state;
}

std::vector<std::string> differences(const ProcessState& before, const ProcessState& after) {
  ProcessState all = before;
  all.insert(after.begin(), after.end());
  std::vector<std::string> found;
  for (const auto& [name, ignored] : all) {
    const auto was = before.find(name);
    const auto is = after.find(name);
    if (was != before.end() && is != after.end() && was->second == is->second) continue;
    found.push_back(name + ": " + (was == before.end() ? "nothing" : "'" + was->second + "'") +
                    " became " + (is == after.end() ? "nothing" : "'" + is->second + "'"));
  }
  return found;
}

int openCvThreads() {
  for (const char* name : {"libopencv_core.so.406", "libopencv_core.so"}) {
    void* library = ::dlopen(name, RTLD_NOW | RTLD_NOLOAD);
    if (library == nullptr) continue;
    const auto function = reinterpret_cast<int (*)()>(::dlsym(library, "_ZN2cv13getNumThreadsEv"));
    return function != nullptr ? function() : -1;
  }
  return -1;
}

std::size_t threadCount(std::size_t expected) {
  using namespace std::chrono_literals;
  std::size_t count = 0;
  for (int i = 0; i < 50; ++i) {
    const fs::directory_iterator tasks("/proc/self/task");
    count = static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
    if (count <= expected) break;
    std::this_thread::sleep_for(10ms);
  }
  return count;
}

std::map<int, std::string> openFiles() {
  std::map<int, std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    const fs::path target = fs::read_symlink(entry.path(), error);
    if (!error) files[std::stoi(entry.path().filename())] = target.string();
  }
  std::erase_if(files, [](const auto& file) {
    return file.second.starts_with("/proc/") && file.second.ends_with("/fd");
  });
  return files;
}

double residentMib() { return statusMib("VmRSS:"); }
double peakResidentMib() { return statusMib("VmHWM:"); }
void resetPeakResident() { std::ofstream("/proc/self/clear_refs") << "5"; }

OutputCapture::OutputCapture() : out_(redirect(STDOUT_FILENO)), err_(redirect(STDERR_FILENO)) {}

OutputCapture::~OutputCapture() {
  std::cout.flush();
  std::fflush(nullptr);
  for (const Stream& stream : {out_, err_}) {
    ::dup2(stream.saved, stream.descriptor);
    ::close(stream.saved);
    ::close(stream.file);
  }
}

OutputCapture::Stream OutputCapture::redirect(int descriptor) {
  std::fflush(nullptr);
  const Stream stream{descriptor, ::dup(descriptor), ::memfd_create("output", MFD_CLOEXEC)};
  ::dup2(stream.file, descriptor);
  return stream;
}

std::string OutputCapture::contents(const Stream& stream) {
  std::cout.flush();
  std::fflush(nullptr);
  std::array<char, 200> text{};
  const ssize_t size = ::pread(stream.file, text.data(), text.size(), 0);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

std::string OutputCapture::out() const { return contents(out_); }
std::string OutputCapture::err() const { return contents(err_); }

}  // namespace tolman::conformance
