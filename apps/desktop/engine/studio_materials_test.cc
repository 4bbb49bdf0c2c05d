#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "desktop/engine/studio.h"
#include "desktop/engine/testing/kept_events.h"
#include "desktop/engine/testing/slate.h"
#include "desktop/engine/usual_color.h"
#include "felt/material/material_file.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/tool.h"

namespace felt::desktop::studio_materials_test {
namespace {

using Texts = std::vector<std::string>;

Medium soft_chalk(double friction) {
  Medium medium = *find_medium("charcoal");
  medium.id = "soft-chalk";
  medium.label = "Soft chalk";
  medium.friction = friction;
  return medium;
}

Page page_of(const std::string& surface) {
  Page page;
  page.surface = surface;
  return page;
}

std::vector<StrokePtr> line_of(const std::string& medium) {
  StrokeData data = felt::testing::straight_stroke({10, 10}, {90, 40}, 2.0, 3.0).data();
  data.medium = medium;
  return {std::make_shared<const Stroke>(Stroke::create(data).value())};
}

/// Collects and counts what a studio emits.
struct Listener {
  explicit Listener(Studio& studio) {
    QObject::connect(&studio, &Studio::refused,
                     [this](const QString& why) { refused.push_back(why); });
    QObject::connect(&studio, &Studio::materials_changed, [this] { ++changes; });
    QObject::connect(&studio, &Studio::option_changed,
                     [this](const QString& id) { options.push_back(id); });
  }
  QStringList refused, options;
  int changes = 0;
};

constexpr Rgba kWhite{255, 255, 255, 255};

bool choose(Studio& studio, const std::string& surface) {
  return studio.apply(SetOption{"surface.material", OptionValue(surface)});
}

Rgba color_of(const std::string& surface) {
  return usual_color(kWhite, {}, find_surface(surface)->color_rgb, kWhite);
}

TEST(StudioMaterials, ThePagesPaperIsOfTheColourOfItsSurface) {
  Studio studio({.live = false});
  int changes = 0;
  QObject::connect(&studio, &Studio::page_changed, [&changes] { ++changes; });
  ASSERT_EQ(studio.page().paper, kWhite);
  ASSERT_TRUE(choose(studio, "blackboard"));
  EXPECT_EQ(studio.page().paper, (Rgba{0x34, 0x46, 0x3e, 255}));
  EXPECT_EQ(changes, 1);
  EXPECT_FALSE(studio.is_modified()) << "an empty drawing is nothing to be asked about";
  studio.import(QStringLiteral("test"), line_of("chalk"));
  studio.set_modified(false);
  ASSERT_TRUE(choose(studio, "wood"));
  EXPECT_EQ(studio.page().paper, color_of("wood"));
  EXPECT_TRUE(studio.is_modified());
  ASSERT_TRUE(choose(studio, "paper"));
  EXPECT_EQ(studio.page().paper, color_of("paper"));
}

TEST(StudioMaterials, AWhiteSurfaceMakesThePageWhiteAgain) {
  Materials known = Materials::built_in();
  SurfaceMaterial plain;  // has no colour
  plain.id = "plain";
  known.put(plain);
  Studio studio({.live = false, .materials = known});
  ASSERT_TRUE(choose(studio, "blackboard"));
  ASSERT_TRUE(choose(studio, "plain"));
  EXPECT_EQ(studio.page().paper, kWhite);
  ASSERT_TRUE(choose(studio, "blackboard"));
  EXPECT_EQ(studio.page().paper, color_of("blackboard"));
}

TEST(StudioMaterials, APaperThatAPersonChoseStays) {
  Studio studio({.live = false});
  for (const Rgba own : {Rgba{200, 220, 240, 255}, Rgba{255, 255, 255, 0}}) {
    Page page = studio.page();
    page.paper = own;
    studio.set_page(page);
    for (const char* surface : {"blackboard", "glass", "paper"}) {
      ASSERT_TRUE(choose(studio, surface));
      EXPECT_EQ(studio.page().paper, own) << surface;
      EXPECT_EQ(studio.page().surface, surface);
    }
  }
}

TEST(StudioMaterials, ADrawingIsOpenedWithItsOwnPaper) {
  Studio studio({.live = false});
  ASSERT_TRUE(choose(studio, "wood"));
  for (const char* surface : {"blackboard", ""}) {
    studio.open(Document{}, page_of(surface));
    EXPECT_EQ(studio.page(), page_of(surface));
    EXPECT_FALSE(studio.is_modified());
  }
  // The surface has no known id, so only white counts as a paper that the user did not choose.
  ASSERT_TRUE(choose(studio, "glass"));
  EXPECT_EQ(studio.page().paper, color_of("glass"));
}

TEST(StudioMaterials, ThePaperFollowsTheColourThatItsSurfaceIsGiven) {
  Materials known = Materials::built_in();
  known.put(slate(0.5));
  Studio studio({.live = false, .materials = known});
  ASSERT_TRUE(choose(studio, "slate"));
  SurfaceMaterial red = slate(0.5);
  red.color_rgb = 0x803020;
  known.put(red);
  studio.set_user_materials(known);
  EXPECT_EQ(studio.page().paper, (Rgba{0x80, 0x30, 0x20, 255}));
  EXPECT_FALSE(studio.is_modified());
  ASSERT_TRUE(choose(studio, "glass"));
  red.color_rgb = 0x102030;
  known.put(red);
  studio.set_user_materials(known);
  EXPECT_EQ(studio.page().paper, color_of("glass")) << "it is another surface's colour";
}

TEST(StudioMaterials, StrokesBringTheMediaThatTheyAreOf) {
  Studio studio({.live = false});
  Listener listener(studio);
  Medium unused = soft_chalk(0.4);
  unused.id = "unused";
  const Texts texts{write_material(slate(0.5)), "nonsense", write_material(unused),
                    write_material(soft_chalk(0.4))};
  EXPECT_TRUE(studio.add_media(texts, line_of("soft-chalk")).empty());
  ASSERT_NE(studio.session().materials().find_medium("soft-chalk"), nullptr);
  EXPECT_EQ(*studio.session().materials().find_medium("soft-chalk"), soft_chalk(0.4));
  EXPECT_NE(studio.materials().find_medium("soft-chalk"), nullptr) << "it may be chosen";
  EXPECT_EQ(studio.materials().find_medium("unused"), nullptr);
  EXPECT_EQ(studio.materials().find_surface("slate"), nullptr);
  EXPECT_EQ(listener.changes, 1);
  EXPECT_FALSE(studio.is_modified()) << "the strokes are what changes the drawing";
  EXPECT_TRUE(studio.add_media(texts, line_of("soft-chalk")).empty());
  EXPECT_EQ(listener.changes, 1) << "it is known";
  EXPECT_TRUE(listener.refused.isEmpty());
}

TEST(StudioMaterials, AMediumThatIsAnotherOneHereStaysAndIsNamed) {
  Materials known = Materials::built_in();
  known.put(soft_chalk(0.4));
  Studio studio({.live = false, .materials = known});
  Medium pencil = *find_medium("pencil");
  pencil.friction = 0.7;
  const Texts texts{write_material(soft_chalk(0.6)), write_material(soft_chalk(0.8)),
                    write_material(pencil)};
  EXPECT_EQ(studio.add_media(texts, line_of("soft-chalk")), Texts{"Soft chalk"});
  EXPECT_EQ(studio.add_media(texts, line_of("pencil")), Texts{pencil.label});
  EXPECT_EQ(*studio.session().materials().find_medium("soft-chalk"), soft_chalk(0.4));
  EXPECT_EQ(*studio.session().materials().find_medium("pencil"), *find_medium("pencil"));
}

// The tool's options stay, including a medium that came with both the previous drawing and this
// one.
TEST(StudioMaterials, OptionsMayNameWhatTheNextDrawingBrings) {
  std::vector<Event> events;
  std::size_t begin = 0;
  Studio studio({.live = false, .connect_early = [&](Studio& created) {
                   keep_events(events)(created);
                   QObject::connect(&created, &Studio::session_began,
                                    [&] { begin = events.size(); });
                 }});
  const Texts texts{write_material(slate(0.5)), write_material(soft_chalk(0.4))};
  studio.open(Document{}, page_of("slate"), texts);
  ASSERT_TRUE(studio.apply(SetOption{"pencil.medium", std::string("soft-chalk")}));
  studio.open(Document{}, page_of("slate"), texts);
  EXPECT_EQ(studio.session().option("pencil.medium").value(),
            OptionValue(std::string("soft-chalk")));
  EXPECT_EQ(studio.session().surface(), slate(0.5));
  // A recording of the second session contains every material that it names.
  Session replayed(make_tools(), {});
  for (std::size_t i = begin; i < events.size(); ++i) {
    EXPECT_TRUE(replayed.apply(events[i])) << i;
    EXPECT_TRUE(i == begin || events[i].time_ns >= events[i - 1].time_ns) << i;
  }
  EXPECT_EQ(replayed.option("pencil.medium").value(), OptionValue(std::string("soft-chalk")));
  EXPECT_EQ(replayed.surface(), slate(0.5));
  // This drawing does not contain the medium, so the pencil has its initial one again.
  studio.open(Document{}, Page{});
  EXPECT_EQ(studio.session().option("pencil.medium").value(), OptionValue(std::string("pencil")));
}

TEST(StudioMaterials, ASurfaceThatGoesWithItsDrawingIsTold) {
  Studio studio({.live = false});
  studio.open(Document{}, page_of("slate"), Texts{write_material(slate(0.5))});
  Listener listener(studio);
  studio.open(Document{}, page_of("slate"), Texts{write_material(slate(0.7))});
  EXPECT_EQ(listener.options, QStringList(QStringLiteral("surface.material")));
  studio.open(Document{}, Page{});
  EXPECT_EQ(studio.session().surface().id, "paper");
  EXPECT_EQ(listener.options.size(), 2);
  EXPECT_FALSE(studio.is_modified());
}

TEST(StudioMaterials, ADrawingWithOtherFiguresThanAPersonsOwnSaysSo) {
  Materials known = Materials::built_in();
  known.put(slate(0.5));
  Studio studio({.live = false, .materials = known});
  Listener listener(studio);
  studio.open(Document{}, page_of("slate"), Texts{write_material(slate(0.5))});
  EXPECT_TRUE(listener.refused.isEmpty()) << "it is the same";
  studio.open(Document{}, page_of("slate"), Texts{write_material(slate(0.7))});
  EXPECT_EQ(studio.session().surface(), slate(0.7));
  ASSERT_EQ(listener.refused.size(), 1);
  EXPECT_TRUE(listener.refused[0].contains(QStringLiteral("Slate")));
  studio.open(Document{}, page_of("slate"));
  EXPECT_EQ(studio.session().surface(), slate(0.5)) << "nothing is lost of one's own";
  EXPECT_EQ(listener.refused.size(), 1);
}

}  // namespace
}  // namespace felt::desktop::studio_materials_test
