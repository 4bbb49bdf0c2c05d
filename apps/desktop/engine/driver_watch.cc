#include "desktop/engine/driver_watch.h"

#include <QCoreApplication>
#include <QPointer>
#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

namespace felt::desktop {
namespace {

DriverWatch* the_watch = nullptr;
int watchers = 0;

QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

/// Ids of what is open, over all windows.
std::vector<QString>& open_ids() {
  static std::vector<QString> ids;
  return ids;
}

PenDeviceInfo info_of(const DeviceDescriptor& device, const PlaneCalibration& plane) {
  PenDeviceInfo info;
  info.id = text_of(device.id);
  info.label = text_of(device.label);
  info.moves_hand = device.capabilities.has_force();
  info.has_own_frame = device.has_own_frame;
  info.is_connected = device.is_connected;
  info.serial = text_of(device.serial);
  info.capabilities = device.capabilities;
  info.default_plane = plane;
  info.note = QCoreApplication::translate("PenDevice", "A person holds it, and feels the forces.");
  return info;
}

}  // namespace

/// A driver, and who talks to it at present.
struct DriverWatch::Slot {
  std::unique_ptr<Driver> driver;
  std::timed_mutex busy;
};

/// A driver's device as a pen, in its own frame.
class DriverWatch::DriverPen final : public PenDevice {
 public:
  DriverPen(PenDeviceInfo info, std::shared_ptr<Slot> slot, std::unique_ptr<DriverDevice> device)
      : info_(std::move(info)), slot_(std::move(slot)), device_(std::move(device)) {
    // Open, it knows more.
    info_.capabilities = device_->capabilities();
    info_.moves_hand = info_.capabilities.has_force();
    if (!device_->descriptor().serial.empty()) info_.serial = text_of(device_->descriptor().serial);
    if (!device_->descriptor().label.empty()) info_.label = text_of(device_->descriptor().label);
    open_ids().push_back(info_.id);
  }
  DriverPen(const DriverPen&) = delete;
  DriverPen& operator=(const DriverPen&) = delete;
  ~DriverPen() override {
    const auto at = std::find(open_ids().begin(), open_ids().end(), info_.id);
    if (at != open_ids().end()) open_ids().erase(at);
    const std::lock_guard lock(slot_->busy);
    device_.reset();
  }

  [[nodiscard]] const PenDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Device& device() noexcept override { return *device_; }
  [[nodiscard]] HandInput* hand() noexcept override { return nullptr; }
  [[nodiscard]] const HandScriptOptions& hand_options() const noexcept override { return options_; }
  [[nodiscard]] DeviceStatus status() noexcept override { return device_->status(); }
  bool set_pen_down(bool is_down) noexcept override { return device_->set_pen_down(is_down); }
  [[nodiscard]] LoopHost* loop_host() noexcept override { return device_->loop_host(); }
  [[nodiscard]] Homing homing() noexcept override { return device_->homing(); }
  [[nodiscard]] QString homing_words() override { return text_of(device_->homing_words()); }
  Result<void> find_home() override {
    const std::lock_guard lock(slot_->busy);
    return device_->find_home();
  }

 private:
  PenDeviceInfo info_;
  std::shared_ptr<Slot> slot_;
  std::unique_ptr<DriverDevice> device_;
  HandScriptOptions options_;
};

DriverWatch::DriverWatch(std::vector<std::unique_ptr<Driver>> drivers, QObject* parent)
    : QObject(parent) {
  for (auto& driver : drivers) {
    slots_.push_back(std::make_shared<Slot>());
    slots_.back()->driver = std::move(driver);
  }
  looker_.setMaxThreadCount(1);
  timer_.setInterval(kLookMs);
  connect(&timer_, &QTimer::timeout, this, &DriverWatch::look);
  pens_ = add_pen_driver(
      {[this] { return found_; },
       [this](const QString& id, const OpenOptions& options) { return open(id, options); }});
  the_watch = this;
  set_pace();
}

DriverWatch::~DriverWatch() {
  if (the_watch == this) the_watch = nullptr;
  remove_pen_driver(pens_);
  looker_.clear();
  looker_.waitForDone();
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

void DriverWatch::look() {
  if (std::exchange(is_looking_, true)) return;
  looker_.start([this] {
    std::vector<DeviceDescriptor> found;
    for (const auto& slot : slots_) {
      const std::lock_guard lock(slot->busy);
      for (DeviceDescriptor& device : slot->driver->find()) found.push_back(std::move(device));
    }
    // Not delivered to a watch that is no more.
    QMetaObject::invokeMethod(
        this, [this, found = std::move(found)]() mutable { take(std::move(found)); },
        Qt::QueuedConnection);
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
    pens.push_back(info_of(device, slot->driver->default_plane(device, {})));
  }
  const auto ids = [](const std::vector<PenDeviceInfo>& list) {
    std::vector<std::pair<QString, bool>> all;
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

Result<std::unique_ptr<PenDevice>> DriverWatch::open(const QString& id,
                                                     const OpenOptions& options) {
  const auto slot = slot_of(id);
  const auto device = std::find_if(
      descriptors_.begin(), descriptors_.end(),
      [&id](const DeviceDescriptor& descriptor) { return text_of(descriptor.id) == id; });
  const PenDeviceInfo* info = find(id);
  if (!slot || !info || device == descriptors_.end()) {
    return fail(ErrorCode::kNotFound, "\"" + id.toStdString() + "\" is not plugged in");
  }
  const std::unique_lock lock(slot->busy, std::chrono::milliseconds(kPatienceMs));
  if (!lock.owns_lock()) {
    return fail(ErrorCode::kIo, "the driver \"" + std::string(slot->driver->name()) +
                                    "\" does not answer: unplug the device and plug it in again");
  }
  Result<std::unique_ptr<DriverDevice>> opened = slot->driver->open(*device, options);
  if (!opened) return tl::unexpected(opened.error());
  PenDeviceInfo seen = *info;
  seen.default_plane = slot->driver->default_plane((*opened)->descriptor(), options);
  return std::make_unique<DriverPen>(std::move(seen), slot, *std::move(opened));
}

void DriverWatch::diagnose(QObject* asker,
                           std::function<void(std::vector<DriverFindings>)> answer) {
  looker_.start([this, asker = QPointer<QObject>(asker), answer = std::move(answer)]() mutable {
    std::vector<DriverFindings> all;
    for (const auto& slot : slots_) {
      const std::lock_guard lock(slot->busy);
      all.push_back({text_of(slot->driver->label()), slot->driver->diagnose(this_system())});
    }
    QMetaObject::invokeMethod(
        this,
        [asker = std::move(asker), answer = std::move(answer), all = std::move(all)]() mutable {
          if (asker) answer(std::move(all));
        },
        Qt::QueuedConnection);
  });
}

bool DriverWatch::is_open(const QString& id) {
  return std::find(open_ids().begin(), open_ids().end(), id) != open_ids().end();
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
