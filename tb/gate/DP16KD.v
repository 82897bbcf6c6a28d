// SPDX-License-Identifier: Apache-2.0
// The ECP5's block RAM as our netlists use it, for simulation: Yosys has a black box only. Facts: Lattice
// FPGA-TN-02204 (memory usage guide), and how Yosys 0.70 connects it (techlibs/lattice/brams_map_16kd.v).
//   1024 words of 18 bits, two bytes of 9; a port narrower than 9 bits does not see a byte's ninth.
//   Addresses count bits: with 18 they begin at AD4, with 9 at AD3, with 4 at AD2, with 2 at AD1, with 1 at
//   AD0; with 36 at AD5, and the lower half is on DIA, DOA, the upper on DIB, DOB.
//   With 18 the lowest two address pins of a write are its byte enables, with 36 the lowest four.
// Port A writes and port B reads, perhaps into its output registers (scripts/flow/ram_registers.py), without resets, and all
// words start with 0: anything else stops the simulation. What port B reads of a word that port A is writing is undefined on the
// chip; here it is the complement of the old bits, as in hdl/core/bank_ram.v, so that its use shows.
`default_nettype none

module DP16KD #(
    parameter DATA_WIDTH_A = 18,
    parameter DATA_WIDTH_B = 18,
    parameter REGMODE_A = "NOREG",
    parameter REGMODE_B = "NOREG",
    parameter CSDECODE_A = "0b000",
    parameter CSDECODE_B = "0b000",
    parameter CLKAMUX = "CLKA",
    parameter CLKBMUX = "CLKB",
    // verilator lint_off UNUSEDPARAM
    parameter RESETMODE = "SYNC",  // of resets that are never 1
    parameter ASYNC_RESET_RELEASE = "SYNC",
    parameter GSR = "ENABLED",  // reaches output registers only
    parameter WRITEMODE_A = "NORMAL",  // what port A reads while it writes: nobody may use it
    parameter WRITEMODE_B = "NORMAL",
    // verilator lint_on UNUSEDPARAM
    parameter [319:0] INITVAL_00 = 320'd0, INITVAL_01 = 320'd0, INITVAL_02 = 320'd0,
    INITVAL_03 = 320'd0, INITVAL_04 = 320'd0, INITVAL_05 = 320'd0, INITVAL_06 = 320'd0,
    INITVAL_07 = 320'd0, INITVAL_08 = 320'd0, INITVAL_09 = 320'd0, INITVAL_0A = 320'd0,
    INITVAL_0B = 320'd0, INITVAL_0C = 320'd0, INITVAL_0D = 320'd0, INITVAL_0E = 320'd0,
    INITVAL_0F = 320'd0, INITVAL_10 = 320'd0, INITVAL_11 = 320'd0, INITVAL_12 = 320'd0,
    INITVAL_13 = 320'd0, INITVAL_14 = 320'd0, INITVAL_15 = 320'd0, INITVAL_16 = 320'd0,
    INITVAL_17 = 320'd0, INITVAL_18 = 320'd0, INITVAL_19 = 320'd0, INITVAL_1A = 320'd0,
    INITVAL_1B = 320'd0, INITVAL_1C = 320'd0, INITVAL_1D = 320'd0, INITVAL_1E = 320'd0,
    INITVAL_1F = 320'd0, INITVAL_20 = 320'd0, INITVAL_21 = 320'd0, INITVAL_22 = 320'd0,
    INITVAL_23 = 320'd0, INITVAL_24 = 320'd0, INITVAL_25 = 320'd0, INITVAL_26 = 320'd0,
    INITVAL_27 = 320'd0, INITVAL_28 = 320'd0, INITVAL_29 = 320'd0, INITVAL_2A = 320'd0,
    INITVAL_2B = 320'd0, INITVAL_2C = 320'd0, INITVAL_2D = 320'd0, INITVAL_2E = 320'd0,
    INITVAL_2F = 320'd0, INITVAL_30 = 320'd0, INITVAL_31 = 320'd0, INITVAL_32 = 320'd0,
    INITVAL_33 = 320'd0, INITVAL_34 = 320'd0, INITVAL_35 = 320'd0, INITVAL_36 = 320'd0,
    INITVAL_37 = 320'd0, INITVAL_38 = 320'd0, INITVAL_39 = 320'd0, INITVAL_3A = 320'd0,
    INITVAL_3B = 320'd0, INITVAL_3C = 320'd0, INITVAL_3D = 320'd0, INITVAL_3E = 320'd0,
    INITVAL_3F = 320'd0
) (
    // port A
    input  wire CLKA, CEA, OCEA, WEA, RSTA, CSA2, CSA1, CSA0,
    input  wire DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6,
    DIA5, DIA4, DIA3, DIA2, DIA1, DIA0, ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5,
    ADA4, ADA3, ADA2, ADA1, ADA0,
    output wire DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6,
    DOA5, DOA4, DOA3, DOA2, DOA1, DOA0,
    // port B
    input  wire CLKB, CEB, OCEB, WEB, RSTB, CSB2, CSB1, CSB0,
    input  wire DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6,
    DIB5, DIB4, DIB3, DIB2, DIB1, DIB0, ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5,
    ADB4, ADB3, ADB2, ADB1, ADB0,
    output wire DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6,
    DOB5, DOB4, DOB3, DOB2, DOB1, DOB0
);

  localparam WORDS = 1024;
  localparam REGISTERED = REGMODE_B != "NOREG";  // else OUTREG
  // The start values, one after another
  localparam [64*320-1:0] START = {
    INITVAL_3F, INITVAL_3E, INITVAL_3D, INITVAL_3C, INITVAL_3B, INITVAL_3A, INITVAL_39, INITVAL_38,
    INITVAL_37, INITVAL_36, INITVAL_35, INITVAL_34, INITVAL_33, INITVAL_32, INITVAL_31, INITVAL_30,
    INITVAL_2F, INITVAL_2E, INITVAL_2D, INITVAL_2C, INITVAL_2B, INITVAL_2A, INITVAL_29, INITVAL_28,
    INITVAL_27, INITVAL_26, INITVAL_25, INITVAL_24, INITVAL_23, INITVAL_22, INITVAL_21, INITVAL_20,
    INITVAL_1F, INITVAL_1E, INITVAL_1D, INITVAL_1C, INITVAL_1B, INITVAL_1A, INITVAL_19, INITVAL_18,
    INITVAL_17, INITVAL_16, INITVAL_15, INITVAL_14, INITVAL_13, INITVAL_12, INITVAL_11, INITVAL_10,
    INITVAL_0F, INITVAL_0E, INITVAL_0D, INITVAL_0C, INITVAL_0B, INITVAL_0A, INITVAL_09, INITVAL_08,
    INITVAL_07, INITVAL_06, INITVAL_05, INITVAL_04, INITVAL_03, INITVAL_02, INITVAL_01, INITVAL_00
  };

  wire [13:0] a_addr = {
    ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0
  };
  wire [13:0] b_addr = {
    ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0
  };
  wire [17:0] a_low = {
    DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4,
    DIA3, DIA2, DIA1, DIA0
  };
  wire [17:0] a_high = {
    DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4,
    DIB3, DIB2, DIB1, DIB0
  };

  reg [17:0] words[0:WORDS-1];
  integer i;
  initial begin
    for (i = 0; i < WORDS; i = i + 1) words[i] = 18'd0;
    if (START != 0) $fatal(1, "DP16KD: start values");
    if (REGMODE_A != (DATA_WIDTH_B == 36 ? REGMODE_B : "NOREG")) begin
      $fatal(1, "DP16KD: output registers of port A alone");
    end
    if (CLKAMUX != "CLKA" || CLKBMUX != "CLKB") $fatal(1, "DP16KD: inverted clock");
    if (CSDECODE_A != "0b000" || CSDECODE_B != "0b000") $fatal(1, "DP16KD: CSDECODE");
  end

  // Of a port: which word, and which of its bits (the lower half's; with 36 bits both are all of a word).
  function automatic [17:0] bits_of;
    input integer width;
    input [3:0] addr;
    begin
      case (width)
        1: bits_of = 18'd1 << (9 * addr[3] + {29'd0, addr[2:0]});
        2: bits_of = 18'd3 << (9 * addr[3] + {29'd0, addr[2:1], 1'b0});
        4: bits_of = 18'd15 << (9 * addr[3] + {29'd0, addr[2], 2'b0});
        9: bits_of = 18'h1ff << (9 * addr[3]);
        default: bits_of = 18'h3ffff;
      endcase
    end
  endfunction
  function automatic [4:0] shift_of;
    input integer width;
    input [3:0] addr;
    begin
      case (width)
        1: shift_of = (addr[3] ? 5'd9 : 5'd0) + {2'd0, addr[2:0]};
        2: shift_of = (addr[3] ? 5'd9 : 5'd0) + {2'd0, addr[2:1], 1'b0};
        4: shift_of = (addr[3] ? 5'd9 : 5'd0) + {2'd0, addr[2], 2'b0};
        9: shift_of = addr[3] ? 5'd9 : 5'd0;
        default: shift_of = 5'd0;
      endcase
    end
  endfunction

  // ---- port A: writes --------------------------------------------------------------------------
  wire a_we = CEA && WEA;
  wire [9:0] a_word = DATA_WIDTH_A == 36 ? {a_addr[13:5], 1'b0} : a_addr[13:4];
  wire [17:0] a_bytes = {{9{a_addr[1]}}, {9{a_addr[0]}}};
  wire [17:0] a_mask = DATA_WIDTH_A >= 18 ? a_bytes : bits_of(DATA_WIDTH_A, a_addr[3:0]);
  wire [17:0] a_high_mask = DATA_WIDTH_A == 36 ? {{9{a_addr[3]}}, {9{a_addr[2]}}} : 18'd0;
  wire [17:0] a_data = a_low << shift_of(DATA_WIDTH_A, a_addr[3:0]);
  always @(posedge CLKA) begin
    if (a_we) begin
      words[a_word] <= (words[a_word] & ~a_mask) | (a_data & a_mask);
      if (DATA_WIDTH_A == 36) begin
        words[a_word|10'd1] <= (words[a_word|10'd1] & ~a_high_mask) | (a_high & a_high_mask);
      end
    end
    if (RSTA || CSA0 || CSA1 || CSA2) $fatal(1, "DP16KD: port A's RST or CS");
  end

  // ---- port B: reads ---------------------------------------------------------------------------
  function automatic [17:0] written;  // bits of a word that port A is writing
    input [9:0] word;
    begin
      written = 18'd0;
      if (a_we && word == a_word) written = a_mask;
      if (a_we && DATA_WIDTH_A == 36 && word == (a_word | 10'd1)) written = a_high_mask;
    end
  endfunction
  wire [9:0] b_word = DATA_WIDTH_B == 36 ? {b_addr[13:5], 1'b0} : b_addr[13:4];
  wire [17:0] b_mask = bits_of(DATA_WIDTH_B, b_addr[3:0]);
  wire [17:0] b_data = words[b_word] ^ written(b_word);
  reg [17:0] b_low_q, b_high_q;
  reg [17:0] b_low_out_q, b_high_out_q;  // the output registers
  always @(posedge CLKB) begin
    if (CEB) begin
      b_low_q <= (b_data & b_mask) >> shift_of(DATA_WIDTH_B, b_addr[3:0]);
      if (DATA_WIDTH_B == 36) b_high_q <= words[b_word|10'd1] ^ written(b_word | 10'd1);
    end
    b_low_out_q  <= b_low_q;
    b_high_out_q <= b_high_q;
    if (REGISTERED && !(OCEB && (OCEA || DATA_WIDTH_B != 36))) begin
      $fatal(1, "DP16KD: an output register that is not always enabled");
    end
    if (WEB || RSTB || CSB0 || CSB1 || CSB2) $fatal(1, "DP16KD: port B's WE, RST or CS");
  end
  wire [17:0] b_low = REGISTERED ? b_low_out_q : b_low_q;
  wire [17:0] b_high = REGISTERED ? b_high_out_q : b_high_q;
  assign {
    DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4,
    DOB3, DOB2, DOB1, DOB0
  } = DATA_WIDTH_B == 36 ? b_high : b_low;
  // Unless it is the lower half of port B, this is a read of port A, which nobody may use.
  assign {
    DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4,
    DOA3, DOA2, DOA1, DOA0
  } = DATA_WIDTH_B == 36 ? b_low : ~a_low;

  wire unused = &{1'b0, OCEA, OCEB, a_high, b_addr, b_high};

endmodule

`default_nettype wire
