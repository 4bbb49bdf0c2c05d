#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tests/support/fit_checker.h"

/// The two line formats of the command line contract, read the plain way. Not felt/io: the judge
/// reads for itself. Bad lines throw std::runtime_error with the line number.
namespace fit_check {

/// Raw strokes, one object a line: {"id":"s1","source":"...","points":[[x,y,pressure,t_ms],...]}.
std::vector<Ink> read_inks(std::istream& in, double mm_per_unit);

/// Sketch strokes, one object a line:
/// {"id":"s1","closed":false,"segments":[[x1,y1,..,x4,y4],...],"joints":["smooth","corner",...]}.
/// Lines without "segments" (a header, a comment object) are passed over.
std::vector<FitCurve> read_curves(std::istream& in);

}  // namespace fit_check
