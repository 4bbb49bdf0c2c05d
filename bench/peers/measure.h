#pragma once

#include <map>
#include <optional>
#include <string>

#include "bench/peers/ink_data.h"
#include "bench/peers/peer.h"

namespace felt::bench {

/// What a peer costs. Times in ns.
struct Cost {
  std::string clock;      ///< "cpu" (this thread) or "cpu, process" (node with its helpers)
  std::string call_unit;  ///< what one call takes: "sample" or "stroke"
  double per_sample = 0.0;
  double call_p999 = 0.0, call_max = 0.0;
  std::optional<double> allocations_per_sample;
};

/// One row of the comparison.
struct Row {
  std::string peer;
  double tolerance = 0.0;
  std::string skipped;  ///< why there is no result; empty when there is one
  Cost cost;
  fit_check::Report total;
  std::map<std::string, fit_check::Report> by_source;
};

/// The value that `fraction` of the values do not exceed; 0 of none.
double quantile(std::vector<float> values, double fraction);

/// Element by element the smaller of the two; `best` may be empty.
void keep_smaller(std::vector<float>& best, const std::vector<float>& values);

/// Runs a peer over the data: once for the result, which warms it up, and `repeats` times each for
/// the total and for the single calls. A fitter does the same work each time, so the least of the
/// repeats is its cost; what is above is the machine's.
Row measure(Peer& peer, const InkData& data, double tolerance, int repeats);

/// Judges curves made elsewhere from the deduplicated data.
void judge(const std::vector<fit_check::Ink>& inks, const std::vector<fit_check::FitCurve>& curves,
           Row& row);

/// Where npm packages are run.
struct NpmFolders {
  std::string modules;        ///< holds node_modules; may be empty or not there
  std::string scratch = ".";  ///< for the files that pass to node and back
};

/// The npm package `package` on the deduplicated data, in a node process of its own. Never fails:
/// a row that could not be had says why.
Row measure_npm(const std::string& package, const InkData& data, double tolerance, int repeats,
                const NpmFolders& folders);

}  // namespace felt::bench
