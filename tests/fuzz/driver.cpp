// SPDX-License-Identifier: BSD-3-Clause
// Runs a fuzz target without libFuzzer, as an ordinary test: each file of the corpus, then seeded
// random changes of them. The same arguments give the same inputs.
//   fuzz_TARGET [--mutations N] [--seed S] FILE-OR-FOLDER...
// An input at which the target ends the process is left as ./crash-input.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" {
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
// Targets whose input has check sums bring their own changes, made of those of LLVMFuzzerMutate().
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                    unsigned seed) __attribute__((weak));
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
int LLVMFuzzerInitialize(int* argc, char*** argv) __attribute__((weak));
void __sanitizer_set_death_callback(void (*callback)()) __attribute__((weak));
}

namespace {

namespace fs = std::filesystem;
using Input = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMax = 1U << 16U;  // bytes of a changed input
constexpr double kSlow = 10;             // s for one input, under sanitizers and beside others

struct Options {
  int mutations = 1000;
  unsigned seed = 1;
  std::vector<fs::path> paths;
};

// What a signal handler can reach.
const Input* g_current = nullptr;  // NOLINT
std::minstd_rand g_random;         // NOLINT
std::vector<Input> g_corpus;       // NOLINT

void keepInput() {
  if (g_current == nullptr) return;
  const int file = ::open("crash-input", O_CREAT | O_TRUNC | O_WRONLY, 0644);
  if (file < 0) return;
  const ssize_t written = ::write(file, g_current->data(), g_current->size());
  constexpr std::string_view kSaid = "fuzz: the input is in ./crash-input\n";
  if (written >= 0) (void)!::write(2, kSaid.data(), kSaid.size());
  ::close(file);
  g_current = nullptr;
}

void onSignal(int number) {
  keepInput();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

std::size_t below(std::size_t end) { return end == 0 ? 0 : g_random() % end; }

void insert(Input& input, std::size_t at, const std::uint8_t* bytes, std::size_t count) {
  input.insert(input.begin() + static_cast<std::ptrdiff_t>(at), bytes, bytes + count);
}

/// A piece of another input, over or into this one.
void splice(Input& input) {
  const Input other = g_corpus[below(g_corpus.size())];
  if (other.empty()) return;
  const std::size_t from = below(other.size());
  const std::size_t count = 1 + below(std::min<std::size_t>(other.size() - from, 64));
  insert(input, below(input.size() + 1), other.data() + from, count);
}

/// A number at the limits of its type.
void setNumber(Input& input) {
  constexpr std::array<std::uint64_t, 10> kNumbers = {
      0, 1, 0x7f, 0xff, 0x7fff, 0xffff, 0x7fffffff, 0xffffffff, 0x7fffffffffffffff, ~0ULL};
  constexpr std::array<std::size_t, 4> kSizes = {1, 2, 4, 8};
  const std::uint64_t number = kNumbers[below(kNumbers.size())];
  const std::size_t size = kSizes[below(kSizes.size())];
  if (input.size() < size) return;
  std::memcpy(input.data() + below(input.size() - size + 1), &number, size);
}

void change(Input& input) {
  const std::size_t at = below(input.size());
  const auto byte = static_cast<std::uint8_t>(below(256));
  switch (below(input.empty() ? 2 : 8)) {
    case 0:
      return insert(input, at, &byte, 1);
    case 1:
      return splice(input);
    case 2:
      input[at] ^= static_cast<std::uint8_t>(1U << below(8));
      return;
    case 3:
      input[at] = byte;
      return;
    case 4:
      return setNumber(input);
    case 5: {
      const auto begin = input.begin() + static_cast<std::ptrdiff_t>(at);
      input.erase(begin, begin + static_cast<std::ptrdiff_t>(
                                     1 + below(std::min<std::size_t>(input.size() - at, 32))));
      return;
    }
    case 6: {
      const std::size_t count = 1 + below(std::min<std::size_t>(input.size() - at, 64));
      const Input copy(input.begin() + static_cast<std::ptrdiff_t>(at),
                       input.begin() + static_cast<std::ptrdiff_t>(at + count));
      return insert(input, below(input.size()), copy.data(), count);
    }
    default:
      input[at] = static_cast<std::uint8_t>('0' + below(10));
  }
}

void run(const Input& input, const std::string& name) {
  g_current = &input;
  const Clock::time_point begin = Clock::now();
  // A copy of exactly its size, so that reading beyond its end is found.
  const auto copy = std::make_unique<std::uint8_t[]>(input.size());
  std::copy(input.begin(), input.end(), copy.get());
  (void)LLVMFuzzerTestOneInput(copy.get(), input.size());
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (seconds > kSlow) {
    std::fprintf(stderr, "fuzz: %s took %.1f s\n", name.c_str(), seconds);
    std::abort();
  }
  g_current = nullptr;
}

void addFile(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  g_corpus.emplace_back(bytes.begin(), bytes.end());
  run(g_corpus.back(), file.string());
}

void addAll(const Options& options) {
  for (const fs::path& path : options.paths) {
    if (!fs::is_directory(path)) {
      addFile(path);
      continue;
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) addFile(file);
  }
}

void runChanges(const Options& options) {
  for (int i = 0; i < options.mutations; ++i) {
    Input input = g_corpus[below(g_corpus.size())];
    const std::size_t size = std::min(input.size(), kMax);
    input.resize(kMax);
    const std::size_t changed =
        LLVMFuzzerCustomMutator != nullptr
            ? LLVMFuzzerCustomMutator(input.data(), size, kMax, static_cast<unsigned>(g_random()))
            : LLVMFuzzerMutate(input.data(), size, kMax);
    input.resize(changed);
    run(input, "change " + std::to_string(i));
  }
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--mutations" && i + 1 < argc) {
      options.mutations = std::stoi(argv[++i]);
    } else if (word == "--seed" && i + 1 < argc) {
      options.seed = static_cast<unsigned>(std::stoul(argv[++i]));
    } else {
      options.paths.emplace_back(word);
    }
  }
  return options;
}

}  // namespace

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most) {
  Input input(data, data + size);
  for (std::size_t n = 1 + below(8); n > 0; --n) change(input);
  input.resize(std::min(input.size(), most));
  std::copy(input.begin(), input.end(), data);
  return input.size();
}

int main(int argc, char** argv) {
  const Options options = parse(argc, argv);
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) {
    std::signal(number, onSignal);
  }
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(keepInput);
  g_random.seed(options.seed);
  if (LLVMFuzzerInitialize != nullptr) LLVMFuzzerInitialize(&argc, &argv);
  addAll(options);
  if (g_corpus.empty()) {
    std::fprintf(stderr, "fuzz: no corpus; give its folder\n");
    return 2;
  }
  runChanges(options);
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  std::printf("%zu files of the corpus, %d changes, at most %ld MiB\n", g_corpus.size(),
              options.mutations, usage.ru_maxrss / 1024);
  return 0;
}
