<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Thicken</name>
    <message>
        <source>Check Surface</source>
        <extracomment>None until they are known</extracomment>
        <translation>Fläche prüfen</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>“{label}” can be thickened: it has no defect.</source>
        <translation>„{label}“ kann verdickt werden: Sie hat keine Fehler.</translation>
    </message>
    <message>
        <source>“{label}” has {count} defects. Click one to go there.</source>
        <translation>„{label}“ hat {count} Fehler. Ein Klick auf einen führt dorthin.</translation>
    </message>
    <message>
        <source>Edge</source>
        <extracomment>n × 3, what to look at</extracomment>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>The direction in which the part grows while it is printed</source>
        <translation>Die Richtung, in der das Teil beim Drucken wächst</translation>
    </message>
    <message>
        <source>Drain holes</source>
        <extracomment>the holes of the inputs that are shown; None while they are computed</extracomment>
        <translation>Ablauflöcher</translation>
    </message>
    <message>
        <source>Drain Holes</source>
        <translation>Ablauflöcher</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Printed towards</source>
        <translation>Druckrichtung</translation>
    </message>
    <message>
        <source>Holes in each cavity</source>
        <translation>Löcher je Hohlraum</translation>
    </message>
    <message>
        <source>Make plugs for the holes</source>
        <translation>Stopfen für die Löcher erzeugen</translation>
    </message>
    <message>
        <source>Place automatically</source>
        <translation>Automatisch platzieren</translation>
    </message>
    <message>
        <source>{count} places chosen by clicks.</source>
        <translation>{count} Stellen durch Klicks gewählt.</translation>
    </message>
    <message>
        <source>At the lowest points of each cavity. Click on the solid to choose the places yourself.</source>
        <translation>An den tiefsten Stellen jedes Hohlraums. Ein Klick auf den Körper wählt die Stelle selbst.</translation>
    </message>
    <message>
        <source>A task is open</source>
        <translation>Eine Aufgabe ist offen</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>Bitte zuerst die offene Aufgabe schließen.</translation>
    </message>
    <message>
        <source>Thicken cannot start</source>
        <translation>Verdicken kann nicht beginnen</translation>
    </message>
    <message>
        <source>No surface is chosen. Set Source in the property editor.</source>
        <translation>Keine Fläche ist gewählt. Bitte Source im Eigenschafteneditor setzen.</translation>
    </message>
    <message>
        <source>Nothing was written</source>
        <translation>Nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>Export for Printing</source>
        <translation>Zum Drucken exportieren</translation>
    </message>
    <message>
        <source>“{label}” was written to {path}, read again and proved valid: {triangles} triangles, {volume} mL.</source>
        <translation>„{label}“ wurde nach {path} geschrieben, wieder gelesen und als gültig bewiesen: {triangles} Dreiecke, {volume} ml.</translation>
    </message>
    <message>
        <source>The longer a bar, the more of the area has this value (square roots)</source>
        <extracomment>the label that tells why there is none</extracomment>
        <translation>Je länger ein Balken, desto mehr von der Fläche hat diesen Wert (Quadratwurzeln)</translation>
    </message>
    <message>
        <source>Thickness Map</source>
        <extracomment>the ThicknessMap that is shown</extracomment>
        <translation>Dickenkarte</translation>
    </message>
    <message>
        <source>Wall thickness (mm)</source>
        <translation>Wanddicke (mm)</translation>
    </message>
    <message>
        <source>Deviation of the shell from the thickness (mm)</source>
        <translation>Abweichung der Schale von der Dicke (mm)</translation>
    </message>
    <message>
        <source>Go to the least</source>
        <translation>Zum kleinsten Wert</translation>
    </message>
    <message>
        <source>Go to the largest</source>
        <translation>Zum größten Wert</translation>
    </message>
    <message>
        <source>Measuring …</source>
        <translation>Wird gemessen …</translation>
    </message>
    <message>
        <source>Least {least}, mean {mean}, largest {largest} mm. 98 % of the area: {low} to {high} mm.</source>
        <translation>Kleinster Wert {least}, Mittel {mean}, größter {largest} mm. 98 % der Fläche: {low} bis {high} mm.</translation>
    </message>
    <message>
        <source>There is not enough memory. Simplify the mesh, or choose a coarser quality.</source>
        <translation>Der Speicher reicht nicht. Bitte das Netz vereinfachen oder eine gröbere Güte wählen.</translation>
    </message>
    <message>
        <source>Thicken cannot compute</source>
        <translation>Thicken kann nicht rechnen</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <translation>Fläche reparieren</translation>
    </message>
    <message>
        <source>Repair Surface</source>
        <translation>Fläche reparieren</translation>
    </message>
    <message>
        <source>There was nothing to mend.</source>
        <translation>Es gab nichts zu reparieren.</translation>
    </message>
    <message>
        <source>Printability Report</source>
        <extracomment>what the report and its page are made from</extracomment>
        <translation>Druckbarkeitsbericht</translation>
    </message>
    <message>
        <source>Thinnest wall that prints</source>
        <translation>Dünnste druckbare Wand</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>Bereit zum Drucken</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Thinnest wall</source>
        <translation>Dünnste Wand</translation>
    </message>
    <message>
        <source>Overhang beyond {angle}°</source>
        <translation>Überhang über {angle}°</translation>
    </message>
    <message>
        <source>On the plate</source>
        <translation>Auf der Platte</translation>
    </message>
    <message>
        <source>Trapped</source>
        <translation>Eingeschlossen</translation>
    </message>
    <message>
        <source>Thicken</source>
        <extracomment>until then nothing is called</extracomment>
        <translation>Verdicken</translation>
    </message>
    <message>
        <source>Pick a region</source>
        <translation>Bereich wählen</translation>
    </message>
    <message>
        <source>Thicken a part of the mesh: each click in the view adds a smooth patch, or takes it away</source>
        <translation>Einen Teil des Netzes verdicken: Jeder Klick in der Ansicht nimmt ein glattes Stück dazu oder weg</translation>
    </message>
    <message>
        <source>A patch ends where the surface turns by more than this</source>
        <translation>Ein Stück endet, wo sich die Fläche um mehr als dies dreht</translation>
    </message>
    <message>
        <source>All of it</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>How thick the solid is: a length with a unit, a sum, or an expression (ƒx)</source>
        <translation>Wie dick der Körper ist: eine Länge mit Einheit, eine Summe oder ein Ausdruck (ƒx)</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Part solid</source>
        <translation>Part-Festkörper</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Zellenweite</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Rounds of shape optimisation of the new surface</source>
        <translation>Runden der Formoptimierung der neuen Fläche</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>The farthest that the triangles of a shape may be from it</source>
        <translation>Wie weit die Dreiecke einer Form höchstens von ihr entfernt sein dürfen</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Repair a defective surface first</source>
        <translation>Fehler zuerst reparieren</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Click on the mesh; click “Pick a region” again to see the preview.</source>
        <translation>Auf das Netz klicken; ein weiterer Klick auf „Bereich wählen“ zeigt die Vorschau.</translation>
    </message>
    <message>
        <source>{count} triangles</source>
        <translation>{count} Dreiecke</translation>
    </message>
    <message>
        <source>Edit thickening</source>
        <translation>Verdickung bearbeiten</translation>
    </message>
    <message>
        <source>OK will take about {seconds} and {memory} of memory.</source>
        <translation>OK dauert etwa {seconds} und braucht {memory} Speicher.</translation>
    </message>
    <message>
        <source>Too many triangles for a preview.</source>
        <translation>Zu viele Dreiecke für eine Vorschau.</translation>
    </message>
    <message>
        <source>Preview: computing …</source>
        <translation>Vorschau: Wird berechnet …</translation>
    </message>
    <message>
        <source>Set a deflection above 0 mm.</source>
        <translation>Bitte eine Abweichung über 0 mm angeben.</translation>
    </message>
    <message>
        <source>Set a thickness above 0 mm.</source>
        <translation>Bitte eine Dicke über 0 mm angeben.</translation>
    </message>
    <message>
        <source>Preview: {numbers}.</source>
        <translation>Vorschau: {numbers}.</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Stopped. The document is as it was.</source>
        <translation>Angehalten. Das Dokument ist unverändert.</translation>
    </message>
    <message>
        <source>The document has no 3D view. Open one: View ▸ Create new view.</source>
        <extracomment>in the coordinates of the object</extracomment>
        <translation>Das Dokument hat keine 3D-Ansicht. Bitte eine öffnen: Ansicht ▸ Neue Ansicht.</translation>
    </message>
    <message>
        <source>The mesh is no valid solid: {defect}.</source>
        <extracomment>m: whether the facet bounds a cavity</extracomment>
        <translation>Das Netz ist kein gültiger Körper: {defect}.</translation>
    </message>
    <message>
        <source>{area} mm² of the walls ({share}) are thinner than {least} mm, the thinnest {mm} mm at {place}.</source>
        <translation>{area} mm² der Wände ({share}) sind dünner als {least} mm, am dünnsten mit {mm} mm bei {place}.</translation>
    </message>
    <message>
        <source>A closed cavity traps {volume} mL; its lowest point is at {place}. Add drain holes.</source>
        <translation>Ein geschlossener Hohlraum schließt {volume} mL ein; sein tiefster Punkt ist bei {place}. Bitte Ablauflöcher hinzufügen.</translation>
    </message>
    <message>
        <source>{volume} mL of resin stay {depth} mm deep below the holes of a cavity, at {place}. Add a hole lower down.</source>
        <translation>{volume} mL Harz bleiben {depth} mm tief unter den Löchern eines Hohlraums stehen, bei {place}. Bitte weiter unten ein Loch hinzufügen.</translation>
    </message>
    <message>
        <source>Corners moved onto a corner nearby</source>
        <extracomment>Of the properties. migrations[n] turns an object of schema n into one of n + 1.</extracomment>
        <translation>Ecken, die auf eine nahe Ecke gerückt wurden</translation>
    </message>
    <message>
        <source>Triangles with a corner that is no number, removed</source>
        <translation>Entfernte Dreiecke mit einer Ecke, die keine Zahl ist</translation>
    </message>
    <message>
        <source>Triangles without area, removed</source>
        <translation>Entfernte Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>Repeated triangles, removed</source>
        <translation>Entfernte wiederholte Dreiecke</translation>
    </message>
    <message>
        <source>Triangles divided at a corner on one of their edges</source>
        <translation>Dreiecke, die an einer Ecke auf einer ihrer Kanten geteilt wurden</translation>
    </message>
    <message>
        <source>Triangles turned over</source>
        <translation>Umgedrehte Dreiecke</translation>
    </message>
    <message>
        <source>Triangles removed where more than two met at an edge</source>
        <translation>Entfernte Dreiecke, wo mehr als zwei an einer Kante lagen</translation>
    </message>
    <message>
        <source>Triangles removed to cut a one-sided part open</source>
        <translation>Entfernte Dreiecke, um einen einseitigen Teil aufzuschneiden</translation>
    </message>
    <message>
        <source>Triangles removed that met others</source>
        <translation>Entfernte Dreiecke, die andere schnitten</translation>
    </message>
    <message>
        <source>Triangles removed where parts touched in a point only</source>
        <translation>Entfernte Dreiecke, wo sich Teile nur in einem Punkt berührten</translation>
    </message>
    <message>
        <source>Triangles removed in a fold or gap with no room for a wall</source>
        <translation>Entfernte Dreiecke in einer Falte oder Lücke ohne Platz für eine Wand</translation>
    </message>
    <message>
        <source>{what}: {count}, the first at {place}.</source>
        <translation>{what}: {count}, das erste Mal bei {place}.</translation>
    </message>
    <message>
        <source>Nothing stands against printing it.</source>
        <translation>Nichts spricht dagegen, es zu drucken.</translation>
    </message>
    <message>
        <source>Printability of {object}</source>
        <translation>Druckbarkeit von {object}</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>{height} mm, along {direction}</source>
        <translation>{height} mm, entlang {direction}</translation>
    </message>
    <message>
        <source>Height while printing</source>
        <translation>Höhe beim Drucken</translation>
    </message>
    <message>
        <source>yes, proved with exact predicates</source>
        <translation>ja, mit exakten Prädikaten bewiesen</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Valid solid</source>
        <translation>Gültiger Körper</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Overhangs beyond {angle}°</source>
        <translation>Überhänge über {angle}°</translation>
    </message>
    <message>
        <source>{area} mm², {share} of the surface</source>
        <translation>{area} mm², {share} der Oberfläche</translation>
    </message>
    <message>
        <source>{mm} mm at {place}</source>
        <translation>{mm} mm bei {place}</translation>
    </message>
    <message>
        <source>Walls below {least} mm</source>
        <translation>Wände unter {least} mm</translation>
    </message>
    <message>
        <source>{share} of the area</source>
        <translation>{share} der Fläche</translation>
    </message>
    <message>
        <source>{volume} mL, lowest at {place}</source>
        <translation>{volume} mL, am tiefsten bei {place}</translation>
    </message>
    <message>
        <source>Closed cavity {number}</source>
        <translation>Geschlossener Hohlraum {number}</translation>
    </message>
    <message>
        <source>Closed cavities</source>
        <translation>Geschlossene Hohlräume</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Stays below holes</source>
        <translation>Bleibt unter Löchern</translation>
    </message>
    <message>
        <source>From above.</source>
        <translation>Von oben.</translation>
    </message>
    <message>
        <source>From below. {colour} needs support.</source>
        <translation>Von unten. {colour} braucht Stützen.</translation>
    </message>
    <message>
        <source>Cut through the middle. {colour} closed cavities.</source>
        <translation>Durch die Mitte geschnitten. {colour} geschlossene Hohlräume.</translation>
    </message>
    <message>
        <source>Walls: {thin} below {least} mm, {thick} {most} mm and more, {plain} not measured.</source>
        <translation>Wände: {thin} unter {least} mm, {thick} {most} mm und mehr, {plain} nicht gemessen.</translation>
    </message>
    <message>
        <source>No triangles</source>
        <translation>Keine Dreiecke</translation>
    </message>
    <message>
        <source>Coordinates that are no numbers</source>
        <translation>Koordinaten, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>Edges or points where the surface branches</source>
        <translation>Kanten oder Punkte, an denen sich die Fläche verzweigt</translation>
    </message>
    <message>
        <source>Neighbours that face opposite ways</source>
        <translation>Nachbarn, die entgegengesetzt orientiert sind</translation>
    </message>
    <message>
        <source>Triangles that cross</source>
        <translation>Dreiecke, die sich schneiden</translation>
    </message>
    <message>
        <source>at {place}</source>
        <translation>bei {place}</translation>
    </message>
    <message>
        <source>One place chosen by a click.</source>
        <translation>Eine Stelle durch einen Klick gewählt.</translation>
    </message>
    <message>
        <source>Stereolithography (*.stl)</source>
        <translation>Stereolithografie (*.stl)</translation>
    </message>
    <message>
        <source>3D Manufacturing Format (*.3mf)</source>
        <translation>3D Manufacturing Format (*.3mf)</translation>
    </message>
    <message>
        <source>“{label}” is a link. Select the object that it links to, “{linked}”, or make a copy of that where the link is.</source>
        <translation>„{label}“ ist eine Verknüpfung. Bitte das verknüpfte Objekt „{linked}“ auswählen oder davon eine Kopie an der Stelle der Verknüpfung machen.</translation>
    </message>
    <message>
        <source>A link is selected</source>
        <translation>Eine Verknüpfung ist ausgewählt</translation>
    </message>
    <message>
        <source>{volume} mL, {triangles} triangles, thinnest wall {wall} mm</source>
        <translation>{volume} mL, {triangles} Dreiecke, dünnste Wand {wall} mm</translation>
    </message>
    <message>
        <source>Weld corners of rims automatically</source>
        <translation>Ecken von Rändern automatisch verschweißen</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Page with pictures (*.html)</source>
        <translation>Seite mit Bildern (*.html)</translation>
    </message>
    <message>
        <source>Data (*.json)</source>
        <translation>Daten (*.json)</translation>
    </message>
    <message>
        <source>Written: {path}</source>
        <translation>Geschrieben: {path}</translation>
    </message>
    <message>
        <source>Written: {path}, and the same facts as data in {data}</source>
        <translation>Geschrieben: {path}, und dieselben Angaben als Daten in {data}</translation>
    </message>
    <message>
        <source>To mend before printing</source>
        <translation>Vor dem Drucken zu beheben</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Part Solid</source>
        <translation>Part-Festkörper</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>In Arbeit</translation>
    </message>
    <message>
        <source>Checking the surface</source>
        <translation>Fläche prüfen</translation>
    </message>
    <message>
        <source>Building the shell</source>
        <translation>Schale bilden</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>Abstände messen</translation>
    </message>
    <message>
        <source>Rebuilding parts of the shell</source>
        <translation>Teile der Schale neu bilden</translation>
    </message>
    <message>
        <source>Smoothing the shell</source>
        <translation>Schale glätten</translation>
    </message>
    <message>
        <source>Joining the parts</source>
        <translation>Teile verbinden</translation>
    </message>
    <message>
        <source>Proving the solid</source>
        <translation>Körper prüfen</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>A Part solid is an object of its own: use the command “Part Solid”</source>
        <translation>Ein Part-Festkörper ist ein eigenes Objekt: bitte den Befehl „Part-Festkörper“ verwenden</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>Within a tolerance</source>
        <translation>Mit Toleranz</translation>
    </message>
    <message>
        <source>The farthest that the new shell may be from where it should be; what cannot be kept is refused</source>
        <translation>Wie weit die neue Schale höchstens von ihrem Ort abweichen darf; was nicht einzuhalten ist, wird abgelehnt</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Moved copy only</source>
        <translation>Nur versetzte Kopie</translation>
    </message>
    <message>
        <source>Rebuilt everywhere</source>
        <translation>Überall neu gebildet</translation>
    </message>
    <message>
        <source>The shell is a moved copy of the surface, and rebuilt where that does not fit; or only one of the two</source>
        <translation>Die Schale ist eine versetzte Kopie der Fläche und wird neu gebildet, wo das nicht passt; oder nur eines von beiden</translation>
    </message>
    <message>
        <source>By the quality</source>
        <translation>Nach der Güte</translation>
    </message>
    <message>
        <source>The grid in which parts of the shell are rebuilt</source>
        <translation>Das Gitter, in dem Teile der Schale neu gebildet werden</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Below half of the thickness: in larger cells both sides of the wall could meet</source>
        <translation>Unter der halben Dicke: In größeren Zellen könnten beide Seiten der Wand zusammentreffen</translation>
    </message>
    <message>
        <source>Cells along the longest side</source>
        <translation>Zellen entlang der längsten Seite</translation>
    </message>
    <message>
        <source>“{label}” is {length} mm long. Is it in {unit}? Then scale it first: lengths here are mm.</source>
        <translation>„{label}“ ist {length} mm lang. Sind die Längen in {unit}? Dann bitte zuerst skalieren: Hier gelten mm.</translation>
    </message>
    <message>
        <source>“Check Surface” marks the places; “Repair a defective surface first” above mends them.</source>
        <translation>„Fläche prüfen“ markiert die Stellen; „Fehler zuerst reparieren“ oben behebt sie.</translation>
    </message>
    <message>
        <source>Cavities that stay closed: {count}, of {volumes} mL.</source>
        <extracomment>what is known of the solid</extracomment>
        <translation>Hohlräume, die geschlossen bleiben: {count}, mit {volumes} mL.</translation>
    </message>
    <message>
        <source>The solid has no cavity, so that nothing is trapped in it. Give places to drill it all the same.</source>
        <extracomment>threads and context of the library&apos;s functions</extracomment>
        <translation>Der Körper hat keinen Hohlraum, nichts ist darin eingeschlossen. Um ihn trotzdem zu bohren, bitte Stellen angeben.</translation>
    </message>
    <message>
        <source>A cavity of {volume} mL got {some} of {all} holes.</source>
        <translation>Ein Hohlraum von {volume} mL bekam {some} von {all} Löchern.</translation>
    </message>
    <message>
        <source>no hole could be drilled lower down</source>
        <translation>weiter unten ließ sich kein Loch bohren</translation>
    </message>
    <message>
        <source>place a hole lower down</source>
        <translation>bitte weiter unten ein Loch setzen</translation>
    </message>
    <message>
        <source>{depth} mm of resin, about {volume} mL, stay below the lowest hole of a cavity of {all} mL: {advice}.</source>
        <translation>{depth} mm Harz, etwa {volume} mL, bleiben unter dem tiefsten Loch eines Hohlraums von {all} mL: {advice}.</translation>
    </message>
    <message>
        <source>There is no room for a hole: choose a smaller diameter or fewer holes.</source>
        <translation>Für ein Loch ist kein Platz: bitte einen kleineren Durchmesser oder weniger Löcher wählen.</translation>
    </message>
    <message>
        <source>{triangles} triangles take about {needed} MiB, and the preferences allow {limit} MiB. Allow more there, or simplify the mesh.</source>
        <translation>{triangles} Dreiecke brauchen etwa {needed} MiB, die Einstellungen erlauben {limit} MiB. Bitte dort mehr erlauben oder das Netz vereinfachen.</translation>
    </message>
    <message>
        <source>in the document the first place is at {place}</source>
        <translation>im Dokument liegt die erste Stelle bei {place}</translation>
    </message>
    <message>
        <source>No surface is chosen. Set Source to a mesh object or to a shape with faces.</source>
        <translation>Keine Fläche ist gewählt. Bitte Source auf ein Netz oder eine Form mit Flächen setzen.</translation>
    </message>
    <message>
        <source>“{label}” is a link. Choose the object that it links to, “{linked}”, or a copy of that.</source>
        <translation>„{label}“ ist eine Verknüpfung. Bitte das verknüpfte Objekt „{linked}“ oder eine Kopie davon wählen.</translation>
    </message>
    <message>
        <source>“{label}” is neither a mesh nor a shape with faces. Choose one that is.</source>
        <translation>„{label}“ ist weder ein Netz noch eine Form mit Flächen. Bitte eines davon wählen.</translation>
    </message>
    <message>
        <source>“{label}” has no triangles: there is nothing to thicken. Choose another mesh.</source>
        <translation>„{label}“ hat keine Dreiecke: Es gibt nichts zu verdicken. Bitte ein anderes Netz wählen.</translation>
    </message>
    <message>
        <source>A Part solid of {faces} faces takes about {seconds} s to make, and a check or a cut of it {later} s. A mesh is enough for printing; choose a coarser quality, or merge coplanar facets, if a solid is needed.</source>
        <extracomment>a result: the path of its value in the report (docs/report.md)</extracomment>
        <translation>Ein Part-Festkörper aus {faces} Flächen braucht etwa {seconds} s, eine Prüfung oder ein Schnitt damit {later} s. Zum Drucken genügt ein Netz; sonst bitte eine gröbere Güte wählen oder ebene Nachbarn vereinigen.</translation>
    </message>
    <message>
        <source>OK makes this solid at once.</source>
        <translation>OK macht diesen Körper sofort.</translation>
    </message>
    <message>
        <source>“{label}”</source>
        <translation>„{label}“</translation>
    </message>
    <message>
        <source>“{label}” is a link that scales. Make a copy of “{linked}” in that size instead.</source>
        <translation>„{label}“ ist eine Verknüpfung mit Skalierung. Bitte stattdessen eine Kopie von „{linked}“ in dieser Größe machen.</translation>
    </message>
    <message>
        <source>Triangles removed of a sheet that lay on a larger one</source>
        <translation>Entfernte Dreiecke einer Fläche, die auf einer größeren lag</translation>
    </message>
    <message>
        <source>Triangles removed of small parts that came off</source>
        <translation>Entfernte Dreiecke kleiner Teile, die sich gelöst haben</translation>
    </message>
    <message>
        <source>Triangles removed to give a border straight runs</source>
        <translation>Entfernte Dreiecke, damit ein Rand gerade verläuft</translation>
    </message>
    <message>
        <source>Triangles added in strips across gaps</source>
        <translation>Hinzugefügte Dreiecke in Streifen über Spalte</translation>
    </message>
    <message>
        <source>Triangles added in holes</source>
        <translation>Hinzugefügte Dreiecke in Löchern</translation>
    </message>
    <message>
        <source>Corners near another rim that could not be joined</source>
        <translation>Ecken nahe einem anderen Rand, die nicht verbunden werden konnten</translation>
    </message>
    <message>
        <source>Holes that no patch fits into</source>
        <translation>Löcher, in die kein Flicken passt</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>added</source>
        <translation>hinzugefügt</translation>
    </message>
    <message>
        <source>joined</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>left</source>
        <translation>belassen</translation>
    </message>
    <message>
        <source>The farthest that rims may be apart to be joined</source>
        <translation>So weit dürfen Ränder höchstens auseinander liegen, um verbunden zu werden</translation>
    </message>
    <message>
        <source>The widest gap between rims to be closed by a strip of triangles; 0: none</source>
        <translation>Der breiteste Spalt zwischen Rändern, den ein Streifen aus Dreiecken schließt; 0: keiner</translation>
    </message>
    <message>
        <source>Rims that are shorter than this are closed by a patch; 0: none</source>
        <translation>Kürzere Ränder werden mit einem Flicken geschlossen; 0: keine</translation>
    </message>
    <message>
        <source>Join rims within</source>
        <translation>Ränder verbinden bis</translation>
    </message>
    <message>
        <source>Bridge gaps up to</source>
        <translation>Spalte überbrücken bis</translation>
    </message>
    <message>
        <source>Fill holes with a rim below</source>
        <translation>Löcher füllen mit Rand unter</translation>
    </message>
    <message>
        <source>Thicken cannot compute yet: its compiled part for {system} and Python {python} is missing ({file}). Install the add-on archive for this system, or put the file into the folder.</source>
        <translation>Thicken kann noch nicht rechnen: Der kompilierte Teil für {system} und Python {python} fehlt ({file}). Installieren Sie das Archiv der Erweiterung für dieses System, oder legen Sie die Datei in den Ordner.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Intersection</source>
        <translation>Verschneidung</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Outside of convex edges: sharp, as planes that meet, or rounded, which takes many more triangles</source>
        <translation>Außen an konvexen Kanten: scharf, als Ebenen, die sich treffen, oder gerundet, was viel mehr Dreiecke braucht</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Trim Surface</source>
        <translation>Fläche zuschneiden</translation>
    </message>
    <message>
        <source>Where new triangles are merged into fewer, as far as the quality allows</source>
        <translation>Wo neue Dreiecke zu weniger zusammengefasst werden, soweit die Qualität es erlaubt</translation>
    </message>
    <message>
        <source>Fewer triangles</source>
        <translation>Weniger Dreiecke</translation>
    </message>
    <message>
        <source>How closely parts of the shell that have to be rebuilt follow the thickness; a moved copy of the surface is the same in all</source>
        <translation>Wie genau Teile der Schale, die neu gebildet werden müssen, der Dicke folgen; eine versetzte Kopie der Fläche ist in allen gleich</translation>
    </message>
    <message>
        <source>Negative (behind)</source>
        <translation>Negativ (dahinter)</translation>
    </message>
    <message>
        <source>Positive (in front)</source>
        <translation>Positiv (davor)</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Beide Seiten</translation>
    </message>
    <message>
        <source>Where the material lies; normals point to the front. A click on the arrow in the view flips it</source>
        <translation>Wo das Material liegt; die Normalen zeigen nach vorn. Ein Klick auf den Pfeil in der Ansicht dreht es um</translation>
    </message>
    <message>
        <source>Shell and walls</source>
        <translation>Schale, Wände</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Shell only</source>
        <translation>Nur Schale</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>A loop has three points at least. Click on the surface.</source>
        <translation>Eine Schleife hat mindestens drei Punkte. Klicken Sie auf die Fläche.</translation>
    </message>
    <message>
        <source>The loop is closed</source>
        <translation>Die Schleife ist geschlossen</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Keep the part inside</source>
        <translation>Den inneren Teil behalten</translation>
    </message>
    <message>
        <source>Rounds of smoothing</source>
        <translation>Glättungsrunden</translation>
    </message>
    <message>
        <source>Click on the surface to set points, and on the first one to close the loop. Points can be dragged; a new one comes after the one that is chosen.</source>
        <translation>Klicken Sie auf die Fläche, um Punkte zu setzen, und auf den ersten, um die Schleife zu schließen. Punkte lassen sich ziehen; ein neuer kommt nach dem gewählten.</translation>
    </message>
    <message>
        <source>The part inside of the loop stays. Click on the surface to keep that part.</source>
        <translation>Der Teil innerhalb der Schleife bleibt. Klicken Sie auf die Fläche, um den Teil dort zu behalten.</translation>
    </message>
    <message>
        <source>The part that was clicked on stays.</source>
        <translation>Der angeklickte Teil bleibt.</translation>
    </message>
    <message>
        <source>The solid begins so far from the surface, and not at it; where there is no room it has a hole</source>
        <translation>Der Körper beginnt so weit von der Fläche entfernt und nicht an ihr; wo kein Platz ist, hat er ein Loch</translation>
    </message>
    <message>
        <source>Only {share} of thickness region {number} ({thickness} mm) is on the surface, which has changed.</source>
        <extracomment>of the area that was painted</extracomment>
        <translation>Nur {share} des Dickenbereichs {number} ({thickness} mm) liegt auf der Fläche, die sich geändert hat.</translation>
    </message>
    <message>
        <source>Thickness Regions</source>
        <extracomment>the thickness at each vertex, once it is there</extracomment>
        <translation>Dickenbereiche</translation>
    </message>
    <message>
        <source>“{label}”: {thickness} mm elsewhere</source>
        <translation>„{label}“: sonst {thickness} mm</translation>
    </message>
    <message>
        <source>New region</source>
        <translation>Neuer Bereich</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>The thickness changes linearly over this distance along the surface around the regions</source>
        <translation>Um die Bereiche ändert sich die Dicke auf dieser Strecke entlang der Fläche linear</translation>
    </message>
    <message>
        <source>{number}: {thickness} mm on {area} mm²</source>
        <translation>{number}: {thickness} mm auf {area} mm²</translation>
    </message>
    <message>
        <source>Drag over the surface to paint the region; with Shift to take away from it.</source>
        <translation>Über die Fläche ziehen, um den Bereich zu malen; mit Umschalt, um davon wegzunehmen.</translation>
    </message>
    <message>
        <source>Paint the region again, or remove it.</source>
        <extracomment>mm</extracomment>
        <translation>Bitte den Bereich neu malen oder entfernen.</translation>
    </message>
    <message>
        <source>Rim thickness</source>
        <translation>Dicke am Rand</translation>
    </message>
    <message>
        <source>Rim width</source>
        <translation>Breite des Rands</translation>
    </message>
    <message>
        <source>Rim radius</source>
        <translation>Radius am Rand</translation>
    </message>
    <message>
        <source>How thick the solid is at the rim of the surface; 0: as elsewhere</source>
        <translation>Wie dick der Körper am Rand der Fläche ist; 0: wie sonst</translation>
    </message>
    <message>
        <source>How far from the rim the solid is as thick as elsewhere; together with the rim thickness</source>
        <translation>In welchem Abstand vom Rand der Körper so dick wie sonst ist; zusammen mit der Dicke am Rand</translation>
    </message>
    <message>
        <source>The radius of the edge between shell and wall; 0: sharp. It is as fine as the triangles at the rim</source>
        <translation>Radius der Kante zwischen Schale und Wand; 0: scharf. Sie wird so fein wie die Dreiecke am Rand</translation>
    </message>
    <message>
        <source>The surface has changed since the panel was opened. Open it again.</source>
        <translation>Die Fläche hat sich geändert, seit die Aufgabe geöffnet wurde. Bitte neu öffnen.</translation>
    </message>
</context>
<context>
    <name>ThickenPreferences</name>
    <message>
        <source>Thicken</source>
        <translation>Verdicken</translation>
    </message>
    <message>
        <source>New thickenings</source>
        <translation>Neue Verdickungen</translation>
    </message>
    <message>
        <source>Thickness, share of the diagonal</source>
        <translation>Dicke als Anteil der Diagonale</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Negative: behind the surface</source>
        <translation>Negativ: hinter der Fläche</translation>
    </message>
    <message>
        <source>Positive: where the normals point</source>
        <translation>Positiv: wohin die Normalen zeigen</translation>
    </message>
    <message>
        <source>Both: the surface is the middle</source>
        <translation>Beide: Die Fläche ist die Mitte</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Part solid</source>
        <translation>Part-Festkörper</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>While the inputs are edited</source>
        <translation>Während die Eingaben geändert werden</translation>
    </message>
    <message>
        <source>Largest surface to preview</source>
        <translation>Größte Fläche mit Vorschau</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Thinnest wall that prints</source>
        <translation>Dünnste druckbare Wand</translation>
    </message>
    <message>
        <source>Diameter of drain holes</source>
        <translation>Durchmesser von Ablauflöchern</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Original surface</source>
        <translation>Ursprüngliche Fläche</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Defects</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>Dieser Rechner</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Memory limit in MiB</source>
        <translation>Speichergrenze in MiB</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
</context>
<context>
    <name>Thicken_Check</name>
    <message>
        <source>Check Surface</source>
        <translation>Fläche prüfen</translation>
    </message>
    <message>
        <source>Find and mark everything that keeps a surface from being thickened</source>
        <translation>Alles finden und markieren, was dem Verdicken einer Fläche im Weg steht</translation>
    </message>
    <message>
        <source>Select a mesh or a shape. All defects are listed and marked in the view; a click on one goes there.</source>
        <translation>Ein Netz oder eine Form auswählen. Alle Fehler werden aufgelistet und in der Ansicht markiert; ein Klick auf einen führt dorthin.</translation>
    </message>
</context>
<context>
    <name>Thicken_Drain</name>
    <message>
        <source>Let resin out of the cavities of a solid</source>
        <translation>Harz aus den Hohlräumen eines Körpers ablaufen lassen</translation>
    </message>
    <message>
        <source>Select a solid. Holes are placed at the lowest points of each cavity for a print direction, or where you click.</source>
        <translation>Einen Körper auswählen. Löcher kommen an die tiefsten Stellen jedes Hohlraums bezüglich der Druckrichtung oder an angeklickte Stellen.</translation>
    </message>
    <message>
        <source>Drain Holes...</source>
        <translation>Ablauflöcher...</translation>
    </message>
</context>
<context>
    <name>Thicken_Export</name>
    <message>
        <source>Write a solid as STL or 3MF, read it again and judge it</source>
        <translation>Einen Körper als STL oder 3MF schreiben, wieder lesen und beurteilen</translation>
    </message>
    <message>
        <source>Select a solid. The file is written whole or not at all, in millimetres, and what is in it is proved valid.</source>
        <translation>Einen Körper auswählen. Die Datei wird ganz oder gar nicht geschrieben, in Millimetern, und ihr Inhalt ist als gültig bewiesen.</translation>
    </message>
    <message>
        <source>Export for Printing...</source>
        <translation>Zum Drucken exportieren...</translation>
    </message>
</context>
<context>
    <name>Thicken_Make</name>
    <message>
        <source>Turn the selected open surfaces into printable solids</source>
        <translation>Ausgewählte offene Flächen zu druckbaren Körpern machen</translation>
    </message>
    <message>
        <source>Select meshes, shapes or faces. A panel asks for the thickness and the side and previews the solid, which keeps every triangle of the surface and follows it afterwards.</source>
        <translation>Netze, Formen oder Flächen auswählen. Eine Aufgabe fragt nach Dicke und Seite und zeigt den Körper in der Vorschau; er behält jedes Dreieck der Fläche und folgt ihr danach.</translation>
    </message>
    <message>
        <source>Thicken...</source>
        <extracomment>the module here and its class</extracomment>
        <translation>Verdicken...</translation>
    </message>
</context>
<context>
    <name>Thicken_Map</name>
    <message>
        <source>Thickness Map</source>
        <translation>Dickenkarte</translation>
    </message>
    <message>
        <source>Colour a solid by the thickness of its wall or by its deviation</source>
        <translation>Einen Körper nach Wanddicke oder Abweichung färben</translation>
    </message>
    <message>
        <source>Select a thickened or drained solid. A panel shows the scale, the least and the largest value and a histogram.</source>
        <translation>Einen verdickten oder gelochten Körper auswählen. Eine Aufgabe zeigt die Skala, den kleinsten und größten Wert und ein Histogramm.</translation>
    </message>
</context>
<context>
    <name>Thicken_Regions</name>
    <message>
        <source>Thickness Regions...</source>
        <translation>Dickenbereiche...</translation>
    </message>
    <message>
        <source>Paint where a thickened solid is thicker or thinner</source>
        <translation>Malen, wo ein verdickter Körper dicker oder dünner ist</translation>
    </message>
    <message>
        <source>Select a thickened solid. A brush paints regions on its surface that have a thickness of their own; around them it changes gradually.</source>
        <translation>Einen verdickten Körper auswählen. Ein Pinsel malt auf seine Fläche Bereiche mit eigener Dicke; um sie herum ändert sie sich allmählich.</translation>
    </message>
</context>
<context>
    <name>Thicken_Repair</name>
    <message>
        <source>Repair Surface</source>
        <translation>Fläche reparieren</translation>
    </message>
    <message>
        <source>Make a mended copy of the selected surfaces, and list every change</source>
        <translation>Eine reparierte Kopie der ausgewählten Flächen erzeugen und jede Änderung auflisten</translation>
    </message>
    <message>
        <source>Select a mesh or a shape. The new object follows it without its defects; its properties list what was changed.</source>
        <translation>Ein Netz oder eine Form auswählen. Das neue Objekt folgt ihr ohne ihre Fehler; seine Eigenschaften nennen, was geändert wurde.</translation>
    </message>
</context>
<context>
    <name>Thicken_Report</name>
    <message>
        <source>Volume, thinnest wall, trapped resin and overhangs of a solid</source>
        <translation>Volumen, dünnste Wand, eingeschlossenes Harz und Überhänge eines Körpers</translation>
    </message>
    <message>
        <source>Select a solid. The facts are shown, and can be saved as a page with pictures or as JSON.</source>
        <translation>Einen Körper auswählen. Die Angaben werden gezeigt und können als Seite mit Bildern oder als JSON gespeichert werden.</translation>
    </message>
    <message>
        <source>Printability Report...</source>
        <translation>Druckbarkeitsbericht...</translation>
    </message>
</context>
<context>
    <name>Thicken_Solid</name>
    <message>
        <source>Part Solid</source>
        <translation>Part-Festkörper</translation>
    </message>
    <message>
        <source>Make a solid of Part from a closed mesh; it follows the mesh</source>
        <translation>Aus einem geschlossenen Netz einen Festkörper von Part machen; er folgt dem Netz</translation>
    </message>
    <message>
        <source>Select thickened or drained solids, or other closed meshes. Each gets a solid with a planar face for each triangle.</source>
        <translation>Verdickte oder gelochte Körper oder andere geschlossene Netze auswählen. Jedes bekommt einen Festkörper mit einer ebenen Fläche je Dreieck.</translation>
    </message>
</context>
<context>
    <name>Thicken_Stop</name>
    <message>
        <source>Stop Computing</source>
        <translation>Rechnung anhalten</translation>
    </message>
    <message>
        <source>Stop whatever Thicken computes at the moment</source>
        <translation>Anhalten, was Thicken gerade rechnet</translation>
    </message>
    <message>
        <source>A feature that was being recomputed is without a solid until the next recompute.</source>
        <translation>Ein Objekt, das neu berechnet wurde, ist bis zur nächsten Neuberechnung ohne Körper.</translation>
    </message>
</context>
<context>
    <name>Thicken_Trim</name>
    <message>
        <source>Trim Surface</source>
        <translation>Fläche zuschneiden</translation>
    </message>
    <message>
        <source>Cut a part out of a surface, along a loop that is clicked or closed wires</source>
        <translation>Einen Teil aus einer Fläche schneiden, entlang einer angeklickten Schleife oder geschlossener Drähte</translation>
    </message>
    <message>
        <source>Select a mesh or a shape, and click points of a loop on it. Or select sketches or wires near it, too. The new object follows them; its rim is where the loop is on the surface.</source>
        <translation>Wählen Sie ein Netz oder eine Form und klicken Sie Punkte einer Schleife darauf an. Oder wählen Sie auch Skizzen oder Drähte nahe daran. Das neue Objekt folgt ihnen; sein Rand liegt, wo die Schleife auf der Fläche liegt.</translation>
    </message>
</context>
</TS>
