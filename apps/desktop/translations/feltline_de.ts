<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>AddedStrokes</name>
    <message>
        <source>“%1” is another medium here than there: its strokes look as they do here</source>
        <translation>„%1“ ist hier ein anderes Zeichenmittel als dort: seine Linien sehen aus wie hier</translation>
    </message>
</context>
<context>
    <name>Arguments</name>
    <message>
        <source>Open a window of its own, with a fresh sheet.</source>
        <translation>Ein eigenes Fenster mit einem leeren Blatt öffnen.</translation>
    </message>
    <message>
        <source>Speak en, de or nl, whatever the system does.</source>
        <translation>Sprache en, de oder nl, unabhängig vom System.</translation>
    </message>
    <message>
        <source>Record all that happens to the drawing, for feltline replay --as-recorded.</source>
        <translation>Alles aufzeichnen, was mit der Zeichnung geschieht, für feltline replay --as-recorded.</translation>
    </message>
    <message>
        <source>Feltline: draw, and feel what you draw.</source>
        <translation>Feltline: zeichnen und fühlen, was man zeichnet.</translation>
    </message>
    <message>
        <source>Drawings to open: .felt, .svg, .ndjson.</source>
        <translation>Zeichnungen, die geöffnet werden: .felt, .svg, .ndjson.</translation>
    </message>
    <message>
        <source>--size is WIDTHxHEIGHT, from 100 to 8000</source>
        <translation>--size ist BREITExHÖHE, von 100 bis 8000</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Beispiele:</translation>
    </message>
</context>
<context>
    <name>ButtonRole</name>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Erase while held</source>
        <translation>Radieren, solange gehalten</translation>
    </message>
    <message>
        <source>Pull while held</source>
        <translation>Ziehen, solange gehalten</translation>
    </message>
    <message>
        <source>Select while held</source>
        <translation>Auswählen, solange gehalten</translation>
    </message>
    <message>
        <source>Move the sheet while held</source>
        <translation>Blatt verschieben, solange gehalten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>The tool&apos;s first modifier (Shift)</source>
        <translation>Erste Zusatztaste des Werkzeugs (Umschalt)</translation>
    </message>
    <message>
        <source>The tool&apos;s second modifier (Ctrl)</source>
        <translation>Zweite Zusatztaste des Werkzeugs (Strg)</translation>
    </message>
</context>
<context>
    <name>ColorActions</name>
    <message>
        <source>&amp;Open a palette…</source>
        <translation>Palette ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Reads colours from a .gpl file.</source>
        <translation>Liest Farben aus einer .gpl-Datei.</translation>
    </message>
    <message>
        <source>&amp;Export the palette…</source>
        <translation>Palette &amp;exportieren …</translation>
    </message>
    <message>
        <source>Writes the palette that is shown.</source>
        <translation>Schreibt die gezeigte Palette.</translation>
    </message>
    <message>
        <source>&amp;Keep the colour</source>
        <translation>Farbe &amp;behalten</translation>
    </message>
    <message>
        <source>Puts the colour in use into a palette of your own.</source>
        <translation>Legt die benutzte Farbe in eine eigene Palette.</translation>
    </message>
    <message>
        <source>&amp;Take the colour out</source>
        <translation>Farbe &amp;herausnehmen</translation>
    </message>
    <message>
        <source>Takes the colour in use out of your own palette.</source>
        <translation>Nimmt die benutzte Farbe aus der eigenen Palette.</translation>
    </message>
</context>
<context>
    <name>DeviceWords</name>
    <message>
        <source>the device is not connected any more</source>
        <translation>das Gerät ist nicht mehr angeschlossen</translation>
    </message>
    <message>
        <source>the device does not know where its arm is</source>
        <translation>das Gerät weiß nicht, wo sein Arm ist</translation>
    </message>
    <message>
        <source>the device has switched its forces off</source>
        <translation>das Gerät hat seine Kräfte abgeschaltet</translation>
    </message>
    <message>
        <source>its motors are warm</source>
        <translation>seine Motoren sind warm</translation>
    </message>
    <message>
        <source>the device says what cannot be</source>
        <translation>das Gerät meldet Unmögliches</translation>
    </message>
    <message>
        <source>the device reports a fault</source>
        <translation>das Gerät meldet einen Fehler</translation>
    </message>
    <message>
        <source>%1 is not connected any more.</source>
        <translation>%1 ist nicht mehr angeschlossen.</translation>
    </message>
    <message>
        <source>Draw on with mouse or tablet; nothing is lost. Look at its cable and its power.</source>
        <translation>Mit Maus oder Tablett weiterzeichnen; nichts ist verloren. Kabel und Stromversorgung prüfen.</translation>
    </message>
    <message>
        <source>%1 does not know where its arm is.</source>
        <translation>%1 weiß nicht, wo sein Arm ist.</translation>
    </message>
    <message>
        <source>Draw on with mouse or tablet until it has found its home.</source>
        <translation>Mit Maus oder Tablett weiterzeichnen, bis es seine Ausgangslage gefunden hat.</translation>
    </message>
    <message>
        <source>%1 has switched its forces off.</source>
        <translation>%1 hat seine Kräfte abgeschaltet.</translation>
    </message>
    <message>
        <source>Its button or its own guard did that. Draw on without forces, or switch them on again there and here.</source>
        <translation>Das war sein Knopf oder sein eigener Schutz. Ohne Kräfte weiterzeichnen oder sie dort und hier wieder einschalten.</translation>
    </message>
    <message>
        <source>The motors of %1 are warm.</source>
        <translation>Die Motoren von %1 sind warm.</translation>
    </message>
    <message>
        <source>Draw on without forces. After some minutes of rest they can be switched on again.</source>
        <translation>Ohne Kräfte weiterzeichnen. Nach einigen Minuten Ruhe lassen sie sich wieder einschalten.</translation>
    </message>
    <message>
        <source>%1 says what cannot be.</source>
        <translation>%1 meldet Unmögliches.</translation>
    </message>
    <message>
        <source>%1 reports a fault.</source>
        <translation>%1 meldet einen Fehler.</translation>
    </message>
    <message>
        <source>Draw on without forces.</source>
        <translation>Ohne Kräfte weiterzeichnen.</translation>
    </message>
    <message>
        <source>Draw on with mouse or tablet. Look at its cable, switch it off and on, and try again.</source>
        <translation>Mit Maus oder Tablett weiterzeichnen. Das Kabel prüfen, das Gerät aus- und einschalten und es noch einmal versuchen.</translation>
    </message>
</context>
<context>
    <name>EditActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>&amp;Invert selection</source>
        <translation>Auswahl &amp;umkehren</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>Takes the last step back.</source>
        <translation>Nimmt den letzten Schritt zurück.</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>Macht wieder, was zurückgenommen wurde.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Removes the lines that are selected.</source>
        <translation>Entfernt die ausgewählten Linien.</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Copies the selected lines, a little beside them.</source>
        <translation>Kopiert die ausgewählten Linien, etwas daneben.</translation>
    </message>
    <message>
        <source>Selects all lines of visible, unlocked layers.</source>
        <translation>Wählt alle Linien sichtbarer, nicht gesperrter Ebenen.</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>&amp;Nichts auswählen</translation>
    </message>
    <message>
        <source>Selects nothing.</source>
        <translation>Wählt nichts aus.</translation>
    </message>
    <message>
        <source>Selects all lines but those that are selected now.</source>
        <translation>Wählt alle Linien außer den jetzt ausgewählten.</translation>
    </message>
    <message>
        <source>&amp;Cancel or select nothing</source>
        <translation>&amp;Abbrechen oder nichts auswählen</translation>
    </message>
    <message>
        <source>Cancels what the pen is doing, or clears the selection.</source>
        <translation>Bricht ab, was der Stift gerade tut, oder hebt die Auswahl auf.</translation>
    </message>
</context>
<context>
    <name>ErrorWords</name>
    <message>
        <source>The file or folder is not there.</source>
        <translation>Die Datei oder der Ordner ist nicht da.</translation>
    </message>
    <message>
        <source>The file cannot be read or written: it may be protected, or the disk may be full.</source>
        <translation>Die Datei kann nicht gelesen oder geschrieben werden: vielleicht ist sie geschützt oder der Datenträger voll.</translation>
    </message>
    <message>
        <source>Feltline cannot read this kind of file.</source>
        <translation>Feltline kann Dateien dieser Art nicht lesen.</translation>
    </message>
    <message>
        <source>It is damaged, or not a drawing that Feltline can read.</source>
        <translation>Sie ist beschädigt oder keine Zeichnung, die Feltline lesen kann.</translation>
    </message>
    <message>
        <source>The drawing is too large for Feltline.</source>
        <translation>Die Zeichnung ist zu groß für Feltline.</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>A cat</source>
        <translation>Eine Katze</translation>
    </message>
    <message>
        <source>Handwriting</source>
        <translation>Handschrift</translation>
    </message>
    <message>
        <source>A page of exercises</source>
        <translation>Eine Seite Übungen</translation>
    </message>
    <message>
        <source>Doodles</source>
        <translation>Kritzeleien</translation>
    </message>
</context>
<context>
    <name>FeelActions</name>
    <message>
        <source>My &amp;own sheets</source>
        <translation>&amp;Eigene Blätter</translation>
    </message>
    <message>
        <source>Sheets that you made, or a drawing brought</source>
        <translation>Blätter, die man selbst gemacht hat oder die eine Zeichnung mitbrachte</translation>
    </message>
    <message>
        <source>No force, at once</source>
        <translation>Keine Kraft mehr, sofort</translation>
    </message>
    <message>
        <source>&amp;Stronger forces</source>
        <translation>&amp;Stärkere Kräfte</translation>
    </message>
    <message>
        <source>All forces 10 % stronger</source>
        <translation>Alle Kräfte 10 % stärker</translation>
    </message>
    <message>
        <source>&amp;Weaker forces</source>
        <translation>S&amp;chwächere Kräfte</translation>
    </message>
    <message>
        <source>All forces 10 % weaker</source>
        <translation>Alle Kräfte 10 % schwächer</translation>
    </message>
    <message>
        <source>Forces are off. The panel Feel switches them on again.</source>
        <translation>Die Kräfte sind aus. Im Feld „Gefühl“ schaltet man sie wieder ein.</translation>
    </message>
    <message>
        <source>Hear the pen rub on the sheet</source>
        <translation>Den Stift auf dem Blatt reiben hören</translation>
    </message>
    <message>
        <source>Stops all forces, or lets the pen be pushed</source>
        <translation>Hält alle Kräfte an oder lässt den Stift schieben</translation>
    </message>
    <message>
        <source>Stop &amp;forces</source>
        <translation>Kräfte &amp;anhalten</translation>
    </message>
    <message>
        <source>Switch &amp;forces on</source>
        <translation>Kräfte &amp;einschalten</translation>
    </message>
    <message>
        <source>Stop forces, &amp;never start (Esc twice)</source>
        <translation>Kräfte anhalten, &amp;nie einschalten (Esc zweimal)</translation>
    </message>
    <message>
        <source>S&amp;ound of drawing</source>
        <translation>&amp;Ton beim Zeichnen</translation>
    </message>
</context>
<context>
    <name>FirstMinute</name>
    <message>
        <source>Draw with the pen or the mouse.</source>
        <translation>Zeichnen Sie mit dem Stift oder der Maus.</translation>
    </message>
    <message>
        <source>To correct a line, press %1 and pull it into shape.</source>
        <translation>Um eine Linie zu verbessern, drücken Sie %1 und ziehen Sie sie in Form.</translation>
    </message>
    <message>
        <source>%1 takes back a step. The Help menu has a two-minute tour.</source>
        <translation>%1 nimmt einen Schritt zurück. Im Hilfe-Menü gibt es eine Führung von zwei Minuten.</translation>
    </message>
</context>
<context>
    <name>KeyTable</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Gefühl</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Blatt verschieben</translation>
    </message>
    <message>
        <source>Space + drag</source>
        <translation>Leertaste + ziehen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Zoom smoothly</source>
        <translation>Stufenlos zoomen</translation>
    </message>
    <message>
        <source>Ctrl + Space + drag</source>
        <translation>Strg + Leertaste + ziehen</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Shift + Space + drag</source>
        <translation>Umschalt + Leertaste + ziehen</translation>
    </message>
    <message>
        <source>Borrow a tool</source>
        <translation>Werkzeug ausleihen</translation>
    </message>
    <message>
        <source>Hold its key while you use it</source>
        <translation>Taste beim Benutzen halten</translation>
    </message>
    <message>
        <source>Pen, mouse and held keys</source>
        <translation>Stift, Maus und gehaltene Tasten</translation>
    </message>
</context>
<context>
    <name>LayerActions</name>
    <message>
        <source>&amp;Add layer</source>
        <translation>Ebene &amp;hinzufügen</translation>
    </message>
    <message>
        <source>A new layer above the one in use.</source>
        <translation>Eine neue Ebene über der benutzten.</translation>
    </message>
    <message>
        <source>Remo&amp;ve layer</source>
        <translation>Ebene &amp;entfernen</translation>
    </message>
    <message>
        <source>Removes it and what is drawn on it.</source>
        <translation>Entfernt sie und was darauf gezeichnet ist.</translation>
    </message>
    <message>
        <source>Re&amp;name layer</source>
        <translation>Ebene &amp;umbenennen</translation>
    </message>
    <message>
        <source>Gives it another name.</source>
        <translation>Gibt ihr einen anderen Namen.</translation>
    </message>
    <message>
        <source>&amp;Raise layer</source>
        <translation>Ebene nach &amp;oben</translation>
    </message>
    <message>
        <source>One place up.</source>
        <translation>Einen Platz nach oben.</translation>
    </message>
    <message>
        <source>&amp;Lower layer</source>
        <translation>Ebene nach un&amp;ten</translation>
    </message>
    <message>
        <source>One place down.</source>
        <translation>Einen Platz nach unten.</translation>
    </message>
    <message>
        <source>Draw on the layer &amp;above</source>
        <translation>Auf der Ebene &amp;darüber zeichnen</translation>
    </message>
    <message>
        <source>New lines go to the next layer up.</source>
        <translation>Neue Linien kommen auf die nächsthöhere Ebene.</translation>
    </message>
    <message>
        <source>Draw on the layer &amp;below</source>
        <translation>Auf der Ebene dar&amp;unter zeichnen</translation>
    </message>
    <message>
        <source>New lines go to the next layer down.</source>
        <translation>Neue Linien kommen auf die nächsttiefere Ebene.</translation>
    </message>
    <message>
        <source>&amp;Show layer</source>
        <translation>Ebene &amp;zeigen</translation>
    </message>
    <message>
        <source>What is drawn on it is seen.</source>
        <translation>Was darauf gezeichnet ist, ist zu sehen.</translation>
    </message>
    <message>
        <source>Loc&amp;k layer</source>
        <translation>Ebene &amp;sperren</translation>
    </message>
    <message>
        <source>Nothing on it can be changed.</source>
        <translation>Nichts darauf lässt sich ändern.</translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Filz</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Hart</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>slippery</source>
        <translation>rutschig</translation>
    </message>
    <message>
        <source>some friction</source>
        <translation>etwas Reibung</translation>
    </message>
    <message>
        <source>much friction</source>
        <translation>viel Reibung</translation>
    </message>
    <message>
        <source>strong friction</source>
        <translation>starke Reibung</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>fine grain</source>
        <translation>feine Körnung</translation>
    </message>
    <message>
        <source>rough grain</source>
        <translation>raue Körnung</translation>
    </message>
    <message>
        <source>coarse weave</source>
        <translation>grobes Gewebe</translation>
    </message>
    <message>
        <source>%1, %2, %3.</source>
        <translation>%1, %2, %3.</translation>
    </message>
    <message>
        <source>Rough paper</source>
        <translation>Raues Papier</translation>
    </message>
    <message>
        <source>Watercolour paper</source>
        <translation>Aquarellpapier</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>matted fibres</source>
        <translation>verfilzte Fasern</translation>
    </message>
    <message>
        <source>grain along the board</source>
        <translation>Maserung längs des Bretts</translation>
    </message>
    <message>
        <source>hilly grain</source>
        <translation>hügeliges Korn</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Bleistift</translation>
    </message>
    <message>
        <source>Hard pencil</source>
        <translation>Harter Bleistift</translation>
    </message>
    <message>
        <source>Soft pencil</source>
        <translation>Weicher Bleistift</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>Kohle</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>Kreide</translation>
    </message>
    <message>
        <source>Crayon</source>
        <translation>Wachskreide</translation>
    </message>
    <message>
        <source>Felt-tip</source>
        <translation>Filzstift</translation>
    </message>
    <message>
        <source>Ink pen</source>
        <translation>Tuschestift</translation>
    </message>
    <message>
        <source>Brush pen</source>
        <translation>Pinselstift</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>hides the grain</source>
        <translation>deckt die Körnung zu</translation>
    </message>
    <message>
        <source>grain to feel, not to see</source>
        <translation>Körnung zu fühlen, nicht zu sehen</translation>
    </message>
    <message>
        <source>fills the grain</source>
        <translation>füllt die Körnung</translation>
    </message>
    <message>
        <source>shows the grain</source>
        <translation>zeigt die Körnung</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>%1, %2, lines of %3.</source>
        <translation>%1, %2, Linien von %3.</translation>
    </message>
</context>
<context>
    <name>MediaPicker</name>
    <message>
        <source>%1 draws in its own colour, %2.</source>
        <translation>%1 zeichnet in seiner eigenen Farbe, %2.</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>F&amp;eel</source>
        <translation>&amp;Gefühl</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>Copy &amp;as</source>
        <translation>Kopieren &amp;als</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>&amp;Example drawings</source>
        <translation>&amp;Beispielzeichnungen</translation>
    </message>
    <message>
        <source>&amp;Scroll</source>
        <translation>Ro&amp;llen</translation>
    </message>
    <message>
        <source>Pal&amp;ette</source>
        <translation>&amp;Palette</translation>
    </message>
    <message>
        <source>S&amp;heet</source>
        <translation>&amp;Blatt</translation>
    </message>
</context>
<context>
    <name>OptionsPanel</name>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>Palettes</name>
    <message>
        <source>Soft black</source>
        <translation>Weiches Schwarz</translation>
    </message>
    <message>
        <source>Graphite</source>
        <translation>Graphit</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Blei</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>Kreide</translation>
    </message>
    <message>
        <source>Red chalk</source>
        <translation>Rötel</translation>
    </message>
    <message>
        <source>Brick</source>
        <translation>Ziegel</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Zinnober</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>Bernstein</translation>
    </message>
    <message>
        <source>Straw</source>
        <translation>Stroh</translation>
    </message>
    <message>
        <source>Moss</source>
        <translation>Moos</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Tanne</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>Petrol</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Ink blue</source>
        <translation>Tintenblau</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Mallow</source>
        <translation>Malve</translation>
    </message>
    <message>
        <source>Blush</source>
        <translation>Rosé</translation>
    </message>
    <message>
        <source>Sepia</source>
        <translation>Sepia</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Himmelblau</translation>
    </message>
    <message>
        <source>Bluish green</source>
        <translation>Blaugrün</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Reddish purple</source>
        <translation>Rotviolett</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>Grautöne</translation>
    </message>
    <message>
        <source>Grey %1 %</source>
        <translation>Grau %1 %</translation>
    </message>
    <message>
        <source>Pencil box</source>
        <translation>Federmäppchen</translation>
    </message>
    <message>
        <source>Okabe and Ito</source>
        <translation>Okabe und Ito</translation>
    </message>
</context>
<context>
    <name>PenActions</name>
    <message>
        <source>&amp;Pen pressure</source>
        <translation>Stift&amp;druck</translation>
    </message>
    <message>
        <source>Pressing harder draws wider; off, every line has the same width.</source>
        <translation>Fester drücken zeichnet breiter; aus: jede Linie ist gleich breit.</translation>
    </message>
    <message>
        <source>Hold the &amp;first modifier</source>
        <translation>&amp;Erste Zusatztaste halten</translation>
    </message>
    <message>
        <source>As if Shift were held, until it is chosen again.</source>
        <translation>Als würde Umschalt gehalten, bis zum nächsten Wählen.</translation>
    </message>
    <message>
        <source>Hold the &amp;second modifier</source>
        <translation>&amp;Zweite Zusatztaste halten</translation>
    </message>
    <message>
        <source>As if Ctrl were held, until it is chosen again.</source>
        <translation>Als würde Strg gehalten, bis zum nächsten Wählen.</translation>
    </message>
</context>
<context>
    <name>PenDevice</name>
    <message>
        <source>Simulated: %1</source>
        <translation>Simuliert: %1</translation>
    </message>
    <message>
        <source>The ink is exactly where the pen is. Forces are shown, not felt.</source>
        <translation>Die Tinte ist genau, wo der Stift ist. Kräfte werden gezeigt, nicht gefühlt.</translation>
    </message>
    <message>
        <source>Mouse or pen lead a simulated hand that holds this stylus. Forces move the ink, so that you see what it would feel like.</source>
        <translation>Maus oder Stift führen eine simulierte Hand, die diesen Stift hält. Kräfte bewegen die Tinte, so dass man sieht, wie es sich anfühlen würde.</translation>
    </message>
    <message>
        <source>Simulated %1</source>
        <translation>%1, simuliert</translation>
    </message>
    <message>
        <source>A person holds it, and feels the forces.</source>
        <translation>Man hält es in der Hand und fühlt die Kräfte.</translation>
    </message>
    <message>
        <source>Mouse or pen, without forces</source>
        <translation>Maus oder Stift, ohne Kräfte</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>Maus oder Stift</translation>
    </message>
    <message>
        <source>Worst case: light, frictionless, coarse</source>
        <translation>Schlimmster Fall: leicht, reibungsfrei, grob</translation>
    </message>
</context>
<context>
    <name>SafetyWords</name>
    <message>
        <source>the force limit</source>
        <translation>die Kraftgrenze</translation>
    </message>
    <message>
        <source>what the motors stand for good</source>
        <translation>was die Motoren auf Dauer aushalten</translation>
    </message>
    <message>
        <source>the speed of the pen</source>
        <translation>das Tempo des Stifts</translation>
    </message>
    <message>
        <source>how fast a force may rise</source>
        <translation>wie schnell eine Kraft steigen darf</translation>
    </message>
    <message>
        <source>how stiff the device can be</source>
        <translation>wie steif das Gerät sein kann</translation>
    </message>
    <message>
        <source>Held back by %1.</source>
        <translation>Begrenzt durch: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Forces are on</source>
        <translation>Die Kräfte sind an</translation>
    </message>
    <message>
        <source>Forces were stopped</source>
        <translation>Die Kräfte wurden angehalten</translation>
    </message>
    <message>
        <source>Forces were stopped: %1</source>
        <translation>Die Kräfte wurden angehalten: %1</translation>
    </message>
    <message>
        <source>Check the cable and the power of the device, then switch the forces on again.</source>
        <translation>Prüfen Sie Kabel und Strom des Geräts und schalten Sie die Kräfte dann wieder ein.</translation>
    </message>
    <message>
        <source>Drawing goes on as before. Lift the pen and switch the forces on again.</source>
        <translation>Das Zeichnen geht weiter wie zuvor. Heben Sie den Stift und schalten Sie die Kräfte wieder ein.</translation>
    </message>
    <message>
        <source>the computer was too busy</source>
        <translation>der Rechner war zu beschäftigt</translation>
    </message>
    <message>
        <source>the pen was too fast</source>
        <translation>der Stift war zu schnell</translation>
    </message>
    <message>
        <source>the program was too busy</source>
        <translation>das Programm war zu beschäftigt</translation>
    </message>
    <message>
        <source>the computer stood still for a moment</source>
        <translation>der Rechner stand einen Moment still</translation>
    </message>
    <message>
        <source>a force made no sense</source>
        <translation>eine Kraft ergab keinen Sinn</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>das Gerät antwortet nicht</translation>
    </message>
    <message>
        <source>the pen seemed to jump</source>
        <translation>der Stift schien zu springen</translation>
    </message>
    <message>
        <source>the self-test failed</source>
        <translation>der Selbsttest ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>Forces are off</source>
        <translation>Die Kräfte sind aus</translation>
    </message>
    <message>
        <source>They are not shown either.</source>
        <translation>Sie werden auch nicht angezeigt.</translation>
    </message>
    <message>
        <source>Shown, not felt: this pen has no motors</source>
        <translation>Zu sehen, nicht zu fühlen: dieser Stift hat keine Motoren</translation>
    </message>
    <message>
        <source>The plot shows what a device would be asked for.</source>
        <translation>Das Diagramm zeigt, was von einem Gerät verlangt würde.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Lift the pen for a moment: forces then begin.</source>
        <translation>Heben Sie den Stift kurz: dann beginnen die Kräfte.</translation>
    </message>
    <message>
        <source>Forces are coming up</source>
        <translation>Die Kräfte kommen</translation>
    </message>
    <message>
        <source>The program is busy</source>
        <translation>Das Programm ist beschäftigt</translation>
    </message>
    <message>
        <source>The pen only feels a brake.</source>
        <translation>Der Stift fühlt nur eine Bremse.</translation>
    </message>
    <message>
        <source>Forces give way: %1</source>
        <translation>Die Kräfte geben nach: %1</translation>
    </message>
    <message>
        <source>They come back by themselves.</source>
        <translation>Sie kommen von selbst wieder.</translation>
    </message>
    <message>
        <source>Sum, asked</source>
        <translation>Summe, verlangt</translation>
    </message>
    <message>
        <source>Sent to the pen</source>
        <translation>An den Stift gesendet</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Körnung</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>Tether</source>
        <translation>Leine</translation>
    </message>
    <message>
        <source>Stabiliser</source>
        <translation>Stabilisator</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anschlag</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Drawing goes on. Switch them on at the device, lift the pen, and switch them on here.</source>
        <translation>Das Zeichnen geht weiter. Am Gerät einschalten, den Stift heben und hier einschalten.</translation>
    </message>
    <message>
        <source>Drawing goes on. Let the device rest for some minutes, then switch the forces on again.</source>
        <translation>Das Zeichnen geht weiter. Das Gerät einige Minuten ruhen lassen, dann die Kräfte wieder einschalten.</translation>
    </message>
    <message>
        <source>the computer or the device could not keep up several times in a minute</source>
        <translation>Computer oder Gerät kamen mehrmals in einer Minute nicht nach</translation>
    </message>
</context>
<context>
    <name>Stability</name>
    <message>
        <source>Stable, as wished</source>
        <translation>Stabil, wie gewünscht</translation>
    </message>
    <message>
        <source>Close to trembling</source>
        <translation>Kurz vor dem Zittern</translation>
    </message>
    <message>
        <source>Trembles</source>
        <translation>Zittert</translation>
    </message>
    <message>
        <source>Stable, but less than wished</source>
        <translation>Stabil, aber weniger als gewünscht</translation>
    </message>
    <message>
        <source>Too much for this device</source>
        <translation>Zu viel für dieses Gerät</translation>
    </message>
    <message>
        <source>The safety chain would switch forces off.</source>
        <translation>Die Sicherheitskette würde die Kräfte abschalten.</translation>
    </message>
    <message>
        <source>A pen that rests trembles with %1 N above 30 Hz; 0.04 N can be felt. Less hardness, less friction or more damping helps.</source>
        <translation>Ein ruhender Stift zittert mit %1 N über 30 Hz; 0,04 N sind zu spüren. Weniger Härte, weniger Reibung oder mehr Dämpfung hilft.</translation>
    </message>
    <message>
        <source>%1 has no motors: nothing is felt. The figures are those of a 3D Systems Touch.</source>
        <translation>%1 hat keine Motoren: Nichts ist zu spüren. Die Werte sind die eines 3D Systems Touch.</translation>
    </message>
    <message>
        <source>%1 % of what the device bears</source>
        <translation>%1 % dessen, was das Gerät verträgt</translation>
    </message>
    <message>
        <source>Hardness: this device makes it %1 of your %2 N/m.</source>
        <translation>Härte: Dieses Gerät macht daraus %1 von Ihren %2 N/m.</translation>
    </message>
    <message>
        <source>Grain: its hills are steeper than this loop can follow; felt are %1 of your %2 µm.</source>
        <translation>Körnung: Ihre Hügel sind steiler, als diese Regelschleife folgen kann; zu fühlen sind %1 von Ihren %2 µm.</translation>
    </message>
</context>
<context>
    <name>ToolActions</name>
    <message>
        <source>S&amp;maller</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Makes the tool in hand smaller.</source>
        <translation>Macht das Werkzeug in der Hand kleiner.</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Größer</translation>
    </message>
    <message>
        <source>Makes the tool in hand larger.</source>
        <translation>Macht das Werkzeug in der Hand größer.</translation>
    </message>
    <message>
        <source>Forces &amp;weaker</source>
        <translation>Kräfte &amp;schwächer</translation>
    </message>
    <message>
        <source>The tool in hand pushes back less.</source>
        <translation>Das Werkzeug in der Hand gibt weniger Widerstand.</translation>
    </message>
    <message>
        <source>Forces &amp;stronger</source>
        <translation>Kräfte s&amp;tärker</translation>
    </message>
    <message>
        <source>The tool in hand pushes back more.</source>
        <translation>Das Werkzeug in der Hand gibt mehr Widerstand.</translation>
    </message>
</context>
<context>
    <name>ToolHint</name>
    <message>
        <source>%1: %2</source>
        <extracomment>a key that is held, and what it does: &quot;Shift: thinner&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ToolSize</name>
    <message>
        <source>%1 mm is the largest size.</source>
        <translation>%1 mm ist die größte Größe.</translation>
    </message>
    <message>
        <source>%1 mm is the smallest size.</source>
        <translation>%1 mm ist die kleinste Größe.</translation>
    </message>
</context>
<context>
    <name>ViewActions</name>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Shows the sheet larger, around the pointer</source>
        <translation>Zeigt das Blatt größer, um den Zeiger</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Shows the sheet smaller, around the pointer</source>
        <translation>Zeigt das Blatt kleiner, um den Zeiger</translation>
    </message>
    <message>
        <source>&amp;Life size</source>
        <translation>&amp;Originalgröße</translation>
    </message>
    <message>
        <source>A millimetre on the sheet is one on the screen</source>
        <translation>Ein Millimeter auf dem Blatt ist einer auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Fit &amp;selection</source>
        <translation>&amp;Auswahl einpassen</translation>
    </message>
    <message>
        <source>Shows what is selected as large as it can</source>
        <translation>Zeigt das Ausgewählte so groß wie möglich</translation>
    </message>
    <message>
        <source>Fit &amp;page</source>
        <translation>&amp;Blatt einpassen</translation>
    </message>
    <message>
        <source>Shows the whole sheet</source>
        <translation>Zeigt das ganze Blatt</translation>
    </message>
    <message>
        <source>Fit &amp;drawing</source>
        <translation>&amp;Zeichnung einpassen</translation>
    </message>
    <message>
        <source>Shows all ink, beside the sheet too</source>
        <translation>Zeigt alle Tinte, auch neben dem Blatt</translation>
    </message>
    <message>
        <source>Turn l&amp;eft</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turns the view anticlockwise; the drawing stays</source>
        <translation>Dreht die Ansicht gegen den Uhrzeigersinn; die Zeichnung bleibt</translation>
    </message>
    <message>
        <source>Turn ri&amp;ght</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turns the view clockwise; the drawing stays</source>
        <translation>Dreht die Ansicht im Uhrzeigersinn; die Zeichnung bleibt</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>Au&amp;frecht</translation>
    </message>
    <message>
        <source>Turns the view back, so that the sheet is upright</source>
        <translation>Dreht die Ansicht zurück, so dass das Blatt aufrecht steht</translation>
    </message>
    <message>
        <source>&amp;Mirror view</source>
        <translation>Ansicht &amp;spiegeln</translation>
    </message>
    <message>
        <source>Swaps left and right of the view, which shows what is askew; the drawing stays</source>
        <translation>Vertauscht links und rechts in der Ansicht und zeigt so, was schief ist; die Zeichnung bleibt</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Nach links rollen</translation>
    </message>
    <message>
        <source>Shows what is further to the left</source>
        <translation>Zeigt, was weiter links ist</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Nach rechts rollen</translation>
    </message>
    <message>
        <source>Shows what is further to the right</source>
        <translation>Zeigt, was weiter rechts ist</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Nach oben rollen</translation>
    </message>
    <message>
        <source>Shows what is further up</source>
        <translation>Zeigt, was weiter oben ist</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Nach unten rollen</translation>
    </message>
    <message>
        <source>Shows what is further down</source>
        <translation>Zeigt, was weiter unten ist</translation>
    </message>
    <message>
        <source>Ou&amp;tlines</source>
        <translation>&amp;Umrisse</translation>
    </message>
    <message>
        <source>Shows the middle of each line only, hair-thin</source>
        <translation>Zeigt nur die Mitte jeder Linie, haarfein</translation>
    </message>
    <message>
        <source>&amp;Force arrow</source>
        <translation>Kraft&amp;pfeil</translation>
    </message>
    <message>
        <source>Shows at the nib where the force pushes</source>
        <translation>Zeigt an der Spitze, wohin die Kraft drückt</translation>
    </message>
    <message>
        <source>&amp;Nib gives way to forces</source>
        <translation>Spitze gibt Kräften &amp;nach</translation>
    </message>
    <message>
        <source>With a simulated stylus, the nib is shown where forces move it</source>
        <translation>Mit einem simulierten Stift steht die Spitze, wohin Kräfte sie bewegen</translation>
    </message>
    <message>
        <source>G&amp;rain of the sheet</source>
        <translation>&amp;Körnung des Blatts</translation>
    </message>
    <message>
        <source>Dry ink shows the relief of the sheet</source>
        <translation>Trockene Tinte zeigt das Relief des Blatts</translation>
    </message>
</context>
<context>
    <name>edits</name>
    <message>
        <source>Add layer</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ebene verbergen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Ebene sperren</translation>
    </message>
    <message>
        <source>Lower layer</source>
        <translation>Ebene nach unten</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Move end</source>
        <translation>Ende verschieben</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>Raise layer</source>
        <translation>Ebene nach oben</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Neu zeichnen</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Ebene umbenennen</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Ebene zeigen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Ebene entsperren</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Restyle</source>
        <translation>Farbe oder Zeichenmittel ändern</translation>
    </message>
</context>
<context>
    <name>felt::desktop::AboutDialog</name>
    <message>
        <source>About Feltline</source>
        <translation>Über Feltline</translation>
    </message>
    <message>
        <source>Icon of Feltline</source>
        <translation>Symbol von Feltline</translation>
    </message>
    <message>
        <source>Sketching that the hand feels: ink that pushes back, lines that are corrected by pulling and pushing them.</source>
        <translation>Skizzieren, das die Hand fühlt: Tinte, die sich wehrt, Linien, die man durch Ziehen und Schieben verbessert.</translation>
    </message>
    <message>
        <source>Begun from an idea of this paper:</source>
        <translation>Entstanden aus einer Idee dieses Artikels:</translation>
    </message>
    <message>
        <source>Built with Qt %1 and these libraries:</source>
        <translation>Gebaut mit Qt %1 und diesen Bibliotheken:</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0. It comes without any warranty.</source>
        <translation>Freie Software unter der Apache-Lizenz 2.0, ohne jede Gewährleistung.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CalibrationDialog</name>
    <message>
        <source>Drawing plane of %1</source>
        <translation>Zeichenebene von %1</translation>
    </message>
    <message>
        <source>The corner to touch</source>
        <translation>Die Ecke, die zu berühren ist</translation>
    </message>
    <message>
        <source>&amp;Take this place</source>
        <translation>Diesen &amp;Ort nehmen</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>&amp;Neu beginnen</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>That is no drawing area: %1. Begin with the upper left corner again.</source>
        <translation>Das ist keine Zeichenfläche: %1. Beginnen Sie wieder mit der Ecke oben links.</translation>
    </message>
    <message>
        <source>Hold the pen&apos;s tip on the upper left corner of where you want to draw.</source>
        <translation>Halten Sie die Stiftspitze auf die obere linke Ecke der Fläche, auf der Sie zeichnen wollen.</translation>
    </message>
    <message>
        <source>Now on the upper right corner.</source>
        <translation>Jetzt auf die Ecke oben rechts.</translation>
    </message>
    <message>
        <source>Now on the lower left corner.</source>
        <translation>Jetzt auf die Ecke unten links.</translation>
    </message>
    <message>
        <source>The drawing area is %L1 mm wide and %L2 mm high.</source>
        <translation>Die Zeichenfläche ist %L1 mm breit und %L2 mm hoch.</translation>
    </message>
    <message>
        <source>Its corners fit within %L1 mm.</source>
        <translation>Ihre Ecken passen auf %L1 mm.</translation>
    </message>
    <message>
        <source>Its corner is not square: %L1 mm off. Starting again may be better.</source>
        <translation>Ihre Ecke ist nicht rechtwinklig: %L1 mm daneben. Neu beginnen ist wohl besser.</translation>
    </message>
    <message>
        <source>The device does not answer. Check its cable and power.</source>
        <translation>Das Gerät antwortet nicht. Prüfen Sie Kabel und Strom.</translation>
    </message>
    <message>
        <source>The pen is at %L1, %L2, %L3 mm.</source>
        <translation>Der Stift ist bei %L1, %L2, %L3 mm.</translation>
    </message>
    <message>
        <source>The pen is %L1 mm above the drawing plane.</source>
        <translation>Der Stift ist %L1 mm über der Zeichenebene.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Canvas</name>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>The sheet to draw on</source>
        <translation>Das Blatt, auf dem man zeichnet</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>Pressure is seen.</source>
        <translation>Druck wird erkannt.</translation>
    </message>
    <message>
        <source>No pressure seen yet: a mouse draws lines of even width.</source>
        <translation>Noch kein Druck erkannt: die Maus zeichnet gleich breite Linien.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Right button: %1</source>
        <translation>Rechte Taste: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CanvasPage</name>
    <message>
        <source>Show the &amp;force as an arrow</source>
        <translation>Die &amp;Kraft als Pfeil zeigen</translation>
    </message>
    <message>
        <source>At the nib: which way it pushes, and how strong it is</source>
        <translation>An der Spitze: wohin sie drückt und wie stark</translation>
    </message>
    <message>
        <source>The &amp;nib gives way to forces</source>
        <translation>Die &amp;Spitze gibt Kräften nach</translation>
    </message>
    <message>
        <source>With a mouse or a tablet, forces are seen in how the nib moves</source>
        <translation>Mit Maus oder Tablett sieht man Kräfte daran, wie die Spitze sich bewegt</translation>
    </message>
    <message>
        <source>Dry ink shows the &amp;grain of the sheet</source>
        <translation>Trockene Tinte zeigt die K&amp;örnung des Blatts</translation>
    </message>
    <message>
        <source>As chalk does; exported outlines stay as they are</source>
        <translation>Wie Kreide; exportierte Umrisse bleiben, wie sie sind</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ClipboardActions</name>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>Move the selected strokes to the clipboard</source>
        <translation>Die ausgewählten Linien in die Zwischenablage legen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected strokes, or all</source>
        <translation>Die ausgewählten Linien kopieren, oder alle</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Add the strokes of the clipboard</source>
        <translation>Die Linien der Zwischenablage hinzufügen</translation>
    </message>
    <message>
        <source>Copy as &amp;SVG</source>
        <translation>Als &amp;SVG kopieren</translation>
    </message>
    <message>
        <source>Copy the selected strokes, or all, as an SVG drawing</source>
        <translation>Die ausgewählten Linien oder alle als SVG kopieren</translation>
    </message>
    <message>
        <source>Copy as &amp;picture</source>
        <translation>Als &amp;Bild kopieren</translation>
    </message>
    <message>
        <source>Copy the selected strokes, or all, as a picture</source>
        <translation>Die ausgewählten Linien oder alle als Bild kopieren</translation>
    </message>
    <message>
        <source>Only whole strokes can be cut: select all of a stroke.</source>
        <translation>Nur ganze Linien lassen sich ausschneiden: wählen Sie eine ganze aus.</translation>
    </message>
    <message>
        <source>The clipboard cannot be pasted</source>
        <translation>Die Zwischenablage lässt sich nicht einfügen</translation>
    </message>
    <message>
        <source>The clipboard holds no strokes.</source>
        <translation>Die Zwischenablage enthält keine Linien.</translation>
    </message>
    <message>
        <source>the clipboard</source>
        <translation>der Zwischenablage</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ColorWell</name>
    <message>
        <source>Colour of the ink</source>
        <translation>Farbe der Tinte</translation>
    </message>
    <message>
        <source>Colour of the ink: %1</source>
        <translation>Farbe der Tinte: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ColorsPanel</name>
    <message>
        <source>Recent colours</source>
        <translation>Letzte Farben</translation>
    </message>
    <message>
        <source>Colours of the palette</source>
        <translation>Farben der Palette</translation>
    </message>
    <message>
        <source>Colour of new lines</source>
        <translation>Farbe neuer Linien</translation>
    </message>
    <message>
        <source>Number of the colour</source>
        <translation>Nummer der Farbe</translation>
    </message>
    <message>
        <source>The colour as #rrggbb; #rgb and #rrggbbaa do as well</source>
        <translation>Die Farbe als #rrggbb; auch #rgb und #rrggbbaa gehen</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity: 0 % is see-through</source>
        <translation>Deckkraft: 0 % ist durchsichtig</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>Paletten</translation>
    </message>
    <message>
        <source>The palette below</source>
        <translation>Die Palette darunter</translation>
    </message>
    <message>
        <source>Keep this colour in a palette of your own</source>
        <translation>Diese Farbe in einer eigenen Palette behalten</translation>
    </message>
    <message>
        <source>&amp;Open a palette…</source>
        <translation>Palette ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Export this palette…</source>
        <translation>Diese Palette &amp;exportieren …</translation>
    </message>
    <message>
        <source>Take the &amp;colour out of your own</source>
        <translation>Farbe aus der eigenen &amp;herausnehmen</translation>
    </message>
    <message>
        <source>Faint on this paper: %1:1</source>
        <translation>Blass auf diesem Papier: %1:1</translation>
    </message>
    <message>
        <source>Contrast with paper %1:1</source>
        <translation>Kontrast zum Papier %1:1</translation>
    </message>
    <message>
        <source>My colours</source>
        <translation>Meine Farben</translation>
    </message>
    <message>
        <source>Open a palette</source>
        <translation>Palette öffnen</translation>
    </message>
    <message>
        <source>Palettes (*.gpl)</source>
        <translation>Paletten (*.gpl)</translation>
    </message>
    <message>
        <source>Export the palette</source>
        <translation>Palette exportieren</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CuePlayer</name>
    <message>
        <source>%1 is gone. It plays again when it is back.</source>
        <translation>%1 ist weg. Es spielt wieder, sobald es zurück ist.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceCare</name>
    <message>
        <source>Find its &amp;home…</source>
        <translation>&amp;Ausgangslage suchen …</translation>
    </message>
    <message>
        <source>&amp;Use it again</source>
        <translation>Wieder &amp;benutzen</translation>
    </message>
    <message>
        <source>Plugged in again it is used again, without forces at first.</source>
        <translation>Wieder angesteckt wird es wieder benutzt, zunächst ohne Kräfte.</translation>
    </message>
    <message>
        <source>%1 is in use in another window.</source>
        <translation>%1 wird in einem anderen Fenster benutzt.</translation>
    </message>
    <message>
        <source>%1 does not open.</source>
        <translation>%1 lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>Noch einmal &amp;versuchen</translation>
    </message>
    <message>
        <source>%1 is there. It must find its home before it is used.</source>
        <translation>%1 ist da. Vor dem Benutzen muss es seine Ausgangslage finden.</translation>
    </message>
    <message>
        <source>%1 is in use. Its forces are off until you switch them on.</source>
        <translation>%1 wird benutzt. Seine Kräfte sind aus, bis Sie sie einschalten.</translation>
    </message>
    <message>
        <source>Switch &amp;forces on</source>
        <translation>Kräfte &amp;einschalten</translation>
    </message>
    <message>
        <source>Message from %1: %2</source>
        <translation>Meldung von %1: %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceNotice</name>
    <message>
        <source>What the device itself says</source>
        <translation>Was das Gerät selbst sagt</translation>
    </message>
    <message>
        <source>The device says: %1</source>
        <translation>Das Gerät sagt: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DevicePage</name>
    <message>
        <source>Feels pressure, if the pen does. No motors.</source>
        <translation>Erkennt Druck, wenn der Stift es tut. Keine Motoren.</translation>
    </message>
    <message>
        <source>No motors.</source>
        <translation>Keine Motoren.</translation>
    </message>
    <message>
        <source>Pushes with up to %L1 N, for long with %L2 N. Loop of %L3 Hz.</source>
        <translation>Drückt mit bis zu %L1 N, auf Dauer mit %L2 N. Schleife mit %L3 Hz.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>No force is ever larger than this, whatever a tool asks for</source>
        <translation>Keine Kraft ist je größer, was auch immer ein Werkzeug verlangt</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>&amp;Largest force</source>
        <translation>&amp;Größte Kraft</translation>
    </message>
    <message>
        <source>Forces stay off until you switch them on.</source>
        <translation>Die Kräfte bleiben aus, bis Sie sie einschalten.</translation>
    </message>
    <message>
        <source>&amp;Use this device</source>
        <translation>Dieses Gerät &amp;benutzen</translation>
    </message>
    <message>
        <source>Vibrations</source>
        <translation>Vibrationen</translation>
    </message>
    <message>
        <source>A haptic pen, mouse, touchpad or game controller that hums and ticks with what you draw, whatever the pen is</source>
        <translation>Ein haptischer Stift, eine Maus, ein Touchpad oder ein Spielregler, der mit der Zeichnung summt und tickt, gleich welcher Stift zeichnet</translation>
    </message>
    <message>
        <source>&amp;Vibrations</source>
        <translation>&amp;Vibrationen</translation>
    </message>
    <message>
        <source>In use; %1</source>
        <translation>Benutzt; %1</translation>
    </message>
    <message>
        <source>In use, forces off</source>
        <translation>Benutzt, Kräfte aus</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>Benutzt</translation>
    </message>
    <message>
        <source>Not connected; used again when it is</source>
        <translation>Nicht angeschlossen; wird wieder benutzt, sobald es das ist</translation>
    </message>
    <message>
        <source>In use in another window</source>
        <translation>In einem anderen Fenster benutzt</translation>
    </message>
    <message>
        <source>Its software is here; whether it is connected shows when it is used</source>
        <translation>Seine Software ist da; ob es angeschlossen ist, zeigt sich beim Benutzen</translation>
    </message>
    <message>
        <source>Connected; its settings cannot be read</source>
        <translation>Angeschlossen; seine Einstellungen sind nicht lesbar</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Angeschlossen</translation>
    </message>
    <message>
        <source>Connected; its drawing plane is not set yet</source>
        <translation>Angeschlossen; seine Zeichenebene ist noch nicht festgelegt</translation>
    </message>
    <message>
        <source>Another haptic device…</source>
        <translation>Ein anderes haptisches Gerät …</translation>
    </message>
    <message>
        <source>A haptic device…</source>
        <translation>Ein haptisches Gerät …</translation>
    </message>
    <message>
        <source>Not here? See what is missing, step by step</source>
        <translation>Nicht dabei? Schritt für Schritt sehen, was fehlt</translation>
    </message>
    <message>
        <source>Mend that line, or remove the file.</source>
        <translation>Diese Zeile berichtigen oder die Datei entfernen.</translation>
    </message>
    <message>
        <source>Look at its cable and its power.</source>
        <translation>Kabel und Stromversorgung prüfen.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1 (nicht angeschlossen)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceSettings</name>
    <message>
        <source>&amp;Set the drawing plane…</source>
        <translation>&amp;Zeichenebene festlegen …</translation>
    </message>
    <message>
        <source>Fit to the s&amp;heet</source>
        <translation>An das &amp;Blatt anpassen</translation>
    </message>
    <message>
        <source>Name of the device</source>
        <translation>Name des Geräts</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>The hand that holds it</source>
        <translation>Die Hand, die es hält</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>No force is ever larger than this, whatever a tool asks for</source>
        <translation>Keine Kraft ist je größer, was auch immer ein Werkzeug verlangt</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>as it can</source>
        <translation>was es kann</translation>
    </message>
    <message>
        <source> N/m</source>
        <translation> N/m</translation>
    </message>
    <message>
        <source>Lower it where the sheet hums or trembles under the pen</source>
        <translation>Senken, wenn das Blatt unter dem Stift brummt oder zittert</translation>
    </message>
    <message>
        <source>Stiffest sheet</source>
        <translation>Steifstes Blatt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>100 %: a millimetre of the hand is one of the sheet. 200 %: it is two, and the hand has half the way.</source>
        <translation>100 %: ein Millimeter der Hand ist einer auf dem Blatt. 200 %: es sind zwei, und die Hand hat den halben Weg.</translation>
    </message>
    <message>
        <source>Size of a movement on the sheet</source>
        <translation>Größe einer Bewegung auf dem Blatt</translation>
    </message>
    <message>
        <source>The middle of the drawing area on the middle of the sheet, and so large that the whole sheet can be reached</source>
        <translation>Die Mitte der Zeichenfläche auf der Mitte des Blatts und so groß, dass das ganze Blatt erreichbar ist</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Hand</source>
        <translation>&amp;Hand</translation>
    </message>
    <message>
        <source>&amp;Largest force</source>
        <translation>&amp;Größte Kraft</translation>
    </message>
    <message>
        <source>S&amp;tiffest sheet</source>
        <translation>&amp;Steifstes Blatt</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>Zeichenebene</translation>
    </message>
    <message>
        <source>S&amp;ize on the sheet</source>
        <translation>Größe au&amp;f dem Blatt</translation>
    </message>
    <message>
        <source>Not set yet: as such a device usually stands.</source>
        <translation>Noch nicht festgelegt: so, wie ein solches Gerät meist steht.</translation>
    </message>
    <message>
        <source>Set: %L1 × %L2 mm.</source>
        <translation>Festgelegt: %L1 × %L2 mm.</translation>
    </message>
    <message>
        <source>Set.</source>
        <translation>Festgelegt.</translation>
    </message>
    <message>
        <source>Each hand has a drawing plane of its own: for the other one the device stands on the other side</source>
        <translation>Jede Hand hat ihre eigene Zeichenebene: für die andere steht das Gerät auf der anderen Seite</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DoctorDialog</name>
    <message>
        <source>Setting up a haptic device</source>
        <translation>Ein haptisches Gerät einrichten</translation>
    </message>
    <message>
        <source>A device pushes your hand only once its maker&apos;s software is installed and you may use its port. Feltline has looked at this computer. Work from the top down; a line with a dash is of a device that you may not own, and needs nothing.</source>
        <translation>Ein Gerät schiebt die Hand erst, wenn die Software seines Herstellers installiert ist und Sie seinen Anschluss benutzen dürfen. Feltline hat diesen Rechner untersucht. Arbeiten Sie von oben nach unten; eine Zeile mit Strich betrifft ein Gerät, das Sie vielleicht nicht besitzen, und braucht nichts.</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>&amp;Noch einmal nachsehen</translation>
    </message>
    <message>
        <source>&amp;Copy all</source>
        <translation>Alles &amp;kopieren</translation>
    </message>
    <message>
        <source>As plain text, to ask somebody who knows</source>
        <translation>Als einfacher Text, um jemanden zu fragen, der sich auskennt</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Wird nachgesehen …</translation>
    </message>
    <message>
        <source>This build of Feltline has no drivers.</source>
        <translation>Dieses Feltline wurde ohne Treiber gebaut.</translation>
    </message>
    <message>
        <source>Nothing to say.</source>
        <translation>Nichts zu sagen.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ExportDialog</name>
    <message>
        <source>With the &amp;paper’s colour</source>
        <translation>Mit der Farbe des &amp;Papiers</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>Das Blatt</translation>
    </message>
    <message>
        <source>The ink only</source>
        <translation>Nur die Tinte</translation>
    </message>
    <message>
        <source> dots per inch</source>
        <translation> Punkte pro Zoll</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>&amp;Show:</source>
        <translation>&amp;Zeigen:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>&amp;Auflösung:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Größe:</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>All strokes, exactly</source>
        <translation>Alle Linien, genau</translation>
    </message>
    <message>
        <source>Keeps:</source>
        <translation>Bewahrt:</translation>
    </message>
    <message>
        <source>&amp;Grain of the sheet in dry ink</source>
        <translation>&amp;Körnung des Blattes in trockener Tinte</translation>
    </message>
    <message>
        <source>As on the screen. Lines stay lines: other programs show them through a picture of the grain</source>
        <translation>Wie auf dem Bildschirm. Linien bleiben Linien: Andere Programme zeigen sie durch ein Bild der Körnung</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FeelPanel</name>
    <message>
        <source>Strength of all forces</source>
        <translation>Stärke aller Kräfte</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Strength of all forces in per cent</source>
        <translation>Stärke aller Kräfte in Prozent</translation>
    </message>
    <message>
        <source>&amp;Strength</source>
        <translation>&amp;Stärke</translation>
    </message>
    <message>
        <source>Sh&amp;eet</source>
        <translation>Bla&amp;tt</translation>
    </message>
    <message>
        <source>Stop forces</source>
        <translation>Kräfte anhalten</translation>
    </message>
    <message>
        <source>Switch forces on</source>
        <translation>Kräfte einschalten</translation>
    </message>
    <message>
        <source>No force, at once (Esc twice)</source>
        <translation>Keine Kraft, sofort (Esc zweimal)</translation>
    </message>
    <message>
        <source>Let the pen be pushed</source>
        <translation>Der Stift wird geschoben</translation>
    </message>
    <message>
        <source>Esc twice stops them too.</source>
        <translation>Auch Esc zweimal hält sie an.</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten …</translation>
    </message>
    <message>
        <source>Change what sheets and media feel, look and sound like</source>
        <translation>Ändern, wie Blätter und Zeichenmittel sich anfühlen, aussehen und klingen</translation>
    </message>
    <message>
        <source>Edit sheets and media</source>
        <translation>Blätter und Zeichenmittel bearbeiten</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FeltPlot</name>
    <message>
        <source>Plot of what a stroke of 40 mm feels like</source>
        <translation>Kurve dessen, was ein Strich von 40 mm fühlen lässt</translation>
    </message>
    <message>
        <source>%1 N of drag; the grain changes it by up to %2 N, which can be felt.</source>
        <translation>%1 N Reibung; die Körnung ändert sie um bis zu %2 N, was zu spüren ist.</translation>
    </message>
    <message>
        <source>%1 N of drag; it changes by up to %2 N, which nobody feels.</source>
        <translation>%1 N Reibung; sie ändert sich um bis zu %2 N, was niemand spürt.</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FileActions</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Begin another drawing</source>
        <translation>Eine andere Zeichnung beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a drawing from a file</source>
        <translation>Eine Zeichnung aus einer Datei öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the drawing to its file</source>
        <translation>Die Zeichnung in ihre Datei speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the drawing to another file</source>
        <translation>Die Zeichnung in eine andere Datei speichern</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren …</translation>
    </message>
    <message>
        <source>Add the strokes of another file to this drawing</source>
        <translation>Die Linien einer anderen Datei hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Leave the program</source>
        <translation>Das Programm beenden</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Ohne Namen</translation>
    </message>
    <message>
        <source>Open a drawing</source>
        <translation>Eine Zeichnung öffnen</translation>
    </message>
    <message>
        <source>“%1” cannot be opened</source>
        <translation>„%1“ lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>“%1” cannot be imported</source>
        <translation>„%1“ lässt sich nicht importieren</translation>
    </message>
    <message>
        <source>Import strokes</source>
        <translation>Linien importieren</translation>
    </message>
    <message>
        <source>Save the drawing</source>
        <translation>Die Zeichnung speichern</translation>
    </message>
    <message>
        <source>“%1” was not saved</source>
        <translation>„%1“ wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>%1
Your drawing is still here: save it to another place.</source>
        <translation>%1
Ihre Zeichnung ist noch da: speichern Sie sie anderswo.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Diese Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Recovered %1</source>
        <translation>%1 (gerettet)</translation>
    </message>
    <message>
        <source>No crash protection: save often</source>
        <translation>Kein Absturzschutz: oft speichern</translation>
    </message>
    <message>
        <source>What is needed for recovery cannot be written: %1</source>
        <translation>Was zum Retten nötig ist, lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>Crash protection in another place</source>
        <translation>Absturzschutz an anderem Ort</translation>
    </message>
    <message>
        <source>The drawing is kept for recovery in %1, because the usual place fails: %2</source>
        <translation>Die Zeichnung wird zum Retten in %1 aufgehoben, denn am üblichen Ort geht es nicht: %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FileDialogs</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Without saving, what you drew since the last save is lost.</source>
        <translation>Ohne Speichern geht verloren, was seitdem gezeichnet wurde.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Auf der Platte geändert</translation>
    </message>
    <message>
        <source>“%1” was changed by another program.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>Saving now replaces those changes by your drawing.</source>
        <translation>Speichern ersetzt diese Änderungen durch Ihre Zeichnung.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Damaged drawing</source>
        <translation>Beschädigte Zeichnung</translation>
    </message>
    <message>
        <source>“%1” is damaged.</source>
        <translation>„%1“ ist beschädigt.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) of it can be shown, as a new drawing; the file stays as it is.</source>
        <translation>
            <numerusform>%n Strich davon kann als neue Zeichnung gezeigt werden; die Datei bleibt, wie sie ist.</numerusform>
            <numerusform>%n Striche davon können als neue Zeichnung gezeigt werden; die Datei bleibt, wie sie ist.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Show what is left</source>
        <translation>Übriges &amp;zeigen</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ForceGraph</name>
    <message>
        <source>Plot of the forces of the last seconds</source>
        <translation>Diagramm der Kräfte der letzten Sekunden</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ForcePanel</name>
    <message>
        <source>%L1 µs</source>
        <translation>%L1 µs</translation>
    </message>
    <message>
        <source>The loop does not run.</source>
        <translation>Die Schleife läuft nicht.</translation>
    </message>
    <message>
        <source>Real-time scheduling.</source>
        <translation>Echtzeitbetrieb.</translation>
    </message>
    <message>
        <source>Raised priority, no real-time scheduling.</source>
        <translation>Höherer Vorrang, kein Echtzeitbetrieb.</translation>
    </message>
    <message>
        <source>Ordinary scheduling: late when the computer is busy.</source>
        <translation>Gewöhnlicher Betrieb: spät, wenn der Rechner beschäftigt ist.</translation>
    </message>
    <message>
        <source>The loop stands still: the device does not answer.</source>
        <translation>Die Schleife steht still: Das Gerät antwortet nicht.</translation>
    </message>
    <message>
        <source>The device&apos;s own software runs the loop.</source>
        <translation>Die Schleife läuft in der Software des Geräts.</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Forces by name</source>
        <translation>Kräfte nach Namen</translation>
    </message>
    <message>
        <source>Each force now and its largest value of the last seconds</source>
        <translation>Jede Kraft jetzt und ihr größter Wert der letzten Sekunden</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Hold the plot still</source>
        <translation>Das Diagramm anhalten</translation>
    </message>
    <message>
        <source>most, %L1 N</source>
        <translation>höchstens, %L1 N</translation>
    </message>
    <message>
        <source>for long, %L1 N</source>
        <translation>auf Dauer, %L1 N</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>The motors are warm, so forces are kept lower for a while.</source>
        <translation>Die Motoren sind warm, darum bleiben die Kräfte eine Weile kleiner.</translation>
    </message>
    <message>
        <source>Loop: %L1 Hz, missed ticks: %L2</source>
        <translation>Schleife: %L1 Hz, versäumte Takte: %L2</translation>
    </message>
    <message>
        <source>Late: %1 as a rule, 1 in 100 %2</source>
        <translation>Verspätung: meist %1, 1 von 100 %2</translation>
    </message>
    <message>
        <source>Motors: %L1 N on average</source>
        <translation>Motoren: im Mittel %L1 N</translation>
    </message>
    <message>
        <source>Work on the hand: %L1 mJ</source>
        <translation>Arbeit an der Hand: %L1 mJ</translation>
    </message>
    <message>
        <source>Asked: %L1 N, at most %L2 N of late. The table has each force.</source>
        <translation>Verlangt: %L1 N, zuletzt höchstens %L2 N. Die Tabelle nennt jede Kraft.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Formats</name>
    <message>
        <source>Feltline drawing</source>
        <translation>Feltline-Zeichnung</translation>
    </message>
    <message>
        <source>Everything, exactly.</source>
        <translation>Alles, genau.</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>The picture, for browsers, Inkscape and all that show SVG; Feltline reads lines, layers and page back exactly.</source>
        <translation>Das Bild, für Browser, Inkscape und alles, was SVG zeigt; Feltline liest Linien, Ebenen und Seite genau wieder ein.</translation>
    </message>
    <message>
        <source>InkML ink</source>
        <translation>InkML-Tinte</translation>
    </message>
    <message>
        <source>Lines and their pressure for programs that know ink; Feltline reads lines, layers and page back exactly.</source>
        <translation>Linien und ihr Druck für Programme, die Tinte kennen; Feltline liest Linien, Ebenen und Seite genau wieder ein.</translation>
    </message>
    <message>
        <source>Xournal++ notes</source>
        <translation>Xournal++-Notizen</translation>
    </message>
    <message>
        <source>Lines with their widths, in layers, for notes in Xournal++; curves become many short lines.</source>
        <translation>Linien mit ihren Breiten, in Ebenen, für Notizen in Xournal++; aus Kurven werden viele kurze Linien.</translation>
    </message>
    <message>
        <source>Strokes as lines of JSON</source>
        <translation>Striche als JSON-Zeilen</translation>
    </message>
    <message>
        <source>Every line that is seen, exactly, for programs and scripts; no layers and no sheet.</source>
        <translation>Jede sichtbare Linie, genau, für Programme und Skripte; keine Ebenen und kein Blatt.</translation>
    </message>
    <message>
        <source>PDF page</source>
        <translation>PDF-Seite</translation>
    </message>
    <message>
        <source>A page to read and print, sharp at any size; it cannot be opened again.</source>
        <translation>Eine Seite zum Lesen und Drucken, scharf in jeder Größe; sie kann nicht wieder geöffnet werden.</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>A picture of pixels at the resolution you choose; it cannot be opened again.</source>
        <translation>Ein Bild aus Pixeln in der gewählten Auflösung; es kann nicht wieder geöffnet werden.</translation>
    </message>
    <message>
        <source>All drawings</source>
        <translation>Alle Zeichnungen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::GeneralPage</name>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Another language is used from the next start on.</source>
        <translation>Eine andere Sprache gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Farbschema:</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Sprache:</translation>
    </message>
    <message>
        <source>At the start:</source>
        <translation>Beim Start:</translation>
    </message>
    <message>
        <source>&amp;Open the last drawing again</source>
        <translation>Die letzte Zeichnung &amp;wieder öffnen</translation>
    </message>
    <message>
        <source>Where no file is named</source>
        <translation>Wenn keine Datei genannt ist</translation>
    </message>
    <message>
        <source>So&amp;und of drawing</source>
        <translation>&amp;Ton beim Zeichnen</translation>
    </message>
    <message>
        <source>Hear the pen rub on the sheet</source>
        <translation>Den Stift auf dem Blatt reiben hören</translation>
    </message>
    <message>
        <source>Volume of the sound of drawing</source>
        <translation>Lautstärke des Tons beim Zeichnen</translation>
    </message>
    <message>
        <source>Sound:</source>
        <translation>Ton:</translation>
    </message>
    <message>
        <source>&amp;Volume:</source>
        <translation>La&amp;utstärke:</translation>
    </message>
</context>
<context>
    <name>felt::desktop::GuideDialog</name>
    <message>
        <source>Guide</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Draw, then correct</source>
        <translation>Zeichnen, dann verbessern</translation>
    </message>
    <message>
        <source>Draw with a pen or with the mouse. A line that is not right is not drawn again: pull it, push it, smooth it, make it broader. Every step can be undone.</source>
        <translation>Zeichnen Sie mit einem Stift oder der Maus. Eine Linie, die nicht stimmt, wird nicht neu gezeichnet: ziehen, schieben, glätten oder verbreitern Sie sie. Jeder Schritt lässt sich zurücknehmen.</translation>
    </message>
    <message>
        <source>A short press on a tool&apos;s key takes the tool. Hold the key while you use the tool, and the former one comes back when you let go.</source>
        <translation>Ein kurzer Druck auf die Taste eines Werkzeugs nimmt es. Wird sie beim Benutzen gehalten, kommt beim Loslassen das vorige zurück.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>The sheet</source>
        <translation>Das Blatt</translation>
    </message>
    <message>
        <source>The wheel zooms at the pointer. Hold Space and drag to move the sheet, with Shift to turn it. None of this changes the drawing.</source>
        <translation>Das Mausrad zoomt am Zeiger. Leertaste halten und ziehen verschiebt das Blatt, mit Umschalt dreht es sich. Nichts davon ändert die Zeichnung.</translation>
    </message>
    <message>
        <source>The feel</source>
        <translation>Das Gefühl</translation>
    </message>
    <message>
        <source>Every tool pushes back. With a force-feedback pen you feel it in your hand; with a tablet or a mouse you see it, as an arrow at the nib and in the panel Forces. Press Esc twice to switch all forces off at once.</source>
        <translation>Jedes Werkzeug gibt Widerstand. Mit einem Stift mit Kraftrückmeldung fühlen Sie ihn in der Hand; mit Tablett oder Maus sehen Sie ihn, als Pfeil an der Spitze und im Feld „Kräfte“. Zweimal Esc schaltet alle Kräfte sofort aus.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Drawings are kept as .felt files, with their layers and their history of pen pressure. Export gives SVG, PDF and PNG to other programs.</source>
        <translation>Zeichnungen liegen in .felt-Dateien, mit ihren Ebenen. Für andere Programme gibt es SVG, PDF und PNG.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HapticLoop</name>
    <message>
        <source>%1 stopped responding and was disconnected. Your drawing is safe. Restart Feltline to use it again.</source>
        <translation>%1 antwortet nicht mehr und wurde getrennt. Ihre Zeichnung ist sicher. Starten Sie Feltline neu, um es wieder zu benutzen.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HelpActions</name>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Anleitung</translation>
    </message>
    <message>
        <source>What the tools do, on one page</source>
        <translation>Was die Werkzeuge tun, auf einer Seite</translation>
    </message>
    <message>
        <source>&amp;Keys at a glance</source>
        <translation>&amp;Tasten im Überblick</translation>
    </message>
    <message>
        <source>All keys on one page, to search and to print</source>
        <translation>Alle Tasten auf einer Seite, zum Suchen und Drucken</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>&amp;Führung</translation>
    </message>
    <message>
        <source>Two minutes in which the program draws by itself</source>
        <translation>Zwei Minuten, in denen das Programm selbst zeichnet</translation>
    </message>
    <message>
        <source>Opens this drawing, made by the project&apos;s simulated hand</source>
        <translation>Öffnet diese Zeichnung der simulierten Hand</translation>
    </message>
    <message>
        <source>&amp;About Feltline</source>
        <translation>&amp;Über Feltline</translation>
    </message>
    <message>
        <source>Version, licence and what it is built on</source>
        <translation>Version, Lizenz und worauf es gebaut ist</translation>
    </message>
    <message>
        <source>From the tour</source>
        <translation>Aus der Tour</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HistoryModel</name>
    <message>
        <source>Earlier steps are forgotten</source>
        <translation>Frühere Schritte sind vergessen</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>%1, here</source>
        <translation>%1, hier</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, zurückgenommen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HistoryPanel</name>
    <message>
        <source>One step back</source>
        <translation>Ein Schritt zurück</translation>
    </message>
    <message>
        <source>One step forward</source>
        <translation>Ein Schritt vor</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HomingDialog</name>
    <message>
        <source>Bring %1 home</source>
        <translation>%1 in die Ausgangslage bringen</translation>
    </message>
    <message>
        <source>Finding home</source>
        <translation>Ausgangslage wird gesucht</translation>
    </message>
    <message>
        <source>Let it &amp;move</source>
        <translation>Es darf sich &amp;bewegen</translation>
    </message>
    <message>
        <source>It is &amp;there</source>
        <translation>Es ist &amp;dort</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Nicht jetzt</translation>
    </message>
    <message>
        <source>May its arm move by itself?</source>
        <translation>Darf sich der Arm von selbst bewegen?</translation>
    </message>
    <message>
        <source>%1 must find out where its arm is, and moves it for that: for some seconds, as far as it reaches, with the force that it needs. Let go of it, clear the space around it, and keep hair, sleeves and cups away. You can stop it at any time by its power switch.</source>
        <translation>%1 muss herausfinden, wo sein Arm ist, und bewegt ihn dazu: einige Sekunden lang, so weit er reicht, mit der Kraft, die er braucht. Lassen Sie ihn los, machen Sie ringsum Platz und halten Sie Haare, Ärmel und Tassen fern. Mit dem Netzschalter des Geräts lässt er sich jederzeit anhalten.</translation>
    </message>
    <message>
        <source>Bring the arm to its rest pose</source>
        <translation>Den Arm in die Ruhelage bringen</translation>
    </message>
    <message>
        <source>%1 takes the pose that it rests in as its home. Nothing moves by itself.</source>
        <translation>%1 nimmt die Lage, in der es ruht, als Ausgangslage. Nichts bewegt sich von selbst.</translation>
    </message>
    <message>
        <source>Put the stylus into the inkwell</source>
        <translation>Den Stift ins Tintenfass stecken</translation>
    </message>
    <message>
        <source>%1 finds out where it is while its stylus is in the inkwell, the hole in its foot. Nothing moves by itself.</source>
        <translation>%1 findet heraus, wo es ist, während sein Stift im Tintenfass steckt, dem Loch in seinem Fuß. Nichts bewegt sich von selbst.</translation>
    </message>
    <message>
        <source>It is moving: hands off</source>
        <translation>Es bewegt sich: Hände weg</translation>
    </message>
    <message>
        <source>One moment: hold it still</source>
        <translation>Einen Moment: still halten</translation>
    </message>
    <message>
        <source>It did not find its home. Try again.</source>
        <translation>Es hat seine Ausgangslage nicht gefunden. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>That did not work: %1</source>
        <translation>Das ging nicht: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HueStrip</name>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Hue. Arrow keys move it.</source>
        <translation>Farbton. Pfeiltasten bewegen ihn.</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
</context>
<context>
    <name>felt::desktop::KeyEdit</name>
    <message>
        <source>Press a key</source>
        <translation>Taste drücken</translation>
    </message>
</context>
<context>
    <name>felt::desktop::KeyboardPen</name>
    <message>
        <source>Cancelled, the pen is up</source>
        <translation>Abgebrochen, der Stift ist oben</translation>
    </message>
    <message>
        <source>The pen is down</source>
        <translation>Der Stift ist unten</translation>
    </message>
    <message>
        <source>The pen is up</source>
        <translation>Der Stift ist oben</translation>
    </message>
</context>
<context>
    <name>felt::desktop::LayersModel</name>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>unlocked</source>
        <translation>nicht gesperrt</translation>
    </message>
    <message>
        <source>, in use</source>
        <translation>, in Gebrauch</translation>
    </message>
    <message>
        <source>%1
Double-click to rename, drag to move</source>
        <translation>%1
Doppelklick benennt um, Ziehen verschiebt</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinte</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Ebene %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Add a layer</source>
        <translation>Eine Ebene hinzufügen</translation>
    </message>
    <message>
        <source>A new layer above this one</source>
        <translation>Eine neue Ebene über dieser</translation>
    </message>
    <message>
        <source>Raise the layer</source>
        <translation>Die Ebene nach oben</translation>
    </message>
    <message>
        <source>One place up</source>
        <translation>Einen Platz nach oben</translation>
    </message>
    <message>
        <source>Lower the layer</source>
        <translation>Die Ebene nach unten</translation>
    </message>
    <message>
        <source>One place down</source>
        <translation>Einen Platz nach unten</translation>
    </message>
    <message>
        <source>Remove the layer</source>
        <translation>Die Ebene entfernen</translation>
    </message>
    <message>
        <source>Removes the layer and what is drawn on it</source>
        <translation>Entfernt die Ebene und was darauf gezeichnet ist</translation>
    </message>
    <message>
        <source>All layers were hidden or locked: “%1” was added, so that there is one to draw on.</source>
        <translation>Alle Ebenen waren verborgen oder gesperrt: „%1“ kam dazu, damit es eine zum Zeichnen gibt.</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to draw there.</source>
        <translation>„%1“ ist gesperrt: zum Zeichnen dort entsperren.</translation>
    </message>
    <message>
        <source>“%1” is hidden: show it to draw there.</source>
        <translation>„%1“ ist verborgen: zum Zeichnen dort einblenden.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MainWindow</name>
    <message>
        <source>Shows or hides the panel %1</source>
        <translation>Zeigt oder verbirgt das Feld %1</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Gefühl</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>&amp;Hide all panels</source>
        <translation>Alle Bedienfelder &amp;verbergen</translation>
    </message>
    <message>
        <source>Leaves nothing but the sheet</source>
        <translation>Lässt nur das Blatt stehen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>The window fills the screen</source>
        <translation>Das Fenster füllt den Bildschirm</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Nächster &amp;Teil des Fensters</translation>
    </message>
    <message>
        <source>Moves the focus from the sheet to the tools, to each panel, and back</source>
        <translation>Bringt den Fokus vom Blatt zu den Werkzeugen, zu jedem Feld und zurück</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>Bedienfelder &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Puts panels and bars where they were at first</source>
        <translation>Stellt Bedienfelder und Leisten hin, wo sie zuerst waren</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Theme, language, pen, device and shortcuts</source>
        <translation>Farben, Sprache, Stift, Gerät und Tasten</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation>Schließt dieses Fenster</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Closes all windows</source>
        <translation>Schließt alle Fenster</translation>
    </message>
    <message>
        <source>These of your own materials could not be read:</source>
        <translation>Diese Ihrer eigenen Materialien konnten nicht gelesen werden:</translation>
    </message>
    <message>
        <source>Ma&amp;terials…</source>
        <translation>Ma&amp;terialien …</translation>
    </message>
    <message>
        <source>Change what sheets and media feel, look and sound like, and make your own</source>
        <translation>Ändern, wie Blätter und Zeichenmittel sich anfühlen, aussehen und klingen, und eigene machen</translation>
    </message>
    <message>
        <source>&amp;Compare materials A and B</source>
        <translation>Materialien A und B &amp;vergleichen</translation>
    </message>
    <message>
        <source>Feel, see and hear the other one of the two that the editor compares</source>
        <translation>Das andere der beiden fühlen, sehen und hören, die der Editor vergleicht</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (schreibgeschützt)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialDesk</name>
    <message>
        <source>Figures of %1</source>
        <translation>Werte von %1</translation>
    </message>
    <message>
        <source>Relief of a picture</source>
        <translation>Relief eines Bildes</translation>
    </message>
    <message>
        <source>Friction of a pair</source>
        <translation>Reibung eines Paares</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>%1, my own</source>
        <translation>%1, eigenes</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>Kopie von %1</translation>
    </message>
    <message>
        <source>Copy %1 to %2</source>
        <translation>%1 nach %2 kopieren</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Speichern als %1</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialEditor</name>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>S&amp;tart from:</source>
        <translation>&amp;Ausgehen von:</translation>
    </message>
    <message>
        <source>Take the figures of another one</source>
        <translation>Die Werte eines anderen nehmen</translation>
    </message>
    <message>
        <source>Sets all figures to those of another one; they can be changed then</source>
        <translation>Setzt alle Werte auf die eines anderen; sie lassen sich dann ändern</translation>
    </message>
    <message>
        <source>Figures of…</source>
        <translation>Werte von …</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Relief from a picture…</source>
        <translation>Relief aus einem Bild …</translation>
    </message>
    <message>
        <source>A PNG of 8 or 16 bits: white is high. It is fitted into a square of 32 widths of the grain, and repeats without a seam</source>
        <translation>Ein PNG mit 8 oder 16 Bit: Weiß ist hoch. Es wird in ein Quadrat von 32 Körnungsweiten eingepasst und wiederholt sich ohne Naht</translation>
    </message>
    <message>
        <source>Light, firm, hard</source>
        <translation>Leicht, fest, kräftig</translation>
    </message>
    <message>
        <source>What a stroke feels like</source>
        <translation>Wie ein Strich sich anfühlt</translation>
    </message>
    <message>
        <source>Hatched: changes below 0.04 N, which nobody feels.</source>
        <translation>Schraffiert: Änderungen unter 0,04 N, die niemand spürt.</translation>
    </message>
    <message>
        <source>What the pen feels now</source>
        <translation>Was der Stift jetzt fühlt</translation>
    </message>
    <message>
        <source>What comes of it</source>
        <translation>Was daraus wird</translation>
    </message>
    <message>
        <source>Comes with Feltline. A change makes a copy of your own.</source>
        <translation>Gehört zu Feltline. Eine Änderung macht eine eigene Kopie.</translation>
    </message>
    <message>
        <source>Your own, not saved. It is kept all the same.</source>
        <translation>Ihr eigenes, nicht gespeichert. Es bleibt trotzdem erhalten.</translation>
    </message>
    <message>
        <source>Your own, saved.</source>
        <translation>Ihr eigenes, gespeichert.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Compare: A = B</source>
        <translation>Vergleich: A = B</translation>
    </message>
    <message>
        <source>Compare: %1</source>
        <translation>Vergleich: %1</translation>
    </message>
    <message>
        <source>You feel, see and hear %1. Press B for %2.</source>
        <translation>Sie fühlen, sehen und hören %1. B drücken für %2.</translation>
    </message>
    <message>
        <source>Copy %1 to %2</source>
        <translation>%1 nach %2 kopieren</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>All figures as they were at first, or when last saved</source>
        <translation>Alle Werte wie am Anfang oder wie zuletzt gespeichert</translation>
    </message>
    <message>
        <source>The other one gets these figures</source>
        <translation>Das andere bekommt diese Werte</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save as a file of your own</source>
        <translation>Als eigene Datei speichern</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Save under another name, as your own</source>
        <translation>Unter einem anderen Namen als eigenes speichern</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen …</translation>
    </message>
    <message>
        <source>Another name</source>
        <translation>Ein anderer Name</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Takes it away, and its file; undo brings it back</source>
        <translation>Nimmt es und seine Datei weg; Rückgängig bringt beide zurück</translation>
    </message>
    <message>
        <source>%1 is deleted. Undo brings it back.</source>
        <translation>%1 ist gelöscht. Rückgängig bringt es zurück.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Take up a material of a file</source>
        <translation>Ein Material aus einer Datei aufnehmen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Write a file for others</source>
        <translation>Eine Datei für andere schreiben</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Weitere Befehle</translation>
    </message>
    <message>
        <source>Relief from a picture</source>
        <translation>Relief aus einem Bild</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Materials (*.toml)</source>
        <translation>Materialien (*.toml)</translation>
    </message>
    <message>
        <source>It is yours now, and not saved yet.</source>
        <translation>Es gehört jetzt Ihnen und ist noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>Comes with this drawing. A change makes a copy of your own.</source>
        <translation>Gehört zu dieser Zeichnung. Eine Änderung macht eine eigene Kopie.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialFieldsView</name>
    <message>
        <source>Another</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Another seed</source>
        <translation>Ein anderer Startwert</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>In the hand</source>
        <translation>In der Hand</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Körnung</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>To the eye</source>
        <translation>Für das Auge</translation>
    </message>
    <message>
        <source>To the ear</source>
        <translation>Für das Ohr</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialList</name>
    <message>
        <source>Sheets and media</source>
        <translation>Blätter und Zeichenmittel</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>My own sheets</source>
        <translation>Eigene Blätter</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>Zeichenmittel</translation>
    </message>
    <message>
        <source>My own media</source>
        <translation>Eigene Zeichenmittel</translation>
    </message>
    <message>
        <source>%1 • not saved</source>
        <translation>%1 • nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MediaPicker</name>
    <message>
        <source>What is drawn with</source>
        <translation>Womit gezeichnet wird</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MessageBar</name>
    <message>
        <source>&amp;Details</source>
        <translation>&amp;Einzelheiten</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::NoticeBar</name>
    <message>
        <source>What was left out or changed, and where</source>
        <translation>Was weggelassen oder geändert wurde, und wo</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>What became of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>How often</source>
        <translation>Wie oft</translation>
    </message>
    <message>
        <source>Not everything in “%1” could be taken as it is. Left out or changed: %2. The file itself is as it was.</source>
        <translation>Nicht alles in „%1“ ließ sich übernehmen, wie es ist. Weggelassen oder geändert: %2. Die Datei selbst ist unverändert.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OptionRow</name>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Zurück auf %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OptionsPanel</name>
    <message>
        <source>All options of this tool back to what they were at first</source>
        <translation>Alle Optionen dieses Werkzeugs wie am Anfang</translation>
    </message>
    <message>
        <source>Reset the tool</source>
        <translation>Werkzeug zurücksetzen</translation>
    </message>
    <message>
        <source>Options of the tool</source>
        <translation>Optionen des Werkzeugs</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Gefühl</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Options that are seldom needed</source>
        <translation>Optionen, die selten gebraucht werden</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OutputActions</name>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Pa&amp;ge setup…</source>
        <translation>&amp;Blatt einrichten …</translation>
    </message>
    <message>
        <source>Size, orientation and colour of the sheet</source>
        <translation>Größe, Lage und Farbe des Blatts</translation>
    </message>
    <message>
        <source>Print pre&amp;view…</source>
        <translation>Druck&amp;vorschau …</translation>
    </message>
    <message>
        <source>See what will be printed</source>
        <translation>Sehen, was gedruckt wird</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Print the sheet at its true size</source>
        <translation>Das Blatt in wahrer Größe drucken</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>“%1” was not exported</source>
        <translation>„%1“ wurde nicht exportiert</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation>Druckvorschau</translation>
    </message>
    <message>
        <source>Write the drawing as SVG, PDF, PNG or ink for other programs</source>
        <translation>Die Zeichnung als SVG, PDF, PNG oder Tinte für andere Programme schreiben</translation>
    </message>
    <message>
        <source>“%1” was exported.</source>
        <translation>„%1“ wurde exportiert.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OwnMaterials</name>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and stays as it is. Save yours under another name; the file can be imported.</source>
        <translation>%1 wurde von einem anderen Programm geändert und bleibt, wie es ist. Speichern Sie Ihres unter einem anderen Namen; die Datei lässt sich importieren.</translation>
    </message>
    <message>
        <source>It is for all users of this computer, and cannot be deleted here: %1</source>
        <translation>Es ist für alle Benutzer dieses Computers und lässt sich hier nicht löschen: %1</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and stays as it is. To lose it, delete the file.</source>
        <translation>%1 wurde von einem anderen Programm geändert und bleibt, wie es ist. Wer es nicht behalten will, löscht die Datei.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PageDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Portrait</source>
        <translation>&amp;Hochformat</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>&amp;Querformat</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keine</translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation>Blatt einrichten</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>No paper: transparent in exported pictures</source>
        <translation>Kein Papier: durchsichtig in exportierten Bildern</translation>
    </message>
    <message>
        <source>Colour of the paper</source>
        <translation>Farbe des Papiers</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>&amp;Breite:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>&amp;Höhe:</translation>
    </message>
    <message>
        <source>Orientation:</source>
        <translation>Lage:</translation>
    </message>
    <message>
        <source>Paper:</source>
        <translation>Papier:</translation>
    </message>
    <message>
        <source>No paper</source>
        <translation>Kein Papier</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PairTable</name>
    <message>
        <source>Friction on each sheet</source>
        <translation>Reibung auf jedem Blatt</translation>
    </message>
    <message>
        <source>Bold numbers are the medium&apos;s own for that sheet</source>
        <translation>Fette Zahlen sind die eigenen des Zeichenmittels auf diesem Blatt</translation>
    </message>
    <message>
        <source>Double-click a number, or press F2, to set the friction on that sheet</source>
        <translation>Eine Zahl doppelt anklicken oder F2 drücken, um die Reibung auf diesem Blatt zu setzen</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>By the rule</source>
        <translation>Nach der Regel</translation>
    </message>
    <message>
        <source>Friction of the medium times that of the sheet, again</source>
        <translation>Wieder die Reibung des Zeichenmittels mal die des Blattes</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PenInput</name>
    <message>
        <source>Pressure is switched off.</source>
        <translation>Druck ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>Your pen&apos;s pressure is seen.</source>
        <translation>Der Druck Ihres Stifts wird erkannt.</translation>
    </message>
    <message>
        <source>Your pen senses no pressure.</source>
        <translation>Ihr Stift erkennt keinen Druck.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PenTestArea</name>
    <message>
        <source>Test area</source>
        <translation>Probefläche</translation>
    </message>
    <message>
        <source>Scribble here to try the pen; nothing of it is kept.</source>
        <translation>Hier kritzeln, um den Stift zu probieren; nichts davon bleibt.</translation>
    </message>
    <message>
        <source>Scribble here to try your pen</source>
        <translation>Hier kritzeln, um den Stift zu probieren</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PensPage</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>&amp;Pressing harder draws wider</source>
        <translation>Fester &amp;drücken zeichnet breiter</translation>
    </message>
    <message>
        <source>Off: every line has the same width, however hard you press.</source>
        <translation>Aus: jede Linie ist gleich breit, wie fest Sie auch drücken.</translation>
    </message>
    <message>
        <source>&amp;Soft</source>
        <translation>&amp;Weich</translation>
    </message>
    <message>
        <source>Feel, from soft to firm</source>
        <translation>Gefühl, von weich bis fest</translation>
    </message>
    <message>
        <source>Soft: a light hand draws wide. Firm: press harder for the same width.</source>
        <translation>Weich: eine leichte Hand zeichnet breit. Fest: fester drücken für dieselbe Breite.</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>&amp;Touches from</source>
        <translation>&amp;Berührt ab</translation>
    </message>
    <message>
        <source>Pressure from which the pen touches</source>
        <translation>Druck, ab dem der Stift berührt</translation>
    </message>
    <message>
        <source>For a pen that draws before it is pressed.</source>
        <translation>Für einen Stift, der zeichnet, bevor er gedrückt wird.</translation>
    </message>
    <message>
        <source>&amp;Straight again</source>
        <translation>Wieder &amp;gerade</translation>
    </message>
    <message>
        <source>The curve that it came with.</source>
        <translation>Die ursprüngliche Kurve.</translation>
    </message>
    <message>
        <source>Pressure after the curve</source>
        <translation>Druck nach der Kurve</translation>
    </message>
    <message>
        <source>pen %1, line %2</source>
        <translation>Stift %1, Linie %2</translation>
    </message>
    <message>
        <source>Charcoal, chalk and pencils draw broader with a pen that leans, where it can say so.</source>
        <translation>Kohle, Kreide und Bleistifte zeichnen breiter, wenn der Stift sich neigt, sofern er das sagen kann.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Wischen</translation>
    </message>
    <message>
        <source>Takes what was scribbled away.</source>
        <translation>Nimmt das Gekritzel weg.</translation>
    </message>
    <message>
        <source>Buttons, mouse and touch</source>
        <translation>Tasten, Maus und Berührung</translation>
    </message>
    <message>
        <source>Pen, &amp;lower button:</source>
        <translation>Stift, &amp;untere Taste:</translation>
    </message>
    <message>
        <source>Lower button of the pen</source>
        <translation>Untere Taste des Stifts</translation>
    </message>
    <message>
        <source>Pen, &amp;upper button:</source>
        <translation>Stift, &amp;obere Taste:</translation>
    </message>
    <message>
        <source>Upper button of the pen</source>
        <translation>Obere Taste des Stifts</translation>
    </message>
    <message>
        <source>Mouse, &amp;right button:</source>
        <translation>Maus, &amp;rechte Taste:</translation>
    </message>
    <message>
        <source>Right button of the mouse</source>
        <translation>Rechte Maustaste</translation>
    </message>
    <message>
        <source>Width of lines by mouse</source>
        <translation>Linienbreite mit der Maus</translation>
    </message>
    <message>
        <source>The same all along</source>
        <translation>Überall gleich</translation>
    </message>
    <message>
        <source>Thinner when fast</source>
        <translation>Schnell ist dünner</translation>
    </message>
    <message>
        <source>&amp;Mouse, width of lines:</source>
        <translation>&amp;Maus, Linienbreite:</translation>
    </message>
    <message>
        <source>What one finger does</source>
        <translation>Was ein Finger tut</translation>
    </message>
    <message>
        <source>Moves the sheet</source>
        <translation>Verschiebt das Blatt</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>Zeichnet</translation>
    </message>
    <message>
        <source>Nothing: touch is off</source>
        <translation>Nichts: Berührung ist aus</translation>
    </message>
    <message>
        <source>Two fingers move, zoom and turn the sheet. While the pen is near, touch is ignored.</source>
        <translation>Zwei Finger verschieben, zoomen und drehen das Blatt. Ist der Stift nah, zählt Berührung nicht.</translation>
    </message>
    <message>
        <source>One f&amp;inger:</source>
        <translation>Ein &amp;Finger:</translation>
    </message>
    <message>
        <source>mouse, line %1</source>
        <translation>Maus, Linie %1</translation>
    </message>
    <message>
        <source>The pen leans by %L1°</source>
        <translation>Der Stift ist um %L1° geneigt</translation>
    </message>
    <message>
        <source>How far the pen leans is not known</source>
        <translation>Wie weit der Stift geneigt ist, ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages of the preferences</source>
        <translation>Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PressureCurveEditor</name>
    <message>
        <source>Pressure curve</source>
        <translation>Druckkurve</translation>
    </message>
    <message>
        <source>From the pen&apos;s pressure, left to right, to the line&apos;s width, bottom to top. The arrow keys move a handle, Space takes the other one.</source>
        <translation>Vom Druck des Stifts, links nach rechts, zur Breite der Linie, unten nach oben. Pfeiltasten bewegen einen Griff, die Leertaste nimmt den anderen.</translation>
    </message>
    <message>
        <source>Drag the two handles. Higher is wider.</source>
        <translation>Ziehen Sie die beiden Griffe. Höher ist breiter.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::RecoveryDialog</name>
    <message>
        <source>Untitled</source>
        <translation>Ohne Namen</translation>
    </message>
    <message>
        <source>Recover drawings</source>
        <translation>Zeichnungen retten</translation>
    </message>
    <message>
        <source>Feltline did not close in order. This was not saved:</source>
        <translation>Feltline wurde nicht ordentlich beendet. Das war nicht gespeichert:</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Keep them, and ask again at the next start</source>
        <translation>Behalten und beim nächsten Start wieder fragen</translation>
    </message>
    <message>
        <source>Recover “%1”</source>
        <translation>„%1“ retten</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen …</translation>
    </message>
    <message>
        <source>Throw “%1” away</source>
        <translation>„%1“ wegwerfen</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Wegwerfen</translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
        <translation>Das lässt sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>%1, one line</source>
        <translation>%1, eine Linie</translation>
    </message>
    <message>
        <source>%1, %2 lines</source>
        <translation>%1, %2 Linien</translation>
    </message>
    <message>
        <source>It was never saved</source>
        <translation>Sie wurde nie gespeichert</translation>
    </message>
    <message>
        <source>The file cannot be read</source>
        <translation>Die Datei ist nicht lesbar</translation>
    </message>
    <message>
        <source>The file is no longer there</source>
        <translation>Die Datei ist nicht mehr da</translation>
    </message>
    <message>
        <source>Picture of the recovered drawing</source>
        <translation>Bild der geretteten Zeichnung</translation>
    </message>
    <message>
        <source>Picture of the saved file</source>
        <translation>Bild der gespeicherten Datei</translation>
    </message>
    <message>
        <source>⚠ Not all of it could be read.</source>
        <translation>⚠ Nicht alles davon war lesbar.</translation>
    </message>
    <message>
        <source>Recover as a new drawing</source>
        <translation>Als neue Zeichnung retten</translation>
    </message>
    <message>
        <source>Open the saved one</source>
        <translation>Gespeicherte öffnen</translation>
    </message>
    <message>
        <source>Open “%1” as it was saved</source>
        <translation>„%1“ öffnen, wie sie gespeichert wurde</translation>
    </message>
    <message>
        <source>What was not saved is kept, and offered again at the next start</source>
        <translation>Was nicht gespeichert wurde, bleibt erhalten und wird beim nächsten Start wieder angeboten</translation>
    </message>
    <message>
        <source>Throw away what was not saved of “%1”?</source>
        <translation>Wegwerfen, was von „%1“ nicht gespeichert wurde?</translation>
    </message>
    <message>
        <source>It cannot be brought back. The file stays as it is.</source>
        <translation>Es lässt sich nicht zurückholen. Die Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Recovered</source>
        <translation>Gerettet</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShadeField</name>
    <message>
        <source>Saturation and brightness</source>
        <translation>Sättigung und Helligkeit</translation>
    </message>
    <message>
        <source>Across: saturation. Up: brightness. Arrow keys move it.</source>
        <translation>Quer: Sättigung. Aufwärts: Helligkeit. Pfeiltasten bewegen sie.</translation>
    </message>
    <message>
        <source>Saturation %1 %, brightness %2 %</source>
        <translation>Sättigung %1 %, Helligkeit %2 %</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShortcutSheet</name>
    <message>
        <source>Keys at a glance</source>
        <translation>Tasten im Überblick</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the keys</source>
        <translation>Tasten suchen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>No key does that.</source>
        <translation>Das tut keine Taste.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShortcutsPage</name>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Take it over</source>
        <translation>&amp;Übernehmen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Alle zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Key:</source>
        <translation>&amp;Taste:</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Alle Tasten zurücksetzen</translation>
    </message>
    <message>
        <source>Give every command the key that it came with?</source>
        <translation>Jedem Befehl seine ursprüngliche Taste geben?</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 gehört zu „%2“.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SizeField</name>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of a line drawn with the mouse, or size of the current tool. Press [ or ] to change it.</source>
        <translation>Breite einer mit der Maus gezeichneten Linie oder Größe des aktuellen Werkzeugs. [ und ] ändern sie.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SoundState</name>
    <message>
        <source>There is no sound device now, so nothing is heard. It is heard once there is one.</source>
        <translation>Es gibt gerade kein Tongerät, daher ist nichts zu hören. Sobald es eines gibt, ist es zu hören.</translation>
    </message>
    <message>
        <source>This program was built without sound.</source>
        <translation>Dieses Programm wurde ohne Ton gebaut.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::StabilitySign</name>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
</context>
<context>
    <name>felt::desktop::StatusLine</name>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Place of the pen</source>
        <translation>Ort des Stifts</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Pressure %1</source>
        <translation>Druck %1</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Turn of the view</source>
        <translation>Drehung der Ansicht</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>State of the file</source>
        <translation>Stand der Datei</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>%1, forces off</source>
        <translation>%1, Kräfte aus</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, %L2 Hz</source>
        <translation>%1, %L2 Hz</translation>
    </message>
</context>
<context>
    <name>felt::desktop::StrokePreview</name>
    <message>
        <source>Three strokes: light, firm, hard</source>
        <translation>Drei Striche: leicht, fest, kräftig</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Studio</name>
    <message>
        <source>This drawing has its own figures for: %1. Yours stay as they are.</source>
        <translation>Diese Zeichnung hat eigene Werte für: %1. Die Ihren bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>The sheet “%1” is not known here: it feels as the one before.</source>
        <translation>Das Blatt „%1“ ist hier nicht bekannt: Es fühlt sich an wie das vorige.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TestPad</name>
    <message>
        <source>Test pad</source>
        <translation>Probefläche</translation>
    </message>
    <message>
        <source>Press here with pen or mouse to try the device</source>
        <translation>Hier mit Stift oder Maus drücken, um das Gerät zu probieren</translation>
    </message>
    <message>
        <source>Try this device on the sheet itself.</source>
        <translation>Probieren Sie dieses Gerät auf dem Blatt selbst.</translation>
    </message>
    <message>
        <source>Press here and feel</source>
        <translation>Hier drücken und fühlen</translation>
    </message>
    <message>
        <source>Force %L1 N</source>
        <translation>Kraft %L1 N</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>in hand while the key is held</source>
        <translation>in der Hand, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>comes back when the key is let go</source>
        <translation>kommt zurück, wenn die Taste losgelassen wird</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>in der Hand</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ToolKeys</name>
    <message>
        <source>&amp;Eraser while held</source>
        <translation>&amp;Radierer, solange gehalten</translation>
    </message>
    <message>
        <source>The eraser as long as the key is held; the pencil where the eraser is in hand</source>
        <translation>Der Radierer, solange die Taste gehalten wird; der Bleistift, wenn der Radierer in der Hand ist</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TopBar</name>
    <message>
        <source>Top bar</source>
        <translation>Obere Leiste</translation>
    </message>
    <message>
        <source>Sheet:</source>
        <translation>Blatt:</translation>
    </message>
    <message>
        <source>Material of the sheet</source>
        <translation>Material des Blatts</translation>
    </message>
    <message>
        <source>What the sheet feels and looks like</source>
        <translation>Wie sich das Blatt anfühlt und aussieht</translation>
    </message>
    <message>
        <source>What is drawn with</source>
        <translation>Womit gezeichnet wird</translation>
    </message>
    <message>
        <source>What the pen is made of: how it looks, feels and sounds</source>
        <translation>Woraus der Stift ist: wie er aussieht, sich anfühlt und klingt</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Größe:</translation>
    </message>
    <message>
        <source>Medium:</source>
        <translation>Zeichenmittel:</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TourWindow</name>
    <message>
        <source>Guided tour</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>The sheet of the tour</source>
        <translation>Das Blatt der Führung</translation>
    </message>
    <message>
        <source>How much of the tour was seen</source>
        <translation>Wie viel von der Führung zu sehen war</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>Try it yourself</source>
        <translation>Versuchen Sie es selbst</translation>
    </message>
    <message>
        <source>Draw with a pen or with the mouse. Press ? for the keys. Nothing can go wrong: Ctrl+Z takes everything back.</source>
        <translation>Zeichnen Sie mit einem Stift oder der Maus. ? zeigt die Tasten. Nichts kann schiefgehen: Strg+Z nimmt alles zurück.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Weiterspielen</translation>
    </message>
    <message>
        <source>&amp;Try it yourself</source>
        <translation>Selbst &amp;versuchen</translation>
    </message>
</context>
<context>
    <name>tools</name>
    <message>
        <source>A line drawn round what is to be selected, or a rectangle from corner to corner.</source>
        <translation>Eine Linie um das, was ausgewählt wird, oder ein Rechteck von Ecke zu Ecke.</translation>
    </message>
    <message>
        <source>Lines farther from the pen than this cannot be grabbed.</source>
        <translation>Eine Linie, die weiter weg vom Stift ist, wird nicht gefasst.</translation>
    </message>
    <message>
        <source>Erases the ink that the ring covers. Off: cuts a line where the ring covers its middle, whatever its width.</source>
        <translation>Radiert die Tinte, die der Ring bedeckt. Aus: trennt eine Linie dort, wo der Ring ihre Mitte bedeckt, wie breit sie auch ist.</translation>
    </message>
    <message>
        <source>A line touched from beside keeps its distance from the pen, instead of coming to the pen over the first millimetres.</source>
        <translation>Eine Linie, die daneben berührt wird, behält ihren Abstand zum Stift, statt auf den ersten Millimetern zum Stift zu kommen.</translation>
    </message>
    <message>
        <source>A short touch selects the whole nearest line within this distance.</source>
        <translation>Eine kurze Berührung wählt die ganze nächste Linie in diesem Abstand.</translation>
    </message>
    <message>
        <source>Above 1 a light hand stays thin for longer, below 1 it broadens sooner.</source>
        <translation>Über 1 bleibt eine leichte Hand länger dünn, unter 1 wird sie früher breit.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Ausmaß</translation>
    </message>
    <message>
        <source>An end that is let go beside all others stays there; without it, it goes back. The first modifier chooses the other.</source>
        <translation>Ein Ende, das neben allen anderen losgelassen wird, bleibt dort; sonst geht es zurück. Die erste Zusatztaste wählt das andere.</translation>
    </message>
    <message>
        <source>Attraction</source>
        <translation>Anziehung</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Width of ink counts</source>
        <translation>Breite der Tinte zählt</translation>
    </message>
    <message>
        <source>Broadest line</source>
        <translation>Breiteste Linie</translation>
    </message>
    <message>
        <source>Brush: thicker or thinner under the pen. Retrace: drawing along a line gives it the new pressure. Scale: dragging up or down scales a whole line.</source>
        <translation>Pinsel: dicker oder dünner unter dem Stift. Nachziehen: eine Linie entlangzeichnen gibt ihr den neuen Druck. Skalieren: auf oder ab ziehen skaliert die ganze Linie.</translation>
    </message>
    <message>
        <source>By pressure, hard for thicker and light for thinner, or always the same way. The first button of the pen makes thinner, the second thicker.</source>
        <translation>Nach Druck, fest für dicker und leicht für dünner, oder immer gleich. Die erste Stifttaste macht dünner, die zweite dicker.</translation>
    </message>
    <message>
        <source>By the handle that is touched (auto), or always the same.</source>
        <translation>Nach dem berührten Griff (auto) oder immer gleich.</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>Kombinieren</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Constrain</source>
        <translation>Einschränken</translation>
    </message>
    <message>
        <source>Corrects lines: take hold of one and pull it into shape, or push it from outside.</source>
        <translation>Verbessert Linien: eine fassen und in Form ziehen oder von außen schieben.</translation>
    </message>
    <message>
        <source>Direction of the brush</source>
        <translation>Richtung des Pinsels</translation>
    </message>
    <message>
        <source>Draws lines; pressing harder draws them broader.</source>
        <translation>Zeichnet Linien; fester drücken macht sie breiter.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Ends and corners go along, instead of staying unless taken hold of; the first modifier turns this round for one gesture.</source>
        <translation>Enden und Ecken gehen mit, statt zu bleiben, wenn sie nicht gefasst sind; die erste Zusatztaste kehrt das für eine Geste um.</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Erases the ink under it, lines up to their next crossings, or whole lines.</source>
        <translation>Radiert, was er bedeckt, Linien bis zu ihren nächsten Kreuzungen oder ganze Linien.</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Filz</translation>
    </message>
    <message>
        <source>Fits the finished line again, with fewer segments within the same tolerance; lines of more than a minute stay as drawn.</source>
        <translation>Passt die fertige Linie neu an, mit weniger Segmenten in derselben Toleranz; Linien von mehr als einer Minute bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Force that draws the pen to the end of a line.</source>
        <translation>Kraft, die den Stift zum Ende einer Linie zieht.</translation>
    </message>
    <message>
        <source>Free ends and corners</source>
        <translation>Freie Enden und Ecken</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Grab divides the line so that no more than this is bent; 0 takes segments as they are.</source>
        <translation>Greifen teilt die Linie, damit nicht mehr als dies gebogen wird; 0 nimmt Segmente, wie sie sind.</translation>
    </message>
    <message>
        <source>Grab radius</source>
        <translation>Greifradius</translation>
    </message>
    <message>
        <source>Heavier draws smoother and trails more; for the stabiliser &apos;inertia&apos;.</source>
        <translation>Schwerer zeichnet glatter und hängt mehr nach; für den Stabilisator „Trägheit“.</translation>
    </message>
    <message>
        <source>How far a line may move when the brush lets go of it; more leaves fewer segments.</source>
        <translation>Wie weit sich eine Linie bewegen darf, wenn der Pinsel sie loslässt; mehr lässt weniger Segmente.</translation>
    </message>
    <message>
        <source>How far the brush reaches along the line, to each side.</source>
        <translation>Wie weit der Pinsel entlang der Linie reicht, zu jeder Seite.</translation>
    </message>
    <message>
        <source>How far the finished line may be from the ironed one, for fewer segments.</source>
        <translation>Wie weit die fertige Linie von der geglätteten abweichen darf, für weniger Segmente.</translation>
    </message>
    <message>
        <source>How far the pen leans, from upright, where the device does not say: some media draw broader and softer with their side.</source>
        <translation>Wie weit der Stift aus der Senkrechten geneigt ist, wenn das Gerät es nicht sagt: manche Zeichenmittel zeichnen mit ihrer Seite breiter und weicher.</translation>
    </message>
    <message>
        <source>How fast it irons; pressing harder irons faster too.</source>
        <translation>Wie schnell es glättet; fester drücken glättet auch schneller.</translation>
    </message>
    <message>
        <source>How fast the width changes, per unit of pressure.</source>
        <translation>Wie schnell sich die Breite ändert, je Druck.</translation>
    </message>
    <message>
        <source>How grab bends a segment: with least motion (soft), by the paper&apos;s three cases (paper), or by its equation 7 as printed, which does not reach the pen.</source>
        <translation>Wie Greifen ein Segment biegt: mit geringster Bewegung (weich), nach den drei Fällen des Artikels (Artikel) oder nach seiner gedruckten Gleichung 7, die den Stift nicht erreicht.</translation>
    </message>
    <message>
        <source>Distance within which the pen grabs the end of a line.</source>
        <translation>Wie nah am Ende einer Linie der Stift es fasst.</translation>
    </message>
    <message>
        <source>How slowly a line gives way to the pen that sweeps it.</source>
        <translation>Wie langsam eine Linie dem fegenden Stift nachgibt.</translation>
    </message>
    <message>
        <source>Irons the jitter out of lines and leaves their shape.</source>
        <translation>Glättet das Zittern aus Linien und lässt ihre Form.</translation>
    </message>
    <message>
        <source>Joins ends of lines, or closes a line: drag an end onto another, or tap where two ends are near.</source>
        <translation>Verbindet Linienenden oder schließt eine Linie: ein Ende auf ein anderes ziehen oder tippen, wo zwei Enden nah sind.</translation>
    </message>
    <message>
        <source>Keep distance from the pen</source>
        <translation>Abstand zum Stift behalten</translation>
    </message>
    <message>
        <source>Keep lines separate</source>
        <translation>Linien getrennt lassen</translation>
    </message>
    <message>
        <source>Largest distance between the pen&apos;s path and the line.</source>
        <translation>Größter Abstand zwischen dem Weg des Stifts und der Linie.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Tilt of a mouse&apos;s pen</source>
        <translation>Neigung des Stifts einer Maus</translation>
    </message>
    <message>
        <source>Leave the end where it is let go</source>
        <translation>Das Ende lassen, wo es losgelassen wird</translation>
    </message>
    <message>
        <source>Leaves the lines and transforms a copy; as the second button of the pen does.</source>
        <translation>Lässt die Linien und verändert eine Kopie; wie die zweite Stifttaste.</translation>
    </message>
    <message>
        <source>Length bent by grab</source>
        <translation>Beim Greifen gebogene Länge</translation>
    </message>
    <message>
        <source>Lines that meet share the point but stay two lines.</source>
        <translation>Linien, die sich treffen, teilen den Punkt, bleiben aber zwei.</translation>
    </message>
    <message>
        <source>Longer draws smoother and trails more; for the stabiliser &apos;towed&apos;.</source>
        <translation>Länger zeichnet glatter und hängt mehr nach; für den Stabilisator „geschleppt“.</translation>
    </message>
    <message>
        <source>Makes lines broader and thinner, here and there or as a whole.</source>
        <translation>Macht Linien breiter und dünner, hier und da oder im Ganzen.</translation>
    </message>
    <message>
        <source>Mass of the stabiliser</source>
        <translation>Masse des Stabilisators</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Moves along one axis, turns in steps of 15 degrees, corners stretch both axes freely; as the first button of the pen does.</source>
        <translation>Verschiebt entlang einer Achse, dreht in Schritten von 15 Grad, Ecken strecken beide Achsen frei; wie die erste Stifttaste.</translation>
    </message>
    <message>
        <source>Moves, turns, scales and stretches what is selected, held back by the lines that lead out of it.</source>
        <translation>Verschiebt, dreht, skaliert und streckt das Ausgewählte, gehalten von den Linien, die hinausführen.</translation>
    </message>
    <message>
        <source>No line is made broader than this; one that is may stay so.</source>
        <translation>Keine Linie wird breiter als dies; eine, die es ist, darf es bleiben.</translation>
    </message>
    <message>
        <source>Of retracing: above 1 a light hand stays thin for longer.</source>
        <translation>Beim Nachziehen: über 1 bleibt eine leichte Hand länger dünn.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Bleistift</translation>
    </message>
    <message>
        <source>Pressure curve</source>
        <translation>Druckkurve</translation>
    </message>
    <message>
        <source>Pressure to use if the device reports neither pressure nor depth.</source>
        <translation>Druck eines Geräts, das weder Druck noch Tiefe kennt.</translation>
    </message>
    <message>
        <source>Pressure of a mouse</source>
        <translation>Druck einer Maus</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Pull a stretch of a line (brush), bend one segment (grab), push lines from outside (push), or draw a line over again (sweep).</source>
        <translation>Ein Stück Linie ziehen (Pinsel), ein Segment biegen (Greifen), Linien von außen schieben (Schieben) oder eine Linie neu führen (Fegen).</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius around the end of a line within which it attracts the dragged end; a tap connects ends that are this near.</source>
        <translation>Radius um ein Linienende, in dem es das gezogene Ende anzieht; Tippen verbindet Enden, die so nah sind.</translation>
    </message>
    <message>
        <source>Radius of the eraser.</source>
        <translation>Radius des Radierers.</translation>
    </message>
    <message>
        <source>Radius of the nib</source>
        <translation>Radius der Spitze</translation>
    </message>
    <message>
        <source>Radius within which the dragged end is connected.</source>
        <translation>Radius, in dem das gezogene Ende verbunden wird.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Reach of a click</source>
        <translation>Reichweite eines Klicks</translation>
    </message>
    <message>
        <source>Reach of the attraction</source>
        <translation>Reichweite der Anziehung</translation>
    </message>
    <message>
        <source>Reach of the brush</source>
        <translation>Reichweite des Pinsels</translation>
    </message>
    <message>
        <source>Refine at pen-up</source>
        <translation>Beim Abheben verfeinern</translation>
    </message>
    <message>
        <source>Rope of the stabiliser</source>
        <translation>Leine des Stabilisators</translation>
    </message>
    <message>
        <source>Rounds corners, which otherwise stay; ends of lines always do.</source>
        <translation>Rundet Ecken, die sonst bleiben; Linienenden bleiben immer.</translation>
    </message>
    <message>
        <source>Scale widths</source>
        <translation>Breiten skalieren</translation>
    </message>
    <message>
        <source>Scaling makes lines broader or thinner as well.</source>
        <translation>Skalieren macht Linien auch breiter oder dünner.</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Selects the lines inside a loop that you draw; a short touch selects one line.</source>
        <translation>Wählt aus, was umfahren wird; eine kurze Berührung nimmt eine Linie.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Force level of friction and grain. Does not affect surface stiffness.</source>
        <translation>Anteil von Reibung und Körnung, der zu fühlen ist; das Blatt bleibt so hart, wie es ist.</translation>
    </message>
    <message>
        <source>Force level of friction and roughness. Does not affect surface stiffness.</source>
        <translation>Anteil von Reibung und Rauheit, der zu fühlen ist; das Blatt bleibt so hart, wie es ist.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction and pull. Does not affect surface stiffness.</source>
        <translation>Anteil von Reibung, Körnung, Anziehung und Zug, der zu fühlen ist; das Blatt bleibt so hart, wie es ist.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction and stabiliser. Does not affect surface stiffness.</source>
        <translation>Anteil von Reibung, Körnung, Anziehung und Stabilisator, der zu fühlen ist; das Blatt bleibt so hart, wie es ist.</translation>
    </message>
    <message>
        <source>Force level of friction, stops and pull. Does not affect surface stiffness.</source>
        <translation>Anteil von Reibung, Anschlägen und Zug, der zu fühlen ist; das Blatt bleibt so hart, wie es ist.</translation>
    </message>
    <message>
        <source>Force level of the counter-force, friction and grain. Does not affect surface stiffness.</source>
        <translation>Anteil von Gegenkraft, Reibung und Körnung, der zu fühlen ist; das Blatt bleibt so hart, wie es ist.</translation>
    </message>
    <message>
        <source>Force level of the surface&apos;s friction and grain. Does not affect surface stiffness.</source>
        <translation>Anteil von Reibung und Körnung des Blatts, der zu fühlen ist; das Blatt bleibt so hart, wie es ist.</translation>
    </message>
    <message>
        <source>Force level of the attached lines, friction and grain.</source>
        <translation>Anteil von Leinen, Reibung und Körnung, der zu fühlen ist.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Size of the round nib that pushes lines.</source>
        <translation>Größe der runden Spitze, die Linien schiebt.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Smooth corners too</source>
        <translation>Auch Ecken glätten</translation>
    </message>
    <message>
        <source>Snap radius</source>
        <translation>Einrastradius</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>Speed of the brush</source>
        <translation>Tempo des Pinsels</translation>
    </message>
    <message>
        <source>Stabiliser</source>
        <translation>Stabilisator</translation>
    </message>
    <message>
        <source>Steadies the hand: the line is drawn by a mass, or by a nib on a rope.</source>
        <translation>Beruhigt die Hand: die Linie wird von einer Masse oder einer Spitze an einer Leine gezogen.</translation>
    </message>
    <message>
        <source>Strength of forces</source>
        <translation>Stärke der Kräfte</translation>
    </message>
    <message>
        <source>The parts of lines inside by their control points (points) or by their joints only (on-curve), or whole lines of which any part is inside (strokes).</source>
        <translation>Die Teile der Linien innen nach ihren Kontrollpunkten (Punkte) oder nur nach ihren Gelenken (auf der Kurve), oder ganze Linien, von denen ein Teil innen ist (Linien).</translation>
    </message>
    <message>
        <source>Thinnest line</source>
        <translation>Dünnste Linie</translation>
    </message>
    <message>
        <source>Thinnest retraced line</source>
        <translation>Dünnste nachgezogene Linie</translation>
    </message>
    <message>
        <source>Time of sweep</source>
        <translation>Zeit des Fegens</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transformieren</translation>
    </message>
    <message>
        <source>Length of line on both sides of the pen that is smoothed. Waves up to this length can be removed.</source>
        <translation>Weg entlang der Linie, zu beiden Seiten des Stifts, der geglättet wird; so lange Wellen lassen sich wegnehmen.</translation>
    </message>
    <message>
        <source>Length of line on both sides of the pen in which the width changes.</source>
        <translation>Weg entlang der Linie, zu beiden Seiten des Stifts, auf dem sich die Breite ändert.</translation>
    </message>
    <message>
        <source>Weights of grab</source>
        <translation>Gewichte des Greifens</translation>
    </message>
    <message>
        <source>What a touch does</source>
        <translation>Was eine Berührung tut</translation>
    </message>
    <message>
        <source>What becomes of what was selected before; the first button of the pen adds, the second takes away.</source>
        <translation>Was aus der bisherigen Auswahl wird; die erste Stifttaste fügt hinzu, die zweite nimmt weg.</translation>
    </message>
    <message>
        <source>What goes</source>
        <translation>Was verschwindet</translation>
    </message>
    <message>
        <source>What is covered, the part of a line up to its next crossings, or the whole line.</source>
        <translation>Was bedeckt ist, der Teil einer Linie bis zu den nächsten Kreuzungen oder die ganze Linie.</translation>
    </message>
    <message>
        <source>What the pen is made of: how it looks and how it slides.</source>
        <translation>Woraus der Stift ist: wie er aussieht und wie er gleitet.</translation>
    </message>
    <message>
        <source>Surface to draw on. Sets hardness, friction and grain.</source>
        <translation>Woraus das Blatt ist: seine Härte und seine Reibung.</translation>
    </message>
    <message>
        <source>Whether ends of lines attract the pen (force), connect to the dragged end (snap), or both.</source>
        <translation>Ob Linienenden den Stift anziehen (Kraft), sich mit dem gezogenen Ende verbinden (Einrasten) oder beides.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of a line at full pressure; at least that of the thinnest line.</source>
        <translation>Breite einer Linie bei vollem Druck; mindestens die der dünnsten Linie.</translation>
    </message>
    <message>
        <source>Width of a line without pressure.</source>
        <translation>Breite einer Linie ohne Druck.</translation>
    </message>
    <message>
        <source>Width of a retraced line without pressure.</source>
        <translation>Breite einer nachgezogenen Linie ohne Druck.</translation>
    </message>
    <message>
        <source>With nothing selected, a touch selects the nearest line within this distance.</source>
        <translation>Ist nichts ausgewählt, nimmt eine Berührung die nächste Linie in diesem Abstand.</translation>
    </message>
    <message>
        <source>add</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>blackboard</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beides</translation>
    </message>
    <message>
        <source>brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>chalk</source>
        <translation>Kreide</translation>
    </message>
    <message>
        <source>crayon</source>
        <translation>Wachskreide</translation>
    </message>
    <message>
        <source>crossing</source>
        <translation>Kreuzung</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>Filz</translation>
    </message>
    <message>
        <source>felt-tip</source>
        <translation>Filzstift</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>grab</source>
        <translation>Greifen</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on-curve</source>
        <translation>auf der Kurve</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>pencil</source>
        <translation>Bleistift</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>printed</source>
        <translation>gedruckt</translation>
    </message>
    <message>
        <source>push</source>
        <translation>schieben</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>ersetzen</translation>
    </message>
    <message>
        <source>retrace</source>
        <translation>nachziehen</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>skalieren</translation>
    </message>
    <message>
        <source>snap</source>
        <translation>einrasten</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>strecken</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>subtract</source>
        <translation>abziehen</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>fegen</translation>
    </message>
    <message>
        <source>thicker</source>
        <translation>dicker</translation>
    </message>
    <message>
        <source>thinner</source>
        <translation>dünner</translation>
    </message>
    <message>
        <source>touched</source>
        <translation>Berührtes</translation>
    </message>
    <message>
        <source>towed</source>
        <translation>geschleppt</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Rough paper</source>
        <translation>Raues Papier</translation>
    </message>
    <message>
        <source>Watercolour paper</source>
        <translation>Aquarellpapier</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>rough-paper</source>
        <translation>Raues Papier</translation>
    </message>
    <message>
        <source>watercolour</source>
        <translation>Aquarellpapier</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>Above 1 a light hand stays pale for longer, below 1 it darkens sooner.</source>
        <translation>Über 1 bleibt eine leichte Hand länger blass, unter 1 wird sie früher dunkel.</translation>
    </message>
    <message>
        <source>Another one makes another relief of its kind.</source>
        <translation>Ein anderer macht ein anderes Relief dieser Art.</translation>
    </message>
    <message>
        <source>Brightness of the sound</source>
        <translation>Helligkeit des Klangs</translation>
    </message>
    <message>
        <source>Character of the grain</source>
        <translation>Art der Körnung</translation>
    </message>
    <message>
        <source>Coefficient of friction of the pencil on it.</source>
        <translation>Reibungszahl des Bleistifts darauf.</translation>
    </message>
    <message>
        <source>Coefficient of friction on paper; pairs may say otherwise.</source>
        <translation>Reibungszahl auf Papier; Paare können es anders sagen.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the surface. A page with another colour keeps it.</source>
        <translation>Farbe des Blattes; eine Seite von anderer Farbe behält ihre.</translation>
    </message>
    <message>
        <source>Crumbs</source>
        <translation>Krümel</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Damping of that.</source>
        <translation>Dämpfung davon.</translation>
    </message>
    <message>
        <source>Damping of the hold</source>
        <translation>Dämpfung des Haltens</translation>
    </message>
    <message>
        <source>Dark rim</source>
        <translation>Dunkler Rand</translation>
    </message>
    <message>
        <source>Depth, heavy</source>
        <translation>Tiefe, kräftig</translation>
    </message>
    <message>
        <source>Depth, light</source>
        <translation>Tiefe, leicht</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>Zeichnet</translation>
    </message>
    <message>
        <source>Can be chosen for drawing (off for erasers).</source>
        <translation>Kann zum Zeichnen gewählt werden (aus für Radierer).</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>From dull to bright.</source>
        <translation>Von dumpf bis hell.</translation>
    </message>
    <message>
        <source>From hill to hill; a relief of one&apos;s own is 32 of it wide.</source>
        <translation>Von Hügel zu Hügel; ein eigenes Relief ist 32 davon breit.</translation>
    </message>
    <message>
        <source>Grain in the eye</source>
        <translation>Körnung für das Auge</translation>
    </message>
    <message>
        <source>Grain in the hand</source>
        <translation>Körnung in der Hand</translation>
    </message>
    <message>
        <source>Half of the width of the edge of a grain.</source>
        <translation>Halbe Breite der Kante eines Korns.</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Height of the grain</source>
        <translation>Höhe der Körnung</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Haften</translation>
    </message>
    <message>
        <source>How far a line falls apart into hairs along its way.</source>
        <translation>Wie weit eine Linie längs in Haare zerfällt.</translation>
    </message>
    <message>
        <source>How far the rim of the line is soft, in shares of its radius.</source>
        <translation>Wie weit der Rand der Linie weich ist, in Teilen ihres Radius.</translation>
    </message>
    <message>
        <source>How hard it pushes back, where the device bears as much.</source>
        <translation>Wie fest es zurückdrückt, soweit das Gerät so viel verträgt.</translation>
    </message>
    <message>
        <source>How loud a pen is on it; 0 is silent.</source>
        <translation>Wie laut ein Stift darauf ist; 0 ist still.</translation>
    </message>
    <message>
        <source>How loud it rubs; 0 is silent.</source>
        <translation>Wie laut es reibt; 0 ist still.</translation>
    </message>
    <message>
        <source>How much at full pressure.</source>
        <translation>Wie viel bei vollem Druck.</translation>
    </message>
    <message>
        <source>How much darker a wet line dries at its rim.</source>
        <translation>Wie viel dunkler eine nasse Linie am Rand trocknet.</translation>
    </message>
    <message>
        <source>How much is laid on without pressure.</source>
        <translation>Wie viel ohne Druck aufgetragen wird.</translation>
    </message>
    <message>
        <source>How much it swallows of a push.</source>
        <translation>Wie viel es von einem Druck schluckt.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief shows in the ink; 0 for wet ink.</source>
        <translation>Wie viel vom Relief des Blattes zu sehen ist; 0 für Nasses.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief the hand feels through it.</source>
        <translation>Wie viel vom Relief des Blattes die Hand dadurch fühlt.</translation>
    </message>
    <message>
        <source>How readily stick and slip sing.</source>
        <translation>Wie leicht Haften und Gleiten singen.</translation>
    </message>
    <message>
        <source>How stiffly it holds before it slides.</source>
        <translation>Wie steif es haftet, bevor es gleitet.</translation>
    </message>
    <message>
        <source>In tones of an upright one.</source>
        <translation>In Tönen eines aufrechten.</translation>
    </message>
    <message>
        <source>In widths of an upright one.</source>
        <translation>In Breiten eines aufrechten.</translation>
    </message>
    <message>
        <source>Its usual colour.</source>
        <translation>Seine übliche Farbe.</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Of what is inked, at tone 0.</source>
        <translation>Dessen, was eingefärbt ist, bei Ton 0.</translation>
    </message>
    <message>
        <source>Of what is inked, at tone 1.</source>
        <translation>Dessen, was eingefärbt ist, bei Ton 1.</translation>
    </message>
    <message>
        <source>Opacity, heavy</source>
        <translation>Deckkraft, kräftig</translation>
    </message>
    <message>
        <source>Opacity, light</source>
        <translation>Deckkraft, leicht</translation>
    </message>
    <message>
        <source>Pressure curve of the tone</source>
        <translation>Druckkurve des Tons</translation>
    </message>
    <message>
        <source>Pressure curve of the width</source>
        <translation>Druckkurve der Breite</translation>
    </message>
    <message>
        <source>Root mean square of its heights; 0 is smooth.</source>
        <translation>Effektivwert ihrer Höhen; 0 ist glatt.</translation>
    </message>
    <message>
        <source>Seed of the grain</source>
        <translation>Startwert der Körnung</translation>
    </message>
    <message>
        <source>Share of its own coarseness: dust and crumbs.</source>
        <translation>Anteil der eigenen Grobheit: Staub und Krümel.</translation>
    </message>
    <message>
        <source>Share of the relief that a firm push flattens, for hand and eye.</source>
        <translation>Anteil des Reliefs, den ein fester Druck einebnet, für Hand und Auge.</translation>
    </message>
    <message>
        <source>Size of the crumbs</source>
        <translation>Größe der Krümel</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>Softness of the grain</source>
        <translation>Weichheit der Körnung</translation>
    </message>
    <message>
        <source>Squeak</source>
        <translation>Quietschen</translation>
    </message>
    <message>
        <source>Streaks</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>The same at tone 1.</source>
        <translation>Dasselbe bei Ton 1.</translation>
    </message>
    <message>
        <source>Their wavelength.</source>
        <translation>Ihre Wellenlänge.</translation>
    </message>
    <message>
        <source>Tone of a heavy hand</source>
        <translation>Ton einer kräftigen Hand</translation>
    </message>
    <message>
        <source>Tone of a leaning pen</source>
        <translation>Ton eines geneigten Stifts</translation>
    </message>
    <message>
        <source>Tone of a light hand</source>
        <translation>Ton einer leichten Hand</translation>
    </message>
    <message>
        <source>Wear of the grain</source>
        <translation>Abrieb der Körnung</translation>
    </message>
    <message>
        <source>What lies below so many heights of the grain stays bare, at tone 0.</source>
        <translation>Was unter so vielen Höhen der Körnung liegt, bleibt frei, bei Ton 0.</translation>
    </message>
    <message>
        <source>What the relief looks like.</source>
        <translation>Wie das Relief aussieht.</translation>
    </message>
    <message>
        <source>Width of a leaning pen</source>
        <translation>Breite eines geneigten Stifts</translation>
    </message>
    <message>
        <source>Width of a line at full pressure.</source>
        <translation>Breite einer Linie bei vollem Druck.</translation>
    </message>
    <message>
        <source>Width of the grain</source>
        <translation>Weite der Körnung</translation>
    </message>
    <message>
        <source>fibres</source>
        <translation>Fasern</translation>
    </message>
    <message>
        <source>grain</source>
        <translation>Korn</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>rau</translation>
    </message>
    <message>
        <source>weave</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>brush-pen</source>
        <translation>Pinselstift</translation>
    </message>
    <message>
        <source>charcoal</source>
        <translation>Kohle</translation>
    </message>
    <message>
        <source>ink-pen</source>
        <translation>Tuschestift</translation>
    </message>
    <message>
        <source>pencil-hard</source>
        <translation>harter Bleistift</translation>
    </message>
    <message>
        <source>pencil-soft</source>
        <translation>weicher Bleistift</translation>
    </message>
    <message>
        <source>Force that draws the pen to its target.</source>
        <translation>Kraft, die den Stift zu seinem Ziel zieht.</translation>
    </message>
    <message>
        <source>How near to its target a line that is meant to meet it is connected.</source>
        <translation>Wie nah an ihrem Ziel eine Linie verbunden wird, die es treffen soll.</translation>
    </message>
    <message>
        <source>How near to its target the pen is attracted, if it comes slowly and heads for it.</source>
        <translation>Wie nah an seinem Ziel der Stift angezogen wird, wenn er langsam darauf zukommt.</translation>
    </message>
    <message>
        <source>Lines that meet share the point but stay two lines; a line that meets both ends of another still closes it.</source>
        <translation>Linien, die sich treffen, teilen den Punkt, bleiben aber zwei; eine Linie, die beide Enden einer anderen trifft, schließt sie trotzdem.</translation>
    </message>
    <message>
        <source>Whether a line that is meant to meet another or itself is attracted (force), connected (snap), or both.</source>
        <translation>Ob eine Linie, die eine andere oder sich selbst treffen soll, angezogen (Kraft), verbunden (Einrasten) wird oder beides.</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Zeichenmittel</translation>
    </message>
    <message>
        <source>Draw; press harder for a broader line. End on a line’s end to join it.</source>
        <translation>Zeichnen; fester drücken für eine breitere Linie. An einem Linienende enden verbindet.</translation>
    </message>
    <message>
        <source>Drag a line to bend it; it goes back as you go back.</source>
        <translation>Linie ziehen, um sie zu biegen; sie geht zurück, wie Sie zurückgehen.</translation>
    </message>
    <message>
        <source>Rub along a line to iron the tremor out; press to iron harder.</source>
        <translation>Eine Linie entlangreiben glättet Zittern; fester drücken glättet mehr.</translation>
    </message>
    <message>
        <source>Rub a line to make it broader or thinner.</source>
        <translation>Linie reiben, um sie breiter oder dünner zu machen.</translation>
    </message>
    <message>
        <source>Erase the ink that the ring touches.</source>
        <translation>Wegradieren, was der Ring berührt.</translation>
    </message>
    <message>
        <source>up to the crossings</source>
        <translation>bis zu den Kreuzungen</translation>
    </message>
    <message>
        <source>whole lines</source>
        <translation>ganze Linien</translation>
    </message>
    <message>
        <source>Draw a loop around lines, or click one.</source>
        <translation>Umfahren Sie, was gemeint ist, oder klicken Sie eine Linie an.</translation>
    </message>
    <message>
        <source>adds</source>
        <translation>fügt hinzu</translation>
    </message>
    <message>
        <source>takes away</source>
        <translation>nimmt weg</translation>
    </message>
    <message>
        <source>Drag inside to move, a corner to scale, outside it to turn.</source>
        <translation>Innen ziehen verschiebt, an der Ecke skaliert, außen dreht.</translation>
    </message>
    <message>
        <source>along one axis, in steps of 15°</source>
        <translation>entlang einer Achse, in Schritten von 15°</translation>
    </message>
    <message>
        <source>a copy</source>
        <translation>eine Kopie</translation>
    </message>
    <message>
        <source>Drag the end of a line to another end.</source>
        <translation>Ein Linienende zu einem anderen Ende ziehen.</translation>
    </message>
    <message>
        <source>the end stays where you let it go</source>
        <translation>das Ende bleibt, wo Sie loslassen</translation>
    </message>
    <message>
        <source>ends and corners go along, or stay</source>
        <translation>Enden und Ecken gehen mit oder bleiben</translation>
    </message>
    <message>
        <source>Push lines away from the side of the pen.</source>
        <translation>Linien mit der Seite des Stifts wegschieben.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Lines become smooth curves while you draw; press harder for a broader one. Near its start, an outline snaps shut.</source>
        <translation>Linien werden beim Zeichnen zu glatten Kurven; fester drücken macht sie breiter. Nahe am Anfang rastet ein Umriss ein.</translation>
    </message>
    <message>
        <source>Pull and push</source>
        <translation>Ziehen und schieben</translation>
    </message>
    <message>
        <source>A line is not quite right? Take hold of it and pull. It resists like a wire, the more the further you go.</source>
        <translation>Eine Linie stimmt nicht ganz? Fassen Sie sie und ziehen Sie. Sie widersteht wie ein Draht, je weiter, desto mehr.</translation>
    </message>
    <message>
        <source>Rub along a shaky line: the jitter goes, the shape stays.</source>
        <translation>Reiben Sie eine zittrige Linie entlang: das Zittern geht, die Form bleibt.</translation>
    </message>
    <message>
        <source>Press on a line to make it broader, after it was drawn.</source>
        <translation>Drücken Sie auf eine Linie, um sie nachträglich breiter zu machen.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Rub away what is covered, a line up to its next crossing, or all of it.</source>
        <translation>Wegreiben, was bedeckt ist, eine Linie bis zur nächsten Kreuzung oder ganz.</translation>
    </message>
    <message>
        <source>Draw a loop around lines to select them; touch one to take it.</source>
        <translation>Linien umfahren wählt sie aus; eine berühren nimmt sie.</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Verschieben und drehen</translation>
    </message>
    <message>
        <source>Drag what is selected. Lines that lead out of it hold it back, and you feel how much.</source>
        <translation>Ziehen Sie, was ausgewählt ist. Linien, die hinausführen, halten es zurück, und Sie fühlen, wie sehr.</translation>
    </message>
    <message>
        <source>Drag one end onto another: they snap, and become one line.</source>
        <translation>Ziehen Sie ein Ende auf ein anderes: sie rasten ein und werden eine Linie.</translation>
    </message>
</context>
</TS>
