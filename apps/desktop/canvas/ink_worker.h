#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

#include "desktop/canvas/ink_tiles.h"
#include "felt/document/document.h"

namespace felt::desktop {

/// A thread that keeps the tiles of a document up to date. Each request is an order with a number.
/// Orders are processed in sequence. A waiting preview is skipped if the next order is also a
/// preview; a waiting view is skipped if the next order is also a view. The worker makes tiles in
/// this sequence: visible tiles that an edit changed, then missing tiles from the middle outwards,
/// then the tiles in a margin around the view. Call all functions from one thread other than the
/// worker's. All functions except `wait` return immediately.
class InkWorker {
 public:
  /// The progress of the orders and the view.
  enum class Stage {
    kBusy,      ///< an order is waiting, or a visible tile is outdated
    kRepaired,  ///< every existing tile of the view is up to date
    kComplete,  ///< the view has all its tiles
  };

  /// The worker's thread calls `on_news` when take_news() has something new.
  explicit InkWorker(std::function<void()> on_news);
  /// Interrupts the work in progress and ends the thread.
  ~InkWorker();
  InkWorker(const InkWorker&) = delete;
  InkWorker& operator=(const InkWorker&) = delete;

  /// These functions post an order and return its number: open a document, apply an edit, show or
  /// hide a preview, set the view, and drop the tiles of a plane. A plane is the picture of the
  /// drawing at one scale and angle (PlaneSpec). In look(), `over` is a second plane of the same
  /// view, which shows only the layers above PlaneSpec::above; its tiles are made after those of
  /// `plane`.
  std::uint64_t open(Document document);
  std::uint64_t apply(Edit edit);
  std::uint64_t show(std::optional<Edit> preview);
  std::uint64_t look(const PlaneSpec& plane, const PlaneRect& seen,
                     const std::optional<PlaneSpec>& over = {});
  std::uint64_t forget(std::uint64_t plane);

  /// Returns the news since the last call, oldest first, and removes them from the queue.
  [[nodiscard]] std::vector<TileNews> take_news();
  [[nodiscard]] Stage stage() const;
  /// Returns the number of the last order that the visible tiles show.
  [[nodiscard]] std::uint64_t repaired_order() const noexcept { return repaired_.load(); }
  /// Waits for at most `at_most` until the worker reaches `stage`. Returns false if it was not
  /// reached in that time.
  bool wait(Stage stage, std::chrono::microseconds at_most);
  /// Waits until the worker reaches `stage`, without a time limit.
  void wait(Stage stage);

  struct Look {
    PlaneSpec plane;
    PlaneRect seen;
    std::optional<PlaneSpec> over;
  };
  struct Forget {
    std::uint64_t plane = 0;
  };
  using Order = std::variant<Document, Edit, std::optional<Edit>, Look, Forget>;

 private:
  std::uint64_t post(Order order);
  void run();
  bool take_orders(std::deque<Order>& orders, std::uint64_t& last);
  void set_stage(Stage stage, std::uint64_t order);
  void publish(std::vector<TileNews> news);

  std::function<void()> on_news_;
  mutable std::mutex mutex_;
  std::condition_variable has_orders_, has_stage_;
  std::deque<Order> orders_;
  std::vector<TileNews> news_;
  std::uint64_t posted_ = 0;
  Stage stage_ = Stage::kBusy;
  bool is_idle_ = false;  // true if no work is left, not even for the tiles around the view
  std::atomic<bool> has_mail_{false};
  std::atomic<bool> quits_{false};
  std::atomic<std::uint64_t> repaired_{0};
  std::thread thread_;
};

}  // namespace felt::desktop
