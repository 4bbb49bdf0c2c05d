#include "felt/motion/key_film.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
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
  KeyFilmOptions options;
  options.between = *rc::gen::inRange(0, 6);
  options.hold = *rc::gen::inRange(1, 4);
  const int keys = *rc::gen::inRange(1, 5);
  KeyFilm film(options);
  RC_ASSERT(film.size() == 0u);
  for (int i = 0; i < keys; ++i) RC_ASSERT(film.add(line_at(10.0 + 20.0 * i)).has_value());
  const auto stride = static_cast<std::size_t>(options.between) + 1;
  RC_ASSERT(film.size() == (static_cast<std::size_t>(keys) - 1) * stride + 1);
  for (std::size_t i = 0; i < film.size(); ++i) {
    RC_ASSERT(film.is_key(i) == (i % stride == 0));
    RC_ASSERT(film.frames(i) == (film.is_key(i) ? options.hold : 1));
    const double wanted = 10.0 + 20.0 * static_cast<double>(i) / static_cast<double>(stride);
    RC_ASSERT(std::abs(height_of(film.picture(i)) - wanted) < 1e-6);
  }
}

TEST(KeyFilm, TheEaseSetsTheSpeed) {
  KeyFilmOptions options;
  options.between = 1;
  options.ease = Ease::parse("ease-in").value();
  KeyFilm film(options);
  ASSERT_TRUE(film.add(line_at(10.0)));
  ASSERT_TRUE(film.add(line_at(30.0)));
  EXPECT_NEAR(height_of(film.picture(1)), 10.0 + 20.0 * options.ease.at(0.5), 1e-6);
  EXPECT_LT(height_of(film.picture(1)), 19.0);
  EXPECT_EQ(film.correspondence(0).matches.size(), 1u);
}

}  // namespace
}  // namespace felt::key_film_test
