#include "felt/gather/line_sections.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr double kMinPieces = 4.0, kMaxPieces = 4000.0;
constexpr double kMaxCellsPerSide = 1024.0;

std::size_t piece_count(double length_mm, double step_mm) {
  return static_cast<std::size_t>(
      std::clamp(std::ceil(length_mm / step_mm), kMinPieces, kMaxPieces));
}

bool nearer(const SectionHit& a, const SectionHit& b) {
  const double da = std::fabs(a.offset_mm), db = std::fabs(b.offset_mm);
  return da != db ? da < db : a.line != b.line ? a.line < b.line : a.along_mm < b.along_mm;
}

bool same_crossing(const SectionHit& a, const SectionHit& b) {
  return a.line == b.line && a.along_mm == b.along_mm;
}

}  // namespace

/// Half of a section: from its point to one side.
struct LineGrid::Ray {
  std::uint32_t line = 0;
  double along_mm = 0.0;
  Point from;
  Vec direction;  // along the line
  Vec normal;     // to the side of this ray
  double sign = 1.0;
};

LineGrid::LineGrid(std::span<const RoughLine> lines, const SectionOptions& options)
    : options_(options), lines_(lines.size()), lengths_(lines.size(), 0.0) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lengths_[i] = polyline_length(lines[i]);
    if (!(lengths_[i] > 0.0)) continue;
    lines_[i].resize(piece_count(lengths_[i], options_.step_mm) + 1);
    resample(lines[i], lines_[i]);
    for (const Point p : lines_[i]) box_.extend(p);
  }
  fill_cells();
}

int LineGrid::column(double x) const noexcept {
  return static_cast<int>(std::clamp((x - box_.x0) / cell_mm_, 0.0, columns_ - 1.0));
}

int LineGrid::row(double y) const noexcept {
  return static_cast<int>(std::clamp((y - box_.y0) / cell_mm_, 0.0, rows_ - 1.0));
}

template <class Visit>
void LineGrid::cells_of(std::uint32_t line, std::uint32_t index, const Visit& visit) const {
  const Point a = lines_[line][index], b = lines_[line][index + 1];
  const int right = column(std::max(a.x, b.x)), bottom = row(std::max(a.y, b.y));
  for (int r = row(std::min(a.y, b.y)); r <= bottom; ++r) {
    for (int c = column(std::min(a.x, b.x)); c <= right; ++c) visit(r * columns_ + c);
  }
}

// Sorts the pieces of all lines into the cells that their boxes touch, by counting.
void LineGrid::fill_cells() {
  if (box_.empty()) return;
  const double side = std::max(box_.width(), box_.height());
  cell_mm_ = std::max(options_.step_mm, side / kMaxCellsPerSide);
  columns_ = static_cast<int>(box_.width() / cell_mm_) + 1;
  rows_ = static_cast<int>(box_.height() / cell_mm_) + 1;
  begins_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto for_all = [this](const auto& visit) {
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      for (std::uint32_t k = 0; k + 1 < lines_[i].size(); ++k) {
        cells_of(i, k, [&](int cell) { visit(static_cast<std::size_t>(cell), Piece{i, k}); });
      }
    }
  };
  for_all([this](std::size_t cell, Piece) { ++begins_[cell + 1]; });
  for (std::size_t c = 1; c < begins_.size(); ++c) begins_[c] += begins_[c - 1];
  pieces_.resize(begins_.back());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for_all([&](std::size_t cell, Piece piece) { pieces_[next[cell]++] = piece; });
}

LineGrid::Crowd LineGrid::crowd() const noexcept {
  Crowd crowd;
  std::size_t most = 0;
  for (std::size_t c = 0; c + 1 < begins_.size(); ++c) {
    const std::size_t count = begins_[c + 1] - begins_[c];
    crowd.tests += 2 * static_cast<std::uint64_t>(count) * count;
    if (count <= most) continue;
    most = count;
    const Piece piece = pieces_[begins_[c]];
    crowd.densest = lines_[piece.line][piece.index];
  }
  return crowd;
}

void LineGrid::test_cell(const Ray& ray, int cell, std::vector<SectionHit>& hits) const {
  const auto c = static_cast<std::size_t>(cell);
  for (std::uint32_t n = begins_[c]; n < begins_[c + 1]; ++n) {
    const Piece piece = pieces_[n];
    const RoughLine& line = lines_[piece.line];
    const Point a = line[piece.index], b = line[piece.index + 1];
    const double u = dot(a - ray.from, ray.direction), v = dot(b - ray.from, ray.direction);
    if ((u > 0.0) == (v > 0.0)) continue;
    const double t = u / (u - v);
    const double offset = dot(lerp(a, b, t) - ray.from, ray.normal);
    if (offset < 0.0 || offset > options_.reach_mm) continue;
    const double cosine = dot(normalized(b - a), ray.direction);
    if (std::fabs(cosine) < options_.min_cosine) continue;
    const double along =
        lengths_[piece.line] * (piece.index + t) / static_cast<double>(line.size() - 1);
    if (piece.line == ray.line && std::fabs(along - ray.along_mm) < options_.own_mm) continue;
    hits.push_back({piece.line, ray.sign * offset, along, cosine});
  }
}

// Visits the cells on the ray in order (Amanatides, Woo, "A Fast Voxel Traversal Algorithm for Ray
// Tracing", Eurographics 1987, doi:10.2312/egtp.19871000).
void LineGrid::collect(const Ray& ray, std::vector<SectionHit>& hits) const {
  int c = column(ray.from.x), r = row(ray.from.y);
  const int dc = ray.normal.x > 0.0 ? 1 : -1, dr = ray.normal.y > 0.0 ? 1 : -1;
  const double x_edge = box_.x0 + cell_mm_ * (c + (dc > 0 ? 1 : 0));
  const double y_edge = box_.y0 + cell_mm_ * (r + (dr > 0 ? 1 : 0));
  constexpr double kNever = 1e300;
  const double ax = std::fabs(ray.normal.x), ay = std::fabs(ray.normal.y);
  double next_x = ax > 1e-12 ? std::fabs(x_edge - ray.from.x) / ax : kNever;
  double next_y = ay > 1e-12 ? std::fabs(y_edge - ray.from.y) / ay : kNever;
  const double step_x = ax > 1e-12 ? cell_mm_ / ax : kNever;
  const double step_y = ay > 1e-12 ? cell_mm_ / ay : kNever;
  hits.clear();
  for (double at = 0.0; at <= options_.reach_mm && hits.size() < options_.max_hits;) {
    if (c < 0 || c >= columns_ || r < 0 || r >= rows_) break;
    test_cell(ray, r * columns_ + c, hits);
    at = std::min(next_x, next_y);
    if (next_x <= next_y) {
      c += dc;
      next_x += step_x;
    } else {
      r += dr;
      next_y += step_y;
    }
  }
  std::sort(hits.begin(), hits.end(), nearer);
  hits.erase(std::unique(hits.begin(), hits.end(), same_crossing), hits.end());
  // One cell may hold more lines than the rest of the section needs.
  if (hits.size() > options_.max_hits) hits.resize(options_.max_hits);
}

void LineGrid::sections(std::uint32_t i,
                        const std::function<void(const LineSection&)>& visit) const {
  const RoughLine& line = lines_[i];
  if (line.empty()) return;
  const std::size_t n = line.size() - 1;
  std::vector<SectionHit> below, above;
  for (std::size_t k = 0; k < n; ++k) {
    // The direction of three pieces, because single pieces follow the noise of the hand.
    const Vec direction =
        normalized(line[std::min(k + 2, n)] - line[k - std::min<std::size_t>(k, 1)]);
    if (direction == Vec{}) continue;
    LineSection section;
    section.line = i;
    section.along_mm = lengths_[i] * (static_cast<double>(k) + 0.5) / static_cast<double>(n);
    section.point = lerp(line[k], line[k + 1], 0.5);
    section.normal = perp(direction);
    Ray ray{i, section.along_mm, section.point, direction, section.normal, 1.0};
    collect(ray, above);
    ray.normal = -ray.normal;
    ray.sign = -1.0;
    collect(ray, below);
    section.below = below;
    section.above = above;
    visit(section);
  }
}

}  // namespace felt
