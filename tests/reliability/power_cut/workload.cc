#include "tests/reliability/power_cut/workload.h"

#include <sys/mman.h>

#include <cstring>
#include <new>
#include <stdexcept>

namespace felt::power_cut {

struct Diary::Pages {
  static constexpr std::size_t kMax = 100'000;
  std::atomic<std::size_t> count;
  Entry entries[kMax];
  char failure[1024];
};

Diary::Diary(const WriteLog& log) : log_(log) {
  void* memory = ::mmap(nullptr, sizeof(Pages), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory for the diary");
  pages_ = new (memory) Pages;
  clear();
}

Diary::~Diary() {
  ::munmap(pages_, sizeof(Pages));
}

void Diary::clear() noexcept {
  pages_->count = 0;
  pages_->failure[0] = '\0';
}

void Diary::add(std::uint32_t generation, bool is_acknowledged) noexcept {
  const std::size_t at = pages_->count;
  if (at >= Pages::kMax) return;
  pages_->entries[at] = {log_.count(), generation, is_acknowledged};
  pages_->count = at + 1;
}

void Diary::start(std::uint32_t generation) noexcept {
  add(generation, false);
}

void Diary::acknowledge(std::uint32_t generation) noexcept {
  add(generation, true);
}

void Diary::fail(const std::string& why) noexcept {
  std::strncpy(pages_->failure, why.c_str(), sizeof pages_->failure - 1);
}

std::string Diary::failure() const {
  return pages_->failure;
}

std::uint32_t Diary::started_at(std::uint64_t record, std::uint32_t floor) const noexcept {
  for (std::size_t i = 0; i < pages_->count && pages_->entries[i].record <= record; ++i) {
    if (!pages_->entries[i].is_acknowledged) floor = pages_->entries[i].generation;
  }
  return floor;
}

std::uint32_t Diary::acknowledged_at(std::uint64_t record, std::uint32_t floor) const noexcept {
  for (std::size_t i = 0; i < pages_->count && pages_->entries[i].record <= record; ++i) {
    if (pages_->entries[i].is_acknowledged) floor = pages_->entries[i].generation;
  }
  return floor;
}

std::vector<Workload> all_workloads() {
  std::vector<Workload> all;
  add_save_workloads(all);
  add_store_workloads(all);
  return all;
}

}  // namespace felt::power_cut
