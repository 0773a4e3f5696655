// SPDX-License-Identifier: BSD-3-Clause
// Atomic replacement: a file is either the old or the new one.
#include "record/atomic_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "record/by_hand.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;
using test::contentOf;

namespace {

std::size_t filesIn(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("atomic writes replace whole files and leave nothing behind") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  REQUIRE(writeAtomically(file, "old").isOk());
  REQUIRE(writeAtomically(file, "new").isOk());
  CHECK(contentOf(file) == "new");
  CHECK(filesIn(folder.path()) == 1);
  CHECK_FALSE(writeAtomically(folder.path() / "absent" / "a.txt", "x").isOk());
}

TEST_CASE("a write that fails leaves the old file and no temporary one") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  REQUIRE(writeAtomically(file, "old").isOk());
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Status status = writeAtomically(file, std::string(5000, 'x'));
    _exit(
        status.message().find("a.txt: cannot be written; look for a full disk (File too large)") !=
                std::string::npos
            ? 0
            : 1);
  }
  int result = 0;
  waitpid(child, &result, 0);
  CHECK((WIFEXITED(result) && WEXITSTATUS(result) == 0));
  CHECK(contentOf(file) == "old");
  CHECK(filesIn(folder.path()) == 1);
}

TEST_CASE("a temporary file of a killed program does not interfere") {
  const test::TemporaryFolder folder;
  const std::string temporary = ".a.txt.partial" + std::to_string(::getpid());
  std::ofstream(folder.path() / temporary) << "half a fi, longer than the whole one";
  REQUIRE(writeAtomically(folder.path() / "a.txt", "whole").isOk());
  CHECK(contentOf(folder.path() / "a.txt") == "whole");
  CHECK(filesIn(folder.path()) == 1);
}

TEST_CASE("any contents, none, and names with characters that are special to a shell") {
  const test::TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  REQUIRE(writeAtomically(folder.path() / "with 'space'", bytes).isOk());
  CHECK(contentOf(folder.path() / "with 'space'") == bytes);
  REQUIRE(writeAtomically(folder.path() / "empty", "").isOk());
  CHECK(std::filesystem::file_size(folder.path() / "empty") == 0);
}

TEST_CASE("a folder in the place of the file is a failure that leaves nothing") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "a.txt" / "inside");
  const Status status = writeAtomically(folder.path() / "a.txt", "x");
  CHECK(status.message() ==
        (folder.path() / "a.txt").string() + ": cannot be replaced (Is a directory)");
  CHECK(filesIn(folder.path()) == 1);
}

TEST_CASE("a reader sees only complete files, however often they are replaced") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  REQUIRE(writeAtomically(file, std::string(50'000, '0')).isOk());
  std::atomic<bool> done = false;
  std::jthread writer([&] {
    for (int i = 0; i < 100; ++i) {
      (void)writeAtomically(file, std::string(50'000, static_cast<char>('0' + i % 10)));
    }
    done = true;
  });
  while (!done) {
    const std::string text = contentOf(file);
    REQUIRE(text.size() == 50'000);
    REQUIRE(text.find_first_not_of(text[0]) == std::string::npos);
  }
}

TEST_CASE("a descriptor is closed once, by its last owner") {
  int number = -1;
  {
    FileDescriptor first(::open("/", O_RDONLY | O_DIRECTORY));
    number = first.number();
    FileDescriptor second(std::move(first));
    FileDescriptor third(-1);
    third = std::move(second);
    CHECK(third.number() == number);
    CHECK(::fcntl(number, F_GETFD) != -1);
  }
  CHECK(::fcntl(number, F_GETFD) == -1);
}
