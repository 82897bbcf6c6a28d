// SPDX-License-Identifier: Apache-2.0
// Modbus addresses to points of the device map, and the exchange of points with the processor.

// Bits of exchange_control
#define WRITE 1
#define READ 2
#define WORDS 4
#define RAW 8
#define MASK 16

#define EXCHANGE_READ (MICRO_EXCHANGE_BUFFER + 128)

// Of a request, and of an exchange: addresses become points.
u16 write_first;
u16 write_count;
u16 read_first;
u16 read_count;

u16 wanted;  // find_area: the address; kind of its areas: 0 bits, 1 those of them that are coils, 2
             // words
u16 wanted_kind;
u16 areas_point;  // of the area looked at
u16 point;        // the answer: its point
u16 room;  // and how many more are in this area behind it, itself included; 0: no area has it

// kind: 0 a bit area of discrete inputs, 1 of coils, 3 of words
static void area(u16 kind, u16 first, u16 count) {
  u16 behind;
  behind = wanted - first;
  if (behind < count && (kind & 2) == (wanted_kind & 2) && (kind & 1) >= (wanted_kind & 1)) {
    point = areas_point + behind;
    room = count - behind;
  }
  areas_point = areas_point + count;
}

// The areas of a table have their points one behind the other.
#define AREA(table, first, count, index, coils) \
  if ((index) == 0) areas_point = 0;            \
  area((table)*2 + (coils), first, count);
static void find_area(u16 address) {
  wanted = address;
  room = 0;
  AREAS
}
#undef AREA

// Finds the point of `address` and sees that `count` addresses from it on are points one behind the
// other, in one area or several that touch. 0 or an exception.
static u16 find_points(u16 address, u16 count) {
  u16 start;
  u16 expected;
  find_area(address);
  start = point;
  while (room) {
    if (room >= count) {
      point = start;
      return 0;
    }
    count = count - room;
    address = address + room;
    expected = point + room;
    if (!address) break;
    find_area(address);
    if (point != expected) break;
  }
  return ILLEGAL_ADDRESS;
}

// Waits for the exchange, until the scan controller says that there will be none. 1: there was
// none.
static u16 exchange_waits(void) {
  u16 start;
  start = io_read(REG(MILLISECONDS));
  while (io_read(REG(EXCHANGE_STATUS)) & 1) {
    if (scan_state() == FAULT || milliseconds_since(start) >= PATIENCE_MS) return 1;
  }
  return 0;
}

// Points to write are at exchange_buffer, those read come to EXCHANGE_READ. 0, or 1: there was
// none.
static u16 exchange(u16 control) {
  if (scan_state() == FAULT || exchange_waits()) return 1;
  io_write(REG(EXCHANGE_WRITE_FIRST), write_first);
  io_write(REG(EXCHANGE_WRITE_COUNT), write_count);
  io_write(REG(EXCHANGE_READ_FIRST), read_first);
  io_write(REG(EXCHANGE_READ_COUNT), read_count);
  io_write(REG(EXCHANGE_CONTROL), control);
  return exchange_waits();
}
