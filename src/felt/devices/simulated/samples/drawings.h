#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/writing_hand.h"

namespace felt {

/// Returns a cat that sits and looks at you, about 100 x 125 mm, with its top left corner near (0,
/// 0).
std::vector<Gesture> cat_drawing();

/// Returns a line of joined-up writing, with its base line starting at `at`. Supports the letters e
/// f h i l n o t and the blank; others are left out. Crosses and dots follow their word.
std::vector<Gesture> cursive(std::string_view text, Point at, double x_height_mm);

/// Returns a page of exercises, 170 x 120 mm: lines, waves, loops, a zigzag with 11 corners, a
/// spiral, hatching, swelling strokes, circles, dots.
std::vector<Gesture> exercise_page();

/// Returns `count` strokes: words, doodles with corners, lines, zigzags, loops, spirals of all
/// sizes, speeds and pressures. For tests and benchmarks.
std::vector<Gesture> random_gestures(std::uint64_t seed, std::size_t count);

/// Single exercises, each one stroke.
Gesture straight_line(Point from, Point to);
Gesture zigzag(Point at, Vec step, int corners);
Gesture loops(Point at, double radius_mm, double advance_mm, int turns);
Gesture spiral(Point center, double radius_mm, int turns);
Gesture wave(Point at, double length_mm, double height_mm, int periods);

}  // namespace felt
