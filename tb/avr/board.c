/* SPDX-License-Identifier: Apache-2.0
 * The board's side of an ATmega328P: a scan every CYCLE_US, and the peripherals' hooks, which are
 * the same for every program. UART_BAUD and CYCLE_US are the program's BAUD and CYCLE. */
#include "board.h"

#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#define TIMER_TICKS (F_CPU / 64 * (CYCLE_US / 100) / 10000)

/* The hooks, as the translated programs declare them. */
int16_t PlcUartReceive(void);
uint8_t PlcUartReady(void);
void PlcUartSend(uint8_t byte);
void PlcSetPwm(uint8_t percent, uint32_t hertz);
uint8_t PlcPersistReady(void);
int16_t PlcPersistRead(uint8_t number);
void PlcPersistWrite(uint8_t number, int16_t value);

static volatile uint8_t tick;
static uint8_t sending;

ISR(TIMER1_COMPA_vect) { tick = 1; }

uint8_t board_input(uint8_t number) { return (uint8_t)(PIND >> (number + 4) & 1); }

void board_output(uint8_t number, uint8_t value) {
  const uint8_t bit = (uint8_t)(1 << (number < 3 ? number : number + 1));
  if (value) {
    PORTB |= bit;
  } else {
    PORTB &= (uint8_t)~bit;
  }
}

int16_t board_sample(uint8_t number) {
  ADMUX = (uint8_t)(1 << REFS0 | number);
  ADCSRA |= 1 << ADSC;
  while (ADCSRA & 1 << ADSC) {
  }
  return (int16_t)ADC;
}

int16_t PlcUartReceive(void) { return UCSR0A & 1 << RXC0 ? UDR0 : -1; }

/* Not when UDR0 takes a byte, but when the byte before is out, as LDmicro's simulator has it. */
uint8_t PlcUartReady(void) {
  if (UCSR0A & 1 << TXC0) sending = 0;
  return !sending;
}

void PlcUartSend(uint8_t byte) {
  UCSR0A |= 1 << TXC0; /* writing 1 clears it */
  UDR0 = byte;
  sending = 1;
}

/* Timer 2, fast PWM: the highest frequency that its prescalers make and that was not passed. */
void PlcSetPwm(uint8_t percent, uint32_t hertz) {
  static const uint16_t prescalers[] = {1, 8, 32, 64, 128, 256, 1024};
  uint8_t i = 0;
  while (i < 6 && F_CPU / 256 / prescalers[i] > hertz) ++i;
  OCR2A = (uint8_t)((uint16_t)percent * 255u / 100u);
  TCCR2A = 1 << COM2A1 | 1 << WGM21 | 1 << WGM20;
  TCCR2B = (uint8_t)(i + 1);
}

uint8_t PlcPersistReady(void) { return eeprom_is_ready() != 0; }

int16_t PlcPersistRead(uint8_t number) {
  return (int16_t)eeprom_read_word((const uint16_t*)(uintptr_t)(2u * number));
}

void PlcPersistWrite(uint8_t number, int16_t value) {
  eeprom_update_word((uint16_t*)(uintptr_t)(2u * number), (uint16_t)value);
}

int main(void) {
  DDRB = 0x3F;
  DDRC = 1 << 5;
  UBRR0 = (uint16_t)(F_CPU / 16 / UART_BAUD - 1);
  UCSR0B = 1 << RXEN0 | 1 << TXEN0;
  UCSR0C = 1 << UCSZ01 | 1 << UCSZ00;
  ADCSRA = 1 << ADEN | 1 << ADPS2 | 1 << ADPS1 | 1 << ADPS0;
  OCR1A = (uint16_t)(TIMER_TICKS - 1);
  TCCR1B = 1 << WGM12 | 1 << CS11 | 1 << CS10;
  TIMSK1 = 1 << OCIE1A;
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_enable();
  for (;;) {
    /* sei takes effect after sleep, so that no tick is missed in between. */
    cli();
    while (!tick) {
      sei();
      sleep_cpu();
      cli();
    }
    tick = 0;
    sei();
    PORTC |= 1 << 5;
    board_scan();
    PORTC &= (uint8_t) ~(1 << 5);
  }
}
