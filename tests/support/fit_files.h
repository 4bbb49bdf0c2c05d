#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tests/support/fit_checker.h"

/// Reads the two .ndjson formats of the command line program. Does not use felt/io, because the
/// checker must be independent of the code that it checks. An invalid line throws
/// std::runtime_error with the line number.
namespace fit_check {

/// Reads raw strokes. Each line is one object:
/// {"id":"s1","source":"...","points":[[x,y,pressure,t_ms],...]}.
std::vector<Ink> read_inks(std::istream& in, double mm_per_unit);

/// Reads the strokes of a sketch. Each line is one object:
/// {"id":"s1","closed":false,"segments":[[x1,y1,..,x4,y4],...],"joints":["smooth","corner",...]}.
/// Lines without "segments" (a header, a comment object) are ignored.
std::vector<FitCurve> read_curves(std::istream& in);

}  // namespace fit_check
