// SPDX-License-Identifier: Apache-2.0
// Filter of an input pin (hdl/controller/input_filter.v): what it shows changes in the clock after a sample if that one
// and the samples before it, `samples_i` in a row, all differ from what it shows; never otherwise. So no pulse of fewer samples
// is ever seen, and one of as many always is. Pin, samples' clocks, setting and inversion are free in every clock.
`default_nettype none

module input_filter_proof (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       pin_i,
    input wire       sample_i,
    input wire [3:0] samples_i,
    input wire       invert_i
);

  wire value;
  input_filter filter (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .pin_i    (pin_i),
      .sample_i (sample_i),
      .samples_i(samples_i),
      .invert_i (invert_i),
      .value_o  (value)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // The pin as it comes in: two clocks late.
  reg [1:0] pin_q;
  reg [1:0] age_q;
  initial age_q = 2'd0;
  always @(posedge clk_i) begin
    pin_q <= {pin_q[0], pin_i};
    if (age_q != 2'd3) age_q <= age_q + 2'd1;
  end
  always @* if (age_q < 2'd3) assume (!rst_ni);  // a reset of three clocks

  // All samples since the filter was asked for, the newest lowest; `number_q` of them count.
  wire filtered = samples_i != 4'd0;
  reg [14:0] taken_q;
  reg [3:0] number_q;
  wire [14:0] taken = {taken_q[13:0], pin_q[1]};
  wire [3:0] number = number_q == 4'd15 ? 4'd15 : number_q + 4'd1;
  reg shown_q;
  reg all_differ;
  integer i;
  always @* begin
    all_differ = number >= samples_i;
    for (i = 0; i < 15; i = i + 1) begin
      if (i < samples_i && taken[i] == shown_q) all_differ = 1'b0;
    end
  end

  always @(posedge clk_i) begin
    if (!rst_ni || !filtered) begin
      shown_q  <= pin_q[1];
      number_q <= 4'd0;
    end else if (sample_i) begin
      taken_q  <= taken;
      number_q <= number;
      if (all_differ) shown_q <= pin_q[1];
    end
  end

  wire ready = age_q == 2'd3;
  always @* begin
    if (ready) begin
      assert (value == ((filtered ? shown_q : pin_q[1]) ^ invert_i));
    end
  end

  // For the induction: the samples that differ are counted.
  (* hierconn *) wire [3:0] \filter.differ_q ;
  (* hierconn *) wire \filter.steady_q ;
  (* hierconn *) wire [1:0] \filter.pin_q ;
  reg [3:0] run;
  reg running;
  integer k;
  always @* begin
    run = 4'd0;
    running = 1'b1;
    for (k = 0; k < 15; k = k + 1) begin
      if (k >= number_q || taken_q[k] == shown_q) running = 1'b0;
      if (running) run = run + 4'd1;
    end
  end
  always @* begin
    if (age_q >= 2'd2) assert (\filter.pin_q == pin_q);
    if (ready) begin
      assert (\filter.steady_q == shown_q);
      assert (\filter.differ_q == run && run != 4'd15);
    end
  end

  // A pulse of one sample less is not seen; a change is.
  reg rose_q;
  always @(posedge clk_i) rose_q <= ready && !shown_q;
  always @* begin
    cover (ready && samples_i == 4'd3 && \filter.differ_q == 4'd2 && pin_q[1] == shown_q);
    cover (ready && samples_i == 4'd3 && rose_q && shown_q);
  end

endmodule

`default_nettype wire
