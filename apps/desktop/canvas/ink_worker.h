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

/// A thread that keeps tiles of a document up to date. Everything that is asked of it is an order
/// with a number; orders are carried out in turn, previews that another one overtook left out.
/// Made first: tiles on the screen that an edit changed, then those that are missing, from the
/// middle outwards, then a ring around the view. All calls are for one other thread and return at
/// once, but for `wait`.
class InkWorker {
 public:
  /// What of all orders and of the view is done.
  enum class Stage {
    kBusy,      ///< an order waits, or a tile on the screen shows what was
    kRepaired,  ///< whatever tile of the view is there is right
    kComplete,  ///< the view has all its tiles
  };

  /// `on_news` is called in the worker's thread when there is something to take.
  explicit InkWorker(std::function<void()> on_news);
  /// Leaves off in the middle of any work.
  ~InkWorker();
  InkWorker(const InkWorker&) = delete;
  InkWorker& operator=(const InkWorker&) = delete;

  /// Each gives back the number of the order.
  std::uint64_t open(Document document);
  std::uint64_t apply(Edit edit);
  std::uint64_t show(std::optional<Edit> preview);
  std::uint64_t look(const PlaneSpec& plane, const PlaneRect& seen,
                     const std::optional<PlaneSpec>& over = {});
  std::uint64_t forget(std::uint64_t plane);

  /// Takes what is new since the last time, in the order in which it was made.
  [[nodiscard]] std::vector<TileNews> take_news();
  [[nodiscard]] Stage stage() const;
  /// The last order that the tiles on the screen show.
  [[nodiscard]] std::uint64_t repaired_order() const noexcept { return repaired_.load(); }
  /// Waits for a stage, at most so long. False: it was not reached.
  bool wait(Stage stage, std::chrono::microseconds at_most);
  /// Likewise, as long as it takes.
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
  bool is_idle_ = false;  // nothing is left to do, not even around the view
  std::atomic<bool> has_mail_{false};
  std::atomic<bool> quits_{false};
  std::atomic<std::uint64_t> repaired_{0};
  std::thread thread_;
};

}  // namespace felt::desktop
