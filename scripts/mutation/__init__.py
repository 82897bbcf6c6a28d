# SPDX-License-Identifier: Apache-2.0
"""Mutation testing of the hardware (scripts/mutate.py)."""
