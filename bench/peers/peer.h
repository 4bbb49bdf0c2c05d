#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/peers/probe.h"
#include "tests/support/fit_checker.h"

namespace felt::bench {

/// The samples that a peer gets.
enum class Feed {
  kRaw,           ///< all of them
  kDeduplicated,  ///< without consecutive repeats, strokes of at least 4 points
};

/// A curve fitter that is measured with one tolerance. Our own fitters are peers, too.
class Peer {
 public:
  virtual ~Peer() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  /// Returns the input of one timed call: "sample" or "stroke".
  [[nodiscard]] virtual std::string call_unit() const = 0;
  [[nodiscard]] virtual Feed feed() const = 0;
  /// Fits one stroke; `probe` times it.
  virtual void fit(const fit_check::Ink& ink, Probe& probe) = 0;
  /// Returns the curve of the last fit, for the checker. Not timed.
  [[nodiscard]] virtual fit_check::FitCurve curve() const = 0;
};

using Peers = std::vector<std::unique_ptr<Peer>>;

/// Returns two peers: lib2geom's recursive fit, and a greedy fit with its one-segment fit.
Peers make_lib2geom_peers(double tolerance);
/// Returns three peers: the scheme of the 2002 paper, our online fit, and our refined fit.
Peers make_feltline_peers(double tolerance);

}  // namespace felt::bench
