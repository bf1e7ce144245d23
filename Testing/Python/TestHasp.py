"""import hasp, as its users meet it. Arguments: test cases, as for unittest; PYTHONPATH says which hasp."""
import math
import os
import pathlib
import tempfile
import unittest

import hasp
from LabelCases import Labels  # noqa: F401: unittest finds it here
from Shared import RADIUS, ball, errors_of
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkTable
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

HEIGHT = 200  # pixels
PARALLEL_SCALE = 12.0  # mm, half the height of the view


def scene(mapper):
    """A window of the mapper seen in parallel, white on black."""
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(1.0)  # lit everywhere
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(0, 0, 50)
    camera.SetParallelScale(PARALLEL_SCALE)
    camera.SetClippingRange(10, 90)
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(HEIGHT, HEIGHT)
    window.AddRenderer(renderer)
    return window, renderer


def lit_pixels(window):
    window.Render()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, HEIGHT - 1, HEIGHT - 1, 1, pixels, 0)
    return sum(pixels.GetValue(i) > 0 for i in range(0, 3 * HEIGHT * HEIGHT, 3))


class Package(unittest.TestCase):
    def test_is_the_one_on_the_path(self):
        self.assertEqual(pathlib.Path(hasp.__file__).resolve().parents[1],
                         pathlib.Path(os.environ["PYTHONPATH"]).resolve())

    def test_has_each_class_of_the_build(self):
        expected = os.environ["HASP_CLASSES"].split(",")
        self.assertEqual([c for c in expected if not hasattr(hasp, c)], [])

    def test_leaves_windows_alone_where_there_is_a_display(self):
        os.environ["DISPLAY"] = ":77"
        try:
            self.assertFalse(hasp.UseHeadlessWindows())
        finally:
            del os.environ["DISPLAY"]


class WithoutHeadlessWindows(unittest.TestCase):
    def test_says_so(self):
        with self.assertRaisesRegex(RuntimeError, "HASP_ENABLE_EGL"):
            hasp.UseHeadlessWindows()


class Isosurface(unittest.TestCase):
    def test_without_a_volume_is_an_error_and_draws_nothing(self):
        self.assertTrue(hasp.UseHeadlessWindows())
        mapper = hasp.vtkHaspClusteredCellMapper()
        said = errors_of(mapper)
        window, _ = scene(mapper)
        self.assertEqual(lit_pixels(window), 0)
        self.assertFalse(mapper.UpdateCells())
        self.assertTrue(said)

    def test_of_a_ball_fills_a_disc(self):
        hasp.UseHeadlessWindows()
        mapper = hasp.vtkHaspClusteredCellMapper()
        self.assertEqual(type(mapper).__name__, "vtkHaspOpenGLClusteredCellMapper")
        mapper.SetInputData(ball())
        mapper.SetIsoValue(0.0)
        window, _ = scene(mapper)
        pixels_per_mm = HEIGHT / (2 * PARALLEL_SCALE)
        disc = math.pi * (RADIUS * pixels_per_mm) ** 2
        # Trilinear cells of 1 mm cut at most h^2/4r = 0.03 mm off the ball: 0.6 % of the area. The
        # rim is 2 pi 75 pixels long, each on the right side of its centre.
        self.assertAlmostEqual(lit_pixels(window) / disc, 1.0, delta=0.008)
        mapper.SetIsoValue(100.0)  # outside the range: nothing, and no error
        said = errors_of(mapper)
        self.assertEqual(lit_pixels(window), 0)
        self.assertEqual(said, [])


    def test_picks_voxel_place_and_normal(self):
        mapper = hasp.vtkHaspClusteredCellMapper()
        mapper.SetInputData(ball())
        mapper.SetIsoValue(0.0)
        self.assertTrue(mapper.UpdateCells())
        picked = hasp.vtkHaspPickedCell()
        self.assertEqual(picked.GetCellId(), -1)
        start, end = (2.3, -1.4, 50.0), (2.3, -1.4, -50.0)
        self.assertTrue(mapper.PickFirstCell(start, end, picked))
        truth = (2.3, -1.4, math.sqrt(RADIUS ** 2 - 2.3 ** 2 - 1.4 ** 2))
        for told, true in zip(picked.GetPosition(), truth):
            self.assertAlmostEqual(told, true, delta=0.04)  # a cell of 1 mm is 0.03 off the ball
        for told, true in zip(picked.GetNormal(), truth):
            self.assertAlmostEqual(told, true / RADIUS, delta=0.1)
        z = picked.GetPosition()[2]
        self.assertEqual(picked.GetIJK(), (14, 10, 12 + int(z)))
        for told, true in zip(picked.GetPCoords(), (0.3, 0.6, z % 1.0)):
            self.assertAlmostEqual(told, true, delta=1e-5)
        self.assertAlmostEqual(picked.GetT(), (50.0 - z) / 100.0, delta=1e-6)
        self.assertEqual((picked.GetValue(), picked.GetLabel()), (0.0, 0))
        again = hasp.vtkHaspPickedCell()
        self.assertTrue(mapper.PickCell(picked.GetCellId(), start, end, again))
        self.assertEqual(again.GetPosition(), picked.GetPosition())
        self.assertFalse(mapper.PickFirstCell((20, 0, 50), (20, 0, -50), again))
        self.assertEqual(again.GetCellId(), picked.GetCellId())  # as it was

    def test_lists_what_it_holds_and_what_not(self):
        mapper = hasp.vtkHaspClusteredCellMapper()
        mapper.SetInputData(ball())
        mapper.SetIsoValue(0.0)
        self.assertTrue(mapper.UpdateCells())
        table = vtkTable()
        mapper.ListResources(table)
        rows = {table.GetValueByName(row, "resource").ToString(): row
                for row in range(table.GetNumberOfRows())}
        self.assertEqual(len(rows), table.GetNumberOfRows())
        def bytes_of(name):
            return table.GetValueByName(rows[name], "bytes").ToInt()
        def milliseconds_of(name):
            return table.GetValueByName(rows[name], "milliseconds").ToDouble()
        self.assertGreater(bytes_of("active cells, host"), 1000)
        self.assertGreater(milliseconds_of("active cells, host"), 0.0)
        self.assertEqual(bytes_of("active cells, GPU"), 0)
        self.assertEqual(table.GetValueByName(rows["active cells, GPU"], "reason").ToString(),
                         "nothing rasterised")


class Files(unittest.TestCase):
    def test_a_missing_file_is_an_error(self):
        reader = hasp.vtkHaspVolumeReader()
        reader.SetFileName("/nonexistent/head.mha")
        said = errors_of(reader)
        reader.Update()
        self.assertIn("the .mha file: there is no such file", "".join(said))
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 0)

    def test_a_volume_comes_back_as_written(self):
        image = ball()
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ball.mha")
            writer = hasp.vtkHaspVolumeWriter()
            writer.SetInputData(image)
            writer.SetFileName(path)
            self.assertEqual(writer.Write(), 1)
            reader = hasp.vtkHaspVolumeReader()
            reader.SetFileName(path)
            reader.Update()
        back = reader.GetOutput()
        self.assertEqual(back.GetDimensions(), image.GetDimensions())
        self.assertEqual([back.GetDirectionMatrix().GetElement(0, c) for c in range(3)], [0, -1, 0])
        for p in (0, 7812, 15624):
            self.assertEqual(back.GetPointData().GetScalars().GetValue(p),
                             image.GetPointData().GetScalars().GetValue(p))


class Cells(unittest.TestCase):
    def test_come_back_as_written(self):
        cells = hasp.vtkHaspClusteredCellFilter()
        cells.SetInputData(ball())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ball.hcells")
            writer = hasp.vtkHaspClusteredCellWriter()
            writer.SetInputConnection(cells.GetOutputPort())
            writer.SetFileName(path)
            self.assertEqual(writer.Write(), 1)
            reader = hasp.vtkHaspClusteredCellReader()
            reader.SetFileName(path)
            reader.Update()
        back = reader.GetOutput()
        self.assertGreater(back.GetNumberOfCells(), 1000)  # about one for each mm2: 4 pi 81
        self.assertEqual(back.GetNumberOfCells(), cells.GetOutput().GetNumberOfCells())
        bounds = [0.0] * 6
        back.GetBounds(bounds)
        self.assertEqual(bounds, [-12, 12] * 3)

    def test_a_missing_file_is_an_error(self):
        reader = hasp.vtkHaspClusteredCellReader()
        reader.SetFileName("/nonexistent/head.hcells")
        said = errors_of(reader)
        reader.Update()
        self.assertIn("the .hcells file: cannot be opened", "".join(said))
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), 0)


class Stereo(unittest.TestCase):
    def test_an_unknown_layout_is_an_error_and_changes_nothing(self):
        picture = hasp.vtkHaspStereoPicture()
        said = errors_of(picture)
        picture.SetLayoutName("sideways")
        self.assertIn("side-by-side", "".join(said))
        self.assertEqual(picture.GetLayoutName(), "side-by-side")

    def test_eyes_stand_side_by_side(self):
        hasp.UseHeadlessWindows()
        mapper = hasp.vtkHaspClusteredCellMapper()
        mapper.SetInputData(ball())
        mapper.SetIsoValue(0.0)
        _window, renderer = scene(mapper)
        renderer.GetActiveCamera().ParallelProjectionOff()
        picture = hasp.vtkHaspStereoPicture()
        picture.SetRenderer(renderer)
        image = vtkImageData()
        self.assertTrue(picture.RenderInto(image))
        self.assertEqual(image.GetDimensions(), (2 * HEIGHT, HEIGHT, 1))
        said = errors_of(picture)
        renderer.GetActiveCamera().ParallelProjectionOn()  # no eye
        self.assertFalse(picture.RenderInto(image))
        self.assertTrue(said)
        self.assertEqual(image.GetNumberOfPoints(), 0)

    def test_two_windows_show_one_scene(self):
        hasp.UseHeadlessWindows()
        mapper = hasp.vtkHaspClusteredCellMapper()
        mapper.SetInputData(ball())
        mapper.SetIsoValue(0.0)
        window, renderer = scene(mapper)
        renderer.GetActiveCamera().ParallelProjectionOff()
        windows = hasp.vtkHaspStereoWindows()
        windows.SetRenderer(renderer)
        other = window.NewInstance()
        other.SetOffScreenRendering(True)
        said = errors_of(windows)
        self.assertFalse(windows.AddWindow(other, "sideways"))
        self.assertIn("interlaced", "".join(said))
        self.assertTrue(windows.AddWindow(window, "mono"))
        self.assertTrue(windows.AddWindow(other, "interlaced"))
        self.assertEqual(windows.GetNumberOfWindows(), 2)
        self.assertTrue(windows.Render())
        eye, through = [0.0] * 3, [0.0] * 3
        self.assertTrue(windows.GetRay(other, 10, 10, eye, through))
        self.assertNotEqual(eye, through)
        windows.RemoveWindow(other)
        self.assertEqual(windows.GetNumberOfWindows(), 1)


class Guide(unittest.TestCase):
    def test_reads_recipes_and_reports_those_that_are_none(self):
        guide = hasp.vtkHaspGuideFilter()
        said = errors_of(guide)
        self.assertFalse(guide.ReadRecipe("/nonexistent/recipe.json"))
        self.assertIn("guide recipe: the file is not there", "".join(said))
        recipe = pathlib.Path(__file__).parents[2] / "Data/cranium-guide.json"
        self.assertTrue(guide.ReadRecipe(str(recipe)))


class ConeBeam(unittest.TestCase):
    def test_correction_leaves_what_is_even_and_what_is_outside(self):
        image = vtkImageData()
        image.SetExtent(2, 25, 0, 23, 0, 11)
        scalars = vtkFloatArray()
        for i in range(24 * 24 * 12):
            scalars.InsertNextValue(100.0 if 4 <= i % 24 < 20 else -900.0)
        image.GetPointData().SetScalars(scalars)
        correction = hasp.vtkHaspConeBeamCorrection()
        correction.SetInputData(image)
        correction.Update()
        corrected = correction.GetOutput()
        self.assertEqual(corrected.GetExtent(), image.GetExtent())
        for i in (3, 4, 12, 19, 20):
            self.assertAlmostEqual(corrected.GetPointData().GetScalars().GetValue(i), scalars.GetValue(i),
                                   delta=0.01)
        self.assertAlmostEqual(correction.GetAirLevel(), -900.0, delta=1.0)

    def test_without_a_patient_is_an_error(self):
        correction = hasp.vtkHaspConeBeamCorrection()
        correction.SetInputData(ball())  # at most 9
        correction.SetInsideAbove(10.0)
        said = errors_of(correction)
        correction.Update()
        self.assertIn("insideAbove", "".join(said))
        self.assertEqual(correction.GetOutput().GetNumberOfPoints(), 0)


class Distance(unittest.TestCase):
    """Bone that is sampled, less a shape that is not."""

    def test_a_saw_cuts_a_ball_in_two(self):
        distance = hasp.vtkHaspSignedDistance()
        distance.SetInputData(ball())
        distance.SetInputKindToGrey()
        distance.SetIsoValue(0.0)
        saw = hasp.vtkHaspSolidSource()
        self.assertTrue(saw.SetToSlab((0, 0, 0), (1, 0, 0), 2.0))
        cut = hasp.vtkHaspCsg()
        cut.SetOperationToDifference()
        cut.AddInputConnection(distance.GetOutputPort())
        cut.AddInputConnection(saw.GetOutputPort())
        contour = hasp.vtkHaspSharpContour()
        contour.SetInputConnection(cut.GetOutputPort())
        contour.Update()
        solid = cut.GetOutput()
        self.assertAlmostEqual(solid.EvaluateDistance((0, 0, 0)), 1.0, delta=1e-6)
        self.assertAlmostEqual(solid.EvaluateDistance((5, 0, 0)), -4.0, delta=0.05)
        mesh = contour.GetOutput()
        self.assertGreater(mesh.GetNumberOfCells(), 1000)
        nearest = min(abs(mesh.GetPoint(p)[0]) for p in range(mesh.GetNumberOfPoints()))
        self.assertAlmostEqual(nearest, 1.0, delta=1e-5)  # the walls of the kerf

    def test_what_is_no_shape_is_an_error(self):
        saw = hasp.vtkHaspSolidSource()
        said = errors_of(saw)
        self.assertFalse(saw.SetToSlab((0, 0, 0), (0, 0, 0), 2.0))
        self.assertTrue(said)


class Fragments(unittest.TestCase):
    """A ball that labels part into two halves."""

    def test_each_half_has_a_closed_surface(self):
        scan = ball()
        labels = vtkImageData()
        labels.CopyStructure(scan)
        labels.AllocateScalars(5, 1)  # VTK_UNSIGNED_SHORT
        for k in range(25):
            for j in range(25):
                for i in range(25):
                    labels.SetScalarComponentFromDouble(i, j, k, 0, 2 if i < 12 else 3)
        surface = hasp.vtkHaspFragmentSurface()
        surface.SetInputData(scan)
        surface.SetLabelData(labels)
        surface.SetIsoValue(0.0)
        surface.Update()
        both = surface.GetOutput()
        cells = both.GetNumberOfCells()  # now: the output is made anew in place
        self.assertEqual(both.GetCellData().GetArray("Label").GetRange(), (2.0, 3.0))
        surface.SetLabel(3)
        surface.Update()
        half = surface.GetOutput()
        self.assertLess(half.GetNumberOfCells(), cells)
        # The cut is half way between the voxels; at its rim it may be three quarters of a voxel off.
        cut = sorted(x for x, _, _ in map(half.GetPoint, range(half.GetNumberOfPoints())) if x < 0.5)
        self.assertAlmostEqual(cut[len(cut) // 2], -0.5, delta=0.05)
        self.assertGreater(cut[0], -0.5 - 0.75)
        self.assertAlmostEqual(half.GetBounds()[1], RADIUS, delta=0.1)
        said = errors_of(surface)
        surface.SetLabel(4)
        surface.Update()
        self.assertIn("label 4 is not in the label map", "".join(said))
        self.assertEqual(surface.GetOutput().GetNumberOfCells(), 0)


class PointShell(unittest.TestCase):
    """A vtkPolyData with normals drawn as discs, and a force."""

    def test_discs_cover_the_ball(self):
        ball_source = vtkSphereSource()
        ball_source.SetRadius(RADIUS)
        ball_source.SetThetaResolution(60)
        ball_source.SetPhiResolution(60)
        mapper = hasp.vtkHaspPointShellMapper()
        mapper.SetInputConnection(ball_source.GetOutputPort())
        self.assertEqual(mapper.GetNumberOfDiscs(), 60 * 58 + 2)
        hasp.UseHeadlessWindows()
        window, _ = scene(mapper)
        lit = lit_pixels(window)
        pixels_per_mm = HEIGHT / (2 * PARALLEL_SCALE)
        self.assertAlmostEqual(lit / (math.pi * (RADIUS * pixels_per_mm) ** 2), 1.0, delta=0.03)

    def test_forces_are_as_long_as_they_are_strong(self):
        at = vtkPoints()
        at.InsertNextPoint(0, 0, 0)
        forces = vtkFloatArray()
        forces.SetNumberOfComponents(3)
        forces.InsertNextTuple3(2, 0, 0)
        arrows = hasp.vtkHaspForceArrows()
        arrows.SetMmPerNewton(3.0)
        arrows.SetArrows(at, forces)
        self.assertAlmostEqual(arrows.GetBounds()[1], 6.0, places=5)


if __name__ == "__main__":
    unittest.main()
