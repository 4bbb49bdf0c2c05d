#include "desktop/engine/cue_player.h"

#include <algorithm>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "felt/devices/drivers.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kLookNs = 16'000'000;  // time between two checks of what the session shows
constexpr int kIdleMs = 150;
constexpr int kAgainMs = 2000;
/// Maximum interval between attempts, in ms. Checking costs little, but an attempt to open a
/// device that refuses may block the window for a second.
constexpr int kMaxAgainMs = 60'000;

struct AddedCueDriver {
  int number = 0;
  std::shared_ptr<Driver> driver;
};

std::vector<AddedCueDriver>& cue_drivers() {
  static std::vector<AddedCueDriver> all = [] {
    std::vector<AddedCueDriver> made;
    for (std::unique_ptr<Driver>& driver : make_drivers()) made.push_back({0, std::move(driver)});
    return made;
  }();
  return all;
}

/// Returns the driver and the descriptor of an id; the driver is null if the device is not
/// connected.
std::pair<Driver*, DeviceDescriptor> find_cue_device(const std::string& id) {
  for (const AddedCueDriver& added : cue_drivers()) {
    if (!id.starts_with(std::string(added.driver->name()) + ":")) continue;
    for (DeviceDescriptor& found : added.driver->find()) {
      if (found.kind == DeviceKind::kCue && found.id == id)
        return {added.driver.get(), std::move(found)};
    }
  }
  return {};
}

}  // namespace

std::vector<CueDeviceInfo> cue_devices() {
  std::vector<CueDeviceInfo> infos;
  for (const AddedCueDriver& added : cue_drivers()) {
    for (const DeviceDescriptor& found : added.driver->find()) {
      if (found.kind == DeviceKind::kCue)
        infos.push_back({text_of(found.id), text_of(found.label)});
    }
  }
  return infos;
}

int add_cue_driver(std::shared_ptr<Driver> driver) {
  static int number = 0;
  cue_drivers().push_back({++number, std::move(driver)});
  return number;
}

void remove_cue_driver(int number) {
  std::erase_if(cue_drivers(), [=](const AddedCueDriver& added) { return added.number == number; });
}

CuePlayer::CuePlayer(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
  connect(&studio_.loop(), &HapticLoop::ticked, this, &CuePlayer::take);
  connect(&studio_, &Studio::edited, this, [this] { watch_.edited(); });
  connect(&studio_, &Studio::tick_wanted, this, [this] { law_.report(CueEvent::kTook); });
  connect(&studio_, &Studio::refused, this, [this] { law_.report(CueEvent::kRefused); });
  connect(&studio_.loop(), &HapticLoop::device_changed, this, &CuePlayer::fall_silent);
  idle_.setSingleShot(true);
  idle_.setInterval(kIdleMs);
  connect(&idle_, &QTimer::timeout, this, &CuePlayer::fall_silent);
  again_.setInterval(kAgainMs);
  connect(&again_, &QTimer::timeout, this, &CuePlayer::look_again);
  connect(&Settings::the(), &Settings::changed, this, [this](const QString& key) {
    if (key != QLatin1String(kCueDeviceKey)) return;
    forget_refusal();
    follow_setting();
  });
  follow_setting();
}

CuePlayer::~CuePlayer() = default;

QString CuePlayer::in_use() const {
  return player_ ? text_of(player_->device().descriptor().id) : QString();
}

void CuePlayer::follow_setting() {
  const QString id = Settings::the().text(QString::fromLatin1(kCueDeviceKey));
  if (id == in_use()) return again_.stop();
  if (!find_cue_device(id.toStdString()).first) {
    use({});
    forget_refusal();
    if (!id.isEmpty()) again_.start();
    return;
  }
  if (use(id)) {
    forget_refusal();
    return again_.stop();
  }
  again_.start(refusal_.tries++ == 0 ? kAgainMs : std::min(2 * again_.interval(), kMaxAgainMs));
}

/// Tries again to open the chosen device. A device that is connected but does not open may open
/// soon: the system sets the permissions only after the device file appears, and a wireless mouse
/// may be asleep.
void CuePlayer::look_again() {
  const QString id = Settings::the().text(QString::fromLatin1(kCueDeviceKey));
  if (find_cue_device(id.toStdString()).first) return follow_setting();
  forget_refusal();
}

void CuePlayer::forget_refusal() {
  refusal_ = {};
  again_.setInterval(kAgainMs);
}

bool CuePlayer::use(const QString& id) {
  const bool had_one = player_ != nullptr;
  player_.reset();
  law_.reset();
  is_silent_ = true;
  if (!id.isEmpty()) {
    const auto [driver, descriptor] = find_cue_device(id.toStdString());
    Result<std::unique_ptr<CueDevice>> device =
        driver ? driver->open_cue(descriptor)
               : fail(ErrorCode::kNotFound, "there is no haptic device \"" + id.toStdString() +
                                                "\" now: is it plugged in and switched on?");
    if (!device) {
      if (had_one) Q_EMIT changed();
      const QString words = QString::fromStdString(device.error().message);
      if (words != std::exchange(refusal_.words, words)) Q_EMIT refused(words);
      return false;
    }
    player_ = std::make_unique<CueThread>(*std::move(device), studio_.loop().thread() != nullptr,
                                          [this, which = ++opened_](DeviceFault) {
                                            QMetaObject::invokeMethod(
                                                this, [this, which] { lose(which); },
                                                Qt::QueuedConnection);
                                          });
  }
  if (had_one || player_) Q_EMIT changed();
  return true;
}

/// Handles a device that was unplugged or went to sleep.
void CuePlayer::lose(int which) {
  if (!player_ || which != opened_) return;
  const QString label = text_of(player_->device().descriptor().label);
  player_.reset();
  is_silent_ = true;
  again_.start();
  Q_EMIT changed();
  Q_EMIT refused(tr("%1 was disconnected. It continues when it is connected again.").arg(label));
}

void CuePlayer::fall_silent() {
  law_.reset();
  if (player_ && !std::exchange(is_silent_, true)) player_->stop();
}

CueFeel CuePlayer::feel() const {
  const Session& session = studio_.session();
  return cue_feel_of(medium_in_hand(session), session.surface());
}

void CuePlayer::take(const TickReport& tick) {
  if (!player_) return;
  idle_.start();
  const std::int64_t now_ns = studio_.now_ns();
  if (!studio_.loop().forces_are_on() || studio_.loop().strength() <= 0.0) return fall_silent();
  if (now_ns - last_look_ns_ >= kLookNs || now_ns < last_look_ns_) {
    last_look_ns_ = now_ns;
    law_.set_feel(feel());
    if (const auto event = watch_.look(studio_.session(), tick.sample)) law_.report(*event);
  }
  CueInput input = cue_input_of(tick.sample, studio_.session().surface());
  input.time_ns = now_ns;
  std::optional<Cue> cue = law_.step(input);
  if (!cue) return;
  cue->intensity *= studio_.loop().strength();
  is_silent_ = cue->waveform == CueWaveform::kNone;
  player_->play(*cue, now_ns);
}

}  // namespace felt::desktop
