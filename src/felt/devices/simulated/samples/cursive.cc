#include <algorithm>
#include <span>

#include "felt/devices/simulated/samples/drawings.h"

namespace felt {
namespace {

// A letter from its join at (0, .2) to the next at (advance, .2). The x-height is 1, y points up,
// and the letter is upright; it is slanted later. A point given twice is a corner.
struct Letter {
  char name;
  double advance;
  std::span<const Point> via;
  std::span<const Point> after;  // cross bar or dot, drawn after the word
};

constexpr Point kE[] = {{.36, .42}, {.60, .78}, {.40, 1.02}, {.17, .68}, {.20, .24}, {.46, -.02}};
constexpr Point kL[] = {{.30, .80},  {.56, 1.65}, {.50, 2.10}, {.34, 2.00},
                        {.25, 1.30}, {.24, .45},  {.44, -.02}};
constexpr Point kF[] = {{.30, .80},  {.58, 1.70},  {.50, 2.12}, {.34, 1.95}, {.26, 1.10}, {.22, .0},
                        {.20, -.75}, {.30, -1.08}, {.44, -.75}, {.36, -.12}, {.42, .02}};
constexpr Point kH[] = {{.30, .80},  {.56, 1.65}, {.50, 2.10}, {.33, 1.95},
                        {.23, 1.10}, {.20, .02},  {.20, .02},  {.28, .55},
                        {.54, .98},  {.74, .76},  {.73, .28},  {.92, -.02}};
constexpr Point kI[] = {{.30, .94}, {.30, .94}, {.25, .48}, {.28, .12}, {.46, -.02}};
constexpr Point kIDot[] = {{.42, 1.52}};
constexpr Point kN[] = {{.14, .76}, {.27, .98}, {.36, .72}, {.34, .02}, {.34, .02},
                        {.42, .55}, {.66, .98}, {.85, .76}, {.84, .28}, {1.02, -.02}};
constexpr Point kO[] = {{.36, .80}, {.52, .99}, {.22, .82},  {.12, .36}, {.36, -.02},
                        {.68, .34}, {.56, .92}, {.50, 1.00}, {.66, .82}, {.95, .92}};
constexpr Point kT[] = {{.28, .78}, {.44, 1.55}, {.44, 1.55}, {.37, .85}, {.34, .25}, {.52, -.02}};
constexpr Point kTBar[] = {{.10, 1.06}, {.42, 1.10}, {.80, 1.16}};

constexpr Letter kLetters[] = {
    {'e', .80, kE, {}}, {'f', .84, kF, {}},  {'h', 1.18, kH, {}}, {'i', .74, kI, kIDot},
    {'l', .72, kL, {}}, {'n', 1.28, kN, {}}, {'o', 1.00, kO, {}}, {'t', .80, kT, kTBar},
};
constexpr double kBlank = 0.75;
constexpr double kSlant = 0.22;
constexpr double kPressure = 0.42;

// Maps letter space to the page.
struct Frame {
  Point at;
  double size_mm;

  Point place(double x, Point p) const {
    return at + Vec{size_mm * (x + p.x + kSlant * p.y), -size_mm * p.y};
  }
};

}  // namespace

std::vector<Gesture> cursive(std::string_view text, Point at, double x_height_mm) {
  const Frame frame{at, x_height_mm};
  std::vector<Gesture> line;
  std::vector<Gesture> later;
  Gesture word{.via = {}, .pressure = kPressure};
  double x = 0.0;
  const auto end_word = [&] {
    if (!word.via.empty()) line.push_back(word);
    line.insert(line.end(), later.begin(), later.end());
    word.via.clear();
    later.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto* letter = std::find_if(std::begin(kLetters), std::end(kLetters),
                                      [c](const Letter& l) { return l.name == c; });
    if (letter == std::end(kLetters)) {
      end_word();
      x += kBlank;
      continue;
    }
    if (word.via.empty()) word.via.push_back(frame.place(x, {-.18, .02}));
    word.via.push_back(frame.place(x, {.0, .2}));
    for (const Point p : letter->via) word.via.push_back(frame.place(x, p));
    if (!letter->after.empty()) {
      Gesture g{.via = {}, .pressure = kPressure, .tempo = 1.3};
      for (const Point p : letter->after) g.via.push_back(frame.place(x, p));
      later.push_back(g);
    }
    x += letter->advance;
    const bool last = i + 1 == text.size() || text[i + 1] == ' ';
    if (last && c != 'o') word.via.push_back(frame.place(x, {.0, .2}));
  }
  end_word();
  return line;
}

}  // namespace felt
