// node same_bytes.mjs RAW NATIVE [--no-refine]: fits the raw strokes and counts the lines that differ
// from those of `feltline fit`.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fitStroke } from 'feltline';

const [, , raw, native, option] = process.argv;
const linesOf = (path) => readFileSync(path, 'utf8').split('\n').filter(Boolean);
const fitted = linesOf(native).map((line) => JSON.parse(line));
const strokes = linesOf(raw).map((line) => JSON.parse(line)).filter((record) => record.points);
assert.equal(strokes.length, fitted.length);
let different = 0, largest = 0;
strokes.forEach(({ points }, i) => {
  const ours = fitStroke(points, { refine: option !== '--no-refine' });
  const { segments, joints, widths } = fitted[i];
  if (JSON.stringify([ours.segments, ours.joints, ours.widths]) === JSON.stringify([segments, joints, widths])) return;
  ++different;
  const a = ours.segments.flat(), b = segments.flat();
  largest = a.length === b.length ? Math.max(largest, ...a.map((x, k) => Math.abs(x - b[k]))) : Infinity;
});
console.log(`${raw.split('/').at(-1)} ${option ?? ''}: ${different} of ${strokes.length} strokes differ, by at most ${largest}`);
assert.ok(different <= strokes.length / 1000);
