/* Runs of the rig: in virtual time over stdin and stdout, or in real time behind a terminal. */
#ifndef SESSION_H
#define SESSION_H

#include <stdbool.h>
#include <stdint.h>

struct settings {
    bool lockstep;
    /* Paths of the report and of a link to the terminal; NULL without. */
    const char *report;
    const char *link;
    /* When faults begin after the first Arm [s]. */
    double from_s;
    /* Latency of the link, each way [us]. */
    uint64_t latency_us;
    uint64_t seed;
};

/* Both return the exit code. */
int run_lockstep(const struct settings *settings);
int run_terminal(const struct settings *settings);

/* Switches the board on at `now_us`. */
void session_begin(const struct settings *settings, uint64_t now_us);

/* Writes the report if a second has passed since the last one. */
void session_report_each_second(const struct settings *settings, uint64_t now_us);

/* Writes the report; returns `false` if that fails. */
bool session_report(const struct settings *settings);

#endif
