/** An error of the library: the data is invalid, or the memory is used up. */
export class FeltlineError extends Error {}

/** Pressure is 0..1, time is in ms, tilt is in degrees from the upright. */
export type PointObject = {x: number; y: number; pressure?: number | null; time?: number | null;
  tilt?: number | null};
/** [x, y, pressure, time, tilt] */
export type PointArray = readonly (number | null | undefined)[];
export type Numbers = Float32Array | Float64Array | Int32Array | Int16Array | Uint32Array |
  Uint16Array | Uint8Array;
/** A list of points, or a typed array with `stride` numbers for each point. */
export type Points = readonly PointArray[] | readonly PointObject[] | Numbers;

export type Easing = (t: number) => number;
export interface TipOptions {
  cap?: boolean;
  taper?: number | boolean;
  easing?: Easing;
}
/** The options of perfect-freehand, and `stride`. */
export interface StrokeOptions {
  size?: number;
  thinning?: number;
  smoothing?: number;
  streamline?: number;
  easing?: Easing;
  simulatePressure?: boolean;
  start?: TipOptions;
  end?: TipOptions;
  last?: boolean;
  stride?: number;
}
/** Returns the outline of a stroke as a polygon, to be filled with the nonzero rule. */
export function getStroke(points: Points, options?: StrokeOptions): [number, number][];
export default getStroke;
/** A point of a stroke as the pen meant it, with the direction from it to the point before it. */
export interface StrokePoint {
  point: [number, number];
  pressure: number;
  distance: number;
  vector: [number, number];
  runningLength: number;
}
/** The first step of getStroke in perfect-freehand: returns the points that `streamline` has smoothed. */
export function getStrokePoints(points: Points, options?: StrokeOptions): StrokePoint[];
/** The second step: returns the outline of such points as a polygon. */
export function getStrokeOutlinePoints(points: readonly StrokePoint[], options?: StrokeOptions):
  [number, number][];

export type Output = 'arrays' | 'float64' | 'float32';
export interface OutputOptions<O extends Output = Output> {
  /** The form of segments and widths. Default: 'arrays'. */
  output?: O;
  /** The number of decimals of `d`. Default: 3. */
  digits?: number;
}
/** The defaults are those of `feltline fit`. Lengths are in mm, or in the unit of the points. */
export interface FitOptions<O extends Output = Output> extends OutputOptions<O> {
  /** Largest distance from a sample to the curve. Default: 0.15. */
  tolerance?: number;
  /** Width without pressure. Default: 0.3. */
  minWidth?: number;
  /** Width at full pressure. Default: 2. */
  maxWidth?: number;
  gamma?: number;
  /** Pressure to use if no point has one. Default: 0.5. */
  absentPressure?: number;
  /** Time constant in ms of the filter of the pressure. Default: 20. */
  timeConstant?: number;
  /** Assumed time in ms between points without times. Default: 7.5. */
  interval?: number;
  tiltWidth?: number;
  /** Largest difference between the widths of the stroke and of a sample. Default: 0.15. */
  widthTolerance?: number;
  /** Drop what the pen adds at touch-down and lift. Default: false. */
  filter?: boolean;
  /** Find fewer segments for the whole stroke. Default: true. StrokeFitter: call refine(). */
  refine?: boolean;
  /** Size of one unit of the points in mm. The result is in mm. Default: 1. */
  mmPerUnit?: number;
  /** The numbers for each point of a typed array, 2 to 5. Default: 2. */
  stride?: number;
}

export interface Stroke {
  closed: boolean;
  /** [x1, y1, x2, y2, x3, y3, x4, y4] for each cubic segment. */
  segments: number[][];
  joints: ('smooth' | 'corner')[];
  /** [u, width], where u is the index of a segment plus the parameter in it. */
  widths: number[][];
  /** The centre line as an SVG path. */
  d: string;
  /** What was wrong with the pressures and times of the points. Absent if nothing was. */
  notices?: string[];
}
/** A stroke with 8 numbers for each segment, 0 (smooth) or 1 (corner) for each joint, and pairs. */
export interface TypedStroke<N = Float64Array> {
  closed: boolean;
  segments: N;
  joints: Uint8Array;
  widths: N;
  d: string;
  notices?: string[];
}
export type StrokeOf<O extends Output> = O extends 'float64' ? TypedStroke<Float64Array>
  : O extends 'float32' ? TypedStroke<Float32Array> : Stroke;
export type AnyStroke = Omit<Stroke, 'd'> | Omit<TypedStroke<Float32Array | Float64Array>, 'd'>;
export type SegmentsOf<O extends Output> = StrokeOf<O>['segments'];

/** Fits a stroke. Points that are not finite are ignored. Throws if no point is left. */
export function fitStroke<O extends Output = 'arrays'>(points: Points, options?: FitOptions<O>):
  StrokeOf<O>;

/** Fits a stroke while it is drawn. */
export class StrokeFitter<O extends Output = 'arrays'> {
  constructor(options?: FitOptions<O>);
  /** Starts the next stroke. */
  begin(): void;
  push(x: number, y: number, pressure?: number | null, time?: number | null, tilt?: number | null): void;
  push(points: PointArray | PointObject | Points): void;
  /**
   * Returns the segments that never change, from `first` on. `joints` has the kind of the joint
   * before each of them, except before the first segment of the stroke.
   */
  frozen(first?: number): {segments: SegmentsOf<O>; joints: StrokeOf<O>['joints']};
  /** Returns provisional segments from the frozen ones to the newest point. */
  tail(): SegmentsOf<O>;
  /** Completes the stroke and returns it. */
  end(): StrokeOf<O>;
  /** Returns the stroke with fewer segments, if there is such a curve. Call after end(). */
  refine(): StrokeOf<O>;
  /** The number of points that were not finite. */
  readonly ignored: number;
  /** Frees the memory now instead of when the object is garbage. */
  free(): void;
}

/** Returns the point of the centre line that is nearest to `point`, and the width there. */
export function nearest(stroke: AnyStroke, point: readonly [number, number] | {x: number; y: number}):
  {u: number; point: [number, number]; distance: number; width: number};
/** Returns the edge of the ink: as polygons, and as an SVG path of curves. Default tolerance: 0.05. */
export function outline(stroke: AnyStroke, options?: {tolerance?: number; digits?: number}):
  {polygons: [number, number][][]; d: string};
/** Returns the parts before and after the parameter u. */
export function split<O extends Output = 'arrays'>(stroke: AnyStroke, u: number,
  options?: OutputOptions<O>): [StrokeOf<O>, StrokeOf<O>];
/** Returns the part from one parameter to another. */
export function part<O extends Output = 'arrays'>(stroke: AnyStroke, from: number, to: number,
  options?: OutputOptions<O>): StrokeOf<O>;

/** Loads the module. Needed for 'feltline/slim' only. */
export function init(source?: string | URL | Response | BufferSource | WebAssembly.Module |
  Promise<Response>): Promise<void>;
