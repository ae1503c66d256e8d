# SPDX-License-Identifier: MIT
"""Generates the part of the bindings that follows from the engine's own description of itself."""
