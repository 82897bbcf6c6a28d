// SPDX-License-Identifier: Apache-2.0
// The latch and refresh list (controller.toml: entries of the io list), walked one entry a clock.
//   latch    latch_i starts it; what its entries stand for goes into devices. done_o is 1 for a clock
//            LATCH_CLOCKS clocks and one an entry after latch_i, when the last access has left.
//   refresh  refresh_i starts it; the devices of its entries are read, and the answers stand one after the other at
//            pin_valid_o and pwm_valid_o. done_o is 1 for a clock REFRESH_CLOCKS clocks and one an entry after
//            refresh_i, when the last answer has been given.
// A forced entry of the latch gives its forced value instead, of the refresh too. The list is written and
// forces are set by the firmware; forced_o: the last whole scan saw a force.
`default_nettype none
`include "rung_controller.vh"

module io_list #(
    parameter integer ANSWER_CLOCKS = 9,  // from a read's access_valid_o to its answer
    parameter integer ADDR_BITS = 14  // of a device
) (
    input  wire         clk_i,
    input  wire         rst_ni,
    // the list, from the firmware
    input  wire         list_write_i,
    input  wire [  8:0] list_addr_i,       // entry * 2 + word
    input  wire [ 15:0] list_data_i,
    input  wire         force_write_i,
    input  wire [  7:0] force_entry_i,
    input  wire [  1:0] force_data_i,      // {forced, value}
    input  wire [  8:0] latch_count_i,
    input  wire [  7:0] refresh_first_i,
    input  wire [  8:0] refresh_count_i,
    // phases
    input  wire         latch_i,
    input  wire         refresh_i,
    output wire         done_o,
    // what entries of the latch may stand for, held from the clock after latch_i on
    input  wire [ 63:0] pins_i,
    input  wire [  9:0] status_i,
    input  wire [ 15:0] ticks_1_i,
    input  wire [ 15:0] ticks_10_i,
    input  wire [ 15:0] ticks_100_i,
    input  wire [127:0] adc_i,
    // accesses to devices
    output wire         access_valid_o,
    output wire         access_write_o,
    output wire         access_word_o,
    output wire [ 15:0] access_addr_o,
    output wire [ 15:0] access_data_o,
    input  wire         answer_valid_i,
    input  wire [ 15:0] answer_data_i,
    // answers of the refresh
    output wire         pin_valid_o,
    output wire [  5:0] pin_o,
    output wire         pin_level_o,
    output wire         pwm_valid_o,
    output wire [ 15:0] pwm_duty_o,
    output wire         forced_o
);

  localparam integer LATCH_CLOCKS = `RUNG_PHASES_LATCH_CLOCKS;
  localparam integer REFRESH_CLOCKS = `RUNG_PHASES_REFRESH_CLOCKS;

  // ---- the list ------------------------------------------------------------------------------------
  // The force of an entry lies beside its address, in bits of its own. The list is written while the controller is
  // stopped. A force comes at any time: it waits while its own entry is the one that is read, which the
  // block RAMs would answer with anything; entry_q moves on with every clock.
  (* no_rw_check *) reg [ADDR_BITS+1:0] address_ram[0:255];
  (* no_rw_check *) reg [15:0] what_ram[0:255];

  reg [7:0] entry_q;
  reg [ADDR_BITS-1:0] address_q;
  reg [15:0] what_q;
  reg [1:0] force_q;
  reg force_waits_q;
  reg [7:0] force_entry_q;
  reg [1:0] force_data_q;
  wire list_address = list_write_i && !list_addr_i[0];
  wire force_write = force_waits_q && !list_address && force_entry_q != entry_q;
  wire [7:0] write_entry = list_address ? list_addr_i[8:1] : force_entry_q;

  always @(posedge clk_i) begin
    if (force_write_i) begin
      force_entry_q <= force_entry_i;
      force_data_q  <= force_data_i;
    end
    force_waits_q <= force_write_i || (force_waits_q && !force_write);
    if (list_address) address_ram[write_entry][ADDR_BITS-1:0] <= list_data_i[ADDR_BITS-1:0];
    if (force_write) address_ram[write_entry][ADDR_BITS+1:ADDR_BITS] <= force_data_q;
    {force_q, address_q} <= address_ram[entry_q];
    if (list_write_i && list_addr_i[0]) what_ram[list_addr_i[8:1]] <= list_data_i;
    what_q <= what_ram[entry_q];
  end

  // ---- the walk: entry, its words, its access ------------------------------------------------------
  reg walk_q;  // entry_q is one of the phase's
  reg write_q;  // the phase is a latch
  reg [8:0] left_q;  // entries behind this one
  reg words_q;  // address_q and what_q are
  reg access_valid_q, access_write_q, access_word_q;
  reg [ADDR_BITS-1:0] access_addr_q;
  reg [15:0] access_data_q;
  reg [9:0] clocks_q;
  reg running_q;
  reg done_q;

  wire start = latch_i || refresh_i;
  wire [8:0] count = latch_i ? latch_count_i : refresh_count_i;
  wire [9:0] length = {1'b0, count} + (latch_i ? LATCH_CLOCKS[9:0] : REFRESH_CLOCKS[9:0]);

  always @(posedge clk_i) begin
    if (start) begin
      entry_q <= latch_i ? 8'd0 : refresh_first_i;
      left_q <= count - 9'd1;
      write_q <= latch_i;
      clocks_q <= length - 10'd2;
    end else begin
      entry_q <= entry_q + 8'd1;
      left_q <= left_q - 9'd1;
      clocks_q <= clocks_q - 10'd1;
    end
    if (!rst_ni) begin
      walk_q <= 1'b0;
      words_q <= 1'b0;
      access_valid_q <= 1'b0;
      running_q <= 1'b0;
      done_q <= 1'b0;
    end else begin
      if (start) walk_q <= count != 9'd0;
      else if (left_q == 9'd0) walk_q <= 1'b0;
      words_q <= walk_q;
      access_valid_q <= words_q;
      if (start) running_q <= 1'b1;
      else if (clocks_q == 10'd0) running_q <= 1'b0;
      done_q <= running_q && clocks_q == 10'd0;
    end
    access_write_q <= write_q;
    access_word_q <= what_q[15];
    access_addr_q <= address_q;
    access_data_q <= value;
  end

  // ---- values of the latch ---------------------------------------------------------------------------
  wire [3:0] kind = what_q[11:8];
  reg [15:0] value;
  always @* begin
    value = 16'd0;
    case (kind)
      `RUNG_LATCH_PIN: value[0] = pins_i[what_q[5:0]];
      `RUNG_LATCH_STATUS: value[0] = what_q[3:0] < 4'd10 && status_i[what_q[3:0]];
      `RUNG_LATCH_TICKS: begin
        value = what_q[1] ? ticks_100_i : what_q[0] ? ticks_10_i : ticks_1_i;
      end
      `RUNG_LATCH_ADC: value = adc_i[{what_q[2:0], 4'd0}+:16];
      default: ;
    endcase
    if (force_q[1]) value = {15'd0, force_q[0]};
  end
  wire unused_what = &{1'b0, what_q[14:12], what_q[7:6]};

  // ---- answers of the refresh: what each is for waits beside it ----------------------------------------
  localparam integer DELAY = ANSWER_CLOCKS;
  reg [11:0] for_q[0:DELAY];  // kind, index, force, of the entry whose access leaves i clocks ago
  integer i;
  always @(posedge clk_i) begin
    for_q[0] <= {kind, what_q[5:0], force_q};
    for (i = 1; i <= DELAY; i = i + 1) for_q[i] <= for_q[i-1];
  end
  wire [11:0] answer_for = for_q[DELAY];
  wire is_answer = answer_valid_i && running_q && !write_q;

  assign pin_valid_o = is_answer && answer_for[11:8] == `RUNG_REFRESH_PIN;
  assign pin_o = answer_for[7:2];
  assign pin_level_o = answer_for[1] ? answer_for[0] : answer_data_i[0];
  assign pwm_valid_o = is_answer && answer_for[11:8] == `RUNG_REFRESH_PWM;
  assign pwm_duty_o = answer_data_i;

  // ---- forces ------------------------------------------------------------------------------------------
  reg seen_q;
  reg forced_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_q <= 1'b0;
      forced_q <= 1'b0;
    end else begin
      if (latch_i) begin
        seen_q <= 1'b0;
        forced_q <= seen_q;
      end else if (words_q && force_q[1]) begin
        seen_q <= 1'b1;
        forced_q <= 1'b1;
      end
    end
  end

  assign access_valid_o = access_valid_q;
  assign access_write_o = access_write_q;
  assign access_word_o = access_word_q;
  assign access_addr_o = {{16 - ADDR_BITS{1'b0}}, access_addr_q};
  assign access_data_o = access_data_q;
  assign done_o = done_q;
  assign forced_o = forced_q;

endmodule

`default_nettype wire
