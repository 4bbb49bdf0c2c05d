#include "felt/replay/forces_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace felt::forces_csv_test {
namespace {

std::string text_of(ForcesCsv& csv) {
  std::string text;
  EXPECT_TRUE(csv.finish([&text](std::string_view bytes) -> Result<void> {
    text += bytes;
    return {};
  }));
  return text;
}

TickReport tick_at(std::int64_t ms) {
  TickReport tick;
  tick.sample.time_ns = ms * 1'000'000;
  tick.sample.position = {0.1, -2.5, 3e-9};
  tick.asked = {0, -0.0, 0.3};
  return tick;
}

TEST(ForcesCsv, TheContractOfItsColumns) {
  ForcesCsv csv = ForcesCsv::create().value();
  TickReport tick = tick_at(7);
  tick.sample.velocity = {1, 2, 3};
  tick.sent = {0.5, 0.25, 0.125};
  tick.terms.add("plane", {0, 0, 0.3});
  ASSERT_TRUE(csv.add(tick, 0.5));
  EXPECT_EQ(text_of(csv),
            "t_ms,x,y,z,vx,vy,vz,pressure,ask_x,ask_y,ask_z,sent_x,sent_y,sent_z,"
            "plane_x,plane_y,plane_z\n"
            "7,0.1,-2.5,3e-09,1,2,3,0.5,0,0,0.3,0.5,0.25,0.125,0,0,0.3\n");
}

TEST(ForcesCsv, TermsThatComeLaterAreZeroBefore) {
  ForcesCsv csv = ForcesCsv::create().value();
  TickReport tick = tick_at(0);
  ASSERT_TRUE(csv.add(tick, {}));
  tick.terms.add("plane", {0, 0, 1});
  ASSERT_TRUE(csv.add(tick, {}));
  tick.terms.clear();
  tick.terms.add("well", {2, 0, 0});
  tick.terms.add("well", {1, 0, 0});  // the same term twice: the sum of both
  ASSERT_TRUE(csv.add(tick, {}));
  std::istringstream lines(text_of(csv));
  std::string line;
  const char* endings[] = {"plane_x,plane_y,plane_z,well_x,well_y,well_z",
                           ",,0,0,0.3,0,0,0,0,0,0,0,0,0", ",,0,0,0.3,0,0,0,0,0,1,0,0,0",
                           ",,0,0,0.3,0,0,0,0,0,0,3,0,0"};
  for (const std::string ending : endings) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_TRUE(line.size() > ending.size() &&
                line.compare(line.size() - ending.size(), ending.size(), ending) == 0)
        << line;
  }
}

TEST(ForcesCsv, EveryRowHasEveryColumnHoweverManyRows) {
  ForcesCsv csv = ForcesCsv::create().value();
  for (int i = 0; i < 20'000; ++i) {
    TickReport tick = tick_at(i);
    if (i > 5'000) tick.terms.add("plane", {0.1 * i, 0, 1});
    if (i > 12'345) tick.terms.add("friction", {0.1 * i, 0, 1});
    ASSERT_TRUE(csv.add(tick, 0.1));
  }
  std::istringstream lines(text_of(csv));
  std::string line;
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    ASSERT_EQ(std::count(line.begin(), line.end(), ','), 13 + 6) << rows;
    if (rows > 0) {
      ASSERT_EQ(line.substr(0, line.find(',')), std::to_string(rows - 1));
    }
  }
  EXPECT_EQ(rows, 20'001);
}

}  // namespace
}  // namespace felt::forces_csv_test
