#include "doctor_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "felt/driver/testing/fake_system.h"
#include "system_fix.h"
#include "tests/support/scratch_path.h"

namespace felt::cli::doctor_report_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr const char* kRule = "/etc/udev/rules.d/70-feltline-falcon.rules";

Finding absent() {
  return {FindingLevel::kAbsent, "No such library."};
}

Finding problem() {
  return {FindingLevel::kProblem,
          "The library is there, but it does not load: another one that it needs is missing.",
          "libncurses.so.5: cannot open shared object file: No such file or directory",
          {"Install it:\nsudo apt install libncurses5", "Try again:\nfeltline doctor openhaptics"}};
}

DoctorReport report_with(std::vector<Finding> findings,
                         std::vector<DeviceDescriptor> devices = {}) {
  DoctorReport report;
  report.drivers = {{"openhaptics", "3D Systems", std::move(devices), std::move(findings)},
                    {"haply", "Haply", {}, {absent()}}};
  return report;
}

DeviceDescriptor touch() {
  DeviceDescriptor device;
  device.id = "openhaptics:default";
  device.label = "3D Systems Touch";
  return device;
}

Finding with_fix(std::string path, std::string activate = {}) {
  Finding finding = problem();
  finding.fix = SystemFix{std::move(path), "RULE\n", std::move(activate)};
  return finding;
}

TEST(DoctorReportTest, NothingHereNeedsNothing) {
  const DoctorReport report = report_with({absent()});
  EXPECT_EQ(count_problems(report), 0U);
  EXPECT_EQ(
      doctor_summary(report),
      "No haptic device is connected. You can draw with mouse and tablet; nothing needs fixing.");
  const std::string text = doctor_text(report, {});
  EXPECT_THAT(text, Not(HasSubstr("No such library")));  // the user did not name this driver
  EXPECT_THAT(text, HasSubstr("\n  openhaptics  3D Systems\n  haply        Haply\n"));
  EXPECT_THAT(text, HasSubstr("\n  feltline doctor openhaptics\n"));
}

TEST(DoctorReportTest, WhoAsksByNameIsToldAll) {
  DoctorReport report = report_with({absent()});
  report.is_named = true;
  EXPECT_THAT(doctor_text(report, {}), HasSubstr("No such library"));
}

TEST(DoctorReportTest, AProblemComesWithItsWordsAndCommandsOfTheirOwn) {
  const DoctorReport report = report_with({{FindingLevel::kOk, "Fine."}, problem()});
  EXPECT_EQ(count_problems(report), 1U);
  EXPECT_EQ(
      doctor_text(report, {}),
      "One thing needs fixing. It is marked MEND below, with instructions.\n\n"
      "3D Systems - openhaptics\n"
      "  MEND   The library is there, but it does not load: another one that it needs\n"
      "         is missing.\n"
      "         Details:\n"
      "           libncurses.so.5: cannot open shared object file: No such file or directory\n"
      "         1. Install it:\n"
      "              sudo apt install libncurses5\n"
      "         2. Try again:\n"
      "              feltline doctor openhaptics\n"
      "  fine   Fine.\n\n"
      "Not on this computer\n"
      "  haply  Haply\n"
      "That is fine unless you own such a device. If you do, ask for it by its name,\n"
      "and the next steps are shown:\n"
      "  feltline doctor haply\n");
}

TEST(DoctorReportTest, DevicesThatAreReady) {
  DeviceDescriptor perhaps = touch();
  perhaps.is_connected = false;
  EXPECT_EQ(doctor_summary(report_with({}, {touch()})),
            "Ready to draw with: 3D Systems Touch. Nothing needs fixing.");
  EXPECT_THAT(doctor_summary(report_with({}, {perhaps})), StartsWith("Possibly connected: 3D"));
  EXPECT_THAT(doctor_summary(report_with({problem()}, {touch()})), StartsWith("One thing"));
}

TEST(DoctorReportTest, ColourIsForTerminals) {
  TextStyle style{.is_terminal = true, .emphasis = true, .width = 60};
  const DoctorReport report = report_with({problem()});
  EXPECT_THAT(doctor_text(report, style), HasSubstr("\x1b[1;31mMEND\x1b[0m   The library"));
  style.emphasis = false;
  EXPECT_THAT(doctor_text(report, style), Not(HasSubstr("\x1b")));
}

TEST(DoctorReportTest, JsonHasItAll) {
  const std::string json = doctor_json(report_with({with_fix(kRule)}));
  EXPECT_THAT(json, HasSubstr(R"("problems":1,)"));
  EXPECT_THAT(json, HasSubstr(R"("level":"problem","what":"The library)"));
  EXPECT_THAT(json, HasSubstr(R"("fix":{"path":"/etc/udev/rules.d/70-feltline-falcon.rules")"));
}

TEST(SystemFixTest, SaysWhatWouldBeWritten) {
  FakeSystem system;
  DoctorReport report = report_with({with_fix(kRule, std::string(kReloadUdev))});
  auto plan = plan_fixes(report, system, "");
  ASSERT_TRUE(plan);
  ASSERT_THAT(*plan, SizeIs(1));
  EXPECT_EQ((*plan)[0].state, PlannedFix::State::kNew);
  EXPECT_EQ((*plan)[0].content, std::string(kOurFileMark) + "RULE\n");
  EXPECT_THAT(plan_text(*plan), HasSubstr("  | RULE\n"));
  EXPECT_THAT(plan_text(*plan), HasSubstr("udevadm control"));
  system.add_file(kRule, (*plan)[0].content);
  EXPECT_EQ(plan_fixes(report, system, "")->front().state, PlannedFix::State::kSame);
  system.add_file(kRule, std::string(kOurFileMark) + "OLD\n");
  EXPECT_EQ(plan_fixes(report, system, "")->front().state, PlannedFix::State::kOurs);
  system.add_file(kRule, "somebody's\n");
  EXPECT_EQ(plan_fixes(report, system, "")->front().state, PlannedFix::State::kForeign);
  system.forbid(kRule);
  EXPECT_EQ(plan_fixes(report, system, "")->front().state, PlannedFix::State::kForeign);
}

TEST(SystemFixTest, WritesNowhereElseAndRunsNothingElse) {
  const FakeSystem system;
  for (const char* path :
       {"/etc/passwd", "/etc/udev/rules.d/../../passwd", "relative", "/etc/udev/rules.d/",
        "/etc/udev/rules.d/.hidden", "/etc/udev/rules.d/sub/file"}) {
    EXPECT_FALSE(plan_fixes(report_with({with_fix(path)}), system, "")) << path;
  }
  EXPECT_FALSE(plan_fixes(report_with({with_fix(kRule, "rm -rf /")}), system, ""));
}

TEST(SystemFixTest, SeveralFindingsMayNeedOneFile) {
  Finding other = with_fix(kRule);
  other.fix->content = "OTHER\n";
  const auto plan =
      plan_fixes(report_with({with_fix(kRule), other, with_fix(kRule)}), FakeSystem(), "");
  ASSERT_TRUE(plan);
  ASSERT_THAT(*plan, SizeIs(1));
  EXPECT_EQ((*plan)[0].content, std::string(kOurFileMark) + "RULE\nOTHER\n");
}

TEST(SystemFixTest, WhatItAllowedBeforeStays) {
  FakeSystem system;
  const std::string before = std::string(kOurFileMark) + "# A wheel\nWHEEL\n\n# A stick\nSTICK";
  system.add_file(kRule, before);
  Finding pen = with_fix(kRule);
  pen.fix->content = "# A stick\nSTICK\n# A pen\nPEN\n";
  auto plan = plan_fixes(report_with({pen}), system, "");
  ASSERT_TRUE(plan);
  EXPECT_EQ((*plan)[0].state, PlannedFix::State::kOurs);
  EXPECT_EQ((*plan)[0].content, before + "\n# A pen\nPEN\n");
  // Applies the plan.
  system.add_file(kRule, (*plan)[0].content);
  plan = plan_fixes(report_with({pen}), system, "");
  EXPECT_EQ((*plan)[0].state, PlannedFix::State::kSame);
  // Only a comment is missing in the file, so the file counts as complete.
  system.add_file(kRule, before);
  pen.fix->content = "# The stick\nSTICK\n";
  plan = plan_fixes(report_with({pen}), system, "");
  EXPECT_EQ((*plan)[0].state, PlannedFix::State::kSame);
  EXPECT_EQ((*plan)[0].content, before);
}

TEST(SystemFixTest, WritesBelowAPrefixTwiceTheSame) {
  const std::string prefix = scratch_path("system-fix");
  std::filesystem::remove_all(prefix);
  const DoctorReport report = report_with({with_fix(kRule, std::string(kReloadUdev))});
  const auto plan = plan_fixes(report, this_system(), prefix);
  ASSERT_TRUE(plan);
  EXPECT_THAT((*plan)[0].activate, IsEmpty());
  const Result<void> done = write_fix((*plan)[0], true);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(this_system().read(prefix + kRule), (*plan)[0].content);
  EXPECT_EQ(plan_fixes(report, this_system(), prefix)->front().state, PlannedFix::State::kSame);
  std::filesystem::remove_all(prefix);
}

}  // namespace
}  // namespace felt::cli::doctor_report_test
