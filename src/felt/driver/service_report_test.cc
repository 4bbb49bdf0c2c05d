#include "felt/driver/service_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "felt/base/constants.h"

namespace felt::service_report_test {
namespace {

ServiceReport prompt_report() {
  return ServiceReport(kMs, {ShortText("late"), ShortText("slow")});
}

TEST(ServiceReport, AForceThatIsNotANumberIsNone) {
  ServiceReport report = prompt_report();
  const Force bad{std::nan(""), 0, 0};
  EXPECT_EQ(report.allowed(bad, std::nullopt), Force{});
  EXPECT_EQ(report.written(bad, std::nullopt).error(), DeviceFault::kBadData);
  EXPECT_EQ(report.allowed({1, 0, 0}, std::nullopt), (Force{1, 0, 0}));
  EXPECT_TRUE(report.written({1, 0, 0}, std::nullopt).has_value());
}

TEST(ServiceReport, AStopIsReportedOnce) {
  ServiceReport report = prompt_report();
  report.stop_force(ShortText("brake"));
  const std::optional<ShortText> why = report.stopped_words();
  EXPECT_EQ(report.allowed({1, 0, 0}, why), Force{});
  EXPECT_EQ(report.written({1, 0, 0}, why).error(), DeviceFault::kForcesOff);
  EXPECT_FALSE(report.stopped_words().has_value());
  EXPECT_EQ(report.shown().vendor_words.view(), "brake");
  EXPECT_EQ(report.shown().faults, 1u);
}

TEST(ServiceReport, ALateServiceIsOneFaultHoweverLongItLasts) {
  ServiceReport report = prompt_report();
  for (int i = 0; i < 500; ++i) {
    report.follow(kMs, i < 100);
    if (report.pace_words()) {
      EXPECT_EQ(report.written({}, report.pace_words()).error(), DeviceFault::kForcesOff);
      EXPECT_EQ(report.failed(DeviceFault::kOther, ShortText("nothing")).value(),
                DeviceFault::kOther);
    }
  }
  EXPECT_EQ(report.shown().vendor_words.view(), "late");
  EXPECT_EQ(report.shown().faults, 1u);
  report.restart_pace();
  EXPECT_FALSE(report.pace_words().has_value());
  EXPECT_EQ(report.pace().share(), 1.0);
}

}  // namespace
}  // namespace felt::service_report_test
