// SPDX-License-Identifier: Apache-2.0
// Latch and refresh list (hdl/controller/io_list.v), any entry of it: a latch writes entry k in its clock 4 + k, a refresh reads
// it there and shows its value in clock 14 + k, and nothing else ever does; device, kind and index are those that were loaded;
// the value is the pin's, the status', the time's, the sample's or the device's, but for an entry with a force it is the
// force's, also in the clock in which the force is written. Forces are written in any clock.
`default_nettype none
`include "rung_controller.vh"

module io_list_proof #(
    parameter integer INPUTS = 4
) (
    input wire              clk_i,
    input wire              rst_ni,
    input wire              latch_i,
    input wire              refresh_i,
    input wire [INPUTS-1:0] pins_i,
    input wire [      15:0] status_i,
    input wire [      47:0] ticks_i,
    input wire [      15:0] adc_i,
    input wire [      15:0] answer_i,
    input wire              write_i,
    input wire [       8:0] write_addr_i,
    input wire [      15:0] write_data_i,
    input wire              sel_register_i,
    input wire [       7:0] bus_addr_i,
    input wire              bus_write_i,
    input wire [       9:0] bus_wdata_i
);

  (* anyconst *) wire [7:0] entry;
  (* anyconst *) wire [8:0] latch_count;
  (* anyconst *) wire [7:0] refresh_first;
  (* anyconst *) wire [8:0] refresh_count;
  always @* begin
    assume (entry < 8'd8 && latch_count <= 9'd8 && refresh_count <= 9'd8);
    assume (refresh_first < 8'd8 && {1'b0, refresh_first} + refresh_count <= 9'd8);
    assume (write_addr_i < 9'd16 && bus_wdata_i[7:0] < 8'd8);
  end

  wire refreshing, host_valid, host_write, host_words, value_valid, forced;
  wire [14:0] host_addr;
  wire [15:0] host_data, value;
  wire [3:0] value_kind;
  wire [7:0] value_index;
  wire [2:0] channel;
  reg  [7:0] reads_q;  // accesses on their way: the answer comes in the eighth clock
  io_list #(
      .INPUTS (INPUTS),
      .ENTRIES(8)
  ) list (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .latch_count_i  (latch_count),
      .refresh_first_i(refresh_first),
      .refresh_count_i(refresh_count),
      .latch_i        (latch_i),
      .refresh_i      (refresh_i),
      .refreshing_i   (refreshing),
      .pins_i         (pins_i),
      .status_i       (status_i),
      .ticks_i        (ticks_i),
      .adc_channel_o  (channel),
      .adc_i          (adc_i),
      .host_valid_o   (host_valid),
      .host_write_o   (host_write),
      .host_words_o   (host_words),
      .host_addr_o    (host_addr),
      .host_data_o    (host_data),
      .host_rvalid_i  (reads_q[7]),
      .host_rdata_i   (answer_i),
      .value_valid_o  (value_valid),
      .value_kind_o   (value_kind),
      .value_index_o  (value_index),
      .value_o        (value),
      .forced_o       (forced),
      .write_i        (write_i),
      .write_addr_i   (write_addr_i),
      .write_data_i   (write_data_i),
      .sel_register_i (sel_register_i),
      .bus_addr_i     (bus_addr_i),
      .bus_write_i    (bus_write_i),
      .bus_wdata_i    (bus_wdata_i)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* assume (rst_ni == begun_q);

  // ---- phases: one at a time, as long as scan_controller.v has them; clock_q counts from latch_i or refresh_i -------
  reg latching_q;
  reg refreshing_q;
  reg [8:0] clock_q;
  wire [8:0] clock = latch_i || refresh_i ? 9'd0 : clock_q;
  wire in_latch = latch_i || latching_q;
  wire in_refresh = refresh_i || refreshing_q;
  wire ends = in_latch ? clock == latch_count + 9'd3 : clock == refresh_count + 9'd14;
  assign refreshing = in_refresh;
  always @* begin
    assume (!(latch_i && refresh_i));
    if (latching_q || refreshing_q || !begun_q) assume (!latch_i && !refresh_i);
    // Lists are loaded while no scan is under way. A write of the bus is a load or a force, a clock later each.
    if (in_latch || in_refresh || reads_q != 8'd0) assume (!write_i);
    if (write_i) assume (!forces_q);
  end
  always @(posedge clk_i) begin
    latching_q <= begun_q && in_latch && !ends;
    refreshing_q <= begun_q && in_refresh && !ends;
    clock_q <= clock + 9'd1;
    reads_q <= begun_q ? {reads_q[6:0], host_valid && !host_write} : 8'd0;
  end

  // ---- the entry as it was loaded, and its force -----------------------------------------------------------
  reg [14:0] device_q;
  reg words_q;
  reg [11:0] kind_q;
  reg [1:0] force_q;
  reg forces_q;  // a force is being written
  reg [9:0] forcing_q;
  wire [1:0] now = forces_q && forcing_q[7:0] == entry ? forcing_q[9:8] : force_q;
  always @(posedge clk_i) begin
    forces_q  <= begun_q && sel_register_i && bus_write_i && bus_addr_i == `RUNG_REG_FORCE_ENTRY;
    forcing_q <= bus_wdata_i;
    force_q   <= begun_q ? now : 2'b00;
    if (!begun_q) {device_q, words_q, kind_q} <= 28'd0;
    else if (write_i && write_addr_i == {entry, 1'b0}) device_q <= write_data_i[14:0];
    else if (write_i && write_addr_i == {entry, 1'b1}) begin
      words_q <= write_data_i[15];
      kind_q  <= write_data_i[11:0];
    end
  end

  // What the force was, and what the inputs showed, in the clocks before.
  reg [1:0] force_1_q, force_2_q, force_3_q;
  reg [15:0] input_q;
  reg [15:0] answer_1_q, answer_2_q;
  wire [5:0] index = kind_q[5:0];
  wire [15:0] tick = index[1:0] == 2'd0 ? ticks_i[15:0] : index[1:0] == 2'd1 ? ticks_i[31:16] :
      ticks_i[47:32];
  always @(posedge clk_i) begin
    {force_1_q, force_2_q, force_3_q} <= {now, force_1_q, force_2_q};
    {answer_1_q, answer_2_q} <= {answer_i, answer_1_q};
    case (kind_q[11:8])
      `RUNG_LATCH_PIN: input_q <= index < INPUTS ? {15'd0, pins_i[index]} : 16'd0;
      `RUNG_LATCH_STATUS: input_q <= {15'd0, status_i[index[3:0]]};
      `RUNG_LATCH_TICKS: input_q <= tick;
      `RUNG_LATCH_ADC: input_q <= adc_i;
      default: input_q <= 16'd0;
    endcase
  end

  wire [8:0] number = {1'b0, entry};
  wire [7:0] behind = entry - refresh_first;
  wire [8:0] refresh_number = {1'b0, behind};
  wire latch_here = in_latch && number < latch_count && clock == number + 9'd4;
  wire read_here = in_refresh && refresh_number < refresh_count && clock == refresh_number + 9'd4;
  wire shown_here = in_refresh && refresh_number < refresh_count && clock == refresh_number + 9'd14;
  wire accesses = clock >= 9'd4 && (in_latch || (in_refresh && clock < refresh_count + 9'd4));
  always @* begin
    if (begun_q) begin
      assert (host_valid == accesses);
      if (accesses) assert (host_write == in_latch);
      if (latch_here || read_here) assert (host_addr == device_q && host_words == words_q);
      if (latch_here) assert (host_data == (force_3_q[1] ? {15'd0, force_3_q[0]} : input_q));
      assert (value_valid == (in_refresh && clock >= 9'd14 && clock < refresh_count + 9'd14));
      if (shown_here) begin
        assert (value_kind == kind_q[11:8] && value_index == kind_q[7:0]);
        assert (value == (force_2_q[1] ? {15'd0, force_2_q[0]} : answer_2_q));
      end
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------------
  (* hierconn *) wire [7:0] \list.entry_q ;
  (* hierconn *) wire [8:0] \list.left_q ;
  (* hierconn *) wire \list.latching_q ;
  (* hierconn *) wire [7:0] \list.answer_q ;
  (* hierconn *) wire \list.read_q ;
  (* hierconn *) wire \list.entry_valid_q ;
  (* hierconn *) wire \list.answered_q ;
  (* hierconn *) wire \list.force_write_q ;
  (* hierconn *) wire [7:0] \list.force_entry_q ;
  (* hierconn *) wire [1:0] \list.force_q ;
  wire [127:0] places;
  wire [111:0] kinds;
  (* hierconn *) wire [15:0] \list.places[0] ;
  (* hierconn *) wire [13:0] \list.kinds[0] ;
  (* hierconn *) wire [15:0] \list.places[1] ;
  (* hierconn *) wire [13:0] \list.kinds[1] ;
  (* hierconn *) wire [15:0] \list.places[2] ;
  (* hierconn *) wire [13:0] \list.kinds[2] ;
  (* hierconn *) wire [15:0] \list.places[3] ;
  (* hierconn *) wire [13:0] \list.kinds[3] ;
  (* hierconn *) wire [15:0] \list.places[4] ;
  (* hierconn *) wire [13:0] \list.kinds[4] ;
  (* hierconn *) wire [15:0] \list.places[5] ;
  (* hierconn *) wire [13:0] \list.kinds[5] ;
  (* hierconn *) wire [15:0] \list.places[6] ;
  (* hierconn *) wire [13:0] \list.kinds[6] ;
  (* hierconn *) wire [15:0] \list.places[7] ;
  (* hierconn *) wire [13:0] \list.kinds[7] ;
  assign places = {
    \list.places[7] ,
    \list.places[6] ,
    \list.places[5] ,
    \list.places[4] ,
    \list.places[3] ,
    \list.places[2] ,
    \list.places[1] ,
    \list.places[0]
  };
  assign kinds = {
    \list.kinds[7] ,
    \list.kinds[6] ,
    \list.kinds[5] ,
    \list.kinds[4] ,
    \list.kinds[3] ,
    \list.kinds[2] ,
    \list.kinds[1] ,
    \list.kinds[0]
  };
  wire busy = latching_q || refreshing_q;  // behind the first clock
  wire [8:0] count = latching_q ? latch_count : refresh_count;
  wire [8:0] gone = clock_q - 9'd1 > count ? count : clock_q - 9'd1;
  wire [8:0] came = clock_q < 9'd12 ? 9'd0 : clock_q - 9'd12 > count ? count : clock_q - 9'd12;
  // When the FPGA has been configured, registers and memories are 0.
  always @* begin
    if (!begun_q) begin
      assume (!write_i && !bus_write_i && !\list.force_write_q );
      assume (places == 128'd0 && kinds == 112'd0);
    end
  end
  integer k;
  always @* begin
    if (begun_q) begin
      assert (!(latching_q && refreshing_q));
      assert (\list.force_write_q == forces_q);
      if (forces_q)
        assert (\list.force_entry_q == forcing_q[7:0] && \list.force_q == forcing_q[9:8]);
      if (busy) begin
        assert (clock_q >= 9'd1 && clock_q <= count + (latching_q ? 9'd3 : 9'd14));
        assert (\list.latching_q == latching_q);
        assert (\list.left_q == count - gone);
        if (clock_q <= count) begin
          assert (\list.entry_q == (latching_q ? 8'd0 : refresh_first) + gone[7:0]);
        end
        assert (\list.read_q == (clock_q >= 9'd2 && clock_q <= count + 9'd1));
        assert (\list.entry_valid_q == (clock_q >= 9'd3 && clock_q <= count + 9'd2));
      end else begin
        assert (\list.left_q == 9'd0 && !\list.read_q && !\list.entry_valid_q );
      end
      if (refreshing_q) begin
        assert (\list.answer_q == refresh_first + came[7:0]);
        assert (\list.answered_q == (clock_q >= 9'd13 && clock_q <= count + 9'd12));
      end else assert (!\list.answered_q );
      for (k = 0; k < 8; k = k + 1) begin
        assert (reads_q[k] == (refreshing_q && clock_q >= 9'd5 + k && clock_q <= count + 9'd4 + k));
      end
      for (k = 0; k < 8; k = k + 1) begin
        if (k[7:0] == entry) begin
          assert (places[16*k+:16] == {words_q, device_q});
          assert (kinds[14*k+:14] == {force_q, kind_q});
        end
      end
    end
  end

  always @* begin
    cover (begun_q && latch_here && entry == 8'd1 && force_3_q == 2'b11 && input_q == 16'd0);
    cover (begun_q && shown_here && entry == 8'd2 && refresh_first == 8'd1 && value == 16'd1);
  end

endmodule

`default_nettype wire
