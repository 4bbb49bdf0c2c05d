// The package as a CommonJS module.
const assert = require('node:assert/strict');
const feltline = require('feltline');
const slim = require('feltline/slim');

const points = [[0, 0], [10, 5], [20, 0]];
assert.equal(feltline.default, feltline.getStroke);
const stroke = feltline.fitStroke(points);
assert.ok(stroke.segments.length >= 1);
slim.init().then(() => {
  assert.deepEqual(slim.fitStroke(points), stroke);
  console.log('CommonJS: passed');
});
