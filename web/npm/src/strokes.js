// Strokes as JavaScript values, as in the lines of a sketch (.ndjson), and functions of strokes.
import { FeltlineError, check, currentCore, inputView, outputView, run, trim } from './module.js';
import { isTyped } from './points.js';

const KINDS = ['smooth', 'corner'];
const FORMS = { arrays: null, float64: Float64Array, float32: Float32Array };

/** Returns `n` as a short text with at most `digits` decimals. */
const short = (n, digits) => String(Number(n.toFixed(digits)));

/** Returns the centre line as an SVG path. `flat` has 8 numbers for each segment. */
export function pathOf(flat, count, digits) {
  if (count === 0) return '';
  const text = (i) => `${short(flat[i], digits)} ${short(flat[i + 1], digits)}`;
  let d = `M${text(0)}`;
  for (let i = 0; i < 8 * count; i += 8) d += `C${text(i + 2)} ${text(i + 4)} ${text(i + 6)}`;
  return d;
}

/** Returns `flat` as an array of arrays with `size` numbers each. */
const rowsOf = (flat, size) =>
  Array.from({ length: flat.length / size }, (_, i) => Array.from(flat.subarray(size * i, size * i + size)));

/** Checks the options `output` and `digits`. */
export function outputForm({ output = 'arrays', digits = 3 }) {
  if (!Object.hasOwn(FORMS, output)) {
    throw new RangeError(`output must be 'arrays', 'float64' or 'float32', not '${output}'`);
  }
  if (!Number.isInteger(digits) || digits < 0 || digits > 20) {
    throw new RangeError(`digits must be 0 to 20, not ${digits}`);
  }
  return { Numbers: FORMS[output], digits };
}

/** Returns the segments from 8 numbers each, in the form that was asked for. */
export const segmentsOf = (flat, { Numbers }) => (Numbers ? Numbers.from(flat) : rowsOf(flat, 8));

/** Returns the joints from their codes. */
export const jointsOf = (codes, { Numbers }) =>
  Numbers ? Uint8Array.from(codes) : Array.from(codes, (code) => KINDS[code]);

/** Reads the stroke in the output. */
export function takeStroke(core, form) {
  const numbers = outputView(core);
  const count = numbers[0], closed = numbers[1] !== 0;
  const points = numbers.subarray(3, 3 + 2 * (3 * count + 1));
  const flat = new Float64Array(8 * count);
  for (let i = 0; i < count; ++i) flat.set(points.subarray(6 * i, 6 * i + 8), 8 * i);
  const jointsAt = 3 + points.length, widthsAt = jointsAt + (closed ? count : count - 1);
  const widths = numbers.subarray(widthsAt, widthsAt + 2 * numbers[2]);
  return {
    closed,
    segments: segmentsOf(flat, form),
    joints: jointsOf(numbers.subarray(jointsAt, widthsAt), form),
    widths: form.Numbers ? form.Numbers.from(widths) : rowsOf(widths, 2),
    d: pathOf(flat, count, form.digits) + (closed ? 'Z' : ''),
  };
}

/** Returns a list of rows, or a typed array, as one Float64Array. */
function flattened(list, size, name) {
  if (isTyped(list)) {
    if (list.length % size === 0) return Float64Array.from(list);
  } else if (Array.isArray(list)) {
    const isRow = (row) => (Array.isArray(row) || isTyped(row)) && row.length === size;
    if (list.every(isRow)) return Float64Array.from(list.flatMap((row) => Array.from(row)));
  }
  throw new TypeError(`${name} must be rows of ${size} numbers, or a typed array`);
}

function jointCode(joint, i) {
  const code = typeof joint === 'string' ? KINDS.indexOf(joint) : joint;
  if (code === 0 || code === 1) return code;
  throw new TypeError(`joints[${i}] must be 'smooth' or 'corner'`);
}

/** Writes a stroke into the input. Neighbouring segments must share their joint. */
function giveStroke(core, stroke) {
  if (stroke === null || typeof stroke !== 'object') throw new TypeError('the stroke must be an object');
  const { closed = false, segments, joints, widths } = stroke;
  const flat = flattened(segments, 8, 'segments'), knots = flattened(widths, 2, 'widths');
  const count = flat.length / 8, jointCount = closed ? count : count - 1;
  if (count === 0) throw new TypeError('the stroke has no segments');
  if (!(Array.isArray(joints) || isTyped(joints)) || joints.length !== jointCount) {
    throw new TypeError(`joints must have ${jointCount} elements for ${count} segments`);
  }
  const input = inputView(core, 3 + 6 * count + 2 + jointCount + knots.length);
  input[0] = count;
  input[1] = closed ? 1 : 0;
  input[2] = knots.length / 2;
  input.set(flat.subarray(0, 2), 3);
  for (let i = 0; i < count; ++i) {
    if (i > 0 && (flat[8 * i] !== flat[8 * i - 2] || flat[8 * i + 1] !== flat[8 * i - 1])) {
      throw new TypeError(`segments[${i}] does not start where the previous one ends`);
    }
    input.set(flat.subarray(8 * i + 2, 8 * i + 8), 5 + 6 * i);
  }
  for (let i = 0; i < jointCount; ++i) input[5 + 6 * count + i] = jointCode(joints[i], i);
  input.set(knots, 5 + 6 * count + jointCount);
}

/** Calls `call` with the stroke in the input, and returns what `take` makes of the output. */
function withStroke(stroke, call, take) {
  const core = currentCore();
  const result = run(core, (wasm) => {
    giveStroke(core, stroke);
    check(core, call(wasm));
    return take(core);
  });
  trim(core);
  return result;
}

export function checkNumber(value, name, least, most) {
  if (typeof value !== 'number') throw new TypeError(`${name} must be a number, not ${typeof value}`);
  if (value >= least && value <= most) return value;
  throw new RangeError(`${name} must be ${least} to ${most}, not ${value}`);
}

export function nearest(stroke, point) {
  const [x, y] = Array.isArray(point) || isTyped(point) ? point : [point?.x, point?.y];
  if (typeof x !== 'number' || typeof y !== 'number') {
    throw new TypeError('the point must be [x, y] or {x, y}');
  }
  if (!Number.isFinite(x) || !Number.isFinite(y)) throw new RangeError('the point must be finite');
  return withStroke(stroke, (wasm) => wasm.stroke_nearest(x, y), (core) => {
    const [u, nearX, nearY, distance, width] = outputView(core);
    return { u, point: [nearX, nearY], distance, width };
  });
}

/** Reads the polygons in the output as arrays of [x, y]. */
export function takePolygons(core) {
  const numbers = outputView(core), polygons = [];
  let at = 1 + numbers[0], begin = 0;
  for (let k = 1; k <= numbers[0]; begin = numbers[k++]) {
    const polygon = new Array(numbers[k] - begin);
    for (let i = 0; i < polygon.length; ++i, at += 2) polygon[i] = [numbers[at], numbers[at + 1]];
    polygons.push(polygon);
  }
  return polygons;
}

/** Reads the lines and curves in the output as an SVG path. */
function takePath(core, digits) {
  const numbers = outputView(core), verbs = numbers[0];
  let at = 1 + verbs, d = '';
  for (let i = 1; i <= verbs; ++i) {
    const points = [1, 1, 3, 0][numbers[i]];
    d += 'MLCZ'[numbers[i]];
    for (let k = 0; k < 2 * points; ++k, ++at) d += (k > 0 ? ' ' : '') + short(numbers[at], digits);
  }
  return d;
}

export function outline(stroke, options = {}) {
  const { tolerance = 0.05 } = options, { digits } = outputForm(options);
  checkNumber(tolerance, 'tolerance', 1e-6, 1e9);
  return {
    polygons: withStroke(stroke, (wasm) => wasm.stroke_outline(tolerance), takePolygons),
    d: withStroke(stroke, (wasm) => wasm.stroke_outline_path(tolerance), (core) => takePath(core, digits)),
  };
}

export function part(stroke, from, to, options = {}) {
  const form = outputForm(options);
  checkNumber(from, 'from', -Infinity, Infinity);
  checkNumber(to, 'to', -Infinity, Infinity);
  return withStroke(stroke, (wasm) => wasm.stroke_part(from, to), (core) => takeStroke(core, form));
}

export function split(stroke, u, options = {}) {
  if (stroke?.closed) throw new FeltlineError('a closed stroke cannot be divided into two parts by one cut');
  return [part(stroke, 0, u, options), part(stroke, u, Infinity, options)];
}
