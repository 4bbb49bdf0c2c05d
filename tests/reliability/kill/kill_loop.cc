// kill_loop --kills N --seed S [--jobs J] [--folder DIR] [--longest MS] [--strict]
//
// Does this N times: A process draws in real time and is killed at a random moment. In one run of
// four, processes that recover the drawing are killed too. A last process recovers the drawing and
// checks that nothing older than 50 ms is lost (kill_judge.cc). In one run of six the edit thread
// hangs before the kill. In one run of four the threads stall; then only damage counts, not how
// much is lost. In one run of eight a second instance shares the folder and continues to draw.
// Exits with 0 if no run is bad and few samples older than 50 ms are lost (none if --strict).
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <random>
#include <string_view>

#include "felt/autosave/recovery.h"
#include "felt/store/felt_file.h"
#include "tests/reliability/kill/kill_shared.h"

namespace felt::kill {
namespace {

constexpr std::int64_t kPromiseNs = 50'000'000;
constexpr std::array<int, 9> kEdgesMs = {0, 5, 10, 20, 30, 40, 50, 100, 1 << 30};

struct Arguments {
  int kills = 25, jobs = 2, longest_ms = 700;
  std::uint64_t seed = 1;
  std::string folder;
  bool strict = false;
};

struct Tally {
  std::atomic<int> next{0}, good{0}, bad{0}, hung{0}, shared{0}, stalled{0}, with_gesture{0};
  std::array<std::atomic<int>, kEdgesMs.size()> ages{};
  std::atomic<std::int64_t> oldest_ns{0};
};

template <class T>
T* in_shared_memory() {
  void* memory =
      ::mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) std::abort();
  return new (memory) T;
}

template <class Run>
pid_t start(Run&& run) {
  const pid_t process = ::fork();
  if (process != 0) return process;
  run();
  ::_exit(0);
}

/// Waits until the process ends and returns its waitpid() status.
int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
  }
  return status;
}

struct Instance {
  Testimony* testimony = in_shared_memory<Testimony>();
  Picture picture;
  pid_t process = 0;

  void begin() {
    new (testimony) Testimony;
    process = start([this] { draw(picture, *testimony); });
  }
};

class Worker {
 public:
  Worker(const Arguments& arguments, Tally& tally) : arguments_(arguments), tally_(tally) {}

  void run() {
    for (int i = tally_.next++; i < arguments_.kills; i = tally_.next++) once(i);
  }

 private:
  int any(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Picture picture_of(std::uint64_t seed, const std::string& folder, const char* name) {
    Picture picture;
    picture.seed = seed;
    picture.root = folder + "/working";
    picture.save_path = folder + '/' + name + ".felt";
    picture.with_forces = any(0, 1) == 0;
    picture.base_strokes = any(0, 3) == 0 ? any(200, 1500) : any(0, 12);
    if (picture.base_strokes > 0) {
      picture.base_path = picture.save_path;
      Drawing base;
      base.document = base_document(picture);
      if (!write_felt(picture.save_path, base)) std::abort();
    }
    if (any(0, 5) == 0) picture.hangs_at = static_cast<std::uint32_t>(any(1, 400));
    picture.stalls = any(0, 3) == 0;
    return picture;
  }

  void once(int i) {
    const std::uint64_t seed = arguments_.seed * 1'000'003 + static_cast<std::uint64_t>(i);
    random_.seed(seed);
    const std::string folder = arguments_.folder + "/" + std::to_string(i);
    std::filesystem::create_directories(folder);
    const bool is_shared = any(0, 7) == 0;
    first_.picture = picture_of(seed, folder, "first");
    if (is_shared) second_.picture = picture_of(seed + 77, folder, "second");
    first_.begin();
    if (is_shared) second_.begin();
    // One kill in five comes early, while the autosave still writes its first base.
    const int wait_us = any(0, 4) == 0 ? any(0, 80'000) : any(0, arguments_.longest_ms * 1000);
    ::usleep(static_cast<useconds_t>(wait_us));
    kill(first_);
    look(first_, i);
    if (is_shared) {
      ::usleep(static_cast<useconds_t>(any(0, 100'000)));
      kill(second_);
      look(second_, i);
      ++tally_.shared;
    }
    std::filesystem::remove_all(folder);
  }

  void kill(const Instance& instance) {
    static constexpr int kSignals[] = {SIGKILL, SIGKILL, SIGKILL, SIGKILL, SIGABRT, SIGSEGV};
    const int signal = kSignals[any(0, 5)];
    ::kill(instance.process, signal);
    const int status = wait_for(instance.process);
    if (!WIFSIGNALED(status)) {
      std::printf("the process ended by itself: %d\n", WEXITSTATUS(status));
      ++tally_.bad;
    }
  }

  void look(Instance& instance, int i) {
    const auto recover = [&instance] {
      judge(instance.picture, instance.process, *instance.testimony);
    };
    // Sometimes kill processes during the recovery. That must not change the result.
    for (int tries = any(0, 3) == 0 ? any(1, 3) : 0; tries > 0; --tries) {
      const pid_t process = start(recover);
      ::usleep(static_cast<useconds_t>(any(0, 30'000)));
      ::kill(process, SIGKILL);
      wait_for(process);
    }
    instance.testimony->is_judged = false;
    wait_for(start(recover));
    count(instance, i);
  }

  void count(const Instance& instance, int i) {
    const Testimony& testimony = *instance.testimony;
    const Picture& picture = instance.picture;
    const std::int64_t age_ns = testimony.age_ns;
    if (!testimony.is_judged || !testimony.is_good) {
      ++tally_.bad;
      std::printf("kill %d (seed %llu, %d strokes before, %s, hangs at %u): %s\n", i,
                  static_cast<unsigned long long>(picture.seed), picture.base_strokes,
                  picture.with_forces ? "touch" : "tablet", picture.hangs_at,
                  testimony.is_judged ? testimony.reason.data() : "recovery itself died");
      std::fflush(stdout);
      return;
    }
    ++tally_.good;
    if (picture.hangs_at < testimony.confirmed) ++tally_.hung;
    if (testimony.live_samples > 0) ++tally_.with_gesture;
    if (picture.stalls) {
      ++tally_.stalled;  // loses more than 50 ms as a matter of course
      return;
    }
    std::size_t bin = 0;
    while (age_ns > std::int64_t{kEdgesMs[bin]} * 1'000'000) ++bin;
    ++tally_.ages[bin];
    std::int64_t oldest = tally_.oldest_ns;
    while (age_ns > oldest && !tally_.oldest_ns.compare_exchange_weak(oldest, age_ns)) {
    }
  }

  const Arguments& arguments_;
  Tally& tally_;
  std::mt19937_64 random_;
  Instance first_, second_;
};

int report(const Tally& tally, const Arguments& arguments) {
  std::printf(
      "%d good, %d bad; %d with a gesture in work, %d with a hung edit thread, %d with stalls, %d "
      "in a folder with another instance\n",
      tally.good.load(), tally.bad.load(), tally.with_gesture.load(), tally.hung.load(),
      tally.stalled.load(), tally.shared.load());
  std::printf("age of the oldest sample that is lost, ms:");
  int late = 0;
  for (std::size_t i = 0; i < kEdgesMs.size(); ++i) {
    if (i + 1 < kEdgesMs.size()) {
      std::printf(i == 0 ? "  none: %d" : "  <=%d: %d", i == 0 ? tally.ages[i].load() : kEdgesMs[i],
                  tally.ages[i].load());
    } else {
      std::printf("  more: %d", tally.ages[i].load());
    }
    if (std::int64_t{kEdgesMs[i]} * 1'000'000 > kPromiseNs) late += tally.ages[i];
  }
  std::printf("\nthe oldest: %.1f ms; older than 50 ms: %d\n",
              static_cast<double>(tally.oldest_ns.load()) * 1e-6, late);
  // If the machine stalls for a moment, the autosave stalls too. A few late runs are therefore
  // allowed. An autosave that is itself too slow would be late in nearly every run.
  const int judged = tally.good + tally.bad - tally.stalled;
  const bool is_late = late > (arguments.strict ? 0 : std::max(2, judged / 10));
  return tally.bad == 0 && !is_late ? 0 : 1;
}

bool parse(int argc, char** argv, Arguments& out) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    if (name == "--strict") {
      out.strict = true;
      continue;
    }
    if (i + 1 == argc) return false;
    const std::string_view value = argv[++i];
    const auto number = [&value](auto& target) {
      const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), target);
      return error == std::errc() && end == value.data() + value.size();
    };
    bool good = true;
    if (name == "--kills") {
      good = number(out.kills);
    } else if (name == "--seed") {
      good = number(out.seed);
    } else if (name == "--jobs") {
      good = number(out.jobs);
    } else if (name == "--longest") {
      good = number(out.longest_ms);
    } else if (name == "--folder") {
      out.folder = value;
    } else {
      good = false;
    }
    if (!good) return false;
  }
  return out.kills > 0 && out.jobs > 0 && out.longest_ms > 0 && out.longest_ms < 8000;
}

/// Implements `kill_loop --leave DIR`: a process draws for 0.7 s, is killed, and leaves its
/// autosave in DIR.
int leave(const std::string& folder) {
  Instance artist;
  artist.picture.seed = 5;
  artist.picture.root = folder;
  artist.picture.save_path = folder + "/../left.felt";
  artist.begin();
  while (artist.testimony->confirmed < 700) ::usleep(1000);
  ::kill(artist.process, SIGKILL);
  return WIFSIGNALED(wait_for(artist.process)) ? 0 : 1;
}

int run(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "--leave") return leave(argv[2]);
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    std::fprintf(stderr,
                 "kill_loop --kills N --seed S [--jobs J] [--folder DIR] [--longest MS] "
                 "[--strict]\n");
    return 2;
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  std::string folder = (arguments.folder.empty() ? std::filesystem::temp_directory_path().string()
                                                 : arguments.folder) +
                       "/felt-kill-XXXXXX";
  if (!::mkdtemp(folder.data())) {
    std::perror(folder.c_str());
    return 2;
  }
  arguments.folder = folder;
  auto* tally = in_shared_memory<Tally>();
  std::vector<pid_t> workers;
  std::fflush(stdout);
  for (int i = 0; i < arguments.jobs; ++i) {
    workers.push_back(start([&] {
      Worker(arguments, *tally).run();
      std::fflush(stdout);
    }));
  }
  for (const pid_t worker : workers) {
    if (wait_for(worker) != 0) ++tally->bad;
  }
  std::filesystem::remove_all(folder);
  std::printf("seed %llu: ", static_cast<unsigned long long>(arguments.seed));
  return report(*tally, arguments);
}

}  // namespace
}  // namespace felt::kill

int main(int argc, char** argv) {
  return felt::kill::run(argc, argv);
}
