// The JavaScript of the core: makes the module, and turns texts and arrays into calls. core.d.ts describes it.
import { instantiate } from './instantiate.mjs';
import { DatabaseModule } from './database/database.js';
import { Pictures } from './pictures/pictures.js';
import { first_module, full_module, load_felt } from './module.js';
import { catalog } from 'generated/extras_text.js';

const kSampleNumbers = 8;
const kChanges = { ink: 1, marks: 2, state: 4, edits: 8, refusal: 16 };
const kMinDpi = 10, kMaxDpi = 1200;

export class CoreError extends Error {
  constructor(message) {
    super(message);
    this.name = 'CoreError';
  }
}

const kFeltHead = 'SQLite format 3\0';
const kCommands = ['undo', 'redo', 'cancel'];  // api.cc
const decoder = new TextDecoder(), encoder = new TextEncoder();
const bytes_of = (data) => (typeof data === 'string' ? encoder.encode(data) : data);
const not_loaded = (name, error) => ({ ok: false, missing: name, error: `${name} could not be loaded (${error.message})` });
const number_of = (color) => parseInt(color.replace('#', ''), 16) || 0;

class Core {
  constructor(exports, options) {
    this.sampleSize = kSampleNumbers;
    this.exports = exports;
    this.start = options.now ?? 0;
    this.bits = 15;
    this.seen_ticks = 0;
    this.rect = [0, 0, 0, 0];
    this.load_script = options.loadScript;
    this.database = new DatabaseModule(options.loadScript);
    this.pictures = new Pictures(() => {
      this.has_new_pictures = true;
      options.onPicture?.();
    }, options.decodePicture);
    this.isComplete = false;
    this.kept = { base: new Uint8Array(0), records: '' };  // what the full module, or another core, continues with
    this.unread = { rebased: false, records: '' };         // of kept, what the caller has not read
    this.settings = {};
    this.now = 0;
    this.shown = { x: 0, y: 0, scale: 4, angle: 0, mirrored: false };
    if (options.page) this.call('felt_set_page', options.page.width, options.page.height);
    Object.assign(this, { width: options.width ?? 800, height: options.height ?? 600, dpr: options.dpr ?? 1 });
    this.call('felt_resize', this.width, this.height, this.dpr);
    this.fitPage();
  }

  // --- Calls

  /** Calls a function of the module. If it stops, the core is lost. */
  call(name, ...values) {
    if (!this.exports) throw new CoreError('the core has ended');
    try {
      return this.exports[name](...values);
    } catch (error) {
      // A RangeError: the stack of the module is full.
      if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
      this.exports = null;
      throw new CoreError(`${name}: ${error.message}`);
    }
  }

  /** Writes the parts one after the other to the input, and returns their size. */
  write(...parts) {
    const size = parts.reduce((sum, part) => sum + part.byteLength, 0);
    let at = this.call('felt_input', size);
    for (const part of parts) {
      new Uint8Array(this.exports.memory.buffer, at, part.byteLength)
        .set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength));
      at += part.byteLength;
    }
    return size;
  }

  reply(size) {
    return new Uint8Array(this.exports.memory.buffer, this.call('felt_reply'), size);
  }

  text(name, ...values) {
    return decoder.decode(this.reply(this.call(name, ...values)));
  }

  json(name, ...values) {
    return JSON.parse(this.text(name, ...values));
  }

  /** Calls a function that reads a text from the input. */
  ask(name, text, ...values) {
    return this.json(name, this.write(bytes_of(text)), ...values);
  }

  /** Calls a function whose effect the full module needs, too. The first module may not have it. */
  set(name, ...values) {
    this.settings[name] = values;
    if (!this.exports || name in this.exports) this.call(name, ...values);
  }

  time(now) {
    return Math.max(0, now - this.start);
  }

  // --- Input

  samples(samples) {
    this.use_view();
    const numbers = Float64Array.from(samples);
    for (let i = 0; i < numbers.length; i += kSampleNumbers) numbers[i] = this.time(numbers[i]);
    this.write(numbers);
    this.call('felt_samples', Math.floor(numbers.length / kSampleNumbers));
  }

  event(event) {
    const command = kCommands.indexOf(event.event);
    if (command >= 0) return this.json('felt_command', command);
    return this.ask('felt_event', typeof event === 'string' ? event : JSON.stringify(event));
  }

  setMedium(id) {
    return this.ask('felt_set_medium', id);
  }

  setSize(mm) {
    return this.json('felt_set_size', mm);
  }

  advance(now) {
    this.now = now;
    this.call('felt_advance', this.time(now));
  }

  finish() {
    this.call('felt_finish');
  }

  // --- What changed

  changed(what) {
    this.use_view();
    this.bits |= this.call('felt_changes');
    const bit = kChanges[what] ?? 0;
    const is_changed = (this.bits & bit) !== 0;
    this.bits &= ~bit;
    return is_changed;
  }

  refusal() {
    return this.json('felt_refusal');
  }

  /** The ticks since the last call. */
  ticks() {
    const all = this.call('felt_ticks');
    const count = Math.max(0, all - this.seen_ticks);
    this.seen_ticks = all;
    return count;
  }

  // --- The picture

  resize(width, height, dpr) {
    if (width === this.width && height === this.height && dpr === this.dpr) return;
    Object.assign(this, { width, height, dpr });
    this.call('felt_resize', width, height, dpr);
    this.setView({});
  }

  view() {
    return { ...this.shown };
  }

  setView(view) {
    const next = { ...this.shown, ...view };
    next.scale = Math.min(Math.max(next.scale, 0.02), 2000);
    // The page moves by whole pixels, so that the picture can be moved with it.
    if (next.angle === 0 && !next.mirrored) {
      const px = next.scale * this.dpr;
      next.x = Math.round(next.x * px) / px;
      next.y = Math.round(next.y * px) / px;
    }
    this.shown = next;
    this.has_view = false;
  }

  /** Sets the view of the module, which scales the picture, when it is needed: the page sets several views when it starts. */
  use_view() {
    if (this.has_view) return;
    this.has_view = true;
    const { x, y, scale, angle, mirrored } = this.shown;
    this.call('felt_set_view', x, y, scale, angle, mirrored ? 1 : 0);
  }

  fitPage(margin = 24) {
    const { width, height } = this.state().page;
    const scale = Math.max(0.1, Math.min((this.width - 2 * margin) / width, (this.height - 2 * margin) / height));
    this.setView({ scale, angle: 0, mirrored: false, x: (width - this.width / scale) / 2, y: (height - this.height / scale) / 2 });
  }

  zoomAt(x, y, factor) {
    const [mm_x, mm_y] = this.toPage(x, y);
    this.setView({ scale: this.shown.scale * factor });
    const [now_x, now_y] = this.toPage(x, y);
    this.setView({ x: this.shown.x + mm_x - now_x, y: this.shown.y + mm_y - now_y });
  }

  toPage(x, y) {
    const { scale, mirrored, x: left, y: top } = this.shown, [cos, sin] = this.turn();
    const to = mirrored ? -x : x;
    return [left + (cos * to + sin * y) / scale, top + (cos * y - sin * to) / scale];
  }

  toCanvas(x_mm, y_mm) {
    const { scale, mirrored, x: left, y: top } = this.shown, [cos, sin] = this.turn();
    const dx = scale * (x_mm - left), dy = scale * (y_mm - top);
    const x = cos * dx - sin * dy;
    return [mirrored ? -x : x, sin * dx + cos * dy];
  }

  turn() {
    const angle = (this.shown.angle * Math.PI) / 180;
    return [Math.cos(angle), Math.sin(angle)];
  }

  setDesk(color) {
    this.set('felt_set_desk', number_of(color));
  }

  setPaper(color) {
    this.call('felt_set_paper', color ? 1 : 0, number_of(color));
  }

  setPage(page) {
    this.call('felt_set_page', page.width, page.height);
  }

  setGrain(on) {
    this.set('felt_set_grain', on ? 1 : 0);
  }

  warmUp() {
    this.set('felt_warm_up');
  }

  paint(context = null, budget = 8) {
    this.use_view();
    if (this.has_new_pictures) this.call('felt_repaint');
    this.has_new_pictures = false;
    const more = this.call('felt_paint', budget) === 1;
    const [x0, y0, x1, y1] = [0, 1, 2, 3].map((side) => this.call('felt_painted', side));
    this.rect = [x0, y0, Math.max(0, x1 - x0), Math.max(0, y1 - y0)];
    if (context && this.rect[2] > 0 && this.rect[3] > 0) {
      const { data, width, height } = this.pixels();
      context.putImageData(new ImageData(data, width, height), 0, 0, ...this.rect);
    }
    return more;
  }

  pixels() {
    const width = Math.min(16384, Math.max(1, Math.round(this.width * this.dpr)));
    const height = Math.min(16384, Math.max(1, Math.round(this.height * this.dpr)));
    const data = new Uint8ClampedArray(this.exports.memory.buffer, this.call('felt_pixels'), 4 * width * height);
    return { data, width, height };
  }

  painted() {
    return [...this.rect];
  }

  picture(dpi, options = {}) {
    const size = this.call('felt_export', Math.min(Math.max(dpi, kMinDpi), kMaxDpi), options.transparent ? 1 : 0);
    return size === 0 ? null : this.exported();
  }

  copied({ whole = false, dpi = 300 } = {}) {
    const svg = this.text('felt_copied', whole ? 1 : 0, dpi);
    return svg ? { svg, picture: this.exported() } : null;
  }

  /** Returns the picture that the module has made. */
  exported() {
    const width = this.call('felt_export_size', 0), height = this.call('felt_export_size', 1), size = 4 * width * height;
    if (size === 0) return null;
    const data = new Uint8ClampedArray(this.exports.memory.buffer, this.call('felt_export_pixels'), size).slice();
    this.call('felt_end_export');
    for (let i = 0; i < size; i += 4) {  // a canvas wants colours that are not multiplied by alpha
      const alpha = data[i + 3];
      if (alpha === 0 || alpha === 255) continue;
      for (let k = i; k < i + 3; ++k) data[k] = Math.round((255 * data[k]) / alpha);
    }
    return { data, width, height };
  }

  marks() {
    this.use_view();
    return this.json('felt_marks');
  }

  pen() {
    this.use_view();
    return this.json('felt_pen');
  }

  // --- Forces and sound

  devices() {
    return this.json('felt_devices');
  }

  setDevice(id) {
    return this.ask('felt_set_device', id);
  }

  setForces(on) {
    this.set('felt_set_forces', on ? 1 : 0);
  }

  setStrength(share) {
    this.set('felt_set_strength', share);
  }

  forces() {
    if (!this.isComplete) return new Float64Array(0);
    const numbers = new Float64Array(this.reply(this.call('felt_forces')).slice().buffer);
    for (let i = 0; i < numbers.length; i += 7) numbers[i] += this.start;
    return numbers;
  }

  forceTerms() {
    if (!this.isComplete) return [];
    this.use_view();
    return this.json('felt_force_terms');
  }

  sound(frames) {
    if (!this.isComplete) return new Float32Array(0);
    return new Float32Array(this.reply(this.call('felt_sound', frames)).slice().buffer);
  }

  // --- State

  catalog() {
    return catalog;
  }

  state() {
    return this.json('felt_state');
  }

  option(id) {
    if (!this.isComplete) return null;
    return this.ask('felt_option', id);
  }

  // --- The simulated hand

  play(script, options = {}) {
    return this.ask('felt_play', script, options.mmPerUnit ?? 1, options.speed ?? 1);
  }

  playing() {
    if (!this.isComplete) return null;
    const fraction = this.call('felt_playing');
    if (fraction >= 0) return { fraction };
    return null;
  }

  playError() {
    return this.text('felt_play_error');
  }

  stopPlay() {
    this.call('felt_stop_play');
  }

  scripts() {
    return this.isComplete ? [{ id: 'cat', text: globalThis.feltlineFull.cat }] : [];
  }

  // --- Files

  open(bytes, name) {
    this.pictures.forget();
    return this.load(bytes, name, 0, [0, 0]);
  }

  add(bytes, name, { by, middle } = {}) {
    return this.load(bytes, name, middle ? 2 : 1, middle ?? by ?? [0, 0]);
  }

  load(data, name, how, [x, y]) {
    const title = encoder.encode(name);
    return this.json('felt_open', this.write(title, bytes_of(data)), title.length, how, x, y);
  }

  save(format) {
    const size = this.call('felt_save', this.write(encoder.encode(format)));
    const bytes = size > 0 ? this.reply(size).slice() : new Uint8Array();
    const { error = '', notices = [] } = this.json('felt_saved');
    Object.assign(this, { saveError: error, saveNotices: notices });
    return error ? null : bytes;
  }

  isFelt(bytes) {
    return decoder.decode(bytes_of(bytes).subarray(0, kFeltHead.length)) === kFeltHead;
  }

  async loadFelt() {
    try {
      await load_felt(this.load_script);
      return { ok: true };
    } catch (error) {
      return not_loaded('core_felt.js', error);
    }
  }

  async prepareFelt() {
    try {
      await this.database.start();
      return { ok: true };
    } catch (error) {
      return not_loaded('core_felt.js', error);
    }
  }

  clear(page) {
    if (page) this.setPage(page);
    this.pictures.forget();
    this.call('felt_clear');
  }

  // --- Autosave

  rebased() {
    this.collect();
    const { rebased } = this.unread;
    this.unread.rebased = false;
    return rebased;
  }

  base() {
    return this.kept.base;
  }

  recorded() {
    this.collect();
    const { records } = this.unread;
    this.unread.records = '';
    return records;
  }

  /** Moves the records of the module here. */
  collect() {
    if (this.call('felt_autosave') === 1) {
      this.unread = { rebased: true, records: '' };
      this.kept = { base: this.reply(this.call('felt_base')).slice(), records: '' };
    }
    const records = this.text('felt_recorded');
    this.unread.records += records;
    this.kept.records += records;
  }

  copy() {
    const { base, records } = this.kept;
    return { base, recorded: records };
  }

  rebase() {
    if (this.isComplete) return this.call('felt_rebase');
    // The first module cannot write a drawing, but all its records are here.
    this.collect();
    this.unread = { rebased: true, records: this.kept.records };
  }

  restore(base, recorded) {
    const first = base ?? new Uint8Array(0);
    const done = this.json('felt_restore', this.write(first, encoder.encode(recorded)), first.byteLength);
    this.unread = { rebased: false, records: '' };
    this.kept = { base: first, records: recorded };
    return done;
  }

  // --- The full module

  async complete(isFree = async () => {}) {
    if (this.isComplete) return { ok: true };
    let full;
    try {
      full = await instantiate(await full_module(this.load_script), this);
    } catch (error) {
      return not_loaded('core_full.js', error);
    }
    const stored = await isFree();
    if (this.isComplete) return { ok: true };  // called twice at the same time
    this.finish();
    this.collect();
    const { base, records } = this.kept, unread = this.unread, first = this.exports, { page } = this.state();
    this.exports = full;
    this.isComplete = true;
    this.call('felt_resize', this.width, this.height, this.dpr);
    this.has_view = false;
    if (stored) this.now = this.start;
    this.call('felt_advance', this.time(this.now));
    const done = stored ? { ok: true, continued: this.restore(stored.base, stored.recorded) } : this.restore(base, records);
    if (!done.ok) {  // the first module still has the drawing
      Object.assign(this, { exports: first, isComplete: false, unread });
      return done;
    }
    // The first module cannot begin the records again when the page gets another size during a line.
    const now = this.state().page;
    if (stored) {
      if (!stored.base) this.setPage(stored.page);
    } else if (page.width !== now.width || page.height !== now.height) this.setPage(page);
    for (const [name, values] of Object.entries(this.settings)) this.call(name, ...values);
    Object.assign(this, { unread: stored ? this.unread : unread, bits: 15, seen_ticks: this.call('felt_ticks') });
    return done;
  }

  replay(script, options = {}) {
    const device = encoder.encode(options.device ?? 'touch');
    const how = (options.asRecorded ? 1 : 0) + (options.forces === false ? 2 : 0);
    return this.json('felt_replay', this.write(device, bytes_of(script)), device.length, how);
  }

  free() {
    this.exports = null;
  }
}

export async function createCore(options = {}) {
  return new Core(await instantiate(await first_module), options);
}
