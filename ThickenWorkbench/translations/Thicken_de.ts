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
        <source>at ({x}, {y}, {z})</source>
        <translation>bei ({x}, {y}, {z})</translation>
    </message>
    <message>
        <source>The direction in which the part grows while it is printed</source>
        <translation>Die Richtung, in der das Teil beim Drucken wächst</translation>
    </message>
    <message>
        <source>Drain holes</source>
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
        <source>For printing (*.stl *.3mf)</source>
        <translation>Zum Drucken (*.stl *.3mf)</translation>
    </message>
    <message>
        <source>The longer a bar, the more of the area has this value (square roots)</source>
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
        <source>{volume} mL, thinnest wall {wall} mm</source>
        <translation>{volume} ml, dünnste Wand {wall} mm</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <extracomment>degrees: what a patch ends at</extracomment>
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
        <extracomment>of the inputs that are shown; None while it is computed</extracomment>
        <translation>Druckbarkeitsbericht</translation>
    </message>
    <message>
        <source>Thinnest wall that prints</source>
        <translation>Dünnste druckbare Wand</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Page with pictures (*.html);;Data (*.json)</source>
        <translation>Seite mit Bildern (*.html);;Daten (*.json)</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>Bereit zum Drucken</translation>
    </message>
    <message>
        <source>Heed before printing</source>
        <translation>Vor dem Drucken zu beachten</translation>
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
        <source>Where the material lies; a click on the arrow in the view flips it</source>
        <translation>Wo das Material liegt; ein Klick auf den Pfeil in der Ansicht wechselt die Seite</translation>
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
        <source>Sweep</source>
        <translation>Sweep</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
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
        <source>Tolerance</source>
        <translation>Toleranz</translation>
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
        <translation>Eine fehlerhafte Fläche zuerst reparieren</translation>
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
        <translation>Das Dokument hat keine 3D-Ansicht. Bitte eine öffnen: Ansicht ▸ Neue Ansicht.</translation>
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
        <source>Drain Holes …</source>
        <translation>Ablauflöcher …</translation>
    </message>
    <message>
        <source>Let resin out of the cavities of a solid</source>
        <translation>Harz aus den Hohlräumen eines Körpers ablaufen lassen</translation>
    </message>
    <message>
        <source>Select a solid. Holes are placed at the lowest points of each cavity for a print direction, or where you click.</source>
        <translation>Einen Körper auswählen. Löcher kommen an die tiefsten Stellen jedes Hohlraums bezüglich der Druckrichtung oder an angeklickte Stellen.</translation>
    </message>
</context>
<context>
    <name>Thicken_Export</name>
    <message>
        <source>Export for Printing …</source>
        <translation>Zum Drucken exportieren …</translation>
    </message>
    <message>
        <source>Write a solid as STL or 3MF, read it again and judge it</source>
        <translation>Einen Körper als STL oder 3MF schreiben, wieder lesen und beurteilen</translation>
    </message>
    <message>
        <source>Select a solid. The file is written whole or not at all, in millimetres, and what is in it is proved valid.</source>
        <translation>Einen Körper auswählen. Die Datei wird ganz oder gar nicht geschrieben, in Millimetern, und ihr Inhalt ist als gültig bewiesen.</translation>
    </message>
</context>
<context>
    <name>Thicken_Make</name>
    <message>
        <source>Thicken …</source>
        <extracomment>of a mesh: indices</extracomment>
        <translation>Verdicken …</translation>
    </message>
    <message>
        <source>Turn the selected open surfaces into printable solids</source>
        <translation>Ausgewählte offene Flächen zu druckbaren Körpern machen</translation>
    </message>
    <message>
        <source>Select meshes, shapes or faces. A panel asks for the thickness and the side and previews the solid, which keeps every triangle of the surface and follows it afterwards.</source>
        <translation>Netze, Formen oder Flächen auswählen. Eine Aufgabe fragt nach Dicke und Seite und zeigt den Körper in der Vorschau; er behält jedes Dreieck der Fläche und folgt ihr danach.</translation>
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
        <source>Printability Report …</source>
        <translation>Druckbarkeitsbericht …</translation>
    </message>
    <message>
        <source>Volume, thinnest wall, trapped resin and overhangs of a solid</source>
        <translation>Volumen, dünnste Wand, eingeschlossenes Harz und Überhänge eines Körpers</translation>
    </message>
    <message>
        <source>Select a solid. The facts are shown, and can be saved as a page with pictures or as JSON.</source>
        <translation>Einen Körper auswählen. Die Angaben werden gezeigt und können als Seite mit Bildern oder als JSON gespeichert werden.</translation>
    </message>
</context>
</TS>
