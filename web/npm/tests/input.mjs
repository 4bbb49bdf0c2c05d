// Bad input gives an error with a reason, or a documented result.
import assert from 'node:assert/strict';
import { FeltlineError, StrokeFitter, fitStroke, getStroke, nearest, outline, split } from 'feltline';

const line = [[0, 0], [10, 0]];
const throws = (work, kind, text) => assert.throws(work, (e) => {
  assert.ok(e instanceof kind, `${e}`);
  assert.match(e.message, text);
  return true;
});

throws(() => fitStroke([]), FeltlineError, /no samples/);
throws(() => fitStroke([[NaN, 0], [0, Infinity]]), FeltlineError, /usable/);
throws(() => fitStroke('text'), TypeError, /points must be an array/);
throws(() => fitStroke(null), TypeError, /not null/);
throws(() => fitStroke([1, 2, 3]), TypeError, /points\[0\]/);
throws(() => fitStroke([['1', 2]]), TypeError, /points\[0\]: x must be a number, not string/);
throws(() => fitStroke([[0, 0], null]), TypeError, /points\[1\]/);
throws(() => fitStroke(new Float32Array(3)), RangeError, /stride/);
throws(() => fitStroke(line, { tolerence: 1 }), TypeError, /unknown option 'tolerence'/);
throws(() => fitStroke(line, { tolerance: '1' }), TypeError, /tolerance must be a number/);
throws(() => fitStroke(line, { tolerance: -1 }), RangeError, /tolerance/);
throws(() => fitStroke(line, { minWidth: 3, maxWidth: 2 }), RangeError, /less than/);
throws(() => fitStroke(line, { output: 'x' }), RangeError, /output/);
throws(() => fitStroke(line, null), TypeError, /options/);

// NaN, doubled points, one and two points.
assert.deepEqual(fitStroke([[0, 0], [NaN, 5], [10, 0]]), fitStroke(line));
assert.equal(fitStroke([[3, 4]]).segments.length, 1);
assert.equal(fitStroke([[3, 4], [3, 4], [3, 4]]).segments.length, 1);
assert.deepEqual(fitStroke(line).segments[0].slice(6), [10, 0]);
assert.deepEqual(getStroke([]), []);
assert.deepEqual(getStroke([[NaN, 0]]), []);
assert.ok(getStroke([[3, 4]]).length > 8);
assert.ok(getStroke([[3, 4], [3, 4]]).flat().every(Number.isFinite));
throws(() => getStroke('x'), TypeError, /points/);
throws(() => getStroke(line, { size: 'big' }), TypeError, /size/);
throws(() => getStroke(line, { size: 0 }), RangeError, /size/);

// Points beyond 1e9 are ignored, also if the stroke is fitted at a larger scale.
assert.deepEqual(getStroke([[1e12, 0]]), []);
assert.deepEqual(getStroke([[5e8, 0]], { size: 1 }), []);
assert.deepEqual(getStroke([[0, 0], [1e12, 0], [10, 0]]), getStroke(line));

// Raw pressures and invalid times are named; the widths still follow the pressure.
const wave = (pressure, time) => Array.from({ length: 40 }, (_, i) =>
  [2 * i, 8 * Math.sin(0.3 * i), pressure * (0.5 + 0.4 * Math.sin(0.15 * i)), time(8 * i)]);
const widest = (stroke) => Math.max(...stroke.widths.map(([, width]) => width));
const good = fitStroke(wave(1, (t) => t));
assert.equal(good.notices, undefined);
assert.deepEqual(fitStroke(wave(1023, (t) => t)).notices, ['pressures outside 0 to 1 count as 0 or 1']);
for (const time of [() => 0, (t) => -t, (t) => t / 1000]) {
  const stroke = fitStroke(wave(1, time), { refine: false }), fitter = new StrokeFitter();
  fitter.push(wave(1, time));
  assert.deepEqual(fitter.end(), stroke);
  assert.deepEqual(stroke.notices, ['the times are not milliseconds and were ignored']);
  assert.ok(Math.abs(widest(stroke) / widest(good) - 1) < 0.1);
}

// Extreme numbers.
for (const scale of [1e-300, 1e-9, 1e6, 1e8, 1e300]) {
  for (const work of [getStroke, fitStroke]) {
    try {
      work([[0, 0], [scale, scale], [2 * scale, 0]]);
    } catch (error) {
      assert.ok(error instanceof FeltlineError, `${error}`);
    }
  }
}

// Strokes from elsewhere.
const stroke = fitStroke([[0, 0], [10, 5], [20, 0]]);
throws(() => nearest({}, [0, 0]), TypeError, /segments/);
throws(() => nearest(stroke, [NaN, 0]), RangeError, /finite/);
throws(() => outline({ ...stroke, widths: [] }), FeltlineError, /I6/);
throws(() => outline({ ...stroke, joints: ['smooth', 'smooth', 'smooth', 'smooth', 'smooth'] }), TypeError, /joints/);
throws(() => outline(stroke, { tolerance: 0 }), RangeError, /tolerance/);
throws(() => split(stroke, 0), FeltlineError, /empty/);

const fitter = new StrokeFitter();
throws(() => fitter.end(), FeltlineError, /no samples/);
throws(() => fitter.push(1, 2), FeltlineError, /begin/);
fitter.begin();
fitter.push(NaN, 1);
assert.equal(fitter.ignored, 1);
fitter.free();
throws(() => fitter.push(1, 2), FeltlineError, /freed/);

const many = new Float32Array(2e6);
for (let i = 0; i < 1e6; ++i) {
  many[2 * i] = i / 100;
  many[2 * i + 1] = 30 * Math.sin(i / 3000);
}
assert.ok(fitStroke(many, { refine: false }).segments.length > 10);
console.log('input: passed');
