const out = document.getElementById('out');
try {
  const points = Array.from({ length: 200 }, (_, i) => [i, 50 * Math.sin(i / 20), 0.5]);
  const stroke = feltline.fitStroke(points);
  const ring = feltline.getStroke(points, { last: true });
  const path = new Path2D(feltline.outline(stroke).d);
  const canvas = document.createElement('canvas').getContext('2d');
  if (!canvas.isPointInPath(path, 100, 50 * Math.sin(5))) throw new Error('the outline misses a sample');
  out.textContent = `passed: ${stroke.segments.length} segments, ${ring.length} points`;
} catch (error) {
  out.textContent = `failed: ${error}`;
}
