#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/reliability/power_cut/write_log.h"

namespace felt::power_cut {

/// What a workload said and when, in shared memory. Generations only grow.
class Diary {
 public:
  explicit Diary(const WriteLog& log);
  ~Diary();
  Diary(const Diary&) = delete;
  Diary& operator=(const Diary&) = delete;

  void clear() noexcept;
  /// It begins to save this generation.
  void start(std::uint32_t generation) noexcept;
  /// It would show "Saved", or rely on the commit.
  void acknowledge(std::uint32_t generation) noexcept;
  /// Something failed that must not.
  void fail(const std::string& why) noexcept;
  [[nodiscard]] std::string failure() const;

  /// The last of each when so many records were on the disk; `floor` where none was.
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

/// Something that is done to a document while the power may go at any moment.
struct Workload {
  std::string name;
  /// Goes on from what it finds in the folder (nothing at first, later what a power cut left), and
  /// from this generation, which is there. A process of its own; returns after some seconds.
  std::function<void(const std::string& folder, std::uint32_t from, Diary& diary)> run;
  /// The generation that the folder holds (0: nothing yet, where nothing may be there), or -1 with
  /// what is wrong. A fresh process; `most`: the last that was begun.
  std::function<int(const std::string& folder, std::uint32_t most, std::string& why)> find;
  /// Loses or damages documents: shows that the rig notices.
  bool is_plant = false;
};

std::vector<Workload> all_workloads();
void add_save_workloads(std::vector<Workload>& to);
void add_store_workloads(std::vector<Workload>& to);

}  // namespace felt::power_cut
