/* Accounts of the forces and the work of the motors, and the report. */
#ifndef REPORT_H
#define REPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One step of a key. Forces [N] are positive upwards, places [m] and velocities [m/s] are positive
 * downwards. */
struct account_step {
    double command;
    double force;
    double from;
    double to;
    double velocity;
    uint64_t now_us;
};

void account(size_t slot, const struct account_step *step);

/* The board's part of the report; all counters are sums over its starts. */
struct board_account {
    bool was_armed;
    double since_arm_s;
    uint32_t armings;
    uint32_t restarts;
    uint32_t forces;
    uint32_t refused;
    uint32_t stale;
    uint32_t samples;
    uint32_t unsent;
    uint32_t trips;
    uint16_t muted;
    uint64_t seed;
};

/* Writes the report to `path`, whole or not at all; prints an error and returns `false` if it
 * cannot. */
bool report_write(const char *path, const struct board_account *board);

#endif
