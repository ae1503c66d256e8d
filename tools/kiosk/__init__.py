# SPDX-License-Identifier: MIT
"""Tests of the exhibit over a long time."""
