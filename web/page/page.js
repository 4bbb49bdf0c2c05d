// The page: connects the core (session, tools, forces, rasteriser) with the sheet, the bars and the browser.
import { make, choices } from './dom.js';
import { t, d, languages, set_language, current_language } from './words.js';
import { Input } from './input.js';
import { Keys, key_name, key_table } from './keys.js';
import { Bars, OfferBar, Menu } from './bars.js';
import { OptionsPanel, LayersPanel } from './panels.js';
import { ForcePanel, Sound, play_cue } from './forces.js';
import { MarksView } from './marks.js';
import { Files, kPictures } from './files.js';
import { Clipboard } from './clipboard.js';
import { Storage } from './storage.js';

const kLifeSize = 96 / 25.4;      // CSS pixels per mm
const kMinScale = 0.05, kMaxScale = 400;
const kIdleMs = 400;              // the frames stop when nothing has happened for this time
const kAutosaveMs = 500;          // longest time between a gesture and its place in the autosave
const kRebaseBytes = 8e6;         // of recorded events; then the autosave begins again with the drawing
const kRetryMs = 10_000;          // after a failed write, the whole drawing is written again
const kRestartMs = 20_000, kMaxRestarts = 3;  // a core that ends more often within this time ends because of the drawing
const kNoticeMs = 6000, kSlowMs = 3000;
const kAnswerMs = 2000;           // a browser that does not answer within this time has no storage for now
const kReadMs = 10_000;           // the same for the drawing, which may be large
const kSettleMs = 40;
const kMaxAgain = 20_000;         // calls of samples(), some minutes of drawing
const kMarginPx = 16;             // around a sheet that is fitted into the window
const kWarmUpMs = 100;
const kFirstEvents = ['undo', 'redo', 'cancel'];  // the first module handles them
const kOfSelection = ['delete', 'duplicate', 'order', 'move', 'exact', 'as-drawn'];  // events that do nothing without one
const kTooLarge = 2, kNotSupported = 5;  // ErrorCode of the library
const kCatSpeed = 3, kCatShare = 0.7;  // of the page
const by_id = (id) => document.getElementById(id);

class LoadError extends Error {}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** Resolves when the script with this name has run. */
function script(name) {
  const { missing, failed } = globalThis.feltlineEarly ?? {};
  if (missing?.includes(name)) return Promise.reject(new LoadError(name));
  if (failed) return Promise.reject(new Error(failed));
  const element = document.querySelector(`script[src="${name}"]`) ?? make('script', { src: name, async: true });
  return new Promise((resolve, reject) => {
    element.addEventListener('load', resolve);
    element.addEventListener('error', () => reject(new LoadError(name)));
    if (!element.isConnected) document.head.append(element);
  });
}

/** Returns strokes, which are lines of JSON, moved to the middle of the page, and a scale at which they fit. */
function in_the_middle(lines, page) {
  const strokes = lines.trim().split('\n').map((line) => JSON.parse(line));
  const points = strokes.flatMap((stroke) => stroke.points);
  const [left, top] = [0, 1].map((axis) => Math.min(...points.map((point) => point[axis])));
  const [right, bottom] = [0, 1].map((axis) => Math.max(...points.map((point) => point[axis])));
  const mmPerUnit = Math.min((kCatShare * page.width) / (right - left), (kCatShare * page.height) / (bottom - top));
  const dx = page.width / mmPerUnit / 2 - (left + right) / 2, dy = page.height / mmPerUnit / 2 - (top + bottom) / 2;
  for (const point of points) [point[0], point[1]] = [point[0] + dx, point[1] + dy];
  return { text: strokes.map((stroke) => JSON.stringify(stroke)).join('\n'), mmPerUnit };
}

/** Returns true if a layer has a stroke, a fill or a picture; `state`: of the core. */
const has_content = ({ layers }) => layers.some(({ strokes, picture }) => strokes > 0 || picture);

class Page {
  constructor() {
    this.sheet = by_id('sheet');
    this.marks = new MarksView(by_id('marks'));
    this.shown = { forces: false, options: false, layers: false };
    this.gestures = 0;
    this.active_until = 0;
    this.is_away = true;  // the pointer is not over the sheet
    // What was done in the first module before the storage has answered; null: it has.
    this.again = [];
    this.last = null;  // the stored drawing with which complete_core() continues
    this.waiting = [];  // what to do when the core is complete: { act, is_first }; is_first: the first module can do it, too
    this.is_replaying = false;  // what has waited is being done
    this.wants_sound = choices.get('sound') === 'on';
    this.frame = (now) => this.run_frame(now);
    this.menu = new Menu(this);
    this.bars = new Bars(this);
    this.offers = new OfferBar(this);
    this.files = new Files(this);
    this.clipboard = new Clipboard(this);
    this.options = new OptionsPanel(this);
    this.layers = new LayersPanel(this);
    this.forces = new ForcePanel(this);
    this.sound = new Sound(() => this.core);
    by_id('panels').append(this.options.element, this.layers.element, this.forces.element);
    for (const [id, name] of [['offer', '--offered'], ['notice', '--said']]) {
      const show_height = () => document.documentElement.style.setProperty(name, `${by_id(id).offsetHeight && by_id(id).offsetHeight + 8}px`);
      new ResizeObserver(show_height).observe(by_id(id));
    }
    this.show_words();
  }

  // --- Start

  async start() {
    this.context = this.sheet.getContext('2d', { alpha: false, desynchronized: true });
    this.answered = this.open_storage();
    await (globalThis.feltlineCore ?? script('core.js'));
    await this.make_core();
    if (this.lasting) this.end_notice();
    this.show_words();
    this.listen();
    this.wake();
    performance.mark('interactive');
    // The full module would keep the browser from ending the load of the page.
    if (document.readyState !== 'complete') await new Promise((resolve) => addEventListener('load', resolve));
    // Loaded now, so that the page needs no request later, even without a network.
    if (!navigator.connection?.saveData) this.complete();
    this.answered.then(() => { if (this.last) this.complete(); });
  }

  /**
   * Opens the storage. Nothing waits for it but the full module, which continues the drawing of the last visit. Resolves
   * when the storage has answered, or is not expected to.
   */
  open_storage() {
    const storage = new Storage();
    // The user must know before the page is closed.
    const slow = setTimeout(() => this.say_not_stored(), kAnswerMs);
    const opened = storage.open().finally(() => clearTimeout(slow)).then((last) => this.use_storage(storage, last)).catch((error) => {
      console.info('Feltline: no storage:', error);
      this.again = null;
      this.say_not_stored();
    });
    return Promise.race([opened, pause(kAnswerMs).then(() => (storage.slot ? pause(kReadMs) : undefined))]);
  }

  /** The storage has answered: it is used from now on. */
  async use_storage(storage, last) {
    this.others = await storage.others().catch(() => []);
    await this.wait_for_core();
    const { core } = this, is_late = last && core.isComplete, loaded = is_late && await this.prepare(core, last);
    this.settle();
    const stays = last && this.has_own_drawing(core);
    if (stays) await storage.leave_slot();
    this.storage = storage;
    this.last = stays ? null : last;
    this.watch_storage();
    // Otherwise a browser may delete the drawing when it needs room. Some ask the user, so there must be a drawing.
    this.sheet.addEventListener('pointerup', () => navigator.storage?.persist?.().catch(() => {}), { once: true });
    if (!this.last) {
      this.begin_to_store(stays);
    } else if (is_late) {
      this.guard(() => this.continue_with(loaded.ok ? this.begin_with(this.core, last) : loaded));
    } else {
      // complete_core() continues with it. Until then nothing is stored, which the user must know if it takes long.
      setTimeout(() => {
        this.is_slow = true;
        this.wake();
      }, kAnswerMs);
      if (this.lasting) this.say_loading();
      // Otherwise start() does this later.
      if (document.readyState === 'complete') this.complete();
    }
    this.wake();
  }

  /** True if something was drawn that cannot be drawn again into the stored drawing. */
  has_own_drawing(core) {
    return (core.isComplete || !this.again) && !this.is_blank();
  }

  /** The present drawing is stored from now on. `stays`: the stored one stays in another slot. */
  begin_to_store(stays) {
    this.last = this.again = null;
    this.end_lasting();
    this.guard((core) => core.rebase());
    this.store_due = true;
    if (stays) this.say(t('Other drawings are in the menu.'));
  }

  /** Keeps what was done in the first module, for continue_with(). If it becomes too much, the stored drawing stays where it is. */
  remember(act) {
    if (this.core && this.again?.length >= kMaxAgain) {
      this.settle();
      this.again = this.is_blank() ? [] : null;
    }
    this.again?.push(act);
  }

  /** True while a pointer or the keys draw. The core starts the gesture a moment later. */
  get draws() {
    return Boolean(this.input) && (this.input.drawing !== null || this.input.keys_draw);
  }

  /** True if the drawing has nothing, nothing can be undone or redone, and nothing is being drawn. */
  is_blank() {
    return !this.draws && !this.core.state().gesture && this.is_empty();
  }

  /** Does not count a line in progress. */
  is_empty() {
    const state = this.core.state();
    return !has_content(state) && state.undo === null && state.redo === null;
  }

  /** The core has begun with the stored drawing, or has refused it. Draws again what was drawn before that. */
  continue_with(done) {
    const { last, again } = this;
    this.last = this.again = null;
    if (!this.storage?.is_broken) this.end_lasting();
    this.is_paused = !done.ok;
    this.record_bytes = last.recorded.length;
    const view = this.core.view();
    if (again?.length > 0) {
      this.is_replaying = true;
      this.sample_time = null;
      if (this.is_empty()) this.guard((core) => core.setPage(this.window_page()));
      this.guard((core) => core.event({ event: 'tool', id: 'pencil' }));
      for (const act of again) this.guard(act);
      this.settle();
      this.is_replaying = false;
      this.set_view(view);
    } else {
      this.fit();
    }
    if (this.storage?.is_broken) this.guard((core) => core.rebase());
    if (!done.ok) this.ask_about(last, this.reason(done));
    else if (has_content(this.core.state())) {
      this.say(t('Restored the drawing of your last visit.') + (this.others.length > 0 ? ` ${t('Other drawings are in the menu.')}` : ''));
    }
    this.layers.ink_layers = this.core.state().inkLayers;  // those of the last visit were announced then
    this.wake();
  }

  /**
   * Loads the full module, which has everything that the first one lacks, and continues with it. This takes a moment, so it
   * waits until no line is drawn. Then does what has waited for it. If the page has no core, or another one meanwhile, waits for
   * that one.
   */
  complete() {
    this.completing ??= this.complete_core().finally(() => { this.completing = null; });
    return this.completing;
  }

  /** Resolves when the page has a core, which it does not while the program is loaded or restarted. */
  async wait_for_core() {
    while (!this.core) await pause(kWarmUpMs);
  }

  async complete_core() {
    await this.wait_for_core();
    const { core } = this, was_complete = core.isComplete;
    let done, loaded = { ok: true }, stays = false;
    // Resolves to the stored drawing that the full module continues with.
    const is_free = async () => {
      await this.answered;
      let last;
      do {
        ({ last } = this);
        if (last?.base && core.isFelt(last.base)) loaded = await core.prepareFelt();
        while (this.draws && this.waiting.length === 0) await pause(kWarmUpMs);
      } while (last !== this.last);
      this.settle();
      if (this.again && this.is_blank()) this.again = [];
      stays = Boolean(last) && this.has_own_drawing(core);
      return loaded.ok && !stays ? last : null;
    };
    try {
      done = await core.complete(is_free);
    } catch (error) {
      this.recover(core, error);
    }
    if (this.core !== core) return this.complete_core();  // it has ended meanwhile
    this.incomplete = !done.ok;
    if (this.last && !was_complete) {
      // Without the full module, the first one has what was drawn.
      if (!done.ok || !loaded.ok) this.again = null;
      if (done.ok && stays) await this.storage.leave_slot().then(() => this.begin_to_store(true), () => this.say_not_stored());
      else this.guard(() => this.continue_with(done.continued ?? (done.ok ? loaded : done)));
    }
    if (done.ok) this.again = null;
    if (done.ok) performance.mark('complete');
    if (done.ok && this.device) core.setDevice(this.device);
    if (!done.ok && this.waiting.length > 0) this.say(`${this.reason(done).replace(/\.?$/, '.')} ${t('Until you reload the page, only the pencil works.')}`);
    this.do_waiting(core);
    if (done.ok) setTimeout(() => this.warm_up(), kWarmUpMs);
    // What .felt files need is loaded now as well, but used only when one is opened or saved.
    if (done.ok && !navigator.connection?.saveData) core.loadFelt();
    this.wake();
    return done;
  }

  get is_waiting() {
    return this.waiting.length > 0 && !this.is_replaying;
  }

  /**
   * Does what has waited, in order, while the core is this one: another one continues with the rest. If the full module is
   * missing, does what the first one can, so that no line is lost, and drops the rest.
   */
  do_waiting(core) {
    this.is_replaying = true;
    this.sample_time = null;
    while (this.waiting.length > 0 && this.core === core) {
      const { act, is_first } = this.waiting.shift();
      if (core.isComplete || is_first) this.guard(act);
    }
    this.is_replaying = false;
  }

  /** Lets the core prepare grain, forces and sound, when no line is drawn. */
  warm_up() {
    if (this.input.drawing !== null) return setTimeout(() => this.warm_up(), kWarmUpMs);
    this.guard((core) => core.warmUp());
    this.wake();
  }

  /** Does this as soon as the core is complete. While something waits, everything else that changes the drawing does, too. */
  when_complete(act, is_first = false) {
    if (this.core?.isComplete && !this.is_waiting) return act();
    this.settle();
    this.waiting.push({ act, is_first });
    if (this.core) this.complete();
    return undefined;
  }

  /**
   * Makes a core that continues with the drawing `last`, { base, page, recorded }, if there is one. The page has no core
   * until this is done, so that nothing is stored meanwhile. If it fails, the sheet is empty or has a part of the drawing,
   * and nothing is stored until the user decides: ask_about().
   */
  async make_core(last = null) {
    const { innerWidth: width, innerHeight: height } = globalThis;
    const make_one = () => globalThis.feltlineCore.createCore({ width, height, dpr: devicePixelRatio, page: this.window_page(),
      onPicture: () => this.wake(),
      // The first samples may be older than the core.
      now: globalThis.feltlineEarly?.events[0]?.event.timeStamp ?? performance.now() });
    let core = await make_one(), done = { ok: true };
    if (last) {
      try {
        done = await this.prepare(core, last);
        if (done.ok) done = this.begin_with(core, last);
      } catch (error) {
        done = { ok: false, error: error.message };
        core = await make_one();
      }
    }
    this.is_paused = !done.ok;
    this.record_bytes = last?.recorded.length ?? 0;
    this.core = core;
    this.catalog = core.catalog();
    by_id('files').accept = this.catalog.formats.filter(({ opens }) => opens).map(({ extension }) => `.${extension.replace('.', '')}`)
      .concat(kPictures).join();
    if (this.strength !== undefined) core.setStrength(this.strength);
    this.resize();
    if (last) this.fit();
    else this.fill_window();
    this.set_theme(this.theme_choice());
    return done;
  }

  /** The size of a sheet that fills the window at life size, in mm, but for the surround of the dark theme. */
  window_page() {
    const { left, top, right, bottom } = this.surround();
    const mm = (px) => Math.max(20, (left > 0 ? Math.floor : Math.ceil)(px / kLifeSize));
    return { width: mm(innerWidth - left - right), height: mm(innerHeight - top - bottom) };
  }

  /** The distances of a new sheet from the edges of the window, in CSS pixels: none in the light theme. */
  surround() {
    const root = document.documentElement;
    // The style takes a while when the page starts.
    if (root.dataset.theme !== 'dark') return { left: 0, top: 0, right: 0, bottom: 0 };
    const style = getComputedStyle(root);
    return Object.fromEntries(['left', 'top', 'right', 'bottom'].map((side) => [side, parseFloat(style.getPropertyValue(`--sheet-${side}`)) || 0]));
  }

  /** Loads what a stored drawing needs. */
  async prepare(core, { base }) {
    const done = await core.complete();
    return done.ok && base && core.isFelt(base) ? core.prepareFelt() : done;
  }

  /** Continues with a stored drawing. */
  begin_with(core, { base, recorded, page }) {
    const done = core.restore(base, recorded);
    if (done.ok && !base) core.setPage(page);
    return done;
  }

  listen() {
    this.input = new Input(this.sheet, this);
    this.keys = new Keys(this, this.input);
    const { feltlineEarly: early } = globalThis;
    for (const event of early.stop()) this.input.replay(event);
    addEventListener('resize', () => this.resize());
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.set_theme(this.theme_choice()));
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState !== 'hidden') return this.wake();
      this.leave();
      this.input.release_all(true);
    });
    addEventListener('beforeunload', (event) => {
      if (this.core && this.is_lost_by_closing()) event.preventDefault();
    });
    addEventListener('pagehide', () => {
      if (this.core) this.do_waiting(this.core);
      this.leave();
    });
  }

  resize() {
    const { innerWidth: width, innerHeight: height, devicePixelRatio: ratio } = globalThis;
    this.sheet.width = Math.round(width * ratio);
    this.sheet.height = Math.round(height * ratio);
    this.marks.resize(width, height, ratio);
    if (!this.core) return;
    this.core.resize(width, height, ratio);
    this.resize_blank();
    this.marks_due = true;
    this.wake();
  }

  /** A sheet without a drawing fills the window. It does not move under the first line. Returns false if there is a drawing. */
  resize_blank() {
    if (!this.is_empty()) return false;
    this.core.setPage(this.window_page());
    this.core.rebase();
    this.store_due = true;
    if (this.is_blank()) this.fill_window();
    return true;
  }

  // --- Frames

  /** Frames go on for a while from now. */
  wake() {
    this.active_until = performance.now() + kIdleMs;
    if (this.asked || !this.core) return;
    this.asked = true;
    requestAnimationFrame(this.frame);
  }

  run_frame(now) {
    this.asked = false;
    let more = false;
    this.guard((core) => {
      if (!this.is_waiting) core.advance(now);
      more = core.paint(this.context);
    });
    this.guard(() => this.show_changes(now));
    // An error of the steps above does not keep the drawing from being stored.
    this.guard((core) => {
      if (core.changed('edits')) this.is_unsaved = this.store_due = true;
      if (this.store_due && now - (this.stored ?? -Infinity) > kAutosaveMs) this.store(now);
    });
    if (!this.core) return;
    if (more || now < this.active_until || this.plays) this.wake_again();
    else this.store(now);
  }

  /** Calls the core. If a check in it fails, another core continues with the drawing. Other errors do not concern the
   * drawing. */
  guard(use) {
    const { core } = this;
    if (!core) return undefined;
    try {
      return use(core);
    } catch (error) {
      if (error.name === 'CoreError') this.recover(core, error);
      else console.warn('Feltline: an error of the page:', error);
      return undefined;
    }
  }

  wake_again() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(this.frame);
  }

  show_changes(now) {
    const { core } = this;
    if (core.changed('marks') || this.marks_due) {
      this.marks_due = false;
      const marks = core.marks(), pen = core.pen();
      const is_away = this.is_away && !pen.touching;
      this.marks.draw(is_away ? marks.filter(({ role }) => role !== 'reach') : marks, is_away ? { known: false } : pen, this.paper_is_dark);
    }
    if (core.ticks() > 0) play_cue();
    if (this.forces.add(core.forces())) this.active_until = Math.max(this.active_until, now + 100);
    if (this.shown.forces) this.forces.draw(core.forceTerms(), now);
    this.sound.feed();
    if (this.plays && !core.playing()) this.end_play(core.playError());
    if (core.changed('refusal')) this.say_refused(core.refusal());
    if (core.changed('state')) this.show_state();
    this.bars.show_view(core.view());
  }

  show_state() {
    const state = this.core.state();
    this.bars.show(state);
    this.offers.show(state);
    this.options.show(state);
    this.layers.show(state);
    this.forces.show(state);
    by_id('empty').hidden = has_content(state) || state.gesture || this.touched_once || Boolean(this.last);
    const { hint, shift, ctrl, alt } = state.use;
    const keys = [['Shift+', shift], ['Ctrl+', ctrl], ['Alt+', alt]].map(([key, what]) => [key_name(key).replace('+', ''), what]);
    const texts = [d('tools', hint), ...keys.filter(([, what]) => what).map(([key, what]) => `${key}: ${d('tools', what)}`)];
    if (texts.join() !== this.hint) {
      this.hint = texts.join();
      by_id('hint').replaceChildren(...texts.map((text) => make('span', {}, text, ' ')));
    }
    const paper = parseInt(state.paper.slice(1, 7), 16);
    this.paper_is_dark = (paper >> 16) + ((paper >> 8) & 255) + (paper & 255) < 384;
    by_id('empty').classList.toggle('on-dark', this.paper_is_dark);
  }

  /** Replaces a core that has ended. */
  async recover(core, error) {
    if (this.core !== core) return;
    console.warn('Feltline restarts after an error:', error);
    this.core = null;
    this.plays = false;
    const now = performance.now();
    this.restarts = [...(this.restarts ?? []).filter((time) => now - time < kRestartMs), now];
    const is_again = this.restarts.length >= kMaxRestarts;
    if (this.restarts.length > 2 * kMaxRestarts) return this.say_ended();
    // If the error occurs again, the drawing causes it. Then the sheet is empty, and the drawing stays stored.
    const was_paused = this.is_paused, last = was_paused ? null : core.copy?.() ?? null, stored = this.last;
    this.last = this.again = null;
    try {
      const done = await this.make_core(is_again ? null : last);
      if (was_paused || is_again || !done.ok) {
        this.is_paused = true;  // what is stored stays
        if (last) this.ask_about(last, done.error ?? error.message);
      } else {
        this.core.rebase();
        this.set_view(core.view());
        this.say(t('An error occurred. The drawing was restored up to the last step.'));
      }
    } catch (failure) {
      console.warn(failure);
      this.core = null;
      return this.say_ended();
    }
    if (stored) {  // it has ended the core
      this.is_paused = true;
      this.ask_about(stored, error.message);
    }
    this.bars.show_switches();
    this.complete();
    this.wake();
  }

  say_ended() {
    this.say(t('An error occurred, and the page cannot continue. The stored drawing is unchanged. Reload the page.'), true);
  }

  // --- Autosave

  /** Writes what has happened since the last call. Without storage, the records are dropped. */
  store(now = performance.now()) {
    this.stored = now;
    this.store_due = false;
    this.guard((core) => {
      const { storage } = this;
      if (storage?.is_broken && !this.is_paused && now - (this.retried ?? -Infinity) > kRetryMs) {
        this.retried = now;
        core.rebase();
      }
      const rebased = core.rebased(), base = rebased ? core.base() : null, recorded = core.recorded();
      this.record_bytes = (rebased ? 0 : this.record_bytes) + recorded.length;
      if (this.record_bytes > kRebaseBytes) core.rebase();
      if (this.last && this.is_slow && this.unsaved()) this.say_loading();
      if (!storage || this.is_paused || this.last) return;
      const page = rebased ? core.state().page : null;
      try {
        Object.assign(storage, { strokes: core.state().strokes, is_empty: this.is_empty() });
        if (rebased) storage.restart(base, page, recorded);
        else storage.append(recorded);
      } catch (error) {
        storage.fail(error);
      }
    });
  }

  watch_storage() {
    const { storage } = this;
    let is_said = false;
    storage.failed = async (error) => {
      console.info('Feltline: the drawing was not stored:', error);
      if (!is_said) this.say_not_stored();
      is_said = true;
      await storage.reopen().catch(() => {});
      // The next attempt comes even if nothing is drawn.
      setTimeout(() => { if (storage.is_broken) this.store(); }, kRetryMs + 1);
    };
    storage.restarted = () => {
      is_said = false;
      this.end_lasting();
    };
    storage.moved = () => {
      this.guard((core) => core.rebase());
      this.store();
    };
  }

  /** Shows this until the drawing is stored; other messages replace it only for a while. */
  say_not_stored(text = t('This browser does not store the drawing. Save it before you close the page.')) {
    if (this.lasting === text) return;
    this.lasting = text;
    if (this.core) this.say(text);  // otherwise the page has more to say
  }

  say_loading() {
    this.say_not_stored(t('The page is still loading, so your lines are not stored yet. Keep it open.'));
  }

  end_lasting() {
    if (!this.lasting) return;
    this.lasting = null;
    this.end_notice();
  }

  /** A stored drawing could not be continued. It stays stored, and nothing else is, until the user decides. */
  async ask_about(last, error) {
    const button = (value, text) => make('button', { value, className: value === 'again' ? 'main' : '' }, text);
    const text = t('It is still stored in this browser. What you draw now is not, until you continue without the stored drawing, which deletes it.');
    for (;;) {
      const answer = await this.dialog(t('The drawing of your last visit could not be restored: %1', error), make('p', {}, text),
        [button('go', t('Continue without it')), button('save', t('Save it as files')), button('again', t('Try again'))]);
      if (answer === 'again') return location.reload();
      if (answer === 'save') this.files.save_stored(last);
      if (answer === 'go') break;
      if (!answer) return this.say_not_stored();
    }
    this.is_paused = false;
    this.guard((core) => core.rebase());
    this.store();
  }

  /** The page is hidden or closed, perhaps without coming back. */
  leave() {
    this.guard((core) => core.finish());
    this.retried = -Infinity;
    if (this.storage) this.storage.is_leaving = true;
    this.store();
    if (this.storage) this.storage.is_leaving = false;
  }

  /** Another drawing began: it replaces the one in the autosave. */
  begun() {
    this.store();
    this.guard((core) => core.changed('edits'));
    this.is_unsaved = false;
    this.touched_once = false;
    this.fit();
  }

  unsaved() {
    return Boolean(this.is_unsaved && this.core && has_content(this.core.state()));
  }

  saved() {
    this.is_unsaved = false;
  }

  /** True if closing the page would lose lines: they are in no file, and the browser does not store them. */
  is_lost_by_closing() {
    const { storage } = this, is_stored = storage && !storage.is_broken && !storage.is_mending && !this.is_paused && !this.last;
    return !is_stored && this.unsaved();
  }

  // --- Events

  /** Sends an event to the core. */
  apply(event) {
    const is_first = kFirstEvents.includes(event.event);
    if (!is_first || this.is_waiting) return this.when_complete(() => this.apply_now(event), is_first);
    if (this.again) this.settle();
    // A step that there is not here may be one of the stored drawing.
    if (event.event === 'cancel' || this.core?.state()[event.event]) this.remember(() => this.apply_now(event));
    return this.apply_now(event);
  }

  apply_now(event) {
    this.settle();
    const before = this.guard((core) => core.state()), done = this.guard((core) => core.event(event));
    if (done && before) this.say_without_effect(event.event, before, done);
    this.wake();
  }

  /** Says why an event changed nothing. `before`: the state of the core before it. */
  say_without_effect(name, before, done) {
    const is_step = name === 'undo' || name === 'redo';
    if (is_step && before[name] === null && !before.gesture) this.say(t(`There is nothing to ${name}.`));
    else if (!done.ok) this.say_refused(done);
    else if (kOfSelection.includes(name)) this.say_unchanged(name, before);
  }

  say_unchanged(name, before) {
    const { position, selected } = this.guard((core) => core.state()) ?? before;
    if (position !== before.position || selected !== before.selected) return;
    if (before.gesture) this.say(t('Lift the pen first.'));
    else if (name === 'exact' || name === 'as-drawn') this.say(t('The last line has no other form.'));
    else if (selected === 0) this.say(t('Nothing is selected. Draw around lines with the lasso first.'));
    else if (name === 'delete' || name === 'duplicate') this.say(t('Only a part of the line is selected. Select whole lines first.'));
  }

  say_refused(done) {
    console.info('Feltline: refused:', done.error);
    // The sentences for codes in other languages are about files, but for that of a limit.
    const is_about_a_file = current_language() !== 'en' && done.code !== undefined && done.code !== kTooLarge;
    this.say(t('This changed nothing: %1', is_about_a_file ? t('It is not possible with this drawing.') : this.reason(done)));
  }

  samples(samples) {
    this.is_away = false;
    if (this.is_waiting) return this.when_complete(() => this.samples(samples), true);
    this.sampled = performance.now();
    if (this.again && this.core) {
      const view = this.core.view();
      this.remember(() => {
        this.core.setView(view);
        this.samples(samples);
      });
    }
    this.guard((core) => {
      this.sample_time = samples.at(-core.sampleSize) ?? null;
      core.samples(samples);
    });
    this.wake();
    return undefined;
  }

  /** A pointer touches the sheet at this point. */
  touched(x, y) {
    this.keys.lead_by_pointer(x, y);
    this.begins();
  }

  /** A gesture begins, of a pointer or of the keys. */
  begins() {
    this.gestures += 1;
    if (this.input.modifiers & 4) this.keys.keeps_alt = true;
    this.touched_once = true;
    by_id('empty').hidden = true;
    if (this.plays) this.stop_hand();
    if (this.wants_sound && !this.sound.is_on) this.toggle_sound();
  }

  middle() {
    return [innerWidth / 2, innerHeight / 2];
  }

  /** The pointer is no longer over the sheet: the nib and its reach are not shown. */
  left() {
    this.is_away = true;
    this.marks_due = true;
    this.wake();
  }

  cancel() {
    this.apply({ event: 'cancel' });
  }

  /** The pen of the core follows the pointer with a short delay. After this call, it has handled all samples that were
   * sent, so that they come before the next event. */
  settle() {
    if (this.is_waiting) return;
    // Samples that have waited are older; those behind them must not be overtaken.
    if (this.is_replaying) {
      if (this.sample_time !== null) this.guard((core) => core.advance(this.sample_time + kSettleMs));
      return;
    }
    const now = performance.now();
    if (now - (this.sampled ?? -Infinity) < kSettleMs) this.guard((core) => core.advance(now + kSettleMs));
  }

  finish() {
    if (this.is_waiting) return this.when_complete(() => this.finish(), true);
    this.remember(() => this.finish());
    this.settle();
    this.guard((core) => core.finish());
    this.wake();
    return undefined;
  }

  undo() {
    this.apply({ event: 'undo' });
  }

  redo() {
    this.apply({ event: 'redo' });
  }

  escape() {
    if (!this.core) return;
    const { gesture, selected } = this.core.state();
    // The core starts the gesture a moment after the pointer is down.
    if (gesture || this.input.drawing !== null) this.input.cancel();
    else if (selected > 0) this.apply({ event: 'select', what: 'none' });
    this.apply({ event: 'cancel' });
    this.keys.lift();
  }

  use_tool(id) {
    this.apply({ event: 'tool', id });
  }

  tool_of_kind(kind) {
    return this.catalog.tools.find((tool) => tool.kind === kind)?.id;
  }

  borrow(kind) {
    if (!this.core) return undefined;
    if (this.is_waiting) return this.when_complete(() => this.borrow(kind));
    const { tool } = this.core.state(), other = this.tool_of_kind(kind);
    if (!other || other === tool) return undefined;
    this.lender = tool;
    return this.use_tool(other);
  }

  give_back() {
    if (this.is_waiting) return this.when_complete(() => this.give_back());
    if (this.lender) this.use_tool(this.lender);
    this.lender = null;
    return undefined;
  }

  set_option(id, value) {
    this.apply({ event: 'option', id, value });
  }

  set_medium(medium) {
    if (!this.core?.isComplete || this.is_waiting) return this.when_complete(() => this.set_medium(medium));
    const done = this.core.setMedium(medium);
    if (!done.ok) this.say_refused(done);
    if (this.core.state().selected > 0) this.apply({ event: 'restyle', medium });
    this.wake();
  }

  set_color(color) {
    this.set_option('ink.color', color);
    if (this.core?.state().selected > 0) this.apply({ event: 'restyle', color });
  }

  set_size(mm) {
    if (!this.core?.isComplete || this.is_waiting) return this.when_complete(() => this.set_size(mm));
    const done = this.core.setSize(mm);
    if (!done.ok) this.say_refused(done);
    this.wake();
  }

  scale_size(factor) {
    const { size } = this.core.state();
    if (size) this.set_size(Math.min(Math.max(size.mm * factor, size.min), size.max));
  }

  nudge([dx, dy], event) {
    const mm = event.shiftKey ? 10 : event.ctrlKey ? 0.1 : 1;
    this.apply({ event: 'move', dx: mm * dx, dy: mm * dy });
  }

  rename_layer() {
    if (!this.core) return;
    if (!this.shown.layers) this.toggle('layers');
    this.layers.show(this.core.state());
    this.layers.edit();
  }

  // --- View

  view() {
    return this.core?.view() ?? {};
  }

  set_view(view) {
    this.guard((core) => core.setView(view));
    this.wake();
  }

  /** Moves the sheet by CSS pixels. */
  pan(dx, dy) {
    if (!this.core) return;
    const [x, y] = this.core.toPage(-dx, -dy);
    this.set_view({ x, y });
  }

  zoom(x, y, factor) {
    if (!this.core) return;
    const { scale } = this.core.view();
    this.core.zoomAt(x, y, Math.min(Math.max(factor, kMinScale / scale), kMaxScale / scale));
    this.wake();
  }

  zoom_middle(factor) {
    this.zoom(...this.middle(), factor);
  }

  life_size() {
    if (!this.core) return;
    this.zoom_middle(kLifeSize / this.core.view().scale);
  }

  fit() {
    if (!this.core) return undefined;
    const { width, height } = this.core.state().page;
    // A sheet that was made for this window fills it.
    const window = this.window_page();
    if (width === window.width && height === window.height) return this.fill_window();
    const { left, top, right, bottom } = this.surround(), margin = left > 0 ? 0 : kMarginPx;
    const wide = innerWidth - left - right, high = innerHeight - top - bottom;
    const scale = Math.max(0.1, Math.min((wide - 2 * margin) / width, (high - 2 * margin) / height));
    return this.use_fit({ scale, x: width / 2 - (left + wide / 2) / scale, y: height / 2 - (top + high / 2) / scale });
  }

  fill_window() {
    const { left, top } = this.surround();
    this.use_fit({ scale: kLifeSize, x: -left / kLifeSize, y: -top / kLifeSize });
  }

  use_fit(view) {
    this.set_view({ ...view, angle: 0, mirrored: false });
    this.fitted = JSON.stringify(this.view());
  }

  mirror() {
    this.change_about(...this.middle(), (view) => ({ mirrored: !view.mirrored }));
  }

  /** Turns the view by these degrees; null: upright. */
  turn(degrees) {
    this.turn_to(...this.middle(), degrees === null ? 0 : this.view().angle + degrees);
  }

  /** Turns the view to these degrees about a point of the window. */
  turn_to(x, y, degrees) {
    this.change_about(x, y, () => ({ angle: ((degrees % 360) + 360) % 360 }));
  }

  /** Changes the view; the point of the sheet at this point of the window stays there. */
  change_about(x, y, change) {
    const { core } = this;
    if (!core) return;
    const at = core.toPage(x, y);
    core.setView(change(core.view()));
    const [now_x, now_y] = core.toCanvas(...at);
    this.pan(x - now_x, y - now_y);
  }

  // --- Simulated hand, sound, forces

  toggle_hand() {
    if (this.plays) return this.stop_hand();
    if (!this.core?.isComplete || this.is_waiting) return this.when_complete(() => this.toggle_hand());
    const { text, mmPerUnit } = in_the_middle(this.core.scripts().find(({ id }) => id === 'cat').text, this.core.state().page);
    const done = this.core.play(text, { speed: kCatSpeed, mmPerUnit });
    if (!done.ok) return this.say_refused(done);
    this.plays = true;
    this.touched_once = true;
    this.bars.show_switches();
    this.say(t('The simulated hand draws. Touch the sheet to stop it.'));
    this.wake();
  }

  stop_hand() {
    this.core.stopPlay();
    this.end_play();
  }

  end_play(error) {
    this.plays = false;
    if (error) this.say_refused({ error });
    this.bars.show_switches();
  }

  async toggle_sound() {
    const on = !this.sound.is_on;
    choices.set('sound', on ? 'on' : '');
    this.wants_sound = on;
    await this.sound.set(on).catch((error) => {
      this.wants_sound = false;
      choices.set('sound', '');
      console.info('Feltline: no sound:', error);
      this.say(t('The browser does not let the page play sound. You can draw without it.'));
    });
    this.bars.show_switches();
    this.wake();
  }

  set_moves(on) {
    if (!this.core?.isComplete || this.is_waiting) return this.when_complete(() => this.set_moves(on));
    const device = this.core.devices().find(({ hasForce }) => hasForce === on);
    const done = this.core.setDevice(device.id);
    if (done.ok) this.device = device.id;
    else this.say_refused(done);
    this.wake();
  }

  set_strength(share) {
    this.strength = share;
    this.core?.setStrength(share);
    this.wake();
  }

  // --- Panels, words, theme

  toggle(panel) {
    this.shown[panel] = !this.shown[panel];
    this[panel].element.hidden = !this.shown[panel];
    if (!this.shown[panel]) this.bars.panels[panel].focus();
    // A small screen has room for one panel.
    if (this.shown[panel] && innerWidth <= 1000) {
      for (const other of Object.keys(this.shown)) if (other !== panel && this.shown[other]) this.toggle(other);
    }
    if (this.core) this[panel].show?.(this.core.state());
    this.bars.show_switches();
    this.wake();
  }

  show_words() {
    const { sheet } = this;
    sheet.setAttribute('aria-label',
      t('Sheet. Draw with pen, finger or mouse; arrow keys move the pen, Enter puts it down and lifts it.'));
    by_id('empty').firstElementChild.textContent = t('Draw. To correct a line, choose Pull and pull it into shape.');
    by_id('empty').lastElementChild.textContent = this.why_light();
    this.keys?.forget_words();
    this.offers.shown = null;
    for (const part of [this.bars, this.options, this.layers, this.forces]) part.show_words();
    if (this.core) this.show_state();
  }

  language() {
    return current_language();
  }

  languages() {
    return Object.entries(languages);
  }

  set_language(language) {
    choices.set('language', language);
    set_language(language);
    this.show_words();
  }

  theme_choice() {
    return choices.get('theme') ?? '';
  }

  set_theme(theme) {
    choices.set('theme', theme);
    const dark = theme ? theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches, { dataset } = document.documentElement;
    const is_new = dataset.theme !== (dark ? 'dark' : 'light');
    dataset.theme = dark ? 'dark' : 'light';
    const { core } = this;
    core?.setDesk(getComputedStyle(document.documentElement).getPropertyValue('--desk').trim());
    // The dark theme has a surround. A sheet that the user has moved stays.
    if (is_new && core && !this.resize_blank() && !this.draws && JSON.stringify(core.view()) === this.fitted) this.fit();
    this.wake();
  }

  why_light() {
    return t('The sheet stays light, so that colours look as they will on paper.');
  }

  key_name(keys) {
    return key_name(keys);
  }

  // --- Messages

  /** Shows a message, for a while if it does not stay. */
  say(text, stays = false) {
    clearTimeout(this.notice);
    this.show_notice(text);
    if (!stays) this.notice = setTimeout(() => this.end_notice(), kNoticeMs);
  }

  /** Removes the message; one about a state that lasts comes back. */
  end_notice() {
    clearTimeout(this.notice);
    this.show_notice(this.lasting);
  }

  /** Shows this text, or nothing. The focus of a button that goes with the former one is the sheet's. */
  show_notice(text, className = '') {
    const notice = by_id('notice'), had_focus = notice.contains(document.activeElement);
    notice.replaceChildren(...(text ? [make('p', { className }, text)] : []));
    if (had_focus) this.sheet.focus({ preventScroll: true });
  }

  /** Returns why something was not done. In other languages than English, the sentences of the library are those for its codes. */
  reason({ error, missing, code }) {
    if (missing) return t('%1 could not be loaded', missing);
    if (code === undefined || current_language() === 'en') return error;
    return d('ErrorWords', code === kTooLarge ? 'The drawing is too large for Feltline.'
      : code === kNotSupported ? 'Feltline cannot read this kind of file.'
        : 'The file is damaged, or is not a drawing that Feltline can read.');
  }

  /** Tells a screen reader. */
  tell(text) {
    this.show_notice(text, 'unseen');
    if (this.lasting) by_id('notice').append(make('p', {}, this.lasting));
  }

  dialog(title, content, buttons) {
    const form = make('form', { method: 'dialog' }, ...buttons);
    const dialog = make('dialog', { 'aria-label': title }, make('h2', {}, title), content, form);
    document.body.append(dialog);
    dialog.addEventListener('close', () => dialog.remove());
    dialog.showModal();
    return new Promise((resolve) => dialog.addEventListener('close', () => resolve(dialog.returnValue)));
  }

  async ask(question, yes) {
    const answer = await this.dialog(question, '', [make('button', { value: '' }, t('Cancel')),
      make('button', { value: 'yes', className: 'main' }, yes)]);
    return answer === 'yes';
  }

  async new_drawing() {
    await this.complete();
    if (this.unsaved() && !(await this.ask(t('Replace the drawing? It is not in a file yet.'), t('Replace')))) return;
    const done = await this.complete();
    if (!done.ok) return this.say(this.reason(done));
    this.core.clear(this.window_page());
    this.files.name = '';
    this.begun();
  }

  /** Lists the other drawings of this browser. The present one is stored, so that another one can be opened. */
  async show_others() {
    const others = await this.storage.others().catch((error) => console.info('Feltline: no list of drawings:', error));
    if (!others) return this.say(t('The browser does not show the other drawings now. Reload the page to try again.'));
    if (others.length === 0) return this.say(t('There are no other drawings in this browser.'));
    const text = ({ time, strokes }) => [time ? new Date(time).toLocaleString(current_language()) : t('Drawing'),
      strokes ? t('Lines: %1', strokes) : ''].join(' ');
    const slot = await this.dialog(t('Other drawings…'), '', [make('button', { value: '' }, t('Cancel')),
      ...others.map((other) => make('button', { value: other.slot }, text(other)))]);
    if (!slot) return undefined;
    this.guard((core) => core.finish());
    this.retried = -Infinity;
    this.store();
    const is_written = await Promise.race([this.storage.written, pause(kAnswerMs)]);
    if (this.unsaved() && (!is_written || this.is_lost_by_closing())) {
      if (!(await this.ask(t('Replace the drawing? It is not in a file yet.'), t('Replace')))) return undefined;
      this.saved();  // so that closing does not ask again
    }
    this.storage.change_to(slot);
    return location.reload();
  }

  show_keys() {
    const content = make('div', {}, key_table(this.keys, this),
      make('p', { className: 'quiet' }, t('Hold the key of a tool to use it until you release the key.')),
      make('p', { className: 'quiet' }, t('Two fingers move, zoom and turn the sheet; a tap with two fingers undoes, with three redoes.')));
    this.dialog(t('Keyboard shortcuts'), content, [make('button', { className: 'main' }, t('Close'))]);
  }

  show_about() {
    const texts = ['Feltline is a sketching program you can feel: pull a line and it resists. On this page you draw with the same tools and see and hear the forces.',
      'Force-feedback devices work with the desktop program and the command line only. There, the safety chain checks each force on the way to the device; a web page must not bypass it.',
      'The drawing stays in this browser until you save it as a file. The page sends nothing and loads nothing.'];
    this.dialog(`Feltline ${this.catalog?.version ?? ''}`, make('div', {}, ...texts.map((text) => make('p', {}, t(text)))),
      [make('button', { className: 'main' }, t('Close'))]);
  }

  get has_felt() {
    return Boolean(this.catalog?.formats.some(({ id, saves }) => id === 'felt' && saves));
  }
}

const page = new Page();
globalThis.feltlinePage = page;  // for tests
const is_slow = setTimeout(() => page.say(t('Loading…'), true), kSlowMs);
page.start().finally(() => {
  clearTimeout(is_slow);
  if (by_id('notice').textContent === t('Loading…')) by_id('notice').replaceChildren();
}).catch((error) => {
  console.warn(error);
  if (error instanceof LoadError) return page.say(t('%1 could not be loaded. Reload the page.', error.message), true);
  page.say(t('This browser cannot run the page: it needs WebAssembly and JavaScript of 2023 or later.'), true);
});
