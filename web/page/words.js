// The words of the page in English, German and Dutch.
import desktop from 'generated/desktop_words.js';
import { choices } from './dom.js';

export const languages = { en: 'English', de: 'Deutsch', nl: 'Nederlands' };

// Texts that the desktop program does not have: [german, dutch].
const own = {
  'Menu': ['Menü', 'Menu'],
  'Tools': ['Werkzeuge', 'Gereedschappen'],
  'View': ['Ansicht', 'Beeld'],
  'Ink': ['Tinte', 'Inkt'],
  'Medium': ['Zeichenmittel', 'Tekenmiddel'],
  'Surface': ['Untergrund', 'Ondergrond'],
  'Colour': ['Farbe', 'Kleur'],
  'Size': ['Größe', 'Grootte'],
  'Options': ['Optionen', 'Opties'],
  'Layers': ['Ebenen', 'Lagen'],
  'Forces': ['Kräfte', 'Krachten'],
  'Close': ['Schließen', 'Sluiten'],
  'New drawing': ['Neue Zeichnung', 'Nieuwe tekening'],
  'Open…': ['Öffnen …', 'Openen…'],
  'Add a file to the drawing…': ['Datei zur Zeichnung hinzufügen …', 'Bestand aan de tekening toevoegen…'],
  'Save as Feltline drawing': ['Als Feltline-Zeichnung speichern', 'Opslaan als Feltline-tekening'],
  'Save as SVG': ['Als SVG speichern', 'Opslaan als SVG'],
  'Save as lines of JSON': ['Als JSON-Zeilen speichern', 'Opslaan als JSON-regels'],
  'Export as PNG': ['Als PNG exportieren', 'Exporteren als PNG'],
  'Theme': ['Farbschema', 'Thema'],
  'Language': ['Sprache', 'Taal'],
  'as in the system': ['wie im System', 'zoals het systeem'],
  'light': ['hell', 'licht'],
  'dark': ['dunkel', 'donker'],
  'Let the simulated hand draw the cat': [
    'Die simulierte Hand die Katze zeichnen lassen',
    'De gesimuleerde hand de kat laten tekenen',
  ],
  'Stop the simulated hand': ['Die simulierte Hand anhalten', 'De gesimuleerde hand stoppen'],
  'The simulated hand draws. Touch the sheet to stop it.': [
    'Die simulierte Hand zeichnet. Berühren Sie das Blatt, um sie anzuhalten.',
    'De gesimuleerde hand tekent. Raak het blad aan om haar te stoppen.',
  ],
  'Keyboard shortcuts': ['Tastenkürzel', 'Sneltoetsen'],
  'About Feltline': ['Über Feltline', 'Over Feltline'],
  'Sound of drawing': ['Ton beim Zeichnen', 'Geluid van het tekenen'],
  'Show forces': ['Kräfte anzeigen', 'Krachten tonen'],
  'Pen moves with forces': ['Stift folgt den Kräften', 'Pen beweegt met krachten'],
  'The plot shows what a force-feedback pen would let you feel.': [
    'Das Diagramm zeigt, was ein Stift mit Kraftrückmeldung spüren ließe.',
    'Het diagram toont wat een pen met krachtterugkoppeling zou laten voelen.',
  ],
  'Fit page': ['Seite einpassen', 'Pagina passend'],
  'Draw. To correct a line, choose Pull and pull it into shape.': [
    'Zeichnen Sie. Um eine Linie zu korrigieren, wählen Sie Ziehen und ziehen Sie sie in Form.',
    'Teken. Om een lijn te verbeteren kiest u Trekken en trekt u de lijn in vorm.',
  ],
  'Sheet. Draw with pen, finger or mouse; arrow keys move the pen, Enter puts it down and lifts it.': [
    'Blatt. Zeichnen Sie mit Stift, Finger oder Maus; Pfeiltasten bewegen den Stift, Enter setzt ihn auf und hebt ihn ab.',
    'Blad. Teken met pen, vinger of muis; pijltoetsen bewegen de pen, Enter zet haar neer en tilt haar op.',
  ],
  'The pen is down': ['Der Stift liegt auf', 'De pen is neer'],
  'The pen is up': ['Der Stift ist abgehoben', 'De pen is los'],
  'Loading…': ['Wird geladen …', 'Laden…'],
  '%1 could not be loaded. Reload the page.': [
    '%1 konnte nicht geladen werden. Laden Sie die Seite neu.',
    '%1 kon niet worden geladen. Laad de pagina opnieuw.',
  ],
  '%1 could not be loaded': ['%1 konnte nicht geladen werden', '%1 kon niet worden geladen'],
  'it is too large': ['Sie ist zu groß', 'het is te groot'],
  'And %1 more.': ['Und %1 weitere.', 'En nog %1.'],
  'Show all': ['Alle zeigen', 'Alle tonen'],
  'Left out or changed': ['Weggelassen oder geändert', 'Weggelaten of gewijzigd'],
  'it is damaged': ['Sie ist beschädigt', 'het is beschadigd'],
  'There is nothing to undo.': ['Es gibt nichts rückgängig zu machen.', 'Er is niets om ongedaan te maken.'],
  'There is nothing to redo.': ['Es gibt nichts zu wiederholen.', 'Er is niets om opnieuw te doen.'],
  'There is nothing to copy.': ['Es gibt nichts zu kopieren.', 'Er is niets om te kopiëren.'],
  'Lift the pen first.': ['Heben Sie zuerst den Stift ab.', 'Til eerst de pen op.'],
  'The last line has no other form.': ['Die letzte Linie hat keine andere Form.', 'De laatste lijn heeft geen andere vorm.'],
  'Nothing is selected. Draw around lines with the lasso first.': [
    'Nichts ist ausgewählt. Ziehen Sie zuerst mit dem Lasso um Linien.',
    'Er is niets geselecteerd. Teken eerst met de lasso om lijnen heen.',
  ],
  'Only a part of the line is selected. Select whole lines first.': [
    'Nur ein Teil der Linie ist ausgewählt. Wählen Sie zuerst ganze Linien aus.',
    'Alleen een deel van de lijn is geselecteerd. Selecteer eerst hele lijnen.',
  ],
  'It is not possible with this drawing.': ['Das geht mit dieser Zeichnung nicht.', 'Dat kan niet met deze tekening.'],
  'This changed nothing: %1': ['Das hat nichts geändert: %1', 'Dit heeft niets gewijzigd: %1'],
  'Your drawing is unchanged.': ['Ihre Zeichnung ist unverändert.', 'Uw tekening is ongewijzigd.'],
  'the browser cannot read it; a folder cannot be opened': [
    'Der Browser kann sie nicht lesen; ein Ordner lässt sich nicht öffnen',
    'de browser kan het niet lezen; een map kan niet worden geopend',
  ],
  'Until you reload the page, only the pencil works.': [
    'Bis Sie die Seite neu laden, arbeitet nur der Bleistift.',
    'Totdat u de pagina opnieuw laadt, werkt alleen het potlood.',
  ],
  'This is not a file, so it was not added. Save it as a file first, or copy and paste it.': [
    'Das ist keine Datei und wurde darum nicht hinzugefügt. Speichern Sie es zuerst als Datei, oder kopieren Sie es und fügen Sie es ein.',
    'Dit is geen bestand en is daarom niet toegevoegd. Sla het eerst als bestand op, of kopieer en plak het.',
  ],
  'The browser does not let the page play sound. You can draw without it.': [
    'Der Browser lässt die Seite keinen Ton abspielen. Zeichnen können Sie auch ohne.',
    'De browser laat de pagina geen geluid afspelen. U kunt zonder geluid tekenen.',
  ],
  'The browser does not show the other drawings now. Reload the page to try again.': [
    'Der Browser zeigt die anderen Zeichnungen gerade nicht. Laden Sie die Seite neu, um es noch einmal zu versuchen.',
    'De browser toont de andere tekeningen nu niet. Laad de pagina opnieuw om het nog eens te proberen.',
  ],
  'Selection': ['Auswahl', 'Selectie'],
  'Suggestions': ['Vorschläge', 'Suggesties'],
  'This browser cannot run the page: it needs WebAssembly and JavaScript of 2023 or later.': [
    'Dieser Browser kann die Seite nicht ausführen: Sie braucht WebAssembly und JavaScript von 2023 oder neuer.',
    'Deze browser kan de pagina niet uitvoeren: ze heeft WebAssembly en JavaScript van 2023 of later nodig.',
  ],
  'Other drawings…': ['Andere Zeichnungen …', 'Andere tekeningen…'],
  'Other drawings are in the menu.': ['Andere Zeichnungen sind im Menü.', 'Andere tekeningen staan in het menu.'],
  'There are no other drawings in this browser.': [
    'In diesem Browser sind keine anderen Zeichnungen.',
    'In deze browser zijn geen andere tekeningen.',
  ],
  'Lines: %1': ['Linien: %1', 'Lijnen: %1'],
  'Restored the drawing of your last visit.': [
    'Die Zeichnung Ihres letzten Besuchs ist wieder da.',
    'De tekening van uw vorige bezoek is hersteld.',
  ],
  'The drawing of your last visit could not be restored: %1': [
    'Die Zeichnung Ihres letzten Besuchs ließ sich nicht wiederherstellen: %1',
    'De tekening van uw vorige bezoek kon niet worden hersteld: %1',
  ],
  'It is still stored in this browser. What you draw now is not, until you continue without the stored drawing, which deletes it.': [
    'Sie ist noch in diesem Browser gespeichert. Was Sie jetzt zeichnen, wird nicht gespeichert, bis Sie ohne die gespeicherte Zeichnung fortfahren; dabei wird diese gelöscht.',
    'Ze is nog in deze browser opgeslagen. Wat u nu tekent wordt niet opgeslagen, totdat u zonder de opgeslagen tekening doorgaat; die wordt daarbij gewist.',
  ],
  'Continue without it': ['Ohne sie fortfahren', 'Zonder haar doorgaan'],
  'Save it as files': ['Als Dateien speichern', 'Als bestanden opslaan'],
  'Try again': ['Noch einmal versuchen', 'Opnieuw proberen'],
  'An error occurred, and the page cannot continue. The stored drawing is unchanged. Reload the page.': [
    'Ein Fehler ist aufgetreten, und die Seite kann nicht fortfahren. Die gespeicherte Zeichnung ist unverändert. Laden Sie die Seite neu.',
    'Er is een fout opgetreden en de pagina kan niet doorgaan. De opgeslagen tekening is ongewijzigd. Laad de pagina opnieuw.',
  ],
  'This browser does not store the drawing. Save it before you close the page.': [
    'Dieser Browser bewahrt die Zeichnung nicht auf. Speichern Sie sie, bevor Sie die Seite schließen.',
    'Deze browser bewaart de tekening niet. Sla haar op voordat u de pagina sluit.',
  ],
  'The page is still loading, so your lines are not stored yet. Keep it open.': [
    'Die Seite wird noch geladen, darum sind Ihre Linien noch nicht gespeichert. Lassen Sie sie geöffnet.',
    'De pagina wordt nog geladen, daarom zijn uw lijnen nog niet opgeslagen. Houd haar open.',
  ],
  'An error occurred. The drawing was restored up to the last step.': [
    'Ein Fehler ist aufgetreten. Die Zeichnung wurde bis zum letzten Schritt wiederhergestellt.',
    'Er is een fout opgetreden. De tekening is tot de laatste stap hersteld.',
  ],
  'Replace the drawing? It is not in a file yet.': [
    'Zeichnung ersetzen? Sie ist noch in keiner Datei gespeichert.',
    'De tekening vervangen? Ze staat nog niet in een bestand.',
  ],
  'Replace': ['Ersetzen', 'Vervangen'],
  'Cancel': ['Abbrechen', 'Annuleren'],
  '“%1” could not be opened: %2': ['„%1“ lässt sich nicht öffnen: %2', '‘%1’ kan niet worden geopend: %2'],
  'The drawing could not be saved: %1': [
    'Die Zeichnung ließ sich nicht speichern: %1',
    'De tekening kon niet worden opgeslagen: %1',
  ],
  'Saved as %1': ['Gespeichert als %1', 'Opgeslagen als %1'],
  'Drawing': ['Zeichnung', 'Tekening'],
  'Show “%1”': ['„%1“ anzeigen', '‘%1’ tonen'],
  'Hide “%1”': ['„%1“ ausblenden', '‘%1’ verbergen'],
  'Draw on “%1”': ['Auf „%1“ zeichnen', 'Tekenen op ‘%1’'],
  'Name of the layer': ['Name der Ebene', 'Naam van de laag'],
  'Rename the layer': ['Ebene umbenennen', 'Laag hernoemen'],
  'Lock “%1”': ['„%1“ sperren', '‘%1’ vergrendelen'],
  'Unlock “%1”': ['„%1“ entsperren', '‘%1’ ontgrendelen'],
  'Opacity': ['Deckkraft', 'Dekking'],
  'Blend mode': ['Mischmodus', 'Mengmodus'],
  'The sheet stays light, so that colours look as they will on paper.': [
    'Das Blatt bleibt hell, damit Farben so aussehen wie später auf Papier.',
    'Het blad blijft licht, zodat kleuren eruitzien zoals later op papier.',
  ],
  'The browser does not let the page copy. Press %1.': [
    'Der Browser lässt die Seite nicht kopieren. Drücken Sie %1.',
    'De browser laat de pagina niet kopiëren. Druk op %1.',
  ],
  'The browser does not let the page paste. Press %1.': [
    'Der Browser lässt die Seite nicht einfügen. Drücken Sie %1.',
    'De browser laat de pagina niet plakken. Druk op %1.',
  ],
  'The sheet is turned by %1°. Turn it upright': [
    'Das Blatt ist um %1° gedreht. Gerade stellen',
    'Het blad is %1° gedraaid. Rechtop zetten',
  ],
  'on': ['an', 'aan'],
  'off': ['aus', 'uit'],
  'Pan': ['Ansicht verschieben', 'Beeld verschuiven'],
  'Space and drag': ['Leertaste und ziehen', 'Spatie en slepen'],
  'Hold the key of a tool to use it until you release the key.': [
    'Halten Sie die Taste eines Werkzeugs, um es nur bis zum Loslassen zu benutzen.',
    'Houd de toets van een gereedschap vast om het tot het loslaten te gebruiken.',
  ],
  'Two fingers move, zoom and turn the sheet; a tap with two fingers undoes, with three redoes.': [
    'Zwei Finger verschieben, vergrößern und drehen das Blatt; ein Tippen mit zwei Fingern macht rückgängig, mit drei wiederholt.',
    'Twee vingers verschuiven, vergroten en draaien het blad; een tik met twee vingers maakt ongedaan, met drie opnieuw.',
  ],
  'Move the pen': ['Stift bewegen', 'Pen bewegen'],
  'Pen down, pen up': ['Stift aufsetzen, abheben', 'Pen neer, pen op'],
  'arrow keys': ['Pfeiltasten', 'pijltoetsen'],
  'Feltline is a sketching program you can feel: pull a line and it resists. On this page you draw with the same tools and see and hear the forces.': [
    'Feltline ist ein Skizzenprogramm zum Fühlen: Ziehen Sie an einer Linie, und sie wehrt sich. Auf dieser Seite zeichnen Sie mit denselben Werkzeugen und sehen und hören die Kräfte.',
    'Feltline is een schetsprogramma dat u kunt voelen: trek aan een lijn en ze biedt weerstand. Op deze pagina tekent u met hetzelfde gereedschap en ziet en hoort u de krachten.',
  ],
  'Force-feedback devices work with the desktop program and the command line only. There, the safety chain checks each force on the way to the device; a web page must not bypass it.': [
    'Geräte mit Kraftrückmeldung arbeiten nur mit dem Desktop-Programm und der Kommandozeile. Dort prüft die Sicherheitskette jede Kraft auf dem Weg zum Gerät; eine Webseite darf sie nicht umgehen.',
    'Apparaten met krachtterugkoppeling werken alleen met het desktopprogramma en de opdrachtregel. Daar controleert de veiligheidsketen elke kracht op weg naar het apparaat; een webpagina mag die niet omzeilen.',
  ],
  'The drawing stays in this browser until you save it as a file. The page sends nothing and loads nothing.': [
    'Die Zeichnung bleibt in diesem Browser, bis Sie sie als Datei speichern. Die Seite sendet nichts und lädt nichts nach.',
    'De tekening blijft in deze browser totdat u haar als bestand opslaat. De pagina verstuurt niets en laadt niets.',
  ],
};

let language = 'en';

export function set_language(wanted) {
  const asked = wanted || navigator.languages?.map((name) => name.slice(0, 2)).find((name) => name in languages);
  language = asked in languages ? asked : 'en';
  document.documentElement.lang = language;
}
export const current_language = () => language;
set_language(choices.get('language'));

/** Returns the text in the language of the page; `values` replace %1, %2. */
export function t(text, ...values) {
  return filled(own[text]?.[language === 'de' ? 0 : 1] && language !== 'en'
    ? own[text][language === 'de' ? 0 : 1] : text, values);
}

/** Returns a text of the desktop program; `context` is that of its translations. */
export function d(context, text, ...values) {
  const both = language === 'en' ? null : desktop[context]?.[text];
  return filled(both?.[language === 'de' ? 0 : 1] || text, values);
}

const kAround = ['line %1: %2', '%1 (and %2 more like it)'];  // another sentence
let patterns = null;

/** The sentences of core_full.js, [expression, [german, dutch]]: the longest first, so that none hides a more exact one. */
function sentence_patterns() {
  const rows = Object.assign({}, ...Object.values(globalThis.feltlineFull?.sentences ?? {}));
  const rank = (text) => (kAround.includes(text) ? Infinity : text.replace(/%\d/g, '').length);
  return Object.keys(rows).sort((a, b) => rank(b) - rank(a)).map((text) => {
    const source = text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&').replace(/%\d/g, '(.+?)');
    // Most of them are about an element, which stands before them.
    return [new RegExp(`^${kAround.includes(text) ? '()' : '(.+? )?'}${source}$`, 's'), rows[text]];
  });
}

/** Returns a sentence of the library about unsupported content in the language of the page. */
export function loss(text) {
  if (language === 'en') return text;
  patterns ??= sentence_patterns();
  for (const [expression, both] of patterns) {
    const found = expression.exec(text);
    if (!found) continue;
    const [, element, ...values] = found;
    return (element ? `${loss(element.trim())} ` : '') + filled(both[language === 'de' ? 0 : 1], values.map(loss));
  }
  return text;
}

/** In one pass, because a value may contain %2 or $&. */
const filled = (text, values) => text.replace(/%(\d)/g, (all, i) => values[i - 1] ?? all);

/** Returns a number with this many decimals, as one writes it in the language of the page. */
export function number(value, decimals = 0) {
  return value.toLocaleString(language, { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
}
