# SPDX-License-Identifier: MIT
"""What the figures of ./run bench mean: which there must be, what is to be compared, and the limits."""

from __future__ import annotations

import math
import statistics
from collections.abc import Mapping, Sequence

from setup.console import Failure

Figures = Mapping[str, object]

PICTURES = (
    "empty", "plain_stars", "lensed_stars_1", "lensed_stars_2", "plain_panorama", "lensed_panorama", "hidden_disk", "disk",
    "march_1000",
)
_NUMBERS = (
    "exact_phi_per_s", "bake_tables_s", "node_update_ms", "catalogue_load_ms", "first_frame_ms",
    "first_frame_empty_project_ms", "first_sky_ms",
)
# Key of the drawing times of every picture in turns, by round: for the quotients, too many to print.
TURNS = "gpu_turns_ms"
_TEXTS = ("renderer", "device", "godot")
# Limits of figures, and of quotients of drawing times: at most so much, or (march) at least.
_AT_MOST = {"bake_tables_s": 0.5, "node_update_ms": 0.1, "catalogue_load_ms": 40.0}
# The same of figures that are measured only with --scale.
_AT_MOST_OF_MANY_STARS = {
    "stars_2500k_load_ms": 1500.0, "stars_2500k_bytes_per_star": 64.0, "stars_2500k_to_linear": 1.1,
}
_QUOTIENTS = {
    "lensed_stars_1_to_plain": ("lensed_stars_1", "plain_stars", 1.5),
    "lensed_stars_2_to_plain": ("lensed_stars_2", "plain_stars", 2.0),
    "lensed_panorama_to_plain": ("lensed_panorama", "plain_panorama", 2.5),
    "hidden_disk_to_lensed_panorama": ("hidden_disk", "lensed_panorama", 1.1),
    "disk_to_lensed_panorama": ("disk", "lensed_panorama", 1.8),
}
# The demo's first picture against that of a project with nothing in it.
_FIRST_FRAME = ("first_frame_to_empty_project", 1.5)
_LEAST_MS = 1e-6
_MARCH = ("march_1000_to_lensed_panorama", 30.0)
# The marched picture counts as the lensed one when 99 % of its pixels differ by less than this part of the mean.
_SAME_PICTURE = 0.1


def check(figures: Figures) -> None:
    """A Failure that names what is missing or no figure."""
    times = figures.get("gpu_ms")
    pictures = times if isinstance(times, Mapping) else {}
    wrong = [key for key in _NUMBERS if not _is_figure(figures.get(key))]
    wrong += [f"gpu_ms.{picture}" for picture in PICTURES if not _is_figure(pictures.get(picture))]
    turns = figures.get(TURNS)
    wrong += [] if isinstance(turns, Mapping) and all(turns.get(picture) for picture in PICTURES) else [TURNS]
    wrong += [key for key in _TEXTS if not isinstance(figures.get(key), str)]
    if wrong:
        raise Failure(f"bench: not measured: {', '.join(wrong)}. Measure again on a quieter machine.")


def limits(figures: Figures) -> dict[str, dict[str, object]]:
    """Each compared figure with its limit and whether it is met."""
    times, turns = figures["gpu_ms"], figures[TURNS]
    assert isinstance(times, Mapping) and isinstance(turns, Mapping)
    result = {key: _held(_number(figures[key]), limit) for key, limit in _AT_MOST.items()}
    result |= {
        key: _held(_number(figures[key]), limit) for key, limit in _AT_MOST_OF_MANY_STARS.items() if key in figures
    }
    name, limit = _FIRST_FRAME
    result[name] = _held(_number(figures["first_frame_ms"]) / _number(figures["first_frame_empty_project_ms"]), limit)
    for name, (picture, plain, limit) in _QUOTIENTS.items():
        result[name] = _held(_quotient(turns[picture], turns[plain], turns["empty"]), limit)
    name, least = _MARCH
    value = _number(times["march_1000"]) / max(_number(times["lensed_panorama"]), _LEAST_MS)
    result[name] = {"value": value, "at_least": least, "met": value >= least}
    compared = figures.get("march_picture")
    if isinstance(compared, Mapping):
        result["march_picture_difference"] = _held(_number(compared["p99_difference"]), _SAME_PICTURE)
    return result


def lines(held: Mapping[str, Mapping[str, object]]) -> list[str]:
    """The comparison as a table."""
    result = [f"{'held against limits':<40}{'value':>10}  {'limit':<12}"]
    for name, entry in held.items():
        bound = f"<= {entry['at_most']:g}" if "at_most" in entry else f">= {entry['at_least']:g}"
        result.append(f"{name:<40}{_number(entry['value']):>10.4g}  {bound:<12}{'' if entry['met'] else 'NOT MET'}".rstrip())
    return result


def _held(value: float, limit: float) -> dict[str, object]:
    return {"value": value, "at_most": limit, "met": value <= limit}


def _quotient(times: Sequence[float], of: Sequence[float], empty: Sequence[float]) -> float:
    """How much longer a picture takes than another: the median over rounds, each without its empty frame."""
    rounds = zip(times, of, empty, strict=True)
    return statistics.median((time - none) / max(other - none, _LEAST_MS) for time, other, none in rounds)


def _number(value: object) -> float:
    assert isinstance(value, (int, float))
    return float(value)


def _is_figure(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value) and value >= 0.0
