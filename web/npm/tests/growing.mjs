// getStroke() of a stroke that grows fits only what is new, and returns what a fresh instance returns.
import assert from 'node:assert/strict';

// Counts the points that wasm gets, and the fitters that it has.
let pushed = 0, fitters = 0, memory = null;
const Real = WebAssembly.Instance;
WebAssembly.Instance = function Instance(module, imports) {
  const { exports } = new Real(module, imports);
  memory ??= exports.memory;
  return { exports: {
    ...exports,
    fitter_push(handle, count) {
      pushed += count;
      return exports.fitter_push(handle, count);
    },
    fitter_new() {
      ++fitters;
      return exports.fitter_new();
    },
    fitter_free(handle) {
      --fitters;
      return exports.fitter_free(handle);
    },
  } };
};
const { getStroke, getStrokeOutlinePoints, getStrokePoints } = await import('feltline');

let instances = 0;
/** Returns what an instance that has seen no other stroke returns. */
async function fresh(points, options) {
  const before = [pushed, fitters];
  const url = `${import.meta.resolve('feltline')}?fresh=${++instances}`;
  const polygon = (await import(url)).getStroke(points, options);
  [pushed, fitters] = before;
  return polygon;
}

let seed = 1;
const random = () => (seed = (seed * 1664525 + 1013904223) % 2 ** 32) / 2 ** 32;
function scribble(count) {
  let x = 100 * random(), y = 100 * random(), angle = 6 * random();
  return Array.from({ length: count }, () => {
    angle += 0.8 * (random() - 0.5);
    const step = 1 + 5 * random();
    return [x += step * Math.cos(angle), y += step * Math.sin(angle), random()];
  });
}

/** Calls getStroke() after each new point; returns the number of points that wasm got, and the last polygon. */
function grow(points, options, list = (count) => points.slice(0, count)) {
  const before = pushed;
  let polygon = [];
  for (let count = 1; count <= points.length; ++count) polygon = getStroke(list(count), options);
  return { count: pushed - before, polygon };
}

// Each point is given to wasm at most twice, whether the array is a new one or the same, and in all forms of points.
const long = scribble(2000);
const same = [];
const flat = Float64Array.from(long.flat());
for (const [name, options, list] of [
  ['new arrays', { size: 8 }],
  ['the same array', { size: 9 }, (count) => (same.push(long[count - 1]), same)],
  ['objects', { size: 10 }, (count) => long.slice(0, count).map(([x, y, pressure]) => ({ x, y, pressure }))],
  ['typed arrays', { size: 11, stride: 3 }, (count) => flat.subarray(0, 3 * count)],
  ['pressures of a pen', { size: 8, simulatePressure: false }],
  ['an easing', { size: 8, easing: (t) => 5 * t * t, simulatePressure: false }],
  ['a small size', { size: 0.5, smoothing: 1 }],
  ['predicted points', { size: 12 }, (count) => [...long.slice(0, count), ...scribble(3)]],
]) {
  const { count, polygon } = grow(long, options, list);
  console.log(`${name}: ${count} points given for ${long.length}`);
  // The points of predictions and those of the first 16 calls are added.
  assert.ok(count <= (name === 'predicted points' ? 5 : 2) * long.length + 200);
  if (name !== 'predicted points') {
    assert.deepEqual(polygon, await fresh(options.stride ? flat : long, options));
  }
}
// A pen that presses harder and harder: the range of widths grows a few times only.
const harder = long.slice(0, 500).map(([x, y], i) => [x, y, i / 500]);
const strong = { size: 8, simulatePressure: false, easing: (t) => 40 * t };
const { count, polygon } = grow(harder, strong);
assert.ok(count <= 2 * 500 + 16 * 500, `${count}`);
assert.deepEqual(polygon, await fresh(harder, strong));
// The two steps cost no more.
{
  const before = pushed;
  for (let n = 1; n <= 1000; ++n) getStrokeOutlinePoints(getStrokePoints(long.slice(0, n)));
  assert.ok(pushed - before <= 2 * 1000 + 200);
}

// An earlier point changes: its coordinates, its pressure, by the least bit, or only the sign of a zero.
const options = { size: 7, simulatePressure: false };
for (const [index, column] of [[0, 0], [3, 1], [200, 2], [390, 0], [399, 1]]) {
  grow(long.slice(0, 400), options);
  const changed = long.slice(0, 401).map((point) => [...point]);
  changed[index][column] += 1e-13 * changed[index][column];
  assert.deepEqual(getStroke(changed, options), await fresh(changed, options), `point ${index}`);
  // The same array, changed in place.
  const own = long.slice(0, 400).map((point) => [...point]);
  getStroke(own, options);
  getStroke(own, options);
  own[index][column] *= 0.99;
  assert.deepEqual(getStroke(own, options), await fresh(own, options), `point ${index} in place`);
}
const rest = scribble(30);
for (const zero of [0, 0, -0, 0]) {
  const points = [[zero, zero, zero], ...rest];
  assert.deepEqual(getStroke(points, options), await fresh(points, options));
}

// Points are removed.
grow(long.slice(0, 300), options);
for (const left of [299, 298, 200, 16, 15, 2, 1]) {
  assert.deepEqual(getStroke(long.slice(0, left), options), await fresh(long.slice(0, left), options), `${left} left`);
}

// Strokes that grow at the same time, also if they start at the same point, cost no more than one after the other.
for (const strokes of [Array.from({ length: 10 }, () => scribble(300)),
  [long.slice(0, 300), long.slice(0, 300).map(([x, y, p], i) => i < 9 ? [x, y, p] : [x, -y, p])]]) {
  const before = pushed;
  for (let n = 1; n <= 300; ++n) for (const points of strokes) getStroke(points.slice(0, n), options);
  assert.ok(pushed - before <= strokes.length * (2 * 300 + 200), `${(pushed - before) / strokes.length} points per stroke`);
  for (const points of strokes) assert.deepEqual(getStroke(points, options), await fresh(points, options));
}

// A trail that fades, such as that of a laser pointer: its first points go at each call. A call costs what the trail has,
// however far it has come, and a stroke that is drawn beside it costs no more than alone.
{
  const trail = [], line = scribble(600), kMost = 40;
  let of_line = 0, of_trail = 0;
  for (let n = 1; n <= line.length; ++n) {
    let before = pushed;
    getStroke(line.slice(0, n), options);
    of_line += pushed - before;
    trail.push(long[n]);
    if (trail.length > kMost) trail.shift();
    before = pushed;
    const polygon = getStroke(trail, { ...options, size: 6 });
    of_trail += pushed - before;
    if (n % 200 === 0) assert.deepEqual(polygon, await fresh(trail, { ...options, size: 6 }), `trail ${n}`);
  }
  assert.ok(of_trail <= kMost * line.length, `${of_trail}`);
  assert.ok(of_line <= 2 * line.length + 200, `${of_line}`);
}

// Options change between the calls, each alone. Those of the look alone need no new fit.
for (const [change, refits] of [[{ smoothing: 0.9 }, false], [{ start: { taper: 40 }, end: { cap: false } }, false],
  [{ last: true }, false], [{ size: 9 }, true], [{ thinning: 0.2 }, true], [{ streamline: 0.1 }, true],
  [{ simulatePressure: true }, true], [{ easing: (t) => t * t }, true]]) {
  const points = scribble(120);
  grow(points.slice(0, 119), options);
  const now = { ...options, ...change }, before = pushed;
  const polygon = getStroke(points, now);
  if (!refits) assert.ok(pushed - before <= 4);
  assert.deepEqual(polygon, await fresh(points, now), JSON.stringify(change));
  assert.deepEqual(getStroke(points, options), await fresh(points, options));
}

// Random calls of all these kinds.
const strokes = [scribble(80), scribble(80)], looks = [options, { size: 3 }, { ...options, streamline: 1 }];
for (let i = 0; i < 150; ++i) {
  const k = Math.floor(2 * random()), points = strokes[k], dice = random();
  if (dice < 0.6) points.push(...scribble(1 + Math.floor(3 * random())));
  else if (dice < 0.75) points.length = Math.ceil(points.length * (0.4 + 0.6 * random()));
  else if (dice < 0.85) points[Math.floor(points.length * random())] = scribble(1)[0];
  else if (dice < 0.9) strokes[k] = points.map((point) => [...point]);
  const look = { ...looks[Math.floor(1.2 * random() * looks.length) % looks.length], last: random() < 0.1 };
  const polygon = getStroke(strokes[k], look);
  if (i % 6 === 0) assert.deepEqual(polygon, await fresh(strokes[k], look), `call ${i}`);
}

// Strokes that are forgotten are freed, one that is complete at once, and a long one that is in progress is kept.
const getMany = (count) => {
  for (let i = 0; i < count; ++i) {
    const points = scribble(40);
    for (let n = 20; n <= 40; n += 10) getStroke(points.slice(0, n), { size: 8, last: n === 40 && i % 2 === 0 });
  }
};
getMany(100);
const { byteLength } = (getStroke(long), memory.buffer);
getMany(3000);
getStroke(long);
assert.ok(fitters <= 17, `${fitters} fitters`);
assert.ok(memory.buffer.byteLength <= byteLength + (1 << 20));
const endless = Float64Array.from(Array.from({ length: 66000 }, (_, i) => [i / 5, 40 * Math.sin(i / 100)]).flat());
for (const count of [40000, 65000, 66000]) {
  getStroke(endless.subarray(0, 2 * count));
  getStroke(endless.subarray(0, 2 * count));
  const before = pushed;
  getStroke(endless.subarray(0, 2 * count));
  assert.equal(pushed - before, count <= 65536 ? 0 : count);
  console.log(`${count} points: ${memory.buffer.byteLength} bytes of wasm`);
}
console.log(`growing: passed, ${instances} fresh instances`);
