// make_page.mjs TEMPLATE WORK ICON: prints the page, with the styles, icons and the first script inside.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';

const [template, work, icon] = process.argv.slice(2);
const read = (name) => readFileSync(name, 'utf8').trim();
const shrunk = read(icon).replace(/<\?.*?\?>|<!--[\s\S]*?-->/g, '').replace(/\s+/g, ' ').replaceAll('> <', '><').trim();
const parts = { ICON: encodeURIComponent(shrunk), STYLE: read(`${work}/style.css`), ICONS: read(`${work}/icons.svg`),
  EARLY: read(`${work}/early.js`) };
// The policy allows this inline script only.
parts.HASH = `sha256-${createHash('sha256').update(parts.EARLY).digest('base64')}`;
process.stdout.write(read(template).replace(/@([A-Z]+)@/g, (all, name) => parts[name] ?? all) + '\n');
