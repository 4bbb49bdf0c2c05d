#include "felt/io/svg/svg_variable_width.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/cubic.h"
#include "felt/io/exact_numbers.h"
#include "felt/io/limits.h"
#include "felt/io/svg/svg_center_line.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_path_parser.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/stroke/edit/mend_joints.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// The widths of a PowerStroke of Inkscape, in user units.
struct SvgPowerKnots {
  std::vector<WidthKnot> widths;   ///< from 0 to the end, linear in between
  std::vector<WidthKnot> written;  ///< the knots as the file has them, sorted by position
  bool is_sampled = false;         ///< `widths` are samples of a curve through the knots
};

/// Reads the widths for a path of `segments` segments. On an open path, the width before the first
/// and after the last knot is that of the nearest knot. On a closed path, the width is interpolated
/// from the last knot to the first, as Inkscape does. Fails if the list of knots is empty.
Result<SvgPowerKnots> svg_power_knots(const SvgVariableWidth& attributes, std::size_t segments,
                                      bool closed);

constexpr std::size_t kMaxKnots = 1'000'000;
constexpr int kSamplesBetweenKnots = 16;

/// Reads knots: "t,w | t,w". w is half the width.
std::vector<WidthKnot> read_knots(std::string_view text, double scale) {
  std::vector<WidthKnot> knots;
  SvgScan scan(text, limits::kMaxSketchNumber);
  while (!scan.at_end() && knots.size() < kMaxKnots) {
    WidthKnot k;
    if (!scan.number(k.u)) break;
    scan.skip_comma();
    if (!scan.number(k.width_mm)) break;
    // Doubling is exact; a scale of 1 changes nothing.
    k.width_mm = 2.0 * std::fabs(k.width_mm) * scale;
    knots.push_back(k);
    while (!scan.empty() && scan.peek() != '|') scan.take(scan.peek());
    scan.take('|');
  }
  std::stable_sort(knots.begin(), knots.end(),
                   [](const WidthKnot& a, const WidthKnot& b) { return a.u < b.u; });
  return knots;
}

/// Adds knots so that they cover all of [0, end].
std::vector<WidthKnot> covering(std::vector<WidthKnot> knots, double end, bool closed,
                                bool zero_begin, bool zero_end) {
  for (WidthKnot& k : knots) k.u = std::clamp(k.u, 0.0, end);
  if (closed) {
    // Interpolate across the start of the path, from the last knot to the first.
    const WidthKnot a = knots.back(), b = knots.front();
    const double gap = end - a.u + b.u;
    const double seam =
        gap > 0.0 ? a.width_mm + (b.width_mm - a.width_mm) * ((end - a.u) / gap) : b.width_mm;
    if (b.u > 0.0) knots.insert(knots.begin(), {0.0, seam});
    if (a.u < end) knots.push_back({end, b.u > 0.0 ? seam : b.width_mm});
  } else {
    if (knots.front().u > 0.0) {
      knots.insert(knots.begin(), {0.0, zero_begin ? 0.0 : knots.front().width_mm});
    }
    if (knots.back().u < end) knots.push_back({end, zero_end ? 0.0 : knots.back().width_mm});
  }
  std::vector<WidthKnot> rising;
  for (const WidthKnot& k : knots) {
    if (rising.empty() || k.u > rising.back().u) rising.push_back(k);
  }
  if (rising.size() == 1) rising.push_back({end, rising.front().width_mm});
  return rising;
}

/// Returns the width curve between knots i and i + 1, as a cubic over position and width.
Cubic width_curve(const std::vector<WidthKnot>& knots, std::size_t i, bool flat, double beta) {
  const auto point = [&](std::size_t k) { return Point{knots[k].u, knots[k].width_mm}; };
  const Point a = point(i), b = point(i + 1);
  if (flat) {
    const Vec handle{beta * (b.x - a.x), 0.0};
    return {{a, a + handle, b - handle, b}};
  }
  const Point before = point(i > 0 ? i - 1 : i);
  const Point after = point(i + 2 < knots.size() ? i + 2 : i + 1);
  return {{a, a + (b - before) / 6.0, b - (after - a) / 6.0, b}};
}

/// Samples a curve through the knots.
std::vector<WidthKnot> sampled(const std::vector<WidthKnot>& knots, bool flat, double beta) {
  std::vector<WidthKnot> widths{knots.front()};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Cubic c = width_curve(knots, i, flat, beta);
    for (int k = 1; k <= kSamplesBetweenKnots; ++k) {
      const Point p = evaluate(c, static_cast<double>(k) / kSamplesBetweenKnots);
      const double end = knots[i + 1].u;
      const double u = k == kSamplesBetweenKnots ? end : std::min(p.x, end);
      if (u > widths.back().u) widths.push_back({u, std::max(0.0, p.y)});
    }
    if (widths.back().u == knots[i + 1].u) widths.back() = knots[i + 1];
  }
  return widths;
}

Result<SvgPowerKnots> svg_power_knots(const SvgVariableWidth& a, std::size_t segments,
                                      bool closed) {
  double scale = 1.0, beta = 0.2;
  // If a value cannot be read, its default stays.
  static_cast<void>(SvgScan(a.scale_width).number(scale));
  static_cast<void>(SvgScan(a.interpolator_beta).number(beta));
  SvgPowerKnots result;
  result.written = read_knots(a.offset_points, scale);
  if (result.written.empty()) return fail(ErrorCode::kInvalidData, "its PowerStroke has no knots");
  const double end = static_cast<double>(segments);
  result.widths =
      covering(result.written, end, closed, a.start_cap == "zerowidth", a.end_cap == "zerowidth");
  if (a.interpolator.empty() || a.interpolator == "Linear") return result;
  if (result.widths.size() * kSamplesBetweenKnots > kMaxKnots) return result;
  result.is_sampled = true;
  result.widths =
      sampled(result.widths, a.interpolator == "CubicBezierJohan", std::clamp(beta, 0.0, 1.0));
  return result;
}

constexpr double kAnyDifference = std::numeric_limits<double>::infinity();

/// Largest difference between our knots and those of the model: positions, and widths in mm.
constexpr double kKnotPlace = 1e-4, kKnotWidthMm = 1.5 / kSvgStepsPerMm;

bool read_joints(std::string_view text, std::vector<JointKind>& joints) {
  SvgScan scan(text);
  while (!scan.at_end()) {
    if (scan.take("smooth")) {
      joints.push_back(JointKind::kSmooth);
    } else if (scan.take("corner")) {
      joints.push_back(JointKind::kCorner);
    } else {
      return false;
    }
  }
  return true;
}

bool read_widths(std::string_view text, std::vector<WidthKnot>& widths) {
  SvgScan scan(text, limits::kMaxSketchNumber);
  while (!scan.at_end()) {
    double u = 0.0, width_mm = 0.0;
    if (!scan.number(u) || !scan.take(',') || !scan.number(width_mm)) return false;
    widths.push_back({u, width_mm});
  }
  return true;
}

/// Reads one tone for each breakpoint. Returns false, and changes nothing, if the number of tones
/// differs or one is invalid.
bool read_tones(std::string_view text, std::vector<WidthKnot>& widths) {
  SvgScan scan(text);
  std::vector<double> tones;
  while (!scan.at_end()) {
    double tone = 0.0;
    if (!scan.number(tone) || !(tone >= 0.0 && tone <= 1.0)) return false;
    if (tones.size() == widths.size()) return false;
    tones.push_back(tone);
  }
  if (tones.size() != widths.size()) return false;
  for (std::size_t i = 0; i < tones.size(); ++i) widths[i].tone = tones[i];
  return true;
}

/// Reads the kinds of the joints: "scs" is smooth, corner, smooth.
bool read_joint_letters(std::string_view text, std::vector<JointKind>& joints) {
  for (const char c : text) {
    if (c != 's' && c != 'c') return false;
    joints.push_back(c == 's' ? JointKind::kSmooth : JointKind::kCorner);
  }
  return true;
}

/// Reads the exact control points of a centre line that was rounded to steps.
bool read_exact_points(std::string_view text, const SvgContour& line, std::vector<Point>& points) {
  // Half a step, and a margin for rounding.
  constexpr double kNearMm = 0.501 / kSvgStepsPerMm;
  // Adding zero turns -0 into 0. The writer used 0, and -0 would be a different guess.
  const auto guess = [](double mm) {
    return std::round(mm * kSvgStepsPerMm) / kSvgStepsPerMm + 0.0;
  };
  const std::size_t count = line.points.size() - (line.closed ? 1 : 0);
  std::vector<double> guesses, values(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    guesses.push_back(guess(line.points[i].x));
    guesses.push_back(guess(line.points[i].y));
  }
  if (!read_exact(text, guesses, kNearMm, values)) return false;
  for (std::size_t i = 0; i < count; ++i) points.push_back({values[2 * i], values[2 * i + 1]});
  if (line.closed) points.push_back(points.front());
  return true;
}

bool read_exact_widths(const SvgVariableWidth& a, double end, std::vector<WidthKnot>& widths) {
  const std::size_t numbers = exact_count(a.widths);
  if (numbers < 2 || numbers % 2 != 0) return false;
  const std::size_t inner = numbers / 2 - 1;
  const std::vector<double> guesses(numbers, kSvgWidthGuess);
  std::vector<double> values(numbers);
  if (!read_exact(a.widths, guesses, kAnyDifference, values)) return false;
  for (std::size_t i = 0; i < inner + 2; ++i) {
    const double u = i == 0 ? 0.0 : i <= inner ? values[i - 1] : end;
    widths.push_back({u, values[inner + i]});
  }
  return true;
}

bool read_exact_tones(std::string_view text, std::vector<WidthKnot>& widths) {
  const std::vector<double> guesses(widths.size(), kSvgWidthGuess);
  std::vector<double> values(widths.size());
  if (!read_exact(text, guesses, kAnyDifference, values)) return false;
  for (const double tone : values) {
    if (!(tone >= 0.0 && tone <= 1.0)) return false;
  }
  for (std::size_t i = 0; i < values.size(); ++i) widths[i].tone = values[i];
  return true;
}

/// Reads the model that version 2 stores next to the centre line, in mm.
std::optional<StrokeData> exact_model(const SvgVariableWidth& a, const SvgContour& line) {
  StrokeData d;
  const std::size_t n = line.segment_count();
  if (!read_joint_letters(a.joints, d.joints) || d.joints.size() != (line.closed ? n : n - 1) ||
      !read_exact_points(a.points, line, d.points) ||
      !read_exact_widths(a, static_cast<double>(n), d.widths)) {
    return std::nullopt;
  }
  d.closed = line.closed;
  return d;
}

/// Reads the model that we stored next to the centre line. Returns nullopt if it no longer fits,
/// because another program changed the line.
std::optional<StrokeData> our_model(const SvgVariableWidth& a, const SvgContour& line) {
  if (!a.points.empty()) return exact_model(a, line);
  StrokeData d;
  const std::size_t n = line.segment_count();
  const bool says_closed = a.closed == "true";
  if ((!says_closed && a.closed != "false") || says_closed != line.closed) return std::nullopt;
  if (!read_joints(a.joints, d.joints) || !read_widths(a.widths, d.widths)) return std::nullopt;
  if (d.joints.size() != (line.closed ? n : n - 1)) return std::nullopt;
  if (d.widths.size() < 2 || d.widths.back().u != static_cast<double>(n)) return std::nullopt;
  d.points = line.points;
  d.closed = line.closed;
  return d;
}

/// Reads a stroke with the effect Pattern Along Path whose centre line another program changed: its
/// widths are those that we stored, stretched over the line. Returns nullopt if there are none.
std::optional<StrokeData> stretched_model(const SvgVariableWidth& a, const SvgContour& line) {
  StrokeData d;
  const auto n = static_cast<double>(line.segment_count());
  const auto stored = static_cast<double>(a.joints.size() + (line.closed ? 0 : 1));
  if (a.points.empty() || !read_exact_widths(a, stored, d.widths)) return std::nullopt;
  for (WidthKnot& knot : d.widths) knot.u *= n / stored;
  d.widths.back().u = n;
  for (std::size_t i = 1; i < d.widths.size(); ++i) {
    if (!(d.widths[i].u > d.widths[i - 1].u)) return std::nullopt;
  }
  d.points = line.points;
  d.closed = line.closed;
  d.joints = svg_joints(d.points, d.closed);
  return d;
}

/// Returns true if the knots of the effect are still those that we wrote. Otherwise another program
/// changed the widths.
bool same_widths(const std::vector<WidthKnot>& ours, const std::vector<WidthKnot>& theirs,
                 bool closed, double near_mm) {
  const std::size_t count = ours.size() - (closed ? 1 : 0);
  if (theirs.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::fabs(ours[i].u - theirs[i].u) > kKnotPlace) return false;
    if (std::fabs(ours[i].width_mm - theirs[i].width_mm) > near_mm + 1e-4 * ours[i].width_mm) {
      return false;
    }
  }
  return true;
}

/// Makes joints smooth again if rounding bent them, or corners if another program bent them.
void mend_joints(StrokeData& d, std::vector<std::string>& notices) {
  if (mend_rounding(d).corners == 0) return;
  notices.emplace_back("has a smooth joint that another program bent; it became a corner");
}

void raise_widths(StrokeData& d, std::vector<std::string>& notices) {
  for (WidthKnot& knot : d.widths) {
    if (knot.width_mm >= kMinWidthMm) continue;
    knot.width_mm = kMinWidthMm;
    notices.emplace_back("is thinner than 0.05 mm and became that wide");
  }
}

/// Moves knots to their positions on the centre line.
std::vector<WidthKnot> moved_knots(const std::vector<WidthKnot>& knots, const SvgCenterLine& line) {
  std::vector<WidthKnot> moved;
  const double end = static_cast<double>(line.segment_count());
  for (const WidthKnot& k : knots) {
    const double u = line.place(k.u);
    if (!moved.empty() && !(u > moved.back().u)) continue;
    if (moved.empty() && u != 0.0) moved.push_back({0.0, k.width_mm, k.tone});
    moved.push_back({u, k.width_mm, k.tone});
  }
  if (moved.empty()) return moved;
  if (moved.back().u != end) moved.push_back({end, knots.back().width_mm, knots.back().tone});
  return moved;
}

/// Joins segments that are too short.
void rejoin(StrokeData& d, std::vector<std::string>& notices) {
  SvgCenterLine line = svg_center_line({d.points, d.closed});
  d.widths = moved_knots(d.widths, line);
  d.points = std::move(line.points);
  d.joints = std::move(line.joints);
  d.closed = line.closed;
  notices.emplace_back("has parts shorter than 0.05 mm, which were joined to their neighbours");
}

void move_to_page(StrokeData& d, const Affine& m, std::vector<std::string>& notices) {
  if (m == Affine{}) return;
  for (Point& p : d.points) p = apply(m, p);
  const double scale = std::sqrt(std::fabs(determinant(m)));
  for (WidthKnot& k : d.widths) k.width_mm *= scale;
  if (!svg_is_similarity(m)) {
    notices.emplace_back("was stretched in one direction; its widths were scaled by the mean");
  }
}

/// Reads the path of a PowerStroke that has widths of another program.
Result<StrokeData> power_stroke(const SvgVariableWidth& a, const SvgContour& line,
                                std::vector<std::string>& notices) {
  if (!a.has_effect) return invalid_data("its centre line was changed by another program");
  Result<SvgPowerKnots> knots = svg_power_knots(a, line.segment_count(), line.closed);
  if (!knots) return tl::unexpected(knots.error());
  if (knots->is_sampled) {
    notices.emplace_back("has widths interpolated by the rule " + std::string(a.interpolator) +
                         ", which were sampled");
  }
  StrokeData d;
  d.points = line.points;
  d.closed = line.closed;
  d.joints = svg_joints(d.points, d.closed);
  d.widths = std::move(knots->widths);
  return d;
}

}  // namespace

bool svg_is_similarity(const Affine& m) noexcept {
  const double x = m.a * m.a + m.b * m.b, y = m.c * m.c + m.d * m.d, xy = m.a * m.c + m.b * m.d;
  const double size = std::max(x, y);
  return size > 0.0 && std::fabs(x - y) <= 1e-9 * size && std::fabs(xy) <= 1e-9 * size;
}

Result<SvgWideStroke> svg_wide_stroke(const SvgVariableWidth& a, const Affine& to_mm) {
  SvgPathData path =
      parse_svg_path(a.center_line, limits::kMaxSvgSegments, limits::kMaxSvgPathNumber);
  if (path.contours.empty()) return invalid_data("it has no centre line");
  if (!path.problem.empty()) return invalid_data("its centre line has an error");
  SvgWideStroke wide;
  if (path.contours.size() > 1) {
    wide.notices.emplace_back("has a centre line of several parts; only the first was read");
  }
  const SvgContour& line = path.contours.front();
  std::optional<StrokeData> d = a.is_ours ? our_model(a, line) : std::nullopt;
  const bool has_tones =
      d && !a.tones.empty() &&
      (a.points.empty() ? read_tones(a.tones, d->widths) : read_exact_tones(a.tones, d->widths));
  if (d && !a.tones.empty() && !has_tones) {
    wide.notices.emplace_back(
        "has invalid tones (one number from 0 to 1 per width is needed); the tones of its widths "
        "were used");
  }
  if (d && a.has_effect) {
    Result<SvgPowerKnots> knots = svg_power_knots(a, line.segment_count(), line.closed);
    if (knots && !same_widths(d->widths, knots->written, line.closed,
                              a.points.empty() ? 1e-4 : kKnotWidthMm)) {
      for (WidthKnot& k : knots->widths) k.tone = tone_at(d->widths, k.u);
      d->widths = std::move(knots->widths);
    }
  }
  if (!d && a.is_ours && a.has_pattern) {
    d = stretched_model(a, line);
    if (d) {
      wide.notices.emplace_back(
          "has a line that another program changed; its widths were stretched over the line");
    }
  }
  if (!d) {
    Result<StrokeData> power = power_stroke(a, line, wide.notices);
    if (!power) return tl::unexpected(power.error());
    d = *std::move(power);
  }
  if (a.is_ours) d->medium = a.medium;
  move_to_page(*d, to_mm, wide.notices);
  wide.data = *std::move(d);
  raise_widths(wide.data, wide.notices);
  if (!has_tones) take_tone_of_width(wide.data.widths);
  if (check_invariants(wide.data)) return wide;
  mend_joints(wide.data, wide.notices);
  if (!check_invariants(wide.data)) rejoin(wide.data, wide.notices);
  if (auto ok = check_invariants(wide.data); !ok) return tl::unexpected(ok.error());
  return wide;
}

}  // namespace felt
