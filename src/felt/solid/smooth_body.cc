#include "felt/solid/smooth_body.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/geometry/triangle_tree.h"
#include "felt/solid/body_boolean.h"
#include "felt/solid/body_parts.h"
#include "felt/solid/line_on_body.h"

namespace felt {
namespace body_smoothing {

/// The smoothing flattens details of up to this share of the width of the stroke, or, if the whole
/// body is smoothed, of the side of a cube with the volume of the body.
constexpr double kReachInWidths = 0.25, kReachInBody = 0.12;
constexpr int kSteps = 3;
/// Cotangents are kept within this range, so that a thin triangle neither pulls nor pushes.
constexpr double kMinCotangent = 0.05, kMaxCotangent = 5.0;
constexpr int kVolumeSteps = 3;

/// Returns how much each point is smoothed: 1 in the middle of the stroke, 0 outside.
std::vector<double> weights_of(const SolidBody& body, const std::vector<LineOnBody>& lines,
                               double width_mm) {
  std::vector<double> weights(body.points.size(), 1.0);
  if (width_mm <= 0.0) return weights;
  const LineSearch search(lines);
  const double radius = 0.5 * width_mm;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double share = std::clamp(
        2.0 * (1.0 - search.nearest(body.points[i], radius).distance_mm / radius), 0.0, 1.0);
    weights[i] = share * share * (3.0 - 2.0 * share);
  }
  return weights;
}

/// The diffusion of a surface: the cotangent weights of its edges, and the system of one step.
class Diffusion {
 public:
  Diffusion(const SolidBody& body, const std::vector<double>& weights);

  /// Moves the points: solves (M + time L) x = M x' with the areas M of the present surface and
  /// the weights L of the first one. Returns false if the system has no solution.
  bool step(SolidBody& body, double time_mm2) const;

 private:
  struct Weight {
    int a, b;
    double value;
  };
  [[nodiscard]] std::vector<double> areas(const SolidBody& body) const;

  const std::vector<double>& weights_;
  std::vector<int> unknowns_;  // the number of a point in the system, or -1 if it stays
  int count_ = 0;
  std::vector<Weight> edges_;
};

Diffusion::Diffusion(const SolidBody& body, const std::vector<double>& weights)
    : weights_(weights), unknowns_(weights.size(), -1) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 1e-3) unknowns_[i] = count_++;
  }
  for (const SolidBody::Triangle& t : body.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& tip = body.points[t[k]];
      const Vec3 u = body.points[t[(k + 1) % 3]] - tip, v = body.points[t[(k + 2) % 3]] - tip;
      const double sine = norm(cross(u, v));
      const double cotangent =
          sine > 0.0 ? std::clamp(dot(u, v) / sine, kMinCotangent, kMaxCotangent) : kMaxCotangent;
      edges_.push_back(
          {static_cast<int>(t[(k + 1) % 3]), static_cast<int>(t[(k + 2) % 3]), 0.5 * cotangent});
    }
  }
}

std::vector<double> Diffusion::areas(const SolidBody& body) const {
  std::vector<double> areas(body.points.size(), 0.0);
  for (const auto& [a, b, c] : body.triangles) {
    const double third =
        norm(cross(body.points[b] - body.points[a], body.points[c] - body.points[a])) / 6.0;
    for (const std::uint32_t i : {a, b, c}) areas[i] += third;
  }
  return areas;
}

bool Diffusion::step(SolidBody& body, double time_mm2) const {
  const std::vector<double> area = areas(body);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count_, 3);
  const auto add = [&](int row, double share, const Vec3& p) {
    right.row(row) += share * Eigen::RowVector3d(p.x, p.y, p.z);
  };
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (unknowns_[i] < 0) continue;
    // Less smoothing is more mass.
    const double mass = area[i] / weights_[i];
    entries.emplace_back(unknowns_[i], unknowns_[i], mass);
    add(unknowns_[i], mass, body.points[i]);
  }
  for (const Weight& edge : edges_) {
    const double pull = time_mm2 * edge.value;
    for (const auto& [from, to] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)}) {
      const int row = unknowns_[static_cast<std::size_t>(from)];
      const int column = unknowns_[static_cast<std::size_t>(to)];
      if (row < 0) continue;
      entries.emplace_back(row, row, pull);
      if (column >= 0) entries.emplace_back(row, column, -pull);
      if (column < 0) add(row, pull, body.points[static_cast<std::size_t>(to)]);
    }
  }
  Eigen::SparseMatrix<double> system(count_, count_);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  if (solver.info() != Eigen::Success) return false;
  const Eigen::MatrixXd moved = solver.solve(right);
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const int row = unknowns_[i];
    if (row >= 0) body.points[i] = {moved(row, 0), moved(row, 1), moved(row, 2)};
  }
  return true;
}

/// Scales a body about its middle until it has this volume.
void scale_to(SolidBody& body, double volume) {
  Vec3 middle{};
  for (const Vec3& p : body.points) middle += (1.0 / static_cast<double>(body.points.size())) * p;
  const double factor = std::cbrt(volume / volume_mm3(body));
  for (Vec3& p : body.points) p = middle + factor * (p - middle);
}

/// Moves the smoothed points along their normals until the body has this volume.
void restore_volume(SolidBody& body, const std::vector<double>& weights, double volume) {
  for (int k = 0; k < kVolumeSteps; ++k) {
    const std::vector<Vec3> normals = point_normals(body);
    SolidBody moved = body;
    const double step_mm = 1e-3 * mean_edge_mm(body);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      moved.points[i] += weights[i] * step_mm * normals[i];
    }
    const double gain = (volume_mm3(moved) - volume_mm3(body)) / step_mm;  // the smoothed area
    if (!(gain > 0.0)) return;
    const double distance = (volume - volume_mm3(body)) / gain;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      body.points[i] += weights[i] * distance * normals[i];
    }
  }
}

}  // namespace body_smoothing

Result<SolidBody> smooth_body(const SolidBody& body, std::span<const Vec3> path, const Vec3& view,
                              double width_mm, double amount) {
  using namespace body_smoothing;
  std::vector<LineOnBody> lines;
  if (width_mm > 0.0) {
    lines = projected_line(body, path, view, 0.25 * width_mm);
    if (lines.empty()) return invalid_data("the stroke does not touch the body");
  }
  const std::vector<double> weights = weights_of(body, lines, width_mm);
  SolidBody smooth = body;
  const double volume = volume_mm3(body);
  const double reach = std::clamp(amount, 0.0, 1.0) *
                       (width_mm > 0.0 ? kReachInWidths * width_mm
                                       : kReachInBody * std::cbrt(std::max(volume, 0.0)));
  const Diffusion diffusion(body, weights);
  for (int step = 0; step < kSteps; ++step) {
    if (!diffusion.step(smooth, 0.5 * reach * reach / kSteps)) {
      return invalid_data("the surface cannot be smoothed there");
    }
  }
  if (width_mm > 0.0) {
    restore_volume(smooth, weights, volume);
  } else {
    scale_to(smooth, volume);
  }
  if (!check_body(smooth, {}) || crosses_itself(smooth)) {
    return invalid_data("the smoothed surface would fold; smooth less at once");
  }
  return smooth;
}

}  // namespace felt
