# SPDX-License-Identifier: MIT
"""Test results as JUnit XML, the form that every test runner here writes."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

# Characters that XML 1.0 cannot hold, such as the escape that starts a terminal colour.
_FORBIDDEN = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


@dataclass(frozen=True)
class Case:
    """One test. failure or skipped hold the reason; both None: passed."""

    name: str
    group: str = ""
    seconds: float = 0.0
    failure: str | None = None
    skipped: str | None = None


def read(path: Path) -> list[Case]:
    """The cases of a JUnit file; raises OSError or ElementTree.ParseError when there is none to read."""
    cases = []
    for suite in ElementTree.parse(path).getroot().iter("testsuite"):
        for node in suite.findall("testcase"):
            group = node.get("classname") or suite.get("name") or ""
            cases.append(_case(node, group))
    return cases


def write(path: Path, suite: str, cases: Sequence[Case]) -> None:
    """Writes the cases as one suite."""
    root = ElementTree.Element("testsuites")
    head = ElementTree.SubElement(root, "testsuite", {
        "name": suite,
        "tests": str(len(cases)),
        "failures": str(sum(case.failure is not None for case in cases)),
        "skipped": str(sum(case.skipped is not None for case in cases)),
        "time": f"{sum(case.seconds for case in cases):.3f}",
    })
    for case in cases:
        node = ElementTree.SubElement(head, "testcase", {
            "name": _clean(case.name), "classname": _clean(case.group or suite), "time": f"{case.seconds:.3f}",
        })
        if case.failure is not None:
            message = case.failure.splitlines()[0] if case.failure else ""
            ElementTree.SubElement(node, "failure", {"message": _clean(message)}).text = _clean(case.failure)
        elif case.skipped is not None:
            ElementTree.SubElement(node, "skipped", {"message": _clean(case.skipped)})
    path.parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(root).write(path, encoding="utf-8", xml_declaration=True)


def _case(node: ElementTree.Element, group: str) -> Case:
    name = node.get("name") or "unnamed"
    seconds = _number(node.get("time"))
    for tag in ("failure", "error"):
        found = node.find(tag)
        if found is not None:
            return Case(name, group, seconds, failure=_reason(found, node.findtext("system-out") or ""))
    found = node.find("skipped")
    if found is not None:
        return Case(name, group, seconds, skipped=found.get("message") or (found.text or "").strip() or "skipped")
    return Case(name, group, seconds)


def _reason(failure: ElementTree.Element, printed: str) -> str:
    """All that a failed case says; the message often is the first line of the text as well."""
    message, text = (failure.get("message") or "").strip(), (failure.text or "").strip()
    parts = [text] if text.startswith(message) else [message, text]
    return "\n".join(part for part in (*parts, printed.strip()) if part) or "failed"


def _number(text: str | None) -> float:
    try:
        return float(text or 0.0)
    except ValueError:
        return 0.0


def _clean(text: str) -> str:
    return _FORBIDDEN.sub("", text)
