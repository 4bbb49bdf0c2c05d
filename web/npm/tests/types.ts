// Checked by tsc: the types of the package.
import getStroke, {
  StrokeFitter, fitStroke, getStrokeOutlinePoints, getStrokePoints, nearest, outline, split,
} from 'feltline';
import * as slim from 'feltline/slim';

const polygon: [number, number][] = getStroke([[0, 0, 0.5], [1, 2, 0.5]], { size: 8, end: { taper: true } });
const steps: [number, number][] = getStrokeOutlinePoints(getStrokePoints([[0, 0], [1, 2]]), { size: 8 });
const stroke = fitStroke([{ x: 0, y: 0, pressure: 0.5 }], { tolerance: 0.2 });
const joints: ('smooth' | 'corner')[] = stroke.joints;
const typed = fitStroke(new Float32Array(4), { output: 'float32' });
const numbers: Float32Array = typed.segments;
const notices: string[] | undefined = typed.notices;
const u: number = nearest(typed, [1, 2]).u;
const d: string = outline(stroke, { tolerance: 0.1 }).d;
const [before] = split(stroke, 0.5);
const fitter = new StrokeFitter({ output: 'float64' });
fitter.push(1, 2, 0.5);
const tail: Float64Array = fitter.tail();
const ready: Promise<void> = slim.init('feltline.wasm');
// @ts-expect-error: the option is misspelt
fitStroke([], { tolerence: 1 });
export { before, d, joints, notices, numbers, polygon, ready, steps, tail, u };
