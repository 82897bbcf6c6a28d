// SPDX-License-Identifier: Apache-2.0
// Fetch (hdl/core/fetch.v): a scan gives ID1 the steps from its first to its last, each once, in order, one
// a clock unless ID1 holds, each as it was loaded; the first is there four clocks after the start, done
// three clocks behind the end, and the clocks of a scan are those that its steps stay in ID1 and
// RUNG_FILL_CLOCKS more, whatever the program.
`default_nettype none
`include "rung_isa.vh"

module fetch_proof #(
    parameter PC_BITS = 2,
    parameter STEP_BITS = 20
) (
    input wire clk_i,
    input wire start_i,
    input wire range_i,
    input wire [15:0] entry_i,
    input wire [15:0] end_i,
    input wire load_chunk_i,
    input wire load_length_i,
    input wire [19:0] load_addr_i,
    input wire [15:0] load_data_i,
    input wire [STEP_BITS-1:0] host_i,
    input wire hold_i,
    // its registers
    input wire peek_f1_active,
    input wire [PC_BITS:0] peek_f1_pc,
    input wire [PC_BITS:0] peek_f1_stop,
    input wire peek_f2_valid,
    input wire peek_f3_valid,
    input wire [3:0] peek_end,  // d3, d1, f3, f2
    input wire peek_d2_end,
    input wire [PC_BITS-1:0] peek_f2_number,
    input wire [PC_BITS-1:0] peek_f3_number,
    input wire [STEP_BITS-1:0] peek_f2_step,
    input wire [STEP_BITS-1:0] peek_f3_step,
    input wire [PC_BITS:0] peek_length,
    input wire [(16<<PC_BITS)-1:0] peek_low,  // all steps' lower chunks
    input wire [(4<<PC_BITS)-1:0] peek_high
);

  localparam STEPS = 1 << PC_BITS;

  reg [2:0] age_q;
  initial age_q = 3'd0;
  always @(posedge clk_i) if (age_q != 3'd6) age_q <= age_q + 3'd1;
  wire reset = age_q < 3'd5;
  wire known = age_q == 3'd6;

  wire scan_start, busy, done, d1_valid;
  wire [31:0] clocks;
  wire [STEP_BITS-1:0] f3_step, d1_step;
  wire [15:0] d1_number;
  wire hold = hold_i && d1_valid;  // only a step can hold
  // A host access is accepted while no scan runs, and is here a clock later.
  reg idle_q;
  always @(posedge clk_i) idle_q <= !busy && !reset;
  wire [STEP_BITS-1:0] host = host_i & {STEP_BITS{idle_q}};
  wire chunk = load_chunk_i && idle_q && !reset;
  wire length = load_length_i && idle_q && !reset;
  wire start = start_i && !reset;
  fetch #(
      .STEPS(STEPS),
      .STEP_BITS(STEP_BITS)
  ) fetch (
      .clk_i(clk_i),
      .rst_ni(!reset),
      .start_i(start),
      .range_i(range_i),
      .entry_i(entry_i),
      .end_i(end_i),
      .scan_start_o(scan_start),
      .busy_o(busy),
      .done_o(done),
      .clocks_o(clocks),
      .load_chunk_i(chunk),
      .load_length_i(length),
      .load_addr_i(load_addr_i),
      .load_data_i(load_data_i),
      .l_step_i(host),
      .d1_hold_i(hold),
      .f3_step_o(f3_step),
      .d1_step_o(d1_step),
      .d1_valid_o(d1_valid),
      .d1_number_o(d1_number)
  );

  // ---- what is loaded: one step, any -----------------------------------------------------------
  (* anyconst *)wire [PC_BITS-1:0] watched;
  reg [STEP_BITS-1:0] content_q;  // what was loaded; the memory has it a clock later
  reg [STEP_BITS-1:0] content_before_q;
  reg [PC_BITS:0] length_q;
  wire [STEP_BITS-1:0] stored = {peek_high[watched*4+:4], peek_low[watched*16+:16]};
  wire hit = chunk && load_addr_i[3+:PC_BITS] == watched;
  always @(posedge clk_i) begin
    content_before_q <= content_q;
    if (hit && load_addr_i[2:0] == 3'd0) content_q[15:0] <= load_data_i;
    if (hit && load_addr_i[2:0] == 3'd1) content_q[STEP_BITS-1:16] <= load_data_i[STEP_BITS-17:0];
    if (reset) begin
      content_q <= stored;
      content_before_q <= stored;
    end
    if (length) length_q <= load_data_i[PC_BITS:0];
    if (reset) length_q <= {PC_BITS + 1{1'b0}};
  end
  wire [PC_BITS:0] new_length = length ? load_data_i[PC_BITS:0] : length_q;
  always @* begin
    // A step more than the memory has is no step; the host leaves a clock between program and start.
    if (length) assume (load_data_i[PC_BITS:0] <= STEPS);
    if (scan_start) begin
      assume (!chunk);
      assume (!range_i || (entry_i[PC_BITS:0] <= end_i[PC_BITS:0] && end_i[PC_BITS:0] <= STEPS));
    end
    if (busy) assume (!chunk && !length);
  end

  // ---- the scan: which step is in ID1, or would be ---------------------------------------------
  reg running_q;
  reg [2:0] filled_q;  // stages that the scan has reached, up to 4: IF1, IF2, IF3, ID1
  reg [PC_BITS+2:0] now_q;  // step in ID1, counting on behind the last
  reg [PC_BITS+2:0] stop_q;
  reg [31:0] elapsed_q;  // clocks since the start
  reg [31:0] stayed_q;  // of those, steps were in ID1
  wire finished = running_q && filled_q == 3'd4 && now_q == stop_q + 3;
  always @(posedge clk_i) begin
    if (running_q) begin
      elapsed_q <= elapsed_q + 32'd1;
      if (d1_valid) stayed_q <= stayed_q + 32'd1;
      if (!hold) begin
        if (filled_q != 3'd4) filled_q <= filled_q + 3'd1;
        else now_q <= now_q + 1'b1;
      end
      if (filled_q == 3'd4 && now_q == stop_q + 2) running_q <= 1'b0;
    end
    if (scan_start) begin
      running_q <= 1'b1;
      filled_q <= 3'd1;
      now_q <= range_i ? {2'd0, entry_i[PC_BITS:0]} : {PC_BITS + 3{1'b0}};
      stop_q <= range_i ? {2'd0, end_i[PC_BITS:0]} : {2'd0, new_length};
      elapsed_q <= 32'd1;
      stayed_q <= 32'd0;
    end
    if (reset) begin
      running_q <= 1'b0;
      stayed_q <= 32'd0;
      elapsed_q <= 32'd0;
      filled_q <= 3'd0;
    end
  end
  // The steps in IF1, IF2, IF3.
  wire [PC_BITS+2:0] ahead = now_q + {{PC_BITS{1'b0}}, filled_q} - 1'b1;
  wire in_f1 = running_q;
  wire in_f2 = running_q && filled_q >= 3'd2;
  wire in_f3 = running_q && filled_q >= 3'd3;
  wire in_d1 = running_q && filled_q == 3'd4;
  wire [PC_BITS+2:0] f2_number = ahead - 1;
  wire [PC_BITS+2:0] f3_number = ahead - 2;

  always @* begin
    if (known) begin
      // what the processor sees
      assert (busy == running_q);
      assert (scan_start == (start && !running_q));
      assert (d1_valid == (in_d1 && now_q < stop_q));
      if (d1_valid) assert (d1_number == {{14 - PC_BITS{1'b0}}, now_q[PC_BITS+1:0]});
      if (d1_valid && now_q == {3'd0, watched}) assert (d1_step == content_q);
      if (running_q && filled_q < 3'd3) assert (f3_step == host);
      if (running_q && filled_q == 3'd4 && !d1_valid) assert (d1_step == {STEP_BITS{1'b0}});
      if (running_q) assert (clocks == elapsed_q);
      if (running_q) assert (!done);
      // the program as the memory has it
      assert (stored == content_before_q);
      assert (length_q == peek_length && length_q <= STEPS);
      if (running_q && filled_q >= 3'd2) assert (content_q == content_before_q);
      // how it gets there
      if (running_q) begin
        assert (filled_q != 3'd0 && filled_q <= 3'd4 && stop_q <= STEPS);
        assert (now_q <= (in_d1 ? stop_q + 2 : stop_q));
        assert (peek_f1_stop == stop_q[PC_BITS:0]);
        if (ahead <= stop_q) assert (peek_f1_pc == ahead[PC_BITS:0]);
      end
      assert (peek_f1_active == (in_f1 && ahead <= stop_q));
      assert (peek_f2_valid == (in_f2 && f2_number < stop_q));
      assert (peek_f3_valid == (in_f3 && f3_number < stop_q));
      assert (peek_end[0] == (in_f2 && f2_number == stop_q));
      assert (peek_end[1] == (in_f3 && f3_number == stop_q));
      assert (peek_end[2] == (in_d1 && now_q == stop_q));
      assert (peek_d2_end == (in_d1 && now_q == stop_q + 1));
      assert (peek_end[3] == (in_d1 && now_q == stop_q + 2));
      if (peek_f2_valid) begin
        assert (peek_f2_number == f2_number[PC_BITS-1:0]);
        if (f2_number == {3'd0, watched}) assert (peek_f2_step == content_q);
      end
      if (peek_f3_valid) begin
        assert (peek_f3_number == f3_number[PC_BITS-1:0]);
        if (f3_number == {3'd0, watched}) assert (peek_f3_step == content_q);
      end
      // constant: what the steps take, and the fill
      if (running_q && !in_d1) assert (stayed_q == 32'd0 && elapsed_q == {29'd0, filled_q});
      if (in_d1 && now_q <= stop_q) assert (elapsed_q == stayed_q + 32'd4);
      if (in_d1 && now_q == stop_q + 1) assert (elapsed_q == stayed_q + 32'd5);
      if (in_d1 && now_q == stop_q + 2) assert (elapsed_q == stayed_q + `RUNG_FILL_CLOCKS - 1);
      if (done) assert (!running_q && clocks == elapsed_q);
      if (done) assert (clocks == stayed_q + `RUNG_FILL_CLOCKS);
    end
  end

  // ID1 has what IF3 showed, unless it holds.
  reg [STEP_BITS-1:0] f3_step_q, d1_step_q;
  reg hold_q;
  always @(posedge clk_i) begin
    f3_step_q <= f3_step;
    d1_step_q <= d1_step;
    hold_q <= hold;
  end
  always @* if (known) assert (d1_step == (hold_q ? d1_step_q : f3_step_q));

  always @* begin
    if (known) begin
      cover (done && stayed_q == 32'd5 && length_q == 4);
      cover (d1_valid && now_q == {3'd0, watched} && content_q == {STEP_BITS / 4{4'h9}});
      cover (done && clocks == `RUNG_FILL_CLOCKS);
    end
  end

endmodule

`default_nettype wire
