# SPDX-License-Identifier: MIT
"""Checks of the sources that no other tool offers."""
