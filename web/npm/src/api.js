export { FeltlineError } from './module.js';
export { StrokeFitter, fitStroke } from './fitter.js';
export { nearest, outline, part, split } from './strokes.js';
export { getStroke, getStroke as default, getStrokeOutlinePoints, getStrokePoints } from './get_stroke.js';
