// SPDX-License-Identifier: BSD-3-Clause
// Reads files and databases without the code under test.
#pragma once

#include <sqlite3.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace tolman::test {

/// Writes a file and the folders above it.
inline void writeFile(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

inline std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

inline std::vector<double> numbersOf(const std::string& line) {
  std::vector<double> numbers;
  for (const std::string& word : wordsOf(line)) numbers.push_back(std::stod(word));
  return numbers;
}

/// The rows that a statement gives, cells joined by '|', NULL as such. REQUIREs that it succeeds.
inline std::vector<std::string> queryByHand(const std::filesystem::path& folder,
                                            const std::string& sql) {
  sqlite3* handle = nullptr;
  REQUIRE(sqlite3_open((folder / "run.sqlite").c_str(), &handle) == SQLITE_OK);
  std::vector<std::string> rows;
  const auto take = [](void* out, int columns, char** values, char**) {
    std::string row;
    for (int i = 0; i < columns; ++i) {
      row += i == 0 ? "" : "|";
      row += values[i] != nullptr ? values[i] : "NULL";
    }
    static_cast<std::vector<std::string>*>(out)->push_back(row);
    return 0;
  };
  INFO(sql);
  const int code = sqlite3_exec(handle, sql.c_str(), take, &rows, nullptr);
  INFO(sqlite3_errmsg(handle));
  REQUIRE(code == SQLITE_OK);
  sqlite3_close(handle);
  return rows;
}

}  // namespace tolman::test
