// SPDX-License-Identifier: Apache-2.0
// Stand-in for the ECP5 primitive that drives the configuration clock's pin, for lint and simulation: the clock
// shows as `pin`, which is 1 while it is not driven (the board has a pull-up).
`default_nettype none

module USRMCLK (
    input wire USRMCLKI,
    input wire USRMCLKTS
);

  // verilator lint_off UNUSEDSIGNAL
  wire pin  /* verilator public_flat_rd */ = USRMCLKTS || USRMCLKI;
  // verilator lint_on UNUSEDSIGNAL

endmodule
`default_nettype wire
