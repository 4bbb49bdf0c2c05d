// getStroke(), with the call of perfect-freehand.
import { check, inputView } from './module.js';
import { fitGrowing } from './growing.js';
import { COLUMNS, readerOf } from './points.js';
import { takePolygons } from './strokes.js';

// The number of parts of a taper: PenTip::kSteps.
const TAPER_STEPS = 16;
// Strokes are fitted at a scale at which the size is at least this many mm, so that the smallest
// width and segment of the library (0.05 mm) do not show.
const LEAST_SIZE_MM = 8;
const LEAST_WIDTH_MM = 0.05;
// Points that are farther away are ignored: kMaxCoordinateMm.
const MOST_MM = 1e9;

const linear = (t) => t;

function optionNumber(options, name, usual, most = Infinity) {
  const value = options[name] ?? usual;
  if (typeof value !== 'number' || Number.isNaN(value)) throw new TypeError(`${name} must be a number`);
  return Math.min(most, value);
}

/** Returns the points that are no farther than `most` as rows of x, y, pressure. */
function usablePoints(points, stride, most) {
  const { count, write } = readerOf(points, stride);
  const rows = new Float64Array(COLUMNS * count);
  write(0, count, rows);
  const result = [];
  for (let i = 0; i < rows.length; i += COLUMNS) {
    if (Math.abs(rows[i]) <= most && Math.abs(rows[i + 1]) <= most) {
      result.push([rows[i], rows[i + 1], Number.isNaN(rows[i + 2]) ? 0.5 : rows[i + 2]]);
    }
  }
  return result;
}

/**
 * Replaces the pressures by those of a pen that presses less the faster it moves. The rate is that
 * of perfect-freehand (MIT), so that lines get about the same widths: from sample to sample,
 * the pressure moves towards 1 - s by the share 0.275 s, if the pen moved s times the size.
 */
function simulatePressure(points, size) {
  let pressure = 0.5;
  const step = (i) => {
    const [x, y] = points[i], [x0, y0] = points[Math.max(0, i - 1)];
    const speed = Math.min(1, Math.hypot(x - x0, y - y0) / size);
    pressure += (1 - speed - pressure) * 0.275 * speed;
    return pressure;
  };
  // The first samples decide how the line starts.
  for (let i = 1; i < Math.min(10, points.length); ++i) step(i);
  points.forEach((point, i) => {
    point[2] = step(i);
  });
}

/** Returns the diameter of the pen at a pressure. */
function diameterOf(pressure, size, thinning, easing) {
  if (thinning === 0) return size;
  const p = Math.min(1, Math.max(0, pressure));
  const share = Number(easing(0.5 - thinning * (0.5 - p)));
  return Number.isFinite(share) ? Math.max(0, 2 * size * share) : size;
}

/** Returns the numbers of PenTip for one end. */
function tipNumbers(tip, easing, length, size, scale) {
  const { taper = 0, cap = true } = tip ?? {};
  const ease = tip?.easing ?? easing;
  if (typeof ease !== 'function') throw new TypeError('easing must be a function');
  const long = taper === true ? Math.max(size, length) : Number(taper);
  const tapers = long > 0 && Number.isFinite(long);
  const shares = Array.from({ length: TAPER_STEPS + 1 }, (_, i) => {
    const share = Number(ease(i / TAPER_STEPS));
    return Number.isFinite(share) ? Math.max(0, share) : 1;
  });
  return [tapers ? long * scale : 0, !tapers && cap === false ? 1 : 0, ...shares];
}

/** Checks the size and the streamline; returns them and the scale at which strokes are fitted. */
function sizeOf(options) {
  if (options === null || typeof options !== 'object') throw new TypeError('options must be an object');
  const size = optionNumber(options, 'size', 16);
  if (!(size > 0 && size < Infinity)) throw new RangeError(`size must be greater than 0, not ${size}`);
  const streamline = Math.max(0, optionNumber(options, 'streamline', 0.5, 1));
  return { size, streamline, scale: Math.max(1, LEAST_SIZE_MM / size) };
}

const distanceOf = ([x, y], [x0, y0]) => Math.hypot(x - x0, y - y0);

/**
 * Returns the largest distance of the edge from the ink. At a smoothing of 0.5, the polygon has about as
 * many points as that of perfect-freehand, and lies nearer to the edge.
 */
const edgeOf = (size, smoothing) =>
  (0.12 + 2.16 * smoothing) * Math.min(1, Math.max(0.15 * Math.sqrt(size), size / 16));

/** Returns the outline of samples x, y, pressure, which lie within `tolerance` of the fitted curve. */
function outlineOf(samples, options, { size, scale }, tolerance) {
  const thinning = optionNumber(options, 'thinning', 0.5);
  const smoothing = Math.max(0, optionNumber(options, 'smoothing', 0.5, 1));
  const easing = options.easing ?? linear;
  if (typeof easing !== 'function') throw new TypeError('easing must be a function');
  if (samples.length === 0) return [];
  if (options.simulatePressure ?? true) simulatePressure(samples, size);

  const widths = samples.map((sample) => scale * diameterOf(sample[2], size, thinning, easing));
  const most = widths.reduce((a, b) => Math.max(a, b), 0);
  // Depends on the points as little as possible, so that the fit of the first points does not change when others follow.
  let widest = 2 * scale * size;
  while (widest < most && widest < Infinity) widest *= 2;
  const values = [scale * tolerance, LEAST_WIDTH_MM, widest, 1, 0.5, 20, 7.5, 1, 0.01 * scale * size, 0];
  const rows = new Float64Array(COLUMNS * samples.length).fill(NaN);
  samples.forEach(([x, y], i) => {
    const share = (widths[i] - LEAST_WIDTH_MM) / (widest - LEAST_WIDTH_MM);
    // -0 becomes 0, because the two are equal when points are compared.
    rows.set([x * scale + 0, y * scale + 0, share], i * COLUMNS);
  });
  const length = samples.reduce((sum, p, i) => sum + (i > 0 ? distanceOf(p, samples[i - 1]) : 0), 0);
  const look = [
    ...tipNumbers(options.start, (t) => t * (2 - t), length, size, scale),
    ...tipNumbers(options.end, (t) => 1 + (t - 1) ** 3, length, size, scale),
  ];
  const [polygon] = fitGrowing(values, rows, options.last === true, (core, handle) => {
    inputView(core, look.length).set(look);
    check(core, core.exports.fitter_look(handle, scale * edgeOf(size, smoothing)));
    return takePolygons(core);
  });
  return scale === 1 ? polygon : polygon.map(([x, y]) => [x / scale, y / scale]);
}

export function getStroke(points, options = {}) {
  const form = sizeOf(options);
  const samples = usablePoints(points, options.stride, MOST_MM / form.scale);
  return outlineOf(samples, options, form, form.streamline * Math.min(2, form.size / 4));
}

/**
 * Returns the points that the pen meant: each lags behind the pen, as in perfect-freehand, by the share of
 * the way that `streamline` says.
 */
export function getStrokePoints(points, options = {}) {
  const { streamline, scale } = sizeOf(options), result = [];
  const samples = usablePoints(points, options.stride, MOST_MM / scale);
  const share = 1 - 0.85 * streamline;
  samples.forEach(([x, y, pressure], i) => {
    const last = result[result.length - 1];
    if (!last) {
      result.push({ point: [x, y], pressure, vector: [1, 1], distance: 0, runningLength: 0 });
      return;
    }
    const [x0, y0] = last.point;
    const t = options.last && i === samples.length - 1 ? 1 : share;
    const point = t === 1 ? [x, y] : [x0 + t * (x - x0), y0 + t * (y - y0)];
    const distance = distanceOf(point, last.point);
    if (distance === 0) return;
    const vector = [(x0 - point[0]) / distance, (y0 - point[1]) / distance];
    if (result.length === 1) last.vector = vector;
    result.push({ point, pressure, vector, distance, runningLength: last.runningLength + distance });
  });
  return result;
}

/** Returns the outline of the points of getStrokePoints(), which are not smoothed again. */
export function getStrokeOutlinePoints(strokePoints, options = {}) {
  const form = sizeOf(options);
  const points = strokePoints.map(({ point: [x, y], pressure }) => [x, y, pressure]);
  return outlineOf(usablePoints(points, 2, MOST_MM / form.scale), options, form, 0.02 * form.size);
}
