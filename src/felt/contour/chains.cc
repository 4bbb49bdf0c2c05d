#include "felt/contour/chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace felt::contour {
namespace {

// From one pixel to the next, a line turns by at most 60 degrees.
constexpr float kMinStraight = 0.5F;
// The ends of a closed line are at most this far apart, and face each other.
constexpr double kClosedPx = 12.0, kFacing = 0.8;
constexpr std::size_t kMinClosedPoints = 30, kEndPoints = 5;
// A neighbour in a direction of at most 45 degrees from that across the line is part of it.
constexpr float kBesideShare = 0.7F;
// Gaps of one pixel are bridged.
constexpr int kReachPx = 2;

cv::Vec2f along(const EdgeMap& map, cv::Point at) {
  const cv::Vec2f across = map.across(at);
  return {-across[1], across[0]};
}

Point position(const EdgeMap& map, cv::Point at) {
  const cv::Vec2f off = map.offset(at) * map.across(at);
  return {static_cast<double>(static_cast<float>(at.x) + off[0]),
          static_cast<double>(static_cast<float>(at.y) + off[1])};
}

/// Returns true if a line goes straight on from its end to its beginning.
bool closes(const std::vector<Point>& line) {
  if (line.size() < kMinClosedPoints) return false;
  const Vec gap = line.front() - line.back();
  const Vec begins = line[kEndPoints] - line.front();
  const Vec ends = line.back() - line[line.size() - 1 - kEndPoints];
  const double gap_px = norm(gap);
  return gap_px <= kClosedPx && dot(gap, begins) >= kFacing * gap_px * norm(begins) &&
         dot(gap, ends) >= kFacing * gap_px * norm(ends);
}

class Linker {
 public:
  explicit Linker(const EdgeMap& map)
      : map_(map), free_(map.level.clone()), inside_(0, 0, map.level.cols, map.level.rows) {}

  std::vector<std::vector<Point>> lines() {
    std::vector<std::vector<Point>> lines;
    for (int row = 0; row < free_.rows; ++row) {
      for (int column = 0; column < free_.cols; ++column) {
        if (free_(row, column) == EdgeMap::kStrong) lines.push_back(line_from({column, row}));
      }
    }
    return lines;
  }

 private:
  std::vector<Point> line_from(cv::Point seed) {
    use(seed);
    std::vector<Point> back = walk(seed, -along(map_, seed));
    std::vector<Point> line(std::make_move_iterator(back.rbegin()),
                            std::make_move_iterator(back.rend()));
    line.push_back(position(map_, seed));
    const std::vector<Point> ahead = walk(seed, along(map_, seed));
    line.insert(line.end(), ahead.begin(), ahead.end());
    if (closes(line)) line.push_back(line.front());
    return line;
  }

  /// Returns the points after a pixel, in a direction.
  std::vector<Point> walk(cv::Point at, cv::Vec2f direction) {
    std::vector<Point> points;
    for (;;) {
      const cv::Point next = next_after(at, direction);
      if (next == at) return points;
      const cv::Vec2f onward = along(map_, next);
      direction = onward.dot(direction) < 0.0F ? -onward : onward;
      at = next;
      use(at);
      points.push_back(position(map_, at));
    }
  }

  /// Returns the free pixel that is nearest to straight on, or the pixel itself.
  [[nodiscard]] cv::Point next_after(cv::Point at, cv::Vec2f direction) const {
    cv::Point best = at;
    float best_worth = 0.0F;
    for (int reach = 1; reach <= kReachPx && best == at; ++reach) {
      for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
          const cv::Point next = at + cv::Point(x, y);
          if (std::max(std::abs(x), std::abs(y)) != reach || !inside_.contains(next)) continue;
          const float worth = free_(next) == EdgeMap::kNone ? 0.0F : worth_of(at, next, direction);
          if (worth <= best_worth) continue;
          best = next;
          best_worth = worth;
        }
      }
    }
    return best;
  }

  [[nodiscard]] float worth_of(cv::Point at, cv::Point next, cv::Vec2f direction) const {
    const Point from = position(map_, at), to = position(map_, next);
    const cv::Vec2f step(static_cast<float>(to.x - from.x), static_cast<float>(to.y - from.y));
    const float length = std::sqrt(step.dot(step));
    if (!(length > 0.0F)) return 0.0F;
    const float straight = step.dot(direction) / length;
    const float parallel = std::fabs(along(map_, next).dot(direction));
    return straight < kMinStraight || parallel < kMinStraight ? 0.0F : straight + parallel;
  }

  /// Marks a pixel as used, and its neighbours on both sides, which are the same line.
  void use(cv::Point at) {
    const cv::Vec2f across = map_.across(at);
    free_(at) = EdgeMap::kNone;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const cv::Point beside = at + cv::Point(x, y);
        const cv::Vec2f step(static_cast<float>(x), static_cast<float>(y));
        const float side = std::fabs(step.dot(across)) / std::max(1.0F, std::sqrt(step.dot(step)));
        if (side >= kBesideShare && inside_.contains(beside)) free_(beside) = EdgeMap::kNone;
      }
    }
  }

  const EdgeMap& map_;
  cv::Mat1b free_;
  cv::Rect inside_;
};

}  // namespace

std::vector<std::vector<Point>> chains_of(const EdgeMap& map) {
  return Linker(map).lines();
}

std::vector<Point> smoothed(const std::vector<Point>& line, double sigma) {
  const auto count = static_cast<std::ptrdiff_t>(line.size());
  if (count < 3) return line;
  const bool is_closed = line.front() == line.back();
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3.0 * sigma));
  std::vector<Point> out(line.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    // At the ends of an open line as many points before as after.
    const std::ptrdiff_t most =
        is_closed ? std::min(reach, (count - 2) / 2) : std::min({reach, i, count - 1 - i});
    const Point& here = line[static_cast<std::size_t>(i)];
    Vec sum;
    double weights = 0.0;
    for (std::ptrdiff_t k = -most; k <= most; ++k) {
      std::ptrdiff_t j = i + k;
      if (is_closed) j = (j + count - 1) % (count - 1);
      const double share = static_cast<double>(k) / sigma, weight = std::exp(-0.5 * share * share);
      sum = sum + weight * (line[static_cast<std::size_t>(j)] - here);
      weights += weight;
    }
    out[static_cast<std::size_t>(i)] = here + (1.0 / weights) * sum;
  }
  if (is_closed) out.back() = out.front();
  return out;
}

}  // namespace felt::contour
