#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/reliability/power_cut/write_log.h"

namespace felt::power_cut {

/// Record of the generations that a workload began and acknowledged, and when. Lies in shared
/// memory. Generations only increase.
class Diary {
 public:
  explicit Diary(const WriteLog& log);
  ~Diary();
  Diary(const Diary&) = delete;
  Diary& operator=(const Diary&) = delete;

  void clear() noexcept;
  /// Records that the workload begins to save this generation.
  void start(std::uint32_t generation) noexcept;
  /// Records that the workload would show "Saved" or rely on the commit.
  void acknowledge(std::uint32_t generation) noexcept;
  /// Records a failure that must not happen.
  void fail(const std::string& why) noexcept;
  [[nodiscard]] std::string failure() const;

  /// Return the last generation that was begun or acknowledged when the disk log held `record`
  /// records, or `floor` if none was.
  [[nodiscard]] std::uint32_t started_at(std::uint64_t record, std::uint32_t floor) const noexcept;
  [[nodiscard]] std::uint32_t acknowledged_at(std::uint64_t record,
                                              std::uint32_t floor) const noexcept;

 private:
  struct Entry {
    std::uint64_t record;
    std::uint32_t generation;
    bool is_acknowledged;
  };
  struct Pages;
  void add(std::uint32_t generation, bool is_acknowledged) noexcept;

  const WriteLog& log_;
  Pages* pages_;
};

/// A series of changes to a document, during which the power may fail at any moment.
struct Workload {
  std::string name;
  /// Continues from the content of the folder, which is empty at first and later the result of a
  /// power cut. `from` is the generation in the folder. Runs in a separate process and returns
  /// after some seconds.
  std::function<void(const std::string& folder, std::uint32_t from, Diary& diary)> run;
  /// Returns the generation in the folder, 0 if the folder is still empty and may be, or -1 and
  /// sets `why`. `most` is the last generation that was begun. Runs in a new process.
  std::function<int(const std::string& folder, std::uint32_t largest, std::string& why)> find;
  /// True for a workload that loses or damages documents, which proves that the test notices.
  bool is_plant = false;
};

std::vector<Workload> all_workloads();
void add_save_workloads(std::vector<Workload>& to);
void add_store_workloads(std::vector<Workload>& to);

}  // namespace felt::power_cut
