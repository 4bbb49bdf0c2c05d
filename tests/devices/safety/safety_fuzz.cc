// safety_fuzz [--ticks N] [--seed S] [--episode E] [--trace]
//
// Runs the safety chain in random and hostile worlds. An oracle that shares no code with the chain
// checks every tick. Prints a summary if no rule was broken. Otherwise prints the broken rule and
// the command that repeats the case, and exits with 1.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "tests/devices/safety/fuzz_world.h"
#include "tests/devices/safety/safety_oracle.h"

namespace felt::safety {
namespace {

struct Options {
  std::uint64_t ticks = 10'000'000;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> episode;
  bool trace = false;
};

struct Totals {
  std::uint64_t ticks = 0, episodes = 0, active = 0, pushed = 0, hard = 0, soft = 0;
  std::uint64_t digest = 0xcbf29ce484222325ULL;

  void add(const TickOutput& out) {
    ++ticks;
    active += out.after.state == SafetyState::kActive ? 1 : 0;
    pushed += norm(out.sent) > 0.0 ? 1 : 0;
    for (double v : {out.sent.x, out.sent.y, out.sent.z}) {
      digest = (digest ^ std::bit_cast<std::uint64_t>(v)) * 0x100000001b3ULL;
    }
  }
};

TickOutput tick(SafetyChain& chain, FuzzWorld& world, const TickInput& in) {
  TickOutput out;
  out.before = chain.report();
  if (in.disarm) chain.disarm();
  if (in.arm) chain.arm();
  if (in.heartbeat_ns) chain.heartbeat(*in.heartbeat_ns);
  out.model_dt_s = chain.begin(in.now_ns);
  if (in.read_fails) {
    chain.device_failed();
  } else {
    out.admitted = chain.admit(in.sample);
    out.scale = chain.budget(in.slopes);
    if (out.admitted) out.asked = world.asked(in.sample, out.scale, out.model_dt_s);
    out.sent = chain.limit(out.asked, in.sample);
  }
  out.after = chain.report();
  if (in.write_fails && !in.read_fails) chain.device_failed();
  return out;
}

void print_tick(int i, const TickInput& in, const TickOutput& out) {
  std::printf(
      "%6d %lld ns state %d>%d fault %d %s%s%s%s%s p %g %g %g v %g %g %g asked %g %g %g sent %.9g "
      "%.9g %.9g\n",
      i, static_cast<long long>(in.now_ns), static_cast<int>(out.before.state),
      static_cast<int>(out.after.state), static_cast<int>(out.after.fault), in.arm ? "arm " : "",
      in.disarm ? "disarm " : "", in.heartbeat_ns ? "beat " : "", in.read_fails ? "noread " : "",
      out.admitted ? "" : "doubt", in.sample.position.x, in.sample.position.y, in.sample.position.z,
      in.sample.velocity.x, in.sample.velocity.y, in.sample.velocity.z, out.asked.x, out.asked.y,
      out.asked.z, out.sent.x, out.sent.y, out.sent.z);
}

/// Runs one episode. Returns true if no rule was broken.
bool run_episode(const Options& options, std::uint64_t episode, Totals& totals) {
  FuzzWorld world(options.seed * 0x9e3779b97f4a7c15ULL + episode);
  SafetyChain chain(world.limits());
  SafetyOracle oracle(world.limits(), world.is_regular());
  Force sent;
  for (int i = 0; i < world.ticks(); ++i) {
    const TickInput in = world.next(chain.report(), sent);
    const TickOutput out = tick(chain, world, in);
    sent = out.sent;
    totals.add(out);
    if (options.trace) print_tick(i, in, out);
    const char* rule = oracle.check(in, out);
    if (!rule) rule = world.broken_by_body();
    if (rule) {
      std::printf("broken rule: %s\n", rule);
      print_tick(i, in, out);
      std::printf("repeat: safety_fuzz --seed %llu --episode %llu --trace\n",
                  static_cast<unsigned long long>(options.seed),
                  static_cast<unsigned long long>(episode));
      return false;
    }
  }
  ++totals.episodes;
  totals.hard += chain.report().hard_faults;
  totals.soft += chain.report().soft_faults;
  return true;
}

void print(const Options& options, const Totals& t) {
  const double share = 100.0 / static_cast<double>(t.ticks);
  std::printf(
      "safety_fuzz: seed %llu, %llu ticks in %llu episodes: no rule broken; force in %.1f %% of "
      "the ticks, active in %.1f %%, %llu soft and %llu hard faults, digest %016llx\n",
      static_cast<unsigned long long>(options.seed), static_cast<unsigned long long>(t.ticks),
      static_cast<unsigned long long>(t.episodes), share * static_cast<double>(t.pushed),
      share * static_cast<double>(t.active), static_cast<unsigned long long>(t.soft),
      static_cast<unsigned long long>(t.hard), static_cast<unsigned long long>(t.digest));
}

int run(const Options& options) {
  Totals totals;
  if (options.episode) {
    if (!run_episode(options, *options.episode, totals)) return 1;
  } else {
    for (std::uint64_t e = 0; totals.ticks < options.ticks; ++e) {
      if (!run_episode(options, e, totals)) return 1;
    }
    // A chain that never sends a force breaks no other rule, but it is useless.
    if (totals.ticks >= 1'000'000 && totals.pushed < totals.ticks / 10) {
      std::printf("broken rule: forces flow when all is well\n");
      return 1;
    }
  }
  print(options, totals);
  return 0;
}

std::optional<Options> parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--trace") == 0) {
      options.trace = true;
      continue;
    }
    if (i + 1 >= argc) return std::nullopt;
    char* end = nullptr;
    const std::uint64_t value = std::strtoull(argv[i + 1], &end, 10);
    if (*end != '\0' || end == argv[i + 1]) return std::nullopt;
    if (std::strcmp(argv[i], "--ticks") == 0)
      options.ticks = value;
    else if (std::strcmp(argv[i], "--seed") == 0)
      options.seed = value;
    else if (std::strcmp(argv[i], "--episode") == 0)
      options.episode = value;
    else
      return std::nullopt;
    ++i;
  }
  return options;
}

}  // namespace
}  // namespace felt::safety

int main(int argc, char** argv) {
  const auto options = felt::safety::parse(argc, argv);
  if (!options) {
    std::fprintf(stderr, "usage: safety_fuzz [--ticks N] [--seed S] [--episode E] [--trace]\n");
    return 2;
  }
  return felt::safety::run(*options);
}
