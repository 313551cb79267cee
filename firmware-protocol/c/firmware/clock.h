/* The board's time [us], which wraps after 71 minutes. */
#ifndef CLOCK_H
#define CLOCK_H

#include <stdbool.h>
#include <stdint.h>

void clock_begin(void);

/* Lets an interrupt come in so many microseconds, so that the processor does not sleep for ever. */
void clock_wake_in(uint32_t us);

/* Whether that time has come. */
bool clock_woke(void);

/* The time; to be asked more often than every second. */
uint32_t clock_us(void);

#endif
