#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/peers/probe.h"
#include "tests/support/fit_checker.h"

namespace felt::bench {

/// How a peer gets its samples.
enum class Feed {
  kRaw,           ///< all of them
  kDeduplicated,  ///< consecutive repeats removed, strokes of at least 4 points
};

/// A curve fitter under measurement, set to one tolerance. Ours are peers too.
class Peer {
 public:
  virtual ~Peer() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  /// What one timed call is: "sample" or "stroke".
  [[nodiscard]] virtual std::string call_unit() const = 0;
  [[nodiscard]] virtual Feed feed() const = 0;
  /// Fits one stroke, inside `probe`.
  virtual void fit(const fit_check::Ink& ink, Probe& probe) = 0;
  /// The curve of the last fit, for the checker. Not timed.
  [[nodiscard]] virtual fit_check::FitCurve curve() const = 0;
};

using Peers = std::vector<std::unique_ptr<Peer>>;

/// lib2geom's recursive fit, and its one-segment fit driven greedily.
Peers make_lib2geom_peers(double tolerance);
/// The 2002 paper's scheme, ours online, ours refined.
Peers make_feltline_peers(double tolerance);

}  // namespace felt::bench
