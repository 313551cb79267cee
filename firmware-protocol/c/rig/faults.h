/* The faults of the rig: names, values, and which of them act now. */
#ifndef FAULTS_H
#define FAULTS_H

#include <stdbool.h>
#include <stdint.h>

/* Faults of one key act on the key in slot 0; the other keys are healthy. */
enum fault {
    FAULT_HALF = 0,
    FAULT_BURST,
    FAULT_LATENCY,
    FAULT_JITTER,
    FAULT_DROP,
    FAULT_DROPDOWN,
    FAULT_CORRUPT,
    FAULT_ECHO,
    FAULT_TEXT,
    FAULT_BOOTTEXT,
    FAULT_REPEAT,
    FAULT_WRONGLEN,
    FAULT_STALE,
    FAULT_DRIFT,
    FAULT_OLDMINOR,
    FAULT_MOTORSIGN,
    FAULT_DEADMOTOR,
    FAULT_WEAK,
    FAULT_STUCK,
    FAULT_SLOWMOTOR,
    FAULT_COGGING,
    FAULT_MUTELIES,
    FAULT_ENCSIGN,
    FAULT_SCALE,
    FAULT_SPIKE,
    FAULT_BIGSPIKE,
    FAULT_SHIFT,
    FAULT_NOISE,
    FAULT_FROZEN,
    FAULT_JUMPY,
    FAULT_VELSIGN,
    FAULT_VELZERO,
    FAULT_VELSCALE,
    FAULT_HOT,
    FAULT_OVERHEAT,
    FAULT_KEYFAULT,
    FAULT_NOTHOMED,
    FAULT_BROWN,
    FAULT_RESTART,
    FAULT_HANG,
    FAULT_COUNT
};

/* Adds the fault that `text` names, as in "drop" or "drop=0.1"; prints an error and returns
 * `false` if there is none, or if it cannot have this value. */
bool faults_add(const char *text);

/* Prints the rows of the table in README.md. */
void faults_print(void);

/* Name of the fault if it was added, else NULL. */
const char *faults_name(enum fault fault);

/* Lets the faults that were added act from now on. */
void faults_begin(uint64_t now_us);

/* Returns `true` if faults were added and act. */
bool faults_began(void);

/* Time since the faults began (s). */
double faults_age(uint64_t now_us);

bool fault_is_on(enum fault fault);

double fault_value(enum fault fault);

#endif
