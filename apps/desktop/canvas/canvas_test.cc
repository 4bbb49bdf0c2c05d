#include "desktop/canvas/canvas.h"

#include <gtest/gtest.h>

#include <QPaintEvent>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "desktop/canvas/canvas_setting_keys.h"
#include "desktop/canvas/testing/canvas_fixture.h"
#include "desktop/engine/settings.h"
#include "felt/geometry/triangle_tree.h"
#include "felt/material/materials.h"

namespace felt::desktop::canvas_test {
namespace {

/// The difference of two pictures: the largest difference of a channel, and the number of pixels
/// that differ by more than `much`.
struct Apart {
  int largest = 0;
  int many = 0;
  QPoint where;
};

Apart apart(const QImage& a, const QImage& b, int much = 48) {
  Apart apart;
  if (a.size() != b.size()) return {255, a.width() * a.height(), {}};
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      const int by = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                               std::abs(qBlue(p) - qBlue(q))});
      if (by > apart.largest) {
        apart.largest = by;
        apart.where = {x, y};
      }
      apart.many += by > much;
    }
  }
  return apart;
}

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double between(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine_); }
  int below(int n) { return std::uniform_int_distribution<>(0, n - 1)(engine_); }
  Point place() { return {between(20, 277), between(15, 195)}; }

 private:
  std::mt19937 engine_;
};

void draw_something(Fixture& fixture) {
  std::vector<Point> wave;
  for (int i = 0; i <= 40; ++i) wave.push_back({30.0 + 5 * i, 70 + 30 * std::sin(0.3 * i)});
  fixture.draw(wave, 0.6);
  fixture.draw({{60, 150}, {140, 120}, {200, 160}}, 0.4);
}

/// For any tool and any action, a repaint of only the changed part gives the same picture as a
/// full repaint.
TEST(Canvas, PaintingWhatChangedIsPaintingEverything) {
  const char* const tools[] = {"pencil", "pull",  "smooth",    "width",
                               "eraser", "lasso", "transform", "connect"};
  Settings::the().set(QString::fromLatin1(canvas_keys::kForceArrow), true);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Dice dice(seed);
    Fixture fixture({520, 380},
                    seed == 2 ? QStringLiteral("simulated:touch") : QStringLiteral("tablet"));
    draw_something(fixture);
    if (seed == 3) {  // new ink lies below other ink
      const LayerId low = fixture.studio.session().layer();
      fixture.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}});
      draw_something(fixture);
      fixture.studio.apply(LayerEvent{LayerEvent::Do::kUse, low});
    }
    for (const char* tool : tools) {
      fixture.tool(tool);
      for (int gesture = 0; gesture < 2; ++gesture) {
        fixture.go(dice.place(), false);
        const auto buttons = static_cast<std::uint32_t>(dice.below(3));
        const bool down = gesture == 1 || dice.below(2) == 0;
        for (int leg = 0; leg < 2; ++leg) {
          fixture.go(dice.place(), down, dice.between(0.2, 1.0), buttons);
          const Apart off = apart(fixture.seen(), fixture.anew());
          ASSERT_LE(off.largest, 2) << "seed " << seed << ", " << tool << ", at " << off.where.x()
                                    << "," << off.where.y();
        }
        fixture.lift();
      }
    }
  }
}

TEST(Canvas, RepaintsLittleWhileInkFlows) {
  Fixture fixture;
  fixture.go({50, 50}, false);
  fixture.touch(0.5);
  fixture.go({150, 120}, true, 0.5);
  fixture.settle();
  struct Meter : QObject {
    int pixels = 0;
    bool eventFilter(QObject*, QEvent* event) override {
      if (event->type() != QEvent::Paint) return false;
      for (const QRect& part : static_cast<QPaintEvent*>(event)->region()) {
        pixels += part.width() * part.height();
      }
      return false;
    }
  } meter;
  fixture.canvas.installEventFilter(&meter);
  for (int i = 0; i < 20; ++i) {
    meter.pixels = 0;
    fixture.move(fixture.at + Vec{1.0, 0.3}, true, 0.5);
    fixture.settle();
    EXPECT_GT(meter.pixels, 0);
    EXPECT_LT(meter.pixels, 640 * 480 / 7);
  }
}

/// Returns the difference between the line while it is drawn and the line in the document.
Apart jump_at_pen_up(Fixture& fixture, const std::vector<Point>& way) {
  fixture.canvas.set_pen_visible(false);
  fixture.go(way.front(), false);
  fixture.touch(0.3);
  double pressure = 0.3;
  for (const Point& p : way) fixture.go(p, true, pressure = 1.1 - pressure);
  fixture.canvas.flush();
  const QImage wet = fixture.anew();
  // Gives the pen time to stop, because its last moments draw no ink.
  fixture.studio.apply(SelectTool{"eraser"});
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), 1u);
  const QImage dry = fixture.anew();
  // Compared in pixels of the widget, because the final width fit makes differences that are too
  // small to see.
  const QSize seen = fixture.canvas.size();
  const auto as_seen = [&](const QImage& image) {
    return image.scaled(seen, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  };
  return apart(as_seen(wet), as_seen(dry));
}

/// Switches the grain of the surface off while it exists, so that ink has the colour of its
/// strokes.
struct SolidInk {
  SolidInk() { Settings::the().set(canvas_keys::kGrain, false); }
  SolidInk(const SolidInk&) = delete;
  SolidInk& operator=(const SolidInk&) = delete;
  ~SolidInk() { Settings::the().set(canvas_keys::kGrain, canvas_keys::kGrainDefault); }
};

TEST(Canvas, WetInkIsTheInkThatDries) {
  const SolidInk solid;
  std::vector<Point> loops;
  for (int i = 0; i <= 120; ++i) {
    loops.push_back({40.0 + 1.4 * i + 18 * std::cos(0.25 * i), 100 + 40 * std::sin(0.25 * i)});
  }
  for (const char* color : {"#20242c", "#c0402080"}) {
    Fixture fixture;
    fixture.option("ink.color", std::string(color));
    fixture.option("pencil.max_width_mm", 4.0);
    fixture.option("pencil.snap", std::string("off"));
    fixture.option("pencil.refine", false);
    if (color[1] == 'c') {
      CanvasView view = fixture.canvas.view();
      view.turn(33, {200, 200});
      view.mirror();
      fixture.canvas.set_view(view);
    }
    const QImage empty = fixture.anew();
    const Apart off = jump_at_pen_up(fixture, loops);
    const double dpr = fixture.canvas.devicePixelRatioF();
    const int inked = qRound(apart(empty, fixture.anew()).many / (dpr * dpr));
    EXPECT_GT(inked, 2000);  // a line was drawn that can be compared
    EXPECT_LE(off.many, inked / 200)
        << color << ": " << off.largest << " at " << off.where.x() << "," << off.where.y();
  }
}

void draw_evenly(Fixture& fixture, double width_mm) {
  for (const char* width : {"pencil.min_width_mm", "pencil.max_width_mm"}) {
    fixture.option(width, width_mm);
  }
  fixture.option("pencil.snap", std::string("off"));
  fixture.option("pencil.refine", false);
}

/// Expects that wet ink does not jump when it enters the document. For a line of constant width,
/// only the end is fitted again; the rest stays the same, pixel for pixel, at any scale of the
/// screen. At most `most` pixels may change. Returns the picture with the wet line.
QImage expect_no_jump(Fixture& fixture, const std::vector<Point>& way, int largest = 0) {
  fixture.canvas.set_pen_visible(false);
  const std::size_t before = fixture.studio.session().document().stroke_count();
  const QImage without = fixture.anew();
  fixture.go(way.front(), false);
  fixture.touch(0.5);
  for (const Point& p : way) fixture.go(p, true, 0.5);
  fixture.canvas.flush();
  QImage all = fixture.anew();
  fixture.studio.apply(SelectTool{"eraser"});
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), before + 1);
  // Checks the very next frame, and the frame with all tiles.
  for (int frame = 0; frame < 2; ++frame) {
    QImage wet = all;
    QImage dry = frame == 0 ? fixture.canvas.grab().toImage().convertToFormat(QImage::Format_RGB32)
                            : fixture.anew();
    for (QImage* image : {&wet, &dry}) {  // clears the end of the line
      image->setDevicePixelRatio(fixture.canvas.devicePixelRatioF());
      QPainter painter(image);
      painter.setBrush(Qt::black);
      const double reach = 30.0 * fixture.canvas.view().px_per_mm();
      painter.drawEllipse(fixture.canvas.view().to_px(way.back()), reach, reach);
    }
    EXPECT_GT(apart(without, dry).many, 2000);
    const Apart off = apart(wet, dry);
    EXPECT_LE(off.many, largest) << "frame " << frame << ", " << off.largest << " at "
                                 << off.where.x() << "," << off.where.y();
  }
  fixture.tool("pencil");
  return all;
}

TEST(Canvas, WetInkOfOneWidthDriesWhereItIs) {
  const SolidInk solid;
  std::vector<Point> loops;
  for (int i = 0; i <= 120; ++i) {
    loops.push_back({40.0 + 1.4 * i + 18 * std::cos(0.25 * i), 100 + 40 * std::sin(0.25 * i)});
  }
  Fixture fixture;
  draw_evenly(fixture, 2.0);
  expect_no_jump(fixture, loops);
}

/// Tests rough paper and glass: wet and dry ink have the same grain at the same points.
TEST(Canvas, R47_WetInkOfEveryMediumDriesAsItLooks) {
  std::vector<Point> loops;
  for (int i = 0; i <= 60; ++i) {
    loops.push_back({60.0 + 1.8 * i + 18 * std::cos(0.25 * i), 100 + 40 * std::sin(0.25 * i)});
  }
  Settings::the().set(canvas_keys::kGrain, true);
  for (const Medium& medium : media()) {
    if (!medium.draws) continue;
    SCOPED_TRACE(medium.id);
    Fixture fixture;
    draw_evenly(fixture, 5.0);
    fixture.option("surface.material",
                   std::string(medium.look.rim > 0.0 ? "glass" : "rough-paper"));
    fixture.option("ink.color", std::string("#20242c"));
    fixture.option("pencil.medium", medium.id);
    // Hairs are as thin as pixels. Where a line crosses itself, either pass may be visible, in 250
    // of 20,000 pixels.
    expect_no_jump(fixture, loops, medium.look.streaks > 0.0 ? 250 : 0);
  }
  Settings::the().set(canvas_keys::kGrain, canvas_keys::kGrainDefault);
}

/// Ink in a layer is shown below the ink of the layers above it from its first sample on.
TEST(Canvas, WetInkLiesBelowTheLayersAboveIt) {
  const SolidInk solid;
  Fixture fixture;
  draw_evenly(fixture, 12.0);
  const LayerId low = fixture.studio.session().layer();
  fixture.option("ink.color", std::string("#209040ff"));
  fixture.draw({{30, 60}, {250, 60}});
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}});
  const LayerId high = fixture.studio.session().layer();
  fixture.option("ink.color", std::string("#c02020ff"));
  fixture.draw({{100, 30}, {100, 180}});
  fixture.option("ink.color", std::string("#2040c080"));
  fixture.draw({{150, 30}, {150, 180}});
  fixture.option("ink.color", std::string("#202020ff"));
  const auto color_at = [&](const QImage& seen, Point place) {
    const double dpr = fixture.canvas.devicePixelRatioF();
    return seen.pixelColor((fixture.canvas.view().to_px(place) * dpr).toPoint());
  };
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kUse, low});
  const QImage below = expect_no_jump(fixture, {{40, 100}, {180, 100}, {260, 150}});
  EXPECT_EQ(color_at(below, {100, 100}), QColor("#c02020"));
  EXPECT_EQ(color_at(below, {80, 100}), QColor("#202020"));
  EXPECT_NEAR(color_at(below, {150, 100}).blue(), 0.5 * (0xc0 + 0x20), 2);
  // Ink that is hidden, removed or below new ink does not cover it.
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kHide, high});
  const QImage alone = expect_no_jump(fixture, {{40, 120}, {180, 120}, {260, 170}});
  EXPECT_EQ(color_at(alone, {100, 120}), QColor("#202020"));
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kShow, high});
  const QImage again = expect_no_jump(fixture, {{40, 140}, {180, 140}, {260, 190}});
  EXPECT_EQ(color_at(again, {100, 140}), QColor("#c02020"));
  CanvasView view = fixture.canvas.view();
  view.turn(20, {200, 200});
  view.zoom(1.1, {200, 200});
  fixture.canvas.set_view(view);
  const QImage turned = expect_no_jump(fixture, {{40, 80}, {180, 80}, {260, 130}});
  EXPECT_EQ(color_at(turned, {100, 80}), QColor("#c02020"));
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kUse, high});
  // At pen-up, the whole straight part after the corner is fitted again. It is short enough here
  // to lie within the end that is not compared.
  const QImage over = expect_no_jump(fixture, {{40, 160}, {235, 160}, {255, 172}});
  EXPECT_EQ(color_at(over, {100, 160}), QColor("#202020"));
}

TEST(Canvas, WetInkWithAlphaCoversEachPlaceOnce) {
  const SolidInk solid;
  Fixture fixture;
  fixture.canvas.set_pen_visible(false);
  fixture.option("ink.color", std::string("#00000080"));
  fixture.option("pencil.snap", std::string("off"));
  fixture.option("pencil.min_width_mm", 5.0);
  fixture.option("pencil.max_width_mm", 6.0);
  fixture.go({60, 60}, false);
  fixture.touch(0.5);
  for (const Point p : {Point{160, 60}, {160, 120}, {100, 120}, {100, 30}}) {
    fixture.go(p, true, 0.5);
  }
  const QImage seen = fixture.seen();
  int darkest = 255;
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) darkest = std::min(darkest, qGray(seen.pixel(x, y)));
  }
  EXPECT_NEAR(darkest, 127, 2);
}

TEST(Canvas, TellsTheEmptyPageWhatToDoUntilThereIsInk) {
  Fixture fixture;
  fixture.canvas.set_pen_visible(false);
  const QImage empty = fixture.seen();
  EXPECT_TRUE(fixture.canvas.accessibleDescription().contains(QStringLiteral("Draw")));
  fixture.go({50, 50}, false);
  fixture.touch(0.5);
  fixture.go({60, 50}, true, 0.5);
  const int dpr = qRound(fixture.canvas.devicePixelRatioF());
  const QRect middle(200 * dpr, 180 * dpr, 240 * dpr, 120 * dpr);
  const QImage drawing = fixture.seen();
  EXPECT_GT(apart(empty.copy(middle), drawing.copy(middle)).many, 200);
  fixture.lift();
  EXPECT_EQ(apart(drawing.copy(middle), fixture.seen().copy(middle)).largest, 0);
  EXPECT_FALSE(fixture.canvas.accessibleDescription().contains(QStringLiteral("Draw")));
  fixture.studio.open(Document{}, fixture.studio.page());
  EXPECT_EQ(apart(empty, fixture.seen()).largest, 0);
}

TEST(Canvas, SaysWhetherPressureIsSeen) {
  Fixture fixture;
  EXPECT_TRUE(fixture.canvas.accessibleDescription().contains(QStringLiteral("No pressure")));
  fixture.canvas.set_tablet_in_hand(true);
  fixture.draw({{50, 50}, {60, 60}}, 0.5);
  fixture.studio.apply(UndoEvent{});
  EXPECT_FALSE(fixture.canvas.accessibleDescription().contains(QStringLiteral("No pressure")));
  fixture.canvas.set_pen_status(QStringLiteral("as the pens say"));
  EXPECT_TRUE(fixture.canvas.accessibleDescription().contains(QStringLiteral("as the pens say")));
}

TEST(Canvas, HasAHintForEveryTool) {
  Fixture fixture;
  QSignalSpy reported(&fixture.canvas, &Canvas::hint_changed);
  QStringList hints;
  for (const auto& tool : fixture.studio.session().tools()) {
    fixture.tool(std::string(tool->info().id));
    const QString hint = fixture.canvas.hint();
    EXPECT_FALSE(hint.isEmpty());
    EXPECT_FALSE(hints.contains(hint)) << hint.toStdString();
    EXPECT_NE(hint.toStdString(), tool->info().help) << "is in the table";
    hints << hint;
  }
  EXPECT_GE(reported.count(), hints.size() - 1);
  fixture.tool("eraser");
  EXPECT_TRUE(fixture.canvas.hint().contains(QStringLiteral("Shift: up to the crossings")));
  EXPECT_TRUE(fixture.canvas.hint().contains(QStringLiteral("Ctrl: whole lines")));
  const std::vector<Triangle3> body{{{50, 50, 5}, {60, 50, 5}, {50, 60, 5}}};
  fixture.studio.touch(std::make_shared<const TriangleTree>(body));
  EXPECT_TRUE(fixture.canvas.hint().startsWith(QStringLiteral("Hold the pen against the body")));
  fixture.studio.touch(nullptr);
  EXPECT_FALSE(fixture.canvas.hint().contains(QStringLiteral("body")));
}

TEST(Canvas, KeepsThePageFittedUntilTheViewIsChanged) {
  Fixture fixture({400, 300});
  const auto shows_page = [&] {
    const CanvasView& view = fixture.canvas.view();
    return view.visible_mm().contains({0, 0}) && view.visible_mm().contains({297, 210});
  };
  EXPECT_TRUE(shows_page());
  fixture.canvas.resize(1200, 900);
  fixture.settle();
  EXPECT_TRUE(shows_page());
  EXPECT_GT(fixture.canvas.view().px_per_mm(), 3.0);
  fixture.canvas.set_zoom(2.0);
  EXPECT_NEAR(fixture.canvas.zoom(), 2.0, 1e-9);
  fixture.canvas.resize(600, 500);
  fixture.settle();
  EXPECT_NEAR(fixture.canvas.zoom(), 2.0, 1e-9);
  EXPECT_EQ(fixture.canvas.view_text(), QStringLiteral("200 %"));
  fixture.canvas.fit_page();
  EXPECT_TRUE(shows_page());
}

TEST(Canvas, ViewChangesAreNoStepOfUndo) {
  Fixture fixture;
  draw_something(fixture);
  const std::uint64_t edits = fixture.studio.session().edit_count();
  CanvasView view = fixture.canvas.view();
  view.mirror();
  view.turn(30, {10, 10});
  fixture.canvas.set_view(view);
  fixture.canvas.fit_ink();
  EXPECT_EQ(fixture.studio.session().edit_count(), edits);
  EXPECT_TRUE(fixture.canvas.view_text().contains(QStringLiteral("mirrored")));
}

/// If forces move the stylus, the nib is shown between the hand and the stylus.
TEST(Canvas, ShowsTheNibThatForcesHoldBackUnlessSwitchedOff) {
  const QString key = QString::fromLatin1(canvas_keys::kPseudoHaptics);
  Settings::the().set(QString::fromLatin1(canvas_keys::kForceArrow), false);
  const auto hand_and_nib_part = [&](bool on) {
    Settings::the().set(key, on);
    Fixture fixture({640, 480}, QStringLiteral("simulated:touch"));
    fixture.draw({{60, 100}, {200, 100}}, 0.6);
    fixture.tool("pull");
    fixture.go({120, 100}, false);
    fixture.touch(0.6);
    fixture.go({120, 130}, true, 0.6);
    const Point stylus{fixture.studio.pen().sample.position.x,
                       fixture.studio.pen().sample.position.y};
    EXPECT_GT(distance(stylus, fixture.studio.pen().hand), 0.5);
    const QImage with = fixture.anew();
    fixture.canvas.set_pen_visible(false);
    const QImage without = fixture.anew();
    QRect part;
    for (int y = 0; y < with.height(); ++y) {
      for (int x = 0; x < with.width(); ++x) {
        if (with.pixel(x, y) != without.pixel(x, y)) part |= QRect(x, y, 1, 1);
      }
    }
    return part;
  };
  const QRect on = hand_and_nib_part(true), off = hand_and_nib_part(false);
  EXPECT_FALSE(off.isEmpty());
  EXPECT_GT(on.height(), off.height());
  Settings::the().set(key, true);
  Settings::the().set(QString::fromLatin1(canvas_keys::kForceArrow), true);
}

TEST(Canvas, ForceArrowIsThereWhereForcesAreAndCanBeSwitchedOff) {
  const QString key = QString::fromLatin1(canvas_keys::kForceArrow);
  Fixture fixture;
  fixture.draw({{60, 100}, {200, 100}}, 0.6);
  fixture.tool("pull");
  fixture.go({120, 100}, false);
  fixture.touch(0.6);
  fixture.go({120, 130}, true, 0.6);
  ASSERT_GT(std::abs(fixture.studio.pen().asked.y), 0.1);
  Settings::the().set(key, true);
  const QImage on = fixture.anew();
  Settings::the().set(key, false);
  EXPECT_GT(apart(on, fixture.anew()).many, 20);
  Settings::the().set(key, true);
  EXPECT_EQ(apart(on, fixture.anew()).largest, 0);
  fixture.studio.loop().set_forces(false);
  fixture.move(fixture.at, true, 0.6);
  EXPECT_GT(apart(on, fixture.anew()).many, 20);
}

double thread_cpu_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Measures and prints the cost of a sample on a large screen, for a line of many metres that
/// crosses itself again and again. Expects no limit, because a busy machine is slow.
TEST(Canvas, CostOfASampleOfALongLine) {
  Fixture fixture({1920, 1080});
  fixture.option("pencil.max_width_mm", 3.0);
  fixture.go({60, 60}, false);
  fixture.touch(0.5);
  std::vector<double> early, late;
  constexpr int kSamples = 800;
  for (int i = 0; i < kSamples; ++i) {
    const double a = 0.1 * i;
    const Point at{148 + (40 + 0.04 * i) * std::cos(a), 105 + (30 + 0.04 * i) * std::sin(1.03 * a)};
    fixture.studio.point({fixture.studio.now_ns(), at, true, 0.3 + 0.2 * std::sin(0.3 * a)});
    fixture.studio.advance(7'000'000);
    QCoreApplication::processEvents();
    const double begin_us = thread_cpu_us();
    fixture.studio.advance(1'000'000);
    QCoreApplication::processEvents();
    const double us = thread_cpu_us() - begin_us;
    if (i >= 100 && i < 300) early.push_back(us);
    if (i >= kSamples - 200) late.push_back(us);
  }
  const auto share = [](std::vector<double> v, double p) {
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(p * static_cast<double>(v.size() - 1))];
  };
  for (const auto& [name, all] : {std::pair{"early", early}, {"late", late}}) {
    std::printf(
        "  a sample and its paint, 1920 x 1080, %s in the line: CPU p50 %.0f us, p99 %.0f us\n",
        name, share(all, 0.5), share(all, 0.99));
  }
  EXPECT_GT(fixture.studio.pen().sample.time_ns, kSamples * 8'000'000LL);
  EXPECT_TRUE(fixture.studio.session().gesture_in_progress());
}

TEST(Canvas, AnotherSizeIsShownAtThePointer) {
  Fixture fixture;
  fixture.go({100, 100}, false);
  const QImage before = fixture.anew();
  fixture.option("pencil.max_width_mm", 12.0);
  fixture.canvas.flush();
  const QImage ring = fixture.anew();
  EXPECT_NE(ring, before);
  // The point is at the edge of a line that was drawn with the mouse.
  const double radius_mm = 0.5 * (0.3 + 0.5 * (12.0 - 0.3));
  const double dpr = fixture.canvas.devicePixelRatioF();
  const QPoint edge = (fixture.canvas.view().to_px({100 + radius_mm, 100}) * dpr).toPoint();
  int other = 0;
  for (int dx = -3; dx <= 3; ++dx) {
    const QPoint at = edge + QPoint(dx, 0);
    other += ring.pixel(at) != before.pixel(at) ? 1 : 0;
  }
  EXPECT_GT(other, 0);
  EXPECT_TRUE(fixture.canvas.hint().contains(QStringLiteral("Draw")));
  fixture.canvas.set_right_button(QStringLiteral("Erase while held"));
  EXPECT_TRUE(fixture.canvas.hint().contains(QStringLiteral("Erase while held")));
  fixture.tool("pull");
  const QString pulls = fixture.canvas.hint();
  fixture.option("pull.mode", std::string("push"));
  EXPECT_NE(fixture.canvas.hint(), pulls) << "each mode says what it does";
}

}  // namespace
}  // namespace felt::desktop::canvas_test
