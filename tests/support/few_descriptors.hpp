// SPDX-License-Identifier: BSD-3-Clause
// A process that can open only a few more files.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <vector>

namespace tolman::test {

/// While it lives, no more than `left` files can be opened.
class FewDescriptors {
 public:
  explicit FewDescriptors(int left) {
    REQUIRE(::getrlimit(RLIMIT_NOFILE, &before_) == 0);
    const rlimit few{128, before_.rlim_max};
    REQUIRE(::setrlimit(RLIMIT_NOFILE, &few) == 0);
    for (int file = 0; file >= 0;) {
      file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
      if (file >= 0) held_.push_back(file);
    }
    for (int i = 0; i < left; ++i) release();
  }
  ~FewDescriptors() {
    while (!held_.empty()) release();
    ::setrlimit(RLIMIT_NOFILE, &before_);
  }
  FewDescriptors(const FewDescriptors&) = delete;
  FewDescriptors& operator=(const FewDescriptors&) = delete;

 private:
  void release() {
    ::close(held_.back());
    held_.pop_back();
  }
  rlimit before_{};
  std::vector<int> held_;
};

}  // namespace tolman::test
