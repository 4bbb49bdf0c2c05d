#include "felt/io/inkml/inkml_trace.h"

#include <gmock/gmock.h>

#include <cmath>

namespace felt::inkml_trace_test {
namespace {

using Rows = std::vector<std::vector<double>>;
constexpr double kNone = -999.0;  // stands for an unknown value

Rows read(std::string_view text, std::size_t channels = 2, std::string* problem = nullptr) {
  InkmlTraceReader reader(text, channels);
  Rows points;
  while (reader.next()) {
    points.emplace_back();
    for (const double v : reader.values()) points.back().push_back(std::isnan(v) ? kNone : v);
  }
  if (problem != nullptr) {
    *problem = reader.problem();
  } else {
    EXPECT_EQ(reader.problem(), "") << text;
  }
  return points;
}

std::string problem(std::string_view text, std::size_t channels = 2) {
  std::string why;
  static_cast<void>(read(text, channels, &why));
  return why;
}

TEST(InkmlTrace, ExplicitValues) {
  EXPECT_EQ(read("10 0, 9 14,\n 8 28"), (Rows{{10, 0}, {9, 14}, {8, 28}}));
  EXPECT_EQ(read("1.5-2.5,.5+3"), (Rows{{1.5, -2.5}, {.5, 3}}));
  EXPECT_EQ(read(" 1 2 , , 3 4 , "), (Rows{{1, 2}, {3, 4}}));
  EXPECT_EQ(read("  "), (Rows{}));
}

TEST(InkmlTrace, TheExampleOfTheRecommendation) {
  // Computed by hand: velocities 23 43, then plus the second differences.
  EXPECT_EQ(read("1125 18432,'23'43,\"7\"-8,3-5,7 -3,6 2,6 8,3 6"), (Rows{{1125, 18432},
                                                                          {1148, 18475},
                                                                          {1178, 18510},
                                                                          {1211, 18540},
                                                                          {1251, 18567},
                                                                          {1297, 18596},
                                                                          {1349, 18633},
                                                                          {1404, 18676}}));
}

TEST(InkmlTrace, ModesStayUntilChangedChannelByChannel) {
  EXPECT_EQ(read("10 10,'1 20,1 30,!50'5,60 5"),
            (Rows{{10, 10}, {11, 20}, {12, 30}, {50, 35}, {60, 40}}));
}

TEST(InkmlTrace, AStarGoesOnAsBefore) {
  EXPECT_EQ(read("10 10,* 20,* *"), (Rows{{10, 10}, {10, 20}, {10, 20}}));
  EXPECT_EQ(read("10 10,'2'3,**,*1"), (Rows{{10, 10}, {12, 13}, {14, 16}, {16, 17}}));
  EXPECT_EQ(read("0 0,'1'1,\"1\"0,**,**"), (Rows{{0, 0}, {1, 1}, {3, 2}, {6, 3}, {10, 4}}));
}

TEST(InkmlTrace, UnknownAndLeftOut) {
  EXPECT_EQ(read("1 ? 3,4 5,6 ? ?", 3), (Rows{{1, kNone, 3}, {4, 5, kNone}, {6, kNone, kNone}}));
  EXPECT_EQ(read("*1"), (Rows{{kNone, 1}}));
}

TEST(InkmlTrace, BooleansAndHexadecimal) {
  EXPECT_EQ(read("10 20T,11 21F,12 22*", 3), (Rows{{10, 20, 1}, {11, 21, 0}, {12, 22, 0}}));
  EXPECT_EQ(read("#ff #10,#a 2"), (Rows{{255, 16}, {10, 2}}));
}

TEST(InkmlTrace, SaysWhereItIsBroken) {
  EXPECT_EQ(problem("1 2,3 x"), "has 'x' instead of a value, in point 2");
  EXPECT_EQ(problem("1 2 3"), "has more values than channels, in point 1");
  EXPECT_EQ(problem("1 '"), "has '' instead of a value, in point 1");
  EXPECT_EQ(problem("inf 2"), "has 'inf 2' instead of a value, in point 1");
  EXPECT_EQ(problem("1 -nan"), "has '-nan' instead of a value, in point 1");
  EXPECT_EQ(problem("1e400 1"), "has '1e400 1' instead of a value, in point 1");
  EXPECT_EQ(problem("#ffffffffffffffffff 1"), "has '#fffffffffff' instead of a value, in point 1");
}

TEST(InkmlTrace, NumbersAtTheirLimits) {
  EXPECT_EQ(problem("8999999999999 0"), "");
  EXPECT_EQ(problem("9000000000000 0"), "");
  EXPECT_EQ(problem("9000000000001 0"), "has a value that is too large, in point 1");
  EXPECT_EQ(problem("5e12 0,'5e12 0"), "has a value that is too large, in point 2");
  EXPECT_EQ(problem("1" + std::string(62, '0').replace(1, 1, ".") + " 0"), "");
  EXPECT_EQ(problem("1." + std::string(62, '0') + " 0"), "");
  EXPECT_NE(problem("1." + std::string(63, '0') + " 0"), "");
}

}  // namespace
}  // namespace felt::inkml_trace_test
