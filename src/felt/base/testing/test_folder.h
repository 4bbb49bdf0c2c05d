#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "felt/base/atomic_file.h"

namespace felt::testing {

/// A folder that is deleted after the test. It is in memory if the machine has such a file system,
/// because thousands of commits would wait for a disk otherwise.
struct TestFolder {
  TestFolder() {
    const bool has_memory = ::access("/dev/shm", W_OK) == 0;
    // mkdtemp() replaces the six letters at the end by others that make the name unique.
    std::string name = (has_memory ? "/dev/shm/" : ::testing::TempDir()) + "felt-test-XXXXXX";
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a folder for a test");
    path = name;
  }
  ~TestFolder() { std::filesystem::remove_all(path); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  [[nodiscard]] std::string at(std::string_view name) const {
    return path + '/' + std::string(name);
  }
  /// Writes a file, and returns its path.
  [[nodiscard]] std::string put(std::string_view name, std::string_view bytes) const {
    EXPECT_TRUE(write_file(at(name), bytes));
    return at(name);
  }

  std::string path;
};

}  // namespace felt::testing
