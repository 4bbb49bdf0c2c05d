#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

#include "felt/stroke/stroke.h"

namespace felt {
namespace {

/// I5 allows for the rounding of coordinates, so that a 0.05 mm dot is valid anywhere.
constexpr double kLengthSlackMm = 1e-9;

std::string text(double v) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.9g", v);
  return buffer.data();
}

std::string text(std::size_t v) {
  return std::to_string(v);
}

std::string text(Point p) {
  return "(" + text(p.x) + ", " + text(p.y) + ")";
}

tl::unexpected<Error> broken(const char* invariant, std::string what) {
  return fail(ErrorCode::kInvalidData, std::string(invariant) + ": " + std::move(what));
}

/// Returns the direction in which segment i starts: towards its first control point that differs
/// from its start.
Vec direction_out(const StrokeData& d, std::size_t i) {
  const Point* p = &d.points[3 * i];
  for (int k = 1; k < 4; ++k) {
    if (p[k] != p[0]) return p[k] - p[0];
  }
  return {};
}

/// Returns the direction in which segment i ends: from its last control point that differs from its
/// end.
Vec direction_in(const StrokeData& d, std::size_t i) {
  const Point* p = &d.points[3 * i];
  for (int k = 2; k >= 0; --k) {
    if (p[k] != p[3]) return p[3] - p[k];
  }
  return {};
}

/// Returns the angle between two vectors, computed with atan2. Scales them first, so that squares
/// of tiny or huge handles do not under- or overflow.
double angle_deg(Vec a, Vec b) {
  return angle_between(normalized(a), normalized(b)) * (180.0 / std::numbers::pi);
}

/// Returns how far rounding can move a control point near p: half a unit in the last place per
/// coordinate, twice, because a handle is a difference.
double rounding_mm(Point p) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  return 2.0 * kEpsilon * std::max(std::fabs(p.x), std::fabs(p.y));
}

/// Returns the turn in degrees that rounding alone can cause between two handles that meet at p: a
/// few millionths if p is kilometres away, negligible on a normal page.
double rounding_deg(Point p, Vec in, Vec out) {
  const double shortest = std::min(norm(in), norm(out));
  return shortest > 0.0 ? 2.0 * rounding_mm(p) / shortest * (180.0 / std::numbers::pi) : 0.0;
}

Result<void> check_finite(const StrokeData& d) {
  for (std::size_t i = 0; i < d.points.size(); ++i) {
    if (!is_finite(d.points[i])) {
      return broken("I3", "control point " + text(i) + " is not finite: " + text(d.points[i]));
    }
  }
  for (std::size_t i = 0; i < d.widths.size(); ++i) {
    const WidthKnot& knot = d.widths[i];
    if (!std::isfinite(knot.u) || !std::isfinite(knot.width_mm) || !std::isfinite(knot.tone)) {
      return broken("I3", "width breakpoint " + text(i) + " is not finite: u = " + text(knot.u) +
                              ", W = " + text(knot.width_mm) + ", tone = " + text(knot.tone));
    }
  }
  return {};
}

Result<void> check_joined(const StrokeData& d) {
  if (d.points.size() < 4 || d.points.size() % 3 != 1) {
    return broken("I1", text(d.points.size()) +
                            " control points do not make joined cubics, which need 3 n + 1");
  }
  if (d.closed && d.points.front() != d.points.back()) {
    return broken("I1", "a closed stroke must end where it starts, but " + text(d.points.back()) +
                            " is not " + text(d.points.front()));
  }
  return {};
}

Result<void> check_joints(const StrokeData& d, std::size_t n) {
  const std::size_t expected = d.closed ? n : n - 1;
  if (d.joints.size() != expected) {
    return broken("I2", text(d.joints.size()) + " joint kinds for " + text(n) + " segments, " +
                            text(expected) + " expected");
  }
  for (std::size_t i = 0; i < expected; ++i) {
    if (d.joints[i] == JointKind::kCorner) continue;
    if (d.joints[i] != JointKind::kSmooth) {
      return broken("I2", "joint " + text(i + 1) + " must be smooth or a corner");
    }
    const Point at = d.points[3 * (i + 1)];
    const Vec in = direction_in(d, i), out = direction_out(d, (i + 1) % n);
    const double angle = angle_deg(in, out);
    if (!(angle <= kSmoothJointMaxDeg + rounding_deg(at, in, out))) {
      return broken("I2", "smooth joint " + text(i + 1) + " at " + text(at) + " turns by " +
                              text(angle) + " degrees");
    }
  }
  return {};
}

Result<void> check_lengths(const StrokeData& d, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    const Point* p = &d.points[3 * i];
    const double length = control_length(Cubic{{p[0], p[1], p[2], p[3]}});
    if (!(length >= kMinSegmentMm - kLengthSlackMm - 4.0 * rounding_mm(p[0]))) {
      return broken("I5", "segment " + text(i) + " at " + text(p[0]) + " is " + text(length) +
                              " mm long, less than " + text(kMinSegmentMm));
    }
  }
  return {};
}

Result<void> check_widths(const StrokeData& d, std::size_t n) {
  const double end = static_cast<double>(n);
  if (d.widths.size() < 2 || d.widths.front().u != 0.0 || d.widths.back().u != end) {
    return broken("I6", "width breakpoints must cover u = 0 to " + text(n) +
                            (d.widths.empty() ? std::string(", but there are none")
                                              : ", but cover " + text(d.widths.front().u) + " to " +
                                                    text(d.widths.back().u)));
  }
  for (std::size_t i = 0; i < d.widths.size(); ++i) {
    if (i > 0 && !(d.widths[i].u > d.widths[i - 1].u)) {
      return broken("I6", "width breakpoint " + text(i) + " at u = " + text(d.widths[i].u) +
                              " does not come after u = " + text(d.widths[i - 1].u));
    }
    if (!(d.widths[i].width_mm >= kMinWidthMm)) {
      return broken("I4", "width breakpoint " + text(i) + " has W = " + text(d.widths[i].width_mm) +
                              " mm, less than " + text(kMinWidthMm));
    }
    if (!(d.widths[i].tone >= 0.0 && d.widths[i].tone <= 1.0)) {
      return broken("I7", "width breakpoint " + text(i) + " has tone " + text(d.widths[i].tone) +
                              ", which is not from 0 to 1");
    }
  }
  return {};
}

}  // namespace

Result<void> check_invariants(const StrokeData& data) {
  if (auto ok = check_finite(data); !ok) return ok;
  if (auto ok = check_joined(data); !ok) return ok;
  const std::size_t n = data.points.size() / 3;
  if (auto ok = check_lengths(data, n); !ok) return ok;
  if (auto ok = check_joints(data, n); !ok) return ok;
  return check_widths(data, n);
}

}  // namespace felt
