/* The serial link: two rings and the interrupts that serve them. Nothing here waits. */
#ifndef UART_H
#define UART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void uart_begin(void);

/* The next byte that came; -1 if there is none. */
int uart_read(void);

/* Sends all bytes, or none if there is no room for all. */
bool uart_write(const uint8_t *bytes, size_t len);

/* Bytes that came faster than they were read, since the last time that this was asked. */
uint32_t uart_lost(void);

/* Whether a byte is waiting. */
bool uart_has_byte(void);

#endif
