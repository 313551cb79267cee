/* The board as a whole: its clock, its power, and the loop of its firmware. */
#ifndef MACHINE_H
#define MACHINE_H

#include "report.h"

/* Switches the board on. Faults begin `from_s` after the first Arm, or now if that is 0. */
void machine_begin(uint64_t now_us, double from_s);

/* Takes bytes that the host sent, at the time up to which the board has run. */
void machine_receive(const uint8_t *bytes, size_t len);

/* Runs the board up to `until_us`. With `every_step` the loop sends after each step; without, as
 * `main.c` does, only when all steps that are due were made. */
void machine_run(uint64_t until_us, bool every_step);

/* Time for which the board has nothing to send [us], at most `most_us`. */
uint32_t machine_idle(uint32_t most_us);

/* Fills in all but the seed. */
struct board_account machine_account(void);

#endif
