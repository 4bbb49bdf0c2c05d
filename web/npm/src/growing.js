// Strokes that grow from call to call of getStroke(). The points of a call usually begin with those of an earlier one, so
// the fitters of the strokes in progress are kept, and only get the points that are new. The points themselves are
// compared, so that it makes no difference whether they are in the same array, and any change is seen.
import { newHandle, pushRows, sameNumbers, wholeFitter } from './fitter.js';
import { currentCore, run, trim } from './module.js';
import { COLUMNS } from './points.js';

// The strokes that are kept, and their points together. The stroke that was not used for the longest time is freed first.
const MOST_STROKES = 16;
const MOST_POINTS = 1 << 16;
// Shorter strokes are fitted from the start, because simulated pressures of their first points still change.
const LEAST_POINTS = 16;

/** Returns how many points at the start of two strokes are the same. */
function commonCount(a, b) {
  const size = Math.min(a.length, b.length);
  let i = 0;
  while (i < size && a[i] === b[i] && a[i + 1] === b[i + 1] && a[i + 2] === b[i + 2]) i += COLUMNS;
  return i / COLUMNS;
}

/**
 * Removes from the kept strokes the one that these points continue, and returns it with `common`, the number of
 * points that did not change. Returns null if there is none.
 */
function takeKept(core, values, rows) {
  let best = null;
  for (const kept of core.growing) {
    if (!sameNumbers(kept.values, values)) continue;
    const common = commonCount(kept.rows, rows);
    if (common < kept.pushed || 2 * COLUMNS * common < kept.rows.length) continue;
    if (!best || common > best.common) best = Object.assign(kept, { common });
  }
  if (best) core.growing.splice(core.growing.indexOf(best), 1);
  return best;
}

/**
 * Keeps a stroke for the next call. Its fitter gets only the points that the last call had, too, because the others may
 * be predictions, which the next call replaces.
 */
function keep(core, kept, rows) {
  pushRows(core, kept.handle, rows.subarray(COLUMNS * kept.pushed, COLUMNS * kept.common));
  kept.pushed = kept.common;
  kept.rows = rows;
  core.growing.push(kept);
  let points = core.growing.reduce((sum, other) => sum + other.rows.length / COLUMNS, 0);
  while (core.growing.length > MOST_STROKES || points > MOST_POINTS) {
    const oldest = core.growing.shift();
    points -= oldest.rows.length / COLUMNS;
    core.exports.fitter_free(oldest.handle);
  }
}

/**
 * Fits the stroke with these rows and returns take(core, handle). `isComplete` means that it does not grow any more, so
 * that it is refined and not kept.
 */
export function fitGrowing(values, rows, isComplete, take) {
  const core = currentCore(), count = rows.length / COLUMNS;
  const result = run(core, (wasm) => {
    const handle = wholeFitter(core, values);
    let kept = takeKept(core, values, rows);
    if (!isComplete && count >= LEAST_POINTS && count <= MOST_POINTS) {
      kept ??= { values, handle: newHandle(core, values), rows, pushed: 0, common: 0 };
      keep(core, kept, rows);
    }
    if (kept) wasm.fitter_copy(handle, kept.handle);
    else wasm.fitter_begin(handle);
    pushRows(core, handle, rows.subarray(COLUMNS * (kept?.pushed ?? 0)));
    if (kept && !core.growing.includes(kept)) wasm.fitter_free(kept.handle);
    wasm.fitter_end(handle);
    if (isComplete) wasm.fitter_refine(handle);
    return take(core, handle);
  });
  trim(core);
  return result;
}
