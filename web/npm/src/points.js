// The forms in which callers may pass points.

/** The number of columns of a sample in wasm: x, y, pressure, time in ms, tilt in degrees. */
export const COLUMNS = 5;

const NAMES = ['x', 'y', 'pressure', 'time', 'tilt'];

export const isTyped = (value) => ArrayBuffer.isView(value) && !(value instanceof DataView);

const kindOf = (value) =>
  value === null ? 'null' : Array.isArray(value) ? 'an array' : typeof value;

/** Returns true for one point: an object with x and y, or an array that starts with a number. */
export const isPoint = (value) =>
  Array.isArray(value) ? typeof value[0] === 'number' : !isTyped(value) && typeof value === 'object';

/** Returns a number of a point; NaN if it is absent and may be. */
function numberOf(value, column, index) {
  if (typeof value === 'number') return value;
  if (column > 1 && value == null) return NaN;
  // Raw strokes of .ndjson files have an object after the time: {"tilt": 32.5}.
  if (column === 4 && typeof value === 'object') return numberOf(value.tilt, 4, index);
  throw new TypeError(`points[${index}]: ${NAMES[column]} must be a number, not ${kindOf(value)}`);
}

/** Writes one point into `row` of `to`. */
export function writePoint(point, index, to, row) {
  const isList = Array.isArray(point) || isTyped(point);
  if (!isList && (point === null || typeof point !== 'object')) {
    throw new TypeError(
      `points[${index}] must be [x, y, pressure] or {x, y, pressure}, not ${kindOf(point)}`);
  }
  for (let column = 0; column < COLUMNS; ++column) {
    const value = isList ? point[column] : point[NAMES[column]];
    to[row * COLUMNS + column] = numberOf(value, column, index);
  }
}

/**
 * Returns how to read `points`: their number, and write(from, to, rows), which writes the points
 * from `from` up to `to` into `rows`.
 */
export function readerOf(points, stride = 2) {
  if (isTyped(points)) {
    if (!Number.isInteger(stride) || stride < 2 || stride > COLUMNS) {
      throw new RangeError(`stride must be 2 to ${COLUMNS}, not ${stride}`);
    }
    if (points.length % stride !== 0) {
      throw new RangeError(`${points.length} numbers are not a multiple of stride = ${stride}`);
    }
    return {
      count: points.length / stride,
      write(from, to, rows) {
        for (let i = from; i < to; ++i) {
          for (let column = 0; column < COLUMNS; ++column) {
            rows[(i - from) * COLUMNS + column] =
              column < stride ? Number(points[i * stride + column]) : NaN;
          }
        }
      },
    };
  }
  if (!Array.isArray(points)) {
    throw new TypeError(`points must be an array or a typed array, not ${kindOf(points)}`);
  }
  return {
    count: points.length,
    write(from, to, rows) {
      for (let i = from; i < to; ++i) writePoint(points[i], i, rows, i - from);
    },
  };
}
