#include "desktop/engine/presets.h"

#include <gtest/gtest.h>

#include "desktop/engine/settings.h"

namespace felt::desktop::presets_test {
namespace {

StudioOptions still() {
  StudioOptions options;
  options.live = false;
  return options;
}

class PresetsTest : public ::testing::Test {
 protected:
  PresetsTest() { Settings::the().reset(QLatin1String(kPresets)); }
  ~PresetsTest() override { Settings::the().reset(QLatin1String(kPresets)); }

  OptionValue value(const char* id) { return studio_.session().option(id).value(); }

  Studio studio_{still()};
};

TEST_F(PresetsTest, APresetIsKeptUsedReplacedAndRemoved) {
  studio_.apply(SetOption{"pencil.medium", std::string("chalk")});
  studio_.apply(SetOption{"pencil.max_width_mm", 7.25});
  studio_.apply(SetOption{"pencil.refine", false});
  studio_.apply(SetOption{"ink.color", std::string("#b0202080")});
  keep_preset(studio_.session(), QStringLiteral("  Big   chalk "));
  keep_preset(studio_.session(), QStringLiteral(" "));
  ASSERT_EQ(stored_presets().size(), 1U);
  EXPECT_EQ(stored_presets()[0].name, QStringLiteral("Big chalk"));

  studio_.apply(SetOption{"pencil.medium", std::string("pencil")});
  studio_.apply(SetOption{"pencil.max_width_mm", 1.0});
  studio_.apply(SetOption{"pencil.refine", true});
  studio_.apply(SetOption{"ink.color", std::string("#000000")});
  studio_.apply(SelectTool{"eraser"});
  use_preset(studio_, stored_presets()[0]);
  EXPECT_EQ(value("pencil.medium"), OptionValue(std::string("chalk")));
  EXPECT_EQ(value("pencil.max_width_mm"), OptionValue(7.25));
  EXPECT_EQ(value("pencil.refine"), OptionValue(false));
  EXPECT_EQ(value("ink.color"), OptionValue(std::string("#b0202080")));
  EXPECT_EQ(studio_.session().tool().info().id, "pencil");

  studio_.apply(SetOption{"pencil.max_width_mm", 3.0});
  keep_preset(studio_.session(), QStringLiteral("Big chalk"));
  ASSERT_EQ(stored_presets().size(), 1U);
  studio_.apply(SelectTool{"shape"});
  use_preset(studio_, stored_presets()[0]);
  EXPECT_EQ(value("pencil.max_width_mm"), OptionValue(3.0));
  EXPECT_EQ(studio_.session().tool().info().id, "shape") << "it draws with the preset, too";
  remove_preset(QStringLiteral("Big chalk"));
  EXPECT_TRUE(stored_presets().empty());
}

TEST_F(PresetsTest, DamagedSettingsAndUnknownOptionsDoNoHarm) {
  for (const char* text : {"", "nonsense", "{}", "[1,null,\"a\"]", "[{\"name\":\"a\"}]",
                           "[{\"name\":\" \",\"options\":{\"pencil.refine\":true}}]"}) {
    Settings::the().set(QLatin1String(kPresets), QString::fromLatin1(text));
    EXPECT_TRUE(stored_presets().empty()) << text;
  }
  Settings::the().set(QLatin1String(kPresets),
                      QStringLiteral(R"([{"name":"old","options":{"gone.x":1,"pencil.medium":"no",)"
                                     R"("pencil.refine":"yes","pencil.max_width_mm":2,"a":[]}}])"));
  ASSERT_EQ(stored_presets().size(), 1U);
  use_preset(studio_, stored_presets()[0]);
  EXPECT_EQ(value("pencil.max_width_mm"), OptionValue(2.0));
  EXPECT_EQ(value("pencil.refine"), OptionValue(true));
}

}  // namespace
}  // namespace felt::desktop::presets_test
