// SPDX-License-Identifier: Apache-2.0
// Yosys' own simulation models of ECP5 cells. Its cells_sim.v reads the same two files, but has black boxes
// besides, in the place of which DP16KD.v and MULT18X18D.v stand here.
`include "common_sim.vh"
`include "ccu2c_sim.vh"
