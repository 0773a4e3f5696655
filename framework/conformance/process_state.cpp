// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/process_state.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <immintrin.h>
#include <sys/mman.h>
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
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) != 0) continue;
    state["handler of signal " + std::to_string(number)] =
        fmt::format("{}", fmt::ptr(reinterpret_cast<void*>(action.sa_handler)));
  }
  state["rounding mode"] = std::to_string(std::fegetround());
  state["denormals"] = std::to_string(_mm_getcsr() & 0x8040U);
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

double memoryMib(const char* key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key)) return std::stod(line.substr(line.find(':') + 1)) / 1024;  // kB
  }
  return 0;
}

void resetPeak() { std::ofstream("/proc/self/clear_refs") << "5"; }

OutputCapture::OutputCapture(int descriptor)
    : descriptor_(descriptor),
      saved_(::dup(descriptor)),
      file_(::memfd_create("output", MFD_CLOEXEC)) {
  std::fflush(nullptr);
  ::dup2(file_, descriptor_);
}

OutputCapture::~OutputCapture() {
  std::cout.flush();
  std::fflush(nullptr);
  ::dup2(saved_, descriptor_);
  ::close(saved_);
  ::close(file_);
}

std::string OutputCapture::text() const {
  std::cout.flush();
  std::fflush(nullptr);
  std::array<char, 200> text{};
  const ssize_t size = ::pread(file_, text.data(), text.size(), 0);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

}  // namespace tolman::conformance
