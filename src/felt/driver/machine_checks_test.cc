#include "felt/driver/machine_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/driver/testing/fake_system.h"

namespace felt::machine_checks_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kOrdinaryLimits =
    "Limit                     Soft Limit           Hard Limit           Units     \n"
    "Max locked memory         8388608              8388608              bytes     \n"
    "Max realtime priority     0                    0                    \n";

FakeSystem ordinary() {
  FakeSystem system;
  system.set_user("ada", {"ada"})
      .set_environment("HOME", "/home/ada")
      .add_folder("/home/ada")
      .add_file("/proc/self/limits", kOrdinaryLimits)
      .add_file("/proc/self/status", "Name:\tfeltline\nCapEff:\t0000000000000000\n")
      .add_file("/proc/sys/kernel/osrelease", "6.1.0-13-amd64\n")
      .add_file("/run/udev/control")
      .set_environment("WAYLAND_DISPLAY", "wayland-0");
  return system;
}

const Finding& about(const std::vector<Finding>& findings, const std::string& words) {
  for (const Finding& finding : findings) {
    if (finding.what.find(words) != std::string::npos) return finding;
  }
  ADD_FAILURE() << "nothing about " << words;
  return findings.front();
}

TEST(MachineChecksTest, AnOrdinaryDesktopHasNoProblem) {
  const FakeSystem system = ordinary();
  for (const Finding& finding : diagnose_machine(system)) {
    EXPECT_NE(finding.level, FindingLevel::kProblem) << finding.what;
  }
}

TEST(MachineChecksTest, RealTimeComesWithTheLinesThatAllowIt) {
  const std::vector<Finding> findings = diagnose_machine(ordinary());
  const Finding& finding = about(findings, "real time");
  EXPECT_EQ(finding.level, FindingLevel::kWarning);
  ASSERT_TRUE(finding.fix);
  EXPECT_EQ(finding.fix->path, "/etc/security/limits.d/70-feltline.conf");
  EXPECT_THAT(finding.fix->content, HasSubstr("\nada - rtprio 80\nada - memlock unlimited\n"));
  EXPECT_THAT(finding.steps,
              ElementsAre(HasSubstr("\nfeltline doctor --fix"), HasSubstr("Log out")));
}

TEST(MachineChecksTest, RealTimeIsThereByLimitsOrByCapabilities) {
  FakeSystem by_limits = ordinary();
  by_limits.add_file("/proc/self/limits",
                     "Max locked memory         unlimited            unlimited            bytes\n"
                     "Max realtime priority     95                   95                   \n");
  EXPECT_EQ(about(diagnose_machine(by_limits), "real time").level, FindingLevel::kOk);
  FakeSystem by_capabilities = ordinary();
  by_capabilities.add_file("/proc/self/status", "CapEff:\t0000000000804000\n");
  EXPECT_EQ(about(diagnose_machine(by_capabilities), "real time").level, FindingLevel::kOk);
  FakeSystem in_part = ordinary();
  in_part.add_file("/proc/self/status", "CapEff:\t0000000000800000\n");
  EXPECT_EQ(about(diagnose_machine(in_part), "lock its memory").level, FindingLevel::kWarning);
}

TEST(MachineChecksTest, WhatIsWrittenMustOnlyComeIntoEffect) {
  FakeSystem system = ordinary();
  system.add_file(std::string(kLimitsFile), std::string(kOurFileMark) + limits_lines("ada"));
  const std::vector<Finding> findings = diagnose_machine(system);
  const Finding& finding = about(findings, "not in effect yet");
  EXPECT_FALSE(finding.fix);
  EXPECT_THAT(finding.steps, ElementsAre(HasSubstr("Log out")));
}

TEST(MachineChecksTest, AUserWithAStrangeNameIsNotWrittenAnywhere) {
  FakeSystem system = ordinary();
  system.set_user("ada - rtprio 99\nroot");
  EXPECT_FALSE(about(diagnose_machine(system), "real time").fix);
}

TEST(MachineChecksTest, FoldersThatCannotBeWritten) {
  FakeSystem system = ordinary();
  system.add_folder("/home/ada/.config").forbid("/home/ada/.config");
  const std::vector<Finding> findings = diagnose_machine(system);
  const Finding& finding = about(findings, "cannot be kept");
  EXPECT_EQ(finding.level, FindingLevel::kProblem);
  EXPECT_EQ(finding.details, "/home/ada/.config: Permission denied");
  EXPECT_THAT(finding.steps, ElementsAre(HasSubstr("\nsudo chown -R ada '/home/ada/.config'")));
  FakeSystem homeless = ordinary();
  homeless.set_environment("HOME", "/nonexistent").add_folder("/tmp").forbid("/");
  const std::vector<Finding> others = diagnose_machine(homeless);
  const Finding& without_home = about(others, "cannot be kept");
  EXPECT_THAT(without_home.steps, ElementsAre(::testing::Not(HasSubstr("chown"))));
  FakeSystem nowhere;
  EXPECT_EQ(about(diagnose_machine(nowhere), "home folder").level, FindingLevel::kProblem);
}

TEST(MachineChecksTest, KernelVersions) {
  FakeSystem system;
  EXPECT_EQ(kernel_version(system), KernelVersion{});
  const std::vector<std::pair<std::string, KernelVersion>> cases = {
      {"6.18.0\n", {6, 18}}, {"6.1.0-13-amd64", {6, 1}}, {"7.0-rc1", {7, 0}}, {"x", {}}, {"6", {}},
      {"99999999999.1", {}}};
  for (const auto& [text, version] : cases) {
    system.add_file("/proc/sys/kernel/osrelease", text);
    EXPECT_EQ(kernel_version(system), version) << text;
  }
  EXPECT_LT((KernelVersion{6, 1}), (KernelVersion{6, 18}));
  EXPECT_LT((KernelVersion{6, 18}), (KernelVersion{7, 0}));
}

}  // namespace
}  // namespace felt::machine_checks_test
