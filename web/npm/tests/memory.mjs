// Neither the memory of wasm nor the heap grows over 10^5 calls.
import assert from 'node:assert/strict';
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
