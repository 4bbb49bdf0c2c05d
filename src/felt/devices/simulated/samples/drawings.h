#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/writing_hand.h"

namespace felt {

/// Returns a drawing of a cat that sits and looks at you, about 100 x 125 mm. Its top left corner
/// is near (0, 0).
std::vector<Gesture> cat_drawing();

/// Returns a line of joined-up writing. Its base line starts at `at`. Supports the letters e f h i
/// l n o t and the blank; other characters are left out. Cross bars and dots are drawn after their
/// word.
std::vector<Gesture> cursive(std::string_view text, Point at, double x_height_mm);

/// Returns a page of exercises, 170 x 120 mm: lines, waves, loops, a zigzag with 11 corners, a
/// spiral, hatching, swelling strokes, circles, dots.
std::vector<Gesture> exercise_page();

/// Returns `count` strokes for tests and benchmarks: words, doodles with corners, lines, zigzags,
/// loops and spirals, in all sizes, speeds and pressures.
std::vector<Gesture> random_gestures(std::uint64_t seed, std::size_t count);

/// Each of the following functions returns an exercise of one stroke.
Gesture straight_line(Point from, Point to);
Gesture zigzag(Point at, Vec step, int corners);
Gesture loops(Point at, double radius_mm, double advance_mm, int turns);
Gesture spiral(Point center, double radius_mm, int turns);
Gesture wave(Point at, double length_mm, double height_mm, int periods);

}  // namespace felt
