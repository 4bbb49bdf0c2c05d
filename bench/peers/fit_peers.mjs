// Runs one npm curve fitter over a file of strokes:
//   node fit_peers.mjs PACKAGE TOLERANCE REPEATS MODULES SCRATCH
// reads SCRATCH/inks.ndjson, writes SCRATCH/curves.ndjson (sketch lines) and SCRATCH/cost.json.
// The total is the CPU time of the whole process with its compiler and collector threads. The time
// of one call (a stroke) is wall time, because the resolution of node's CPU clock is too low.
import { createRequire } from 'node:module';
import { readFileSync, writeFileSync } from 'node:fs';

const [, , packageName, toleranceText, repeatsText, modules, scratch] = process.argv;
const tolerance = Number(toleranceText);
const repeats = Number(repeatsText);
const load = createRequire(`${modules}/`);

// Each fitter converts points [[x, y], ...] to segments [[p0, p1, p2, p3], ...], where each p is an
// [x, y] point, or to {segments, joints}. fit-curve and paper compare their tolerance with a squared
// distance.
const fitters = {
  'fit-curve': () => {
    const fitCurve = load('fit-curve');
    return (points) => fitCurve(points, tolerance * tolerance);
  },
  // Our own package, if ./dev npm has built it.
  feltline: () => {
    const { fitStroke } = load('feltline');
    return (points) => fitStroke(points, { tolerance });
  },
  paper: () => {
    const paper = load('paper/dist/paper-core.js');
    paper.setup([1, 1]);
    return (points) => {
      const path = new paper.Path({ segments: points, insert: false });
      path.simplify(tolerance * tolerance);
      return path.curves.map((curve) =>
        curve.getValues().reduce((pairs, value, i) => {
          if (i % 2 === 0) pairs.push([value]);
          else pairs[pairs.length - 1].push(value);
          return pairs;
        }, []));
    };
  },
};

const inks = readFileSync(`${scratch}/inks.ndjson`, 'utf8')
  .split('\n').filter((line) => line !== '').map((line) => JSON.parse(line));
const samples = inks.reduce((sum, ink) => sum + ink.points.length, 0);
const fit = fitters[packageName]();

// The first pass produces the result and warms up the compiler.
const lines = inks.map((ink) => {
  const fitted = fit(ink.points);
  const segments = (fitted.segments ?? fitted).map((segment) => segment.flat());
  const joints = fitted.joints ?? segments.slice(1).map(() => 'smooth');
  return JSON.stringify({ id: ink.id, segments, joints });
});
writeFileSync(`${scratch}/curves.ndjson`, lines.map((line) => `${line}\n`).join(''));

let perSample = Infinity;
const calls = new Array(inks.length).fill(Infinity);
for (let i = 0; i < repeats; ++i) {
  const start = process.cpuUsage();
  for (const ink of inks) fit(ink.points);
  const used = process.cpuUsage(start);
  perSample = Math.min(perSample, ((used.user + used.system) * 1000) / samples);
  inks.forEach((ink, k) => {
    const begin = process.hrtime.bigint();
    fit(ink.points);
    calls[k] = Math.min(calls[k], Number(process.hrtime.bigint() - begin));
  });
}
calls.sort((a, b) => a - b);
writeFileSync(`${scratch}/cost.json`, JSON.stringify({
  ns_per_sample: perSample,
  call_p999_ns: calls[Math.ceil(0.999 * calls.length) - 1] ?? 0,
  call_max_ns: calls[calls.length - 1] ?? 0,
}));
