#include "desktop/canvas/ink_worker.h"

#include <iterator>
#include <utility>

#include "desktop/canvas/ink_tile_store.h"

namespace felt::desktop {

InkWorker::InkWorker(std::function<void()> on_news)
    : on_news_(std::move(on_news)), thread_([this] { run(); }) {}

InkWorker::~InkWorker() {
  quits_ = true;
  {
    const std::lock_guard lock(mutex_);
    has_mail_ = true;
  }
  has_orders_.notify_all();
  thread_.join();
}

std::uint64_t InkWorker::post(Order order) {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    // If two views or two previews wait one after the other, the first would never be visible, so
    // the second replaces it.
    if (!orders_.empty() && orders_.back().index() == order.index() &&
        (std::holds_alternative<Look>(order) ||
         std::holds_alternative<std::optional<Edit>>(order))) {
      orders_.pop_back();
    }
    orders_.push_back(std::move(order));
    number = ++posted_;
    stage_ = Stage::kBusy;
    has_mail_ = true;
  }
  has_orders_.notify_one();
  return number;
}

std::uint64_t InkWorker::open(Document document) {
  return post(std::move(document));
}
std::uint64_t InkWorker::apply(Edit edit) {
  return post(std::move(edit));
}
std::uint64_t InkWorker::show(std::optional<Edit> preview) {
  return post(std::move(preview));
}
std::uint64_t InkWorker::look(const PlaneSpec& plane, const PlaneRect& seen,
                              const std::optional<PlaneSpec>& over) {
  return post(Look{plane, seen, over});
}
std::uint64_t InkWorker::forget(std::uint64_t plane) {
  return post(Forget{plane});
}

std::vector<TileNews> InkWorker::take_news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

InkWorker::Stage InkWorker::stage() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

bool InkWorker::wait(Stage stage, std::chrono::microseconds at_most) {
  std::unique_lock lock(mutex_);
  return has_stage_.wait_for(lock, at_most, [&] { return stage_ >= stage; });
}

void InkWorker::wait(Stage stage) {
  std::unique_lock lock(mutex_);
  has_stage_.wait(lock, [&] { return stage_ >= stage; });
}

/// Takes the waiting orders. If nothing else is to do, waits for them. Returns false when the
/// thread must end.
bool InkWorker::take_orders(std::deque<Order>& orders, std::uint64_t& last) {
  std::unique_lock lock(mutex_);
  if (is_idle_) has_orders_.wait(lock, [&] { return !orders_.empty() || quits_; });
  orders = std::exchange(orders_, {});
  last = posted_;
  has_mail_ = false;
  return !quits_;
}

void InkWorker::set_stage(Stage stage, std::uint64_t order) {
  {
    const std::lock_guard lock(mutex_);
    repaired_ = order;
    if (order != posted_) return;  // another order has arrived meanwhile
    stage_ = stage;
  }
  has_stage_.notify_all();
}

void InkWorker::publish(std::vector<TileNews> news) {
  bool is_first = false;
  {
    const std::lock_guard lock(mutex_);
    is_first = news_.empty();
    news_.insert(news_.end(), std::make_move_iterator(news.begin()),
                 std::make_move_iterator(news.end()));
  }
  if (is_first) on_news_();
}

void InkWorker::run() {
  InkTileStore store;
  std::deque<Order> orders;
  std::uint64_t last = 0;
  const auto should_stop = [this] { return has_mail_.load(std::memory_order_relaxed); };
  while (take_orders(orders, last)) {
    for (Order& order : orders) {
      std::visit(
          [&store](auto& what) {
            using What = std::decay_t<decltype(what)>;
            if constexpr (std::is_same_v<What, Document>) store.open(what);
            if constexpr (std::is_same_v<What, Edit>) store.apply(what);
            if constexpr (std::is_same_v<What, std::optional<Edit>>) store.show(what);
            if constexpr (std::is_same_v<What, Look>) store.look(what.plane, what.seen, what.over);
            if constexpr (std::is_same_v<What, Forget>) store.forget(what.plane);
          },
          order);
    }
    orders.clear();
    const InkTileStore::Need need = store.plan();
    if (need != InkTileStore::Need::kRepair) {
      set_stage(need == InkTileStore::Need::kMissing ? Stage::kRepaired : Stage::kComplete, last);
    }
    is_idle_ = need == InkTileStore::Need::kNone;
    std::vector<TileNews> news;
    store.work(last, should_stop, news);
    if (!news.empty()) publish(std::move(news));
  }
}

}  // namespace felt::desktop
