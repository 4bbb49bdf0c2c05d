#include <2geom/bezier-utils.h>

#include "bench/peers/peer.h"

namespace felt::bench {
namespace {

constexpr std::size_t kMaxSegments = 4096;

fit_check::Segment segment_of(const Geom::Point* bezier) {
  fit_check::Segment segment;
  for (std::size_t i = 0; i < 4; ++i) segment[i] = {bezier[i].x(), bezier[i].y()};
  return segment;
}

/// Base class of both fitters. The error argument of lib2geom is a squared distance.
class Lib2geomPeer : public Peer {
 public:
  explicit Lib2geomPeer(double tolerance) : error_(tolerance * tolerance) {}

  [[nodiscard]] Feed feed() const override { return Feed::kDeduplicated; }
  [[nodiscard]] fit_check::FitCurve curve() const override {
    fit_check::FitCurve curve;
    for (std::size_t i = 0; i < count_; ++i) curve.segments.push_back(segment_of(&beziers_[4 * i]));
    return curve;
  }
  void fit(const fit_check::Ink& ink, Probe& probe) override {
    points_.clear();
    for (const fit_check::Point& p : ink.samples) points_.emplace_back(p.x, p.y);
    beziers_.resize(4 * kMaxSegments);
    probe.stroke([&] { fit_points(probe); });
  }

 protected:
  virtual void fit_points(Probe& probe) = 0;

  double error_;
  std::vector<Geom::Point> points_;
  std::vector<Geom::Point> beziers_;  // four control points per segment
  std::size_t count_ = 0;
};

class Recursive : public Lib2geomPeer {
 public:
  using Lib2geomPeer::Lib2geomPeer;
  [[nodiscard]] std::string name() const override { return "lib2geom recursive"; }
  [[nodiscard]] std::string call_unit() const override { return "stroke"; }

 private:
  void fit_points(Probe& probe) override {
    probe.call([&] {
      const int count = Geom::bezier_fit_cubic_r(
          beziers_.data(), points_.data(), static_cast<int>(points_.size()), error_, kMaxSegments);
      count_ = static_cast<std::size_t>(std::max(count, 0));
    });
  }
};

/// Adds samples to a run one by one, and refits the run with one segment each time. If that fails,
/// commits the last valid segment and starts the next run. The end tangent of a segment is the
/// start tangent of the next one; lib2geom ignores it if it detects a spike.
class Greedy : public Lib2geomPeer {
 public:
  using Lib2geomPeer::Lib2geomPeer;
  [[nodiscard]] std::string name() const override { return "lib2geom greedy"; }
  [[nodiscard]] std::string call_unit() const override { return "sample"; }

 private:
  inline static const Geom::Point kFree{0.0, 0.0};

  void fit_points(Probe& probe) override {
    count_ = 0;
    first_ = 0;
    tangent_ = kFree;
    for (std::size_t last = 1; last < points_.size(); ++last) {
      probe.call([&] { take(last); });
    }
  }

  void take(std::size_t last) {
    if (fits(last)) return;
    first_ = last - 1;
    const Geom::Point* held = &beziers_[4 * count_];
    tangent_ = Geom::unit_vector(held[3] - held[2]);
    ++count_;
    fits(last);
  }

  /// Fits the run first_..last with one segment. Keeps the previous segment if that fails.
  bool fits(std::size_t last) {
    Geom::Point bezier[4];
    if (Geom::bezier_fit_cubic_full(bezier, nullptr, &points_[first_],
                                    static_cast<int>(last - first_ + 1), tangent_, kFree, error_,
                                    1) != 1) {
      return false;
    }
    std::copy(bezier, bezier + 4, beziers_.begin() + static_cast<std::ptrdiff_t>(4 * count_));
    return true;
  }

 public:
  [[nodiscard]] fit_check::FitCurve curve() const override {
    fit_check::FitCurve curve = Lib2geomPeer::curve();
    curve.segments.push_back(segment_of(&beziers_[4 * count_]));  // the run in progress
    return curve;
  }

 private:
  std::size_t first_ = 0;
  Geom::Point tangent_ = kFree;
};

}  // namespace

Peers make_lib2geom_peers(double tolerance) {
  Peers peers;
  peers.push_back(std::make_unique<Recursive>(tolerance));
  peers.push_back(std::make_unique<Greedy>(tolerance));
  return peers;
}

}  // namespace felt::bench
