#pragma once

#include <map>
#include <optional>
#include <string>

#include "bench/peers/ink_data.h"
#include "bench/peers/peer.h"

namespace felt::bench {

/// The cost of a peer. Times are in ns.
struct Cost {
  std::string clock;      ///< "cpu" (this thread) or "cpu, process" (node with its helpers)
  std::string call_unit;  ///< the input of one call: "sample" or "stroke"
  double per_sample = 0.0;
  double call_p999 = 0.0, call_max = 0.0;
  std::optional<double> allocations_per_sample;
};

/// One row of the comparison.
struct Row {
  std::string peer;
  double tolerance = 0.0;
  std::string skipped;  ///< why the row has no result; empty if it has one
  Cost cost;
  fit_check::Report total;
  std::map<std::string, fit_check::Report> by_source;
};

/// Returns the value that `fraction` of the values do not exceed, or 0 if `values` is empty.
double quantile(std::vector<float> values, double fraction);

/// Sets each element of `best` to the minimum of the two. `best` may be empty.
void keep_smaller(std::vector<float>& best, const std::vector<float>& values);

/// Runs a peer over the data: once for the result and to warm up, and `repeats` times each for the
/// total and for the single calls. The cost is the minimum of the repeats: a fitter does the same
/// work each time, so any additional time is caused by the machine.
Row measure(Peer& peer, const InkData& data, double tolerance, int repeats);

/// Checks curves that another program has fitted to the deduplicated data.
void judge(const std::vector<fit_check::Ink>& inks, const std::vector<fit_check::FitCurve>& curves,
           Row& row);

/// The folders for running npm packages.
struct NpmFolders {
  std::string modules;        ///< contains node_modules; may be "" or not exist
  std::string scratch = ".";  ///< for the files that are exchanged with node
};

/// Measures the npm package `package` on the deduplicated data, in a separate node process. Never
/// fails: `skipped` of the row says why it has no result.
Row measure_npm(const std::string& package, const InkData& data, double tolerance, int repeats,
                const NpmFolders& folders);

}  // namespace felt::bench
