<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl_NL" sourcelanguage="en">
<context>
    <name>felt::desktop::ExampleButton</name>
    <message>
        <source>Show the sample cat</source>
        <translation>Voorbeeldkat tonen</translation>
    </message>
    <message>
        <source>Opens a drawing to pull, erase and colour</source>
        <translation>Opent een tekening om te trekken, te gummen en te kleuren</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MatchView</name>
    <message>
        <source>Matches of two key drawings</source>
        <translation>Koppelingen van twee sleuteltekeningen</translation>
    </message>
    <message>
        <source>Drag from a line to the line that it becomes in the next key drawing. Click a line without a partner. Esc ends.</source>
        <translation>Sleep van een lijn naar de lijn die zij in de volgende sleuteltekening wordt. Klik op een lijn zonder tegenhanger. Esc stopt.</translation>
    </message>
</context>
<context>
    <name>AddedStrokes</name>
    <message>
        <source>“%1” differs here: the added strokes look as it does in this drawing</source>
        <translation>‘%1’ is hier anders gedefinieerd: de toegevoegde lijnen zien eruit zoals in deze tekening</translation>
    </message>
    <message>
        <source>Pictures of this file were not added: %1. Open the file to see them.</source>
        <translation>Niet toegevoegde afbeeldingen van dit bestand: %1. Open het bestand om ze te zien.</translation>
    </message>
    <message>
        <source>Lines of hidden layers that were not added: %1. Open the file to see them.</source>
        <translation>Niet toegevoegde lijnen van verborgen lagen: %1. Open het bestand om ze te zien.</translation>
    </message>
    <message>
        <source>Layers whose lines were added to the current layer, without the name of their own: %1</source>
        <translation>Lagen waarvan de lijnen zonder de naam van de laag aan de huidige laag zijn toegevoegd: %1</translation>
    </message>
    <message>
        <source>Opacities and blend modes of layers that were left out: %1</source>
        <translation>Weggelaten dekkingen en mengmodi van lagen: %1</translation>
    </message>
    <message>
        <source>Guides, symmetry groups, timings and edits of the body that were not added: %1. Open the file to see them.</source>
        <translation>Niet toegevoegde hulplijnen, symmetriegroepen, timings en bewerkingen van het lichaam: %1. Open het bestand om ze te zien.</translation>
    </message>
    <message>
        <source>Names of lines that were left out, because lines of this drawing have them: %1</source>
        <translation>Weggelaten namen van lijnen, omdat lijnen van deze tekening ze al hebben: %1</translation>
    </message>
</context>
<context>
    <name>Arguments</name>
    <message>
        <source>Open a separate window with an empty drawing.</source>
        <translation>Een apart venster met een lege tekening openen.</translation>
    </message>
    <message>
        <source>Use this UI language (en, de, nl) instead of the system&apos;s.</source>
        <translation>Deze taal (en, de, nl) gebruiken in plaats van de systeemtaal.</translation>
    </message>
    <message>
        <source>Record everything that happens to the drawing, for feltline replay --as-recorded.</source>
        <translation>Alles opnemen wat er met de tekening gebeurt, voor feltline replay --as-recorded.</translation>
    </message>
    <message>
        <source>Feltline: draw, and feel what you draw.</source>
        <translation>Feltline: teken, en voel wat je tekent.</translation>
    </message>
    <message>
        <source>Drawings to open: .felt, .svg, .ndjson.</source>
        <translation>Tekeningen om te openen: .felt, .svg, .ndjson.</translation>
    </message>
    <message>
        <source>--size must be WIDTHxHEIGHT, each from 100 to 8000</source>
        <translation>--size moet BREEDTExHOOGTE zijn, elk van 100 tot 8000</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Voorbeelden:</translation>
    </message>
    <message>
        <source>Run a session of a study with a participant, on the whole screen.</source>
        <translation>Een sessie van een onderzoek met een deelnemer uitvoeren, op het hele scherm.</translation>
    </message>
    <message>
        <source>The folder for the results of --trial (also -o).</source>
        <translation>De map voor de resultaten van --trial (ook -o).</translation>
    </message>
    <message>
        <source>The number of the participant, from 1 to 9999.</source>
        <translation>Het nummer van de deelnemer, van 1 tot 9999.</translation>
    </message>
    <message>
        <source>The session: pre, train (if not given), post, retention or transfer.</source>
        <translation>De sessie: pre, train (zonder opgave), post, retention of transfer.</translation>
    </message>
    <message>
        <source>--%1 needs --trial</source>
        <translation>--%1 vereist --trial</translation>
    </message>
    <message>
        <source>--trial needs a study, -o FOLDER and --participant NUMBER (from 1)</source>
        <translation>--trial vereist een onderzoek, -o FOLDER en --participant NUMBER (vanaf 1)</translation>
    </message>
    <message>
        <source>--trial opens no drawings</source>
        <translation>--trial opent geen tekeningen</translation>
    </message>
    <message>
        <source>--screenshot shows one drawing only</source>
        <translation>--screenshot toont maar één tekening</translation>
    </message>
</context>
<context>
    <name>ButtonRole</name>
    <message>
        <source>Nothing</source>
        <translation>Niets</translation>
    </message>
    <message>
        <source>Erase while held</source>
        <translation>Gummen zolang ingedrukt</translation>
    </message>
    <message>
        <source>Pull while held</source>
        <translation>Trekken zolang ingedrukt</translation>
    </message>
    <message>
        <source>Select while held</source>
        <translation>Selecteren zolang ingedrukt</translation>
    </message>
    <message>
        <source>Move the view while held</source>
        <translation>Beeld verschuiven zolang ingedrukt</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>The tool&apos;s first modifier (Shift)</source>
        <translation>Eerste modificatietoets van het gereedschap (Shift)</translation>
    </message>
    <message>
        <source>The tool&apos;s second modifier (Ctrl)</source>
        <translation>Tweede modificatietoets van het gereedschap (Ctrl)</translation>
    </message>
    <message>
        <source>Open the palette at the pointer</source>
        <translation>Palet bij de aanwijzer openen</translation>
    </message>
    <message>
        <source>Open the ring of tools; release to choose</source>
        <translation>Ring met gereedschappen openen; loslaten kiest</translation>
    </message>
</context>
<context>
    <name>CanvasPopup</name>
    <message>
        <source>Palette at the p&amp;ointer</source>
        <translation>Palet bij de &amp;aanwijzer</translation>
    </message>
    <message>
        <source>Shows tools, media, colours and commands beside the pen.</source>
        <translation>Toont gereedschappen, tekenmiddelen, kleuren en opdrachten naast de pen.</translation>
    </message>
</context>
<context>
    <name>ColorActions</name>
    <message>
        <source>&amp;Open a palette…</source>
        <translation>Palet &amp;openen…</translation>
    </message>
    <message>
        <source>Reads colours from a .gpl file.</source>
        <translation>Leest kleuren uit een .gpl-bestand.</translation>
    </message>
    <message>
        <source>&amp;Export the palette…</source>
        <translation>Palet &amp;exporteren…</translation>
    </message>
    <message>
        <source>Writes the palette that is shown.</source>
        <translation>Schrijft het getoonde palet naar een bestand.</translation>
    </message>
    <message>
        <source>&amp;Keep the colour</source>
        <translation>Kleur be&amp;waren</translation>
    </message>
    <message>
        <source>Adds the current colour to your own palette.</source>
        <translation>Voegt de huidige kleur toe aan je eigen palet.</translation>
    </message>
    <message>
        <source>&amp;Remove the colour</source>
        <translation>Kleur &amp;verwijderen</translation>
    </message>
    <message>
        <source>Removes the current colour from your own palette.</source>
        <translation>Verwijdert de huidige kleur uit je eigen palet.</translation>
    </message>
</context>
<context>
    <name>DeviceWords</name>
    <message>
        <source>the device is no longer connected</source>
        <translation>het apparaat is niet meer verbonden</translation>
    </message>
    <message>
        <source>the device does not know the position of its arm</source>
        <translation>het apparaat kent de positie van zijn arm niet</translation>
    </message>
    <message>
        <source>the device has switched its forces off</source>
        <translation>het apparaat heeft zijn krachten uitgeschakeld</translation>
    </message>
    <message>
        <source>its motors are too warm</source>
        <translation>de motoren zijn te warm</translation>
    </message>
    <message>
        <source>the device reports impossible values</source>
        <translation>het apparaat meldt onmogelijke waarden</translation>
    </message>
    <message>
        <source>the device reports a fault</source>
        <translation>het apparaat meldt een fout</translation>
    </message>
    <message>
        <source>%1 is no longer connected.</source>
        <translation>%1 is niet meer verbonden.</translation>
    </message>
    <message>
        <source>Nothing is lost. Check its cable and power; you can continue with mouse or tablet.</source>
        <translation>Er is niets verloren. Controleer de kabel en de voeding; je kunt met muis of tablet verder tekenen.</translation>
    </message>
    <message>
        <source>%1 does not know the position of its arm.</source>
        <translation>%1 kent de positie van zijn arm niet.</translation>
    </message>
    <message>
        <source>Until it has found its home position, continue with mouse or tablet.</source>
        <translation>Teken met muis of tablet verder tot het zijn uitgangspositie heeft gevonden.</translation>
    </message>
    <message>
        <source>%1 has switched its forces off.</source>
        <translation>%1 heeft zijn krachten uitgeschakeld.</translation>
    </message>
    <message>
        <source>Its switch or its own protection did this. Continue without forces, or switch them on at the device and then here.</source>
        <translation>De schakelaar of de eigen beveiliging van het apparaat deed dit. Teken verder zonder krachten, of schakel ze eerst op het apparaat en dan hier weer in.</translation>
    </message>
    <message>
        <source>The motors of %1 are too warm.</source>
        <translation>De motoren van %1 zijn te warm.</translation>
    </message>
    <message>
        <source>Continue without forces. You can switch them on again in a few minutes.</source>
        <translation>Teken verder zonder krachten. Over enkele minuten kun je ze weer inschakelen.</translation>
    </message>
    <message>
        <source>%1 reports impossible values.</source>
        <translation>%1 meldt onmogelijke waarden.</translation>
    </message>
    <message>
        <source>%1 reports a fault.</source>
        <translation>%1 meldt een fout.</translation>
    </message>
    <message>
        <source>Continue without forces.</source>
        <translation>Teken verder zonder krachten.</translation>
    </message>
    <message>
        <source>Continue with mouse or tablet. Check the cable, switch the device off and on, and try again.</source>
        <translation>Teken verder met muis of tablet. Controleer de kabel, zet het apparaat uit en weer aan en probeer het opnieuw.</translation>
    </message>
</context>
<context>
    <name>EditActions</name>
    <message>
        <source>Make e&amp;xact</source>
        <translation>E&amp;xact maken</translation>
    </message>
    <message>
        <source>Replaces the line that was drawn along a guide by the exact curve.</source>
        <translation>Vervangt de lijn die langs een hulplijn is getekend door de exacte kromme.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ongedaan maken</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Op&amp;nieuw</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles selecteren</translation>
    </message>
    <message>
        <source>&amp;Invert selection</source>
        <translation>Selectie om&amp;keren</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Ongedaan maken: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>Op&amp;nieuw: %1</translation>
    </message>
    <message>
        <source>Undoes the last step.</source>
        <translation>Maakt de laatste stap ongedaan.</translation>
    </message>
    <message>
        <source>Redoes the step that was undone.</source>
        <translation>Voert de ongedaan gemaakte stap opnieuw uit.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Verwijderen</translation>
    </message>
    <message>
        <source>Removes the selected lines.</source>
        <translation>Verwijdert de geselecteerde lijnen.</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliceren</translation>
    </message>
    <message>
        <source>Copies the selected lines, slightly offset.</source>
        <translation>Kopieert de geselecteerde lijnen, iets verschoven.</translation>
    </message>
    <message>
        <source>Selects all lines of visible, unlocked layers.</source>
        <translation>Selecteert alle lijnen op zichtbare, niet vergrendelde lagen.</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>&amp;Niets selecteren</translation>
    </message>
    <message>
        <source>Clears the selection.</source>
        <translation>Heft de selectie op.</translation>
    </message>
    <message>
        <source>Selects all lines that are not selected now.</source>
        <translation>Selecteert alle lijnen die nu niet geselecteerd zijn.</translation>
    </message>
    <message>
        <source>&amp;Cancel or clear selection</source>
        <translation>&amp;Annuleren of selectie opheffen</translation>
    </message>
    <message>
        <source>Cancels the current gesture, or clears the selection.</source>
        <translation>Breekt de huidige handeling af, of heft de selectie op.</translation>
    </message>
    <message>
        <source>&amp;Broader lines</source>
        <translation>&amp;Bredere lijnen</translation>
    </message>
    <message>
        <source>Makes the selected lines broader by a quarter.</source>
        <translation>Maakt de geselecteerde lijnen een kwart breder.</translation>
    </message>
    <message>
        <source>T&amp;hinner lines</source>
        <translation>&amp;Dunnere lijnen</translation>
    </message>
    <message>
        <source>Makes the selected lines thinner by a fifth.</source>
        <translation>Maakt de geselecteerde lijnen een vijfde dunner.</translation>
    </message>
    <message>
        <source>Bring to &amp;front</source>
        <translation>Naar &amp;voren halen</translation>
    </message>
    <message>
        <source>Puts the selected lines above all others of their layer.</source>
        <translation>Legt de geselecteerde lijnen boven alle andere van hun laag.</translation>
    </message>
    <message>
        <source>Send to bac&amp;k</source>
        <translation>Naar a&amp;chteren sturen</translation>
    </message>
    <message>
        <source>Puts the selected lines below all others of their layer.</source>
        <translation>Legt de geselecteerde lijnen onder alle andere van hun laag.</translation>
    </message>
    <message>
        <source>Line as dra&amp;wn</source>
        <translation>Lijn als ge&amp;tekend</translation>
    </message>
    <message>
        <source>Replaces the line of the steady hand by the line as it was drawn.</source>
        <translation>Vervangt de lijn van de vaste hand door de lijn zoals die getekend is.</translation>
    </message>
</context>
<context>
    <name>ErrorWords</name>
    <message>
        <source>The file or folder does not exist.</source>
        <translation>Het bestand of de map bestaat niet.</translation>
    </message>
    <message>
        <source>The file cannot be read or written. It may be protected, or the disk may be full.</source>
        <translation>Het bestand kan niet worden gelezen of geschreven. Misschien is het beveiligd of is de schijf vol.</translation>
    </message>
    <message>
        <source>Feltline cannot read this kind of file.</source>
        <translation>Feltline kan dit bestandstype niet lezen.</translation>
    </message>
    <message>
        <source>The file is damaged, or is not a drawing that Feltline can read.</source>
        <translation>Het bestand is beschadigd, of geen tekening die Feltline kan lezen.</translation>
    </message>
    <message>
        <source>The drawing is too large for Feltline.</source>
        <translation>De tekening is te groot voor Feltline.</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>A cat</source>
        <translation>Een kat</translation>
    </message>
    <message>
        <source>Handwriting</source>
        <translation>Handschrift</translation>
    </message>
    <message>
        <source>A page of exercises</source>
        <translation>Een pagina oefeningen</translation>
    </message>
    <message>
        <source>Doodles</source>
        <translation>Krabbels</translation>
    </message>
</context>
<context>
    <name>FeelActions</name>
    <message>
        <source>M&amp;y surfaces</source>
        <translation>&amp;Eigen ondergronden</translation>
    </message>
    <message>
        <source>Surfaces that you made or that came with a drawing</source>
        <translation>Ondergronden die je hebt gemaakt of die met een tekening meekwamen</translation>
    </message>
    <message>
        <source>Stops all forces immediately</source>
        <translation>Stopt alle krachten onmiddellijk</translation>
    </message>
    <message>
        <source>&amp;Stronger forces</source>
        <translation>&amp;Sterkere krachten</translation>
    </message>
    <message>
        <source>All forces 10 % stronger</source>
        <translation>Alle krachten 10% sterker</translation>
    </message>
    <message>
        <source>&amp;Weaker forces</source>
        <translation>&amp;Zwakkere krachten</translation>
    </message>
    <message>
        <source>All forces 10 % weaker</source>
        <translation>Alle krachten 10% zwakker</translation>
    </message>
    <message>
        <source>Forces are off. Switch them on in the Feel panel.</source>
        <translation>De krachten zijn uit. Schakel ze weer in op het paneel Gevoel.</translation>
    </message>
    <message>
        <source>Hear the pen rub on the surface</source>
        <translation>De pen over de ondergrond horen wrijven</translation>
    </message>
    <message>
        <source>Stops all forces, or switches them on</source>
        <translation>Stopt alle krachten, of schakelt ze in</translation>
    </message>
    <message>
        <source>Stop &amp;forces</source>
        <translation>Krachten &amp;stoppen</translation>
    </message>
    <message>
        <source>Switch &amp;forces on</source>
        <translation>Krachten &amp;inschakelen</translation>
    </message>
    <message>
        <source>Stop forces, &amp;never start (Esc twice)</source>
        <translation>Krachten stoppen, &amp;nooit inschakelen (tweemaal Esc)</translation>
    </message>
    <message>
        <source>S&amp;ound of drawing</source>
        <translation>&amp;Geluid bij het tekenen</translation>
    </message>
    <message>
        <source>&amp;Edge of the page as a ridge</source>
        <translation>&amp;Rand van de pagina als richel</translation>
    </message>
    <message>
        <source>Feel where the page ends, while the pen touches</source>
        <translation>Voelen waar de pagina eindigt, terwijl de pen het oppervlak raakt</translation>
    </message>
    <message>
        <source>Box of the se&amp;lection as a ridge</source>
        <translation>&amp;Kader van de selectie als richel</translation>
    </message>
    <message>
        <source>Feel where the box around the selected lines ends</source>
        <translation>Voelen waar het kader rond de geselecteerde lijnen eindigt</translation>
    </message>
    <message>
        <source>Lines of locked &amp;pictures as grooves</source>
        <translation>Lijnen van vergrendelde af&amp;beeldingen als groeven</translation>
    </message>
    <message>
        <source>Feel the lines and edges of a picture in a locked layer, while you draw slowly along them</source>
        <translation>Voel de lijnen en randen van een afbeelding in een vergrendelde laag, terwijl u er langzaam langs tekent</translation>
    </message>
</context>
<context>
    <name>FirstMinute</name>
    <message>
        <source>Draw with the pen or the mouse.</source>
        <translation>Teken met de pen of de muis.</translation>
    </message>
    <message>
        <source>To correct a line, press %1 and pull it into shape.</source>
        <translation>Druk op %1 en trek een lijn in vorm om die te corrigeren.</translation>
    </message>
    <message>
        <source>%1 undoes a step. The Help menu has a two-minute tour.</source>
        <translation>%1 maakt een stap ongedaan. In het menu Help staat een rondleiding van twee minuten.</translation>
    </message>
</context>
<context>
    <name>GuideActions</name>
    <message>
        <source>&amp;Ruler</source>
        <translation>Lin&amp;iaal</translation>
    </message>
    <message>
        <source>Adds a straight edge with millimetres.</source>
        <translation>Voegt een rechte rand met millimeters toe.</translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation>&amp;Lijn</translation>
    </message>
    <message>
        <source>Adds a straight line across the page.</source>
        <translation>Voegt een rechte lijn over de hele pagina toe.</translation>
    </message>
    <message>
        <source>&amp;Parallels</source>
        <translation>&amp;Parallellen</translation>
    </message>
    <message>
        <source>Adds all lines of one direction.</source>
        <translation>Voegt alle lijnen van één richting toe.</translation>
    </message>
    <message>
        <source>&amp;Set square</source>
        <translation>&amp;Geodriehoek</translation>
    </message>
    <message>
        <source>Adds a right angle with millimetres.</source>
        <translation>Voegt een rechte hoek met millimeters toe.</translation>
    </message>
    <message>
        <source>Pr&amp;otractor</source>
        <translation>Grad&amp;enboog</translation>
    </message>
    <message>
        <source>Adds rays in steps of 15 degrees.</source>
        <translation>Voegt stralen in stappen van 15 graden toe.</translation>
    </message>
    <message>
        <source>&amp;Compass</source>
        <translation>&amp;Passer</translation>
    </message>
    <message>
        <source>Adds the centre of circles.</source>
        <translation>Voegt het middelpunt van cirkels toe.</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellips</translation>
    </message>
    <message>
        <source>Adds one ellipse.</source>
        <translation>Voegt één ellips toe.</translation>
    </message>
    <message>
        <source>Co&amp;ncentric ellipses</source>
        <translation>Co&amp;ncentrische ellipsen</translation>
    </message>
    <message>
        <source>Adds ellipses around one centre.</source>
        <translation>Voegt ellipsen rond één middelpunt toe.</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Perspectie&amp;f</translation>
    </message>
    <message>
        <source>Adds two vanishing points.</source>
        <translation>Voegt twee verdwijnpunten toe.</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Adds a grid of squares.</source>
        <translation>Voegt een raster van vierkanten toe.</translation>
    </message>
    <message>
        <source>&amp;Isometric grid</source>
        <translation>&amp;Isometrisch raster</translation>
    </message>
    <message>
        <source>Adds a grid of triangles.</source>
        <translation>Voegt een raster van driehoeken toe.</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>S&amp;ymmetrie</translation>
    </message>
    <message>
        <source>Adds a mirror axis. New lines get mirror images.</source>
        <translation>Voegt een spiegelas toe. Nieuwe lijnen krijgen spiegelbeelden.</translation>
    </message>
    <message>
        <source>&amp;Trace of selected lines</source>
        <translation>&amp;Spoor van geselecteerde lijnen</translation>
    </message>
    <message>
        <source>Makes each selected line a guide.</source>
        <translation>Maakt van elke geselecteerde lijn een hulplijn.</translation>
    </message>
    <message>
        <source>&amp;Show guides</source>
        <translation>&amp;Hulplijnen tonen</translation>
    </message>
    <message>
        <source>Shows or hides the guides. Hidden guides have no effect.</source>
        <translation>Toont of verbergt de hulplijnen. Verborgen hulplijnen doen niets.</translation>
    </message>
    <message>
        <source>&amp;Unlink mirrored lines</source>
        <translation>Gespiegelde lijnen &amp;losmaken</translation>
    </message>
    <message>
        <source>The selected lines no longer follow their mirror images.</source>
        <translation>De geselecteerde lijnen volgen hun spiegelbeelden niet meer.</translation>
    </message>
    <message>
        <source>Remove &amp;all guides</source>
        <translation>&amp;Alle hulplijnen verwijderen</translation>
    </message>
    <message>
        <source>Removes the guides. Lines stay.</source>
        <translation>Verwijdert de hulplijnen. Lijnen blijven.</translation>
    </message>
</context>
<context>
    <name>ImportWords</name>
    <message>
        <source>has times that are not milliseconds: they stand still, run backwards or hardly advance; they were ignored</source>
        <translation>heeft tijden die geen milliseconden zijn en is zonder tijden gelezen</translation>
    </message>
    <message>
        <source>has pressures outside 0 to 1, which count as 0 or 1; divide them by the largest pressure of the pen</source>
        <translation>heeft drukwaarden buiten 0 tot 1, die als 0 of 1 tellen; deel ze door de grootste druk van de pen</translation>
    </message>
    <message>
        <source>has invalid tones (one number from 0 to 1 per width is needed); the tones of its widths were used</source>
        <translation>heeft ongeldige tonen; die van de breedtes zijn gebruikt</translation>
    </message>
    <message>
        <source>has rounded coordinates; smooth joints were moved by less than 0.001 mm or became corners</source>
        <translation>heeft afgeronde coördinaten; vloeiende plekken zijn minder dan 0,001 mm verschoven of hoeken geworden</translation>
    </message>
    <message>
        <source>is transparent inside a transparent group; the transparency was applied to each stroke</source>
        <translation>is doorschijnend in een doorschijnende groep; elke lijn is doorschijnend geworden</translation>
    </message>
    <message>
        <source>has widths that are not positive numbers (%1); those of the pieces beside them were used</source>
        <translation>heeft breedtes die geen positieve getallen zijn (%1); die van de stukken ernaast zijn gebruikt</translation>
    </message>
    <message>
        <source>has invalid tones (one number from 0 to 1 per width is needed); its points were read</source>
        <translation>heeft ongeldige tonen; de punten zijn gelezen</translation>
    </message>
    <message>
        <source>has a line that another program changed; its widths were stretched over the line</source>
        <translation>heeft een lijn die een ander programma heeft gewijzigd; de breedtes zijn erover verdeeld</translation>
    </message>
    <message>
        <source>has more points than a stroke can have (%1); it was split into several strokes</source>
        <translation>heeft meer punten dan een lijn kan hebben (%1) en is in meerdere lijnen gesplitst</translation>
    </message>
    <message>
        <source>has a different colour from the first page; the first page&apos;s colour was used</source>
        <translation>heeft een andere kleur dan de eerste pagina; die van de eerste pagina is gebruikt</translation>
    </message>
    <message>
        <source>contains something that is not a number; only the points before it were read</source>
        <translation>bevat iets dat geen getal is; alleen de punten ervoor zijn gelezen</translation>
    </message>
    <message>
        <source>has a blend mode, which was ignored: the file has more than 200 such groups</source>
        <translation>heeft een mengmodus, die is genegeerd: het bestand heeft meer dan 200 zulke groepen</translation>
    </message>
    <message>
        <source>was read without some of its styles, because the style sheet is too complex</source>
        <translation>is zonder een deel van de stijlen gelezen, omdat het stylesheet te ingewikkeld is</translation>
    </message>
    <message>
        <source>was changed by another program: its points were read, not the stored curve</source>
        <translation>is door een ander programma gewijzigd: de punten zijn gelezen, niet de opgeslagen kromme</translation>
    </message>
    <message>
        <source>is transparent and has several parts; it became darker at their crossings</source>
        <translation>is doorschijnend en heeft meerdere delen; waar ze kruisen is het donkerder geworden</translation>
    </message>
    <message>
        <source>is in a transparent group; the transparency was applied to each stroke</source>
        <translation>zit in een doorschijnende groep; elke lijn is doorschijnend geworden</translation>
    </message>
    <message>
        <source>is larger than a page can be (5000 mm); the rest lies outside the page</source>
        <translation>is groter dan een pagina kan zijn (5000 mm); de rest ligt buiten de pagina</translation>
    </message>
    <message>
        <source>has parts shorter than 0.05 mm, which were joined to their neighbours</source>
        <translation>heeft delen korter dan 0,05 mm, die met hun buren zijn verbonden</translation>
    </message>
    <message>
        <source>has a newer version than Feltline supports; the known parts were read</source>
        <translation>heeft een nieuwere versie dan Feltline kent; de bekende delen zijn gelezen</translation>
    </message>
    <message>
        <source>has a line that is stretched in one direction; its width was sampled</source>
        <translation>heeft een lijn die in één richting is uitgerekt; de breedte is benaderd</translation>
    </message>
    <message>
        <source>was stretched in one direction; its widths were scaled by the mean</source>
        <translation>is in één richting uitgerekt; de breedtes zijn gemiddeld geschaald</translation>
    </message>
    <message>
        <source>ends before the file does; the documents after it (%1) were skipped</source>
        <translation>eindigt eerder dan het bestand; wat erna komt (documenten: %1) is overgeslagen</translation>
    </message>
    <message>
        <source>is painted with a gradient; the mean colour of its stops was used</source>
        <translation>heeft een kleurverloop; de gemiddelde kleur ervan is gebruikt</translation>
    </message>
    <message>
        <source>extends beyond the frame that shows it; its lines end about there</source>
        <translation>steekt buiten het kader dat het toont; de lijnen eindigen daar ongeveer</translation>
    </message>
    <message>
        <source>has more than 250000 segments and was split into several strokes</source>
        <translation>heeft meer dan 250000 segmenten en is in meerdere lijnen gesplitst</translation>
    </message>
    <message>
        <source>has more than 10000 layers; the others were merged into the last</source>
        <translation>heeft meer dan 10000 lagen; de overige zijn met de laatste samengevoegd</translation>
    </message>
    <message>
        <source>has a smooth joint that another program bent; it became a corner</source>
        <translation>heeft een vloeiende plek die een ander programma heeft geknikt; het is een hoek geworden</translation>
    </message>
    <message>
        <source>was skipped: a drawing has at most 200 pictures and 10000 layers</source>
        <translation>is overgeslagen: een tekening heeft hoogstens 200 afbeeldingen en 10000 lagen</translation>
    </message>
    <message>
        <source>extends beyond the frame that shows it, and is shown as a whole</source>
        <translation>steekt buiten het kader dat het toont en wordt helemaal getoond</translation>
    </message>
    <message>
        <source>crosses itself; parts that it covers twice may lack their fill</source>
        <translation>kruist zichzelf; delen die dubbel bedekt zijn, kunnen hun vulling missen</translation>
    </message>
    <message>
        <source>was skipped: it is in another file, &apos;%1&apos;, which is not opened</source>
        <translation>is overgeslagen: het staat in een ander bestand, ‘%1’, dat niet wordt geopend</translation>
    </message>
    <message>
        <source>refers to a style sheet in another file, which was not read</source>
        <translation>verwijst naar een stylesheet in een ander bestand, dat niet is gelezen</translation>
    </message>
    <message>
        <source>is clipped to too many rotated frames; this one was ignored</source>
        <translation>is door te veel gedraaide kaders bijgesneden; dit is genegeerd</translation>
    </message>
    <message>
        <source>has a centre line of several parts; only the first was read</source>
        <translation>heeft een middenlijn van meerdere delen; alleen het eerste is gelezen</translation>
    </message>
    <message>
        <source>has ends or corners too close together, which became round</source>
        <translation>heeft uiteinden of hoeken die te dicht bij elkaar liggen en rond zijn geworden</translation>
    </message>
    <message>
        <source>has no known widths of its pieces; a single width was used</source>
        <translation>heeft geen bekende breedtes van zijn stukken; één breedte is gebruikt</translation>
    </message>
    <message>
        <source>has no supported mapping; its coordinates were not changed</source>
        <translation>heeft geen afbeelding die Feltline kent; de coördinaten zijn niet gewijzigd</translation>
    </message>
    <message>
        <source>has a blend mode that is not supported, which was ignored</source>
        <translation>heeft een mengmodus die niet wordt ondersteund en is genegeerd</translation>
    </message>
    <message>
        <source>%1 rules of style sheets are not supported and were ignored</source>
        <translation>%1 regels van stylesheets worden niet ondersteund en zijn genegeerd</translation>
    </message>
    <message>
        <source>covers lines of its transparent group, which show through</source>
        <translation>bedekt lijnen van de doorschijnende groep, die nu doorschijnen</translation>
    </message>
    <message>
        <source>has flat dashes shorter than its width, which became dots</source>
        <translation>heeft rechte streepjes die korter zijn dan breed en punten zijn geworden</translation>
    </message>
    <message>
        <source>was skipped: the element it refers to is not in the file</source>
        <translation>is overgeslagen: waar het naar verwijst, staat niet in het bestand</translation>
    </message>
    <message>
        <source>has neither a line nor a fill that shows and was skipped</source>
        <translation>heeft geen zichtbare lijn en geen zichtbare vulling en is overgeslagen</translation>
    </message>
    <message>
        <source>lost its variable width (%1); its outline was used instead</source>
        <translation>heeft zijn wisselende breedte verloren; in plaats daarvan is de omtrek gebruikt</translation>
    </message>
    <message>
        <source>has widths interpolated by the rule %1, which were sampled</source>
        <translation>heeft breedtes volgens de regel %1, die zijn benaderd</translation>
    </message>
    <message>
        <source>has a name of more than 4096 bytes; its points were read</source>
        <translation>heeft een te lange naam; de punten zijn gelezen</translation>
    </message>
    <message>
        <source>has a width or height of 0, so nothing of it is visible</source>
        <translation>heeft breedte of hoogte 0, dus er is niets van te zien</translation>
    </message>
    <message>
        <source>does not define its largest pressure; 32767 was assumed</source>
        <translation>noemt zijn grootste druk niet; 32767 is aangenomen</translation>
    </message>
    <message>
        <source>has an invalid or too long material, which was skipped</source>
        <translation>heeft een ongeldig of te lang materiaal, dat is overgeslagen</translation>
    </message>
    <message>
        <source>has a fill that was put below the lines that it covers</source>
        <translation>heeft een vulling die onder de lijnen is gelegd die ze bedekt</translation>
    </message>
    <message>
        <source>has dashes that merge, because their ends became round</source>
        <translation>heeft streepjes die samenlopen, omdat de uiteinden rond zijn geworden</translation>
    </message>
    <message>
        <source>was skipped: it is in another file, which is not read</source>
        <translation>is overgeslagen: het staat in een ander bestand, dat niet wordt gelezen</translation>
    </message>
    <message>
        <source>has a name of more than 4096 bytes, which was skipped</source>
        <translation>heeft een te lange naam, die is overgeslagen</translation>
    </message>
    <message>
        <source>of the white-out eraser was read as ink of its colour</source>
        <translation>van de correctiepen is als lijn in die kleur gelezen</translation>
    </message>
    <message>
        <source>is a broad nib; its longer side was used as the width</source>
        <translation>is een brede pen; de langste zijde is de breedte geworden</translation>
    </message>
    <message>
        <source>was skipped: too many elements are repeated by &apos;use&apos;</source>
        <translation>is overgeslagen: ‘use’ herhaalt te veel elementen</translation>
    </message>
    <message>
        <source>was made with the pen off the paper and was skipped</source>
        <translation>is gemaakt met de pen los van het papier en is overgeslagen</translation>
    </message>
    <message>
        <source>is painted with a pattern; a single colour was used</source>
        <translation>heeft een patroon; één kleur is gebruikt</translation>
    </message>
    <message>
        <source>refers to &apos;%1&apos; in another document, which is not read</source>
        <translation>verwijst naar ‘%1’ in een ander document, dat niet wordt gelezen</translation>
    </message>
    <message>
        <source>does not have a matrix of two rows of three numbers</source>
        <translation>heeft geen matrix van twee rijen met drie getallen</translation>
    </message>
    <message>
        <source>lost the references to the strokes around its fill</source>
        <translation>heeft de verbinding met de lijnen rond de vulling verloren</translation>
    </message>
    <message>
        <source>is outside the frame that shows it and was skipped</source>
        <translation>ligt buiten het kader dat het toont en is overgeslagen</translation>
    </message>
    <message>
        <source>has a width or height of 0 or less and was skipped</source>
        <translation>heeft geen breedte of hoogte en is overgeslagen</translation>
    </message>
    <message>
        <source>has no extent after its transform and was skipped</source>
        <translation>heeft na zijn transformatie geen omvang en is overgeslagen</translation>
    </message>
    <message>
        <source>paints its line below its fill, which was ignored</source>
        <translation>schildert de lijn onder de vulling, wat is genegeerd</translation>
    </message>
    <message>
        <source>says %1, but the content is a %2 and was read as such</source>
        <translation>zegt %1, maar de inhoud is %2 en is zo gelezen</translation>
    </message>
    <message>
        <source>has a %1 that could not be read, which was ignored</source>
        <translation>heeft een onleesbare waarde (%1), die is genegeerd</translation>
    </message>
    <message>
        <source>%1; it was skipped, and its ink looks like pencil</source>
        <translation>Een materiaal is ongeldig en is overgeslagen; de lijnen ervan zien eruit als potlood</translation>
    </message>
    <message>
        <source>has a %1 that could not be read, and became black</source>
        <translation>heeft een onleesbare waarde (%1) en is zwart geworden</translation>
    </message>
    <message>
        <source>fills the page and was used as the paper colour</source>
        <translation>vult de pagina en is de kleur van het papier geworden</translation>
    </message>
    <message>
        <source>does not define its unit; 1/96 inch was assumed</source>
        <translation>noemt zijn eenheid niet; 1/96 inch is aangenomen</translation>
    </message>
    <message>
        <source>shows part of a trace; the whole trace was read</source>
        <translation>toont een deel van een lijn; de hele lijn is gelezen</translation>
    </message>
    <message>
        <source>was skipped: it follows the end of the drawing</source>
        <translation>is overgeslagen: het staat na het einde van de tekening</translation>
    </message>
    <message>
        <source>has pointed or cut corners, which became round</source>
        <translation>heeft spitse of afgesneden hoeken, die rond zijn geworden</translation>
    </message>
    <message>
        <source>has a last point without y, which was skipped</source>
        <translation>heeft een laatste punt zonder y, dat is overgeslagen</translation>
    </message>
    <message>
        <source>was skipped: it is nested more than 256 deep</source>
        <translation>is overgeslagen: het is meer dan 256 keer genest</translation>
    </message>
    <message>
        <source>was made with the eraser end and was skipped</source>
        <translation>is gemaakt met het gumuiteinde en is overgeslagen</translation>
    </message>
    <message>
        <source>has times beyond 9e12 ms, which were ignored</source>
        <translation>heeft onmogelijke tijden, die zijn genegeerd</translation>
    </message>
    <message>
        <source>is thinner than 0.05 mm and became that wide</source>
        <translation>is dunner dan 0,05 mm en is zo breed geworden</translation>
    </message>
    <message>
        <source>has an invalid page size, which was ignored</source>
        <translation>heeft een ongeldig paginaformaat, dat is genegeerd</translation>
    </message>
    <message>
        <source>has an invalid transform, which was ignored</source>
        <translation>heeft een ongeldige transformatie, die is genegeerd</translation>
    </message>
    <message>
        <source>has flat or square ends, which became round</source>
        <translation>heeft rechte uiteinden, die rond zijn geworden</translation>
    </message>
    <message>
        <source>has too many dashes and became a solid line</source>
        <translation>heeft te veel streepjes en is een doorgetrokken lijn geworden</translation>
    </message>
    <message>
        <source>is not a known colour; it was read as black</source>
        <translation>is geen bekende kleur en is zwart geworden</translation>
    </message>
    <message>
        <source>has too few widths; a single width was used</source>
        <translation>heeft te weinig breedtes; één breedte is gebruikt</translation>
    </message>
    <message>
        <source>is not two-dimensional and is not supported</source>
        <translation>is niet tweedimensionaal en wordt niet ondersteund</translation>
    </message>
    <message>
        <source>has a damaged curve; its points were read: %1</source>
        <translation>heeft een beschadigde kromme; de punten zijn gelezen</translation>
    </message>
    <message>
        <source>belongs to another program and was skipped</source>
        <translation>hoort bij een ander programma en is overgeslagen</translation>
    </message>
    <message>
        <source>has an impossible width, which was skipped</source>
        <translation>heeft een onmogelijke breedte, die is overgeslagen</translation>
    </message>
    <message>
        <source>has widths without a unit; mm was assumed</source>
        <translation>heeft breedtes zonder eenheid; mm is aangenomen</translation>
    </message>
    <message>
        <source>has a damaged curve; its points were read</source>
        <translation>heeft een beschadigde kromme; de punten zijn gelezen</translation>
    </message>
    <message>
        <source>does not form a stroke and was skipped: %1</source>
        <translation>vormt geen lijn en is overgeslagen</translation>
    </message>
    <message>
        <source>has no width; the default width was used</source>
        <translation>heeft geen breedte; de gebruikelijke is gebruikt</translation>
    </message>
    <message>
        <source>of type &apos;%1&apos; is a picture and was skipped</source>
        <translation>van type ‘%1’ is een afbeelding en is overgeslagen</translation>
    </message>
    <message>
        <source>is unknown in a context and was skipped</source>
        <translation>is onbekend in een context en is overgeslagen</translation>
    </message>
    <message>
        <source>was skipped: animation is not supported</source>
        <translation>is overgeslagen: animatie wordt niet ondersteund</translation>
    </message>
    <message>
        <source>has a %1 to something that does not exist</source>
        <translation>verwijst met %1 naar iets dat niet bestaat</translation>
    </message>
    <message>
        <source>is text, not a stroke, and was skipped</source>
        <translation>is tekst, geen lijn, en is overgeslagen</translation>
    </message>
    <message>
        <source>does not form a fill and was skipped: %1</source>
        <translation>vormt geen vulling en is overgeslagen</translation>
    </message>
    <message>
        <source>has times that run backwards in places</source>
        <translation>heeft tijden die op sommige plaatsen teruglopen</translation>
    </message>
    <message>
        <source>of an unknown tool was read as a pen&apos;s</source>
        <translation>van een onbekend gereedschap is als lijn van een pen gelezen</translation>
    </message>
    <message>
        <source>of form &apos;%1&apos; was replaced by a round one</source>
        <translation>van vorm ‘%1’ is door een ronde vervangen</translation>
    </message>
    <message>
        <source>is hidden in the file and was skipped</source>
        <translation>is in het bestand verborgen en is overgeslagen</translation>
    </message>
    <message>
        <source>has an unknown colour; white was used</source>
        <translation>heeft een onbekende kleur; wit is gebruikt</translation>
    </message>
    <message>
        <source>has an unknown colour; black was used</source>
        <translation>heeft een onbekende kleur; zwart is gebruikt</translation>
    </message>
    <message>
        <source>%1; only the points before it were read</source>
        <translation>bevat een fout; alleen de punten ervoor zijn gelezen</translation>
    </message>
    <message>
        <source>has no unit of length; mm was assumed</source>
        <translation>heeft geen lengte-eenheid; mm is aangenomen</translation>
    </message>
    <message>
        <source>extends beyond 1e9 mm and was skipped</source>
        <translation>is onmetelijk groot en is overgeslagen</translation>
    </message>
    <message>
        <source>has too many choices and was skipped</source>
        <translation>heeft te veel alternatieven en is overgeslagen</translation>
    </message>
    <message>
        <source>is not a valid width and was skipped</source>
        <translation>is geen geldige breedte en is overgeslagen</translation>
    </message>
    <message>
        <source>The picture of the layer &apos;%1&apos; is lost.</source>
        <translation>De afbeelding van de laag ‘%1’ is verloren.</translation>
    </message>
    <message>
        <source>of style &apos;%1&apos;: its lines were skipped</source>
        <translation>van stijl ‘%1’: de lijnen ervan zijn overgeslagen</translation>
    </message>
    <message>
        <source>has a blend mode, which was ignored</source>
        <translation>heeft een mengmodus, die is genegeerd</translation>
    </message>
    <message>
        <source>and others were changed or skipped</source>
        <translation>en andere zijn gewijzigd of overgeslagen</translation>
    </message>
    <message>
        <source>has a clip path, which was ignored</source>
        <translation>heeft een afsnijpad, dat is genegeerd</translation>
    </message>
    <message>
        <source>was skipped: scripts are not run</source>
        <translation>is overgeslagen: scripts worden niet uitgevoerd</translation>
    </message>
    <message>
        <source>was skipped: it refers to itself</source>
        <translation>is overgeslagen: het verwijst naar zichzelf</translation>
    </message>
    <message>
        <source>has no X or no Y and was skipped</source>
        <translation>heeft geen X of geen Y en is overgeslagen</translation>
    </message>
    <message>
        <source>is not a stroke and was skipped</source>
        <translation>is geen lijn en is overgeslagen</translation>
    </message>
    <message>
        <source>has markers, which were skipped</source>
        <translation>heeft markeringen, die zijn overgeslagen</translation>
    </message>
    <message>
        <source>has a filter, which was ignored</source>
        <translation>heeft een filter, dat is genegeerd</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is unknown and was skipped</source>
        <translation>‘%1’ is onbekend en is overgeslagen</translation>
    </message>
    <message>
        <source>has no points and was skipped</source>
        <translation>heeft geen punten en is overgeslagen</translation>
    </message>
    <message>
        <source>has a mask, which was ignored</source>
        <translation>heeft een masker, dat is genegeerd</translation>
    </message>
    <message>
        <source>has a zoom, which was ignored</source>
        <translation>heeft een zoom, die is genegeerd</translation>
    </message>
    <message>
        <source>is a picture and was skipped</source>
        <translation>is een afbeelding en is overgeslagen</translation>
    </message>
    <message>
        <source>has no size; A4 was assumed</source>
        <translation>heeft geen formaat; A4 is aangenomen</translation>
    </message>
    <message>
        <source>of type &apos;%1&apos; is not supported</source>
        <translation>van type ‘%1’ wordt niet ondersteund</translation>
    </message>
    <message>
        <source>is unknown and was skipped</source>
        <translation>is onbekend en is overgeslagen</translation>
    </message>
    <message>
        <source>was read up to an error: %1</source>
        <translation>is tot een fout gelezen</translation>
    </message>
    <message>
        <source>lost the fill of its area</source>
        <translation>heeft de vulling van het vlak verloren</translation>
    </message>
    <message>
        <source>%1; the rest was skipped</source>
        <translation>bevat een fout; de rest is overgeslagen</translation>
    </message>
    <message>
        <source>is no longer dashed</source>
        <translation>is niet meer gestreept</translation>
    </message>
    <message>
        <source>got round ends</source>
        <translation>heeft ronde uiteinden gekregen</translation>
    </message>
    <message>
        <source>was skipped: %1</source>
        <translation>is overgeslagen</translation>
    </message>
    <message>
        <source>has no page</source>
        <translation>heeft geen pagina</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>regel %1: %2</translation>
    </message>
    <message>
        <source>%1 (and %2 more like it)</source>
        <translation>%1 (en nog %2 zoals deze)</translation>
    </message>
</context>
<context>
    <name>KeyTable</name>
    <message>
        <source>Tools</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bewerken</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Beeld</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Laag</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Gevoel</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Help</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Beeld verschuiven</translation>
    </message>
    <message>
        <source>Space + drag</source>
        <translation>Spatie + slepen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Muiswiel</translation>
    </message>
    <message>
        <source>Zoom smoothly</source>
        <translation>Traploos zoomen</translation>
    </message>
    <message>
        <source>Ctrl + Space + drag</source>
        <translation>Ctrl + spatie + slepen</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Beeld draaien</translation>
    </message>
    <message>
        <source>Shift + Space + drag</source>
        <translation>Shift + spatie + slepen</translation>
    </message>
    <message>
        <source>Use a tool temporarily</source>
        <translation>Gereedschap tijdelijk gebruiken</translation>
    </message>
    <message>
        <source>Hold its key while you use it</source>
        <translation>Toets tijdens het gebruik ingedrukt houden</translation>
    </message>
    <message>
        <source>Pen, mouse and held keys</source>
        <translation>Pen, muis en ingedrukte toetsen</translation>
    </message>
    <message>
        <source>Change the size</source>
        <translation>Grootte wijzigen</translation>
    </message>
    <message>
        <source>Ctrl + Alt + drag</source>
        <translation>Ctrl + Alt + slepen</translation>
    </message>
    <message>
        <source>Palette at the pointer</source>
        <translation>Palet bij de aanwijzer</translation>
    </message>
    <message>
        <source>Click with the right button</source>
        <translation>Klik met de rechterknop</translation>
    </message>
    <message>
        <source>Move the selected lines by 1, 10 or 0.1 mm</source>
        <translation>Geselecteerde lijnen 1, 10 of 0,1 mm verplaatsen</translation>
    </message>
    <message>
        <source>Arrow, Shift + arrow, Ctrl + arrow</source>
        <translation>Pijl, Shift + pijl, Ctrl + pijl</translation>
    </message>
</context>
<context>
    <name>LayerActions</name>
    <message>
        <source>&amp;Add layer</source>
        <translation>Laag &amp;toevoegen</translation>
    </message>
    <message>
        <source>Adds a layer above the current one.</source>
        <translation>Voegt een laag toe boven de huidige.</translation>
    </message>
    <message>
        <source>Remo&amp;ve layer</source>
        <translation>Laag &amp;verwijderen</translation>
    </message>
    <message>
        <source>Removes the layer and its lines.</source>
        <translation>Verwijdert de laag en de lijnen erop.</translation>
    </message>
    <message>
        <source>Re&amp;name layer</source>
        <translation>Laag &amp;hernoemen</translation>
    </message>
    <message>
        <source>Changes the name of the layer.</source>
        <translation>Wijzigt de naam van de laag.</translation>
    </message>
    <message>
        <source>&amp;Raise layer</source>
        <translation>Laag &amp;omhoog</translation>
    </message>
    <message>
        <source>Moves the layer up by one.</source>
        <translation>Verplaatst de laag één omhoog.</translation>
    </message>
    <message>
        <source>&amp;Lower layer</source>
        <translation>Laag o&amp;mlaag</translation>
    </message>
    <message>
        <source>Moves the layer down by one.</source>
        <translation>Verplaatst de laag één omlaag.</translation>
    </message>
    <message>
        <source>Draw on the layer &amp;above</source>
        <translation>Op de laag er&amp;boven tekenen</translation>
    </message>
    <message>
        <source>New lines go to the next layer up.</source>
        <translation>Nieuwe lijnen komen op de volgende laag erboven.</translation>
    </message>
    <message>
        <source>Draw on the layer &amp;below</source>
        <translation>Op de laag er&amp;onder tekenen</translation>
    </message>
    <message>
        <source>New lines go to the next layer down.</source>
        <translation>Nieuwe lijnen komen op de volgende laag eronder.</translation>
    </message>
    <message>
        <source>&amp;Show layer</source>
        <translation>Laag to&amp;nen</translation>
    </message>
    <message>
        <source>Shows or hides the lines on the layer.</source>
        <translation>Toont of verbergt de lijnen op de laag.</translation>
    </message>
    <message>
        <source>Loc&amp;k layer</source>
        <translation>Laag ver&amp;grendelen</translation>
    </message>
    <message>
        <source>Protects the layer against changes.</source>
        <translation>Beschermt de laag tegen wijzigingen.</translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation>Laag &amp;dupliceren</translation>
    </message>
    <message>
        <source>Adds a copy of the layer above it.</source>
        <translation>Voegt erboven een kopie van de laag toe.</translation>
    </message>
    <message>
        <source>&amp;Merge layer down</source>
        <translation>Met de laag eronder sa&amp;menvoegen</translation>
    </message>
    <message>
        <source>Moves the lines of the layer to the one below.</source>
        <translation>Verplaatst de lijnen van de laag naar de laag eronder.</translation>
    </message>
    <message>
        <source>&amp;Export the picture</source>
        <translation>Afbeelding &amp;exporteren</translation>
    </message>
    <message>
        <source>Shows the picture of the layer in exported files.</source>
        <translation>Toont de afbeelding van de laag in geëxporteerde bestanden.</translation>
    </message>
    <message>
        <source>&amp;Group layers</source>
        <translation>Lagen &amp;groeperen</translation>
    </message>
    <message>
        <source>Groups the layer with the one below, or puts it into the group below.</source>
        <translation>Groepeert de laag met die eronder, of zet hem in de groep eronder.</translation>
    </message>
    <message>
        <source>&amp;Ungroup layers</source>
        <translation>Groep &amp;opheffen</translation>
    </message>
    <message>
        <source>Dissolves the group; its layers stay.</source>
        <translation>Heft de groep op; de lagen blijven.</translation>
    </message>
    <message>
        <source>&amp;Take out of the group</source>
        <translation>&amp;Uit de groep halen</translation>
    </message>
    <message>
        <source>Puts the layer above its group.</source>
        <translation>Zet de laag boven zijn groep.</translation>
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
        <translation>Schoolbord</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Vilt</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Hard</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Stevig</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Zacht</translation>
    </message>
    <message>
        <source>slippery</source>
        <translation>glad</translation>
    </message>
    <message>
        <source>some friction</source>
        <translation>enige wrijving</translation>
    </message>
    <message>
        <source>much friction</source>
        <translation>veel wrijving</translation>
    </message>
    <message>
        <source>strong friction</source>
        <translation>sterke wrijving</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>effen</translation>
    </message>
    <message>
        <source>fine grain</source>
        <translation>fijne korrel</translation>
    </message>
    <message>
        <source>rough grain</source>
        <translation>grove korrel</translation>
    </message>
    <message>
        <source>coarse weave</source>
        <translation>grof weefsel</translation>
    </message>
    <message>
        <source>%1, %2, %3.</source>
        <translation>%1, %2, %3.</translation>
    </message>
    <message>
        <source>Rough paper</source>
        <translation>Ruw papier</translation>
    </message>
    <message>
        <source>Watercolour paper</source>
        <translation>Aquarelpapier</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Canvas</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Hout</translation>
    </message>
    <message>
        <source>matted fibres</source>
        <translation>vervilte vezels</translation>
    </message>
    <message>
        <source>grain along the board</source>
        <translation>nerf in de lengte van de plank</translation>
    </message>
    <message>
        <source>hilly grain</source>
        <translation>heuvelige korrel</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Potlood</translation>
    </message>
    <message>
        <source>Hard pencil</source>
        <translation>Hard potlood</translation>
    </message>
    <message>
        <source>Soft pencil</source>
        <translation>Zacht potlood</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>Houtskool</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>Krijt</translation>
    </message>
    <message>
        <source>Crayon</source>
        <translation>Waskrijt</translation>
    </message>
    <message>
        <source>Felt-tip</source>
        <translation>Viltstift</translation>
    </message>
    <message>
        <source>Ink pen</source>
        <translation>Inktpen</translation>
    </message>
    <message>
        <source>Brush pen</source>
        <translation>Penseelstift</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Gum</translation>
    </message>
    <message>
        <source>covers the grain</source>
        <translation>bedekt de korrel</translation>
    </message>
    <message>
        <source>grain is felt but not visible</source>
        <translation>korrel voelbaar, maar niet zichtbaar</translation>
    </message>
    <message>
        <source>fills the grain</source>
        <translation>vult de korrel</translation>
    </message>
    <message>
        <source>shows the grain</source>
        <translation>toont de korrel</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 tot %2 mm</translation>
    </message>
    <message>
        <source>%1, %2, lines of %3.</source>
        <translation>%1, %2, lijnen van %3.</translation>
    </message>
    <message>
        <source>Dashed pen</source>
        <translation>Streepjespen</translation>
    </message>
    <message>
        <source>Double line</source>
        <translation>Dubbele lijn</translation>
    </message>
    <message>
        <source>Arrow pen</source>
        <translation>Pijlenpen</translation>
    </message>
    <message>
        <source>Rope</source>
        <translation>Touw</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Blad</translation>
    </message>
    <message>
        <source>Hatched pen</source>
        <translation>Arceerpen</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;Guides</source>
        <translation>H&amp;ulplijnen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Bestand</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Be&amp;werken</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>B&amp;eeld</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Gereedschap</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Laag</translation>
    </message>
    <message>
        <source>F&amp;eel</source>
        <translation>Ge&amp;voel</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Help</translation>
    </message>
    <message>
        <source>Copy &amp;as</source>
        <translation>Kopiëren &amp;als</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panelen</translation>
    </message>
    <message>
        <source>&amp;Example drawings</source>
        <translation>&amp;Voorbeeldtekeningen</translation>
    </message>
    <message>
        <source>&amp;Scroll</source>
        <translation>Sch&amp;uiven</translation>
    </message>
    <message>
        <source>Pal&amp;ette</source>
        <translation>Pal&amp;et</translation>
    </message>
    <message>
        <source>S&amp;urface</source>
        <translation>&amp;Ondergrond</translation>
    </message>
    <message>
        <source>Export the so&amp;lid</source>
        <translation>&amp;Lichaam exporteren</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporteren</translation>
    </message>
</context>
<context>
    <name>OfferPopup</name>
    <message>
        <source>Delete 1 line</source>
        <translation>1 lijn verwijderen</translation>
    </message>
    <message>
        <source>Delete %1 lines</source>
        <translation>%1 lijnen verwijderen</translation>
    </message>
    <message>
        <source>Select 1 line</source>
        <translation>1 lijn selecteren</translation>
    </message>
    <message>
        <source>Select %1 lines</source>
        <translation>%1 lijnen selecteren</translation>
    </message>
    <message>
        <source>Straight line</source>
        <translation>Rechte lijn</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Boog</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cirkel</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellips</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Driehoek</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechthoek</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Veelhoek</translation>
    </message>
    <message>
        <source>Keep the ink</source>
        <translation>Inkt behouden</translation>
    </message>
    <message>
        <source>Take the &amp;offer at the pen</source>
        <translation>&amp;Aanbod bij de pen aannemen</translation>
    </message>
    <message>
        <source>Chooses what the last stroke is offered to mean: a gesture or a shape.</source>
        <translation>Kiest wat de laatste haal kan betekenen: een gebaar of een vorm.</translation>
    </message>
    <message>
        <source>Take the &amp;second offer at the pen</source>
        <translation>&amp;Tweede aanbod bij de pen aannemen</translation>
    </message>
    <message>
        <source>Chooses the second meaning, if two are offered.</source>
        <translation>Kiest de tweede betekenis, als er twee worden aangeboden.</translation>
    </message>
</context>
<context>
    <name>OptionsPanel</name>
    <message>
        <source>on</source>
        <translation>aan</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
</context>
<context>
    <name>Palettes</name>
    <message>
        <source>Soft black</source>
        <translation>Zachtzwart</translation>
    </message>
    <message>
        <source>Graphite</source>
        <translation>Grafiet</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Lood</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>Krijt</translation>
    </message>
    <message>
        <source>Red chalk</source>
        <translation>Rood krijt</translation>
    </message>
    <message>
        <source>Brick</source>
        <translation>Baksteen</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Vermiljoen</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>Amber</translation>
    </message>
    <message>
        <source>Straw</source>
        <translation>Stro</translation>
    </message>
    <message>
        <source>Moss</source>
        <translation>Mos</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Den</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>Petrol</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Hemel</translation>
    </message>
    <message>
        <source>Ink blue</source>
        <translation>Inktblauw</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violet</translation>
    </message>
    <message>
        <source>Mallow</source>
        <translation>Malve</translation>
    </message>
    <message>
        <source>Blush</source>
        <translation>Blos</translation>
    </message>
    <message>
        <source>Sepia</source>
        <translation>Sepia</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Zwart</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Oranje</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Hemelsblauw</translation>
    </message>
    <message>
        <source>Bluish green</source>
        <translation>Blauwgroen</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Geel</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blauw</translation>
    </message>
    <message>
        <source>Reddish purple</source>
        <translation>Roodpaars</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>Grijzen</translation>
    </message>
    <message>
        <source>Grey %1 %</source>
        <translation>Grijs %1%</translation>
    </message>
    <message>
        <source>Pencil box</source>
        <translation>Etui</translation>
    </message>
    <message>
        <source>Okabe and Ito</source>
        <translation>Okabe en Ito</translation>
    </message>
</context>
<context>
    <name>PenActions</name>
    <message>
        <source>&amp;Pen pressure</source>
        <translation>Pen&amp;druk</translation>
    </message>
    <message>
        <source>Press harder to draw a wider line. If off, every line has the same width.</source>
        <translation>Harder drukken geeft bredere lijnen. Indien uit, zijn alle lijnen even breed.</translation>
    </message>
    <message>
        <source>Hold the &amp;first modifier</source>
        <translation>&amp;Eerste modificatietoets vasthouden</translation>
    </message>
    <message>
        <source>Acts as if Shift were held, until you choose this again.</source>
        <translation>Alsof Shift wordt vastgehouden, tot je deze opdracht opnieuw kiest.</translation>
    </message>
    <message>
        <source>Hold the &amp;second modifier</source>
        <translation>&amp;Tweede modificatietoets vasthouden</translation>
    </message>
    <message>
        <source>Acts as if Ctrl were held, until you choose this again.</source>
        <translation>Alsof Ctrl wordt vastgehouden, tot je deze opdracht opnieuw kiest.</translation>
    </message>
</context>
<context>
    <name>PenDevice</name>
    <message>
        <source>Simulated: %1</source>
        <translation>Gesimuleerd: %1</translation>
    </message>
    <message>
        <source>The ink follows the pen exactly. Forces are shown, not felt.</source>
        <translation>De inkt volgt de pen exact. Krachten worden getoond, maar zijn niet voelbaar.</translation>
    </message>
    <message>
        <source>Mouse or pen move a simulated hand that holds this stylus. Forces move the ink, so that you see what they would feel like.</source>
        <translation>Muis of pen bewegen een gesimuleerde hand die deze stylus vasthoudt. Krachten verplaatsen de inkt, zodat je ziet hoe het zou aanvoelen.</translation>
    </message>
    <message>
        <source>Simulated %1</source>
        <translation>%1, gesimuleerd</translation>
    </message>
    <message>
        <source>You hold it in your hand and feel the forces.</source>
        <translation>Je houdt het in de hand en voelt de krachten.</translation>
    </message>
    <message>
        <source>Mouse or pen, without forces</source>
        <translation>Muis of pen, zonder krachten</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>Muis of pen</translation>
    </message>
    <message>
        <source>Worst case: light, frictionless, coarse</source>
        <translation>Slechtste geval: licht, wrijvingsloos, grof</translation>
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
        <translation>Als voorinstelling bewaren</translation>
    </message>
    <message>
        <source>Name for this medium, size, colour and options:</source>
        <translation>Naam voor dit tekenmiddel met grootte, kleur en opties:</translation>
    </message>
    <message>
        <source>&amp;Keep as a preset…</source>
        <translation>Als voorinstelling &amp;bewaren…</translation>
    </message>
    <message>
        <source>Keeps the medium, the size, the colour and the options of the pencil under a name.</source>
        <translation>Bewaart tekenmiddel, grootte, kleur en opties van het potlood onder een naam.</translation>
    </message>
</context>
<context>
    <name>QuestionScreen</name>
    <message>
        <source>Mental demand</source>
        <translation>Mentale belasting</translation>
    </message>
    <message>
        <source>How mentally demanding was the task?</source>
        <translation>Hoe mentaal belastend was de taak?</translation>
    </message>
    <message>
        <source>Very low</source>
        <translation>Zeer laag</translation>
    </message>
    <message>
        <source>Very high</source>
        <translation>Zeer hoog</translation>
    </message>
    <message>
        <source>Physical demand</source>
        <translation>Fysieke belasting</translation>
    </message>
    <message>
        <source>How physically demanding was the task?</source>
        <translation>Hoe fysiek belastend was de taak?</translation>
    </message>
    <message>
        <source>Temporal demand</source>
        <translation>Tijdsdruk</translation>
    </message>
    <message>
        <source>How hurried or rushed was the pace of the task?</source>
        <translation>Hoe gehaast of gejaagd was het tempo van de taak?</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Prestatie</translation>
    </message>
    <message>
        <source>How successful were you in accomplishing what you were asked to do?</source>
        <translation>Hoe succesvol was u in het uitvoeren van wat u gevraagd werd?</translation>
    </message>
    <message>
        <source>Perfect</source>
        <translation>Perfect</translation>
    </message>
    <message>
        <source>Failure</source>
        <translation>Mislukt</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Inspanning</translation>
    </message>
    <message>
        <source>How hard did you have to work to accomplish your level of performance?</source>
        <translation>Hoe hard moest u werken om uw prestatieniveau te bereiken?</translation>
    </message>
    <message>
        <source>Frustration</source>
        <translation>Frustratie</translation>
    </message>
    <message>
        <source>How insecure, discouraged, irritated, stressed and annoyed were you?</source>
        <translation>Hoe onzeker, ontmoedigd, geïrriteerd, gestrest en geërgerd was u?</translation>
    </message>
    <message>
        <source>obstructive</source>
        <translation>belemmerend</translation>
    </message>
    <message>
        <source>supportive</source>
        <translation>ondersteunend</translation>
    </message>
    <message>
        <source>complicated</source>
        <translation>ingewikkeld</translation>
    </message>
    <message>
        <source>easy</source>
        <translation>gemakkelijk</translation>
    </message>
    <message>
        <source>inefficient</source>
        <translation>inefficiënt</translation>
    </message>
    <message>
        <source>efficient</source>
        <translation>efficiënt</translation>
    </message>
    <message>
        <source>confusing</source>
        <translation>verwarrend</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>overzichtelijk</translation>
    </message>
    <message>
        <source>boring</source>
        <translation>saai</translation>
    </message>
    <message>
        <source>exciting</source>
        <translation>spannend</translation>
    </message>
    <message>
        <source>not interesting</source>
        <translation>oninteressant</translation>
    </message>
    <message>
        <source>interesting</source>
        <translation>interessant</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>conventioneel</translation>
    </message>
    <message>
        <source>inventive</source>
        <translation>origineel</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>gebruikelijk</translation>
    </message>
    <message>
        <source>leading edge</source>
        <translation>nieuw</translation>
    </message>
</context>
<context>
    <name>SafetyWords</name>
    <message>
        <source>the force limit</source>
        <translation>de krachtgrens</translation>
    </message>
    <message>
        <source>the continuous force of the motors</source>
        <translation>de continue kracht van de motoren</translation>
    </message>
    <message>
        <source>the speed of the pen</source>
        <translation>de snelheid van de pen</translation>
    </message>
    <message>
        <source>the limit on how fast a force may rise</source>
        <translation>de grens voor hoe snel een kracht mag toenemen</translation>
    </message>
    <message>
        <source>the largest stiffness of the device</source>
        <translation>de maximale stijfheid van het apparaat</translation>
    </message>
    <message>
        <source>Limited by %1.</source>
        <translation>Begrensd door: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Forces are on</source>
        <translation>De krachten zijn aan</translation>
    </message>
    <message>
        <source>Forces were stopped</source>
        <translation>De krachten zijn gestopt</translation>
    </message>
    <message>
        <source>Forces were stopped: %1</source>
        <translation>De krachten zijn gestopt: %1</translation>
    </message>
    <message>
        <source>Check the cable and the power of the device, then switch the forces on again.</source>
        <translation>Controleer de kabel en de voeding van het apparaat en schakel de krachten daarna weer in.</translation>
    </message>
    <message>
        <source>You can continue to draw. Lift the pen and switch the forces on again.</source>
        <translation>Je kunt verder tekenen. Til de pen op en schakel de krachten weer in.</translation>
    </message>
    <message>
        <source>the computer was too busy</source>
        <translation>de computer had het te druk</translation>
    </message>
    <message>
        <source>the pen was too fast</source>
        <translation>de pen was te snel</translation>
    </message>
    <message>
        <source>the program was too busy</source>
        <translation>het programma had het te druk</translation>
    </message>
    <message>
        <source>the computer paused for a moment</source>
        <translation>de computer stond even stil</translation>
    </message>
    <message>
        <source>a force was invalid</source>
        <translation>een kracht was ongeldig</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>het apparaat antwoordt niet</translation>
    </message>
    <message>
        <source>the pen seemed to jump</source>
        <translation>de pen leek te springen</translation>
    </message>
    <message>
        <source>the self-test failed</source>
        <translation>de zelftest is mislukt</translation>
    </message>
    <message>
        <source>Forces are off</source>
        <translation>De krachten zijn uit</translation>
    </message>
    <message>
        <source>They are not shown either.</source>
        <translation>Ze worden ook niet getoond.</translation>
    </message>
    <message>
        <source>Shown, not felt: this pen has no motors</source>
        <translation>Getoond, niet gevoeld: deze pen heeft geen motoren</translation>
    </message>
    <message>
        <source>The plot shows the forces that a device would be asked for.</source>
        <translation>De grafiek toont de krachten die van een apparaat gevraagd zouden worden.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Lift the pen for a moment to start the forces.</source>
        <translation>Til de pen even op om de krachten te starten.</translation>
    </message>
    <message>
        <source>Forces are starting</source>
        <translation>De krachten beginnen</translation>
    </message>
    <message>
        <source>The program is busy</source>
        <translation>Het programma is bezig</translation>
    </message>
    <message>
        <source>The pen only feels damping.</source>
        <translation>De pen voelt alleen demping.</translation>
    </message>
    <message>
        <source>Forces are reduced: %1</source>
        <translation>De krachten zijn verlaagd: %1</translation>
    </message>
    <message>
        <source>They return by themselves.</source>
        <translation>Ze komen vanzelf terug.</translation>
    </message>
    <message>
        <source>Sum, requested</source>
        <translation>Som, gevraagd</translation>
    </message>
    <message>
        <source>Sent to the pen</source>
        <translation>Naar de pen gestuurd</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Ondergrond</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viscositeit</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Korrel</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kromme</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Vastklikken</translation>
    </message>
    <message>
        <source>Tether</source>
        <translation>Lijn</translation>
    </message>
    <message>
        <source>Stabiliser</source>
        <translation>Stabilisator</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Aanslag</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Demping</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Overige</translation>
    </message>
    <message>
        <source>You can continue to draw. Switch the forces on at the device, lift the pen, then switch them on here.</source>
        <translation>Je kunt verder tekenen. Schakel de krachten in op het apparaat, til de pen op en schakel ze dan hier in.</translation>
    </message>
    <message>
        <source>You can continue to draw. Let the device rest for a few minutes, then switch the forces on again.</source>
        <translation>Je kunt verder tekenen. Laat het apparaat enkele minuten rusten en schakel de krachten daarna weer in.</translation>
    </message>
    <message>
        <source>the computer or the device could not keep up several times in a minute</source>
        <translation>de computer of het apparaat kon het meermaals per minuut niet bijhouden</translation>
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
        <translation>Schrijft het lichaam als driehoeken, om te printen</translation>
    </message>
    <message>
        <source>STL file (*.stl)</source>
        <translation>STL-bestand (*.stl)</translation>
    </message>
    <message>
        <source>&amp;3MF…</source>
        <translation>&amp;3MF…</translation>
    </message>
    <message>
        <source>Writes the solid with its unit and colours, for printing</source>
        <translation>Schrijft het lichaam met eenheid en kleuren, om te printen</translation>
    </message>
    <message>
        <source>3MF file (*.3mf)</source>
        <translation>3MF-bestand (*.3mf)</translation>
    </message>
    <message>
        <source>&amp;OBJ…</source>
        <translation>&amp;OBJ…</translation>
    </message>
    <message>
        <source>Writes the solid for any 3D program</source>
        <translation>Schrijft het lichaam voor elk 3D-programma</translation>
    </message>
    <message>
        <source>Wavefront file (*.obj)</source>
        <translation>Wavefront-bestand (*.obj)</translation>
    </message>
    <message>
        <source>&amp;glTF…</source>
        <translation>&amp;glTF…</translation>
    </message>
    <message>
        <source>Writes the solid with colours and smooth shading, for 3D programs and web pages</source>
        <translation>Schrijft het lichaam met kleuren en vloeiende schaduw, voor 3D-programma’s en webpagina’s</translation>
    </message>
    <message>
        <source>Binary glTF file (*.glb)</source>
        <translation>Binair glTF-bestand (*.glb)</translation>
    </message>
    <message>
        <source>Export the solid</source>
        <translation>Lichaam exporteren</translation>
    </message>
    <message>
        <source>“%1” was not exported</source>
        <translation>‘%1’ is niet geëxporteerd</translation>
    </message>
    <message>
        <source>The paint on the body was left out, because the format has none; glTF has it.</source>
        <translation>De verf op het lichaam is weggelaten, omdat het formaat die niet heeft; glTF heeft die wel.</translation>
    </message>
</context>
<context>
    <name>SolidWords</name>
    <message>
        <source>left out: edit %1 of the body, the cut that begins at (%2, %3) mm: %4</source>
        <translation>weggelaten: bewerking %1 van het lichaam, de snede die bij (%2, %3) mm begint: %4</translation>
    </message>
    <message>
        <source>left out: edit %1 of the body, the extrusion that begins at (%2, %3) mm: %4</source>
        <translation>weggelaten: bewerking %1 van het lichaam, de extrusie die bij (%2, %3) mm begint: %4</translation>
    </message>
    <message>
        <source>left out: edit %1 of the body, the painted line that begins at (%2, %3) mm: %4</source>
        <translation>weggelaten: bewerking %1 van het lichaam, de geverfde lijn die bij (%2, %3) mm begint: %4</translation>
    </message>
    <message>
        <source>left out: edit %1 of the body, the smoothing that begins at (%2, %3) mm: %4</source>
        <translation>weggelaten: bewerking %1 van het lichaam, het gladmaken dat bij (%2, %3) mm begint: %4</translation>
    </message>
    <message>
        <source>left out the smaller part: %1</source>
        <translation>het kleinere deel is weggelaten: %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelaten: %1</translation>
    </message>
    <message>
        <source>left out %1 small closed line, %2</source>
        <translation>%1 kleine gesloten lijn is weggelaten: die %2</translation>
    </message>
    <message>
        <source>left out %1 small closed lines, the largest %2</source>
        <translation>%1 kleine gesloten lijnen zijn weggelaten, de grootste %2</translation>
    </message>
    <message>
        <source>every closed outline is too small or too narrow; the largest is that %1</source>
        <translation>elke gesloten omtrek is te klein of te smal; de grootste is die %1</translation>
    </message>
    <message>
        <source>of stroke %1 at (%2, %3) mm, %4 x %5 mm</source>
        <translation>van streek %1 bij (%2, %3) mm, %4 x %5 mm</translation>
    </message>
    <message>
        <source>at (%1, %2) mm, %3 x %4 mm</source>
        <translation>bij (%1, %2) mm, %3 x %4 mm</translation>
    </message>
    <message>
        <source>contains no closed outline: there is a gap of %1 mm at (%2, %3) mm, at the end of stroke %4</source>
        <translation>er is geen gesloten omtrek: bij (%2, %3) mm, aan het einde van streek %4, zit een gat van %1 mm</translation>
    </message>
    <message>
        <source>contains no closed outline</source>
        <translation>er is geen gesloten omtrek</translation>
    </message>
    <message>
        <source>stroke %1 retraces the outline of stroke %2 at a distance of %3 mm; it was not treated as a hole</source>
        <translation>streek %1 tekent de omtrek van streek %2 nog eens, %3 mm ernaast, en maakt geen gat</translation>
    </message>
    <message>
        <source>the lines are too dense at (%1, %2) mm to find an outline: %3 mm of line within %4 mm, but at most %5 mm can be; smooth the line</source>
        <translation>de lijnen zijn bij (%1, %2) mm te dicht om een omtrek te vinden: %3 mm lijn binnen %4 mm, hoogstens mogelijk is %5 mm; maak de lijn vloeiend</translation>
    </message>
    <message>
        <source>contains no visible strokes</source>
        <translation>er zijn geen zichtbare streken</translation>
    </message>
    <message>
        <source>has more than 100,000 visible strokes</source>
        <translation>er zijn meer dan 100.000 zichtbare streken</translation>
    </message>
    <message>
        <source>an option for solids is out of range</source>
        <translation>een optie voor lichamen valt buiten haar bereik</translation>
    </message>
    <message>
        <source>stroke %1 crosses itself at (%2, %3) mm, so its parts meet in only one point</source>
        <translation>streek %1 kruist zichzelf bij (%2, %3) mm, zodat haar delen elkaar maar in één punt raken</translation>
    </message>
    <message>
        <source>strokes %1 and %2 enclose areas that meet in only one point, (%3, %4) mm: let them overlap, or move them apart</source>
        <translation>de streken %1 en %2 omsluiten vlakken die elkaar maar in één punt raken, (%3, %4) mm: laat ze overlappen of zet ze verder uit elkaar</translation>
    </message>
    <message>
        <source>lines enclose areas that meet in only one point, (%1, %2) mm: let them overlap, or move them apart</source>
        <translation>lijnen omsluiten vlakken die elkaar maar in één punt raken, (%1, %2) mm: laat ze overlappen of zet ze verder uit elkaar</translation>
    </message>
    <message>
        <source>the outline of stroke %1 only touches its mirror axis at (%2, %3) mm</source>
        <translation>de omtrek van streek %1 raakt zijn spiegelas alleen maar, bij (%2, %3) mm</translation>
    </message>
    <message>
        <source>the outline of stroke %1 touches or crosses itself at (%2, %3) mm</source>
        <translation>de omtrek van streek %1 raakt of kruist zichzelf bij (%2, %3) mm</translation>
    </message>
    <message>
        <source>the outline of stroke %1 is too narrow at (%2, %3) mm</source>
        <translation>de omtrek van streek %1 is te smal bij (%2, %3) mm</translation>
    </message>
    <message>
        <source>stroke %1: %2</source>
        <translation>streek %1: %2</translation>
    </message>
    <message>
        <source>the outline nearly touches itself at (%1, %2) mm</source>
        <translation>de omtrek raakt bijna zichzelf bij (%1, %2) mm</translation>
    </message>
    <message>
        <source>the outline is too narrow at (%1, %2) mm</source>
        <translation>de omtrek is te smal bij (%1, %2) mm</translation>
    </message>
    <message>
        <source>the surface is not closed at (%1, %2) mm</source>
        <translation>het oppervlak is niet gesloten bij (%1, %2) mm</translation>
    </message>
    <message>
        <source>the outline has equal points</source>
        <translation>de omtrek heeft gelijke punten</translation>
    </message>
    <message>
        <source>the outline has no area</source>
        <translation>de omtrek heeft geen oppervlakte</translation>
    </message>
    <message>
        <source>the outline has too many narrow parts</source>
        <translation>de omtrek heeft te veel smalle delen</translation>
    </message>
    <message>
        <source>the outline cannot be filled</source>
        <translation>de omtrek kan niet worden gevuld</translation>
    </message>
    <message>
        <source>no point is on the border</source>
        <translation>geen punt ligt op de rand</translation>
    </message>
    <message>
        <source>the heights of the body cannot be computed</source>
        <translation>de hoogten van het lichaam kunnen niet worden berekend</translation>
    </message>
    <message>
        <source>a coordinate of the body is not a number</source>
        <translation>een coördinaat van het lichaam is geen getal</translation>
    </message>
    <message>
        <source>the body has no surface</source>
        <translation>het lichaam heeft geen oppervlak</translation>
    </message>
    <message>
        <source>the stroke does not touch a body</source>
        <translation>de streek raakt geen lichaam</translation>
    </message>
    <message>
        <source>the stroke does not touch the body</source>
        <translation>de streek raakt het lichaam niet</translation>
    </message>
    <message>
        <source>the stroke has no length</source>
        <translation>de streek heeft geen lengte</translation>
    </message>
    <message>
        <source>the stroke is too long</source>
        <translation>de streek is te lang</translation>
    </message>
    <message>
        <source>the stroke begins on the body</source>
        <translation>de streek begint op het lichaam</translation>
    </message>
    <message>
        <source>the stroke ends on the body</source>
        <translation>de streek eindigt op het lichaam</translation>
    </message>
    <message>
        <source>the stroke crosses itself</source>
        <translation>de streek kruist zichzelf</translation>
    </message>
    <message>
        <source>the stroke does not cut off a part of the body</source>
        <translation>de streek snijdt geen deel van het lichaam af</translation>
    </message>
    <message>
        <source>the stroke turns too sharply beside the body</source>
        <translation>de streek draait naast het lichaam te scherp</translation>
    </message>
    <message>
        <source>nothing of the body would remain</source>
        <translation>er zou niets van het lichaam overblijven</translation>
    </message>
    <message>
        <source>the cut runs along the surface of the body</source>
        <translation>de snede loopt langs het oppervlak van het lichaam</translation>
    </message>
    <message>
        <source>the profile has too few points</source>
        <translation>het profiel heeft te weinig punten</translation>
    </message>
    <message>
        <source>the profile begins and ends at the same point</source>
        <translation>het profiel begint en eindigt in hetzelfde punt</translation>
    </message>
    <message>
        <source>the profile leads into the body</source>
        <translation>het profiel loopt het lichaam in</translation>
    </message>
    <message>
        <source>the profile is too flat</source>
        <translation>het profiel is te vlak</translation>
    </message>
    <message>
        <source>the closed line bends around the body too far</source>
        <translation>de gesloten lijn buigt te ver om het lichaam</translation>
    </message>
    <message>
        <source>the body is too thin below the closed line</source>
        <translation>het lichaam is te dun onder de gesloten lijn</translation>
    </message>
    <message>
        <source>the extruded part would cross itself</source>
        <translation>het geëxtrudeerde deel zou zichzelf kruisen</translation>
    </message>
    <message>
        <source>the closed line has too few points</source>
        <translation>de gesloten lijn heeft te weinig punten</translation>
    </message>
    <message>
        <source>the closed line has no length</source>
        <translation>de gesloten lijn heeft geen lengte</translation>
    </message>
    <message>
        <source>the closed line crosses itself</source>
        <translation>de gesloten lijn kruist zichzelf</translation>
    </message>
    <message>
        <source>the closed line is not wholly on the body</source>
        <translation>de gesloten lijn ligt niet helemaal op het lichaam</translation>
    </message>
    <message>
        <source>the closed line encloses nothing</source>
        <translation>de gesloten lijn omsluit niets</translation>
    </message>
    <message>
        <source>the extruded part would touch the body elsewhere</source>
        <translation>het geëxtrudeerde deel zou het lichaam elders raken</translation>
    </message>
    <message>
        <source>the extruded part runs along the surface of the body</source>
        <translation>het geëxtrudeerde deel loopt langs het oppervlak van het lichaam</translation>
    </message>
    <message>
        <source>the painted line has no width</source>
        <translation>de geverfde lijn heeft geen breedte</translation>
    </message>
    <message>
        <source>the surface cannot be smoothed there</source>
        <translation>het oppervlak kan daar niet glad worden gemaakt</translation>
    </message>
    <message>
        <source>the smoothed surface would fold; smooth less at once</source>
        <translation>het gladgemaakte oppervlak zou vouwen; maak minder tegelijk glad</translation>
    </message>
    <message>
        <source>parts of the body would meet in only a point or a line</source>
        <translation>delen van het lichaam zouden elkaar maar in een punt of een lijn raken</translation>
    </message>
    <message>
        <source>the surface of the body crosses itself there</source>
        <translation>het oppervlak van het lichaam kruist zichzelf daar</translation>
    </message>
    <message>
        <source>the surfaces cannot be joined</source>
        <translation>de oppervlakken kunnen niet worden verbonden</translation>
    </message>
</context>
<context>
    <name>Stability</name>
    <message>
        <source>Stable, as requested</source>
        <translation>Stabiel, zoals ingesteld</translation>
    </message>
    <message>
        <source>Close to trembling</source>
        <translation>Bijna trillend</translation>
    </message>
    <message>
        <source>Trembles</source>
        <translation>Trilt</translation>
    </message>
    <message>
        <source>Stable, but less than requested</source>
        <translation>Stabiel, maar minder dan ingesteld</translation>
    </message>
    <message>
        <source>Too much for this device</source>
        <translation>Te veel voor dit apparaat</translation>
    </message>
    <message>
        <source>The safety chain would switch forces off.</source>
        <translation>De veiligheidsketen zou de krachten uitschakelen.</translation>
    </message>
    <message>
        <source>The pen at rest trembles with %1 N above 30 Hz; 0.04 N can be felt. Reduce hardness or friction, or add damping.</source>
        <translation>De pen in rust trilt met %1 N boven 30 Hz; 0,04 N is voelbaar. Verlaag de hardheid of wrijving, of voeg demping toe.</translation>
    </message>
    <message>
        <source>%1 has no motors, so nothing is felt. The figures are those of a 3D Systems Touch.</source>
        <translation>%1 heeft geen motoren, dus er is niets te voelen. De waarden gelden voor een 3D Systems Touch.</translation>
    </message>
    <message>
        <source>%1 % of the device’s limit</source>
        <translation>%1% van de grens van het apparaat</translation>
    </message>
    <message>
        <source>Hardness: this device reaches %1 of your %2 N/m.</source>
        <translation>Hardheid: dit apparaat haalt %1 van de %2 N/m.</translation>
    </message>
    <message>
        <source>Grain: it is too steep for the haptic loop; you feel %1 of your %2 µm.</source>
        <translation>Korrel: die is te steil voor de regellus; te voelen is %1 van de %2 µm.</translation>
    </message>
</context>
<context>
    <name>SwellWords</name>
    <message>
        <source>Lines widened: %1.</source>
        <translation>Verbrede lijnen: %1.</translation>
    </message>
    <message>
        <source>Lines with another width: %1.</source>
        <translation>Lijnen met een andere breedte: %1.</translation>
    </message>
    <message>
        <source>Lines made black: %1.</source>
        <translation>Zwart gemaakte lijnen: %1.</translation>
    </message>
    <message>
        <source>Areas with a texture: %1.</source>
        <translation>Vlakken met een patroon: %1.</translation>
    </message>
    <message>
        <source>Areas too narrow for a texture: %1.</source>
        <translation>Vlakken die te smal zijn voor een patroon: %1.</translation>
    </message>
    <message>
        <source>Lines left out, because they are not seen: %1.</source>
        <translation>Weggelaten lijnen, omdat ze niet te zien zijn: %1.</translation>
    </message>
    <message>
        <source>Areas left out, because they are not seen: %1.</source>
        <translation>Weggelaten vlakken, omdat ze niet te zien zijn: %1.</translation>
    </message>
    <message>
        <source>Pictures left out: %1.</source>
        <translation>Weggelaten afbeeldingen: %1.</translation>
    </message>
    <message>
        <source>Faults that a fingertip would notice: %1. The panel “Tactile check” shows them.</source>
        <translation>Fouten die een vingertop zou merken: %1. Het paneel ‘Tastcontrole’ toont ze.</translation>
    </message>
    <message>
        <source>Some colours share a texture.</source>
        <translation>Sommige kleuren delen een patroon.</translation>
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
        <translation>Maakt het huidige gereedschap kleiner.</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Groter</translation>
    </message>
    <message>
        <source>Makes the current tool larger.</source>
        <translation>Maakt het huidige gereedschap groter.</translation>
    </message>
    <message>
        <source>Forces &amp;weaker</source>
        <translation>Krachten &amp;zwakker</translation>
    </message>
    <message>
        <source>The current tool resists less.</source>
        <translation>Het huidige gereedschap biedt minder weerstand.</translation>
    </message>
    <message>
        <source>Forces &amp;stronger</source>
        <translation>Krachten &amp;sterker</translation>
    </message>
    <message>
        <source>The current tool resists more.</source>
        <translation>Het huidige gereedschap biedt meer weerstand.</translation>
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
        <translation>De maximale grootte is %1 mm.</translation>
    </message>
    <message>
        <source>The smallest size is %1 mm.</source>
        <translation>De minimale grootte is %1 mm.</translation>
    </message>
</context>
<context>
    <name>ViewActions</name>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Inzoomen</translation>
    </message>
    <message>
        <source>Shows the drawing larger, around the pointer</source>
        <translation>Vergroot het beeld rond de aanwijzer</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Uitzoomen</translation>
    </message>
    <message>
        <source>Shows the drawing smaller, around the pointer</source>
        <translation>Verkleint het beeld rond de aanwijzer</translation>
    </message>
    <message>
        <source>&amp;Life size</source>
        <translation>&amp;Ware grootte</translation>
    </message>
    <message>
        <source>One millimetre of the drawing is one millimetre on the screen</source>
        <translation>Eén millimeter in de tekening is één millimeter op het scherm</translation>
    </message>
    <message>
        <source>Fit &amp;selection</source>
        <translation>&amp;Selectie passend</translation>
    </message>
    <message>
        <source>Shows the selection as large as possible</source>
        <translation>Toont de selectie zo groot mogelijk</translation>
    </message>
    <message>
        <source>Fit &amp;page</source>
        <translation>Pa&amp;gina passend</translation>
    </message>
    <message>
        <source>Shows the whole page</source>
        <translation>Toont de hele pagina</translation>
    </message>
    <message>
        <source>Fit &amp;drawing</source>
        <translation>&amp;Tekening passend</translation>
    </message>
    <message>
        <source>Shows all ink, including any outside the page</source>
        <translation>Toont alle inkt, ook buiten de pagina</translation>
    </message>
    <message>
        <source>Turn l&amp;eft</source>
        <translation>&amp;Linksom draaien</translation>
    </message>
    <message>
        <source>Turns the view anticlockwise; the drawing does not change</source>
        <translation>Draait het beeld linksom; de tekening verandert niet</translation>
    </message>
    <message>
        <source>Turn ri&amp;ght</source>
        <translation>&amp;Rechtsom draaien</translation>
    </message>
    <message>
        <source>Turns the view clockwise; the drawing does not change</source>
        <translation>Draait het beeld rechtsom; de tekening verandert niet</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>Re&amp;chtop</translation>
    </message>
    <message>
        <source>Turns the view back upright</source>
        <translation>Zet het beeld weer rechtop</translation>
    </message>
    <message>
        <source>&amp;Mirror view</source>
        <translation>Beeld s&amp;piegelen</translation>
    </message>
    <message>
        <source>Swaps left and right in the view, to check proportions; the drawing does not change</source>
        <translation>Verwisselt links en rechts in beeld, om verhoudingen te controleren; de tekening verandert niet</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Naar links schuiven</translation>
    </message>
    <message>
        <source>Moves the view to the left</source>
        <translation>Verschuift het beeld naar links</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Naar rechts schuiven</translation>
    </message>
    <message>
        <source>Moves the view to the right</source>
        <translation>Verschuift het beeld naar rechts</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Omhoog schuiven</translation>
    </message>
    <message>
        <source>Moves the view up</source>
        <translation>Verschuift het beeld omhoog</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Omlaag schuiven</translation>
    </message>
    <message>
        <source>Moves the view down</source>
        <translation>Verschuift het beeld omlaag</translation>
    </message>
    <message>
        <source>Ou&amp;tlines</source>
        <translation>&amp;Omtrekken</translation>
    </message>
    <message>
        <source>Shows only the centre line of each stroke</source>
        <translation>Toont alleen de hartlijn van elke lijn</translation>
    </message>
    <message>
        <source>&amp;Force arrow</source>
        <translation>&amp;Krachtpijl</translation>
    </message>
    <message>
        <source>Shows the direction and size of the force at the nib</source>
        <translation>Toont richting en grootte van de kracht bij de punt</translation>
    </message>
    <message>
        <source>&amp;Nib moves with forces</source>
        <translation>Pu&amp;nt beweegt mee met krachten</translation>
    </message>
    <message>
        <source>With a simulated stylus, shows the nib where forces move it</source>
        <translation>Toont bij een gesimuleerde pen de punt waar de krachten hem heen bewegen</translation>
    </message>
    <message>
        <source>G&amp;rain of the surface</source>
        <translation>Korr&amp;el van de ondergrond</translation>
    </message>
    <message>
        <source>Dry media show the relief of the surface</source>
        <translation>Droge tekenmiddelen tonen het reliëf van de ondergrond</translation>
    </message>
</context>
<context>
    <name>edits</name>
    <message>
        <source>Make exact</source>
        <translation>Exact maken</translation>
    </message>
    <message>
        <source>Add guide</source>
        <translation>Hulplijn toevoegen</translation>
    </message>
    <message>
        <source>Change guide</source>
        <translation>Hulplijn wijzigen</translation>
    </message>
    <message>
        <source>Remove guide</source>
        <translation>Hulplijn verwijderen</translation>
    </message>
    <message>
        <source>Remove guides</source>
        <translation>Hulplijnen verwijderen</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>Hulplijnen tonen</translation>
    </message>
    <message>
        <source>Hide guides</source>
        <translation>Hulplijnen verbergen</translation>
    </message>
    <message>
        <source>Unlink</source>
        <translation>Losmaken</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Laag toevoegen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Tekenen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliceren</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Gummen</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Laag verbergen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importeren</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Laag vergrendelen</translation>
    </message>
    <message>
        <source>Lower layer</source>
        <translation>Laag omlaag</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verplaatsen</translation>
    </message>
    <message>
        <source>Move end</source>
        <translation>Eind verplaatsen</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Laag verplaatsen</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Trekken</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Duwen</translation>
    </message>
    <message>
        <source>Raise layer</source>
        <translation>Laag omhoog</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Hertekenen</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Laag verwijderen</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Laag hernoemen</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Draaien</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Schalen</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Laag tonen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gladstrijken</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Rekken</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Laag ontgrendelen</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Restyle</source>
        <translation>Kleur of tekenmiddel wijzigen</translation>
    </message>
    <message>
        <source>Recolour</source>
        <translation>Herkleuren</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation>Dekking van de laag</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Laag dupliceren</translation>
    </message>
    <message>
        <source>Merge layers</source>
        <translation>Lagen samenvoegen</translation>
    </message>
    <message>
        <source>Add picture</source>
        <translation>Afbeelding toevoegen</translation>
    </message>
    <message>
        <source>Place picture</source>
        <translation>Afbeelding plaatsen</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Afbeelding exporteren</translation>
    </message>
    <message>
        <source>Gather</source>
        <translation>Bundelen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Vullen</translation>
    </message>
    <message>
        <source>Layer blend mode</source>
        <translation>Mengmodus van laag</translation>
    </message>
    <message>
        <source>Group layers</source>
        <translation>Lagen groeperen</translation>
    </message>
    <message>
        <source>Ungroup layers</source>
        <translation>Groep opheffen</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Als getekend</translation>
    </message>
    <message>
        <source>Scratch out</source>
        <translation>Doorhalen</translation>
    </message>
    <message>
        <source>Bulge</source>
        <translation>Opbollen</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Samenknijpen</translation>
    </message>
    <message>
        <source>Motion timing</source>
        <translation>Timing van de beweging</translation>
    </message>
    <message>
        <source>Correct matches</source>
        <translation>Koppelingen corrigeren</translation>
    </message>
    <message>
        <source>Edit the body</source>
        <translation>Lichaam bewerken</translation>
    </message>
    <message>
        <source>Remove edit of the body</source>
        <translation>Bewerking van het lichaam verwijderen</translation>
    </message>
    <message>
        <source>Remove edits of the body</source>
        <translation>Bewerkingen van het lichaam verwijderen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::AboutDialog</name>
    <message>
        <source>About Feltline</source>
        <translation>Over Feltline</translation>
    </message>
    <message>
        <source>Icon of Feltline</source>
        <translation>Pictogram van Feltline</translation>
    </message>
    <message>
        <source>Sketching that you can feel: ink that resists, lines that you correct by pulling and pushing.</source>
        <translation>Schetsen dat je kunt voelen: inkt die weerstand biedt, lijnen die je verbetert door te trekken en te duwen.</translation>
    </message>
    <message>
        <source>Based on an idea in this paper:</source>
        <translation>Gebaseerd op een idee uit dit artikel:</translation>
    </message>
    <message>
        <source>Built with Qt %1 and these libraries:</source>
        <translation>Gebouwd met Qt %1 en deze bibliotheken:</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0. It comes without any warranty.</source>
        <translation>Vrije software onder de Apache-licentie 2.0, zonder enige garantie.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::AnswerScale</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::BodyTools</name>
    <message>
        <source>Turn</source>
        <translation>Draaien</translation>
    </message>
    <message>
        <source>Drag to turn the body</source>
        <translation>Slepen draait het lichaam</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Snijden</translation>
    </message>
    <message>
        <source>Cuts the body along a stroke, and removes the part at its left</source>
        <translation>Snijdt het lichaam langs een streek en verwijdert het deel links ervan</translation>
    </message>
    <message>
        <source>Draw a line across the body, from beside it to beside it. What is at the left of the line goes away.</source>
        <translation>Trek een lijn dwars over het lichaam die ernaast begint en eindigt. Wat links van de lijn ligt, valt weg.</translation>
    </message>
    <message>
        <source>Extrude</source>
        <translation>Extruderen</translation>
    </message>
    <message>
        <source>Pulls a part out of the body: a closed line, then its profile</source>
        <translation>Trekt een deel uit het lichaam: een gesloten lijn, dan het profiel ervan</translation>
    </message>
    <message>
        <source>Draw a closed line on the body.</source>
        <translation>Teken een gesloten lijn op het lichaam.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Verven</translation>
    </message>
    <message>
        <source>Paints on the body, in the colour of the pen</source>
        <translation>Verft op het lichaam, in de kleur van de pen</translation>
    </message>
    <message>
        <source>Draw on the body.</source>
        <translation>Teken op het lichaam.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gladmaken</translation>
    </message>
    <message>
        <source>Smooths the body below a stroke, for example where it was cut</source>
        <translation>Maakt het lichaam onder een streek glad, bijvoorbeeld bij een snijrand</translation>
    </message>
    <message>
        <source>Draw over what should become smooth.</source>
        <translation>Teken over wat glad moet worden.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of the brush</source>
        <translation>Breedte van het penseel</translation>
    </message>
    <message>
        <source>Turn the body with the other mouse button or the arrow keys until you see the line from the side. Then draw the profile: from one side of the line over the tip to the other side.</source>
        <translation>Draai het lichaam met de andere muisknop of de pijltoetsen tot u de lijn van opzij ziet. Teken dan het profiel: van de ene kant van de lijn over de punt naar de andere kant.</translation>
    </message>
    <message>
        <source>The line is not closed.</source>
        <translation>De lijn is niet gesloten.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CalibrationDialog</name>
    <message>
        <source>Drawing plane of %1</source>
        <translation>Tekenvlak van %1</translation>
    </message>
    <message>
        <source>The corner to touch</source>
        <translation>De hoek die je moet aanraken</translation>
    </message>
    <message>
        <source>&amp;Use this position</source>
        <translation>Deze &amp;positie gebruiken</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>Op&amp;nieuw beginnen</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Bewaren</translation>
    </message>
    <message>
        <source>This is not a usable drawing area: %1. Start again with the upper left corner.</source>
        <translation>Dit is geen bruikbaar tekengebied: %1. Begin opnieuw met de hoek linksboven.</translation>
    </message>
    <message>
        <source>Hold the tip of the pen on the upper left corner of your drawing area.</source>
        <translation>Houd de punt van de pen op de hoek linksboven van het tekengebied.</translation>
    </message>
    <message>
        <source>Now hold it on the upper right corner.</source>
        <translation>Houd hem nu op de hoek rechtsboven.</translation>
    </message>
    <message>
        <source>Now hold it on the lower left corner.</source>
        <translation>Houd hem nu op de hoek linksonder.</translation>
    </message>
    <message>
        <source>The drawing area is %L1 mm wide and %L2 mm high.</source>
        <translation>Het tekengebied is %L1 mm breed en %L2 mm hoog.</translation>
    </message>
    <message>
        <source>Its corners agree to within %L1 mm.</source>
        <translation>De hoeken kloppen tot op %L1 mm.</translation>
    </message>
    <message>
        <source>The corner is not square: it is off by %L1 mm. Start again for a better result.</source>
        <translation>De hoek is niet haaks: de afwijking is %L1 mm. Begin opnieuw voor een beter resultaat.</translation>
    </message>
    <message>
        <source>The device does not answer. Check its cable and power.</source>
        <translation>Het apparaat antwoordt niet. Controleer de kabel en de voeding.</translation>
    </message>
    <message>
        <source>The pen is at %L1, %L2, %L3 mm.</source>
        <translation>De pen is op %L1, %L2, %L3 mm.</translation>
    </message>
    <message>
        <source>The pen is %L1 mm above the drawing plane.</source>
        <translation>De pen is %L1 mm boven het tekenvlak.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Canvas</name>
    <message>
        <source>Hold the pen against the body, and move along it. The pen draws nothing.</source>
        <translation>Houd de pen tegen het lichaam en beweeg erlangs. De pen tekent niets.</translation>
    </message>
    <message>
        <source>Drawing area</source>
        <translation>Tekengebied</translation>
    </message>
    <message>
        <source>The area to draw on</source>
        <translation>Het gebied om op te tekenen</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>gespiegeld</translation>
    </message>
    <message>
        <source>Pressure is recognised.</source>
        <translation>Druk wordt herkend.</translation>
    </message>
    <message>
        <source>No pressure recognised yet. A mouse draws lines of even width.</source>
        <translation>Nog geen druk herkend. Met een muis zijn lijnen overal even breed.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Right button: %1</source>
        <translation>Rechterknop: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CanvasPage</name>
    <message>
        <source>Show the &amp;force as an arrow</source>
        <translation>De &amp;kracht als pijl tonen</translation>
    </message>
    <message>
        <source>Shows the direction and strength of the force at the nib</source>
        <translation>Toont richting en sterkte van de kracht bij de punt</translation>
    </message>
    <message>
        <source>The &amp;nib moves with forces</source>
        <translation>De &amp;punt beweegt mee met krachten</translation>
    </message>
    <message>
        <source>With a mouse or a tablet, this makes forces visible</source>
        <translation>Maakt krachten zichtbaar bij gebruik van muis of tablet</translation>
    </message>
    <message>
        <source>Dry media show the &amp;grain of the surface</source>
        <translation>Droge tekenmiddelen tonen de k&amp;orrel van de ondergrond</translation>
    </message>
    <message>
        <source>Like chalk on paper. Exported outlines do not change</source>
        <translation>Zoals krijt op papier. Geëxporteerde omtrekken veranderen niet</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CanvasPopup</name>
    <message>
        <source>Palette at the pointer</source>
        <translation>Palet bij de aanwijzer</translation>
    </message>
    <message>
        <source>Recently used colours</source>
        <translation>Recent gebruikte kleuren</translation>
    </message>
    <message>
        <source>Paste &amp;here</source>
        <translation>&amp;Hier plakken</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ClipboardActions</name>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Knippen</translation>
    </message>
    <message>
        <source>Move the selected strokes to the clipboard</source>
        <translation>De geselecteerde lijnen naar het klembord verplaatsen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiëren</translation>
    </message>
    <message>
        <source>Copy the selected strokes, or all if none is selected</source>
        <translation>De geselecteerde lijnen kopiëren, of alle als er geen selectie is</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Plakken</translation>
    </message>
    <message>
        <source>Add the strokes from the clipboard</source>
        <translation>De lijnen van het klembord toevoegen</translation>
    </message>
    <message>
        <source>Copy as &amp;SVG</source>
        <translation>Kopiëren als &amp;SVG</translation>
    </message>
    <message>
        <source>Copy the selected strokes, or all, as an SVG drawing</source>
        <translation>De geselecteerde lijnen of alle als SVG kopiëren</translation>
    </message>
    <message>
        <source>Copy as &amp;picture</source>
        <translation>Kopiëren als &amp;afbeelding</translation>
    </message>
    <message>
        <source>Copy the selected strokes, or all, as a picture</source>
        <translation>De geselecteerde lijnen of alle als afbeelding kopiëren</translation>
    </message>
    <message>
        <source>Only whole strokes can be cut. Select a whole stroke first.</source>
        <translation>Alleen hele lijnen kunnen worden geknipt. Selecteer eerst een hele lijn.</translation>
    </message>
    <message>
        <source>The clipboard cannot be pasted</source>
        <translation>Het klembord kan niet worden geplakt</translation>
    </message>
    <message>
        <source>The clipboard holds no strokes.</source>
        <translation>Het klembord bevat geen lijnen.</translation>
    </message>
    <message>
        <source>the clipboard</source>
        <translation>het klembord</translation>
    </message>
    <message>
        <source>Paste &amp;in place</source>
        <translation>&amp;Op dezelfde plaats plakken</translation>
    </message>
    <message>
        <source>Add the strokes from the clipboard at their original position</source>
        <translation>Voegt de streken van het klembord op hun oorspronkelijke plaats toe</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Afbeelding</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ColorNotice</name>
    <message>
        <source>&amp;Use %1</source>
        <translation>%1 &amp;gebruiken</translation>
    </message>
    <message>
        <source>Use the colour %1</source>
        <translation>De kleur %1 gebruiken</translation>
    </message>
    <message>
        <source>The colour of the ink can hardly be seen on this page.</source>
        <translation>De kleur van de inkt is op deze pagina nauwelijks te zien.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ColorWell</name>
    <message>
        <source>Colour of the ink</source>
        <translation>Kleur van de inkt</translation>
    </message>
    <message>
        <source>Colour of the ink: %1</source>
        <translation>Kleur van de inkt: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ColorsPanel</name>
    <message>
        <source>Recent colours</source>
        <translation>Recente kleuren</translation>
    </message>
    <message>
        <source>Colours of the palette</source>
        <translation>Kleuren van het palet</translation>
    </message>
    <message>
        <source>Colour of new lines</source>
        <translation>Kleur van nieuwe lijnen</translation>
    </message>
    <message>
        <source>Colour code</source>
        <translation>Kleurcode</translation>
    </message>
    <message>
        <source>The colour as #rrggbb, #rgb or #rrggbbaa</source>
        <translation>De kleur als #rrggbb, #rgb of #rrggbbaa</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Dekking</translation>
    </message>
    <message>
        <source>Opacity: 0 % is transparent</source>
        <translation>Dekking: 0% is doorzichtig</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Palet</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>Paletten</translation>
    </message>
    <message>
        <source>The palette below</source>
        <translation>Het palet hieronder</translation>
    </message>
    <message>
        <source>Keep this colour in your own palette</source>
        <translation>Deze kleur in je eigen palet bewaren</translation>
    </message>
    <message>
        <source>&amp;Open a palette…</source>
        <translation>Palet &amp;openen…</translation>
    </message>
    <message>
        <source>&amp;Export this palette…</source>
        <translation>Dit palet &amp;exporteren…</translation>
    </message>
    <message>
        <source>Remove the &amp;colour from your palette</source>
        <translation>Kleur uit je ei&amp;gen palet verwijderen</translation>
    </message>
    <message>
        <source>Low contrast with the paper: %1:1</source>
        <translation>Weinig contrast met het papier: %1:1</translation>
    </message>
    <message>
        <source>Contrast with the paper: %1:1</source>
        <translation>Contrast met het papier: %1:1</translation>
    </message>
    <message>
        <source>My colours</source>
        <translation>Mijn kleuren</translation>
    </message>
    <message>
        <source>Open a palette</source>
        <translation>Palet openen</translation>
    </message>
    <message>
        <source>Palettes (*.gpl)</source>
        <translation>Paletten (*.gpl)</translation>
    </message>
    <message>
        <source>Export the palette</source>
        <translation>Palet exporteren</translation>
    </message>
</context>
<context>
    <name>felt::desktop::CuePlayer</name>
    <message>
        <source>%1 was disconnected. It continues when it is connected again.</source>
        <translation>%1 is losgekoppeld. Het gaat verder zodra het weer is aangesloten.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceCare</name>
    <message>
        <source>Find its &amp;home position…</source>
        <translation>&amp;Uitgangspositie zoeken…</translation>
    </message>
    <message>
        <source>&amp;Use it again</source>
        <translation>Weer &amp;gebruiken</translation>
    </message>
    <message>
        <source>When you connect it again it is used again, with its forces off.</source>
        <translation>Zodra het weer is aangesloten, wordt het weer gebruikt, met de krachten uit.</translation>
    </message>
    <message>
        <source>%1 is in use in another window.</source>
        <translation>%1 wordt in een ander venster gebruikt.</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>%1 kan niet worden geopend.</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>Opnieuw &amp;proberen</translation>
    </message>
    <message>
        <source>%1 is connected. It must find its home position before you can use it.</source>
        <translation>%1 is aangesloten. Het moet eerst zijn uitgangspositie vinden.</translation>
    </message>
    <message>
        <source>%1 is in use. Its forces are off until you switch them on.</source>
        <translation>%1 is in gebruik. De krachten blijven uit totdat je ze inschakelt.</translation>
    </message>
    <message>
        <source>Switch &amp;forces on</source>
        <translation>Krachten &amp;inschakelen</translation>
    </message>
    <message>
        <source>Message from %1: %2</source>
        <translation>Melding van %1: %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceNotice</name>
    <message>
        <source>Message from the device itself</source>
        <translation>Melding van het apparaat zelf</translation>
    </message>
    <message>
        <source>Message from the device: %1</source>
        <translation>Melding van het apparaat: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DevicePage</name>
    <message>
        <source>Senses pressure if the pen does. No motors.</source>
        <translation>Herkent druk als de pen dat doet. Geen motoren.</translation>
    </message>
    <message>
        <source>No motors.</source>
        <translation>Geen motoren.</translation>
    </message>
    <message>
        <source>Pushes with up to %L1 N, continuously with %L2 N. Loop of %L3 Hz.</source>
        <translation>Duwt met maximaal %L1 N, continu met %L2 N. Regellus van %L3 Hz.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Apparaat</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>The upper limit of all forces of this device</source>
        <translation>De bovengrens van alle krachten van dit apparaat</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Maximale kracht</translation>
    </message>
    <message>
        <source>&amp;Largest force</source>
        <translation>&amp;Maximale kracht</translation>
    </message>
    <message>
        <source>Forces stay off until you switch them on.</source>
        <translation>De krachten blijven uit totdat je ze inschakelt.</translation>
    </message>
    <message>
        <source>&amp;Use this device</source>
        <translation>Dit apparaat &amp;gebruiken</translation>
    </message>
    <message>
        <source>Vibrations</source>
        <translation>Trillingen</translation>
    </message>
    <message>
        <source>A haptic pen, mouse, touchpad or game controller that vibrates while you draw, with any pen</source>
        <translation>Een haptische pen, muis, touchpad of gamecontroller die trilt terwijl je tekent, met elke pen</translation>
    </message>
    <message>
        <source>&amp;Vibrations</source>
        <translation>&amp;Trillingen</translation>
    </message>
    <message>
        <source>In use; %1</source>
        <translation>In gebruik; %1</translation>
    </message>
    <message>
        <source>In use, forces off</source>
        <translation>In gebruik, krachten uit</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In gebruik</translation>
    </message>
    <message>
        <source>Not connected; used again once it is</source>
        <translation>Niet aangesloten; wordt weer gebruikt zodra het is aangesloten</translation>
    </message>
    <message>
        <source>In use in another window</source>
        <translation>In gebruik in een ander venster</translation>
    </message>
    <message>
        <source>Its software is installed; whether it is connected shows when you use it</source>
        <translation>De software is geïnstalleerd; of het is aangesloten blijkt bij gebruik</translation>
    </message>
    <message>
        <source>Connected; its settings cannot be read</source>
        <translation>Aangesloten; de instellingen zijn niet leesbaar</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Aangesloten</translation>
    </message>
    <message>
        <source>Connected; its drawing plane is not set yet</source>
        <translation>Aangesloten; het tekenvlak is nog niet ingesteld</translation>
    </message>
    <message>
        <source>Another haptic device…</source>
        <translation>Een ander haptisch apparaat…</translation>
    </message>
    <message>
        <source>A haptic device…</source>
        <translation>Een haptisch apparaat…</translation>
    </message>
    <message>
        <source>Not in the list? See what is missing, step by step</source>
        <translation>Niet in de lijst? Zie stap voor stap wat er ontbreekt</translation>
    </message>
    <message>
        <source>Correct that line, or remove the file.</source>
        <translation>Corrigeer die regel of verwijder het bestand.</translation>
    </message>
    <message>
        <source>Check its cable and power.</source>
        <translation>Controleer de kabel en de voeding.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1 (niet aangesloten)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceSettings</name>
    <message>
        <source>&amp;Set the drawing plane…</source>
        <translation>&amp;Tekenvlak instellen…</translation>
    </message>
    <message>
        <source>Fit to the p&amp;age</source>
        <translation>A&amp;an de pagina aanpassen</translation>
    </message>
    <message>
        <source>Name of the device</source>
        <translation>Naam van het apparaat</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechterhand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linkerhand</translation>
    </message>
    <message>
        <source>The hand that holds it</source>
        <translation>De hand die het vasthoudt</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>The upper limit of all forces of this device</source>
        <translation>De bovengrens van alle krachten van dit apparaat</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Maximale kracht</translation>
    </message>
    <message>
        <source>device limit</source>
        <translation>apparaatgrens</translation>
    </message>
    <message>
        <source> N/m</source>
        <translation> N/m</translation>
    </message>
    <message>
        <source>Lower this if the surface hums or trembles under the pen</source>
        <translation>Verlaag dit als de ondergrond onder de pen bromt of trilt</translation>
    </message>
    <message>
        <source>Stiffest surface</source>
        <translation>Maximale stijfheid</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>At 100 %, one millimetre of the hand is one millimetre of the page. At 200 % it is two.</source>
        <translation>Bij 100 % is één millimeter van de hand één millimeter op de pagina. Bij 200 % zijn het er twee.</translation>
    </message>
    <message>
        <source>Size of a movement on the page</source>
        <translation>Grootte van een beweging op de pagina</translation>
    </message>
    <message>
        <source>Centres the drawing area on the page and scales it so that the whole page can be reached</source>
        <translation>Centreert het tekengebied op de pagina en schaalt het zodat de hele pagina bereikbaar is</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Naam</translation>
    </message>
    <message>
        <source>&amp;Hand</source>
        <translation>&amp;Hand</translation>
    </message>
    <message>
        <source>&amp;Largest force</source>
        <translation>Ma&amp;ximale kracht</translation>
    </message>
    <message>
        <source>S&amp;tiffest surface</source>
        <translation>Maximale stij&amp;fheid</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>Tekenvlak</translation>
    </message>
    <message>
        <source>S&amp;ize on the page</source>
        <translation>Gr&amp;ootte op de pagina</translation>
    </message>
    <message>
        <source>Not set yet: the usual position of such a device is assumed.</source>
        <translation>Nog niet ingesteld: de gebruikelijke positie van zo’n apparaat wordt aangenomen.</translation>
    </message>
    <message>
        <source>Set: %L1 × %L2 mm.</source>
        <translation>Ingesteld: %L1 × %L2 mm.</translation>
    </message>
    <message>
        <source>Set.</source>
        <translation>Ingesteld.</translation>
    </message>
    <message>
        <source>Each hand has its own drawing plane, because the device stands on that side</source>
        <translation>Elke hand heeft een eigen tekenvlak, omdat het apparaat aan die kant staat</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DoctorDialog</name>
    <message>
        <source>Setting up a haptic device</source>
        <translation>Een haptisch apparaat instellen</translation>
    </message>
    <message>
        <source>A haptic device needs its maker&apos;s software and permission to use its port. Feltline has checked this computer. Work from top to bottom. A line with a dash is about a device that you may not own; ignore it then.</source>
        <translation>Een haptisch apparaat heeft de software van de fabrikant nodig en toestemming om de poort te gebruiken. Feltline heeft deze computer gecontroleerd. Werk van boven naar beneden. Een regel met een streepje gaat over een apparaat dat je misschien niet hebt; sla die dan over.</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Wat er is gevonden</translation>
    </message>
    <message>
        <source>&amp;Check again</source>
        <translation>&amp;Opnieuw controleren</translation>
    </message>
    <message>
        <source>&amp;Copy all</source>
        <translation>Alles &amp;kopiëren</translation>
    </message>
    <message>
        <source>Copies the report as plain text, to ask for help</source>
        <translation>Kopieert het rapport als platte tekst, om hulp te vragen</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Bezig met controleren…</translation>
    </message>
    <message>
        <source>This build of Feltline has no drivers.</source>
        <translation>Deze versie van Feltline is zonder stuurprogramma’s gebouwd.</translation>
    </message>
    <message>
        <source>Nothing to report.</source>
        <translation>Niets te melden.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ExportDialog</name>
    <message>
        <source>With the &amp;paper’s colour</source>
        <translation>Met de kleur van het &amp;papier</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>De pagina</translation>
    </message>
    <message>
        <source>The ink only</source>
        <translation>Alleen de inkt</translation>
    </message>
    <message>
        <source> dots per inch</source>
        <translation> punten per inch</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Voorbeeld</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formaat:</translation>
    </message>
    <message>
        <source>&amp;Show:</source>
        <translation>&amp;Tonen:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>&amp;Resolutie:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Grootte:</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporteren…</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message>
        <source>All strokes, exactly</source>
        <translation>Alle lijnen, exact</translation>
    </message>
    <message>
        <source>Keeps:</source>
        <translation>Bewaart:</translation>
    </message>
    <message>
        <source>&amp;Grain of the surface in dry media</source>
        <translation>&amp;Korrel van de ondergrond in droge tekenmiddelen</translation>
    </message>
    <message>
        <source>As on the screen. Lines stay editable; the grain is added as a picture</source>
        <translation>Zoals op het scherm. Lijnen blijven lijnen; de korrel wordt als afbeelding toegevoegd</translation>
    </message>
    <message>
        <source>Small file for &amp;web pages</source>
        <translation>Klein bestand voor &amp;webpagina’s</translation>
    </message>
    <message>
        <source>The selected lines</source>
        <translation>De geselecteerde lijnen</translation>
    </message>
    <message>
        <source>Only the visible ink, which other programs show but cannot edit as lines</source>
        <translation>Alleen de zichtbare inkt: andere programma’s tonen die, maar kunnen er geen lijnen van bewerken</translation>
    </message>
    <message>
        <source>The selected strokes, exactly</source>
        <translation>De geselecteerde streken, exact</translation>
    </message>
    <message>
        <source>The picture, for browsers. Feltline does not read the lines back.</source>
        <translation>De afbeelding, voor browsers. Feltline leest de lijnen niet terug.</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolutie</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Schaal</translation>
    </message>
    <message>
        <source>1× is 96 dots per inch, as on a screen of usual resolution</source>
        <translation>1× is 96 punten per inch, zoals op een scherm met gewone resolutie</translation>
    </message>
    <message>
        <source>P&amp;ictures to draw over</source>
        <translation>Afbeeld&amp;ingen om over te trekken</translation>
    </message>
    <message>
        <source>For s&amp;well paper</source>
        <translation>Voor &amp;zwelpapier</translation>
    </message>
    <message>
        <source>Black at true size, with lines at least 1 mm wide and textures instead of colours, for drawings that are read with the fingers</source>
        <translation>Zwart op ware grootte, met lijnen van ten minste 1 mm breed en patronen in plaats van kleuren, voor tekeningen die met de vingers worden gelezen</translation>
    </message>
    <message>
        <source>Black lines and textures that rise on swell paper.</source>
        <translation>Zwarte lijnen en patronen die op zwelpapier omhoog komen.</translation>
    </message>
    <message>
        <source>It cannot be made for swell paper: %1.</source>
        <translation>De tekening kan niet voor zwelpapier worden gemaakt: %1.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Eyedropper</name>
    <message>
        <source>&amp;Pick a colour</source>
        <translation>Kleur &amp;overnemen</translation>
    </message>
    <message>
        <source>Uses the colour of the line under the pen, or of the line that you click</source>
        <translation>Gebruikt de kleur van de lijn onder de pen, of van de lijn die u aanklikt</translation>
    </message>
    <message>
        <source>Pick colour, &amp;medium and width</source>
        <translation>Kleur, &amp;tekenmiddel en breedte overnemen</translation>
    </message>
    <message>
        <source>Draws on as the line under the pen, or as the line that you click</source>
        <translation>Tekent verder zoals de lijn onder de pen, of zoals de lijn die u aanklikt</translation>
    </message>
    <message>
        <source>There is no line or filled area under the pen.</source>
        <translation>Er is geen lijn of gevuld vlak onder de pen.</translation>
    </message>
    <message>
        <source>Click a line to use its colour. Escape ends this.</source>
        <translation>Klik op een lijn om de kleur ervan te gebruiken. Met Escape stopt u.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FeelPanel</name>
    <message>
        <source>Strength of all forces</source>
        <translation>Sterkte van alle krachten</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Strength of all forces in per cent</source>
        <translation>Sterkte van alle krachten in procenten</translation>
    </message>
    <message>
        <source>&amp;Strength</source>
        <translation>&amp;Sterkte</translation>
    </message>
    <message>
        <source>Surfac&amp;e</source>
        <translation>Ond&amp;ergrond</translation>
    </message>
    <message>
        <source>Stop forces</source>
        <translation>Krachten stoppen</translation>
    </message>
    <message>
        <source>Switch forces on</source>
        <translation>Krachten inschakelen</translation>
    </message>
    <message>
        <source>Stops all forces immediately (Esc twice)</source>
        <translation>Stopt alle krachten onmiddellijk (tweemaal Esc)</translation>
    </message>
    <message>
        <source>Let forces act on the pen</source>
        <translation>Krachten op de pen laten werken</translation>
    </message>
    <message>
        <source>Esc twice stops them too.</source>
        <translation>Ook tweemaal Esc stopt ze.</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bewerken…</translation>
    </message>
    <message>
        <source>Change how surfaces and media feel, look and sound</source>
        <translation>Wijzigen hoe ondergronden en tekenmiddelen aanvoelen, eruitzien en klinken</translation>
    </message>
    <message>
        <source>Edit surfaces and media</source>
        <translation>Ondergronden en tekenmiddelen bewerken</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FileActions</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Recent geopend</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nieuw</translation>
    </message>
    <message>
        <source>Start a new drawing</source>
        <translation>Een nieuwe tekening beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Openen…</translation>
    </message>
    <message>
        <source>Open a drawing from a file</source>
        <translation>Een tekening uit een bestand openen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Op&amp;slaan</translation>
    </message>
    <message>
        <source>Save the drawing to its file</source>
        <translation>De tekening in het bestand opslaan</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Opslaan &amp;als…</translation>
    </message>
    <message>
        <source>Save the drawing to another file</source>
        <translation>De tekening in een ander bestand opslaan</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importeren…</translation>
    </message>
    <message>
        <source>Add the strokes of another file to this drawing</source>
        <translation>De lijnen van een ander bestand aan deze tekening toevoegen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;luiten</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dit venster sluiten</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Afsluiten</translation>
    </message>
    <message>
        <source>Quit the program</source>
        <translation>Het programma afsluiten</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Naamloos</translation>
    </message>
    <message>
        <source>Open a drawing</source>
        <translation>Een tekening openen</translation>
    </message>
    <message>
        <source>“%1” cannot be opened</source>
        <translation>‘%1’ kan niet worden geopend</translation>
    </message>
    <message>
        <source>“%1” cannot be imported</source>
        <translation>‘%1’ kan niet worden geïmporteerd</translation>
    </message>
    <message>
        <source>Import strokes</source>
        <translation>Lijnen importeren</translation>
    </message>
    <message>
        <source>Save the drawing</source>
        <translation>De tekening opslaan</translation>
    </message>
    <message>
        <source>“%1” was not saved</source>
        <translation>‘%1’ is niet opgeslagen</translation>
    </message>
    <message>
        <source>%1
Your drawing is still open: save it to another place.</source>
        <translation>%1
Je tekening is nog open: sla haar op een andere plaats op.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Nog niets</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Deze lijst &amp;wissen</translation>
    </message>
    <message>
        <source>Recovered %1</source>
        <translation>%1 (hersteld)</translation>
    </message>
    <message>
        <source>No crash protection: save often</source>
        <translation>Geen crashbescherming: sla vaak op</translation>
    </message>
    <message>
        <source>The autosave cannot be written: %1</source>
        <translation>De automatische opslag kan niet worden geschreven: %1</translation>
    </message>
    <message>
        <source>Autosave in another place</source>
        <translation>Automatische opslag op een andere plaats</translation>
    </message>
    <message>
        <source>The drawing is autosaved in %1, because the usual place fails: %2</source>
        <translation>De tekening wordt automatisch opgeslagen in %1, omdat de gebruikelijke plaats niet werkt: %2</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Afbeelding</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FileDialogs</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Niet-opgeslagen wijzigingen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>De wijzigingen in ‘%1’ opslaan?</translation>
    </message>
    <message>
        <source>If you do not save, your changes since the last save are lost.</source>
        <translation>Als je niet opslaat, gaan je wijzigingen sinds de laatste keer opslaan verloren.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Op schijf gewijzigd</translation>
    </message>
    <message>
        <source>“%1” was changed by another program.</source>
        <translation>‘%1’ is door een ander programma gewijzigd.</translation>
    </message>
    <message>
        <source>If you save now, your drawing replaces those changes.</source>
        <translation>Als je nu opslaat, vervangt je tekening die wijzigingen.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Vervangen</translation>
    </message>
    <message>
        <source>Damaged drawing</source>
        <translation>Beschadigde tekening</translation>
    </message>
    <message>
        <source>“%1” is damaged.</source>
        <translation>‘%1’ is beschadigd.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) of it can be shown, as a new drawing; the file stays as it is.</source>
        <translation>
            <numerusform>%n lijn ervan kan als nieuwe tekening worden getoond; het bestand blijft zoals het is.</numerusform>
            <numerusform>%n lijnen ervan kunnen als nieuwe tekening worden getoond; het bestand blijft zoals het is.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Show the readable part</source>
        <translation>Leesbaar deel &amp;tonen</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Opslaan &amp;als…</translation>
    </message>
    <message>
        <source>Import a page</source>
        <translation>Een pagina importeren</translation>
    </message>
    <message>
        <source>Page of “%1” (1 to %2):</source>
        <translation>Pagina van ‘%1’ (1 tot %2):</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ForceGraph</name>
    <message>
        <source>Plot of the forces of the last seconds</source>
        <translation>Grafiek van de krachten van de laatste seconden</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nu</translation>
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
        <translation>De regellus draait niet.</translation>
    </message>
    <message>
        <source>Real-time scheduling.</source>
        <translation>Realtimeplanning.</translation>
    </message>
    <message>
        <source>Raised priority, no real-time scheduling.</source>
        <translation>Hogere prioriteit, geen realtimeplanning.</translation>
    </message>
    <message>
        <source>Ordinary scheduling: late if the computer is busy.</source>
        <translation>Normale planning: te laat als de computer het druk heeft.</translation>
    </message>
    <message>
        <source>The loop has stopped: the device does not answer.</source>
        <translation>De regellus staat stil: het apparaat antwoordt niet.</translation>
    </message>
    <message>
        <source>The device&apos;s own software runs the loop.</source>
        <translation>De regellus draait in de software van het apparaat.</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Krachten</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kracht</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nu</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Forces by name</source>
        <translation>Krachten op naam</translation>
    </message>
    <message>
        <source>Each force now and its maximum in the last seconds</source>
        <translation>Elke kracht nu en haar maximum in de laatste seconden</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Pause the plot</source>
        <translation>De grafiek pauzeren</translation>
    </message>
    <message>
        <source>maximum, %L1 N</source>
        <translation>maximaal, %L1 N</translation>
    </message>
    <message>
        <source>continuous, %L1 N</source>
        <translation>continu, %L1 N</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>The motors are warm, so forces are reduced for a while.</source>
        <translation>De motoren zijn warm, daarom zijn de krachten een tijdje verlaagd.</translation>
    </message>
    <message>
        <source>Loop: %L1 Hz, missed ticks: %L2</source>
        <translation>Regellus: %L1 Hz, gemiste tikken: %L2</translation>
    </message>
    <message>
        <source>Delay: usually %1, 1 in 100 %2</source>
        <translation>Vertraging: meestal %1, 1 op 100 %2</translation>
    </message>
    <message>
        <source>Motors: %L1 N on average</source>
        <translation>Motoren: gemiddeld %L1 N</translation>
    </message>
    <message>
        <source>Work on the hand: %L1 mJ</source>
        <translation>Arbeid op de hand: %L1 mJ</translation>
    </message>
    <message>
        <source>Requested: %L1 N, recently at most %L2 N. The table lists each force.</source>
        <translation>Gevraagd: %L1 N, onlangs hoogstens %L2 N. De tabel toont elke kracht.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Formats</name>
    <message>
        <source>Feltline drawing</source>
        <translation>Feltline-tekening</translation>
    </message>
    <message>
        <source>Everything, exactly.</source>
        <translation>Alles, exact.</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-tekening</translation>
    </message>
    <message>
        <source>The picture, for browsers, Inkscape and all that show SVG; Feltline reads lines, layers and page back exactly.</source>
        <translation>Het beeld, voor browsers, Inkscape en alles wat SVG toont; Feltline leest lijnen, lagen en pagina exact terug.</translation>
    </message>
    <message>
        <source>InkML ink</source>
        <translation>InkML-inkt</translation>
    </message>
    <message>
        <source>Lines with their widths, for programs that read InkML; Feltline reads lines, layers and page back exactly.</source>
        <translation>Lijnen met hun breedte voor programma’s die InkML lezen; Feltline leest lijnen, lagen en pagina exact terug.</translation>
    </message>
    <message>
        <source>Xournal++ notes</source>
        <translation>Xournal++-notities</translation>
    </message>
    <message>
        <source>Lines with their widths, in layers, for notes in Xournal++; curves become many short lines.</source>
        <translation>Lijnen met hun breedtes, in lagen, voor notities in Xournal++; krommen worden veel korte lijnen.</translation>
    </message>
    <message>
        <source>Strokes as lines of JSON</source>
        <translation>Lijnen als JSON-regels</translation>
    </message>
    <message>
        <source>Every visible line, exactly, for programs and scripts; no layers, page or surface.</source>
        <translation>Elke zichtbare lijn, exact, voor programma’s en scripts; geen lagen, pagina of ondergrond.</translation>
    </message>
    <message>
        <source>PDF page</source>
        <translation>PDF-pagina</translation>
    </message>
    <message>
        <source>A page to read and print, sharp at any size; it cannot be opened again.</source>
        <translation>Een pagina om te lezen en af te drukken, scherp op elke grootte; ze kan niet opnieuw worden geopend.</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-afbeelding</translation>
    </message>
    <message>
        <source>A picture of pixels at the resolution you choose; it cannot be opened again.</source>
        <translation>Een beeld van pixels in de gekozen resolutie; het kan niet opnieuw worden geopend.</translation>
    </message>
    <message>
        <source>All drawings</source>
        <translation>Alle tekeningen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::GeneralPage</name>
    <message>
        <source>Same as the desktop</source>
        <translation>Zoals de werkomgeving</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Donker</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Taal</translation>
    </message>
    <message>
        <source>The new language is used from the next start.</source>
        <translation>De nieuwe taal geldt vanaf de volgende start.</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Thema:</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>T&amp;aal:</translation>
    </message>
    <message>
        <source>At startup:</source>
        <translation>Bij het starten:</translation>
    </message>
    <message>
        <source>&amp;Open the last drawing again</source>
        <translation>De laatste tekening &amp;weer openen</translation>
    </message>
    <message>
        <source>If no file is given</source>
        <translation>Als er geen bestand is opgegeven</translation>
    </message>
    <message>
        <source>So&amp;und of drawing</source>
        <translation>&amp;Geluid bij het tekenen</translation>
    </message>
    <message>
        <source>Hear the pen rub on the surface</source>
        <translation>De pen over de ondergrond horen wrijven</translation>
    </message>
    <message>
        <source>Volume of the sound of drawing</source>
        <translation>Volume van het geluid bij het tekenen</translation>
    </message>
    <message>
        <source>Sound:</source>
        <translation>Geluid:</translation>
    </message>
    <message>
        <source>&amp;Volume:</source>
        <translation>&amp;Volume:</translation>
    </message>
</context>
<context>
    <name>felt::desktop::GuideDialog</name>
    <message>
        <source>Guide</source>
        <translation>Handleiding</translation>
    </message>
    <message>
        <source>Draw, then correct</source>
        <translation>Tekenen, dan corrigeren</translation>
    </message>
    <message>
        <source>Draw with a pen or with the mouse. You do not need to redraw a line that is not right: pull it, push it, smooth it, make it broader. You can undo every step.</source>
        <translation>Teken met een pen of met de muis. Een lijn die niet klopt, hoef je niet opnieuw te tekenen: trek eraan, duw ertegen, strijk hem glad of maak hem breder. Elke stap kun je ongedaan maken.</translation>
    </message>
    <message>
        <source>Press a tool&apos;s key briefly to choose the tool. Hold the key to use the tool only until you release it.</source>
        <translation>Druk kort op de toets van een gereedschap om het te kiezen. Houd de toets ingedrukt om het alleen tot het loslaten te gebruiken.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>Het beeld</translation>
    </message>
    <message>
        <source>The wheel zooms at the pointer. Hold Space and drag to move the view, with Shift to turn it. None of this changes the drawing.</source>
        <translation>Het muiswiel zoomt bij de aanwijzer. Houd de spatiebalk ingedrukt en sleep om het beeld te verschuiven, met Shift om het te draaien. Niets daarvan verandert de tekening.</translation>
    </message>
    <message>
        <source>The feel</source>
        <translation>Het gevoel</translation>
    </message>
    <message>
        <source>Every tool resists. With a force-feedback pen you feel this in your hand. With a tablet or a mouse you see it: as an arrow at the nib and in the panel Forces. Press Esc twice to switch off all forces immediately.</source>
        <translation>Elk gereedschap biedt weerstand. Met een forcefeedbackpen voel je die in je hand. Met een tablet of muis zie je hem: als pijl bij de punt en in het paneel Krachten. Druk tweemaal op Esc om alle krachten onmiddellijk uit te schakelen.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Drawings are saved as .felt files, with their layers and pen pressure. You can export SVG, PDF and PNG for other programs.</source>
        <translation>Tekeningen worden als .felt-bestanden opgeslagen, met hun lagen en pendruk. Voor andere programma’s kun je SVG, PDF en PNG exporteren.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HapticLoop</name>
    <message>
        <source>%1 stopped responding and was disconnected. Your drawing is safe. Restart Feltline to use it again.</source>
        <translation>%1 reageert niet meer en is losgekoppeld. Je tekening is veilig. Start Feltline opnieuw om het weer te gebruiken.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HelpActions</name>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Handleiding</translation>
    </message>
    <message>
        <source>What the tools do, on one page</source>
        <translation>Wat de gereedschappen doen, op één pagina</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>Snel&amp;toetsen</translation>
    </message>
    <message>
        <source>All shortcuts on one page, to search and to print</source>
        <translation>Alle sneltoetsen op één pagina, om te zoeken en af te drukken</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>&amp;Rondleiding</translation>
    </message>
    <message>
        <source>A two-minute demonstration of the tools</source>
        <translation>Een demonstratie van de gereedschappen in twee minuten</translation>
    </message>
    <message>
        <source>Opens this drawing, made by the project&apos;s simulated hand</source>
        <translation>Opent deze tekening van de gesimuleerde hand</translation>
    </message>
    <message>
        <source>&amp;About Feltline</source>
        <translation>&amp;Over Feltline</translation>
    </message>
    <message>
        <source>Version, licence and libraries</source>
        <translation>Versie, licentie en bibliotheken</translation>
    </message>
    <message>
        <source>From the tour</source>
        <translation>Uit de rondleiding</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HistoryModel</name>
    <message>
        <source>Earlier steps are no longer available</source>
        <translation>Eerdere stappen zijn niet meer beschikbaar</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Zoals geopend</translation>
    </message>
    <message>
        <source>%1, current</source>
        <translation>%1, huidige</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, ongedaan gemaakt</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HistoryPanel</name>
    <message>
        <source>One step back</source>
        <translation>Eén stap terug</translation>
    </message>
    <message>
        <source>One step forward</source>
        <translation>Eén stap vooruit</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stappen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HomingDialog</name>
    <message>
        <source>Home position of %1</source>
        <translation>Uitgangspositie van %1</translation>
    </message>
    <message>
        <source>Finding the home position</source>
        <translation>Uitgangspositie wordt gezocht</translation>
    </message>
    <message>
        <source>Let it &amp;move</source>
        <translation>Be&amp;weging toestaan</translation>
    </message>
    <message>
        <source>It is &amp;in place</source>
        <translation>Het staat op &amp;zijn plaats</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Niet nu</translation>
    </message>
    <message>
        <source>Allow its arm to move by itself?</source>
        <translation>Mag de arm uit zichzelf bewegen?</translation>
    </message>
    <message>
        <source>%1 moves its arm to find its home position: for a few seconds, over its whole reach, with the force that it needs. Let go of the arm, clear the space around it, and keep hair, sleeves and cups away. You can stop it at any time with its power switch.</source>
        <translation>%1 beweegt zijn arm om de uitgangspositie te vinden: enkele seconden, over het hele bereik, met de kracht die nodig is. Laat de arm los, maak er ruimte omheen en houd haar, mouwen en kopjes weg. Met de aan-uitschakelaar kun je hem op elk moment stoppen.</translation>
    </message>
    <message>
        <source>Bring the arm to its rest pose</source>
        <translation>Breng de arm in de ruststand</translation>
    </message>
    <message>
        <source>%1 uses its rest pose as its home position. Nothing moves by itself.</source>
        <translation>%1 gebruikt de ruststand als uitgangspositie. Niets beweegt uit zichzelf.</translation>
    </message>
    <message>
        <source>Put the stylus into the inkwell</source>
        <translation>Zet de stylus in de inktpot</translation>
    </message>
    <message>
        <source>%1 finds its position while its stylus is in the inkwell, the hole in its base. Nothing moves by itself.</source>
        <translation>%1 bepaalt zijn positie terwijl de stylus in de inktpot staat, het gat in de voet. Niets beweegt uit zichzelf.</translation>
    </message>
    <message>
        <source>It is moving: keep your hands away</source>
        <translation>Het beweegt: houd je handen weg</translation>
    </message>
    <message>
        <source>Hold it still for a moment</source>
        <translation>Houd het even stil</translation>
    </message>
    <message>
        <source>It did not find its home position. Try again.</source>
        <translation>Het heeft zijn uitgangspositie niet gevonden. Probeer het opnieuw.</translation>
    </message>
    <message>
        <source>This failed: %1</source>
        <translation>Mislukt: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HueStrip</name>
    <message>
        <source>Hue</source>
        <translation>Tint</translation>
    </message>
    <message>
        <source>Hue. Change it with the arrow keys.</source>
        <translation>Tint. Wijzig met de pijltoetsen.</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 graden</translation>
    </message>
</context>
<context>
    <name>felt::desktop::KeyEdit</name>
    <message>
        <source>Press a key</source>
        <translation>Druk op een toets</translation>
    </message>
</context>
<context>
    <name>felt::desktop::KeyboardPen</name>
    <message>
        <source>Cancelled; the pen is up</source>
        <translation>Afgebroken; de pen is opgetild</translation>
    </message>
    <message>
        <source>The pen is down</source>
        <translation>De pen is neer</translation>
    </message>
    <message>
        <source>The pen is up</source>
        <translation>De pen is opgetild</translation>
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
        <translation>zichtbaar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>vergrendeld</translation>
    </message>
    <message>
        <source>unlocked</source>
        <translation>niet vergrendeld</translation>
    </message>
    <message>
        <source>, current</source>
        <translation>, huidig</translation>
    </message>
    <message>
        <source>%1
Double-click to rename, drag to move</source>
        <translation>%1
Dubbelklik om te hernoemen, sleep om te verplaatsen</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Inkt</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Laag %1</translation>
    </message>
    <message>
        <source>, picture</source>
        <translation>, afbeelding</translation>
    </message>
    <message>
        <source>, opacity %1 %</source>
        <translation>, dekking %1 %</translation>
    </message>
    <message>
        <source>, multiplies</source>
        <translation>, vermenigvuldigt</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Groep %1</translation>
    </message>
    <message>
        <source>, in the group %1</source>
        <translation>, in de groep %1</translation>
    </message>
    <message>
        <source>%1 (group), %2, %3, %4</source>
        <translation>%1 (groep), %2, %3, %4</translation>
    </message>
    <message>
        <source>collapsed</source>
        <translation>ingeklapt</translation>
    </message>
    <message>
        <source>expanded</source>
        <translation>uitgeklapt</translation>
    </message>
    <message>
        <source>%1
Double-click to rename, drag to move, drag layers into it</source>
        <translation>%1
Dubbelklik om te hernoemen, sleep om te verplaatsen, sleep lagen erin</translation>
    </message>
    <message>
        <source>, hidden by its group</source>
        <translation>, verborgen door zijn groep</translation>
    </message>
    <message>
        <source>, locked by its group</source>
        <translation>, vergrendeld door zijn groep</translation>
    </message>
</context>
<context>
    <name>felt::desktop::LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Add a layer</source>
        <translation>Een laag toevoegen</translation>
    </message>
    <message>
        <source>Raise the layer</source>
        <translation>De laag omhoog</translation>
    </message>
    <message>
        <source>Moves the layer up by one</source>
        <translation>Verplaatst de laag één omhoog</translation>
    </message>
    <message>
        <source>Lower the layer</source>
        <translation>De laag omlaag</translation>
    </message>
    <message>
        <source>Moves the layer down by one</source>
        <translation>Verplaatst de laag één omlaag</translation>
    </message>
    <message>
        <source>Remove the layer</source>
        <translation>De laag verwijderen</translation>
    </message>
    <message>
        <source>Removes the layer and its lines</source>
        <translation>Verwijdert de laag en de lijnen erop</translation>
    </message>
    <message>
        <source>All layers were hidden or locked, so “%1” was added to draw on.</source>
        <translation>Alle lagen waren verborgen of vergrendeld, daarom is ‘%1’ toegevoegd om op te tekenen.</translation>
    </message>
    <message>
        <source>Duplicate the layer</source>
        <translation>De laag dupliceren</translation>
    </message>
    <message>
        <source>A copy of this layer above it</source>
        <translation>Een kopie van deze laag erboven</translation>
    </message>
    <message>
        <source>Merge the layer with the one below</source>
        <translation>De laag met de laag eronder samenvoegen</translation>
    </message>
    <message>
        <source>Moves the lines to the layer below</source>
        <translation>Verplaatst de lijnen naar de laag eronder</translation>
    </message>
    <message>
        <source>&amp;Opacity:</source>
        <translation>&amp;Dekking:</translation>
    </message>
    <message>
        <source>Opacity of the layer</source>
        <translation>Dekking van de laag</translation>
    </message>
    <message>
        <source>&amp;Blend mode:</source>
        <translation>&amp;Mengmodus:</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normaal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Vermenigvuldigen</translation>
    </message>
    <message>
        <source>Blend mode of the layer</source>
        <translation>Mengmodus van de laag</translation>
    </message>
    <message>
        <source>Multiply makes what is below darker, for shading on line art</source>
        <translation>Vermenigvuldigen maakt donkerder wat eronder ligt: voor schaduw op lijnen</translation>
    </message>
    <message>
        <source>A new layer above the current one</source>
        <translation>Een nieuwe laag boven de huidige</translation>
    </message>
    <message>
        <source>Removes the group, its layers and their lines</source>
        <translation>Verwijdert de groep, de lagen erin en hun lijnen</translation>
    </message>
    <message>
        <source>The group “%1”</source>
        <translation>De groep ‘%1’</translation>
    </message>
    <message>
        <source>“%1”</source>
        <comment>a layer</comment>
        <translation>‘%1’</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it to draw there.</source>
        <translation>%1 is vergrendeld. Ontgrendel hem om daar te tekenen.</translation>
    </message>
    <message>
        <source>%1 is hidden. Show it to draw there.</source>
        <translation>%1 is verborgen. Maak hem zichtbaar om daar te tekenen.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MainWindow</name>
    <message>
        <source>Shows or hides the panel %1</source>
        <translation>Toont of verbergt het paneel %1</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Opties</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Gevoel</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Kleuren</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Geschiedenis</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Krachten</translation>
    </message>
    <message>
        <source>&amp;Hide all panels</source>
        <translation>Alle panelen &amp;verbergen</translation>
    </message>
    <message>
        <source>Shows only the drawing area</source>
        <translation>Toont alleen het tekengebied</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Volledig &amp;scherm</translation>
    </message>
    <message>
        <source>The window fills the screen</source>
        <translation>Het venster vult het scherm</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Volge&amp;nd deel van het venster</translation>
    </message>
    <message>
        <source>Moves the focus from the drawing area to the tools, to each panel, and back</source>
        <translation>Verplaatst de focus van het tekengebied naar het gereedschap, naar elk paneel en terug</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>Panelen &amp;herstellen</translation>
    </message>
    <message>
        <source>Restores the default layout of panels and bars</source>
        <translation>Herstelt de standaardindeling van panelen en balken</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Voorkeuren…</translation>
    </message>
    <message>
        <source>Theme, language, pen, device and shortcuts</source>
        <translation>Thema, taal, pen, apparaat en sneltoetsen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;luiten</translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation>Sluit dit venster</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Afsluiten</translation>
    </message>
    <message>
        <source>Closes all windows</source>
        <translation>Sluit alle vensters</translation>
    </message>
    <message>
        <source>Some of your materials could not be read:</source>
        <translation>Sommige van je materialen konden niet worden gelezen:</translation>
    </message>
    <message>
        <source>Ma&amp;terials…</source>
        <translation>Ma&amp;terialen…</translation>
    </message>
    <message>
        <source>Change how surfaces and media feel, look and sound, and make your own</source>
        <translation>Wijzigen hoe ondergronden en tekenmiddelen aanvoelen, eruitzien en klinken, en eigen maken</translation>
    </message>
    <message>
        <source>&amp;Compare materials A and B</source>
        <translation>Materialen A en B &amp;vergelijken</translation>
    </message>
    <message>
        <source>Switch between the two materials that the editor compares</source>
        <translation>Wisselen tussen de twee materialen die de editor vergelijkt</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (alleen-lezen)</translation>
    </message>
    <message>
        <source>Tactile check</source>
        <translation>Tastcontrole</translation>
    </message>
    <message>
        <source>Solid view</source>
        <translation>Lichaamsweergave</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Beweging</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialEditor</name>
    <message>
        <source>Materials</source>
        <translation>Materialen</translation>
    </message>
    <message>
        <source>S&amp;tart from:</source>
        <translation>Ui&amp;tgaan van:</translation>
    </message>
    <message>
        <source>Use the values of another material</source>
        <translation>De waarden van een ander materiaal gebruiken</translation>
    </message>
    <message>
        <source>Sets all values to those of another material; you can then change them</source>
        <translation>Zet alle waarden op die van een ander materiaal; daarna kun je ze wijzigen</translation>
    </message>
    <message>
        <source>Values of…</source>
        <translation>Waarden van…</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Waarden</translation>
    </message>
    <message>
        <source>Relief from a picture…</source>
        <translation>Reliëf uit een afbeelding…</translation>
    </message>
    <message>
        <source>A PNG of 8 or 16 bits; white is high. It is scaled to a square of 32 grain wavelengths and repeats seamlessly</source>
        <translation>Een PNG van 8 of 16 bits; wit is hoog. Het wordt geschaald naar een vierkant van 32 golflengten van de korrel en herhaalt zich naadloos</translation>
    </message>
    <message>
        <source>Light, firm, hard</source>
        <translation>Licht, stevig, hard</translation>
    </message>
    <message>
        <source>What a stroke feels like</source>
        <translation>Hoe een streek aanvoelt</translation>
    </message>
    <message>
        <source>Hatched: changes below 0.04 N, which are too small to feel.</source>
        <translation>Gearceerd: veranderingen onder 0,04 N, te klein om te voelen.</translation>
    </message>
    <message>
        <source>Forces on the pen now</source>
        <translation>Krachten op de pen nu</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultaat</translation>
    </message>
    <message>
        <source>Comes with Feltline. Changing it makes your own copy.</source>
        <translation>Hoort bij Feltline. Een wijziging maakt een eigen kopie.</translation>
    </message>
    <message>
        <source>Your own, not saved to a file yet. Feltline remembers it.</source>
        <translation>Eigen materiaal, nog niet in een bestand opgeslagen. Feltline onthoudt het.</translation>
    </message>
    <message>
        <source>Your own, saved.</source>
        <translation>Eigen materiaal, opgeslagen.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Ongedaan maken: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Opnieuw: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Compare: A = B</source>
        <translation>Vergelijken: A = B</translation>
    </message>
    <message>
        <source>Compare: %1</source>
        <translation>Vergelijken: %1</translation>
    </message>
    <message>
        <source>You feel, see and hear %1. Press B for %2.</source>
        <translation>Je voelt, ziet en hoort %1. Druk op B voor %2.</translation>
    </message>
    <message>
        <source>Copy %1 to %2</source>
        <translation>%1 naar %2 kopiëren</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>Restores all values as they were at first, or when last saved</source>
        <translation>Herstelt alle waarden zoals aan het begin, of zoals laatst opgeslagen</translation>
    </message>
    <message>
        <source>Copies these values to the other material</source>
        <translation>Kopieert deze waarden naar het andere materiaal</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Save to your own file</source>
        <translation>Als eigen bestand opslaan</translation>
    </message>
    <message>
        <source>%1 was saved.</source>
        <translation>%1 is opgeslagen.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Opslaan als…</translation>
    </message>
    <message>
        <source>Save under another name, as your own</source>
        <translation>Onder een andere naam als eigen opslaan</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Hernoemen…</translation>
    </message>
    <message>
        <source>Changes the name</source>
        <translation>Wijzigt de naam</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Deletes the material and its file; undo restores both</source>
        <translation>Verwijdert het materiaal en het bestand; ongedaan maken herstelt beide</translation>
    </message>
    <message>
        <source>%1 was deleted. Undo restores it.</source>
        <translation>%1 is verwijderd. Ongedaan maken herstelt het.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importeren…</translation>
    </message>
    <message>
        <source>Add a material from a file</source>
        <translation>Een materiaal uit een bestand toevoegen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporteren…</translation>
    </message>
    <message>
        <source>Write a file to share</source>
        <translation>Een bestand schrijven om te delen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Meer</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Meer opdrachten</translation>
    </message>
    <message>
        <source>Relief from a picture</source>
        <translation>Reliëf uit een afbeelding</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Afbeeldingen (*.png)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Opslaan als</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Naam:</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importeren</translation>
    </message>
    <message>
        <source>Materials (*.toml)</source>
        <translation>Materialen (*.toml)</translation>
    </message>
    <message>
        <source>It is yours now, but not saved yet.</source>
        <translation>Het is nu van jou, maar nog niet opgeslagen.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>%1 was exported.</source>
        <translation>%1 is geëxporteerd.</translation>
    </message>
    <message>
        <source>Comes with this drawing. Changing it makes your own copy.</source>
        <translation>Hoort bij deze tekening. Een wijziging maakt een eigen kopie.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialEditorModel</name>
    <message>
        <source>Values of %1</source>
        <translation>Waarden van %1</translation>
    </message>
    <message>
        <source>Relief of a picture</source>
        <translation>Reliëf van een afbeelding</translation>
    </message>
    <message>
        <source>Friction of a pair</source>
        <translation>Wrijving van een paar</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>%1 (custom)</source>
        <translation>%1 (eigen)</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>Kopie van %1</translation>
    </message>
    <message>
        <source>Copy %1 to %2</source>
        <translation>%1 naar %2 kopiëren</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Opslaan als %1</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importeren</translation>
    </message>
    <message>
        <source>Shape of the style</source>
        <translation>Vorm van de stijl</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialFieldsView</name>
    <message>
        <source>New seed</source>
        <translation>Nieuwe startwaarde</translation>
    </message>
    <message>
        <source>Chooses another seed</source>
        <translation>Kiest een andere startwaarde</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Algemeen</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Gevoel</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Korrel</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Lijn</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Uiterlijk</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Geluid</translation>
    </message>
    <message>
        <source>Style of lines</source>
        <translation>Stijl van lijnen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialList</name>
    <message>
        <source>Surfaces and media</source>
        <translation>Ondergronden en tekenmiddelen</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Ondergronden</translation>
    </message>
    <message>
        <source>My surfaces</source>
        <translation>Eigen ondergronden</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>Tekenmiddelen</translation>
    </message>
    <message>
        <source>My media</source>
        <translation>Eigen tekenmiddelen</translation>
    </message>
    <message>
        <source>%1 • not saved</source>
        <translation>%1 • niet opgeslagen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MediaPicker</name>
    <message>
        <source>Drawing medium</source>
        <translation>Tekenmiddel</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MessageBar</name>
    <message>
        <source>&amp;Details</source>
        <translation>&amp;Details</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Deze melding sluiten</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MessageScreen</name>
    <message>
        <source>or press Space</source>
        <translation>of druk op de spatiebalk</translation>
    </message>
</context>
<context>
    <name>felt::desktop::NoticeBar</name>
    <message>
        <source>Unsupported content, and its line</source>
        <translation>Niet-ondersteunde inhoud, met regel</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultaat</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Aantal</translation>
    </message>
    <message>
        <source>Some content of “%1” is not supported. Skipped or changed: %2. The file itself is unchanged.</source>
        <translation>Sommige inhoud van ‘%1’ wordt niet ondersteund. Overgeslagen of gewijzigd: %2. Het bestand zelf is ongewijzigd.</translation>
    </message>
    <message>
        <source>&amp;Open the folder</source>
        <translation>Map &amp;openen</translation>
    </message>
    <message>
        <source>“%1” was exported to “%2”.</source>
        <translation>‘%1’ is geëxporteerd naar ‘%2’.</translation>
    </message>
    <message>
        <source>Left out, because the format has no fills: %1.</source>
        <translation>Weggelaten, omdat het formaat geen vullingen heeft: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no pictures to draw over: %1.</source>
        <translation>Weggelaten, omdat het formaat geen afbeeldingen om over te trekken heeft: %1.</translation>
    </message>
    <message>
        <source>Blend modes that became normal: %1.</source>
        <translation>Mengmodi die normaal werden: %1.</translation>
    </message>
    <message>
        <source>Groups of layers that were dissolved: %1.</source>
        <translation>Opgeheven groepen van lagen: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no timings of key drawings: %1.</source>
        <translation>Weggelaten, omdat het formaat geen timing van sleuteltekeningen heeft: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no edits of the body: %1.</source>
        <translation>Weggelaten, omdat het formaat geen bewerkingen van het lichaam heeft: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no guides: %1.</source>
        <translation>Weggelaten, omdat het formaat geen hulplijnen heeft: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no symmetry groups: %1.</source>
        <translation>Weggelaten, omdat het formaat geen symmetriegroepen heeft: %1.</translation>
    </message>
    <message>
        <source>Layers or groups whose opacity became that of each line: %1.</source>
        <translation>Lagen of groepen waarvan de dekking op elke lijn overging: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no layers: %1.</source>
        <translation>Weggelaten, omdat het formaat geen lagen heeft: %1.</translation>
    </message>
    <message>
        <source>Locked layers that became unlocked: %1.</source>
        <translation>Vergrendelde lagen die ontgrendeld werden: %1.</translation>
    </message>
    <message>
        <source>Lines of hidden layers that were left out: %1.</source>
        <translation>Weggelaten lijnen van verborgen lagen: %1.</translation>
    </message>
    <message>
        <source>Lines of hidden layers that became visible: %1.</source>
        <translation>Lijnen van verborgen lagen die zichtbaar werden: %1.</translation>
    </message>
    <message>
        <source>Lines whose medium became a plain pen: %1.</source>
        <translation>Lijnen waarvan het medium een gewone pen werd: %1.</translation>
    </message>
    <message>
        <source>Left out, because the format has no custom materials: %1.</source>
        <translation>Weggelaten, omdat het formaat geen eigen materialen heeft: %1.</translation>
    </message>
    <message>
        <source>Lines whose flat ends and pointed corners became round: %1.</source>
        <translation>Lijnen waarvan de vlakke uiteinden en puntige hoeken rond werden: %1.</translation>
    </message>
    <message>
        <source>Names of lines that became numbers: %1.</source>
        <translation>Namen van lijnen die nummers werden: %1.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OfferPopup</name>
    <message>
        <source>Key: %1</source>
        <translation>Toets: %1</translation>
    </message>
    <message>
        <source>This stroke can be: %1</source>
        <translation>Deze haal kan zijn: %1</translation>
    </message>
    <message>
        <source>Press harder, or hold the mouse still:</source>
        <translation>Druk harder, of houd de muis stil:</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OptionRow</name>
    <message>
        <source>Reset %1</source>
        <translation>%1 herstellen</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Terug naar %1</translation>
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
        <translation>Herstelt alle opties van dit gereedschap naar de standaardwaarden</translation>
    </message>
    <message>
        <source>Reset the tool</source>
        <translation>Gereedschap herstellen</translation>
    </message>
    <message>
        <source>Options of the tool</source>
        <translation>Opties van het gereedschap</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Gevoel</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Meer</translation>
    </message>
    <message>
        <source>Options that are rarely needed</source>
        <translation>Opties die zelden nodig zijn</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OutputActions</name>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporteren…</translation>
    </message>
    <message>
        <source>Pa&amp;ge setup…</source>
        <translation>Pa&amp;gina-instelling…</translation>
    </message>
    <message>
        <source>Size, orientation and colour of the page</source>
        <translation>Grootte, oriëntatie en kleur van de pagina</translation>
    </message>
    <message>
        <source>Print pre&amp;view…</source>
        <translation>Afdrukvoor&amp;beeld…</translation>
    </message>
    <message>
        <source>Shows what will be printed</source>
        <translation>Toont wat er wordt afgedrukt</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Af&amp;drukken…</translation>
    </message>
    <message>
        <source>Prints the page at its true size</source>
        <translation>Drukt de pagina op ware grootte af</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>“%1” was not exported</source>
        <translation>‘%1’ is niet geëxporteerd</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Afdrukken</translation>
    </message>
    <message>
        <source>“%1” was not printed</source>
        <translation>‘%1’ is niet afgedrukt</translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation>Afdrukvoorbeeld</translation>
    </message>
    <message>
        <source>Export the drawing as SVG, PDF, PNG or ink for other programs</source>
        <translation>De tekening als SVG, PDF, PNG of inkt voor andere programma’s exporteren</translation>
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
        <translation>&amp;Staand</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>&amp;Liggend</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Geen</translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation>Pagina-instelling</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Aangepast</translation>
    </message>
    <message>
        <source>No paper: transparent in exported pictures</source>
        <translation>Geen papier: doorzichtig in geëxporteerde afbeeldingen</translation>
    </message>
    <message>
        <source>Colour of the paper</source>
        <translation>Kleur van het papier</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Grootte:</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>&amp;Breedte:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>&amp;Hoogte:</translation>
    </message>
    <message>
        <source>Orientation:</source>
        <translation>Oriëntatie:</translation>
    </message>
    <message>
        <source>Paper:</source>
        <translation>Papier:</translation>
    </message>
    <message>
        <source>No paper</source>
        <translation>Geen papier</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PairTable</name>
    <message>
        <source>Friction on each surface</source>
        <translation>Wrijving op elke ondergrond</translation>
    </message>
    <message>
        <source>Bold numbers are specific to this medium and surface</source>
        <translation>Vette getallen gelden alleen voor dit tekenmiddel op deze ondergrond</translation>
    </message>
    <message>
        <source>Double-click a number, or press F2, to set the friction on that surface</source>
        <translation>Dubbelklik op een getal, of druk op F2, om de wrijving op die ondergrond in te stellen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Ondergrond</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation>Standaard gebruiken</translation>
    </message>
    <message>
        <source>Uses the friction of the medium times that of the surface</source>
        <translation>Gebruikt de wrijving van het tekenmiddel maal die van de ondergrond</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PenInput</name>
    <message>
        <source>Pressure is switched off.</source>
        <translation>Druk is uitgeschakeld.</translation>
    </message>
    <message>
        <source>The pressure of your pen is recognised.</source>
        <translation>De druk van je pen wordt herkend.</translation>
    </message>
    <message>
        <source>Your pen senses no pressure.</source>
        <translation>Je pen herkent geen druk.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PenTestArea</name>
    <message>
        <source>Test area</source>
        <translation>Testgebied</translation>
    </message>
    <message>
        <source>Scribble here to try the pen. The scribbles are not kept.</source>
        <translation>Krabbel hier om de pen te proberen. De krabbels worden niet bewaard.</translation>
    </message>
    <message>
        <source>Scribble here to try your pen</source>
        <translation>Krabbel hier om je pen te proberen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PensPage</name>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druk</translation>
    </message>
    <message>
        <source>&amp;Pressing harder draws wider</source>
        <translation>Harder &amp;drukken tekent breder</translation>
    </message>
    <message>
        <source>If off, every line has the same width, however hard you press.</source>
        <translation>Indien uit, is elke lijn even breed, hoe hard je ook drukt.</translation>
    </message>
    <message>
        <source>&amp;Soft</source>
        <translation>&amp;Zacht</translation>
    </message>
    <message>
        <source>Feel, from soft to firm</source>
        <translation>Gevoel, van zacht tot stevig</translation>
    </message>
    <message>
        <source>Soft: light pressure draws wide. Firm: press harder for the same width.</source>
        <translation>Zacht: lichte druk tekent breed. Stevig: druk harder voor dezelfde breedte.</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Stevig</translation>
    </message>
    <message>
        <source>Con&amp;tact from</source>
        <translation>Con&amp;tact vanaf</translation>
    </message>
    <message>
        <source>Pressure at which the pen touches the surface</source>
        <translation>Druk waarbij de pen de ondergrond raakt</translation>
    </message>
    <message>
        <source>Raise this if the pen draws before you press it.</source>
        <translation>Verhoog dit als de pen al tekent voordat je drukt.</translation>
    </message>
    <message>
        <source>Reset cur&amp;ve</source>
        <translation>Kromme h&amp;erstellen</translation>
    </message>
    <message>
        <source>Restores the default curve.</source>
        <translation>Herstelt de standaardkromme.</translation>
    </message>
    <message>
        <source>Pressure after the curve</source>
        <translation>Druk na de kromme</translation>
    </message>
    <message>
        <source>pen %1, line %2</source>
        <translation>pen %1, lijn %2</translation>
    </message>
    <message>
        <source>Charcoal, chalk and pencils draw broader with a tilted pen, if it reports its tilt.</source>
        <translation>Houtskool, krijt en potloden tekenen breder met een gekantelde pen, mits die zijn kanteling meldt.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Wissen</translation>
    </message>
    <message>
        <source>Clears the test area.</source>
        <translation>Wist het testgebied.</translation>
    </message>
    <message>
        <source>Buttons, mouse and touch</source>
        <translation>Knoppen, muis en aanraking</translation>
    </message>
    <message>
        <source>Pen, &amp;lower button:</source>
        <translation>Pen, &amp;onderste knop:</translation>
    </message>
    <message>
        <source>Lower button of the pen</source>
        <translation>Onderste knop van de pen</translation>
    </message>
    <message>
        <source>Pen, &amp;upper button:</source>
        <translation>Pen, &amp;bovenste knop:</translation>
    </message>
    <message>
        <source>Upper button of the pen</source>
        <translation>Bovenste knop van de pen</translation>
    </message>
    <message>
        <source>Mouse, &amp;right button:</source>
        <translation>Muis, &amp;rechterknop:</translation>
    </message>
    <message>
        <source>Right button of the mouse</source>
        <translation>Rechtermuisknop</translation>
    </message>
    <message>
        <source>Width of lines by mouse</source>
        <translation>Lijnbreedte met de muis</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constant</translation>
    </message>
    <message>
        <source>Thinner when fast</source>
        <translation>Dunner bij snelheid</translation>
    </message>
    <message>
        <source>&amp;Mouse, width of lines:</source>
        <translation>&amp;Muis, lijnbreedte:</translation>
    </message>
    <message>
        <source>What one finger does</source>
        <translation>Wat één vinger doet</translation>
    </message>
    <message>
        <source>Moves the view</source>
        <translation>Verschuift het beeld</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>Tekent</translation>
    </message>
    <message>
        <source>Nothing: touch is off</source>
        <translation>Niets: aanraking is uit</translation>
    </message>
    <message>
        <source>Two fingers move, zoom and turn the view. While the pen is near, touch is ignored.</source>
        <translation>Twee vingers verschuiven, zoomen en draaien het beeld. Zolang de pen dichtbij is, wordt aanraking genegeerd.</translation>
    </message>
    <message>
        <source>One f&amp;inger:</source>
        <translation>Eén &amp;vinger:</translation>
    </message>
    <message>
        <source>mouse, line %1</source>
        <translation>muis, lijn %1</translation>
    </message>
    <message>
        <source>The pen is tilted by %L1°</source>
        <translation>De pen is %L1° gekanteld</translation>
    </message>
    <message>
        <source>The tilt of the pen is not known</source>
        <translation>De kanteling van de pen is niet bekend</translation>
    </message>
    <message>
        <source>Tap with two fingers to &amp;undo, with three to redo</source>
        <translation>Tikken met twee vingers maakt &amp;ongedaan, met drie herhaalt het</translation>
    </message>
    <message>
        <source>A tap is short, and the fingers do not move.</source>
        <translation>Een tik is kort, en de vingers bewegen niet.</translation>
    </message>
    <message>
        <source>&amp;Hold the pen or finger still to open the ring of tools</source>
        <translation>Pen of vinger stil&amp;houden opent de ring met gereedschappen</translation>
    </message>
    <message>
        <source>Touch and rest for 0.6 seconds, then move in a direction and lift. The dot that you drew vanishes.</source>
        <translation>Raak 0,6 seconde aan zonder te bewegen, beweeg dan in een richting en til op. De getekende punt verdwijnt.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PictureActions</name>
    <message>
        <source>Import p&amp;icture…</source>
        <translation>Afbeeld&amp;ing importeren…</translation>
    </message>
    <message>
        <source>Add a picture or a page of a PDF file to draw over</source>
        <translation>Een afbeelding of een pagina van een PDF-bestand toevoegen om over te trekken</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Afbeeldingen</translation>
    </message>
    <message>
        <source>Import a picture</source>
        <translation>Een afbeelding importeren</translation>
    </message>
    <message>
        <source>“%1” cannot be imported</source>
        <translation>‘%1’ kan niet worden geïmporteerd</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>Voorkeuren</translation>
    </message>
    <message>
        <source>Pages of the preferences</source>
        <translation>Pagina’s van de voorkeuren</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Algemeen</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Sneltoetsen</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Tekengebied</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Pen</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Apparaat</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PresetMenu</name>
    <message>
        <source>P&amp;resets</source>
        <translation>Voo&amp;rinstellingen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Verwijderen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PressureCurveEditor</name>
    <message>
        <source>Pressure curve</source>
        <translation>Drukkromme</translation>
    </message>
    <message>
        <source>From the pressure of the pen (left to right) to the width of the line (bottom to top). The arrow keys move a handle; Space selects the other one.</source>
        <translation>Van de druk van de pen (links naar rechts) naar de breedte van de lijn (onder naar boven). De pijltoetsen bewegen een greep; de spatiebalk kiest de andere.</translation>
    </message>
    <message>
        <source>Drag the two handles. Higher is wider.</source>
        <translation>Sleep de twee grepen. Hoger is breder.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ProbePlot</name>
    <message>
        <source>Plot of the force along a stroke of 40 mm</source>
        <translation>Grafiek van de kracht langs een streek van 40 mm</translation>
    </message>
    <message>
        <source>%1 N of friction; the grain changes it by up to %2 N, which can be felt.</source>
        <translation>%1 N wrijving; de korrel verandert die met hoogstens %2 N, wat voelbaar is.</translation>
    </message>
    <message>
        <source>%1 N of friction; the grain changes it by up to %2 N, which is too little to feel.</source>
        <translation>%1 N wrijving; de korrel verandert die met hoogstens %2 N, te weinig om te voelen.</translation>
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
        <translation>Kies het gereedschap %1 en trek aan deze lijn</translation>
    </message>
    <message>
        <source>Hold %1 and pull this line</source>
        <translation>Houd %1 ingedrukt en trek aan deze lijn</translation>
    </message>
</context>
<context>
    <name>felt::desktop::QuestionScreen</name>
    <message>
        <source>Your opinion on this session</source>
        <translation>Uw mening over deze sessie</translation>
    </message>
    <message>
        <source>Your opinion on %1</source>
        <translation>Uw mening over %1</translation>
    </message>
    <message>
        <source>For each question, choose the mark that matches your experience best.</source>
        <translation>Kies bij elke vraag het streepje dat het best bij uw ervaring past.</translation>
    </message>
    <message>
        <source>For each line, choose the circle that matches your impression best.</source>
        <translation>Kies op elke regel het rondje dat het best bij uw indruk past.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Volgende</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ReadingSpeech</name>
    <message>
        <source>red</source>
        <translation>rood</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>oranje</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>geel</translation>
    </message>
    <message>
        <source>green</source>
        <translation>groen</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>turkoois</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blauw</translation>
    </message>
    <message>
        <source>violet</source>
        <translation>violet</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>roze</translation>
    </message>
    <message>
        <source>black</source>
        <translation>zwart</translation>
    </message>
    <message>
        <source>white</source>
        <translation>wit</translation>
    </message>
    <message>
        <source>dark grey</source>
        <translation>donkergrijs</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>grijs</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>bruin</translation>
    </message>
    <message>
        <source>line, %1, %2 mm</source>
        <translation>lijn, %1, %2 mm</translation>
    </message>
    <message>
        <source>end</source>
        <translation>einde</translation>
    </message>
    <message>
        <source>crossing of %1 lines</source>
        <translation>kruising van %1 lijnen</translation>
    </message>
    <message>
        <source>fill, %1</source>
        <translation>vulling, %1</translation>
    </message>
    <message>
        <source>layer %1</source>
        <translation>laag %1</translation>
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
        <translation>Naamloos</translation>
    </message>
    <message>
        <source>Recover drawings</source>
        <translation>Tekeningen herstellen</translation>
    </message>
    <message>
        <source>Feltline closed unexpectedly. These drawings have unsaved changes:</source>
        <translation>Feltline is onverwacht afgesloten. Deze tekeningen hebben niet-opgeslagen wijzigingen:</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Later</translation>
    </message>
    <message>
        <source>Keep them, and ask again at the next start</source>
        <translation>Bewaren en bij de volgende start weer vragen</translation>
    </message>
    <message>
        <source>Recover “%1”</source>
        <translation>‘%1’ herstellen</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Weggooien…</translation>
    </message>
    <message>
        <source>Discard “%1”</source>
        <translation>‘%1’ weggooien</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Weggooien</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Dat kan niet ongedaan worden gemaakt.</translation>
    </message>
    <message>
        <source>%1, one line</source>
        <translation>%1, één lijn</translation>
    </message>
    <message>
        <source>%1, %2 lines</source>
        <translation>%1, %2 lijnen</translation>
    </message>
    <message>
        <source>It was never saved</source>
        <translation>Ze is nooit opgeslagen</translation>
    </message>
    <message>
        <source>The file cannot be read</source>
        <translation>Het bestand is niet leesbaar</translation>
    </message>
    <message>
        <source>The file is no longer there</source>
        <translation>Het bestand is er niet meer</translation>
    </message>
    <message>
        <source>Picture of the recovered drawing</source>
        <translation>Afbeelding van de herstelde tekening</translation>
    </message>
    <message>
        <source>Picture of the saved file</source>
        <translation>Afbeelding van het opgeslagen bestand</translation>
    </message>
    <message>
        <source>⚠ Some of it could not be read.</source>
        <translation>⚠ Een deel ervan was niet leesbaar.</translation>
    </message>
    <message>
        <source>Recover as a new drawing</source>
        <translation>Als nieuwe tekening herstellen</translation>
    </message>
    <message>
        <source>Open the saved version</source>
        <translation>Opgeslagen versie openen</translation>
    </message>
    <message>
        <source>Open the saved version of “%1”</source>
        <translation>Opgeslagen versie van ‘%1’ openen</translation>
    </message>
    <message>
        <source>The unsaved changes are kept and offered again at the next start</source>
        <translation>De niet-opgeslagen wijzigingen blijven bewaard en worden bij de volgende start opnieuw aangeboden</translation>
    </message>
    <message>
        <source>Discard the unsaved changes of “%1”?</source>
        <translation>Niet-opgeslagen wijzigingen in ‘%1’ weggooien?</translation>
    </message>
    <message>
        <source>This cannot be undone. The saved file does not change.</source>
        <translation>Dit kan niet ongedaan worden gemaakt. Het opgeslagen bestand verandert niet.</translation>
    </message>
    <message>
        <source>Recovered</source>
        <translation>Hersteld</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Opgeslagen</translation>
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
        <translation>&amp;Ring met gereedschappen bij de pen</translation>
    </message>
    <message>
        <source>Eight tools around the pen, each in its own direction. Hold the key, move in the direction, and release the key.</source>
        <translation>Acht gereedschappen rond de pen, elk in een eigen richting. Houd de toets ingedrukt, beweeg in de richting en laat de toets los.</translation>
    </message>
    <message>
        <source>Ring of &amp;media at the pen</source>
        <translation>Ring met &amp;tekenmiddelen bij de pen</translation>
    </message>
    <message>
        <source>Eight media around the pen.</source>
        <translation>Acht tekenmiddelen rond de pen.</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>Tekenmiddelen</translation>
    </message>
    <message>
        <source>Ring of si&amp;zes at the pen</source>
        <translation>Ring met &amp;grootten bij de pen</translation>
    </message>
    <message>
        <source>Eight sizes around the pen: widths of new lines, or sizes of the current tool. They grow clockwise.</source>
        <translation>Acht grootten rond de pen: breedten van nieuwe lijnen of grootten van het huidige gereedschap. Ze nemen met de klok mee toe.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Ring of tools</source>
        <translation>Ring met gereedschappen</translation>
    </message>
    <message>
        <source>Ring of media</source>
        <translation>Ring met tekenmiddelen</translation>
    </message>
    <message>
        <source>Ring of sizes</source>
        <translation>Ring met grootten</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShadeField</name>
    <message>
        <source>Saturation and brightness</source>
        <translation>Verzadiging en helderheid</translation>
    </message>
    <message>
        <source>Horizontal: saturation. Vertical: brightness. Change them with the arrow keys.</source>
        <translation>Horizontaal: verzadiging. Verticaal: helderheid. Wijzig ze met de pijltoetsen.</translation>
    </message>
    <message>
        <source>Saturation %1 %, brightness %2 %</source>
        <translation>Verzadiging %1%, helderheid %2%</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShapeRow</name>
    <message>
        <source>Shape</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Path data of SVG with M, L, H, V, C and Z: x 0 to 1 along one repeat, y -0.5 to 0.5 across the line</source>
        <translation>Padgegevens van SVG met M, L, H, V, C en Z: x 0 tot 1 langs één herhaling, y -0.5 tot 0.5 dwars op de lijn</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShortcutSheet</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Sneltoetsen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Sneltoetsen zoeken</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Toetsen</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Af&amp;drukken…</translation>
    </message>
    <message>
        <source>No shortcut found.</source>
        <translation>Geen sneltoets gevonden.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShortcutsPage</name>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Geen toets</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Herstellen</translation>
    </message>
    <message>
        <source>Reass&amp;ign</source>
        <translation>Opnieuw toe&amp;wijzen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Search the commands</source>
        <translation>Opdrachten zoeken</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nieuwe toets</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Alles herstellen</translation>
    </message>
    <message>
        <source>&amp;Key:</source>
        <translation>&amp;Toets:</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Alle sneltoetsen herstellen</translation>
    </message>
    <message>
        <source>Restore the default keys of all commands?</source>
        <translation>De standaardtoetsen van alle opdrachten herstellen?</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Opdrachten en hun toetsen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Opdracht</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Toetsen</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 is al toegewezen aan ‘%2’.</translation>
    </message>
    <message>
        <source>&amp;Letters, digits and signs alone are keys</source>
        <translation>&amp;Letters, cijfers en tekens alleen zijn toetsen</translation>
    </message>
    <message>
        <source>Switch this off if speech input or accidental presses trigger commands</source>
        <translation>Zet dit uit als spraakinvoer of per ongeluk drukken opdrachten start</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SizeField</name>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of a line drawn with the mouse, or size of the current tool. Press [ or ] to change it, or hold Ctrl and Alt and drag. Selected lines get the width, too.</source>
        <translation>Breedte van een lijn die met de muis wordt getekend, of grootte van het huidige gereedschap. Wijzig met [ of ], of sleep met Ctrl en Alt ingedrukt. Ook geselecteerde lijnen krijgen de breedte.</translation>
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
        <translation>Wordt opgeblazen…</translation>
    </message>
    <message>
        <source>Draw a closed line: it becomes a body here.</source>
        <translation>Teken een gesloten lijn: hier wordt het een lichaam.</translation>
    </message>
    <message>
        <source>Close wider gaps</source>
        <translation>Grotere openingen sluiten</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Opening</translation>
    </message>
    <message>
        <source>Gaps of the outline up to this size count as closed</source>
        <translation>Openingen in de omtrek tot deze grootte gelden als gesloten</translation>
    </message>
    <message>
        <source>Uses the smallest of 2, 4 and 8 mm that closes most of the drawing</source>
        <translation>Neemt de kleinste van 2, 4 en 8 mm die het grootste deel van de tekening sluit</translation>
    </message>
    <message>
        <source>Closed lines inside an outline, such as eyes, make no holes</source>
        <translation>Gesloten lijnen in een omtrek, zoals ogen, worden geen gaten</translation>
    </message>
    <message>
        <source>Shows the triangles</source>
        <translation>Toont de driehoeken</translation>
    </message>
    <message>
        <source>Cuts away the right part</source>
        <translation>Snijdt het rechterdeel weg</translation>
    </message>
    <message>
        <source>Position of the section</source>
        <translation>Plaats van de doorsnede</translation>
    </message>
    <message>
        <source>Writes the bodies as a file for printing or for a 3D program</source>
        <translation>Schrijft de lichamen als bestand om te printen of voor een 3D-programma</translation>
    </message>
    <message>
        <source>Bodies: %1. Triangles: %2.</source>
        <translation>Lichamen: %1. Driehoeken: %2.</translation>
    </message>
    <message>
        <source>Close gaps up to %1</source>
        <translation>Openingen tot %1 sluiten</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Gaten vullen</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Draadmodel</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Doorsnede</translation>
    </message>
    <message>
        <source>Gap:</source>
        <translation>Opening:</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>The drawing has no body, because no line is closed.</source>
        <translation>Er is geen lichaam, omdat geen lijn gesloten is.</translation>
    </message>
    <message>
        <source>The drawing has no body.</source>
        <translation>Er is geen lichaam.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>en nog %1</translation>
    </message>
    <message>
        <source>Wait until the last stroke has been applied.</source>
        <translation>Wacht tot de laatste streek is toegepast.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SolidScene</name>
    <message>
        <source>Solid</source>
        <translation>Lichaam</translation>
    </message>
    <message>
        <source>Arrow keys turn the solid, plus and minus zoom, Home shows the first view again</source>
        <translation>Pijltoetsen draaien het lichaam, plus en min zoomen, Home toont de eerste weergave weer</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SolidTouchMode</name>
    <message>
        <source>&amp;Touch the solid</source>
        <translation>Lichaam &amp;aanraken</translation>
    </message>
    <message>
        <source>The pen feels the bodies of the solid view, and draws nothing meanwhile</source>
        <translation>De pen voelt de lichamen van de lichaamsweergave en tekent intussen niets</translation>
    </message>
    <message>
        <source>To touch a body, open the solid view and draw a closed line.</source>
        <translation>Om een lichaam aan te raken, opent u de lichaamsweergave en tekent u een gesloten lijn.</translation>
    </message>
    <message>
        <source>This device cannot push in three directions, so it cannot let you touch a body.</source>
        <translation>Dit apparaat kan niet in drie richtingen duwen; daarom kunt u er geen lichaam mee betasten.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SoundState</name>
    <message>
        <source>There is no sound device. Sound starts when one is connected.</source>
        <translation>Er is geen geluidsapparaat. Het geluid begint zodra er een is aangesloten.</translation>
    </message>
    <message>
        <source>This program was built without sound.</source>
        <translation>Dit programma is zonder geluid gebouwd.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SpiralArea</name>
    <message>
        <source>Spiral</source>
        <translation>Spiraal</translation>
    </message>
    <message>
        <source>Draw along the spiral, from its middle outwards.</source>
        <translation>Teken de spiraal na, van het midden naar buiten.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::StabilitySign</name>
    <message>
        <source>Stability</source>
        <translation>Stabiliteit</translation>
    </message>
</context>
<context>
    <name>felt::desktop::StatusLine</name>
    <message>
        <source>Hint</source>
        <translation>Tip</translation>
    </message>
    <message>
        <source>Position of the pen</source>
        <translation>Positie van de pen</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druk</translation>
    </message>
    <message>
        <source>Pressure %1</source>
        <translation>Druk %1</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Rotation of the view</source>
        <translation>Draaiing van het beeld</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Apparaat</translation>
    </message>
    <message>
        <source>State of the file</source>
        <translation>Stand van het bestand</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>%1, forces off</source>
        <translation>%1, krachten uit</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Niet opgeslagen</translation>
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
        <translation>Opgeslagen in %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SteadyDialog</name>
    <message>
        <source>The computer was too busy and missed parts of the spiral. Close other programs, then start again.</source>
        <translation>De computer had het te druk en heeft delen van de spiraal gemist. Sluit andere programma’s en begin opnieuw.</translation>
    </message>
    <message>
        <source>This pen reports its position too rarely to measure a shaking.</source>
        <translation>Deze pen meldt zijn positie te weinig om beven te meten.</translation>
    </message>
    <message>
        <source>No shaking was found, so there is nothing to remove.</source>
        <translation>Er is geen beven gevonden, dus er valt niets te verwijderen.</translation>
    </message>
    <message>
        <source>%L1 times a second, by %L2 mm to each side</source>
        <translation>%L1 keer per seconde, %L2 mm naar elke kant</translation>
    </message>
    <message>
        <source>Measure the hand</source>
        <translation>Hand meten</translation>
    </message>
    <message>
        <source>Trace the spiral slowly, from the middle outwards, without resting the hand. It takes about ten seconds. What is measured stays on this computer.</source>
        <translation>Teken de spiraal langzaam na, van het midden naar buiten, zonder de hand te laten rusten. Het duurt ongeveer tien seconden. Wat gemeten wordt, blijft op deze computer.</translation>
    </message>
    <message>
        <source>The spiral begins where your device touches first.</source>
        <translation>De spiraal begint waar uw apparaat het eerst neerkomt.</translation>
    </message>
    <message>
        <source>How much of the ten seconds is drawn</source>
        <translation>Hoeveel van de tien seconden getekend is</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Gebruiken</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>&amp;Opnieuw beginnen</translation>
    </message>
    <message>
        <source>The hand shakes %1.</source>
        <translation>De hand beeft %1.</translation>
    </message>
    <message>
        <source>That was too short. Draw slowly, for about ten seconds, without lifting the pen.</source>
        <translation>Dat was te kort. Teken langzaam, ongeveer tien seconden lang, zonder de pen op te tillen.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SteadyGroup</name>
    <message>
        <source>Steady hand</source>
        <translation>Vaste hand</translation>
    </message>
    <message>
        <source>&amp;Remove the shaking of the hand</source>
        <translation>Het &amp;beven van de hand verwijderen</translation>
    </message>
    <message>
        <source>Lines become calm while you draw, and calmer when you lift the pen. The command Line as drawn brings the shaken line back.</source>
        <translation>Lijnen worden rustig terwijl u tekent, en rustiger als u de pen optilt. De opdracht Lijn als getekend haalt de bevende lijn terug.</translation>
    </message>
    <message>
        <source>&amp;Measure…</source>
        <translation>&amp;Meten…</translation>
    </message>
    <message>
        <source>Measures how the hand shakes, by a spiral of ten seconds.</source>
        <translation>Meet met een spiraal van tien seconden hoe de hand beeft.</translation>
    </message>
    <message>
        <source>Set to a hand that shakes %1.</source>
        <translation>Ingesteld op een hand die %1 beeft.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::StrokePreview</name>
    <message>
        <source>Three strokes: light, firm, hard</source>
        <translation>Drie streken: licht, stevig, hard</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 op %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::Studio</name>
    <message>
        <source>This drawing has its own values for: %1. Your materials are unchanged.</source>
        <translation>Deze tekening heeft eigen waarden voor: %1. Je materialen zijn ongewijzigd.</translation>
    </message>
    <message>
        <source>The surface “%1” is not installed, so the previous surface is used.</source>
        <translation>De ondergrond ‘%1’ is niet geïnstalleerd, daarom wordt de vorige gebruikt.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TactilePanel</name>
    <message>
        <source>Gap</source>
        <translation>Tussenruimte</translation>
    </message>
    <message>
        <source>Small shape</source>
        <translation>Kleine vorm</translation>
    </message>
    <message>
        <source>Short side</source>
        <translation>Korte zijde</translation>
    </message>
    <message>
        <source>Narrow area</source>
        <translation>Smal vlak</translation>
    </message>
    <message>
        <source>Line widths</source>
        <translation>Lijnbreedten</translation>
    </message>
    <message>
        <source>Area colours</source>
        <translation>Vlakkleuren</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Thin line</source>
        <translation>Dunne lijn</translation>
    </message>
    <message>
        <source>%1 mm between lines, for %2 mm; at least %3 mm</source>
        <translation>%1 mm tussen lijnen, over %2 mm; ten minste %3 mm</translation>
    </message>
    <message>
        <source>%1 mm long; at least %2 mm</source>
        <translation>%1 mm lang; ten minste %2 mm</translation>
    </message>
    <message>
        <source>%1 mm wide; at least %2 mm</source>
        <translation>%1 mm breed; ten minste %2 mm</translation>
    </message>
    <message>
        <source>%1 different widths; at most %2</source>
        <translation>%1 verschillende breedten; hoogstens %2</translation>
    </message>
    <message>
        <source>%1 colours, which feel the same</source>
        <translation>%1 kleuren die hetzelfde aanvoelen</translation>
    </message>
    <message>
        <source>%1 mm; at most %2 mm (A4)</source>
        <translation>%1 mm; hoogstens %2 mm (A4)</translation>
    </message>
    <message>
        <source>Swell paper</source>
        <translation>Zwelpapier</translation>
    </message>
    <message>
        <source>An embosser</source>
        <translation>Een brailleprinter</translation>
    </message>
    <message>
        <source>Lines on swell paper must be 6.4 mm apart, embossed lines 3.2 mm</source>
        <translation>Lijnen op zwelpapier moeten 6,4 mm uit elkaar liggen, geperste lijnen 3,2 mm</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fouten</translation>
    </message>
    <message>
        <source>Made &amp;for:</source>
        <translation>Gemaakt &amp;voor:</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Bezig met controleren …</translation>
    </message>
    <message>
        <source>The lines are longer than 100 m: too much for a raised drawing.</source>
        <translation>De lijnen zijn langer dan 100 m: te veel voor een voelbare tekening.</translation>
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
        <translation>Geen fouten.</translation>
    </message>
    <message>
        <source>%1 faults; the first %2 are shown.</source>
        <translation>%1 fouten; de eerste %2 zijn te zien.</translation>
    </message>
    <message>
        <source>Faults: %1. Click one to go to it.</source>
        <translation>Fouten: %1. Klik erop om erheen te gaan.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TestPad</name>
    <message>
        <source>Test pad</source>
        <translation>Testgebied</translation>
    </message>
    <message>
        <source>Press here with pen or mouse to try the device</source>
        <translation>Druk hier met pen of muis om het apparaat te proberen</translation>
    </message>
    <message>
        <source>Try this device on the drawing area.</source>
        <translation>Probeer dit apparaat uit op het tekengebied.</translation>
    </message>
    <message>
        <source>Press here and feel</source>
        <translation>Druk hier en voel</translation>
    </message>
    <message>
        <source>Force %L1 N</source>
        <translation>Kracht %L1 N</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>active while the key is held</source>
        <translation>actief zolang de toets ingedrukt is</translation>
    </message>
    <message>
        <source>returns when the key is released</source>
        <translation>keert terug als de toets wordt losgelaten</translation>
    </message>
    <message>
        <source>active</source>
        <translation>actief</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ToolKeys</name>
    <message>
        <source>&amp;Eraser while held</source>
        <translation>&amp;Gum zolang ingedrukt</translation>
    </message>
    <message>
        <source>Uses the eraser while the key is held, or the pencil if the eraser is active</source>
        <translation>Gebruikt de gum zolang de toets ingedrukt is, of het potlood als de gum actief is</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TopBar</name>
    <message>
        <source>Top bar</source>
        <translation>Bovenste balk</translation>
    </message>
    <message>
        <source>Surface:</source>
        <translation>Ondergrond:</translation>
    </message>
    <message>
        <source>Material of the surface</source>
        <translation>Materiaal van de ondergrond</translation>
    </message>
    <message>
        <source>How the surface feels and looks</source>
        <translation>Hoe de ondergrond aanvoelt en eruitziet</translation>
    </message>
    <message>
        <source>Drawing medium</source>
        <translation>Tekenmiddel</translation>
    </message>
    <message>
        <source>How the medium looks, feels and sounds</source>
        <translation>Hoe het tekenmiddel eruitziet, aanvoelt en klinkt</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Grootte:</translation>
    </message>
    <message>
        <source>Medium:</source>
        <translation>Tekenmiddel:</translation>
    </message>
    <message>
        <source>Presets: a medium with its size, colour and options, under a name</source>
        <translation>Voorinstellingen: een tekenmiddel met grootte, kleur en opties onder een naam</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voorinstellingen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TourWindow</name>
    <message>
        <source>Guided tour</source>
        <translation>Rondleiding</translation>
    </message>
    <message>
        <source>Drawing area of the tour</source>
        <translation>Tekengebied van de rondleiding</translation>
    </message>
    <message>
        <source>Progress of the tour</source>
        <translation>Voortgang van de rondleiding</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Terug</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pauze</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Volgende</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;luiten</translation>
    </message>
    <message>
        <source>Try it yourself</source>
        <translation>Probeer het zelf</translation>
    </message>
    <message>
        <source>Draw with a pen or with the mouse. Press ? for the keys. You can undo everything with Ctrl+Z.</source>
        <translation>Teken met een pen of met de muis. Druk op ? voor de sneltoetsen. Met Ctrl+Z kun je alles ongedaan maken.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>C&amp;ontinue</source>
        <translation>&amp;Hervatten</translation>
    </message>
    <message>
        <source>&amp;Try it yourself</source>
        <translation>Zelf &amp;proberen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TrialScreen</name>
    <message>
        <source>Draw along the line. Begin at the dot and go in the direction of the arrow.</source>
        <translation>Teken langs de lijn. Begin bij de stip en ga in de richting van de pijl.</translation>
    </message>
    <message>
        <source>Draw between the walls without touching them. Begin at the dot and go in the direction of the arrow.</source>
        <translation>Teken tussen de wanden zonder ze te raken. Begin bij de stip en ga in de richting van de pijl.</translation>
    </message>
    <message>
        <source>Draw the same shape in the empty half on the right.</source>
        <translation>Teken dezelfde vorm in de lege rechterhelft.</translation>
    </message>
    <message>
        <source>Draw from target to target in the order of the numbers.</source>
        <translation>Teken van doel naar doel in de volgorde van de cijfers.</translation>
    </message>
    <message>
        <source>Move the pen over the page until you feel a line in it, and follow this line.</source>
        <translation>Beweeg de pen over de pagina tot u er een lijn in voelt, en volg deze lijn.</translation>
    </message>
    <message>
        <source>Draw over the line. Begin at the dot and go in the direction of the arrow.</source>
        <translation>Teken over de lijn. Begin bij de stip en ga in de richting van de pijl.</translation>
    </message>
    <message>
        <source>Draw along the line, once around, so that the end of your line meets its start.</source>
        <translation>Teken de lijn één keer helemaal rond over, zodat het einde van uw lijn het begin raakt.</translation>
    </message>
    <message>
        <source>Draw along the band with one line that is as broad as the band everywhere. Begin at the dot.</source>
        <translation>Teken langs de band één lijn die overal zo breed is als de band. Begin bij de stip.</translation>
    </message>
    <message>
        <source>Erase the marked part of the line, up to the two lines that cross it. Leave all other lines as they are.</source>
        <translation>Gum het gemarkeerde deel van de lijn uit, tot aan de twee lijnen die haar kruisen. Laat alle andere lijnen zoals ze zijn.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>You will not see what you draw.</source>
        <translation>U ziet niet wat u tekent.</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Ronde %1 van %2</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>oefening</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TrialWindow</name>
    <message>
        <source>The line was much shorter than the shape. Please draw the whole shape.</source>
        <translation>De lijn was veel korter dan de vorm. Teken de hele vorm, alstublieft.</translation>
    </message>
    <message>
        <source>The pen was lifted often. Please keep it on the page.</source>
        <translation>De pen werd vaak opgetild. Houd hem op de pagina, alstublieft.</translation>
    </message>
    <message>
        <source>The pen left the tunnel. Please stay between the walls.</source>
        <translation>De pen verliet de tunnel. Blijf tussen de wanden, alstublieft.</translation>
    </message>
    <message>
        <source>That was very fast. Please draw a little more slowly.</source>
        <translation>Dat was erg snel. Teken iets langzamer, alstublieft.</translation>
    </message>
    <message>
        <source>The device had a problem. It was not your fault.</source>
        <translation>Het apparaat had een storing. Het lag niet aan u.</translation>
    </message>
    <message>
        <source>After each drawing, press Space or the button “Done”.</source>
        <translation>Druk na elke tekening op de spatiebalk of op de knop ‘Klaar’.</translation>
    </message>
    <message>
        <source>You may feel forces in the pen. Hold it before you begin.</source>
        <translation>U kunt krachten in de pen voelen. Houd hem vast voordat u begint.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Doorgaan</translation>
    </message>
    <message>
        <source>Thank you!</source>
        <translation>Dank u wel!</translation>
    </message>
    <message>
        <source>You have finished. Please tell the researcher.</source>
        <translation>U bent klaar. Zeg het alstublieft tegen de onderzoeker.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Please draw this one again</source>
        <translation>Teken deze nog een keer, alstublieft</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Nog een keer</translation>
    </message>
    <message>
        <source>Please rest a little</source>
        <translation>Rust even uit, alstublieft</translation>
    </message>
    <message>
        <source>Relax your hand and your arm.</source>
        <translation>Ontspan uw hand en uw arm.</translation>
    </message>
    <message>
        <source>This cannot be saved: %1</source>
        <translation>Dit kan niet worden opgeslagen: %1</translation>
    </message>
    <message>
        <source>Stop the session? Finished trials are saved.</source>
        <translation>De sessie stoppen? Voltooide rondes zijn opgeslagen.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Doorgaan</translation>
    </message>
</context>
<context>
    <name>felt::desktop::UserMaterials</name>
    <message>
        <source>not saved</source>
        <translation>niet opgeslagen</translation>
    </message>
    <message>
        <source>%1 was changed by another program and was not overwritten. Save your material under another name; you can import the file.</source>
        <translation>%1 is door een ander programma gewijzigd en niet overschreven. Sla je materiaal onder een andere naam op; het bestand kun je importeren.</translation>
    </message>
    <message>
        <source>It is installed for all users of this computer and cannot be deleted here: %1</source>
        <translation>Het is voor alle gebruikers van deze computer geïnstalleerd en kan hier niet worden verwijderd: %1</translation>
    </message>
    <message>
        <source>%1 was changed by another program and was not deleted. To remove it, delete the file.</source>
        <translation>%1 is door een ander programma gewijzigd en niet verwijderd. Verwijder het bestand om het te verwijderen.</translation>
    </message>
</context>
<context>
    <name>tools</name>
    <message>
        <source>Guide</source>
        <translation>Hulplijn</translation>
    </message>
    <message>
        <source>Lines that lead out of the loop: only their part inside (parts), or the whole line (strokes). By control points, as in the paper (points), or by joints (on-curve).</source>
        <translation>Lijnen die uit de lus lopen: alleen hun deel erbinnen (delen) of de hele lijn (lijnen). Naar controlepunten, zoals in het artikel (punten), of naar knooppunten (op de kromme).</translation>
    </message>
    <message>
        <source>Places rulers, grids, mirror axes and other guides, and moves and turns them.</source>
        <translation>Plaatst linialen, rasters, spiegelassen en andere hulplijnen, en verplaatst en draait ze.</translation>
    </message>
    <message>
        <source>Drag to place a guide, or drag a guide by a handle or a line.</source>
        <translation>Sleep om een hulplijn te plaatsen, of sleep er een aan een greep of lijn.</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>delen</translation>
    </message>
    <message>
        <source>removes the guide</source>
        <translation>verwijdert de hulplijn</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Soort</translation>
    </message>
    <message>
        <source>The guide that a drag on a free part of the page places.</source>
        <translation>De hulplijn die slepen op een vrij deel van de pagina plaatst.</translation>
    </message>
    <message>
        <source>Mirror axes</source>
        <translation>Spiegelassen</translation>
    </message>
    <message>
        <source>How many axes a new symmetry has. Each stroke gets twice as many images.</source>
        <translation>Hoeveel assen een nieuwe symmetrie heeft. Elke lijn krijgt twee keer zoveel beelden.</translation>
    </message>
    <message>
        <source>Vanishing points</source>
        <translation>Verdwijnpunten</translation>
    </message>
    <message>
        <source>How many vanishing points a new perspective has.</source>
        <translation>Hoeveel verdwijnpunten een nieuw perspectief heeft.</translation>
    </message>
    <message>
        <source>How strongly a new guide holds the pen of the pencil.</source>
        <translation>Hoe sterk een nieuwe hulplijn de pen vasthoudt.</translation>
    </message>
    <message>
        <source>ruler</source>
        <translation>liniaal</translation>
    </message>
    <message>
        <source>parallels</source>
        <translation>parallellen</translation>
    </message>
    <message>
        <source>set-square</source>
        <translation>geodriehoek</translation>
    </message>
    <message>
        <source>protractor</source>
        <translation>gradenboog</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>passer</translation>
    </message>
    <message>
        <source>ellipses</source>
        <translation>ellipsen</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspectief</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>raster</translation>
    </message>
    <message>
        <source>isometric-grid</source>
        <translation>isometrisch raster</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>symmetrie</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>spoor</translation>
    </message>
    <message>
        <source>steps of 15°</source>
        <translation>stappen van 15°</translation>
    </message>
    <message>
        <source>Draw a line around the selection, or a rectangle from corner to corner.</source>
        <translation>Teken een lijn om de selectie, of een rechthoek van hoek tot hoek.</translation>
    </message>
    <message>
        <source>Lines farther from the pen than this are not grabbed.</source>
        <translation>Lijnen die verder van de pen liggen, worden niet gepakt.</translation>
    </message>
    <message>
        <source>Erases the ink that the ring covers. If off, cuts a line where the ring covers its centre line.</source>
        <translation>Gumt de inkt die de ring bedekt. Indien uit, wordt een lijn doorgeknipt waar de ring haar hartlijn bedekt.</translation>
    </message>
    <message>
        <source>A grabbed line keeps its distance from the pen instead of moving to it.</source>
        <translation>Een gepakte lijn houdt haar afstand tot de pen, in plaats van ernaartoe te bewegen.</translation>
    </message>
    <message>
        <source>A short touch selects the nearest line within this distance.</source>
        <translation>Een korte aanraking selecteert de dichtstbijzijnde lijn binnen deze afstand.</translation>
    </message>
    <message>
        <source>Above 1, light pressure stays thin for longer; below 1, lines broaden sooner.</source>
        <translation>Boven 1 blijft lichte druk langer dun, onder 1 worden lijnen eerder breed.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Hoeveelheid</translation>
    </message>
    <message>
        <source>An end released away from all others stays there. If off, it returns. The first modifier inverts this.</source>
        <translation>Een eind dat los van alle andere wordt losgelaten, blijft daar. Indien uit, gaat het terug. De eerste modificatietoets keert dit om.</translation>
    </message>
    <message>
        <source>Attraction</source>
        <translation>Aantrekking</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>Schoolbord</translation>
    </message>
    <message>
        <source>Erase by ink width</source>
        <translation>Rekening houden met inktbreedte</translation>
    </message>
    <message>
        <source>Broadest line</source>
        <translation>Breedste lijn</translation>
    </message>
    <message>
        <source>Brush: thicker or thinner under the pen. Retrace: drawing along a line gives it the new pressure. Scale: dragging up or down scales a whole line.</source>
        <translation>Penseel: dikker of dunner onder de pen. Overtrekken: langs een lijn tekenen geeft haar de nieuwe druk. Schalen: omhoog of omlaag slepen schaalt de hele lijn.</translation>
    </message>
    <message>
        <source>By pressure, hard for thicker and light for thinner, or always the same way. The first button of the pen makes thinner, the second thicker.</source>
        <translation>Naar druk, hard voor dikker en licht voor dunner, of altijd dezelfde kant op. De eerste penknop maakt dunner, de tweede dikker.</translation>
    </message>
    <message>
        <source>By the handle that is touched (auto), or always the same.</source>
        <translation>Naar de aangeraakte greep (auto), of altijd hetzelfde.</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>Combineren</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Constrain</source>
        <translation>Beperken</translation>
    </message>
    <message>
        <source>Corrects lines: grab one and pull it into shape, or push it from outside.</source>
        <translation>Corrigeert lijnen: pak er een en trek haar in vorm, of duw haar van buitenaf.</translation>
    </message>
    <message>
        <source>Direction of the brush</source>
        <translation>Richting van het penseel</translation>
    </message>
    <message>
        <source>Draws lines; pressing harder draws them broader.</source>
        <translation>Tekent lijnen; harder drukken maakt ze breder.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliceren</translation>
    </message>
    <message>
        <source>Ends and corners move along instead of staying; the first modifier inverts this for one gesture.</source>
        <translation>Uiteinden en hoeken bewegen mee in plaats van te blijven; de eerste modificatietoets keert dit om voor één gebaar.</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Gum</translation>
    </message>
    <message>
        <source>Erases the ink under it, lines up to their next crossings, or whole lines.</source>
        <translation>Gumt wat hij bedekt, lijnen tot hun volgende kruisingen, of hele lijnen.</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Vilt</translation>
    </message>
    <message>
        <source>Fits the finished line again, with fewer segments within the same tolerance; lines of more than a minute stay as drawn.</source>
        <translation>Past de voltooide lijn opnieuw aan, met minder segmenten binnen dezelfde tolerantie; lijnen van meer dan een minuut blijven zoals getekend.</translation>
    </message>
    <message>
        <source>Force that draws the pen to the end of a line.</source>
        <translation>Kracht die de pen naar het eind van een lijn trekt.</translation>
    </message>
    <message>
        <source>Free ends and corners</source>
        <translation>Vrije uiteinden en hoeken</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Grab divides the line so that no more than this is bent; 0 bends whole segments.</source>
        <translation>Pakken verdeelt de lijn zodat niet meer dan deze lengte wordt gebogen; 0 buigt hele segmenten.</translation>
    </message>
    <message>
        <source>Grab radius</source>
        <translation>Pakstraal</translation>
    </message>
    <message>
        <source>A larger mass draws smoother lines with more lag; for the stabiliser &apos;inertia&apos;.</source>
        <translation>Een grotere massa tekent vloeiendere lijnen met meer vertraging; voor de stabilisator ‘traagheid’.</translation>
    </message>
    <message>
        <source>How far a line may move when it is simplified after the gesture; more gives fewer segments.</source>
        <translation>Hoe ver een lijn mag verschuiven bij het vereenvoudigen na het gebaar; meer geeft minder segmenten.</translation>
    </message>
    <message>
        <source>How far the simplified line may be from the smoothed one.</source>
        <translation>Hoe ver de vereenvoudigde lijn van de gladgestreken lijn mag afwijken.</translation>
    </message>
    <message>
        <source>Tilt of the pen from upright, if the device does not report it. Some media draw broader and softer when tilted.</source>
        <translation>Kanteling van de pen ten opzichte van rechtop, als het apparaat die niet meldt. Sommige tekenmiddelen tekenen gekanteld breder en zachter.</translation>
    </message>
    <message>
        <source>How fast it smooths; pressing harder is faster.</source>
        <translation>Hoe snel er wordt gladgestreken; harder drukken gaat sneller.</translation>
    </message>
    <message>
        <source>How fast the width changes, per unit of pressure.</source>
        <translation>Hoe snel de breedte verandert, per eenheid druk.</translation>
    </message>
    <message>
        <source>How grab and sweep bend a segment: with least motion (soft), by the paper&apos;s three cases (paper), or by its equation 7 as printed, which moves the line less than the pen.</source>
        <translation>Hoe pakken en vegen een segment buigen: met de minste beweging (zacht), volgens de drie gevallen van het artikel (artikel), of volgens vergelijking 7 zoals gedrukt, waarmee de lijn minder beweegt dan de pen.</translation>
    </message>
    <message>
        <source>Distance from the end of a line at which the pen grabs it.</source>
        <translation>Afstand tot het lijneind waarop de pen het pakt.</translation>
    </message>
    <message>
        <source>How slowly a line gives way to the pen that sweeps it.</source>
        <translation>Hoe langzaam een lijn toegeeft aan de vegende pen.</translation>
    </message>
    <message>
        <source>Smooths the jitter out of lines and keeps their shape.</source>
        <translation>Strijkt trillingen uit lijnen en behoudt hun vorm.</translation>
    </message>
    <message>
        <source>Joins ends of lines, or closes a line: drag an end onto another, or tap where two ends are near.</source>
        <translation>Verbindt lijneinden, of sluit een lijn: sleep een eind op een ander, of tik waar twee einden dicht bij elkaar zijn.</translation>
    </message>
    <message>
        <source>Keep distance from the pen</source>
        <translation>Afstand tot de pen houden</translation>
    </message>
    <message>
        <source>Retracing</source>
        <translation>Overtrekken</translation>
    </message>
    <message>
        <source>Force that holds a slow pen to a line that it draws over; 0 for none.</source>
        <translation>Kracht die een langzame pen bij de lijn houdt die hij overtrekt; 0 voor geen.</translation>
    </message>
    <message>
        <source>Keep lines separate</source>
        <translation>Lijnen apart houden</translation>
    </message>
    <message>
        <source>Largest distance between the path of the pen and the line.</source>
        <translation>Grootste afstand tussen het pad van de pen en de lijn.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Tilt with a mouse</source>
        <translation>Kanteling met een muis</translation>
    </message>
    <message>
        <source>Keep the end where it is released</source>
        <translation>Het eind blijft waar het wordt losgelaten</translation>
    </message>
    <message>
        <source>About the centre</source>
        <translation>Om het midden</translation>
    </message>
    <message>
        <source>Corners and edges scale and stretch about the centre and not about the opposite side, like the third button of the pen.</source>
        <translation>Hoeken en randen schalen en rekken om het midden in plaats van om de tegenoverliggende zijde, zoals de derde penknop.</translation>
    </message>
    <message>
        <source>Keeps the lines and transforms a copy, like the second button of the pen.</source>
        <translation>Behoudt de lijnen en transformeert een kopie, zoals de tweede penknop.</translation>
    </message>
    <message>
        <source>Length bent by grab</source>
        <translation>Bij pakken gebogen lengte</translation>
    </message>
    <message>
        <source>Lines that meet share the point but stay two lines.</source>
        <translation>Lijnen die elkaar raken delen het punt maar blijven twee lijnen.</translation>
    </message>
    <message>
        <source>A longer rope draws smoother lines with more lag; for the stabiliser &apos;towed&apos;.</source>
        <translation>Een langer touw tekent vloeiendere lijnen met meer vertraging; voor de stabilisator ‘gesleept’.</translation>
    </message>
    <message>
        <source>Makes lines broader and thinner, here and there or as a whole.</source>
        <translation>Maakt lijnen breder en dunner, hier en daar of als geheel.</translation>
    </message>
    <message>
        <source>Mass of the stabiliser</source>
        <translation>Massa van de stabilisator</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Moves along one axis, turns in steps of 15 degrees, and corners stretch both axes freely, like the first button of the pen.</source>
        <translation>Verplaatst langs één as, draait in stappen van 15 graden, en hoeken rekken beide assen vrij, zoals de eerste penknop.</translation>
    </message>
    <message>
        <source>Moves, turns, scales and stretches the selection. Lines that cross it stay attached and resist.</source>
        <translation>Verplaatst, draait, schaalt en rekt de selectie. Lijnen die haar kruisen, blijven verbonden en bieden weerstand.</translation>
    </message>
    <message>
        <source>Lines are not made broader than this. Lines that already are broader keep their width.</source>
        <translation>Lijnen worden niet breder dan dit. Lijnen die al breder zijn, behouden hun breedte.</translation>
    </message>
    <message>
        <source>For retracing: above 1, light pressure stays thin for longer.</source>
        <translation>Bij overtrekken: boven 1 blijft lichte druk langer dun.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Potlood</translation>
    </message>
    <message>
        <source>Pressure curve</source>
        <translation>Drukkromme</translation>
    </message>
    <message>
        <source>Pressure for devices that report neither pressure nor depth.</source>
        <translation>Druk voor apparaten die druk noch diepte melden.</translation>
    </message>
    <message>
        <source>Pressure with a mouse</source>
        <translation>Druk met een muis</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Trekken</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Straal</translation>
    </message>
    <message>
        <source>Radius around the end of a line within which it attracts the dragged end; a tap connects ends that are this near.</source>
        <translation>Straal rond een lijneind waarbinnen het gesleepte eind wordt aangetrokken; een tik verbindt einden die zo dichtbij zijn.</translation>
    </message>
    <message>
        <source>Radius of the eraser.</source>
        <translation>Straal van de gum.</translation>
    </message>
    <message>
        <source>Radius of the nib</source>
        <translation>Straal van de punt</translation>
    </message>
    <message>
        <source>Radius within which the dragged end is connected.</source>
        <translation>Straal waarbinnen het gesleepte eind wordt verbonden.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Bereik</translation>
    </message>
    <message>
        <source>Reach of a click</source>
        <translation>Bereik van een klik</translation>
    </message>
    <message>
        <source>Reach of the attraction</source>
        <translation>Bereik van de aantrekking</translation>
    </message>
    <message>
        <source>Reach of the brush</source>
        <translation>Bereik van het penseel</translation>
    </message>
    <message>
        <source>Refine at pen-up</source>
        <translation>Verfijnen bij optillen</translation>
    </message>
    <message>
        <source>Rope of the stabiliser</source>
        <translation>Touw van de stabilisator</translation>
    </message>
    <message>
        <source>Rounds corners instead of keeping them. Ends of lines are always kept.</source>
        <translation>Rondt hoeken af in plaats van ze te behouden. Lijneinden blijven altijd behouden.</translation>
    </message>
    <message>
        <source>Scale widths</source>
        <translation>Breedten schalen</translation>
    </message>
    <message>
        <source>Scaling makes lines broader or thinner as well.</source>
        <translation>Schalen maakt lijnen ook breder of dunner.</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selecteren</translation>
    </message>
    <message>
        <source>Selects the lines that you draw around; a short touch selects one line.</source>
        <translation>Selecteert de lijnen waar je omheen tekent; een korte aanraking selecteert één lijn.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Force level of friction and grain. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van wrijving en korrel. De hardheid van de ondergrond verandert niet.</translation>
    </message>
    <message>
        <source>Force level of friction and roughness. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van wrijving en ruwheid. De hardheid van de ondergrond verandert niet.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction and pull. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van wrijving, korrel, aantrekking en trek. De hardheid van de ondergrond verandert niet.</translation>
    </message>
    <message>
        <source>Force level of friction, stops and pull. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van wrijving, aanslagen en trek. De hardheid van de ondergrond verandert niet.</translation>
    </message>
    <message>
        <source>Force level of the counter-force, friction and grain. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van tegenkracht, wrijving en korrel. De hardheid van de ondergrond verandert niet.</translation>
    </message>
    <message>
        <source>Force level of the surface&apos;s friction and grain. Does not affect its hardness.</source>
        <translation>Sterkte van wrijving en korrel van de ondergrond. De hardheid ervan verandert niet.</translation>
    </message>
    <message>
        <source>Force level of the tethers, friction and grain.</source>
        <translation>Sterkte van lijnen, wrijving en korrel.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Ondergrond</translation>
    </message>
    <message>
        <source>Size of the round nib that pushes lines.</source>
        <translation>Grootte van de ronde punt die lijnen duwt.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gladstrijken</translation>
    </message>
    <message>
        <source>Smooth corners too</source>
        <translation>Ook hoeken gladstrijken</translation>
    </message>
    <message>
        <source>Snap radius</source>
        <translation>Vastklikstraal</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>Vastklikken</translation>
    </message>
    <message>
        <source>Speed of the brush</source>
        <translation>Snelheid van het penseel</translation>
    </message>
    <message>
        <source>Stabiliser</source>
        <translation>Stabilisator</translation>
    </message>
    <message>
        <source>Steadies the hand: the line is drawn by a mass, or by a nib on a rope.</source>
        <translation>Maakt de hand rustig: de lijn wordt getrokken door een massa, of door een punt aan een touw.</translation>
    </message>
    <message>
        <source>Strength of forces</source>
        <translation>Sterkte van de krachten</translation>
    </message>
    <message>
        <source>Thinnest line</source>
        <translation>Dunste lijn</translation>
    </message>
    <message>
        <source>Thinnest retraced line</source>
        <translation>Dunste overgetrokken lijn</translation>
    </message>
    <message>
        <source>Time of sweep</source>
        <translation>Tijd van vegen</translation>
    </message>
    <message>
        <source>Time to yield</source>
        <translation>Meegeeftijd</translation>
    </message>
    <message>
        <source>How long the counter-force lasts when the pen rests; 0: as long as the pen is down, as in the paper.</source>
        <translation>Hoe lang de tegenkracht aanhoudt als de pen rust; 0: zolang de pen op het vlak is, zoals in het artikel.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerantie</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transformeren</translation>
    </message>
    <message>
        <source>Length of line, to each side of the pen, that is smoothed. Waves up to this length can be removed.</source>
        <translation>Lengte van de lijn, aan elke kant van de pen, die wordt gladgestreken. Golven tot deze lengte kunnen worden verwijderd.</translation>
    </message>
    <message>
        <source>Length of line, to each side of the pen, whose width changes.</source>
        <translation>Lengte van de lijn, aan elke kant van de pen, waarvan de breedte verandert.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichten</translation>
    </message>
    <message>
        <source>What a touch does</source>
        <translation>Wat een aanraking doet</translation>
    </message>
    <message>
        <source>How to combine with the previous selection; the first button of the pen adds, the second subtracts.</source>
        <translation>Hoe met de vorige selectie wordt gecombineerd; de eerste penknop voegt toe, de tweede trekt af.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Gummen</translation>
    </message>
    <message>
        <source>What is covered, the part of a line up to its next crossings, or the whole line.</source>
        <translation>Wat bedekt is, het deel van een lijn tot de volgende kruisingen, of de hele lijn.</translation>
    </message>
    <message>
        <source>The medium: how it looks and how it slides.</source>
        <translation>Het tekenmiddel: hoe het eruitziet en hoe het glijdt.</translation>
    </message>
    <message>
        <source>The material of the surface: its hardness and its friction.</source>
        <translation>Het materiaal van de ondergrond: de hardheid en de wrijving.</translation>
    </message>
    <message>
        <source>How pull, transform and the attraction of ends resist: without jumps (felt), or by equations 8 to 11 of the paper as printed, which vibrate. For study.</source>
        <translation>Hoe trekken, transformeren en de aantrekking van lijneinden weerstand geven: zonder sprongen (felt) of volgens vergelijkingen 8 tot 11 van het artikel zoals gedrukt (paper); die trillen. Voor studie.</translation>
    </message>
    <message>
        <source>Law of the forces</source>
        <translation>Wet van de krachten</translation>
    </message>
    <message>
        <source>Only the plane</source>
        <translation>Alleen het vlak</translation>
    </message>
    <message>
        <source>On the page, the plane of the surface is the only force: no friction, grain, attraction or guide. To compare other forces with.</source>
        <translation>Op de pagina is het vlak van de ondergrond de enige kracht: geen wrijving, korrel, aantrekking of geleiding. Om andere krachten mee te vergelijken.</translation>
    </message>
    <message>
        <source>Whether ends of lines attract the pen (force), connect to the dragged end (snap), or both.</source>
        <translation>Of lijneinden de pen aantrekken (kracht), met het gesleepte eind verbinden (vastklikken), of beide.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Width of a line at full pressure; at least that of the thinnest line.</source>
        <translation>Breedte van een lijn bij volle druk; minstens die van de dunste lijn.</translation>
    </message>
    <message>
        <source>Width of a line without pressure.</source>
        <translation>Breedte van een lijn zonder druk.</translation>
    </message>
    <message>
        <source>Width of a retraced line without pressure.</source>
        <translation>Breedte van een overgetrokken lijn zonder druk.</translation>
    </message>
    <message>
        <source>If nothing is selected, a touch selects the nearest line within this distance.</source>
        <translation>Als er niets is geselecteerd, selecteert een aanraking de dichtstbijzijnde lijn binnen deze afstand.</translation>
    </message>
    <message>
        <source>add</source>
        <translation>toevoegen</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>blackboard</source>
        <translation>schoolbord</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>brush</source>
        <translation>penseel</translation>
    </message>
    <message>
        <source>chalk</source>
        <translation>krijt</translation>
    </message>
    <message>
        <source>crayon</source>
        <translation>waskrijt</translation>
    </message>
    <message>
        <source>crossing</source>
        <translation>kruising</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>vilt</translation>
    </message>
    <message>
        <source>felt-tip</source>
        <translation>viltstift</translation>
    </message>
    <message>
        <source>force</source>
        <translation>kracht</translation>
    </message>
    <message>
        <source>free</source>
        <translation>vrij</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>glas</translation>
    </message>
    <message>
        <source>grab</source>
        <translation>pakken</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>traagheid</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verplaatsen</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
    <message>
        <source>on-curve</source>
        <translation>op de kromme</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>papier</translation>
    </message>
    <message>
        <source>pencil</source>
        <translation>potlood</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punten</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>druk</translation>
    </message>
    <message>
        <source>printed</source>
        <translation>gedrukt</translation>
    </message>
    <message>
        <source>push</source>
        <translation>duwen</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rechthoek</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>vervangen</translation>
    </message>
    <message>
        <source>retrace</source>
        <translation>overtrekken</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>draaien</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>schalen</translation>
    </message>
    <message>
        <source>snap</source>
        <translation>vastklikken</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>zacht</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>rekken</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>lijn</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>lijnen</translation>
    </message>
    <message>
        <source>subtract</source>
        <translation>aftrekken</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>vegen</translation>
    </message>
    <message>
        <source>thicker</source>
        <translation>dikker</translation>
    </message>
    <message>
        <source>thinner</source>
        <translation>dunner</translation>
    </message>
    <message>
        <source>touched</source>
        <translation>geraakte</translation>
    </message>
    <message>
        <source>towed</source>
        <translation>gesleept</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Canvas</translation>
    </message>
    <message>
        <source>Rough paper</source>
        <translation>Ruw papier</translation>
    </message>
    <message>
        <source>Watercolour paper</source>
        <translation>Aquarelpapier</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Hout</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>canvas</translation>
    </message>
    <message>
        <source>rough-paper</source>
        <translation>ruw papier</translation>
    </message>
    <message>
        <source>watercolour</source>
        <translation>aquarelpapier</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>hout</translation>
    </message>
    <message>
        <source>Above 1, light pressure stays pale for longer; below 1, lines darken sooner.</source>
        <translation>Boven 1 blijft lichte druk langer bleek, onder 1 worden lijnen eerder donker.</translation>
    </message>
    <message>
        <source>Another number gives another relief of the same character.</source>
        <translation>Een ander getal geeft een ander reliëf van dezelfde aard.</translation>
    </message>
    <message>
        <source>Brightness of the sound</source>
        <translation>Helderheid van het geluid</translation>
    </message>
    <message>
        <source>Character of the grain</source>
        <translation>Aard van de korrel</translation>
    </message>
    <message>
        <source>Coefficient of friction of a pencil on this surface.</source>
        <translation>Wrijvingscoëfficiënt van een potlood op deze ondergrond.</translation>
    </message>
    <message>
        <source>Coefficient of friction on paper, unless a pair sets another.</source>
        <translation>Wrijvingscoëfficiënt op papier, tenzij een paar een andere instelt.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kleur</translation>
    </message>
    <message>
        <source>Crumbs</source>
        <translation>Kruimels</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Demping</translation>
    </message>
    <message>
        <source>Damping while the tip sticks.</source>
        <translation>Demping terwijl de punt kleeft.</translation>
    </message>
    <message>
        <source>Damping of the hold</source>
        <translation>Demping van het houvast</translation>
    </message>
    <message>
        <source>Dark rim</source>
        <translation>Donkere rand</translation>
    </message>
    <message>
        <source>Depth, heavy</source>
        <translation>Diepte, hard</translation>
    </message>
    <message>
        <source>Depth, light</source>
        <translation>Diepte, licht</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>Tekent</translation>
    </message>
    <message>
        <source>Can be chosen for drawing (off for erasers).</source>
        <translation>Kan worden gekozen om te tekenen (uit voor gummen).</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>From dull to bright.</source>
        <translation>Van dof tot helder.</translation>
    </message>
    <message>
        <source>Grain wavelength. A custom relief spans 32 wavelengths.</source>
        <translation>Golflengte van de korrel. Een eigen reliëf is 32 golflengten breed.</translation>
    </message>
    <message>
        <source>Grain in the eye</source>
        <translation>Korrel voor het oog</translation>
    </message>
    <message>
        <source>Grain in the hand</source>
        <translation>Korrel in de hand</translation>
    </message>
    <message>
        <source>Ink fades in from this far below the depth to this far above it.</source>
        <translation>De inkt begint zo ver onder de diepte en dekt zo ver erboven volledig.</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Hardheid</translation>
    </message>
    <message>
        <source>Height of the grain</source>
        <translation>Hoogte van de korrel</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Houvast</translation>
    </message>
    <message>
        <source>Amount of dry-brush streaking.</source>
        <translation>Hoeveelheid strepen als van een droge kwast.</translation>
    </message>
    <message>
        <source>Width of the soft edge of a line, as a share of its radius.</source>
        <translation>Breedte van de zachte rand van een lijn, als aandeel van de straal.</translation>
    </message>
    <message>
        <source>How hard the surface pushes back, if the device allows it.</source>
        <translation>Hoe hard de ondergrond terugduwt, als het apparaat dat toelaat.</translation>
    </message>
    <message>
        <source>How loud a pen is on this surface; 0 is silent.</source>
        <translation>Hoe luid een pen op deze ondergrond is; 0 is stil.</translation>
    </message>
    <message>
        <source>How loud the medium rubs; 0 is silent.</source>
        <translation>Hoe luid het medium wrijft; 0 is stil.</translation>
    </message>
    <message>
        <source>How much of the medium is laid on at full pressure.</source>
        <translation>Hoeveel van het medium bij volle druk wordt aangebracht.</translation>
    </message>
    <message>
        <source>How much darker a wet line dries at its edge.</source>
        <translation>Hoeveel donkerder een natte lijn aan de rand droogt.</translation>
    </message>
    <message>
        <source>How much of the medium is laid on without pressure.</source>
        <translation>Hoeveel van het medium zonder druk wordt aangebracht.</translation>
    </message>
    <message>
        <source>How much of the pen&apos;s motion into the surface is damped.</source>
        <translation>Hoe sterk de beweging van de pen in de ondergrond wordt gedempt.</translation>
    </message>
    <message>
        <source>How easily the tip squeaks by sticking and slipping.</source>
        <translation>Hoe gemakkelijk de punt piept door kleven en glijden.</translation>
    </message>
    <message>
        <source>How stiffly the tip sticks before it slides.</source>
        <translation>Hoe stijf de punt kleeft voordat die glijdt.</translation>
    </message>
    <message>
        <source>Tone at full tilt, as a share of the tone with an upright pen.</source>
        <translation>Toon bij volle helling, als aandeel van de toon bij een rechte pen.</translation>
    </message>
    <message>
        <source>Width of a line at full tilt, as a multiple of the width with an upright pen.</source>
        <translation>Breedte van een lijn bij volle helling, als veelvoud van de breedte bij een rechte pen.</translation>
    </message>
    <message>
        <source>Default colour of this medium.</source>
        <translation>Standaardkleur van dit medium.</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Luidheid</translation>
    </message>
    <message>
        <source>Opacity of the inked parts at tone 0.</source>
        <translation>Dekking van de ingekleurde delen bij toon 0.</translation>
    </message>
    <message>
        <source>Opacity of the inked parts at tone 1.</source>
        <translation>Dekking van de ingekleurde delen bij toon 1.</translation>
    </message>
    <message>
        <source>Opacity, heavy</source>
        <translation>Dekking, hard</translation>
    </message>
    <message>
        <source>Opacity, light</source>
        <translation>Dekking, licht</translation>
    </message>
    <message>
        <source>Pressure curve of the tone</source>
        <translation>Drukkromme van de toon</translation>
    </message>
    <message>
        <source>Pressure curve of the width</source>
        <translation>Drukkromme van de breedte</translation>
    </message>
    <message>
        <source>Root mean square of the heights; 0 is smooth.</source>
        <translation>Effectieve waarde van de hoogten; 0 is glad.</translation>
    </message>
    <message>
        <source>Seed of the grain</source>
        <translation>Startwaarde van de korrel</translation>
    </message>
    <message>
        <source>How much grain the medium adds by itself: dust and crumbs.</source>
        <translation>Hoeveel korrel het tekenmiddel zelf toevoegt: stof en kruimels.</translation>
    </message>
    <message>
        <source>Share of the relief that firm pressure flattens, for the hand and for the eye.</source>
        <translation>Aandeel van het reliëf dat stevige druk afvlakt, voelbaar en zichtbaar.</translation>
    </message>
    <message>
        <source>Size of the crumbs</source>
        <translation>Grootte van de kruimels</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Zachte rand</translation>
    </message>
    <message>
        <source>Softness of the grain</source>
        <translation>Zachtheid van de korrel</translation>
    </message>
    <message>
        <source>Squeak</source>
        <translation>Piepen</translation>
    </message>
    <message>
        <source>Streaks</source>
        <translation>Strepen</translation>
    </message>
    <message>
        <source>Parts of the relief below this height stay bare at tone 1.</source>
        <translation>Delen van het reliëf onder deze hoogte blijven kaal bij toon 1.</translation>
    </message>
    <message>
        <source>Wavelength of the crumbs.</source>
        <translation>Golflengte van de kruimels.</translation>
    </message>
    <message>
        <source>Tone at full pressure</source>
        <translation>Toon bij volle druk</translation>
    </message>
    <message>
        <source>Tone when tilted</source>
        <translation>Toon bij een schuine pen</translation>
    </message>
    <message>
        <source>Tone at light pressure</source>
        <translation>Toon bij lichte druk</translation>
    </message>
    <message>
        <source>Wear of the grain</source>
        <translation>Slijtage van de korrel</translation>
    </message>
    <message>
        <source>Parts of the relief below this height stay bare at tone 0.</source>
        <translation>Delen van het reliëf onder deze hoogte blijven kaal bij toon 0.</translation>
    </message>
    <message>
        <source>Shape of the relief.</source>
        <translation>Vorm van het reliëf.</translation>
    </message>
    <message>
        <source>Width when tilted</source>
        <translation>Breedte bij een schuine pen</translation>
    </message>
    <message>
        <source>Width of a line at full pressure.</source>
        <translation>Breedte van een lijn bij volle druk.</translation>
    </message>
    <message>
        <source>Width of the grain</source>
        <translation>Breedte van de korrel</translation>
    </message>
    <message>
        <source>fibres</source>
        <translation>vezels</translation>
    </message>
    <message>
        <source>grain</source>
        <translation>korrel</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>afbeelding</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>ruw</translation>
    </message>
    <message>
        <source>weave</source>
        <translation>weefsel</translation>
    </message>
    <message>
        <source>brush-pen</source>
        <translation>penseelstift</translation>
    </message>
    <message>
        <source>charcoal</source>
        <translation>houtskool</translation>
    </message>
    <message>
        <source>ink-pen</source>
        <translation>inktpen</translation>
    </message>
    <message>
        <source>pencil-hard</source>
        <translation>hard potlood</translation>
    </message>
    <message>
        <source>pencil-soft</source>
        <translation>zacht potlood</translation>
    </message>
    <message>
        <source>Force that draws a slow pen to its target, beyond the friction of the device.</source>
        <translation>Kracht die een langzame pen naar zijn doel trekt, boven op de wrijving van het apparaat.</translation>
    </message>
    <message>
        <source>How near to its target a line that is meant to meet it is connected.</source>
        <translation>Hoe dicht bij haar doel een lijn wordt verbonden die het moet raken.</translation>
    </message>
    <message>
        <source>How near to its target the pen is attracted, if it comes slowly and heads for it.</source>
        <translation>Hoe dicht bij zijn doel de pen wordt aangetrokken, als hij er langzaam op af komt.</translation>
    </message>
    <message>
        <source>Lines that meet share the point but stay two lines; a line that meets both ends of another still closes it.</source>
        <translation>Lijnen die elkaar raken delen het punt maar blijven er twee; een lijn die beide uiteinden van een andere raakt, sluit die toch.</translation>
    </message>
    <message>
        <source>Whether a line that is meant to meet another or itself is attracted (force), connected (snap), or both.</source>
        <translation>Of een lijn die een andere of zichzelf moet raken wordt aangetrokken (kracht), verbonden (vastklikken), of beide.</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Tekenmiddel</translation>
    </message>
    <message>
        <source>Draw; press harder for a broader line. End on a line’s end to join it.</source>
        <translation>Teken; druk harder voor een bredere lijn. Eindig op een lijneinde om te verbinden.</translation>
    </message>
    <message>
        <source>Drag a line to bend it; drag back to undo the bend.</source>
        <translation>Sleep een lijn om hem te buigen; sleep terug om de buiging op te heffen.</translation>
    </message>
    <message>
        <source>Rub along a line to smooth it; press harder to smooth it more.</source>
        <translation>Wrijf langs een lijn om hem glad te strijken; druk harder voor meer effect.</translation>
    </message>
    <message>
        <source>Rub a line to make it broader or thinner.</source>
        <translation>Wrijf over een lijn om hem breder of dunner te maken.</translation>
    </message>
    <message>
        <source>Erase what the ring touches.</source>
        <translation>Gum uit wat de ring raakt.</translation>
    </message>
    <message>
        <source>up to the crossings</source>
        <translation>tot aan de kruisingen</translation>
    </message>
    <message>
        <source>whole lines</source>
        <translation>hele lijnen</translation>
    </message>
    <message>
        <source>Draw around lines to select them, or click one.</source>
        <translation>Teken om lijnen heen om ze te selecteren, of klik er een aan.</translation>
    </message>
    <message>
        <source>adds</source>
        <translation>voegt toe</translation>
    </message>
    <message>
        <source>subtracts</source>
        <translation>trekt af</translation>
    </message>
    <message>
        <source>Drag inside to move, a corner to scale, outside it to turn.</source>
        <translation>Sleep binnenin om te verplaatsen, een hoek om te schalen, erbuiten om te draaien.</translation>
    </message>
    <message>
        <source>along one axis, in steps of 15°</source>
        <translation>langs één as, in stappen van 15°</translation>
    </message>
    <message>
        <source>about the centre</source>
        <translation>om het midden</translation>
    </message>
    <message>
        <source>a copy</source>
        <translation>een kopie</translation>
    </message>
    <message>
        <source>Drag the end of a line to another end.</source>
        <translation>Sleep het eind van een lijn naar een ander eind.</translation>
    </message>
    <message>
        <source>the end stays where you release it</source>
        <translation>het eind blijft waar je het loslaat</translation>
    </message>
    <message>
        <source>ends and corners move along, or stay</source>
        <translation>uiteinden en hoeken bewegen mee of blijven</translation>
    </message>
    <message>
        <source>Push lines away from the side of the pen.</source>
        <translation>Duw lijnen weg met de zijkant van de pen.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Tekenen</translation>
    </message>
    <message>
        <source>Lines become smooth curves while you draw; press harder for a broader line. Near its start, an outline closes by itself.</source>
        <translation>Lijnen worden vloeiende krommen terwijl je tekent; druk harder voor een bredere lijn. Dicht bij het begin sluit een omtrek vanzelf.</translation>
    </message>
    <message>
        <source>Pull and push</source>
        <translation>Trekken en duwen</translation>
    </message>
    <message>
        <source>Is a line not quite right? Grab it and pull. Like a wire, it resists more the further you pull.</source>
        <translation>Klopt een lijn niet helemaal? Pak hem vast en trek. Als een draad biedt hij meer weerstand naarmate je verder trekt.</translation>
    </message>
    <message>
        <source>Lines that are already drawn can get another colour. Tap one, or drag across several.</source>
        <translation>Ook getekende lijnen kunnen een andere kleur krijgen. Tik er een aan of sleep over meerdere.</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Vormen</translation>
    </message>
    <message>
        <source>Drag from corner to corner: a line, a rectangle or an ellipse. Shift makes a square or a circle.</source>
        <translation>Sleep van hoek naar hoek: een lijn, een rechthoek of een ellips. Met Shift ontstaat een vierkant of een cirkel.</translation>
    </message>
    <message>
        <source>Brush along rough strokes, and they become one line. The bundle resists until it is one.</source>
        <translation>Strijk langs ruwe streken, en ze worden één lijn. De bundel biedt weerstand tot het er één is.</translation>
    </message>
    <message>
        <source>A tap fills the area between lines, a drag fills several. The colour follows the lines when you change them.</source>
        <translation>Tikken vult het vlak tussen lijnen, slepen vult er meerdere. De kleur volgt de lijnen als u ze verandert.</translation>
    </message>
    <message>
        <source>Rub along a shaky line to remove the jitter and keep the shape.</source>
        <translation>Wrijf langs een beverige lijn om het beven te verwijderen en de vorm te behouden.</translation>
    </message>
    <message>
        <source>Press on a finished line to make it broader.</source>
        <translation>Druk op een voltooide lijn om hem breder te maken.</translation>
    </message>
    <message>
        <source>Erase what is covered, a line up to its next crossing, or a whole line.</source>
        <translation>Gum uit wat bedekt is, een lijn tot de volgende kruising, of een hele lijn.</translation>
    </message>
    <message>
        <source>Draw a loop around lines to select them, or touch one.</source>
        <translation>Teken een lus om lijnen om ze te selecteren, of raak er een aan.</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Verplaatsen en draaien</translation>
    </message>
    <message>
        <source>Drag the selection. Lines that cross it stay attached and resist, and you feel how much.</source>
        <translation>Sleep de selectie. Lijnen die haar kruisen blijven verbonden en bieden weerstand, en je voelt hoeveel.</translation>
    </message>
    <message>
        <source>Drag one end onto another: they snap together and become one line.</source>
        <translation>Sleep een eind op een ander: ze klikken vast en worden één lijn.</translation>
    </message>
    <message>
        <source>Colour of the surface. A page whose colour you changed keeps that colour.</source>
        <translation>Kleur van de ondergrond. Een pagina waarvan je de kleur hebt gewijzigd, behoudt die.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief shows in the ink; 0 for wet ink.</source>
        <translation>Hoeveel van het reliëf van de ondergrond in de inkt te zien is; 0 voor natte inkt.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief the hand feels through it.</source>
        <translation>Hoeveel van het reliëf van de ondergrond de hand erdoorheen voelt.</translation>
    </message>
    <message>
        <source>Gives</source>
        <translation>Geeft</translation>
    </message>
    <message>
        <source>Gives lines that are already drawn the current colour or medium.</source>
        <translation>Geeft lijnen die al getekend zijn de huidige kleur of het huidige tekenmiddel.</translation>
    </message>
    <message>
        <source>Lines whose ink is within this distance of the pen are changed.</source>
        <translation>Lijnen waarvan de inkt binnen deze afstand van de pen ligt, worden gewijzigd.</translation>
    </message>
    <message>
        <source>Recolour</source>
        <translation>Herkleuren</translation>
    </message>
    <message>
        <source>Tap a line, or drag across several, to give them the current colour.</source>
        <translation>Tik op een lijn, of sleep over meerdere, om ze de huidige kleur te geven.</translation>
    </message>
    <message>
        <source>The lines get the current colour with its opacity, the current medium, or both.</source>
        <translation>De lijnen krijgen de huidige kleur met haar dekking, het huidige tekenmiddel, of beide.</translation>
    </message>
    <message>
        <source>colour and medium</source>
        <translation>kleur en tekenmiddel</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>tekenmiddel</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>kleur</translation>
    </message>
    <message>
        <source>Drag from one corner of the shape to the opposite one.</source>
        <translation>Sleep van een hoek van de vorm naar de tegenoverliggende.</translation>
    </message>
    <message>
        <source>Draws straight lines, rectangles and ellipses.</source>
        <translation>Tekent rechte lijnen, rechthoeken en ellipsen.</translation>
    </message>
    <message>
        <source>The shape that is drawn from corner to corner, with the current medium and size.</source>
        <translation>De vorm die van hoek tot hoek wordt getekend, met het huidige tekenmiddel en de huidige grootte.</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>ellips</translation>
    </message>
    <message>
        <source>from the centre</source>
        <translation>vanuit het midden</translation>
    </message>
    <message>
        <source>line</source>
        <translation>lijn</translation>
    </message>
    <message>
        <source>square, circle, steps of 15°</source>
        <translation>vierkant, cirkel, stappen van 15°</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>rechte lijn</translation>
    </message>
    <message>
        <source>straight, in steps of 15°</source>
        <translation>recht, in stappen van 15°</translation>
    </message>
    <message>
        <source>Gather</source>
        <translation>Bundelen</translation>
    </message>
    <message>
        <source>Presses a bundle of rough strokes into one line.</source>
        <translation>Maakt van een bundel ruwe streken één lijn.</translation>
    </message>
    <message>
        <source>Brush along rough strokes to press them into one line.</source>
        <translation>Strijk langs ruwe streken om er één lijn van te maken.</translation>
    </message>
    <message>
        <source>The brush gathers lines within this distance that run along its path.</source>
        <translation>Het penseel bundelt lijnen binnen deze afstand die langs zijn weg lopen.</translation>
    </message>
    <message>
        <source>Width of the line</source>
        <translation>Breedte van de lijn</translation>
    </message>
    <message>
        <source>The line gets the median width of its strokes, or the width of the strip that they cover.</source>
        <translation>De lijn krijgt de mediane breedte van haar streken, of de breedte van de strook die zij bedekken.</translation>
    </message>
    <message>
        <source>Force level of friction, grain and the resistance of the bundle. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van wrijving, korrel en weerstand van de bundel. Heeft geen invloed op de hardheid van het oppervlak.</translation>
    </message>
    <message>
        <source>median</source>
        <translation>mediaan</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>strook</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Vullen</translation>
    </message>
    <message>
        <source>Tap an area to fill it, or drag across several. Tap again to remove the fill.</source>
        <translation>Tik een gebied aan om het te vullen, of sleep over meerdere. Nogmaals tikken verwijdert de vulling.</translation>
    </message>
    <message>
        <source>removes fills</source>
        <translation>verwijdert vullingen</translation>
    </message>
    <message>
        <source>Fills the areas between lines. Fills follow their lines.</source>
        <translation>Vult de gebieden tussen lijnen. Vullingen volgen hun lijnen.</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Opening</translation>
    </message>
    <message>
        <source>Gaps of the outline up to this size count as closed. 0: only outlines that touch.</source>
        <translation>Openingen in de omtrek tot deze grootte gelden als gesloten. 0: alleen omtrekken die elkaar raken.</translation>
    </message>
    <message>
        <source>Opened areas</source>
        <translation>Geopende gebieden</translation>
    </message>
    <message>
        <source>If an edit opens the outline of a fill: a straight edge closes it, or the fill is removed.</source>
        <translation>Als een bewerking de omtrek van een vulling opent: een rechte rand sluit hem, of de vulling wordt verwijderd.</translation>
    </message>
    <message>
        <source>Felt edge</source>
        <translation>Voelbare rand</translation>
    </message>
    <message>
        <source>Height of the soft ridge at the edge of the area under the pen while it fills.</source>
        <translation>Hoogte van de zachte richel aan de rand van het gebied onder de pen terwijl die vult.</translation>
    </message>
    <message>
        <source>Force level of the surface&apos;s friction and grain, and of the ridge. Does not affect the surface&apos;s hardness.</source>
        <translation>Krachtniveau van de wrijving en korrel van het oppervlak en van de richel. Heeft geen invloed op de hardheid van het oppervlak.</translation>
    </message>
    <message>
        <source>close</source>
        <translation>sluiten</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>verwijderen</translation>
    </message>
    <message>
        <source>Steady hand</source>
        <translation>Vaste hand</translation>
    </message>
    <message>
        <source>Removes the shaking of the hand from lines; Preferences &gt; Pen measures how it shakes.</source>
        <translation>Haalt het beven van de hand uit lijnen; Voorkeuren &gt; Pen meet hoe de hand beeft.</translation>
    </message>
    <message>
        <source>Shakes a second</source>
        <translation>Trillingen per seconde</translation>
    </message>
    <message>
        <source>How often the hand shakes; for the steady hand.</source>
        <translation>Hoe vaak de hand beeft; voor de vaste hand.</translation>
    </message>
    <message>
        <source>Size of the shaking</source>
        <translation>Grootte van het beven</translation>
    </message>
    <message>
        <source>How far the hand shakes, from the middle to one side; for the steady hand.</source>
        <translation>Hoe ver de hand beeft, van het midden naar één kant; voor de vaste hand.</translation>
    </message>
    <message>
        <source>Direction of the shaking</source>
        <translation>Richting van het beven</translation>
    </message>
    <message>
        <source>Direction of the largest shaking, clockwise from the right; for the steady hand.</source>
        <translation>Richting van het sterkste beven, met de klok mee vanaf rechts; voor de vaste hand.</translation>
    </message>
    <message>
        <source>Scratch out</source>
        <translation>Doorhalen</translation>
    </message>
    <message>
        <source>Scribble over lines, at least six times to and fro: deleting them is offered.</source>
        <translation>Over lijnen krabbelen, minstens zes keer heen en weer: Feltline biedt aan ze te verwijderen.</translation>
    </message>
    <message>
        <source>Circle twice to select</source>
        <translation>Twee keer omcirkelen om te selecteren</translation>
    </message>
    <message>
        <source>Circle lines twice in one stroke: selecting them is offered.</source>
        <translation>Lijnen in één haal twee keer omcirkelen: Feltline biedt aan ze te selecteren.</translation>
    </message>
    <message>
        <source>Hold for a shape</source>
        <translation>Vasthouden voor een vorm</translation>
    </message>
    <message>
        <source>Hold the pen still at the end of a line: the shape that it resembles is offered. Press harder to get it, or go on drawing.</source>
        <translation>De pen aan het einde van een lijn stilhouden: Feltline biedt de vorm aan waarop ze lijkt. Harder drukken neemt die aan, verder tekenen wijst die af.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction, hold, retracing and stabiliser. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van wrijving, korrel, aantrekking, houvast en stabilisator. De hardheid van de ondergrond verandert niet.</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lezen</translation>
    </message>
    <message>
        <source>Reads a drawing without eyes: lines attract the pen, and are heard and spoken.</source>
        <translation>Leest een tekening zonder ogen: lijnen trekken de pen aan en zijn te horen en worden uitgesproken.</translation>
    </message>
    <message>
        <source>Touch a line and follow it: it holds the pen, its ends and crossings click.</source>
        <translation>Raak een lijn aan en volg haar: ze houdt de pen vast, haar uiteinden en kruisingen klikken.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>zichtbare</translation>
    </message>
    <message>
        <source>current</source>
        <translation>huidige</translation>
    </message>
    <message>
        <source>Reads all visible layers, or only the current one. Alt+Page up and Alt+Page down choose it.</source>
        <translation>Leest alle zichtbare lagen of alleen de huidige. Alt+Page Up en Alt+Page Down kiezen die.</translation>
    </message>
    <message>
        <source>Sound of the distance</source>
        <translation>Geluid van de afstand</translation>
    </message>
    <message>
        <source>A tone says how far the nearest line is: pulses that become faster and higher, and a steady tone on the line.</source>
        <translation>Een toon zegt hoe ver de dichtstbijzijnde lijn is: pulsen die sneller en hoger worden, en een aanhoudende toon op de lijn.</translation>
    </message>
    <message>
        <source>Force level of the lines. Does not affect the hardness of the surface.</source>
        <translation>Sterkte van de krachten van de lijnen. De hardheid van het oppervlak blijft gelijk.</translation>
    </message>
    <message>
        <source>Holds the width at steps such as 0.3, 0.5 and 0.7 mm. A force-feedback pen clicks from step to step.</source>
        <translation>Houdt de breedte op stappen zoals 0,3, 0,5 en 0,7 mm. Een pen met krachtterugkoppeling klikt van stap naar stap.</translation>
    </message>
    <message>
        <source>Press hard for whole lines</source>
        <translation>Hard drukken voor hele lijnen</translation>
    </message>
    <message>
        <source>Pressing hard erases the whole line under the ring. A force-feedback pen clicks at this pressure.</source>
        <translation>Hard drukken wist de hele lijn onder de ring. Een pen met krachtterugkoppeling klikt bij deze druk.</translation>
    </message>
    <message>
        <source>Guard of other lines</source>
        <translation>Andere lijnen beschermen</translation>
    </message>
    <message>
        <source>Largest force with which lines that the eraser has not touched yet push a force-feedback pen away. Push on to erase them, too.</source>
        <translation>Grootste kracht waarmee lijnen die de gum nog niet heeft geraakt, een pen met krachtterugkoppeling wegduwen. Wie verder duwt, gumt ook die uit.</translation>
    </message>
    <message>
        <source>Widths in steps</source>
        <translation>Breedtes in stappen</translation>
    </message>
    <message>
        <source>A drawing can be read without eyes: lines hold the pen, ends and crossings click, and what is under the pen is spoken.</source>
        <translation>Een tekening kan zonder ogen gelezen worden: lijnen houden de pen vast, einden en kruisingen klikken, en wat onder de pen ligt, wordt uitgesproken.</translation>
    </message>
    <message>
        <source>Felt steps</source>
        <translation>Voelbare stappen</translation>
    </message>
    <message>
        <source>Gestures</source>
        <translation>Gebaren</translation>
    </message>
    <message>
        <source>Hold the pen at the end of a line and press: the line becomes the shape. Scribble over lines, and you are asked whether to delete them.</source>
        <translation>Blijf aan het einde van een lijn staan en druk: de lijn wordt de vorm. Kras over lijnen, en Feltline vraagt of ze weg mogen.</translation>
    </message>
    <message>
        <source>If your hand shakes, lines can be calm: the shaking is measured once and removed while you draw.</source>
        <translation>Ook als je hand beeft, kunnen lijnen rustig zijn: het beven wordt één keer gemeten en tijdens het tekenen verwijderd.</translation>
    </message>
    <message>
        <source>Press the eraser until it clicks, and the whole line goes. The pencil has such steps too: they hold the width of a line.</source>
        <translation>Druk de gum in tot hij klikt: de hele lijn verdwijnt. Ook het potlood heeft zulke stappen; ze houden de breedte van een lijn vast.</translation>
    </message>
    <message>
        <source>Around the pen there are eight choices, each in its own direction: a well that attracts the pen, with a ridge to the next one. Lift the pen to choose.</source>
        <translation>Rond de pen liggen acht keuzes, elk in een eigen richting: een kuil die de pen aantrekt, met een richel naar de volgende. Til de pen op om te kiezen.</translation>
    </message>
    <message>
        <source>Ring of tools</source>
        <translation>Ring met gereedschappen</translation>
    </message>
    <message>
        <source>A ruler, a compass or a perspective holds the pen gently, and lets go if you mean to leave it. One key makes a line along it exact.</source>
        <translation>Een liniaal, een passer of een perspectief houdt de pen zacht vast en laat los als je ervan weg wilt. Eén toets maakt een lijn erlangs exact.</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>Hulplijnen</translation>
    </message>
    <message>
        <source>Drag away from the touch to draw the lines to it; drag back to undo.</source>
        <translation>Sleep weg van het aanraakpunt om de lijnen ernaartoe te trekken; terugslepen maakt het ongedaan.</translation>
    </message>
    <message>
        <source>Drag away from the touch to spread the lines around it; drag back to undo.</source>
        <translation>Sleep weg van het aanraakpunt om de lijnen eromheen uit elkaar te duwen; terugslepen maakt het ongedaan.</translation>
    </message>
    <message>
        <source>How far the brush reaches along the line, to each side; the radius of the circle that bulge and pinch change.</source>
        <translation>Hoe ver het penseel langs de lijn reikt, naar elke kant; de straal van de cirkel die opbollen en samenknijpen veranderen.</translation>
    </message>
    <message>
        <source>Pull a stretch of a line (brush), bend one segment (grab), push lines from outside (push), move a line along the pen (sweep), spread all lines around the touch (bulge), or draw them together (pinch).</source>
        <translation>Trek aan een stuk van een lijn (penseel), buig één segment (pakken), duw lijnen van buitenaf (duwen), voer een lijn langs de pen (vegen), duw alle lijnen rond het aanraakpunt uit elkaar (opbollen), of trek ze naar elkaar toe (samenknijpen).</translation>
    </message>
    <message>
        <source>bulge</source>
        <translation>opbollen</translation>
    </message>
    <message>
        <source>pinch</source>
        <translation>samenknijpen</translation>
    </message>
    <message>
        <source>Angle of the hatching</source>
        <translation>Hoek van de arcering</translation>
    </message>
    <message>
        <source>Arrow heads</source>
        <translation>Pijlpunten</translation>
    </message>
    <message>
        <source>Direction of the hatching on the page, clockwise from the x axis.</source>
        <translation>Richting van de arcering op de pagina, met de klok mee vanaf de x-as.</translation>
    </message>
    <message>
        <source>Distance between the lines of the hatching.</source>
        <translation>Afstand tussen de lijnen van de arcering.</translation>
    </message>
    <message>
        <source>Gap between dashes or repeats, in widths of the line.</source>
        <translation>Ruimte tussen streepjes of herhalingen, in breedten van de lijn.</translation>
    </message>
    <message>
        <source>Length of a dash</source>
        <translation>Lengte van een streepje</translation>
    </message>
    <message>
        <source>Length of a dash or of one repeat, in widths of the line; 1 makes dots.</source>
        <translation>Lengte van een streepje of van één herhaling, in breedten van de lijn; 1 geeft punten.</translation>
    </message>
    <message>
        <source>Length of an arrow head</source>
        <translation>Lengte van een pijlpunt</translation>
    </message>
    <message>
        <source>Length of an arrow head, in widths of the line.</source>
        <translation>Lengte van een pijlpunt, in breedten van de lijn.</translation>
    </message>
    <message>
        <source>Spacing of the hatching</source>
        <translation>Afstand van de arcering</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stijl</translation>
    </message>
    <message>
        <source>The ends of an open line that have arrow heads.</source>
        <translation>De uiteinden van een open lijn die pijlpunten hebben.</translation>
    </message>
    <message>
        <source>Thinness</source>
        <translation>Smalheid</translation>
    </message>
    <message>
        <source>What is drawn in place of a solid line. Repeat and stretch use the shape.</source>
        <translation>Wat in plaats van een doorgetrokken lijn wordt getekend. Herhalen en uitrekken gebruiken de vorm.</translation>
    </message>
    <message>
        <source>Width of dashes, rails, shafts and hatching lines, as a share of the width of the line.</source>
        <translation>Breedte van streepjes, rails, schachten en arceerlijnen, als deel van de breedte van de lijn.</translation>
    </message>
    <message>
        <source>dashes</source>
        <translation>streepjes</translation>
    </message>
    <message>
        <source>double</source>
        <translation>dubbel</translation>
    </message>
    <message>
        <source>end</source>
        <translation>einde</translation>
    </message>
    <message>
        <source>hatch</source>
        <translation>arcering</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>effen</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>herhalen</translation>
    </message>
    <message>
        <source>start</source>
        <translation>begin</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>A motion needs two key drawings: two layers with lines that are not locked.</source>
        <translation>Een beweging heeft twee sleuteltekeningen nodig: twee lagen met lijnen die niet vergrendeld zijn.</translation>
    </message>
    <message>
        <source>Export animation</source>
        <translation>Animatie exporteren</translation>
    </message>
    <message>
        <source>Choose a key drawing that has a next one to correct its matches.</source>
        <translation>Kies een sleuteltekening waarop nog een volgt om de koppelingen te corrigeren.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::AnimationDialog</name>
    <message>
        <source>Numbered PNG files</source>
        <translation>Genummerde PNG-bestanden</translation>
    </message>
    <message>
        <source>Numbered SVG files</source>
        <translation>Genummerde SVG-bestanden</translation>
    </message>
    <message>
        <source>One animated SVG</source>
        <translation>Eén bewegende SVG</translation>
    </message>
    <message>
        <source>Export animation</source>
        <translation>Animatie exporteren</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> pixels</translation>
    </message>
    <message>
        <source>The longer side of the pictures</source>
        <translation>De langste zijde van de afbeeldingen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporteren…</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formaat:</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Grootte:</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FilmView</name>
    <message>
        <source>Film of the key drawings</source>
        <translation>Film van de sleuteltekeningen</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MotionPanel</name>
    <message>
        <source>Add &amp;key drawing</source>
        <translation>&amp;Sleuteltekening toevoegen</translation>
    </message>
    <message>
        <source>Adds a layer for the next key drawing</source>
        <translation>Voegt een laag voor de volgende sleuteltekening toe</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>&amp;Doorschijnende buren</translation>
    </message>
    <message>
        <source>The key drawings before and after the current one shine through</source>
        <translation>De sleuteltekeningen voor en na de huidige schijnen door</translation>
    </message>
    <message>
        <source>&amp;Play the motion</source>
        <translation>Beweging afs&amp;pelen</translation>
    </message>
    <message>
        <source>Plays the key drawings and the drawings between them; Esc stops</source>
        <translation>Speelt de sleuteltekeningen en de tekeningen ertussen af; Esc stopt</translation>
    </message>
    <message>
        <source>Export &amp;animation…</source>
        <translation>&amp;Animatie exporteren…</translation>
    </message>
    <message>
        <source>Write the key drawings and the drawings between them as files</source>
        <translation>De sleuteltekeningen en de tekeningen ertussen als bestanden schrijven</translation>
    </message>
    <message>
        <source>Key drawings</source>
        <translation>Sleuteltekeningen</translation>
    </message>
    <message>
        <source>Each layer with lines that is not locked is a key drawing, from the bottom up</source>
        <translation>Elke laag met lijnen die niet vergrendeld is, is een sleuteltekening, van onder naar boven</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gelijkmatig</translation>
    </message>
    <message>
        <source>Starts slowly</source>
        <translation>Begint langzaam</translation>
    </message>
    <message>
        <source>Ends slowly</source>
        <translation>Eindigt langzaam</translation>
    </message>
    <message>
        <source>Starts and ends slowly</source>
        <translation>Begint en eindigt langzaam</translation>
    </message>
    <message>
        <source>In-&amp;betweens:</source>
        <translation>&amp;Tussentekeningen:</translation>
    </message>
    <message>
        <source>&amp;Hold:</source>
        <translation>&amp;Vasthouden:</translation>
    </message>
    <message>
        <source>&amp;Speed:</source>
        <translation>&amp;Snelheid:</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nieuwe tekening</translation>
    </message>
    <message>
        <source>Onion skin</source>
        <translation>Doorschijnend</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Afspelen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporteren…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Draw the second key drawing on a layer of its own.</source>
        <translation>Teken de tweede sleuteltekening op een eigen laag.</translation>
    </message>
    <message>
        <source>%1 frames, %2 s</source>
        <translation>%1 beelden, %2 s</translation>
    </message>
    <message>
        <source>Same &amp;timing for all key drawings</source>
        <translation>Zelfde &amp;timing voor alle sleuteltekeningen</translation>
    </message>
    <message>
        <source>Gives the in-betweens, hold and speed of this key drawing to all</source>
        <translation>Geeft alle de tussentekeningen, het vasthouden en de snelheid van deze sleuteltekening</translation>
    </message>
    <message>
        <source>Correct &amp;matches</source>
        <translation>Koppelingen &amp;corrigeren</translation>
    </message>
    <message>
        <source>Shows which line becomes which, and lets you draw from line to line</source>
        <translation>Toont welke lijn welke wordt, en laat u van lijn naar lijn slepen</translation>
    </message>
    <message>
        <source>The number of drawings from this key drawing to the next</source>
        <translation>Het aantal tekeningen van deze sleuteltekening naar de volgende</translation>
    </message>
    <message>
        <source>For how many frames this key drawing is shown</source>
        <translation>Hoeveel beelden deze sleuteltekening te zien is</translation>
    </message>
    <message>
        <source>The speed from this key drawing to the next</source>
        <translation>De snelheid van deze sleuteltekening naar de volgende</translation>
    </message>
    <message>
        <source>Same for all</source>
        <translation>Zelfde voor alle</translation>
    </message>
    <message>
        <source>Matches</source>
        <translation>Koppelingen</translation>
    </message>
    <message>
        <source>Another curve</source>
        <translation>Andere curve</translation>
    </message>
    <message>
        <source>%1: %2 (empty)</source>
        <translation>%1: %2 (leeg)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TimelapseActions</name>
    <message>
        <source>Export &amp;timelapse…</source>
        <translation>&amp;Timelapse exporteren…</translation>
    </message>
    <message>
        <source>Make a film of how a drawing was made, from a recording</source>
        <translation>Van een opname een film maken die laat zien hoe een tekening ontstond</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>Een opname kiezen</translation>
    </message>
    <message>
        <source>Recordings (*.ndjson *.felt)</source>
        <translation>Opnamen (*.ndjson *.felt)</translation>
    </message>
    <message>
        <source>Export timelapse</source>
        <translation>Timelapse exporteren</translation>
    </message>
    <message>
        <source>Making the film “%1”…</source>
        <translation>De film ‘%1’ wordt gemaakt…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>“%1” was not exported</source>
        <translation>‘%1’ is niet geëxporteerd</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>Changed in the recording: %1.</source>
        <translation>In de opname gewijzigd: %1.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TimelapseDialog</name>
    <message>
        <source>GIF (repeats, 256 colours)</source>
        <translation>GIF (herhaalt zich, 256 kleuren)</translation>
    </message>
    <message>
        <source>Animated SVG (for web pages)</source>
        <translation>Bewegende SVG (voor webpagina’s)</translation>
    </message>
    <message>
        <source>WebM film (VP9)</source>
        <translation>WebM-film (VP9)</translation>
    </message>
    <message>
        <source>This window, which is being recorded</source>
        <translation>Dit venster, dat wordt opgenomen</translation>
    </message>
    <message>
        <source>The recording in this drawing</source>
        <translation>De opname in deze tekening</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>Een bestand</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Kiezen…</translation>
    </message>
    <message>
        <source>&amp;Grain of the surface in dry media</source>
        <translation>&amp;Korrel van de ondergrond in droge tekenmiddelen</translation>
    </message>
    <message>
        <source>Export timelapse</source>
        <translation>Timelapse exporteren</translation>
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
        <translation>Automatisch: 30 s, of minder als het tekenen minder tijd kostte</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> pixels</translation>
    </message>
    <message>
        <source>The longer side of the film</source>
        <translation>De langste zijde van de film</translation>
    </message>
    <message>
        <source>&amp;Recording:</source>
        <translation>&amp;Opname:</translation>
    </message>
    <message>
        <source>File:</source>
        <translation>Bestand:</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formaat:</translation>
    </message>
    <message>
        <source>&amp;Length:</source>
        <translation>&amp;Lengte:</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Grootte:</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporteren…</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Bestand van de opname</translation>
    </message>
    <message>
        <source>A script (.ndjson) or a drawing (.felt)</source>
        <translation>Een script (.ndjson) of een tekening (.felt)</translation>
    </message>
    <message>
        <source>This format needs the program ffmpeg, which is not installed. Install the package “ffmpeg”, or export an animated SVG.</source>
        <translation>Dit formaat heeft het programma ffmpeg nodig, dat niet is geïnstalleerd. Installeer het pakket ‘ffmpeg’, of exporteer een bewegende SVG.</translation>
    </message>
    <message>
        <source>A recording is made by “feltline-desktop --record FILE.ndjson” or “feltline replay --recording”.</source>
        <translation>Een opname maken ‘feltline-desktop --record BESTAND.ndjson’ en ‘feltline replay --recording’.</translation>
    </message>
</context>
</TS>
