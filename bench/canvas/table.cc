#include "table.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace felt::bench {
namespace {

double us_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void Table::heading(const std::string& text) const {
  if (json_) return;
  std::printf("%s\n%-40s %8s %9s %9s %9s %9s\n", text.c_str(), "", "calls", "p50", "p90", "p99",
              "max");
}

void Table::times(const std::string& what, std::vector<double> us) const {
  if (us.empty()) return;
  std::sort(us.begin(), us.end());
  const auto part = [&us](double p) {
    return us[static_cast<std::size_t>(p * static_cast<double>(us.size() - 1))];
  };
  std::printf(json_ ? "{\"what\":\"%s\",\"calls\":%zu,\"p50_us\":%.1f,\"p90_us\":%.1f,"
                      "\"p99_us\":%.1f,\"max_us\":%.1f}\n"
                    : "%-40s %8zu %9.1f %9.1f %9.1f %9.1f\n",
              what.c_str(), us.size(), part(0.5), part(0.9), part(0.99), us.back());
  std::fflush(stdout);
}

void Table::number(const std::string& what, double value, const std::string& unit) const {
  std::printf(json_ ? "{\"what\":\"%s\",\"value\":%.3f,\"unit\":\"%s\"}\n" : "%-40s %18.2f %s\n",
              what.c_str(), value, unit.c_str());
  std::fflush(stdout);
}

double thread_cpu_us() {
  return us_of(CLOCK_THREAD_CPUTIME_ID);
}
double process_cpu_us() {
  return us_of(CLOCK_PROCESS_CPUTIME_ID);
}
double wall_us() {
  return us_of(CLOCK_MONOTONIC);
}

}  // namespace felt::bench
