#include "felt/motion/key_film.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
#include "felt/motion/key_layers.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::key_film_test {
namespace {

/// Returns a drawing with one horizontal line at this height.
Drawing line_at(double y_mm) {
  Drawing drawing;
  EditBuilder edit(drawing.document);
  edit.add(drawing.document.layers().front().id,
           std::make_shared<const Stroke>(
               felt::testing::straight_stroke({10.0, y_mm}, {90.0, y_mm}, 1.0, 1.0)));
  EXPECT_TRUE(drawing.document.apply(std::move(edit).build("line")));
  return drawing;
}

double height_of(const Drawing& drawing) {
  const std::vector<StrokePtr> strokes = visible_strokes(drawing.document);
  return strokes.size() == 1 ? strokes.front()->data().points.front().y : -1.0;
}

RC_GTEST_PROP(KeyFilm, EveryPictureIsBetweenItsKeyDrawings, ()) {
  std::vector<FilmKey> keys;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
    FilmKey key{line_at(10.0 + 20.0 * static_cast<double>(keys.size()))};
    key.timing.between = *rc::gen::inRange(0, 6);
    key.timing.hold = *rc::gen::inRange(1, 4);
    keys.push_back(std::move(key));
  }
  KeyFilm film;
  RC_ASSERT(film.size() == 0u);
  for (const FilmKey& key : keys) RC_ASSERT(film.add(key).has_value());
  std::size_t picture = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const int between = k + 1 < keys.size() ? keys[k].timing.between : 0;
    for (int i = 0; i <= between; ++i, ++picture) {
      RC_ASSERT(film.is_key(picture) == (i == 0));
      RC_ASSERT(film.frames(picture) == (i == 0 ? keys[k].timing.hold : 1));
      const double wanted = 10.0 + 20.0 * (static_cast<double>(k) + i / (between + 1.0));
      RC_ASSERT(std::abs(height_of(film.picture(picture)) - wanted) < 1e-6);
    }
  }
  RC_ASSERT(film.size() == picture);
}

TEST(KeyFilm, TheEaseSetsTheSpeed) {
  const KeyTiming timing{.between = 1, .ease = {0.42, 0.0, 1.0, 1.0}};
  KeyFilm film;
  ASSERT_TRUE(film.add({line_at(10.0), timing}));
  ASSERT_TRUE(film.add({line_at(30.0), {}}));
  const double half = Ease::parse("ease-in").value().at(0.5);
  EXPECT_NEAR(height_of(film.picture(1)), 10.0 + 20.0 * half, 1e-6);
  EXPECT_LT(height_of(film.picture(1)), 19.0);
  EXPECT_EQ(film.correspondence(0).matches.size(), 1u);
}

/// Returns a document of two layers, each with two lines, the longer of which is the higher one in
/// the second layer. Lines have ids 1, 2 and 3, 4.
Document two_keys() {
  Document document;
  Edit edit;
  edit.layers.push_back({{2}, std::nullopt, LayerState{"Second"}, 0, 1});
  const auto add = [&edit](std::uint64_t id, std::uint64_t layer, double y, double length) {
    edit.changes.push_back(
        {{id},
         nullptr,
         std::make_shared<const Stroke>(felt::testing::straight_stroke({0, y}, {length, y}, 1, 1)),
         {},
         {{layer}, (id - 1) % 2}});
  };
  add(1, 1, 10.0, 90.0);
  add(2, 1, 50.0, 40.0);
  add(3, 2, 12.0, 90.0);
  add(4, 2, 52.0, 40.0);
  EXPECT_TRUE(document.apply(edit));
  return document;
}

/// Returns the strokes of the second layer that 1 and 2 become, with these corrections; 0: none.
std::vector<std::uint64_t> partners(std::vector<KeyPair> pairs) {
  Document document = two_keys();
  const LayerState before = document.layers()[0].state();
  LayerState after = before;
  after.timing = shared_timing({.pairs = std::move(pairs)});
  Edit edit;
  edit.layers.push_back({{1}, before, after, 0, 0});
  EXPECT_TRUE(document.apply(edit));
  KeyFilm film;
  for (FilmKey& key : film_keys(document, Page{})) EXPECT_TRUE(film.add(std::move(key)));
  std::vector<std::uint64_t> found;
  for (const StrokeMatch& match : film.correspondence(0).matches) {
    if (match.from) found.push_back(match.to ? *match.to + 3 : 0);
  }
  return found;
}

TEST(KeyLayers, ADocumentKeepsTimingsAndCorrectionsOfItsKeyDrawings) {
  using Ids = std::vector<std::uint64_t>;
  EXPECT_EQ(partners({}), (Ids{3, 4}));
  EXPECT_EQ(partners({{{1}, {4}}, {{2}, {3}}}), (Ids{4, 3}));
  EXPECT_EQ(partners({{{1}, {}}, {{}, {3}}}), (Ids{0, 4}));
  EXPECT_EQ(partners({{{1}, {99}}, {{98}, {}}, {{}, {1}}}), (Ids{3, 4})) << "none of them exists";
}

TEST(KeyLayers, AKeyDrawingIsAnUnlockedLayerWithInk) {
  const Document document = two_keys();
  EXPECT_EQ(key_layers(document), (std::vector<LayerId>{{1}, {2}}));
  EXPECT_TRUE(key_layers(Document()).empty());
  EXPECT_EQ(film_frames(document), 1u + 12u + 1u);
  EXPECT_EQ(film_frames(Document()), 0u);
  const Drawing second = key_drawing(document, {2}, Page{});
  EXPECT_EQ(second.document.stroke_count(), 2u);
  EXPECT_EQ(second.document.find({4}), document.find({4}));
  EXPECT_EQ(second.document.layers().size(), 1u);
  EXPECT_EQ(second.document.layers()[0].name, "Second");
}

}  // namespace
}  // namespace felt::key_film_test
