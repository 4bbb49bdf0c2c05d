#include "felt/devices/simulated/samples/drawings.h"

namespace felt {
namespace {

using Via = std::vector<Point>;

Gesture contour(Via via, double pressure = 0.55) {
  return {.via = std::move(via), .pressure = pressure, .end_pressure = 0.3};
}

// Returns a quick, light, tapering stroke for fur and whiskers.
Gesture flick(Via via, double pressure = 0.35) {
  return {.via = std::move(via), .pressure = pressure, .tempo = 1.7, .end_pressure = 0.08};
}

void add_head(std::vector<Gesture>& cat) {
  cat.push_back(contour({{41, 34}, {38.5, 25}, {37.5, 14}, {37.5, 14}, {44.5, 18.5}, {51, 25}}));
  cat.push_back(contour({{50.5, 25.2}, {56, 24}, {62, 24}, {67.5, 25.4}}));
  cat.push_back(
      contour({{67, 25.2}, {73.5, 18.5}, {80.5, 14}, {80.5, 14}, {79.8, 25}, {77.2, 34}}));
  cat.push_back(contour({{41, 33}, {37.6, 40}, {37.4, 47}, {41.5, 54.5}, {49, 59.6}, {57, 61.4}}));
  cat.push_back(contour(
      {{77, 33}, {80.6, 40}, {80.8, 47}, {76.8, 54.5}, {69.4, 59.6}, {61, 61.6}, {56, 61.4}}));
  // Inner ears.
  cat.push_back(flick({{42.5, 29}, {40.8, 24}, {40.4, 18.6}, {44, 21.6}, {46.6, 25}}));
  cat.push_back(flick({{75.6, 29}, {77.4, 24}, {77.8, 18.6}, {74.2, 21.6}, {71.6, 25}}));
  // Tabby marks.
  cat.push_back(flick({{59.2, 25}, {59, 29}, {59.2, 33.4}}, 0.6));
  cat.push_back(flick({{55, 25.6}, {55.2, 29}, {56, 32}}, 0.5));
  cat.push_back(flick({{63.4, 25.6}, {63.2, 29}, {62.4, 32}}, 0.5));
  cat.push_back(flick({{38.4, 43}, {41.4, 43.6}, {44, 45}}, 0.45));
  cat.push_back(flick({{38.6, 47.4}, {41.4, 47.2}, {43.8, 47.8}}, 0.45));
  cat.push_back(flick({{80, 43}, {77, 43.6}, {74.4, 45}}, 0.45));
  cat.push_back(flick({{79.8, 47.4}, {77, 47.2}, {74.6, 47.8}}, 0.45));
}

void add_eye(std::vector<Gesture>& cat, double x, double side) {
  const auto at = [=](double dx, double y) { return Point{x + side * dx, y}; };
  cat.push_back(contour({at(4.6, 42.6), at(2.4, 39.2), at(-1.0, 38.4), at(-4.4, 42.6)}, 0.75));
  cat.push_back(contour({at(-4.2, 42.6), at(-1.4, 45.0), at(1.8, 45.0), at(4.4, 42.6)}, 0.4));
  // Pupil: three strokes, darkest in the middle.
  cat.push_back(contour({at(-0.9, 40.0), at(-1.1, 41.8), at(-0.7, 43.8)}, 0.8));
  cat.push_back(contour({at(0.1, 39.2), at(0.2, 41.6), at(0.1, 44.6)}, 1.0));
  cat.push_back(contour({at(1.0, 40.4), at(1.2, 42.0), at(0.9, 43.8)}, 0.8));
}

void add_face(std::vector<Gesture>& cat) {
  add_eye(cat, 50.2, -1.0);
  add_eye(cat, 68.2, 1.0);
  cat.push_back(contour({{57.0, 48.4},
                         {59.2, 47.9},
                         {61.4, 48.4},
                         {61.4, 48.4},
                         {59.2, 51.0},
                         {59.2, 51.0},
                         {57.0, 48.5}},
                        0.6));
  cat.push_back(contour({{58.0, 48.9}, {60.6, 48.8}, {60.6, 48.8}, {59.2, 50.0}}, 0.7));
  cat.push_back(
      contour({{59.2, 51.0}, {59.2, 53.4}, {57.4, 55.4}, {54.8, 55.0}, {53.6, 53.6}}, 0.45));
  cat.push_back(contour({{59.2, 53.2}, {60.8, 55.4}, {63.6, 55.0}, {64.8, 53.6}}, 0.45));
  // Whiskers, from the cheeks outwards.
  cat.push_back(flick({{52, 50.4}, {42, 48.2}, {29, 48.4}}));
  cat.push_back(flick({{52, 51.8}, {41.6, 51.8}, {28.4, 54.4}}));
  cat.push_back(flick({{52.4, 53.2}, {43, 55.4}, {31.6, 60.2}}));
  cat.push_back(flick({{66.4, 50.4}, {76.4, 48.2}, {89.6, 48}}));
  cat.push_back(flick({{66.4, 51.8}, {77, 51.8}, {90.4, 54}}));
  cat.push_back(flick({{66, 53.2}, {75.4, 55.4}, {86.8, 60}}));
}

void add_body(std::vector<Gesture>& cat) {
  // Left flank and foreleg, then the right flank with the back.
  cat.push_back(
      contour({{45.6, 58.6}, {42.6, 68}, {41.6, 80}, {43.4, 93}, {46, 104}, {46.6, 114}}));
  cat.push_back(
      contour({{73.6, 58}, {79.4, 67}, {85.4, 79}, {89.6, 93}, {90.4, 105}, {86.6, 114.6}}));
  // Forelegs and paws.
  cat.push_back(contour({{58.4, 88}, {57.8, 98}, {57.6, 108}, {57.8, 114}}, 0.5));
  cat.push_back(contour(
      {{46.6, 113.6}, {43.8, 117.4}, {46.8, 120.4}, {53, 120.6}, {57.6, 119}, {57.8, 114}}));
  cat.push_back(contour({{60.4, 90}, {60.6, 100}, {60.4, 108}, {60.2, 114}}, 0.5));
  cat.push_back(
      contour({{60.2, 114}, {60.4, 119}, {65, 120.7}, {71, 120.3}, {73.6, 117}, {71.2, 113.6}}));
  cat.push_back(contour({{71.2, 113.8}, {71.4, 106}, {72.6, 97}}, 0.5));
  for (const double x : {49.0, 53.2, 63.8, 68.0}) {
    cat.push_back(flick({{x, 116.6}, {x - 0.3, 118.4}, {x, 120.2}}, 0.5));
  }
  // Haunch and hind paw.
  cat.push_back(contour({{73.4, 112}, {72.6, 104}, {75.6, 96.4}, {81.4, 94.4}}, 0.45));
  cat.push_back(
      contour({{74, 116.6}, {79.2, 115.2}, {83.4, 117}, {83, 120}, {78.4, 120.8}, {73, 120.2}}));
  // Shade below the chin.
  for (int i = 0; i < 6; ++i) {
    const Point p{62.6 + 1.7 * i, 63.2 - 0.45 * i};
    cat.push_back(flick({p, p + Vec{-0.9, 2.0}, p + Vec{-2.2, 4.2 - 0.3 * i}}, 0.3));
  }
  // Chest fur.
  cat.push_back(flick({{52, 64.4}, {53.4, 69}, {53.6, 69.6}, {53.6, 69.6}, {55.6, 66.6}}, 0.45));
  cat.push_back(flick({{56.2, 66.2}, {57.8, 71.4}, {59, 74.4}, {59, 74.4}, {60.4, 70}}, 0.5));
  cat.push_back(flick({{62.4, 67.4}, {63.2, 71.4}, {63.2, 71.4}, {66.0, 66.6}}, 0.45));
  cat.push_back(flick({{56.6, 78}, {58.4, 81.6}, {59.4, 84}}, 0.35));
  cat.push_back(flick({{63.2, 76.6}, {62.2, 80}, {60.8, 83}}, 0.35));
  // Stripes on the back.
  for (int i = 0; i < 4; ++i) {
    const Point p{82.2 + 2.6 * i - 0.25 * i * i, 73.0 + 7.0 * i};
    cat.push_back(flick({p, p + Vec{-3.2, 0.6}, p + Vec{-6.4 - 0.5 * i, 2.6}}, 0.7));
  }
}

void add_tail(std::vector<Gesture>& cat) {
  cat.push_back(contour({{88.6, 113},
                         {97, 117.4},
                         {107, 115.6},
                         {113, 107},
                         {111.4, 97.4},
                         {106.4, 90.4},
                         {108.4, 83.6},
                         {112.6, 82.4}},
                        0.6));
  cat.push_back(contour({{112.4, 82.2},
                         {114.4, 83.8},
                         {112.6, 87.6},
                         {113.2, 92.4},
                         {118, 100.4},
                         {118.2, 110.6},
                         {111.6, 119},
                         {100, 122},
                         {88, 120.2},
                         {83.6, 118.8}},
                        0.6));
  cat.push_back(flick({{112.6, 107}, {115.4, 107.4}, {118, 109}}, 0.6));
  cat.push_back(flick({{111.6, 99}, {114.2, 98.4}, {117, 98.6}}, 0.6));
  cat.push_back(flick({{107.6, 115}, {109.2, 117.2}, {110.4, 119.4}}, 0.6));
  cat.push_back(flick({{100, 117.2}, {100.4, 119.6}, {100, 121.8}}, 0.6));
}

void add_ground(std::vector<Gesture>& cat) {
  cat.push_back(flick({{26, 121.6}, {34, 121}, {42.6, 121.4}}, 0.4));
  cat.push_back(flick({{46, 123.2}, {56, 124.0}, {68, 123.4}, {80, 123.8}}, 0.45));
  for (int i = 0; i < 9; ++i) {
    const double x = 86.0 + 4.0 * i;
    cat.push_back(flick({{x + 3.0, 123.0}, {x, 125.0}, {x - 3.4, 127.6}}, 0.3));
  }
}

}  // namespace

std::vector<Gesture> cat_drawing() {
  std::vector<Gesture> cat;
  add_head(cat);
  add_face(cat);
  add_body(cat);
  add_tail(cat);
  add_ground(cat);
  return cat;
}

}  // namespace felt
