# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is computed beside documents: nothing of a step touches one, and all of it obeys the user's limits."""

import threading
import time
from unittest import mock

import FreeCAD as App

import ThickenWorkbench
from thicken import native
from ThickenWorkbench import preferences, runs
from ThickenWorkbench.check_surface import check_step
from ThickenWorkbench.drain_holes import drill_step
from ThickenWorkbench.export import export_step
from ThickenWorkbench.printability import report_step
from ThickenWorkbench.report_page import write_measured
from ThickenWorkbench.repair_feature import Joins, repair_step
from ThickenWorkbench.sources import RefusedError
from ThickenWorkbench.thickness_map import map_step
from thicken_case import DocumentCase
from thicken_surfaces import crossing_plates, plate, together
from test_thicken_part_solid import box


class Steps(DocumentCase):
    def setUp(self):
        super().setUp()
        self.surface = self.add_source(crossing_plates(), "Crossing")
        hollow = together(box((0, 0, 0), (20, 20, 20)), box((2, 2, 2), (18, 18, 18), inward=True))
        self.solid = self.add_source(hollow, "Hollow")
        self.feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate(), "Plate"), 1)

    def makers(self):
        up = App.Vector(0, 0, 1)
        return {
            "check": lambda: check_step(self.surface),
            "repair": lambda: repair_step(self.surface, Joins(None)),
            "wall": lambda: map_step(self.solid),
            "deviation": lambda: map_step(self.feature, "deviation"),
            "report": lambda: report_step(self.solid),
            "holes": lambda: drill_step(self.solid, 3.0, 1, up, []),
            "places": lambda: drill_step(self.solid, 3.0, 1, up, [(10, 10, 0)]),
            "export": lambda: export_step(self.solid, self.folder / "solid.stl"),
        }

    def test_nothing_of_them_is_read_from_the_document(self):
        steps = {name: make() for name, make in self.makers().items()}
        App.closeDocument(self.doc.Name)
        results = {}

        def work():
            for name, step in steps.items():
                with runs.started() as context:
                    results[name] = step(context)

        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
        self.assertEqual(set(results), set(steps))
        self.assertEqual(results["check"][0].code, "self-intersecting")
        self.assertGreater(results["repair"].report["removed_triangles"], 0)
        self.assertAlmostEqual(results["wall"].minimum, 2, places=5)
        self.assertAlmostEqual(results["deviation"].maximum, 0, places=5)
        self.assertAlmostEqual(results["report"].facts["trapped_volume_ml"], 4.096, places=3)
        self.assertEqual((len(results["holes"].holes), len(results["places"].holes)), (1, 1))
        self.assertTrue((self.folder / "solid.stl").is_file())

    def test_all_of_them_can_be_cancelled(self):
        extension = native.load()
        for name, make in self.makers().items():
            with self.subTest(name):
                context = extension.RunContext()
                context.cancel()
                with self.assertRaises(extension.ThickenError) as caught:
                    make()(context)
                self.assertEqual(caught.exception.code, "cancelled")

    def test_a_report_is_not_written_once_it_is_cancelled(self):
        with runs.started() as context:
            found = report_step(self.solid)(context)
            context.cancel()
            with self.assertRaises(runs.CancelledError):
                write_measured(found, self.folder / "solid.html", context)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_all_of_them_obey_the_memory_limit(self):
        self.addCleanup(preferences.put, "MemoryMiB", 0)
        preferences.put("MemoryMiB", 1)
        for name, make in self.makers().items():
            with self.subTest(name), self.assertRaisesRegex(RefusedError, "the preferences allow 1 MiB"):
                make()

    def test_threads_are_those_of_the_preferences(self):
        self.addCleanup(preferences.put, "Threads", 0)
        preferences.put("Threads", 3)
        extension = native.load()
        for function, name in (("check", "check"), ("wall_thickness", "wall"), ("inspect", "report"), ("drill", "holes"),
                               ("repair_mesh", "repair")):  # fmt: skip
            with self.subTest(name):
                real = getattr(extension, function)
                with mock.patch.object(extension, function, side_effect=real) as called, runs.started() as context:
                    self.makers()[name]()(context)
                self.assertEqual(called.call_args.kwargs["threads"], 3)


class AnotherThread(DocumentCase):
    """A FreeCAD that recomputes beside its windows calls execute() in a thread of its own."""

    def test_a_recompute_is_stopped_from_the_main_thread(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate()), 1)
        self.doc.getObject("Scan").Mesh = self.add_source(plate(n=350), "Large").Mesh
        errors = []

        def work():
            try:
                feature.Proxy.execute(feature)
            except RefusedError as error:
                errors.append(error)

        thread = threading.Thread(target=work)
        thread.start()
        while not runs.any_running():
            self.assertTrue(thread.is_alive(), "the recompute ended before it could be stopped")
            time.sleep(0.001)
        runs.cancel_all()
        thread.join()
        self.assertEqual(len(errors), 1)
        self.assertIn("ancelled", str(errors[0]))
        self.assertFalse(runs.any_running())
        self.assertEqual(feature.Mesh.CountFacets, 0)
