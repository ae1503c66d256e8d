# SPDX-License-Identifier: MIT
"""What is handed on: the addon as a zip, and the demo as programs."""
