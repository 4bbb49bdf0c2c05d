// The wasm module: its instance, its memory, and what happens if a call fails.

/** An error of the library: the data is invalid, or the memory is used up. */
export class FeltlineError extends Error {
  constructor(message) {
    super(message);
    this.name = 'FeltlineError';
  }
}

// If the memory is larger than this and no StrokeFitter needs it, it is given back after a call.
const KEPT_BYTES = 32 << 20;

let getModule = () => {
  throw new FeltlineError('call and await init() first');
};
let module = null;
let current = null;

/** Sets the function that returns the WebAssembly.Module when it is needed for the first time. */
export function setModuleSource(source) {
  getModule = source;
}

/** Sets the compiled module itself. */
export function setModule(compiled) {
  module = compiled;
}

function instantiate() {
  module ??= getModule();
  // For `loans` and `maxLoans`, see fitter.js; `fit` is wholeFitter(); for `growing`, see growing.js.
  const core = { alive: true, loans: [], maxLoans: 16, fit: null, growing: [] };
  const instance = new WebAssembly.Instance(module, {
    env: {
      // Prints a number for an error message: small_library.cc.
      print_number(at, size, number) {
        const text = String(Number(number.toPrecision(9))).slice(0, size - 1);
        const bytes = new Uint8Array(core.exports.memory.buffer, at, size);
        for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
        bytes[text.length] = 0;
        return text.length;
      },
      emscripten_notify_memory_growth() {},
    },
    wasi_snapshot_preview1: {
      proc_exit() {
        throw new WebAssembly.RuntimeError('exit');
      },
    },
  });
  core.exports = instance.exports;
  instance.exports._initialize();
  return core;
}

/** Returns the instance for new work. */
export function currentCore() {
  current ??= instantiate();
  return current;
}

/**
 * Runs work(exports) on an instance. If wasm stops, which it does if it gets no more memory, the
 * instance is discarded, so that the next call finds a fresh one.
 */
export function run(core, work) {
  try {
    return work(core.exports);
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError)) throw error;
    core.alive = false;
    if (current === core) current = null;
    throw new FeltlineError(`out of memory (${error.message})`);
  }
}

/** Returns true if a StrokeFitter that is still in use has this loan (fitter.js). */
export const isInUse = (loan) => Boolean(loan.owner?.deref());

/** Gives back a large memory after a call, unless a StrokeFitter still uses it. */
export function trim(core) {
  if (!core.loans.some(isInUse) && core === current && core.exports.memory.buffer.byteLength > KEPT_BYTES) {
    current = null;
  }
}

/** Returns the size of the wasm memory in bytes, for tests. */
export function memoryBytes() {
  return current ? current.exports.memory.buffer.byteLength : 0;
}

/** Returns a view of `count` numbers of the input. Valid until the next call. */
export function inputView(core, count) {
  const at = core.exports.input(count);
  return new Float64Array(core.exports.memory.buffer, at, count);
}

/** Returns a view of the output. Valid until the next call. */
export function outputView(core) {
  return new Float64Array(core.exports.memory.buffer, core.exports.output(), core.exports.output_size());
}

/** Throws the reason of a failure unless a call has returned 1. */
export function check(core, result) {
  if (result) return;
  const bytes = new Uint8Array(core.exports.memory.buffer);
  const from = core.exports.error();
  throw new FeltlineError(String.fromCharCode(...bytes.subarray(from, bytes.indexOf(0, from))));
}
