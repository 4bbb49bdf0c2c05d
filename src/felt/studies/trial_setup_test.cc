#include "felt/studies/trial_setup.h"

#include <gmock/gmock.h>

#include "felt/session/session.h"
#include "felt/studies/testing/study_fixture.h"
#include "felt/tools/guide_line.h"

namespace felt::trial_setup_test {
namespace {

using ::testing::HasSubstr;

Capabilities with_force() {
  Capabilities device;
  device.max_force_n = 3.0;
  return device;
}

class TrialSetupTest : public felt::testing::StudyFixture {
 protected:
  StudyFiles study_with(const std::string& condition) const {
    write("s.toml", "id = \"s\"\n[[condition]]\nname = \"c\"\n" + condition +
                        "\n[[shape]]\nname = \"l\"\nkind = \"line\"\n"
                        "\n[[shape]]\nname = \"o\"\nkind = \"circle\"\n");
    return read_study_files(path("s.toml")).value();
  }
  std::string error_of(const std::string& condition, const Capabilities& device) const {
    const Result<void> checked =
        check_conditions(study_with(condition), Materials::built_in(), device, "s.toml");
    return checked ? "" : checked.error().message;
  }
};

TEST_F(TrialSetupTest, ChecksEachSettingWithItsLine) {
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
  EXPECT_THAT(error_of("settings = { \"surface.plane_only\" = true }", with_force()),
              HasSubstr("s.toml:4: condition.settings: surface.plane_only: condition.forces"));
  EXPECT_THAT(error_of("settings = { \"surface.material\" = \"lava\" }", with_force()),
              HasSubstr("lava"));
}

TEST_F(TrialSetupTest, ChecksWhatTheDeviceCanDo) {
  EXPECT_EQ(error_of("needs = \"force\"", with_force()), "");
  EXPECT_EQ(error_of("", Capabilities()), "");
  EXPECT_THAT(error_of("needs = \"force\"", Capabilities()),
              HasSubstr("s.toml:3: condition.needs is \"force\""));
  EXPECT_EQ(error_of("guidance = \"groove\"", with_force()), "");
  EXPECT_THAT(error_of("guidance = \"groove\"", Capabilities()),
              HasSubstr("s.toml:3: condition.guidance is \"groove\""));
}

TEST_F(TrialSetupTest, AStudyOfShareCanBeTriedWithoutForces) {
  const Result<StudyFiles> files = read_study_files("share/studies/stabilisers.toml");
  ASSERT_TRUE(files);
  EXPECT_TRUE(check_conditions(*files, Materials::built_in(), Capabilities(), "s.toml"));
  for (const StudyCondition& condition : files->study.conditions)
    EXPECT_EQ(condition.forces, StudyForces::kAir);
}

TEST_F(TrialSetupTest, OnlyThePlaneIsASettingOfItsOwn) {
  for (const auto& [forces, is_plane] :
       {std::pair{"air", false}, {"plane", true}, {"all", false}}) {
    const StudyFiles files = study_with("forces = \"" + std::string(forces) + "\"");
    Session session(make_tools(), {.device = with_force()});
    for (const Event& event : setup_events(files, {}, with_force())) {
      EXPECT_TRUE(session.apply(event));
    }
    EXPECT_EQ(session.option("surface.plane_only"), OptionValue(is_plane)) << forces;
  }
}

TEST_F(TrialSetupTest, AGuideFollowsTheShape) {
  const std::pair<const char*, GuideKind> kinds[] = {
      {"groove", GuideKind::kGroove},
      {"as-needed", GuideKind::kAsNeeded},
      {"error-amplifying", GuideKind::kErrorAmplifying}};
  for (const auto& [name, kind] : kinds) {
    const StudyFiles files = study_with("strength = 0.5\nguidance = \"" + std::string(name) + "\"");
    const Event event = setup_events(files, {.shape = 1}, with_force()).back();
    const auto* guide = std::get_if<UseGuide>(&event.what);
    ASSERT_TRUE(guide);
    EXPECT_EQ(guide->line.kind, kind);
    EXPECT_EQ(guide->line.points, files.paths[1].points);
    EXPECT_EQ(guide->line.strength, 0.5);
    EXPECT_TRUE(guide->line.is_closed);
  }
  const StudyFiles files = study_with("");
  EXPECT_TRUE(std::holds_alternative<UseDevice>(setup_events(files, {}, with_force()).back().what));
}

TEST_F(TrialSetupTest, ATeacherHasTimes) {
  StudyFiles files = study_with("");
  files.study.conditions[0].guidance = StudyGuidance::kReplayedTeacher;
  const auto sample = [](std::int64_t ms, double x, bool contact) {
    return TrialSample{.time_ns = ms * 1'000'000, .position = {x, 50.0}, .contact = contact};
  };
  files.teachers[0] = {sample(0, 10.0, false), sample(100, 20.0, true), sample(100, 21.0, true),
                       sample(350, 40.0, true), sample(400, 50.0, false)};
  const Event event = setup_events(files, {}, with_force()).back();
  const auto& guide = std::get<UseGuide>(event.what).line;
  EXPECT_EQ(guide.points, (std::vector<Point>{{20.0, 50.0}, {40.0, 50.0}}));
  EXPECT_EQ(guide.times_ms, (std::vector<double>{0.0, 250.0}));
  EXPECT_TRUE(check_guide(guide));
  files.teachers[0].resize(2);
  const auto refused = check_conditions(files, Materials::built_in(), with_force(), "s.toml");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("s.toml:3: condition.guidance of the shape"));
}

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
