/* SPDX-License-Identifier: Apache-2.0 */
/* Device ports: numbers for rung_vm_port(), as hdl/isa/ports.toml has them. */
#ifndef RUNG_PORTS_H
#define RUNG_PORTS_H

/* RUNG_SPACE_BIT */
#define RUNG_PORT_UART_RX_FULL 0
#define RUNG_PORT_UART_TX_READY 1
#define RUNG_PORT_PERSIST_READY 2

/* RUNG_SPACE_WORD */
#define RUNG_PORT_UART_RX_DATA 0
#define RUNG_PORT_UART_TX_DATA 1
#define RUNG_PORT_PWM_DUTY 2
#define RUNG_PORT_PWM_HZ_LOW 3
#define RUNG_PORT_PWM_HZ_HIGH 4
#define RUNG_PORT_PERSIST_INDEX 5
#define RUNG_PORT_ADC 8
#define RUNG_PORT_ADC_COUNT 8
#define RUNG_PORT_PERSIST_VALUE 16
#define RUNG_PORT_PERSIST_VALUE_COUNT 48

#endif
