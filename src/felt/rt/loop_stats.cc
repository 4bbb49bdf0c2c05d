#include "felt/rt/loop_stats.h"

#include <array>
#include <cstdio>

namespace felt {
namespace {

/// Returns a text such as "p50 12.0, p99 34.0, p99.9 282.0, max 684.0 us".
std::string percentiles(const TimeHistogram& times) {
  const auto us = [&](double q) { return 1e-3 * static_cast<double>(times.percentile_ns(q)); };
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "p50 %.1f, p99 %.1f, p99.9 %.1f, max %.1f us", us(0.5),
                us(0.99), us(0.999), 1e-3 * static_cast<double>(times.max_ns()));
  return text.data();
}

}  // namespace

std::string describe(const LoopStats& stats) {
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "%llu ticks at %.1f Hz, %llu missed",
                static_cast<unsigned long long>(stats.ticks()), stats.rate_hz(),
                static_cast<unsigned long long>(stats.missed()));
  std::string line = text.data();
  line += "; late by " + percentiles(stats.lateness());
  if (stats.cpu().count() > 0) line += "; CPU " + percentiles(stats.cpu());
  return line;
}

}  // namespace felt
