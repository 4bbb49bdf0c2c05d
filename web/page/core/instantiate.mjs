// Makes an instance of a wasm module of the core.

/** Writes the digits of the shortest decimal that reads back as the number: numbers_text.cc. */
function shortest_digits(memory, number, to, exponent_at) {
  const [mantissa, exponent] = number.toExponential().split('e');
  const digits = mantissa.replace('.', '');
  const bytes = new Uint8Array(memory.buffer, to, digits.length);
  for (let i = 0; i < digits.length; ++i) bytes[i] = digits.charCodeAt(i);
  new DataView(memory.buffer).setInt32(exponent_at, Number(exponent), true);
  return digits.length;
}

/** Returns a function that ends the core. */
const stop_with = (message) => () => {
  throw new WebAssembly.RuntimeError(message);
};

/**
 * Makes an instance of a compiled module, and returns its exports. The first module lacks functions that it never calls
 * (build.sh): they are imports with names of C++. `database`, `pictures`: where the full module finds SQLite and the pixels of
 * pictures.
 */
export async function instantiate(module, { database, pictures } = {}) {
  let memory;
  const stop = stop_with('the module ended');
  const lacking = WebAssembly.Module.imports(module).filter(({ name }) => name.startsWith('_Z'))
    .map(({ name }) => [name, stop_with(`${name} is not in the first module`)]);
  const nothing = () => 0;
  const instance = await WebAssembly.instantiate(module, {
    env: {
      ...Object.fromEntries(lacking),
      shortest_digits: (number, to, exponent_at) => shortest_digits(memory, number, to, exponent_at),
      now_ms: () => performance.now(),
      database_call: (what, handle, at, size) => database?.call(what, handle, new Uint8Array(memory.buffer, at, size)) ?? -1,
      picture_pixels: (high, low, at, size, to, to_size) => pictures?.copy(`${high}-${low}`,
        new Uint8Array(memory.buffer, at, size), new Uint8Array(memory.buffer, to, to_size)),
      database_answer: (to) => database?.copy_answer(memory, to),
      emscripten_notify_memory_growth: nothing,
    },
    wasi_snapshot_preview1: {
      proc_exit: stop, fd_write: nothing, fd_close: nothing, fd_seek: nothing, fd_read: nothing,
      environ_sizes_get: nothing, environ_get: nothing, clock_time_get: nothing,
    },
  });
  memory = instance.exports.memory;
  instance.exports._initialize();
  return instance.exports;
}
