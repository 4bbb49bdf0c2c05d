// gesture_fuzz [--gestures N] [--seed S] [--episode E] [--tool ID] [--strokes FILE] [--all]
// [--trace]
//
// Makes random gestures with every tool and option on random drawings, or on drawings with strokes
// of FILE (or of the file named by FELT_GESTURES_FILE), and checks each step (episode.h). Prints
// what was tried. If a rule is broken, prints it with the command line that repeats it and exits
// with 1. --all continues after a broken rule and lists each rule once per tool.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <set>
#include <string>

#include "tests/drawing/gestures/episode.h"
#include "tests/drawing/gestures/random_sketch.h"
#include "tests/support/last_words.h"

namespace felt::gestures {
namespace {

constexpr int kGesturesInEpisode = 20;
constexpr unsigned kHangsAfterS = 120;
/// In so many gestures with all tools, some are offered as more than ink, and a choice is made.
constexpr std::uint64_t kGesturesUntilAChoice = 1000;
/// In so many gestures with all tools, some strokes keep to a guide and are made exact.
constexpr std::uint64_t kGesturesUntilExact = 2000;

struct Options {
  std::uint64_t gestures = 2000;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> episode;
  std::string tool;
  std::string strokes;
  bool all = false;
  bool trace = false;
};

void watch(const Options& options, std::uint64_t episode) {
  std::string repeat = "repeat: gesture_fuzz --seed " + std::to_string(options.seed) +
                       " --episode " + std::to_string(episode);
  if (!options.tool.empty()) repeat += " --tool " + options.tool;
  if (!options.strokes.empty()) repeat += " --strokes " + options.strokes;
  last_words::watch(repeat + "\n", kHangsAfterS);
}

void print(const Options& options, const Totals& totals) {
  std::printf("%-10s %9s %9s %9s %10s %9s\n", "tool", "gestures", "edits", "previews", "selections",
              "most N");
  std::uint64_t gestures = 0, edits = 0;
  for (const auto& [tool, t] : totals.tools) {
    gestures += t.gestures;
    edits += t.edits;
    std::printf("%-10s %9llu %9llu %9llu %10llu %9.3f\n", tool.c_str(),
                static_cast<unsigned long long>(t.gestures),
                static_cast<unsigned long long>(t.edits),
                static_cast<unsigned long long>(t.previews),
                static_cast<unsigned long long>(t.selections), t.largest_n);
  }
  std::printf(
      "gesture_fuzz: seed %llu, %llu gestures, %llu samples, %llu edits, %llu undone or redone, "
      "%llu offers chosen, %llu strokes made exact: no rule broken; digest %016llx\n",
      static_cast<unsigned long long>(options.seed), static_cast<unsigned long long>(gestures),
      static_cast<unsigned long long>(totals.samples), static_cast<unsigned long long>(edits),
      static_cast<unsigned long long>(totals.undone),
      static_cast<unsigned long long>(totals.chosen), static_cast<unsigned long long>(totals.exact),
      static_cast<unsigned long long>(totals.digest));
}

/// Returns the id of a tool that had almost no effect, or null. A tool that does nothing breaks no
/// rule, so the run would prove nothing about it.
const char* idle_tool(const Totals& totals) {
  for (const auto& [tool, t] : totals.tools) {
    if (t.gestures >= 100 && t.edits + t.selections + t.readings < t.gestures / 50)
      return tool.c_str();
  }
  return nullptr;
}

/// Runs the episodes and reports the rules that they break.
class Fuzz {
 public:
  Fuzz(const Options& options, std::vector<Stroke> real)
      : options_(options), real_(std::move(real)) {}

  int run() {
    if (options_.episode) {
      run_episode(*options_.episode);
      return close();
    }
    for (std::uint64_t e = 0; e * kGesturesInEpisode < options_.gestures; ++e) {
      if (!run_episode(e) && !options_.all) return 1;
    }
    return close();
  }

 private:
  bool run_episode(std::uint64_t number) {
    watch(options_, number);
    EpisodeOptions options;
    options.seed = options_.seed * 0x9e3779b97f4a7c15ULL + number;
    options.gestures = kGesturesInEpisode;
    options.tool = options_.tool;
    options.trace = options_.trace;
    Episode episode(options, real_, totals_);
    const Broken broken = episode.run();
    if (!broken) return true;
    ++failures_;
    report(*broken, episode);
    return false;
  }
  void report(const std::string& broken, const Episode& episode) {
    // Messages that differ only in their numbers are the same broken rule of the tool.
    std::string kind(episode.tool());
    for (const char c : broken) {
      if (std::strchr("0123456789.-+e", c) == nullptr) kind += c;
    }
    if (!seen_.insert(kind).second) return;
    std::printf("broken rule: %s\n  in %s\n  %s", broken.c_str(), episode.where().c_str(),
                std::string(last_words::repeat()).c_str());
    std::fflush(stdout);
  }
  int close() {
    alarm(0);
    if (failures_ > 0) {
      std::printf("%llu episodes broke a rule\n", static_cast<unsigned long long>(failures_));
      return 1;
    }
    if (options_.gestures >= kGesturesUntilAChoice && !options_.episode && totals_.chosen == 0) {
      std::printf("broken rule: a stroke is offered as more than ink now and then\n");
      return 1;
    }
    if (options_.gestures >= kGesturesUntilExact && !options_.episode && options_.tool.empty() &&
        totals_.exact == 0) {
      std::printf("broken rule: a stroke is made exact now and then\n");
      return 1;
    }
    if (const char* tool = idle_tool(totals_)) {
      std::printf("broken rule: %s does something now and then\n", tool);
      return 1;
    }
    print(options_, totals_);
    return 0;
  }

  Options options_;
  std::vector<Stroke> real_;
  Totals totals_;
  std::set<std::string> seen_;
  std::uint64_t failures_ = 0;
};

bool take_flag(const char* word, Options& options) {
  if (std::strcmp(word, "--trace") == 0) return options.trace = true;
  if (std::strcmp(word, "--all") == 0) return options.all = true;
  return false;
}

bool take_value(const char* word, const char* value, Options& options) {
  if (std::strcmp(word, "--tool") == 0) return options.tool = value, true;
  if (std::strcmp(word, "--strokes") == 0) return options.strokes = value, true;
  char* end = nullptr;
  const std::uint64_t number = std::strtoull(value, &end, 10);
  if (*end != '\0' || end == value) return false;
  if (std::strcmp(word, "--gestures") == 0) return options.gestures = number, true;
  if (std::strcmp(word, "--seed") == 0) return options.seed = number, true;
  if (std::strcmp(word, "--episode") == 0) return options.episode = number, true;
  return false;
}

std::optional<Options> parse(int argc, char** argv) {
  Options options;
  if (const char* file = std::getenv("FELT_GESTURES_FILE")) options.strokes = file;
  for (int i = 1; i < argc; ++i) {
    if (take_flag(argv[i], options)) continue;
    if (i + 1 >= argc || !take_value(argv[i], argv[i + 1], options)) return std::nullopt;
    ++i;
  }
  return options;
}

bool is_tool(const std::string& id) {
  const auto tools = make_tools();
  return std::any_of(tools.begin(), tools.end(), [&](const auto& t) { return t->info().id == id; });
}

int run(const Options& options) {
  if (!options.tool.empty() && !is_tool(options.tool)) {
    std::fprintf(stderr, "gesture_fuzz: no tool '%s'\n", options.tool.c_str());
    return 2;
  }
  std::vector<Stroke> real;
  if (!options.strokes.empty()) {
    Result<std::vector<Stroke>> read = read_strokes(options.strokes);
    if (!read) {
      std::fprintf(stderr, "gesture_fuzz: %s\n", read.error().message.c_str());
      return 2;
    }
    real = *std::move(read);
  }
  last_words::watch_signals();
  return Fuzz(options, std::move(real)).run();
}

}  // namespace
}  // namespace felt::gestures

int main(int argc, char** argv) {
  const auto options = felt::gestures::parse(argc, argv);
  if (!options) {
    std::fprintf(stderr,
                 "usage: gesture_fuzz [--gestures N] [--seed S] [--episode E] [--tool ID] "
                 "[--strokes FILE] [--all] [--trace]\n");
    return 2;
  }
  return felt::gestures::run(*options);
}
