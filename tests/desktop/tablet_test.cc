// Draws in a real window with a tablet that is visible to Qt only. Checks the drawing, and that the
// recording gives the same drawing.
#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "desktop/engine/recording_file.h"
#include "desktop/files/drawing_file.h"
#include "desktop/window/main_window.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "tests/desktop/injected_pen.h"
#include "tests/desktop/recording_check.h"

namespace felt::desktop::tablet_test {
namespace {

constexpr int kMaxMs = 20'000;  // longest time to wait for an effect on a busy machine

std::string text_of(const Document& document) {
  std::string text;
  append_sketch_lines(text, document);
  return text;
}

class DesktopTablet : public ::testing::Test {
 protected:
  DesktopTablet() : recording_path_(folder_.filePath(QStringLiteral("recording.ndjson"))) {
    StudioOptions options;
    recording_ = record_into(recording_path_, options);
    window_ = std::make_unique<MainWindow>(std::move(options));
    window_->resize(1200, 800);
    window_->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    pen_ = std::make_unique<InjectedPen>(window_->canvas());
  }
  ~DesktopTablet() override {
    window_->studio().set_modified(false);  // so that closing does not ask whether to save
    window_.reset();
  }

  Studio& studio() { return window_->studio(); }
  std::size_t strokes() { return studio().session().document().stroke_count(); }
  std::string tool() { return std::string(studio().session().tool().info().id); }
  [[nodiscard]] QPointF px(Point mm) { return window_->canvas().view().to_px(mm); }

  void point(Point mm, double pressure) {
    pen_->point(px(mm), pressure);
    QTest::qWait(2);
  }
  /// Draws a stroke, lifts the pen, and waits until the session has handled the lift.
  void draw(const std::vector<Point>& places, double pressure = 0.5) {
    point(places.front(), 0.0);
    for (const Point& place : places) point(place, pressure);
    point(places.back(), 0.0);
    EXPECT_TRUE(QTest::qWaitFor(
        [this] { return studio().pen().is_known && !in_contact(studio().pen().sample); }, kMaxMs));
    QTest::qWait(250);  // a tool may wait for some time in case the pen touches again
  }
  static std::vector<Point> line(Point a, Point b, double wave_mm = 0.0) {
    std::vector<Point> places;
    for (int i = 0; i <= 60; ++i) {
      const double t = i / 60.0;
      places.push_back(
          {std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t) + wave_mm * std::sin(9 * t)});
    }
    return places;
  }
  /// Plays the recording so far with the command line program and returns the sketch.
  std::string replay() {
    recording_->flush();
    const Result<std::string> text = replayed(QStringLiteral(FELTLINE), recording_path_);
    EXPECT_TRUE(text.has_value()) << text.error().message;
    return text.value_or("");
  }

  QTemporaryDir folder_;
  QString recording_path_;
  std::unique_ptr<RecordingFile> recording_;
  std::unique_ptr<MainWindow> window_;
  std::unique_ptr<InjectedPen> pen_;
};

// Draws, pulls, erases, selects and rotates strokes, undoes, saves and reopens the drawing. Then
// the recording of all this must give the same drawing.
TEST_F(DesktopTablet, ADrawingIsMadeSavedAndPlayedAgain) {
  draw(line({40, 40}, {120, 60}, 4.0));
  draw(line({40, 90}, {120, 90}));
  draw(line({40, 120}, {120, 130}, 3.0));
  ASSERT_EQ(strokes(), 3u);

  std::string before = text_of(studio().session().document());
  studio().apply(SelectTool{"pull"});
  draw(line({80, 90}, {80, 105}), 0.8);
  EXPECT_NE(text_of(studio().session().document()), before) << "nothing was pulled";

  studio().apply(SelectTool{"pencil"});
  pen_->turn_over(true);
  point({80, 30}, 0.0);
  EXPECT_EQ(tool(), "eraser");
  draw(line({80, 30}, {80, 70}), 0.9);
  pen_->turn_over(false);
  point({150, 150}, 0.0);
  EXPECT_TRUE(QTest::qWaitFor([this] { return tool() == "pencil"; }, kMaxMs));
  EXPECT_EQ(strokes(), 4u) << "the first line is cut in two";

  before = text_of(studio().session().document());
  studio().apply(SelectStrokes{SelectStrokes::What::kAll});
  studio().apply(SetOption{"transform.mode", std::string("rotate")});
  studio().apply(SelectTool{"transform"});
  const Rect box = studio().session().selection().bounds(studio().session().document());
  draw(line({box.x1 - 4, box.y0 + 4}, {box.x1 - 4, box.y0 + 30}), 0.6);
  const std::string turned = text_of(studio().session().document());
  EXPECT_NE(turned, before) << "nothing was turned";

  studio().apply(UndoEvent{});
  EXPECT_EQ(text_of(studio().session().document()), before);
  studio().apply(RedoEvent{});
  EXPECT_EQ(text_of(studio().session().document()), turned);

  const QString path = folder_.filePath(QStringLiteral("drawing.felt"));
  ASSERT_TRUE(write_drawing(path, window_->files().drawing()).has_value());
  const Result<Drawing> again = read_drawing(path);
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(text_of(again->document), turned);
  EXPECT_EQ(replay(), turned) << "the recording gives another drawing";
  studio().set_modified(false);  // the drawing is saved
  EXPECT_TRUE(window_->files().open(path));
  EXPECT_EQ(text_of(studio().session().document()), turned);
}

// Sends 1,000 events at 1 kHz while the window repaints continuously and files are written. The
// recording must contain each position.
TEST_F(DesktopTablet, AThousandEventsAreAThousandPlaces) {
  for (int i = 0; i < 6; ++i) draw(line({20, 20.0 + 8 * i}, {180, 24.0 + 8 * i}, 2.0));
  QTimer repaint;
  QObject::connect(&repaint, &QTimer::timeout, &window_->canvas(),
                   [this] { window_->canvas().update(); });
  repaint.start(2);
  std::atomic<bool> done = false;
  std::atomic<int> saves = 0;
  const Drawing drawing = window_->files().drawing();
  const QString path = folder_.filePath(QStringLiteral("saved.felt"));
  std::jthread saver([&] {
    while (!done) saves += write_drawing(path, drawing).has_value() ? 1 : 0;
  });
  std::vector<Point> reported;
  std::vector<QPointF> places;
  for (int i = 0; i < 1000; ++i) {
    const double t = i / 1000.0;
    reported.push_back({30.0 + 140.0 * t, 110.0 + 25.0 * std::sin(20.0 * t)});
    places.push_back(px(reported.back()));
  }
  point(reported.front(), 0.0);
  std::jthread tablet([&] {
    auto next = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
      pen_->point(places[i], 0.3 + 0.0005 * static_cast<double>(i));
    }
    done = true;
  });
  EXPECT_TRUE(QTest::qWaitFor([&] { return done.load(); }, kMaxMs));
  QTest::qWait(50);
  point(reported.back(), 0.0);
  EXPECT_TRUE(QTest::qWaitFor([this] { return !in_contact(studio().pen().sample); }, kMaxMs));
  QTest::qWait(250);
  saver.join();
  EXPECT_GT(saves, 0);
  EXPECT_EQ(strokes(), 7u);
  recording_->flush();
  const auto poses = poses_of(recording_path_);
  ASSERT_TRUE(poses.has_value()) << poses.error().message;
  EXPECT_EQ(count_places(*poses, reported), reported.size());
  EXPECT_EQ(replay(), text_of(studio().session().document()));
}

}  // namespace
}  // namespace felt::desktop::tablet_test
