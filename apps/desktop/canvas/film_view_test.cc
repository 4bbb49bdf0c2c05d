#include "desktop/canvas/film_view.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <limits>

#include "desktop/canvas/testing/canvas_fixture.h"
#include "felt/document/edit_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::film_view_test {
namespace {

constexpr int kWaitMs = 20'000;

Drawing vertical_line(double x_mm) {
  Drawing drawing;
  EditBuilder edit(drawing.document);
  edit.add(drawing.document.layers().front().id,
           std::make_shared<const Stroke>(
               felt::testing::straight_stroke({x_mm, 20.0}, {x_mm, 190.0}, 8.0, 8.0)));
  EXPECT_TRUE(drawing.document.apply(std::move(edit).build("line")));
  return drawing;
}

/// Returns two key drawings, with this number of in-betweens.
std::vector<FilmKey> two_keys(int between = 12) {
  const KeyTiming timing{.between = between};
  return {{vertical_line(40.0), timing}, {vertical_line(250.0), timing}};
}

/// Returns the horizontal position of the dark pixels in the middle row, 0..1; -1 without any.
double dark_at(const QImage& picture) {
  double sum = 0.0, count = 0.0;
  const int y = picture.height() / 2;
  for (int x = picture.width() / 10; x < picture.width() * 9 / 10; ++x) {
    if (qGray(picture.pixel(x, y)) > 60) continue;
    sum += x;
    count += 1.0;
  }
  return count > 0.0 ? sum / count / picture.width() : -1.0;
}

TEST(FilmView, ShowsTheFramesInTheirOrderAgainAndAgain) {
  Fixture fixture;
  FilmView film(fixture.canvas);
  film.play(two_keys(3));
  EXPECT_TRUE(film.isVisible());
  EXPECT_EQ(film.geometry(), fixture.canvas.rect());
  ASSERT_TRUE(QTest::qWaitFor([&] { return film.ready() == 5; }, kWaitMs));
  double first = 0.0, last = 0.0;
  for (int i = 0; i < 400 && (first == 0.0 || last == 0.0); ++i) {
    QTest::qWait(5);
    const double at = dark_at(film.grab().toImage());
    if (film.frame() == 0) first = at;
    if (film.frame() == 4) last = at;
  }
  EXPECT_GT(first, 0.0);
  EXPECT_GT(last, first + 0.3);
  ASSERT_TRUE(QTest::qWaitFor([&] { return film.frame() == 0; }, kWaitMs)) << "it repeats";
}

TEST(FilmView, EscapeAClickAndAnEditStopIt) {
  Fixture fixture;
  FilmView film(fixture.canvas);
  QSignalSpy stopped(&film, &FilmView::stopped);
  film.play(two_keys());
  QTest::keyClick(&film, Qt::Key_Escape);
  EXPECT_FALSE(film.is_playing());
  EXPECT_FALSE(film.isVisible());
  film.play(two_keys());
  QTest::mouseClick(&film, Qt::LeftButton);
  EXPECT_FALSE(film.is_playing());
  film.play(two_keys());
  QTest::keyClick(&film, Qt::Key_P);
  EXPECT_TRUE(film.is_playing());
  fixture.draw({{50, 50}, {90, 50}});
  EXPECT_FALSE(film.is_playing()) << "a real device may draw meanwhile";
  EXPECT_EQ(stopped.count(), 3);
  EXPECT_EQ(stopped.front().front().toString(), QString());
}

TEST(FilmView, AFilmThatCannotBeMadeSaysWhy) {
  Fixture fixture;
  FilmView film(fixture.canvas);
  QSignalSpy stopped(&film, &FilmView::stopped);
  std::vector<FilmKey> keys = two_keys();
  keys.front().drawing.page.width_mm = std::numeric_limits<double>::quiet_NaN();
  film.play(std::move(keys));
  ASSERT_TRUE(stopped.count() > 0 || stopped.wait(kWaitMs));
  EXPECT_NE(stopped.front().front().toString(), QString());
  EXPECT_FALSE(film.is_playing());
}

TEST(Canvas, TheOnionSkinIsBelowTheInk) {
  Fixture fixture;
  fixture.draw({{20, 100}, {270, 100}}, 0.9);
  fixture.settle();
  const QImage before = fixture.canvas.grab().toImage();
  Drawing ghost = vertical_line(150.0);
  fixture.canvas.set_onion(ghost.document);
  const auto differs = [&] { return fixture.canvas.grab().toImage() != before; };
  EXPECT_TRUE(QTest::qWaitFor(differs, kWaitMs));
  fixture.canvas.set_onion(std::nullopt);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !differs(); }, kWaitMs));
}

}  // namespace
}  // namespace felt::desktop::film_view_test
