// device_fuzz [--bench NAME] [--seeds N] [--seed FIRST] [--limits] [--bad NAME] [--all] [--trace]
// device_fuzz --list
//
// Runs N cases, with seeds from FIRST on, for the driver NAME or for every driver. Each case is a
// fault of docs/design/devices.md#faults in a fake (fault_case.h, fault_episode.h). With --limits,
// a case is a random sequence of calls that try to exceed the force limits (limits_fuzz.h). Prints
// a summary if no rule was broken. Otherwise prints the broken rule and the command that repeats
// the case, and exits with 1. --all continues after a broken rule and counts the broken rules.
// --bad uses the reference bench with a driver that is bad on purpose and must break a rule.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <string>

#include "tests/devices/drivers/fault_episode.h"
#include "tests/devices/drivers/limits_fuzz.h"
#include "tests/devices/drivers/scripted_bench.h"
#include "tests/support/last_words.h"

namespace felt {
namespace {

constexpr unsigned kHangsAfterS = 120;

struct Options {
  std::uint64_t seeds = 1000;
  std::uint64_t seed = 1;
  std::string bench;
  std::string bad;
  bool limits = false;
  bool all = false;
  bool trace = false;
};

void watch(const Options& options, std::string_view bench, std::uint64_t seed) {
  std::string repeat = "repeat: device_fuzz --bench " + std::string(bench);
  if (!options.bad.empty()) repeat += " --bad " + options.bad;
  if (options.limits) repeat += " --limits";
  last_words::watch(repeat + " --seeds 1 --seed " + std::to_string(seed) + "\n", kHangsAfterS);
}

struct Totals {
  std::uint64_t cases = 0, ticks = 0, broken = 0;
  std::uint64_t with_force = 0;   // cases that held a force when the fault happened
  std::uint64_t reconnected = 0;  // cases that reopened the device
  std::uint64_t engaged = 0;      // cases that held a force again at the end
  double largest_n = 0.0;
  std::map<std::string, std::uint64_t, std::less<>> kinds;
  std::map<std::string, double, std::less<>> slowest_ms;  // until the force was zero, by kind
  std::uint64_t digest = 0xcbf29ce484222325ULL;

  void add(std::uint64_t other) { digest = (digest ^ other) * 0x100000001b3ULL; }
};

BadDriver bad_by_name(const std::string& name) {
  for (const BadDriverName& bad : bad_drivers()) {
    if (bad.name == name) return bad.bad;
  }
  return BadDriver::kNone;
}

BenchMaker maker_of(const Options& options, std::string_view bench) {
  const BadDriver bad = bad_by_name(options.bad);
  if (bad != BadDriver::kNone) {
    return
        [bad](std::vector<FaultWindow> faults) { return make_bad_bench(bad, std::move(faults)); };
  }
  return [bench](std::vector<FaultWindow> faults) {
    return make_driver_bench(bench, std::move(faults));
  };
}

class Fuzz {
 public:
  Fuzz(const Options& options, std::string_view bench)
      : options_(options), bench_(bench), make_(maker_of(options, bench)) {}

  /// Returns false if a rule was broken.
  bool run() {
    const auto shown = make_({});
    if (!shown || shown->device() == nullptr) {
      std::printf("broken rule: %s cannot be opened\n", name().c_str());
      return false;
    }
    for (std::uint64_t k = 0; k < options_.seeds; ++k) {
      const std::uint64_t seed = options_.seed + k;
      watch(options_, bench_, seed);
      const std::string said = options_.limits ? limits(seed) : fault(*shown, seed);
      ++totals_.cases;
      if (said.empty()) continue;
      ++totals_.broken;
      std::printf("broken rule: %s\n%s", said.c_str(), std::string(last_words::repeat()).c_str());
      if (!options_.all) return false;
    }
    alarm(0);
    return print();
  }

 private:
  [[nodiscard]] std::string name() const { return std::string(bench_); }

  std::string fault(DriverBench& shown, std::uint64_t seed) {
    const FaultCase fault = make_fault_case(shown, seed);
    if (options_.trace)
      std::fprintf(stderr, "%llu: %s\n", static_cast<unsigned long long>(seed),
                   text_of(fault).c_str());
    const FaultVerdict verdict = FaultEpisode(make_, fault).run();
    const std::string kind(kind_of(fault));
    ++totals_.kinds[kind];
    totals_.ticks += verdict.ticks;
    totals_.with_force += verdict.force_before_n > 0.02 ? 1 : 0;
    totals_.reconnected += verdict.reconnected ? 1 : 0;
    totals_.engaged += verdict.force_after_n > 0.02 ? 1 : 0;
    totals_.largest_n = std::max(totals_.largest_n, verdict.force_before_n);
    if (verdict.zero_after_ns) {
      double& slowest = totals_.slowest_ms[kind];
      slowest = std::max(slowest, 1e-6 * static_cast<double>(*verdict.zero_after_ns));
    }
    totals_.add(verdict.digest);
    return verdict.broken.empty() ? "" : verdict.broken + "\n  case: " + text_of(fault);
  }

  std::string limits(std::uint64_t seed) {
    const LimitsVerdict verdict = fuzz_limits(make_, seed);
    totals_.ticks += verdict.calls;
    totals_.largest_n = std::max(totals_.largest_n, verdict.largest_n);
    totals_.add(verdict.digest);
    return verdict.broken;
  }

  bool print() const {
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    if (options_.limits) {
      std::printf("%s: %llu sequences, %llu calls, %.4g N asked at most, digest %016llx\n",
                  name().c_str(), number(totals_.cases), number(totals_.ticks), totals_.largest_n,
                  number(totals_.digest));
      return totals_.broken == 0;
    }
    std::printf(
        "%s: %llu cases, %llu ticks; a force was held in %llu of them, %llu reconnected, "
        "a force again in %llu; digest %016llx\n",
        name().c_str(), number(totals_.cases), number(totals_.ticks), number(totals_.with_force),
        number(totals_.reconnected), number(totals_.engaged), number(totals_.digest));
    for (const auto& [kind, count] : totals_.kinds) {
      std::printf("  %-16s %7llu cases", kind.c_str(), number(count));
      const auto slowest = totals_.slowest_ms.find(kind);
      if (slowest == totals_.slowest_ms.end()) {
        std::printf("\n");
      } else if (slowest->second == 0.0) {
        std::printf(", no force in the same tick\n");
      } else {
        std::printf(", no force after %.2f ms at most\n", slowest->second);
      }
    }
    if (totals_.cases >= 400 && totals_.with_force < totals_.cases / 4) {
      std::printf("broken rule: forces are there to be taken away\n");
      return false;
    }
    if (totals_.cases >= 400 && totals_.engaged < totals_.with_force) {
      std::printf("broken rule: forces come back\n");
      return false;
    }
    if (totals_.broken > 0) std::printf("%llu cases broke a rule\n", number(totals_.broken));
    return totals_.broken == 0;
  }

  const Options& options_;
  std::string_view bench_;
  BenchMaker make_;
  Totals totals_;
};

bool take_flag(const char* word, Options& options) {
  if (std::strcmp(word, "--limits") == 0) return options.limits = true;
  if (std::strcmp(word, "--all") == 0) return options.all = true;
  if (std::strcmp(word, "--trace") == 0) return options.trace = true;
  return false;
}

bool take_value(const char* word, const char* value, Options& options) {
  if (std::strcmp(word, "--bench") == 0) return options.bench = value, true;
  if (std::strcmp(word, "--bad") == 0) {
    options.bad = value;
    options.bench = "scripted";
    return bad_by_name(value) != BadDriver::kNone;
  }
  char* end = nullptr;
  const std::uint64_t number = std::strtoull(value, &end, 10);
  if (*end != '\0' || end == value) return false;
  if (std::strcmp(word, "--seeds") == 0) return options.seeds = number, true;
  if (std::strcmp(word, "--seed") == 0) return options.seed = number, true;
  return false;
}

std::optional<Options> parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    if (take_flag(argv[i], options)) continue;
    if (i + 1 >= argc || !take_value(argv[i], argv[i + 1], options)) return std::nullopt;
    ++i;
  }
  return options;
}

int run(const Options& options) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  last_words::watch_signals();
  bool found = false, fine = true;
  for (const std::string_view bench : driver_bench_names()) {
    if (!options.bench.empty() && options.bench != bench) continue;
    found = true;
    fine = Fuzz(options, bench).run() && fine;
  }
  if (!found) {
    std::fprintf(stderr, "device_fuzz: no bench \"%s\"; there are", options.bench.c_str());
    for (const std::string_view bench : driver_bench_names()) {
      std::fprintf(stderr, " %s", std::string(bench).c_str());
    }
    std::fprintf(stderr, "\n");
    return 2;
  }
  return fine ? 0 : 1;
}

}  // namespace
}  // namespace felt

int main(int argc, char** argv) {
  const auto options = felt::parse(argc, argv);
  if (argc == 2 && std::strcmp(argv[1], "--list") == 0) {
    for (const std::string_view bench : felt::driver_bench_names()) {
      std::puts(std::string(bench).c_str());
    }
    return 0;
  }
  if (!options) {
    std::fprintf(stderr,
                 "usage: device_fuzz [--bench NAME] [--seeds N] [--seed FIRST] [--limits] "
                 "[--bad NAME] [--all] [--trace] | --list\n");
    return 2;
  }
  return felt::run(*options);
}
