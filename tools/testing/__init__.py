# SPDX-License-Identifier: MIT
"""The stages of ./test."""
