#include "desktop/engine/cue_thread.h"

#include <utility>

namespace felt::desktop {

CueThread::CueThread(std::unique_ptr<CueDevice> device, bool with_thread,
                     std::function<void(DeviceFault)> on_fault)
    : device_(std::move(device)), on_fault_(std::move(on_fault)) {
  if (with_thread) thread_ = std::thread([this] { serve(); });
}

CueThread::~CueThread() {
  if (thread_.joinable()) {
    {
      const std::lock_guard lock(mutex_);
      orders_.clear();
      is_over_ = true;
    }
    posted_.notify_one();
    thread_.join();
  }
  device_->stop();
}

void CueThread::play(const Cue& cue, std::int64_t now_ns) {
  post({cue, now_ns});
}

void CueThread::stop() {
  post({{}, 0, true});
}

void CueThread::post(const Order& order) {
  if (!thread_.joinable()) return carry_out(order);
  {
    const std::lock_guard lock(mutex_);
    if (order.is_stop) orders_.clear();
    if (orders_.size() == kMaxWaiting) orders_.pop_front();
    orders_.push_back(order);
  }
  posted_.notify_one();
}

void CueThread::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    posted_.wait(lock, [this] { return is_over_ || !orders_.empty(); });
    if (is_over_) return;
    const Order order = orders_.front();
    orders_.pop_front();
    lock.unlock();
    carry_out(order);
    lock.lock();
  }
}

void CueThread::carry_out(const Order& order) {
  if (order.is_stop) return device_->stop();
  if (has_failed_) return;
  const auto played = device_->play(order.cue, order.now_ns);
  if (played || played.error() != DeviceFault::kDisconnected) return;
  has_failed_ = true;
  if (on_fault_) on_fault_(played.error());
}

}  // namespace felt::desktop
