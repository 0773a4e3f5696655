// SPDX-License-Identifier: BSD-3-Clause
#include "host/guard.hpp"

#include <immintrin.h>

#include <clocale>

namespace tolman::host {
namespace {

/// Of MXCSR, without the flags that calculations raise.
constexpr unsigned kControl = 0xffc0;

}  // namespace

KeptState::KeptState(bool handlers, std::set<std::string>* changed)
    : changed_(changed), mxcsr_(_mm_getcsr()), c_locale_(std::setlocale(LC_ALL, nullptr)) {
  std::fegetenv(&floats_);
  if (!handlers) return;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ, SIGCHLD}) {
    (void)::sigaction(signal, nullptr, &handlers_[signal]);
  }
}

KeptState::~KeptState() {
  const auto note = [&](const std::string& name) {
    if (changed_ != nullptr) changed_->insert(name);
  };
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
  for (const auto& [signal, before] : handlers_) {
    struct sigaction now {};
    (void)::sigaction(signal, nullptr, &now);
    if (now.sa_handler == before.sa_handler) continue;
    (void)::sigaction(signal, &before, nullptr);
    note("handler of signal " + std::to_string(signal));
  }
}

}  // namespace tolman::host
