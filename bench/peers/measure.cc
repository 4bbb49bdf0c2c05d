#include "bench/peers/measure.h"

namespace felt::bench {
namespace {

const std::vector<fit_check::Ink>& fed(const InkData& data, Feed feed) {
  return feed == Feed::kRaw ? data.raw : data.deduplicated;
}

std::vector<fit_check::FitCurve> curves_of(Peer& peer, const std::vector<fit_check::Ink>& inks) {
  std::vector<fit_check::FitCurve> curves;
  Probe warm_up(Probe::Mode::kTotal);
  for (const fit_check::Ink& ink : inks) {
    peer.fit(ink, warm_up);
    curves.push_back(peer.curve());
    curves.back().id = ink.id;
  }
  return curves;
}

Cost cost_of(Peer& peer, const std::vector<fit_check::Ink>& inks, int repeats) {
  const auto samples = static_cast<double>(sample_count(inks));
  Cost cost{"cpu", peer.call_unit(), 1e300, 0.0, 0.0, 0.0};
  std::vector<float> calls;
  for (int i = 0; i < repeats; ++i) {
    Probe total(Probe::Mode::kTotal), each(Probe::Mode::kEachCall);
    for (const fit_check::Ink& ink : inks) peer.fit(ink, total);
    for (const fit_check::Ink& ink : inks) peer.fit(ink, each);
    cost.per_sample = std::min(cost.per_sample, static_cast<double>(total.total_ns()) / samples);
    cost.allocations_per_sample = static_cast<double>(total.allocations()) / samples;
    keep_smaller(calls, each.calls_ns());
  }
  cost.call_p999 = quantile(calls, 0.999);
  cost.call_max = quantile(calls, 1.0);
  return cost;
}

}  // namespace

double quantile(std::vector<float> values, double fraction) {
  if (values.empty()) return 0.0;
  const double rank = std::ceil(fraction * static_cast<double>(values.size())) - 1.0;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::max(0.0, rank));
  std::nth_element(values.begin(), nth, values.end());
  return static_cast<double>(*nth);
}

void keep_smaller(std::vector<float>& best, const std::vector<float>& values) {
  if (best.empty()) best = values;
  for (std::size_t i = 0; i < best.size() && i < values.size(); ++i) {
    best[i] = std::min(best[i], values[i]);
  }
}

void judge(const std::vector<fit_check::Ink>& inks, const std::vector<fit_check::FitCurve>& curves,
           Row& row) {
  row.by_source.clear();
  row.total = fit_check::check_all(inks, curves, row.tolerance, &row.by_source);
}

Row measure(Peer& peer, const InkData& data, double tolerance, int repeats) {
  const std::vector<fit_check::Ink>& inks = fed(data, peer.feed());
  Row row{peer.name(), tolerance, "", {}, {}, {}};
  judge(inks, curves_of(peer, inks), row);
  row.cost = cost_of(peer, inks, repeats);
  return row;
}

}  // namespace felt::bench
