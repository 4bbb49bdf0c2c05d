// make_words.mjs TRANSLATIONS_FOLDER OUT [CONTEXT...]: writes the German and Dutch texts of the desktop program as a module:
// { context: { english: [german, dutch] } }. Without contexts: what the page itself says, that is, the names of materials, edits
// and forces, and those other texts that are in the sources of the page or of the tools.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [folder, out, ...contexts_wanted] = process.argv.slice(2);
const wanted = contexts_wanted.length > 0 ? contexts_wanted : ['tools', 'edits', 'Material', 'OfferPopup', 'LayerActions', 'EditActions', 'felt::desktop::LayersPanel',
  'felt::desktop::TopBar', 'felt::desktop::FileActions', 'felt::desktop::ClipboardActions', 'felt::desktop::ForcePanel', 'felt::desktop::OptionsPanel',
  'ViewActions', 'ToolActions', 'felt::desktop::ToolKeys', 'felt::desktop::FeelPanel',
  'SafetyWords', 'ErrorWords'];
const whole = ['edits', 'Material', 'OfferPopup', 'SafetyWords', ...contexts_wanted.map((name) => name.split('::').pop())];  // used by texts of the core
const kShort = 16;
const here = dirname(fileURLToPath(import.meta.url));

/** Returns the C++ sources of a folder and its folders, one after the other. */
function sources(path) {
  return readdirSync(path, { withFileTypes: true }).map((entry) => {
    if (entry.isDirectory()) return sources(join(path, entry.name));
    return /\.(cc|h)$/.test(entry.name) ? readFileSync(join(path, entry.name), 'utf8') : '';
  }).join('\n');
}

const of_page = readdirSync(here).filter((name) => name.endsWith('.js')).map((name) => readFileSync(join(here, name), 'utf8')).join('\n');
const of_tools = sources(join(here, '../../src/felt/tools')).replace(/"\s*"/g, '');
const is_used = (context, text) => whole.includes(context) ||
  (context === 'tools' ? of_tools.includes(text) : of_page.includes(`'${text}'`));

const entities = { amp: '&', lt: '<', gt: '>', quot: '"', apos: "'" };
const plain = (text) => text.replace(/&(\w+);/g, (all, name) => entities[name] ?? all);
// A single & marks the access key of a menu entry.
const without_key = (text) => text.replace(/&(.)/g, '$1');

function read(language) {
  const text = readFileSync(`${folder}/feltline_${language}.ts`, 'utf8');
  const contexts = {};
  for (const [, context] of text.matchAll(/<context>([\s\S]*?)<\/context>/g)) {
    const name = plain(/<name>(.*?)<\/name>/.exec(context)[1]);
    if (!wanted.includes(name)) continue;
    const words = (contexts[name.split('::').pop()] ??= {});
    for (const [, source, , done] of context.matchAll(
      /<source>([\s\S]*?)<\/source>([\s\S]*?)<translation>([\s\S]*?)<\/translation>/g)) {
      if (name === 'SafetyWords' && source.length > kShort) continue;  // the names of the forces only
      const text = without_key(plain(source));
      if (is_used(name.split('::').pop(), text)) words[text] = without_key(plain(done));
    }
  }
  return contexts;
}

const german = read('de'), dutch = read('nl'), both = {};
for (const [context, words] of Object.entries(german)) {
  both[context] = {};
  for (const [source, word] of Object.entries(words)) both[context][source] = [word, dutch[context]?.[source] ?? ''];
}
for (const [, context, text] of contexts_wanted.length > 0 ? [] : of_page.matchAll(/\bd\('(\w+)', '([^']+)'/g)) {
  if (!both[context]?.[text]) throw new Error(`${context} has no '${text}'`);
}
writeFileSync(out, `export default ${JSON.stringify(both)};\n`);
