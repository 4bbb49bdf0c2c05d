<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>felt::desktop::ExampleButton</name>
    <message>
        <source>Show the sample cat</source>
        <translation>Beispielkatze zeigen</translation>
    </message>
    <message>
        <source>Opens a drawing to pull, erase and colour</source>
        <translation>Öffnet eine Zeichnung zum Ziehen, Radieren und Färben</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MatchView</name>
    <message>
        <source>Matches of two key drawings</source>
        <translation>Zuordnungen zweier Schlüsselzeichnungen</translation>
    </message>
    <message>
        <source>Drag from a line to the line that it becomes in the next key drawing. Click a line without a partner. Esc ends.</source>
        <translation>Ziehen Sie von einer Linie zu der Linie, die in der nächsten Schlüsselzeichnung aus ihr wird. Klicken Sie eine Linie ohne Gegenstück an. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>AddedStrokes</name>
    <message>
        <source>“%1” differs here: the added strokes look as it does in this drawing</source>
        <translation>„%1“ ist hier anders definiert: Die hinzugefügten Linien sehen aus wie in dieser Zeichnung</translation>
    </message>
    <message>
        <source>Pictures of this file were not added: %1. Open the file to see them.</source>
        <translation>Nicht hinzugefügte Bilder dieser Datei: %1. Öffnen Sie die Datei, um sie zu sehen.</translation>
    </message>
    <message>
        <source>Lines of hidden layers that were not added: %1. Open the file to see them.</source>
        <translation>Nicht hinzugefügte Linien ausgeblendeter Ebenen: %1. Öffnen Sie die Datei, um sie zu sehen.</translation>
    </message>
    <message>
        <source>Layers whose lines were added to the current layer, without the name of their own: %1</source>
        <translation>Ebenen, deren Linien ohne den Namen der Ebene zur aktuellen Ebene hinzugefügt wurden: %1</translation>
    </message>
    <message>
        <source>Opacities and blend modes of layers that were left out: %1</source>
        <translation>Weggelassene Deckkräfte und Mischmodi von Ebenen: %1</translation>
    </message>
    <message>
        <source>Guides, symmetry groups, timings and edits of the body that were not added: %1. Open the file to see them.</source>
        <translation>Nicht hinzugefügte Hilfslinien, Symmetriegruppen, Zeitpläne und Bearbeitungen des Körpers: %1. Öffnen Sie die Datei, um sie zu sehen.</translation>
    </message>
    <message>
        <source>Names of lines that were left out, because lines of this drawing have them: %1</source>
        <translation>Weggelassene Namen von Linien, weil Linien dieser Zeichnung sie schon haben: %1</translation>
    </message>
</context>
<context>
    <name>Arguments</name>
    <message>
        <source>Open a separate window with an empty drawing.</source>
        <translation>Ein separates Fenster mit einer leeren Zeichnung öffnen.</translation>
    </message>
    <message>
        <source>Use this UI language (en, de, nl) instead of the system&apos;s.</source>
        <translation>Diese Sprache (en, de, nl) statt der Systemsprache verwenden.</translation>
    </message>
    <message>
        <source>Record everything that happens to the drawing, for feltline replay --as-recorded.</source>
        <translation>Alles aufzeichnen, was mit der Zeichnung geschieht, für feltline replay --as-recorded.</translation>
    </message>
    <message>
        <source>Feltline: draw, and feel what you draw.</source>
        <translation>Feltline: zeichnen und spüren, was man zeichnet.</translation>
    </message>
    <message>
        <source>Drawings to open: .felt, .svg, .ndjson.</source>
        <translation>Zu öffnende Zeichnungen: .felt, .svg, .ndjson.</translation>
    </message>
    <message>
        <source>--size must be WIDTHxHEIGHT, each from 100 to 8000</source>
        <translation>--size muss BREITExHÖHE sein, jeweils 100 bis 8000</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Beispiele:</translation>
    </message>
    <message>
        <source>Run a session of a study with a participant, on the whole screen.</source>
        <translation>Eine Sitzung einer Studie mit einer Versuchsperson durchführen, auf dem ganzen Bildschirm.</translation>
    </message>
    <message>
        <source>The folder for the results of --trial (also -o).</source>
        <translation>Der Ordner für die Ergebnisse von --trial (auch -o).</translation>
    </message>
    <message>
        <source>The number of the participant, from 1 to 9999.</source>
        <translation>Die Nummer der Versuchsperson, von 1 bis 9999.</translation>
    </message>
    <message>
        <source>The session: pre, train (if not given), post, retention or transfer.</source>
        <translation>Die Sitzung: pre, train (ohne Angabe), post, retention oder transfer.</translation>
    </message>
    <message>
        <source>--%1 needs --trial</source>
        <translation>--%1 braucht --trial</translation>
    </message>
    <message>
        <source>--trial needs a study, -o FOLDER and --participant NUMBER (from 1)</source>
        <translation>--trial braucht eine Studie, -o FOLDER und --participant NUMBER (ab 1)</translation>
    </message>
    <message>
        <source>--trial opens no drawings</source>
        <translation>--trial öffnet keine Zeichnungen</translation>
    </message>
    <message>
        <source>--screenshot shows one drawing only</source>
        <translation>--screenshot zeigt nur eine Zeichnung</translation>
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
        <translation>Radieren, solange gedrückt</translation>
    </message>
    <message>
        <source>Pull while held</source>
        <translation>Ziehen, solange gedrückt</translation>
    </message>
    <message>
        <source>Select while held</source>
        <translation>Auswählen, solange gedrückt</translation>
    </message>
    <message>
        <source>Move the view while held</source>
        <translation>Ansicht verschieben, solange gedrückt</translation>
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
    <message>
        <source>Open the palette at the pointer</source>
        <translation>Palette am Zeiger öffnen</translation>
    </message>
    <message>
        <source>Open the ring of tools; release to choose</source>
        <translation>Ring der Werkzeuge öffnen; Loslassen wählt</translation>
    </message>
</context>
<context>
    <name>CanvasPopup</name>
    <message>
        <source>Palette at the p&amp;ointer</source>
        <translation>Palette am &amp;Zeiger</translation>
    </message>
    <message>
        <source>Shows tools, media, colours and commands beside the pen.</source>
        <translation>Zeigt Werkzeuge, Zeichenmittel, Farben und Befehle neben dem Stift.</translation>
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
        <translation>Schreibt die angezeigte Palette in eine Datei.</translation>
    </message>
    <message>
        <source>&amp;Keep the colour</source>
        <translation>Farbe &amp;behalten</translation>
    </message>
    <message>
        <source>Adds the current colour to your own palette.</source>
        <translation>Fügt die aktuelle Farbe zur eigenen Palette hinzu.</translation>
    </message>
    <message>
        <source>&amp;Remove the colour</source>
        <translation>Farbe en&amp;tfernen</translation>
    </message>
    <message>
        <source>Removes the current colour from your own palette.</source>
        <translation>Entfernt die aktuelle Farbe aus der eigenen Palette.</translation>
    </message>
</context>
<context>
    <name>DeviceWords</name>
    <message>
        <source>the device is no longer connected</source>
        <translation>das Gerät ist nicht mehr verbunden</translation>
    </message>
    <message>
        <source>the device does not know the position of its arm</source>
        <translation>das Gerät kennt die Position seines Arms nicht</translation>
    </message>
    <message>
        <source>the device has switched its forces off</source>
        <translation>das Gerät hat seine Kräfte abgeschaltet</translation>
    </message>
    <message>
        <source>its motors are too warm</source>
        <translation>die Motoren sind zu warm</translation>
    </message>
    <message>
        <source>the device reports impossible values</source>
        <translation>das Gerät meldet unmögliche Werte</translation>
    </message>
    <message>
        <source>the device reports a fault</source>
        <translation>das Gerät meldet einen Fehler</translation>
    </message>
    <message>
        <source>%1 is no longer connected.</source>
        <translation>%1 ist nicht mehr verbunden.</translation>
    </message>
    <message>
        <source>Nothing is lost. Check its cable and power; you can continue with mouse or tablet.</source>
        <translation>Es ist nichts verloren. Prüfen Sie Kabel und Stromversorgung; Sie können mit Maus oder Tablett weiterzeichnen.</translation>
    </message>
    <message>
        <source>%1 does not know the position of its arm.</source>
        <translation>%1 kennt die Position seines Arms nicht.</translation>
    </message>
    <message>
        <source>Until it has found its home position, continue with mouse or tablet.</source>
        <translation>Zeichnen Sie mit Maus oder Tablett weiter, bis es seine Ausgangsposition gefunden hat.</translation>
    </message>
    <message>
        <source>%1 has switched its forces off.</source>
        <translation>%1 hat seine Kräfte abgeschaltet.</translation>
    </message>
    <message>
        <source>Its switch or its own protection did this. Continue without forces, or switch them on at the device and then here.</source>
        <translation>Auslöser war sein Schalter oder sein eigener Schutz. Zeichnen Sie ohne Kräfte weiter oder schalten Sie die Kräfte erst am Gerät und dann hier wieder ein.</translation>
    </message>
    <message>
        <source>The motors of %1 are too warm.</source>
        <translation>Die Motoren von %1 sind zu warm.</translation>
    </message>
    <message>
        <source>Continue without forces. You can switch them on again in a few minutes.</source>
        <translation>Zeichnen Sie ohne Kräfte weiter. In einigen Minuten können Sie sie wieder einschalten.</translation>
    </message>
    <message>
        <source>%1 reports impossible values.</source>
        <translation>%1 meldet unmögliche Werte.</translation>
    </message>
    <message>
        <source>%1 reports a fault.</source>
        <translation>%1 meldet einen Fehler.</translation>
    </message>
    <message>
        <source>Continue without forces.</source>
        <translation>Zeichnen Sie ohne Kräfte weiter.</translation>
    </message>
    <message>
        <source>Continue with mouse or tablet. Check the cable, switch the device off and on, and try again.</source>
        <translation>Zeichnen Sie mit Maus oder Tablett weiter. Prüfen Sie das Kabel, schalten Sie das Gerät aus und wieder ein und versuchen Sie es erneut.</translation>
    </message>
</context>
<context>
    <name>EditActions</name>
    <message>
        <source>Make e&amp;xact</source>
        <translation>&amp;Exakt machen</translation>
    </message>
    <message>
        <source>Replaces the line that was drawn along a guide by the exact curve.</source>
        <translation>Ersetzt die Linie, die an einer Hilfslinie gezeichnet wurde, durch die exakte Kurve.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
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
        <translation>&amp;Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Undoes the last step.</source>
        <translation>Macht den letzten Schritt rückgängig.</translation>
    </message>
    <message>
        <source>Redoes the step that was undone.</source>
        <translation>Stellt den rückgängig gemachten Schritt wieder her.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Removes the selected lines.</source>
        <translation>Entfernt die ausgewählten Linien.</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Copies the selected lines, slightly offset.</source>
        <translation>Kopiert die ausgewählten Linien, leicht versetzt.</translation>
    </message>
    <message>
        <source>Selects all lines of visible, unlocked layers.</source>
        <translation>Wählt alle Linien auf sichtbaren, nicht gesperrten Ebenen aus.</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>&amp;Nichts auswählen</translation>
    </message>
    <message>
        <source>Clears the selection.</source>
        <translation>Hebt die Auswahl auf.</translation>
    </message>
    <message>
        <source>Selects all lines that are not selected now.</source>
        <translation>Wählt alle Linien aus, die jetzt nicht ausgewählt sind.</translation>
    </message>
    <message>
        <source>&amp;Cancel or clear selection</source>
        <translation>&amp;Abbrechen oder Auswahl aufheben</translation>
    </message>
    <message>
        <source>Cancels the current gesture, or clears the selection.</source>
        <translation>Bricht die laufende Aktion ab oder hebt die Auswahl auf.</translation>
    </message>
    <message>
        <source>&amp;Broader lines</source>
        <translation>&amp;Breitere Linien</translation>
    </message>
    <message>
        <source>Makes the selected lines broader by a quarter.</source>
        <translation>Macht die ausgewählten Linien um ein Viertel breiter.</translation>
    </message>
    <message>
        <source>T&amp;hinner lines</source>
        <translation>D&amp;ünnere Linien</translation>
    </message>
    <message>
        <source>Makes the selected lines thinner by a fifth.</source>
        <translation>Macht die ausgewählten Linien um ein Fünftel dünner.</translation>
    </message>
    <message>
        <source>Bring to &amp;front</source>
        <translation>In den &amp;Vordergrund</translation>
    </message>
    <message>
        <source>Puts the selected lines above all others of their layer.</source>
        <translation>Legt die ausgewählten Linien über alle anderen ihrer Ebene.</translation>
    </message>
    <message>
        <source>Send to bac&amp;k</source>
        <translation>In den &amp;Hintergrund</translation>
    </message>
    <message>
        <source>Puts the selected lines below all others of their layer.</source>
        <translation>Legt die ausgewählten Linien unter alle anderen ihrer Ebene.</translation>
    </message>
    <message>
        <source>Line as dra&amp;wn</source>
        <translation>Linie wie ge&amp;zeichnet</translation>
    </message>
    <message>
        <source>Replaces the line of the steady hand by the line as it was drawn.</source>
        <translation>Ersetzt die Linie der ruhigen Hand durch die Linie, wie sie gezeichnet wurde.</translation>
    </message>
</context>
<context>
    <name>ErrorWords</name>
    <message>
        <source>The file or folder does not exist.</source>
        <translation>Die Datei oder der Ordner existiert nicht.</translation>
    </message>
    <message>
        <source>The file cannot be read or written. It may be protected, or the disk may be full.</source>
        <translation>Die Datei kann nicht gelesen oder geschrieben werden. Vielleicht ist sie schreibgeschützt oder der Datenträger voll.</translation>
    </message>
    <message>
        <source>Feltline cannot read this kind of file.</source>
        <translation>Feltline kann diesen Dateityp nicht lesen.</translation>
    </message>
    <message>
        <source>The file is damaged, or is not a drawing that Feltline can read.</source>
        <translation>Die Datei ist beschädigt oder keine Zeichnung, die Feltline lesen kann.</translation>
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
        <source>M&amp;y surfaces</source>
        <translation>Ei&amp;gene Untergründe</translation>
    </message>
    <message>
        <source>Surfaces that you made or that came with a drawing</source>
        <translation>Untergründe, die Sie erstellt haben oder die mit einer Zeichnung kamen</translation>
    </message>
    <message>
        <source>Stops all forces immediately</source>
        <translation>Schaltet alle Kräfte sofort ab</translation>
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
        <source>Forces are off. Switch them on in the Feel panel.</source>
        <translation>Die Kräfte sind aus. Schalten Sie sie im Bedienfeld „Gefühl“ wieder ein.</translation>
    </message>
    <message>
        <source>Hear the pen rub on the surface</source>
        <translation>Den Stift auf dem Untergrund reiben hören</translation>
    </message>
    <message>
        <source>Stops all forces, or switches them on</source>
        <translation>Hält alle Kräfte an oder schaltet sie ein</translation>
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
    <message>
        <source>&amp;Edge of the page as a ridge</source>
        <translation>Seiten&amp;rand als Erhebung</translation>
    </message>
    <message>
        <source>Feel where the page ends, while the pen touches</source>
        <translation>Fühlen, wo die Seite endet, während der Stift aufliegt</translation>
    </message>
    <message>
        <source>Box of the se&amp;lection as a ridge</source>
        <translation>Rahmen der &amp;Auswahl als Erhebung</translation>
    </message>
    <message>
        <source>Feel where the box around the selected lines ends</source>
        <translation>Fühlen, wo der Rahmen um die ausgewählten Linien endet</translation>
    </message>
    <message>
        <source>Lines of locked &amp;pictures as grooves</source>
        <translation>Linien gesperrter &amp;Bilder als Rillen</translation>
    </message>
    <message>
        <source>Feel the lines and edges of a picture in a locked layer, while you draw slowly along them</source>
        <translation>Die Linien und Kanten eines Bildes in einer gesperrten Ebene fühlen, während man langsam an ihnen entlang zeichnet</translation>
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
        <translation>Um eine Linie zu korrigieren, drücken Sie %1 und ziehen Sie sie in Form.</translation>
    </message>
    <message>
        <source>%1 undoes a step. The Help menu has a two-minute tour.</source>
        <translation>%1 macht einen Schritt rückgängig. Im Hilfe-Menü finden Sie eine zweiminütige Tour.</translation>
    </message>
</context>
<context>
    <name>GuideActions</name>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Lineal</translation>
    </message>
    <message>
        <source>Adds a straight edge with millimetres.</source>
        <translation>Fügt eine gerade Kante mit Millimetern hinzu.</translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation>&amp;Gerade</translation>
    </message>
    <message>
        <source>Adds a straight line across the page.</source>
        <translation>Fügt eine Gerade über die ganze Seite hinzu.</translation>
    </message>
    <message>
        <source>&amp;Parallels</source>
        <translation>&amp;Parallelen</translation>
    </message>
    <message>
        <source>Adds all lines of one direction.</source>
        <translation>Fügt alle Linien einer Richtung hinzu.</translation>
    </message>
    <message>
        <source>&amp;Set square</source>
        <translation>Geo&amp;dreieck</translation>
    </message>
    <message>
        <source>Adds a right angle with millimetres.</source>
        <translation>Fügt einen rechten Winkel mit Millimetern hinzu.</translation>
    </message>
    <message>
        <source>Pr&amp;otractor</source>
        <translation>&amp;Winkelmesser</translation>
    </message>
    <message>
        <source>Adds rays in steps of 15 degrees.</source>
        <translation>Fügt Strahlen in Schritten von 15 Grad hinzu.</translation>
    </message>
    <message>
        <source>&amp;Compass</source>
        <translation>&amp;Zirkel</translation>
    </message>
    <message>
        <source>Adds the centre of circles.</source>
        <translation>Fügt den Mittelpunkt von Kreisen hinzu.</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>Adds one ellipse.</source>
        <translation>Fügt eine Ellipse hinzu.</translation>
    </message>
    <message>
        <source>Co&amp;ncentric ellipses</source>
        <translation>Ko&amp;nzentrische Ellipsen</translation>
    </message>
    <message>
        <source>Adds ellipses around one centre.</source>
        <translation>Fügt Ellipsen um einen Mittelpunkt hinzu.</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Perspekti&amp;ve</translation>
    </message>
    <message>
        <source>Adds two vanishing points.</source>
        <translation>Fügt zwei Fluchtpunkte hinzu.</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Adds a grid of squares.</source>
        <translation>Fügt ein Raster aus Quadraten hinzu.</translation>
    </message>
    <message>
        <source>&amp;Isometric grid</source>
        <translation>&amp;Isometrisches Raster</translation>
    </message>
    <message>
        <source>Adds a grid of triangles.</source>
        <translation>Fügt ein Raster aus Dreiecken hinzu.</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>S&amp;ymmetrie</translation>
    </message>
    <message>
        <source>Adds a mirror axis. New lines get mirror images.</source>
        <translation>Fügt eine Spiegelachse hinzu. Neue Linien bekommen Spiegelbilder.</translation>
    </message>
    <message>
        <source>&amp;Trace of selected lines</source>
        <translation>&amp;Spur ausgewählter Linien</translation>
    </message>
    <message>
        <source>Makes each selected line a guide.</source>
        <translation>Macht jede ausgewählte Linie zu einer Hilfslinie.</translation>
    </message>
    <message>
        <source>&amp;Show guides</source>
        <translation>&amp;Hilfslinien zeigen</translation>
    </message>
    <message>
        <source>Shows or hides the guides. Hidden guides have no effect.</source>
        <translation>Zeigt oder verbirgt die Hilfslinien. Verborgene wirken nicht.</translation>
    </message>
    <message>
        <source>&amp;Unlink mirrored lines</source>
        <translation>Gespiegelte Linien &amp;trennen</translation>
    </message>
    <message>
        <source>The selected lines no longer follow their mirror images.</source>
        <translation>Die ausgewählten Linien folgen ihren Spiegelbildern nicht mehr.</translation>
    </message>
    <message>
        <source>Remove &amp;all guides</source>
        <translation>&amp;Alle Hilfslinien entfernen</translation>
    </message>
    <message>
        <source>Removes the guides. Lines stay.</source>
        <translation>Entfernt die Hilfslinien. Linien bleiben.</translation>
    </message>
</context>
<context>
    <name>ImportWords</name>
    <message>
        <source>has times that are not milliseconds: they stand still, run backwards or hardly advance; they were ignored</source>
        <translation>hat Zeiten, die keine Millisekunden sind, und wurde ohne Zeiten gelesen</translation>
    </message>
    <message>
        <source>has pressures outside 0 to 1, which count as 0 or 1; divide them by the largest pressure of the pen</source>
        <translation>hat Druckwerte außerhalb von 0 bis 1, die als 0 oder 1 zählen; teilen Sie sie durch den größten Druck des Stifts</translation>
    </message>
    <message>
        <source>has invalid tones (one number from 0 to 1 per width is needed); the tones of its widths were used</source>
        <translation>hat ungültige Tonwerte; die seiner Breiten wurden verwendet</translation>
    </message>
    <message>
        <source>has rounded coordinates; smooth joints were moved by less than 0.001 mm or became corners</source>
        <translation>hat gerundete Koordinaten; glatte Stellen wurden um weniger als 0,001 mm verschoben oder zu Ecken</translation>
    </message>
    <message>
        <source>is transparent inside a transparent group; the transparency was applied to each stroke</source>
        <translation>ist durchscheinend in einer durchscheinenden Gruppe; jede Linie wurde durchscheinend</translation>
    </message>
    <message>
        <source>has widths that are not positive numbers (%1); those of the pieces beside them were used</source>
        <translation>hat Breiten, die keine positiven Zahlen sind (%1); die der Stücke daneben wurden verwendet</translation>
    </message>
    <message>
        <source>has invalid tones (one number from 0 to 1 per width is needed); its points were read</source>
        <translation>hat ungültige Tonwerte; seine Punkte wurden gelesen</translation>
    </message>
    <message>
        <source>has a line that another program changed; its widths were stretched over the line</source>
        <translation>hat eine Linie, die ein anderes Programm geändert hat; ihre Breiten wurden über sie verteilt</translation>
    </message>
    <message>
        <source>has more points than a stroke can have (%1); it was split into several strokes</source>
        <translation>hat mehr Punkte, als eine Linie haben kann (%1), und wurde in mehrere Linien geteilt</translation>
    </message>
    <message>
        <source>has a different colour from the first page; the first page&apos;s colour was used</source>
        <translation>hat eine andere Farbe als die erste Seite; die der ersten Seite wurde verwendet</translation>
    </message>
    <message>
        <source>contains something that is not a number; only the points before it were read</source>
        <translation>enthält etwas, das keine Zahl ist; nur die Punkte davor wurden gelesen</translation>
    </message>
    <message>
        <source>has a blend mode, which was ignored: the file has more than 200 such groups</source>
        <translation>hat einen Mischmodus, der nicht beachtet wurde: die Datei hat mehr als 200 solche Gruppen</translation>
    </message>
    <message>
        <source>was read without some of its styles, because the style sheet is too complex</source>
        <translation>wurde ohne einige seiner Stile gelesen, weil das Stylesheet zu umfangreich ist</translation>
    </message>
    <message>
        <source>was changed by another program: its points were read, not the stored curve</source>
        <translation>wurde von einem anderen Programm geändert: seine Punkte wurden gelesen, nicht die gespeicherte Kurve</translation>
    </message>
    <message>
        <source>is transparent and has several parts; it became darker at their crossings</source>
        <translation>ist durchscheinend und hat mehrere Teile; wo sie sich kreuzen, wurde es dunkler</translation>
    </message>
    <message>
        <source>is in a transparent group; the transparency was applied to each stroke</source>
        <translation>ist in einer durchscheinenden Gruppe; jede Linie wurde durchscheinend</translation>
    </message>
    <message>
        <source>is larger than a page can be (5000 mm); the rest lies outside the page</source>
        <translation>ist größer, als eine Seite sein kann (5000 mm); der Rest liegt außerhalb der Seite</translation>
    </message>
    <message>
        <source>has parts shorter than 0.05 mm, which were joined to their neighbours</source>
        <translation>hat Teile, die kürzer als 0,05 mm sind; sie wurden mit ihren Nachbarn verbunden</translation>
    </message>
    <message>
        <source>has a newer version than Feltline supports; the known parts were read</source>
        <translation>hat eine neuere Version, als Feltline kennt; die bekannten Teile wurden gelesen</translation>
    </message>
    <message>
        <source>has a line that is stretched in one direction; its width was sampled</source>
        <translation>hat eine Linie, die in einer Richtung gestreckt ist; ihre Breite wurde angenähert</translation>
    </message>
    <message>
        <source>was stretched in one direction; its widths were scaled by the mean</source>
        <translation>wurde in einer Richtung gestreckt; die Breiten wurden im Mittel vergrößert</translation>
    </message>
    <message>
        <source>ends before the file does; the documents after it (%1) were skipped</source>
        <translation>endet vor der Datei; was danach kommt (Dokumente: %1), wurde übersprungen</translation>
    </message>
    <message>
        <source>is painted with a gradient; the mean colour of its stops was used</source>
        <translation>hat einen Farbverlauf; dessen mittlere Farbe wurde verwendet</translation>
    </message>
    <message>
        <source>extends beyond the frame that shows it; its lines end about there</source>
        <translation>reicht über den Rahmen hinaus, der es zeigt; seine Linien enden ungefähr dort</translation>
    </message>
    <message>
        <source>has more than 250000 segments and was split into several strokes</source>
        <translation>hat mehr als 250000 Abschnitte und wurde in mehrere Linien geteilt</translation>
    </message>
    <message>
        <source>has more than 10000 layers; the others were merged into the last</source>
        <translation>hat mehr als 10000 Ebenen; die übrigen wurden mit der letzten vereint</translation>
    </message>
    <message>
        <source>has a smooth joint that another program bent; it became a corner</source>
        <translation>hat eine glatte Stelle, die ein anderes Programm geknickt hat; sie wurde zur Ecke</translation>
    </message>
    <message>
        <source>was skipped: a drawing has at most 200 pictures and 10000 layers</source>
        <translation>wurde übersprungen: eine Zeichnung hat höchstens 200 Bilder und 10000 Ebenen</translation>
    </message>
    <message>
        <source>extends beyond the frame that shows it, and is shown as a whole</source>
        <translation>reicht über den Rahmen hinaus, der es zeigt, und wird ganz gezeigt</translation>
    </message>
    <message>
        <source>crosses itself; parts that it covers twice may lack their fill</source>
        <translation>kreuzt sich selbst; doppelt bedeckten Teilen kann die Füllung fehlen</translation>
    </message>
    <message>
        <source>was skipped: it is in another file, &apos;%1&apos;, which is not opened</source>
        <translation>wurde übersprungen: es ist in einer anderen Datei, „%1“, die nicht geöffnet wird</translation>
    </message>
    <message>
        <source>refers to a style sheet in another file, which was not read</source>
        <translation>verweist auf ein Stylesheet in einer anderen Datei, das nicht gelesen wurde</translation>
    </message>
    <message>
        <source>is clipped to too many rotated frames; this one was ignored</source>
        <translation>ist von zu vielen gedrehten Rahmen beschnitten; dieser wurde nicht beachtet</translation>
    </message>
    <message>
        <source>has a centre line of several parts; only the first was read</source>
        <translation>hat eine Mittellinie aus mehreren Teilen; nur der erste wurde gelesen</translation>
    </message>
    <message>
        <source>has ends or corners too close together, which became round</source>
        <translation>hat Enden oder Ecken, die zu nahe beieinander liegen und rund wurden</translation>
    </message>
    <message>
        <source>has no known widths of its pieces; a single width was used</source>
        <translation>hat keine bekannten Breiten seiner Stücke; eine einzige wurde verwendet</translation>
    </message>
    <message>
        <source>has no supported mapping; its coordinates were not changed</source>
        <translation>hat keine Abbildung, die Feltline kennt; seine Koordinaten blieben unverändert</translation>
    </message>
    <message>
        <source>has a blend mode that is not supported, which was ignored</source>
        <translation>hat einen Mischmodus, den es hier nicht gibt und der nicht beachtet wurde</translation>
    </message>
    <message>
        <source>%1 rules of style sheets are not supported and were ignored</source>
        <translation>%1 Regeln von Stylesheets gibt es hier nicht; sie wurden nicht beachtet</translation>
    </message>
    <message>
        <source>covers lines of its transparent group, which show through</source>
        <translation>bedeckt Linien seiner durchscheinenden Gruppe, die nun durchscheinen</translation>
    </message>
    <message>
        <source>has flat dashes shorter than its width, which became dots</source>
        <translation>hat gerade Striche, die kürzer als breit sind und zu Punkten wurden</translation>
    </message>
    <message>
        <source>was skipped: the element it refers to is not in the file</source>
        <translation>wurde übersprungen: worauf es verweist, ist nicht in der Datei</translation>
    </message>
    <message>
        <source>has neither a line nor a fill that shows and was skipped</source>
        <translation>hat weder eine sichtbare Linie noch eine sichtbare Füllung und wurde übersprungen</translation>
    </message>
    <message>
        <source>lost its variable width (%1); its outline was used instead</source>
        <translation>verlor seine wechselnde Breite; stattdessen wurde sein Umriss verwendet</translation>
    </message>
    <message>
        <source>has widths interpolated by the rule %1, which were sampled</source>
        <translation>hat Breiten nach der Regel %1, die angenähert wurden</translation>
    </message>
    <message>
        <source>has a name of more than 4096 bytes; its points were read</source>
        <translation>hat einen zu langen Namen; seine Punkte wurden gelesen</translation>
    </message>
    <message>
        <source>has a width or height of 0, so nothing of it is visible</source>
        <translation>hat die Breite oder Höhe 0, darum ist nichts davon sichtbar</translation>
    </message>
    <message>
        <source>does not define its largest pressure; 32767 was assumed</source>
        <translation>nennt seinen größten Druck nicht; 32767 wurde angenommen</translation>
    </message>
    <message>
        <source>has an invalid or too long material, which was skipped</source>
        <translation>hat ein ungültiges oder zu langes Material, das übersprungen wurde</translation>
    </message>
    <message>
        <source>has a fill that was put below the lines that it covers</source>
        <translation>hat eine Füllung, die unter die Linien gelegt wurde, die sie bedeckt</translation>
    </message>
    <message>
        <source>has dashes that merge, because their ends became round</source>
        <translation>hat Striche, die zusammenlaufen, weil ihre Enden rund wurden</translation>
    </message>
    <message>
        <source>was skipped: it is in another file, which is not read</source>
        <translation>wurde übersprungen: es ist in einer anderen Datei, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>has a name of more than 4096 bytes, which was skipped</source>
        <translation>hat einen zu langen Namen, der übersprungen wurde</translation>
    </message>
    <message>
        <source>of the white-out eraser was read as ink of its colour</source>
        <translation>des Korrekturstifts wurde als Linie in dessen Farbe gelesen</translation>
    </message>
    <message>
        <source>is a broad nib; its longer side was used as the width</source>
        <translation>ist eine breite Feder; ihre längere Seite wurde zur Breite</translation>
    </message>
    <message>
        <source>was skipped: too many elements are repeated by &apos;use&apos;</source>
        <translation>wurde übersprungen: „use“ wiederholt zu viele Elemente</translation>
    </message>
    <message>
        <source>was made with the pen off the paper and was skipped</source>
        <translation>entstand mit abgehobenem Stift und wurde übersprungen</translation>
    </message>
    <message>
        <source>is painted with a pattern; a single colour was used</source>
        <translation>hat ein Muster; eine einzige Farbe wurde verwendet</translation>
    </message>
    <message>
        <source>refers to &apos;%1&apos; in another document, which is not read</source>
        <translation>verweist auf „%1“ in einem anderen Dokument, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>does not have a matrix of two rows of three numbers</source>
        <translation>hat keine Matrix aus zwei Zeilen mit je drei Zahlen</translation>
    </message>
    <message>
        <source>lost the references to the strokes around its fill</source>
        <translation>verlor die Verbindung zu den Linien um seine Füllung</translation>
    </message>
    <message>
        <source>is outside the frame that shows it and was skipped</source>
        <translation>liegt außerhalb des Rahmens, der es zeigt, und wurde übersprungen</translation>
    </message>
    <message>
        <source>has a width or height of 0 or less and was skipped</source>
        <translation>hat keine Breite oder Höhe und wurde übersprungen</translation>
    </message>
    <message>
        <source>has no extent after its transform and was skipped</source>
        <translation>hat nach seiner Transformation keine Ausdehnung und wurde übersprungen</translation>
    </message>
    <message>
        <source>paints its line below its fill, which was ignored</source>
        <translation>malt seine Linie unter seine Füllung, was nicht beachtet wurde</translation>
    </message>
    <message>
        <source>says %1, but the content is a %2 and was read as such</source>
        <translation>sagt %1, aber der Inhalt ist %2 und wurde so gelesen</translation>
    </message>
    <message>
        <source>has a %1 that could not be read, which was ignored</source>
        <translation>hat einen unlesbaren Wert (%1), der nicht beachtet wurde</translation>
    </message>
    <message>
        <source>%1; it was skipped, and its ink looks like pencil</source>
        <translation>Ein Material ist ungültig und wurde übersprungen; seine Linien sehen wie Bleistift aus</translation>
    </message>
    <message>
        <source>has a %1 that could not be read, and became black</source>
        <translation>hat einen unlesbaren Wert (%1) und wurde schwarz</translation>
    </message>
    <message>
        <source>fills the page and was used as the paper colour</source>
        <translation>füllt die Seite und wurde zur Farbe des Papiers</translation>
    </message>
    <message>
        <source>does not define its unit; 1/96 inch was assumed</source>
        <translation>nennt seine Einheit nicht; 1/96 Zoll wurde angenommen</translation>
    </message>
    <message>
        <source>shows part of a trace; the whole trace was read</source>
        <translation>zeigt einen Teil einer Linie; die ganze Linie wurde gelesen</translation>
    </message>
    <message>
        <source>was skipped: it follows the end of the drawing</source>
        <translation>wurde übersprungen: es steht hinter dem Ende der Zeichnung</translation>
    </message>
    <message>
        <source>has pointed or cut corners, which became round</source>
        <translation>hat spitze oder geschnittene Ecken, die rund wurden</translation>
    </message>
    <message>
        <source>has a last point without y, which was skipped</source>
        <translation>hat einen letzten Punkt ohne y, der übersprungen wurde</translation>
    </message>
    <message>
        <source>was skipped: it is nested more than 256 deep</source>
        <translation>wurde übersprungen: es ist mehr als 256-fach verschachtelt</translation>
    </message>
    <message>
        <source>was made with the eraser end and was skipped</source>
        <translation>entstand mit dem Radierer-Ende und wurde übersprungen</translation>
    </message>
    <message>
        <source>has times beyond 9e12 ms, which were ignored</source>
        <translation>hat unmögliche Zeiten, die nicht beachtet wurden</translation>
    </message>
    <message>
        <source>is thinner than 0.05 mm and became that wide</source>
        <translation>ist dünner als 0,05 mm und wurde so breit</translation>
    </message>
    <message>
        <source>has an invalid page size, which was ignored</source>
        <translation>hat eine ungültige Seitengröße, die nicht beachtet wurde</translation>
    </message>
    <message>
        <source>has an invalid transform, which was ignored</source>
        <translation>hat eine ungültige Transformation, die nicht beachtet wurde</translation>
    </message>
    <message>
        <source>has flat or square ends, which became round</source>
        <translation>hat gerade Enden, die rund wurden</translation>
    </message>
    <message>
        <source>has too many dashes and became a solid line</source>
        <translation>hat zu viele Striche und wurde zur durchgezogenen Linie</translation>
    </message>
    <message>
        <source>is not a known colour; it was read as black</source>
        <translation>ist keine bekannte Farbe und wurde schwarz</translation>
    </message>
    <message>
        <source>has too few widths; a single width was used</source>
        <translation>hat zu wenige Breiten; eine einzige wurde verwendet</translation>
    </message>
    <message>
        <source>is not two-dimensional and is not supported</source>
        <translation>ist nicht zweidimensional und wird nicht unterstützt</translation>
    </message>
    <message>
        <source>has a damaged curve; its points were read: %1</source>
        <translation>hat eine beschädigte Kurve; seine Punkte wurden gelesen</translation>
    </message>
    <message>
        <source>belongs to another program and was skipped</source>
        <translation>gehört zu einem anderen Programm und wurde übersprungen</translation>
    </message>
    <message>
        <source>has an impossible width, which was skipped</source>
        <translation>hat eine unmögliche Breite, die übersprungen wurde</translation>
    </message>
    <message>
        <source>has widths without a unit; mm was assumed</source>
        <translation>hat Breiten ohne Einheit; mm wurde angenommen</translation>
    </message>
    <message>
        <source>has a damaged curve; its points were read</source>
        <translation>hat eine beschädigte Kurve; seine Punkte wurden gelesen</translation>
    </message>
    <message>
        <source>does not form a stroke and was skipped: %1</source>
        <translation>ergibt keine Linie und wurde übersprungen</translation>
    </message>
    <message>
        <source>has no width; the default width was used</source>
        <translation>hat keine Breite; die übliche wurde verwendet</translation>
    </message>
    <message>
        <source>of type &apos;%1&apos; is a picture and was skipped</source>
        <translation>vom Typ „%1“ ist ein Bild und wurde übersprungen</translation>
    </message>
    <message>
        <source>is unknown in a context and was skipped</source>
        <translation>ist in einem Kontext unbekannt und wurde übersprungen</translation>
    </message>
    <message>
        <source>was skipped: animation is not supported</source>
        <translation>wurde übersprungen: Animationen gibt es hier nicht</translation>
    </message>
    <message>
        <source>has a %1 to something that does not exist</source>
        <translation>verweist mit %1 auf etwas, das es nicht gibt</translation>
    </message>
    <message>
        <source>is text, not a stroke, and was skipped</source>
        <translation>ist Text, keine Linie, und wurde übersprungen</translation>
    </message>
    <message>
        <source>does not form a fill and was skipped: %1</source>
        <translation>ergibt keine Füllung und wurde übersprungen</translation>
    </message>
    <message>
        <source>has times that run backwards in places</source>
        <translation>hat Zeiten, die stellenweise rückwärts laufen</translation>
    </message>
    <message>
        <source>of an unknown tool was read as a pen&apos;s</source>
        <translation>eines unbekannten Werkzeugs wurde als Linie eines Stifts gelesen</translation>
    </message>
    <message>
        <source>of form &apos;%1&apos; was replaced by a round one</source>
        <translation>der Form „%1“ wurde durch eine runde ersetzt</translation>
    </message>
    <message>
        <source>is hidden in the file and was skipped</source>
        <translation>ist in der Datei verborgen und wurde übersprungen</translation>
    </message>
    <message>
        <source>has an unknown colour; white was used</source>
        <translation>hat eine unbekannte Farbe; Weiß wurde verwendet</translation>
    </message>
    <message>
        <source>has an unknown colour; black was used</source>
        <translation>hat eine unbekannte Farbe; Schwarz wurde verwendet</translation>
    </message>
    <message>
        <source>%1; only the points before it were read</source>
        <translation>ist fehlerhaft; nur die Punkte davor wurden gelesen</translation>
    </message>
    <message>
        <source>has no unit of length; mm was assumed</source>
        <translation>hat keine Längeneinheit; mm wurde angenommen</translation>
    </message>
    <message>
        <source>extends beyond 1e9 mm and was skipped</source>
        <translation>ist unermesslich groß und wurde übersprungen</translation>
    </message>
    <message>
        <source>has too many choices and was skipped</source>
        <translation>hat zu viele Alternativen und wurde übersprungen</translation>
    </message>
    <message>
        <source>is not a valid width and was skipped</source>
        <translation>ist keine gültige Breite und wurde übersprungen</translation>
    </message>
    <message>
        <source>The picture of the layer &apos;%1&apos; is lost.</source>
        <translation>Das Bild der Ebene „%1“ ist verloren.</translation>
    </message>
    <message>
        <source>of style &apos;%1&apos;: its lines were skipped</source>
        <translation>der Art „%1“: die Linien darauf wurden übersprungen</translation>
    </message>
    <message>
        <source>has a blend mode, which was ignored</source>
        <translation>hat einen Mischmodus, der nicht beachtet wurde</translation>
    </message>
    <message>
        <source>and others were changed or skipped</source>
        <translation>und weiteres wurde geändert oder übersprungen</translation>
    </message>
    <message>
        <source>has a clip path, which was ignored</source>
        <translation>hat einen Beschneidungspfad, der nicht beachtet wurde</translation>
    </message>
    <message>
        <source>was skipped: scripts are not run</source>
        <translation>wurde übersprungen: Skripte werden nicht ausgeführt</translation>
    </message>
    <message>
        <source>was skipped: it refers to itself</source>
        <translation>wurde übersprungen: es verweist auf sich selbst</translation>
    </message>
    <message>
        <source>has no X or no Y and was skipped</source>
        <translation>hat kein X oder kein Y und wurde übersprungen</translation>
    </message>
    <message>
        <source>is not a stroke and was skipped</source>
        <translation>ist keine Linie und wurde übersprungen</translation>
    </message>
    <message>
        <source>has markers, which were skipped</source>
        <translation>hat Markierungen, die übersprungen wurden</translation>
    </message>
    <message>
        <source>has a filter, which was ignored</source>
        <translation>hat einen Filter, der nicht beachtet wurde</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is unknown and was skipped</source>
        <translation>„%1“ ist unbekannt und wurde übersprungen</translation>
    </message>
    <message>
        <source>has no points and was skipped</source>
        <translation>hat keine Punkte und wurde übersprungen</translation>
    </message>
    <message>
        <source>has a mask, which was ignored</source>
        <translation>hat eine Maske, die nicht beachtet wurde</translation>
    </message>
    <message>
        <source>has a zoom, which was ignored</source>
        <translation>hat einen Zoom, der nicht beachtet wurde</translation>
    </message>
    <message>
        <source>is a picture and was skipped</source>
        <translation>ist ein Bild und wurde übersprungen</translation>
    </message>
    <message>
        <source>has no size; A4 was assumed</source>
        <translation>hat keine Größe; A4 wurde angenommen</translation>
    </message>
    <message>
        <source>of type &apos;%1&apos; is not supported</source>
        <translation>vom Typ „%1“ kennt Feltline nicht</translation>
    </message>
    <message>
        <source>is unknown and was skipped</source>
        <translation>ist unbekannt und wurde übersprungen</translation>
    </message>
    <message>
        <source>was read up to an error: %1</source>
        <translation>wurde bis zu einem Fehler gelesen</translation>
    </message>
    <message>
        <source>lost the fill of its area</source>
        <translation>verlor die Füllung seiner Fläche</translation>
    </message>
    <message>
        <source>%1; the rest was skipped</source>
        <translation>ist fehlerhaft; der Rest wurde übersprungen</translation>
    </message>
    <message>
        <source>is no longer dashed</source>
        <translation>ist nicht mehr gestrichelt</translation>
    </message>
    <message>
        <source>got round ends</source>
        <translation>bekam runde Enden</translation>
    </message>
    <message>
        <source>was skipped: %1</source>
        <translation>wurde übersprungen</translation>
    </message>
    <message>
        <source>has no page</source>
        <translation>hat keine Seite</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>%1 (and %2 more like it)</source>
        <translation>%1 (und %2 weitere dieser Art)</translation>
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
        <source>Move the view</source>
        <translation>Ansicht verschieben</translation>
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
        <source>Use a tool temporarily</source>
        <translation>Werkzeug vorübergehend benutzen</translation>
    </message>
    <message>
        <source>Hold its key while you use it</source>
        <translation>Taste während der Benutzung gedrückt halten</translation>
    </message>
    <message>
        <source>Pen, mouse and held keys</source>
        <translation>Stift, Maus und gehaltene Tasten</translation>
    </message>
    <message>
        <source>Change the size</source>
        <translation>Größe ändern</translation>
    </message>
    <message>
        <source>Ctrl + Alt + drag</source>
        <translation>Strg + Alt + ziehen</translation>
    </message>
    <message>
        <source>Palette at the pointer</source>
        <translation>Palette am Zeiger</translation>
    </message>
    <message>
        <source>Click with the right button</source>
        <translation>Klick mit der rechten Taste</translation>
    </message>
    <message>
        <source>Move the selected lines by 1, 10 or 0.1 mm</source>
        <translation>Ausgewählte Linien um 1, 10 oder 0,1 mm verschieben</translation>
    </message>
    <message>
        <source>Arrow, Shift + arrow, Ctrl + arrow</source>
        <translation>Pfeil, Umschalt + Pfeil, Strg + Pfeil</translation>
    </message>
</context>
<context>
    <name>LayerActions</name>
    <message>
        <source>&amp;Add layer</source>
        <translation>Ebene &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Adds a layer above the current one.</source>
        <translation>Fügt eine Ebene über der aktuellen hinzu.</translation>
    </message>
    <message>
        <source>Remo&amp;ve layer</source>
        <translation>Ebene &amp;entfernen</translation>
    </message>
    <message>
        <source>Removes the layer and its lines.</source>
        <translation>Entfernt die Ebene und ihre Linien.</translation>
    </message>
    <message>
        <source>Re&amp;name layer</source>
        <translation>Ebene &amp;umbenennen</translation>
    </message>
    <message>
        <source>Changes the name of the layer.</source>
        <translation>Ändert den Namen der Ebene.</translation>
    </message>
    <message>
        <source>&amp;Raise layer</source>
        <translation>Ebene nach &amp;oben</translation>
    </message>
    <message>
        <source>Moves the layer up by one.</source>
        <translation>Verschiebt die Ebene um eins nach oben.</translation>
    </message>
    <message>
        <source>&amp;Lower layer</source>
        <translation>Ebene nach un&amp;ten</translation>
    </message>
    <message>
        <source>Moves the layer down by one.</source>
        <translation>Verschiebt die Ebene um eins nach unten.</translation>
    </message>
    <message>
        <source>Draw on the layer &amp;above</source>
        <translation>Auf der Ebene &amp;darüber zeichnen</translation>
    </message>
    <message>
        <source>New lines go to the next layer up.</source>
        <translation>Neue Linien kommen auf die nächste Ebene darüber.</translation>
    </message>
    <message>
        <source>Draw on the layer &amp;below</source>
        <translation>Auf der Ebene dar&amp;unter zeichnen</translation>
    </message>
    <message>
        <source>New lines go to the next layer down.</source>
        <translation>Neue Linien kommen auf die nächste Ebene darunter.</translation>
    </message>
    <message>
        <source>&amp;Show layer</source>
        <translation>Ebene an&amp;zeigen</translation>
    </message>
    <message>
        <source>Shows or hides the lines on the layer.</source>
        <translation>Zeigt die Linien der Ebene an oder blendet sie aus.</translation>
    </message>
    <message>
        <source>Loc&amp;k layer</source>
        <translation>Ebene &amp;sperren</translation>
    </message>
    <message>
        <source>Protects the layer against changes.</source>
        <translation>Schützt die Ebene vor Änderungen.</translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation>Ebene &amp;duplizieren</translation>
    </message>
    <message>
        <source>Adds a copy of the layer above it.</source>
        <translation>Fügt darüber eine Kopie der Ebene hinzu.</translation>
    </message>
    <message>
        <source>&amp;Merge layer down</source>
        <translation>Mit der Ebene darunter &amp;vereinen</translation>
    </message>
    <message>
        <source>Moves the lines of the layer to the one below.</source>
        <translation>Verschiebt die Linien der Ebene auf die Ebene darunter.</translation>
    </message>
    <message>
        <source>&amp;Export the picture</source>
        <translation>Bild &amp;exportieren</translation>
    </message>
    <message>
        <source>Shows the picture of the layer in exported files.</source>
        <translation>Zeigt das Bild der Ebene in exportierten Dateien.</translation>
    </message>
    <message>
        <source>&amp;Group layers</source>
        <translation>Ebenen &amp;gruppieren</translation>
    </message>
    <message>
        <source>Groups the layer with the one below, or puts it into the group below.</source>
        <translation>Gruppiert die Ebene mit der darunter oder legt sie in die Gruppe darunter.</translation>
    </message>
    <message>
        <source>&amp;Ungroup layers</source>
        <translation>Gruppe a&amp;uflösen</translation>
    </message>
    <message>
        <source>Dissolves the group; its layers stay.</source>
        <translation>Löst die Gruppe auf; ihre Ebenen bleiben.</translation>
    </message>
    <message>
        <source>&amp;Take out of the group</source>
        <translation>Aus der Gruppe neh&amp;men</translation>
    </message>
    <message>
        <source>Puts the layer above its group.</source>
        <translation>Legt die Ebene über ihre Gruppe.</translation>
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
        <translation>hügelige Körnung</translation>
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
        <source>covers the grain</source>
        <translation>überdeckt die Körnung</translation>
    </message>
    <message>
        <source>grain is felt but not visible</source>
        <translation>Körnung spürbar, aber nicht sichtbar</translation>
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
    <message>
        <source>Dashed pen</source>
        <translation>Strichelstift</translation>
    </message>
    <message>
        <source>Double line</source>
        <translation>Doppellinie</translation>
    </message>
    <message>
        <source>Arrow pen</source>
        <translation>Pfeilstift</translation>
    </message>
    <message>
        <source>Rope</source>
        <translation>Seil</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Hatched pen</source>
        <translation>Schraffurstift</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;Guides</source>
        <translation>&amp;Hilfslinien</translation>
    </message>
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
        <translation>&amp;Scrollen</translation>
    </message>
    <message>
        <source>Pal&amp;ette</source>
        <translation>&amp;Palette</translation>
    </message>
    <message>
        <source>S&amp;urface</source>
        <translation>&amp;Untergrund</translation>
    </message>
    <message>
        <source>Export the so&amp;lid</source>
        <translation>Kör&amp;per exportieren</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
</context>
<context>
    <name>OfferPopup</name>
    <message>
        <source>Delete 1 line</source>
        <translation>1 Linie löschen</translation>
    </message>
    <message>
        <source>Delete %1 lines</source>
        <translation>%1 Linien löschen</translation>
    </message>
    <message>
        <source>Select 1 line</source>
        <translation>1 Linie auswählen</translation>
    </message>
    <message>
        <source>Select %1 lines</source>
        <translation>%1 Linien auswählen</translation>
    </message>
    <message>
        <source>Straight line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>Keep the ink</source>
        <translation>Tinte behalten</translation>
    </message>
    <message>
        <source>Take the &amp;offer at the pen</source>
        <translation>&amp;Angebot am Stift annehmen</translation>
    </message>
    <message>
        <source>Chooses what the last stroke is offered to mean: a gesture or a shape.</source>
        <translation>Wählt, was der letzte Strich bedeuten kann: eine Geste oder eine Form.</translation>
    </message>
    <message>
        <source>Take the &amp;second offer at the pen</source>
        <translation>&amp;Zweites Angebot am Stift annehmen</translation>
    </message>
    <message>
        <source>Chooses the second meaning, if two are offered.</source>
        <translation>Wählt die zweite Bedeutung, wenn zwei angeboten werden.</translation>
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
        <source>Press harder to draw a wider line. If off, every line has the same width.</source>
        <translation>Fester drücken zeichnet breitere Linien. Wenn aus, sind alle Linien gleich breit.</translation>
    </message>
    <message>
        <source>Hold the &amp;first modifier</source>
        <translation>&amp;Erste Zusatztaste halten</translation>
    </message>
    <message>
        <source>Acts as if Shift were held, until you choose this again.</source>
        <translation>Wirkt wie gehaltene Umschalttaste, bis der Befehl erneut gewählt wird.</translation>
    </message>
    <message>
        <source>Hold the &amp;second modifier</source>
        <translation>&amp;Zweite Zusatztaste halten</translation>
    </message>
    <message>
        <source>Acts as if Ctrl were held, until you choose this again.</source>
        <translation>Wirkt wie gehaltene Strg-Taste, bis der Befehl erneut gewählt wird.</translation>
    </message>
</context>
<context>
    <name>PenDevice</name>
    <message>
        <source>Simulated: %1</source>
        <translation>Simuliert: %1</translation>
    </message>
    <message>
        <source>The ink follows the pen exactly. Forces are shown, not felt.</source>
        <translation>Die Tinte folgt dem Stift genau. Kräfte werden angezeigt, sind aber nicht zu spüren.</translation>
    </message>
    <message>
        <source>Mouse or pen move a simulated hand that holds this stylus. Forces move the ink, so that you see what they would feel like.</source>
        <translation>Maus oder Stift bewegen eine simulierte Hand, die diesen Stift hält. Kräfte verschieben die Tinte und zeigen so, wie es sich anfühlen würde.</translation>
    </message>
    <message>
        <source>Simulated %1</source>
        <translation>%1, simuliert</translation>
    </message>
    <message>
        <source>You hold it in your hand and feel the forces.</source>
        <translation>Sie halten es in der Hand und spüren die Kräfte.</translation>
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
    <name>PresetMenu</name>
    <message>
        <source>%1, %2 mm</source>
        <extracomment>a medium and its size</extracomment>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Als Vorgabe behalten</translation>
    </message>
    <message>
        <source>Name for this medium, size, colour and options:</source>
        <translation>Name für dieses Zeichenmittel mit Größe, Farbe und Optionen:</translation>
    </message>
    <message>
        <source>&amp;Keep as a preset…</source>
        <translation>Als Vorgabe be&amp;halten …</translation>
    </message>
    <message>
        <source>Keeps the medium, the size, the colour and the options of the pencil under a name.</source>
        <translation>Behält Zeichenmittel, Größe, Farbe und Optionen des Stifts unter einem Namen.</translation>
    </message>
</context>
<context>
    <name>QuestionScreen</name>
    <message>
        <source>Mental demand</source>
        <translation>Geistige Anforderung</translation>
    </message>
    <message>
        <source>How mentally demanding was the task?</source>
        <translation>Wie hoch waren die geistigen Anforderungen der Aufgabe?</translation>
    </message>
    <message>
        <source>Very low</source>
        <translation>Sehr gering</translation>
    </message>
    <message>
        <source>Very high</source>
        <translation>Sehr hoch</translation>
    </message>
    <message>
        <source>Physical demand</source>
        <translation>Körperliche Anforderung</translation>
    </message>
    <message>
        <source>How physically demanding was the task?</source>
        <translation>Wie hoch waren die körperlichen Anforderungen der Aufgabe?</translation>
    </message>
    <message>
        <source>Temporal demand</source>
        <translation>Zeitliche Anforderung</translation>
    </message>
    <message>
        <source>How hurried or rushed was the pace of the task?</source>
        <translation>Wie hoch war das Tempo, mit dem die Aufgabe zu erledigen war?</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>How successful were you in accomplishing what you were asked to do?</source>
        <translation>Wie erfolgreich haben Sie die gestellte Aufgabe Ihrer Meinung nach ausgeführt?</translation>
    </message>
    <message>
        <source>Perfect</source>
        <translation>Perfekt</translation>
    </message>
    <message>
        <source>Failure</source>
        <translation>Misserfolg</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Anstrengung</translation>
    </message>
    <message>
        <source>How hard did you have to work to accomplish your level of performance?</source>
        <translation>Wie sehr mussten Sie sich anstrengen, um Ihre Leistung zu erreichen?</translation>
    </message>
    <message>
        <source>Frustration</source>
        <translation>Frustration</translation>
    </message>
    <message>
        <source>How insecure, discouraged, irritated, stressed and annoyed were you?</source>
        <translation>Wie verunsichert, entmutigt, gereizt, gestresst und verärgert waren Sie?</translation>
    </message>
    <message>
        <source>obstructive</source>
        <translation>behindernd</translation>
    </message>
    <message>
        <source>supportive</source>
        <translation>unterstützend</translation>
    </message>
    <message>
        <source>complicated</source>
        <translation>kompliziert</translation>
    </message>
    <message>
        <source>easy</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>inefficient</source>
        <translation>ineffizient</translation>
    </message>
    <message>
        <source>efficient</source>
        <translation>effizient</translation>
    </message>
    <message>
        <source>confusing</source>
        <translation>verwirrend</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>übersichtlich</translation>
    </message>
    <message>
        <source>boring</source>
        <translation>langweilig</translation>
    </message>
    <message>
        <source>exciting</source>
        <translation>spannend</translation>
    </message>
    <message>
        <source>not interesting</source>
        <translation>uninteressant</translation>
    </message>
    <message>
        <source>interesting</source>
        <translation>interessant</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>konventionell</translation>
    </message>
    <message>
        <source>inventive</source>
        <translation>originell</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>herkömmlich</translation>
    </message>
    <message>
        <source>leading edge</source>
        <translation>neuartig</translation>
    </message>
</context>
<context>
    <name>SafetyWords</name>
    <message>
        <source>the force limit</source>
        <translation>die Kraftgrenze</translation>
    </message>
    <message>
        <source>the continuous force of the motors</source>
        <translation>die Dauerkraft der Motoren</translation>
    </message>
    <message>
        <source>the speed of the pen</source>
        <translation>die Geschwindigkeit des Stifts</translation>
    </message>
    <message>
        <source>the limit on how fast a force may rise</source>
        <translation>die Grenze für den Anstieg einer Kraft</translation>
    </message>
    <message>
        <source>the largest stiffness of the device</source>
        <translation>die größte Steifigkeit des Geräts</translation>
    </message>
    <message>
        <source>Limited by %1.</source>
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
        <translation>Prüfen Sie Kabel und Stromversorgung des Geräts und schalten Sie die Kräfte dann wieder ein.</translation>
    </message>
    <message>
        <source>You can continue to draw. Lift the pen and switch the forces on again.</source>
        <translation>Sie können weiterzeichnen. Heben Sie den Stift ab und schalten Sie die Kräfte wieder ein.</translation>
    </message>
    <message>
        <source>the computer was too busy</source>
        <translation>der Computer war ausgelastet</translation>
    </message>
    <message>
        <source>the pen was too fast</source>
        <translation>der Stift war zu schnell</translation>
    </message>
    <message>
        <source>the program was too busy</source>
        <translation>das Programm war ausgelastet</translation>
    </message>
    <message>
        <source>the computer paused for a moment</source>
        <translation>der Computer hielt einen Moment an</translation>
    </message>
    <message>
        <source>a force was invalid</source>
        <translation>eine Kraft war ungültig</translation>
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
        <translation>Wird angezeigt, nicht gespürt: Dieser Stift hat keine Motoren</translation>
    </message>
    <message>
        <source>The plot shows the forces that a device would be asked for.</source>
        <translation>Das Diagramm zeigt die Kräfte, die von einem Gerät angefordert würden.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Lift the pen for a moment to start the forces.</source>
        <translation>Heben Sie den Stift kurz ab, um die Kräfte zu starten.</translation>
    </message>
    <message>
        <source>Forces are starting</source>
        <translation>Die Kräfte setzen ein</translation>
    </message>
    <message>
        <source>The program is busy</source>
        <translation>Das Programm ist beschäftigt</translation>
    </message>
    <message>
        <source>The pen only feels damping.</source>
        <translation>Der Stift spürt nur eine Dämpfung.</translation>
    </message>
    <message>
        <source>Forces are reduced: %1</source>
        <translation>Die Kräfte sind verringert: %1</translation>
    </message>
    <message>
        <source>They return by themselves.</source>
        <translation>Sie kehren von selbst zurück.</translation>
    </message>
    <message>
        <source>Sum, requested</source>
        <translation>Summe, angefordert</translation>
    </message>
    <message>
        <source>Sent to the pen</source>
        <translation>An den Stift gesendet</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Untergrund</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Zähigkeit</translation>
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
        <source>You can continue to draw. Switch the forces on at the device, lift the pen, then switch them on here.</source>
        <translation>Sie können weiterzeichnen. Schalten Sie die Kräfte am Gerät ein, heben Sie den Stift ab und schalten Sie sie dann hier ein.</translation>
    </message>
    <message>
        <source>You can continue to draw. Let the device rest for a few minutes, then switch the forces on again.</source>
        <translation>Sie können weiterzeichnen. Lassen Sie das Gerät einige Minuten ruhen und schalten Sie die Kräfte dann wieder ein.</translation>
    </message>
    <message>
        <source>the computer or the device could not keep up several times in a minute</source>
        <translation>Computer oder Gerät kamen mehrmals in einer Minute nicht hinterher</translation>
    </message>
</context>
<context>
    <name>SolidActions</name>
    <message>
        <source>&amp;STL…</source>
        <translation>&amp;STL…</translation>
    </message>
    <message>
        <source>Writes the solid as triangles, for printing</source>
        <translation>Schreibt den Körper als Dreiecke, zum Drucken</translation>
    </message>
    <message>
        <source>STL file (*.stl)</source>
        <translation>STL-Datei (*.stl)</translation>
    </message>
    <message>
        <source>&amp;3MF…</source>
        <translation>&amp;3MF…</translation>
    </message>
    <message>
        <source>Writes the solid with its unit and colours, for printing</source>
        <translation>Schreibt den Körper mit Einheit und Farben, zum Drucken</translation>
    </message>
    <message>
        <source>3MF file (*.3mf)</source>
        <translation>3MF-Datei (*.3mf)</translation>
    </message>
    <message>
        <source>&amp;OBJ…</source>
        <translation>&amp;OBJ…</translation>
    </message>
    <message>
        <source>Writes the solid for any 3D program</source>
        <translation>Schreibt den Körper für beliebige 3D-Programme</translation>
    </message>
    <message>
        <source>Wavefront file (*.obj)</source>
        <translation>Wavefront-Datei (*.obj)</translation>
    </message>
    <message>
        <source>&amp;glTF…</source>
        <translation>&amp;glTF…</translation>
    </message>
    <message>
        <source>Writes the solid with colours and smooth shading, for 3D programs and web pages</source>
        <translation>Schreibt den Körper mit Farben und glatter Schattierung, für 3D-Programme und Webseiten</translation>
    </message>
    <message>
        <source>Binary glTF file (*.glb)</source>
        <translation>Binäre glTF-Datei (*.glb)</translation>
    </message>
    <message>
        <source>Export the solid</source>
        <translation>Körper exportieren</translation>
    </message>
    <message>
        <source>“%1” was not exported</source>
        <translation>„%1“ wurde nicht exportiert</translation>
    </message>
    <message>
        <source>The paint on the body was left out, because the format has none; glTF has it.</source>
        <translation>Die Farbe auf dem Körper wurde weggelassen, weil das Format keine hat; glTF hat sie.</translation>
    </message>
</context>
<context>
    <name>SolidWords</name>
    <message>
        <source>left out: edit %1 of the body, the cut that begins at (%2, %3) mm: %4</source>
        <translation>weggelassen: Bearbeitung %1 des Körpers, der Schnitt, der bei (%2, %3) mm beginnt: %4</translation>
    </message>
    <message>
        <source>left out: edit %1 of the body, the extrusion that begins at (%2, %3) mm: %4</source>
        <translation>weggelassen: Bearbeitung %1 des Körpers, die Extrusion, die bei (%2, %3) mm beginnt: %4</translation>
    </message>
    <message>
        <source>left out: edit %1 of the body, the painted line that begins at (%2, %3) mm: %4</source>
        <translation>weggelassen: Bearbeitung %1 des Körpers, die gemalte Linie, die bei (%2, %3) mm beginnt: %4</translation>
    </message>
    <message>
        <source>left out: edit %1 of the body, the smoothing that begins at (%2, %3) mm: %4</source>
        <translation>weggelassen: Bearbeitung %1 des Körpers, die Glättung, die bei (%2, %3) mm beginnt: %4</translation>
    </message>
    <message>
        <source>left out the smaller part: %1</source>
        <translation>der kleinere Teil wurde weggelassen: %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelassen: %1</translation>
    </message>
    <message>
        <source>left out %1 small closed line, %2</source>
        <translation>%1 kleine geschlossene Linie wurde weggelassen: die %2</translation>
    </message>
    <message>
        <source>left out %1 small closed lines, the largest %2</source>
        <translation>%1 kleine geschlossene Linien wurden weggelassen, die größte %2</translation>
    </message>
    <message>
        <source>every closed outline is too small or too narrow; the largest is that %1</source>
        <translation>jeder geschlossene Umriss ist zu klein oder zu schmal; der größte ist der %1</translation>
    </message>
    <message>
        <source>of stroke %1 at (%2, %3) mm, %4 x %5 mm</source>
        <translation>des Strichs %1 bei (%2, %3) mm, %4 x %5 mm</translation>
    </message>
    <message>
        <source>at (%1, %2) mm, %3 x %4 mm</source>
        <translation>bei (%1, %2) mm, %3 x %4 mm</translation>
    </message>
    <message>
        <source>contains no closed outline: there is a gap of %1 mm at (%2, %3) mm, at the end of stroke %4</source>
        <translation>es gibt keinen geschlossenen Umriss: Bei (%2, %3) mm, am Ende des Strichs %4, ist eine Lücke von %1 mm</translation>
    </message>
    <message>
        <source>contains no closed outline</source>
        <translation>es gibt keinen geschlossenen Umriss</translation>
    </message>
    <message>
        <source>stroke %1 retraces the outline of stroke %2 at a distance of %3 mm; it was not treated as a hole</source>
        <translation>Strich %1 zeichnet den Umriss von Strich %2 noch einmal, %3 mm daneben, und macht kein Loch</translation>
    </message>
    <message>
        <source>the lines are too dense at (%1, %2) mm to find an outline: %3 mm of line within %4 mm, but at most %5 mm can be; smooth the line</source>
        <translation>die Linien sind bei (%1, %2) mm zu dicht, um einen Umriss zu finden: %3 mm Linie innerhalb von %4 mm, höchstens möglich sind %5 mm; glätten Sie die Linie</translation>
    </message>
    <message>
        <source>contains no visible strokes</source>
        <translation>es gibt keine sichtbaren Striche</translation>
    </message>
    <message>
        <source>has more than 100,000 visible strokes</source>
        <translation>es gibt mehr als 100.000 sichtbare Striche</translation>
    </message>
    <message>
        <source>an option for solids is out of range</source>
        <translation>eine Option für Körper liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>stroke %1 crosses itself at (%2, %3) mm, so its parts meet in only one point</source>
        <translation>Strich %1 kreuzt sich bei (%2, %3) mm selbst, sodass seine Teile sich nur in einem Punkt berühren</translation>
    </message>
    <message>
        <source>strokes %1 and %2 enclose areas that meet in only one point, (%3, %4) mm: let them overlap, or move them apart</source>
        <translation>die Striche %1 und %2 umschließen Flächen, die sich nur in einem Punkt berühren, (%3, %4) mm: Lassen Sie sie überlappen, oder rücken Sie sie auseinander</translation>
    </message>
    <message>
        <source>lines enclose areas that meet in only one point, (%1, %2) mm: let them overlap, or move them apart</source>
        <translation>Linien umschließen Flächen, die sich nur in einem Punkt berühren, (%1, %2) mm: Lassen Sie sie überlappen, oder rücken Sie sie auseinander</translation>
    </message>
    <message>
        <source>the outline of stroke %1 only touches its mirror axis at (%2, %3) mm</source>
        <translation>der Umriss des Strichs %1 berührt seine Spiegelachse nur, bei (%2, %3) mm</translation>
    </message>
    <message>
        <source>the outline of stroke %1 touches or crosses itself at (%2, %3) mm</source>
        <translation>der Umriss des Strichs %1 berührt oder kreuzt sich selbst bei (%2, %3) mm</translation>
    </message>
    <message>
        <source>the outline of stroke %1 is too narrow at (%2, %3) mm</source>
        <translation>der Umriss des Strichs %1 ist bei (%2, %3) mm zu schmal</translation>
    </message>
    <message>
        <source>stroke %1: %2</source>
        <translation>Strich %1: %2</translation>
    </message>
    <message>
        <source>the outline nearly touches itself at (%1, %2) mm</source>
        <translation>der Umriss berührt sich fast selbst bei (%1, %2) mm</translation>
    </message>
    <message>
        <source>the outline is too narrow at (%1, %2) mm</source>
        <translation>der Umriss ist bei (%1, %2) mm zu schmal</translation>
    </message>
    <message>
        <source>the surface is not closed at (%1, %2) mm</source>
        <translation>die Oberfläche ist bei (%1, %2) mm nicht geschlossen</translation>
    </message>
    <message>
        <source>the outline has equal points</source>
        <translation>der Umriss hat gleiche Punkte</translation>
    </message>
    <message>
        <source>the outline has no area</source>
        <translation>der Umriss hat keine Fläche</translation>
    </message>
    <message>
        <source>the outline has too many narrow parts</source>
        <translation>der Umriss hat zu viele schmale Stellen</translation>
    </message>
    <message>
        <source>the outline cannot be filled</source>
        <translation>der Umriss kann nicht gefüllt werden</translation>
    </message>
    <message>
        <source>no point is on the border</source>
        <translation>kein Punkt liegt auf dem Rand</translation>
    </message>
    <message>
        <source>the heights of the body cannot be computed</source>
        <translation>die Höhen des Körpers können nicht berechnet werden</translation>
    </message>
    <message>
        <source>a coordinate of the body is not a number</source>
        <translation>eine Koordinate des Körpers ist keine Zahl</translation>
    </message>
    <message>
        <source>the body has no surface</source>
        <translation>der Körper hat keine Oberfläche</translation>
    </message>
    <message>
        <source>the stroke does not touch a body</source>
        <translation>der Strich trifft keinen Körper</translation>
    </message>
    <message>
        <source>the stroke does not touch the body</source>
        <translation>der Strich trifft den Körper nicht</translation>
    </message>
    <message>
        <source>the stroke has no length</source>
        <translation>der Strich hat keine Länge</translation>
    </message>
    <message>
        <source>the stroke is too long</source>
        <translation>der Strich ist zu lang</translation>
    </message>
    <message>
        <source>the stroke begins on the body</source>
        <translation>der Strich beginnt auf dem Körper</translation>
    </message>
    <message>
        <source>the stroke ends on the body</source>
        <translation>der Strich endet auf dem Körper</translation>
    </message>
    <message>
        <source>the stroke crosses itself</source>
        <translation>der Strich kreuzt sich selbst</translation>
    </message>
    <message>
        <source>the stroke does not cut off a part of the body</source>
        <translation>der Strich schneidet keinen Teil des Körpers ab</translation>
    </message>
    <message>
        <source>the stroke turns too sharply beside the body</source>
        <translation>der Strich biegt neben dem Körper zu scharf ab</translation>
    </message>
    <message>
        <source>nothing of the body would remain</source>
        <translation>vom Körper bliebe nichts übrig</translation>
    </message>
    <message>
        <source>the cut runs along the surface of the body</source>
        <translation>der Schnitt verläuft entlang der Oberfläche des Körpers</translation>
    </message>
    <message>
        <source>the profile has too few points</source>
        <translation>das Profil hat zu wenige Punkte</translation>
    </message>
    <message>
        <source>the profile begins and ends at the same point</source>
        <translation>das Profil beginnt und endet am selben Punkt</translation>
    </message>
    <message>
        <source>the profile leads into the body</source>
        <translation>das Profil führt in den Körper hinein</translation>
    </message>
    <message>
        <source>the profile is too flat</source>
        <translation>das Profil ist zu flach</translation>
    </message>
    <message>
        <source>the closed line bends around the body too far</source>
        <translation>die geschlossene Linie biegt sich zu weit um den Körper</translation>
    </message>
    <message>
        <source>the body is too thin below the closed line</source>
        <translation>der Körper ist unter der geschlossenen Linie zu dünn</translation>
    </message>
    <message>
        <source>the extruded part would cross itself</source>
        <translation>der extrudierte Teil würde sich selbst kreuzen</translation>
    </message>
    <message>
        <source>the closed line has too few points</source>
        <translation>die geschlossene Linie hat zu wenige Punkte</translation>
    </message>
    <message>
        <source>the closed line has no length</source>
        <translation>die geschlossene Linie hat keine Länge</translation>
    </message>
    <message>
        <source>the closed line crosses itself</source>
        <translation>die geschlossene Linie kreuzt sich selbst</translation>
    </message>
    <message>
        <source>the closed line is not wholly on the body</source>
        <translation>die geschlossene Linie liegt nicht ganz auf dem Körper</translation>
    </message>
    <message>
        <source>the closed line encloses nothing</source>
        <translation>die geschlossene Linie umschließt nichts</translation>
    </message>
    <message>
        <source>the extruded part would touch the body elsewhere</source>
        <translation>der extrudierte Teil würde den Körper an anderer Stelle berühren</translation>
    </message>
    <message>
        <source>the extruded part runs along the surface of the body</source>
        <translation>der extrudierte Teil verläuft entlang der Oberfläche des Körpers</translation>
    </message>
    <message>
        <source>the painted line has no width</source>
        <translation>die gemalte Linie hat keine Breite</translation>
    </message>
    <message>
        <source>the surface cannot be smoothed there</source>
        <translation>die Oberfläche kann dort nicht geglättet werden</translation>
    </message>
    <message>
        <source>the smoothed surface would fold; smooth less at once</source>
        <translation>die geglättete Oberfläche würde sich falten; glätten Sie weniger auf einmal</translation>
    </message>
    <message>
        <source>parts of the body would meet in only a point or a line</source>
        <translation>Teile des Körpers würden sich nur in einem Punkt oder einer Linie berühren</translation>
    </message>
    <message>
        <source>the surface of the body crosses itself there</source>
        <translation>die Oberfläche des Körpers kreuzt sich dort selbst</translation>
    </message>
    <message>
        <source>the surfaces cannot be joined</source>
        <translation>die Oberflächen können nicht verbunden werden</translation>
    </message>
</context>
<context>
    <name>Stability</name>
    <message>
        <source>Stable, as requested</source>
        <translation>Stabil, wie eingestellt</translation>
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
        <source>Stable, but less than requested</source>
        <translation>Stabil, aber weniger als eingestellt</translation>
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
        <source>The pen at rest trembles with %1 N above 30 Hz; 0.04 N can be felt. Reduce hardness or friction, or add damping.</source>
        <translation>Der ruhende Stift zittert mit %1 N über 30 Hz; ab 0,04 N ist das spürbar. Verringern Sie Härte oder Reibung oder erhöhen Sie die Dämpfung.</translation>
    </message>
    <message>
        <source>%1 has no motors, so nothing is felt. The figures are those of a 3D Systems Touch.</source>
        <translation>%1 hat keine Motoren, daher ist nichts zu spüren. Die Werte gelten für einen 3D Systems Touch.</translation>
    </message>
    <message>
        <source>%1 % of the device’s limit</source>
        <translation>%1 % der Grenze des Geräts</translation>
    </message>
    <message>
        <source>Hardness: this device reaches %1 of your %2 N/m.</source>
        <translation>Härte: Dieses Gerät erreicht %1 von %2 N/m.</translation>
    </message>
    <message>
        <source>Grain: it is too steep for the haptic loop; you feel %1 of your %2 µm.</source>
        <translation>Körnung: Sie ist zu steil für die Regelschleife; zu spüren sind %1 von %2 µm.</translation>
    </message>
</context>
<context>
    <name>SwellWords</name>
    <message>
        <source>Lines widened: %1.</source>
        <translation>Verbreiterte Linien: %1.</translation>
    </message>
    <message>
        <source>Lines with another width: %1.</source>
        <translation>Linien mit anderer Breite: %1.</translation>
    </message>
    <message>
        <source>Lines made black: %1.</source>
        <translation>Geschwärzte Linien: %1.</translation>
    </message>
    <message>
        <source>Areas with a texture: %1.</source>
        <translation>Flächen mit Muster: %1.</translation>
    </message>
    <message>
        <source>Areas too narrow for a texture: %1.</source>
        <translation>Für ein Muster zu schmale Flächen: %1.</translation>
    </message>
    <message>
        <source>Lines left out, because they are not seen: %1.</source>
        <translation>Weggelassene Linien, weil man sie nicht sieht: %1.</translation>
    </message>
    <message>
        <source>Areas left out, because they are not seen: %1.</source>
        <translation>Weggelassene Flächen, weil man sie nicht sieht: %1.</translation>
    </message>
    <message>
        <source>Pictures left out: %1.</source>
        <translation>Weggelassene Bilder: %1.</translation>
    </message>
    <message>
        <source>Faults that a fingertip would notice: %1. The panel “Tactile check” shows them.</source>
        <translation>Fehler, die eine Fingerspitze bemerken würde: %1. Das Bedienfeld „Tastprüfung“ zeigt sie.</translation>
    </message>
    <message>
        <source>Some colours share a texture.</source>
        <translation>Manche Farben teilen sich ein Muster.</translation>
    </message>
</context>
<context>
    <name>ToolActions</name>
    <message>
        <source>S&amp;maller</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Makes the current tool smaller.</source>
        <translation>Verkleinert das aktuelle Werkzeug.</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Größer</translation>
    </message>
    <message>
        <source>Makes the current tool larger.</source>
        <translation>Vergrößert das aktuelle Werkzeug.</translation>
    </message>
    <message>
        <source>Forces &amp;weaker</source>
        <translation>Kräfte &amp;schwächer</translation>
    </message>
    <message>
        <source>The current tool resists less.</source>
        <translation>Das aktuelle Werkzeug leistet weniger Widerstand.</translation>
    </message>
    <message>
        <source>Forces &amp;stronger</source>
        <translation>Kräfte s&amp;tärker</translation>
    </message>
    <message>
        <source>The current tool resists more.</source>
        <translation>Das aktuelle Werkzeug leistet mehr Widerstand.</translation>
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
        <source>The largest size is %1 mm.</source>
        <translation>Die maximale Größe ist %1 mm.</translation>
    </message>
    <message>
        <source>The smallest size is %1 mm.</source>
        <translation>Die minimale Größe ist %1 mm.</translation>
    </message>
</context>
<context>
    <name>ViewActions</name>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Shows the drawing larger, around the pointer</source>
        <translation>Vergrößert die Ansicht um den Zeiger</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Shows the drawing smaller, around the pointer</source>
        <translation>Verkleinert die Ansicht um den Zeiger</translation>
    </message>
    <message>
        <source>&amp;Life size</source>
        <translation>&amp;Originalgröße</translation>
    </message>
    <message>
        <source>One millimetre of the drawing is one millimetre on the screen</source>
        <translation>Ein Millimeter der Zeichnung entspricht einem Millimeter auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Fit &amp;selection</source>
        <translation>&amp;Auswahl einpassen</translation>
    </message>
    <message>
        <source>Shows the selection as large as possible</source>
        <translation>Zeigt die Auswahl so groß wie möglich</translation>
    </message>
    <message>
        <source>Fit &amp;page</source>
        <translation>Se&amp;ite einpassen</translation>
    </message>
    <message>
        <source>Shows the whole page</source>
        <translation>Zeigt die ganze Seite</translation>
    </message>
    <message>
        <source>Fit &amp;drawing</source>
        <translation>&amp;Zeichnung einpassen</translation>
    </message>
    <message>
        <source>Shows all ink, including any outside the page</source>
        <translation>Zeigt alle Linien, auch außerhalb der Seite</translation>
    </message>
    <message>
        <source>Turn l&amp;eft</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turns the view anticlockwise; the drawing does not change</source>
        <translation>Dreht die Ansicht gegen den Uhrzeigersinn; die Zeichnung ändert sich nicht</translation>
    </message>
    <message>
        <source>Turn ri&amp;ght</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turns the view clockwise; the drawing does not change</source>
        <translation>Dreht die Ansicht im Uhrzeigersinn; die Zeichnung ändert sich nicht</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>Au&amp;frecht</translation>
    </message>
    <message>
        <source>Turns the view back upright</source>
        <translation>Dreht die Ansicht wieder aufrecht</translation>
    </message>
    <message>
        <source>&amp;Mirror view</source>
        <translation>Ansicht &amp;spiegeln</translation>
    </message>
    <message>
        <source>Swaps left and right in the view, to check proportions; the drawing does not change</source>
        <translation>Vertauscht links und rechts in der Ansicht, um Proportionen zu prüfen; die Zeichnung ändert sich nicht</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Nach links scrollen</translation>
    </message>
    <message>
        <source>Moves the view to the left</source>
        <translation>Verschiebt die Ansicht nach links</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Nach rechts scrollen</translation>
    </message>
    <message>
        <source>Moves the view to the right</source>
        <translation>Verschiebt die Ansicht nach rechts</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Nach oben scrollen</translation>
    </message>
    <message>
        <source>Moves the view up</source>
        <translation>Verschiebt die Ansicht nach oben</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Nach unten scrollen</translation>
    </message>
    <message>
        <source>Moves the view down</source>
        <translation>Verschiebt die Ansicht nach unten</translation>
    </message>
    <message>
        <source>Ou&amp;tlines</source>
        <translation>&amp;Umrisse</translation>
    </message>
    <message>
        <source>Shows only the centre line of each stroke</source>
        <translation>Zeigt nur die Mittellinie jedes Strichs</translation>
    </message>
    <message>
        <source>&amp;Force arrow</source>
        <translation>Kraft&amp;pfeil</translation>
    </message>
    <message>
        <source>Shows the direction and size of the force at the nib</source>
        <translation>Zeigt Richtung und Stärke der Kraft an der Spitze</translation>
    </message>
    <message>
        <source>&amp;Nib moves with forces</source>
        <translation>Spitze folgt den Kräfte&amp;n</translation>
    </message>
    <message>
        <source>With a simulated stylus, shows the nib where forces move it</source>
        <translation>Zeigt bei einem simulierten Stift die Spitze dort, wohin die Kräfte sie bewegen</translation>
    </message>
    <message>
        <source>G&amp;rain of the surface</source>
        <translation>&amp;Körnung des Untergrunds</translation>
    </message>
    <message>
        <source>Dry media show the relief of the surface</source>
        <translation>Trockene Zeichenmittel zeigen das Relief des Untergrunds</translation>
    </message>
</context>
<context>
    <name>edits</name>
    <message>
        <source>Make exact</source>
        <translation>Exakt machen</translation>
    </message>
    <message>
        <source>Add guide</source>
        <translation>Hilfslinie hinzufügen</translation>
    </message>
    <message>
        <source>Change guide</source>
        <translation>Hilfslinie ändern</translation>
    </message>
    <message>
        <source>Remove guide</source>
        <translation>Hilfslinie entfernen</translation>
    </message>
    <message>
        <source>Remove guides</source>
        <translation>Hilfslinien entfernen</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>Hilfslinien zeigen</translation>
    </message>
    <message>
        <source>Hide guides</source>
        <translation>Hilfslinien verbergen</translation>
    </message>
    <message>
        <source>Unlink</source>
        <translation>Trennen</translation>
    </message>
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
        <translation>Ebene ausblenden</translation>
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
        <translation>Ebene anzeigen</translation>
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
    <message>
        <source>Recolour</source>
        <translation>Umfärben</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation>Deckkraft der Ebene</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Ebene duplizieren</translation>
    </message>
    <message>
        <source>Merge layers</source>
        <translation>Ebenen vereinen</translation>
    </message>
    <message>
        <source>Add picture</source>
        <translation>Bild hinzufügen</translation>
    </message>
    <message>
        <source>Place picture</source>
        <translation>Bild verschieben</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Gather</source>
        <translation>Zusammenfassen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Layer blend mode</source>
        <translation>Mischmodus der Ebene</translation>
    </message>
    <message>
        <source>Group layers</source>
        <translation>Ebenen gruppieren</translation>
    </message>
    <message>
        <source>Ungroup layers</source>
        <translation>Gruppe auflösen</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Wie gezeichnet</translation>
    </message>
    <message>
        <source>Scratch out</source>
        <translation>Durchstreichen</translation>
    </message>
    <message>
        <source>Bulge</source>
        <translation>Wölben</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Zusammenziehen</translation>
    </message>
    <message>
        <source>Motion timing</source>
        <translation>Zeitplan der Bewegung</translation>
    </message>
    <message>
        <source>Correct matches</source>
        <translation>Zuordnungen berichtigen</translation>
    </message>
    <message>
        <source>Edit the body</source>
        <translation>Körper bearbeiten</translation>
    </message>
    <message>
        <source>Remove edit of the body</source>
        <translation>Bearbeitung des Körpers entfernen</translation>
    </message>
    <message>
        <source>Remove edits of the body</source>
        <translation>Bearbeitungen des Körpers entfernen</translation>
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
        <source>Sketching that you can feel: ink that resists, lines that you correct by pulling and pushing.</source>
        <translation>Skizzieren, das man spürt: Tinte, die Widerstand leistet, und Linien, die man durch Ziehen und Schieben korrigiert.</translation>
    </message>
    <message>
        <source>Based on an idea in this paper:</source>
        <translation>Nach einer Idee aus diesem Artikel:</translation>
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
    <name>felt::desktop::AnswerScale</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::BodyTools</name>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Drag to turn the body</source>
        <translation>Ziehen dreht den Körper</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cuts the body along a stroke, and removes the part at its left</source>
        <translation>Schneidet den Körper entlang eines Strichs und entfernt den Teil links davon</translation>
    </message>
    <message>
        <source>Draw a line across the body, from beside it to beside it. What is at the left of the line goes away.</source>
        <translation>Ziehen Sie eine Linie quer über den Körper, die neben ihm beginnt und endet. Was links der Linie liegt, fällt weg.</translation>
    </message>
    <message>
        <source>Extrude</source>
        <translation>Extrudieren</translation>
    </message>
    <message>
        <source>Pulls a part out of the body: a closed line, then its profile</source>
        <translation>Zieht einen Teil aus dem Körper heraus: eine geschlossene Linie, dann ihr Profil</translation>
    </message>
    <message>
        <source>Draw a closed line on the body.</source>
        <translation>Zeichnen Sie eine geschlossene Linie auf den Körper.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Paints on the body, in the colour of the pen</source>
        <translation>Malt auf den Körper, in der Farbe des Stifts</translation>
    </message>
    <message>
        <source>Draw on the body.</source>
        <translation>Zeichnen Sie auf den Körper.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Smooths the body below a stroke, for example where it was cut</source>
        <translation>Glättet den Körper unter einem Strich, zum Beispiel an einer Schnittkante</translation>
    </message>
    <message>
        <source>Draw over what should become smooth.</source>
        <translation>Zeichnen Sie über das, was glatt werden soll.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of the brush</source>
        <translation>Breite des Pinsels</translation>
    </message>
    <message>
        <source>Turn the body with the other mouse button or the arrow keys until you see the line from the side. Then draw the profile: from one side of the line over the tip to the other side.</source>
        <translation>Drehen Sie den Körper mit der anderen Maustaste oder den Pfeiltasten, bis Sie die Linie von der Seite sehen. Zeichnen Sie dann das Profil: von einer Seite der Linie über die Spitze zur anderen Seite.</translation>
    </message>
    <message>
        <source>The line is not closed.</source>
        <translation>Die Linie ist nicht geschlossen.</translation>
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
        <translation>Zu berührende Ecke</translation>
    </message>
    <message>
        <source>&amp;Use this position</source>
        <translation>Diese &amp;Position verwenden</translation>
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
        <source>This is not a usable drawing area: %1. Start again with the upper left corner.</source>
        <translation>Das ist keine brauchbare Zeichenfläche: %1. Beginnen Sie erneut mit der oberen linken Ecke.</translation>
    </message>
    <message>
        <source>Hold the tip of the pen on the upper left corner of your drawing area.</source>
        <translation>Halten Sie die Stiftspitze auf die obere linke Ecke der Zeichenfläche.</translation>
    </message>
    <message>
        <source>Now hold it on the upper right corner.</source>
        <translation>Halten Sie sie jetzt auf die obere rechte Ecke.</translation>
    </message>
    <message>
        <source>Now hold it on the lower left corner.</source>
        <translation>Halten Sie sie jetzt auf die untere linke Ecke.</translation>
    </message>
    <message>
        <source>The drawing area is %L1 mm wide and %L2 mm high.</source>
        <translation>Die Zeichenfläche ist %L1 mm breit und %L2 mm hoch.</translation>
    </message>
    <message>
        <source>Its corners agree to within %L1 mm.</source>
        <translation>Die Ecken stimmen auf %L1 mm genau.</translation>
    </message>
    <message>
        <source>The corner is not square: it is off by %L1 mm. Start again for a better result.</source>
        <translation>Die Ecke ist nicht rechtwinklig, die Abweichung beträgt %L1 mm. Beginnen Sie für ein besseres Ergebnis neu.</translation>
    </message>
    <message>
        <source>The device does not answer. Check its cable and power.</source>
        <translation>Das Gerät antwortet nicht. Prüfen Sie Kabel und Stromversorgung.</translation>
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
        <source>Hold the pen against the body, and move along it. The pen draws nothing.</source>
        <translation>Halten Sie den Stift gegen den Körper, und fahren Sie an ihm entlang. Der Stift zeichnet nichts.</translation>
    </message>
    <message>
        <source>Drawing area</source>
        <translation>Zeichenfläche</translation>
    </message>
    <message>
        <source>The area to draw on</source>
        <translation>Die Fläche, auf der gezeichnet wird</translation>
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
        <source>Pressure is recognised.</source>
        <translation>Druck wird erkannt.</translation>
    </message>
    <message>
        <source>No pressure recognised yet. A mouse draws lines of even width.</source>
        <translation>Noch kein Druck erkannt. Mit der Maus sind Linien überall gleich breit.</translation>
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
        <source>Shows the direction and strength of the force at the nib</source>
        <translation>Zeigt Richtung und Stärke der Kraft an der Spitze</translation>
    </message>
    <message>
        <source>The &amp;nib moves with forces</source>
        <translation>Die &amp;Spitze folgt den Kräften</translation>
    </message>
    <message>
        <source>With a mouse or a tablet, this makes forces visible</source>
        <translation>Macht Kräfte bei Maus oder Tablett sichtbar</translation>
    </message>
    <message>
        <source>Dry media show the &amp;grain of the surface</source>
        <translation>Trockene Zeichenmittel zeigen die K&amp;örnung des Untergrunds</translation>
    </message>
    <message>
        <source>Like chalk on paper. Exported outlines do not change</source>
        <translation>Wie Kreide auf Papier. Exportierte Umrisse ändern sich nicht</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CanvasPopup</name>
    <message>
        <source>Palette at the pointer</source>
        <translation>Palette am Zeiger</translation>
    </message>
    <message>
        <source>Recently used colours</source>
        <translation>Zuletzt benutzte Farben</translation>
    </message>
    <message>
        <source>Paste &amp;here</source>
        <translation>&amp;Hier einfügen</translation>
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
        <translation>Die ausgewählten Linien in die Zwischenablage verschieben</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected strokes, or all if none is selected</source>
        <translation>Die ausgewählten Linien kopieren, ohne Auswahl alle</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Add the strokes from the clipboard</source>
        <translation>Die Linien aus der Zwischenablage hinzufügen</translation>
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
        <source>Only whole strokes can be cut. Select a whole stroke first.</source>
        <translation>Nur ganze Linien lassen sich ausschneiden. Wählen Sie zuerst eine ganze Linie aus.</translation>
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
        <translation>die Zwischenablage</translation>
    </message>
    <message>
        <source>Paste &amp;in place</source>
        <translation>An &amp;Ort und Stelle einfügen</translation>
    </message>
    <message>
        <source>Add the strokes from the clipboard at their original position</source>
        <translation>Fügt die Striche aus der Zwischenablage an ihrer ursprünglichen Stelle ein</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ColorNotice</name>
    <message>
        <source>&amp;Use %1</source>
        <translation>%1 &amp;verwenden</translation>
    </message>
    <message>
        <source>Use the colour %1</source>
        <translation>Die Farbe %1 verwenden</translation>
    </message>
    <message>
        <source>The colour of the ink can hardly be seen on this page.</source>
        <translation>Die Farbe der Tinte ist auf dieser Seite kaum zu sehen.</translation>
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
        <source>Colour code</source>
        <translation>Farbcode</translation>
    </message>
    <message>
        <source>The colour as #rrggbb, #rgb or #rrggbbaa</source>
        <translation>Die Farbe als #rrggbb, #rgb oder #rrggbbaa</translation>
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
        <source>Opacity: 0 % is transparent</source>
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
        <source>Keep this colour in your own palette</source>
        <translation>Diese Farbe in der eigenen Palette behalten</translation>
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
        <source>Remove the &amp;colour from your palette</source>
        <translation>Farbe aus der eigenen Palette en&amp;tfernen</translation>
    </message>
    <message>
        <source>Low contrast with the paper: %1:1</source>
        <translation>Geringer Kontrast zum Papier: %1:1</translation>
    </message>
    <message>
        <source>Contrast with the paper: %1:1</source>
        <translation>Kontrast zum Papier: %1:1</translation>
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
        <source>%1 was disconnected. It continues when it is connected again.</source>
        <translation>%1 wurde getrennt. Es macht weiter, sobald es wieder verbunden ist.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceCare</name>
    <message>
        <source>Find its &amp;home position…</source>
        <translation>&amp;Ausgangsposition suchen …</translation>
    </message>
    <message>
        <source>&amp;Use it again</source>
        <translation>Wieder &amp;benutzen</translation>
    </message>
    <message>
        <source>When you connect it again it is used again, with its forces off.</source>
        <translation>Sobald es wieder angeschlossen ist, wird es wieder benutzt; seine Kräfte sind dann aus.</translation>
    </message>
    <message>
        <source>%1 is in use in another window.</source>
        <translation>%1 wird in einem anderen Fenster benutzt.</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>%1 lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>Noch einmal &amp;versuchen</translation>
    </message>
    <message>
        <source>%1 is connected. It must find its home position before you can use it.</source>
        <translation>%1 ist angeschlossen. Vor der Benutzung muss es seine Ausgangsposition finden.</translation>
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
        <source>Message from the device itself</source>
        <translation>Meldung des Geräts selbst</translation>
    </message>
    <message>
        <source>Message from the device: %1</source>
        <translation>Meldung des Geräts: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DevicePage</name>
    <message>
        <source>Senses pressure if the pen does. No motors.</source>
        <translation>Erkennt Druck, wenn der Stift ihn meldet. Keine Motoren.</translation>
    </message>
    <message>
        <source>No motors.</source>
        <translation>Keine Motoren.</translation>
    </message>
    <message>
        <source>Pushes with up to %L1 N, continuously with %L2 N. Loop of %L3 Hz.</source>
        <translation>Drückt mit bis zu %L1 N, dauerhaft mit %L2 N. Regelschleife mit %L3 Hz.</translation>
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
        <source>The upper limit of all forces of this device</source>
        <translation>Obergrenze für alle Kräfte dieses Geräts</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Maximale Kraft</translation>
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
        <source>A haptic pen, mouse, touchpad or game controller that vibrates while you draw, with any pen</source>
        <translation>Haptischer Stift, Maus, Touchpad oder Gamecontroller, der beim Zeichnen vibriert, mit jedem Stift</translation>
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
        <source>Not connected; used again once it is</source>
        <translation>Nicht angeschlossen; wird wieder benutzt, sobald es angeschlossen ist</translation>
    </message>
    <message>
        <source>In use in another window</source>
        <translation>In einem anderen Fenster benutzt</translation>
    </message>
    <message>
        <source>Its software is installed; whether it is connected shows when you use it</source>
        <translation>Die Software ist installiert; ob es angeschlossen ist, zeigt sich bei der Benutzung</translation>
    </message>
    <message>
        <source>Connected; its settings cannot be read</source>
        <translation>Angeschlossen; die Einstellungen sind nicht lesbar</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Angeschlossen</translation>
    </message>
    <message>
        <source>Connected; its drawing plane is not set yet</source>
        <translation>Angeschlossen; die Zeichenebene ist noch nicht festgelegt</translation>
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
        <source>Not in the list? See what is missing, step by step</source>
        <translation>Nicht in der Liste? Schritt für Schritt sehen, was fehlt</translation>
    </message>
    <message>
        <source>Correct that line, or remove the file.</source>
        <translation>Korrigieren Sie diese Zeile oder löschen Sie die Datei.</translation>
    </message>
    <message>
        <source>Check its cable and power.</source>
        <translation>Prüfen Sie Kabel und Stromversorgung.</translation>
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
        <source>Fit to the p&amp;age</source>
        <translation>An die Se&amp;ite anpassen</translation>
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
        <source>The upper limit of all forces of this device</source>
        <translation>Obergrenze für alle Kräfte dieses Geräts</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Maximale Kraft</translation>
    </message>
    <message>
        <source>device limit</source>
        <translation>Gerätegrenze</translation>
    </message>
    <message>
        <source> N/m</source>
        <translation> N/m</translation>
    </message>
    <message>
        <source>Lower this if the surface hums or trembles under the pen</source>
        <translation>Verringern, wenn der Untergrund unter dem Stift brummt oder zittert</translation>
    </message>
    <message>
        <source>Stiffest surface</source>
        <translation>Größte Steifigkeit</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>At 100 %, one millimetre of the hand is one millimetre of the page. At 200 % it is two.</source>
        <translation>Bei 100 % ist ein Millimeter der Hand ein Millimeter auf der Seite. Bei 200 % sind es zwei.</translation>
    </message>
    <message>
        <source>Size of a movement on the page</source>
        <translation>Größe einer Bewegung auf der Seite</translation>
    </message>
    <message>
        <source>Centres the drawing area on the page and scales it so that the whole page can be reached</source>
        <translation>Zentriert die Zeichenfläche auf der Seite und skaliert sie, so dass die ganze Seite erreichbar ist</translation>
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
        <translation>&amp;Maximale Kraft</translation>
    </message>
    <message>
        <source>S&amp;tiffest surface</source>
        <translation>Größte &amp;Steifigkeit</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>Zeichenebene</translation>
    </message>
    <message>
        <source>S&amp;ize on the page</source>
        <translation>Größe au&amp;f der Seite</translation>
    </message>
    <message>
        <source>Not set yet: the usual position of such a device is assumed.</source>
        <translation>Noch nicht festgelegt: Die übliche Position eines solchen Geräts wird angenommen.</translation>
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
        <source>Each hand has its own drawing plane, because the device stands on that side</source>
        <translation>Jede Hand hat ihre eigene Zeichenebene, weil das Gerät auf der jeweiligen Seite steht</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DoctorDialog</name>
    <message>
        <source>Setting up a haptic device</source>
        <translation>Ein haptisches Gerät einrichten</translation>
    </message>
    <message>
        <source>A haptic device needs its maker&apos;s software and permission to use its port. Feltline has checked this computer. Work from top to bottom. A line with a dash is about a device that you may not own; ignore it then.</source>
        <translation>Ein haptisches Gerät braucht die Software seines Herstellers und die Berechtigung, seinen Anschluss zu benutzen. Feltline hat diesen Computer geprüft. Gehen Sie die Liste von oben nach unten durch. Eine Zeile mit Strich betrifft ein Gerät, das Sie vielleicht nicht besitzen; ignorieren Sie sie dann.</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>&amp;Check again</source>
        <translation>&amp;Erneut prüfen</translation>
    </message>
    <message>
        <source>&amp;Copy all</source>
        <translation>Alles &amp;kopieren</translation>
    </message>
    <message>
        <source>Copies the report as plain text, to ask for help</source>
        <translation>Kopiert den Bericht als einfachen Text, um Hilfe zu erbitten</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>This build of Feltline has no drivers.</source>
        <translation>Diese Version von Feltline wurde ohne Treiber gebaut.</translation>
    </message>
    <message>
        <source>Nothing to report.</source>
        <translation>Nichts zu melden.</translation>
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
        <translation>Die Seite</translation>
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
        <translation>An&amp;zeigen:</translation>
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
        <source>&amp;Grain of the surface in dry media</source>
        <translation>&amp;Körnung des Untergrunds in trockenen Zeichenmitteln</translation>
    </message>
    <message>
        <source>As on the screen. Lines stay editable; the grain is added as a picture</source>
        <translation>Wie auf dem Bildschirm. Linien bleiben Linien; die Körnung kommt als Bild dazu</translation>
    </message>
    <message>
        <source>Small file for &amp;web pages</source>
        <translation>Kleine Datei für &amp;Webseiten</translation>
    </message>
    <message>
        <source>The selected lines</source>
        <translation>Die ausgewählten Linien</translation>
    </message>
    <message>
        <source>Only the visible ink, which other programs show but cannot edit as lines</source>
        <translation>Nur die sichtbare Tinte: Andere Programme zeigen sie, können sie aber nicht als Linien bearbeiten</translation>
    </message>
    <message>
        <source>The selected strokes, exactly</source>
        <translation>Die ausgewählten Striche, exakt</translation>
    </message>
    <message>
        <source>The picture, for browsers. Feltline does not read the lines back.</source>
        <translation>Das Bild, für Browser. Feltline liest die Linien nicht zurück.</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>1× is 96 dots per inch, as on a screen of usual resolution</source>
        <translation>1× sind 96 Punkte pro Zoll, wie auf einem Bildschirm mit üblicher Auflösung</translation>
    </message>
    <message>
        <source>P&amp;ictures to draw over</source>
        <translation>B&amp;ilder zum Nachzeichnen</translation>
    </message>
    <message>
        <source>For s&amp;well paper</source>
        <translation>Für Sch&amp;wellpapier</translation>
    </message>
    <message>
        <source>Black at true size, with lines at least 1 mm wide and textures instead of colours, for drawings that are read with the fingers</source>
        <translation>Schwarz in wahrer Größe, mit mindestens 1 mm breiten Linien und Mustern statt Farben, für Zeichnungen, die mit den Fingern gelesen werden</translation>
    </message>
    <message>
        <source>Black lines and textures that rise on swell paper.</source>
        <translation>Schwarze Linien und Muster, die auf Schwellpapier hochkommen.</translation>
    </message>
    <message>
        <source>It cannot be made for swell paper: %1.</source>
        <translation>Die Zeichnung kann nicht für Schwellpapier ausgegeben werden: %1.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Eyedropper</name>
    <message>
        <source>&amp;Pick a colour</source>
        <translation>Farbe &amp;aufnehmen</translation>
    </message>
    <message>
        <source>Uses the colour of the line under the pen, or of the line that you click</source>
        <translation>Verwendet die Farbe der Linie unter dem Stift oder der Linie, die Sie anklicken</translation>
    </message>
    <message>
        <source>Pick colour, &amp;medium and width</source>
        <translation>Farbe, &amp;Medium und Breite aufnehmen</translation>
    </message>
    <message>
        <source>Draws on as the line under the pen, or as the line that you click</source>
        <translation>Zeichnet weiter wie die Linie unter dem Stift oder die Linie, die Sie anklicken</translation>
    </message>
    <message>
        <source>There is no line or filled area under the pen.</source>
        <translation>Unter dem Stift ist weder eine Linie noch eine gefüllte Fläche.</translation>
    </message>
    <message>
        <source>Click a line to use its colour. Escape ends this.</source>
        <translation>Klicken Sie eine Linie an, um ihre Farbe zu verwenden. Escape beendet dies.</translation>
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
        <source>Surfac&amp;e</source>
        <translation>&amp;Untergrund</translation>
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
        <source>Stops all forces immediately (Esc twice)</source>
        <translation>Schaltet alle Kräfte sofort ab (Esc zweimal)</translation>
    </message>
    <message>
        <source>Let forces act on the pen</source>
        <translation>Kräfte auf den Stift wirken lassen</translation>
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
        <source>Change how surfaces and media feel, look and sound</source>
        <translation>Ändern, wie Untergründe und Zeichenmittel sich anfühlen, aussehen und klingen</translation>
    </message>
    <message>
        <source>Edit surfaces and media</source>
        <translation>Untergründe und Zeichenmittel bearbeiten</translation>
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
        <source>Start a new drawing</source>
        <translation>Eine neue Zeichnung beginnen</translation>
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
        <translation>Die Zeichnung in ihrer Datei speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the drawing to another file</source>
        <translation>Die Zeichnung in einer anderen Datei speichern</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren …</translation>
    </message>
    <message>
        <source>Add the strokes of another file to this drawing</source>
        <translation>Dieser Zeichnung die Linien einer anderen Datei hinzufügen</translation>
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
        <source>Quit the program</source>
        <translation>Das Programm beenden</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
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
Your drawing is still open: save it to another place.</source>
        <translation>%1
Ihre Zeichnung ist noch geöffnet: Speichern Sie sie an einem anderen Ort.</translation>
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
        <translation>%1 (wiederhergestellt)</translation>
    </message>
    <message>
        <source>No crash protection: save often</source>
        <translation>Kein Absturzschutz: oft speichern</translation>
    </message>
    <message>
        <source>The autosave cannot be written: %1</source>
        <translation>Die automatische Sicherung lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>Autosave in another place</source>
        <translation>Automatische Sicherung an anderem Ort</translation>
    </message>
    <message>
        <source>The drawing is autosaved in %1, because the usual place fails: %2</source>
        <translation>Die Zeichnung wird automatisch in %1 gesichert, weil der übliche Ort nicht funktioniert: %2</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
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
        <source>If you do not save, your changes since the last save are lost.</source>
        <translation>Wenn Sie nicht speichern, gehen die Änderungen seit dem letzten Speichern verloren.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Auf dem Datenträger geändert</translation>
    </message>
    <message>
        <source>“%1” was changed by another program.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>If you save now, your drawing replaces those changes.</source>
        <translation>Wenn Sie jetzt speichern, überschreibt Ihre Zeichnung diese Änderungen.</translation>
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
        <source>&amp;Show the readable part</source>
        <translation>&amp;Lesbaren Teil anzeigen</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Import a page</source>
        <translation>Eine Seite importieren</translation>
    </message>
    <message>
        <source>Page of “%1” (1 to %2):</source>
        <translation>Seite von „%1“ (1 bis %2):</translation>
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
        <source>The loop is not running.</source>
        <translation>Die Regelschleife läuft nicht.</translation>
    </message>
    <message>
        <source>Real-time scheduling.</source>
        <translation>Echtzeitbetrieb.</translation>
    </message>
    <message>
        <source>Raised priority, no real-time scheduling.</source>
        <translation>Höhere Priorität, kein Echtzeitbetrieb.</translation>
    </message>
    <message>
        <source>Ordinary scheduling: late if the computer is busy.</source>
        <translation>Normaler Betrieb: verspätet, wenn der Computer ausgelastet ist.</translation>
    </message>
    <message>
        <source>The loop has stopped: the device does not answer.</source>
        <translation>Die Regelschleife steht: Das Gerät antwortet nicht.</translation>
    </message>
    <message>
        <source>The device&apos;s own software runs the loop.</source>
        <translation>Die Regelschleife läuft in der Software des Geräts.</translation>
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
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Forces by name</source>
        <translation>Kräfte nach Namen</translation>
    </message>
    <message>
        <source>Each force now and its maximum in the last seconds</source>
        <translation>Jede Kraft jetzt und ihr Höchstwert in den letzten Sekunden</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause the plot</source>
        <translation>Das Diagramm anhalten</translation>
    </message>
    <message>
        <source>maximum, %L1 N</source>
        <translation>maximal, %L1 N</translation>
    </message>
    <message>
        <source>continuous, %L1 N</source>
        <translation>dauerhaft, %L1 N</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>The motors are warm, so forces are reduced for a while.</source>
        <translation>Die Motoren sind warm, daher sind die Kräfte eine Weile verringert.</translation>
    </message>
    <message>
        <source>Loop: %L1 Hz, missed ticks: %L2</source>
        <translation>Regelschleife: %L1 Hz, versäumte Takte: %L2</translation>
    </message>
    <message>
        <source>Delay: usually %1, 1 in 100 %2</source>
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
        <source>Requested: %L1 N, recently at most %L2 N. The table lists each force.</source>
        <translation>Angefordert: %L1 N, zuletzt höchstens %L2 N. Die Tabelle nennt jede Kraft.</translation>
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
        <source>Lines with their widths, for programs that read InkML; Feltline reads lines, layers and page back exactly.</source>
        <translation>Linien mit ihrer Breite für Programme, die InkML lesen; Feltline liest Linien, Ebenen und Seite genau wieder ein.</translation>
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
        <translation>Linien als JSON-Zeilen</translation>
    </message>
    <message>
        <source>Every visible line, exactly, for programs and scripts; no layers, page or surface.</source>
        <translation>Jede sichtbare Linie, genau, für Programme und Skripte; keine Ebenen, keine Seite, kein Untergrund.</translation>
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
        <source>Same as the desktop</source>
        <translation>Wie die Arbeitsumgebung</translation>
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
        <translation>Design</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The new language is used from the next start.</source>
        <translation>Die neue Sprache gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Design:</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Sprache:</translation>
    </message>
    <message>
        <source>At startup:</source>
        <translation>Beim Start:</translation>
    </message>
    <message>
        <source>&amp;Open the last drawing again</source>
        <translation>Die letzte Zeichnung &amp;wieder öffnen</translation>
    </message>
    <message>
        <source>If no file is given</source>
        <translation>Wenn keine Datei angegeben ist</translation>
    </message>
    <message>
        <source>So&amp;und of drawing</source>
        <translation>&amp;Ton beim Zeichnen</translation>
    </message>
    <message>
        <source>Hear the pen rub on the surface</source>
        <translation>Den Stift auf dem Untergrund reiben hören</translation>
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
        <translation>Zeichnen, dann korrigieren</translation>
    </message>
    <message>
        <source>Draw with a pen or with the mouse. You do not need to redraw a line that is not right: pull it, push it, smooth it, make it broader. You can undo every step.</source>
        <translation>Zeichnen Sie mit einem Stift oder der Maus. Eine Linie, die nicht stimmt, müssen Sie nicht neu zeichnen: Ziehen, schieben, glätten oder verbreitern Sie sie. Jeder Schritt lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Press a tool&apos;s key briefly to choose the tool. Hold the key to use the tool only until you release it.</source>
        <translation>Drücken Sie kurz die Taste eines Werkzeugs, um es zu wählen. Halten Sie die Taste gedrückt, um es nur bis zum Loslassen zu benutzen.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>Die Ansicht</translation>
    </message>
    <message>
        <source>The wheel zooms at the pointer. Hold Space and drag to move the view, with Shift to turn it. None of this changes the drawing.</source>
        <translation>Das Mausrad zoomt am Zeiger. Mit gedrückter Leertaste ziehen verschiebt die Ansicht, zusätzlich mit Umschalt dreht es sie. Nichts davon ändert die Zeichnung.</translation>
    </message>
    <message>
        <source>The feel</source>
        <translation>Das Gefühl</translation>
    </message>
    <message>
        <source>Every tool resists. With a force-feedback pen you feel this in your hand. With a tablet or a mouse you see it: as an arrow at the nib and in the panel Forces. Press Esc twice to switch off all forces immediately.</source>
        <translation>Jedes Werkzeug leistet Widerstand. Mit einem Force-Feedback-Stift spüren Sie ihn in der Hand. Mit Tablett oder Maus sehen Sie ihn: als Pfeil an der Spitze und im Bedienfeld „Kräfte“. Zweimal Esc schaltet alle Kräfte sofort ab.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Drawings are saved as .felt files, with their layers and pen pressure. You can export SVG, PDF and PNG for other programs.</source>
        <translation>Zeichnungen werden als .felt-Dateien gespeichert, mit Ebenen und Stiftdruck. Für andere Programme können Sie SVG, PDF und PNG exportieren.</translation>
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
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>All shortcuts on one page, to search and to print</source>
        <translation>Alle Tastenkürzel auf einer Seite, zum Suchen und Drucken</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>Geführte T&amp;our</translation>
    </message>
    <message>
        <source>A two-minute demonstration of the tools</source>
        <translation>Eine zweiminütige Vorführung der Werkzeuge</translation>
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
        <source>Version, licence and libraries</source>
        <translation>Version, Lizenz und Bibliotheken</translation>
    </message>
    <message>
        <source>From the tour</source>
        <translation>Aus der Tour</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HistoryModel</name>
    <message>
        <source>Earlier steps are no longer available</source>
        <translation>Frühere Schritte sind nicht mehr verfügbar</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>%1, current</source>
        <translation>%1, aktuell</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, rückgängig gemacht</translation>
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
        <source>Home position of %1</source>
        <translation>Ausgangsposition von %1</translation>
    </message>
    <message>
        <source>Finding the home position</source>
        <translation>Ausgangsposition wird gesucht</translation>
    </message>
    <message>
        <source>Let it &amp;move</source>
        <translation>&amp;Bewegung erlauben</translation>
    </message>
    <message>
        <source>It is &amp;in place</source>
        <translation>Es ist an &amp;Ort und Stelle</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Nicht jetzt</translation>
    </message>
    <message>
        <source>Allow its arm to move by itself?</source>
        <translation>Darf sich der Arm von selbst bewegen?</translation>
    </message>
    <message>
        <source>%1 moves its arm to find its home position: for a few seconds, over its whole reach, with the force that it needs. Let go of the arm, clear the space around it, and keep hair, sleeves and cups away. You can stop it at any time with its power switch.</source>
        <translation>%1 bewegt seinen Arm, um die Ausgangsposition zu finden: einige Sekunden lang, über die ganze Reichweite, mit der nötigen Kraft. Lassen Sie den Arm los, machen Sie ringsum Platz und halten Sie Haare, Ärmel und Tassen fern. Am Netzschalter können Sie ihn jederzeit anhalten.</translation>
    </message>
    <message>
        <source>Bring the arm to its rest pose</source>
        <translation>Bringen Sie den Arm in die Ruheposition</translation>
    </message>
    <message>
        <source>%1 uses its rest pose as its home position. Nothing moves by itself.</source>
        <translation>%1 verwendet die Ruheposition als Ausgangsposition. Nichts bewegt sich von selbst.</translation>
    </message>
    <message>
        <source>Put the stylus into the inkwell</source>
        <translation>Stecken Sie den Stift in die Halterung</translation>
    </message>
    <message>
        <source>%1 finds its position while its stylus is in the inkwell, the hole in its base. Nothing moves by itself.</source>
        <translation>%1 ermittelt seine Position, während der Stift in der Halterung steckt, der Öffnung im Sockel. Nichts bewegt sich von selbst.</translation>
    </message>
    <message>
        <source>It is moving: keep your hands away</source>
        <translation>Es bewegt sich: Hände fernhalten</translation>
    </message>
    <message>
        <source>Hold it still for a moment</source>
        <translation>Bitte einen Moment still halten</translation>
    </message>
    <message>
        <source>It did not find its home position. Try again.</source>
        <translation>Es hat seine Ausgangsposition nicht gefunden. Versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>This failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HueStrip</name>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Hue. Change it with the arrow keys.</source>
        <translation>Farbton. Mit den Pfeiltasten ändern.</translation>
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
        <source>Cancelled; the pen is up</source>
        <translation>Abgebrochen; der Stift ist abgehoben</translation>
    </message>
    <message>
        <source>The pen is down</source>
        <translation>Der Stift ist aufgesetzt</translation>
    </message>
    <message>
        <source>The pen is up</source>
        <translation>Der Stift ist abgehoben</translation>
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
        <translation>ausgeblendet</translation>
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
        <source>, current</source>
        <translation>, aktuell</translation>
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
    <message>
        <source>, picture</source>
        <translation>, Bild</translation>
    </message>
    <message>
        <source>, opacity %1 %</source>
        <translation>, Deckkraft %1 %</translation>
    </message>
    <message>
        <source>, multiplies</source>
        <translation>, multipliziert</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>, in the group %1</source>
        <translation>, in der Gruppe %1</translation>
    </message>
    <message>
        <source>%1 (group), %2, %3, %4</source>
        <translation>%1 (Gruppe), %2, %3, %4</translation>
    </message>
    <message>
        <source>collapsed</source>
        <translation>eingeklappt</translation>
    </message>
    <message>
        <source>expanded</source>
        <translation>ausgeklappt</translation>
    </message>
    <message>
        <source>%1
Double-click to rename, drag to move, drag layers into it</source>
        <translation>%1
Doppelklick zum Umbenennen, ziehen zum Verschieben, Ebenen hineinziehen</translation>
    </message>
    <message>
        <source>, hidden by its group</source>
        <translation>, durch ihre Gruppe ausgeblendet</translation>
    </message>
    <message>
        <source>, locked by its group</source>
        <translation>, durch ihre Gruppe gesperrt</translation>
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
        <source>Raise the layer</source>
        <translation>Die Ebene nach oben</translation>
    </message>
    <message>
        <source>Moves the layer up by one</source>
        <translation>Verschiebt die Ebene um eins nach oben</translation>
    </message>
    <message>
        <source>Lower the layer</source>
        <translation>Die Ebene nach unten</translation>
    </message>
    <message>
        <source>Moves the layer down by one</source>
        <translation>Verschiebt die Ebene um eins nach unten</translation>
    </message>
    <message>
        <source>Remove the layer</source>
        <translation>Die Ebene entfernen</translation>
    </message>
    <message>
        <source>Removes the layer and its lines</source>
        <translation>Entfernt die Ebene und ihre Linien</translation>
    </message>
    <message>
        <source>All layers were hidden or locked, so “%1” was added to draw on.</source>
        <translation>Alle Ebenen waren ausgeblendet oder gesperrt, daher wurde „%1“ zum Zeichnen hinzugefügt.</translation>
    </message>
    <message>
        <source>Duplicate the layer</source>
        <translation>Ebene duplizieren</translation>
    </message>
    <message>
        <source>A copy of this layer above it</source>
        <translation>Eine Kopie dieser Ebene darüber</translation>
    </message>
    <message>
        <source>Merge the layer with the one below</source>
        <translation>Ebene mit der Ebene darunter vereinen</translation>
    </message>
    <message>
        <source>Moves the lines to the layer below</source>
        <translation>Verschiebt die Linien auf die Ebene darunter</translation>
    </message>
    <message>
        <source>&amp;Opacity:</source>
        <translation>&amp;Deckkraft:</translation>
    </message>
    <message>
        <source>Opacity of the layer</source>
        <translation>Deckkraft der Ebene</translation>
    </message>
    <message>
        <source>&amp;Blend mode:</source>
        <translation>&amp;Mischmodus:</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplizieren</translation>
    </message>
    <message>
        <source>Blend mode of the layer</source>
        <translation>Mischmodus der Ebene</translation>
    </message>
    <message>
        <source>Multiply makes what is below darker, for shading on line art</source>
        <translation>Multiplizieren macht dunkler, was darunter liegt: zum Schattieren von Linien</translation>
    </message>
    <message>
        <source>A new layer above the current one</source>
        <translation>Eine neue Ebene über der aktuellen</translation>
    </message>
    <message>
        <source>Removes the group, its layers and their lines</source>
        <translation>Entfernt die Gruppe, ihre Ebenen und deren Linien</translation>
    </message>
    <message>
        <source>The group “%1”</source>
        <translation>Die Gruppe „%1“</translation>
    </message>
    <message>
        <source>“%1”</source>
        <comment>a layer</comment>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it to draw there.</source>
        <translation>%1 ist gesperrt. Entsperren Sie sie, um dort zu zeichnen.</translation>
    </message>
    <message>
        <source>%1 is hidden. Show it to draw there.</source>
        <translation>%1 ist ausgeblendet. Blenden Sie sie ein, um dort zu zeichnen.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MainWindow</name>
    <message>
        <source>Shows or hides the panel %1</source>
        <translation>Blendet das Bedienfeld %1 ein oder aus</translation>
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
        <translation>Alle Bedienfelder &amp;ausblenden</translation>
    </message>
    <message>
        <source>Shows only the drawing area</source>
        <translation>Zeigt nur die Zeichenfläche</translation>
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
        <source>Moves the focus from the drawing area to the tools, to each panel, and back</source>
        <translation>Bewegt den Fokus von der Zeichenfläche zu den Werkzeugen, zu jedem Bedienfeld und zurück</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>Bedienfelder &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Restores the default layout of panels and bars</source>
        <translation>Stellt die Standardanordnung der Bedienfelder und Leisten wieder her</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Theme, language, pen, device and shortcuts</source>
        <translation>Design, Sprache, Stift, Gerät und Tastenkürzel</translation>
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
        <source>Some of your materials could not be read:</source>
        <translation>Einige Ihrer Materialien konnten nicht gelesen werden:</translation>
    </message>
    <message>
        <source>Ma&amp;terials…</source>
        <translation>Ma&amp;terialien …</translation>
    </message>
    <message>
        <source>Change how surfaces and media feel, look and sound, and make your own</source>
        <translation>Ändern, wie Untergründe und Zeichenmittel sich anfühlen, aussehen und klingen, und eigene erstellen</translation>
    </message>
    <message>
        <source>&amp;Compare materials A and B</source>
        <translation>Materialien A und B &amp;vergleichen</translation>
    </message>
    <message>
        <source>Switch between the two materials that the editor compares</source>
        <translation>Zwischen den beiden Materialien umschalten, die der Editor vergleicht</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (schreibgeschützt)</translation>
    </message>
    <message>
        <source>Tactile check</source>
        <translation>Tastprüfung</translation>
    </message>
    <message>
        <source>Solid view</source>
        <translation>Körperansicht</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
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
        <source>Use the values of another material</source>
        <translation>Die Werte eines anderen Materials verwenden</translation>
    </message>
    <message>
        <source>Sets all values to those of another material; you can then change them</source>
        <translation>Setzt alle Werte auf die eines anderen Materials; Sie können sie danach ändern</translation>
    </message>
    <message>
        <source>Values of…</source>
        <translation>Werte von …</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Relief from a picture…</source>
        <translation>Relief aus einem Bild …</translation>
    </message>
    <message>
        <source>A PNG of 8 or 16 bits; white is high. It is scaled to a square of 32 grain wavelengths and repeats seamlessly</source>
        <translation>Ein PNG mit 8 oder 16 Bit; Weiß ist hoch. Es wird auf ein Quadrat von 32 Wellenlängen der Körnung skaliert und wiederholt sich nahtlos</translation>
    </message>
    <message>
        <source>Light, firm, hard</source>
        <translation>Leicht, fest, kräftig</translation>
    </message>
    <message>
        <source>What a stroke feels like</source>
        <translation>Wie sich ein Strich anfühlt</translation>
    </message>
    <message>
        <source>Hatched: changes below 0.04 N, which are too small to feel.</source>
        <translation>Schraffiert: Änderungen unter 0,04 N, zu klein, um sie zu spüren.</translation>
    </message>
    <message>
        <source>Forces on the pen now</source>
        <translation>Aktuelle Kräfte am Stift</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Comes with Feltline. Changing it makes your own copy.</source>
        <translation>Gehört zu Feltline. Eine Änderung legt eine eigene Kopie an.</translation>
    </message>
    <message>
        <source>Your own, not saved to a file yet. Feltline remembers it.</source>
        <translation>Eigenes, noch nicht in einer Datei gespeichert. Feltline merkt es sich.</translation>
    </message>
    <message>
        <source>Your own, saved.</source>
        <translation>Eigenes, gespeichert.</translation>
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
        <translation>Sie fühlen, sehen und hören %1. Drücken Sie B für %2.</translation>
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
        <source>Restores all values as they were at first, or when last saved</source>
        <translation>Setzt alle Werte auf den Anfangszustand oder den zuletzt gespeicherten Stand zurück</translation>
    </message>
    <message>
        <source>Copies these values to the other material</source>
        <translation>Kopiert diese Werte in das andere Material</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save to your own file</source>
        <translation>Als eigene Datei speichern</translation>
    </message>
    <message>
        <source>%1 was saved.</source>
        <translation>%1 wurde gespeichert.</translation>
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
        <source>Changes the name</source>
        <translation>Ändert den Namen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Deletes the material and its file; undo restores both</source>
        <translation>Löscht das Material und seine Datei; Rückgängig stellt beide wieder her</translation>
    </message>
    <message>
        <source>%1 was deleted. Undo restores it.</source>
        <translation>%1 wurde gelöscht. Rückgängig stellt es wieder her.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Add a material from a file</source>
        <translation>Ein Material aus einer Datei hinzufügen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Write a file to share</source>
        <translation>Eine Datei zum Weitergeben schreiben</translation>
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
        <source>It is yours now, but not saved yet.</source>
        <translation>Es ist jetzt Ihr eigenes, aber noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>%1 was exported.</source>
        <translation>%1 wurde exportiert.</translation>
    </message>
    <message>
        <source>Comes with this drawing. Changing it makes your own copy.</source>
        <translation>Gehört zu dieser Zeichnung. Eine Änderung legt eine eigene Kopie an.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialEditorModel</name>
    <message>
        <source>Values of %1</source>
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
        <source>%1 (custom)</source>
        <translation>%1 (eigenes)</translation>
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
    <message>
        <source>Shape of the style</source>
        <translation>Form des Stils</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialFieldsView</name>
    <message>
        <source>New seed</source>
        <translation>Neuer Startwert</translation>
    </message>
    <message>
        <source>Chooses another seed</source>
        <translation>Wählt einen anderen Startwert</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Haptik</translation>
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
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Klang</translation>
    </message>
    <message>
        <source>Style of lines</source>
        <translation>Stil der Linien</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialList</name>
    <message>
        <source>Surfaces and media</source>
        <translation>Untergründe und Zeichenmittel</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Untergründe</translation>
    </message>
    <message>
        <source>My surfaces</source>
        <translation>Eigene Untergründe</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>Zeichenmittel</translation>
    </message>
    <message>
        <source>My media</source>
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
        <source>Drawing medium</source>
        <translation>Zeichenmittel</translation>
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
    <name>felt::desktop::MessageScreen</name>
    <message>
        <source>or press Space</source>
        <translation>oder Leertaste drücken</translation>
    </message>
</context>
<context>
    <name>felt::desktop::NoticeBar</name>
    <message>
        <source>Unsupported content, and its line</source>
        <translation>Nicht unterstützte Inhalte mit Zeile</translation>
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
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Some content of “%1” is not supported. Skipped or changed: %2. The file itself is unchanged.</source>
        <translation>Einige Inhalte von „%1“ werden nicht unterstützt. Übersprungen oder geändert: %2. Die Datei selbst ist unverändert.</translation>
    </message>
    <message>
        <source>&amp;Open the folder</source>
        <translation>Ordner &amp;öffnen</translation>
    </message>
    <message>
        <source>“%1” was exported to “%2”.</source>
        <translation>„%1“ wurde nach „%2“ exportiert.</translation>
    </message>
    <message>
        <source>Left out, because the format has no fills: %1.</source>
        <translation>Weggelassen, weil das Format keine Füllungen hat: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no pictures to draw over: %1.</source>
        <translation>Weggelassen, weil das Format keine Bilder zum Nachzeichnen hat: %1.</translation>
    </message>
    <message>
        <source>Blend modes that became normal: %1.</source>
        <translation>Mischmodi, die normal wurden: %1.</translation>
    </message>
    <message>
        <source>Groups of layers that were dissolved: %1.</source>
        <translation>Aufgelöste Gruppen von Ebenen: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no timings of key drawings: %1.</source>
        <translation>Weggelassen, weil das Format keinen Zeitplan von Schlüsselzeichnungen hat: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no edits of the body: %1.</source>
        <translation>Weggelassen, weil das Format keine Bearbeitungen des Körpers hat: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no guides: %1.</source>
        <translation>Weggelassen, weil das Format keine Hilfslinien hat: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no symmetry groups: %1.</source>
        <translation>Weggelassen, weil das Format keine Symmetriegruppen hat: %1.</translation>
    </message>
    <message>
        <source>Layers or groups whose opacity became that of each line: %1.</source>
        <translation>Ebenen oder Gruppen, deren Deckkraft auf jede Linie überging: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no layers: %1.</source>
        <translation>Weggelassen, weil das Format keine Ebenen hat: %1.</translation>
    </message>
    <message>
        <source>Locked layers that became unlocked: %1.</source>
        <translation>Gesperrte Ebenen, die entsperrt wurden: %1.</translation>
    </message>
    <message>
        <source>Lines of hidden layers that were left out: %1.</source>
        <translation>Weggelassene Linien ausgeblendeter Ebenen: %1.</translation>
    </message>
    <message>
        <source>Lines of hidden layers that became visible: %1.</source>
        <translation>Linien ausgeblendeter Ebenen, die sichtbar wurden: %1.</translation>
    </message>
    <message>
        <source>Lines whose medium became a plain pen: %1.</source>
        <translation>Linien, deren Medium ein einfacher Stift wurde: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no custom materials: %1.</source>
        <translation>Weggelassen, weil das Format keine eigenen Materialien hat: %1.</translation>
    </message>
    <message>
        <source>Lines whose flat ends and pointed corners became round: %1.</source>
        <translation>Linien, deren flache Enden und spitze Ecken rund wurden: %1.</translation>
    </message>
    <message>
        <source>Names of lines that became numbers: %1.</source>
        <translation>Namen von Linien, die zu Nummern wurden: %1.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OfferPopup</name>
    <message>
        <source>Key: %1</source>
        <translation>Taste: %1</translation>
    </message>
    <message>
        <source>This stroke can be: %1</source>
        <translation>Dieser Strich kann sein: %1</translation>
    </message>
    <message>
        <source>Press harder, or hold the mouse still:</source>
        <translation>Fester drücken oder die Maus stillhalten:</translation>
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
        <source>Resets all options of this tool to their defaults</source>
        <translation>Setzt alle Optionen dieses Werkzeugs auf die Vorgaben zurück</translation>
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
        <source>Options that are rarely needed</source>
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
        <translation>Sei&amp;te einrichten …</translation>
    </message>
    <message>
        <source>Size, orientation and colour of the page</source>
        <translation>Größe, Ausrichtung und Farbe der Seite</translation>
    </message>
    <message>
        <source>Print pre&amp;view…</source>
        <translation>Druck&amp;vorschau …</translation>
    </message>
    <message>
        <source>Shows what will be printed</source>
        <translation>Zeigt, was gedruckt wird</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Prints the page at its true size</source>
        <translation>Druckt die Seite in Originalgröße</translation>
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
        <source>“%1” was not printed</source>
        <translation>„%1“ wurde nicht gedruckt</translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation>Druckvorschau</translation>
    </message>
    <message>
        <source>Export the drawing as SVG, PDF, PNG or ink for other programs</source>
        <translation>Die Zeichnung als SVG, PDF, PNG oder Tinte für andere Programme exportieren</translation>
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
        <translation>Seite einrichten</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Benutzerdefiniert</translation>
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
        <translation>Ausrichtung:</translation>
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
        <source>Friction on each surface</source>
        <translation>Reibung auf jedem Untergrund</translation>
    </message>
    <message>
        <source>Bold numbers are specific to this medium and surface</source>
        <translation>Fette Zahlen gelten nur für dieses Zeichenmittel auf diesem Untergrund</translation>
    </message>
    <message>
        <source>Double-click a number, or press F2, to set the friction on that surface</source>
        <translation>Auf eine Zahl doppelklicken oder F2 drücken, um die Reibung auf diesem Untergrund festzulegen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Untergrund</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation>Vorgabe verwenden</translation>
    </message>
    <message>
        <source>Uses the friction of the medium times that of the surface</source>
        <translation>Verwendet die Reibung des Zeichenmittels mal die des Untergrunds</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PenInput</name>
    <message>
        <source>Pressure is switched off.</source>
        <translation>Druck ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>The pressure of your pen is recognised.</source>
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
        <translation>Testbereich</translation>
    </message>
    <message>
        <source>Scribble here to try the pen. The scribbles are not kept.</source>
        <translation>Kritzeln Sie hier, um den Stift auszuprobieren. Das Gekritzel wird nicht gespeichert.</translation>
    </message>
    <message>
        <source>Scribble here to try your pen</source>
        <translation>Hier kritzeln, um den Stift auszuprobieren</translation>
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
        <source>If off, every line has the same width, however hard you press.</source>
        <translation>Wenn aus, sind alle Linien gleich breit, egal wie fest Sie drücken.</translation>
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
        <source>Soft: light pressure draws wide. Firm: press harder for the same width.</source>
        <translation>Weich: Leichter Druck zeichnet breit. Fest: Für dieselbe Breite fester drücken.</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Con&amp;tact from</source>
        <translation>Kon&amp;takt ab</translation>
    </message>
    <message>
        <source>Pressure at which the pen touches the surface</source>
        <translation>Druck, ab dem der Stift den Untergrund berührt</translation>
    </message>
    <message>
        <source>Raise this if the pen draws before you press it.</source>
        <translation>Erhöhen, wenn der Stift schon zeichnet, bevor Sie drücken.</translation>
    </message>
    <message>
        <source>Reset cur&amp;ve</source>
        <translation>Kurve zurück&amp;setzen</translation>
    </message>
    <message>
        <source>Restores the default curve.</source>
        <translation>Stellt die Standardkurve wieder her.</translation>
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
        <source>Charcoal, chalk and pencils draw broader with a tilted pen, if it reports its tilt.</source>
        <translation>Kohle, Kreide und Bleistifte zeichnen mit geneigtem Stift breiter, wenn er seine Neigung meldet.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>Clears the test area.</source>
        <translation>Leert den Testbereich.</translation>
    </message>
    <message>
        <source>Buttons, mouse and touch</source>
        <translation>Tasten, Maus und Touch</translation>
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
        <source>Constant</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Thinner when fast</source>
        <translation>Bei Tempo dünner</translation>
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
        <source>Moves the view</source>
        <translation>Verschiebt die Ansicht</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>Zeichnet</translation>
    </message>
    <message>
        <source>Nothing: touch is off</source>
        <translation>Nichts: Touch ist aus</translation>
    </message>
    <message>
        <source>Two fingers move, zoom and turn the view. While the pen is near, touch is ignored.</source>
        <translation>Zwei Finger verschieben, zoomen und drehen die Ansicht. Solange der Stift nah ist, wird Touch ignoriert.</translation>
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
        <source>The pen is tilted by %L1°</source>
        <translation>Der Stift ist um %L1° geneigt</translation>
    </message>
    <message>
        <source>The tilt of the pen is not known</source>
        <translation>Die Neigung des Stifts ist nicht bekannt</translation>
    </message>
    <message>
        <source>Tap with two fingers to &amp;undo, with three to redo</source>
        <translation>Tippen mit zwei Fingern macht &amp;rückgängig, mit dreien wiederholt es</translation>
    </message>
    <message>
        <source>A tap is short, and the fingers do not move.</source>
        <translation>Ein Tippen ist kurz, und die Finger bewegen sich nicht.</translation>
    </message>
    <message>
        <source>&amp;Hold the pen or finger still to open the ring of tools</source>
        <translation>Stift oder Finger still &amp;halten öffnet den Ring der Werkzeuge</translation>
    </message>
    <message>
        <source>Touch and rest for 0.6 seconds, then move in a direction and lift. The dot that you drew vanishes.</source>
        <translation>0,6 Sekunden aufsetzen und ruhen, dann in eine Richtung bewegen und abheben. Der gezeichnete Punkt verschwindet.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PictureActions</name>
    <message>
        <source>Import p&amp;icture…</source>
        <translation>B&amp;ild importieren …</translation>
    </message>
    <message>
        <source>Add a picture or a page of a PDF file to draw over</source>
        <translation>Ein Bild oder eine Seite einer PDF-Datei zum Nachzeichnen hinzufügen</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Import a picture</source>
        <translation>Ein Bild importieren</translation>
    </message>
    <message>
        <source>“%1” cannot be imported</source>
        <translation>„%1“ lässt sich nicht importieren</translation>
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
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Zeichenfläche</translation>
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
    <name>felt::desktop::PresetMenu</name>
    <message>
        <source>P&amp;resets</source>
        <translation>Vor&amp;gaben</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PressureCurveEditor</name>
    <message>
        <source>Pressure curve</source>
        <translation>Druckkurve</translation>
    </message>
    <message>
        <source>From the pressure of the pen (left to right) to the width of the line (bottom to top). The arrow keys move a handle; Space selects the other one.</source>
        <translation>Vom Druck des Stifts (links nach rechts) zur Breite der Linie (unten nach oben). Die Pfeiltasten bewegen einen Griff; die Leertaste wählt den anderen.</translation>
    </message>
    <message>
        <source>Drag the two handles. Higher is wider.</source>
        <translation>Ziehen Sie die beiden Griffe. Höher ist breiter.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ProbePlot</name>
    <message>
        <source>Plot of the force along a stroke of 40 mm</source>
        <translation>Diagramm der Kraft entlang eines Strichs von 40 mm</translation>
    </message>
    <message>
        <source>%1 N of friction; the grain changes it by up to %2 N, which can be felt.</source>
        <translation>%1 N Reibung; die Körnung ändert sie um bis zu %2 N, was spürbar ist.</translation>
    </message>
    <message>
        <source>%1 N of friction; the grain changes it by up to %2 N, which is too little to feel.</source>
        <translation>%1 N Reibung; die Körnung ändert sie um bis zu %2 N, was zu wenig zum Spüren ist.</translation>
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
    <name>felt::desktop::PullHint</name>
    <message>
        <source>Choose the tool %1 and pull this line</source>
        <translation>Das Werkzeug %1 wählen und an dieser Linie ziehen</translation>
    </message>
    <message>
        <source>Hold %1 and pull this line</source>
        <translation>%1 halten und an dieser Linie ziehen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::QuestionScreen</name>
    <message>
        <source>Your opinion on this session</source>
        <translation>Ihre Meinung zu dieser Sitzung</translation>
    </message>
    <message>
        <source>Your opinion on %1</source>
        <translation>Ihre Meinung zu %1</translation>
    </message>
    <message>
        <source>For each question, choose the mark that matches your experience best.</source>
        <translation>Wählen Sie bei jeder Frage den Strich, der am besten zu Ihrer Erfahrung passt.</translation>
    </message>
    <message>
        <source>For each line, choose the circle that matches your impression best.</source>
        <translation>Wählen Sie in jeder Zeile den Kreis, der am besten zu Ihrem Eindruck passt.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ReadingSpeech</name>
    <message>
        <source>red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>Türkis</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>white</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>dark grey</source>
        <translation>Dunkelgrau</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>Braun</translation>
    </message>
    <message>
        <source>line, %1, %2 mm</source>
        <translation>Linie, %1, %2 mm</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>crossing of %1 lines</source>
        <translation>Kreuzung von %1 Linien</translation>
    </message>
    <message>
        <source>fill, %1</source>
        <translation>Füllung, %1</translation>
    </message>
    <message>
        <source>layer %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::RecoveryDialog</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Recover drawings</source>
        <translation>Zeichnungen wiederherstellen</translation>
    </message>
    <message>
        <source>Feltline closed unexpectedly. These drawings have unsaved changes:</source>
        <translation>Feltline wurde unerwartet beendet. Diese Zeichnungen haben nicht gespeicherte Änderungen:</translation>
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
        <translation>„%1“ wiederherstellen</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen …</translation>
    </message>
    <message>
        <source>Discard “%1”</source>
        <translation>„%1“ verwerfen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen.</translation>
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
        <translation>Bild der wiederhergestellten Zeichnung</translation>
    </message>
    <message>
        <source>Picture of the saved file</source>
        <translation>Bild der gespeicherten Datei</translation>
    </message>
    <message>
        <source>⚠ Some of it could not be read.</source>
        <translation>⚠ Ein Teil davon war nicht lesbar.</translation>
    </message>
    <message>
        <source>Recover as a new drawing</source>
        <translation>Als neue Zeichnung wiederherstellen</translation>
    </message>
    <message>
        <source>Open the saved version</source>
        <translation>Gespeicherte Version öffnen</translation>
    </message>
    <message>
        <source>Open the saved version of “%1”</source>
        <translation>Gespeicherte Version von „%1“ öffnen</translation>
    </message>
    <message>
        <source>The unsaved changes are kept and offered again at the next start</source>
        <translation>Die nicht gespeicherten Änderungen bleiben erhalten und werden beim nächsten Start wieder angeboten</translation>
    </message>
    <message>
        <source>Discard the unsaved changes of “%1”?</source>
        <translation>Nicht gespeicherte Änderungen an „%1“ verwerfen?</translation>
    </message>
    <message>
        <source>This cannot be undone. The saved file does not change.</source>
        <translation>Das lässt sich nicht rückgängig machen. Die gespeicherte Datei ändert sich nicht.</translation>
    </message>
    <message>
        <source>Recovered</source>
        <translation>Wiederhergestellt</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
</context>
<context>
    <name>felt::desktop::RingMenu</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Ring of tools at the pen</source>
        <translation>&amp;Ring der Werkzeuge am Stift</translation>
    </message>
    <message>
        <source>Eight tools around the pen, each in its own direction. Hold the key, move in the direction, and release the key.</source>
        <translation>Acht Werkzeuge um den Stift, jedes in seiner Richtung. Taste halten, in die Richtung bewegen und Taste loslassen.</translation>
    </message>
    <message>
        <source>Ring of &amp;media at the pen</source>
        <translation>Ring der &amp;Zeichenmittel am Stift</translation>
    </message>
    <message>
        <source>Eight media around the pen.</source>
        <translation>Acht Zeichenmittel um den Stift.</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>Zeichenmittel</translation>
    </message>
    <message>
        <source>Ring of si&amp;zes at the pen</source>
        <translation>Ring der &amp;Größen am Stift</translation>
    </message>
    <message>
        <source>Eight sizes around the pen: widths of new lines, or sizes of the current tool. They grow clockwise.</source>
        <translation>Acht Größen um den Stift: Breiten neuer Linien oder Größen des aktuellen Werkzeugs. Sie wachsen im Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Ring of tools</source>
        <translation>Ring der Werkzeuge</translation>
    </message>
    <message>
        <source>Ring of media</source>
        <translation>Ring der Zeichenmittel</translation>
    </message>
    <message>
        <source>Ring of sizes</source>
        <translation>Ring der Größen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShadeField</name>
    <message>
        <source>Saturation and brightness</source>
        <translation>Sättigung und Helligkeit</translation>
    </message>
    <message>
        <source>Horizontal: saturation. Vertical: brightness. Change them with the arrow keys.</source>
        <translation>Horizontal: Sättigung. Vertikal: Helligkeit. Mit den Pfeiltasten ändern.</translation>
    </message>
    <message>
        <source>Saturation %1 %, brightness %2 %</source>
        <translation>Sättigung %1 %, Helligkeit %2 %</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShapeRow</name>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Path data of SVG with M, L, H, V, C and Z: x 0 to 1 along one repeat, y -0.5 to 0.5 across the line</source>
        <translation>Pfaddaten von SVG mit M, L, H, V, C und Z: x 0 bis 1 entlang einer Wiederholung, y -0.5 bis 0.5 quer zur Linie</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShortcutSheet</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Tastenkürzel suchen</translation>
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
        <source>No shortcut found.</source>
        <translation>Kein Tastenkürzel gefunden.</translation>
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
        <source>Reass&amp;ign</source>
        <translation>&amp;Neu zuweisen</translation>
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
        <translation>Alle Tastenkürzel zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the default keys of all commands?</source>
        <translation>Die Standardtasten aller Befehle wiederherstellen?</translation>
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
        <translation>%1 ist bereits „%2“ zugewiesen.</translation>
    </message>
    <message>
        <source>&amp;Letters, digits and signs alone are keys</source>
        <translation>&amp;Buchstaben, Ziffern und Zeichen allein sind Tasten</translation>
    </message>
    <message>
        <source>Switch this off if speech input or accidental presses trigger commands</source>
        <translation>Ausschalten, wenn Spracheingabe oder versehentliches Drücken Befehle auslöst</translation>
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
        <source>Width of a line drawn with the mouse, or size of the current tool. Press [ or ] to change it, or hold Ctrl and Alt and drag. Selected lines get the width, too.</source>
        <translation>Breite einer mit der Maus gezeichneten Linie oder Größe des aktuellen Werkzeugs. Mit [ oder ] ändern, oder mit gehaltenem Strg und Alt ziehen. Auch ausgewählte Linien bekommen die Breite.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SolidPanel</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Inflating…</source>
        <translation>Wird aufgeblasen…</translation>
    </message>
    <message>
        <source>Draw a closed line: it becomes a body here.</source>
        <translation>Zeichnen Sie eine geschlossene Linie: Hier wird daraus ein Körper.</translation>
    </message>
    <message>
        <source>Close wider gaps</source>
        <translation>Größere Lücken schließen</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>Gaps of the outline up to this size count as closed</source>
        <translation>Lücken des Umrisses bis zu dieser Größe gelten als geschlossen</translation>
    </message>
    <message>
        <source>Uses the smallest of 2, 4 and 8 mm that closes most of the drawing</source>
        <translation>Nimmt die kleinste von 2, 4 und 8 mm, die den größten Teil der Zeichnung schließt</translation>
    </message>
    <message>
        <source>Closed lines inside an outline, such as eyes, make no holes</source>
        <translation>Geschlossene Linien in einem Umriss, etwa Augen, werden keine Löcher</translation>
    </message>
    <message>
        <source>Shows the triangles</source>
        <translation>Zeigt die Dreiecke</translation>
    </message>
    <message>
        <source>Cuts away the right part</source>
        <translation>Schneidet den rechten Teil weg</translation>
    </message>
    <message>
        <source>Position of the section</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source>Writes the bodies as a file for printing or for a 3D program</source>
        <translation>Schreibt die Körper als Datei zum Drucken oder für ein 3D-Programm</translation>
    </message>
    <message>
        <source>Bodies: %1. Triangles: %2.</source>
        <translation>Körper: %1. Dreiecke: %2.</translation>
    </message>
    <message>
        <source>Close gaps up to %1</source>
        <translation>Lücken bis %1 schließen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Gap:</source>
        <translation>Lücke:</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>The drawing has no body, because no line is closed.</source>
        <translation>Es gibt keinen Körper, weil keine Linie geschlossen ist.</translation>
    </message>
    <message>
        <source>The drawing has no body.</source>
        <translation>Es gibt keinen Körper.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Wait until the last stroke has been applied.</source>
        <translation>Warten Sie, bis der letzte Strich angewendet ist.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SolidScene</name>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Arrow keys turn the solid, plus and minus zoom, Home shows the first view again</source>
        <translation>Pfeiltasten drehen den Körper, Plus und Minus zoomen, Pos1 zeigt wieder die erste Ansicht</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SolidTouchMode</name>
    <message>
        <source>&amp;Touch the solid</source>
        <translation>Körper &amp;betasten</translation>
    </message>
    <message>
        <source>The pen feels the bodies of the solid view, and draws nothing meanwhile</source>
        <translation>Der Stift spürt die Körper der Körperansicht und zeichnet solange nichts</translation>
    </message>
    <message>
        <source>To touch a body, open the solid view and draw a closed line.</source>
        <translation>Um einen Körper zu betasten, öffnen Sie die Körperansicht und zeichnen Sie eine geschlossene Linie.</translation>
    </message>
    <message>
        <source>This device cannot push in three directions, so it cannot let you touch a body.</source>
        <translation>Dieses Gerät kann nicht in drei Richtungen drücken; deshalb lässt sich damit kein Körper betasten.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SoundState</name>
    <message>
        <source>There is no sound device. Sound starts when one is connected.</source>
        <translation>Es gibt kein Audiogerät. Der Ton beginnt, sobald eines angeschlossen ist.</translation>
    </message>
    <message>
        <source>This program was built without sound.</source>
        <translation>Dieses Programm wurde ohne Ton gebaut.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SpiralArea</name>
    <message>
        <source>Spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Draw along the spiral, from its middle outwards.</source>
        <translation>Zeichnen Sie die Spirale nach, von der Mitte nach außen.</translation>
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
        <source>Position of the pen</source>
        <translation>Position des Stifts</translation>
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
        <source>Rotation of the view</source>
        <translation>Drehung der Ansicht</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>State of the file</source>
        <translation>Status der Datei</translation>
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
    <message>
        <source>Saved in %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SteadyDialog</name>
    <message>
        <source>The computer was too busy and missed parts of the spiral. Close other programs, then start again.</source>
        <translation>Der Rechner war zu beschäftigt und hat Teile der Spirale verpasst. Schließen Sie andere Programme und beginnen Sie neu.</translation>
    </message>
    <message>
        <source>This pen reports its position too rarely to measure a shaking.</source>
        <translation>Dieser Stift meldet seine Position zu selten, um ein Zittern zu messen.</translation>
    </message>
    <message>
        <source>No shaking was found, so there is nothing to remove.</source>
        <translation>Es wurde kein Zittern gefunden, also gibt es nichts zu entfernen.</translation>
    </message>
    <message>
        <source>%L1 times a second, by %L2 mm to each side</source>
        <translation>%L1-mal pro Sekunde, um %L2 mm zu jeder Seite</translation>
    </message>
    <message>
        <source>Measure the hand</source>
        <translation>Hand messen</translation>
    </message>
    <message>
        <source>Trace the spiral slowly, from the middle outwards, without resting the hand. It takes about ten seconds. What is measured stays on this computer.</source>
        <translation>Zeichnen Sie die Spirale langsam nach, von der Mitte nach außen, ohne die Hand abzulegen. Es dauert etwa zehn Sekunden. Was gemessen wird, bleibt auf diesem Computer.</translation>
    </message>
    <message>
        <source>The spiral begins where your device touches first.</source>
        <translation>Die Spirale beginnt dort, wo Ihr Gerät zuerst aufsetzt.</translation>
    </message>
    <message>
        <source>How much of the ten seconds is drawn</source>
        <translation>Wie viel von den zehn Sekunden gezeichnet ist</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>&amp;Neu beginnen</translation>
    </message>
    <message>
        <source>The hand shakes %1.</source>
        <translation>Die Hand zittert %1.</translation>
    </message>
    <message>
        <source>That was too short. Draw slowly, for about ten seconds, without lifting the pen.</source>
        <translation>Das war zu kurz. Zeichnen Sie langsam, etwa zehn Sekunden lang, ohne den Stift abzuheben.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SteadyGroup</name>
    <message>
        <source>Steady hand</source>
        <translation>Ruhige Hand</translation>
    </message>
    <message>
        <source>&amp;Remove the shaking of the hand</source>
        <translation>Das Zitte&amp;rn der Hand entfernen</translation>
    </message>
    <message>
        <source>Lines become calm while you draw, and calmer when you lift the pen. The command Line as drawn brings the shaken line back.</source>
        <translation>Linien werden ruhig, während Sie zeichnen, und ruhiger, wenn Sie den Stift heben. Der Befehl Linie wie gezeichnet holt die gezitterte Linie zurück.</translation>
    </message>
    <message>
        <source>&amp;Measure…</source>
        <translation>&amp;Messen…</translation>
    </message>
    <message>
        <source>Measures how the hand shakes, by a spiral of ten seconds.</source>
        <translation>Misst mit einer Spirale von zehn Sekunden, wie die Hand zittert.</translation>
    </message>
    <message>
        <source>Set to a hand that shakes %1.</source>
        <translation>Eingestellt auf eine Hand, die %1 zittert.</translation>
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
        <source>This drawing has its own values for: %1. Your materials are unchanged.</source>
        <translation>Diese Zeichnung hat eigene Werte für: %1. Ihre Materialien sind unverändert.</translation>
    </message>
    <message>
        <source>The surface “%1” is not installed, so the previous surface is used.</source>
        <translation>Der Untergrund „%1“ ist nicht installiert, daher wird der vorige verwendet.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TactilePanel</name>
    <message>
        <source>Gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>Small shape</source>
        <translation>Kleine Form</translation>
    </message>
    <message>
        <source>Short side</source>
        <translation>Kurze Seite</translation>
    </message>
    <message>
        <source>Narrow area</source>
        <translation>Schmale Fläche</translation>
    </message>
    <message>
        <source>Line widths</source>
        <translation>Linienbreiten</translation>
    </message>
    <message>
        <source>Area colours</source>
        <translation>Flächenfarben</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Thin line</source>
        <translation>Dünne Linie</translation>
    </message>
    <message>
        <source>%1 mm between lines, for %2 mm; at least %3 mm</source>
        <translation>%1 mm zwischen Linien, auf %2 mm; mindestens %3 mm</translation>
    </message>
    <message>
        <source>%1 mm long; at least %2 mm</source>
        <translation>%1 mm lang; mindestens %2 mm</translation>
    </message>
    <message>
        <source>%1 mm wide; at least %2 mm</source>
        <translation>%1 mm breit; mindestens %2 mm</translation>
    </message>
    <message>
        <source>%1 different widths; at most %2</source>
        <translation>%1 verschiedene Breiten; höchstens %2</translation>
    </message>
    <message>
        <source>%1 colours, which feel the same</source>
        <translation>%1 Farben, die sich gleich anfühlen</translation>
    </message>
    <message>
        <source>%1 mm; at most %2 mm (A4)</source>
        <translation>%1 mm; höchstens %2 mm (A4)</translation>
    </message>
    <message>
        <source>Swell paper</source>
        <translation>Schwellpapier</translation>
    </message>
    <message>
        <source>An embosser</source>
        <translation>Einen Prägedrucker</translation>
    </message>
    <message>
        <source>Lines on swell paper must be 6.4 mm apart, embossed lines 3.2 mm</source>
        <translation>Linien auf Schwellpapier brauchen 6,4 mm Abstand, geprägte Linien 3,2 mm</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Made &amp;for:</source>
        <translation>Gedacht &amp;für:</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>The lines are longer than 100 m: too much for a raised drawing.</source>
        <translation>Die Linien sind länger als 100 m: zu viel für eine tastbare Zeichnung.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No faults.</source>
        <translation>Keine Fehler.</translation>
    </message>
    <message>
        <source>%1 faults; the first %2 are shown.</source>
        <translation>%1 Fehler; die ersten %2 sind zu sehen.</translation>
    </message>
    <message>
        <source>Faults: %1. Click one to go to it.</source>
        <translation>Fehler: %1. Ein Klick führt hin.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TestPad</name>
    <message>
        <source>Test pad</source>
        <translation>Testbereich</translation>
    </message>
    <message>
        <source>Press here with pen or mouse to try the device</source>
        <translation>Hier mit Stift oder Maus drücken, um das Gerät auszuprobieren</translation>
    </message>
    <message>
        <source>Try this device on the drawing area.</source>
        <translation>Probieren Sie dieses Gerät auf der Zeichenfläche aus.</translation>
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
        <source>active while the key is held</source>
        <translation>aktiv, solange die Taste gedrückt ist</translation>
    </message>
    <message>
        <source>returns when the key is released</source>
        <translation>kehrt zurück, wenn die Taste losgelassen wird</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ToolKeys</name>
    <message>
        <source>&amp;Eraser while held</source>
        <translation>&amp;Radierer, solange gedrückt</translation>
    </message>
    <message>
        <source>Uses the eraser while the key is held, or the pencil if the eraser is active</source>
        <translation>Benutzt den Radierer, solange die Taste gedrückt ist, oder den Bleistift, wenn der Radierer aktiv ist</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TopBar</name>
    <message>
        <source>Top bar</source>
        <translation>Obere Leiste</translation>
    </message>
    <message>
        <source>Surface:</source>
        <translation>Untergrund:</translation>
    </message>
    <message>
        <source>Material of the surface</source>
        <translation>Material des Untergrunds</translation>
    </message>
    <message>
        <source>How the surface feels and looks</source>
        <translation>Wie sich der Untergrund anfühlt und aussieht</translation>
    </message>
    <message>
        <source>Drawing medium</source>
        <translation>Zeichenmittel</translation>
    </message>
    <message>
        <source>How the medium looks, feels and sounds</source>
        <translation>Wie das Zeichenmittel aussieht, sich anfühlt und klingt</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Größe:</translation>
    </message>
    <message>
        <source>Medium:</source>
        <translation>Zeichenmittel:</translation>
    </message>
    <message>
        <source>Presets: a medium with its size, colour and options, under a name</source>
        <translation>Vorgaben: ein Zeichenmittel mit Größe, Farbe und Optionen unter einem Namen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TourWindow</name>
    <message>
        <source>Guided tour</source>
        <translation>Geführte Tour</translation>
    </message>
    <message>
        <source>Drawing area of the tour</source>
        <translation>Zeichenfläche der Tour</translation>
    </message>
    <message>
        <source>Progress of the tour</source>
        <translation>Fortschritt der Tour</translation>
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
        <source>Draw with a pen or with the mouse. Press ? for the keys. You can undo everything with Ctrl+Z.</source>
        <translation>Zeichnen Sie mit einem Stift oder der Maus. ? zeigt die Tastenkürzel. Mit Strg+Z können Sie alles rückgängig machen.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>C&amp;ontinue</source>
        <translation>&amp;Fortsetzen</translation>
    </message>
    <message>
        <source>&amp;Try it yourself</source>
        <translation>Selbst &amp;versuchen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TrialScreen</name>
    <message>
        <source>Draw along the line. Begin at the dot and go in the direction of the arrow.</source>
        <translation>Zeichnen Sie die Linie nach. Beginnen Sie am Punkt, in Richtung des Pfeils.</translation>
    </message>
    <message>
        <source>Draw between the walls without touching them. Begin at the dot and go in the direction of the arrow.</source>
        <translation>Zeichnen Sie zwischen den Wänden, ohne sie zu berühren. Beginnen Sie am Punkt, in Richtung des Pfeils.</translation>
    </message>
    <message>
        <source>Draw the same shape in the empty half on the right.</source>
        <translation>Zeichnen Sie dieselbe Form in die leere rechte Hälfte.</translation>
    </message>
    <message>
        <source>Draw from target to target in the order of the numbers.</source>
        <translation>Zeichnen Sie von Ziel zu Ziel, in der Reihenfolge der Zahlen.</translation>
    </message>
    <message>
        <source>Move the pen over the page until you feel a line in it, and follow this line.</source>
        <translation>Bewegen Sie den Stift über die Seite, bis Sie darin eine Linie fühlen, und folgen Sie dieser Linie.</translation>
    </message>
    <message>
        <source>Draw over the line. Begin at the dot and go in the direction of the arrow.</source>
        <translation>Zeichnen Sie über die Linie. Beginnen Sie am Punkt und folgen Sie der Richtung des Pfeils.</translation>
    </message>
    <message>
        <source>Draw along the line, once around, so that the end of your line meets its start.</source>
        <translation>Zeichnen Sie die Linie einmal ganz herum nach, sodass das Ende Ihrer Linie ihren Anfang trifft.</translation>
    </message>
    <message>
        <source>Draw along the band with one line that is as broad as the band everywhere. Begin at the dot.</source>
        <translation>Zeichnen Sie entlang des Bandes eine einzige Linie, die überall so breit ist wie das Band. Beginnen Sie am Punkt.</translation>
    </message>
    <message>
        <source>Erase the marked part of the line, up to the two lines that cross it. Leave all other lines as they are.</source>
        <translation>Radieren Sie den markierten Teil der Linie weg, bis zu den beiden Linien, die sie kreuzen. Lassen Sie alle anderen Linien, wie sie sind.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>You will not see what you draw.</source>
        <translation>Sie sehen nicht, was Sie zeichnen.</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>Übung</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TrialWindow</name>
    <message>
        <source>The line was much shorter than the shape. Please draw the whole shape.</source>
        <translation>Die Linie war viel kürzer als die Form. Bitte zeichnen Sie die ganze Form.</translation>
    </message>
    <message>
        <source>The pen was lifted often. Please keep it on the page.</source>
        <translation>Der Stift wurde oft abgehoben. Bitte lassen Sie ihn auf der Seite.</translation>
    </message>
    <message>
        <source>The pen left the tunnel. Please stay between the walls.</source>
        <translation>Der Stift hat den Tunnel verlassen. Bitte bleiben Sie zwischen den Wänden.</translation>
    </message>
    <message>
        <source>That was very fast. Please draw a little more slowly.</source>
        <translation>Das war sehr schnell. Bitte zeichnen Sie etwas langsamer.</translation>
    </message>
    <message>
        <source>The device had a problem. It was not your fault.</source>
        <translation>Das Gerät hatte eine Störung. Es lag nicht an Ihnen.</translation>
    </message>
    <message>
        <source>After each drawing, press Space or the button “Done”.</source>
        <translation>Drücken Sie nach jeder Zeichnung die Leertaste oder den Knopf „Fertig“.</translation>
    </message>
    <message>
        <source>You may feel forces in the pen. Hold it before you begin.</source>
        <translation>Der Stift kann Kräfte ausüben. Nehmen Sie ihn in die Hand, bevor Sie beginnen.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Thank you!</source>
        <translation>Vielen Dank!</translation>
    </message>
    <message>
        <source>You have finished. Please tell the researcher.</source>
        <translation>Sie sind fertig. Bitte sagen Sie der Versuchsleitung Bescheid.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Please draw this one again</source>
        <translation>Bitte noch einmal zeichnen</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Please rest a little</source>
        <translation>Bitte ruhen Sie sich etwas aus</translation>
    </message>
    <message>
        <source>Relax your hand and your arm.</source>
        <translation>Entspannen Sie Hand und Arm.</translation>
    </message>
    <message>
        <source>This cannot be saved: %1</source>
        <translation>Das kann nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>Stop the session? Finished trials are saved.</source>
        <translation>Die Sitzung beenden? Fertige Durchgänge sind gespeichert.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weitermachen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::UserMaterials</name>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 was changed by another program and was not overwritten. Save your material under another name; you can import the file.</source>
        <translation>%1 wurde von einem anderen Programm geändert und nicht überschrieben. Speichern Sie Ihr Material unter einem anderen Namen; die Datei können Sie importieren.</translation>
    </message>
    <message>
        <source>It is installed for all users of this computer and cannot be deleted here: %1</source>
        <translation>Es ist für alle Benutzer dieses Computers installiert und kann hier nicht gelöscht werden: %1</translation>
    </message>
    <message>
        <source>%1 was changed by another program and was not deleted. To remove it, delete the file.</source>
        <translation>%1 wurde von einem anderen Programm geändert und nicht gelöscht. Um es zu entfernen, löschen Sie die Datei.</translation>
    </message>
</context>
<context>
    <name>tools</name>
    <message>
        <source>Guide</source>
        <translation>Hilfslinie</translation>
    </message>
    <message>
        <source>Lines that lead out of the loop: only their part inside (parts), or the whole line (strokes). By control points, as in the paper (points), or by joints (on-curve).</source>
        <translation>Linien, die aus der Schlinge hinausführen: nur ihr Teil innen (Teile) oder die ganze Linie (Linien). Nach Kontrollpunkten wie im Artikel (Punkte) oder nach Gelenken (auf der Kurve).</translation>
    </message>
    <message>
        <source>Places rulers, grids, mirror axes and other guides, and moves and turns them.</source>
        <translation>Setzt Lineale, Raster, Spiegelachsen und andere Hilfslinien, verschiebt und dreht sie.</translation>
    </message>
    <message>
        <source>Drag to place a guide, or drag a guide by a handle or a line.</source>
        <translation>Ziehen setzt eine Hilfslinie; an einem Griff oder einer Linie ziehen verändert sie.</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>removes the guide</source>
        <translation>entfernt die Hilfslinie</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>The guide that a drag on a free part of the page places.</source>
        <translation>Die Hilfslinie, die ein Ziehen auf freier Seite setzt.</translation>
    </message>
    <message>
        <source>Mirror axes</source>
        <translation>Spiegelachsen</translation>
    </message>
    <message>
        <source>How many axes a new symmetry has. Each stroke gets twice as many images.</source>
        <translation>Wie viele Achsen eine neue Symmetrie hat. Jede Linie hat doppelt so viele Bilder.</translation>
    </message>
    <message>
        <source>Vanishing points</source>
        <translation>Fluchtpunkte</translation>
    </message>
    <message>
        <source>How many vanishing points a new perspective has.</source>
        <translation>Wie viele Fluchtpunkte eine neue Perspektive hat.</translation>
    </message>
    <message>
        <source>How strongly a new guide holds the pen of the pencil.</source>
        <translation>Wie stark eine neue Hilfslinie den Stift hält.</translation>
    </message>
    <message>
        <source>ruler</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>parallels</source>
        <translation>Parallelen</translation>
    </message>
    <message>
        <source>set-square</source>
        <translation>Geodreieck</translation>
    </message>
    <message>
        <source>protractor</source>
        <translation>Winkelmesser</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>Zirkel</translation>
    </message>
    <message>
        <source>ellipses</source>
        <translation>Ellipsen</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>isometric-grid</source>
        <translation>isometrisches Raster</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>Spur</translation>
    </message>
    <message>
        <source>steps of 15°</source>
        <translation>Schritte von 15°</translation>
    </message>
    <message>
        <source>Draw a line around the selection, or a rectangle from corner to corner.</source>
        <translation>Die Auswahl mit einer Linie umfahren oder ein Rechteck von Ecke zu Ecke aufziehen.</translation>
    </message>
    <message>
        <source>Lines farther from the pen than this are not grabbed.</source>
        <translation>Linien, die weiter vom Stift entfernt sind, werden nicht gegriffen.</translation>
    </message>
    <message>
        <source>Erases the ink that the ring covers. If off, cuts a line where the ring covers its centre line.</source>
        <translation>Radiert die Tinte, die der Ring bedeckt. Wenn aus, wird eine Linie dort getrennt, wo der Ring ihre Mittellinie bedeckt.</translation>
    </message>
    <message>
        <source>A grabbed line keeps its distance from the pen instead of moving to it.</source>
        <translation>Eine gegriffene Linie behält ihren Abstand zum Stift, statt zu ihm zu wandern.</translation>
    </message>
    <message>
        <source>A short touch selects the nearest line within this distance.</source>
        <translation>Eine kurze Berührung wählt die nächste Linie in diesem Abstand aus.</translation>
    </message>
    <message>
        <source>Above 1, light pressure stays thin for longer; below 1, lines broaden sooner.</source>
        <translation>Über 1 bleiben Linien bei leichtem Druck länger dünn, unter 1 werden sie früher breit.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>An end released away from all others stays there. If off, it returns. The first modifier inverts this.</source>
        <translation>Ein abseits aller anderen losgelassenes Ende bleibt dort. Wenn aus, kehrt es zurück. Die erste Zusatztaste kehrt dies um.</translation>
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
        <source>Erase by ink width</source>
        <translation>Tintenbreite berücksichtigen</translation>
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
        <source>Corrects lines: grab one and pull it into shape, or push it from outside.</source>
        <translation>Korrigiert Linien: eine greifen und in Form ziehen oder von außen schieben.</translation>
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
        <source>Ends and corners move along instead of staying; the first modifier inverts this for one gesture.</source>
        <translation>Enden und Ecken bewegen sich mit, statt zu bleiben; die erste Zusatztaste kehrt dies für eine Geste um.</translation>
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
        <source>Grab divides the line so that no more than this is bent; 0 bends whole segments.</source>
        <translation>Greifen teilt die Linie, damit nicht mehr als diese Länge gebogen wird; 0 biegt ganze Segmente.</translation>
    </message>
    <message>
        <source>Grab radius</source>
        <translation>Greifradius</translation>
    </message>
    <message>
        <source>A larger mass draws smoother lines with more lag; for the stabiliser &apos;inertia&apos;.</source>
        <translation>Eine größere Masse zeichnet glattere Linien mit mehr Verzögerung; für den Stabilisator „Trägheit“.</translation>
    </message>
    <message>
        <source>How far a line may move when it is simplified after the gesture; more gives fewer segments.</source>
        <translation>Wie weit sich eine Linie beim Vereinfachen nach der Geste verschieben darf; mehr ergibt weniger Segmente.</translation>
    </message>
    <message>
        <source>How far the simplified line may be from the smoothed one.</source>
        <translation>Wie weit die vereinfachte Linie von der geglätteten abweichen darf.</translation>
    </message>
    <message>
        <source>Tilt of the pen from upright, if the device does not report it. Some media draw broader and softer when tilted.</source>
        <translation>Neigung des Stifts aus der Senkrechten, wenn das Gerät sie nicht meldet. Manche Zeichenmittel zeichnen geneigt breiter und weicher.</translation>
    </message>
    <message>
        <source>How fast it smooths; pressing harder is faster.</source>
        <translation>Wie schnell geglättet wird; fester drücken geht schneller.</translation>
    </message>
    <message>
        <source>How fast the width changes, per unit of pressure.</source>
        <translation>Wie schnell sich die Breite ändert, je Einheit Druck.</translation>
    </message>
    <message>
        <source>How grab and sweep bend a segment: with least motion (soft), by the paper&apos;s three cases (paper), or by its equation 7 as printed, which moves the line less than the pen.</source>
        <translation>Wie Greifen und Fegen ein Segment biegen: mit geringster Bewegung (weich), nach den drei Fällen des Artikels (Artikel) oder nach seiner gedruckten Gleichung 7, mit der sich die Linie weniger bewegt als der Stift.</translation>
    </message>
    <message>
        <source>Distance from the end of a line at which the pen grabs it.</source>
        <translation>Abstand vom Linienende, in dem der Stift es greift.</translation>
    </message>
    <message>
        <source>How slowly a line gives way to the pen that sweeps it.</source>
        <translation>Wie langsam eine Linie dem fegenden Stift nachgibt.</translation>
    </message>
    <message>
        <source>Smooths the jitter out of lines and keeps their shape.</source>
        <translation>Glättet das Zittern in Linien und behält ihre Form.</translation>
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
        <source>Retracing</source>
        <translation>Nachziehen</translation>
    </message>
    <message>
        <source>Force that holds a slow pen to a line that it draws over; 0 for none.</source>
        <translation>Kraft, die einen langsamen Stift an der Linie hält, die er nachzieht; 0 für keine.</translation>
    </message>
    <message>
        <source>Keep lines separate</source>
        <translation>Linien getrennt lassen</translation>
    </message>
    <message>
        <source>Largest distance between the path of the pen and the line.</source>
        <translation>Größter Abstand zwischen dem Pfad des Stifts und der Linie.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Tilt with a mouse</source>
        <translation>Neigung mit der Maus</translation>
    </message>
    <message>
        <source>Keep the end where it is released</source>
        <translation>Das Ende bleibt, wo es losgelassen wird</translation>
    </message>
    <message>
        <source>About the centre</source>
        <translation>Um die Mitte</translation>
    </message>
    <message>
        <source>Corners and edges scale and stretch about the centre and not about the opposite side, like the third button of the pen.</source>
        <translation>Ecken und Kanten skalieren und strecken um die Mitte statt um die gegenüberliegende Seite, wie die dritte Stifttaste.</translation>
    </message>
    <message>
        <source>Keeps the lines and transforms a copy, like the second button of the pen.</source>
        <translation>Behält die Linien und transformiert eine Kopie, wie die zweite Stifttaste.</translation>
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
        <source>A longer rope draws smoother lines with more lag; for the stabiliser &apos;towed&apos;.</source>
        <translation>Eine längere Leine zeichnet glattere Linien mit mehr Verzögerung; für den Stabilisator „geschleppt“.</translation>
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
        <source>Moves along one axis, turns in steps of 15 degrees, and corners stretch both axes freely, like the first button of the pen.</source>
        <translation>Verschiebt entlang einer Achse, dreht in Schritten von 15 Grad, und Ecken strecken beide Achsen frei, wie die erste Stifttaste.</translation>
    </message>
    <message>
        <source>Moves, turns, scales and stretches the selection. Lines that cross it stay attached and resist.</source>
        <translation>Verschiebt, dreht, skaliert und streckt die Auswahl. Linien, die sie kreuzen, bleiben verbunden und leisten Widerstand.</translation>
    </message>
    <message>
        <source>Lines are not made broader than this. Lines that already are broader keep their width.</source>
        <translation>Linien werden nicht breiter als dieser Wert. Bereits breitere Linien behalten ihre Breite.</translation>
    </message>
    <message>
        <source>For retracing: above 1, light pressure stays thin for longer.</source>
        <translation>Beim Nachziehen: Über 1 bleiben Linien bei leichtem Druck länger dünn.</translation>
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
        <source>Pressure for devices that report neither pressure nor depth.</source>
        <translation>Druck für Geräte, die weder Druck noch Tiefe melden.</translation>
    </message>
    <message>
        <source>Pressure with a mouse</source>
        <translation>Druck mit der Maus</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
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
        <source>Rounds corners instead of keeping them. Ends of lines are always kept.</source>
        <translation>Rundet Ecken ab, statt sie zu erhalten. Linienenden bleiben immer erhalten.</translation>
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
        <source>Selects the lines that you draw around; a short touch selects one line.</source>
        <translation>Wählt die umfahrenen Linien aus; eine kurze Berührung wählt eine Linie aus.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Force level of friction and grain. Does not affect the hardness of the surface.</source>
        <translation>Stärke von Reibung und Körnung. Die Härte des Untergrunds bleibt gleich.</translation>
    </message>
    <message>
        <source>Force level of friction and roughness. Does not affect the hardness of the surface.</source>
        <translation>Stärke von Reibung und Rauheit. Die Härte des Untergrunds bleibt gleich.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction and pull. Does not affect the hardness of the surface.</source>
        <translation>Stärke von Reibung, Körnung, Anziehung und Zug. Die Härte des Untergrunds bleibt gleich.</translation>
    </message>
    <message>
        <source>Force level of friction, stops and pull. Does not affect the hardness of the surface.</source>
        <translation>Stärke von Reibung, Anschlägen und Zug. Die Härte des Untergrunds bleibt gleich.</translation>
    </message>
    <message>
        <source>Force level of the counter-force, friction and grain. Does not affect the hardness of the surface.</source>
        <translation>Stärke von Gegenkraft, Reibung und Körnung. Die Härte des Untergrunds bleibt gleich.</translation>
    </message>
    <message>
        <source>Force level of the surface&apos;s friction and grain. Does not affect its hardness.</source>
        <translation>Stärke von Reibung und Körnung des Untergrunds. Seine Härte bleibt gleich.</translation>
    </message>
    <message>
        <source>Force level of the tethers, friction and grain.</source>
        <translation>Stärke von Leinen, Reibung und Körnung.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Untergrund</translation>
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
        <translation>Geschwindigkeit des Pinsels</translation>
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
        <source>Time to yield</source>
        <translation>Nachgebezeit</translation>
    </message>
    <message>
        <source>How long the counter-force lasts when the pen rests; 0: as long as the pen is down, as in the paper.</source>
        <translation>Wie lange die Gegenkraft anhält, wenn der Stift ruht; 0: solange der Stift aufliegt, wie im Artikel.</translation>
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
        <source>Length of line, to each side of the pen, that is smoothed. Waves up to this length can be removed.</source>
        <translation>Länge der Linie zu jeder Seite des Stifts, die geglättet wird. Wellen bis zu dieser Länge lassen sich entfernen.</translation>
    </message>
    <message>
        <source>Length of line, to each side of the pen, whose width changes.</source>
        <translation>Länge der Linie zu jeder Seite des Stifts, deren Breite sich ändert.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>What a touch does</source>
        <translation>Was eine Berührung tut</translation>
    </message>
    <message>
        <source>How to combine with the previous selection; the first button of the pen adds, the second subtracts.</source>
        <translation>Wie mit der bisherigen Auswahl kombiniert wird; die erste Stifttaste fügt hinzu, die zweite zieht ab.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>What is covered, the part of a line up to its next crossings, or the whole line.</source>
        <translation>Was bedeckt ist, der Teil einer Linie bis zu den nächsten Kreuzungen oder die ganze Linie.</translation>
    </message>
    <message>
        <source>The medium: how it looks and how it slides.</source>
        <translation>Das Zeichenmittel: wie es aussieht und wie es gleitet.</translation>
    </message>
    <message>
        <source>The material of the surface: its hardness and its friction.</source>
        <translation>Das Material des Untergrunds: seine Härte und seine Reibung.</translation>
    </message>
    <message>
        <source>How pull, transform and the attraction of ends resist: without jumps (felt), or by equations 8 to 11 of the paper as printed, which vibrate. For study.</source>
        <translation>Wie Ziehen, Transformieren und die Anziehung von Linienenden widerstehen: ohne Sprünge (felt) oder nach den Gleichungen 8 bis 11 der Veröffentlichung wie gedruckt (paper); diese vibrieren. Zum Studium.</translation>
    </message>
    <message>
        <source>Law of the forces</source>
        <translation>Gesetz der Kräfte</translation>
    </message>
    <message>
        <source>Only the plane</source>
        <translation>Nur die Fläche</translation>
    </message>
    <message>
        <source>On the page, the plane of the surface is the only force: no friction, grain, attraction or guide. To compare other forces with.</source>
        <translation>Auf der Seite ist die Fläche des Untergrunds die einzige Kraft: keine Reibung, Körnung, Anziehung oder Führung. Zum Vergleich mit anderen Kräften.</translation>
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
        <source>If nothing is selected, a touch selects the nearest line within this distance.</source>
        <translation>Ist nichts ausgewählt, wählt eine Berührung die nächste Linie in diesem Abstand aus.</translation>
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
        <source>Above 1, light pressure stays pale for longer; below 1, lines darken sooner.</source>
        <translation>Über 1 bleiben Linien bei leichtem Druck länger blass, unter 1 werden sie früher dunkel.</translation>
    </message>
    <message>
        <source>Another number gives another relief of the same character.</source>
        <translation>Eine andere Zahl ergibt ein anderes Relief derselben Art.</translation>
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
        <source>Coefficient of friction of a pencil on this surface.</source>
        <translation>Reibungszahl eines Bleistifts auf diesem Untergrund.</translation>
    </message>
    <message>
        <source>Coefficient of friction on paper, unless a pair sets another.</source>
        <translation>Reibungszahl auf Papier, sofern kein Paar eine andere festlegt.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
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
        <source>Damping while the tip sticks.</source>
        <translation>Dämpfung, während die Spitze haftet.</translation>
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
        <source>Grain wavelength. A custom relief spans 32 wavelengths.</source>
        <translation>Wellenlänge der Körnung. Ein eigenes Relief ist 32 Wellenlängen breit.</translation>
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
        <source>Ink fades in from this far below the depth to this far above it.</source>
        <translation>Die Farbe setzt so weit unterhalb der Tiefe ein und deckt so weit oberhalb ganz.</translation>
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
        <source>Amount of dry-brush streaking.</source>
        <translation>Stärke der Streifen wie von einem trockenen Pinsel.</translation>
    </message>
    <message>
        <source>Width of the soft edge of a line, as a share of its radius.</source>
        <translation>Breite des weichen Rands einer Linie, als Anteil ihres Radius.</translation>
    </message>
    <message>
        <source>How hard the surface pushes back, if the device allows it.</source>
        <translation>Wie stark der Untergrund zurückdrückt, soweit das Gerät es erlaubt.</translation>
    </message>
    <message>
        <source>How loud a pen is on this surface; 0 is silent.</source>
        <translation>Wie laut ein Stift auf diesem Untergrund ist; 0 ist still.</translation>
    </message>
    <message>
        <source>How loud the medium rubs; 0 is silent.</source>
        <translation>Wie laut das Medium reibt; 0 ist still.</translation>
    </message>
    <message>
        <source>How much of the medium is laid on at full pressure.</source>
        <translation>Wie viel vom Medium bei vollem Druck aufgetragen wird.</translation>
    </message>
    <message>
        <source>How much darker a wet line dries at its edge.</source>
        <translation>Wie viel dunkler eine nasse Linie am Rand trocknet.</translation>
    </message>
    <message>
        <source>How much of the medium is laid on without pressure.</source>
        <translation>Wie viel vom Medium ohne Druck aufgetragen wird.</translation>
    </message>
    <message>
        <source>How much of the pen&apos;s motion into the surface is damped.</source>
        <translation>Wie stark die Bewegung des Stifts in den Untergrund gedämpft wird.</translation>
    </message>
    <message>
        <source>How easily the tip squeaks by sticking and slipping.</source>
        <translation>Wie leicht die Spitze durch Haften und Gleiten quietscht.</translation>
    </message>
    <message>
        <source>How stiffly the tip sticks before it slides.</source>
        <translation>Wie steif die Spitze haftet, bevor sie gleitet.</translation>
    </message>
    <message>
        <source>Tone at full tilt, as a share of the tone with an upright pen.</source>
        <translation>Ton bei voller Neigung, als Anteil des Tons bei aufrechtem Stift.</translation>
    </message>
    <message>
        <source>Width of a line at full tilt, as a multiple of the width with an upright pen.</source>
        <translation>Breite einer Linie bei voller Neigung, als Vielfaches der Breite bei aufrechtem Stift.</translation>
    </message>
    <message>
        <source>Default colour of this medium.</source>
        <translation>Standardfarbe dieses Mediums.</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Opacity of the inked parts at tone 0.</source>
        <translation>Deckkraft der eingefärbten Stellen bei Ton 0.</translation>
    </message>
    <message>
        <source>Opacity of the inked parts at tone 1.</source>
        <translation>Deckkraft der eingefärbten Stellen bei Ton 1.</translation>
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
        <source>Root mean square of the heights; 0 is smooth.</source>
        <translation>Effektivwert der Höhen; 0 ist glatt.</translation>
    </message>
    <message>
        <source>Seed of the grain</source>
        <translation>Startwert der Körnung</translation>
    </message>
    <message>
        <source>How much grain the medium adds by itself: dust and crumbs.</source>
        <translation>Wie viel Körnung das Zeichenmittel selbst mitbringt: Staub und Krümel.</translation>
    </message>
    <message>
        <source>Share of the relief that firm pressure flattens, for the hand and for the eye.</source>
        <translation>Anteil des Reliefs, den kräftiger Druck einebnet, fühlbar und sichtbar.</translation>
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
        <source>Parts of the relief below this height stay bare at tone 1.</source>
        <translation>Teile des Reliefs unter dieser Höhe bleiben bei Ton 1 frei.</translation>
    </message>
    <message>
        <source>Wavelength of the crumbs.</source>
        <translation>Wellenlänge der Krümel.</translation>
    </message>
    <message>
        <source>Tone at full pressure</source>
        <translation>Ton bei vollem Druck</translation>
    </message>
    <message>
        <source>Tone when tilted</source>
        <translation>Ton bei geneigtem Stift</translation>
    </message>
    <message>
        <source>Tone at light pressure</source>
        <translation>Ton bei leichtem Druck</translation>
    </message>
    <message>
        <source>Wear of the grain</source>
        <translation>Abrieb der Körnung</translation>
    </message>
    <message>
        <source>Parts of the relief below this height stay bare at tone 0.</source>
        <translation>Teile des Reliefs unter dieser Höhe bleiben bei Ton 0 frei.</translation>
    </message>
    <message>
        <source>Shape of the relief.</source>
        <translation>Form des Reliefs.</translation>
    </message>
    <message>
        <source>Width when tilted</source>
        <translation>Breite bei geneigtem Stift</translation>
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
        <source>Force that draws a slow pen to its target, beyond the friction of the device.</source>
        <translation>Kraft, die einen langsamen Stift zu seinem Ziel zieht, über die Reibung des Geräts hinaus.</translation>
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
        <source>Drag a line to bend it; drag back to undo the bend.</source>
        <translation>Eine Linie ziehen, um sie zu biegen; zurückziehen hebt die Biegung auf.</translation>
    </message>
    <message>
        <source>Rub along a line to smooth it; press harder to smooth it more.</source>
        <translation>An einer Linie entlangreiben, um sie zu glätten; fester drücken glättet mehr.</translation>
    </message>
    <message>
        <source>Rub a line to make it broader or thinner.</source>
        <translation>Über eine Linie reiben, um sie breiter oder dünner zu machen.</translation>
    </message>
    <message>
        <source>Erase what the ring touches.</source>
        <translation>Radieren, was der Ring berührt.</translation>
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
        <source>Draw around lines to select them, or click one.</source>
        <translation>Linien umfahren, um sie auszuwählen, oder eine anklicken.</translation>
    </message>
    <message>
        <source>adds</source>
        <translation>fügt hinzu</translation>
    </message>
    <message>
        <source>subtracts</source>
        <translation>zieht ab</translation>
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
        <source>about the centre</source>
        <translation>um die Mitte</translation>
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
        <source>the end stays where you release it</source>
        <translation>das Ende bleibt, wo Sie es loslassen</translation>
    </message>
    <message>
        <source>ends and corners move along, or stay</source>
        <translation>Enden und Ecken bewegen sich mit oder bleiben</translation>
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
        <source>Lines become smooth curves while you draw; press harder for a broader line. Near its start, an outline closes by itself.</source>
        <translation>Linien werden beim Zeichnen zu glatten Kurven; fester drücken macht sie breiter. Nahe am Anfang schließt sich ein Umriss von selbst.</translation>
    </message>
    <message>
        <source>Pull and push</source>
        <translation>Ziehen und schieben</translation>
    </message>
    <message>
        <source>Is a line not quite right? Grab it and pull. Like a wire, it resists more the further you pull.</source>
        <translation>Eine Linie stimmt nicht ganz? Greifen und ziehen Sie sie. Wie ein Draht leistet sie mehr Widerstand, je weiter Sie ziehen.</translation>
    </message>
    <message>
        <source>Lines that are already drawn can get another colour. Tap one, or drag across several.</source>
        <translation>Auch fertige Linien können eine andere Farbe bekommen. Tippen Sie eine an oder ziehen Sie über mehrere.</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Drag from corner to corner: a line, a rectangle or an ellipse. Shift makes a square or a circle.</source>
        <translation>Ziehen Sie von Ecke zu Ecke: eine Gerade, ein Rechteck oder eine Ellipse. Mit Umschalt entsteht ein Quadrat oder ein Kreis.</translation>
    </message>
    <message>
        <source>Brush along rough strokes, and they become one line. The bundle resists until it is one.</source>
        <translation>Streichen Sie an rohen Strichen entlang, und sie werden eine Linie. Das Bündel leistet Widerstand, bis es eine ist.</translation>
    </message>
    <message>
        <source>A tap fills the area between lines, a drag fills several. The colour follows the lines when you change them.</source>
        <translation>Ein Tippen füllt die Fläche zwischen Linien, ein Ziehen mehrere. Die Farbe folgt den Linien, wenn Sie sie ändern.</translation>
    </message>
    <message>
        <source>Rub along a shaky line to remove the jitter and keep the shape.</source>
        <translation>Reiben Sie an einer zittrigen Linie entlang: Das Zittern verschwindet, die Form bleibt.</translation>
    </message>
    <message>
        <source>Press on a finished line to make it broader.</source>
        <translation>Drücken Sie auf eine fertige Linie, um sie breiter zu machen.</translation>
    </message>
    <message>
        <source>Erase what is covered, a line up to its next crossing, or a whole line.</source>
        <translation>Radieren Sie, was bedeckt ist, eine Linie bis zur nächsten Kreuzung oder eine ganze Linie.</translation>
    </message>
    <message>
        <source>Draw a loop around lines to select them, or touch one.</source>
        <translation>Umfahren Sie Linien, um sie auszuwählen, oder berühren Sie eine.</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Verschieben und drehen</translation>
    </message>
    <message>
        <source>Drag the selection. Lines that cross it stay attached and resist, and you feel how much.</source>
        <translation>Ziehen Sie die Auswahl. Linien, die sie kreuzen, bleiben verbunden und leisten Widerstand, und Sie spüren, wie viel.</translation>
    </message>
    <message>
        <source>Drag one end onto another: they snap together and become one line.</source>
        <translation>Ziehen Sie ein Ende auf ein anderes: Sie rasten ein und werden eine Linie.</translation>
    </message>
    <message>
        <source>Colour of the surface. A page whose colour you changed keeps that colour.</source>
        <translation>Farbe des Untergrunds. Eine Seite, deren Farbe Sie geändert haben, behält sie.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief shows in the ink; 0 for wet ink.</source>
        <translation>Wie viel vom Relief des Untergrunds in der Tinte zu sehen ist; 0 bei nasser Tinte.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief the hand feels through it.</source>
        <translation>Wie viel vom Relief des Untergrunds die Hand hindurch spürt.</translation>
    </message>
    <message>
        <source>Gives</source>
        <translation>Überträgt</translation>
    </message>
    <message>
        <source>Gives lines that are already drawn the current colour or medium.</source>
        <translation>Gibt gezeichneten Linien die aktuelle Farbe oder das aktuelle Medium.</translation>
    </message>
    <message>
        <source>Lines whose ink is within this distance of the pen are changed.</source>
        <translation>Linien, deren Tinte höchstens so weit vom Stift entfernt ist, werden geändert.</translation>
    </message>
    <message>
        <source>Recolour</source>
        <translation>Umfärben</translation>
    </message>
    <message>
        <source>Tap a line, or drag across several, to give them the current colour.</source>
        <translation>Tippen Sie eine Linie an oder ziehen Sie über mehrere, um ihnen die aktuelle Farbe zu geben.</translation>
    </message>
    <message>
        <source>The lines get the current colour with its opacity, the current medium, or both.</source>
        <translation>Die Linien erhalten die aktuelle Farbe mit ihrer Deckkraft, das aktuelle Medium oder beides.</translation>
    </message>
    <message>
        <source>colour and medium</source>
        <translation>Farbe und Medium</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>Medium</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Drag from one corner of the shape to the opposite one.</source>
        <translation>Von einer Ecke der Form zur gegenüberliegenden ziehen.</translation>
    </message>
    <message>
        <source>Draws straight lines, rectangles and ellipses.</source>
        <translation>Zeichnet gerade Linien, Rechtecke und Ellipsen.</translation>
    </message>
    <message>
        <source>The shape that is drawn from corner to corner, with the current medium and size.</source>
        <translation>Die Form, die von Ecke zu Ecke gezeichnet wird, mit dem aktuellen Zeichenmittel und der aktuellen Größe.</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>from the centre</source>
        <translation>von der Mitte aus</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>square, circle, steps of 15°</source>
        <translation>Quadrat, Kreis, Schritte von 15°</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>gerade Linie</translation>
    </message>
    <message>
        <source>straight, in steps of 15°</source>
        <translation>gerade, in Schritten von 15°</translation>
    </message>
    <message>
        <source>Gather</source>
        <translation>Zusammenfassen</translation>
    </message>
    <message>
        <source>Presses a bundle of rough strokes into one line.</source>
        <translation>Fasst ein Bündel roher Striche zu einer Linie zusammen.</translation>
    </message>
    <message>
        <source>Brush along rough strokes to press them into one line.</source>
        <translation>Streichen Sie an rohen Strichen entlang, um sie zu einer Linie zusammenzufassen.</translation>
    </message>
    <message>
        <source>The brush gathers lines within this distance that run along its path.</source>
        <translation>Der Pinsel fasst Linien zusammen, die innerhalb dieses Abstands entlang seines Weges verlaufen.</translation>
    </message>
    <message>
        <source>Width of the line</source>
        <translation>Breite der Linie</translation>
    </message>
    <message>
        <source>The line gets the median width of its strokes, or the width of the strip that they cover.</source>
        <translation>Die Linie erhält die mittlere Breite (Median) ihrer Striche oder die Breite des Streifens, den sie bedecken.</translation>
    </message>
    <message>
        <source>Force level of friction, grain and the resistance of the bundle. Does not affect the hardness of the surface.</source>
        <translation>Stärke von Reibung, Körnung und Widerstand des Bündels. Wirkt nicht auf die Härte der Oberfläche.</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Tap an area to fill it, or drag across several. Tap again to remove the fill.</source>
        <translation>Tippen Sie eine Fläche an, um sie zu füllen, oder ziehen Sie über mehrere. Erneutes Tippen entfernt die Füllung.</translation>
    </message>
    <message>
        <source>removes fills</source>
        <translation>entfernt Füllungen</translation>
    </message>
    <message>
        <source>Fills the areas between lines. Fills follow their lines.</source>
        <translation>Füllt die Flächen zwischen Linien. Füllungen folgen ihren Linien.</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>Gaps of the outline up to this size count as closed. 0: only outlines that touch.</source>
        <translation>Lücken im Umriss bis zu dieser Größe gelten als geschlossen. 0: nur Umrisse, die sich berühren.</translation>
    </message>
    <message>
        <source>Opened areas</source>
        <translation>Geöffnete Flächen</translation>
    </message>
    <message>
        <source>If an edit opens the outline of a fill: a straight edge closes it, or the fill is removed.</source>
        <translation>Wenn eine Änderung den Umriss einer Füllung öffnet: Eine gerade Kante schließt ihn, oder die Füllung wird entfernt.</translation>
    </message>
    <message>
        <source>Felt edge</source>
        <translation>Fühlbarer Rand</translation>
    </message>
    <message>
        <source>Height of the soft ridge at the edge of the area under the pen while it fills.</source>
        <translation>Höhe der weichen Erhebung am Rand der Fläche unter dem Stift, während er füllt.</translation>
    </message>
    <message>
        <source>Force level of the surface&apos;s friction and grain, and of the ridge. Does not affect the surface&apos;s hardness.</source>
        <translation>Stärke von Reibung und Körnung der Oberfläche und der Erhebung. Beeinflusst nicht die Härte der Oberfläche.</translation>
    </message>
    <message>
        <source>close</source>
        <translation>schließen</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>entfernen</translation>
    </message>
    <message>
        <source>Steady hand</source>
        <translation>Ruhige Hand</translation>
    </message>
    <message>
        <source>Removes the shaking of the hand from lines; Preferences &gt; Pen measures how it shakes.</source>
        <translation>Entfernt das Zittern der Hand aus Linien; Einstellungen &gt; Stift misst, wie sie zittert.</translation>
    </message>
    <message>
        <source>Shakes a second</source>
        <translation>Zittern pro Sekunde</translation>
    </message>
    <message>
        <source>How often the hand shakes; for the steady hand.</source>
        <translation>Wie oft die Hand zittert; für die ruhige Hand.</translation>
    </message>
    <message>
        <source>Size of the shaking</source>
        <translation>Größe des Zitterns</translation>
    </message>
    <message>
        <source>How far the hand shakes, from the middle to one side; for the steady hand.</source>
        <translation>Wie weit die Hand zittert, von der Mitte zu einer Seite; für die ruhige Hand.</translation>
    </message>
    <message>
        <source>Direction of the shaking</source>
        <translation>Richtung des Zitterns</translation>
    </message>
    <message>
        <source>Direction of the largest shaking, clockwise from the right; for the steady hand.</source>
        <translation>Richtung des stärksten Zitterns, im Uhrzeigersinn von rechts; für die ruhige Hand.</translation>
    </message>
    <message>
        <source>Scratch out</source>
        <translation>Durchstreichen</translation>
    </message>
    <message>
        <source>Scribble over lines, at least six times to and fro: deleting them is offered.</source>
        <translation>Über Linien kritzeln, mindestens sechsmal hin und her: Feltline bietet an, sie zu löschen.</translation>
    </message>
    <message>
        <source>Circle twice to select</source>
        <translation>Zweimal umkreisen zum Auswählen</translation>
    </message>
    <message>
        <source>Circle lines twice in one stroke: selecting them is offered.</source>
        <translation>Linien in einem Strich zweimal umkreisen: Feltline bietet an, sie auszuwählen.</translation>
    </message>
    <message>
        <source>Hold for a shape</source>
        <translation>Halten für eine Form</translation>
    </message>
    <message>
        <source>Hold the pen still at the end of a line: the shape that it resembles is offered. Press harder to get it, or go on drawing.</source>
        <translation>Den Stift am Ende einer Linie stillhalten: Feltline bietet die Form an, der sie ähnelt. Fester drücken nimmt sie an, Weiterzeichnen lehnt sie ab.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction, hold, retracing and stabiliser. Does not affect the hardness of the surface.</source>
        <translation>Stärke von Reibung, Körnung, Anziehung, Halt, Nachziehen und Stabilisator. Die Härte des Untergrunds bleibt gleich.</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Reads a drawing without eyes: lines attract the pen, and are heard and spoken.</source>
        <translation>Liest eine Zeichnung ohne Augen: Linien ziehen den Stift an und werden hörbar und gesprochen.</translation>
    </message>
    <message>
        <source>Touch a line and follow it: it holds the pen, its ends and crossings click.</source>
        <translation>Berühren Sie eine Linie und folgen Sie ihr: Sie hält den Stift, ihre Enden und Kreuzungen klicken.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>sichtbare</translation>
    </message>
    <message>
        <source>current</source>
        <translation>aktuelle</translation>
    </message>
    <message>
        <source>Reads all visible layers, or only the current one. Alt+Page up and Alt+Page down choose it.</source>
        <translation>Liest alle sichtbaren Ebenen oder nur die aktuelle. Alt+Bild auf und Alt+Bild ab wählen sie.</translation>
    </message>
    <message>
        <source>Sound of the distance</source>
        <translation>Ton des Abstands</translation>
    </message>
    <message>
        <source>A tone says how far the nearest line is: pulses that become faster and higher, and a steady tone on the line.</source>
        <translation>Ein Ton sagt, wie weit die nächste Linie ist: Pulse, die schneller und höher werden, und ein Dauerton auf der Linie.</translation>
    </message>
    <message>
        <source>Force level of the lines. Does not affect the hardness of the surface.</source>
        <translation>Stärke der Kräfte der Linien. Die Härte der Oberfläche bleibt gleich.</translation>
    </message>
    <message>
        <source>Holds the width at steps such as 0.3, 0.5 and 0.7 mm. A force-feedback pen clicks from step to step.</source>
        <translation>Hält die Breite auf Stufen wie 0,3, 0,5 und 0,7 mm. Ein Stift mit Kraftrückmeldung klickt von Stufe zu Stufe.</translation>
    </message>
    <message>
        <source>Press hard for whole lines</source>
        <translation>Fest drücken für ganze Linien</translation>
    </message>
    <message>
        <source>Pressing hard erases the whole line under the ring. A force-feedback pen clicks at this pressure.</source>
        <translation>Festes Drücken löscht die ganze Linie unter dem Ring. Ein Stift mit Kraftrückmeldung klickt bei diesem Druck.</translation>
    </message>
    <message>
        <source>Guard of other lines</source>
        <translation>Andere Linien schützen</translation>
    </message>
    <message>
        <source>Largest force with which lines that the eraser has not touched yet push a force-feedback pen away. Push on to erase them, too.</source>
        <translation>Größte Kraft, mit der Linien, die der Radierer noch nicht berührt hat, einen Stift mit Kraftrückmeldung wegdrücken. Wer weiterdrückt, radiert auch sie.</translation>
    </message>
    <message>
        <source>Widths in steps</source>
        <translation>Breiten in Stufen</translation>
    </message>
    <message>
        <source>A drawing can be read without eyes: lines hold the pen, ends and crossings click, and what is under the pen is spoken.</source>
        <translation>Eine Zeichnung lässt sich ohne Augen lesen: Linien halten den Stift, Enden und Kreuzungen klicken, und was unter dem Stift ist, wird gesprochen.</translation>
    </message>
    <message>
        <source>Felt steps</source>
        <translation>Fühlbare Stufen</translation>
    </message>
    <message>
        <source>Gestures</source>
        <translation>Gesten</translation>
    </message>
    <message>
        <source>Hold the pen at the end of a line and press: the line becomes the shape. Scribble over lines, and you are asked whether to delete them.</source>
        <translation>Am Ende einer Linie stehen bleiben und drücken: Die Linie wird zur Form. Über Linien kritzeln: Feltline fragt, ob sie gelöscht werden sollen.</translation>
    </message>
    <message>
        <source>If your hand shakes, lines can be calm: the shaking is measured once and removed while you draw.</source>
        <translation>Auch wenn die Hand zittert, können Linien ruhig sein: Das Zittern wird einmal gemessen und beim Zeichnen entfernt.</translation>
    </message>
    <message>
        <source>Press the eraser until it clicks, and the whole line goes. The pencil has such steps too: they hold the width of a line.</source>
        <translation>Den Radierer drücken, bis er klickt: Die ganze Linie verschwindet. Auch der Bleistift hat solche Stufen; sie halten die Breite einer Linie.</translation>
    </message>
    <message>
        <source>Around the pen there are eight choices, each in its own direction: a well that attracts the pen, with a ridge to the next one. Lift the pen to choose.</source>
        <translation>Um den Stift liegen acht Möglichkeiten, jede in ihrer eigenen Richtung: eine Mulde, die den Stift anzieht, mit einer Erhebung zur nächsten. Abheben wählt.</translation>
    </message>
    <message>
        <source>Ring of tools</source>
        <translation>Ring der Werkzeuge</translation>
    </message>
    <message>
        <source>A ruler, a compass or a perspective holds the pen gently, and lets go if you mean to leave it. One key makes a line along it exact.</source>
        <translation>Ein Lineal, ein Zirkel oder eine Perspektive hält den Stift sanft und lässt ihn los, wenn man sie verlassen will. Eine Taste macht eine Linie daran exakt.</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>Hilfslinien</translation>
    </message>
    <message>
        <source>Drag away from the touch to draw the lines to it; drag back to undo.</source>
        <translation>Von der Berührung wegziehen, um die Linien zu ihr zu ziehen; zurückziehen macht es rückgängig.</translation>
    </message>
    <message>
        <source>Drag away from the touch to spread the lines around it; drag back to undo.</source>
        <translation>Von der Berührung wegziehen, um die Linien ringsum auseinanderzudrücken; zurückziehen macht es rückgängig.</translation>
    </message>
    <message>
        <source>How far the brush reaches along the line, to each side; the radius of the circle that bulge and pinch change.</source>
        <translation>Wie weit der Pinsel entlang der Linie reicht, zu jeder Seite; der Radius des Kreises, den Wölben und Zusammenziehen verändern.</translation>
    </message>
    <message>
        <source>Pull a stretch of a line (brush), bend one segment (grab), push lines from outside (push), move a line along the pen (sweep), spread all lines around the touch (bulge), or draw them together (pinch).</source>
        <translation>Ein Stück einer Linie ziehen (Pinsel), ein Segment biegen (Greifen), Linien von außen schieben (Schieben), eine Linie am Stift entlangführen (Fegen), alle Linien um die Berührung auseinanderdrücken (Wölben) oder zusammenziehen (Zusammenziehen).</translation>
    </message>
    <message>
        <source>bulge</source>
        <translation>wölben</translation>
    </message>
    <message>
        <source>pinch</source>
        <translation>zusammenziehen</translation>
    </message>
    <message>
        <source>Angle of the hatching</source>
        <translation>Winkel der Schraffur</translation>
    </message>
    <message>
        <source>Arrow heads</source>
        <translation>Pfeilspitzen</translation>
    </message>
    <message>
        <source>Direction of the hatching on the page, clockwise from the x axis.</source>
        <translation>Richtung der Schraffur auf der Seite, im Uhrzeigersinn von der x-Achse.</translation>
    </message>
    <message>
        <source>Distance between the lines of the hatching.</source>
        <translation>Abstand zwischen den Linien der Schraffur.</translation>
    </message>
    <message>
        <source>Gap between dashes or repeats, in widths of the line.</source>
        <translation>Lücke zwischen Strichen oder Wiederholungen, in Breiten der Linie.</translation>
    </message>
    <message>
        <source>Length of a dash</source>
        <translation>Länge eines Strichs</translation>
    </message>
    <message>
        <source>Length of a dash or of one repeat, in widths of the line; 1 makes dots.</source>
        <translation>Länge eines Strichs oder einer Wiederholung, in Breiten der Linie; 1 ergibt Punkte.</translation>
    </message>
    <message>
        <source>Length of an arrow head</source>
        <translation>Länge einer Pfeilspitze</translation>
    </message>
    <message>
        <source>Length of an arrow head, in widths of the line.</source>
        <translation>Länge einer Pfeilspitze, in Breiten der Linie.</translation>
    </message>
    <message>
        <source>Spacing of the hatching</source>
        <translation>Abstand der Schraffur</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>The ends of an open line that have arrow heads.</source>
        <translation>Die Enden einer offenen Linie, die Pfeilspitzen haben.</translation>
    </message>
    <message>
        <source>Thinness</source>
        <translation>Schmalheit</translation>
    </message>
    <message>
        <source>What is drawn in place of a solid line. Repeat and stretch use the shape.</source>
        <translation>Was anstelle einer durchgezogenen Linie gezeichnet wird. Wiederholen und Strecken verwenden die Form.</translation>
    </message>
    <message>
        <source>Width of dashes, rails, shafts and hatching lines, as a share of the width of the line.</source>
        <translation>Breite von Strichen, Schienen, Schäften und Schraffurlinien, als Anteil an der Breite der Linie.</translation>
    </message>
    <message>
        <source>dashes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>double</source>
        <translation>doppelt</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>hatch</source>
        <translation>Schraffur</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>schlicht</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>A motion needs two key drawings: two layers with lines that are not locked.</source>
        <translation>Eine Bewegung braucht zwei Schlüsselzeichnungen: zwei Ebenen mit Linien, die nicht gesperrt sind.</translation>
    </message>
    <message>
        <source>Export animation</source>
        <translation>Animation exportieren</translation>
    </message>
    <message>
        <source>Choose a key drawing that has a next one to correct its matches.</source>
        <translation>Wählen Sie eine Schlüsselzeichnung, auf die eine weitere folgt, um ihre Zuordnungen zu berichtigen.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::AnimationDialog</name>
    <message>
        <source>Numbered PNG files</source>
        <translation>Nummerierte PNG-Dateien</translation>
    </message>
    <message>
        <source>Numbered SVG files</source>
        <translation>Nummerierte SVG-Dateien</translation>
    </message>
    <message>
        <source>One animated SVG</source>
        <translation>Ein bewegtes SVG</translation>
    </message>
    <message>
        <source>Export animation</source>
        <translation>Animation exportieren</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>The longer side of the pictures</source>
        <translation>Die längere Seite der Bilder</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FilmView</name>
    <message>
        <source>Film of the key drawings</source>
        <translation>Film der Schlüsselzeichnungen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MotionPanel</name>
    <message>
        <source>Add &amp;key drawing</source>
        <translation>&amp;Schlüsselzeichnung hinzufügen</translation>
    </message>
    <message>
        <source>Adds a layer for the next key drawing</source>
        <translation>Fügt eine Ebene für die nächste Schlüsselzeichnung hinzu</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>Zwiebel&amp;haut</translation>
    </message>
    <message>
        <source>The key drawings before and after the current one shine through</source>
        <translation>Die Schlüsselzeichnungen vor und nach der aktuellen scheinen durch</translation>
    </message>
    <message>
        <source>&amp;Play the motion</source>
        <translation>Bewegung abs&amp;pielen</translation>
    </message>
    <message>
        <source>Plays the key drawings and the drawings between them; Esc stops</source>
        <translation>Spielt die Schlüsselzeichnungen und die Zeichnungen dazwischen ab; Esc beendet</translation>
    </message>
    <message>
        <source>Export &amp;animation…</source>
        <translation>&amp;Animation exportieren…</translation>
    </message>
    <message>
        <source>Write the key drawings and the drawings between them as files</source>
        <translation>Die Schlüsselzeichnungen und die Zeichnungen dazwischen als Dateien schreiben</translation>
    </message>
    <message>
        <source>Key drawings</source>
        <translation>Schlüsselzeichnungen</translation>
    </message>
    <message>
        <source>Each layer with lines that is not locked is a key drawing, from the bottom up</source>
        <translation>Jede Ebene mit Linien, die nicht gesperrt ist, ist eine Schlüsselzeichnung, von unten nach oben</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Starts slowly</source>
        <translation>Beginnt langsam</translation>
    </message>
    <message>
        <source>Ends slowly</source>
        <translation>Endet langsam</translation>
    </message>
    <message>
        <source>Starts and ends slowly</source>
        <translation>Beginnt und endet langsam</translation>
    </message>
    <message>
        <source>In-&amp;betweens:</source>
        <translation>&amp;Zwischenzeichnungen:</translation>
    </message>
    <message>
        <source>&amp;Hold:</source>
        <translation>&amp;Halten:</translation>
    </message>
    <message>
        <source>&amp;Speed:</source>
        <translation>&amp;Tempo:</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Zeichnung</translation>
    </message>
    <message>
        <source>Onion skin</source>
        <translation>Zwiebelhaut</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Draw the second key drawing on a layer of its own.</source>
        <translation>Zeichne die zweite Schlüsselzeichnung auf einer eigenen Ebene.</translation>
    </message>
    <message>
        <source>%1 frames, %2 s</source>
        <translation>%1 Bilder, %2 s</translation>
    </message>
    <message>
        <source>Same &amp;timing for all key drawings</source>
        <translation>Gleicher &amp;Zeitplan für alle Schlüsselzeichnungen</translation>
    </message>
    <message>
        <source>Gives the in-betweens, hold and speed of this key drawing to all</source>
        <translation>Gibt allen die Zwischenzeichnungen, das Halten und das Tempo dieser Schlüsselzeichnung</translation>
    </message>
    <message>
        <source>Correct &amp;matches</source>
        <translation>Zuordnungen &amp;berichtigen</translation>
    </message>
    <message>
        <source>Shows which line becomes which, and lets you draw from line to line</source>
        <translation>Zeigt, welche Linie zu welcher wird, und lässt Sie von Linie zu Linie ziehen</translation>
    </message>
    <message>
        <source>The number of drawings from this key drawing to the next</source>
        <translation>Die Zahl der Zeichnungen von dieser Schlüsselzeichnung zur nächsten</translation>
    </message>
    <message>
        <source>For how many frames this key drawing is shown</source>
        <translation>Wie viele Bilder lang diese Schlüsselzeichnung gezeigt wird</translation>
    </message>
    <message>
        <source>The speed from this key drawing to the next</source>
        <translation>Das Tempo von dieser Schlüsselzeichnung zur nächsten</translation>
    </message>
    <message>
        <source>Same for all</source>
        <translation>Gleich für alle</translation>
    </message>
    <message>
        <source>Matches</source>
        <translation>Zuordnungen</translation>
    </message>
    <message>
        <source>Another curve</source>
        <translation>Andere Kurve</translation>
    </message>
    <message>
        <source>%1: %2 (empty)</source>
        <translation>%1: %2 (leer)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TimelapseActions</name>
    <message>
        <source>Export &amp;timelapse…</source>
        <translation>&amp;Zeitraffer exportieren…</translation>
    </message>
    <message>
        <source>Make a film of how a drawing was made, from a recording</source>
        <translation>Aus einer Aufnahme einen Film machen, der zeigt, wie eine Zeichnung entstand</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>Aufnahme wählen</translation>
    </message>
    <message>
        <source>Recordings (*.ndjson *.felt)</source>
        <translation>Aufnahmen (*.ndjson *.felt)</translation>
    </message>
    <message>
        <source>Export timelapse</source>
        <translation>Zeitraffer exportieren</translation>
    </message>
    <message>
        <source>Making the film “%1”…</source>
        <translation>Der Film „%1“ wird gemacht…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>“%1” was not exported</source>
        <translation>„%1“ wurde nicht exportiert</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Changed in the recording: %1.</source>
        <translation>In der Aufzeichnung geändert: %1.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TimelapseDialog</name>
    <message>
        <source>GIF (repeats, 256 colours)</source>
        <translation>GIF (läuft immer wieder, 256 Farben)</translation>
    </message>
    <message>
        <source>Animated SVG (for web pages)</source>
        <translation>Bewegtes SVG (für Webseiten)</translation>
    </message>
    <message>
        <source>WebM film (VP9)</source>
        <translation>WebM-Film (VP9)</translation>
    </message>
    <message>
        <source>This window, which is being recorded</source>
        <translation>Dieses Fenster, das aufgenommen wird</translation>
    </message>
    <message>
        <source>The recording in this drawing</source>
        <translation>Die Aufnahme in dieser Zeichnung</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>Eine Datei</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>&amp;Grain of the surface in dry media</source>
        <translation>&amp;Körnung des Untergrunds in trockenen Zeichenmitteln</translation>
    </message>
    <message>
        <source>Export timelapse</source>
        <translation>Zeitraffer exportieren</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Automatic: 30 s, or less if the drawing took less time</source>
        <translation>Automatisch: 30 s, oder weniger, wenn das Zeichnen weniger Zeit brauchte</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>The longer side of the film</source>
        <translation>Die längere Seite des Films</translation>
    </message>
    <message>
        <source>&amp;Recording:</source>
        <translation>&amp;Aufnahme:</translation>
    </message>
    <message>
        <source>File:</source>
        <translation>Datei:</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>&amp;Length:</source>
        <translation>&amp;Länge:</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Datei der Aufnahme</translation>
    </message>
    <message>
        <source>A script (.ndjson) or a drawing (.felt)</source>
        <translation>Ein Skript (.ndjson) oder eine Zeichnung (.felt)</translation>
    </message>
    <message>
        <source>This format needs the program ffmpeg, which is not installed. Install the package “ffmpeg”, or export an animated SVG.</source>
        <translation>Dieses Format braucht das Programm ffmpeg, das nicht installiert ist. Installiere das Paket „ffmpeg“, oder exportiere ein bewegtes SVG.</translation>
    </message>
    <message>
        <source>A recording is made by “feltline-desktop --record FILE.ndjson” or “feltline replay --recording”.</source>
        <translation>Eine Aufnahme machen „feltline-desktop --record DATEI.ndjson“ und „feltline replay --recording“.</translation>
    </message>
</context>
</TS>
