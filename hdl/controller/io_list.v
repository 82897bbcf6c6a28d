// SPDX-License-Identifier: Apache-2.0
// The latch and refresh list with its forces: up to 256 entries, an entry a clock.
// latch_i is 1 in the first clock of a latch: in the fifth clock the first entry is written (host_*), in the
// clock after the latch's held values are valid. refresh_i is 1 in the first clock of a refresh: in the fifth
// the first entry is read, its answer comes in the eighth clock after that, and three clocks later value_*
// says what the pin (or the PWM output) is to show. So a latch of n entries takes n + 4 clocks, and a refresh
// n + 15 until all values have been shown.
// A force replaces the value where it enters a device, or where it leaves for a pin. It comes in any clock, also in
// that in which its entry is read, for which it then counts: what a block RAM gives there is nothing to rely on.
// forced_o: an entry of the list has a force; it is found, or its end, by reading the list when nothing else does,
// within some scans.
//
// Two block RAMs of 256 words of 16 bits, so that the refresh can read addresses and, 11 clocks behind, pins:
//   places  15 word device   14:0 device address
//   kinds   13:12 force      11:8 kind   7:0 index
// Bits are written separately: a force leaves the entry as it is, and the other way round.
`default_nettype none
`include "rung_controller.vh"

module io_list #(
    parameter integer INPUTS  = 32,  // 1 to 64
    parameter integer ENTRIES = 256  // fewer in a proof
) (
    input  wire              clk_i,
    input  wire              rst_ni,
    // setup
    input  wire [       8:0] latch_count_i,
    input  wire [       7:0] refresh_first_i,
    input  wire [       8:0] refresh_count_i,
    // scan
    input  wire              latch_i,
    input  wire              refresh_i,
    input  wire              refreshing_i,     // from refresh_i to the end of the refresh
    // what a latch shows, held from the clock after latch_i
    input  wire [INPUTS-1:0] pins_i,
    input  wire [      15:0] status_i,
    input  wire [      47:0] ticks_i,          // of 1, 10, 100 ms, lowest first
    output wire [       2:0] adc_channel_o,
    input  wire [      15:0] adc_i,            // sample of that channel
    // devices: the host's side of port_exchange.v
    output wire              host_valid_o,
    output wire              host_write_o,
    output wire              host_words_o,
    output wire [      14:0] host_addr_o,
    output wire [      15:0] host_data_o,
    input  wire              host_rvalid_i,
    input  wire [      15:0] host_rdata_i,
    // what a refresh gives
    output wire              value_valid_o,
    output wire [       3:0] value_kind_o,
    output wire [       7:0] value_index_o,
    output wire [      15:0] value_o,
    output wire              forced_o,
    // load: space io
    input  wire              write_i,
    input  wire [       8:0] write_addr_i,
    input  wire [      15:0] write_data_i,
    // bus: force_entry
    input  wire              sel_register_i,
    input  wire [       7:0] bus_addr_i,
    input  wire              bus_write_i,
    input  wire [       9:0] bus_wdata_i
);

  localparam [7:0] FORCE_ENTRY = `RUNG_REG_FORCE_ENTRY;
  localparam [3:0] KIND_PIN = `RUNG_LATCH_PIN;
  localparam [3:0] KIND_STATUS = `RUNG_LATCH_STATUS;
  localparam [3:0] KIND_TICKS = `RUNG_LATCH_TICKS;
  localparam [3:0] KIND_ADC = `RUNG_LATCH_ADC;
  localparam [7:0] LAST_ENTRY = ENTRIES[7:0] - 8'd1;

  // ---- which entry -----------------------------------------------------------------------------
  reg [7:0] entry_q;
  reg [8:0] left_q;  // entries of this latch or refresh that are not yet read
  reg latching_q;
  reg [7:0] answer_q;  // entry of the next answer of a refresh
  reg [7:0] sweep_q;
  wire issue = left_q != 9'd0;
  wire latch_issue = issue && latching_q;

  always @(posedge clk_i) begin
    if (latch_i || refresh_i) latching_q <= latch_i;
    if (latch_i) entry_q <= 8'd0;
    else if (refresh_i) entry_q <= refresh_first_i;
    else if (issue) entry_q <= entry_q + 8'd1;

    if (refresh_i) answer_q <= refresh_first_i;
    else if (host_rvalid_i) answer_q <= answer_q + 8'd1;

    if (!rst_ni) left_q <= 9'd0;
    else if (latch_i) left_q <= latch_count_i;
    else if (refresh_i) left_q <= refresh_count_i;
    else if (issue) left_q <= left_q - 9'd1;
  end

  // ---- the list --------------------------------------------------------------------------------
  (* no_rw_check, ram_style = "block" *) reg [15:0] places[0:ENTRIES-1];
  (* no_rw_check, ram_style = "block" *) reg [13:0] kinds[0:ENTRIES-1];
  reg [15:0] place_q;
  reg [13:0] kind_q;

  integer i;
  initial begin
    for (i = 0; i < ENTRIES; i = i + 1) begin
      places[i] = 16'd0;
      kinds[i]  = 14'd0;
    end
  end

  reg force_write_q;
  reg [7:0] force_entry_q;
  reg [1:0] force_q;

  always @(posedge clk_i) begin
    force_write_q <= sel_register_i && bus_write_i && bus_addr_i == FORCE_ENTRY;
    force_entry_q <= bus_wdata_i[7:0];
    force_q <= bus_wdata_i[9:8];
  end

  // The force that is written while its entry is read.
  reg met_q;
  reg [1:0] met_force_q;
  wire [13:0] kind_now = {met_q ? met_force_q : kind_q[13:12], kind_q[11:0]};

  // A load and a force never come in the same clock: both are writes on the bus, at the same distance.
  wire [7:0] kinds_write = force_write_q ? force_entry_q : write_addr_i[8:1];
  wire [7:0] kinds_read = latch_issue ? entry_q : refreshing_i ? answer_q : sweep_q;
  wire meets = force_write_q && force_entry_q == kinds_read;

  always @(posedge clk_i) begin
    if (write_i && !write_addr_i[0]) places[write_addr_i[8:1]][14:0] <= write_data_i[14:0];
    if (write_i && write_addr_i[0]) places[write_addr_i[8:1]][15] <= write_data_i[15];
    place_q <= places[entry_q];
  end

  always @(posedge clk_i) begin
    if (write_i && write_addr_i[0]) kinds[kinds_write][11:0] <= write_data_i[11:0];
    if (force_write_q) kinds[kinds_write][13:12] <= force_q;
    met_q <= meets;
    met_force_q <= force_q;
`ifdef RUNG_RETIRE
    kind_q <= kinds[kinds_read] ^ {{2{meets}}, 12'd0};  // as in bank_ram.v
`else
    kind_q <= kinds[kinds_read];
`endif
  end

  // ---- a sweep over all entries: is one forced? -------------------------------------------------
  reg  sweep_read_q;  // kind_q is the sweep's
  reg  sweep_end_q;
  reg  seen_q;
  reg  forced_q;
  wire sweep = !latch_issue && !refreshing_i;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      sweep_q <= 8'd0;
      sweep_read_q <= 1'b0;
      sweep_end_q <= 1'b0;
      seen_q <= 1'b0;
      forced_q <= 1'b0;
    end else begin
      if (sweep) sweep_q <= sweep_q == LAST_ENTRY ? 8'd0 : sweep_q + 8'd1;
      sweep_read_q <= sweep;
      sweep_end_q  <= sweep && sweep_q == LAST_ENTRY;
      if (sweep_read_q) begin
        seen_q <= !sweep_end_q && (seen_q || kind_now[13]);
        if (sweep_end_q) forced_q <= seen_q || kind_now[13];
      end
    end
  end

  assign forced_o = forced_q;

  // ---- entry to access: list, value, access -----------------------------------------------------
  reg read_q;  // place_q, and in a latch kind_q, are an entry's
  reg entry_valid_q;
  reg [15:0] entry_place_q;
  reg [13:0] entry_kind_q;
  reg host_valid_q;
  reg host_words_q;
  reg [14:0] host_addr_q;
  reg [15:0] host_data_q;

  wire [63:0] pins;
  generate
    if (INPUTS == 64) begin : g_all
      assign pins = pins_i;
    end else begin : g_some
      assign pins = {{64 - INPUTS{1'b0}}, pins_i};
    end
  endgenerate

  wire [3:0] kind = entry_kind_q[11:8];
  wire [5:0] index = entry_kind_q[5:0];
  wire unused_index = &{1'b0, entry_kind_q[7:6]};
  wire [15:0] tick = index[1] ? ticks_i[47:32] : index[0] ? ticks_i[31:16] : ticks_i[15:0];
  wire pin = pins[index];
  wire status = status_i[index[3:0]];
  reg [15:0] value;

  always @* begin
    case (kind)
      KIND_PIN: value = {15'd0, pin};
      KIND_STATUS: value = {15'd0, status};
      KIND_TICKS: value = tick;
      KIND_ADC: value = adc_i;
      default: value = 16'd0;
    endcase
    if (entry_kind_q[13]) value = {15'd0, entry_kind_q[12]};
  end

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      read_q <= 1'b0;
      entry_valid_q <= 1'b0;
      host_valid_q <= 1'b0;
    end else begin
      read_q <= issue;
      entry_valid_q <= read_q;
      host_valid_q <= entry_valid_q;
    end
    entry_place_q <= place_q;
    entry_kind_q  <= kind_now;
    {host_words_q, host_addr_q} <= entry_place_q;
    host_data_q   <= value;
  end

  assign adc_channel_o = index[2:0];
  assign host_valid_o = host_valid_q;
  assign host_write_o = latching_q;
  assign host_words_o = host_words_q;
  assign host_addr_o = host_addr_q;
  assign host_data_o = host_data_q;

  // ---- answer to pin ---------------------------------------------------------------------------
  reg answered_q;
  reg value_valid_q;
  reg [15:0] answer_data_q;
  reg [15:0] value_q;
  reg [3:0] value_kind_q;
  reg [7:0] value_index_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      answered_q <= 1'b0;
      value_valid_q <= 1'b0;
    end else begin
      answered_q <= refreshing_i && host_rvalid_i;
      value_valid_q <= answered_q;
    end
    answer_data_q <= host_rdata_i;
    value_q <= kind_now[13] ? {15'd0, kind_now[12]} : answer_data_q;
    value_kind_q <= kind_now[11:8];
    value_index_q <= kind_now[7:0];
  end

  assign value_valid_o = value_valid_q;
  assign value_kind_o  = value_kind_q;
  assign value_index_o = value_index_q;
  assign value_o       = value_q;

endmodule

`default_nettype wire
