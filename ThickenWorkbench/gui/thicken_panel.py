# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Thicken task panel: makes features, or edits one.

Nothing is written to the document before OK. Then the solids are computed in another thread, and only
when all of them are there, lines of Python that a macro can repeat make the features; the recompute
takes the solids that are there already. So a cancelled run leaves no trace, and undo is one step.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Callable

import FreeCAD as App
import FreeCADGui as Gui

from .. import build, numbers, prediction, preferences, runs
from ..core import precomputed
from thicken.arrays import ThickenedMesh, size_of, thicken_mesh
from ..part_solid import part_solid_of, size_warning
from ..sources import DEFAULT_DEFLECTION, RefusedError
from ..thickness_regions import ThicknessField
from . import macro, messages
from .camera import view_of
from .chosen import Chosen, is_mesh, is_shape
from .feature_inputs import changes, in_mm, inputs_of
from .job import Job
from .looks import Looks
from .panel import Panel
from .preview import Preview
from .region_picker import RegionPicker
from .side_arrow import SideArrow
from .surfaces import arguments_of, surface_of
from .thicken_form import OUTPUTS, ThickenForm

translate = App.Qt.translate


class ThickenPanel(Panel):
    """With `feature`, that one is edited."""

    buttons = ("Ok", "Cancel")

    def __init__(self, chosen: list[Chosen], feature: Any = None) -> None:
        self.chosen, self.feature = chosen, feature
        self.document = chosen[0].source.Document
        self.objects = [item.source for item in chosen] + ([feature] if feature is not None else [])
        view = view_of(self.document)
        of_shape = any(is_shape(item.source) for item in chosen)
        self._read_surfaces(DEFAULT_DEFLECTION if feature is None else feature.Deflection.Value)
        share = preferences.get("ThicknessPercent") / 100
        start = build.suggested_thickness(chosen[0].source, share) if feature is None else feature.Thickness.Value
        self.form_parts = ThickenForm(
            self._title(), start, of_shape=of_shape, of_mesh=self._can_pick(), edits=feature is not None,
            changed=self._edited, stop=self._stop,
        )  # fmt: skip
        self.form = self.form_parts.widget
        self._show_start()
        self._open_transaction()
        self._looks = Looks([feature] if feature is not None else [], [item.source for item in chosen])
        Gui.Selection.clearSelection()  # its colour would hide those of the preview
        self._arrow = SideArrow(chosen[0].source, view, *self._surfaces[0], self._flip)
        self._picker: RegionPicker | None = None
        self._preview = Preview([item.source for item in chosen], self._previewed)
        self.form_parts.pick.toggled.connect(self._pick)
        self.form_parts.sharpest.valueChanged.connect(self._sharpen)
        self.form_parts.whole.clicked.connect(lambda: self._choose(()))
        self.form_parts.show_region(bool(chosen[0].facets))
        self._edited()

    # --- what FreeCAD calls ---

    def accept(self) -> bool:
        """Take the previewed solids, or compute; the panel closes itself once the features are made."""
        if self._job is None and self._inputs_make_sense():
            self.form_parts.pick.setChecked(False)
            solids = self._preview.solids()
            if solids is not None:
                self._take(solids)
            else:
                self._preview.cancel()
                self._compute()
        return False

    # --- before OK ---

    def _read_surfaces(self, deflection: float) -> None:
        self._deflection = deflection
        self._surfaces = [surface_of(item, deflection) for item in self.chosen]
        self._sizes = [size_of(*surface) for surface in self._surfaces]
        self._field: ThicknessField | None = None
        self._triangles = sum(size.triangles for size in self._sizes)

    def _flip(self) -> None:
        """A click on the arrow; while a region is picked, clicks mean the mesh."""
        if self._picker is None and self._job is None:
            self.form_parts.flip_side()

    def _can_pick(self) -> bool:
        return len(self.chosen) == 1 and is_mesh(self.chosen[0].source)

    def _pick(self, on: bool) -> None:
        """Let clicks in the view choose facets; the preview gives way to them."""
        self.form_parts.show_picking(on)
        if on:
            self._preview.cancel()
            self._preview.hide()
            item = self.chosen[0]
            self._picker = RegionPicker(item.source, item.facets, self._choose)
            self._sharpen(self.form_parts.sharpest.value())
            self.form_parts.tell(
                translate("Thicken", "Click on the mesh; click “Pick a region” again to see the preview.")
            )
        elif self._picker is not None:
            self._picker.stop()
            self._picker = None
            self._edited()

    def _sharpen(self, degrees: int) -> None:
        if self._picker is not None:
            self._picker.sharpest = float(degrees)

    def _choose(self, facets: tuple[int, ...]) -> None:
        """Thicken these facets, or all of them when there is none."""
        if not facets and self._picker is not None and self.chosen[0].facets:
            self.chosen = [Chosen(self.chosen[0].source)]
            self._picker.clear()
        self.chosen = [Chosen(self.chosen[0].source, facets=facets)]
        self._read_surfaces(self._deflection)
        self.form_parts.title.setText(self._title())
        self.form_parts.show_region(bool(facets))
        self._arrow.move(*self._surfaces[0])
        self._edited()

    def _title(self) -> str:
        quoted = translate("Thicken", "“{label}”")
        names = ", ".join(quoted.format(label=item.source.Label) for item in self.chosen[:3])
        more = "" if len(self.chosen) <= 3 else " …"
        count = translate("Thicken", "{count} triangles").format(count=numbers.count(self._triangles))
        return f"{names}{more}: {count}"

    def _show_start(self) -> None:
        if self.feature is not None:
            self.form_parts.set_inputs(inputs_of(self.feature))
            self.form_parts.output.setCurrentIndex(0 if part_solid_of(self.feature) is None else 1)
            return
        self.form_parts.start_with(preferences.get("Side"), preferences.get("Output"))

    def _open_transaction(self) -> None:
        """So that Cancel takes back what an expression did, which FreeCAD's own field sets at once."""
        if self.feature is not None:
            self.document.openTransaction(translate("Thicken", "Edit thickening"))
            self._bound = self.feature
        else:
            self.document.openTransaction(translate("Thicken", "Thicken"))
            self._bound = self.document.addObject("App::FeaturePython", "ThickenInputs")
            self._bound.addProperty("App::PropertyLength", "Thickness")
            self._bound.Thickness = self.form_parts.inputs()["thickness"]
            self._bound.ViewObject.ShowInTree = False
        self._expression = _expression_of(self._bound)
        Gui.ExpressionBinding(self.form_parts.thickness).bind(self._bound, "Thickness")

    def _edited(self) -> None:
        parts = self.form_parts
        inputs = parts.inputs()
        if inputs["deflection"] and inputs["deflection"] != self._deflection:
            self._read_surfaces(inputs["deflection"])
        self._show_forecast(self._forecast(inputs))
        self._arrow.show(inputs["side"], inputs["thickness"])
        self._preview.cancel()
        if self._picker is not None:
            return
        if not parts.preview.isChecked():
            self._preview.hide()
            parts.tell("")
        elif self._inputs_make_sense():
            if self._triangles > preferences.get("PreviewTriangles"):
                parts.tell(translate("Thicken", "Too many triangles for a preview."))
                return
            parts.tell(translate("Thicken", "Preview: computing …"))
            self._preview.request(self._runs())
        else:
            self._preview.hide()

    def _forecast(self, inputs: dict[str, Any]) -> str:
        if not inputs["thickness"] > 0:
            return ""
        arguments = {**arguments_of(inputs), "threads": runs.threads()}
        seconds, memory = prediction.forecast(self._sizes, arguments).sentence()
        text = translate("Thicken", "OK will take about {seconds} and {memory} of memory.")
        return text.format(seconds=seconds, memory=memory)

    def _show_forecast(self, text: str) -> None:
        told = [text, self._question_of_unit(), self._warning_of_size()]
        self.form_parts.forecast.setText("\n".join(filter(None, told)))

    def _warning_of_size(self) -> str:
        """What Part will make of a large solid: the previewed one, or one with about as many new triangles."""
        if self.form_parts.output_word() == OUTPUTS[0]:
            return ""
        solids = self._preview.solids()
        return size_warning(2 * self._triangles if solids is None else sum(len(solid.triangles) for solid in solids))

    def _question_of_unit(self) -> str:
        """Whether the surface is in another unit, where it is hardly in millimetres."""
        for item in self.chosen:
            unit = build.likely_unit(item.source)
            if unit is not None:
                ask = translate(
                    "Thicken", "“{label}” is {length} mm long. Is it in {unit}? Then scale it first: lengths here are mm."
                )
                length = numbers.number(build.diagonal(item.source))
                return ask.format(label=item.source.Label, length=length, unit=unit)
        return ""

    def _inputs_make_sense(self) -> bool:
        inputs = self.form_parts.inputs()
        if inputs["deflection"] is not None and not inputs["deflection"] > 0:
            self.form_parts.tell(translate("Thicken", "Set a deflection above 0 mm."), bad=True)
            return False
        if not inputs["thickness"] > 0:
            self.form_parts.tell(translate("Thicken", "Set a thickness above 0 mm."), bad=True)
            return False
        try:
            self._find_regions()
        except RefusedError as error:
            self.form_parts.tell(str(error), bad=True)
            return False
        return True

    def _find_regions(self) -> None:
        """The thickness regions of the feature that is edited, on the surface as it is now."""
        if self.feature is not None and self._field is None:
            self._field = ThicknessField(self.feature, self._surfaces[0])

    def _runs(self) -> list[tuple[Any, dict[str, Any]]]:
        inputs = self.form_parts.inputs()
        if self._field is not None:
            inputs["thickness"] = self._field.values(inputs["thickness"])
        arguments = arguments_of(inputs)
        return [(surface, arguments) for surface in self._surfaces]

    def _previewed(self, solids: list[ThickenedMesh], error: BaseException | None) -> None:
        if error is not None:
            self.form_parts.tell(self._advice(error), bad=True)
            return
        self._learn(solids)
        lines = [translate("Thicken", "Preview: {numbers}.").format(numbers=messages.numbers(s)) for s in solids]
        self._show_forecast(translate("Thicken", "OK makes this solid at once."))
        lines += [messages.warning(w) for s in solids for w in s.report["warnings"]]
        lines += self._field.notes if self._field is not None else []
        self.form_parts.tell("\n".join(lines))

    def _advice(self, error: BaseException) -> str:
        """What an error says, where in the document, and what of this workbench helps."""
        defects = getattr(error, "defects", ())
        if not defects:
            return messages.sentences(error)
        text = runs.sentences(error, self.chosen[0].source) if len(self.chosen) == 1 else messages.sentences(error)
        helps = translate("Thicken", "“Check Surface” marks the places; “Repair a defective surface first” above mends them.")
        return f"{text}\n{helps}"

    def _learn(self, solids: list[ThickenedMesh]) -> None:
        arguments = {**arguments_of(self.form_parts.inputs()), "threads": runs.threads()}
        for size, solid in zip(self._sizes, solids):
            prediction.learn(size, arguments, solid.report["seconds"]["total"])

    # --- after OK ---

    def _compute(self) -> None:
        def step(surface: Any, arguments: dict[str, Any]) -> Callable[[Any], ThickenedMesh]:
            return lambda context: thicken_mesh(*surface, **arguments, **limits, context=context)

        limits = {"threads": runs.threads(), "memory": runs.memory()}
        self.form_parts.show_running(True)
        self.form_parts.tell(translate("Thicken", "Computing …"))
        self._job = Job([step(*run) for run in self._runs()], self._computed, self.form_parts.run_row.progressed).start()

    def _stop(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self.form_parts.tell(translate("Thicken", "Stopping …"))

    def _computed(self, job: Job) -> None:
        self._job = None
        self.form_parts.show_running(False)
        if job.cancelled or messages.was_cancelled(job.error):
            self.form_parts.tell(translate("Thicken", "Stopped. The document is as it was."))
        elif job.error is not None:
            self.form_parts.tell(self._advice(job.error), bad=True)
        else:
            self._learn(job.results)
            self._take(job.results)

    def _take(self, solids: list[ThickenedMesh]) -> None:
        """Make the features with solids that are there already."""
        for run, solid in zip(self._runs(), solids):
            precomputed.offer(*run, solid)
        try:
            self._commit()
        finally:
            precomputed.withdraw()

    def _commit(self) -> None:
        """Make the features by lines that a macro can repeat, as one step of undo."""
        lines = self._edit_lines() if self.feature is not None else self._make_lines()
        self.close()
        self.document.openTransaction(translate("Thicken", "Thicken"))
        for line in lines:
            macro.run(line)
        self.document.commitTransaction()
        if Gui.Control.activeDialog():
            Gui.Control.closeDialog()

    def _make_lines(self) -> list[str]:
        inputs = self.form_parts.inputs()
        inputs["thickness"] = in_mm(inputs["thickness"])
        given = {name: value for name, value in inputs.items() if value is not None and value is not False}
        if self.form_parts.output_word() != OUTPUTS[0]:
            given["output"] = self.form_parts.output_word()
        lines = []
        for item in self.chosen:
            made = macro.call("make_thicken", macro.Text(macro.DOCUMENT), item.source, **item.named(), **given)
            lines.append(f"thicken = {made}")
            if self.form_parts.expression():
                lines.append(f"thicken.setExpression('Thickness', {self.form_parts.expression()!r})")
                lines.append(f"{macro.DOCUMENT}.recompute()")
        return lines

    def _edit_lines(self) -> list[str]:
        reference = macro.reference(self.feature)
        lines = []
        before, after = inputs_of(self.feature), self.form_parts.inputs()
        facets = list(self.chosen[0].facets)
        if is_mesh(self.feature.Source) and facets != list(self.feature.Facets):
            lines.append(f"{reference}.Facets = {facets!r}")
        expression = self.form_parts.expression()
        if expression != self._expression:
            lines.append(f"{reference}.setExpression('Thickness', {expression or None!r})")
        for name, value in changes(before, after):
            if name != "Thickness" or not expression:
                lines.append(f"{reference}.{name} = {value!r}")
        return [*lines, f"{macro.DOCUMENT}.recompute()"]

    def forget_runs(self) -> None:
        super().forget_runs()
        self._preview.cancel()

    def leave_view(self) -> None:
        """Take away all that is drawn over the objects."""
        if self._picker is not None:
            self._picker.stop()
            self._picker = None
        self._preview.remove()
        self._arrow.remove()

    def close(self) -> None:
        """Leave nothing behind: neither in the view nor in the document."""
        if self._closed:
            return
        self._closed = True
        if self._job is not None:
            self._job.abandon()
        self.leave_view()
        self._looks.restore()
        with suppress(ReferenceError, RuntimeError, NameError):  # the document was closed in the meantime
            if self.feature is None:
                self.document.removeObject(self._bound.Name)
            self.document.abortTransaction()
            gui = Gui.getDocument(self.document.Name)
            if self.feature is not None and gui.getInEdit():
                gui.resetEdit()


def _expression_of(obj: Any) -> str:
    return dict((path, text) for path, text, *_ in obj.ExpressionEngine).get("Thickness", "")
