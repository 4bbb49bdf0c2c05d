// Neither the memory of wasm nor the heap grows over 10^5 calls.
import assert from 'node:assert/strict';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { StrokeFitter, fitStroke, getStroke } from 'feltline';

const points = Array.from({ length: 12 }, (_, i) => [4 * i, 9 * Math.sin(i), 0.5]);
const round = (count) => {
  for (let i = 0; i < count; ++i) {
    getStroke(points);
    fitStroke(points, { tolerance: i % 2 ? 0.1 : 0.5 });
    if (i % 10 === 0) {
      const fitter = new StrokeFitter();
      fitter.push(points);
      fitter.end();
      fitter.free();
    }
  }
};
round(5000);
const before = process.memoryUsage();
round(45000);
const after = process.memoryUsage();
const bytes = after.rss - before.rss;
console.log(`10^5 calls: rss ${bytes} bytes, arrays ${after.arrayBuffers - before.arrayBuffers} bytes`);
assert.ok(bytes < 48 << 20);
assert.ok(after.arrayBuffers - before.arrayBuffers < 16 << 20);

// Fitters that nobody frees: the memory of wasm does not grow with their number.
// `external` contains it, `arrayBuffers` does not. What is garbage in JavaScript does not count.
setFlagsFromString('--expose-gc');
const collect = runInNewContext('gc');
const memory = () => {
  collect();
  return process.memoryUsage().external;
};
const forgotten = (count) => {
  for (let i = 0; i < count; ++i) {
    const fitter = new StrokeFitter({ tolerance: i % 3 ? 0.15 : 0.3 });
    fitter.push(points);
    if (i % 2) fitter.end();
  }
};
forgotten(1000);
const start = memory();
forgotten(30000);
console.log(`3 x 10^4 forgotten fitters: ${memory() - start} bytes outside the heap`);
assert.ok(memory() - start < 16 << 20);

// Many strokes that are drawn at the same time, in any state, are those of one call each.
const many = Array.from({ length: 100 }, (_, k) => ({
  fitter: new StrokeFitter({ tolerance: 0.1 + 0.01 * (k % 4), mmPerUnit: 1 + (k % 2) }),
  points: Array.from({ length: 60 + k }, (_, i) => [3 * i, 20 * Math.sin(i / (5 + k % 7)), 0.5]),
}));
for (let i = 0; i < 160; ++i) {
  for (const { fitter, points } of many) {
    if (i < points.length) fitter.push(points[i]);
    if (i === points.length) fitter.end();
  }
}
many.forEach(({ fitter, points }, k) => {
  const options = { tolerance: 0.1 + 0.01 * (k % 4), mmPerUnit: 1 + (k % 2) };
  if (k < 99) assert.deepEqual(fitter.frozen().segments, fitStroke(points, { ...options, refine: false }).segments);
  else fitter.end();
  assert.deepEqual(fitter.refine(), fitStroke(points, options));
});
many.forEach(({ fitter, points }, k) => {
  if (k % 3 === 0) fitter.free();
  else assert.equal(fitter.ignored, 0);
});
