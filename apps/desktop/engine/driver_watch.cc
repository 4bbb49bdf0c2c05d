#include "desktop/engine/driver_watch.h"

#include <QCoreApplication>
#include <QPointer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <utility>

#include "desktop/engine/text_of.h"
#include "felt/rt/abandon.h"

namespace felt::desktop {
namespace {

DriverWatch* the_watch = nullptr;
int watchers = 0;

PenDeviceInfo info_of(const DeviceDescriptor& device) {
  PenDeviceInfo info;
  info.id = text_of(device.id);
  info.label = text_of(device.label);
  info.moves_hand = device.capabilities.has_force();
  info.has_own_frame = device.has_own_frame;
  info.is_connected = device.is_connected;
  info.serial = text_of(device.serial);
  info.capabilities = device.capabilities;
  info.note =
      QCoreApplication::translate("PenDevice", "You hold it in your hand and feel the forces.");
  return info;
}

}  // namespace

/// A driver, and the lock for the call that uses it.
struct DriverWatch::Slot {
  std::unique_ptr<Driver> driver;
  std::timed_mutex busy;
  std::atomic<bool> is_stuck{false};  // the library hangs: never call it again
};

/// The state that the search thread shares with the watch. A hanging search thread may outlive the
/// watch.
struct DriverWatch::Looking {
  std::vector<std::shared_ptr<Slot>> slots;
  std::atomic<std::size_t> at{0};  // the driver that is being asked
  std::mutex mutex;
  DriverWatch* watch = nullptr;  // null if the result is no longer needed

  /// Asks all drivers that answer, one after the other.
  template <class Ask>
  void ask_all(const Ask& ask) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (slots[i]->is_stuck) continue;
      at = i;
      const std::lock_guard lock(slots[i]->busy);
      ask(*slots[i]);
    }
  }
  /// Calls `answer` with the watch on the main thread, unless the result is no longer needed.
  template <class Answer>
  void report(Answer answer) {
    const std::lock_guard lock(mutex);
    if (watch == nullptr) return;
    QMetaObject::invokeMethod(
        watch, [to = watch, answer = std::move(answer)]() mutable { answer(*to); },
        Qt::QueuedConnection);
  }
};

DriverWatch::DriverWatch(std::vector<std::unique_ptr<Driver>> drivers, QObject* parent,
                         int stuck_ms)
    : QObject(parent), stuck_ms_(stuck_ms) {
  for (auto& driver : drivers) {
    slots_.push_back(std::make_shared<Slot>());
    slots_.back()->driver = std::move(driver);
  }
  begin_looking();
  timer_.setInterval(kLookMs);
  connect(&timer_, &QTimer::timeout, this, &DriverWatch::look);
  pens_ = add_pen_driver(
      {[this] { return found_; },
       [this](const QString& id, DeviceSetup setup) { return open(id, std::move(setup)); }});
  the_watch = this;
  set_pace();
}

DriverWatch::~DriverWatch() {
  if (the_watch == this) the_watch = nullptr;
  remove_pen_driver(pens_);
  looker_->clear();
  if (!looker_->waitForDone(kPatienceMs)) give_up_looking();
}

void DriverWatch::begin_looking() {
  looker_ = std::make_unique<QThreadPool>();
  looker_->setMaxThreadCount(1);
  looking_ = std::make_shared<Looking>();
  looking_->slots = slots_;
  looking_->watch = this;
}

/// Abandons the search thread because a library hangs; the thread's result is ignored.
void DriverWatch::give_up_looking() {
  looking_->slots[looking_->at]->is_stuck = true;
  {
    const std::lock_guard lock(looking_->mutex);
    looking_->watch = nullptr;
  }
  looker_->clear();
  abandon(std::move(looker_));
}

DriverWatch* DriverWatch::the() noexcept {
  return the_watch;
}

const PenDeviceInfo* DriverWatch::find(const QString& id) const noexcept {
  const auto at = std::find_if(found_.begin(), found_.end(),
                               [&id](const PenDeviceInfo& info) { return info.id == id; });
  return at == found_.end() ? nullptr : &*at;
}

std::shared_ptr<DriverWatch::Slot> DriverWatch::slot_of(const QString& id) const noexcept {
  const QString name = id.section(QLatin1Char(':'), 0, 0);
  for (const auto& slot : slots_) {
    if (name == text_of(slot->driver->name())) return slot;
  }
  return nullptr;
}

bool DriverWatch::knows(const QString& id) const noexcept {
  return slot_of(id) != nullptr;
}

/// Starts a search unless one is running. If that search has run for `stuck_ms_`, abandons it with
/// its thread and starts another thread without the driver that hangs.
void DriverWatch::look() {
  if (std::exchange(is_looking_, true)) {
    if (since_look_.elapsed() < stuck_ms_ || slots_.empty()) return;
    give_up_looking();
    begin_looking();
  }
  since_look_.start();
  looker_->start([looking = looking_] {
    std::vector<DeviceDescriptor> found;
    looking->ask_all([&found](Slot& slot) {
      for (DeviceDescriptor& device : slot.driver->find()) found.push_back(std::move(device));
    });
    looking->report(
        [found = std::move(found)](DriverWatch& watch) mutable { watch.take(std::move(found)); });
  });
}

void DriverWatch::take(std::vector<DeviceDescriptor> found) {
  is_looking_ = false;
  descriptors_ = std::move(found);
  std::vector<PenDeviceInfo> pens;
  std::vector<std::pair<QString, QString>> cues;
  for (const DeviceDescriptor& device : descriptors_) {
    const auto slot = slot_of(text_of(device.id));
    if (!slot) continue;
    if (device.kind == DeviceKind::kCue) {
      cues.emplace_back(text_of(device.id), text_of(device.label));
      continue;
    }
    pens.push_back(info_of(device));
  }
  const auto ids = [](const std::vector<PenDeviceInfo>& list) {
    std::vector<std::pair<QString, bool>> all;
    all.reserve(list.size());
    for (const PenDeviceInfo& info : list) all.emplace_back(info.id, info.is_connected);
    return all;
  };
  const bool is_other = ids(pens) != ids(found_) || cues != cues_;
  found_ = std::move(pens);
  cues_ = std::move(cues);
  has_looked_ = true;
  if (is_other) Q_EMIT changed();
  Q_EMIT looked();
}

Result<std::unique_ptr<OpenDevice>> DriverWatch::open(const QString& id, DeviceSetup setup) {
  const auto slot = slot_of(id);
  const auto device = std::find_if(
      descriptors_.begin(), descriptors_.end(),
      [&id](const DeviceDescriptor& descriptor) { return text_of(descriptor.id) == id; });
  if (!slot || device == descriptors_.end()) {
    return fail(ErrorCode::kNotFound, "\"" + id.toStdString() + "\" is not plugged in");
  }
  const std::unique_lock lock(slot->busy, std::chrono::milliseconds(kPatienceMs));
  if (!lock.owns_lock()) {
    return fail(ErrorCode::kIo, "the driver \"" + std::string(slot->driver->name()) +
                                    "\" does not answer: unplug the device and plug it in again");
  }
  setup.driver_lock = {slot, &slot->busy};  // also keeps the driver alive
  return OpenDevice::open(*slot->driver, *device, setup);
}

void DriverWatch::diagnose(QObject* asker,
                           std::function<void(std::vector<DriverFindings>)> answer) {
  looker_->start(
      [looking = looking_, asker = QPointer<QObject>(asker), answer = std::move(answer)]() mutable {
        std::vector<DriverFindings> all;
        looking->ask_all([&all](Slot& slot) {
          all.push_back({text_of(slot.driver->label()), slot.driver->diagnose(this_system())});
        });
        looking->report([asker = std::move(asker), answer = std::move(answer),
                         all = std::move(all)](DriverWatch&) mutable {
          if (asker) answer(std::move(all));
        });
      });
}

void DriverWatch::set_pace() {
  if (watchers == 0) return timer_.stop();
  if (timer_.isActive()) return;
  timer_.start();
  look();
}

DriverWatch::Watching::Watching() {
  ++watchers;
  if (the_watch) the_watch->set_pace();
}

DriverWatch::Watching::~Watching() {
  --watchers;
  if (the_watch) the_watch->set_pace();
}

}  // namespace felt::desktop
