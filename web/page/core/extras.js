// What is not in the module: the script that the simulated hand plays, and the version.
import { cat, version } from 'generated/extras_text.js';

/** Adds to the catalog what JavaScript has. */
export const catalog_extras = (catalog) => ({ version, ...catalog });

export const scripts = [{ id: 'cat', text: cat }];
