// make_words.mjs TRANSLATIONS_FOLDER OUT: writes the German and Dutch names of tools, options, materials and
// edits of the desktop program as a module: { context: { english: [german, dutch] } }.
import { readFileSync, writeFileSync } from 'node:fs';

const wanted = ['tools', 'edits', 'Material', 'OfferPopup', 'LayerActions', 'EditActions', 'felt::desktop::LayersPanel',
  'felt::desktop::TopBar', 'felt::desktop::FileActions', 'felt::desktop::ClipboardActions', 'felt::desktop::ForcePanel', 'felt::desktop::OptionsPanel',
  'ViewActions', 'ToolActions', 'felt::desktop::ToolKeys', 'felt::desktop::FeelPanel',
  'SafetyWords'];
const kShort = 16;
const [folder, out] = process.argv.slice(2);

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
      words[without_key(plain(source))] = without_key(plain(done));
    }
  }
  return contexts;
}

const german = read('de'), dutch = read('nl'), both = {};
for (const [context, words] of Object.entries(german)) {
  both[context] = {};
  for (const [source, word] of Object.entries(words)) both[context][source] = [word, dutch[context]?.[source] ?? ''];
}
writeFileSync(out, `export default ${JSON.stringify(both)};\n`);
