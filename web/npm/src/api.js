export { FeltlineError } from './module.js';
export { StrokeFitter, fitStroke } from './fitter.js';
export { nearest, outline, part, split } from './strokes.js';
export { getStroke, getStroke as default } from './get_stroke.js';
