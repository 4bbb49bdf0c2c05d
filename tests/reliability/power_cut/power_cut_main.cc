// felt_power_cut: changes documents on a file system with a disk that records every write. Then it
// simulates many power cuts at random moments: it builds a possible state of the disk at that
// moment, mounts it, and checks the documents in a new process. README.md explains the use.
#include <fcntl.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <random>
#include <sstream>

#include "tests/reliability/power_cut/log_disk.h"
#include "tests/reliability/power_cut/mounts.h"
#include "tests/reliability/power_cut/workload.h"

namespace felt::power_cut {
namespace {

namespace fs = std::filesystem;

constexpr int kSkipped = 77;
constexpr unsigned kHangSeconds = 120;
constexpr std::uint64_t kMaxUnmountable = 100;

struct Options {
  std::string system, workload;
  std::uint64_t states = 12, seed = 1, per_recording = 100;
  bool list = false, no_neighbour = false;
};

struct Tally {
  std::uint64_t states = 0, ok = 0, damaged = 0, older = 0, repaired = 0, unmountable = 0,
                by_kind[kCutKinds] = {};
};

/// Runs `work` in a child process. Returns its exit code, or 128 plus the signal that killed it.
template <class Work>
int in_child(Work work) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(kHangSeconds);
    std::_Exit(work());
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Starts a process that simulates other programs: it makes the file system write at random times.
pid_t start_neighbour(const std::string& folder, std::uint64_t seed) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  std::mt19937_64 random(seed);
  for (;;) {
    ::usleep(static_cast<useconds_t>(20'000 + random() % 200'000));
    const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    if (fd < 0) std::_Exit(0);
    ::syncfs(fd);
    ::close(fd);
  }
}

class Rig {
 public:
  Rig(const Options& options, std::string work) : options_(options), work_(std::move(work)) {
    fs::create_directory(work_ + "/fuse");
    fs::create_directory(work_ + "/mount");
  }

  /// Records the workload and tests states of the disk until options_.states are tested. Returns ""
  /// or the reason why it cannot continue.
  std::string run(const FileSystem& system, const Workload& workload) {
    const auto start = std::chrono::steady_clock::now();
    tally_ = {};
    std::string error;
    std::vector<char> base = make_base(system, image(), error);
    std::uint32_t floor = 0;
    std::uint64_t recordings = 0;
    std::mt19937_64 random(options_.seed);
    while (error.empty() && tally_.states < options_.states) {
      // Every third recording starts from an empty file system, to test the first creation too.
      if (recordings % 3 == 0 && recordings > 0) base = make_base(system, image(), error);
      if (recordings % 3 == 0) floor = 0;
      ++recordings;
      if (error.empty()) error = record(system, workload, base, floor, random());
      const std::uint64_t some = std::min(options_.per_recording, options_.states - tally_.states);
      for (std::uint64_t i = 0; error.empty() && i < some; ++i) {
        const Cut cut{random() % (log_.count() + 1), static_cast<CutKind>(i % kCutKinds), random()};
        error = try_cut(system, workload, base, floor, cut);
      }
      // The next recording continues from the last state, to test repeated power cuts.
      if (error.empty() && last_found_ >= 0) {
        base = read_image();
        floor = static_cast<std::uint32_t>(last_found_);
      }
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    std::printf(
        "%-6s %-18s %6llu states (%llu prefix, %llu drop, %llu tear) of %llu recordings: "
        "%llu ok, %llu damaged, %llu older than acknowledged; file system repaired %llu, "
        "lost %llu; %.1f s\n",
        system.name, workload.name.c_str(), number(tally_.states), number(tally_.by_kind[0]),
        number(tally_.by_kind[1]), number(tally_.by_kind[2]), number(recordings), number(tally_.ok),
        number(tally_.damaged), number(tally_.older), number(tally_.repaired),
        number(tally_.unmountable), took.count());
    std::fflush(stdout);
    bad_ += tally_.states - tally_.ok;
    return error;
  }

  [[nodiscard]] std::uint64_t bad() const { return bad_; }

 private:
  [[nodiscard]] std::string image() const { return work_ + "/image"; }
  [[nodiscard]] std::string mount_point() const { return work_ + "/mount"; }

  std::vector<char> read_image() const {
    std::vector<char> bytes(fs::file_size(image()));
    const int fd = ::open(image().c_str(), O_RDONLY | O_CLOEXEC);
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t n = ::pread(fd, bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
      if (n <= 0) break;
      at += static_cast<std::size_t>(n);
    }
    ::close(fd);
    return bytes;
  }

  std::string record(const FileSystem& system, const Workload& workload,
                     const std::vector<char>& base, std::uint32_t floor, std::uint64_t seed) {
    log_.clear();
    diary_.clear();
    std::string error;
    const LogDisk disk(work_ + "/fuse", base, log_, error);
    if (!error.empty()) return error;
    {
      const Mount mount(system, disk.path(), mount_point(), error);
      if (!error.empty()) return error;
      const pid_t neighbour = options_.no_neighbour ? -1 : start_neighbour(mount_point(), seed);
      const int code = in_child([&] {
        workload.run(mount_point(), floor, diary_);
        return 0;
      });
      if (neighbour > 0) {
        ::kill(neighbour, SIGKILL);
        ::waitpid(neighbour, nullptr, 0);
      }
      if (code != 0) error = workload.name + " ended with code " + std::to_string(code);
      if (!diary_.failure().empty()) error = workload.name + " failed: " + diary_.failure();
    }
    return error;
  }

  std::string try_cut(const FileSystem& system, const Workload& workload,
                      const std::vector<char>& base, std::uint32_t floor, const Cut& cut) {
    std::string error = log_.replay(base, image(), cut);
    if (!error.empty()) return error;
    const std::uint32_t started = diary_.started_at(cut.at, floor);
    const std::uint32_t acknowledged = diary_.acknowledged_at(cut.at, floor);
    int answer[2];
    if (::pipe(answer) != 0) return "no pipe";
    auto mount = std::make_unique<Mount>(system, image(), mount_point(), error);
    if (!error.empty() && repair(system, image())) {
      ++tally_.repaired;
      error.clear();
      mount = std::make_unique<Mount>(system, image(), mount_point(), error);
    }
    if (!error.empty()) {
      // The file system itself is destroyed, so the documents on it cannot be checked.
      if (++tally_.unmountable > kMaxUnmountable) return error + describe(cut);
      ::close(answer[0]);
      ::close(answer[1]);
      last_found_ = -1;
      return "";
    }
    const int code = in_child([&] {
      std::string why;
      const int found = workload.find(mount_point(), started, why);
      const std::string text = std::to_string(found) + " " + why.substr(0, 1000);
      static_cast<void>(::write(answer[1], text.data(), text.size()) > 0);
      return 0;
    });
    ::close(answer[1]);
    char text[1200] = {};
    static_cast<void>(::read(answer[0], text, sizeof text - 1) > 0);
    ::close(answer[0]);
    judge(system, workload, cut, code, text, acknowledged);
    return "";
  }

  static std::string describe(const Cut& cut) {
    return " (record " + std::to_string(cut.at) + ", " + cut_name(cut.kind) + ", seed " +
           std::to_string(cut.seed) + ")";
  }

  void judge(const FileSystem& system, const Workload& workload, const Cut& cut, int code,
             const std::string& answer, std::uint32_t acknowledged) {
    ++tally_.states;
    ++tally_.by_kind[static_cast<int>(cut.kind)];
    const int found = code == 0 ? std::atoi(answer.c_str()) : -1;
    last_found_ = found;
    std::string problem;
    if (code != 0) problem = "CRASH: the checking process ended with code " + std::to_string(code);
    if (problem.empty() && found < 0) problem = "DAMAGED: " + answer.substr(answer.find(' ') + 1);
    tally_.damaged += !problem.empty();
    if (problem.empty() && found < static_cast<int>(acknowledged)) {
      problem = "LOST: generation " + std::to_string(found) + " where " +
                std::to_string(acknowledged) + " was acknowledged";
      ++tally_.older;
    }
    tally_.ok += problem.empty();
    if (!problem.empty() && ++shown_ <= 10) {
      std::printf("%s %s: %s%s\n", system.name, workload.name.c_str(), problem.c_str(),
                  describe(cut).c_str());
    }
  }

  const Options& options_;
  std::string work_;
  WriteLog log_;
  Diary diary_{log_};
  Tally tally_;
  int last_found_ = -1;
  std::uint64_t bad_ = 0;
  int shown_ = 0;
};

int skip(const std::string& why) {
  std::printf("skipped: %s\n", why.c_str());
  return kSkipped;
}

/// Returns true if `name` matches one of the comma-separated patterns. A pattern is a name, or the
/// beginning of a name and '*'.
bool matches(const std::string& name, const std::string& patterns, bool by_default) {
  if (patterns.empty()) return by_default;
  std::stringstream list(patterns);
  for (std::string one; std::getline(list, one, ',');) {
    const bool is_beginning = !one.empty() && one.back() == '*';
    if (is_beginning ? name.rfind(one.substr(0, one.size() - 1), 0) == 0 : name == one) return true;
  }
  return false;
}

int run(const Options& options) {
  if (options.list) {
    for (const Workload& workload : all_workloads()) std::printf("%s\n", workload.name.c_str());
    return 0;
  }
  if (const std::string why = why_not(); !why.empty()) return skip(why);
  std::string work = (fs::temp_directory_path() / "felt-power-cut-XXXXXX").string();
  if (::mkdtemp(work.data()) == nullptr) return skip("no folder to work in");
  const std::string error = enter_private_mounts(work);
  if (!error.empty()) {
    fs::remove(work);
    return skip(error);
  }
  int code = kSkipped;
  std::uint64_t bad = 0;
  {
    Rig rig(options, work);
    for (const FileSystem& system : file_systems()) {
      if (!matches(system.name, options.system, true)) continue;
      if (const std::string why = why_not(system); !why.empty()) {
        std::printf("skipped: %s: %s\n", system.name, why.c_str());
        continue;
      }
      for (const Workload& workload : all_workloads()) {
        if (!matches(workload.name, options.workload, !workload.is_plant)) continue;
        const std::string problem = rig.run(system, workload);
        if (problem.empty()) {
          code = 0;
          continue;
        }
        std::printf("%s %s: the rig failed: %s\n", system.name, workload.name.c_str(),
                    problem.c_str());
        code = 1;
        break;
      }
      if (code == 1) break;
    }
    bad = rig.bad();
  }
  ::umount2(work.c_str(), MNT_DETACH);
  std::error_code ignored;
  fs::remove(work, ignored);
  return bad > 0 ? 1 : code;
}

}  // namespace
}  // namespace felt::power_cut

int main(int argc, char** argv) {
  felt::power_cut::Options options;
  CLI::App app("Cuts the power at random moments of saving, and looks whether anything was lost");
  app.add_option("--states", options.states, "how many states of each workload and file system");
  app.add_option("--file-system", options.system, "ext4, xfs or btrfs; all without it");
  app.add_option("--workload", options.workload,
                 "some, separated by commas, each may be a beginning and '*'");
  app.add_option("--seed", options.seed, "of all that is random");
  app.add_option("--per-recording", options.per_recording, "states of each recording");
  app.add_flag("--list", options.list, "the names of the workloads");
  CLI11_PARSE(app, argc, argv);
  return felt::power_cut::run(options);
}
