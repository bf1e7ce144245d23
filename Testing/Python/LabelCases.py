"""Label maps and their files, from Python."""
import os
import tempfile
import unittest

import hasp
from LabelFile import LABELS, NAME, label_image, parse_segmentation
from Shared import ball, errors_of


class Labels(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "jaw.seg.nrrd")

    def write(self, image, compress=True):
        writer = hasp.vtkHaspSegmentationWriter()
        writer.SetInputData(image)
        writer.SetFileName(self.path)
        writer.SetCompress(compress)
        self.said = errors_of(writer)
        return writer.Write()

    def test_a_file_is_what_slicer_reads(self):
        for compress in (True, False):
            self.assertEqual(self.write(label_image(LABELS), compress), 1)
            fields, pairs, samples = parse_segmentation(self.path)
            self.assertEqual(samples, LABELS)
            self.assertEqual(fields["encoding"], "gzip" if compress else "raw")
            self.assertEqual(fields["type"], "uint16")
            self.assertEqual(fields["space"], "left-posterior-superior")
            self.assertEqual(fields["space origin"], "(-10.5,20.25,3)")
            # Slicer reads segments until an ID is missing, and cuts all to the extent of the first.
            self.assertEqual([n for n in range(9) if f"Segment{n}_ID" in pairs], [0, 1, 2])
            self.assertEqual({pairs[f"Segment{n}_Extent"] for n in range(3)}, {"1 2 0 1 0 1"})
            self.assertEqual([pairs[f"Segment{n}_LabelValue"] for n in range(3)], ["65535", "2", "9"])
            self.assertEqual([pairs[f"Segment{n}_Name"] for n in range(3)], [NAME, "two", "Fragment 9"])
            self.assertEqual([round(255 * float(c)) for c in pairs["Segment0_Color"].split(" ")],
                             [255, 128, 0])
            # Nobody said that the first is of bone.
            tags = [dict(t.split(":", 1) for t in pairs[f"Segment{n}_Tags"].split("|") if t)
                    for n in range(3)]
            self.assertNotIn("TerminologyEntry", tags[0])
            entry = tags[2]["TerminologyEntry"].split("~")
            self.assertEqual(len(entry), 7)
            self.assertEqual(entry[2].split("^"), ["SCT", "272673000", "Bone"])

    def test_labels_and_names_come_back(self):
        self.assertEqual(self.write(label_image(LABELS)), 1)
        reader = hasp.vtkHaspSegmentationReader()
        reader.SetFileName(self.path)
        reader.SetInputData(label_image([0] * 12))
        reader.Update()
        back = reader.GetOutput()
        scalars, fields = back.GetPointData().GetScalars(), back.GetFieldData()
        self.assertEqual([scalars.GetValue(p) for p in range(12)], LABELS)
        names = fields.GetAbstractArray("LabelNames")
        self.assertEqual([names.GetValue(n) for n in range(3)], [NAME, "two", "Fragment 9"])
        self.assertEqual(fields.GetArray("LabelColors").GetTuple3(0), (255, 128, 0))

    def test_a_name_with_a_tab_is_an_error_and_leaves_no_file(self):
        image = label_image(LABELS)
        image.GetFieldData().GetAbstractArray("LabelNames").SetValue(0, "a\tb")
        self.assertEqual(self.write(image), 0)
        self.assertIn("control character", "".join(self.said))
        self.assertEqual(os.listdir(os.path.dirname(self.path)), [])

    def test_a_scan_is_no_label_map(self):
        writer = hasp.vtkHaspVolumeWriter()
        writer.SetInputData(ball())
        self.path = self.path.replace(".seg.nrrd", ".mha")
        writer.SetFileName(self.path)
        self.assertEqual(writer.Write(), 1)
        reader = hasp.vtkHaspSegmentationReader()
        reader.SetFileName(self.path)
        said = errors_of(reader)
        reader.Update()
        self.assertIn("the .mha file: holds samples in floating point", "".join(said))

    def test_a_recipe_makes_labels_of_a_scan(self):
        recipe = os.path.join(os.path.dirname(self.path), "recipe.json")
        with open(recipe, "w", encoding="utf-8") as file:
            file.write("""{ "format": "hasp-segmentation-1", "steps": [
                { "step": "threshold", "lowest": 0, "highest": 1000000, "smoothMm": 0 } ],
                "names": [{ "label": 1, "name": "ball", "colour": "#ff8000" }] }""")
        segmentation = hasp.vtkHaspSegmentationFilter()
        segmentation.SetInputData(ball())
        self.assertTrue(segmentation.ReadRecipe(recipe))
        segmentation.Update()
        image = segmentation.GetOutput()
        scan, labels = (i.GetPointData().GetScalars() for i in (ball(), image))
        self.assertEqual([labels.GetValue(p) for p in range(labels.GetNumberOfValues())],
                         [int(scan.GetTuple1(p) >= 0) for p in range(scan.GetNumberOfTuples())])
        self.assertEqual(image.GetFieldData().GetAbstractArray("LabelNames").GetValue(0), "ball")
        said = errors_of(segmentation)
        for tolerance in (0, 0.2, float("nan")):
            segmentation.SetTolerance(tolerance)
            segmentation.Update()
            self.assertIn("must be in (0, 0.1]", said.pop())
            self.assertEqual(segmentation.GetOutput().GetNumberOfPoints(), 0)
        segmentation.SetTolerance(0.01)
        segmentation.Update()
        self.assertGreater(segmentation.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(said, [])
        self.assertFalse(segmentation.ReadRecipe(recipe + ".none"))
        self.assertEqual(len(said), 1)
        self.assertNotIn("recipe.json", "".join(said))
