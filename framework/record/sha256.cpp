// SPDX-License-Identifier: BSD-3-Clause
#include "record/sha256.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace tolman::record {
namespace {

void check(int success) {
  if (success != 1) throw std::runtime_error("libcrypto cannot compute SHA-256");
}

/// Without a handler of exit(): when a plugin calls it, other threads still compute digests.
evp_md_ctx_st* newContext() {
  check(OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr));
  return EVP_MD_CTX_new();
}

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* context) const { EVP_MD_CTX_free(context); }

Sha256::Sha256() : context_(newContext()) {
  check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Sha256::add(std::span<const std::byte> bytes) {
  check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::digest() {
  std::array<unsigned char, 32> bytes{};
  check(EVP_DigestFinal_ex(context_.get(), bytes.data(), nullptr));
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

}  // namespace tolman::record
