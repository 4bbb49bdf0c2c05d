#include "felt/motion/ease.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "felt/geometry/cubic.h"

namespace felt {
namespace {

constexpr int kEaseSteps = 256;

struct NamedEase {
  std::string_view name;
  std::array<double, 4> numbers;
};
/// The keywords of CSS Easing Functions Level 1, section 2.2.
constexpr std::array<NamedEase, 5> kNamedEases{{{"linear", {0.0, 0.0, 1.0, 1.0}},
                                                {"ease", {0.25, 0.1, 0.25, 1.0}},
                                                {"ease-in", {0.42, 0.0, 1.0, 1.0}},
                                                {"ease-out", {0.0, 0.0, 0.58, 1.0}},
                                                {"ease-in-out", {0.42, 0.0, 0.58, 1.0}}}};

}  // namespace

Result<Ease> Ease::cubic(double x1, double y1, double x2, double y2) {
  for (const double number : {x1, y1, x2, y2}) {
    if (!(number >= 0.0 && number <= 1.0)) {
      return fail(ErrorCode::kInvalidArgument, "the numbers of an ease must be from 0 to 1");
    }
  }
  return of({x1, y1, x2, y2});
}

Ease Ease::of(const EaseCurve& ease) {
  const Cubic curve{
      {Point{0.0, 0.0}, Point{ease.x1, ease.y1}, Point{ease.x2, ease.y2}, Point{1.0, 1.0}}};
  std::vector<Knot> knots{{0.0, 0.0}};
  for (int i = 1; i < kEaseSteps; ++i) {
    const Point p = evaluate(curve, static_cast<double>(i) / kEaseSteps);
    knots.push_back(
        {std::clamp(p.x, knots.back().time, 1.0), std::clamp(p.y, knots.back().progress, 1.0)});
  }
  knots.push_back({1.0, 1.0});
  return Ease(std::move(knots));
}

Result<Ease> Ease::parse(std::string_view text) {
  for (const NamedEase& named : kNamedEases) {
    const auto& n = named.numbers;
    if (text == named.name) return cubic(n[0], n[1], n[2], n[3]);
  }
  std::array<double, 4> numbers{};
  const char *at = text.data(), *end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) at = nullptr;
    const auto read = at ? std::from_chars(at, end, numbers[i]) : std::from_chars_result{};
    if (!at || read.ec != std::errc() || (i == 3 && read.ptr != end)) {
      return fail(ErrorCode::kInvalidArgument,
                  "'" + std::string(text) + "' is not an ease; use linear, ease, ease-in, " +
                      "ease-out, ease-in-out or four numbers such as 0.4,0,0.6,1");
    }
    at = read.ptr;
  }
  return cubic(numbers[0], numbers[1], numbers[2], numbers[3]);
}

Result<Ease> Ease::drawn(std::span<const Point> line) {
  const bool is_line = line.size() >= 2 && line.front().x != line.back().x &&
                       line.front().y != line.back().y &&
                       std::all_of(line.begin(), line.end(), is_in_range);
  if (!is_line) {
    return fail(ErrorCode::kInvalidData,
                "an ease is a line from one corner of a box to the opposite one");
  }
  const Point start = line.front();
  const Vec size = line.back() - start;
  std::vector<Knot> knots{{0.0, 0.0}};
  for (const Point p : line) {
    knots.push_back({std::clamp((p.x - start.x) / size.x, knots.back().time, 1.0),
                     std::clamp((p.y - start.y) / size.y, knots.back().progress, 1.0)});
  }
  knots.push_back({1.0, 1.0});
  return Ease(std::move(knots));
}

double Ease::at(double time) const noexcept {
  if (!(time > 0.0)) return 0.0;
  if (time >= 1.0) return 1.0;
  const auto next = std::upper_bound(knots_.begin(), knots_.end(), time,
                                     [](double t, const Knot& k) { return t < k.time; });
  const Knot &from = *(next - 1), &to = *next;
  const double share = (time - from.time) / (to.time - from.time);
  // In this form, rounding cannot make it go back.
  return std::min(from.progress + share * (to.progress - from.progress), to.progress);
}

}  // namespace felt
