// Fitting: fitStroke() for whole strokes and StrokeFitter while the pen draws.
import { FeltlineError, check, currentCore, inputView, outputView, run, trim } from './module.js';
import { COLUMNS, isPoint, readerOf, writePoint } from './points.js';
import { checkNumber, jointsOf, outputForm, segmentsOf, takeStroke } from './strokes.js';

// The default, the least and the greatest value of each number that feltline.cc reads.
const numbers = {
  tolerance: [0.15, 0, 1e9],
  minWidth: [0.3, 0.05, 1000],
  maxWidth: [2, 0.05, 1000],
  gamma: [1, 0.01, 100],
  absentPressure: [0.5, 0, 1],
  timeConstant: [20, 0, 1e6],
  interval: [7.5, 0.2, 1e6],
  tiltWidth: [1, 1, 100],
  widthTolerance: [0.15, 0, 1000],
};
const optionNames = Object.keys(numbers);
const otherNames = ['filter', 'refine', 'mmPerUnit', 'stride', 'output', 'digits'];
// Points are passed to wasm in pieces of this many, so that its input stays small.
const PIECE = 4096;

/** Checks all options; returns the numbers for wasm, and what JavaScript uses. */
function settingsOf(options) {
  if (options === null || typeof options !== 'object') throw new TypeError('options must be an object');
  for (const name of Object.keys(options)) {
    if (!optionNames.includes(name) && !otherNames.includes(name)) {
      throw new TypeError(`unknown option '${name}'; the options are ${[...optionNames, ...otherNames].join(', ')}`);
    }
  }
  const values = optionNames.map((name) => {
    const [usual, least, most] = numbers[name];
    return checkNumber(options[name] ?? usual, name, least, most);
  });
  if (values[2] < values[1]) {
    throw new RangeError(`maxWidth (${values[2]}) is less than minWidth (${values[1]})`);
  }
  values.push(options.filter ? 1 : 0);
  return {
    values,
    refine: options.refine ?? true,
    scale: checkNumber(options.mmPerUnit ?? 1, 'mmPerUnit', 1e-9, 1e9),
    stride: options.stride,
    form: outputForm(options),
  };
}

function newHandle(core, values) {
  inputView(core, values.length).set(values);
  return core.exports.fitter_new();
}

function pushRows(core, handle, rows, count, scale) {
  if (scale !== 1) {
    for (let i = 0; i < count * COLUMNS; i += COLUMNS) {
      rows[i] *= scale;
      rows[i + 1] *= scale;
    }
  }
  inputView(core, count * COLUMNS).set(rows.subarray(0, count * COLUMNS));
  core.exports.fitter_push(handle, count);
}

function pushPoints(core, handle, { count, write }, scale) {
  const rows = new Float64Array(COLUMNS * Math.min(count, PIECE));
  for (let from = 0; from < count; from += PIECE) {
    const to = Math.min(count, from + PIECE);
    write(from, to, rows);
    pushRows(core, handle, rows, to - from, scale);
  }
}

/**
 * Fits one whole stroke and returns take(core, handle). Keeps the fitter for the next call with the
 * same values, because its buffers can be used again.
 */
export function fitOnce({ values, refine, scale }, reader, take) {
  const core = currentCore();
  const result = run(core, (wasm) => {
    if (!core.fit || core.fit.values.some((value, i) => value !== values[i])) {
      if (core.fit) wasm.fitter_free(core.fit.handle);
      core.fit = null;
      core.fit = { values, handle: newHandle(core, values) };
    }
    const { handle } = core.fit;
    wasm.fitter_begin(handle);
    pushPoints(core, handle, reader, scale);
    wasm.fitter_end(handle);
    if (refine) wasm.fitter_refine(handle);
    return take(core, handle);
  });
  trim(core);
  return result;
}

export function fitStroke(points, options = {}) {
  const settings = settingsOf(options);
  return fitOnce(settings, readerOf(points, settings.stride), (core, handle) => {
    check(core, core.exports.fitter_stroke(handle));
    return takeStroke(core, settings.form);
  });
}

// Frees fitters that nobody can reach any more.
const registry = new FinalizationRegistry(({ core, handle }) => release(core, handle));

function release(core, handle) {
  --core.fitters;
  if (core.alive) run(core, (wasm) => wasm.fitter_free(handle));
}

export class StrokeFitter {
  #core;
  #handle;
  #settings;
  #row = new Float64Array(COLUMNS);
  #state = 'drawing';

  constructor(options = {}) {
    this.#settings = settingsOf(options);
    this.#core = currentCore();
    this.#handle = run(this.#core, () => newHandle(this.#core, this.#settings.values));
    ++this.#core.fitters;
    registry.register(this, { core: this.#core, handle: this.#handle }, this);
  }

  /** Runs work(exports, handle, core). */
  #run(work) {
    if (this.#state === 'freed') throw new FeltlineError('this StrokeFitter was freed');
    return run(this.#core, (wasm) => work(wasm, this.#handle, this.#core));
  }

  #pushRow() {
    this.#run((_, handle, core) => pushRows(core, handle, this.#row, 1, this.#settings.scale));
  }

  begin() {
    this.#run((wasm, handle) => wasm.fitter_begin(handle));
    this.#state = 'drawing';
  }

  push(...args) {
    if (this.#state === 'ended') throw new FeltlineError('the stroke has ended; call begin() first');
    if (typeof args[0] === 'number') {
      writePoint(args, 0, this.#row, 0);
      this.#pushRow();
    } else if (args[0] !== null && isPoint(args[0])) {
      // An empty array is an empty list.
      if (Array.isArray(args[0]) && args[0].length === 0) return;
      writePoint(args[0], 0, this.#row, 0);
      this.#pushRow();
    } else {
      const reader = readerOf(args[0], this.#settings.stride);
      this.#run((_, handle, core) => pushPoints(core, handle, reader, this.#settings.scale));
    }
  }

  frozen(first = 0) {
    checkNumber(first, 'first', 0, 2 ** 31 - 1);
    first = Math.trunc(first);
    return this.#run((wasm, handle, core) => {
      wasm.fitter_frozen(handle, first);
      const rows = outputView(core), count = rows.length / 9;
      const flat = new Float64Array(8 * count), codes = new Uint8Array(count);
      for (let i = 0; i < count; ++i) {
        flat.set(rows.subarray(9 * i, 9 * i + 8), 8 * i);
        codes[i] = rows[9 * i + 8];
      }
      const { form } = this.#settings;
      const joints = first === 0 ? codes.subarray(1) : codes;
      return { segments: segmentsOf(flat, form), joints: jointsOf(joints, form) };
    });
  }

  tail() {
    return this.#run((wasm, handle, core) => {
      wasm.fitter_tail(handle);
      return segmentsOf(outputView(core), this.#settings.form);
    });
  }

  end() {
    this.#run((wasm, handle) => wasm.fitter_end(handle));
    this.#state = 'ended';
    return this.#stroke();
  }

  refine() {
    if (this.#state !== 'ended') throw new FeltlineError('call end() before refine()');
    this.#run((wasm, handle) => wasm.fitter_refine(handle));
    return this.#stroke();
  }

  #stroke() {
    return this.#run((wasm, handle, core) => {
      check(core, wasm.fitter_stroke(handle));
      return takeStroke(core, this.#settings.form);
    });
  }

  get ignored() {
    return this.#run((wasm, handle) => wasm.fitter_ignored(handle));
  }

  free() {
    if (this.#state === 'freed') return;
    this.#state = 'freed';
    registry.unregister(this);
    release(this.#core, this.#handle);
    trim(this.#core);
  }
}
