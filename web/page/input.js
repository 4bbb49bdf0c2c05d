// Pointers on the sheet: pen, mouse and fingers become samples of the core; fingers, the wheel, the middle button
// and the space key move the view. Every coalesced sample counts; predicted events are never used.

const kSampleSize = 8;      // numbers of one sample: Core.samples()
const kPalmMs = 800;        // a finger within this time after the pen is a palm
const kTapMs = 350;         // limits of a tap with several fingers, as in the desktop program
const kTapPx = 16;
const kSecondFingerMs = 220;  // a second finger within this time makes a line a pinch
const kTurnDeg = 8;         // two fingers that turn by less than this only move and zoom the sheet
const kUprightDeg = 3;      // a sheet that is turned to within this of a right angle snaps to it
const kTurnPx = 40;         // fingers that are closer to each other do not turn the sheet
const kPixelsPerDoubling = 400;
const kFinePixelsPerDoubling = 120;  // a pinch on a touchpad is a wheel with Ctrl

const is_pen = (event) => event.pointerType === 'pen';
const is_touch = (event) => event.pointerType === 'touch';
const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

const direction = (a, b) => (Math.atan2(b.y - a.y, b.x - a.x) * 180) / Math.PI;
const snapped = (angle) => (Math.abs(angle - 90 * Math.round(angle / 90)) <= kUprightDeg ? 90 * Math.round(angle / 90) : angle);

/** Returns the tilt of the pen as in PointerEvent, tiltX and tiltY; NaN if the pointer does not report it. */
export function tilt_of(event) {
  if (!is_pen(event)) return [NaN, NaN];
  if (event.tiltX || event.tiltY) return [event.tiltX, event.tiltY];
  if (event.altitudeAngle === undefined || event.altitudeAngle >= Math.PI / 2) return [event.tiltX ?? NaN, event.tiltY ?? NaN];
  const flat = 1 / Math.tan(Math.max(event.altitudeAngle, 1e-3));
  const degrees = (value) => (Math.atan(value) * 180) / Math.PI;
  return [degrees(Math.cos(event.azimuthAngle) * flat), degrees(Math.sin(event.azimuthAngle) * flat)];
}

/** Returns the samples of a pointer event in an array for Core.samples(). */
export function packed(event, coalesced, touching, modifiers) {
  // A browser that has no coalesced events gives an empty list.
  const events = coalesced?.length ? coalesced : [event];
  const samples = new Float64Array(kSampleSize * events.length);
  events.forEach((one, i) => {
    const [tilt_x, tilt_y] = tilt_of(one);
    samples.set([one.timeStamp, one.clientX, one.clientY, touching ? 1 : 0,
      is_pen(one) ? one.pressure : NaN, tilt_x, tilt_y, modifiers], kSampleSize * i);
  });
  return samples;
}

/**
 * Handles the pointers of `sheet`. `page` gets what they mean:
 *   samples(array), apply(event), cancel(), finish(), pan(dx, dy), zoom(x, y, factor), turn_to(x, y, degrees), touched(x, y),
 *   left(), borrow(kind), give_back(), undo(), redo(), view(), set_view(view)
 */
export class Input {
  constructor(sheet, page) {
    Object.assign(this, { sheet, page, fingers: new Map(), drawing: null, panning: null, modifiers: 0,
      space: false, pen_seen: -Infinity, tap: null, pinch: null, last: null,
      keys_draw: false });  // the pen of the keys is down, so that nothing else moves the pen
    const on = (type, handler, options) => sheet.addEventListener(type, handler.bind(this), options);
    on('pointerdown', (event) => this.down(event, event.getCoalescedEvents?.()));
    on('pointermove', (event) => this.move(event, event.getCoalescedEvents?.()));
    on('pointerup', (event) => this.up(event));
    on('pointercancel', (event) => this.up(event));
    on('pointerleave', (event) => this.leave(event));
    on('lostpointercapture', (event) => this.lost(event));
    on('contextmenu', (event) => event.preventDefault());
    on('wheel', this.wheel, { passive: false });
    // Safari's own gestures, and the magnifier of iOS.
    on('gesturestart', (event) => event.preventDefault());
    // While something scrolls, the browser does not let a touch be cancelled.
    on('touchstart', (event) => { if (event.cancelable) event.preventDefault(); }, { passive: false });
  }

  /** Handles an event that was collected before this object was made (early.js). */
  replay({ event, coalesced }) {
    if (event.type === 'pointerdown') this.down(event, coalesced);
    else if (event.type === 'pointermove') this.move(event, coalesced);
    else this.up(event);
  }

  down(event, coalesced) {
    this.page.touched(event.clientX, event.clientY);
    if (document.activeElement !== this.sheet) this.sheet.focus({ preventScroll: true });
    if (is_pen(event)) this.pen_near(event);
    if (is_touch(event)) return this.finger_down(event);
    if (this.panning || this.drawing !== null) return this.buttons(event, coalesced);
    if (event.button === 1 || (this.space && event.button === 0)) return this.begin_pan(event);
    const erases = event.button === 2 || event.button === 5;
    if (event.button !== 0 && !erases) return;
    if (erases) this.page.borrow('erases');
    this.erases = erases;
    this.button = { 0: 1, 2: 2, 5: 32 }[event.button];  // its bit in `buttons`
    this.begin(event, coalesced);
  }

  move(event, coalesced) {
    if (is_pen(event)) this.pen_near(event);
    if (this.fingers.has(event.pointerId)) return this.finger_move(event, coalesced);
    if (is_touch(event)) return;
    if (this.panning?.id === event.pointerId) return this.pan(event);
    if (this.drawing !== null && this.drawing !== event.pointerId) return;
    // If several buttons are held, a release of one of them is a move.
    if (this.drawing !== null && !(event.buttons & this.button)) return this.end(event);
    if (this.drawing === null && this.keys_draw) return;
    this.send(event, coalesced, this.drawing !== null);
  }

  /** A further button of a pointer that is down: only the release of the first one matters. */
  buttons(event, coalesced) {
    if (this.drawing === event.pointerId) this.send(event, coalesced, true);
  }

  up(event) {
    if (this.fingers.has(event.pointerId)) return this.finger_up(event);
    if (this.panning?.id === event.pointerId) return this.end_pan();
    if (this.drawing === event.pointerId) this.end(event);
  }

  leave(event) {
    if (this.drawing === null && !this.keys_draw && !is_touch(event)) this.page.left();
  }

  lost(event) {
    if (this.drawing === event.pointerId) this.end(event);
    if (this.panning?.id === event.pointerId) this.end_pan();
  }

  begin(event, coalesced) {
    this.drawing = event.pointerId;
    this.began = event.timeStamp;
    try {
      this.sheet.setPointerCapture(event.pointerId);
    } catch { /* the pointer is already gone */ }
    this.send(event, coalesced, true);
  }

  send(event, coalesced, touching) {
    const samples = packed(event, coalesced, touching, this.modifiers);
    this.last = samples.slice(-kSampleSize);
    this.page.samples(samples);
  }

  end(event) {
    this.drawing = null;
    // These events may have no position.
    if (event.type === 'pointercancel' || event.type === 'lostpointercapture') this.lift(event.timeStamp);
    else this.send(event, null, false);
    if (this.erases) this.page.give_back();
    this.erases = false;
  }

  /** Discards the line in progress. */
  cancel() {
    if (this.drawing === null) return;
    this.drawing = null;
    this.page.cancel();
    this.lift(performance.now());
    // The core waits whether the pen comes back immediately; after this, an undo is for the step before.
    this.page.finish();
    if (this.erases) this.page.give_back();
    this.erases = false;
  }

  /** Lifts the pen at its last position. */
  lift(time) {
    const samples = this.last.slice();
    samples[0] = Math.max(time, samples[0]);
    samples[3] = 0;
    this.last = samples;
    this.page.samples(samples);
  }

  // --- View

  begin_pan(event) {
    this.panning = { id: event.pointerId, x: event.clientX, y: event.clientY };
    try {
      this.sheet.setPointerCapture(event.pointerId);
    } catch { /* the pointer is already gone */ }
    event.preventDefault();
  }

  pan(event) {
    this.page.pan(event.clientX - this.panning.x, event.clientY - this.panning.y);
    this.panning.x = event.clientX;
    this.panning.y = event.clientY;
  }

  end_pan() {
    this.panning = null;
  }

  wheel(event) {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 32 : event.deltaMode === 2 ? 400 : 1;
    const dx = event.deltaX * unit, dy = event.deltaY * unit;
    if (event.shiftKey) return this.page.pan(-(dy || dx), 0);
    if (dx) this.page.pan(-dx, 0);
    const doubling = event.ctrlKey ? kFinePixelsPerDoubling : kPixelsPerDoubling;
    if (dy) this.page.zoom(event.clientX, event.clientY, 2 ** (-dy / doubling));
  }

  // --- Fingers

  pen_near(event) {
    this.pen_seen = event.timeStamp;
    // Fingers that are down are a palm.
    if (this.fingers.size === 0) return;
    if (this.drawing !== null && this.fingers.has(this.drawing)) this.cancel();
    for (const finger of this.fingers.values()) finger.palm = true;
    this.pinch = this.tap = null;
  }

  finger_down(event) {
    const palm = event.timeStamp - this.pen_seen < kPalmMs;
    const finger = { x: event.clientX, y: event.clientY, palm };
    if (this.fingers.size === 0) this.tap = { since: event.timeStamp, most: 0, view: this.page.view(), from: new Map() };
    this.fingers.set(event.pointerId, finger);
    if (palm || [...this.fingers.values()].some((one) => one.palm)) {
      this.tap = null;
      return;
    }
    if (this.tap) {
      this.tap.most = Math.max(this.tap.most, this.fingers.size);
      this.tap.from.set(event.pointerId, { ...finger });
    }
    if (this.fingers.size === 1 && this.drawing === null) {
      this.erases = false;
      this.button = 1;
      this.begin(event, event.getCoalescedEvents?.());
    } else if (this.fingers.size === 2 && this.fingers.has(this.drawing)) {
      // A long line goes on if another finger touches; a short one, or a finger that only rests, was the begin of a pinch.
      if (event.timeStamp - this.began > kSecondFingerMs && !this.tap) return;
      this.cancel();
      this.begin_pinch();
    } else if (this.drawing === null) {
      this.begin_pinch();
    }
  }

  finger_move(event, coalesced) {
    const finger = this.fingers.get(event.pointerId);
    finger.x = event.clientX;
    finger.y = event.clientY;
    const from = this.tap?.from.get(event.pointerId);
    if (from && distance(from, finger) > kTapPx) this.tap = null;
    if (this.drawing === event.pointerId) this.send(event, coalesced, true);
    else if (this.pinch) this.move_pinch();
  }

  finger_up(event) {
    this.fingers.delete(event.pointerId);
    const tap = this.tap;
    // The browser took over the finger, or it is a palm.
    if (this.drawing === event.pointerId && event.type === 'pointercancel') this.cancel();
    if (this.drawing === event.pointerId) this.end(event);
    if (this.pinch) this.begin_pinch();
    if (this.fingers.size > 0) return;
    this.pinch = this.tap = null;
    this.page.left();
    if (!tap || tap.most < 2 || event.type === 'pointercancel' || event.timeStamp - tap.since > kTapMs) return;
    this.page.set_view(tap.view);
    if (tap.most === 2) this.page.undo();
    if (tap.most === 3) this.page.redo();
  }

  begin_pinch() {
    const pinch = this.between_fingers();
    if (pinch) pinch.turn = { view: this.page.view(), by: 0, free: null };
    this.pinch = pinch;
  }

  /** Returns where the first two fingers are, or the only one; null if there is none. */
  between_fingers() {
    const [a, b] = [...this.fingers.values()];
    if (!a) return null;
    return b ? { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: distance(a, b), direction: direction(a, b) }
      : { x: a.x, y: a.y, apart: 0, direction: 0 };
  }

  move_pinch() {
    const before = this.pinch, now = { ...this.between_fingers(), turn: before.turn };
    this.pinch = now;
    this.page.pan(now.x - before.x, now.y - before.y);
    if (before.apart > 8 && now.apart > 8) this.page.zoom(now.x, now.y, now.apart / before.apart);
    if (Math.min(before.apart, now.apart) > kTurnPx) this.turn(now, now.direction - before.direction);
  }

  /** Turns the sheet with the fingers, by these degrees since the last move. */
  turn({ x, y, turn }, degrees) {
    turn.by += degrees - 360 * Math.round(degrees / 360);
    if (turn.free === null && Math.abs(turn.by) > kTurnDeg) turn.free = Math.sign(turn.by) * kTurnDeg;
    if (turn.free === null) return;
    const { angle, mirrored } = turn.view;
    this.page.turn_to(x, y, snapped(angle + (mirrored ? -1 : 1) * (turn.by - turn.free)));
  }

  // --- Keys

  /** Sets Shift (1), Ctrl (2) and Alt (4). They take effect even while the pen rests. */
  set_modifiers(event) {
    const modifiers = (event.shiftKey ? 1 : 0) + (event.ctrlKey || event.metaKey ? 2 : 0) + (event.altKey ? 4 : 0);
    if (modifiers === this.modifiers) return;
    this.modifiers = modifiers;
    if (!this.last || this.keys_draw) return;
    const samples = this.last.slice();
    samples[0] = Math.max(event.timeStamp, samples[0]);
    samples[7] = modifiers;
    this.last = samples;
    this.page.samples(samples);
  }

  /** The window lost the focus: keys and fingers count as released; if it is hidden, so does every pointer. */
  release_all(is_hidden = false) {
    this.space = false;
    this.sheet.classList.remove('pans');
    this.panning = this.pinch = this.tap = null;
    if (this.drawing !== null && (is_hidden || this.fingers.has(this.drawing))) this.end({ type: 'pointercancel', timeStamp: performance.now() });
    this.fingers.clear();
    this.set_modifiers({ shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, timeStamp: performance.now() });
  }
}
