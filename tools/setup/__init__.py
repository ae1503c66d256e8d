# SPDX-License-Identifier: MIT
"""Brings a bare machine to the point where the project runs: packages, Godot, build, import."""
