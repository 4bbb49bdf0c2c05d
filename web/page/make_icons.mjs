// make_icons.mjs OUT SVG...: joins icons of the desktop program into one list of symbols. Their two colours
// become the colour of the text and the accent of the page.
import { readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';

const [out, ...files] = process.argv.slice(2);
const symbols = files.map((file) => {
  const svg = readFileSync(file, 'utf8');
  const [, attributes, content] = /<svg([^>]*)>([\s\S]*)<\/svg>/.exec(svg);
  const kept = [...attributes.matchAll(/\b(viewBox|fill|stroke[a-z-]*)="([^"]*)"/g)].map(([all]) => all).join(' ');
  return `<symbol id="i-${basename(file, '.svg')}" ${kept}>${content.replace(/\n/g, '')}</symbol>`
    .replaceAll('#303438', 'currentColor').replaceAll('#c8501e', 'var(--spot)');
});
writeFileSync(out, symbols.join(''));
