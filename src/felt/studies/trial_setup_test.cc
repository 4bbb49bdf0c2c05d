#include "felt/studies/trial_setup.h"

#include <gmock/gmock.h>

#include "felt/session/session.h"
#include "felt/studies/testing/study_fixture.h"
#include "felt/trial/study_file.h"

namespace felt::trial_setup_test {
namespace {

using ::testing::HasSubstr;

Capabilities with_force() {
  Capabilities device;
  device.max_force_n = 3.0;
  return device;
}

std::string error_of(const std::string& condition, const Capabilities& device) {
  const Study study = read_study("id = \"s\"\n[[condition]]\nname = \"c\"\n" + condition +
                                 "\n[[shape]]\nname = \"l\"\nkind = \"line\"\n")
                          .value();
  const Result<void> checked = check_conditions(study, Materials::built_in(), device, "s.toml");
  return checked ? "" : checked.error().message;
}

TEST(TrialSetup, ChecksEachSettingWithItsLine) {
  EXPECT_EQ(error_of("settings = { \"pencil.snap\" = \"off\", \"surface.material\" = \"glass\" }",
                     with_force()),
            "");
  EXPECT_THAT(error_of("settings = { \"pencil.stabilizer\" = \"towed\" }", with_force()),
              HasSubstr("s.toml:4: condition.settings: pencil.stabilizer: "));
  EXPECT_THAT(error_of("settings = { \"pencil.stabiliser\" = \"towing\" }", with_force()),
              HasSubstr("towed"));
  EXPECT_THAT(error_of("settings = { \"pencil.stabiliser\" = true }", with_force()),
              HasSubstr("s.toml:4: "));
  EXPECT_THAT(error_of("settings = { \"crayon.size\" = 1 }", with_force()), HasSubstr("crayon"));
  EXPECT_THAT(error_of("settings = { \"surface.material\" = \"lava\" }", with_force()),
              HasSubstr("lava"));
}

TEST(TrialSetup, ChecksWhatTheDeviceCanDo) {
  EXPECT_EQ(error_of("needs = \"force\"", with_force()), "");
  EXPECT_EQ(error_of("", Capabilities()), "");
  EXPECT_THAT(error_of("needs = \"force\"", Capabilities()),
              HasSubstr("s.toml:3: condition.needs is \"force\""));
  EXPECT_THAT(error_of("guidance = \"groove\"", with_force()),
              HasSubstr("s.toml:3: condition.guidance"));
}

class TrialSetupTest : public felt::testing::StudyFixture {};

TEST_F(TrialSetupTest, SetsUpASessionWithTheDeviceAndTheOptions) {
  const StudyFiles files = small_study();
  PlannedTrial trial;
  trial.condition = 1;
  Session session(make_tools(), {});
  for (const Event& event : setup_events(files, trial, with_force())) {
    EXPECT_EQ(event.time_ns, 0);
    EXPECT_TRUE(session.apply(event));
  }
  EXPECT_EQ(session.device(), with_force());
  EXPECT_EQ(session.option("pencil.stabiliser").value(), OptionValue("towed"));
  EXPECT_EQ(session.option("pencil.snap").value(), OptionValue("off"));
}

}  // namespace
}  // namespace felt::trial_setup_test
