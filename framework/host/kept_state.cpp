// SPDX-License-Identifier: BSD-3-Clause
#include "host/kept_state.hpp"

#include <immintrin.h>

#include <clocale>
#include <mutex>
#include <utility>

namespace tolman::host {
namespace {

struct Restored {
  std::mutex mutex;
  std::set<std::string> names;
};
Restored& restored() {
  static Restored all;
  return all;
}

void note(const std::string& name) {
  const std::scoped_lock lock(restored().mutex);
  restored().names.insert(name);
}

/// Of MXCSR, without the flags that calculations raise.
constexpr unsigned kControl = 0xffc0;

}  // namespace

KeptState::KeptState() : mxcsr_(_mm_getcsr()), c_locale_(std::setlocale(LC_ALL, nullptr)) {
  std::fegetenv(&floats_);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    (void)::sigaction(kSignals[i], nullptr, &handlers_[i]);
  }
}

KeptState::~KeptState() {
  const unsigned changed = (_mm_getcsr() ^ mxcsr_) & kControl;
  std::fesetenv(&floats_);
  if ((changed & _MM_ROUND_MASK) != 0) note("rounding mode");
  if ((changed & ~unsigned{_MM_ROUND_MASK}) != 0) {
    note("floating point control (denormals, traps)");
  }
  const bool speaks_otherwise = c_locale_ != std::setlocale(LC_ALL, nullptr);
  if (std::locale() != locale_) {
    std::locale::global(locale_);  // sets that of C as well
    note("locale of C++");
  }
  if (speaks_otherwise) note("locale of C");
  if (c_locale_ != std::setlocale(LC_ALL, nullptr)) std::setlocale(LC_ALL, c_locale_.c_str());
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    struct sigaction handler {};
    (void)::sigaction(kSignals[i], nullptr, &handler);
    if (handler.sa_handler == handlers_[i].sa_handler) continue;
    (void)::sigaction(kSignals[i], &handlers_[i], nullptr);
    note("handler of signal " + std::to_string(kSignals[i]));
  }
}

std::set<std::string> takeRestored() {
  const std::scoped_lock lock(restored().mutex);
  return std::exchange(restored().names, {});
}

}  // namespace tolman::host
