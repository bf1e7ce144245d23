<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sv" sourcelanguage="en">
<context>
    <name>CaseReport</name>
    <message>
        <source>Case report</source>
        <translation>Fallrapport</translation>
    </message>
    <message>
        <source>Case report: %1</source>
        <translation>Fallrapport: %1</translation>
    </message>
    <message>
        <source>Planned: kept fragments: %1, of them moved: %2; resected: %3; cuts: %4; guides: %5; plates: %6; implants: %7; transplants: %8.</source>
        <translation>Planerat: behållna fragment: %1, av dem flyttade: %2; resekerade: %3; snitt: %4; sågmallar: %5; plattor: %6; implantat: %7; transplantat: %8.</translation>
    </message>
    <message>
        <source>Plan, SHA-256: %1</source>
        <translation>Plan, SHA-256: %1</translation>
    </message>
    <message>
        <source>Date: %1</source>
        <translation>Datum: %1</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>what</source>
        <translation>vad</translation>
    </message>
    <message>
        <source>version</source>
        <translation>version</translation>
    </message>
    <message>
        <source>%1, commit %2</source>
        <translation>%1, incheckning %2</translation>
    </message>
    <message>
        <source>none: no pictures are drawn</source>
        <translation>inget: inga bilder ritas</translation>
    </message>
    <message>
        <source>There are no pictures: OpenGL 3.2 or later is needed.</source>
        <translation>Det finns inga bilder: OpenGL 3.2 eller senare behövs.</translation>
    </message>
    <message>
        <source>The report is not written: %1. Choose a folder that can be written, or make room on its disk.</source>
        <translation>Rapporten är inte skriven: %1. Välj en mapp som går att skriva i, eller frigör utrymme på dess disk.</translation>
    </message>
    <message>
        <source>The report is written, as a page and as a PDF beside it.</source>
        <translation>Rapporten är skriven, som en sida och som en PDF bredvid den.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Research use only, not a medical device. Not for clinical use.</source>
        <translation>Endast för forskning, inte en medicinteknisk produkt. Inte för kliniskt bruk.</translation>
    </message>
    <message>
        <source>not certified</source>
        <translation>inte certifierad</translation>
    </message>
    <message>
        <source>what was measured on it cannot be read: make it again</source>
        <translation>det som mättes på den går inte att läsa: skapa den på nytt</translation>
    </message>
    <message>
        <source>Certificate of %1</source>
        <translation>Certifikat för %1</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>mått</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>uppmätt</translation>
    </message>
    <message>
        <source>must be</source>
        <translation>ska vara</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>omdöme</translation>
    </message>
    <message>
        <source>DOES NOT HOLD</source>
        <translation>UPPFYLLS INTE</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>inte uppmätt</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>uppfylls</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Delar</translation>
    </message>
    <message>
        <source>A part is its file: by the SHA-256 of that it is known again.</source>
        <translation>En del är sin fil: den känns igen på filens SHA-256.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>del</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fil</translation>
    </message>
    <message>
        <source>volume, mm³</source>
        <translation>volym, mm³</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>sida %1 av %2</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>framifrån</translation>
    </message>
    <message>
        <source>from the patient&apos;s left</source>
        <translation>från patientens vänstra sida</translation>
    </message>
    <message>
        <source>from the patient&apos;s right</source>
        <translation>från patientens högra sida</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>ovanifrån</translation>
    </message>
    <message>
        <source>Cuts and guides on the bone as it was scanned, %1.</source>
        <translation>Snitt och sågmallar på benet som det skannades, %1.</translation>
    </message>
    <message>
        <source>As planned, %1.</source>
        <translation>Som planerat, %1.</translation>
    </message>
    <message>
        <source>%1, the donor&apos;s</source>
        <translation>%1, donatorns</translation>
    </message>
    <message>
        <source>not moved</source>
        <translation>inte flyttat</translation>
    </message>
    <message>
        <source>not turned</source>
        <translation>inte vridet</translation>
    </message>
    <message>
        <source>%1° about %2</source>
        <translation>%1° kring %2</translation>
    </message>
    <message>
        <source>label %1 of %2</source>
        <translation>etikett %1 i %2</translation>
    </message>
    <message>
        <source>a piece of %1</source>
        <translation>en bit av %1</translation>
    </message>
    <message>
        <source>bone of %1</source>
        <translation>ben i %1</translation>
    </message>
    <message>
        <source>resected</source>
        <translation>resekerat</translation>
    </message>
    <message>
        <source>cut into pieces</source>
        <translation>delat i bitar</translation>
    </message>
    <message>
        <source>kept, locked: the reference</source>
        <translation>behållet, låst: referensen</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behållet</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>Fragment</translation>
    </message>
    <message>
        <source>Motion from the scan to the plan. A fragment is moved as the middle of its box is, or the place that it was picked at; L, R, A, P, S and I are the patient&apos;s left, right, front, back, top and bottom. It is turned about that place, by the right-hand rule; axes are patient LPS.</source>
        <translation>Rörelse från skanningen till planen. Ett fragment flyttas så som mitten av dess ram flyttas, eller det ställe där det plockades; L, R, A, P, S och I är patientens vänster, höger, fram, bak, upp och ned. Det vrids kring det stället, enligt högerhandsregeln; axlarna är patientens LPS.</translation>
    </message>
    <message>
        <source>fragment</source>
        <translation>fragment</translation>
    </message>
    <message>
        <source>of</source>
        <translation>av</translation>
    </message>
    <message>
        <source>state</source>
        <translation>status</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>flyttat</translation>
    </message>
    <message>
        <source>turned</source>
        <translation>vridet</translation>
    </message>
    <message>
        <source>moved; its scan is not there to tell by how much</source>
        <translation>flyttat; dess skanning saknas, så det går inte att säga hur mycket</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupper</translation>
    </message>
    <message>
        <source>Fragments that are moved as one.</source>
        <translation>Fragment som flyttas som ett.</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupp</translation>
    </message>
    <message>
        <source>fragments</source>
        <translation>fragment</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>Where the bone lies in the scan; places are patient LPS, mm. Angles are those between the blade&apos;s plane and the axial, coronal and sagittal planes.</source>
        <translation>Där benet ligger i skanningen; lägen i patientens LPS, mm. Vinklarna är de mellan sågbladets plan och axial-, koronal- och sagittalplanen.</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>snitt</translation>
    </message>
    <message>
        <source>through</source>
        <translation>genom</translation>
    </message>
    <message>
        <source>middle of the blade</source>
        <translation>sågbladets mitt</translation>
    </message>
    <message>
        <source>axial</source>
        <translation>axial</translation>
    </message>
    <message>
        <source>coronal</source>
        <translation>koronal</translation>
    </message>
    <message>
        <source>sagittal</source>
        <translation>sagittal</translation>
    </message>
    <message>
        <source>blade, mm</source>
        <translation>sågblad, mm</translation>
    </message>
    <message>
        <source>kerf, mm</source>
        <translation>sågspalt, mm</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Mått</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>planerat</translation>
    </message>
    <message>
        <source>in the scan</source>
        <translation>i skanningen</translation>
    </message>
    <message>
        <source>change</source>
        <translation>ändring</translation>
    </message>
    <message>
        <source>Scans and surfaces</source>
        <translation>Skanningar och ytor</translation>
    </message>
    <message>
        <source>By the SHA-256 of what they hold: it is the same wherever a file lies and whatever it is called.</source>
        <translation>Med SHA-256 av det de innehåller: den är densamma var en fil än ligger och vad den än heter.</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objekt</translation>
    </message>
    <message>
        <source>Pictures lack a fragment: %1.</source>
        <translation>Ett fragment saknas på bilderna: %1.</translation>
    </message>
    <message>
        <source>Pictures lack %1: it cannot be shown. Open its scan if that is missing; else it is no piece of its own: move its cuts. Then write the report again.</source>
        <translation>%1 saknas på bilderna: det går inte att visa. Öppna dess skanning om den saknas; annars är det ingen egen bit: flytta dess snitt. Skriv sedan rapporten på nytt.</translation>
    </message>
    <message>
        <source>Pictures lack %1: it is being made. Write the report again when it is shown.</source>
        <translation>%1 saknas på bilderna: det håller på att skapas. Skriv rapporten på nytt när det visas.</translation>
    </message>
    <message>
        <source>Pictures lack %1: it is hidden. Show it, and write the report again.</source>
        <translation>%1 saknas på bilderna: det är dolt. Visa det, och skriv rapporten på nytt.</translation>
    </message>
    <message>
        <source>Pictures lack %1: %2; make it again.</source>
        <translation>%1 saknas på bilderna: %2; skapa det på nytt.</translation>
    </message>
</context>
<context>
    <name>FileQuestion</name>
    <message>
        <source>Replace the file?</source>
        <translation>Ersätt filen?</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 finns redan.</translation>
    </message>
    <message>
        <source>&amp;Replace it</source>
        <translation>&amp;Ersätt den</translation>
    </message>
    <message>
        <source>&amp;Another name</source>
        <translation>&amp;Annat namn</translation>
    </message>
</context>
<context>
    <name>Orientation</name>
    <message>
        <source>R</source>
        <comment>right side</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left side</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>A</source>
        <comment>anterior</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>P</source>
        <comment>posterior</comment>
        <translation>P</translation>
    </message>
    <message>
        <source>I</source>
        <comment>inferior</comment>
        <translation>I</translation>
    </message>
    <message>
        <source>S</source>
        <comment>superior</comment>
        <translation>S</translation>
    </message>
</context>
<context>
    <name>PartExport</name>
    <message>
        <source>Nothing is written: %1</source>
        <translation>Inget är skrivet: %1</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Skriver %1</translation>
    </message>
    <message>
        <source>%1 is written, read back, and the same.</source>
        <translation>%1 är skriven, läst tillbaka och oförändrad.</translation>
    </message>
    <message>
        <source>nothing is made of this plan yet</source>
        <translation>inget är skapat av den här planen ännu</translation>
    </message>
    <message>
        <source>Writing all parts</source>
        <translation>Skriver alla delar</translation>
    </message>
    <message>
        <source>Parts written: %1.</source>
        <translation>Skrivna delar: %1.</translation>
    </message>
</context>
<context>
    <name>PartFacts</name>
    <message>
        <source>%1 does not hold</source>
        <translation>%1 uppfyller inte kraven</translation>
    </message>
    <message>
        <source>%1 must be made again: %2</source>
        <translation>%1 måste skapas på nytt: %2</translation>
    </message>
    <message>
        <source>%1 does not hold: %2</source>
        <translation>%1 uppfyller inte kraven: %2</translation>
    </message>
    <message>
        <source>%1 was kept without what was measured on it: make it again</source>
        <translation>%1 sparades utan det som mättes på den: skapa den på nytt</translation>
    </message>
    <message>
        <source>%1 is exported as it is: nothing is claimed of its fit, so that there is nothing to certify.</source>
        <translation>%1 exporteras som den är: inget utlovas om dess passform, så det finns inget att certifiera.</translation>
    </message>
    <message>
        <source>%1 is not certified: it lies on fragments where the plan puts them, so that its gap to scanned bone cannot be measured, and it has no screw whose bore could be. Touch screws in the step Plate and make it again.</source>
        <translation>%1 är inte certifierad: den ligger på fragment där planen lägger dem, så avståndet till skannat ben kan inte mätas, och den har ingen skruv vars borrhål kan mätas. Peka ut skruvar i steget Platta och skapa den på nytt.</translation>
    </message>
</context>
<context>
    <name>PartMaking</name>
    <message>
        <source>%1 does not hold and is not kept: change what it is made of, and make it again. The step Check shows where.
%2</source>
        <translation>%1 uppfyller inte kraven och behålls inte: ändra det som den skapas av, och skapa den på nytt. Steget Kontroll visar var.
%2</translation>
    </message>
    <message>
        <source>%1 is made: %2.</source>
        <translation>%1 är skapad: %2.</translation>
    </message>
    <message>
        <source>Making %1</source>
        <translation>Skapar %1</translation>
    </message>
    <message>
        <source>%1: no part is made of it.</source>
        <translation>%1: ingen del skapas av det.</translation>
    </message>
    <message>
        <source>Nothing is made of this plan yet: add a fragment, a guide, a plate or an implant first.</source>
        <translation>Inget skapas av den här planen ännu: lägg först till ett fragment, en sågmall, en platta eller ett implantat.</translation>
    </message>
    <message>
        <source>All parts are in date.</source>
        <translation>Alla delar är aktuella.</translation>
    </message>
    <message>
        <source>Parts that do not hold: %1. Change what they are made of first.</source>
        <translation>Delar som inte uppfyller kraven: %1. Ändra först det som de skapas av.</translation>
    </message>
</context>
<context>
    <name>PartWork</name>
    <message>
        <source>%1 cannot be made: its scan, %2, is not in memory. Give the scan that the plan was made on, at the step Import.</source>
        <translation>%1 kan inte skapas: dess skanning, %2, finns inte i minnet. Ange den skanning som planen gjordes på, i steget Import.</translation>
    </message>
</context>
<context>
    <name>PlanScene</name>
    <message>
        <source>Showing fragments</source>
        <translation>Visar fragment</translation>
    </message>
    <message>
        <source>Mirroring bone</source>
        <translation>Speglar ben</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 deg</source>
        <translation>%1 grader</translation>
    </message>
    <message>
        <source>Showing parts</source>
        <translation>Visar delar</translation>
    </message>
    <message>
        <source>The brightest values cannot be shown: %1.</source>
        <translation>De ljusaste värdena kan inte visas: %1.</translation>
    </message>
</context>
<context>
    <name>QWidget</name>
    <message>
        <source>Add a %1</source>
        <translation>Lägg till %1</translation>
    </message>
    <message>
        <source>Change %1 %2</source>
        <translation>Ändra %1 %2</translation>
    </message>
</context>
<context>
    <name>Ruler</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>SceneLooks</name>
    <message>
        <source>There is no scan: import one first.</source>
        <translation>Det finns ingen skanning: importera en först.</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Hud</translation>
    </message>
    <message>
        <source>Skin begins at, HU (air is -1000)</source>
        <translation>Huden börjar vid, HU (luft är -1000)</translation>
    </message>
    <message>
        <source>Skin begins at, in the scan&apos;s values</source>
        <translation>Huden börjar vid, i skanningens värden</translation>
    </message>
    <message>
        <source>3D &amp;view</source>
        <translation>3D-&amp;vy</translation>
    </message>
    <message>
        <source>&amp;Skin over bone</source>
        <translation>&amp;Hud över benet</translation>
    </message>
    <message>
        <source>Skin be&amp;gins at …</source>
        <translation>Huden &amp;börjar vid …</translation>
    </message>
    <message>
        <source>&amp;Brightest values, without bone&apos;s surface</source>
        <translation>&amp;Ljusaste värdena, utan benets yta</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Ljus</translation>
    </message>
    <message>
        <source>&amp;Plain</source>
        <translation>&amp;Vanligt</translation>
    </message>
    <message>
        <source>&amp;Ambient occlusion: darker where surfaces are close</source>
        <translation>&amp;Omgivningsskugga: mörkare där ytor är nära</translation>
    </message>
    <message>
        <source>&amp;Traced: daylight with shadows</source>
        <translation>&amp;Strålföljt: dagsljus med skuggor</translation>
    </message>
</context>
<context>
    <name>ViewPresets</name>
    <message>
        <source>From the f&amp;ront</source>
        <translation>&amp;Framifrån</translation>
    </message>
    <message>
        <source>From be&amp;hind</source>
        <translation>&amp;Bakifrån</translation>
    </message>
    <message>
        <source>From the patient&apos;s &amp;left</source>
        <translation>Från patientens &amp;vänstra sida</translation>
    </message>
    <message>
        <source>From the patient&apos;s ri&amp;ght</source>
        <translation>Från patientens &amp;högra sida</translation>
    </message>
    <message>
        <source>From a&amp;bove</source>
        <translation>&amp;Ovanifrån</translation>
    </message>
    <message>
        <source>From b&amp;elow</source>
        <translation>&amp;Underifrån</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Ben</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Mjukdelar</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Hjärna</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Metal and teeth</source>
        <translation>Metall och tänder</translation>
    </message>
    <message>
        <source>&amp;All in sight</source>
        <translation>&amp;Allt i bild</translation>
    </message>
    <message>
        <source>&amp;Window and level</source>
        <translation>Fö&amp;nster och nivå</translation>
    </message>
    <message>
        <source>%1: %2 / %3</source>
        <translation>%1: %2 / %3</translation>
    </message>
</context>
<context>
    <name>hasp::AreaTool</name>
    <message>
        <source>Drag over painted bone to wipe it off; a drag beside bone turns the view. Escape ends.</source>
        <translation>Dra över målat ben för att sudda ut det; en dragning bredvid ben vrider vyn. Escape avslutar.</translation>
    </message>
    <message>
        <source>Drag over bone to paint it; a drag beside it turns the view. Insert dabs at the crosshair, Escape ends.</source>
        <translation>Dra över ben för att måla det; en dragning bredvid vrider vyn. Insert målar en fläck vid hårkorset, Escape avslutar.</translation>
    </message>
    <message>
        <source>There is no crosshair: show a scan first.</source>
        <translation>Det finns inget hårkors: visa först en skanning.</translation>
    </message>
</context>
<context>
    <name>hasp::BladeNudge</name>
    <message>
        <source>Shift along its normal</source>
        <translation>Flytta längs normalen</translation>
    </message>
    <message>
        <source>Shift along its width</source>
        <translation>Flytta längs bredden</translation>
    </message>
    <message>
        <source>Shift along its depth</source>
        <translation>Flytta längs djupet</translation>
    </message>
    <message>
        <source>Turn about its width</source>
        <translation>Vrid kring bredden</translation>
    </message>
    <message>
        <source>Turn about its depth</source>
        <translation>Vrid kring djupet</translation>
    </message>
    <message>
        <source>Turn in its plane</source>
        <translation>Vrid i planet</translation>
    </message>
</context>
<context>
    <name>hasp::BladeTool</name>
    <message>
        <source>Drag the blade&apos;s middle to shift it, its arrow to move it along its normal, a corner to turn it. Escape ends.</source>
        <translation>Dra i sågbladets mitt för att flytta det, i dess pil för att flytta det längs normalen, i ett hörn för att vrida det. Escape avslutar.</translation>
    </message>
    <message>
        <source>Move cut %1</source>
        <translation>Flytta snitt %1</translation>
    </message>
</context>
<context>
    <name>hasp::BonesBox</name>
    <message>
        <source>Whole pieces of bone</source>
        <translation>Hela benbitar</translation>
    </message>
    <message>
        <source>Click on the bone that shall be a fragment. Esc: back</source>
        <translation>Klicka på benet som ska bli ett fragment. Esc: tillbaka</translation>
    </message>
    <message>
        <source>Bone from here: &amp;click on it</source>
        <translation>Ben härifrån: kli&amp;cka på det</translation>
    </message>
    <message>
        <source>&amp;Whole bone at the crosshair</source>
        <translation>Hela be&amp;net vid hårkorset</translation>
    </message>
    <message>
        <source>All pieces of at leas&amp;t</source>
        <translation>Alla bitar &amp;om minst</translation>
    </message>
    <message>
        <source> mm³</source>
        <translation> mm³</translation>
    </message>
    <message>
        <source>Least volume of a piece</source>
        <translation>Minsta volym för en bit</translation>
    </message>
</context>
<context>
    <name>hasp::CertificateBox</name>
    <message>
        <source>does not hold</source>
        <translation>uppfylls inte</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>inte uppmätt</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>uppfylls</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certifikat</translation>
    </message>
    <message>
        <source>Faults of the part</source>
        <translation>Delens fel</translation>
    </message>
    <message>
        <source>Sho&amp;w the fault&apos;s place</source>
        <translation>Visa &amp;felets plats</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Vad som mättes</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mått</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Uppmätt</translation>
    </message>
    <message>
        <source>Must be</source>
        <translation>Ska vara</translation>
    </message>
    <message>
        <source>Open the certificate&apos;s &amp;page</source>
        <translation>Öppna certifikatets si&amp;da</translation>
    </message>
    <message>
        <source>Certificate of %1</source>
        <translation>Certifikat för %1</translation>
    </message>
</context>
<context>
    <name>hasp::CertificateDialog</name>
    <message>
        <source>the planner&apos;s views show the part</source>
        <translation>planerarens vyer visar delen</translation>
    </message>
    <message>
        <source>The part was not kept.</source>
        <translation>Delen behölls inte.</translation>
    </message>
    <message>
        <source> It was held to fragment %1 alone: other bone of the scan was not looked at.</source>
        <translation> Den prövades bara mot fragment %1: annat ben i skanningen granskades inte.</translation>
    </message>
    <message>
        <source>Certificate of %1</source>
        <translation>Certifikat för %1</translation>
    </message>
    <message>
        <source>&amp;Save the page…</source>
        <translation>&amp;Spara sidan…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;täng</translation>
    </message>
    <message>
        <source>Save the certificate of %1</source>
        <translation>Spara certifikatet för %1</translation>
    </message>
    <message>
        <source>certificate.html</source>
        <translation>certifikat.html</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webbsidor (*.html)</translation>
    </message>
    <message>
        <source>The certificate of %1 is saved.</source>
        <translation>Certifikatet för %1 är sparat.</translation>
    </message>
    <message>
        <source>The certificate is not saved: %1</source>
        <translation>Certifikatet är inte sparat: %1</translation>
    </message>
</context>
<context>
    <name>hasp::CheckPanel</name>
    <message>
        <source>Ma&amp;ke</source>
        <translation>&amp;Skapa</translation>
    </message>
    <message>
        <source>Make &amp;all</source>
        <translation>Skapa a&amp;lla</translation>
    </message>
    <message>
        <source>All parts that are not in date</source>
        <translation>Alla delar som inte är aktuella</translation>
    </message>
    <message>
        <source>Plan something that parts are made of first: a fragment, a guide, a plate.</source>
        <translation>Planera först något som delar skapas av: ett fragment, en sågmall, en platta.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Kontroll</translation>
    </message>
</context>
<context>
    <name>hasp::CutPanel</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nytt</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Läge</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Sågblad</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Bitar</translation>
    </message>
    <message>
        <source>Import a scan first.</source>
        <translation>Importera först en skanning.</translation>
    </message>
    <message>
        <source>Find the plan&apos;s scan first: it is not in memory.</source>
        <translation>Hitta först planens skanning: den finns inte i minnet.</translation>
    </message>
    <message>
        <source>That is a surface: only bone of scans can be cut.</source>
        <translation>Det är en yta: bara ben i skanningar kan snittas.</translation>
    </message>
    <message>
        <source>Add a cut</source>
        <translation>Lägg till snitt</translation>
    </message>
    <message>
        <source>Place cut %1</source>
        <translation>Placera snitt %1</translation>
    </message>
    <message>
        <source>Change cut %1</source>
        <translation>Ändra snitt %1</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>&amp;Bone from here</source>
        <translation>B&amp;en härifrån</translation>
    </message>
    <message>
        <source>Touch bone: all that is connected with it becomes a fragment, which can be cut.</source>
        <translation>Peka på ben: allt som hänger ihop med det blir ett fragment, som kan snittas.</translation>
    </message>
    <message>
        <source>&amp;Touch the cut</source>
        <translation>&amp;Peka ut snittet</translation>
    </message>
    <message>
        <source>Touch two places: the blade goes through them as you look. A third one turns it into the plane through all three.</source>
        <translation>Peka på två ställen: sågbladet går genom dem i din blickriktning. Ett tredje vrider det till planet genom alla tre.</translation>
    </message>
    <message>
        <source>&amp;Drag its handles</source>
        <translation>&amp;Dra i handtagen</translation>
    </message>
    <message>
        <source>No fragment yet: touch bone, and it becomes one.</source>
        <translation>Inget fragment ännu: peka på ben, så blir det ett.</translation>
    </message>
    <message>
        <source>It cuts</source>
        <translation>Det snittar</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Sågspalt</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Djup</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Räckvidd</translation>
    </message>
    <message>
        <source>Bone of the fragment that is farther from what it cuts stays whole</source>
        <translation>Ben i fragmentet som är längre bort från det som snittas förblir helt</translation>
    </message>
    <message>
        <source>Move it by numbers</source>
        <translation>Flytta det med siffror</translation>
    </message>
</context>
<context>
    <name>hasp::DevicePage</name>
    <message>
        <source>&amp;Copy the udev rules</source>
        <translation>&amp;Kopiera udev-reglerna</translation>
    </message>
    <message>
        <source>Haptic device</source>
        <translation>Haptisk enhet</translation>
    </message>
    <message>
        <source>Plugged in</source>
        <translation>Ansluten</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Använd</translation>
    </message>
    <message>
        <source>&amp;Named</source>
        <translation>Med &amp;namn</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Tillstånd</translation>
    </message>
    <message>
        <source>It says</source>
        <translation>Den säger</translation>
    </message>
    <message>
        <source>Test of the force</source>
        <translation>Prov av kraften</translation>
    </message>
    <message>
        <source>&amp;Push along each axis</source>
        <translation>&amp;Tryck längs varje axel</translation>
    </message>
    <message>
        <source>&amp;Largest force</source>
        <translation>&amp;Största kraft</translation>
    </message>
    <message>
        <source>Hold the grip, and its first button for as long as you want to feel it: right, left, up, down, towards you, away.</source>
        <translation>Håll i greppet, och i dess första knapp så länge du vill känna kraften: åt höger, vänster, upp, ner, mot dig, från dig.</translation>
    </message>
    <message>
        <source>Scale of the force</source>
        <translation>Kraftens skala</translation>
    </message>
    <message>
        <source>Hang a spring scale between grip and table, so that it is pulled when the grip moves towards you. Choose a force, hold the first button and read the scale.</source>
        <translation>Häng en fjädervåg mellan grepp och bord, så att den dras ut när greppet rör sig mot dig. Välj en kraft, håll i den första knappen och läs av vågen.</translation>
    </message>
    <message>
        <source>Push with %1 N</source>
        <translation>Tryck med %1 N</translation>
    </message>
    <message>
        <source>&amp;Keep the scale</source>
        <translation>&amp;Behåll skalan</translation>
    </message>
    <message>
        <source>What pushes, when it is plugged in</source>
        <translation>Den som trycker, när den är ansluten</translation>
    </message>
    <message>
        <source>None: the mouse</source>
        <translation>Ingen: musen</translation>
    </message>
    <message>
        <source>%1: can be used</source>
        <translation>%1: kan användas</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>What is named below</source>
        <translation>Den som anges nedan</translation>
    </message>
    <message>
        <source>No haptic device and no 6-DOF mouse</source>
        <translation>Ingen haptisk enhet och ingen 6-DOF-mus</translation>
    </message>
    <message>
        <source>no button</source>
        <translation>ingen knapp</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>knapp %1</translation>
    </message>
    <message>
        <source>No device is used: the mouse moves what is in hand.</source>
        <translation>Ingen enhet används: musen flyttar det som är i handen.</translation>
    </message>
    <message>
        <source>%1 mm right, %2 up, %3 towards you; %4; pushed with %5 N</source>
        <translation>%1 mm åt höger, %2 uppåt, %3 mot dig; %4; trycks med %5 N</translation>
    </message>
    <message>
        <source>The readings scatter by %1 N: read them again.</source>
        <translation>Avläsningarna sprider sig med %1 N: läs av dem igen.</translation>
    </message>
    <message>
        <source>%1 of what is asked for was felt, ± %2 N.</source>
        <translation>%1 av det som begärdes kändes, ± %2 N.</translation>
    </message>
    <message>
        <source>It is kept.</source>
        <translation>Det behålls.</translation>
    </message>
    <message>
        <source>It holds until the program ends.</source>
        <translation>Det gäller tills programmet avslutas.</translation>
    </message>
    <message>
        <source>%1 N was not felt yet: choose it, and hold the first button while you read the scale.</source>
        <translation>%1 N har inte känts ännu: välj den, och håll i den första knappen medan du läser av vågen.</translation>
    </message>
</context>
<context>
    <name>hasp::DistanceColours</name>
    <message>
        <source>Measuring distances</source>
        <translation>Mäter avstånd</translation>
    </message>
</context>
<context>
    <name>hasp::ExportPanel</name>
    <message>
        <source>Forma&amp;t</source>
        <translation>Forma&amp;t</translation>
    </message>
    <message>
        <source>One part</source>
        <translation>En del</translation>
    </message>
    <message>
        <source>All parts, with their recipes and run.json</source>
        <translation>Alla delar, med sina recept och run.json</translation>
    </message>
    <message>
        <source>Fol&amp;der</source>
        <translation>Ma&amp;pp</translation>
    </message>
    <message>
        <source>not there yet, or empty</source>
        <translation>finns inte ännu, eller är tom</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>Vä&amp;lj…</translation>
    </message>
    <message>
        <source>Export &amp;all</source>
        <translation>E&amp;xportera alla</translation>
    </message>
    <message>
        <source>&amp;Report of the case…</source>
        <translation>Rapport &amp;om fallet…</translation>
    </message>
    <message>
        <source>With the &amp;names of objects</source>
        <translation>Med objektens &amp;namn</translation>
    </message>
    <message>
        <source>They are your own words: make sure that they name no patient</source>
        <translation>De är dina egna ord: se till att de inte nämner någon patient</translation>
    </message>
    <message>
        <source>A folder for all parts</source>
        <translation>En mapp för alla delar</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>delar</translation>
    </message>
    <message>
        <source>Plan something that parts are made of first.</source>
        <translation>Planera först något som delar skapas av.</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>nothing is made of this plan yet</source>
        <translation>inget är skapat av den här planen ännu</translation>
    </message>
    <message>
        <source>choose a folder that is not there yet, or empty</source>
        <translation>välj en mapp som inte finns ännu, eller som är tom</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Exportera %1</translation>
    </message>
    <message>
        <source>Parts (*.%1)</source>
        <translation>Delar (*.%1)</translation>
    </message>
    <message>
        <source>Report of the case</source>
        <translation>Rapport om fallet</translation>
    </message>
    <message>
        <source>report.html</source>
        <translation>rapport.html</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webbsidor (*.html)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
</context>
<context>
    <name>hasp::FitBox</name>
    <message>
        <source>%1 touches nothing, not even %2 mm beyond its planned place.</source>
        <translation>%1 rör inte vid något, inte ens %2 mm bortom sin planerade plats.</translation>
    </message>
    <message>
        <source>%1 seats: it touches first %2 mm beyond its planned place, at (%3) mm.</source>
        <translation>%1 sitter på plats: den tar emot först %2 mm bortom sin planerade plats, vid (%3) mm.</translation>
    </message>
    <message>
        <source> The least gap of its certificate is %1 mm.</source>
        <translation> Det minsta avståndet i dess certifikat är %1 mm.</translation>
    </message>
    <message>
        <source>Test fit</source>
        <translation>Provpassning</translation>
    </message>
    <message>
        <source>&amp;Try it on</source>
        <translation>&amp;Prova</translation>
    </message>
    <message>
        <source>Move the part against its bone and feel where it touches</source>
        <translation>För delen mot dess ben och känn var den tar emot</translation>
    </message>
    <message>
        <source>&amp;Lift it off</source>
        <translation>L&amp;yft av</translation>
    </message>
    <message>
        <source>Push it &amp;on</source>
        <translation>S&amp;kjut på</translation>
    </message>
    <message>
        <source>Straight along its withdrawal, until it touches</source>
        <translation>Rakt längs dess avlyftning, tills den tar emot</translation>
    </message>
    <message>
        <source>Preparing the test fit of %1</source>
        <translation>Förbereder provpassningen av %1</translation>
    </message>
    <message>
        <source>Pushing %1 on</source>
        <translation>Skjuter på %1</translation>
    </message>
    <message>
        <source>A part must be made, and in date, before it is tried on.</source>
        <translation>En del måste vara skapad och aktuell innan den provas.</translation>
    </message>
    <message>
        <source>%1 is put on no bone: there is nothing to try.</source>
        <translation>%1 sätts inte på något ben: det finns inget att prova.</translation>
    </message>
    <message>
        <source>Lifted off, the part is moved against its bone before it is exported.</source>
        <translation>Avlyft förs delen mot sitt ben innan den exporteras.</translation>
    </message>
    <message>
        <source>Preparing what is felt: %1 %</source>
        <translation>Förbereder det som känns: %1 %</translation>
    </message>
    <message>
        <source>Touches, %1 mm off its planned place.</source>
        <translation>Tar emot, %1 mm från sin planerade plats.</translation>
    </message>
    <message>
        <source>Free, %1 mm off its planned place.</source>
        <translation>Fri, %1 mm från sin planerade plats.</translation>
    </message>
    <message>
        <source>change the way it lifts off, or its outline</source>
        <translation>ändra åt vilket håll den lyfts av, eller dess kontur</translation>
    </message>
    <message>
        <source>move its landmarks away from there, or make it narrower</source>
        <translation>flytta dess landmärken därifrån, eller gör den smalare</translation>
    </message>
    <message>
        <source>change its outline, the way it is put in, or give it more clearance</source>
        <translation>ändra dess kontur eller hur det sätts in, eller ge det mer spelrum</translation>
    </message>
    <message>
        <source>make it narrower, or shorter beyond the cuts</source>
        <translation>gör den smalare, eller kortare bortom snitten</translation>
    </message>
    <message>
        <source>%1 is blocked %2 mm before its planned place, by bone at (%3) mm: %4, and make it again.</source>
        <translation>%1 stoppas %2 mm före sin planerade plats, av ben vid (%3) mm: %4, och skapa den på nytt.</translation>
    </message>
    <message>
        <source>%1 lies on fragments where the plan puts them: it cannot be tried on scanned bone.</source>
        <translation>%1 ligger på fragment där planen lägger dem: den kan inte provas på skannat ben.</translation>
    </message>
</context>
<context>
    <name>hasp::FitTool</name>
    <message>
        <source>There is no part to be tried: choose one, and try it from there.</source>
        <translation>Det finns ingen del att prova: välj en, och prova den därifrån.</translation>
    </message>
    <message>
        <source>Drag the part onto the bone; the wheel moves it in depth, the middle button turns it, Shift holds it. Beside the part the view turns. Esc: back</source>
        <translation>Dra delen mot benet; hjulet flyttar den i djupled, mittknappen vrider den, Shift håller kvar den. Bredvid delen vrids vyn. Esc: tillbaka</translation>
    </message>
</context>
<context>
    <name>hasp::FragmentMaking</name>
    <message>
        <source>What was painted is no longer in the plan: no fragments were made of it.</source>
        <translation>Det som målades finns inte längre i planen: inga fragment skapades av det.</translation>
    </message>
    <message>
        <source>Make fragments</source>
        <translation>Skapa fragment</translation>
    </message>
    <message>
        <source>It was painted on meanwhile: make the fragments once more.</source>
        <translation>Det målades mer under tiden: skapa fragmenten en gång till.</translation>
    </message>
    <message>
        <source>There is no bone in it: choose a lower isovalue.</source>
        <translation>Det finns inget ben i den: välj ett lägre isovärde.</translation>
    </message>
    <message>
        <source>No fragment was made.</source>
        <translation>Inget fragment gjordes.</translation>
    </message>
    <message>
        <source>The fragments are as they are painted now.</source>
        <translation>Fragmenten är så som de är målade nu.</translation>
    </message>
    <message>
        <source>Fragments made: %1.</source>
        <translation>Skapade fragment: %1.</translation>
    </message>
    <message>
        <source>The scan that was painted on is not here: locate it in the step Import.</source>
        <translation>Skanningen som målades på finns inte här: hitta den i steget Import.</translation>
    </message>
    <message>
        <source>Making fragments</source>
        <translation>Skapar fragment</translation>
    </message>
    <message>
        <source>No scan is shown: import one, or show it.</source>
        <translation>Ingen skanning visas: importera en, eller visa den.</translation>
    </message>
    <message>
        <source>pieces of bone</source>
        <translation>benbitar</translation>
    </message>
    <message>
        <source>Take bone apart</source>
        <translation>Ta isär ben</translation>
    </message>
    <message>
        <source>Bone from here</source>
        <translation>Ben härifrån</translation>
    </message>
</context>
<context>
    <name>hasp::FragmentTable</name>
    <message>
        <source>fragment %1</source>
        <translation>fragment %1</translation>
    </message>
    <message>
        <source>, group %1</source>
        <translation>, grupp %1</translation>
    </message>
    <message>
        <source>%1 (stays)</source>
        <translation>%1 (orörligt)</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>Fragment</translation>
    </message>
    <message>
        <source>Fragment</source>
        <translation>Fragment</translation>
    </message>
    <message>
        <source>Fits</source>
        <translation>Passas in</translation>
    </message>
    <message>
        <source>Other bone</source>
        <translation>Annat ben</translation>
    </message>
    <message>
        <source>Takes part when fragments are put together</source>
        <translation>Är med när fragment sätts ihop</translation>
    </message>
    <message>
        <source>Is only touched, and nothing is fitted to it: as the cranium for a mandible</source>
        <translation>Tar bara emot, och inget passas in mot det: som kraniet för en underkäke</translation>
    </message>
</context>
<context>
    <name>hasp::GrabTool</name>
    <message>
        <source>Drag a fragment to move it; the wheel moves it in depth, the middle button turns it, Shift holds it. Beside fragments the view turns. Esc: back</source>
        <translation>Dra ett fragment för att flytta det; hjulet flyttar det i djupled, mittknappen vrider det, Shift håller kvar det. Bredvid fragment vrids vyn. Esc: tillbaka</translation>
    </message>
    <message>
        <source>What is felt is still being prepared (%1 %): take the fragment in hand when that is done.</source>
        <translation>Det som känns förbereds fortfarande (%1 %): ta fragmentet i handen när det är klart.</translation>
    </message>
</context>
<context>
    <name>hasp::GuideBox</name>
    <message>
        <source>Touch bone along the middle of the guide, in order.</source>
        <translation>Peka på benet längs sågmallens mitt, i ordning.</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Ny</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>sågmall</translation>
    </message>
    <message>
        <source>&amp;Touch bone</source>
        <translation>&amp;Peka på benet</translation>
    </message>
    <message>
        <source>Touch &amp;pins</source>
        <translation>Peka ut st&amp;ift</translation>
    </message>
    <message>
        <source>Touch where pins go through the guide into bone.</source>
        <translation>Peka där stift går genom sågmallen in i benet.</translation>
    </message>
    <message>
        <source>Touch the &amp;label&apos;s place</source>
        <translation>Peka ut märkningens &amp;läge</translation>
    </message>
    <message>
        <source>Touch bone below the middle of the label.</source>
        <translation>Peka på benet under märkningens mitt.</translation>
    </message>
    <message>
        <source>The plan has no cuts: make them in the step Cut.</source>
        <translation>Planen har inga snitt: gör dem i steget Snitt.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Område</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Of the chosen pin; of all of them where none is chosen</source>
        <translation>För det valda stiftet; för alla om inget är valt</translation>
    </message>
    <message>
        <source>Pin, as printed</source>
        <translation>Stift, som utskrivet</translation>
    </message>
    <message>
        <source>Drilled into bone</source>
        <translation>Borrat i benet</translation>
    </message>
    <message>
        <source>Sleeve above bone</source>
        <translation>Hylsa ovanför benet</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Sida</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vänster</translation>
    </message>
    <message>
        <source>right</source>
        <translation>höger</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Bokstäver</translation>
    </message>
    <message>
        <source>Letters&apos; depth</source>
        <translation>Bokstävernas djup</translation>
    </message>
    <message>
        <source>Cut in</source>
        <translation>Graverade</translation>
    </message>
    <message>
        <source>Written towards</source>
        <translation>Skrivriktning</translation>
    </message>
    <message>
        <source>My right</source>
        <translation>Åt höger för mig</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>On the bone</source>
        <translation>På benet</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Filled ring</source>
        <translation>Fylld ring</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Lifts off along</source>
        <translation>Lyfts av längs</translation>
    </message>
    <message>
        <source>Mean normal</source>
        <translation>Medelnormal</translation>
    </message>
    <message>
        <source>As I look</source>
        <translation>Min blickriktning</translation>
    </message>
    <message>
        <source>Search near it</source>
        <translation>Sök nära den</translation>
    </message>
    <message>
        <source>And what is painted</source>
        <translation>Och det som målas</translation>
    </message>
    <message>
        <source>Gap to the bone</source>
        <translation>Avstånd till benet</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tjocklek</translation>
    </message>
    <message>
        <source>Round edges</source>
        <translation>Kantradie</translation>
    </message>
    <message>
        <source>Slots wider by</source>
        <translation>Slitsar vidare med</translation>
    </message>
    <message>
        <source>For resin</source>
        <translation>För resin</translation>
    </message>
    <message>
        <source>For filament</source>
        <translation>För filament</translation>
    </message>
    <message>
        <source>Walls of slots</source>
        <translation>Slitsväggar</translation>
    </message>
    <message>
        <source>Walls of sleeves</source>
        <translation>Hylsväggar</translation>
    </message>
    <message>
        <source>Working grid</source>
        <translation>Arbetsrutnät</translation>
    </message>
    <message>
        <source>Bone from</source>
        <translation>Ben från</translation>
    </message>
    <message>
        <source>Ignore pieces below</source>
        <translation>Bortse från bitar under</translation>
    </message>
    <message>
        <source>The guide gets a slot for each of these cuts, and follows them:</source>
        <translation>Sågmallen får en slits för vart och ett av dessa snitt, och följer dem:</translation>
    </message>
</context>
<context>
    <name>hasp::GuidePanel</name>
    <message>
        <source>Import a scan first.</source>
        <translation>Importera först en skanning.</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Sågmall</translation>
    </message>
</context>
<context>
    <name>hasp::HandDevices</name>
    <message>
        <source>The settings of devices are not used: %1</source>
        <translation>Enheternas inställningar används inte: %1</translation>
    </message>
    <message>
        <source>The haptic device is not used: %1</source>
        <translation>Den haptiska enheten används inte: %1</translation>
    </message>
    <message>
        <source>%1 moves what is in hand now.</source>
        <translation>%1 flyttar nu det som är i handen.</translation>
    </message>
    <message>
        <source>%1: %2. The mouse moves what is in hand.</source>
        <translation>%1: %2. Musen flyttar det som är i handen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 was unplugged. The mouse moves what is in hand.</source>
        <translation>%1 har kopplats ur. Musen flyttar det som är i handen.</translation>
    </message>
</context>
<context>
    <name>hasp::ImplantBox</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nytt</translation>
    </message>
    <message>
        <source>implant</source>
        <translation>implantat</translation>
    </message>
    <message>
        <source>&amp;Touch the outline</source>
        <translation>&amp;Peka ut konturen</translation>
    </message>
    <message>
        <source>Touch the outer bone all around the hole, in order, some millimetres from its rim.</source>
        <translation>Peka på benets utsida runt hela hålet, i ordning, några millimeter från dess kant.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>In the scan</source>
        <translation>I skanningen</translation>
    </message>
    <message>
        <source>Clearance to the edge</source>
        <translation>Spel mot kanten</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tjocklek</translation>
    </message>
    <message>
        <source>Holes, 0: none</source>
        <translation>Hål, 0: inga</translation>
    </message>
    <message>
        <source>Holes apart</source>
        <translation>Mellan hål</translation>
    </message>
    <message>
        <source>Holes to the edge</source>
        <translation>Hål till kant</translation>
    </message>
    <message>
        <source>Working grid</source>
        <translation>Arbetsrutnät</translation>
    </message>
    <message>
        <source>Bone from</source>
        <translation>Ben från</translation>
    </message>
    <message>
        <source>Ignore pieces below</source>
        <translation>Bortse från bitar under</translation>
    </message>
    <message>
        <source>Put in against</source>
        <translation>Sätts in mot</translation>
    </message>
    <message>
        <source>Towards me</source>
        <translation>Mot mig</translation>
    </message>
    <message>
        <source>Upright on the outline</source>
        <translation>Vinkelrätt mot konturen</translation>
    </message>
    <message>
        <source>Mirrored at</source>
        <translation>Speglat i</translation>
    </message>
    <message>
        <source>the plane found in the scan</source>
        <translation>planet som hittas i skanningen</translation>
    </message>
</context>
<context>
    <name>hasp::ImportPanel</name>
    <message>
        <source>O&amp;pen file…</source>
        <translation>Öppna &amp;fil…</translation>
    </message>
    <message>
        <source>Open a scan, a label map or a surface</source>
        <translation>Öppna en skanning, en etikettkarta eller en yta</translation>
    </message>
    <message>
        <source>Scans, label maps and surfaces (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.vti *.inv3 *.stl *.ply *.obj *.3mf *.vtp);;All files (*)</source>
        <translation>Skanningar, etikettkartor och ytor (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.vti *.inv3 *.stl *.ply *.obj *.3mf *.vtp);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Open f&amp;older…</source>
        <translation>Öppna ma&amp;pp…</translation>
    </message>
    <message>
        <source>A folder of DICOM slices, or a plan (.hasp)</source>
        <translation>En mapp med DICOM-snittbilder, eller en plan (.hasp)</translation>
    </message>
    <message>
        <source>Open a folder of slices, or a plan</source>
        <translation>Öppna en mapp med snittbilder, eller en plan</translation>
    </message>
    <message>
        <source>a pseudonym, no name</source>
        <translation>en pseudonym, inget namn</translation>
    </message>
    <message>
        <source>It is written on parts and into reports.</source>
        <translation>Den skrivs på delar och i rapporter.</translation>
    </message>
    <message>
        <source>&amp;Case</source>
        <translation>Fa&amp;ll</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>An open surface is taken as a sheet, so thick behind the face that it shows.</source>
        <translation>En öppen yta tolkas som ett skal, så här tjockt bakom den sida som syns.</translation>
    </message>
    <message>
        <source>Open surfaces are thic&amp;k</source>
        <translation>Öppna ytors tjoc&amp;klek</translation>
    </message>
    <message>
        <source>Set the case label</source>
        <translation>Ange fallbeteckningen</translation>
    </message>
    <message>
        <source>This plan has changes that are not saved: save it, then open another.</source>
        <translation>Den här planen har ändringar som inte är sparade: spara den, och öppna sedan en annan.</translation>
    </message>
    <message>
        <source>Reading what was chosen</source>
        <translation>Läser det valda</translation>
    </message>
    <message>
        <source>Scan %1 of the plan: it was here before.</source>
        <translation>Planens skanning %1: den fanns här redan.</translation>
    </message>
    <message>
        <source>The scan that these labels are of is no longer in the plan: import it, and then the labels again.</source>
        <translation>Skanningen som dessa etiketter hör till finns inte längre i planen: importera den, och sedan etiketterna på nytt.</translation>
    </message>
    <message>
        <source>These labels are segmentation %1 of the plan already.</source>
        <translation>Dessa etiketter är redan planens segmentering %1.</translation>
    </message>
    <message>
        <source>Import fragments</source>
        <translation>Importera fragment</translation>
    </message>
    <message>
        <source>Import a surface</source>
        <translation>Importera en yta</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
</context>
<context>
    <name>hasp::ImportRemedies</name>
    <message>
        <source>Me&amp;nd it by resampling</source>
        <translation>Rätta ge&amp;nom omsampling</translation>
    </message>
    <message>
        <source>Series of the folder</source>
        <translation>Mappens serier</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>Försök i&amp;gen</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
</context>
<context>
    <name>hasp::IsovalueBox</name>
    <message>
        <source>bone</source>
        <translation>ben</translation>
    </message>
    <message>
        <source>adult compact bone</source>
        <translation>kompakt ben, vuxen</translation>
    </message>
    <message>
        <source>adult spongial bone</source>
        <translation>spongiöst ben, vuxen</translation>
    </message>
    <message>
        <source>adult enamel</source>
        <translation>emalj, vuxen</translation>
    </message>
    <message>
        <source>child compact bone</source>
        <translation>kompakt ben, barn</translation>
    </message>
    <message>
        <source>child spongial bone</source>
        <translation>spongiöst ben, barn</translation>
    </message>
    <message>
        <source>child enamel</source>
        <translation>emalj, barn</translation>
    </message>
    <message>
        <source>soft tissue</source>
        <translation>mjukdelar</translation>
    </message>
    <message>
        <source>Prop&amp;ose</source>
        <translation>&amp;Föreslå</translation>
    </message>
    <message>
        <source>Isovalue</source>
        <translation>Isovärde</translation>
    </message>
    <message>
        <source>choose a range…</source>
        <translation>välj ett intervall…</translation>
    </message>
    <message>
        <source>%1, from %2 HU</source>
        <translation>%1, från %2 HU</translation>
    </message>
    <message>
        <source>Finds where bone begins by the histogram: for values that are no HU</source>
        <translation>Hittar var ben börjar med histogrammet: för värden som inte är HU</translation>
    </message>
    <message>
        <source>Bone is at &amp;least</source>
        <translation>&amp;Ben är minst</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HU</translation>
    </message>
    <message>
        <source>Proposing where bone begins</source>
        <translation>Föreslår var ben börjar</translation>
    </message>
    <message>
        <source>Bone begins at about %1, but soft tissue and bone run into each other: look at thin bone, and set it by hand.</source>
        <translation>Ben börjar vid ungefär %1, men mjukdelar och ben går in i varandra: granska tunt ben, och ställ in det för hand.</translation>
    </message>
    <message>
        <source>Bone begins at about %1. Thin bone may be lost: look at it.</source>
        <translation>Ben börjar vid ungefär %1. Tunt ben kan gå förlorat: granska det.</translation>
    </message>
</context>
<context>
    <name>hasp::JobQueue</name>
    <message>
        <source>there is not enough memory; close other programs or work on a smaller scan</source>
        <translation>minnet räcker inte; stäng andra program eller arbeta med en mindre skanning</translation>
    </message>
</context>
<context>
    <name>hasp::LabelFindings</name>
    <message>
        <source>%1 gets no bone: its strokes touch none, or later ones paint over them.</source>
        <translation>%1 får inget ben: dess penseldrag rör inget, eller senare penseldrag målar över dem.</translation>
    </message>
    <message>
        <source>Sharing out bone did not come to its end: look at where fragments meet.</source>
        <translation>Fördelningen av ben kom inte till slut: granska där fragment möts.</translation>
    </message>
    <message>
        <source>Strokes that touch no bone: %1.</source>
        <translation>Penseldrag som inte rör något ben: %1.</translation>
    </message>
    <message>
        <source>Left out is bone that no stroke is connected to: %1 mm³ (voxels: %2).</source>
        <translation>Utelämnat är ben som inget penseldrag hänger ihop med: %1 mm³ (voxlar: %2).</translation>
    </message>
    <message>
        <source>%1 has no cavity to fill.</source>
        <translation>%1 har ingen hålighet att fylla.</translation>
    </message>
    <message>
        <source>Of %1 nothing changes within %2 mm.</source>
        <translation>Av %1 ändras inget inom %2 mm.</translation>
    </message>
    <message>
        <source>The bone is one piece.</source>
        <translation>Benet är ett stycke.</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Steg %1</translation>
    </message>
</context>
<context>
    <name>hasp::LabelList</name>
    <message>
        <source>Colo&amp;ur…</source>
        <translation>Fär&amp;g…</translation>
    </message>
    <message>
        <source>Labels that are painted</source>
        <translation>Etiketter som målas</translation>
    </message>
    <message>
        <source>&amp;Add label</source>
        <translation>Lägg &amp;till etikett</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>Etikett %1</translation>
    </message>
    <message>
        <source>Add label %1</source>
        <translation>Lägg till etikett %1</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>Etikettens färg</translation>
    </message>
    <message>
        <source>Colour label %1</source>
        <translation>Färga etikett %1</translation>
    </message>
    <message>
        <source>Rename label %1</source>
        <translation>Byt namn på etikett %1</translation>
    </message>
</context>
<context>
    <name>hasp::LandmarkTool</name>
    <message>
        <source>Drag: move it, Delete: remove it, Insert: at the crosshair, Esc: back.</source>
        <translation>Dra: flytta det, Delete: ta bort det, Insert: vid hårkorset, Esc: tillbaka.</translation>
    </message>
    <message>
        <source>There is no crosshair: show a scan first.</source>
        <translation>Det finns inget hårkors: visa först en skanning.</translation>
    </message>
    <message>
        <source>That is %1 and no bone: hide it, or touch beside it.</source>
        <translation>Det är %1 och inget ben: dölj det, eller peka bredvid.</translation>
    </message>
    <message>
        <source>There are %1 places, and no more are taken: drag one to another place, or remove one.</source>
        <translation>Det finns %1 ställen, och fler tas inte emot: dra ett till ett annat ställe, eller ta bort ett.</translation>
    </message>
</context>
<context>
    <name>hasp::LayoutFile</name>
    <message>
        <source>The layout file cannot be written: give --layout a place that can be, or free space on its disk.</source>
        <translation>Layoutfilen kan inte skrivas: ge --layout en plats där det går, eller frigör utrymme på dess disk.</translation>
    </message>
</context>
<context>
    <name>hasp::MeasureTool</name>
    <message>
        <source>Distance: places still to touch: %1; or press Insert at the crosshair.</source>
        <translation>Avstånd: ställen kvar att peka ut: %1; eller tryck Insert vid hårkorset.</translation>
    </message>
    <message>
        <source>Angle, its corner second: places still to touch: %1; or press Insert at the crosshair.</source>
        <translation>Vinkel, spetsen som nummer två: ställen kvar att peka ut: %1; eller tryck Insert vid hårkorset.</translation>
    </message>
    <message>
        <source>There is no crosshair: show a scan first.</source>
        <translation>Det finns inget hårkors: visa först en skanning.</translation>
    </message>
    <message>
        <source>distance %1</source>
        <translation>avstånd %1</translation>
    </message>
    <message>
        <source>angle %1</source>
        <translation>vinkel %1</translation>
    </message>
</context>
<context>
    <name>hasp::MessageBar</name>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Fault: %1</source>
        <translation>Fel: %1</translation>
    </message>
</context>
<context>
    <name>hasp::MissingInputs</name>
    <message>
        <source>The plan was made on what is not here:</source>
        <translation>Planen gjordes på sådant som inte finns här:</translation>
    </message>
    <message>
        <source>Scans and surfaces that are not here</source>
        <translation>Skanningar och ytor som inte finns här</translation>
    </message>
    <message>
        <source>&amp;Locate its file…</source>
        <translation>Hitta dess f&amp;il…</translation>
    </message>
    <message>
        <source>Locate its fol&amp;der…</source>
        <translation>Hitta &amp;dess mapp…</translation>
    </message>
    <message>
        <source>Where is it?</source>
        <translation>Var finns den?</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>Where are this scan&apos;s slices?</source>
        <translation>Var finns den här skanningens snittbilder?</translation>
    </message>
    <message>
        <source>scan %1 is not here</source>
        <translation>skanning %1 finns inte här</translation>
    </message>
    <message>
        <source>surface %1 is not here</source>
        <translation>yta %1 finns inte här</translation>
    </message>
    <message>
        <source>Reading surface %1</source>
        <translation>Läser yta %1</translation>
    </message>
    <message>
        <source>Reading scan %1</source>
        <translation>Läser skanning %1</translation>
    </message>
    <message>
        <source>This is not scan %1: its samples are others. Choose the file or folder that the plan was made on; a copy in another format will do. One that was resampled then is to be imported, and resampled, again.</source>
        <translation>Det här är inte skanning %1: dess värden är andra. Välj den fil eller mapp som planen gjordes på; en kopia i ett annat format duger. En som omsamplades då ska importeras, och omsamplas, på nytt.</translation>
    </message>
    <message>
        <source>Scan %1 is here.</source>
        <translation>Skanning %1 finns här.</translation>
    </message>
    <message>
        <source>This is not surface %1: its triangles are others. Choose the file that the plan was made on.</source>
        <translation>Det här är inte yta %1: dess trianglar är andra. Välj den fil som planen gjordes på.</translation>
    </message>
</context>
<context>
    <name>hasp::MitreBox</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Ny</translation>
    </message>
    <message>
        <source>mitre guide</source>
        <translation>geringsmall</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>For</source>
        <translation>För</translation>
    </message>
    <message>
        <source>Gap to the bone</source>
        <translation>Avstånd till benet</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tjocklek</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Slots wider by</source>
        <translation>Slitsar vidare med</translation>
    </message>
    <message>
        <source>Walls of slots</source>
        <translation>Slitsväggar</translation>
    </message>
    <message>
        <source>Slots across</source>
        <translation>Slitsar tvärs över</translation>
    </message>
    <message>
        <source>Slots above bone</source>
        <translation>Slitsar ovanför benet</translation>
    </message>
    <message>
        <source>Beyond the cuts</source>
        <translation>Bortom snitten</translation>
    </message>
    <message>
        <source>Pins, 0: none</source>
        <translation>Stift, 0: inga</translation>
    </message>
    <message>
        <source>Working grid</source>
        <translation>Arbetsrutnät</translation>
    </message>
    <message>
        <source>Plan a transplant first.</source>
        <translation>Planera först ett transplantat.</translation>
    </message>
</context>
<context>
    <name>hasp::NudgePad</name>
    <message>
        <source>Move to the left</source>
        <translation>Flytta åt vänster</translation>
    </message>
    <message>
        <source>Move to the right</source>
        <translation>Flytta åt höger</translation>
    </message>
    <message>
        <source>Move backwards</source>
        <translation>Flytta bakåt</translation>
    </message>
    <message>
        <source>Move forwards</source>
        <translation>Flytta framåt</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Flytta uppåt</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Flytta nedåt</translation>
    </message>
    <message>
        <source>Turn about left and right</source>
        <translation>Vrid kring vänster–höger</translation>
    </message>
    <message>
        <source>Turn back about left and right</source>
        <translation>Vrid tillbaka kring vänster–höger</translation>
    </message>
    <message>
        <source>Turn about front and back</source>
        <translation>Vrid kring fram–bak</translation>
    </message>
    <message>
        <source>Turn back about front and back</source>
        <translation>Vrid tillbaka kring fram–bak</translation>
    </message>
    <message>
        <source>Turn about up and down</source>
        <translation>Vrid kring upp–ned</translation>
    </message>
    <message>
        <source>Turn back about up and down</source>
        <translation>Vrid tillbaka kring upp–ned</translation>
    </message>
    <message>
        <source>Move b&amp;y</source>
        <translation>Fl&amp;ytta med</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>t&amp;urn by</source>
        <translation>vrid m&amp;ed</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>&amp;Back to where it was scanned</source>
        <translation>Till&amp;baka dit det skannades</translation>
    </message>
    <message>
        <source>What is not shown has no middle to be turned about: show it first.</source>
        <translation>Det som inte visas har ingen mitt att vridas kring: visa det först.</translation>
    </message>
    <message>
        <source>Back to where it was scanned</source>
        <translation>Tillbaka dit det skannades</translation>
    </message>
    <message>
        <source>It is where it was scanned.</source>
        <translation>Det ligger där det skannades.</translation>
    </message>
</context>
<context>
    <name>hasp::ObjectChooser</name>
    <message>
        <source>&amp;Remove</source>
        <translation>Ta &amp;bort</translation>
    </message>
    <message>
        <source>Which one</source>
        <translation>Vilket</translation>
    </message>
    <message>
        <source>none</source>
        <translation>inget</translation>
    </message>
</context>
<context>
    <name>hasp::ObjectList</name>
    <message>
        <source>Choose the two or more fragments that shall move as one.</source>
        <translation>Välj de två eller fler fragment som ska flyttas som ett.</translation>
    </message>
    <message>
        <source>Choose the fragments that shall be resected.</source>
        <translation>Välj de fragment som ska resekeras.</translation>
    </message>
    <message>
        <source>Choose the fragments that shall have another colour.</source>
        <translation>Välj de fragment som ska ha en annan färg.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Färg</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Ändra färg</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Skanningar</translation>
    </message>
    <message>
        <source>Segmentations</source>
        <translation>Segmenteringar</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Ytor</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>Fragment</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupper</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>Sågmallar</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Plattor</translation>
    </message>
    <message>
        <source>Implants</source>
        <translation>Implantat</translation>
    </message>
    <message>
        <source>Transplants</source>
        <translation>Transplantat</translation>
    </message>
    <message>
        <source>Mitre guides</source>
        <translation>Geringsmallar</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Mått</translation>
    </message>
    <message>
        <source>Ghosts</source>
        <translation>Spegelbilder</translation>
    </message>
    <message>
        <source>resected</source>
        <translation>resekerat</translation>
    </message>
    <message>
        <source>in pieces</source>
        <translation>i bitar</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>in date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>inaktuell</translation>
    </message>
    <message>
        <source>not made</source>
        <translation>inte skapad</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Lås</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Objects of the plan</source>
        <translation>Planens objekt</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ta &amp;bort</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Gruppera</translation>
    </message>
    <message>
        <source>Re&amp;sect, or take that back</source>
        <translation>Re&amp;sekera, eller ta tillbaka det</translation>
    </message>
    <message>
        <source>&amp;Colour …</source>
        <translation>&amp;Färg …</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Byt &amp;namn</translation>
    </message>
    <message>
        <source>S&amp;how, or hide</source>
        <translation>&amp;Visa, eller dölj</translation>
    </message>
    <message>
        <source>&amp;Lock, or take that back</source>
        <translation>&amp;Lås, eller ta tillbaka det</translation>
    </message>
    <message>
        <source>Choose the fragments that shall stay where they are.</source>
        <translation>Välj de fragment som ska stanna där de är.</translation>
    </message>
</context>
<context>
    <name>hasp::ObjectNames</name>
    <message>
        <source>scan %1</source>
        <translation>skanning %1</translation>
    </message>
    <message>
        <source>segmentation %1</source>
        <translation>segmentering %1</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>yta %1</translation>
    </message>
    <message>
        <source>fragment %1</source>
        <translation>fragment %1</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>grupp %1</translation>
    </message>
    <message>
        <source>cut %1</source>
        <translation>snitt %1</translation>
    </message>
    <message>
        <source>guide %1</source>
        <translation>sågmall %1</translation>
    </message>
    <message>
        <source>plate %1</source>
        <translation>platta %1</translation>
    </message>
    <message>
        <source>implant %1</source>
        <translation>implantat %1</translation>
    </message>
    <message>
        <source>transplant %1</source>
        <translation>transplantat %1</translation>
    </message>
    <message>
        <source>mitre-guide %1</source>
        <translation>geringsmall %1</translation>
    </message>
    <message>
        <source>measure %1</source>
        <translation>mått %1</translation>
    </message>
    <message>
        <source>mirror %1</source>
        <translation>spegelbild %1</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>etikett %1</translation>
    </message>
</context>
<context>
    <name>hasp::PaintTool</name>
    <message>
        <source>Drag over strokes to take them away. Shift and wheel: size. Esc: back</source>
        <translation>Dra över penseldrag för att ta bort dem. Shift och hjul: storlek. Esc: tillbaka</translation>
    </message>
    <message>
        <source>Drag on bone to paint label %1. Shift and wheel: size. Beside bone the view turns. Esc: back</source>
        <translation>Dra på ben för att måla etikett %1. Shift och hjul: storlek. Bredvid ben vrids vyn. Esc: tillbaka</translation>
    </message>
    <message>
        <source>No scan is shown that could be painted on: import one, or show it.</source>
        <translation>Ingen skanning visas som går att måla på: importera en, eller visa den.</translation>
    </message>
    <message>
        <source>There is no stroke under the eraser.</source>
        <translation>Det finns inget penseldrag under suddgummit.</translation>
    </message>
    <message>
        <source>Erase strokes</source>
        <translation>Sudda penseldrag</translation>
    </message>
    <message>
        <source>painted</source>
        <translation>målat</translation>
    </message>
    <message>
        <source>Paint label %1</source>
        <translation>Måla etikett %1</translation>
    </message>
</context>
<context>
    <name>hasp::PaintedArea</name>
    <message>
        <source>&amp;Paint</source>
        <translation>Må&amp;la</translation>
    </message>
    <message>
        <source>&amp;Wipe off</source>
        <translation>Sudda &amp;ut</translation>
    </message>
    <message>
        <source>At the +</source>
        <translation>Vid +</translation>
    </message>
    <message>
        <source>A dab at the crosshair</source>
        <translation>En fläck vid hårkorset</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radie</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Rensa</translation>
    </message>
    <message>
        <source>Nothing is painted.</source>
        <translation>Inget är målat.</translation>
    </message>
    <message>
        <source>Strokes: %1</source>
        <translation>Penseldrag: %1</translation>
    </message>
</context>
<context>
    <name>hasp::PartStatus</name>
    <message>
        <source>Ma&amp;ke</source>
        <translation>&amp;Skapa</translation>
    </message>
    <message>
        <source>Make the part, and measure whether it holds what is asked of it</source>
        <translation>Skapa delen, och mät om den uppfyller det som krävs av den</translation>
    </message>
    <message>
        <source>Not in the plan yet.</source>
        <translation>Inte i planen ännu.</translation>
    </message>
    <message>
        <source>In date.</source>
        <translation>Aktuell.</translation>
    </message>
</context>
<context>
    <name>hasp::PartTable</name>
    <message>
        <source>in date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>inaktuell</translation>
    </message>
    <message>
        <source>not made</source>
        <translation>inte skapad</translation>
    </message>
    <message>
        <source>red</source>
        <translation>röd</translation>
    </message>
    <message>
        <source>not certified</source>
        <translation>inte certifierad</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grön</translation>
    </message>
    <message>
        <source>green, held to fragment %1 alone</source>
        <translation>grön, prövad bara mot fragment %1</translation>
    </message>
    <message>
        <source>Parts of the plan</source>
        <translation>Planens delar</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Omdöme</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>red, not kept</source>
        <translation>röd, inte behållen</translation>
    </message>
    <message>
        <source>Gap, mm</source>
        <translation>Avstånd, mm</translation>
    </message>
    <message>
        <source>To the bone: median / 95 % / least</source>
        <translation>Till benet: median / 95 % / minst</translation>
    </message>
</context>
<context>
    <name>hasp::PassportBrowser</name>
    <message>
        <source>What is known of what was imported</source>
        <translation>Vad som är känt om det som importerats</translation>
    </message>
    <message>
        <source>The scan that is shown:</source>
        <translation>Skanningen som visas:</translation>
    </message>
</context>
<context>
    <name>hasp::PassportPage</name>
    <message>
        <source>Fault:</source>
        <translation>Fel:</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalitet</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>inte angivet</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Voxlar</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Voxelavstånd</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Storlek</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Värden</translation>
    </message>
    <message>
        <source>%1 to %2 HU</source>
        <translation>%1 till %2 HU</translation>
    </message>
    <message>
        <source>%1 to %2, not said to be HU</source>
        <translation>%1 till %2, inte angivna som HU</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Röntgenrör</translation>
    </message>
    <message>
        <source>%1 kV</source>
        <translation>%1 kV</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Snittbilder</translation>
    </message>
    <message>
        <source>%1 mm thick, as the file says</source>
        <translation>%1 mm tjocka, enligt filen</translation>
    </message>
    <message>
        <source>Gantry tilt</source>
        <translation>Gantrylutning</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Överhoppat</translation>
    </message>
    <message>
        <source>files that are no images: %1</source>
        <translation>filer som inte är bilder: %1</translation>
    </message>
    <message>
        <source>Resampled</source>
        <translation>Omsamplad</translation>
    </message>
    <message>
        <source>%1 slices made, %2 measured</source>
        <translation>%1 snittbilder skapade, %2 uppmätta</translation>
    </message>
    <message>
        <source>Its error</source>
        <translation>Felets storlek</translation>
    </message>
    <message>
        <source>at most %1 mm at 95 % of edges</source>
        <translation>högst %1 mm vid 95 % av kanterna</translation>
    </message>
    <message>
        <source>not known: there is nothing to measure it by</source>
        <translation>okänd: det finns inget att mäta den med</translation>
    </message>
    <message>
        <source>Hash</source>
        <translation>Hash</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Anmärkning:</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Koordinatsystem</translation>
    </message>
    <message>
        <source>not said, LPS is taken</source>
        <translation>inte angivet, LPS antas</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trianglar</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Sluten</translation>
    </message>
    <message>
        <source>yes, %1 cm³</source>
        <translation>ja, %1 cm³</translation>
    </message>
    <message>
        <source>no, it is a sheet; edges at its holes: %1</source>
        <translation>nej, den är ett skal; kanter vid dess hål: %1</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Bitar</translation>
    </message>
</context>
<context>
    <name>hasp::PiecesBox</name>
    <message>
        <source>F&amp;ind the pieces</source>
        <translation>Hi&amp;tta bitarna</translation>
    </message>
    <message>
        <source>All that the cuts leave of the bone become fragments</source>
        <translation>Allt som snitten lämnar av benet blir fragment</translation>
    </message>
    <message>
        <source>&amp;Touch pieces</source>
        <translation>&amp;Peka på bitar</translation>
    </message>
    <message>
        <source>Touch each piece that is to be kept.</source>
        <translation>Peka på varje bit som ska behållas.</translation>
    </message>
    <message>
        <source>&amp;Keep the touched pieces</source>
        <translation>Behå&amp;ll utpekade bitar</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Bitar</translation>
    </message>
    <message>
        <source>Rese&amp;ct</source>
        <translation>Re&amp;sekera</translation>
    </message>
    <message>
        <source>Finding the pieces of fragment %1</source>
        <translation>Söker bitarna av fragment %1</translation>
    </message>
    <message>
        <source>Fragment %1 has changed meanwhile: find its pieces again.</source>
        <translation>Fragment %1 har ändrats under tiden: sök dess bitar på nytt.</translation>
    </message>
    <message>
        <source>All pieces of fragment %1 are in the plan.</source>
        <translation>Alla bitar av fragment %1 finns i planen.</translation>
    </message>
    <message>
        <source>Cut %1 does not part the bone: make its blade larger, or its reach.</source>
        <translation>Snitt %1 delar inte benet: gör dess sågblad större, eller dess räckvidd.</translation>
    </message>
    <message>
        <source>Touch pieces of a fragment that a cut goes through, then keep them.</source>
        <translation>Peka på bitar av ett fragment som ett snitt går genom, och behåll dem sedan.</translation>
    </message>
    <message>
        <source>Keep pieces of fragment %1</source>
        <translation>Behåll bitar av fragment %1</translation>
    </message>
    <message>
        <source>Keep it &amp;after all</source>
        <translation>Behåll än&amp;då</translation>
    </message>
    <message>
        <source> (resected)</source>
        <translation> (resekerat)</translation>
    </message>
    <message>
        <source>piece %1 of fragment %2</source>
        <translation>bit %1 av fragment %2</translation>
    </message>
</context>
<context>
    <name>hasp::PlanFigures</name>
    <message>
        <source>none can be measured</source>
        <translation>inget kan mätas</translation>
    </message>
    <message>
        <source>Measures and fractures</source>
        <translation>Mått och frakturer</translation>
    </message>
    <message>
        <source>Measures of the plan</source>
        <translation>Planens mått</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mått</translation>
    </message>
    <message>
        <source>As planned</source>
        <translation>Som planerat</translation>
    </message>
    <message>
        <source>Fractures of the plan</source>
        <translation>Planens frakturer</translation>
    </message>
    <message>
        <source>Fracture</source>
        <translation>Fraktur</translation>
    </message>
    <message>
        <source>Step-off: median / 95 %, mm</source>
        <translation>Stegbildning: median / 95 %, mm</translation>
    </message>
    <message>
        <source>Gap: median / 95 %, mm</source>
        <translation>Diastas: median / 95 %, mm</translation>
    </message>
    <message>
        <source>Mea&amp;sure along the fractures</source>
        <translation>Mät längs frakt&amp;urerna</translation>
    </message>
    <message>
        <source>Step-off and gap of fragments that face each other, as planned; their parts must be made</source>
        <translation>Stegbildning och diastas mellan fragment som vetter mot varandra, som planerat; deras delar måste vara skapade</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Measuring along the fractures</source>
        <translation>Mäter längs frakturerna</translation>
    </message>
    <message>
        <source>fragments %1 and %2</source>
        <translation>fragment %1 och %2</translation>
    </message>
    <message>
        <source>no two fragments face each other</source>
        <translation>inga två fragment vetter mot varandra</translation>
    </message>
</context>
<context>
    <name>hasp::PlanSession</name>
    <message>
        <source>What you do is not kept against a crash: %1. Save the plan, and make room on the disk.</source>
        <translation>Det du gör skyddas inte mot en krasch: %1. Spara planen, och frigör utrymme på disken.</translation>
    </message>
    <message>
        <source>The plan cannot be opened: %1</source>
        <translation>Planen kan inte öppnas: %1</translation>
    </message>
    <message>
        <source>A part of the journal is damaged: what was done after it is lost.</source>
        <translation>En del av händelseloggen är skadad: det som gjordes efter den är förlorat.</translation>
    </message>
    <message>
        <source>The work cannot be brought back: %1</source>
        <translation>Arbetet kan inte återställas: %1</translation>
    </message>
    <message>
        <source>The plan is not saved: %1</source>
        <translation>Planen är inte sparad: %1</translation>
    </message>
</context>
<context>
    <name>hasp::Planner</name>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 misslyckades: %2</translation>
    </message>
</context>
<context>
    <name>hasp::PlannerScript</name>
    <message>
        <source>the screenshot cannot be written; choose a folder that can</source>
        <translation>skärmbilden kan inte skrivas; välj en mapp där det går</translation>
    </message>
</context>
<context>
    <name>hasp::PlannerWindow</name>
    <message>
        <source>3D view</source>
        <translation>3D-vy</translation>
    </message>
    <message>
        <source>left drag</source>
        <translation>vänsterdragning</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>vrider</translation>
    </message>
    <message>
        <source>middle drag, Shift+left drag</source>
        <translation>mittdragning, Shift+vänsterdragning</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>flyttar</translation>
    </message>
    <message>
        <source>right drag, wheel</source>
        <translation>högerdragning, hjul</translation>
    </message>
    <message>
        <source>zooms</source>
        <translation>zoomar</translation>
    </message>
    <message>
        <source>Ctrl+left drag</source>
        <translation>Ctrl+vänsterdragning</translation>
    </message>
    <message>
        <source>rolls</source>
        <translation>rullar</translation>
    </message>
    <message>
        <source>all in sight; turn about what is under the pointer</source>
        <translation>allt i bild; vrid kring det under pekaren</translation>
    </message>
    <message>
        <source>parallel projection; wireframe, surface of meshes</source>
        <translation>parallellprojektion; trådmodell, yta för nät</translation>
    </message>
    <message>
        <source>stereo on and off</source>
        <translation>stereo på och av</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>dubbelklick</translation>
    </message>
    <message>
        <source>one view or four</source>
        <translation>en vy eller fyra</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Snittbilder</translation>
    </message>
    <message>
        <source>wheel, arrow keys, b, f</source>
        <translation>hjul, piltangenter, b, f</translation>
    </message>
    <message>
        <source>next slice</source>
        <translation>nästa snittbild</translation>
    </message>
    <message>
        <source>window (sideways) and level (up, down)</source>
        <translation>fönster (i sidled) och nivå (upp, ned)</translation>
    </message>
    <message>
        <source>left click, Shift+move</source>
        <translation>vänsterklick, Shift+rörelse</translation>
    </message>
    <message>
        <source>crosshair, in all views</source>
        <translation>hårkors, i alla vyer</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>högerdragning</translation>
    </message>
    <message>
        <source>all in sight; show the slice in the 3D view</source>
        <translation>allt i bild; visa snittbilden i 3D-vyn</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Verktyg</translation>
    </message>
    <message>
        <source>puts the tool away</source>
        <translation>lägger undan verktyget</translation>
    </message>
    <message>
        <source>paint: left drag</source>
        <translation>måla: vänsterdragning</translation>
    </message>
    <message>
        <source>paints on bone; beside it turns the view</source>
        <translation>målar på ben; bredvid vrids vyn</translation>
    </message>
    <message>
        <source>paint: Shift+wheel, +, -</source>
        <translation>måla: Shift+hjul, +, -</translation>
    </message>
    <message>
        <source>brush larger, smaller</source>
        <translation>större, mindre pensel</translation>
    </message>
    <message>
        <source>grab: left drag</source>
        <translation>greppa: vänsterdragning</translation>
    </message>
    <message>
        <source>takes a fragment along</source>
        <translation>tar med ett fragment</translation>
    </message>
    <message>
        <source>grab: wheel, middle drag</source>
        <translation>greppa: hjul, mittdragning</translation>
    </message>
    <message>
        <source>nearer and farther; turns it</source>
        <translation>närmare och längre bort; vrider det</translation>
    </message>
    <message>
        <source>grab: Shift</source>
        <translation>greppa: Shift</translation>
    </message>
    <message>
        <source>the mouse moves and the fragment stays</source>
        <translation>musen rör sig och fragmentet ligger kvar</translation>
    </message>
    <message>
        <source>landmarks: click, drag</source>
        <translation>landmärken: klick, dragning</translation>
    </message>
    <message>
        <source>touches bone; moves a landmark</source>
        <translation>pekar på ben; flyttar ett landmärke</translation>
    </message>
    <message>
        <source>landmark at the crosshair; removes the chosen one</source>
        <translation>landmärke vid hårkorset; tar bort det valda</translation>
    </message>
    <message>
        <source>the steps, from Import to Export</source>
        <translation>stegen, från Import till Export</translation>
    </message>
    <message>
        <source>gives up what is worked out</source>
        <translation>avbryter det som beräknas</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tangenter och mus</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Överallt</translation>
    </message>
    <message>
        <source>Research use only, not a medical device. Not for clinical use.</source>
        <translation>Endast för forskning, inte en medicinteknisk produkt. Inte för kliniskt bruk.</translation>
    </message>
    <message>
        <source>Version %1, commit %2; VTK %3, Qt %4.</source>
        <translation>Version %1, incheckning %2; VTK %3, Qt %4.</translation>
    </message>
    <message>
        <source>After F. Nysjö, Haptic Rendering and Interactive Surgery Planning, Uppsala University 2020. BSD 3-Clause; with CGAL&apos;s mesh check the program is under the GPL.</source>
        <translation>Efter F. Nysjö, Haptic Rendering and Interactive Surgery Planning, Uppsala universitet 2020. BSD 3-Clause; med CGAL:s nätkontroll lyder programmet under GPL.</translation>
    </message>
    <message>
        <source>Nothing leaves this machine: no network is used, and what is kept here names no patient.</source>
        <translation>Inget lämnar den här datorn: inget nätverk används, och det som sparas här nämner ingen patient.</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Om</translation>
    </message>
    <message>
        <source>Save the plan?</source>
        <translation>Spara planen?</translation>
    </message>
    <message>
        <source>The plan has changes that are not saved.</source>
        <translation>Planen har ändringar som inte är sparade.</translation>
    </message>
    <message>
        <source>Open a plan: its folder, NAME.hasp</source>
        <translation>Öppna en plan: dess mapp, NAMN.hasp</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Sparad.</translation>
    </message>
    <message>
        <source>Save the plan as a folder, NAME.hasp</source>
        <translation>Spara planen som en mapp, NAMN.hasp</translation>
    </message>
    <message>
        <source>Reading scan %1</source>
        <translation>Läser skanning %1</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Skapar exemplet</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>exempel %1</translation>
    </message>
    <message>
        <source>Begin with the sample</source>
        <translation>Börja med exemplet</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arkiv</translation>
    </message>
    <message>
        <source>&amp;New plan</source>
        <translation>&amp;Ny plan</translation>
    </message>
    <message>
        <source>&amp;Open a plan …</source>
        <translation>&amp;Öppna en plan …</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Öppna s&amp;enaste</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Spara so&amp;m …</translation>
    </message>
    <message>
        <source>&amp;Try it on a sample</source>
        <translation>&amp;Prova på ett exempel</translation>
    </message>
    <message>
        <source>A &amp;skull with a defect: a guide</source>
        <translation>Ett &amp;kranium med en defekt: en sågmall</translation>
    </message>
    <message>
        <source>A broken &amp;mandible: fragments, reduction, plate</source>
        <translation>En bruten &amp;underkäke: fragment, reposition, platta</translation>
    </message>
    <message>
        <source>A jaw and a &amp;fibula: cuts and a transplant</source>
        <translation>En käke och en &amp;fibula: snitt och ett transplantat</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avsluta</translation>
    </message>
    <message>
        <source>(no case label)</source>
        <translation>(ingen fallbeteckning)</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Ingen ännu</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigera</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Put the &amp;tool away</source>
        <translation>Lägg undan verk&amp;tyget</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visa</translation>
    </message>
    <message>
        <source>One view or &amp;four</source>
        <translation>En vy eller f&amp;yra</translation>
    </message>
    <message>
        <source>&amp;Crosshair</source>
        <translation>Hår&amp;kors</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Hel&amp;skärm</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mät</translation>
    </message>
    <message>
        <source>&amp;Distance: touch two places</source>
        <translation>&amp;Avstånd: peka på två ställen</translation>
    </message>
    <message>
        <source>&amp;Angle: touch three places</source>
        <translation>&amp;Vinkel: peka på tre ställen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjälp</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tangenter och mus</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;Om</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>What this scene uses</source>
        <translation>Vad scenen använder</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Research use only, not a medical device</source>
        <translation>Endast för forskning, inte en medicinteknisk produkt</translation>
    </message>
    <message>
        <source>%1[*] - Hasp planner</source>
        <translation>%1[*] - Hasp-planerare</translation>
    </message>
    <message>
        <source>New plan</source>
        <translation>Ny plan</translation>
    </message>
    <message>
        <source>The planner ended without saving, and what it kept cannot be read: it is damaged, or of a newer version.</source>
        <translation>Planeraren avslutades utan att spara, och det som den behöll går inte att läsa: det är skadat, eller av en nyare version.</translation>
    </message>
    <message>
        <source>The planner ended without saving. Case: %1. Actions not saved: %2.</source>
        <translation>Planeraren avslutades utan att spara. Fall: %1. Åtgärder som inte är sparade: %2.</translation>
    </message>
    <message>
        <source>Bring back what was not saved?</source>
        <translation>Återställa det som inte sparades?</translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation>&amp;Återställ</translation>
    </message>
    <message>
        <source>Ask &amp;later</source>
        <translation>Fråga &amp;senare</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Kasta</translation>
    </message>
    <message>
        <source>Brought back. Save the plan to keep it.</source>
        <translation>Återställt. Spara planen för att behålla det.</translation>
    </message>
    <message>
        <source>The last action was not finished: %1. Undo it if the plan is not as it should be.</source>
        <translation>Den sista åtgärden avslutades inte: %1. Ångra den om planen inte är som den ska.</translation>
    </message>
    <message>
        <source>Stereo: %1</source>
        <translation>Stereo: %1</translation>
    </message>
    <message>
        <source>&amp;Stereo</source>
        <translation>St&amp;ereo</translation>
    </message>
    <message>
        <source>Stereo se&amp;ttings …</source>
        <translation>Stereoinställnin&amp;gar …</translation>
    </message>
    <message>
        <source>Close all the same?</source>
        <translation>Stäng ändå?</translation>
    </message>
    <message>
        <source>The trial&apos;s plan is not saved.</source>
        <translation>Försökets plan är inte sparad.</translation>
    </message>
    <message>
        <source>The real CT is not here, so this is a generated phantom. The CT comes by Utilities/Scripts/cranium, or with Debian&apos;s invesalius-examples.</source>
        <translation>Den riktiga datortomografin finns inte här, så detta är ett genererat fantom. Utilities/Scripts/cranium hämtar den, eller så kommer den med Debians invesalius-examples.</translation>
    </message>
    <message>
        <source>Haptic &amp;device …</source>
        <translation>Haptisk en&amp;het …</translation>
    </message>
    <message>
        <source>A recorded hand is in the device&apos;s place.</source>
        <translation>En inspelad hand är i enhetens ställe.</translation>
    </message>
</context>
<context>
    <name>hasp::PlateBox</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Ny</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>platta</translation>
    </message>
    <message>
        <source>The plan has no fragments.</source>
        <translation>Planen har inga fragment.</translation>
    </message>
    <message>
        <source>&amp;Touch bone</source>
        <translation>&amp;Peka på benet</translation>
    </message>
    <message>
        <source>Touch bone along the middle of the plate, in order.</source>
        <translation>Peka på benet längs plattans mitt, i ordning.</translation>
    </message>
    <message>
        <source>Touch &amp;screws</source>
        <translation>Peka ut s&amp;kruvar</translation>
    </message>
    <message>
        <source>Touch bone where screws go through the plate.</source>
        <translation>Peka på benet där skruvar går genom plattan.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Skruvar</translation>
    </message>
    <message>
        <source>On</source>
        <translation>På</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>Gap to the bone</source>
        <translation>Avstånd till benet</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tjocklek</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Bevel</source>
        <translation>Fas</translation>
    </message>
    <message>
        <source>Bridge clefts to</source>
        <translation>Överbrygga springor till</translation>
    </message>
    <message>
        <source>Hole to edge</source>
        <translation>Hål till kant</translation>
    </message>
    <message>
        <source>Hole to hole</source>
        <translation>Hål till hål</translation>
    </message>
    <message>
        <source>Working grid</source>
        <translation>Arbetsrutnät</translation>
    </message>
    <message>
        <source>Bone from</source>
        <translation>Ben från</translation>
    </message>
    <message>
        <source>Ignore pieces below</source>
        <translation>Bortse från bitar under</translation>
    </message>
    <message>
        <source>Of the chosen screw; of all of them where none is chosen</source>
        <translation>För den valda skruven; för alla om ingen är vald</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Borrhål</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Skruvhuvud</translation>
    </message>
    <message>
        <source>Straight room for it</source>
        <translation>Rak försänkning</translation>
    </message>
    <message>
        <source>Cone below it</source>
        <translation>Kon under den</translation>
    </message>
    <message>
        <source>Length in bone</source>
        <translation>Längd i benet</translation>
    </message>
    <message>
        <source>Out of the bone along</source>
        <translation>Ut ur benet längs</translation>
    </message>
    <message>
        <source>Towards me</source>
        <translation>Mot mig</translation>
    </message>
    <message>
        <source>Upright on the plate</source>
        <translation>Vinkelrätt mot plattan</translation>
    </message>
    <message>
        <source>fragments, as planned</source>
        <translation>fragment, som planerat</translation>
    </message>
</context>
<context>
    <name>hasp::PlatePanel</name>
    <message>
        <source>What is planned</source>
        <translation>Vad som planeras</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Plattor</translation>
    </message>
    <message>
        <source>Implants</source>
        <translation>Implantat</translation>
    </message>
    <message>
        <source>Transplants</source>
        <translation>Transplantat</translation>
    </message>
    <message>
        <source>Saw guides for transplants</source>
        <translation>Geringsmallar för transplantat</translation>
    </message>
    <message>
        <source>Import a scan first.</source>
        <translation>Importera först en skanning.</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platta</translation>
    </message>
</context>
<context>
    <name>hasp::PointsEdit</name>
    <message>
        <source>Touch places in the views</source>
        <translation>Peka på ställen i vyerna</translation>
    </message>
    <message>
        <source>At the +</source>
        <translation>Vid +</translation>
    </message>
    <message>
        <source>A place at the crosshair</source>
        <translation>Ett ställe vid hårkorset</translation>
    </message>
    <message>
        <source>Remove the chosen place</source>
        <translation>Ta bort det valda stället</translation>
    </message>
    <message>
        <source>The chosen place sooner</source>
        <translation>Det valda stället tidigare</translation>
    </message>
    <message>
        <source>The chosen place later</source>
        <translation>Det valda stället senare</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z, mm</source>
        <translation>z, mm</translation>
    </message>
    <message>
        <source>A place is a number of millimetres, from -4000 to 4000.</source>
        <translation>Ett läge är ett antal millimeter, från -4000 till 4000.</translation>
    </message>
</context>
<context>
    <name>hasp::RecipeForm</name>
    <message>
        <source>%1 to %2%3</source>
        <translation>%1 till %2%3</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s left, back and head: three numbers</source>
        <translation>Mot patientens vänster, rygg och huvud: tre tal</translation>
    </message>
    <message>
        <source>A direction is three numbers that are not all 0: 0 0 1.</source>
        <translation>En riktning är tre tal som inte alla är 0: 0 0 1.</translation>
    </message>
</context>
<context>
    <name>hasp::ReducePanel</name>
    <message>
        <source>By hand</source>
        <translation>För hand</translation>
    </message>
    <message>
        <source>&amp;Grab</source>
        <translation>&amp;Greppa</translation>
    </message>
    <message>
        <source>&amp;Snap to fit</source>
        <translation>&amp;Snäpp på plats</translation>
    </message>
    <message>
        <source>Faces that broke apart attract each other</source>
        <translation>Ytor som brutits isär dras till varandra</translation>
    </message>
    <message>
        <source>Show for&amp;ces</source>
        <translation>Visa &amp;krafter</translation>
    </message>
    <message>
        <source>Show &amp;distances as colours</source>
        <translation>Visa avstån&amp;d som färger</translation>
    </message>
    <message>
        <source>Of the fragment in hand, or selected, to all others: −3 mm (inside) to 3 mm</source>
        <translation>Från fragmentet i handen, eller det valda, till alla andra: −3 mm (inuti) till 3 mm</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>Fragment</translation>
    </message>
    <message>
        <source>Grou&amp;p</source>
        <translation>Gru&amp;ppera</translation>
    </message>
    <message>
        <source>U&amp;ngroup</source>
        <translation>Lös &amp;upp</translation>
    </message>
    <message>
        <source>Take groups apart</source>
        <translation>Lös upp grupper</translation>
    </message>
    <message>
        <source>Stays: &amp;lock</source>
        <translation>Orörligt: &amp;lås</translation>
    </message>
    <message>
        <source>The reference, such as the cranium: it does not move</source>
        <translation>Referensen, till exempel kraniet: det rör sig inte</translation>
    </message>
    <message>
        <source>Lock or free fragments</source>
        <translation>Lås eller frigör fragment</translation>
    </message>
    <message>
        <source>Add the mirror &amp;image</source>
        <translation>Lägg till spegelb&amp;ilden</translation>
    </message>
    <message>
        <source>By themselves</source>
        <translation>Automatiskt</translation>
    </message>
    <message>
        <source>They are &amp;off by up to</source>
        <translation>De ligger &amp;fel med upp till</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>and tu&amp;rned by up to</source>
        <translation>och är vrid&amp;na upp till</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Find ho&amp;w they fit</source>
        <translation>Hitta hur de passar ih&amp;op</translation>
    </message>
    <message>
        <source>Make fragments first: paint them in the step Split, or import their labels.</source>
        <translation>Skapa först fragment: måla dem i steget Delning, eller importera deras etiketter.</translation>
    </message>
    <message>
        <source>There is one fragment alone: make another, or cut it.</source>
        <translation>Det finns bara ett fragment: skapa ett till, eller snitta det.</translation>
    </message>
    <message>
        <source>Nothing is felt: take Grab.</source>
        <translation>Inget känns: ta Greppa.</translation>
    </message>
    <message>
        <source>Nothing in hand: drag a fragment.</source>
        <translation>Inget i handen: dra ett fragment.</translation>
    </message>
    <message>
        <source>Preparing what is felt: %1 %</source>
        <translation>Förbereder det som känns: %1 %</translation>
    </message>
    <message>
        <source>Touches: %1 N, %2 mm deep.</source>
        <translation>Tar emot: %1 N, %2 mm djupt.</translation>
    </message>
    <message>
        <source>Pulled in by %1 N.</source>
        <translation>Dras in med %1 N.</translation>
    </message>
    <message>
        <source>Free: touches nothing.</source>
        <translation>Fritt: tar inte emot.</translation>
    </message>
    <message>
        <source>Finding how fragments fit</source>
        <translation>Söker hur fragment passar ihop</translation>
    </message>
    <message>
        <source>The plan has it: mirror %1. It is in the list of objects.</source>
        <translation>Planen har den: spegelbild %1. Den finns i objektlistan.</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Reposition</translation>
    </message>
</context>
<context>
    <name>hasp::ReductionProposals</name>
    <message>
        <source>group %1</source>
        <translation>grupp %1</translation>
    </message>
    <message>
        <source>fragment %1</source>
        <translation>fragment %1</translation>
    </message>
    <message>
        <source>%1 stays where it is</source>
        <translation>%1 ligger kvar där det är</translation>
    </message>
    <message>
        <source>%1 is not placed: no face is in its reach</source>
        <translation>%1 placeras inte: ingen yta finns inom räckhåll</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Förslag</translation>
    </message>
    <message>
        <source>Show in &amp;the view</source>
        <translation>F&amp;örhandsvisa i vyn</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>God&amp;ta</translation>
    </message>
    <message>
        <source>Fragments have changed while they were put together: do it again.</source>
        <translation>Fragment har ändrats medan de sattes ihop: gör om det.</translation>
    </message>
    <message>
        <source>No fragment has a face within reach of another&apos;s: move them nearer by hand first, or say how far they may be off.</source>
        <translation>Inget fragment har en yta inom räckhåll för ett annats: flytta dem först närmare för hand, eller ange hur fel de får ligga.</translation>
    </message>
    <message>
        <source>No unit that was placed is checked: there is nothing to take.</source>
        <translation>Ingen placerad enhet är markerad: det finns inget att godta.</translation>
    </message>
    <message>
        <source>Put fragments together</source>
        <translation>Sätt ihop fragment</translation>
    </message>
    <message>
        <source>wide and undecided: little holds it, look before you use it, and at the next one, too</source>
        <translation>osäkert och oavgjort: lite håller det på plats, granska det innan du använder det, och även nästa</translation>
    </message>
    <message>
        <source>wide: little holds it, look before you use it</source>
        <translation>osäkert: lite håller det på plats, granska innan du använder det</translation>
    </message>
    <message>
        <source>undecided: look at the next one, too</source>
        <translation>oavgjort: granska också nästa</translation>
    </message>
    <message>
        <source>placed</source>
        <translation>placerat</translation>
    </message>
    <message>
        <source>%1, %2.
At 95 % within %3 mm and %4°; turned %5°, faces %6 mm² at %7 mm</source>
        <translation>%1, %2.
Till 95 % inom %3 mm och %4°; vridet %5°, ytor %6 mm² på %7 mm</translation>
    </message>
    <message>
        <source>%1: %2 % likely, within %3 mm; %4 mm from where it was, faces %5 mm² at %6 mm</source>
        <translation>%1: %2 % sannolikt, inom %3 mm; %4 mm från där det var, ytor %5 mm² på %6 mm</translation>
    </message>
</context>
<context>
    <name>hasp::SliceView</name>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HU</translation>
    </message>
    <message>
        <source>grey %1</source>
        <translation>grått %1</translation>
    </message>
    <message>
        <source>W %1 L %2</source>
        <comment>window and level</comment>
        <translation>F %1 N %2</translation>
    </message>
</context>
<context>
    <name>hasp::SplitPanel</name>
    <message>
        <source>Bone</source>
        <translation>Ben</translation>
    </message>
    <message>
        <source>Fragments by painting</source>
        <translation>Fragment genom målning</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>Må&amp;la</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pensel</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>E&amp;raser</source>
        <translation>&amp;Suddgummi</translation>
    </message>
    <message>
        <source>Paint at the cros&amp;shair</source>
        <translation>Måla vid hår&amp;korset</translation>
    </message>
    <message>
        <source>sharing out bone: %p %</source>
        <translation>delar upp ben: %p %</translation>
    </message>
    <message>
        <source>Ma&amp;ke fragments</source>
        <translation>Skapa fragm&amp;ent</translation>
    </message>
    <message>
        <source>Split by the isovalue that is set &amp;now</source>
        <translation>Dela med isovärdet som är inställt n&amp;u</translation>
    </message>
    <message>
        <source>Fill its cav&amp;ities</source>
        <translation>Fyll dess hål&amp;igheter</translation>
    </message>
    <message>
        <source>Of the label that is chosen; shows when the fragments have been made.</source>
        <translation>För den valda etiketten; syns när fragmenten har skapats.</translation>
    </message>
    <message>
        <source>Fill cavities of label %1</source>
        <translation>Fyll håligheter i etikett %1</translation>
    </message>
    <message>
        <source>Close its &amp;gaps of</source>
        <translation>Slut &amp;dess glipor om</translation>
    </message>
    <message>
        <source>Of the label that is chosen: gaps that a ball of this radius does not go through; shows when the fragments have been made.</source>
        <translation>För den valda etiketten: glipor som en kula med denna radie inte går genom; syns när fragmenten har skapats.</translation>
    </message>
    <message>
        <source>Radius of gaps</source>
        <translation>Glipornas radie</translation>
    </message>
    <message>
        <source>Close gaps of label %1</source>
        <translation>Slut glipor i etikett %1</translation>
    </message>
    <message>
        <source>Import a scan first.</source>
        <translation>Importera först en skanning.</translation>
    </message>
    <message>
        <source>No scan is shown: show one, or locate it in the step Import.</source>
        <translation>Ingen skanning visas: visa en, eller hitta den i steget Import.</translation>
    </message>
    <message>
        <source>Split by another isovalue</source>
        <translation>Dela med ett annat isovärde</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Delning</translation>
    </message>
</context>
<context>
    <name>hasp::StartHint</name>
    <message>
        <source>Open a scan in the step Import, or drop a file or a folder here; without a scan of your own: File, Try it on a sample.</source>
        <translation>Öppna en skanning i steget Import, eller släpp en fil eller mapp här; utan egen skanning: Arkiv, Prova på ett exempel.</translation>
    </message>
</context>
<context>
    <name>hasp::StereoSettings</name>
    <message>
        <source>Anaglyph (red and cyan glasses)</source>
        <translation>Anaglyf (röda och cyanblå glasögon)</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Sida vid sida</translation>
    </message>
    <message>
        <source>Top and bottom</source>
        <translation>Över och under</translation>
    </message>
    <message>
        <source>Interlaced rows</source>
        <translation>Varannan rad</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Schackruta</translation>
    </message>
    <message>
        <source>One eye</source>
        <translation>Ett öga</translation>
    </message>
    <message>
        <source>Full: an eye has its own pixels</source>
        <translation>Full: ett öga har egna pixlar</translation>
    </message>
    <message>
        <source>Half: both share the window&apos;s</source>
        <translation>Halv: båda delar fönstrets</translation>
    </message>
    <message>
        <source>No mirror</source>
        <translation>Ingen spegel</translation>
    </message>
    <message>
        <source>Left and right changed over</source>
        <translation>Vänster och höger ombytta</translation>
    </message>
    <message>
        <source>Upside down (a mirror above hands)</source>
        <translation>Upp och ned (en spegel ovanför händerna)</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Båda</translation>
    </message>
    <message>
        <source>The head keeps still</source>
        <translation>Huvudet är stilla</translation>
    </message>
    <message>
        <source>The mouse moves the head</source>
        <translation>Musen rör huvudet</translation>
    </message>
    <message>
        <source>opentrack (listens on a port)</source>
        <translation>opentrack (lyssnar på en port)</translation>
    </message>
    <message>
        <source>A recording or a plugin:</source>
        <translation>En inspelning eller ett insticksprogram:</translation>
    </message>
    <message>
        <source>Change the eyes &amp;over</source>
        <translation>&amp;Byt plats på ögonen</translation>
    </message>
    <message>
        <source>&amp;Life size</source>
        <translation>&amp;Naturlig storlek</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Helskärm</translation>
    </message>
    <message>
        <source>The &amp;screen&apos;s size is known</source>
        <translation>&amp;Skärmens storlek är känd</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Stereo settings</source>
        <translation>Stereoinställningar</translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation>B&amp;ild</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>&amp;Upplösning</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>S&amp;pegel</translation>
    </message>
    <message>
        <source>Screen&apos;s &amp;width</source>
        <translation>Skärmens b&amp;redd</translation>
    </message>
    <message>
        <source>Screen&apos;s heigh&amp;t</source>
        <translation>Skärmens hö&amp;jd</translation>
    </message>
    <message>
        <source>Head to screen, &amp;distance</source>
        <translation>&amp;Avstånd från huvudet till skärmen</translation>
    </message>
    <message>
        <source>&amp;Eyes apart</source>
        <translation>Ö&amp;gonavstånd</translation>
    </message>
    <message>
        <source>&amp;Angle between the eyes, where no size is known</source>
        <translation>&amp;Vinkel mellan ögonen, när ingen storlek är känd</translation>
    </message>
    <message>
        <source>&amp;Head</source>
        <translation>Huvu&amp;d</translation>
    </message>
    <message>
        <source>File, or FILE.so:SETTINGS</source>
        <translation>Fil, eller FIL.so:INSTÄLLNINGAR</translation>
    </message>
    <message>
        <source>With the screen&apos;s size, a drawing of the desk.</source>
        <translation>Med skärmens storlek, en ritning av skrivbordet.</translation>
    </message>
</context>
<context>
    <name>hasp::StereoWindowWidget</name>
    <message>
        <source>Stereo - Hasp planner</source>
        <translation>Stereo - Hasp-planerare</translation>
    </message>
    <message>
        <source>The stereo window keeps its last picture: two eyes need a perspective view (5 in the 3D view).</source>
        <translation>Stereofönstret behåller sin senaste bild: två ögon behöver en perspektivvy (5 i 3D-vyn).</translation>
    </message>
</context>
<context>
    <name>hasp::StudyLog</name>
    <message>
        <source>What is done is missing in the trial&apos;s log: %1. Make room on the disk of the study&apos;s folder, and do the trial again.</source>
        <translation>Det som görs saknas i försökets logg: %1. Frigör utrymme på disken där studiens mapp ligger, och gör om försöket.</translation>
    </message>
    <message>
        <source>The trial&apos;s plan is not saved: %1. Make room on the disk of the study&apos;s folder, and finish again.</source>
        <translation>Försökets plan är inte sparad: %1. Frigör utrymme på disken där studiens mapp ligger, och avsluta på nytt.</translation>
    </message>
</context>
<context>
    <name>hasp::SusForm</name>
    <message>
        <source>I think that I would like to use this system frequently.</source>
        <translation>Jag tror att jag skulle vilja använda det här systemet ofta.</translation>
    </message>
    <message>
        <source>I found the system unnecessarily complex.</source>
        <translation>Jag tyckte att systemet var onödigt komplicerat.</translation>
    </message>
    <message>
        <source>I thought the system was easy to use.</source>
        <translation>Jag tyckte att systemet var lätt att använda.</translation>
    </message>
    <message>
        <source>I think that I would need the support of a technical person to be able to use this system.</source>
        <translation>Jag tror att jag skulle behöva hjälp av en tekniskt kunnig person för att kunna använda det här systemet.</translation>
    </message>
    <message>
        <source>I found the various functions in this system were well integrated.</source>
        <translation>Jag tyckte att de olika funktionerna i det här systemet var väl integrerade.</translation>
    </message>
    <message>
        <source>I thought there was too much inconsistency in this system.</source>
        <translation>Jag tyckte att det fanns för mycket inkonsekvens i det här systemet.</translation>
    </message>
    <message>
        <source>I would imagine that most people would learn to use this system very quickly.</source>
        <translation>Jag kan tänka mig att de flesta skulle lära sig att använda det här systemet mycket snabbt.</translation>
    </message>
    <message>
        <source>I found the system very cumbersome to use.</source>
        <translation>Jag tyckte att systemet var mycket besvärligt att använda.</translation>
    </message>
    <message>
        <source>I felt very confident using the system.</source>
        <translation>Jag kände mig mycket säker när jag använde systemet.</translation>
    </message>
    <message>
        <source>I needed to learn a lot of things before I could get going with this system.</source>
        <translation>Jag behövde lära mig en mängd saker innan jag kunde komma igång med det här systemet.</translation>
    </message>
    <message>
        <source>System Usability Scale</source>
        <translation>System Usability Scale</translation>
    </message>
    <message>
        <source>How far do you agree? Answer each statement at once, by what comes to your mind; where you cannot say, take the middle.</source>
        <translation>Hur väl instämmer du? Svara genast på varje påstående, med det som först faller dig in; ta mitten om du inte kan säga.</translation>
    </message>
    <message>
        <source>Strongly
disagree</source>
        <translation>Instämmer
inte alls</translation>
    </message>
    <message>
        <source>Strongly
agree</source>
        <translation>Instämmer
helt</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Statement %1: %2 of 5</source>
        <translation>Påstående %1: %2 av 5</translation>
    </message>
</context>
<context>
    <name>hasp::TouchButton</name>
    <message>
        <source>At the +</source>
        <translation>Vid +</translation>
    </message>
    <message>
        <source>The place at the crosshair</source>
        <translation>Stället vid hårkorset</translation>
    </message>
</context>
<context>
    <name>hasp::Tour</name>
    <message>
        <source>Back</source>
        <translation>Tillbaka</translation>
    </message>
    <message>
        <source>Ne&amp;xt</source>
        <translation>N&amp;ästa</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Lämna rundturen</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 av %2: %3</translation>
    </message>
    <message>
        <source>D&amp;one</source>
        <translation>&amp;Klar</translation>
    </message>
    <message>
        <source>This is the bone of the scan. Turn it with the left button, zoom with the wheel; a double click makes a view large. Ctrl+Z takes anything back. Press Next.</source>
        <translation>Det här är skanningens ben. Vrid det med vänster knapp, zooma med hjulet; ett dubbelklick gör en vy stor. Ctrl+Z tar tillbaka vad som helst. Tryck på Nästa.</translation>
    </message>
    <message>
        <source>Move the isovalue: what is at least so bright is bone. 226 HU is a usual choice. Press Next when the bone looks right.</source>
        <translation>Flytta isovärdet: det som är minst så ljust är ben. 226 HU är ett vanligt val. Tryck på Nästa när benet ser rätt ut.</translation>
    </message>
    <message>
        <source>Make all parts. Each is written, read back and measured: green holds what the recipe promises. Press Next when it is green.</source>
        <translation>Skapa alla delar. Var och en skrivs, läses tillbaka och mäts: grön uppfyller det som receptet lovar. Tryck på Nästa när den är grön.</translation>
    </message>
    <message>
        <source>Choose a folder and export. What is out of date cannot be exported. That is the whole way; Ctrl+S saves the plan.</source>
        <translation>Välj en mapp och exportera. Det som är inaktuellt kan inte exporteras. Det är hela vägen; Ctrl+S sparar planen.</translation>
    </message>
    <message>
        <source>Press New, then touch bone along the rim of the defect: three clicks or more.</source>
        <translation>Tryck på Ny, och peka på ben längs defektens kant: tre klick eller fler.</translation>
    </message>
    <message>
        <source>Sizes are at the left of their units; change what you like. Press Next.</source>
        <translation>Måtten står till vänster om sina enheter; ändra vad du vill. Tryck på Nästa.</translation>
    </message>
    <message>
        <source>Press Paint and draw a stroke on each piece, with another label for each; the bone falls apart while you paint.</source>
        <translation>Tryck på Måla och dra ett penseldrag på varje bit, med en egen etikett för var och en; benet delas medan du målar.</translation>
    </message>
    <message>
        <source>When each piece has its colour: Make fragments.</source>
        <translation>När varje bit har sin färg: Skapa fragment.</translation>
    </message>
    <message>
        <source>Lock the cranium in the list of objects, press Grab and drag a piece to where it belongs; with Snap-to-fit it is drawn to its place. Or let all be put together: Find how they fit.</source>
        <translation>Lås kraniet i objektlistan, tryck på Greppa och dra en bit dit den hör; med Snäpp på plats dras den till sin plats. Eller låt allt sättas ihop: Hitta hur de passar ihop.</translation>
    </message>
    <message>
        <source>Press New, then touch the bone along the plate&apos;s way over the fracture. Press Next when its line is right.</source>
        <translation>Tryck på Ny, och peka på benet längs plattans väg över frakturen. Tryck på Nästa när dess linje är rätt.</translation>
    </message>
    <message>
        <source>Touch the jaw in two places for a cut; press New, and do so for a second one. What is between them will be resected.</source>
        <translation>Peka på käken på två ställen för ett snitt; tryck på Nytt, och gör likadant för ett andra. Det som är mellan dem kommer att resekeras.</translation>
    </message>
    <message>
        <source>Keep the pieces, and resect the one in the middle.</source>
        <translation>Behåll bitarna, och resekera den i mitten.</translation>
    </message>
    <message>
        <source>Choose Transplants and press New; touch the places of the new jaw&apos;s line, and the two tips of the fibula.</source>
        <translation>Välj Transplantat och tryck på Nytt; peka ut den nya käkens linje, och fibulas båda ändar.</translation>
    </message>
    <message>
        <source>Choose Saw guides for transplants, and press New: the guide leads the saw on the fibula.</source>
        <translation>Välj Geringsmallar för transplantat, och tryck på Ny: mallen styr sågen på fibula.</translation>
    </message>
</context>
<context>
    <name>hasp::TransplantBox</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nytt</translation>
    </message>
    <message>
        <source>transplant</source>
        <translation>transplantat</translation>
    </message>
    <message>
        <source>&amp;Touch the path</source>
        <translation>&amp;Peka ut banan</translation>
    </message>
    <message>
        <source>Touch the new jaw&apos;s middle line, from stump to stump, with a place at each corner.</source>
        <translation>Peka ut den nya käkens mittlinje, från stump till stump, med ett ställe vid varje hörn.</translation>
    </message>
    <message>
        <source>Touch both ti&amp;ps</source>
        <translation>Peka ut bå&amp;da ändarna</translation>
    </message>
    <message>
        <source>Touch the two ends of the donor bone.</source>
        <translation>Peka på donatorbenets båda ändar.</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Kärl</translation>
    </message>
    <message>
        <source>Touch the vessel along the donor bone, in slices.</source>
        <translation>Peka ut kärlet längs donatorbenet, i snittbilder.</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Hud</translation>
    </message>
    <message>
        <source>Touch the outline of the skin that comes along, in order.</source>
        <translation>Peka ut konturen av huden som följer med, i ordning.</translation>
    </message>
    <message>
        <source>Its vessel</source>
        <translation>Dess kärl</translation>
    </message>
    <message>
        <source>Touch where the skin&apos;s vessel reaches the bone.</source>
        <translation>Peka där hudens kärl når benet.</translation>
    </message>
    <message>
        <source>Jaw</source>
        <translation>Käke</translation>
    </message>
    <message>
        <source>Donor</source>
        <translation>Donatorben</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Vävnad</translation>
    </message>
    <message>
        <source>Touch both tips of the donor bone first.</source>
        <translation>Peka först ut donatorbenets båda ändar.</translation>
    </message>
    <message>
        <source>Finding the middle line of fragment %1</source>
        <translation>Söker mittlinjen i fragment %1</translation>
    </message>
    <message>
        <source>Find the donor&apos;s middle line</source>
        <translation>Hitta donatorbenets mittlinje</translation>
    </message>
    <message>
        <source>Skin needs an outline of three places or more, and the place of its vessel.</source>
        <translation>Hud behöver en kontur med tre ställen eller fler, och stället för dess kärl.</translation>
    </message>
    <message>
        <source>A vessel needs two places or more.</source>
        <translation>Ett kärl behöver två ställen eller fler.</translation>
    </message>
    <message>
        <source>There is one scan only: import the donor&apos;s as a second one.</source>
        <translation>Det finns bara en skanning: importera donatorbenets som en andra.</translation>
    </message>
    <message>
        <source>Look at the &amp;jaw</source>
        <translation>Titta på kä&amp;ken</translation>
    </message>
    <message>
        <source>To its middle</source>
        <translation>Till mitten</translation>
    </message>
    <message>
        <source>Places that were touched on the bone&apos;s outside go into its middle</source>
        <translation>Ställen som pekades ut på benets utsida går in i dess mitt</translation>
    </message>
    <message>
        <source>Segment +</source>
        <translation>Segment +</translation>
    </message>
    <message>
        <source>Segment −</source>
        <translation>Segment −</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>Shortest segment</source>
        <translation>Kortaste segment</translation>
    </message>
    <message>
        <source>Gaps up to</source>
        <translation>Glipor upp till</translation>
    </message>
    <message>
        <source>Overlaps up to</source>
        <translation>Överlapp upp till</translation>
    </message>
    <message>
        <source>Begins at the face of</source>
        <translation>Börjar vid ytan av</translation>
    </message>
    <message>
        <source>of the stump</source>
        <translation>på stumpen</translation>
    </message>
    <message>
        <source>Ends at the face of</source>
        <translation>Slutar vid ytan av</translation>
    </message>
    <message>
        <source>Of segment</source>
        <translation>För segment</translation>
    </message>
    <message>
        <source>Its lateral side looks</source>
        <translation>Dess laterala sida vetter</translation>
    </message>
    <message>
        <source>Towards me</source>
        <translation>Mot mig</translation>
    </message>
    <message>
        <source>Turn it about its axis</source>
        <translation>Vrid det kring dess axel</translation>
    </message>
    <message>
        <source>Look at the d&amp;onor</source>
        <translation>Titta på d&amp;onatorbenet</translation>
    </message>
    <message>
        <source>Find &amp;its middle line</source>
        <translation>Hitta dess mittl&amp;inje</translation>
    </message>
    <message>
        <source>Touch its lateral &amp;side</source>
        <translation>P&amp;eka ut dess laterala sida</translation>
    </message>
    <message>
        <source>Touch the side of the donor bone that is known again in the defect.</source>
        <translation>Peka på den sida av donatorbenet som ska kännas igen i defekten.</translation>
    </message>
    <message>
        <source>Donor bone</source>
        <translation>Donatorben</translation>
    </message>
    <message>
        <source>Lateral side</source>
        <translation>Lateral sida</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radie</translation>
    </message>
    <message>
        <source>Stays at both tips</source>
        <translation>Lämnas kvar i båda ändar</translation>
    </message>
    <message>
        <source>Left over before</source>
        <translation>Spill före</translation>
    </message>
    <message>
        <source>From the second tip</source>
        <translation>Från den andra änden</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Sågspalt</translation>
    </message>
    <message>
        <source>Between segments</source>
        <translation>Mellan segment</translation>
    </message>
    <message>
        <source>The vessel along the donor, if it is to be followed:</source>
        <translation>Kärlet längs donatorbenet, om det ska följas:</translation>
    </message>
    <message>
        <source>Skin that comes along: its outline on the donor, three places or more, and where its vessel reaches the bone:</source>
        <translation>Hud som följer med: dess kontur på donatorbenet, tre ställen eller fler, och där dess kärl når benet:</translation>
    </message>
    <message>
        <source>none</source>
        <translation>inget</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alla</translation>
    </message>
    <message>
        <source>Its middle line has %1 places.</source>
        <translation>Dess mittlinje har %1 ställen.</translation>
    </message>
    <message>
        <source>Its middle line is straight, from tip to tip.</source>
        <translation>Dess mittlinje är rak, från ände till ände.</translation>
    </message>
    <message>
        <source>Touch both tips of the donor bone.</source>
        <translation>Peka ut donatorbenets båda ändar.</translation>
    </message>
    <message>
        <source>Segment %1: %2 mm, shortest side %3 mm, wedge %4°</source>
        <translation>Segment %1: %2 mm, kortaste sidan %3 mm, kil %4°</translation>
    </message>
</context>
<context>
    <name>hasp::UsePanel</name>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source>%1 KiB</source>
        <translation>%1 KiB</translation>
    </message>
    <message>
        <source>Resource</source>
        <translation>Resurs</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Byte</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Varför</translation>
    </message>
    <message>
        <source>What this scene uses</source>
        <translation>Vad scenen använder</translation>
    </message>
</context>
<context>
    <name>hasp::WorkflowBar</name>
    <message>
        <source>Workflow</source>
        <translation>Arbetsflöde</translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
</TS>
