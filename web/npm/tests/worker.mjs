// A worker fits the same stroke; strokes can be posted.
import assert from 'node:assert/strict';
import { Worker, isMainThread, parentPort } from 'node:worker_threads';
import { fitStroke } from 'feltline';

const points = Array.from({ length: 100 }, (_, i) => ({ x: i, y: (i * i) / 100, pressure: 0.5 }));
if (isMainThread) {
  new Worker(new URL(import.meta.url)).once('message', (stroke) => {
    assert.deepEqual(stroke, fitStroke(points));
    console.log('worker: passed');
  });
} else {
  parentPort.postMessage(fitStroke(points));
}
