#include "tests/support/fit_curve_pieces.h"

namespace fit_check {
namespace {

constexpr double kSagInTolerances = 0.0005;
constexpr double kStepInTolerances = 0.25;
constexpr double kMinPieces = 8.0;
constexpr double kMaxPieces = 4096.0;

/// Returns the largest |f''| on the segment. f'' is linear in t, so |f''| is largest at an end.
double largest_second_derivative(const Segment& b) {
  return 6.0 * std::max(length(b[2] - 2.0 * b[1] + b[0]), length(b[3] - 2.0 * b[2] + b[1]));
}

/// Returns the largest possible distance between the curve and a chord of parameter width dt:
/// dt^2 / 8 max |f''|.
double sag_of(double second_derivative, double dt) {
  return dt * dt / 8.0 * second_derivative;
}

int piece_count(const Segment& b, double tolerance) {
  const double by_sag =
      std::sqrt(largest_second_derivative(b) / (8.0 * kSagInTolerances * tolerance));
  const double by_step = (length(b[1] - b[0]) + length(b[2] - b[1]) + length(b[3] - b[2])) /
                         (kStepInTolerances * tolerance);
  return static_cast<int>(std::clamp(std::ceil(std::max(by_sag, by_step)), kMinPieces, kMaxPieces));
}

std::vector<Piece> cut(const std::vector<Segment>& segments, double tolerance) {
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Segment& b = segments[s];
    const int count = piece_count(b, tolerance);
    const double sag = sag_of(largest_second_derivative(b), 1.0 / count);
    Point last = b[0];
    for (int i = 0; i < count; ++i) {
      const double t0 = static_cast<double>(i) / count, t1 = (i + 1.0) / count;
      const Point next = at(b, t1);
      pieces.push_back({s, t0, t1, last, next, sag});
      last = next;
    }
  }
  return pieces;
}

std::vector<Box> boxes_of(const std::vector<Piece>& pieces) {
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (const Piece& piece : pieces) boxes.push_back(box_of_line(piece.a, piece.b, piece.sag));
  return boxes;
}

/// Returns the smallest distance from p to the segment on [low, high]. Assumes that the distance
/// has only one minimum there.
double golden_section(const Segment& segment, double low, double high, Point p) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kRounds = 40;  // reduces the interval to 4e-9 of its width
  const auto squared = [&](double t) {
    const Point d = at(segment, t) - p;
    return dot(d, d);
  };
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double at_left = squared(left), at_right = squared(right);
  for (int i = 0; i < kRounds; ++i) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = squared(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = squared(right);
    }
  }
  return std::sqrt(std::min(at_left, at_right));
}

}  // namespace

CurvePieces::CurvePieces(const std::vector<Segment>& segments, double tolerance)
    : segments_(&segments), pieces_(cut(segments, tolerance)), tree_(boxes_of(pieces_)) {}

double CurvePieces::distance_to_piece(const Piece& piece, Point p, double bound) const {
  if (distance_to_line(piece.a, piece.b, p) - piece.sag > bound) return bound;
  const double inside = golden_section((*segments_)[piece.segment], piece.t0, piece.t1, p);
  return std::min({bound, inside, length(piece.a - p), length(piece.b - p)});
}

double CurvePieces::distance(Point p, std::size_t& hint) const {
  double best = std::numeric_limits<double>::infinity();
  if (pieces_.empty()) return best;
  best = distance_to_piece(pieces_[std::min(hint, pieces_.size() - 1)], p, best);
  tree_.search(p, best, [&](std::size_t i) {
    const double d = distance_to_piece(pieces_[i], p, best);
    if (d < best) {
      best = d;
      hint = i;
    }
    return best;
  });
  return best;
}

}  // namespace fit_check
