// Tests of opacity, pictures, lines, copies and merging of layers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "felt/document/testing/small_picture.h"
#include "felt/document/visible_strokes.h"
#include "felt/session/session.h"
#include "felt/session/testing/fake_tools.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::layer_events_test {
namespace {

using Do = LayerEvent::Do;
using ::testing::HasSubstr;

struct LayerFixture {
  LayerFixture() {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<FakePencil>());
    session = std::make_unique<Session>(std::move(tools), SessionOptions{});
    add_strokes(2);
  }

  void add_strokes(std::uint64_t count) {
    std::vector<StrokePtr> strokes;
    for (std::uint64_t i = 0; i < count; ++i) {
      strokes.push_back(std::make_shared<const Stroke>(testing::random_stroke(++seed)));
    }
    EXPECT_TRUE(session->import(0, ImportEvent{}, strokes));
  }
  template <class What>
  std::string apply(What what) {
    const Result<void> done = session->apply({0, std::move(what)});
    return done ? "" : done.error().message;
  }
  std::string layer(Do what, std::uint64_t id, double opacity = 1.0) {
    LayerEvent event{what, {id}};
    event.opacity = opacity;
    return apply(event);
  }
  std::string place(std::uint64_t id, const Affine& place) {
    LayerEvent event{Do::kPlace, {id}};
    event.place = place;
    return apply(event);
  }
  [[nodiscard]] const Layer& at(std::size_t i) const { return session->document().layers()[i]; }

  std::uint64_t seed = 0;
  std::unique_ptr<Session> session;
};

TEST(LayerEvents, OpacityIsAStepOfUndo) {
  LayerFixture f;
  EXPECT_EQ(f.layer(Do::kOpacity, 1, 0.25), "");
  EXPECT_EQ(f.at(0).opacity, 0.25);
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.at(0).opacity, 1.0);
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(f.layer(Do::kOpacity, 1, bad), HasSubstr("from 0 to 1"));
  }
}

TEST(LineEvents, ALineIsInkInTheColourOfNewInk) {
  LayerFixture f;
  ASSERT_EQ(f.apply(SetOption{"ink.color", std::string("#102030")}), "");
  ASSERT_EQ(f.apply(AddLine{{{0, 0}, {10, 0}, {10.01, 0}, {10, 10}}, false, 0.8}), "");
  ASSERT_EQ(f.apply(AddLine{{{0, 0}, {10, 0}, {10, 10}, {0, 0}}, true, 2.0}), "");
  const auto strokes = visible_strokes(f.session->document());
  ASSERT_EQ(strokes.size(), 4u);
  EXPECT_EQ(strokes[2]->segment_count(), 2);
  EXPECT_EQ(strokes[2]->color(), (Rgba{0x10, 0x20, 0x30, 255}));
  EXPECT_EQ(strokes[2]->width_mm(1.0), 0.8);
  EXPECT_TRUE(strokes[3]->closed());
  EXPECT_EQ(strokes[3]->segment_count(), 3);
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.session->document().stroke_count(), 3u) << "each is a step of undo";
}

TEST(LineEvents, RefusesLinesThatCannotBeInk) {
  LayerFixture f;
  EXPECT_THAT(f.apply(AddLine{{{0, 0}}, false, 1.0}), HasSubstr("points: a line has 2 to 20000"));
  EXPECT_THAT(f.apply(AddLine{{{0, 0}, {0, 0.01}}, false, 1.0}), HasSubstr("points: "));
  EXPECT_THAT(f.apply(AddLine{{{0, 0}, {0, 0.01}}, true, 1.0}), HasSubstr("points: "));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(f.apply(AddLine{{{0, 0}, {nan, 1}}, false, 1.0}), HasSubstr("points: "));
  for (const double bad : {0.0, 51.0, nan}) {
    EXPECT_THAT(f.apply(AddLine{{{0, 0}, {9, 0}}, false, bad}), HasSubstr("width_mm: "));
  }
  EXPECT_EQ(f.session->document().stroke_count(), 2u);
}

TEST(LayerEvents, APictureComesBelowTheCurrentLayerAndIsUsed) {
  LayerFixture f;
  const Affine place{2, 0, 0, 2, 10, 20};
  EXPECT_EQ(f.apply(AddPicture{"Photo", testing::picture_data(), place}), "");
  ASSERT_EQ(f.session->document().layers().size(), 2U);
  EXPECT_EQ(f.at(0).name, "Photo");
  ASSERT_TRUE(f.at(0).picture);
  EXPECT_EQ(f.at(0).picture->place, place);
  EXPECT_FALSE(f.at(0).picture->exported);
  EXPECT_EQ(f.at(0).opacity, 1.0);
  EXPECT_EQ(f.session->layer(), f.at(0).id);
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.session->document().layers().size(), 1U);
  EXPECT_EQ(f.apply(AddPicture{"Faded", testing::picture_data(), place, 0.25}), "");
  EXPECT_EQ(f.at(0).opacity, 0.25);
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(f.apply(AddPicture{"", testing::picture_data(), place, bad}),
                HasSubstr("from 0 to 1"));
  }
  EXPECT_EQ(f.apply(AddPicture{"", nullptr, place}), "picture: has no data");
  EXPECT_THAT(f.apply(AddPicture{"", testing::picture_data(), {0, 0, 0, 0, 1, 1}}),
              HasSubstr("cannot be placed"));
}

TEST(LayerEvents, APictureIsPlacedAndMarkedForExportUnlessItIsLocked) {
  LayerFixture f;
  ASSERT_EQ(f.apply(AddPicture{"Photo", testing::picture_data(), {}}), "");
  EXPECT_EQ(f.place(2, {0, 3, -3, 0, 1, 2}), "");
  EXPECT_EQ(f.at(0).picture->place, (Affine{0, 3, -3, 0, 1, 2}));
  EXPECT_EQ(f.layer(Do::kExport, 2), "");
  EXPECT_TRUE(f.at(0).picture->exported);
  EXPECT_EQ(f.layer(Do::kLeaveOut, 2), "");
  EXPECT_FALSE(f.at(0).picture->exported);
  EXPECT_EQ(f.place(1, {}), "layer 1 (Ink) has no picture");
  EXPECT_EQ(f.layer(Do::kExport, 1), "layer 1 (Ink) has no picture");
  EXPECT_EQ(f.layer(Do::kLock, 2), "");
  EXPECT_EQ(f.place(2, {}), "layer 2 (Photo) is locked: its picture cannot be moved");
  EXPECT_EQ(f.at(0).picture->place, (Affine{0, 3, -3, 0, 1, 2}));
}

TEST(LayerEvents, ADuplicateHasTheSameLookAndStrokes) {
  LayerFixture f;
  ASSERT_EQ(f.layer(Do::kOpacity, 1, 0.5), "");
  EXPECT_EQ(f.layer(Do::kDuplicate, 1), "");
  ASSERT_EQ(f.session->document().layers().size(), 2U);
  const Layer &original = f.at(0), &copy = f.at(1);
  EXPECT_EQ(copy.name, "Ink copy");
  EXPECT_EQ(copy.opacity, 0.5);
  EXPECT_EQ(f.session->layer(), copy.id);
  ASSERT_EQ(copy.strokes.size(), original.strokes.size());
  for (std::size_t i = 0; i < copy.strokes.size(); ++i) {
    EXPECT_NE(copy.strokes[i], original.strokes[i]);
    EXPECT_EQ(*f.session->document().find(copy.strokes[i]),
              *f.session->document().find(original.strokes[i]));
  }
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.session->document().layers().size(), 1U);
}

TEST(LayerEvents, MergingMovesTheStrokesOnTopOfTheLayerBelow) {
  LayerFixture f;
  const Document before = f.session->document();
  ASSERT_EQ(f.apply(LayerEvent{}), "");
  f.add_strokes(3);
  const Document parted = f.session->document();
  EXPECT_EQ(f.layer(Do::kMerge, 2), "");
  ASSERT_EQ(f.session->document().layers().size(), 1U);
  std::vector<StrokeId> all = parted.layers()[0].strokes;
  all.insert(all.end(), parted.layers()[1].strokes.begin(), parted.layers()[1].strokes.end());
  EXPECT_EQ(f.at(0).strokes, all);
  EXPECT_EQ(f.session->layer(), f.at(0).id);
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_TRUE(f.session->document() == parted);
}

TEST(LayerEvents, MergingIsRefusedWhereThePictureWouldChange) {
  LayerFixture f;
  EXPECT_THAT(f.layer(Do::kMerge, 1), HasSubstr("is the lowest"));
  ASSERT_EQ(f.apply(LayerEvent{}), "");
  ASSERT_EQ(f.layer(Do::kOpacity, 2, 0.5), "");
  EXPECT_THAT(f.layer(Do::kMerge, 2), HasSubstr("differ in opacity"));
  ASSERT_EQ(f.layer(Do::kOpacity, 2, 1.0), "");
  ASSERT_EQ(f.layer(Do::kLock, 1), "");
  EXPECT_THAT(f.layer(Do::kMerge, 2), HasSubstr("layer 1 (Ink) is locked"));
  ASSERT_EQ(f.layer(Do::kUnlock, 1), "");
  ASSERT_EQ(f.layer(Do::kHide, 1), "");
  EXPECT_THAT(f.layer(Do::kMerge, 2), HasSubstr("layer 1 (Ink) is hidden"));
  ASSERT_EQ(f.layer(Do::kShow, 1), "");
  ASSERT_EQ(f.apply(AddPicture{"Photo", testing::picture_data(), {}}), "");  // between the two
  EXPECT_THAT(f.layer(Do::kMerge, 3), HasSubstr("has a picture"));
  EXPECT_EQ(f.layer(Do::kMerge, 2), "") << "strokes may go onto the layer of a picture";
  EXPECT_TRUE(f.at(1).picture);
}

TEST(LayerEvents, NamesStayShortEnoughForFiles) {
  LayerFixture f;
  const std::string longest = std::string(kMaxLayerNameBytes - 8, 'n') + "\u270e\u270e";
  ASSERT_EQ(f.apply(LayerEvent{Do::kRename, {1}, longest}), "");
  ASSERT_EQ(f.layer(Do::kDuplicate, 1), "");
  EXPECT_EQ(f.at(1).name, longest.substr(0, kMaxLayerNameBytes - 8) + "\u270e copy");
  EXPECT_LE(f.at(1).name.size(), kMaxLayerNameBytes);
  const std::string too_long(kMaxLayerNameBytes + 1, 'n');
  EXPECT_THAT(f.apply(LayerEvent{Do::kRename, {1}, too_long}), HasSubstr("longer than 4096 bytes"));
  EXPECT_THAT(f.apply(LayerEvent{Do::kAdd, {}, too_long}), HasSubstr("longer than 4096 bytes"));
  EXPECT_EQ(f.at(0).name, longest);
}

TEST(LayerEvents, ALockedPictureStaysWhereItIsAlsoIfNoOtherLayerIsThere) {
  for (const bool locks : {false, true}) {
    Session session(make_tools(), {});
    std::int64_t time_ns = 0;
    const auto apply = [&](decltype(Event::what) what) {
      EXPECT_TRUE(session.apply({time_ns += 20'000'000, std::move(what)}));
    };
    const Affine place{10, 0, 0, 10, 20, 20};
    apply(AddPicture{"Photo", testing::picture_data(), place});
    apply(LayerEvent{Do::kRemove, {1}});
    if (locks) apply(LayerEvent{Do::kLock, {2}});
    apply(SelectTool{"transform"});
    apply(PenEvent{{30.0, 25.0, 5.0}, {}, 0});
    for (const double x : {30.0, 35.0, 45.0}) apply(PenEvent{{x, 25.0, -1.0}, {}, 0});
    for (int i = 0; i < 20; ++i) apply(PenEvent{{45.0, 25.0, 5.0}, {}, 0});
    EXPECT_EQ(session.document().layers()[0].picture->place == place, locks);
    EXPECT_EQ(session.document().layers().size(), 1U);
  }
}

/// A script may add layers one by one. The work for each of them does not grow with their number.
TEST(LayerEvents, ManyLayersAreAddedAndUndoneWithoutMovingTheOthers) {
  LayerFixture f;
  for (std::size_t i = 1; i < kMaxLayers; ++i) ASSERT_EQ(f.apply(LayerEvent{}), "");
  EXPECT_LE(f.session->document().moved_layers(), kMaxLayers + 1);
  EXPECT_EQ(f.session->layer(), f.at(kMaxLayers - 1).id);
  for (std::size_t i = 1; i < kMaxLayers; ++i) ASSERT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_LE(f.session->document().moved_layers(), kMaxLayers + 1);
  EXPECT_EQ(f.session->document().layers().size(), 1U);
}

/// Files have at most kMaxLayers layers, so a drawing with more could not be saved.
TEST(LayerEvents, NoEventAddsMoreLayersThanFilesMayHave) {
  LayerFixture f;
  Edit edit{"Add layers", {}, {}};
  for (std::uint64_t i = 1; i < kMaxLayers; ++i) {
    LayerState state{"l"};
    state.visible = false;
    edit.layers.push_back({{i + 1}, std::nullopt, std::move(state), 0, i});
  }
  Document document;
  ASSERT_TRUE(document.apply(edit));
  SessionOptions options;
  options.document = document;
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(std::make_unique<FakePencil>());
  f.session = std::make_unique<Session>(std::move(tools), std::move(options));
  const AddPicture picture{"Photo", testing::picture_data(), {}};
  for (const auto& refused :
       {f.apply(LayerEvent{}), f.layer(Do::kDuplicate, 1), f.apply(picture)}) {
    EXPECT_THAT(refused, HasSubstr("at most 10000 layers"));
  }
  EXPECT_EQ(f.session->document(), document);
  EXPECT_EQ(f.layer(Do::kLock, 1), "") << "now no layer is open";
  const std::vector strokes{std::make_shared<const Stroke>(testing::random_stroke(1))};
  EXPECT_THAT(f.session->import(1, ImportEvent{"a.svg"}, strokes).error().message,
              HasSubstr("at most 10000 layers"));
  for (const double z : {5.0, -1.0, -1.0, 5.0}) {
    EXPECT_EQ(f.apply(PenEvent{{10.0 * z, 0.0, z}, {}, 0}), "") << "a recording may contain it";
  }
  std::vector<std::string> errors;  // of two lines
  for (const double z : {5.0, -1.0, -1.0, -1.0, 5.0, 5.0, -1.0, -1.0, 5.0}) {
    const Result<void> done = f.session->sample({0, {10.0 * z, 0.0, z}, {}, {}, 0, {}});
    errors.push_back(done ? "" : done.error().message);
  }
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (i == 1 || i == 6) {
      EXPECT_THAT(errors[i], HasSubstr("at most 10000 layers")) << "the line draws nothing";
    } else {
      EXPECT_EQ(errors[i], "") << i;
    }
  }
  EXPECT_EQ(f.session->refusals().gestures, 3U) << "one of the recording, two of the pen";
  EXPECT_THAT(f.session->refusals().first, HasSubstr("at most 10000 layers"));
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.session->document(), document);
  EXPECT_EQ(f.layer(Do::kRemove, 2), "");
  EXPECT_EQ(f.apply(LayerEvent{}), "");
  EXPECT_THAT(f.apply(LayerEvent{}), HasSubstr("at most 10000 layers"));
}

}  // namespace
}  // namespace felt::layer_events_test
