# SPDX-License-Identifier: MIT
"""The schema of the capture's shots: it is one, it explains every key, the manual names the same keys, and another
validator than the program's own judges a set of shots alike."""

import json
import unittest
from collections.abc import Iterator

from jsonschema import Draft202012Validator

from setup import paths

_CAPTURE = paths.ROOT / "scenes" / "capture"
_SHOTS = paths.ROOT / "tests" / "data" / "shots"
_SCHEMA = json.loads((_CAPTURE / "shot.schema.json").read_text(encoding="utf-8"))


def _objects(schema: object, place: str = "#") -> Iterator[tuple[str, dict]]:
    """Every schema that lists the keys of an object, and where it stands."""
    if isinstance(schema, dict):
        if "additionalProperties" in schema:
            yield place, schema
        for name, part in schema.items():
            yield from _objects(part, f"{place}/{name}")
    elif isinstance(schema, list):
        for number, part in enumerate(schema):
            yield from _objects(part, f"{place}/{number}")


def _resolved(schema: dict) -> dict:
    return _SCHEMA["$defs"][schema["$ref"].rpartition("/")[2]] if "$ref" in schema else schema


def _reached(schema: dict) -> Iterator[str]:
    """The keys that a shot may hold, at any depth."""
    schema = _resolved(schema)
    properties = schema.get("properties", {})
    for key, part in properties.items():
        yield key
        yield from _reached(part)
    for part in [*schema.get("oneOf", []), *([schema["items"]] if "items" in schema else [])]:
        yield from _reached(part)


def _read(name: str) -> list:
    return json.loads((_SHOTS / name).read_text(encoding="utf-8"))


class Schema(unittest.TestCase):
    def test_it_is_a_json_schema(self) -> None:
        self.assertEqual(_SCHEMA["$schema"], Draft202012Validator.META_SCHEMA["$id"])
        Draft202012Validator.check_schema(_SCHEMA)

    def test_every_key_is_explained_and_no_other_one_let_in(self) -> None:
        objects = list(_objects(_SCHEMA))
        self.assertGreater(len(objects), 8)
        for place, schema in objects:
            self.assertIs(schema["additionalProperties"], False, place)
            for key, part in schema["properties"].items():
                with self.subTest(place=place, key=key):
                    self.assertRegex(part.get("description", ""), r"\w{2}")

    def test_defaults_and_examples_follow_the_schema(self) -> None:
        for place, schema in _objects(_SCHEMA):
            for key, part in schema["properties"].items():
                if "default" in part:
                    with self.subTest(place=place, key=key):
                        Draft202012Validator({**part, "$defs": _SCHEMA["$defs"]}).validate(part["default"])

    def test_the_manual_names_every_key(self) -> None:
        manual = (paths.ROOT / "docs" / "capture.md").read_text(encoding="utf-8")
        keys = set(_reached(_SCHEMA))
        self.assertLessEqual({"position_rs", "psf_sigma_px", "motion"}, keys)
        for key in sorted(keys):
            with self.subTest(key=key):
                self.assertRegex(manual, rf'[`"]{key}[`"]')


class Corpus(unittest.TestCase):
    def setUp(self) -> None:
        self.validator = Draft202012Validator(_SCHEMA)

    def test_good_shots_pass(self) -> None:
        # What only the program can refuse passes the schema as well.
        for shot in [*_read("accepted.json"), *(entry["shot"] for entry in _read("impossible.json"))]:
            with self.subTest(shot=shot):
                self.validator.validate(shot)

    def test_bad_shots_do_not(self) -> None:
        for entry in _read("against_schema.json"):
            with self.subTest(says=entry["says"]):
                self.assertFalse(self.validator.is_valid(entry["shot"]))

    def test_every_key_occurs_in_a_good_shot(self) -> None:
        text = (_SHOTS / "accepted.json").read_text(encoding="utf-8")
        for key in set(_reached(_SCHEMA)):
            with self.subTest(key=key):
                self.assertIn(f'"{key}":', text)
