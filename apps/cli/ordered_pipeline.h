#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace felt::cli {

/// Distributes work over threads and returns the results in the order of the items. The number of
/// slots for items is fixed, so memory is bounded. The results do not depend on the number of
/// threads.
///
/// `Item` and `Output` must be default constructible. The same Item and Output objects are reused
/// for later items, so that their buffers are allocated only once. `Item::bytes()` returns the size
/// of an item.
template <class Item, class Output>
class OrderedPipeline {
 public:
  /// Uses `jobs` >= 1 threads. If `jobs` is 1, everything runs on the caller's thread.
  explicit OrderedPipeline(int jobs)
      : jobs_(jobs), slots_(jobs == 1 ? 1 : 4 * static_cast<std::size_t>(jobs) + 4) {}

  /// Calls `next(item)` to fill an item and `take(output)` to handle a result, both on the caller's
  /// thread, until `next` returns false. Each thread gets its own function object from
  /// `make_worker()` and calls it to turn an item into its output: `worker(item, output)`. Ends
  /// early if `take` returns false.
  template <class MakeWorker, class Next, class Take>
  void run(MakeWorker&& make_worker, Next&& next, Take&& take) {
    if (jobs_ == 1) {
      auto worker = make_worker();
      Slot& slot = slots_.front();
      while (next(slot.item)) {
        worker(slot.item, slot.output);
        if (!take(slot.output)) return;
      }
      return;
    }
    std::vector<std::jthread> threads;  // joined after ~Stop() has run, on every return path
    threads.reserve(static_cast<std::size_t>(jobs_));
    const Stop stop{*this};
    for (int i = 0; i < jobs_; ++i) {
      threads.emplace_back([this, worker = make_worker()]() mutable { work(worker); });
    }
    feed(next, take);
  }

 private:
  struct Slot {
    Item item;
    Output output;
    bool done = false;
  };
  /// A guard with a destructor that stops the workers.
  struct Stop {
    OrderedPipeline& pipeline;
    ~Stop() {
      {
        const std::lock_guard lock(pipeline.mutex_);
        pipeline.stopped_ = true;
      }
      pipeline.work_waits_.notify_all();
    }
  };
  /// Limit for the total size of the items that are not yet handled. Another item is filled only
  /// while the total is below this limit, so the total exceeds the limit by at most one item.
  static constexpr std::size_t kMaxBytesInFlight = std::size_t{64} << 20;

  Slot& slot(std::size_t sequence) { return slots_[sequence % slots_.size()]; }

  template <class Next, class Take>
  void feed(Next&& next, Take&& take) {
    std::size_t taken = 0, given = 0, bytes_in_flight = 0;
    bool more = true;
    for (;;) {
      while (more && given - taken < slots_.size() &&
             (given == taken || bytes_in_flight < kMaxBytesInFlight)) {
        Slot& free = slot(given);
        more = next(free.item);
        if (!more) break;
        bytes_in_flight += free.item.bytes();
        free.done = false;
        give(++given);
      }
      if (given == taken) return;
      Slot& oldest = slot(taken++);
      wait_for(oldest);
      bytes_in_flight -= oldest.item.bytes();
      if (!take(oldest.output)) return;
    }
  }

  void give(std::size_t given) {
    {
      const std::lock_guard lock(mutex_);
      given_ = given;
    }
    work_waits_.notify_one();
  }

  void wait_for(const Slot& wanted) {
    std::unique_lock lock(mutex_);
    slot_done_.wait(lock, [&wanted] { return wanted.done; });
  }

  template <class Worker>
  void work(Worker& worker) {
    std::unique_lock lock(mutex_);
    for (;;) {
      work_waits_.wait(lock, [this] { return stopped_ || started_ < given_; });
      if (stopped_) return;
      Slot& mine = slot(started_++);
      lock.unlock();
      worker(mine.item, mine.output);
      lock.lock();
      mine.done = true;
      slot_done_.notify_one();
    }
  }

  int jobs_;
  std::vector<Slot> slots_;
  std::mutex mutex_;
  std::condition_variable work_waits_, slot_done_;
  std::size_t given_ = 0, started_ = 0;  // sequence numbers, guarded by the mutex
  bool stopped_ = false;
};

}  // namespace felt::cli
