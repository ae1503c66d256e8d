# SPDX-License-Identifier: MIT
"""The 88 constellations as text: names, places of labels, lines of the figures."""

import json
import unicodedata

# The package says Corona Austrina here, the IAU's list of constellations Australis.
IAU_NAMES = {"CrA": "Corona Australis"}
SOURCE = "d3-celestial 0.7.35, Copyright (c) 2015, Olaf Frohn, BSD-3-Clause: see CREDITS.md"


def _place(coordinates: list[float]) -> str:
    """'[ra,dec]' in degrees, right ascension from 0 to below 360; the package counts it from -180."""
    ra = f"{coordinates[0] % 360.0:.4f}"
    return f"[{'0.0000' if ra == '360.0000' else ra},{coordinates[1]:.4f}]"


def _plain(name: str) -> str:
    """The name in composed Unicode; some in the package have typographic spaces that few fonts know."""
    return " ".join(unicodedata.normalize("NFC", name).split())


def _latin(properties: dict) -> str:
    """Serpens comes as two features, Caput and Cauda, of which only the first word is the constellation's name."""
    name = IAU_NAMES.get(properties["desig"], properties["name"])
    return name.split()[0] if properties["desig"] == "Ser" else name


def _merged(labels: list[dict], lines: list[dict]) -> dict[str, dict]:
    """By the IAU's abbreviation: {"la", "de", "labels", "lines"}; a constellation in two parts is one entry."""
    merged = {}
    for feature in labels:
        properties = feature["properties"]
        entry = merged.setdefault(feature["id"], {
            "la": _plain(_latin(properties)), "de": _plain(properties["de"]), "labels": [], "lines": []})
        entry["labels"].append(_place(feature["geometry"]["coordinates"]))
    for feature in lines:
        for line in feature["geometry"]["coordinates"]:
            merged[feature["id"]]["lines"].append(f"[{','.join(_place(point) for point in line)}]")
    return merged


def encode(labels: list[dict], lines: list[dict]) -> bytes:
    """The file made of the features of constellations.json and constellations.lines.json; one constellation a line."""
    rows = []
    for abbreviation, entry in sorted(_merged(labels, lines).items()):
        rows.append(
            f'{{"id":{json.dumps(abbreviation)},"la":{json.dumps(entry["la"], ensure_ascii=False)},'
            f'"de":{json.dumps(entry["de"], ensure_ascii=False)},"labels":[{",".join(entry["labels"])}],'
            f'"lines":[{",".join(entry["lines"])}]}}')
    head = f'{{"source":{json.dumps(SOURCE)},\n"constellations":[\n'
    return (head + ",\n".join(rows) + "\n]}\n").encode("utf-8")
