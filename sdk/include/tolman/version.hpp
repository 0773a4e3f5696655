// SPDX-License-Identifier: BSD-3-Clause
// The SDK's version and the build fingerprint, which the host compares before it opens a plugin.
#pragma once

#include <Eigen/Core>

#define TOLMAN_SDK_MAJOR 0
#define TOLMAN_SDK_MINOR 3

#define TOLMAN_STRINGIFY_(x) #x
#define TOLMAN_STRINGIFY(x) TOLMAN_STRINGIFY_(x)
#define TOLMAN_SDK_VERSION TOLMAN_STRINGIFY(TOLMAN_SDK_MAJOR) "." TOLMAN_STRINGIFY(TOLMAN_SDK_MINOR)

// Sanitizers change allocation and must be the same on both sides.
#if defined(__SANITIZE_ADDRESS__)
#define TOLMAN_SANITIZER "address"
#elif defined(__SANITIZE_THREAD__)
#define TOLMAN_SANITIZER "thread"
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TOLMAN_SANITIZER "address"
#elif __has_feature(thread_sanitizer)
#define TOLMAN_SANITIZER "thread"
#else
#define TOLMAN_SANITIZER "none"
#endif
#else
#define TOLMAN_SANITIZER "none"
#endif

#if defined(_GLIBCXX_DEBUG)
#define TOLMAN_STDLIB_DEBUG "debug"
#else
#define TOLMAN_STDLIB_DEBUG "release"
#endif

// Eigen's alignment depends on -mavx2, -mavx512f and -march=native. If host and plugin differ in
// it, their types have equal sizes but different alignments, and the heap is corrupted later.
#define TOLMAN_FINGERPRINT \
  "libstdc++" TOLMAN_STRINGIFY(_GLIBCXX_RELEASE) "-" TOLMAN_STDLIB_DEBUG       \
  " cxx11abi" TOLMAN_STRINGIFY(_GLIBCXX_USE_CXX11_ABI)                         \
  " eigen" TOLMAN_STRINGIFY(EIGEN_WORLD_VERSION) "."                           \
  TOLMAN_STRINGIFY(EIGEN_MAJOR_VERSION) "." TOLMAN_STRINGIFY(EIGEN_MINOR_VERSION) \
  " align" TOLMAN_STRINGIFY(EIGEN_MAX_ALIGN_BYTES)                             \
  " sanitizer-" TOLMAN_SANITIZER

// Set by tolman_add_plugin(... OPENCV). One process cannot use two versions of OpenCV.
#if defined(TOLMAN_USES_OPENCV)
#include <opencv2/core/version.hpp>
#define TOLMAN_OPENCV_VERSION CV_VERSION
#else
#define TOLMAN_OPENCV_VERSION ""
#endif
