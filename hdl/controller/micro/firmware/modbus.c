// SPDX-License-Identifier: Apache-2.0
// The Modbus RTU server: MODBUS Application Protocol Specification V1.1b3. Checks in the standard's
// order: function, quantity and length, address, execution.

#define READ_COILS 1
#define READ_INPUTS 2
#define READ_HOLDING 3
#define READ_REGISTERS 4
#define WRITE_COIL 5
#define WRITE_REGISTER 6
#define DIAGNOSTICS 8
#define WRITE_COILS 15
#define WRITE_REGISTERS 16
#define MASK_WRITE 22
#define READ_WRITE 23
#define ENCAPSULATED 43

// The request: bytes 0 unit, 1 function, data from 2 on.
u16 size;
u16 function;
u16 words;      // it is of words, else of bits
u16 values_at;  // byte of the first value to write
u16 tx_size;    // bytes of the answer so far

#define rx(at) io_read(MICRO_RX_FRAME + (at))

static u16 rx_word(u16 at) {
  u16 high;
  high = rx(at) << 8;
  return high | rx(at + 1);
}

static void put(u16 byte) {
  io_write(MICRO_TX_FRAME + tx_size, byte);
  tx_size = tx_size + 1;
}

static void put_word(u16 word) {
  put(word >> 8);
  put(word & 255);
}

// Bytes 2 to end - 1 of the request
static void echo(u16 end) {
  while (tx_size < end) put(rx(tx_size));
}

static u16 bytes_of(u16 count) { return words ? count << 1 : (count + 7) >> 3; }

// Takes the request of a function that reads or writes points apart; 0 or an exception.
static u16 parse(void) {
  u16 most_read;
  u16 most_written;
  words = 1;
  most_read = 0;
  most_written = 0;
  write_first = rx_word(2);
  write_count = 1;
  read_count = 0;
  values_at = 4;
  // `most` is 0 where there is no quantity.
  switch (function) {
    case READ_COILS:
    case READ_INPUTS:
      words = 0;
      most_read = 2000;
      break;
    case READ_HOLDING:
    case READ_REGISTERS:
      most_read = 125;
      break;
    case WRITE_COIL:
      words = 0;
      if (rx(5) || (rx(4) && rx(4) != 255)) return ILLEGAL_VALUE;
      break;
    case WRITE_REGISTER:
      break;
    case WRITE_COILS:
      words = 0;
      most_written = 1968;
      values_at = 7;
      break;
    case WRITE_REGISTERS:
      most_written = 123;
      values_at = 7;
      break;
    case MASK_WRITE:
      values_at = 6;
      break;
    case READ_WRITE:
      most_read = 125;
      most_written = 121;
      values_at = 11;
      break;
    default:
      return ILLEGAL_FUNCTION;
  }
  if (size < values_at) return ILLEGAL_VALUE;
  if (most_read) {
    read_first = write_first;
    read_count = rx_word(4);
    write_first = rx_word(6);
    write_count = 0;
    if (!within(read_count, 1, most_read)) return ILLEGAL_VALUE;
  }
  if (most_written) {
    write_count = rx_word(values_at - 3);
    if (!within(write_count, 1, most_written)) return ILLEGAL_VALUE;
    most_written = bytes_of(write_count);
    if (rx(values_at - 1) != most_written) return ILLEGAL_VALUE;
  } else {
    most_written = 2;  // the quantity of a read, the value of a write
  }
  return size == values_at + most_written ? 0 : ILLEGAL_VALUE;
}

// Value k that a request writes to registers
static u16 written(u16 k) {
  u16 mask;
  if (function != MASK_WRITE) return rx_word(values_at + (k << 1));
  mask = rx_word(4);
  return (holding_read(write_first, 1) & mask) | (rx_word(6) & ~mask);
}

static u16 of_controller(u16 first, u16 count) {
  return !count || (first >= FIRST_HOLDING && (first & 0x1FFF) + count <= HOLDING_REGISTERS);
}

static u16 serve_controller(void) {
  u16 k;
  u16 wrong;
  u16 really;
  if (!of_controller(write_first, write_count) || !of_controller(read_first, read_count)) {
    return ILLEGAL_ADDRESS;
  }
  write_first = write_first & 0x1FFF;
  read_first = read_first & 0x1FFF;
  // a window only from its first word on
#if FLOW
  if (write_first < NUMBER(FLOW))
#endif
    if (write_count && write_first > NUMBER(WINDOW)) return ILLEGAL_VALUE;
  window_wanted[0] = window(0);
  window_wanted[1] = window(1);
  force_wanted = force_point;
  for (really = 0; really < 2; really = really + 1) {
    for (k = 0; k < write_count; k = k + 1) {
      wrong = holding_write(really, write_first + k, written(k), write_count - k);
      if (wrong) return wrong;
    }
  }
  if (read_count) {
    put(read_count << 1);
    for (k = 0; k < read_count; k = k + 1) put_word(holding_read(read_first + k, !k));
    flash_end();
  }
  return 0;
}

static u16 serve_devices(void) {
  u16 k;
  u16 control;
  u16 word;
  control = words * WORDS;
  wanted_kind = words ? 2 : function != READ_INPUTS;
  if (write_count) {
    if (find_points(write_first, write_count)) return ILLEGAL_ADDRESS;
    write_first = point;
    control = control | WRITE;
  }
  if (read_count) {
    if (find_points(read_first, read_count)) return ILLEGAL_ADDRESS;
    read_first = point;
    control = control | READ;
  }
  if (write_count + read_count > exchange_points) return no_program ? FAILURE : ILLEGAL_VALUE;
  if (function == MASK_WRITE) control = control | MASK;
  io_write(REG(EXCHANGE_AND), rx_word(4));
  io_write(REG(EXCHANGE_OR), rx_word(6));
  // Bits are in the buffer with the lowest byte first; the 0xFF00 of one coil becomes 1 so, too.
  for (k = 0; k < bytes_of(write_count); k = k + 2) {
    word = rx_word(values_at + k);
    if (!words) word = word << 8 | word >> 8;
    io_write(MICRO_EXCHANGE_BUFFER + (k >> 1), word);
  }
  if (exchange(control)) return FAILURE;
  if (read_count) {
    put(bytes_of(read_count));
    for (k = 0; k < bytes_of(read_count); k = k + 1) {
      word = io_read(EXCHANGE_READ + (k >> 1));
      // Words have their high byte first, bits their low one.
      put((words ^ k) & 1 ? word >> 8 : word & 255);
    }
  }
  return 0;
}

static u16 points_request(void) {
  u16 wrong;
  wrong = parse();
  if (wrong) return wrong;
  if (words && (write_count ? write_first : read_first) >= FIRST_HOLDING) {
    wrong = serve_controller();
  } else {
    wrong = serve_devices();
  }
  if (!read_count) echo(6 + ((function == MASK_WRITE) << 1));
  return wrong;
}

// Objects of the device identification
static void put_number(u16 number) {
  u16 tens;
  tens = 0;
  while (number >= 10) {
    number = number - 10;
    tens = tens + 1;
  }
  if (tens) put('0' + tens);
  put('0' + number);
}

static void put_object(u16 object) {
  u16 length_at;
  put(object);
  length_at = tx_size;
  put(0);
  switch (object) {
    case 0:
      put_word('R' << 8 | 'u');
      put_word('n' << 8 | 'g');
      break;
    case 1:  // board 1 mpu 3
      put_word('b' << 8 | 'o');
      put_word('a' << 8 | 'r');
      put_word('d' << 8 | ' ');
      put_number(io_read(REG(BOARD_ID)));
      put_word(' ' << 8 | 'm');
      put_word('p' << 8 | 'u');
      put(' ');
      put_number(io_read(REG(MPU)));
      break;
    default:
      put('1');  // version of the registers' map
  }
  io_write(MICRO_TX_FRAME + length_at, tx_size - length_at - 1);
}

#define OBJECTS 3

static u16 identify(void) {
  u16 object;
  if (size < 3) return ILLEGAL_VALUE;
  if (rx(2) != 14) return ILLEGAL_FUNCTION;
  if (size != 5 || !within(rx(3), 1, 4)) return ILLEGAL_VALUE;
  object = rx(4);
  if (rx(3) == 4) {
    if (object >= OBJECTS) return ILLEGAL_ADDRESS;
  } else if (object >= OBJECTS) {
    object = 0;
  }
  put_word(14 << 8 | rx(3));
  put(0x81);    // conformity: basic objects, as a stream and one by one
  put_word(0);  // nothing follows
  if (rx(3) == 4) {
    put(1);
    put_object(object);
    return 0;
  }
  put(OBJECTS - object);
  while (object < OBJECTS) {
    put_object(object);
    object = object + 1;
  }
  return 0;
}

static u16 answer(void) {
  if (function == DIAGNOSTICS) {
    if (size < 4) return ILLEGAL_VALUE;
    if (rx_word(2)) return ILLEGAL_FUNCTION;
    echo(size);
    return 0;
  }
  if (function == ENCAPSULATED) return identify();
  return points_request();
}

// A frame waits in rx_frame.
static void serve(void) {
  u16 wrong;
  u16 to;
  size = io_read(REG(LINE_LENGTH));
  to = rx(0);
  if (!to || to == unit) {
    frames = frames + 1;
    function = rx(1);
    tx_size = 2;
    wrong = answer();
    io_write(MICRO_TX_FRAME, to);
    if (wrong) {
      function = function | 0x80;
      tx_size = 2;
      put(wrong);
      if (to) exceptions = exceptions + 1;
    }
    io_write(MICRO_TX_FRAME + 1, function);
    if (to) {
      io_write(REG(LINE_TAKE), 0);
      io_write(REG(LINE_SEND), tx_size);
      return;
    }
  }
  io_write(REG(LINE_TAKE), 0);
}
