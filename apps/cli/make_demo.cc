// Writes the acts of the demonstration as scripts into the tools' folders: make_demo
// src/felt/tools.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

#include "demo_act.h"
#include "felt/devices/simulated/samples/drawings.h"
#include "felt/tools/choice_ring.h"

namespace felt {
namespace {

/// Returns a part of a circle that begins at `from` turns (0 is right, a quarter is down). It is
/// slightly uneven, as if drawn by hand.
Gesture arc(Point center, double radius_mm, double from, double turns, double pressure) {
  Gesture gesture{.via = {}, .pressure = pressure, .end_pressure = 0.45};
  const int steps = std::max(4, static_cast<int>(std::abs(turns) * 16.0));
  for (int i = 0; i <= steps; ++i) {
    const double turn = from + turns * i / steps;
    const double angle = 2.0 * std::numbers::pi * turn;
    const double r = radius_mm * (1.0 + 0.015 * std::sin(3.0 * angle + 1.0));
    gesture.via.push_back(center + Vec{r * std::cos(angle), r * std::sin(angle)});
  }
  return gesture;
}

/// Returns a ball of wool next to the cat. Its outline ends 1.5 mm before its start, and snapping
/// closes it.
std::vector<Gesture> ball_of_wool() {
  const Point center{14.5, 111.0};
  constexpr double kRadius = 10.2;
  std::vector<Gesture> ball;
  ball.push_back(arc(center, kRadius, 0.75, 1.0 - 1.5 / (2.0 * std::numbers::pi * kRadius), 0.6));
  const auto thread = [&](const std::vector<Vec>& offsets) {
    Gesture gesture{.via = {}, .pressure = 0.32, .end_pressure = 0.3};
    for (const Vec& offset : offsets) gesture.via.push_back(center + offset);
    ball.push_back(std::move(gesture));
  };
  // The thread is wound in one direction, and then over it in the other direction.
  thread({{-9.2, -2.4}, {-6.2, -5.2}, {-2.6, -9.2}});
  thread({{-9.0, 2.2}, {-5.0, -2.8}, {1.2, -9.0}});
  thread({{-7.8, 5.2}, {-3.4, -0.8}, {4.4, -5.2}, {8.2, -4.8}});
  thread({{-4.8, 8.2}, {-0.6, 2.2}, {5.6, -1.6}, {9.0, -1.0}});
  thread({{-0.8, 9.2}, {3.0, 4.8}, {6.8, 2.4}, {8.8, 2.8}});
  // This is the loose end of the thread.
  ball.push_back({.via = {{20.5, 119.2},
                          {24.6, 123.4},
                          {30.6, 125.6},
                          {35.2, 125.2},
                          {35.0, 122.8},
                          {31.8, 124.0},
                          {34.0, 127.0},
                          {41.4, 126.2}},
                  .pressure = 0.45});
  return ball;
}

/// Selects fine lines that get wider with pressure, because the tool's default width is for broad
/// strokes.
void fine_pencil(DemoAct& act) {
  act.set("pencil.min_width_mm", 0.25);
  act.set("pencil.max_width_mm", 2.2);
  act.set("pencil.gamma", 1.2);
}

/// Returns a line drawn by a trembling hand.
std::vector<Gesture> shaky_line() {
  return {{.via = {{22, 130}, {38, 131.5}, {58, 130.5}, {80, 132}, {104, 130}, {119, 131.5}},
           .pressure = 0.5,
           .tempo = 0.5,
           .end_pressure = 0.4}};
}

/// Returns a fish with an outline that ends 7 mm from its start.
std::vector<Gesture> fish() {
  const Vec at{2.0, 74.0};
  std::vector<Gesture> fish;
  const auto line = [&](const std::vector<Vec>& offsets, double pressure) {
    Gesture gesture{.via = {}, .pressure = pressure, .end_pressure = 0.4};
    for (const Vec& offset : offsets) gesture.via.push_back(Point{} + at + offset);
    fish.push_back(std::move(gesture));
  };
  line({{24.5, 1.5},
        {18, -3.6},
        {9.5, -3.4},
        {1.5, 3.0},
        {1.5, 3.0},
        {9.5, 9.2},
        {17.5, 9.4},
        {23.5, 5.6},
        {28.5, 1.6},
        {28.5, 1.6},
        {29.2, 6},
        {28.6, 10.4},
        {28.6, 10.4},
        {26.2, 7.6}},
       0.5);
  line({{6.6, 1.8}, {6.7, 2.1}}, 0.8);
  line({{11.5, -1.0}, {13.4, 3.0}, {11.8, 7.0}}, 0.35);
  return fish;
}

/// Returns the first act: the pencil draws the cat and the ball of wool, and snapping closes the
/// ball's outline.
std::string pencil_act() {
  WritingHand hand({.seed = 3});
  int count = 0;
  std::vector<Gesture> ball = ball_of_wool();
  DemoAct act;
  act.tool("pencil");
  fine_pencil(act);
  act.set("ink.color", std::string("#23262d"));
  act.draw(hand, ball, count);
  act.draw(hand, cat_drawing(), count);
  return act.text();
}

/// Returns the act in which the tip of an ear is pulled out, and the back is made rounder.
std::string pull_act() {
  DemoAct act;
  act.tool("pull");
  act.set("pull.mode", std::string("brush"));
  act.set("pull.radius_mm", 16.0);
  act.gesture({{80.5, 14.2}, {83.2, 10.2}, {86.2, 5.6}}, 20.0);
  act.set("pull.radius_mm", 9.0);
  act.gesture({{77.8, 18.6}, {79.4, 16.0}, {82.0, 12.6}}, 20.0);
  act.set("pull.radius_mm", 30.0);
  act.gesture({{86.6, 82}, {89.5, 81}, {93, 79.5}}, 20.0);
  return act.text();
}

/// Returns the act in which a trembling line is smoothed, except its last part.
std::string smooth_act() {
  WritingHand hand({.tremor_mm = 0.28, .wander_mm = 0.3, .seed = 5});
  int count = 100;
  DemoAct act;
  act.tool("pencil");
  fine_pencil(act);
  act.draw(hand, shaky_line(), count);
  act.tool("smooth");
  act.set("smooth.radius_mm", 22.0);
  const std::vector<Point> there{{22, 130}, {38, 131.5}, {58, 130.5}, {80, 132}};
  act.gesture(there, 40.0, 4.0);
  act.gesture({there.rbegin(), there.rend()}, 40.0, 4.0);
  return act.text();
}

/// Returns the act in which a line of the tail is made wider.
std::string width_act() {
  DemoAct act;
  act.tool("width");
  act.set("width.mode", std::string("brush"));
  act.set("width.reach_mm", 8.0);
  act.set("width.max_width_mm", 2.6);
  act.gesture({{41.8, 72}, {41.6, 80}, {43.4, 93}, {45.4, 101}}, 12.0, 6.0);
  return act.text();
}

/// Returns the act in which a whisker is erased as far as the cheek, and another one completely.
std::string eraser_act() {
  DemoAct act;
  act.tool("eraser");
  act.set("eraser.mode", std::string("touched"));
  act.set("eraser.radius_mm", 1.5);
  act.gesture({{26.0, 55.0}, {32, 53.4}, {37.4, 52.3}}, 30.0, 3.0);
  act.set("eraser.mode", std::string("stroke"));
  act.gesture({{30, 60.8}, {33, 59.4}}, 15.0, 3.0);
  return act.text();
}

/// Returns the act in which a loop around the ball selects whole lines.
std::string lasso_act() {
  DemoAct act;
  act.tool("lasso");
  act.set("lasso.take", std::string("strokes"));
  act.gesture({{3, 100},
               {14.5, 97.5},
               {26.5, 104},
               {28, 113},
               {22, 122},
               {10, 124},
               {1.5, 113},
               {3.2, 101}},
              90.0);
  return act.text();
}

/// Returns the act in which the head is selected by a lasso and rotated by a drag around its
/// middle. The flanks stay attached and resist.
std::string transform_act() {
  DemoAct act;
  act.tool("lasso");
  act.set("lasso.take", std::string("parts"));
  act.gesture(loop_around_cats_head(), 130.0);
  act.tool("transform");
  act.set("transform.mode", std::string("rotate"));
  act.gesture({{80, 30}, {81.6, 33.5}, {82.4, 37.5}}, 18.0);
  return act.text();
}

/// Returns the act in which a fish is drawn with an open outline, and the end of the outline is
/// moved to its start, which closes it.
std::string connect_act() {
  WritingHand hand({.seed = 8});
  int count = 200;
  DemoAct act;
  act.tool("pencil");
  fine_pencil(act);
  act.draw(hand, fish(), count);
  act.tool("connect");
  act.gesture({{28.2, 81.6}, {27.4, 78.6}, {26.5, 75.5}}, 12.0);
  return act.text();
}

/// Returns the act in which a drag across the ball makes the wool red.
std::string recolor_act() {
  DemoAct act;
  act.tool("recolor");
  act.set("ink.color", std::string("#a63c2e"));
  act.gesture({{3.2, 114}, {9, 115.5}, {16, 112}, {22, 107.5}, {25.5, 106}}, 25.0);
  return act.text();
}

/// Returns the act in which a window with a moon is drawn from corner to corner.
std::string shape_act() {
  DemoAct act;
  act.tool("shape");
  act.set("ink.color", std::string("#23262d"));
  act.set("shape.shape", std::string("rectangle"));
  act.gesture({{3, 6}, {12, 19}, {23, 36}}, 25.0);
  act.set("shape.shape", std::string("ellipse"));
  act.gesture({{10, 11}, {15, 16}, {20, 21}}, 25.0);
  return act.text();
}

/// Returns the act in which four rough strokes become one line, the edge of a curtain.
std::string gather_act() {
  WritingHand hand({.tremor_mm = 0.1, .wander_mm = 0.3, .seed = 9});
  int count = 300;
  const auto strand = [](double off, double from, double to) {
    Gesture gesture{.via = {}, .pressure = 0.4, .end_pressure = 0.4};
    for (int i = 0; i <= 6; ++i) {
      const double y = from + (to - from) * i / 6.0;
      gesture.via.push_back({112.0 + off + 4.0 * std::sin(0.08 * (y - 12.0)), y});
    }
    return gesture;
  };
  const std::vector<Gesture> strands{strand(-0.8, 14, 46), strand(0.6, 20, 62), strand(0.0, 36, 70),
                                     strand(1.0, 12, 40)};
  DemoAct act;
  act.tool("pencil");
  fine_pencil(act);
  act.set("ink.color", std::string("#23262d"));
  act.draw(hand, strands, count);
  act.tool("gather");
  act.set("gather.radius_mm", 4.0);
  act.gesture({{112.8, 11}, {116.2, 30}, {114.2, 46}, {109.8, 60}, {108.2, 71}}, 25.0);
  return act.text();
}

/// Returns the act in which the areas between the threads of the ball are filled.
std::string fill_act() {
  DemoAct act;
  act.tool("fill");
  act.set("ink.color", std::string("#e8b9a5"));
  act.gesture({{7.5, 105.5}, {11.5, 109}, {15, 113.5}, {18, 118.2}}, 20.0);
  return act.text();
}

/// Returns the act in which a held ring becomes a circle, and a scribble deletes the moon.
std::string gestures_act() {
  DemoAct act;
  act.tool("pencil");
  fine_pencil(act);
  act.set("ink.color", std::string("#23262d"));
  act.set("pencil.shapes", true);
  act.set("pencil.scratch_out", true);
  std::vector<Point> ring;
  for (const Point& at : arc({13.0, 52.0}, 8.0, 0.75, 0.97, 0.5).via) ring.push_back(at);
  act.hover(ring.front());
  act.press();
  act.wait(0.15);
  act.along({ring.begin() + 1, ring.end()}, 25.0);
  act.wait(0.8);  // the circle is offered
  act.press(3.5);
  act.wait(0.3);
  act.lift();
  act.hover({8.5, 10.5});
  act.press();
  std::vector<Point> scribble;
  for (int i = 1; i <= 9; ++i) scribble.push_back({i % 2 == 0 ? 8.5 : 21.5, 10.5 + 1.3 * i});
  act.along(scribble, 90.0);
  act.wait(0.1);
  act.lift();
  act.wait(1.0);  // it is asked
  act.choose(OfferKind::kDelete);
  act.wait(0.6);
  act.set("pencil.shapes", false);
  act.set("pencil.scratch_out", false);
  return act.text();
}

/// Returns the act in which a hand that shakes draws the same line without and with the steady
/// hand.
std::string steady_act() {
  constexpr double kHz = 5.5;
  const auto line = [](double y) {
    return std::vector<Point>{{4.0, y}, {12.0, y - 1.0}, {22.0, y + 1.0}, {33.0, y}};
  };
  DemoAct act;
  act.tool("pencil");
  fine_pencil(act);
  act.shake({0.3, 1.0}, kHz);
  act.gesture(line(91.0), 18.0);
  act.set("pencil.steady_hz", kHz);
  act.set("pencil.steady_mm", 1.0);
  act.set("pencil.steady_axis_deg", 73.0);
  act.set("pencil.steady", true);
  act.gesture(line(96.5), 18.0);
  act.set("pencil.steady", false);
  return act.text();
}

/// Returns the act in which the eraser is pressed until it clicks, and erases a whole line.
std::string press_act() {
  DemoAct act;
  act.tool("eraser");
  act.set("eraser.mode", std::string("touched"));
  act.set("eraser.radius_mm", 1.5);
  act.set("eraser.press_through", true);
  act.hover({20.0, 94.0});
  act.press(2.0);
  act.along({{20.0, 90.5}}, 15.0);
  act.wait(0.5);
  act.press(5.0);
  act.wait(0.5);
  act.lift();
  act.set("eraser.press_through", false);
  return act.text();
}

/// Returns the act in which the pen follows a line to its end.
std::string read_act() {
  DemoAct act;
  act.tool("read");
  act.gesture({{6.0, 98.0}, {13.0, 97.2}, {22.0, 98.4}, {32.6, 97.0}}, 14.0);
  return act.text();
}

/// Returns the act in which the pen chooses a tool in a ring: it feels a well, goes over the ridge
/// to the next one, and lifts. Then it uses the tool.
std::string ring_act() {
  DemoAct act;
  act.tool("pencil");
  act.hover({66.0, 78.0});
  act.open_ring(kRingMm);
  act.wait(0.5);
  act.press();
  act.along({{66.0, 62.0}}, 30.0);
  act.wait(0.4);
  act.along({{72.5, 64.0}, {77.3, 66.7}}, 20.0);
  act.wait(0.3);
  act.along({{80.5, 72.0}, {82.0, 78.0}}, 20.0);
  act.wait(0.8);
  act.lift();
  act.close_ring();
  act.tool("pull");
  act.wait(0.4);
  act.gesture({{83.0, 80.0}, {83.6, 76.5}}, 15.0);
  return act.text();
}

/// Returns the act in which a shaking hand draws a circle along a compass, and makes it exact.
std::string guide_act() {
  const Point center{97.5, 30.0};
  DrawingGuide compass;
  compass.kind = DrawingGuideKind::kCompass;
  compass.origin = center;
  DemoAct act;
  act.tool("pencil");
  fine_pencil(act);
  act.add_guide(compass);
  act.shake({0.4, 0.7}, 1.7);
  act.gesture(arc(center, 8.0, 0.75, 0.99, 0.5).via, 20.0);
  act.make_exact();
  act.wait(0.8);
  act.clear_guides();
  return act.text();
}

struct Act {
  const char* name;
  std::string (*script)();
};
constexpr Act kActs[] = {{"1-pencil", pencil_act},
                         {"2-pull", pull_act},
                         {"3-smooth", smooth_act},
                         {"4-width", width_act},
                         {"5-eraser", eraser_act},
                         {"6-lasso", lasso_act},
                         {"7-transform", transform_act},
                         {"8-connect", connect_act},
                         {"9-recolor", recolor_act},
                         {"10-shape", shape_act},
                         {"11-gather", gather_act},
                         {"12-fill", fill_act},
                         {"13-pencil-gestures", gestures_act},
                         {"14-pencil-steady", steady_act},
                         {"15-eraser-press", press_act},
                         {"16-read", read_act},
                         {"17-pencil-ring", ring_act},
                         {"18-pencil-guide", guide_act}};

}  // namespace
}  // namespace felt

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  for (const felt::Act& act : felt::kActs) {
    // N-TOOL or N-TOOL-NAME
    const std::string name = act.name, rest = name.substr(name.find('-') + 1),
                      tool = rest.substr(0, rest.find('-'));
    std::string path = argv[1];
    path.append("/").append(tool).append("/").append(name).append(".ndjson");
    std::ofstream out(path, std::ios::binary);
    out << act.script();
    if (out.flush()) continue;
    std::fprintf(stderr, "%s: cannot write\n", path.c_str());
    return 1;
  }
  return 0;
}
