#include "table.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>

namespace felt::bench {
namespace {

double percentile(const std::vector<double>& sorted, double part) {
  if (sorted.empty()) return 0.0;
  const double place = part * static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::lround(place))];
}

std::uint64_t count_now() noexcept {
#if defined(__x86_64__)
  unsigned core = 0;
  return __builtin_ia32_rdtscp(&core);
#else
  return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

// Returns how often the scheduler has preempted this thread.
long switches_now() noexcept {
  rusage usage{};
#if defined(RUSAGE_THREAD)
  getrusage(RUSAGE_THREAD, &usage);
#endif
  return usage.ru_nivcsw;
}

}  // namespace

double thread_cpu_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

Stopwatch::Stopwatch() {
  using Clock = std::chrono::steady_clock;
  const auto wall = Clock::now();
  const std::uint64_t begin = count_now();
  while (Clock::now() - wall < std::chrono::milliseconds(100)) {
  }
  const std::chrono::duration<double, std::nano> spent = Clock::now() - wall;
  ns_per_count_ = spent.count() / static_cast<double>(count_now() - begin);
  std::vector<double> empty(10001);
  for (double& e : empty) {
    const std::uint64_t from = count_now();
    e = static_cast<double>(count_now() - from);
  }
  std::nth_element(empty.begin(), empty.begin() + 5000, empty.end());
  overhead_ = empty[5000];
}

void Stopwatch::start() noexcept {
  switches_ = switches_now();
  started_ = count_now();
}

double Stopwatch::stop() const noexcept {
  const std::uint64_t stopped = count_now();
  if (switches_now() != switches_) return -1.0;
  return std::max(0.0, static_cast<double>(stopped - started_) - overhead_) * ns_per_count_;
}

Table::Table(const char* csv_path) {
  if (csv_path != nullptr) {
    csv_ = std::fopen(csv_path, "w");
    if (csv_ == nullptr) std::perror(csv_path);
  }
  if (csv_ != nullptr) {
    std::fputs(
        "what,segments,calls,preempted,median_ns,mean_ns,p99_ns,p999_ns,max_ns,nodes,pieces,"
        "unproven\n",
        csv_);
  }
  std::printf("%-34s %8s %9s %8s %8s %8s %9s %6s %6s %6s %9s\n", "times in ns", "segments",
              "median", "mean", "p99", "p99.9", "max", "preem.", "nodes", "pieces", "unproven");
}

Table::~Table() {
  if (csv_ != nullptr) std::fclose(csv_);
}

void Table::add(Row row) {
  const std::size_t calls = row.ns.size();
  std::erase_if(row.ns, [](double ns) { return ns < 0.0; });
  const std::size_t preempted = calls - row.ns.size();
  std::sort(row.ns.begin(), row.ns.end());
  const double mean = std::accumulate(row.ns.begin(), row.ns.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(row.ns.size(), 1));
  const double median = percentile(row.ns, 0.5), p99 = percentile(row.ns, 0.99);
  const double p999 = percentile(row.ns, 0.999), max = percentile(row.ns, 1.0);
  std::printf("%-34s %8zu %9.0f %8.0f %8.0f %8.0f %9.0f %6zu %6.1f %6.1f %8.2f%%\n",
              row.what.c_str(), row.segments, median, mean, p99, p999, max, preempted, row.nodes,
              row.pieces, 100.0 * row.unproven);
  std::fflush(stdout);
  if (csv_ == nullptr) return;
  std::fprintf(csv_, "%s,%zu,%zu,%zu,%.1f,%.1f,%.1f,%.1f,%.1f,%.3f,%.3f,%.5f\n", row.what.c_str(),
               row.segments, calls, preempted, median, mean, p99, p999, max, row.nodes, row.pieces,
               row.unproven);
}

void Table::note(const std::string& text) {
  std::printf("%s\n", text.c_str());
}

}  // namespace felt::bench
