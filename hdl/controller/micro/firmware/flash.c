// SPDX-License-Identifier: Apache-2.0
// The flash: SPI NOR with the commands that all of them have. A place is a page of 256 bytes (the
// upper 16 of an address' 24 bits) and a byte in it. Every wait is bounded: what the flash does not
// do in time, or does wrong, is an error that the caller sees or a wrong CRC.

#define FLASH_WRITE_ENABLE 0x06
#define FLASH_STATUS 0x05
#define FLASH_ERASE_4K 0x20
#define FLASH_PROGRAM 0x02
#define FLASH_READ 0x03
#define FLASH_WAKE 0xAB

#define SECTOR_PAGES (FLASH_SECTOR_BYTES / FLASH_PAGE_BYTES)

// The longest sector erase that data sheets allow is 400 ms.
#define FLASH_PATIENCE_MS 900

u16 write_page;  // where flash_put goes on
u16 write_byte;
u16 flash_failed;  // since it was last cleared

static u16 flash_byte(u16 byte) {
  io_write(REG(FLASH_DATA), byte);
  while (io_read(REG(FLASH_BUSY)) & 1) {
  }
  return io_read(REG(FLASH_DATA)) & 255;
}

// Only the low 8 bits of what is written are sent.
static void flash_send(u16 word) {
  flash_byte(word >> 8);
  flash_byte(word);
}

static void flash_end(void) { io_write(REG(FLASH_SELECT), 0); }

static void flash_begin(u16 command) {
  flash_end();
  io_write(REG(FLASH_SELECT), 1);
  flash_byte(command);
}

static void flash_at(u16 command, u16 page, u16 byte) {
  flash_begin(command);
  flash_send(page);
  flash_byte(byte);
}

static u16 flash_word(void) {
  u16 high;
  high = flash_byte(0) << 8;
  return high | flash_byte(0);
}

// Ends a command that writes and waits until it is done.
static void flash_wait(void) {
  u16 start;
  start = io_read(REG(MILLISECONDS));
  flash_begin(FLASH_STATUS);
  while (flash_byte(0) & 1) {
    if (milliseconds_since(start) > FLASH_PATIENCE_MS) {
      flash_failed = 1;
      break;
    }
  }
  flash_end();
}

static void flash_erase(u16 page) {
  flash_begin(FLASH_WRITE_ENABLE);
  flash_at(FLASH_ERASE_4K, page, 0);
  flash_wait();
}

static void flash_write_at(u16 page, u16 byte) {
  write_page = page;
  write_byte = byte;
  flash_begin(FLASH_WRITE_ENABLE);
  flash_at(FLASH_PROGRAM, page, byte);
}

// A word behind flash_write_at; flash_wait ends it. Pages are crossed, erased sectors not looked
// after.
static void flash_put(u16 word) {
  if (write_byte == FLASH_PAGE_BYTES) {
    flash_wait();
    flash_write_at(write_page + 1, 0);
  }
  flash_send(word);
  write_byte = write_byte + 2;
}

static void crc_word(u16 word) {
  io_write(REG(CRC_BYTE), word >> 8);
  io_write(REG(CRC_BYTE), word);
}

// A word that is part of a CRC-32: read, and written.
static u16 checked_word(void) {
  u16 word;
  word = flash_word();
  crc_word(word);
  return word;
}

static void flash_put_checked(u16 word) {
  crc_word(word);
  flash_put(word);
}

// The CRC-32 of what was written, low word first, ends it.
static void flash_put_crc(void) {
  flash_put(io_read(REG(CRC_LOW)));
  flash_put(io_read(REG(CRC_HIGH)));
  flash_wait();
}

// 1: the CRC-32 of what was read follows it.
static u16 crc_follows(void) {
  return flash_word() == io_read(REG(CRC_LOW)) && flash_word() == io_read(REG(CRC_HIGH));
}

// The first page of a sector of the controller's part.
static u16 sector_page(u16 sector) { return (sector + io_read(REG(FLASH_BASE))) * SECTOR_PAGES; }

// The first page of a sector of a copy.
static u16 copy_page(u16 of_copy, u16 sector) {
  return sector_page(of_copy * FLASH_COPY_SECTORS + sector);
}

// Power may have come back while the flash was asleep, or at work.
static void flash_wake(void) {
  flash_begin(FLASH_WAKE);
  flash_wait();
  flash_failed = 0;
}
