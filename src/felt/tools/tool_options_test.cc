#include "felt/tools/tool_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <set>
#include <string>

#include "felt/tools/tool.h"

namespace felt::tool_options_test {
namespace {

using ::testing::HasSubstr;

constexpr std::array<std::string_view, 2> kWays = {"near", "far"};
constexpr std::array<OptionSpec, 3> kTable = {{
    {.id = "size_mm",
     .label = "Size",
     .unit = "mm",
     .min = 1,
     .max = 40,
     .fallback = 8,
     .help = ""},
    {.id = "on", .label = "On", .unit = "", .kind = OptionKind::kSwitch, .fallback = 1, .help = ""},
    {.id = "way",
     .label = "Way",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 1,
     .choices = kWays,
     .help = ""},
}};

TEST(OptionValues, BeginsWithTheDefaults) {
  const OptionValues values(kTable);
  EXPECT_EQ(values.number(0), 8.0);
  EXPECT_TRUE(values.is_on(1));
  EXPECT_EQ(values.choice(2), 1u);
  EXPECT_EQ(values.get("way").value(), OptionValue(std::string("far")));
}

TEST(OptionValues, TakesWhatIsAllowed) {
  OptionValues values(kTable);
  EXPECT_TRUE(values.set("size_mm", 40.0));
  EXPECT_TRUE(values.set("on", false));
  EXPECT_TRUE(values.set("way", std::string("near")));
  EXPECT_EQ(values.get("size_mm").value(), OptionValue(40.0));
  EXPECT_EQ(values.get("on").value(), OptionValue(false));
  EXPECT_EQ(values.get("way").value(), OptionValue(std::string("near")));
}

TEST(OptionValues, NamesTheOptionTheValueAndWhatIsAllowed) {
  OptionValues values(kTable);
  const OptionValues before = values;
  EXPECT_EQ(values.set("size_mm", 0.5).error().message,
            "option 'size_mm' cannot be 0.5: it must be a number from 1 to 40 mm");
  EXPECT_EQ(values.set("on", 1.0).error().message,
            "option 'on' cannot be 1: it must be true or false");
  EXPECT_EQ(values.set("way", std::string("up")).error().message,
            "option 'way' cannot be 'up': it must be one of near, far");
  EXPECT_THAT(values.set("size", 2.0).error().message, HasSubstr("'size'"));
  EXPECT_FALSE(values.set("size_mm", std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(values.set("size_mm", std::string("2")));
  EXPECT_FALSE(values.set("way", 0.0));
  EXPECT_FALSE(values.get("size"));
  EXPECT_EQ(values, before);
}

// Tests the option table of every tool, so that new tools are covered automatically.

TEST(EveryTool, HasATableThatMakesSense) {
  std::set<std::string_view> tools;
  for (const auto& tool : make_tools()) {
    const ToolInfo& info = tool->info();
    SCOPED_TRACE(info.id);
    EXPECT_TRUE(tools.insert(info.id).second);
    EXPECT_FALSE(info.id.empty() || info.label.empty() || info.help.empty());
    std::set<std::string_view> ids;
    for (const OptionSpec& spec : info.options) {
      SCOPED_TRACE(spec.id);
      EXPECT_TRUE(ids.insert(spec.id).second);
      EXPECT_FALSE(spec.id.empty() || spec.label.empty() || spec.help.empty());
      EXPECT_EQ(spec.help.back(), '.');
      EXPECT_EQ(spec.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                std::string_view::npos);
      if (spec.kind == OptionKind::kNumber) {
        EXPECT_LT(spec.min, spec.max);
        EXPECT_TRUE(spec.min <= spec.fallback && spec.fallback <= spec.max);
      }
      if (!spec.unit.empty()) {
        std::string ending = "_" + (spec.unit == "°" ? "deg" : std::string(spec.unit));
        for (char& c : ending) c = static_cast<char>(std::tolower(c));
        if (const auto slash = ending.find('/'); slash != std::string::npos) {
          ending.replace(slash, 1, "_per_");
        }
        EXPECT_TRUE(spec.id.ends_with(ending)) << "the unit belongs in the name";
      }
    }
  }
  EXPECT_TRUE(tools.contains("pencil"));
}

TEST(EveryTool, SaysOfRealChoicesWhenARowMeansSomething) {
  for (const auto& tool : make_tools()) {
    const auto table = tool->info().options;
    for (const OptionSpec& spec : table) {
      SCOPED_TRACE(std::string(tool->info().id) + "." + std::string(spec.id));
      const auto decider = std::find_if(table.begin(), table.end(), [&](const OptionSpec& other) {
        return other.id == decider_of(spec);
      });
      EXPECT_EQ(decider == table.end(), spec.when.empty());
      if (decider == table.end()) continue;
      ASSERT_EQ(decider->kind, OptionKind::kChoice);
      EXPECT_TRUE(decider->when.empty()) << "one look at one choice must do";
      std::string words;
      for (const std::string_view choice : decider->choices) {
        if (matters_with(spec, choice)) words += (words.empty() ? "" : "|") + std::string(choice);
      }
      EXPECT_EQ(spec.when, std::string(decider->id) + "=" + words);
    }
  }
}

TEST(OptionSpec, AlwaysMeansSomethingUnlessAChoiceDecides) {
  OptionSpec spec;
  EXPECT_TRUE(matters_with(spec, "") && matters_with(spec, "near"));
  EXPECT_EQ(decider_of(spec), "");
  spec.when = "way=near|nearer";
  EXPECT_EQ(decider_of(spec), "way");
  EXPECT_TRUE(matters_with(spec, "near") && matters_with(spec, "nearer"));
  EXPECT_FALSE(matters_with(spec, "nea") || matters_with(spec, "") || matters_with(spec, "far"));
}

void check_number(Tool& tool, const OptionSpec& spec) {
  const double below = std::nextafter(spec.min, -1e300), above = std::nextafter(spec.max, 1e300);
  for (const double good : {spec.min, spec.max, 0.5 * (spec.min + spec.max), spec.fallback}) {
    EXPECT_TRUE(tool.set_option(spec.id, good)) << good;
    EXPECT_EQ(tool.option(spec.id).value(), OptionValue(good));
  }
  for (const double bad : {below, above, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    const auto result = tool.set_option(spec.id, bad);
    ASSERT_FALSE(result) << bad;
    EXPECT_THAT(result.error().message, HasSubstr(std::string(spec.id)));
    EXPECT_EQ(tool.option(spec.id).value(), OptionValue(spec.fallback));
  }
  EXPECT_FALSE(tool.set_option(spec.id, true));
}

TEST(EveryTool, KeepsItsOptionsInRange) {
  for (const auto& tool : make_tools()) {
    for (const OptionSpec& spec : tool->info().options) {
      SCOPED_TRACE(std::string(tool->info().id) + "." + std::string(spec.id));
      EXPECT_EQ(tool->option(spec.id).value(), default_value(spec));
      if (spec.kind == OptionKind::kNumber) {
        check_number(*tool, spec);
      } else if (spec.kind == OptionKind::kSwitch) {
        for (const bool on : {true, false}) {
          EXPECT_TRUE(tool->set_option(spec.id, on));
          EXPECT_EQ(tool->option(spec.id).value(), OptionValue(on));
        }
        EXPECT_FALSE(tool->set_option(spec.id, 1.0));
      } else {
        for (std::string_view choice : spec.choices) {
          EXPECT_TRUE(tool->set_option(spec.id, std::string(choice)));
          EXPECT_EQ(tool->option(spec.id).value(), OptionValue(std::string(choice)));
        }
        EXPECT_FALSE(tool->set_option(spec.id, std::string("no such choice")));
        EXPECT_FALSE(tool->set_option(spec.id, 0.0));
      }
    }
    EXPECT_FALSE(tool->set_option("no_such_option", 1.0));
    EXPECT_FALSE(tool->option("no_such_option"));
  }
}

}  // namespace
}  // namespace felt::tool_options_test
