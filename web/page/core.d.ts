/**
 * The core of the page: Feltline's drawing session, simulated pen and hand, forces, sound and rasteriser, compiled
 * to WebAssembly. Everything that the user sees is made of one `Core`; it uses no DOM, no clock, no network, and no
 * thread, so it also works in Node.
 *
 * Units: positions on the canvas are CSS pixels from its top left corner, positions on the page are mm; times are
 * milliseconds on one clock of the caller (`performance.now()`, `event.timeStamp`), forces are N on the pen, in
 * directions of the canvas (x right, y down) and out of the surface (z).
 *
 * A frame of the page:
 *
 *     onpointermove = e => core.samples(packed(e.getCoalescedEvents()));   // every sample counts
 *     onframe = now => {
 *       core.advance(now);                       // the simulated time passes
 *       core.paint(context);                     // repaints only what changed
 *       if (core.changed('marks')) drawMarks(core.marks(), core.pen());
 *       if (core.changed('state')) showState(core.state());
 *     };
 *
 * If a call throws a `CoreError`, a check in the core failed (a defect): make a new core and `restore()` it.
 */
export function createCore(options?: CoreOptions): Promise<Core>;

export interface CoreOptions {
  /** Size of the canvas in CSS pixels, and device pixels per CSS pixel. */
  width?: number;
  height?: number;
  dpr?: number;
  /** Size of the page in mm; A4, landscape, if absent. */
  page?: { width: number; height: number };
  /** Time of the start on the clock of the caller; 0 if absent. */
  now?: number;
  /** Loads a script that is beside the page; for programs without a document. */
  loadScript?: (name: string) => Promise<void>;
  /** Called when a picture of the drawing was decoded: `paint()` has work. */
  onPicture?: () => void;
  /** Returns the pixels of a PNG file, RGBA with straight alpha; for programs without a document. */
  decodePicture?: (png: Uint8Array) => Promise<Uint8ClampedArray>;
}

export class CoreError extends Error {}

/** What a call returns that can be refused. `error` is a sentence for the user, in English; `code` is its ErrorCode
 * (src/felt/base/result.h), if the library refused. */
export interface Done {
  ok: boolean;
  error?: string;
  code?: number;
  /** The script that could not be loaded. */
  missing?: string;
  /** Content of a file that was left out or changed, one sentence each. */
  notices?: string[];
}

/**
 * `ink`: pixels differ, `paint()` has work. `marks`: what `marks()` or `pen()` return. `state`: what `state()`
 * returns. `edits`: the document differs (for the autosave and "unsaved changes"). `refusal`: samples had no effect.
 */
export type Change = 'ink' | 'marks' | 'state' | 'edits' | 'refusal';

export interface Core {
  // --- Input

  /** Numbers of one sample in the array for `samples()`. */
  readonly sampleSize: 8;
  /**
   * Handles pointer samples in order of time, hover samples, too: for each sample `time, x, y, touching (0 or 1),
   * pressure, tiltX, tiltY, modifiers`. `pressure` is 0..1; NaN if the pointer has no sensor (mouse, finger).
   * `tiltX` and `tiltY` are degrees as in PointerEvent; NaN if unknown. `modifiers`: the sum of 1 for Shift,
   * 2 for Ctrl and 4 for Alt; `state().use` says what they do. A sample that is earlier than the time that has passed counts as now.
   */
  samples(samples: Float64Array): void;
  /**
   * Handles one event of docs/formats/events.md, without `t_ms`: `{event: 'tool', id: 'pull'}`,
   * `{event: 'option', id: 'pencil.snap', value: 'both'}`, `{event: 'undo'}`,
   * `{event: 'layer', do: 'add', name: 'Ideas'}`, ... It may also be its JSON text.
   */
  event(event: object | string): Done;
  /** Sets the medium of new lines with its widths, its pressure curve and, unless the user chose another one, its
   * colour. */
  setMedium(id: string): Done;
  /** Sets the size of the tool in use, in mm (`state().size`). */
  setSize(mm: number): Done;
  /** Lets the simulated time pass until `now`: at most 100 ms a call, what exceeds that is skipped. */
  advance(now: number): void;
  /** Ends the gesture as if the pen had been lifted (page hidden, pointer lost). */
  finish(): void;

  // --- What changed

  /** Returns true if this changed since the last call with the same word. The first call returns true,
   * except for a refusal. */
  changed(what: Change): boolean;
  /** Returns why samples, or the end of a gesture, had no effect, once. */
  refusal(): Done;
  /** Returns how many events since the last call should be felt as a tick, for playHaptics and gamepads. */
  ticks(): number;

  // --- The picture

  resize(width: number, height: number, dpr: number): void;
  view(): View;
  setView(view: Partial<View>): void;
  /** Shows the whole page with this margin in CSS pixels. */
  fitPage(margin?: number): void;
  /** Scales the view by `factor`; the point (x, y) of the canvas stays. */
  zoomAt(x: number, y: number, factor: number): void;
  toPage(x: number, y: number): [number, number];
  toCanvas(x_mm: number, y_mm: number): [number, number];
  /** Colour around the page, `#rrggbb`. */
  setDesk(color: string): void;
  /** Sets the paper's colour, `#rrggbb`; '' for the usual colour of the surface. It is saved with the drawing. */
  setPaper(color: string): void;
  /** Size of the page in mm. */
  setPage(page: { width: number; height: number }): void;
  /** Computes the relief of the surface (some 50 ms), which the grain of dry media, forces and sound need. Until this
   * call there are none of them, so that the user can draw immediately. Call it when the page is idle, after the first frame;
   * play() and sound() do it, too. */
  warmUp(): void;
  /** True: media have their grain. False: solid ink, which is faster. */
  setGrain(on: boolean): void;
  /**
   * Repaints what changed: desk, paper, ink, wet ink and previews; everything except `marks()`. Puts the pixels into
   * `context`, which belongs to a canvas of `width * dpr` by `height * dpr` pixels; without a context, only updates
   * `pixels()`. Works for at most `budget` ms (8), then leaves the rest for the next call; wet ink is always
   * painted. Returns true if there is more to paint.
   */
  paint(context?: CanvasRenderingContext2D | null, budget?: number): boolean;
  /** The last picture, RGBA; valid until the next call of any function. */
  pixels(): { data: Uint8ClampedArray; width: number; height: number };
  /** The rectangle that the last `paint()` updated, in device pixels: x, y, width, height. */
  painted(): [number, number, number, number];
  /** Draws the page without marks for an exported picture. `grain` and paper are as on the canvas. */
  picture(dpi: number, options?: { transparent?: boolean }): {
    data: Uint8ClampedArray;
    width: number;
    height: number;
  } | null;
  /** What to draw over the ink, in CSS pixels, lowest first. */
  marks(): Mark[];
  pen(): Pen;

  // --- Forces and sound

  /** The pens to choose from: 'tablet' (the ink follows the pointer exactly; forces are shown) and simulated pens,
   * which a simulated hand holds and forces move. */
  devices(): { id: string; label: string; hasForce: boolean }[];
  setDevice(id: string): Done;
  /** Switches forces off and on; sets the share of the forces, 0..1. */
  setForces(on: boolean): void;
  setStrength(share: number): void;
  /** The numbers of each tick since the last call, at most the last 2,000: time, then x, y, z of the force that the
   * tool asked for, then x, y, z of the force that was sent. 7 numbers a tick. */
  forces(): Float64Array;
  /** The names of the terms of the force of the newest tick, with x, y, z each, for a legend. */
  forceTerms(): { name: string; x: number; y: number; z: number }[];
  /** The next `frames` samples of the rubbing sound, mono, 48 kHz, for an AudioWorklet or a script node. Valid until
   * the next call. Returns an empty array if all is still. */
  sound(frames: number): Float32Array;

  // --- State

  /** Everything that does not change: tools with their options, surfaces and media, formats. */
  catalog(): Catalog;
  state(): State;
  /** The value of every option that matters now: `state().options` is the same for the tool in use. */
  option(id: string): number | boolean | string | null;

  // --- The simulated hand

  /**
   * Lets the simulated hand play an event script or raw pen strokes (`samples`: the cat and the acts of the tools).
   * The play advances with `advance()`; pointer samples are ignored meanwhile, except that a touch ends the play.
   * The drawing continues with what the hand drew.
   */
  play(script: string, options?: { speed?: number; mmPerUnit?: number }): Done;
  /** Null if nothing plays. */
  playing(): { fraction: number } | null;
  /** Why the last play ended early; '' if it did not. Says it once. */
  playError(): string;
  stopPlay(): void;
  /** The built-in scripts for `play()`: `cat`, raw strokes of a cat. None before the core is complete. */
  scripts(): { id: string; text: string }[];

  // --- Files

  /**
   * True if the core has everything below. A new core has only a first module, which draws with the pencil: samples, undo,
   * redo, cancel, view, picture without grain, state, and the autosave except restore(). It has no forces and no sound.
   */
  readonly isComplete: boolean;
  /**
   * Loads the full module (`core_full.js` beside the page, once) and continues the drawing with it, undo included. Takes
   * over when `isFree` resolves, which is called when the module is ready, because this ends a gesture. Fails if the script
   * cannot be loaded. If `isFree` resolves to a stored drawing, the module continues with it instead of that of the first
   * module, and `continued` says whether it could (restore()).
   */
  complete(isFree?: () => Promise<{ base: Uint8Array | null; recorded: string; page: View } | null | void>): Promise<Done>;
  /**
   * Replaces the drawing by that of a file: .felt, .svg, .ndjson, .inkml, .xopp (`catalog().formats`); the content decides, and
   * `name` if it does not. Compressed files (.svgz, .xopp) must be unpacked before. Undo history and selection become empty. Fails without a change.
   * If isFelt(bytes), prepareFelt() must be called before.
   */
  open(bytes: Uint8Array | string, name: string): Done;
  /**
   * Adds the strokes of a file to the drawing, selected, as one undo step (drag and drop, paste): moved by `by`, or with their
   * middle at `middle`, both in mm.
   */
  add(bytes: Uint8Array | string, name: string, place?: { by?: [number, number]; middle?: [number, number] }): Done;
  /**
   * Returns what a copy command puts on the clipboard, as an SVG file and as a picture without ground (null if it would be too
   * large): the selected strokes and the fills between them, or everything visible if nothing is selected. `whole`: only strokes
   * that are selected as a whole, which are those that `delete` removes. Returns null if there are none.
   */
  copied(options?: { whole?: boolean; dpi?: number }): { svg: string; picture: ReturnType<Core['picture']> } | null;
  /**
   * The drawing as a file; `format` is an id of `catalog().formats` with `saves`. Null if it cannot be saved; then `saveError`
   * says why. Before `felt`, prepareFelt() must be called.
   */
  save(format: string): Uint8Array | null;
  readonly saveError: string;
  /** What the drawing has and the file of the last save() lacks, one sentence each. */
  readonly saveNotices: string[];
  /** True for the bytes of an SQLite database, such as a .felt file. */
  isFelt(bytes: Uint8Array | string): boolean;
  /** Loads the script with SQLite (`core_felt.js` beside the page, once), so that prepareFelt() needs no network. */
  loadFelt(): Promise<Done>;
  /** Starts the module with SQLite. Without it, .felt files are neither read nor written. With it, the base of the autosave is
   * a .felt file, which loses nothing. */
  prepareFelt(): Promise<Done>;
  /** An empty drawing. */
  clear(page?: { width: number; height: number }): void;

  // --- Autosave

  /**
   * The autosave is a base, the drawing with which the records begin, and the records, which are lines of an event
   * script. To store what is new:
   *
   *     if (core.rebased()) store.restart(core.base());   // the base replaces all that was stored
   *     store.append(core.recorded());                     // always, also right after a restart
   *
   * `rebased()` is true once after a core was made, after open(), add(), clear(), replay() and rebase(), and if the user
   * undoes a step that is older than the base, and if the page changes. With both, `restore()` gives the same drawing again, byte for byte.
   * The records after a base begin with the options of the session, so they must not be dropped.
   */
  rebased(): boolean;
  base(): Uint8Array;
  recorded(): string;
  /** The drawing as it was at the last `rebased()` or `recorded()`, for `restore()` of another core. Works even after a
   * CoreError. */
  copy(): { base: Uint8Array; recorded: string };
  /** The next `rebased()` makes the present drawing the new base (as soon as no gesture is in progress; undo stays until
   * a reload). Call it when the records exceed some MB. */
  rebase(): void;
  /** Continues with a stored drawing; what was stored stays valid, so that `rebased()` is false. If the records are
   * damaged, restores what comes before the damage, and returns the error. */
  restore(base: Uint8Array | null, recorded: string): Done;
  /** Plays a script or a recording exactly as `feltline replay` does, without time passing, and makes the result the
   * drawing. For tests. `asRecorded` for recordings. */
  replay(script: string, options?: { asRecorded?: boolean; forces?: boolean; device?: string }): Done;

  /** Frees the memory of the core. */
  free(): void;
}

export interface View {
  /** The point of the page at the top left corner of the canvas, in mm. */
  x: number;
  y: number;
  /** CSS pixels per mm. */
  scale: number;
  /** Clockwise angle of the page in degrees. */
  angle: number;
  mirrored: boolean;
}

export type Role =
  | 'reach' | 'snap' | 'tether' | 'guide' | 'span' | 'vector' | 'selected' | 'handle' | 'cut' | 'rule' | 'tick' | 'axis';

/** A mark over the ink. `points` are x, y pairs. `color` is for light paper; `width` is in CSS pixels. */
export interface Mark {
  /** `arrow` is from the first point to the second; `band` is a pale line, 2 `radius` wide, to draw below the ink or
   * translucent over it;
   * `ring` has its middle in points and a `radius`. */
  kind: 'line' | 'arrow' | 'ring' | 'dot' | 'label' | 'band';
  role: Role;
  points: number[];
  closed?: boolean;
  radius?: number;
  width: number;
  color: string;
  dashed: boolean;
  text?: string;
}

export interface Pen {
  /** False before the first sample. */
  known: boolean;
  touching: boolean;
  x: number;
  y: number;
  /** Where the pointer is; differs from x, y if forces hold a simulated pen back. */
  handX: number;
  handY: number;
  /** Radius of the dot that the pen would draw, in CSS pixels. */
  radius: number;
  /** The force to show as an arrow at (x, y), in N; z out of the surface. */
  force: { x: number; y: number; z: number };
  pressure: number;
}

export interface Option {
  /** For `event({event: 'option', id, value})`: 'pencil.snap'. */
  id: string;
  label: string;
  unit: string;
  kind: 'number' | 'switch' | 'choice';
  min: number;
  max: number;
  fallback: number | boolean | string;
  choices: string[];
  /** 'surfaces' or 'media': the choices are ids of these materials. */
  open: '' | 'surfaces' | 'media';
  help: string;
  /** The option matters only if the option `when.id` has one of these values; null: always. */
  when: { id: string; values: string[] } | null;
  isSeldom: boolean;
}

export interface ToolEntry {
  id: string;
  label: string;
  help: string;
  /** A letter for the keyboard, or ''. */
  shortcut: string;
  kind: 'draws' | 'shapes' | 'edits' | 'erases' | 'selects' | 'fills' | 'transforms' | 'reads' | 'guides';
  options: Option[];
}

export interface Catalog {
  version: string;
  tools: ToolEntry[];
  surfaces: { id: string; label: string; color: string }[];
  media: { id: string; label: string; color: string }[];
  formats: { id: string; extension: string; label: string; opens: boolean; saves: boolean }[];
}

export interface State {
  tool: string;
  /** The tool's hint and what its modifiers do now. */
  use: { hint: string; shift: string; ctrl: string; alt: string };
  /** Size of the tool, for [ and ]; null if it has none. */
  size: { mm: number; min: number; max: number; options: Record<string, number> } | null;
  /** Values of the options of the tool in use, by id. */
  options: Record<string, number | boolean | string>;
  surface: string;
  medium: string;
  ink: string;
  paper: string;
  page: { width: number; height: number };
  /** Highest first. */
  layers: {
    id: number;
    name: string;
    visible: boolean;
    locked: boolean;
    opacity: number;
    blend: string;
    /** The id of its group; 0 if it is in none. */
    group: number;
    /** Strokes and fills. */
    strokes: number;
    /** It has a picture below the strokes. */
    picture: boolean;
    current: boolean;
  }[];
  /** The groups of layers, highest first. */
  groups: { id: number; name: string; visible: boolean; locked: boolean; opacity: number; blend: string }[];
  /** The number of layers that were added because ink needed one. */
  inkLayers: number;
  undo: string | null;
  redo: string | null;
  strokes: number;
  selected: number;
  /** Meanings that the last stroke offers: choose one with `event({event: 'choose', what: id})`. */
  offers: { id: string; count: number; applies: boolean }[];
  canShowAsDrawn: boolean;
  exact: boolean;
  device: string;
  forces: boolean;
  strength: number;
  gesture: boolean;
}
