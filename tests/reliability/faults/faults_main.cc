// felt_faults: runs scenarios, such as saving a document, again and again. Each run lets one system
// call fail in one way, and then checks the document. README.md explains the use.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>

#include "tests/reliability/faults/driver.h"

namespace felt::faults {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string scenario, program, preload, mode;
  std::uint32_t at = 0, stride = 0, thin = 1;
  bool persistent = false, memory = false, list = false, verbose = false;
};

constexpr std::pair<Mode, bool> kVariants[] = {
    {Mode::kEio, false},      {Mode::kEio, true},    {Mode::kEnospc, false}, {Mode::kEnospc, true},
    {Mode::kEdquot, false},   {Mode::kEdquot, true}, {Mode::kEintr, false},  {Mode::kShort, false},
    {Mode::kHalfKill, false}, {Mode::kKill, false}};

/// Prints the problem and the command line that repeats the run.
void print_problem(const Scenario& scenario, const Fault& fault, const RunResult& run) {
  std::printf("%s\n  at %s\n  felt_faults --scenario %s --at %u%s%s%s%s\n", run.problem.c_str(),
              run.hit_name.c_str(), scenario.name.c_str(), fault.at,
              fault.memory ? " --memory" : " --mode ", fault.memory ? "" : mode_name(fault.mode),
              fault.persistent ? " --persistent" : "", "");
}

std::string without(std::string text, const std::string& part) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part)) {
    text.erase(at, part.size());
  }
  return text;
}

class Suite {
 public:
  Suite(Driver& driver, const Options& options) : driver_(driver), options_(options) {}

  /// Runs the scenario with a fault at every call, in every variant. The number of calls varies if
  /// the scenario uses threads. So the call number increases until a run ends before that call.
  void run_all(const Scenario& scenario) {
    const auto start = std::chrono::steady_clock::now();
    driver_.prepare(scenario);
    tally_ = {};
    messages_.clear();
    std::uint32_t sites = 0;
    RunResult plain = run_one(scenario, {});
    const std::uint32_t stride =
        options_.stride > 0 ? options_.stride : scenario.stride * options_.thin;
    if (options_.memory) {
      for (const bool persistent : {false, true})
        sites = count_up(scenario, Mode::kNone, persistent, stride);
    } else {
      for (const auto& [mode, persistent] : kVariants)
        sites = count_up(scenario, mode, persistent, stride);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::printf(
        "%-32s %6u calls %7llu runs: %llu hit, %llu completed, %llu errors, %llu killed, "
        "%llu bad_alloc, %llu terminated; %llu damaged, %llu problems, %.1f s\n",
        scenario.name.c_str(), sites, number(tally_.runs), number(tally_.hits),
        number(tally_.completed), number(tally_.errors), number(tally_.killed),
        number(tally_.out_of_memory), number(tally_.terminated), number(tally_.damaged),
        number(tally_.problems), took.count());
    for (const auto& [text, count] : messages_) {
      if (options_.verbose) std::printf("    %5llu x %s\n", number(count), text.c_str());
    }
    std::fflush(stdout);
    total_problems_ += tally_.problems;
  }

  RunResult run_one(const Scenario& scenario, const Fault& fault) {
    RunResult run = driver_.run(scenario, fault);
    if (fault.at == 0 && run.outcome == Outcome::kError && !scenario.read_only) {
      run.problem = "fails undisturbed: " + run.message;
    }
    tally_.add(run);
    if (!run.message.empty()) ++messages_[without(run.message, driver_.folder())];
    if (!run.problem.empty() && ++shown_ <= 20) print_problem(scenario, fault, run);
    return run;
  }

  [[nodiscard]] std::uint64_t problems() const { return total_problems_; }

 private:
  static unsigned long long number(std::uint64_t value) { return value; }

  std::uint32_t count_up(const Scenario& scenario, Mode mode, bool persistent,
                         std::uint32_t stride) {
    for (std::uint32_t at = 1;; at += stride) {
      const RunResult run = run_one(scenario, {mode, at, persistent, options_.memory});
      if (run.seen < at) return run.seen;
    }
  }

  Driver& driver_;
  const Options& options_;
  Tally tally_;
  std::map<std::string, std::uint64_t> messages_;
  std::uint64_t total_problems_ = 0;
  int shown_ = 0;
};

/// Returns a new folder, in memory if possible. The test checks the behaviour of the program, for
/// which the many thousand flushes need no real disk.
std::string work_folder() {
  const char* named = std::getenv("FELT_FAULTS_FOLDER");
  const std::string parent = named != nullptr                  ? named
                             : ::access("/dev/shm", W_OK) == 0 ? "/dev/shm"
                                                               : fs::temp_directory_path().string();
  std::string name = parent + "/felt-faults-XXXXXX";
  return ::mkdtemp(name.data()) != nullptr ? name : parent + "/felt-faults";
}

Mode mode_named(const std::string& name) {
  for (std::uint32_t i = 0; i < kModeCount; ++i) {
    if (name == mode_name(static_cast<Mode>(i))) return static_cast<Mode>(i);
  }
  return Mode::kNone;
}

bool is_asked_for(const Scenario& scenario, const Options& options) {
  if (options.memory && !scenario.has_memory) return false;
  if (options.scenario.empty()) return !scenario.is_plant;
  if (options.scenario.back() != '*') return scenario.name == options.scenario;
  return scenario.name.rfind(options.scenario.substr(0, options.scenario.size() - 1), 0) == 0;
}

int run(const Options& options) {
  Driver driver(work_folder(), options.preload);
  Suite suite(driver, options);
  int found = 0;
  for (const Scenario& scenario : all_scenarios(options.program)) {
    if (options.list) std::printf("%s\n", scenario.name.c_str());
    if (options.list || !is_asked_for(scenario, options)) continue;
    ++found;
    if (options.at == 0) {
      suite.run_all(scenario);
      continue;
    }
    driver.prepare(scenario);
    const RunResult once = suite.run_one(
        scenario, {mode_named(options.mode), options.at, options.persistent, options.memory});
    std::printf("%u calls; %s; outcome %u%s; message: %s\n%s\n", once.seen, once.hit_name.c_str(),
                static_cast<unsigned>(once.outcome), once.killed ? ", killed" : "",
                once.message.c_str(), once.problem.empty() ? "all is well" : "A PROBLEM");
  }
  if (options.list) return 0;
  if (found == 0) std::fprintf(stderr, "no scenario '%s'\n", options.scenario.c_str());
  return found == 0 ? 2 : suite.problems() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace felt::faults

int main(int argc, char** argv) {
  felt::faults::Options options;
  CLI::App app("Fails every call to the system, and looks whether a document was damaged");
  app.add_option("--scenario", options.scenario, "one, or a beginning and '*'; all without it");
  app.add_option("--program", options.program, "feltline, for the scenarios of the program");
  app.add_option("--preload", options.preload, "the interposer as a library, for the same");
  app.add_option("--at", options.at, "this call only");
  app.add_option("--mode", options.mode, "with --at: how it fails");
  app.add_option("--stride", options.stride, "every n-th call; 1 for all, also of large ones");
  app.add_option("--thin", options.thin, "tries every n-th of the calls that would be tried");
  app.add_flag("--persistent", options.persistent, "with --at: all later calls fail too");
  app.add_flag("--memory", options.memory, "allocations fail instead of calls on files");
  app.add_flag("--list", options.list, "the names of the scenarios");
  app.add_flag("--verbose", options.verbose, "the messages, and how often");
  CLI11_PARSE(app, argc, argv);
  return felt::faults::run(options);
}
