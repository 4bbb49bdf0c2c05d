// The package as an ES module, with the wasm module inside and beside it.
import assert from 'node:assert/strict';
import getStroke, {
  StrokeFitter, fitStroke, getStrokeOutlinePoints, getStrokePoints, nearest, outline, part, split,
} from 'feltline';
import * as slim from 'feltline/slim';

const points = Array.from({ length: 200 }, (_, i) => [i, 50 * Math.sin(i / 20), 0.3 + i / 500]);
const stroke = fitStroke(points);
assert.ok(stroke.segments.length > 2 && stroke.segments.length < 12);
assert.equal(stroke.joints.length, stroke.segments.length - 1);
assert.match(stroke.d, /^M0 0C/);
for (const [x, y] of points) assert.ok(nearest(stroke, [x, y]).distance <= 0.15 + 1e-9);
assert.ok(stroke.widths.at(-1)[1] > stroke.widths[0][1]);

assert.throws(() => slim.fitStroke(points), /init/);
await slim.init();
assert.deepEqual(slim.fitStroke(points), stroke);

// Typed arrays in and out.
const flat = Float64Array.from(points.flat());
const typed = fitStroke(flat, { stride: 3, output: 'float64' });
assert.deepEqual(Array.from(typed.segments), stroke.segments.flat());
const single = fitStroke(flat, { stride: 3, output: 'float32' });
assert.ok(single.segments instanceof Float32Array);
assert.ok(nearest(single, [20, 42]).distance < 1);

// Streaming gives the same stroke, and what is frozen does not change.
const fitter = new StrokeFitter();
let frozen = [];
for (const [x, y, pressure] of points) {
  fitter.push(x, y, pressure);
  const now = fitter.frozen().segments;
  assert.deepEqual(now.slice(0, frozen.length), frozen);
  frozen = now;
  const tail = fitter.tail();
  if (tail.length > 0 && frozen.length > 0) {
    assert.deepEqual(tail[0].slice(0, 2), frozen.at(-1).slice(6));
  }
}
const online = fitter.end();
assert.deepEqual(online, fitStroke(points, { refine: false }));
assert.deepEqual(online.segments.slice(0, frozen.length), frozen);
assert.deepEqual(fitter.refine(), stroke);
fitter.begin();
fitter.push(points);
assert.deepEqual(fitter.end(), online);
fitter.free();

// Parts and outlines.
const [before, after] = split(stroke, 1.5);
assert.deepEqual(before.segments.at(-1).slice(6), after.segments[0].slice(0, 2));
assert.equal(before.segments.length + after.segments.length, stroke.segments.length + 1);
assert.equal(part(stroke, 1, 2).segments.length, 1);
const edge = outline(stroke);
assert.equal(edge.polygons.length, 1);
assert.match(edge.d, /^M.*Z$/);

// The outline covers all samples, like that of perfect-freehand.
const inside = (polygon, [x, y]) => {
  let winding = 0;
  polygon.forEach(([x0, y0], i) => {
    const [x1, y1] = polygon[(i + 1) % polygon.length];
    if (y0 <= y !== y1 <= y && (x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0))) winding += y1 > y0 ? 1 : -1;
  });
  return winding !== 0;
};
const ring = getStroke(points, { size: 16, simulatePressure: false, last: true });
for (const point of points) assert.ok(inside(ring, point), `${point}`);
const flatEnds = getStroke([[0, 0, 0.5], [100, 0, 0.5]], {
  simulatePressure: false, start: { cap: false }, end: { cap: false } });
assert.ok(flatEnds.every(([x]) => x >= -1e-9 && x <= 100 + 1e-9));
const straight = [[0, 0, 0.5], [50, 0, 0.5], [100, 0, 0.5]];
const tapered = getStroke(straight, { simulatePressure: false, start: { taper: 40 }, end: { taper: 40 } });
for (const x of [2, 98]) assert.ok(inside(tapered, [x, 0]) && !inside(tapered, [x, 4]));
assert.ok(inside(tapered, [50, 7.5]) && !inside(tapered, [50, 8.5]));
const even = getStroke(straight, { thinning: 0 });
assert.ok(inside(even, [20, 7.9]) && !inside(even, [20, 8.1]));

// The polygon has at most 1.3 times the points of perfect-freehand's. Its numbers (1.2.3, thinning 0.6, last) for these
// curves are written here, because it is no part of the tests.
const curves = Array.from({ length: 12 }, (_, k) => {
  let seed = k + 1, x = 100, y = 100, bend = 0;
  const random = () => (seed = (seed * 1664525 + 1013904223) % 2 ** 32) / 2 ** 32;
  let angle = 6 * random();
  const count = 60 + Math.floor(200 * random()), step = 2 + 6 * random();
  return Array.from({ length: count }, (_, i) => {
    bend = 0.95 * (bend + 0.25 * (random() - 0.5));
    angle += bend;
    const length = step * (0.4 + 0.6 * Math.abs(Math.sin(0.07 * i)));
    x += length * Math.cos(angle);
    y += length * Math.sin(angle);
    return [Math.round(10 * x) / 10, Math.round(10 * y) / 10, 0.5];
  });
});
for (const [size, theirs] of [[1, 4088], [4.25, 3812], [16, 1898]]) {
  const ours = curves.reduce((sum, points) => sum + getStroke(points, { size, thinning: 0.6, last: true }).length, 0);
  assert.ok(ours <= 1.3 * theirs, `size ${size}: ${ours} points, perfect-freehand ${theirs}`);
}

// The two steps.
const steps = getStrokePoints(points, { streamline: 0.5, last: true });
assert.deepEqual(steps[0].point, points[0].slice(0, 2));
assert.deepEqual(steps.at(-1).point, points.at(-1).slice(0, 2));
let runningLength = 0;
steps.forEach((step, i) => {
  if (i > 0) assert.ok(Math.abs(Math.hypot(step.point[0] - steps[i - 1].point[0],
    step.point[1] - steps[i - 1].point[1]) - step.distance) < 1e-9);
  assert.ok(Math.abs((runningLength += step.distance) - step.runningLength) < 1e-9);
  assert.ok(i === 0 || Math.abs(Math.hypot(...step.vector) - 1) < 1e-9);
});
const stepped = getStrokeOutlinePoints(steps, { size: 16, simulatePressure: false, last: true });
for (const { point } of steps) assert.ok(inside(stepped, point), `${point}`);
assert.deepEqual(getStrokePoints([]), []);
assert.deepEqual(getStrokeOutlinePoints([]), []);
assert.deepEqual(getStrokePoints([[3, 4], [3, 4]]).length, 1);
assert.deepEqual(getStrokePoints(points, { streamline: 0 }).map((step) => step.point), points.map((p) => p.slice(0, 2)));
console.log('ESM: passed');
