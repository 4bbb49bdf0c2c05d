#include "felt/store/journal_log.h"

#include <gtest/gtest.h>

#include <random>

namespace felt {
namespace {

TEST(JournalLog, WhateverIsCutOffTheWholeRecordsAreRead) {
  std::mt19937 random(1);
  std::vector<std::string> payloads;
  std::vector<std::size_t> ends;
  std::string log;
  for (int i = 0; i < 30; ++i) {
    std::string bytes(random() % 40, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    append_log_record(log, static_cast<std::uint8_t>(i), bytes);
    payloads.push_back(std::move(bytes));
    ends.push_back(log.size());
  }
  for (std::size_t size = 0; size <= log.size(); ++size) {
    const auto records = read_log(std::string_view(log).substr(0, size));
    std::size_t whole = 0;
    while (whole < ends.size() && ends[whole] <= size) ++whole;
    ASSERT_EQ(records.size(), whole) << size;
    for (std::size_t i = 0; i < whole; ++i) {
      EXPECT_EQ(records[i].type, i);
      EXPECT_EQ(records[i].bytes, payloads[i]);
    }
  }
  // A changed byte ends the belief there, and not before.
  for (std::size_t at = 0; at < log.size(); ++at) {
    std::string bad = log;
    bad[at] = static_cast<char>(bad[at] ^ 0x40);
    std::size_t before = 0;
    while (ends[before] <= at) ++before;
    EXPECT_EQ(read_log(bad).size(), before) << at;
  }
}

}  // namespace
}  // namespace felt
