<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl_NL" sourcelanguage="en">
<context>
    <name>AddedStrokes</name>
    <message>
        <source>“%1” is another medium here than there: its strokes look as they do here</source>
        <translation>‘%1’ is hier een ander tekenmiddel dan daar: de lijnen ervan zien eruit zoals hier</translation>
    </message>
</context>
<context>
    <name>Arguments</name>
    <message>
        <source>Open a window of its own, with a fresh sheet.</source>
        <translation>Een eigen venster met een leeg vel openen.</translation>
    </message>
    <message>
        <source>Speak en, de or nl, whatever the system does.</source>
        <translation>Taal en, de of nl, wat het systeem ook spreekt.</translation>
    </message>
    <message>
        <source>Record all that happens to the drawing, for feltline replay --as-recorded.</source>
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
        <source>--size is WIDTHxHEIGHT, from 100 to 8000</source>
        <translation>--size is BREEDTExHOOGTE, van 100 tot 8000</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Voorbeelden:</translation>
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
        <source>Move the sheet while held</source>
        <translation>Vel verschuiven zolang ingedrukt</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>The tool&apos;s first modifier (Shift)</source>
        <translation>Eerste extra toets van het gereedschap (Shift)</translation>
    </message>
    <message>
        <source>The tool&apos;s second modifier (Ctrl)</source>
        <translation>Tweede extra toets van het gereedschap (Ctrl)</translation>
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
        <translation>Schrijft het getoonde palet.</translation>
    </message>
    <message>
        <source>&amp;Keep the colour</source>
        <translation>Kleur be&amp;waren</translation>
    </message>
    <message>
        <source>Puts the colour in use into a palette of your own.</source>
        <translation>Legt de gebruikte kleur in een eigen palet.</translation>
    </message>
    <message>
        <source>&amp;Take the colour out</source>
        <translation>Kleur &amp;weghalen</translation>
    </message>
    <message>
        <source>Takes the colour in use out of your own palette.</source>
        <translation>Haalt de gebruikte kleur uit je eigen palet.</translation>
    </message>
</context>
<context>
    <name>DeviceWords</name>
    <message>
        <source>the device is not connected any more</source>
        <translation>het apparaat is niet meer aangesloten</translation>
    </message>
    <message>
        <source>the device does not know where its arm is</source>
        <translation>het apparaat weet niet waar zijn arm is</translation>
    </message>
    <message>
        <source>the device has switched its forces off</source>
        <translation>het apparaat heeft zijn krachten uitgezet</translation>
    </message>
    <message>
        <source>its motors are warm</source>
        <translation>de motoren zijn warm</translation>
    </message>
    <message>
        <source>the device says what cannot be</source>
        <translation>het apparaat meldt wat niet kan</translation>
    </message>
    <message>
        <source>the device reports a fault</source>
        <translation>het apparaat meldt een fout</translation>
    </message>
    <message>
        <source>%1 is not connected any more.</source>
        <translation>%1 is niet meer aangesloten.</translation>
    </message>
    <message>
        <source>Draw on with mouse or tablet; nothing is lost. Look at its cable and its power.</source>
        <translation>Teken door met muis of tablet; er is niets verloren. Kijk naar de kabel en de voeding.</translation>
    </message>
    <message>
        <source>%1 does not know where its arm is.</source>
        <translation>%1 weet niet waar zijn arm is.</translation>
    </message>
    <message>
        <source>Draw on with mouse or tablet until it has found its home.</source>
        <translation>Teken door met muis of tablet tot het zijn uitgangsstand heeft gevonden.</translation>
    </message>
    <message>
        <source>%1 has switched its forces off.</source>
        <translation>%1 heeft zijn krachten uitgezet.</translation>
    </message>
    <message>
        <source>Its button or its own guard did that. Draw on without forces, or switch them on again there and here.</source>
        <translation>Dat deed de knop of de eigen beveiliging. Teken door zonder krachten, of zet ze daar en hier weer aan.</translation>
    </message>
    <message>
        <source>The motors of %1 are warm.</source>
        <translation>De motoren van %1 zijn warm.</translation>
    </message>
    <message>
        <source>Draw on without forces. After some minutes of rest they can be switched on again.</source>
        <translation>Teken door zonder krachten. Na enkele minuten rust kunnen ze weer aan.</translation>
    </message>
    <message>
        <source>%1 says what cannot be.</source>
        <translation>%1 meldt wat niet kan.</translation>
    </message>
    <message>
        <source>%1 reports a fault.</source>
        <translation>%1 meldt een fout.</translation>
    </message>
    <message>
        <source>Draw on without forces.</source>
        <translation>Teken door zonder krachten.</translation>
    </message>
    <message>
        <source>Draw on with mouse or tablet. Look at its cable, switch it off and on, and try again.</source>
        <translation>Teken door met muis of tablet. Kijk naar de kabel, zet het uit en aan, en probeer het opnieuw.</translation>
    </message>
</context>
<context>
    <name>EditActions</name>
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
        <source>Takes the last step back.</source>
        <translation>Neemt de laatste stap terug.</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>Doet opnieuw wat teruggenomen is.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Verwijderen</translation>
    </message>
    <message>
        <source>Removes the lines that are selected.</source>
        <translation>Verwijdert de geselecteerde lijnen.</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliceren</translation>
    </message>
    <message>
        <source>Copies the selected lines, a little beside them.</source>
        <translation>Kopieert de geselecteerde lijnen, er iets naast.</translation>
    </message>
    <message>
        <source>Selects all lines of visible, unlocked layers.</source>
        <translation>Selecteert alle lijnen van zichtbare, niet vergrendelde lagen.</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>&amp;Niets selecteren</translation>
    </message>
    <message>
        <source>Selects nothing.</source>
        <translation>Selecteert niets.</translation>
    </message>
    <message>
        <source>Selects all lines but those that are selected now.</source>
        <translation>Selecteert alle lijnen behalve de nu geselecteerde.</translation>
    </message>
    <message>
        <source>&amp;Cancel or select nothing</source>
        <translation>&amp;Annuleren of niets selecteren</translation>
    </message>
    <message>
        <source>Cancels what the pen is doing, or clears the selection.</source>
        <translation>Breekt af wat de pen aan het doen is, of heft de selectie op.</translation>
    </message>
</context>
<context>
    <name>ErrorWords</name>
    <message>
        <source>The file or folder is not there.</source>
        <translation>Het bestand of de map is er niet.</translation>
    </message>
    <message>
        <source>The file cannot be read or written: it may be protected, or the disk may be full.</source>
        <translation>Het bestand kan niet worden gelezen of geschreven: misschien is het beveiligd of de schijf vol.</translation>
    </message>
    <message>
        <source>Feltline cannot read this kind of file.</source>
        <translation>Feltline kan dit soort bestand niet lezen.</translation>
    </message>
    <message>
        <source>It is damaged, or not a drawing that Feltline can read.</source>
        <translation>Het is beschadigd, of geen tekening die Feltline kan lezen.</translation>
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
        <source>My &amp;own sheets</source>
        <translation>&amp;Eigen vellen</translation>
    </message>
    <message>
        <source>Sheets that you made, or a drawing brought</source>
        <translation>Vellen die u zelf maakte of die een tekening meebracht</translation>
    </message>
    <message>
        <source>No force, at once</source>
        <translation>Geen kracht meer, meteen</translation>
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
        <source>Forces are off. The panel Feel switches them on again.</source>
        <translation>De krachten zijn uit. In het paneel Gevoel zet je ze weer aan.</translation>
    </message>
    <message>
        <source>Hear the pen rub on the sheet</source>
        <translation>De pen op het vel horen wrijven</translation>
    </message>
    <message>
        <source>Stops all forces, or lets the pen be pushed</source>
        <translation>Stopt alle krachten, of laat de pen duwen</translation>
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
        <translation>&amp;Geluid van het tekenen</translation>
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
        <translation>Om een lijn te verbeteren druk je op %1 en trek je hem in vorm.</translation>
    </message>
    <message>
        <source>%1 takes back a step. The Help menu has a two-minute tour.</source>
        <translation>%1 neemt een stap terug. In het menu Help staat een rondleiding van twee minuten.</translation>
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
        <source>Move the sheet</source>
        <translation>Vel verschuiven</translation>
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
        <source>Borrow a tool</source>
        <translation>Gereedschap lenen</translation>
    </message>
    <message>
        <source>Hold its key while you use it</source>
        <translation>Houd de toets vast terwijl je het gebruikt</translation>
    </message>
    <message>
        <source>Pen, mouse and held keys</source>
        <translation>Pen, muis en vastgehouden toetsen</translation>
    </message>
</context>
<context>
    <name>LayerActions</name>
    <message>
        <source>&amp;Add layer</source>
        <translation>Laag &amp;toevoegen</translation>
    </message>
    <message>
        <source>A new layer above the one in use.</source>
        <translation>Een nieuwe laag boven de gebruikte.</translation>
    </message>
    <message>
        <source>Remo&amp;ve layer</source>
        <translation>Laag &amp;verwijderen</translation>
    </message>
    <message>
        <source>Removes it and what is drawn on it.</source>
        <translation>Verwijdert de laag en wat erop getekend is.</translation>
    </message>
    <message>
        <source>Re&amp;name layer</source>
        <translation>Laag &amp;hernoemen</translation>
    </message>
    <message>
        <source>Gives it another name.</source>
        <translation>Geeft de laag een andere naam.</translation>
    </message>
    <message>
        <source>&amp;Raise layer</source>
        <translation>Laag &amp;omhoog</translation>
    </message>
    <message>
        <source>One place up.</source>
        <translation>Eén plaats omhoog.</translation>
    </message>
    <message>
        <source>&amp;Lower layer</source>
        <translation>Laag o&amp;mlaag</translation>
    </message>
    <message>
        <source>One place down.</source>
        <translation>Eén plaats omlaag.</translation>
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
        <source>What is drawn on it is seen.</source>
        <translation>Wat erop getekend is, is te zien.</translation>
    </message>
    <message>
        <source>Loc&amp;k layer</source>
        <translation>Laag ver&amp;grendelen</translation>
    </message>
    <message>
        <source>Nothing on it can be changed.</source>
        <translation>Er kan niets op veranderd worden.</translation>
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
        <translation>ruwe korrel</translation>
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
        <translation>Linnen</translation>
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
        <source>hides the grain</source>
        <translation>bedekt de korrel</translation>
    </message>
    <message>
        <source>grain to feel, not to see</source>
        <translation>korrel te voelen, niet te zien</translation>
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
</context>
<context>
    <name>MediaPicker</name>
    <message>
        <source>%1 draws in its own colour, %2.</source>
        <translation>%1 tekent in zijn eigen kleur, %2.</translation>
    </message>
</context>
<context>
    <name>Menus</name>
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
        <source>&amp;Export</source>
        <translation>&amp;Exporteren</translation>
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
        <source>S&amp;heet</source>
        <translation>&amp;Blad</translation>
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
        <source>Pressing harder draws wider; off, every line has the same width.</source>
        <translation>Harder drukken tekent breder; uit: elke lijn is even breed.</translation>
    </message>
    <message>
        <source>Hold the &amp;first modifier</source>
        <translation>&amp;Eerste extra toets vasthouden</translation>
    </message>
    <message>
        <source>As if Shift were held, until it is chosen again.</source>
        <translation>Alsof Shift ingedrukt is, tot je dit weer kiest.</translation>
    </message>
    <message>
        <source>Hold the &amp;second modifier</source>
        <translation>&amp;Tweede extra toets vasthouden</translation>
    </message>
    <message>
        <source>As if Ctrl were held, until it is chosen again.</source>
        <translation>Alsof Ctrl ingedrukt is, tot je dit weer kiest.</translation>
    </message>
</context>
<context>
    <name>PenDevice</name>
    <message>
        <source>Simulated: %1</source>
        <translation>Gesimuleerd: %1</translation>
    </message>
    <message>
        <source>The ink is exactly where the pen is. Forces are shown, not felt.</source>
        <translation>De inkt ligt precies waar de pen is. Krachten worden getoond, niet gevoeld.</translation>
    </message>
    <message>
        <source>Mouse or pen lead a simulated hand that holds this stylus. Forces move the ink, so that you see what it would feel like.</source>
        <translation>Muis of pen leiden een gesimuleerde hand die deze stylus vasthoudt. Krachten bewegen de inkt, zodat je ziet hoe het zou voelen.</translation>
    </message>
    <message>
        <source>Simulated %1</source>
        <translation>%1, gesimuleerd</translation>
    </message>
    <message>
        <source>A person holds it, and feels the forces.</source>
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
    <name>SafetyWords</name>
    <message>
        <source>the force limit</source>
        <translation>de krachtgrens</translation>
    </message>
    <message>
        <source>what the motors stand for good</source>
        <translation>wat de motoren blijvend aankunnen</translation>
    </message>
    <message>
        <source>the speed of the pen</source>
        <translation>de snelheid van de pen</translation>
    </message>
    <message>
        <source>how fast a force may rise</source>
        <translation>hoe snel een kracht mag stijgen</translation>
    </message>
    <message>
        <source>how stiff the device can be</source>
        <translation>hoe stijf het apparaat kan zijn</translation>
    </message>
    <message>
        <source>Held back by %1.</source>
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
        <translation>Controleer de kabel en de stroom van het apparaat en zet de krachten dan weer aan.</translation>
    </message>
    <message>
        <source>Drawing goes on as before. Lift the pen and switch the forces on again.</source>
        <translation>Tekenen gaat door als tevoren. Til de pen op en zet de krachten weer aan.</translation>
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
        <source>the computer stood still for a moment</source>
        <translation>de computer stond even stil</translation>
    </message>
    <message>
        <source>a force made no sense</source>
        <translation>een kracht was onzinnig</translation>
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
        <translation>Te zien, niet te voelen: deze pen heeft geen motoren</translation>
    </message>
    <message>
        <source>The plot shows what a device would be asked for.</source>
        <translation>De grafiek toont wat er van een apparaat gevraagd zou worden.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Lift the pen for a moment: forces then begin.</source>
        <translation>Til de pen even op: dan beginnen de krachten.</translation>
    </message>
    <message>
        <source>Forces are coming up</source>
        <translation>De krachten komen op</translation>
    </message>
    <message>
        <source>The program is busy</source>
        <translation>Het programma is bezig</translation>
    </message>
    <message>
        <source>The pen only feels a brake.</source>
        <translation>De pen voelt alleen een rem.</translation>
    </message>
    <message>
        <source>Forces give way: %1</source>
        <translation>De krachten geven toe: %1</translation>
    </message>
    <message>
        <source>They come back by themselves.</source>
        <translation>Ze komen vanzelf terug.</translation>
    </message>
    <message>
        <source>Sum, asked</source>
        <translation>Som, gevraagd</translation>
    </message>
    <message>
        <source>Sent to the pen</source>
        <translation>Naar de pen gestuurd</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Vel</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
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
        <source>Drawing goes on. Switch them on at the device, lift the pen, and switch them on here.</source>
        <translation>Tekenen gaat door. Zet ze aan op het apparaat, til de pen op en zet ze hier aan.</translation>
    </message>
    <message>
        <source>Drawing goes on. Let the device rest for some minutes, then switch the forces on again.</source>
        <translation>Tekenen gaat door. Laat het apparaat enkele minuten rusten en zet de krachten dan weer aan.</translation>
    </message>
    <message>
        <source>the computer or the device could not keep up several times in a minute</source>
        <translation>computer of apparaat kon het meermaals in een minuut niet bijhouden</translation>
    </message>
</context>
<context>
    <name>Stability</name>
    <message>
        <source>Stable, as wished</source>
        <translation>Stabiel, zoals gewenst</translation>
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
        <source>Stable, but less than wished</source>
        <translation>Stabiel, maar minder dan gewenst</translation>
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
        <source>A pen that rests trembles with %1 N above 30 Hz; 0.04 N can be felt. Less hardness, less friction or more damping helps.</source>
        <translation>Een rustende pen trilt met %1 N boven 30 Hz; 0,04 N is te voelen. Minder hardheid, minder wrijving of meer demping helpt.</translation>
    </message>
    <message>
        <source>%1 has no motors: nothing is felt. The figures are those of a 3D Systems Touch.</source>
        <translation>%1 heeft geen motoren: er is niets te voelen. De waarden zijn die van een 3D Systems Touch.</translation>
    </message>
    <message>
        <source>%1 % of what the device bears</source>
        <translation>%1 % van wat het apparaat verdraagt</translation>
    </message>
    <message>
        <source>Hardness: this device makes it %1 of your %2 N/m.</source>
        <translation>Hardheid: dit apparaat maakt er %1 van uw %2 N/m van.</translation>
    </message>
    <message>
        <source>Grain: its hills are steeper than this loop can follow; felt are %1 of your %2 µm.</source>
        <translation>Korrel: de heuvels zijn steiler dan deze lus kan volgen; te voelen zijn %1 van uw %2 µm.</translation>
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
        <translation>Maakt het gereedschap in de hand kleiner.</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Groter</translation>
    </message>
    <message>
        <source>Makes the tool in hand larger.</source>
        <translation>Maakt het gereedschap in de hand groter.</translation>
    </message>
    <message>
        <source>Forces &amp;weaker</source>
        <translation>Krachten &amp;zwakker</translation>
    </message>
    <message>
        <source>The tool in hand pushes back less.</source>
        <translation>Het gereedschap in de hand biedt minder weerstand.</translation>
    </message>
    <message>
        <source>Forces &amp;stronger</source>
        <translation>Krachten &amp;sterker</translation>
    </message>
    <message>
        <source>The tool in hand pushes back more.</source>
        <translation>Het gereedschap in de hand biedt meer weerstand.</translation>
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
        <translation>%1 mm is de grootste maat.</translation>
    </message>
    <message>
        <source>%1 mm is the smallest size.</source>
        <translation>%1 mm is de kleinste maat.</translation>
    </message>
</context>
<context>
    <name>ViewActions</name>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Inzoomen</translation>
    </message>
    <message>
        <source>Shows the sheet larger, around the pointer</source>
        <translation>Toont het vel groter, rond de aanwijzer</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Uitzoomen</translation>
    </message>
    <message>
        <source>Shows the sheet smaller, around the pointer</source>
        <translation>Toont het vel kleiner, rond de aanwijzer</translation>
    </message>
    <message>
        <source>&amp;Life size</source>
        <translation>&amp;Ware grootte</translation>
    </message>
    <message>
        <source>A millimetre on the sheet is one on the screen</source>
        <translation>Een millimeter op het vel is er een op het scherm</translation>
    </message>
    <message>
        <source>Fit &amp;selection</source>
        <translation>&amp;Selectie passend</translation>
    </message>
    <message>
        <source>Shows what is selected as large as it can</source>
        <translation>Toont de selectie zo groot mogelijk</translation>
    </message>
    <message>
        <source>Fit &amp;page</source>
        <translation>&amp;Vel passend</translation>
    </message>
    <message>
        <source>Shows the whole sheet</source>
        <translation>Toont het hele vel</translation>
    </message>
    <message>
        <source>Fit &amp;drawing</source>
        <translation>&amp;Tekening passend</translation>
    </message>
    <message>
        <source>Shows all ink, beside the sheet too</source>
        <translation>Toont alle inkt, ook naast het vel</translation>
    </message>
    <message>
        <source>Turn l&amp;eft</source>
        <translation>&amp;Linksom draaien</translation>
    </message>
    <message>
        <source>Turns the view anticlockwise; the drawing stays</source>
        <translation>Draait het beeld tegen de klok in; de tekening blijft</translation>
    </message>
    <message>
        <source>Turn ri&amp;ght</source>
        <translation>&amp;Rechtsom draaien</translation>
    </message>
    <message>
        <source>Turns the view clockwise; the drawing stays</source>
        <translation>Draait het beeld met de klok mee; de tekening blijft</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>Re&amp;chtop</translation>
    </message>
    <message>
        <source>Turns the view back, so that the sheet is upright</source>
        <translation>Draait het beeld terug, zodat het vel rechtop staat</translation>
    </message>
    <message>
        <source>&amp;Mirror view</source>
        <translation>Beeld s&amp;piegelen</translation>
    </message>
    <message>
        <source>Swaps left and right of the view, which shows what is askew; the drawing stays</source>
        <translation>Verwisselt links en rechts in beeld, zodat je ziet wat scheef is; de tekening blijft</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Naar links schuiven</translation>
    </message>
    <message>
        <source>Shows what is further to the left</source>
        <translation>Toont wat verder naar links ligt</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Naar rechts schuiven</translation>
    </message>
    <message>
        <source>Shows what is further to the right</source>
        <translation>Toont wat verder naar rechts ligt</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Omhoog schuiven</translation>
    </message>
    <message>
        <source>Shows what is further up</source>
        <translation>Toont wat hoger ligt</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Omlaag schuiven</translation>
    </message>
    <message>
        <source>Shows what is further down</source>
        <translation>Toont wat lager ligt</translation>
    </message>
    <message>
        <source>Ou&amp;tlines</source>
        <translation>&amp;Omtrekken</translation>
    </message>
    <message>
        <source>Shows the middle of each line only, hair-thin</source>
        <translation>Toont alleen het midden van elke lijn, haardun</translation>
    </message>
    <message>
        <source>&amp;Force arrow</source>
        <translation>&amp;Krachtpijl</translation>
    </message>
    <message>
        <source>Shows at the nib where the force pushes</source>
        <translation>Toont bij de punt waarheen de kracht duwt</translation>
    </message>
    <message>
        <source>&amp;Nib gives way to forces</source>
        <translation>Pu&amp;nt geeft toe aan krachten</translation>
    </message>
    <message>
        <source>With a simulated stylus, the nib is shown where forces move it</source>
        <translation>Bij een gesimuleerde pen staat de punt waar krachten hem heen bewegen</translation>
    </message>
    <message>
        <source>G&amp;rain of the sheet</source>
        <translation>Korr&amp;el van het vel</translation>
    </message>
    <message>
        <source>Dry ink shows the relief of the sheet</source>
        <translation>Droge inkt toont het reliëf van het vel</translation>
    </message>
</context>
<context>
    <name>edits</name>
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
        <source>Sketching that the hand feels: ink that pushes back, lines that are corrected by pulling and pushing them.</source>
        <translation>Schetsen dat de hand voelt: inkt die weerstand biedt, lijnen die je verbetert door te trekken en te duwen.</translation>
    </message>
    <message>
        <source>Begun from an idea of this paper:</source>
        <translation>Begonnen met een idee uit dit artikel:</translation>
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
    <name>felt::desktop::CalibrationDialog</name>
    <message>
        <source>Drawing plane of %1</source>
        <translation>Tekenvlak van %1</translation>
    </message>
    <message>
        <source>The corner to touch</source>
        <translation>De hoek om aan te raken</translation>
    </message>
    <message>
        <source>&amp;Take this place</source>
        <translation>Deze &amp;plek nemen</translation>
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
        <source>That is no drawing area: %1. Begin with the upper left corner again.</source>
        <translation>Dat is geen tekenvlak: %1. Begin weer met de hoek linksboven.</translation>
    </message>
    <message>
        <source>Hold the pen&apos;s tip on the upper left corner of where you want to draw.</source>
        <translation>Houd de punt van de pen op de hoek linksboven van waar je wilt tekenen.</translation>
    </message>
    <message>
        <source>Now on the upper right corner.</source>
        <translation>Nu op de hoek rechtsboven.</translation>
    </message>
    <message>
        <source>Now on the lower left corner.</source>
        <translation>Nu op de hoek linksonder.</translation>
    </message>
    <message>
        <source>The drawing area is %L1 mm wide and %L2 mm high.</source>
        <translation>Het tekenvlak is %L1 mm breed en %L2 mm hoog.</translation>
    </message>
    <message>
        <source>Its corners fit within %L1 mm.</source>
        <translation>De hoeken passen binnen %L1 mm.</translation>
    </message>
    <message>
        <source>Its corner is not square: %L1 mm off. Starting again may be better.</source>
        <translation>De hoek is niet haaks: %L1 mm ernaast. Opnieuw beginnen is misschien beter.</translation>
    </message>
    <message>
        <source>The device does not answer. Check its cable and power.</source>
        <translation>Het apparaat antwoordt niet. Controleer kabel en stroom.</translation>
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
        <source>Sheet</source>
        <translation>Vel</translation>
    </message>
    <message>
        <source>The sheet to draw on</source>
        <translation>Het vel om op te tekenen</translation>
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
        <source>Pressure is seen.</source>
        <translation>Druk wordt gezien.</translation>
    </message>
    <message>
        <source>No pressure seen yet: a mouse draws lines of even width.</source>
        <translation>Nog geen druk gezien: een muis tekent even brede lijnen.</translation>
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
        <source>At the nib: which way it pushes, and how strong it is</source>
        <translation>Bij de punt: waarheen ze duwt en hoe sterk</translation>
    </message>
    <message>
        <source>The &amp;nib gives way to forces</source>
        <translation>De &amp;punt geeft toe aan krachten</translation>
    </message>
    <message>
        <source>With a mouse or a tablet, forces are seen in how the nib moves</source>
        <translation>Met muis of tablet zie je krachten aan hoe de punt beweegt</translation>
    </message>
    <message>
        <source>Dry ink shows the &amp;grain of the sheet</source>
        <translation>Droge inkt toont de korrel van het &amp;vel</translation>
    </message>
    <message>
        <source>As chalk does; exported outlines stay as they are</source>
        <translation>Zoals krijt; geëxporteerde omtrekken blijven zoals ze zijn</translation>
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
        <source>Copy the selected strokes, or all</source>
        <translation>De geselecteerde lijnen kopiëren, of alle</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Plakken</translation>
    </message>
    <message>
        <source>Add the strokes of the clipboard</source>
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
        <source>Only whole strokes can be cut: select all of a stroke.</source>
        <translation>Alleen hele lijnen kun je knippen: selecteer een hele lijn.</translation>
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
        <source>Number of the colour</source>
        <translation>Nummer van de kleur</translation>
    </message>
    <message>
        <source>The colour as #rrggbb; #rgb and #rrggbbaa do as well</source>
        <translation>De kleur als #rrggbb; #rgb en #rrggbbaa kan ook</translation>
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
        <source>Opacity: 0 % is see-through</source>
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
        <source>Keep this colour in a palette of your own</source>
        <translation>Deze kleur in een eigen palet bewaren</translation>
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
        <source>Take the &amp;colour out of your own</source>
        <translation>Kleur uit het &amp;eigen palet halen</translation>
    </message>
    <message>
        <source>Faint on this paper: %1:1</source>
        <translation>Flauw op dit papier: %1:1</translation>
    </message>
    <message>
        <source>Contrast with paper %1:1</source>
        <translation>Contrast met papier %1:1</translation>
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
        <source>%1 is gone. It plays again when it is back.</source>
        <translation>%1 is weg. Het speelt weer zodra het terug is.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceCare</name>
    <message>
        <source>Find its &amp;home…</source>
        <translation>&amp;Uitgangsstand zoeken…</translation>
    </message>
    <message>
        <source>&amp;Use it again</source>
        <translation>Weer &amp;gebruiken</translation>
    </message>
    <message>
        <source>Plugged in again it is used again, without forces at first.</source>
        <translation>Weer aangesloten wordt het weer gebruikt, eerst zonder krachten.</translation>
    </message>
    <message>
        <source>%1 is in use in another window.</source>
        <translation>%1 wordt in een ander venster gebruikt.</translation>
    </message>
    <message>
        <source>%1 does not open.</source>
        <translation>%1 gaat niet open.</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>Opnieuw &amp;proberen</translation>
    </message>
    <message>
        <source>%1 is there. It must find its home before it is used.</source>
        <translation>%1 is er. Het moet zijn uitgangsstand vinden voordat het wordt gebruikt.</translation>
    </message>
    <message>
        <source>%1 is in use. Its forces are off until you switch them on.</source>
        <translation>%1 wordt gebruikt. De krachten zijn uit totdat u ze aanzet.</translation>
    </message>
    <message>
        <source>Switch &amp;forces on</source>
        <translation>Krachten &amp;aanzetten</translation>
    </message>
    <message>
        <source>Message from %1: %2</source>
        <translation>Melding van %1: %2</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DeviceNotice</name>
    <message>
        <source>What the device itself says</source>
        <translation>Wat het apparaat zelf zegt</translation>
    </message>
    <message>
        <source>The device says: %1</source>
        <translation>Het apparaat zegt: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DevicePage</name>
    <message>
        <source>Feels pressure, if the pen does. No motors.</source>
        <translation>Voelt druk, als de pen dat doet. Geen motoren.</translation>
    </message>
    <message>
        <source>No motors.</source>
        <translation>Geen motoren.</translation>
    </message>
    <message>
        <source>Pushes with up to %L1 N, for long with %L2 N. Loop of %L3 Hz.</source>
        <translation>Duwt met hoogstens %L1 N, blijvend met %L2 N. Lus van %L3 Hz.</translation>
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
        <source>No force is ever larger than this, whatever a tool asks for</source>
        <translation>Geen kracht is ooit groter, wat een gereedschap ook vraagt</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Grootste kracht</translation>
    </message>
    <message>
        <source>&amp;Largest force</source>
        <translation>&amp;Grootste kracht</translation>
    </message>
    <message>
        <source>Forces stay off until you switch them on.</source>
        <translation>De krachten blijven uit tot je ze aanzet.</translation>
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
        <source>A haptic pen, mouse, touchpad or game controller that hums and ticks with what you draw, whatever the pen is</source>
        <translation>Een haptische pen, muis, touchpad of spelbesturing die zoemt en tikt met wat u tekent, welke pen er ook tekent</translation>
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
        <source>Not connected; used again when it is</source>
        <translation>Niet aangesloten; wordt weer gebruikt zodra dat zo is</translation>
    </message>
    <message>
        <source>In use in another window</source>
        <translation>In gebruik in een ander venster</translation>
    </message>
    <message>
        <source>Its software is here; whether it is connected shows when it is used</source>
        <translation>De software is er; of het is aangesloten blijkt bij het gebruik</translation>
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
        <source>Not here? See what is missing, step by step</source>
        <translation>Niet in de lijst? Zie stap voor stap wat er ontbreekt</translation>
    </message>
    <message>
        <source>Mend that line, or remove the file.</source>
        <translation>Verbeter die regel of verwijder het bestand.</translation>
    </message>
    <message>
        <source>Look at its cable and its power.</source>
        <translation>Kijk naar de kabel en de voeding.</translation>
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
        <source>Fit to the s&amp;heet</source>
        <translation>Aan het &amp;blad aanpassen</translation>
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
        <source>No force is ever larger than this, whatever a tool asks for</source>
        <translation>Geen kracht is ooit groter, wat een gereedschap ook vraagt</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Grootste kracht</translation>
    </message>
    <message>
        <source>as it can</source>
        <translation>wat het kan</translation>
    </message>
    <message>
        <source> N/m</source>
        <translation> N/m</translation>
    </message>
    <message>
        <source>Lower it where the sheet hums or trembles under the pen</source>
        <translation>Verlaag dit als het blad onder de pen bromt of trilt</translation>
    </message>
    <message>
        <source>Stiffest sheet</source>
        <translation>Stijfste blad</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>100 %: a millimetre of the hand is one of the sheet. 200 %: it is two, and the hand has half the way.</source>
        <translation>100 %: een millimeter van de hand is er een op het blad. 200 %: het zijn er twee, en de hand heeft de halve weg.</translation>
    </message>
    <message>
        <source>Size of a movement on the sheet</source>
        <translation>Grootte van een beweging op het blad</translation>
    </message>
    <message>
        <source>The middle of the drawing area on the middle of the sheet, and so large that the whole sheet can be reached</source>
        <translation>Het midden van het tekengebied op het midden van het blad, en zo groot dat het hele blad bereikbaar is</translation>
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
        <translation>&amp;Grootste kracht</translation>
    </message>
    <message>
        <source>S&amp;tiffest sheet</source>
        <translation>&amp;Stijfste blad</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>Tekenvlak</translation>
    </message>
    <message>
        <source>S&amp;ize on the sheet</source>
        <translation>Gr&amp;ootte op het blad</translation>
    </message>
    <message>
        <source>Not set yet: as such a device usually stands.</source>
        <translation>Nog niet ingesteld: zoals zo&apos;n apparaat meestal staat.</translation>
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
        <source>Each hand has a drawing plane of its own: for the other one the device stands on the other side</source>
        <translation>Elke hand heeft een eigen tekenvlak: voor de andere staat het apparaat aan de andere kant</translation>
    </message>
</context>
<context>
    <name>felt::desktop::DoctorDialog</name>
    <message>
        <source>Setting up a haptic device</source>
        <translation>Een haptisch apparaat instellen</translation>
    </message>
    <message>
        <source>A device pushes your hand only once its maker&apos;s software is installed and you may use its port. Feltline has looked at this computer. Work from the top down; a line with a dash is of a device that you may not own, and needs nothing.</source>
        <translation>Een apparaat duwt uw hand pas als de software van de maker is geïnstalleerd en u de poort mag gebruiken. Feltline heeft deze computer bekeken. Werk van boven naar beneden; een regel met een streepje hoort bij een apparaat dat u misschien niet hebt, en vraagt niets.</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Wat er is gevonden</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>&amp;Opnieuw kijken</translation>
    </message>
    <message>
        <source>&amp;Copy all</source>
        <translation>Alles &amp;kopiëren</translation>
    </message>
    <message>
        <source>As plain text, to ask somebody who knows</source>
        <translation>Als gewone tekst, om het iemand te vragen die het weet</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Bezig met kijken…</translation>
    </message>
    <message>
        <source>This build of Feltline has no drivers.</source>
        <translation>Deze Feltline is zonder stuurprogramma&apos;s gebouwd.</translation>
    </message>
    <message>
        <source>Nothing to say.</source>
        <translation>Niets te zeggen.</translation>
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
        <translation>Het vel</translation>
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
        <source>&amp;Grain of the sheet in dry ink</source>
        <translation>&amp;Korrel van het vel in droge inkt</translation>
    </message>
    <message>
        <source>As on the screen. Lines stay lines: other programs show them through a picture of the grain</source>
        <translation>Zoals op het scherm. Lijnen blijven lijnen: andere programma’s tonen ze door een afbeelding van de korrel</translation>
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
        <source>Sh&amp;eet</source>
        <translation>V&amp;el</translation>
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
        <source>No force, at once (Esc twice)</source>
        <translation>Geen kracht, meteen (tweemaal Esc)</translation>
    </message>
    <message>
        <source>Let the pen be pushed</source>
        <translation>De pen wordt geduwd</translation>
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
        <source>Change what sheets and media feel, look and sound like</source>
        <translation>Veranderen hoe vellen en tekenmiddelen aanvoelen, eruitzien en klinken</translation>
    </message>
    <message>
        <source>Edit sheets and media</source>
        <translation>Vellen en tekenmiddelen bewerken</translation>
    </message>
</context>
<context>
    <name>felt::desktop::FeltPlot</name>
    <message>
        <source>Plot of what a stroke of 40 mm feels like</source>
        <translation>Grafiek van wat een streek van 40 mm laat voelen</translation>
    </message>
    <message>
        <source>%1 N of drag; the grain changes it by up to %2 N, which can be felt.</source>
        <translation>%1 N wrijving; de korrel verandert die met hoogstens %2 N, wat te voelen is.</translation>
    </message>
    <message>
        <source>%1 N of drag; it changes by up to %2 N, which nobody feels.</source>
        <translation>%1 N wrijving; die verandert met hoogstens %2 N, wat niemand voelt.</translation>
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
        <translation>&amp;Recent geopend</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nieuw</translation>
    </message>
    <message>
        <source>Begin another drawing</source>
        <translation>Een andere tekening beginnen</translation>
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
        <translation>De tekening in haar bestand opslaan</translation>
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
        <translation>De lijnen van een ander bestand toevoegen</translation>
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
        <source>Leave the program</source>
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
Your drawing is still here: save it to another place.</source>
        <translation>%1
Je tekening is er nog: sla haar ergens anders op.</translation>
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
        <source>What is needed for recovery cannot be written: %1</source>
        <translation>Wat voor herstel nodig is kan niet worden geschreven: %1</translation>
    </message>
    <message>
        <source>Crash protection in another place</source>
        <translation>Crashbeveiliging op een andere plek</translation>
    </message>
    <message>
        <source>The drawing is kept for recovery in %1, because the usual place fails: %2</source>
        <translation>De tekening wordt voor herstel bewaard in %1, want op de gewone plek lukt het niet: %2</translation>
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
        <source>Without saving, what you drew since the last save is lost.</source>
        <translation>Zonder opslaan gaat verloren wat je sindsdien tekende.</translation>
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
        <source>Saving now replaces those changes by your drawing.</source>
        <translation>Opslaan vervangt die wijzigingen door jouw tekening.</translation>
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
        <translation>“%1” is beschadigd.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) of it can be shown, as a new drawing; the file stays as it is.</source>
        <translation>
            <numerusform>%n lijn ervan kan als nieuwe tekening worden getoond; het bestand blijft zoals het is.</numerusform>
            <numerusform>%n lijnen ervan kunnen als nieuwe tekening worden getoond; het bestand blijft zoals het is.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Show what is left</source>
        <translation>&amp;Tonen wat er over is</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Opslaan &amp;als…</translation>
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
        <source>The loop does not run.</source>
        <translation>De lus loopt niet.</translation>
    </message>
    <message>
        <source>Real-time scheduling.</source>
        <translation>Realtime-planning.</translation>
    </message>
    <message>
        <source>Raised priority, no real-time scheduling.</source>
        <translation>Hogere prioriteit, geen realtime-planning.</translation>
    </message>
    <message>
        <source>Ordinary scheduling: late when the computer is busy.</source>
        <translation>Gewone planning: te laat als de computer het druk heeft.</translation>
    </message>
    <message>
        <source>The loop stands still: the device does not answer.</source>
        <translation>De lus staat stil: het apparaat antwoordt niet.</translation>
    </message>
    <message>
        <source>The device&apos;s own software runs the loop.</source>
        <translation>De lus loopt in de software van het apparaat.</translation>
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
        <source>Most</source>
        <translation>Hoogste</translation>
    </message>
    <message>
        <source>Forces by name</source>
        <translation>Krachten op naam</translation>
    </message>
    <message>
        <source>Each force now and its largest value of the last seconds</source>
        <translation>Elke kracht nu en haar hoogste waarde van de laatste seconden</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Hold the plot still</source>
        <translation>De grafiek stilzetten</translation>
    </message>
    <message>
        <source>most, %L1 N</source>
        <translation>hoogstens, %L1 N</translation>
    </message>
    <message>
        <source>for long, %L1 N</source>
        <translation>blijvend, %L1 N</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>The motors are warm, so forces are kept lower for a while.</source>
        <translation>De motoren zijn warm, dus blijven de krachten een tijdje lager.</translation>
    </message>
    <message>
        <source>Loop: %L1 Hz, missed ticks: %L2</source>
        <translation>Lus: %L1 Hz, gemiste tikken: %L2</translation>
    </message>
    <message>
        <source>Late: %1 as a rule, 1 in 100 %2</source>
        <translation>Te laat: meestal %1, 1 op 100 %2</translation>
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
        <source>Asked: %L1 N, at most %L2 N of late. The table has each force.</source>
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
        <source>Lines and their pressure for programs that know ink; Feltline reads lines, layers and page back exactly.</source>
        <translation>Lijnen en hun druk voor programma’s die inkt kennen; Feltline leest lijnen, lagen en pagina exact terug.</translation>
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
        <source>Every line that is seen, exactly, for programs and scripts; no layers and no sheet.</source>
        <translation>Elke zichtbare lijn, exact, voor programma’s en scripts; geen lagen en geen blad.</translation>
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
        <source>As the desktop</source>
        <translation>Zoals het bureaublad</translation>
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
        <source>Another language is used from the next start on.</source>
        <translation>Een andere taal geldt vanaf de volgende start.</translation>
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
        <source>At the start:</source>
        <translation>Bij het starten:</translation>
    </message>
    <message>
        <source>&amp;Open the last drawing again</source>
        <translation>De laatste tekening &amp;weer openen</translation>
    </message>
    <message>
        <source>Where no file is named</source>
        <translation>Als er geen bestand is genoemd</translation>
    </message>
    <message>
        <source>So&amp;und of drawing</source>
        <translation>&amp;Geluid van het tekenen</translation>
    </message>
    <message>
        <source>Hear the pen rub on the sheet</source>
        <translation>De pen op het vel horen wrijven</translation>
    </message>
    <message>
        <source>Volume of the sound of drawing</source>
        <translation>Volume van het geluid van het tekenen</translation>
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
        <translation>Tekenen, dan verbeteren</translation>
    </message>
    <message>
        <source>Draw with a pen or with the mouse. A line that is not right is not drawn again: pull it, push it, smooth it, make it broader. Every step can be undone.</source>
        <translation>Teken met een pen of met de muis. Een lijn die niet klopt, teken je niet opnieuw: trek, duw, strijk hem glad of maak hem breder. Elke stap kan ongedaan worden gemaakt.</translation>
    </message>
    <message>
        <source>A short press on a tool&apos;s key takes the tool. Hold the key while you use the tool, and the former one comes back when you let go.</source>
        <translation>Een korte druk op de toets van een gereedschap neemt het. Houd je de toets vast terwijl je het gebruikt, dan komt bij loslaten het vorige terug.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>The sheet</source>
        <translation>Het vel</translation>
    </message>
    <message>
        <source>The wheel zooms at the pointer. Hold Space and drag to move the sheet, with Shift to turn it. None of this changes the drawing.</source>
        <translation>Het muiswiel zoomt bij de aanwijzer. Houd de spatiebalk vast en sleep om het vel te verschuiven, met Shift om het te draaien. Niets daarvan verandert de tekening.</translation>
    </message>
    <message>
        <source>The feel</source>
        <translation>Het gevoel</translation>
    </message>
    <message>
        <source>Every tool pushes back. With a force-feedback pen you feel it in your hand; with a tablet or a mouse you see it, as an arrow at the nib and in the panel Forces. Press Esc twice to switch all forces off at once.</source>
        <translation>Elk gereedschap biedt weerstand. Met een pen met krachtterugkoppeling voel je die in je hand; met een tablet of muis zie je hem, als pijl bij de punt en in het paneel Krachten. Druk tweemaal op Esc om alle krachten meteen uit te zetten.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Drawings are kept as .felt files, with their layers and their history of pen pressure. Export gives SVG, PDF and PNG to other programs.</source>
        <translation>Tekeningen staan in .felt-bestanden, met hun lagen. Voor andere programma&apos;s zijn er SVG, PDF en PNG.</translation>
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
        <source>&amp;Keys at a glance</source>
        <translation>&amp;Toetsen in één oogopslag</translation>
    </message>
    <message>
        <source>All keys on one page, to search and to print</source>
        <translation>Alle toetsen op één pagina, om te zoeken en te printen</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>&amp;Rondleiding</translation>
    </message>
    <message>
        <source>Two minutes in which the program draws by itself</source>
        <translation>Twee minuten waarin het programma zelf tekent</translation>
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
        <source>Version, licence and what it is built on</source>
        <translation>Versie, licentie en waarop het gebouwd is</translation>
    </message>
    <message>
        <source>From the tour</source>
        <translation>Uit de rondleiding</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HistoryModel</name>
    <message>
        <source>Earlier steps are forgotten</source>
        <translation>Eerdere stappen zijn vergeten</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Zoals geopend</translation>
    </message>
    <message>
        <source>%1, here</source>
        <translation>%1, hier</translation>
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
        <source>Bring %1 home</source>
        <translation>%1 naar de uitgangsstand brengen</translation>
    </message>
    <message>
        <source>Finding home</source>
        <translation>Uitgangsstand wordt gezocht</translation>
    </message>
    <message>
        <source>Let it &amp;move</source>
        <translation>Laat het be&amp;wegen</translation>
    </message>
    <message>
        <source>It is &amp;there</source>
        <translation>Het is &amp;daar</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Niet nu</translation>
    </message>
    <message>
        <source>May its arm move by itself?</source>
        <translation>Mag de arm uit zichzelf bewegen?</translation>
    </message>
    <message>
        <source>%1 must find out where its arm is, and moves it for that: for some seconds, as far as it reaches, with the force that it needs. Let go of it, clear the space around it, and keep hair, sleeves and cups away. You can stop it at any time by its power switch.</source>
        <translation>%1 moet uitvinden waar de arm is en beweegt hem daarvoor: enkele seconden, zo ver als hij reikt, met de kracht die nodig is. Laat hem los, maak er ruimte omheen en houd haar, mouwen en kopjes weg. Met de aan-uitknop van het apparaat kunt u hem altijd stoppen.</translation>
    </message>
    <message>
        <source>Bring the arm to its rest pose</source>
        <translation>Breng de arm in de ruststand</translation>
    </message>
    <message>
        <source>%1 takes the pose that it rests in as its home. Nothing moves by itself.</source>
        <translation>%1 neemt de stand waarin het rust als uitgangsstand. Niets beweegt uit zichzelf.</translation>
    </message>
    <message>
        <source>Put the stylus into the inkwell</source>
        <translation>Zet de stift in de inktpot</translation>
    </message>
    <message>
        <source>%1 finds out where it is while its stylus is in the inkwell, the hole in its foot. Nothing moves by itself.</source>
        <translation>%1 vindt uit waar het is terwijl de stift in de inktpot staat, het gat in de voet. Niets beweegt uit zichzelf.</translation>
    </message>
    <message>
        <source>It is moving: hands off</source>
        <translation>Het beweegt: handen weg</translation>
    </message>
    <message>
        <source>One moment: hold it still</source>
        <translation>Een ogenblik: houd het stil</translation>
    </message>
    <message>
        <source>It did not find its home. Try again.</source>
        <translation>Het heeft zijn uitgangsstand niet gevonden. Probeer het opnieuw.</translation>
    </message>
    <message>
        <source>That did not work: %1</source>
        <translation>Dat lukte niet: %1</translation>
    </message>
</context>
<context>
    <name>felt::desktop::HueStrip</name>
    <message>
        <source>Hue</source>
        <translation>Tint</translation>
    </message>
    <message>
        <source>Hue. Arrow keys move it.</source>
        <translation>Tint. Pijltoetsen verschuiven hem.</translation>
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
        <source>Cancelled, the pen is up</source>
        <translation>Afgebroken, de pen is op</translation>
    </message>
    <message>
        <source>The pen is down</source>
        <translation>De pen is neer</translation>
    </message>
    <message>
        <source>The pen is up</source>
        <translation>De pen is op</translation>
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
        <source>, in use</source>
        <translation>, in gebruik</translation>
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
        <source>A new layer above this one</source>
        <translation>Een nieuwe laag boven deze</translation>
    </message>
    <message>
        <source>Raise the layer</source>
        <translation>De laag omhoog</translation>
    </message>
    <message>
        <source>One place up</source>
        <translation>Eén plaats omhoog</translation>
    </message>
    <message>
        <source>Lower the layer</source>
        <translation>De laag omlaag</translation>
    </message>
    <message>
        <source>One place down</source>
        <translation>Eén plaats omlaag</translation>
    </message>
    <message>
        <source>Remove the layer</source>
        <translation>De laag verwijderen</translation>
    </message>
    <message>
        <source>Removes the layer and what is drawn on it</source>
        <translation>Verwijdert de laag en wat erop getekend is</translation>
    </message>
    <message>
        <source>All layers were hidden or locked: “%1” was added, so that there is one to draw on.</source>
        <translation>Alle lagen waren verborgen of vergrendeld: ‘%1’ is toegevoegd, zodat er een is om op te tekenen.</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to draw there.</source>
        <translation>‘%1’ is vergrendeld: ontgrendel de laag om er te tekenen.</translation>
    </message>
    <message>
        <source>“%1” is hidden: show it to draw there.</source>
        <translation>‘%1’ is verborgen: toon de laag om er te tekenen.</translation>
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
        <source>Leaves nothing but the sheet</source>
        <translation>Laat alleen het vel over</translation>
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
        <source>Moves the focus from the sheet to the tools, to each panel, and back</source>
        <translation>Brengt de focus van het vel naar het gereedschap, naar elk paneel en terug</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>Panelen &amp;herstellen</translation>
    </message>
    <message>
        <source>Puts panels and bars where they were at first</source>
        <translation>Zet panelen en balken terug waar ze eerst stonden</translation>
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
        <source>These of your own materials could not be read:</source>
        <translation>Deze eigen materialen konden niet worden gelezen:</translation>
    </message>
    <message>
        <source>Ma&amp;terials…</source>
        <translation>Ma&amp;terialen…</translation>
    </message>
    <message>
        <source>Change what sheets and media feel, look and sound like, and make your own</source>
        <translation>Veranderen hoe vellen en tekenmiddelen aanvoelen, eruitzien en klinken, en eigen maken</translation>
    </message>
    <message>
        <source>&amp;Compare materials A and B</source>
        <translation>Materialen A en B &amp;vergelijken</translation>
    </message>
    <message>
        <source>Feel, see and hear the other one of the two that the editor compares</source>
        <translation>De andere van de twee voelen, zien en horen die de editor vergelijkt</translation>
    </message>
    <message>
        <source> (read-only)</source>
        <translation> (alleen-lezen)</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialDesk</name>
    <message>
        <source>Figures of %1</source>
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
        <source>%1, my own</source>
        <translation>%1, eigen</translation>
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
        <source>Take the figures of another one</source>
        <translation>De waarden van een ander nemen</translation>
    </message>
    <message>
        <source>Sets all figures to those of another one; they can be changed then</source>
        <translation>Zet alle waarden op die van een ander; daarna zijn ze te veranderen</translation>
    </message>
    <message>
        <source>Figures of…</source>
        <translation>Waarden van…</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Waarden</translation>
    </message>
    <message>
        <source>Relief from a picture…</source>
        <translation>Reliëf uit een afbeelding…</translation>
    </message>
    <message>
        <source>A PNG of 8 or 16 bits: white is high. It is fitted into a square of 32 widths of the grain, and repeats without a seam</source>
        <translation>Een PNG van 8 of 16 bits: wit is hoog. Het wordt in een vierkant van 32 korrelbreedtes gepast en herhaalt zich zonder naad</translation>
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
        <source>Hatched: changes below 0.04 N, which nobody feels.</source>
        <translation>Gearceerd: veranderingen onder 0,04 N, die niemand voelt.</translation>
    </message>
    <message>
        <source>What the pen feels now</source>
        <translation>Wat de pen nu voelt</translation>
    </message>
    <message>
        <source>What comes of it</source>
        <translation>Wat ervan komt</translation>
    </message>
    <message>
        <source>Comes with Feltline. A change makes a copy of your own.</source>
        <translation>Hoort bij Feltline. Een verandering maakt een eigen kopie.</translation>
    </message>
    <message>
        <source>Your own, not saved. It is kept all the same.</source>
        <translation>Uw eigen, niet opgeslagen. Het blijft toch bewaard.</translation>
    </message>
    <message>
        <source>Your own, saved.</source>
        <translation>Uw eigen, opgeslagen.</translation>
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
        <translation>U voelt, ziet en hoort %1. Druk op B voor %2.</translation>
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
        <source>All figures as they were at first, or when last saved</source>
        <translation>Alle waarden zoals aan het begin of zoals laatst opgeslagen</translation>
    </message>
    <message>
        <source>The other one gets these figures</source>
        <translation>De andere krijgt deze waarden</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Save as a file of your own</source>
        <translation>Als eigen bestand opslaan</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
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
        <source>Another name</source>
        <translation>Een andere naam</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Takes it away, and its file; undo brings it back</source>
        <translation>Haalt het en het bestand weg; ongedaan maken brengt beide terug</translation>
    </message>
    <message>
        <source>%1 is deleted. Undo brings it back.</source>
        <translation>%1 is verwijderd. Ongedaan maken brengt het terug.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importeren…</translation>
    </message>
    <message>
        <source>Take up a material of a file</source>
        <translation>Een materiaal uit een bestand opnemen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporteren…</translation>
    </message>
    <message>
        <source>Write a file for others</source>
        <translation>Een bestand voor anderen schrijven</translation>
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
        <source>It is yours now, and not saved yet.</source>
        <translation>Het is nu van u en nog niet opgeslagen.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 is geschreven.</translation>
    </message>
    <message>
        <source>Comes with this drawing. A change makes a copy of your own.</source>
        <translation>Hoort bij deze tekening. Een verandering maakt een eigen kopie.</translation>
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
        <translation>Een andere startwaarde</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Algemeen</translation>
    </message>
    <message>
        <source>In the hand</source>
        <translation>In de hand</translation>
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
        <source>To the eye</source>
        <translation>Voor het oog</translation>
    </message>
    <message>
        <source>To the ear</source>
        <translation>Voor het oor</translation>
    </message>
</context>
<context>
    <name>felt::desktop::MaterialList</name>
    <message>
        <source>Sheets and media</source>
        <translation>Vellen en tekenmiddelen</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Vellen</translation>
    </message>
    <message>
        <source>My own sheets</source>
        <translation>Eigen vellen</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>Tekenmiddelen</translation>
    </message>
    <message>
        <source>My own media</source>
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
        <source>What is drawn with</source>
        <translation>Waarmee getekend wordt</translation>
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
    <name>felt::desktop::NoticeBar</name>
    <message>
        <source>What was left out or changed, and where</source>
        <translation>Wat is weggelaten of veranderd, en waar</translation>
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
        <source>What became of it</source>
        <translation>Wat ervan werd</translation>
    </message>
    <message>
        <source>How often</source>
        <translation>Hoe vaak</translation>
    </message>
    <message>
        <source>Not everything in “%1” could be taken as it is. Left out or changed: %2. The file itself is as it was.</source>
        <translation>Niet alles in “%1” kon worden overgenomen zoals het is. Weggelaten of veranderd: %2. Het bestand zelf is onveranderd.</translation>
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
        <source>All options of this tool back to what they were at first</source>
        <translation>Alle opties van dit gereedschap zoals in het begin</translation>
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
        <source>Options that are seldom needed</source>
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
        <translation>Vel &amp;instellen…</translation>
    </message>
    <message>
        <source>Size, orientation and colour of the sheet</source>
        <translation>Grootte, stand en kleur van het vel</translation>
    </message>
    <message>
        <source>Print pre&amp;view…</source>
        <translation>Afdrukvoor&amp;beeld…</translation>
    </message>
    <message>
        <source>See what will be printed</source>
        <translation>Zien wat er wordt afgedrukt</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Af&amp;drukken…</translation>
    </message>
    <message>
        <source>Print the sheet at its true size</source>
        <translation>Het vel op ware grootte afdrukken</translation>
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
        <source>Print preview</source>
        <translation>Afdrukvoorbeeld</translation>
    </message>
    <message>
        <source>Write the drawing as SVG, PDF, PNG or ink for other programs</source>
        <translation>De tekening als SVG, PDF, PNG of inkt voor andere programma’s schrijven</translation>
    </message>
    <message>
        <source>“%1” was exported.</source>
        <translation>‘%1’ is geëxporteerd.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::OwnMaterials</name>
    <message>
        <source>not saved</source>
        <translation>niet opgeslagen</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and stays as it is. Save yours under another name; the file can be imported.</source>
        <translation>%1 is door een ander programma veranderd en blijft zoals het is. Sla het uwe onder een andere naam op; het bestand is te importeren.</translation>
    </message>
    <message>
        <source>It is for all users of this computer, and cannot be deleted here: %1</source>
        <translation>Het is voor alle gebruikers van deze computer en is hier niet te verwijderen: %1</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and stays as it is. To lose it, delete the file.</source>
        <translation>%1 is door een ander programma veranderd en blijft zoals het is. Wie het niet wil houden, verwijdert het bestand.</translation>
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
        <translation>Vel instellen</translation>
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
        <translation>Stand:</translation>
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
        <source>Friction on each sheet</source>
        <translation>Wrijving op elk vel</translation>
    </message>
    <message>
        <source>Bold numbers are the medium&apos;s own for that sheet</source>
        <translation>Vette getallen zijn die van het tekenmiddel zelf op dat vel</translation>
    </message>
    <message>
        <source>Double-click a number, or press F2, to set the friction on that sheet</source>
        <translation>Dubbelklik op een getal, of druk op F2, om de wrijving op dat vel in te stellen</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Vel</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>By the rule</source>
        <translation>Volgens de regel</translation>
    </message>
    <message>
        <source>Friction of the medium times that of the sheet, again</source>
        <translation>Weer de wrijving van het tekenmiddel maal die van het vel</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PenInput</name>
    <message>
        <source>Pressure is switched off.</source>
        <translation>Druk is uitgeschakeld.</translation>
    </message>
    <message>
        <source>Your pen&apos;s pressure is seen.</source>
        <translation>De druk van je pen wordt gezien.</translation>
    </message>
    <message>
        <source>Your pen senses no pressure.</source>
        <translation>Je pen voelt geen druk.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::PenTestArea</name>
    <message>
        <source>Test area</source>
        <translation>Proefvlak</translation>
    </message>
    <message>
        <source>Scribble here to try the pen; nothing of it is kept.</source>
        <translation>Krabbel hier om de pen te proberen; er blijft niets van bewaard.</translation>
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
        <source>Off: every line has the same width, however hard you press.</source>
        <translation>Uit: elke lijn is even breed, hoe hard je ook drukt.</translation>
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
        <source>Soft: a light hand draws wide. Firm: press harder for the same width.</source>
        <translation>Zacht: een lichte hand tekent breed. Stevig: druk harder voor dezelfde breedte.</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Stevig</translation>
    </message>
    <message>
        <source>&amp;Touches from</source>
        <translation>&amp;Raakt vanaf</translation>
    </message>
    <message>
        <source>Pressure from which the pen touches</source>
        <translation>Druk vanaf welke de pen raakt</translation>
    </message>
    <message>
        <source>For a pen that draws before it is pressed.</source>
        <translation>Voor een pen die tekent voordat je drukt.</translation>
    </message>
    <message>
        <source>&amp;Straight again</source>
        <translation>Weer &amp;recht</translation>
    </message>
    <message>
        <source>The curve that it came with.</source>
        <translation>De oorspronkelijke kromme.</translation>
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
        <source>Charcoal, chalk and pencils draw broader with a pen that leans, where it can say so.</source>
        <translation>Houtskool, krijt en potloden tekenen breder als de pen overhelt, mits hij dat kan zeggen.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Wissen</translation>
    </message>
    <message>
        <source>Takes what was scribbled away.</source>
        <translation>Haalt het gekrabbel weg.</translation>
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
        <source>The same all along</source>
        <translation>Overal gelijk</translation>
    </message>
    <message>
        <source>Thinner when fast</source>
        <translation>Snel is dunner</translation>
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
        <source>Moves the sheet</source>
        <translation>Verschuift het vel</translation>
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
        <source>Two fingers move, zoom and turn the sheet. While the pen is near, touch is ignored.</source>
        <translation>Twee vingers verschuiven, zoomen en draaien het vel. Is de pen dichtbij, dan telt aanraking niet.</translation>
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
        <source>The pen leans by %L1°</source>
        <translation>De pen helt %L1° over</translation>
    </message>
    <message>
        <source>How far the pen leans is not known</source>
        <translation>Hoe ver de pen overhelt is niet bekend</translation>
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
        <translation>Pagina&apos;s van de voorkeuren</translation>
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
        <source>Sheet</source>
        <translation>Vel</translation>
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
    <name>felt::desktop::PressureCurveEditor</name>
    <message>
        <source>Pressure curve</source>
        <translation>Drukkromme</translation>
    </message>
    <message>
        <source>From the pen&apos;s pressure, left to right, to the line&apos;s width, bottom to top. The arrow keys move a handle, Space takes the other one.</source>
        <translation>Van de druk van de pen, links naar rechts, naar de breedte van de lijn, onder naar boven. Pijltoetsen bewegen een greep, de spatiebalk neemt de andere.</translation>
    </message>
    <message>
        <source>Drag the two handles. Higher is wider.</source>
        <translation>Sleep de twee grepen. Hoger is breder.</translation>
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
        <source>Feltline did not close in order. This was not saved:</source>
        <translation>Feltline is niet netjes afgesloten. Dit was niet opgeslagen:</translation>
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
        <source>Throw “%1” away</source>
        <translation>‘%1’ weggooien</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Weggooien</translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
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
        <source>⚠ Not all of it could be read.</source>
        <translation>⚠ Niet alles ervan was leesbaar.</translation>
    </message>
    <message>
        <source>Recover as a new drawing</source>
        <translation>Als nieuwe tekening herstellen</translation>
    </message>
    <message>
        <source>Open the saved one</source>
        <translation>Opgeslagen tekening openen</translation>
    </message>
    <message>
        <source>Open “%1” as it was saved</source>
        <translation>“%1” openen zoals ze is opgeslagen</translation>
    </message>
    <message>
        <source>What was not saved is kept, and offered again at the next start</source>
        <translation>Wat niet is opgeslagen blijft bewaard en wordt bij de volgende start weer aangeboden</translation>
    </message>
    <message>
        <source>Throw away what was not saved of “%1”?</source>
        <translation>Weggooien wat van “%1” niet is opgeslagen?</translation>
    </message>
    <message>
        <source>It cannot be brought back. The file stays as it is.</source>
        <translation>Het kan niet worden teruggehaald. Het bestand blijft zoals het is.</translation>
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
    <name>felt::desktop::ShadeField</name>
    <message>
        <source>Saturation and brightness</source>
        <translation>Verzadiging en helderheid</translation>
    </message>
    <message>
        <source>Across: saturation. Up: brightness. Arrow keys move it.</source>
        <translation>Dwars: verzadiging. Omhoog: helderheid. Pijltoetsen verschuiven ze.</translation>
    </message>
    <message>
        <source>Saturation %1 %, brightness %2 %</source>
        <translation>Verzadiging %1%, helderheid %2%</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ShortcutSheet</name>
    <message>
        <source>Keys at a glance</source>
        <translation>Toetsen in één oogopslag</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Search the keys</source>
        <translation>Toetsen zoeken</translation>
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
        <source>No key does that.</source>
        <translation>Geen toets doet dat.</translation>
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
        <source>&amp;Take it over</source>
        <translation>&amp;Overnemen</translation>
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
        <translation>Alle toetsen herstellen</translation>
    </message>
    <message>
        <source>Give every command the key that it came with?</source>
        <translation>Elke opdracht zijn oorspronkelijke toets geven?</translation>
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
        <translation>%1 hoort bij ‘%2’.</translation>
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
        <source>Width of a line drawn with the mouse, or size of the current tool. Press [ or ] to change it.</source>
        <translation>Breedte van een lijn die met de muis wordt getekend, of grootte van het huidige gereedschap. [ en ] wijzigen die.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::SoundState</name>
    <message>
        <source>There is no sound device now, so nothing is heard. It is heard once there is one.</source>
        <translation>Er is nu geen geluidsapparaat, dus is er niets te horen. Zodra er een is, is het te horen.</translation>
    </message>
    <message>
        <source>This program was built without sound.</source>
        <translation>Dit programma is zonder geluid gebouwd.</translation>
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
        <source>Place of the pen</source>
        <translation>Plaats van de pen</translation>
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
        <source>Turn of the view</source>
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
        <source>This drawing has its own figures for: %1. Yours stay as they are.</source>
        <translation>Deze tekening heeft eigen waarden voor: %1. Die van jou blijven zoals ze zijn.</translation>
    </message>
    <message>
        <source>The sheet “%1” is not known here: it feels as the one before.</source>
        <translation>Het vel “%1” is hier niet bekend: het voelt aan als het vorige.</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TestPad</name>
    <message>
        <source>Test pad</source>
        <translation>Proefvlak</translation>
    </message>
    <message>
        <source>Press here with pen or mouse to try the device</source>
        <translation>Druk hier met pen of muis om het apparaat te proberen</translation>
    </message>
    <message>
        <source>Try this device on the sheet itself.</source>
        <translation>Probeer dit apparaat op het vel zelf.</translation>
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
        <source>in hand while the key is held</source>
        <translation>in de hand zolang de toets ingedrukt is</translation>
    </message>
    <message>
        <source>comes back when the key is let go</source>
        <translation>komt terug als de toets wordt losgelaten</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>in de hand</translation>
    </message>
</context>
<context>
    <name>felt::desktop::ToolKeys</name>
    <message>
        <source>&amp;Eraser while held</source>
        <translation>&amp;Gum zolang ingedrukt</translation>
    </message>
    <message>
        <source>The eraser as long as the key is held; the pencil where the eraser is in hand</source>
        <translation>De gum zolang de toets ingedrukt is; het potlood als je de gum in de hand hebt</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TopBar</name>
    <message>
        <source>Top bar</source>
        <translation>Bovenste balk</translation>
    </message>
    <message>
        <source>Sheet:</source>
        <translation>Vel:</translation>
    </message>
    <message>
        <source>Material of the sheet</source>
        <translation>Materiaal van het vel</translation>
    </message>
    <message>
        <source>What the sheet feels and looks like</source>
        <translation>Hoe het vel aanvoelt en eruitziet</translation>
    </message>
    <message>
        <source>What is drawn with</source>
        <translation>Waarmee getekend wordt</translation>
    </message>
    <message>
        <source>What the pen is made of: how it looks, feels and sounds</source>
        <translation>Waarvan de pen is: hoe hij eruitziet, aanvoelt en klinkt</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Grootte:</translation>
    </message>
    <message>
        <source>Medium:</source>
        <translation>Tekenmiddel:</translation>
    </message>
</context>
<context>
    <name>felt::desktop::TourWindow</name>
    <message>
        <source>Guided tour</source>
        <translation>Rondleiding</translation>
    </message>
    <message>
        <source>The sheet of the tour</source>
        <translation>Het vel van de rondleiding</translation>
    </message>
    <message>
        <source>How much of the tour was seen</source>
        <translation>Hoeveel van de rondleiding is gezien</translation>
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
        <source>Draw with a pen or with the mouse. Press ? for the keys. Nothing can go wrong: Ctrl+Z takes everything back.</source>
        <translation>Teken met een pen of met de muis. Druk op ? voor de toetsen. Er kan niets misgaan: Ctrl+Z neemt alles terug.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Verder</translation>
    </message>
    <message>
        <source>&amp;Try it yourself</source>
        <translation>Zelf &amp;proberen</translation>
    </message>
</context>
<context>
    <name>tools</name>
    <message>
        <source>A line drawn round what is to be selected, or a rectangle from corner to corner.</source>
        <translation>Een lijn om wat geselecteerd moet worden, of een rechthoek van hoek tot hoek.</translation>
    </message>
    <message>
        <source>Lines farther from the pen than this cannot be grabbed.</source>
        <translation>Een lijn die verder van de pen ligt, wordt niet gepakt.</translation>
    </message>
    <message>
        <source>Erases the ink that the ring covers. Off: cuts a line where the ring covers its middle, whatever its width.</source>
        <translation>Gumt de inkt die de ring bedekt. Uit: knipt een lijn waar de ring haar midden bedekt, hoe breed ze ook is.</translation>
    </message>
    <message>
        <source>A line touched from beside keeps its distance from the pen, instead of coming to the pen over the first millimetres.</source>
        <translation>Een lijn die ernaast wordt aangeraakt, houdt haar afstand tot de pen, in plaats van in de eerste millimeters naar de pen te komen.</translation>
    </message>
    <message>
        <source>A short touch selects the whole nearest line within this distance.</source>
        <translation>Een korte aanraking selecteert de hele dichtstbijzijnde lijn binnen deze afstand.</translation>
    </message>
    <message>
        <source>Above 1 a light hand stays thin for longer, below 1 it broadens sooner.</source>
        <translation>Boven 1 blijft een lichte hand langer dun, onder 1 wordt hij eerder breed.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Hoeveelheid</translation>
    </message>
    <message>
        <source>An end that is let go beside all others stays there; without it, it goes back. The first modifier chooses the other.</source>
        <translation>Een eind dat naast alle andere wordt losgelaten blijft daar; anders gaat het terug. De eerste extra toets kiest het andere.</translation>
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
        <source>Width of ink counts</source>
        <translation>Breedte van de inkt telt</translation>
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
        <source>Corrects lines: take hold of one and pull it into shape, or push it from outside.</source>
        <translation>Verbetert lijnen: pak er een en trek haar in vorm, of duw haar van buitenaf.</translation>
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
        <source>Ends and corners go along, instead of staying unless taken hold of; the first modifier turns this round for one gesture.</source>
        <translation>Uiteinden en hoeken gaan mee, in plaats van te blijven als ze niet gepakt zijn; de eerste extra toets draait dit om voor één gebaar.</translation>
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
        <source>Grab divides the line so that no more than this is bent; 0 takes segments as they are.</source>
        <translation>Pakken verdeelt de lijn zodat niet meer dan dit wordt gebogen; 0 neemt segmenten zoals ze zijn.</translation>
    </message>
    <message>
        <source>Grab radius</source>
        <translation>Pakstraal</translation>
    </message>
    <message>
        <source>Heavier draws smoother and trails more; for the stabiliser &apos;inertia&apos;.</source>
        <translation>Zwaarder tekent vloeiender en sleept meer na; voor de stabilisator ‘traagheid’.</translation>
    </message>
    <message>
        <source>How far a line may move when the brush lets go of it; more leaves fewer segments.</source>
        <translation>Hoe ver een lijn mag verschuiven als het penseel haar loslaat; meer laat minder segmenten over.</translation>
    </message>
    <message>
        <source>How far the brush reaches along the line, to each side.</source>
        <translation>Hoe ver het penseel langs de lijn reikt, naar elke kant.</translation>
    </message>
    <message>
        <source>How far the finished line may be from the ironed one, for fewer segments.</source>
        <translation>Hoe ver de voltooide lijn van de gladgestreken mag liggen, voor minder segmenten.</translation>
    </message>
    <message>
        <source>How far the pen leans, from upright, where the device does not say: some media draw broader and softer with their side.</source>
        <translation>Hoe ver de pen overhelt vanuit rechtop, als het apparaat het niet zegt: sommige middelen tekenen met hun zijkant breder en zachter.</translation>
    </message>
    <message>
        <source>How fast it irons; pressing harder irons faster too.</source>
        <translation>Hoe snel het gladstrijkt; harder drukken gaat ook sneller.</translation>
    </message>
    <message>
        <source>How fast the width changes, per unit of pressure.</source>
        <translation>Hoe snel de breedte verandert, per druk.</translation>
    </message>
    <message>
        <source>How grab bends a segment: with least motion (soft), by the paper&apos;s three cases (paper), or by its equation 7 as printed, which does not reach the pen.</source>
        <translation>Hoe pakken een segment buigt: met de minste beweging (zacht), volgens de drie gevallen van het artikel (artikel), of volgens vergelijking 7 zoals gedrukt, die de pen niet bereikt.</translation>
    </message>
    <message>
        <source>Distance within which the pen grabs the end of a line.</source>
        <translation>Hoe dicht bij het eind van een lijn de pen het pakt.</translation>
    </message>
    <message>
        <source>How slowly a line gives way to the pen that sweeps it.</source>
        <translation>Hoe langzaam een lijn toegeeft aan de vegende pen.</translation>
    </message>
    <message>
        <source>Irons the jitter out of lines and leaves their shape.</source>
        <translation>Strijkt het beven uit lijnen en laat hun vorm.</translation>
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
        <source>Keep lines separate</source>
        <translation>Lijnen apart houden</translation>
    </message>
    <message>
        <source>Largest distance between the pen&apos;s path and the line.</source>
        <translation>Grootste afstand tussen de weg van de pen en de lijn.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Tilt of a mouse&apos;s pen</source>
        <translation>Helling van de pen van een muis</translation>
    </message>
    <message>
        <source>Leave the end where it is let go</source>
        <translation>Het eind laten waar het wordt losgelaten</translation>
    </message>
    <message>
        <source>Leaves the lines and transforms a copy; as the second button of the pen does.</source>
        <translation>Laat de lijnen en transformeert een kopie; zoals de tweede penknop.</translation>
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
        <source>Longer draws smoother and trails more; for the stabiliser &apos;towed&apos;.</source>
        <translation>Langer tekent vloeiender en sleept meer na; voor de stabilisator ‘gesleept’.</translation>
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
        <source>Moves along one axis, turns in steps of 15 degrees, corners stretch both axes freely; as the first button of the pen does.</source>
        <translation>Verplaatst langs één as, draait in stappen van 15 graden, hoeken rekken beide assen vrij; zoals de eerste penknop.</translation>
    </message>
    <message>
        <source>Moves, turns, scales and stretches what is selected, held back by the lines that lead out of it.</source>
        <translation>Verplaatst, draait, schaalt en rekt wat geselecteerd is, tegengehouden door de lijnen die eruit leiden.</translation>
    </message>
    <message>
        <source>No line is made broader than this; one that is may stay so.</source>
        <translation>Geen lijn wordt breder dan dit; een die dat al is mag zo blijven.</translation>
    </message>
    <message>
        <source>Of retracing: above 1 a light hand stays thin for longer.</source>
        <translation>Bij overtrekken: boven 1 blijft een lichte hand langer dun.</translation>
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
        <source>Pressure to use if the device reports neither pressure nor depth.</source>
        <translation>Druk van een apparaat dat druk noch diepte kent.</translation>
    </message>
    <message>
        <source>Pressure of a mouse</source>
        <translation>Druk van een muis</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Trekken</translation>
    </message>
    <message>
        <source>Pull a stretch of a line (brush), bend one segment (grab), push lines from outside (push), or draw a line over again (sweep).</source>
        <translation>Een stuk lijn trekken (penseel), één segment buigen (pakken), lijnen van buitenaf duwen (duwen), of een lijn opnieuw trekken (vegen).</translation>
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
        <source>Rounds corners, which otherwise stay; ends of lines always do.</source>
        <translation>Rondt hoeken af, die anders blijven; lijneinden blijven altijd.</translation>
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
        <source>Selects the lines inside a loop that you draw; a short touch selects one line.</source>
        <translation>Selecteert waar een lijn omheen getekend wordt; een korte aanraking neemt een lijn.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Force level of friction and grain. Does not affect surface stiffness.</source>
        <translation>Aandeel van wrijving en korrel dat je voelt; het vel blijft zo hard als het is.</translation>
    </message>
    <message>
        <source>Force level of friction and roughness. Does not affect surface stiffness.</source>
        <translation>Aandeel van wrijving en ruwheid dat je voelt; het vel blijft zo hard als het is.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction and pull. Does not affect surface stiffness.</source>
        <translation>Aandeel van wrijving, korrel, aantrekking en trek dat je voelt; het vel blijft zo hard als het is.</translation>
    </message>
    <message>
        <source>Force level of friction, grain, attraction and stabiliser. Does not affect surface stiffness.</source>
        <translation>Aandeel van wrijving, korrel, aantrekking en stabilisator dat je voelt; het vel blijft zo hard als het is.</translation>
    </message>
    <message>
        <source>Force level of friction, stops and pull. Does not affect surface stiffness.</source>
        <translation>Aandeel van wrijving, aanslagen en trek dat je voelt; het vel blijft zo hard als het is.</translation>
    </message>
    <message>
        <source>Force level of the counter-force, friction and grain. Does not affect surface stiffness.</source>
        <translation>Aandeel van tegenkracht, wrijving en korrel dat je voelt; het vel blijft zo hard als het is.</translation>
    </message>
    <message>
        <source>Force level of the surface&apos;s friction and grain. Does not affect surface stiffness.</source>
        <translation>Aandeel van wrijving en korrel van het vel dat je voelt; het vel blijft zo hard als het is.</translation>
    </message>
    <message>
        <source>Force level of the attached lines, friction and grain.</source>
        <translation>Aandeel van lijnen, wrijving en korrel dat je voelt.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Vel</translation>
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
        <source>The parts of lines inside by their control points (points) or by their joints only (on-curve), or whole lines of which any part is inside (strokes).</source>
        <translation>De delen van lijnen erbinnen naar hun controlepunten (punten) of alleen hun knooppunten (op de kromme), of hele lijnen waarvan een deel erbinnen ligt (lijnen).</translation>
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
        <source>Tolerance</source>
        <translation>Tolerantie</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transformeren</translation>
    </message>
    <message>
        <source>Length of line on both sides of the pen that is smoothed. Waves up to this length can be removed.</source>
        <translation>Weg langs de lijn, aan beide kanten van de pen, die wordt gladgestreken; golven tot deze lengte kunnen weg.</translation>
    </message>
    <message>
        <source>Length of line on both sides of the pen in which the width changes.</source>
        <translation>Weg langs de lijn, aan beide kanten van de pen, waarbinnen de breedte verandert.</translation>
    </message>
    <message>
        <source>Weights of grab</source>
        <translation>Gewichten van pakken</translation>
    </message>
    <message>
        <source>What a touch does</source>
        <translation>Wat een aanraking doet</translation>
    </message>
    <message>
        <source>What becomes of what was selected before; the first button of the pen adds, the second takes away.</source>
        <translation>Wat er met de vorige selectie gebeurt; de eerste penknop voegt toe, de tweede haalt weg.</translation>
    </message>
    <message>
        <source>What goes</source>
        <translation>Wat verdwijnt</translation>
    </message>
    <message>
        <source>What is covered, the part of a line up to its next crossings, or the whole line.</source>
        <translation>Wat bedekt is, het deel van een lijn tot de volgende kruisingen, of de hele lijn.</translation>
    </message>
    <message>
        <source>What the pen is made of: how it looks and how it slides.</source>
        <translation>Waar de pen van gemaakt is: hoe hij eruitziet en hoe hij glijdt.</translation>
    </message>
    <message>
        <source>Surface to draw on. Sets hardness, friction and grain.</source>
        <translation>Waar het vel van gemaakt is: zijn hardheid en wrijving.</translation>
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
        <source>With nothing selected, a touch selects the nearest line within this distance.</source>
        <translation>Is er niets geselecteerd, dan neemt een aanraking de dichtstbijzijnde lijn binnen deze afstand.</translation>
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
        <translation>Linnen</translation>
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
        <translation>linnen</translation>
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
        <source>Above 1 a light hand stays pale for longer, below 1 it darkens sooner.</source>
        <translation>Boven 1 blijft een lichte hand langer bleek, onder 1 wordt die eerder donker.</translation>
    </message>
    <message>
        <source>Another one makes another relief of its kind.</source>
        <translation>Een andere maakt een ander reliëf van die soort.</translation>
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
        <source>Coefficient of friction of the pencil on it.</source>
        <translation>Wrijvingscoëfficiënt van het potlood erop.</translation>
    </message>
    <message>
        <source>Coefficient of friction on paper; pairs may say otherwise.</source>
        <translation>Wrijvingscoëfficiënt op papier; paren kunnen iets anders zeggen.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kleur</translation>
    </message>
    <message>
        <source>Colour of the surface. A page with another colour keeps it.</source>
        <translation>Kleur van het vel; een pagina met een andere kleur houdt de hare.</translation>
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
        <source>Damping of that.</source>
        <translation>Demping daarvan.</translation>
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
        <source>From hill to hill; a relief of one&apos;s own is 32 of it wide.</source>
        <translation>Van heuvel tot heuvel; een eigen reliëf is er 32 van breed.</translation>
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
        <source>Half of the width of the edge of a grain.</source>
        <translation>Halve breedte van de rand van een korrel.</translation>
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
        <source>How far a line falls apart into hairs along its way.</source>
        <translation>Hoever een lijn in de lengte in haren uiteenvalt.</translation>
    </message>
    <message>
        <source>How far the rim of the line is soft, in shares of its radius.</source>
        <translation>Hoever de rand van de lijn zacht is, in delen van de straal.</translation>
    </message>
    <message>
        <source>How hard it pushes back, where the device bears as much.</source>
        <translation>Hoe hard het terugduwt, voor zover het apparaat dat verdraagt.</translation>
    </message>
    <message>
        <source>How loud a pen is on it; 0 is silent.</source>
        <translation>Hoe luid een pen erop is; 0 is stil.</translation>
    </message>
    <message>
        <source>How loud it rubs; 0 is silent.</source>
        <translation>Hoe luid het wrijft; 0 is stil.</translation>
    </message>
    <message>
        <source>How much at full pressure.</source>
        <translation>Hoeveel bij volle druk.</translation>
    </message>
    <message>
        <source>How much darker a wet line dries at its rim.</source>
        <translation>Hoeveel donkerder een natte lijn aan de rand droogt.</translation>
    </message>
    <message>
        <source>How much is laid on without pressure.</source>
        <translation>Hoeveel er zonder druk wordt aangebracht.</translation>
    </message>
    <message>
        <source>How much it swallows of a push.</source>
        <translation>Hoeveel het van een duw opslokt.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief shows in the ink; 0 for wet ink.</source>
        <translation>Hoeveel van het reliëf van het vel te zien is; 0 voor wat nat is.</translation>
    </message>
    <message>
        <source>How much of the surface&apos;s relief the hand feels through it.</source>
        <translation>Hoeveel van het reliëf van het vel de hand erdoor voelt.</translation>
    </message>
    <message>
        <source>How readily stick and slip sing.</source>
        <translation>Hoe gemakkelijk kleven en glijden zingen.</translation>
    </message>
    <message>
        <source>How stiffly it holds before it slides.</source>
        <translation>Hoe stijf het houdt voordat het glijdt.</translation>
    </message>
    <message>
        <source>In tones of an upright one.</source>
        <translation>In tonen van een rechtopstaande.</translation>
    </message>
    <message>
        <source>In widths of an upright one.</source>
        <translation>In breedtes van een rechtopstaande.</translation>
    </message>
    <message>
        <source>Its usual colour.</source>
        <translation>De gebruikelijke kleur.</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Luidheid</translation>
    </message>
    <message>
        <source>Of what is inked, at tone 0.</source>
        <translation>Van wat is ingekleurd, bij toon 0.</translation>
    </message>
    <message>
        <source>Of what is inked, at tone 1.</source>
        <translation>Van wat is ingekleurd, bij toon 1.</translation>
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
        <translation>Drukcurve van de toon</translation>
    </message>
    <message>
        <source>Pressure curve of the width</source>
        <translation>Drukcurve van de breedte</translation>
    </message>
    <message>
        <source>Root mean square of its heights; 0 is smooth.</source>
        <translation>Effectieve waarde van de hoogten; 0 is glad.</translation>
    </message>
    <message>
        <source>Seed of the grain</source>
        <translation>Startwaarde van de korrel</translation>
    </message>
    <message>
        <source>Share of its own coarseness: dust and crumbs.</source>
        <translation>Aandeel van de eigen grofheid: stof en kruimels.</translation>
    </message>
    <message>
        <source>Share of the relief that a firm push flattens, for hand and eye.</source>
        <translation>Aandeel van het reliëf dat een stevige duw vlakt, voor hand en oog.</translation>
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
        <source>The same at tone 1.</source>
        <translation>Hetzelfde bij toon 1.</translation>
    </message>
    <message>
        <source>Their wavelength.</source>
        <translation>Hun golflengte.</translation>
    </message>
    <message>
        <source>Tone of a heavy hand</source>
        <translation>Toon van een harde hand</translation>
    </message>
    <message>
        <source>Tone of a leaning pen</source>
        <translation>Toon van een schuine pen</translation>
    </message>
    <message>
        <source>Tone of a light hand</source>
        <translation>Toon van een lichte hand</translation>
    </message>
    <message>
        <source>Wear of the grain</source>
        <translation>Slijtage van de korrel</translation>
    </message>
    <message>
        <source>What lies below so many heights of the grain stays bare, at tone 0.</source>
        <translation>Wat onder zoveel hoogten van de korrel ligt, blijft kaal, bij toon 0.</translation>
    </message>
    <message>
        <source>What the relief looks like.</source>
        <translation>Hoe het reliëf eruitziet.</translation>
    </message>
    <message>
        <source>Width of a leaning pen</source>
        <translation>Breedte van een schuine pen</translation>
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
        <source>Force that draws the pen to its target.</source>
        <translation>Kracht die de pen naar zijn doel trekt.</translation>
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
        <source>Drag a line to bend it; it goes back as you go back.</source>
        <translation>Sleep een lijn om hem te buigen; hij gaat terug als jij teruggaat.</translation>
    </message>
    <message>
        <source>Rub along a line to iron the tremor out; press to iron harder.</source>
        <translation>Wrijf langs een lijn om trillingen glad te strijken; druk om harder te strijken.</translation>
    </message>
    <message>
        <source>Rub a line to make it broader or thinner.</source>
        <translation>Wrijf een lijn om hem breder of dunner te maken.</translation>
    </message>
    <message>
        <source>Erase the ink that the ring touches.</source>
        <translation>Gum weg wat de ring raakt.</translation>
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
        <source>Draw a loop around lines, or click one.</source>
        <translation>Teken om wat je bedoelt heen, of klik een lijn aan.</translation>
    </message>
    <message>
        <source>adds</source>
        <translation>voegt toe</translation>
    </message>
    <message>
        <source>takes away</source>
        <translation>haalt weg</translation>
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
        <source>a copy</source>
        <translation>een kopie</translation>
    </message>
    <message>
        <source>Drag the end of a line to another end.</source>
        <translation>Sleep het eind van een lijn naar een ander eind.</translation>
    </message>
    <message>
        <source>the end stays where you let it go</source>
        <translation>het eind blijft waar je het loslaat</translation>
    </message>
    <message>
        <source>ends and corners go along, or stay</source>
        <translation>uiteinden en hoeken gaan mee of blijven</translation>
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
        <source>Lines become smooth curves while you draw; press harder for a broader one. Near its start, an outline snaps shut.</source>
        <translation>Lijnen worden vloeiend terwijl je tekent; druk harder voor een bredere. Dicht bij het begin klikt een omtrek dicht.</translation>
    </message>
    <message>
        <source>Pull and push</source>
        <translation>Trekken en duwen</translation>
    </message>
    <message>
        <source>A line is not quite right? Take hold of it and pull. It resists like a wire, the more the further you go.</source>
        <translation>Klopt een lijn niet helemaal? Pak hem vast en trek. Hij biedt weerstand als een draad, hoe verder hoe meer.</translation>
    </message>
    <message>
        <source>Rub along a shaky line: the jitter goes, the shape stays.</source>
        <translation>Wrijf langs een beverige lijn: het beven gaat weg, de vorm blijft.</translation>
    </message>
    <message>
        <source>Press on a line to make it broader, after it was drawn.</source>
        <translation>Druk op een lijn om hem achteraf breder te maken.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Gummen</translation>
    </message>
    <message>
        <source>Rub away what is covered, a line up to its next crossing, or all of it.</source>
        <translation>Wrijf weg wat bedekt is, een lijn tot de volgende kruising, of helemaal.</translation>
    </message>
    <message>
        <source>Draw a loop around lines to select them; touch one to take it.</source>
        <translation>Teken een lus om lijnen om ze te selecteren; raak er een aan om hem te nemen.</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Verplaatsen en draaien</translation>
    </message>
    <message>
        <source>Drag what is selected. Lines that lead out of it hold it back, and you feel how much.</source>
        <translation>Sleep wat geselecteerd is. Lijnen die eruit leiden houden het tegen, en je voelt hoeveel.</translation>
    </message>
    <message>
        <source>Drag one end onto another: they snap, and become one line.</source>
        <translation>Sleep een eind op een ander: ze klikken vast en worden één lijn.</translation>
    </message>
</context>
</TS>
