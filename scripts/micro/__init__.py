# SPDX-License-Identifier: Apache-2.0
"""The compiler of the controller's firmware: a C subset to the micro-sequencer's code.

front     C text to functions and global variables, everything checked
code      functions to instructions with labels
layout    places of variables along the call graph
assemble  labels to addresses, instructions to words
"""
