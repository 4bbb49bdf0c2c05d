// Fitting: fitStroke() for whole strokes and StrokeFitter while the pen draws.
import { FeltlineError, check, currentCore, inputView, isInUse, outputView, run, trim } from './module.js';
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

export function newHandle(core, values) {
  inputView(core, values.length).set(values);
  return core.exports.fitter_new();
}

export const sameNumbers = (a, b) => a.every((value, i) => value === b[i]);

function scaleRows(rows, scale) {
  if (scale === 1) return;
  for (let i = 0; i < rows.length; i += COLUMNS) {
    rows[i] *= scale;
    rows[i + 1] *= scale;
  }
}

export function pushRows(core, handle, rows) {
  for (let from = 0; from < rows.length; from += PIECE * COLUMNS) {
    const piece = rows.slice(from, from + PIECE * COLUMNS);
    inputView(core, piece.length).set(piece);
    core.exports.fitter_push(handle, piece.length / COLUMNS);
  }
}

/** Calls use(rows) for pieces of the points of a reader, in mm. */
function forPieces({ count, write }, scale, use) {
  const buffer = new Float64Array(COLUMNS * Math.min(count, PIECE));
  for (let from = 0; from < count; from += PIECE) {
    const to = Math.min(count, from + PIECE), rows = buffer.subarray(0, COLUMNS * (to - from));
    write(from, to, rows);
    scaleRows(rows, scale);
    use(rows);
  }
}

/** Returns the fitter for whole strokes. It is kept for the next call with the same values, which reuses its buffers. */
export function wholeFitter(core, values) {
  if (!core.fit || !sameNumbers(core.fit.values, values)) {
    if (core.fit) core.exports.fitter_free(core.fit.handle);
    core.fit = null;
    core.fit = { values, handle: newHandle(core, values) };
  }
  return core.fit.handle;
}

/** What can be wrong with pressures and times, in the order of the bits of fitter_faults(). */
const FAULTS = [
  'pressures outside 0 to 1 count as 0 or 1',
  'the times are not milliseconds and were ignored',
  'some times run backwards',
];

/** Returns the finished stroke, with `notices` if something was wrong with its points. */
function finished(core, handle, form) {
  check(core, core.exports.fitter_stroke(handle));
  const stroke = takeStroke(core, form), bits = core.exports.fitter_faults(handle);
  if (bits) stroke.notices = FAULTS.filter((_, i) => bits >> i & 1);
  return stroke;
}

export function fitStroke(points, options = {}) {
  const { values, refine, scale, stride, form } = settingsOf(options);
  const reader = readerOf(points, stride), core = currentCore();
  const stroke = run(core, (wasm) => {
    const handle = wholeFitter(core, values);
    wasm.fitter_begin(handle);
    forPieces(reader, scale, (rows) => pushRows(core, handle, rows));
    wasm.fitter_end(handle);
    if (refine) wasm.fitter_refine(handle);
    return finished(core, handle, form);
  });
  trim(core);
  return stroke;
}

// The fitters of wasm that StrokeFitters have on loan. They are few, however many StrokeFitters there are, because the
// collector does not see the memory of wasm and so is in no hurry. A StrokeFitter keeps its points; if its fitter went to
// another one, it gets a new one and pushes the points again, which gives the same curve.

/** Returns the loan of a core that nobody uses or that was not used for the longest time, or a new one if there are few. */
function freeLoan(core) {
  const index = core.loans.findIndex((loan) => !isInUse(loan));
  if (index >= 0) return core.loans.splice(index, 1)[0];
  return core.loans.length < core.maxLoans ? { handle: 0, values: null, owner: null } : core.loans.shift();
}

/** Lends a fitter with these values to `owner`. It is used last now. */
function lend(core, values, owner) {
  const loan = freeLoan(core);
  loan.owner = null;
  if (loan.values === null || !sameNumbers(loan.values, values)) {
    if (loan.handle) core.exports.fitter_free(loan.handle);
    loan.handle = newHandle(core, values);
    loan.values = values;
  }
  core.exports.fitter_begin(loan.handle);
  loan.owner = new WeakRef(owner);
  core.loans.push(loan);
  return loan;
}

export class StrokeFitter {
  #core = null;
  #loan = null;
  #settings;
  #row = new Float64Array(COLUMNS);
  #rows = [];  // the numbers of all points, COLUMNS each
  #state = 'drawing';

  constructor(options = {}) {
    this.#settings = settingsOf(options);
    this.#run(() => {});
  }

  /** Gets a fitter, and brings it to the state of this stroke. */
  #borrow() {
    const before = this.#loan;
    this.#core = currentCore();
    this.#loan = run(this.#core, () => lend(this.#core, this.#settings.values, this));
    // Strokes that are drawn at the same time must not take the fitters from each other at each point.
    if (before) this.#core.maxLoans = Math.min(1 << 16, 2 * this.#core.maxLoans);
    run(this.#core, (wasm) => {
      const { handle } = this.#loan;
      pushRows(this.#core, handle, this.#rows);
      if (this.#state !== 'drawing') wasm.fitter_end(handle);
      if (this.#state === 'refined') wasm.fitter_refine(handle);
    });
  }

  /** Runs work(exports, handle, core). */
  #run(work) {
    if (this.#state === 'freed') throw new FeltlineError('this StrokeFitter was freed');
    if (this.#loan?.owner?.deref() !== this || !this.#core.alive) this.#borrow();
    return run(this.#core, (wasm) => work(wasm, this.#loan.handle, this.#core));
  }

  /** Adds points in mm. */
  #push(rows) {
    this.#run((_, handle, core) => pushRows(core, handle, rows));
    this.#rows.push(...rows);
  }

  #pushRow() {
    scaleRows(this.#row, this.#settings.scale);
    this.#push(this.#row);
  }

  begin() {
    if (this.#state !== 'freed') this.#state = 'drawing';
    this.#rows.length = 0;  // first, so that a borrowed fitter gets none of them
    this.#run((wasm, handle) => wasm.fitter_begin(handle));
  }

  push(...args) {
    if (this.#state === 'ended' || this.#state === 'refined') {
      throw new FeltlineError('the stroke has ended; call begin() first');
    }
    if (typeof args[0] === 'number') {
      writePoint(args, 0, this.#row, 0);
      this.#pushRow();
    } else if (args[0] !== null && isPoint(args[0])) {
      // An empty array is an empty list.
      if (Array.isArray(args[0]) && args[0].length === 0) return;
      writePoint(args[0], 0, this.#row, 0);
      this.#pushRow();
    } else {
      forPieces(readerOf(args[0], this.#settings.stride), this.#settings.scale, (rows) => this.#push(rows));
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
    if (this.#state === 'drawing') this.#state = 'ended';
    return this.#stroke();
  }

  refine() {
    if (this.#state === 'drawing') throw new FeltlineError('call end() before refine()');
    this.#run((wasm, handle) => wasm.fitter_refine(handle));
    this.#state = 'refined';
    return this.#stroke();
  }

  #stroke() {
    return this.#run((_, handle, core) => finished(core, handle, this.#settings.form));
  }

  get ignored() {
    return this.#run((wasm, handle) => wasm.fitter_ignored(handle));
  }

  free() {
    if (this.#state === 'freed') return;
    this.#state = 'freed';
    this.#rows.length = 0;
    if (this.#loan?.owner?.deref() === this) this.#loan.owner = null;
    trim(this.#core);
  }
}
