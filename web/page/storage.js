// The autosave: the drawing of the last visit is in the browser's database, as a base and the events since then. If
// the tab is killed, at most the gesture in progress is lost.

const kDatabase = 'feltline', kStores = ['bases', 'records'];

const done = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

/** Reserves a place for the drawing of this tab. Each tab that is open at the same time has its own. */
async function free_slot() {
  if (!navigator.locks) return 1;
  for (let slot = 1; slot <= 16; ++slot) {
    const got = await new Promise((resolve) => {
      navigator.locks.request(`feltline-drawing-${slot}`, { ifAvailable: true }, (lock) => {
        resolve(Boolean(lock));
        return lock ? new Promise(() => {}) : undefined;  // held as long as the tab lives
      }).catch(() => resolve(true));
    });
    if (got) return slot;
  }
  return 16;
}

export class Storage {
  /** Opens the store. Returns null if the browser does not allow it. */
  static async open() {
    try {
      const request = indexedDB.open(kDatabase, 1);
      request.onupgradeneeded = () => {
        for (const name of kStores) request.result.createObjectStore(name);
      };
      const storage = new Storage();
      [storage.database, storage.slot] = await Promise.all([done(request), free_slot()]);
      storage.next = 0;
      storage.bytes = 0;
      return storage;
    } catch {
      return null;
    }
  }

  /** Returns the drawing of the last visit, { base, page, recorded }, or null. */
  async load() {
    const transaction = this.database.transaction(kStores);
    const [first, keys, records] = await Promise.all([
      done(transaction.objectStore('bases').get(this.slot)),
      done(transaction.objectStore('records').getAllKeys(this.range())),
      done(transaction.objectStore('records').getAll(this.range())),
    ]);
    this.next = keys.length ? keys[keys.length - 1][1] + 1 : 0;
    this.bytes = records.reduce((sum, text) => sum + text.length, 0);
    return first ? { ...first, recorded: records.join('') } : null;
  }

  /** Appends events. */
  append(recorded) {
    if (!recorded) return;
    this.bytes += recorded.length;
    const transaction = this.write();
    transaction.objectStore('records').put(recorded, [this.slot, this.next++]);
  }

  /** Begins a new drawing: all events so far are removed. `base` is null for an empty drawing, whose page is `page`. */
  restart(base, page) {
    this.bytes = 0;
    const transaction = this.write();
    transaction.objectStore('records').delete(this.range());
    transaction.objectStore('bases').put({ base, page }, this.slot);
  }

  range() {
    return IDBKeyRange.bound([this.slot, 0], [this.slot, Number.MAX_SAFE_INTEGER]);
  }

  write() {
    const transaction = this.database.transaction(kStores, 'readwrite', { durability: 'relaxed' });
    transaction.onerror = transaction.onabort = (event) => this.failed?.(event.target.error);
    return transaction;
  }
}
