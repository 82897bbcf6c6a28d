# SPDX-License-Identifier: Apache-2.0
"""What the tests reach: of the hardware, of the C++, of the pipeline's situations."""
