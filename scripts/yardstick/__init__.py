# SPDX-License-Identifier: Apache-2.0
"""The same ladder program on other machines: soft cores in the same FPGA, and the host."""
