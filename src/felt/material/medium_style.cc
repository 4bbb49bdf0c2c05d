#include "felt/material/medium_style.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

namespace felt {
namespace {

/// Half of the width of a line, in units of a shape.
constexpr double kHalfWidth = 0.5;

/// Returns false if all control points are on one straight line.
bool encloses_area(const std::vector<Point>& contour) {
  constexpr double kFlat = 1e-6;
  const Point from = contour.front();
  const Point far = *std::max_element(contour.begin(), contour.end(), [from](Point a, Point b) {
    return distance(from, a) < distance(from, b);
  });
  return std::any_of(contour.begin(), contour.end(), [&](Point p) {
    return std::fabs(cross(far - from, p - from)) > kFlat * distance(from, far);
  });
}

/// Reads the commands of a shape one after another.
class ShapeReader {
 public:
  explicit ShapeReader(std::string_view text) : text_(text) {}

  Result<StyleShape> read() {
    skip();
    while (at_ < text_.size()) {
      const char letter = text_[at_++];
      const char command = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      if (std::string_view("mlhvcz").find(command) == std::string_view::npos) {
        --at_;
        return problem("expected one of the commands M, L, H, V, C and Z");
      }
      if (!has_begun_ && command != 'm') {
        --at_;
        return problem("the first command must be M");
      }
      is_relative_ = letter == command;
      if (auto ok = carry_out(command); !ok) return tl::unexpected(ok.error());
      skip();
    }
    finish();
    if (shape_.contours.empty()) return problem("the shape has no line or curve");
    if (std::none_of(shape_.contours.begin(), shape_.contours.end(), encloses_area)) {
      return fail(ErrorCode::kInvalidData,
                  "the shape encloses no area, so its lines are invisible");
    }
    return std::move(shape_);
  }

 private:
  tl::unexpected<Error> problem(const std::string& what) const {
    return fail(ErrorCode::kInvalidData, what + " at character " + std::to_string(at_ + 1));
  }

  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == ',')) ++at_;
  }

  [[nodiscard]] bool at_number() const {
    return at_ < text_.size() &&
           std::string_view("+-.0123456789").find(text_[at_]) != std::string_view::npos;
  }

  std::optional<double> number() {
    skip();
    if (text_.substr(at_).starts_with("+-")) return std::nullopt;
    if (at_ < text_.size() && text_[at_] == '+') ++at_;
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  /// Reads the coordinates that are given and takes the others from the current point.
  Result<Point> point(bool has_x, bool has_y) {
    Point p = is_relative_ ? here_ : Point{};
    if (!has_x) p.x = here_.x;
    if (!has_y) p.y = here_.y;
    for (double* to : {has_x ? &p.x : nullptr, has_y ? &p.y : nullptr}) {
      if (!to) continue;
      const std::optional<double> value = number();
      if (!value) return problem("a number is missing");
      *to += *value;
    }
    constexpr double kRounding = 1e-9;
    if (!(p.x >= -kRounding && p.x <= 1.0 + kRounding &&
          std::fabs(p.y) <= kHalfWidth + kRounding)) {
      return problem("x must be 0 to 1 and y -0.5 to 0.5");
    }
    return p;
  }

  Result<void> carry_out(char command) {
    if (command == 'z') {
      finish();
      here_ = begin_;
      return {};
    }
    do {
      const std::size_t count = command == 'c' ? 3 : 1;
      std::array<Point, 3> p{};
      for (std::size_t i = 0; i < count; ++i) {
        const Result<Point> next = point(command != 'v', command != 'h');
        if (!next) return tl::unexpected(next.error());
        p[i] = *next;
      }
      if (command == 'm') {
        finish();
        begin_ = p[0];
        shape_.contours.push_back({begin_});
        is_finished_ = false;
        has_begun_ = true;
        command = 'l';
      } else if (command == 'c') {
        curve(p[0], p[1], p[2]);
      } else {
        curve(lerp(here_, p[0], 1.0 / 3.0), lerp(here_, p[0], 2.0 / 3.0), p[0]);
      }
      here_ = p[count - 1];
      skip();
    } while (at_number());
    return {};
  }

  void curve(Point a, Point b, Point end) {
    if (is_finished_) shape_.contours.push_back({begin_});  // after Z, without M
    is_finished_ = false;
    shape_.contours.back().insert(shape_.contours.back().end(), {a, b, end});
  }

  /// Closes the last contour, or removes it if it is a single point.
  void finish() {
    if (!std::exchange(is_finished_, true) && !shape_.contours.empty()) {
      std::vector<Point>& contour = shape_.contours.back();
      if (contour.back() != begin_) {
        const Point from = contour.back();
        contour.insert(contour.end(),
                       {lerp(from, begin_, 1.0 / 3.0), lerp(from, begin_, 2.0 / 3.0), begin_});
      }
      if (contour.size() < 4) shape_.contours.pop_back();
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  StyleShape shape_;
  Point here_, begin_;
  bool is_relative_ = false;
  bool is_finished_ = true;
  bool has_begun_ = false;
};

}  // namespace

Result<StyleShape> read_style_shape(std::string_view text) {
  if (text.size() > kMaxStyleShapeBytes) {
    return fail(ErrorCode::kLimitExceeded,
                "the shape has more than " + std::to_string(kMaxStyleShapeBytes) + " bytes");
  }
  return ShapeReader(text).read();
}

}  // namespace felt
