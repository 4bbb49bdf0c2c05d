#include "bench/peers/peer.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::bench {
namespace {

/// Drives the library's fitter sample by sample, as a drawing session does.
class InkFitterPeer : public Peer {
 public:
  InkFitterPeer(std::string name, const InkFitOptions& options)
      : name_(std::move(name)), fitter_(options) {}

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] std::string call_unit() const override { return "sample"; }
  [[nodiscard]] Feed feed() const override { return Feed::kRaw; }

  void fit(const fit_check::Ink& ink, Probe& probe) override {
    probe.stroke([&] { draw(ink, probe); });
  }

  [[nodiscard]] fit_check::FitCurve curve() const override {
    const FittedCurve& fitted = fitter_.curve();
    fit_check::FitCurve curve;
    for (int i = 0; i < fitted.segment_count(); ++i) {
      const Cubic cubic = fitted.segment(i);
      fit_check::Segment segment;
      for (std::size_t k = 0; k < 4; ++k) segment[k] = {cubic.p[k].x, cubic.p[k].y};
      curve.segments.push_back(segment);
    }
    for (const JointKind kind : fitted.joints) curve.corners.push_back(kind == JointKind::kCorner);
    return curve;
  }

 private:
  void draw(const fit_check::Ink& ink, Probe& probe) {
    fitter_.begin();
    for (const fit_check::Point& p : ink.samples) {
      probe.call([&] { fitter_.push({{p.x, p.y}, {}, {}}); });
    }
    probe.call([&] { fitter_.end(); });
  }

 protected:
  std::string name_;
  InkFitter fitter_;
};

/// Fits online and then refines the curve, as at pen-up. Only the refinement is timed as a single
/// call.
class RefinedPeer : public InkFitterPeer {
 public:
  using InkFitterPeer::InkFitterPeer;
  [[nodiscard]] std::string call_unit() const override { return "stroke"; }

  void fit(const fit_check::Ink& ink, Probe& probe) override {
    probe.stroke([&] {
      fitter_.begin();
      for (const fit_check::Point& p : ink.samples) fitter_.push({{p.x, p.y}, {}, {}});
      fitter_.end();
      probe.call([&] { fitter_.refine(); });
    });
  }
};

}  // namespace

Peers make_feltline_peers(double tolerance) {
  InkFitOptions ours;
  ours.curve.tolerance_mm = tolerance;
  InkFitOptions paper = ours;
  paper.scheme = FitScheme::kPaper2002;
  Peers peers;
  peers.push_back(std::make_unique<InkFitterPeer>("paper 2002", paper));
  peers.push_back(std::make_unique<InkFitterPeer>("feltline online", ours));
  peers.push_back(std::make_unique<RefinedPeer>("feltline refined", ours));
  return peers;
}

}  // namespace felt::bench
